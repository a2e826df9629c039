"""The target of the index by the kind of work, and what it is compared with before (NTC 8.4.1 to 8.4.3; NZSEE 2017).

Local works (8.4.1) have no threshold: they do not lower any index, and whether it rises enough is the engineer's to
judge. An improvement (8.4.2) has one of its own, or 0.10 above the index before; upgrading (8.4.3) that of a new
building, or 0.80 of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from assess.codes.bases import Basis, IndexKind
from assess.codes.question import Missing, Question, missing_input
from assess.messages.message import Message, Quantity, Severity, message

TargetOrMissing = tuple[float | None, tuple[Missing, ...]]
IMPROVED, RAISED = 0.60, 0.10  # NTC 8.4.2
UPGRADED, FULL = 0.80, 1.0  # NTC 8.4.3: cases c and e, and all others
LOCAL = ("local", "repair")
SAME_INDEX = 0.01  # share by which an index may be less than before and count as the same


def target_of(question: Question, basis: Basis) -> TargetOrMissing:
    """Return the target, and what is missing to know it.

    Parameters
    ----------
    question : what the project asks
    basis : the rules of the code

    Returns
    -------
    Target, None where it is not known, and the missing inputs.
    """
    if basis.index == IndexKind.NBS:
        return _share_of_standard(question)
    if basis.index == IndexKind.DEMAND_CAPACITY:
        return FULL, ()
    return _OF_WORKS[question.works](question)


def full_target(basis: Basis) -> float:
    """Return the target of a new building, in the unit of the index."""
    return 100.0 if basis.index == IndexKind.NBS else FULL


def fall_of_index(question: Question, mechanism: str, index: float | None) -> Message | None:
    """Return that local works lower the index of a mechanism, which they are not to do; None where they do not.

    Parameters
    ----------
    question : with the state before the works
    mechanism : its name
    index : after the works; None where it is not known

    Source: NTC 2018, 8.4.1.
    """
    if question.works not in LOCAL or question.before is None:
        return None
    before = question.before.indices.get(mechanism)
    if before is None or index is None or index >= before * (1.0 - SAME_INDEX):
        return None
    values = {"before": Quantity(before, "ratio", 3), "after": Quantity(index, "ratio", 3)}
    return message("index-falls", values, severity=Severity.WARNING, where=f"mechanisms.{mechanism}")


def _share_of_standard(question: Question) -> TargetOrMissing:
    if question.target_nbs is None:
        return None, (missing_input("verdict.target_nbs", message("missing-target"), "target_nbs = 67"),)
    return question.target_nbs, ()


def _unchanged(question: Question) -> TargetOrMissing:
    return FULL, ()


def _of_local_works(question: Question) -> TargetOrMissing:
    return _compared(question, message("missing-works"))


def _improved(question: Question) -> TargetOrMissing:
    if question.use_class is None:
        why = message("missing-class-of-improvement")
        return None, (missing_input("building.use_class", why, 'use_class = "II"'),)
    if question.use_class == "III" and question.school is None:
        return None, (missing_input("building.school", message("missing-school"), "school = true"),)
    if question.use_class == "IV" or (question.use_class == "III" and question.school):
        return IMPROVED, ()
    if question.use_class == "I":
        return _compared(question, message("missing-target-of-class-I"))
    before, missing = _index_before(question, message("missing-index-before"))
    return (None if before is None else before + RAISED), missing


def _compared(question: Question, why: Message) -> TargetOrMissing:
    """Return no target where the clause states no threshold: the indices before and after are for the engineer."""
    before, missing = _index_before(question, why)
    if before is None:
        return None, missing
    compared = message("compared-with-index-before", {"before": Quantity(before, "ratio", 3)})
    return None, (missing_input("verdict.works", compared, reasons=(why,)),)


def _index_before(question: Question, why: Message) -> TargetOrMissing:
    """Return the index of the building before the works, by its own run or as measured, and what is missing of it."""
    state = question.before
    if state is None and question.index_before is None:
        return None, (missing_input("verdict.index_before", why, "index_before = 0.40"),)
    if state is not None and state.index is None:
        return None, (missing_input("verdict.before", message("before-incomplete", {"file": state.path})),)
    return (question.index_before if state is None else state.index), ()


def _upgraded(question: Question) -> TargetOrMissing:
    return (UPGRADED if question.upgrading in ("c", "e") else FULL), ()


_OF_WORKS: Mapping[str, Callable[[Question], TargetOrMissing]] = {
    "none": _unchanged,
    "local": _of_local_works,
    "repair": _of_local_works,
    "improvement": _improved,
    "upgrading": _upgraded,
}
