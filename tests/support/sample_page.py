"""A document as a page of HTML, its figures traced in this process."""

from __future__ import annotations

from pathlib import Path

from reports.document import Document
from reports.render.html import write_html
from reports.render.vector import svg_picture, trace_figure


def write_page(document: Document, path: Path) -> Path:
    """Write the page; the path written."""
    pictures = {figure.name: svg_picture(trace_figure(figure.draw(document.writer))) for figure in document.figures}
    return write_html(document, path, pictures=pictures)
