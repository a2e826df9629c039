"""Differences of verdicts, of PGA at capacity, and of demand over capacity."""

from __future__ import annotations

from collections.abc import Iterator
from operator import attrgetter

from assess.codes.check import Check, Outcome
from assess.results.diff.change import Change
from assess.results.diff.pairs import common_mechanisms, of_both, pairs
from assess.results.diff.verdict_statements import verdict_statements
from assess.results.mechanism import MechanismResult
from assess.results.run import Results


def verdicts(before: Results, after: Results) -> Iterator[Change]:
    """Compare the verdict of the building and of each mechanism, then the outcome of each check."""
    sides = [verdict_statements(results.verdict) for results in (before, after)]
    for (where, what), earlier, later in pairs(*sides):
        yield Change("verdict", where, what, earlier, later)
    for one, other in common_mechanisms(before, after):
        for name, first_check, second_check in pairs(
            checks_by_name(one, one, other), checks_by_name(other, one, other)
        ):
            yield Change("verdict", one.name, name, *of_both(attrgetter("verdict"), first_check, second_check))


def capacities(before: Results, after: Results) -> Iterator[Change]:
    """Compare the PGA at uplift and at capacity of each procedure [g]; they do not depend on the level."""
    for one, other in common_mechanisms(before, after):
        sides = [{check_name(check, one, other): check for check in each.checks} for each in (one, other)]
        for what, first, second in pairs(*sides):
            for word in ("capacity", "uplift"):
                ends = of_both(attrgetter(f"{word}_pga_g"), first, second)
                yield Change("capacity", one.name, f"{word}, {what}", *ends, unit="g")


def ratios(before: Results, after: Results) -> Iterator[Change]:
    """Compare demand over capacity of each check."""
    for one, other in common_mechanisms(before, after):
        for what, first, second in pairs(checks_by_name(one, one, other), checks_by_name(other, one, other)):
            yield Change("ratio", one.name, what, *of_both(demand_capacity, first, second))


def demand_capacity(check: Check) -> float | str | None:
    """Return demand over capacity, or why it is unbounded; None where the check does not apply."""
    return None if check.verdict == Outcome.NOT_APPLICABLE else check.unbounded or check.ratio


def checks_by_name(mechanism: MechanismResult, *runs: MechanismResult) -> dict[str, Check]:
    """Return the checks of a mechanism by procedure and level, under names that are unique within both `runs`."""
    return {f"{check_name(check, *runs)} at {check.level_pga_g:.6g} g": check for check in mechanism.checks}


def check_name(check: Check, *runs: MechanismResult) -> str:
    """Return the procedure of a check, with its limit state if the procedure has several in either run."""
    states = {other.limit_state for run in runs for other in run.checks if other.procedure == check.procedure}
    return f"{check.procedure} {check.limit_state}" if len(states) > 1 else check.procedure
