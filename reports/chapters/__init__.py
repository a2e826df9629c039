"""The chapters of the report: what each says, taken from the results."""
