"""The decision table of each basis, row by row: which method decides, what informs, what is missing."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.codes.bases import BASES, BY_SITE, stated_basis
from assess.codes.check import Outcome
from assess.codes.question import Action, Missing, Question
from assess.codes.verdict import Decision
from assess.codes.works import target_of
from tests.support.answered import SITE, check, decide, question

PASS, FAIL, SILENT, NOT_FOR = Outcome.PASS, Outcome.FAIL, Outcome.NOT_ANSWERED, Outcome.NOT_APPLICABLE
YES, NO, OPEN = Decision.PASS, Decision.FAIL, Decision.INCOMPLETE
HISTORY, NONLINEAR, LINEAR = "ntc2018-history", "ntc2018-nonlinear", "ntc2018-linear"


def verdict_of(basis, checks, **more):
    return decide(question(basis, **more), checks)


def test_bases_of_sites_whose_code_tells():
    assert dict(BY_SITE) == {"ntc2018": "ntc2018", "ntc2008": "dmi2008", "nzs1170.5": "nzsee2017", "ec8": "ec8"}


def test_without_a_basis_nothing_is_decided():
    found = verdict_of(None, [check(NONLINEAR, PASS)])
    assert (found.outcome, found.basis, found.missing[0].key) == (OPEN, "", "verdict.basis")


@pytest.mark.parametrize(
    ("named", "history", "nonlinear", "linear", "outcome", "by"),
    [
        (None, PASS, PASS, FAIL, YES, NONLINEAR),
        (None, FAIL, PASS, FAIL, YES, NONLINEAR),
        (None, PASS, FAIL, PASS, NO, NONLINEAR),
        (None, PASS, SILENT, PASS, OPEN, NONLINEAR),
        ((HISTORY, NONLINEAR), PASS, FAIL, FAIL, YES, HISTORY),
        ((HISTORY, NONLINEAR), FAIL, PASS, PASS, NO, HISTORY),
        ((HISTORY, NONLINEAR), SILENT, PASS, FAIL, YES, NONLINEAR),
        ((HISTORY, NONLINEAR), SILENT, FAIL, PASS, NO, NONLINEAR),
        ((HISTORY, NONLINEAR), SILENT, SILENT, PASS, OPEN, HISTORY),
        ((HISTORY,), SILENT, PASS, PASS, OPEN, HISTORY),
        ((LINEAR,), PASS, FAIL, PASS, YES, LINEAR),
        ((LINEAR,), PASS, PASS, FAIL, NO, LINEAR),
        ((NONLINEAR, LINEAR), PASS, SILENT, PASS, OPEN, NONLINEAR),
        ((HISTORY, LINEAR), SILENT, PASS, FAIL, NO, LINEAR),
    ],
)
def test_ntc2018_slv(named, history, nonlinear, linear, outcome, by):
    """verdict.md 2: history (if declared) > non-linear > linear, the last never for a non-linear that was asked."""
    checks = [check(HISTORY, history), check(NONLINEAR, nonlinear), check(LINEAR, linear)]
    found = verdict_of("ntc2018", checks, procedures=named, use_class="II")
    (answer,) = found.mechanisms[0].answers
    assert (found.outcome, answer.procedure) == (outcome, by)


@pytest.mark.parametrize(
    ("chosen", "slv", "slc", "outcome"),
    [(None, PASS, FAIL, YES), ("SLV", FAIL, PASS, NO), ("SLC", FAIL, PASS, YES), ("SLC", PASS, FAIL, NO)],
)
def test_ntc2018_one_of_slv_and_slc_is_chosen_for_the_building(chosen, slv, slc, outcome):
    checks = [check(NONLINEAR, slv), check(NONLINEAR, slc, state="SLC")]
    found = verdict_of("ntc2018", checks, limit_state=chosen, periods=True, use_class="II")
    assert (found.outcome, found.limit_states) == (outcome, (chosen or "SLV",))


def test_ntc2018_slc_has_no_linear_method():
    checks = [check(LINEAR, PASS, state="SLC"), check(LINEAR, PASS)]
    found = verdict_of("ntc2018", checks, limit_state="SLC", state="SLC", procedures=(LINEAR,), use_class="II")
    assert found.outcome == OPEN


@pytest.mark.parametrize(
    ("declared", "outcome"), [("SLV", YES), ("SLC", OPEN), ("SLD", OPEN), (None, OPEN), ("DBE", OPEN)]
)
def test_a_single_spectrum_decides_only_what_the_site_declares(declared, outcome):
    found = verdict_of("ntc2018", [check(NONLINEAR, PASS)], state=declared, use_class="II")
    assert found.outcome == outcome
    assert {each.key for each in found.missing} == (set() if outcome == YES else {"site.limit_state"})
    assert found.provisional == (None if outcome == YES else YES)


@pytest.mark.parametrize(
    ("use_class", "sld", "outcome"),
    [
        ("I", FAIL, YES),
        ("II", FAIL, YES),
        ("III", FAIL, YES),
        ("IV", FAIL, NO),
        ("IV", PASS, YES),
        ("IV", SILENT, OPEN),
        (None, PASS, YES),
        (None, SILENT, YES),
        (None, FAIL, OPEN),
    ],
)
def test_ntc2018_sld_decides_too_in_class_iv(use_class, sld, outcome):
    checks = [check(NONLINEAR, PASS), check(LINEAR, sld, state="SLD")]
    found = verdict_of("ntc2018", checks, periods=True, use_class=use_class)
    assert found.outcome == outcome
    if use_class is None and sld == FAIL:
        assert [each.key for each in found.missing] == ["building.use_class"]


@pytest.mark.parametrize(
    ("works", "more", "index", "outcome"),
    [
        ("none", {}, 0.99, NO),
        ("none", {}, 1.0, YES),
        ("local", {}, 2.0, OPEN),
        ("local", {"index_before": 0.4}, 2.0, OPEN),
        ("repair", {"index_before": 0.4}, 2.0, OPEN),
        ("improvement", {"use_class": "I", "index_before": 0.4}, 2.0, OPEN),
        ("improvement", {"use_class": None}, 2.0, OPEN),
        ("improvement", {"use_class": "IV"}, 0.60, YES),
        ("improvement", {"use_class": "IV"}, 0.59, NO),
        ("improvement", {"use_class": "III"}, 0.60, OPEN),
        ("improvement", {"use_class": "III", "school": True}, 0.60, YES),
        ("improvement", {"use_class": "III", "school": False}, 0.60, OPEN),
        ("improvement", {"use_class": "II", "index_before": 0.45}, 0.55, YES),
        ("improvement", {"use_class": "II", "index_before": 0.45}, 0.54, NO),
        ("upgrading", {"upgrading": "a"}, 0.9, NO),
        ("upgrading", {"upgrading": "c"}, 0.8, YES),
        ("upgrading", {"upgrading": "e"}, 0.79, NO),
        ("upgrading", {}, 0.9, NO),
    ],
)
def test_ntc2018_targets_of_works(works, more, index, outcome):
    """NTC 8.4.1 to 8.4.3."""
    said = PASS if index >= 1.0 else FAIL
    checks = [check(NONLINEAR, said, ratio=1.0 / index), check(LINEAR, PASS, state="SLD")]
    found = verdict_of("ntc2018", checks, periods=True, works=works, **{"use_class": "II", **more})
    assert found.outcome == outcome


@pytest.mark.parametrize(("works", "more"), [("local", {}), ("repair", {}), ("improvement", {"use_class": "I"})])
def test_works_without_a_threshold_ask_for_the_index_before_and_have_no_target(works, more):
    """NTC 8.4.1, and 8.4.2 in class I."""
    asked = question("ntc2018", works=works, **{"use_class": "II", **more})
    target, (missing,) = target_of(asked, asked.basis)
    assert (target, missing.key, missing.toml) == (None, "verdict.index_before", "index_before = 0.40")
    target, (missing,) = target_of(replace(asked, index_before=0.4), asked.basis)
    assert (target, missing.key) == (None, "verdict.works")
    assert "0.4" in missing.text


def test_below_the_full_target_a_check_that_may_not_pass_is_not_answered():
    """Ground motion upstairs fails at the whole action; that it would reach a lower target is not known."""
    low = check(NONLINEAR, FAIL, ratio=1.0 / 0.7, may_pass=False)
    asked = question("ntc2018", works="improvement", use_class="IV", periods=True)
    assert decide(asked, [low, check(LINEAR, PASS, state="SLD")]).outcome == OPEN
    assert decide(question("ntc2018", use_class="II"), [low]).outcome == NO


@pytest.mark.parametrize(
    ("named", "linear", "nonlinear", "outcome"),
    [
        (None, PASS, PASS, YES),
        (None, PASS, FAIL, NO),
        (None, FAIL, PASS, NO),
        (None, PASS, SILENT, OPEN),
        (("dmi2008-linear",), PASS, FAIL, YES),
        (("dmi2008-nonlinear",), PASS, FAIL, NO),
        (("dmi2008-nonlinear",), FAIL, PASS, YES),
    ],
)
def test_dmi2008_equals_must_both_hold_where_none_is_named(named, linear, nonlinear, outcome):
    checks = [check("dmi2008-linear", linear), check("dmi2008-nonlinear", nonlinear), check("dmi2008-history", PASS)]
    assert verdict_of("dmi2008", checks, procedures=named, use_class="II").outcome == outcome


@pytest.mark.parametrize(
    ("target", "share", "outcome", "grade"),
    [
        (34, 0.45, YES, "C"),
        (67, 0.45, NO, "C"),
        (100, 0.99, NO, "A"),
        (100, 1.0, YES, "A"),
        (67, 1.2, YES, "A+"),
        (34, 0.33, NO, "D"),
        (34, 0.1, NO, "E"),
        (67, 0.70, YES, "B"),
        (None, 2.0, OPEN, "A+"),
    ],
)
def test_nzsee2017_by_the_target_and_with_its_grade(target, share, outcome, grade):
    one = check("nzsee2017-face-loaded", PASS if share >= 1.0 else FAIL, state="ULS", ratio=1.0 / share)
    found = verdict_of("nzsee2017", [one], state="ULS", target_nbs=target)
    assert found.outcome == outcome
    assert found.mechanisms[0].answers[0].index is None or found.mechanisms[0].answers[0].index.grade == grade
    assert ({each.key for each in found.missing} == {"verdict.target_nbs"}) is (target is None)


def test_nzsee2017_without_a_target_says_what_the_whole_standard_would_make_of_it():
    one = check("nzsee2017-face-loaded", FAIL, state="ULS", ratio=2.0)
    assert verdict_of("nzsee2017", [one], state="ULS").provisional == NO


@pytest.mark.parametrize(
    ("declared", "chosen", "outcome", "state"),
    [
        ("BSE-1E", None, YES, ("LS",)),
        ("BSE-2E", None, YES, ("CP",)),
        ("BSE-1E", "CP", OPEN, ("CP",)),
        (None, "LS", OPEN, ("LS",)),
        (None, None, OPEN, ()),
    ],
)
def test_asce41_13_at_the_declared_level(declared, chosen, outcome, state):
    one = check("asce41-13-ht", PASS, state="life safety, collapse prevention")
    found = verdict_of("asce41-13", [one], state=declared, limit_state=chosen)
    assert (found.outcome, found.limit_states) == (outcome, state)


def test_asce41_13_has_nothing_to_say_of_cantilevers():
    one = check("asce41-13-ht", NOT_FOR, state="life safety, collapse prevention")
    assert verdict_of("asce41-13", [one], state="BSE-1E").outcome == OPEN


@pytest.mark.parametrize(
    ("named", "history", "spectrum", "outcome"),
    [
        (None, PASS, FAIL, YES),
        (None, FAIL, PASS, NO),
        (None, SILENT, PASS, OPEN),
        (("asce43-05-spectrum",), FAIL, PASS, YES),
        (("asce43-05-history", "asce43-05-spectrum"), SILENT, PASS, YES),
        (("asce43-05-history", "asce43-05-spectrum"), FAIL, PASS, NO),
        (("asce43-05-history", "asce43-05-spectrum"), SILENT, NOT_FOR, OPEN),
    ],
)
def test_asce43_05_histories_decide_and_a2_only_where_named(named, history, spectrum, outcome):
    state = "no overturning"
    checks = [check("asce43-05-history", history, state=state), check("asce43-05-spectrum", spectrum, state=state)]
    assert verdict_of("asce43-05", checks, state="DBE", procedures=named).outcome == outcome


def test_asce43_05_needs_the_dbe():
    one = check("asce43-05-history", PASS, state="no overturning")
    assert verdict_of("asce43-05", [one], state=None).missing[0].key == "site.limit_state"


@pytest.mark.parametrize(("said", "outcome"), [(PASS, YES), (FAIL, NO), (SILENT, OPEN), (NOT_FOR, OPEN)])
def test_ec8_elements(said, outcome):
    """A wall that carries floors has no accepted method: not applicable, so incomplete."""
    assert verdict_of("ec8", [check("ec8-element", said, state="element")], state="ULS").outcome == outcome


@pytest.mark.parametrize(
    ("rule", "first", "second", "outcome"),
    [("all", PASS, PASS, YES), ("all", PASS, FAIL, NO), ("all", PASS, SILENT, OPEN), ("any", SILENT, PASS, YES)],
)
def test_own_basis(rule, first, second, outcome):
    basis = stated_basis(("sliding", NONLINEAR), rule=rule, statement="as agreed")
    asked = Question(basis, Action(SITE, None))
    checks = [check("sliding", first, state="no sliding"), check(NONLINEAR, second)]
    assert decide(asked, checks).outcome == outcome


def test_a_method_with_two_checks_does_not_stand_for_one_that_gave_none():
    basis = stated_basis((LINEAR, "asce43-05-history"), rule="all", statement="as agreed")
    checks = [check(LINEAR, PASS), check(LINEAR, PASS, state="SLD")]
    assert decide(Question(basis, Action(SITE, None)), checks).outcome == OPEN


@pytest.mark.parametrize(
    ("first", "second", "provisional"), [(PASS, FAIL, NO), (FAIL, PASS, NO), (PASS, PASS, YES), (PASS, None, None)]
)
def test_methods_that_must_both_hold_would_pass_only_where_both_would(first, second, provisional):
    checks = [
        check("dmi2008-linear", SILENT, provisional=first),
        check("dmi2008-nonlinear", SILENT, provisional=second),
    ]
    found = verdict_of("dmi2008", checks, use_class="II")
    assert (found.outcome, found.mechanisms[0].answers[0].provisional) == (OPEN, provisional)


@pytest.mark.parametrize(
    ("basis", "method", "state"),
    [
        ("asce43-05", "asce43-05-history", "no overturning"),
        ("nzsee2017", "nzsee2017-face-loaded", "ULS"),
        ("ec8", "ec8-element", "element"),
    ],
)
def test_an_italian_hazard_is_not_the_action_of_another_code(basis, method, state):
    """It gives SLO to SLC; that of SLV is neither a DBE nor New Zealand's ULS."""
    more = {"target_nbs": 34} if basis == "nzsee2017" else {}
    found = verdict_of(basis, [check(method, PASS, state=state)], periods=True, **more)
    assert (found.outcome, [each.key for each in found.missing]) == (OPEN, ["site.spectrum"])


