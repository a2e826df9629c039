"""The chapters of the report, made from the results."""
