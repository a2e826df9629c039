"""The bases that stand over the ground, and where their input acts."""

from __future__ import annotations

from assess.results import Results
from reports.document import Table


def table(results: Results) -> Table:
    """One line for each mechanism whose input acts over the ground."""
    return Table("heights", "Bases over the ground.", (), ())
