"""What changed between two runs: each kind of difference, and none where there is none."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from assess.codes.verdict import Decision
from assess.messages.message import Message, Severity
from assess.results import ResolvedValue, Results, SensitivityResult, SweepResult
from assess.results.diff import KINDS, Difference, differences, same
from assess.study.envelopes import run_envelopes
from tests.support.projects import ASCE7, block, project_toml, published, results_of, study_of, wall

PROJECT = project_toml(
    verdict={"basis": "dmi2008", "procedures": ["dmi2008-linear"]},
    building={"use_class": "II", "height": 9, "storeys": 2},
    site={"limit_state": "SLV", "spectrum": ASCE7 | {"s_ds": "0.75 g", "s_d1": "0.3 g"}},
    materials={"stone": {"density": 2000, "disintegration": "excluded"}},
    bodies={"wall": wall(length=4.0, height=4.5, material="stone")},
    mechanisms={
        "wall": block(sides="one", direction=[1, 0, 0]),
        "parapet": published(2.4, 0.26, 1.2, disintegration="excluded"),
    },
    report={
        "sources": {
            "materials.stone": "measured: blocks bonded through the wall",
            "mechanisms.parapet.disintegration": "measured: blocks bonded through the wall",
        }
    },
    records={"synthetic": {"count": 1, "duration": 8}},
    analysis={"levels": ["0.1 g", "0.3 g"], "procedures": ["asce43-05-spectrum", "dmi2008-linear"]},
)
TIE = 'sides = "one"\nloads = [{ kind = "tie", force = "20 kN", at = [0, 4], direction = [-1, 0] }]'
SOURCES = "[report.sources]"
TIE_SHOWN = f'{SOURCES}\n"mechanisms.wall.loads[1]" = "measured: anchored behind the floor, tensioned in 2024"'


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("runs")


@pytest.fixture(scope="module")
def before(folder: Path) -> Results:
    return results_of(folder, PROJECT)


@pytest.fixture(scope="module")
def after(folder: Path, before: Results) -> Results:
    return results_of(folder, PROJECT.replace('sides = "one"', TIE, 1).replace(SOURCES, TIE_SHOWN, 1))


def of_kind(found: tuple[Difference, ...], kind: str) -> Iterator[Difference]:
    return (change for change in found if change.kind == kind)


def test_a_run_does_not_differ_from_itself(before: Results, after: Results) -> None:
    assert differences(before, before) == differences(after, after) == ()


def test_a_tie_turns_the_verdict_which_stands_first(before: Results, after: Results) -> None:
    found = differences(before, after)
    building, *others = of_kind(found, "verdict")
    assert found[0] == building == Difference("verdict", "", "verdict", "fail", "pass")
    assert Difference("verdict", "wall", "verdict", "fail", "pass") in others
    margin = next(each for each in others if each.what == "holds up to, over the site's PGA")
    assert margin.before < 1.0 < margin.after
    assert [change.kind for change in found] == sorted((c.kind for c in found), key=KINDS.index)
    assert {change.where for change in found} <= {"wall", "mechanisms.wall", "", "project.toml"}  # parapet: as it was
    tied, source = of_kind(found, "project")
    assert (tied.what, tied.before) == ("mechanisms.wall.loads[1]", None)
    assert source.what == "report.sources.mechanisms.wall.loads[1]"
    assert (tied.after["kind"], tied.after["force"]) == ("tie", 20000.0)
    (file,) = of_kind(found, "input")
    assert (file.where, file.what) == ("project.toml", "sha256")


def test_numbers_are_those_of_both_results(before: Results, after: Results) -> None:
    found = differences(before, after)
    one, other = (results.mechanisms[0] for results in (before, after))
    (uplift,) = (c for c in of_kind(found, "parameter") if c.what == "uplift_multiplier, positive")
    assert (uplift.before, uplift.after) == (one.oscillator.uplift_multiplier, other.oscillator.uplift_multiplier)
    assert uplift.relative == pytest.approx(uplift.after / uplift.before - 1.0, rel=1e-15)
    (capacity,) = (c for c in of_kind(found, "capacity") if c.what == "capacity, dmi2008-linear")
    assert (capacity.before, capacity.after) == tuple(m.checks[-1].capacity_pga_g for m in (one, other))
    ratios = {c.what: (c.before, c.after) for c in of_kind(found, "ratio")}
    assert ratios["dmi2008-linear at 0.3 g"] == tuple(m.checks[-1].ratio for m in (one, other))


def test_a_limit_state_is_compared_with_itself_where_the_other_run_has_more(before: Results) -> None:
    """SLV beside SLD in one run, alone in the other: the SLV checks are one pair, the SLD ones stand alone."""
    wall = before.mechanisms[0]
    more = replace(wall, checks=(*wall.checks, *(replace(check, limit_state="SLD") for check in wall.checks[-2:])))
    assert {check.procedure for check in wall.checks[-2:]} == {"dmi2008-linear"}
    found = differences(replace(before, mechanisms=(more, *before.mechanisms[1:])), before)
    assert len(found) == 6  # at two levels verdict and ratio; capacity, uplift
    assert all("SLD" in change.what and change.after is None for change in found)


def test_the_other_way_round_is_the_mirror_image(before: Results, after: Results) -> None:
    assert set(map(repr, differences(after, before))) == {
        repr(replace(change, before=change.after, after=change.before)) for change in differences(before, after)
    }


def test_what_one_run_alone_has_is_a_change(before: Results) -> None:
    less = replace(
        before, mechanisms=before.mechanisms[:1], warnings=(*before.warnings, Message("a", Severity.WARNING, "b", "c"))
    )
    found = differences(before, less)
    assert [(c.kind, c.where, c.before, c.after) for c in found] == [
        ("mechanism", "parapet", "equivalent-block", None),
        ("warning", "b", None, "c"),
    ]


@pytest.mark.parametrize("given", [False, True])
def test_a_key_that_one_run_lacks_is_a_change_if_it_was_given(before: Results, given: bool) -> None:
    """Results of an older version lack the keys that came later, with their defaults."""
    later = replace(before, project={**before.project, "report.motto": ResolvedValue("none", given)})
    assert [(c.what, c.before, c.after) for c in differences(before, later)] == [("report.motto", None, "none")] * given
    assert [(c.what, c.before, c.after) for c in differences(later, before)] == [("report.motto", "none", None)] * given


def test_a_warning_of_the_same_words_under_another_key_is_the_same(before: Results) -> None:
    one, other = (
        replace(before, warnings=(Message(key, Severity.WARNING, "mechanisms.wall", "it slides"),))
        for key in ("mechanism", "slides")
    )
    assert differences(one, other) == ()


def test_rounding_is_hidden_and_zero_tolerance_shows_it(before: Results) -> None:
    wall = before.mechanisms[0]
    nudged = replace(wall, oscillator=replace(wall.oscillator, p_eq_per_s=wall.oscillator.p_eq_per_s * (1 + 1e-8)))
    other = replace(before, mechanisms=(nudged, *before.mechanisms[1:]))
    assert differences(before, other) == ()
    assert [c.what for c in differences(before, other, tolerance=0.0)] == ["p_eq_per_s, positive"]


def test_blocks_that_are_not_compared_are_named_where_they_alone_differ(before: Results, after: Results) -> None:
    wall, *rest = before.mechanisms
    step = replace(wall.checks[0].steps[0], value=1e9)
    check = replace(wall.checks[0], steps=(step, *wall.checks[0].steps[1:]))
    edited = replace(
        before, mechanisms=(replace(wall, checks=(check, *wall.checks[1:])), *rest), comparison=before.comparison[1:]
    )
    (change,) = differences(before, edited)
    assert (change.kind, change.after) == ("other", f"comparison, checks of {wall.name}")
    nearly = replace(check, steps=(replace(step, value=wall.checks[0].steps[0].value * (1 + 1e-9)), *check.steps[1:]))
    rounded = replace(before, mechanisms=(replace(wall, checks=(nearly, *wall.checks[1:])), *rest))
    assert not differences(before, rounded)
    assert not [*of_kind(differences(before, after), "other")]  # there they follow from what is listed


def test_values_are_one_item_by_item() -> None:
    assert same([1.0, {"a": 2.0}], [1.0 + 1e-9, {"a": 2.0}], tolerance=1e-6)
    assert not same([1.0], [1.0, 2.0], tolerance=1e-6)
    assert not same({"a": 1}, {"b": 1}, tolerance=1e-6)
    assert not same(True, 1, tolerance=1e-6)
    assert not same("1", 1, tolerance=1e-6)
    assert same(1, 1.0, tolerance=0.0)
    assert same(0.0, 1e-17, tolerance=0.0)
    assert not same(None, 0.0, tolerance=1.0)


def test_what_changed_in_a_load_is_one_number(after: Results) -> None:
    loads = after.project["mechanisms.wall.loads"]
    stronger = ResolvedValue([{**loads.value[0], "force": 12000.0}], True)
    found = differences(after, replace(after, project={**after.project, "mechanisms.wall.loads": stronger}))
    assert [(c.what, c.before, c.after) for c in found] == [("mechanisms.wall.loads[1].force", 20000.0, 12000.0)]


def swept(values: tuple[float, ...], ratios: tuple[float | None, ...], controlling: int) -> SweepResult:
    """A study of a density by hand: the last case overturns where it has no ratio."""
    n = len(values)
    fell = tuple(ratio is None for ratio in ratios)
    same, none = (0.5,) * n, (None,) * n
    answers = (ratios, fell, (0.2,) * n, (Decision.PASS,) * n, controlling, True)
    return SweepResult(
        "wall", "materials.stone.density", "kg/m^3", values, same, same, same, none, none, same, *answers
    )


def test_cases_of_a_study_are_compared_value_by_value(before: Results) -> None:
    one = replace(before, sweeps=(swept((1800.0, 2000.0), (0.8, 0.9), 1),))
    other = replace(before, sweeps=(swept((1800.0, 2000.0, 2200.0), (0.8, None, None), 2),))
    found = {c.what: (c.before, c.after) for c in of_kind(differences(one, other), "sweep")}
    assert found["materials.stone.density that controls"] == (2000.0, 2200.0)
    assert found["demand_capacity, materials.stone.density = 2000 kg/m^3"] == (0.9, "overturned")
    assert found["demand_capacity, materials.stone.density = 2200 kg/m^3"] == (None, "overturned")
    assert not any("1800" in what for what in found)
    assert list(differences(one, one)) == []


def test_sensitivities_are_compared_at_both_ends(before: Results) -> None:
    row = SensitivityResult(
        "wall", "density", "", "materials.stone.density", "kg/m^3", 2000.0, 1800.0, 2200.0, "dmi2008-linear", "SLV",
        0.3, "demand_capacity", 0.9, 0.8, 1.0, "pass", "pass", "pass",
    )  # fmt: skip
    other = replace(row, high=2400.0, at_high=1.1, verdict_high="fail")
    found = differences(replace(before, sensitivity=(row,)), replace(before, sensitivity=(other,)))
    what = "demand_capacity, dmi2008-linear SLV at 0.3 g, materials.stone.density high"
    assert {(c.kind, c.where, c.what, c.before, c.after, c.unit) for c in found} == {
        ("sensitivity", "wall", "materials.stone.density, high", 2200.0, 2400.0, "kg/m^3"),
        ("sensitivity", "wall", what, 1.0, 1.1, ""),
        ("sensitivity", "wall", f"verdict of {what}", "pass", "fail", ""),
    }


def test_envelopes_are_compared_by_their_least_pulse(folder: Path) -> None:
    pulses = (
        '[analysis.pulses]\nfrequency = { from = 0.5, to = 2, count = 3 }\namplitude = { from = "0 g", to = "2 g", '
        "count = 5 }\n"
    )
    found = []
    for uplift in (0.2, 0.3):
        text = PROJECT.replace("uplift = 0.2", f"uplift = {uplift}") + pulses
        found.append(run_envelopes(study_of(folder, text), jobs=1))
    least = next(c for c in of_kind(differences(*found), "envelope") if c.where == "parapet")
    ends = [min(b for b in each.mechanisms[1].envelope.lower_bound_g if b is not None) for each in found]  # type: ignore[union-attr]
    assert (least.what, least.before, least.after) == ("least pulse that overturns", *ends)
    assert least.before < least.after