def test_what_the_project_lacks_as_a_whole_leaves_nothing_to_show():
    lacking = (Missing("site.pga", "less than the hazard's"),)
    found = verdict_of("ntc2018", [check(NONLINEAR, PASS)], use_class="II", missing=lacking)
    assert (found.outcome, found.missing, found.mechanisms[0].provisional) == (OPEN, lacking, None)


def test_what_informs_other_levels_and_thesis_readings_never_decide():
    others = [
        check(NONLINEAR, FAIL, informs=True),
        check(NONLINEAR, FAIL, level_pga_g=0.3),
        check(NONLINEAR, FAIL, reading="thesis"),
    ]
    assert verdict_of("ntc2018", [*others, check(NONLINEAR, PASS)], use_class="II").outcome == YES
    assert verdict_of("ntc2018", others, use_class="II").outcome == OPEN


def test_a_premise_that_is_missing_makes_a_pass_incomplete_and_leaves_a_fail():
    premise = [Missing("materials.m.disintegration", "unknown", 'disintegration = "excluded"')]
    asked = question("ntc2018", use_class="II")
    passing = decide(asked, [check(NONLINEAR, PASS)], missing=premise)
    assert (passing.outcome, passing.provisional) == (OPEN, YES)
    assert passing.missing == tuple(premise)
    assert decide(asked, [check(NONLINEAR, FAIL)], missing=premise).outcome == NO


