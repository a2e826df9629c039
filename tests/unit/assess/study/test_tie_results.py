"""Ties that stretch as results: three plates by hand, what fails first, and what is said of it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from assess.cli.tables.project import duration_text, tie_text
from assess.codes.calculation_sheet import Step
from assess.loads.load import Tie
from assess.results import LoadResult
from assess.study.checks import _facts_of
from assess.study.mechanism_results import parameters
from assess.study.study import Study
from tests.support import projects
from tests.support.projects import NTC, block, lines, project_toml, wall

PLATE = (
    'width = "300 mm", height = "300 mm", thickness = "15 mm", yield_stress = "235 MPa", nut = "50 mm", '
    'thread_area = "245 mm^2", tensile_strength = "360 MPa", shear_strength = "0.02 MPa", '
    'bearing_strength = "1 MPa", far_strength = "100 kN", between = "400 kN"'
)
ROUND = (
    'diameter = "0.4 m", thickness = "20 mm", yield_stress = "235 MPa", nut = "60 mm", '
    'thread_area = "157 mm^2", tensile_strength = "360 MPa", shear_strength = "0.2 MPa", friction = 0.4, '
    'normal_stress = "0.1 MPa", bearing_strength = "2 MPa", far_strength = "300 kN", between = "400 kN"'
)
INJECTED = (
    'width = "250 mm", height = "500 mm", thickness = "8 mm", yield_stress = "235 MPa", nut = "100 mm", '
    'thread_area = "314 mm^2", tensile_strength = "360 MPa", shear_strength = "0.1 MPa", '
    'bearing_strength = "1.5 MPa", leaf = "0.3 m", hole = "50 mm", embedment = "0.8 m", bond_strength = "0.3 MPa", '
    'between = "400 kN"'
)
SOURCE = '[report.sources]\n"mechanisms.wall.loads[1]" = "measured: survey"'


def tie(plate: str, more: str = "", *, area: str = "314 mm^2", at: str = "[0.3, 0, 3.5]") -> str:
    there = at.replace("[0.3", "[-9.7")
    held = f", plate = {{ {plate} }}" if plate else ""
    return (
        f'{{ kind = "tie", at = {at}, anchor = {there}, area = "{area}", young_modulus = "210 GPa", '
        f'yield_stress = "235 MPa", length = "10 m", fracture_strain = 0.1{held}{more} }}'
    )


def study_of(folder: Path, *ties: str, level: str = "", top: str = SOURCE) -> Study:
    mechanism = block(direction=[1, 0, 0], sides="one")
    text = project_toml(
        site={"limit_state": "SLV", "spectrum": NTC | {"a_g": "0.1 g", "soil": "B", "topography": "T1"}},
        materials={"m": {"density": 1900}},
        bodies={"wall": wall(0.6, 6.0, 6.0, material="m")},
        mechanisms={"wall": lines(mechanism, f"loads = [{', '.join(ties)}]")},
        analysis={"procedures": ["ntc2018-nonlinear"]},
    )
    known = f'[procedures.ntc2018]\nknowledge_level = "{level}"\n' if level else ""
    return projects.study_of(folder, f"{top}\n{known}{text}")


def load_of(study: Study) -> LoadResult:
    return parameters(study)[0].loads[0]


def values(load: LoadResult) -> dict[str, float | None]:
    assert load.tie is not None
    return {step.symbol: step.value for step in load.tie.steps}


KN = 1e3
BY_HAND = {
    # bar 314 x 235 = 73.79; / 1.05 = 70.28; thread 0.9 x 245 x 360 / 1.25 = 63.50; plate 0.09 x 0.015^2 x 235e6 /
    # (2.1 x 0.125^2) = 145.03; bearing 0.09 x 1e6 / 2.7 = 33.33; punching 2.16 x 0.02e6 / 2.7 = 16.00
    PLATE: {"N_y": 73.79, "N_Rd": 70.28, "N_1": 63.50, "N_2": 145.03, "N_3": 33.33, "N_4": 16.00, "N_6": 100.0},
    # thread 0.9 x 157 x 360 / 1.25 = 40.69; plate pi 0.04 x 0.02^2 x 235e6 / (2.1 x 0.17^2) = 194.64; bearing
    # 0.125664 x 2e6 / 2.7 = 93.08; punching pi (0.4 + 0.6) 0.6 x (0.2 + 0.04) MPa / 2.7 = 167.55
    ROUND: {"N_1": 40.69, "N_2": 194.64, "N_3": 93.08, "N_4": 167.55, "N_6": 300.0},
    # plate 0.125 x 0.008^2 x 235e6 / (2.1 x 0.2^2) = 22.38; bearing 0.125 x 1.5e6 / 2.7 = 69.44; punching
    # 2 (0.25 + 0.5 + 0.6) 0.3 x 0.1 MPa / 2.7 = 30.0; bond pi 0.05 x 0.8 x 0.3 MPa / 2.7 = 13.96, cone
    # pi 0.85 x 0.8 x 0.1 MPa / 2.7 = 79.12
    INJECTED: {"N_1": 81.39, "N_2": 22.38, "N_3": 69.44, "N_4": 30.00, "N_b": 13.96, "N_c": 79.12, "N_6": 13.96},
}
"""What each part bears [kN], worked with a pocket calculator."""


@pytest.mark.parametrize("plate", BY_HAND)
def test_three_plates_by_hand(tmp_path: Path, plate: str) -> None:
    load = load_of(study_of(tmp_path, tie(plate)))
    found = values(load)
    for symbol, expected in BY_HAND[plate].items():
        value = found[symbol]
        assert value is not None
        assert value / KN == pytest.approx(expected, rel=1e-3), symbol
    assert load.tie is not None
    assert load.tie.anchorage_n == pytest.approx(min(BY_HAND[plate][f"N_{k}"] for k in (1, 2, 3, 4, 6)) * KN, rel=1e-3)


def worked(step: Step) -> float:
    """Put the numbers of a line into its formula as it is printed."""
    written = step.formula.replace("²", "**2").replace("·", "*").replace("−", "-").replace("π", "3.141592653589793")
    names = {each.symbol: each.value for each in step.inputs}
    for symbol in sorted(names, key=len, reverse=True):
        written = re.sub(rf"(?<![\w]){re.escape(symbol)}(?![\w])", repr(names[symbol]), written)
    return float(eval(written, {"min": min}))


@pytest.mark.parametrize("plate", BY_HAND)
def test_lines_are_their_formulas_worked(tmp_path: Path, plate: str) -> None:
    load = load_of(study_of(tmp_path, tie(plate)))
    assert load.tie is not None
    lines_with_inputs = [step for step in load.tie.steps if step.inputs and step.value is not None]
    assert len(lines_with_inputs) > 6
    for step in lines_with_inputs:
        assert worked(step) == pytest.approx(step.value, rel=1e-9), step.symbol


def test_it_punches_at_16_kn_where_the_bar_yields_at_74(tmp_path: Path) -> None:
    """Gone at 16.0 / (210e9 x 314e-6 / 10) = 2.43 mm; d_SLV has no part of it, as it does not last."""
    study = study_of(tmp_path, tie(PLATE))
    load = load_of(study)
    assert load.tie is not None
    assert (load.tie.ductile, str(load.tie.fails)) == (False, "the plate punches through the wall")
    assert load.tie.gone_m == pytest.approx(16e3 / (210e9 * 314e-6 / 10.0), rel=1e-6)
    assert load.lasting == "to its end"
    (told,) = [each for each in study.messages if each.key == "tie-brittle"]
    assert "the plate punches through the wall at 16" in told.text
    assert "brittle, the plate punches through the wall first" in tie_text(load.tie)


@pytest.mark.parametrize(
    ("bar", "thread", "kilonewtons", "fails", "lasting"),
    [
        # the bar yields at 11.75 kN; a thread of its own section bears 0.9 x 50 x 360 / 1.25 = 12.96 kN, 1.10 times
        ("50 mm^2", "50 mm^2", 12.96, "the thread of the bar breaks", "to its end"),
        # with an upset end of 80 mm2 20.7 kN: the plate punches at 16 kN, 1.36 times
        ("50 mm^2", "80 mm^2", 16.0, "the bar yields", "to collapse"),
    ],
)
def test_a_thin_bar_with_an_upset_end_is_ductile(
    tmp_path: Path, bar: str, thread: str, kilonewtons: float, fails: str, lasting: str
) -> None:
    load = load_of(study_of(tmp_path, tie(PLATE.replace("245 mm^2", thread), area=bar)))
    assert load.tie is not None
    assert load.tie.anchorage_n == pytest.approx(kilonewtons * KN, rel=1e-6)
    assert (str(load.tie.fails), load.lasting) == (fails, lasting)
    assert load.tie.ductile is (fails == "the bar yields")


@pytest.mark.parametrize(("level", "factor"), [("", 1.35), ("LC1", 1.35), ("LC2", 1.2), ("LC3", 1.0)])
def test_the_level_of_knowledge_gives_fc(tmp_path: Path, level: str, factor: float) -> None:
    found = values(load_of(study_of(tmp_path, tie(PLATE), level=level)))
    assert found["N_4"] == pytest.approx(2.16 * 0.02e6 / (2.0 * factor), rel=1e-6)


def test_a_level_of_knowledge_without_a_source_is_replaced_in_the_plate_too(tmp_path: Path) -> None:
    """16.0 kN by LC1, where LC3 as typed gives 21.6."""
    study = study_of(tmp_path, tie(PLATE), level="LC3")
    (level,) = [each for each in study.replaceables if each.key == "procedures.ntc2018.knowledge_level"]
    (load,) = [each for each in level.study_at("wall").mechanisms[0].positive.loads if isinstance(each, Tie)]
    assert load.strength == pytest.approx(16e3, rel=1e-6)


def test_what_a_plate_lacks_is_told_and_the_tie_does_not_last(tmp_path: Path) -> None:
    lacking = PLATE.replace(', far_strength = "100 kN"', "").replace(', nut = "50 mm"', "")
    study = study_of(tmp_path, tie(lacking))
    load = load_of(study)
    assert load.lasting == "not shown"
    assert load.missing == ("plate.nut", "plate.far_strength")
    assert "plate.nut, plate.far_strength missing" in duration_text(load)
    assert tie_text(load.tie).endswith("anchorage not answered")
    (told,) = [each for each in study.messages if each.key == "tie-not-lasting"]
    assert "give plate.nut, plate.far_strength (" in told.text
    assert load.tie is not None
    assert {step.symbol: step.subject for step in load.tie.steps if step.value is None} == {
        "N_2": "plate.nut", "N_6": "plate.far_strength", "N_7": "", "N_8": "plate.course, plate.overlap", "N_a": "",
    }  # fmt: skip


def test_a_stated_strength_stands_in_for_what_is_not_given_and_never_above_what_is(tmp_path: Path) -> None:
    lacking = PLATE.replace(', far_strength = "100 kN"', "")
    for stated, expected in ((12, 12e3), (90, 16e3)):
        load = load_of(study_of(tmp_path, tie(lacking, f', strength = "{stated} kN"')))
        assert load.tie is not None
        assert load.tie.anchorage_n == pytest.approx(expected, rel=1e-6)


def test_without_a_source_its_plate_does_not_make_it_last(tmp_path: Path) -> None:
    load = load_of(study_of(tmp_path, tie(PLATE), top=""))
    assert (load.lasting, load.missing) == ("not shown", ("source",))


def test_a_plate_of_another_mechanism_on_the_same_wall_shares_its_cone(tmp_path: Path) -> None:
    """0.5 m beside it: 2.82 m2 for two in place of 2.16 for each; the same tie in both mechanisms is one."""
    twice = tie(PLATE, at="[0.3, 0.5, 3.5]")
    whole, top = block(direction=[1, 0, 0], sides="one"), block(direction=[1, 0, 0], sides="one", cut="1 m")
    text = project_toml(
        site={"limit_state": "SLV", "spectrum": NTC | {"a_g": "0.1 g", "soil": "B", "topography": "T1"}},
        materials={"m": {"density": 1900}},
        bodies={"wall": wall(0.6, 6.0, 6.0, material="m")},
        mechanisms={
            "wall": lines(whole, f"loads = [{tie(PLATE)}]"),
            "top": lines(top, f"loads = [{tie(PLATE)}, {twice}]"),
        },
        analysis={"procedures": ["ntc2018-nonlinear"]},
    )
    study = projects.study_of(tmp_path, f"{SOURCE}\n{text}")
    found = [load.tie.anchorage_n for each in parameters(study) for load in each.loads if load.tie is not None]
    assert found == [pytest.approx(2.82 / 2 * 0.02e6 / 2.7, rel=2e-3)] * 3


def test_a_drawn_far_wall_counts_under_the_action_of_the_site(tmp_path: Path) -> None:
    """0.6 x 2.4 x 6 m of 1900 kg/m3 at 0.02 x 1.35: W (0.3 - 0.027 x 3) / 3.5 = 10.08 kN, where the plate bears 16.

    A stated far end of 100 kN no longer counts; at 0.1 g the wall turns by itself, and there is no tie.
    """

    def study_at(a_g: str) -> Study:
        text = project_toml(
            site={"limit_state": "SLV", "spectrum": NTC | {"a_g": a_g, "soil": "A", "topography": "T1"}},
            materials={"m": {"density": 1900}},
            bodies={
                "wall": wall(0.6, 6.0, 6.0, material="m"),
                "rear": wall(0.6, 2.4, 6.0, material="m", base=[-9.7, 0, 0]),
            },
            mechanisms={"wall": lines(block(direction=[1, 0, 0], sides="one"), f"loads = [{tie(PLATE)}]")},
            analysis={"procedures": ["ntc2018-nonlinear"]},
        )
        return projects.study_of(tmp_path, f"{SOURCE}\n{text}")

    weight = 0.6 * 2.4 * 6.0 * 1900 * 9.80665
    held = study_at("0.02 g")
    load = load_of(held)
    found = values(load)
    assert found["α"] == pytest.approx(0.027, rel=1e-9)
    assert found["N_7"] == found["N_a"] == pytest.approx(weight * (0.3 - 0.027 * 3.0) / 3.5, rel=1e-9)
    assert load.tie is not None
    assert str(load.tie.fails) == "the wall at the far end turns inwards"
    (told,) = [each for each in held.messages if each.key == "far-wall-less"]
    assert 'the wall "rear" at its far end turns inwards above 0 m' in told.text
    fallen = study_at("0.1 g")
    load = load_of(fallen)
    assert (load.lasting, load.missing) == ("not shown", ("a far wall that holds",))
    assert values(load)["N_7"] == 0.0
    assert [each.key for each in fallen.messages if each.key.startswith("far-wall")] == ["far-wall-falls"]


def test_a_pass_depends_on_far_walls_that_are_not_examined(tmp_path: Path) -> None:
    """Where no wall is drawn at the anchor the condition and the sheet say so."""
    study = study_of(tmp_path, tie(PLATE))
    (told,) = [each for each in _facts_of(study, "wall")[1] if each.key == "far-wall-unexamined"]
    assert told.text.endswith("the far end of tie 1 holds it; it is not examined: no wall is drawn at the anchor")
    load = load_of(study)
    assert load.tie is not None
    (line,) = [step for step in load.tie.steps if step.symbol == "N_7"]
    assert line.remark == "no wall is drawn at the anchor"
