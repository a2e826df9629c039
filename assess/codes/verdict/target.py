"""The target of the index: one, the share of a standard, or the threshold of the kind of work."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from assess.codes.basis import Basis, IndexKind
from assess.codes.verdict.question import Missing, Question

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
        text = "the share of the new building standard to be reached, 34, 67 or 100, has no default"
        return None, (Missing("verdict.target_nbs", text, "target_nbs = 67"),)
    return question.target_nbs, ()


def _unchanged(question: Question) -> Target:
    return FULL, ()


def _repaired(question: Question) -> Target:
    text = 'a local repair has no threshold (NTC 8.4.1): compare the index before and after; write "none" for a target'
    return None, (Missing("verdict.works", text, 'works = "none"'),)


def _improved(question: Question) -> Target:
    if question.use_class is None:
        text = "the class of use, on which the target of an improvement depends (NTC 8.4.2)"
        return None, (Missing("building.use_class", text, 'use_class = "II"'),)
    if question.use_class == "III" and question.school is None:
        text = "whether the building is a school, for which class III asks 0.60 (NTC 8.4.2)"
        return None, (Missing("building.school", text, "school = true"),)
    if question.use_class == "IV" or (question.use_class == "III" and question.school):
        return IMPROVED, ()
    if question.index_before is None:
        text = "the index before the works, which an improvement raises by at least 0.10 (NTC 8.4.2)"
        return None, (Missing("verdict.index_before", text, "index_before = 0.40"),)
    return question.index_before + RAISED, ()


def _upgraded(question: Question) -> Target:
    return (UPGRADED if question.upgrading in ("c", "e") else FULL), ()


_OF_WORKS: Mapping[str, Callable[[Question], Target]] = {
    "none": _unchanged,
    "repair": _repaired,
    "improvement": _improved,
    "upgrading": _upgraded,
}
