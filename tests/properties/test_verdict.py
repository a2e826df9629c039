"""What must hold for every basis and every combination of answers."""

from __future__ import annotations

from itertools import combinations, product

import pytest

from assess.codes.bases import BASES
from assess.codes.check import Outcome
from assess.codes.verdict import Decision
from tests.support.answered import check, decide, question

ANSWERS = (Outcome.PASS, Outcome.FAIL, Outcome.NOT_ANSWERED)
RANK = {Decision.FAIL: 0, Decision.INCOMPLETE: 1, Decision.PASS: 2}
MORE = {"nzsee2017": {"target_nbs": 100}}
ITALIAN = ("ntc2018", "dmi2008")


def question_of(basis, state, procedures, use_class):
    """The question of a basis by one limit state, at an action that each of its deciding limit states may go by."""
    periods = {"periods": True} if basis in ITALIAN else {}
    action = periods or {"state": next(each.actions[0] for each in BASES[basis].states if each.name == state)}
    more = {"limit_state": state, "procedures": procedures, "use_class": use_class, **MORE.get(basis, {})}
    return question(basis, **action, **more)


def slots(basis):
    """Every check that some method of a basis gives: procedure and limit state."""
    return list(
        dict.fromkeys((m.procedure, s.checked_as) for s in BASES[basis].states for rank in s.ranks for m in rank)
    )


CASES = [  # every basis, chosen limit state, and choice of named methods
    (name, state.name, procedures, use_class)
    for name, basis in BASES.items()
    for state in basis.chosen
    for methods in [tuple(dict.fromkeys(m.procedure for rank in state.ranks for m in rank))]
    for procedures in [None, *(c for n in range(1, len(methods) + 1) for c in combinations(methods, n))]
    for use_class in ("II", "IV", None)
]


@pytest.mark.parametrize(("basis", "state", "procedures", "use_class"), CASES)
def test_a_worse_answer_never_improves_the_outcome(basis, state, procedures, use_class):
    """Turning one answer from pass to fail or to missing never improves what is decided."""
    asked = question_of(basis, state, procedures, use_class)
    places = slots(basis)

    def outcome(answers):
        return RANK[decide(asked, [check(p, a, state=s) for (p, s), a in zip(places, answers, strict=True)]).outcome]

    known = {answers: outcome(answers) for answers in product(ANSWERS, repeat=len(places))}
    for answers, before in known.items():
        for place, answer in enumerate(answers):
            if answer != Outcome.PASS:
                continue
            for worse in (Outcome.FAIL, Outcome.NOT_ANSWERED):
                after = known[(*answers[:place], worse, *answers[place + 1 :])]
                assert after <= before, (answers, place, worse)


@pytest.mark.parametrize(("basis", "state", "procedures", "use_class"), CASES)
def test_nothing_passes_without_an_answer_that_passes(basis, state, procedures, use_class):
    asked = question_of(basis, state, procedures, use_class)
    silent = [check(procedure, None, state=checked) for procedure, checked in slots(basis)]
    assert decide(asked, silent).outcome == Decision.INCOMPLETE
    assert decide(asked, []).outcome == Decision.INCOMPLETE


@pytest.mark.parametrize("basis", BASES)
def test_an_undeclared_action_never_passes_nor_fails(basis):
    asked = question(basis, state=None, limit_state=BASES[basis].chosen[0].name, use_class="II", **MORE.get(basis, {}))
    for answer in (Outcome.PASS, Outcome.FAIL):
        checks = [check(procedure, answer, state=checked) for procedure, checked in slots(basis)]
        assert decide(asked, checks).outcome == Decision.INCOMPLETE
