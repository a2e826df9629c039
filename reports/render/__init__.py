"""The renderers: a document as PDF, HTML, workbook and CSV; its figures as SVG and PNG."""
