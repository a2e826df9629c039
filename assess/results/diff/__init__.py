"""Differences between two runs, as before and after a retrofit.

Mechanisms, records, files and keys are matched by name; checks by mechanism, procedure, limit state and level. What
only one run has is a change too, with None on the other side. Curves and single histories follow from what is compared
and are left out; if only they differ, one change names them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from assess.results.diff.change import KINDS, TOLERANCE, Change, Kind, is_number, same
from assess.results.diff.checks import capacities, ratios, verdicts
from assess.results.diff.inputs import inputs, program, project, site, warnings
from assess.results.diff.mechanisms import envelopes, histories, mechanisms, parameters
from assess.results.diff.others import others
from assess.results.diff.suites import suites
from assess.results.diff.variations import sensitivities, sweeps, uncertainties
from assess.results.run import Results

__all__ = ["COMPARED", "KINDS", "Change", "Kind", "changes", "is_number", "same"]

COMPARED: tuple[Callable[[Results, Results], Iterator[Change]], ...] = (
    verdicts,
    mechanisms,
    capacities,
    ratios,
    envelopes,
    histories,
    parameters,
    sweeps,
    sensitivities,
    uncertainties,
    suites,
    site,
    project,
    inputs,
    warnings,
    program,
)


def changes(before: Results, after: Results, *, tolerance: float = TOLERANCE) -> tuple[Change, ...]:
    """Return every difference between two runs, the most important kinds first.

    Parameters
    ----------
    before, after : Results
        The two runs.
    tolerance : float
        Relative difference up to which two numbers count as equal [-].

    Returns
    -------
    tuple of Change
        Sorted by kind, in the order of `KINDS`.
    """
    found = (change for compare in COMPARED for change in compare(before, after))
    different = [c for c in found if not same(c.before, c.after, tolerance=tolerance)]
    if not any(KINDS.index(change.kind) < KINDS.index("other") for change in different):
        different += others(before, after, tolerance=tolerance)
    return tuple(sorted(different, key=lambda change: KINDS.index(change.kind)))
