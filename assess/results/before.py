"""What each mechanism holds in one state of a building, to set the state before the works beside the one after."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from assess.codes.calculation_sheet import Bound
from assess.codes.check import Check
from assess.codes.procedures import uses_histories
from assess.codes.verdict import Decision, Index, MechanismVerdict, Verdict, least_index
from assess.messages.message import Message
from assess.short_repr import ShortRepr

if TYPE_CHECKING:
    from assess.results.run import Results


@dataclass(frozen=True, repr=False)
class CapacityResult(ShortRepr):
    """What one mechanism holds in one state, by the method that decides.

    procedure : that method; empty where none answers
    margin : PGA at capacity over the action's; it, that PGA, the index and the return period of the capacity are None
        where they are not known
    return_period_bound : "<=" or ">=" where the capacity lies beyond the rows of the hazard
    """

    mechanism: str
    label: str
    outcome: Decision
    at_the_limit: bool
    procedure: str
    limit_state: str
    index: Index | None
    margin: float | None
    capacity_pga_g: float | None
    return_period_years: float | None
    return_period_bound: Bound = ""


@dataclass(frozen=True, repr=False)
class CapacitiesResult(ShortRepr):
    """One state of a building.

    path : of the results that it is from; empty for those that hold it; stamp : of them
    index : of the building; weakest : the mechanism that holds up to the lowest action, empty where none is known
    suite : each record by its id with its scale factor [-], where histories decide; else empty
    differences : of a state before the works, from that which holds it: a warning for each value of the building that
        differs, by its key, and a note for each load and body that one state alone has
    """

    path: str
    title: str
    stamp: str
    outcome: Decision
    index: Index | None
    weakest: str
    mechanisms: tuple[CapacityResult, ...]
    suite: tuple[tuple[str, float], ...] = ()
    differences: tuple[Message, ...] = ()

    def of(self, mechanism: str) -> CapacityResult | None:
        """Return what a mechanism holds; None for one that this state does not have."""
        return next((each for each in self.mechanisms if each.mechanism == mechanism), None)


def state_of(results: Results, *, path: str = "") -> CapacitiesResult | None:
    """Return the state of the building that results are of; None where they hold no verdict.

    Parameters
    ----------
    results : of a run
    path : of their file, as it is to be named
    """
    verdict = results.verdict
    if verdict is None:
        return None
    labels = {each.name: each.label for each in results.falling} | {
        each.name: each.label for each in results.mechanisms
    }
    found = tuple(_capacity_of(each, results, verdict, labels[each.mechanism]) for each in verdict.mechanisms)
    known = [each for each in found if each.margin is not None]
    weakest = min(known, key=lambda each: each.margin or 0.0, default=None)
    title = results.project.get("title")
    return CapacitiesResult(
        path=path,
        title="" if title is None or title.value is None else str(title.value),
        stamp=results.stamp,
        outcome=verdict.outcome,
        index=verdict.index,
        weakest="" if weakest is None else weakest.mechanism,
        mechanisms=found,
        suite=tuple((each.id, each.scale_factor) for each in results.records)
        if any(uses_histories(each.procedure) for each in found)
        else (),
    )


def governing_check(checks: tuple[Check, ...], *, pga_g: float) -> Check | None:
    """Return the check of least capacity among those that decide at the site's own action; None where none does.

    Parameters
    ----------
    checks : of one mechanism
    pga_g : of the site's own action [g]
    """
    deciding = [each for each in checks if each.role == "deciding" and abs(each.level_pga_g - pga_g) <= 1e-9 * pga_g]
    return min(deciding, key=_share_held, default=None)


def _share_held(check: Check) -> float:
    """Return the share of its action that a check holds [-]; of one that does not say, by its ratio."""
    if check.safety_index is not None:
        return check.safety_index
    if check.capacity_pga_g is not None:
        return check.capacity_pga_g / check.level_pga_g
    return 0.0 if not check.ratio else 1.0 / check.ratio


def _capacity_of(found: MechanismVerdict, results: Results, verdict: Verdict, label: str) -> CapacityResult:
    mechanism = next((each for each in results.mechanisms if each.name == found.mechanism), None)
    check = None if mechanism is None else governing_check(mechanism.checks, pga_g=verdict.action.pga_g)
    answer = next((each for each in found.answers if check is not None and each.procedure == check.procedure), None)
    return CapacityResult(
        mechanism=found.mechanism,
        label=label,
        outcome=found.outcome,
        at_the_limit=found.at_the_limit,
        procedure="" if check is None else check.procedure,
        limit_state="" if answer is None else answer.limit_state,
        index=least_index(found),
        margin=found.margin,
        capacity_pga_g=None if found.margin is None else found.margin * verdict.action.pga_g,
        return_period_years=None if check is None else check.return_period_years,
        return_period_bound="" if check is None else check.return_period_bound,
    )
