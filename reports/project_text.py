"""Texts of the project file, as the results hold them."""

from __future__ import annotations

from assess.results import Results


def project_text(results: Results, key: str) -> str:
    """Return a resolved text of the project.

    Parameters
    ----------
    results : of a run
    key : of the project file, as "report.units"

    Returns
    -------
    str
        Empty where it is not given.
    """
    found = results.project.get(key)
    return "" if found is None or found.value is None else str(found.value)