def test_of_what_may_enlarge_the_demand_nothing_says_that_it_would_pass_with_it():
    """gamma_I of 1.4 in place of 1.0 may turn the pass into a fail; the numbers without it show which way."""
    asked = question("ec8", state="ULS")
    larger = [Missing("site.spectrum.importance_factor", "class IV", "importance_factor = 1.4", enlarges=True)]
    as_is = [Missing("materials.m.disintegration", "unknown", 'disintegration = "excluded"')]
    for missing, would_be in ((as_is, YES), (larger, OPEN), ([*as_is, *larger], OPEN)):
        found = decide(asked, [check("ec8-element", PASS, state="element")], missing=missing)
        assert (found.outcome, found.provisional) == (OPEN, would_be)
    failing = decide(asked, [check("ec8-element", FAIL, state="element")], missing=larger)
    assert failing.outcome == NO


@pytest.mark.parametrize(("said", "would_be"), [(PASS, YES), (FAIL, NO), (SILENT, OPEN)])
def test_what_rests_on_a_provisional_value_is_neither_a_pass_nor_a_failure(said, would_be):
    stands_for = (Missing("building.use_class", "which class", 'use_class = "II"'),)
    for found in (
        decide(question("ntc2018", use_class="II"), [check(NONLINEAR, said)], provisional=stands_for),
        decide(question("ntc2018", provisional=stands_for), [check(NONLINEAR, said)]),
    ):
        assert (found.outcome, found.mechanisms[0].outcome) == (OPEN, OPEN)
        assert found.provisional == would_be
        assert "building.use_class" in [each.key for each in found.missing]


