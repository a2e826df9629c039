"""The target of the index: one, the share of a standard, or the threshold of the kind of work."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from assess.codes.basis import Basis, IndexKind
from assess.codes.verdict.question import Missing, Question, missing_input
from assess.messages.message import message

Target = tuple[float | None, tuple[Missing, ...]]
IMPROVED, RAISED = 0.60, 0.10  # NTC 8.4.2
UPGRADED, FULL = 0.80, 1.0  # NTC 8.4.3: cases c and e, and all others


def target_of(question: Question, basis: Basis) -> Target:
    """Return the target, and what is missing to know it (NTC 8.4.1-8.4.3; NZSEE 2017).

    Parameters
    ----------
    question : what the project asks
    basis : the rules of the code

    Returns
    -------
    tuple
        Target, None where it is not known, and the missing inputs.
    """
    if basis.index == IndexKind.NBS:
        return _share_of_standard(question)
    if basis.index == IndexKind.DEMAND_CAPACITY:
        return FULL, ()
    return _OF_WORKS[question.works](question)


def whole(basis: Basis) -> float:
    """Return the target of a new building, in the unit of the index."""
    return 100.0 if basis.index == IndexKind.NBS else FULL


def _share_of_standard(question: Question) -> Target:
    if question.target_nbs is None:
        return None, (missing_input("verdict.target_nbs", message("missing-target"), "target_nbs = 67"),)
    return question.target_nbs, ()


def _unchanged(question: Question) -> Target:
    return FULL, ()


def _repaired(question: Question) -> Target:
    return None, (missing_input("verdict.works", message("missing-works"), 'works = "none"'),)


def _improved(question: Question) -> Target:
    if question.use_class is None:
        why = message("missing-class-of-improvement")
        return None, (missing_input("building.use_class", why, 'use_class = "II"'),)
    if question.use_class == "III" and question.school is None:
        return None, (missing_input("building.school", message("missing-school"), "school = true"),)
    if question.use_class == "IV" or (question.use_class == "III" and question.school):
        return IMPROVED, ()
    if question.index_before is None:
        return None, (missing_input("verdict.index_before", message("missing-index-before"), "index_before = 0.40"),)
    return question.index_before + RAISED, ()


def _upgraded(question: Question) -> Target:
    return (UPGRADED if question.upgrading in ("c", "e") else FULL), ()


_OF_WORKS: Mapping[str, Callable[[Question], Target]] = {
    "none": _unchanged,
    "repair": _repaired,
    "improvement": _improved,
    "upgrading": _upgraded,
}
