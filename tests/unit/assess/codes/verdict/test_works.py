"""Works by NTC 8.4.1 and 8.4.2 against the state before: decisions worked by hand from the clauses."""

from __future__ import annotations

import pytest

from assess.codes.check import Outcome
from assess.codes.question import MechanismChecks, Question, StateBefore
from assess.codes.verdict import Decision, Verdict, verdict
from assess.codes.works import target_of
from tests.support.answered import check, question

YES, NO, OPEN = Decision.PASS, Decision.FAIL, Decision.INCOMPLETE


def works(kind: str, before: dict[str, float | None], *, least: float | None = None, **more: str) -> Question:
    """The question of works against a state before, whose building has the least index of its mechanisms."""
    known = [index for index in before.values() if index is not None]
    index = least if least is not None or None in before.values() else min(known)
    state = StateBefore("before.json", index, before)
    return question("ntc2018", periods=True, works=kind, before=state, **{"use_class": "II", **more})


def decide(asked: Question, indices: dict[str, float]) -> Verdict:
    checked = [
        MechanismChecks(
            name,
            (
                check("ntc2018-nonlinear", Outcome.PASS if index >= 1.0 else Outcome.FAIL, ratio=1.0 / index),
                check("ntc2018-linear", Outcome.PASS, state="SLD"),
            ),
        )
        for name, index in indices.items()
    ]
    return verdict(asked, checked)


@pytest.mark.parametrize(
    ("before", "after", "outcome"),
    [
        ({"wall": 0.40}, {"wall": 0.80}, OPEN),  # 8.4.1 has no threshold: for the engineer to judge
        ({"wall": 0.40}, {"wall": 0.40}, OPEN),
        ({"wall": 0.40}, {"wall": 0.398}, OPEN),  # within 1 %
        ({"wall": 0.40}, {"wall": 0.39}, NO),
        ({"wall": 0.40, "gable": 0.90}, {"wall": 0.80, "gable": 0.90}, OPEN),
        ({"wall": 0.40, "gable": 0.90}, {"wall": 0.80, "gable": 0.70}, NO),  # it falls elsewhere
        ({"wall": 0.40, "gable": 1.60}, {"wall": 0.80, "gable": 1.20}, NO),  # also above that of a new building
        ({"wall": 0.40}, {"wall": 0.80, "bending": 0.30}, OPEN),  # new: nothing to compare it with
        ({"wall": 0.40, "gable": None}, {"wall": 0.80, "gable": 0.70}, OPEN),  # not known before
    ],
)
@pytest.mark.parametrize("spelling", ["local", "repair"])
def test_local_works_do_not_lower_the_index_of_any_mechanism(before, after, outcome, spelling):
    """NTC 8.4.1: "non riducano le condizioni di sicurezza preesistenti"; no index to reach is stated."""
    found = decide(works(spelling, before), after)
    assert (found.outcome, found.target) == (outcome, None)
    lower = {each.mechanism for each in found.mechanisms if each.answers[0].reason.key == "index-falls"}
    assert lower == {name for name in after if (before.get(name) or 0.0) > after[name] / 0.99}


def test_a_fall_is_told_with_both_indices_and_how_far_the_mechanism_holds():
    (wall,) = decide(works("local", {"wall": 0.50}), {"wall": 0.40}).mechanisms
    assert wall.answers[0].reason.text == "the works lower the index from 0.5 to 0.4 (NTC 8.4.1)"
    assert (wall.outcome, wall.missing, wall.provisional) == (NO, (), None)
    assert wall.margin == pytest.approx(0.40)


def test_local_works_tell_how_far_a_mechanism_holds_though_there_is_no_target():
    (wall,) = decide(works("local", {"wall": 0.50}), {"wall": 0.80}).mechanisms
    assert wall.margin == pytest.approx(0.80)


@pytest.mark.parametrize(
    ("before", "after", "outcome"),
    [
        ({"wall": 0.45, "gable": 0.80}, {"wall": 0.90, "gable": 0.80}, YES),  # 0.80 >= 0.45 + 0.10
        ({"wall": 0.45, "gable": 0.54}, {"wall": 0.90, "gable": 0.54}, NO),  # 0.54 < 0.55
        ({"wall": 0.45}, {"wall": 0.90, "bending": 0.50}, NO),  # a new one counts like all others
        ({"wall": 0.45, "gable": None}, {"wall": 0.90, "gable": 0.80}, OPEN),
    ],
)
def test_an_improvement_raises_the_index_of_the_building_by_a_tenth(before, after, outcome):
    """NTC 8.4.2, class II."""
    found = decide(works("improvement", before), after)
    assert found.outcome == outcome
    assert [each.key for each in found.missing] == (["verdict.before"] if outcome == OPEN else [])


def test_an_improvement_is_measured_from_the_better_state_before():
    asked = works("improvement", {"wall": 0.45}, least=0.60)  # the other state of the run before
    assert asked.basis is not None
    assert target_of(asked, asked.basis) == (pytest.approx(0.70), ())


@pytest.mark.parametrize(("kind", "more"), [("none", {}), ("upgrading", {"upgrading": "c"})])
def test_other_targets_do_not_depend_on_the_state_before(kind, more):
    found = decide(works(kind, {"wall": 1.60}, **more), {"wall": 1.20})
    assert found.outcome == YES