@pytest.mark.parametrize(
    ("index", "tolerance", "near"),
    [(1.049, 0.0, True), (1.051, 0.0, False), (0.951, 0.0, True), (1.1, 0.12, True), (1.1, 0.09, False)],
)
def test_at_the_limit_within_five_per_cent_or_the_survey_tolerance(index, tolerance, near):
    one = check(NONLINEAR, PASS if index >= 1.0 else FAIL, ratio=1.0 / index)
    found = decide(question("ntc2018", use_class="II"), [one], tolerance=tolerance)
    assert found.at_the_limit is near


def test_the_building_is_the_worst_of_its_mechanisms_and_its_index_the_least():
    from assess.codes.question import MechanismChecks
    from assess.codes.verdict import verdict

    asked = question("ntc2018", use_class="II")
    walls = {
        "a": check(NONLINEAR, PASS, ratio=0.4),
        "b": check(NONLINEAR, FAIL, ratio=1.25),
        "c": check(NONLINEAR, SILENT),
    }
    judged = {name: MechanismChecks(name, (wall,)) for name, wall in walls.items()}
    found = {names: verdict(asked, [judged[name] for name in names]) for names in ("a", "ab", "ac", "abc")}
    assert [each.outcome for each in found.values()] == [YES, NO, OPEN, NO]
    assert found["ab"].index.value == pytest.approx(0.8)
    assert found["ac"].index is None
    assert [one.margin for one in found["ab"].mechanisms] == pytest.approx([2.5, 0.8])


def test_every_basis_has_its_clauses_and_says_what_was_not_compared():
    assert all(basis.clauses and basis.uncompared for basis in BASES.values())
