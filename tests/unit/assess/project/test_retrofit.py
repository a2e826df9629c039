"""Least works on small projects: against statics by hand, against runs of what is written, and what is refused."""

from __future__ import annotations

import csv
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import assess
from assess.cli.tables.retrofit import retrofit_text
from assess.errors import AssessError, OutputError
from assess.project.bars import bars_of
from assess.project.build import build, build_with_cases
from assess.project.keys import read_content
from assess.project.layouts import with_tolerance
from assess.project.project_file import load
from assess.project.works import WORKS, subject_of
from assess.results.retrofit import Tolerance
from assess.study.histories import rocking_case
from assess.study.level_peaks import level_solver, suites_of
from assess.study.retrofit import record_ratios, tolerances
from assess.study.suites import motions_of
from tests.support.motions import write_noise
from tests.support.projects import replace_once

BAR = (
    'area = "314 mm^2", young_modulus = "210 GPa", yield_stress = "235 MPa", fracture_strain = 0.05, length = "10 m", '
    'strength = "200 kN"'
)
FACADE = f"""
title = "Façade"
[site]
limit_state = "SLV"
[site.spectrum]
code = "ntc2018"
a_g = "0.25 g"
f_0 = 2.4
t_c_star = "0.33 s"
soil = "B"
[building]
height = "6 m"
storeys = 1
use_class = "II"
[materials.stone]
density = "2000 kg/m^3"
young_modulus = "1.5 GPa"
disintegration = "excluded"
[bodies.wall]
material = "stone"
box = {{ thickness = 0.6, length = 8.0, height = 6.0 }}
[mechanisms.facade]
kind = "single-block"
blocks = ["wall"]
direction = [1, 0, 0]
sides = "one"
amplification = {{ method = "modal-filter" }}
loads = [
  # d20, one for all
  {{ kind = "tie", force = "8 kN", at = [-0.3, 0, 5.5], anchor = [-10.3, 0, 5.5], {BAR} }},
]
[records]
files = ["records/*.csv"]
[report.sources]
"mechanisms.facade.loads[1]" = "measured: design of the ties"
"materials.stone.disintegration" = "measured: survey"
"""
AREA, COUNT, BASE = (f"mechanisms.facade.{key}" for key in ("ties.area", "ties.count", "base.width"))


def facade(folder: Path, *changes: tuple[str, str], records: int = 6) -> Path:
    (folder / "records").mkdir(parents=True, exist_ok=True)
    for seed in range(records):
        write_noise(folder / "records" / f"r{seed}.csv", duration=6.0, seed=seed, amplitude=2.0)
    text = FACADE
    for old, new in changes:
        text = replace_once(text, old, new)
    path = folder / "project.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_least_constant_force_by_hand(tmp_path: Path) -> None:
    """A tie of constant force T at h_t holds a block: alpha_0 = (W t / 2 + T h_t) / (W h / 2).

    NTC 2018 asks for alpha_0 g / FC >= a_g S / 2 at the ground, with e* = 1 and FC = 1.35; S = 1.4 - 0.4 F_0 a_g / g.
    The proof lowers the tie by a tenth, where it takes a ninth more.
    """
    tie = 'force = "8 kN", at = [-0.3, 0, 5.5], anchor = [-10.3, 0, 5.5], ' + BAR
    path = facade(
        tmp_path,
        (tie, 'force = "8 kN", at = [-0.3, 0, 0.9], direction = [-1, 0, 0]'),
        ("[records]", '[verdict]\nprocedures = ["ntc2018-linear"]\n[records]'),
    )
    key = "mechanisms.facade.loads.tie.force"
    asked: dict[str, Any] = {"target": "index", "reach": 1.0, "vary": {key: "175..210 kN by 1"}}
    found = assess.retrofit(path, **asked, price={key: 1.0}, spacing=9.0).results
    soil = 1.4 - 0.4 * 2.4 * 0.25
    needed = 1.35 * 0.25 * soil / 2.0
    weight = 2000.0 * 9.80665 * 0.6 * 8.0 * 6.0
    force = weight * (needed * 3.0 - 0.3) / 0.9
    holding = [each.values[0] for each in found.layouts if each.reached and found.target.holds(each.reached)]
    assert force / 1e3 < min(holding) < force / 1e3 + 1.0
    assert found.best is not None
    assert force / 0.9e3 < found.best.values[0] < force / 0.9e3 + 1.0
    assert found.best.objective == pytest.approx(found.best.values[0] - 8.0)
    assert found.tried == found.best.values[0] - min(holding) + 1
    with pytest.raises(AssessError, match="shows in no steel"):
        assess.retrofit(path, **asked)


def test_the_project_with_the_works_reaches_the_target(tmp_path: Path) -> None:
    """The file in another folder keeps its comments, finds its records, and its verdict is that of the search."""
    path = facade(tmp_path / "house [1]")
    before = path.read_bytes()
    found = assess.retrofit(path, target="index", reach=1.0, vary={AREA: [80, "150 mm^2", 200], COUNT: "2..4"})
    results = found.results
    assert results.best is not None
    assert results.best.steel == pytest.approx(7850.0 * results.best.values[0] * 1e-6 * results.best.values[1] * 10.0)
    least = min(each.steel for each in results.layouts if each.reached and results.target.holds(each.reached))
    assert results.best.steel == least
    assert [proof.tolerance for proof in results.proofs] == list(tolerances())
    written = assess.write_retrofit(found, tmp_path / "out", jobs=1)
    text = written.read_text(encoding="utf-8")
    assert "# d20, one for all" in text
    run = assess.run(written, jobs=1)
    assert run.verdict is not None
    assert run.verdict.index is not None
    assert results.best.reached is not None
    assert run.verdict.index.value == pytest.approx(results.best.reached.value, rel=1e-9)
    assert len(run.results.records) == 6
    loads = tomllib.loads(text)["mechanisms"]["facade"]["loads"]
    across = np.array([load["at"][1] for load in loads])
    assert len(loads) == results.best.values[1]
    np.testing.assert_allclose(np.diff(across), 8.0 / len(loads))
    assert across.sum() == pytest.approx(0.0, abs=1e-9)
    assert path.read_bytes() == before
    assert {each.name for each in (tmp_path / "out" / "tables").iterdir()} == {"front.csv", "layouts.csv", "proof.csv"}
    assert (tmp_path / "out" / "figures" / "front.svg").read_text(encoding="utf-8").startswith("<?xml")
    with pytest.raises(OutputError, match="was not written by assess"):
        assess.write_retrofit(found, path.parent)
    assert path.read_bytes() == before


def test_a_name_of_several_lines_stays_in_the_comment_of_what_is_written(tmp_path: Path) -> None:
    named = ("[mechanisms.facade]", '[mechanisms."fa\\ncade"]'), ("mechanisms.facade.", "mechanisms.fa\\ncade.")
    path = facade(tmp_path, *named)
    vary = {"mechanisms.fa\ncade.loads[1].area": "400, 500 mm^2"}
    found = assess.retrofit(path, target="index", reach=0.05, vary=vary, spacing=9.0)
    text = found.project_text(tmp_path / "out")
    assert r"#   mechanisms.fa\ncade.loads[1].area = 400 mm^2" in text
    assert tomllib.loads(text)["mechanisms"].keys() == {"fa\ncade"}


def test_rules_of_detailing_refuse_layouts(tmp_path: Path) -> None:
    path = facade(tmp_path)
    found = assess.retrofit(path, target="index", reach=1.0, vary={AREA: "50, 100 mm^2", COUNT: "2..3"}).results
    said = {each.values: "" if each.refused is None else each.refused.text for each in found.layouts}
    assert said[100.0, 3.0] == ""
    assert said[100.0, 2.0] == "its anchors are 4 m apart, more than 3 m"
    assert said[50.0, 3.0].startswith("its pretension of 8000 N is above half of what yields the bar, 5875 N")
    wide = assess.retrofit(
        path, target="index", reach=1.0, vary={AREA: "100 mm^2", COUNT: "2..3"}, spacing="5 m"
    ).results
    assert [each.refused for each in wide.layouts] == [None, None]
    assert any(each.key == "retrofit-spacing-allowed" for each in wide.warnings)


PLATE = (
    'plate = { width = "300 mm", height = "300 mm", thickness = "30 mm", yield_stress = "235 MPa", nut = "60 mm", '
    'thread_area = "400 mm^2", tensile_strength = "360 MPa", shear_strength = "0.1 MPa", bearing_strength = "2 MPa", '
    'far_strength = "150 kN" }'
)
OUTSIDE = ("at = [-0.3, 0, 5.5]", "at = [0.3, 0, 5.5]")


def test_anchorages_from_plates_follow_their_places(tmp_path: Path) -> None:
    """The wall between the plates is a part of them, so none is refused for it; plates that crowd in a cone are."""
    path = facade(tmp_path, ('strength = "200 kN"', PLATE), OUTSIDE, ('force = "8 kN"', 'force = "3 kN"'))
    found = assess.retrofit(path, target="index", reach=0.2, vary={AREA: "314 mm^2", COUNT: "2, 3, 12"}).results
    two, three, twelve = found.layouts
    assert two.refused is None
    assert two.reached is not None
    assert three.reached is not None
    assert (two.reached.value or 0.0) < (three.reached.value or 0.0)
    assert twelve.refused is not None
    assert "plates punch one cone; 2 at most may" in twelve.refused.text
    assert [each.key for each in found.warnings] == []


def test_of_a_plate_works_change_its_sizes_and_steel_at_a_price(tmp_path: Path) -> None:
    """What was measured of masonry, and calculations of others, are no works."""
    path, plate = facade(tmp_path, ('strength = "200 kN"', PLATE), OUTSIDE), "mechanisms.facade.loads[1].plate"
    asked: dict[str, Any] = {"target": "index", "reach": 0.1}
    for key in ("shear_strength", "friction", "normal_stress", "bearing_strength", "leaf", "between", "far_strength"):
        with pytest.raises(AssessError, match="no works change it"):
            assess.retrofit(path, **asked, vary={f"{plate}.{key}": "0.1, 0.2"}, price={f"{plate}.{key}": 1.0})
    vary = {f"{plate}.width": "300, 400 mm", COUNT: "3"}
    with pytest.raises(AssessError, match="shows in no steel"):
        assess.retrofit(path, **asked, vary=vary)
    found = assess.retrofit(path, **asked, vary=vary, price={f"{plate}.width": 1.0, "steel": 4.0}).results
    first, second = (each.reached.value for each in found.layouts if each.reached)
    assert first is not None
    assert second is not None
    assert first < second


def test_histories_of_many_layouts_are_those_of_each_alone(tmp_path: Path) -> None:
    """Packed into one call, with ties that are merged, against the solver of a run for each study."""
    project = load(facade(tmp_path, ('amplification = { method = "modal-filter" }\n', "")))
    study = build(project)
    wide = load(
        facade(
            tmp_path / "three", ('amplification = { method = "modal-filter" }\n', ""), (BAR, BAR.replace("314", "100"))
        )
    )
    found = find_study_of_three(wide)
    motions = motions_of(study, study.spectrum, jobs=1)  # type: ignore[arg-type]
    together = record_ratios([study, found, study], motions, share=1.5, twins=True, threads=1)
    for number, each in enumerate((study, found, study)):
        case = rocking_case(each, each.mechanisms[0], motions)
        (alone,) = suites_of(level_solver(case, motions, site_pga=1.0, threads=1)([1.5], "all"))
        assert alone.twins is not None
        np.testing.assert_allclose(together[number], np.asarray(alone.twins.ratio).T, rtol=1e-6)


def find_study_of_three(project: Any) -> Any:
    """The study with three ties in the place of one."""
    built = build_with_cases(project)
    subject = subject_of("facade", built.project.content, built.solids)
    assert subject is not None
    tables = WORKS["ties", "count"].change(built.project.raw, subject, 3.0)
    return built.study_at(read_content(tables, project.folder), ("facade",))


def test_probability_is_proved_on_the_other_records(tmp_path: Path) -> None:
    path = facade(tmp_path, records=10)
    vary = {AREA: "60..160 mm^2 by 20", COUNT: "3..4"}
    found = assess.retrofit(path, target="probability", reach=0.4, vary=vary).results
    assert len(found.search_records) == len(found.proof_records) == 5
    assert not set(found.search_records) & set(found.proof_records)
    assert found.best is not None
    assert len(found.proofs) == 25
    assert found.most == 2  # 0.16 / 0.6^5: two layouts could show it with no record that overturns
    assert all(each.reached.value == pytest.approx(1.0 - 0.08 ** (1 / 5)) for each in found.proofs)
    assert "in the proof a share counts at a confidence of 0.92, so that of up to 2 layouts" in retrofit_text(found)
    with pytest.raises(AssessError, match=r"of 5 records that prove it none may overturn and the upper end is 0.307"):
        assess.retrofit(path, target="probability", reach=0.3, vary=vary)


UPPER = (
    '[mechanisms.upper]\nkind = "single-block"\nblocks = ["wall"]\ndirection = [1, 0, 0]\nsides = "one"\ncut = "3 m"\n'
    f'loads = [\n  {{ kind = "tie", force = "8 kN", at = [-0.3, 0, 5.5], anchor = [-10.3, 0, 5.5], {BAR} }},\n]\n\n'
)
UPPER_SOURCE = (
    '"materials.stone.disintegration"',
    '"mechanisms.upper.loads[1]" = "measured: design of the ties"\n"materials.stone.disintegration"',
)


@pytest.mark.parametrize("key", ["ties.area", "loads.tie.area", "loads[1].area"])
def test_one_bar_of_two_mechanisms_is_one_in_works(tmp_path: Path, key: str) -> None:
    """The lower mechanism alone asks for less; what is written has the same bars in both, and passes in both."""
    path = facade(tmp_path, ("[records]", f"{UPPER}[records]"), UPPER_SOURCE)
    vary = {f"mechanisms.facade.{key}": "80..240 mm^2 by 20", COUNT: "3..4"}
    found = assess.retrofit(path, target="index", reach=1.0, vary=vary)
    results = found.results
    assert results.mechanisms == ("facade", "upper")
    assert results.best is not None
    area, count = results.best.values
    assert results.best.steel == pytest.approx(7850.0 * area * 1e-6 * count * 10.0)
    written = tomllib.loads(found.project_text(tmp_path / "out"))
    bars = [
        [(tie["at"], tie["anchor"], tie["area"]) for tie in written["mechanisms"][name]["loads"]]
        for name in ("facade", "upper")
    ]
    assert bars[0] == bars[1]
    assert len(bars[0]) == count
    assert {each for _, _, each in bars[0]} == {f"{area:g} mm^2"}
    run = assess.run(assess.write_retrofit(found, tmp_path / "out", jobs=1), jobs=1)
    assert [each.key for each in run.results.warnings if each.key == "one-bar-twice"] == []
    assert run.verdict is not None
    indices = [answer.index.value for each in run.verdict.mechanisms for answer in each.answers if answer.index]
    assert min(indices) == pytest.approx(results.best.reached.value if results.best.reached else 0.0, rel=1e-9)


def test_one_bar_of_two_mechanisms_has_one_tolerance(tmp_path: Path) -> None:
    """It moves by a tenth of its height above the lower hinge, in both, and no higher than the top of the wall."""
    path = facade(tmp_path, ("[records]", f"{UPPER}[records]"))
    built = build_with_cases(load(path))
    content = built.project.content
    subjects = {name: each for name in content.mechanisms if (each := subject_of(name, content, built.solids))}
    for factor, height in ((0.9, 4.95), (1.05, 5.775), (1.1, 6.0)):
        tables = with_tolerance(built.project.raw, content, subjects, ("facade",), Tolerance(0.9, height=factor))
        for name in ("facade", "upper"):
            (tie,) = tables["mechanisms"][name]["loads"]
            assert tie["at"][-1] == pytest.approx(height)
            assert tie["area"] == pytest.approx(0.9 * 314e-6)


def test_fewer_ties_than_the_file_has_are_layouts(tmp_path: Path) -> None:
    """Three, one and none of three: those that go take their sources along; none leaves the wall as it is without."""
    tie = f'{{ kind = "tie", force = "8 kN", at = [-0.3, 0, 5.5], anchor = [-10.3, 0, 5.5], {BAR} }},'
    three = "\n  ".join(tie.replace(", 0, ", f", {y}, ") for y in (-2.5, 0.0, 2.5))
    sources = "".join(f'"mechanisms.facade.loads[{place}]" = "measured: tie {place}"\n' for place in (1, 2, 3))
    path = facade(tmp_path, (tie, three), ('"mechanisms.facade.loads[1]" = "measured: design of the ties"\n', sources))
    found = assess.retrofit(path, target="index", reach=0.05, vary={COUNT: "0..3"}, spacing=9.0)
    layouts = {each.values[0]: each for each in found.results.layouts}
    assert [layouts[count].steel for count in (0.0, 1.0, 2.0, 3.0)] == pytest.approx(
        [7850.0 * 314e-6 * 10.0 * count for count in (0, 1, 2, 3)]
    )
    assert found.results.best is not None
    assert found.results.best.values == (0.0,)
    written = tomllib.loads(found.project_text(tmp_path / "out"))
    assert written["mechanisms"]["facade"]["loads"] == []
    assert list(written["report"]["sources"]) == ["materials.stone.disintegration"]
    bare = facade(tmp_path / "bare", (tie, ""), ('"mechanisms.facade.loads[1]" = "measured: design of the ties"\n', ""))
    run = assess.run(bare, jobs=1)
    assert run.verdict is not None
    assert run.verdict.index is not None
    reached = layouts[0.0].reached
    assert reached is not None
    assert reached.value == pytest.approx(run.verdict.index.value, rel=1e-9)


def test_values_without_a_source_are_named_where_histories_count_them(tmp_path: Path) -> None:
    """A rebound of 0.5 is less than the formula gives, which no source vouches for."""
    path = facade(tmp_path, ('sides = "one"', 'sides = "one"\nrestitution = 0.5'))
    found = assess.retrofit(path, target="ratio", reach=0.9, vary={AREA: "150, 300 mm^2", COUNT: "3, 4"}).results
    assert found.best is not None
    (told,) = [each for each in found.warnings if each.key == "retrofit-as-typed"]
    assert "mechanisms.facade.restitution" in told.text


def test_a_target_beyond_all_layouts_is_not_reached(tmp_path: Path) -> None:
    found = assess.retrofit(facade(tmp_path), target="index", reach=50.0, vary={AREA: "100..200 mm^2", COUNT: "3..4"})
    assert found.tables is None
    assert found.results.best is None
    assert found.results.nearest is not None
    assert found.results.nearest.values == (200.0, 4.0)
    written = assess.write_retrofit(found, tmp_path / "out", jobs=1)
    assert written == tmp_path / "out" / "retrofit.pdf"
    assert not (tmp_path / "out" / "project.toml").exists()


def test_what_falls_short_in_the_proof_says_with_which_tolerance(tmp_path: Path) -> None:
    """Area and yield stress a tenth less take a bar below what it needs; the front marks it, and proof.csv lists it."""
    path = facade(tmp_path)
    every = assess.retrofit(path, target="index", reach=0.1, vary={AREA: "100 mm^2", COUNT: "3"}).results
    assert every.best is not None
    assert every.best.reached is not None
    found = assess.retrofit(
        path, target="index", reach=0.999 * (every.best.reached.value or 0.0), vary={AREA: "100 mm^2", COUNT: "3"}
    )
    results = found.results
    assert results.best is None
    (failed,) = results.trials
    assert failed.layout.values == (100.0, 3.0)
    assert not failed.proof.holds
    assert failed.proof.tolerance.yield_stress == 0.9
    assert failed.proof.reached.value is not None
    assert failed.proof.reached.value < results.target.reach
    assert results.table()["proof"].tolist() == ["falls short"]
    shown = retrofit_text(results)
    assert "fell short, with these factors on their ties:\n" in shown
    assert f"{failed.proof.reached.value:.4g}" in shown
    assess.write_retrofit(found, tmp_path / "out", jobs=1)
    (row,) = csv.DictReader((tmp_path / "out/tables/proof.csv").read_text(encoding="utf-8-sig").splitlines())
    assert row["ties.area [mm^2]"] == "100.0"
    assert row["Outcome"] == "falls short"


def test_least_cost_may_be_other_works_than_least_steel(tmp_path: Path) -> None:
    """Where a tie with its plates costs more than its bar, fewer and thicker ones are cheaper."""
    path = facade(tmp_path)
    asked: dict[str, Any] = {"target": "index", "reach": 1.0, "vary": {AREA: "100, 140, 190 mm^2", COUNT: "3..6"}}
    steel, cost = (assess.retrofit(path, **asked, price=price).results for price in ({}, {"steel": 4.0, "tie": 300.0}))
    assert steel.best is not None
    assert cost.best is not None
    assert cost.best.objective == pytest.approx(4.0 * cost.best.steel + 300.0 * cost.best.values[1])
    assert cost.best.objective <= 4.0 * steel.best.steel + 300.0 * steel.best.values[1]
    reached = [each for each in cost.layouts if each.reached and cost.target.holds(each.reached)]
    assert cost.best.objective == min(each.objective for each in reached)


def test_a_tolerance_with_which_a_layout_cannot_be_built_is_named_with_the_reason(tmp_path: Path) -> None:
    """No bar yields at a tenth more than 1400 MPa."""
    path = facade(tmp_path, ('yield_stress = "235 MPa"', 'yield_stress = "1400 MPa"'))
    found = assess.retrofit(path, target="index", reach=0.2, vary={AREA: "100 mm^2", COUNT: "3"})
    assert found.results.best is None
    (failed,) = found.results.trials
    assert failed.proof.tolerance.yield_stress == 1.1
    assert failed.proof.refused is not None
    assert "not 50 to 1500 MPa" in failed.proof.refused.text
    shown = retrofit_text(found.results)
    assert "cannot be built: mechanisms.facade.loads[1].yield_stress" in shown
    assess.write_retrofit(found, tmp_path / "out", jobs=1)
    (row,) = csv.DictReader((tmp_path / "out/tables/proof.csv").read_text(encoding="utf-8-sig").splitlines())
    assert "not 50 to 1500 MPa" in row["Refused"]


def test_prices_of_the_file_stand_behind_those_of_the_command(tmp_path: Path) -> None:
    """4 EUR/kg of steel and 300 EUR a tie by hand; a tonne costs a thousand times a kilogram."""
    prices = 'steel = "4000 EUR/t", tie = "300 EUR/tie", "mechanisms.facade.base.width" = 9'
    path = facade(tmp_path, ("[records]", f"[analysis.retrofit]\nprices = {{ {prices} }}\n[records]"))
    asked: dict[str, Any] = {"target": "index", "reach": 0.3, "vary": {AREA: "200 mm^2", COUNT: "3"}}
    steel = 7850.0 * 200e-6 * 10.0 * 3.0
    by_file = assess.retrofit(path, **asked).results
    assert by_file.layouts[0].objective == pytest.approx(4.0 * steel + 900.0)
    assert by_file.currency == "EUR"
    assert f"cost {4.0 * steel + 900.0:.6g} EUR, " in retrofit_text(by_file)
    cheaper = assess.retrofit(path, **asked, price={"tie": 100, AREA: "2 EUR/cm^2"}).results
    assert cheaper.layouts[0].objective == pytest.approx(4.0 * steel + 300.0 + 2.0 * 2.0)
    for price, said in (
        ({"steel": "4 EUR/m"}, '"m" does not measure that; write the price for each kg'),
        ({"steel": "4 USD/kg"}, "where others are in"),
        ({"steel": -1.0}, "write a price from 0"),
        ({"steel": "four"}, "write a price from 0"),
        ({"mechanisms.facade.base.width": 3.0}, "write a price of one of steel, tie, "),
    ):
        with pytest.raises(AssessError, match=re.escape(said)):
            assess.retrofit(path, **asked, price=price)
    wrong = facade(tmp_path / "wrong", ("[records]", "[analysis.retrofit]\nprices = { stone = 4 }\n[records]"))
    with pytest.raises(AssessError, match=r"analysis\.retrofit\.prices\.stone = 4: write a price of one of"):
        assess.retrofit(wrong, **asked)


def test_a_tie_without_a_source_is_named(tmp_path: Path) -> None:
    path = facade(tmp_path, ('"mechanisms.facade.loads[1]" = "measured: design of the ties"\n', ""))
    found = assess.retrofit(path, target="index", reach=1.0, vary={AREA: "100..200 mm^2", COUNT: "3..4"}).results
    assert found.best is None
    assert [each.where for each in found.warnings if each.key == "retrofit-tie-lacks"] == ["mechanisms.facade.loads[1]"]


@pytest.mark.parametrize(
    ("key", "values"),
    [
        ("base.width", "0.2, 0.4 m"),
        ("ring_beam.mass", "1000, 3000 kg"),
        ("ring_beam.area", "100, 300 mm^2"),
        ("ties.height", "4, 5.5 m"),
    ],
)
def test_declared_works_change_the_study(tmp_path: Path, key: str, values: str) -> None:
    name = f"mechanisms.facade.{key}"
    path = facade(tmp_path)
    price = {name: 1.0} if key in ("base.width", "ring_beam.mass") else {}
    found = assess.retrofit(
        path, target="index", reach=0.1, vary={name: values, AREA: "314 mm^2"}, price=price, spacing=9.0
    )
    reached = [each.reached.value for each in found.results.layouts if each.reached]
    assert len(reached) == 2
    assert reached[0] != reached[1]


def test_pretension_moves_no_capacity_where_the_bar_yields(tmp_path: Path) -> None:
    found = assess.retrofit(
        facade(tmp_path),
        target="index",
        reach=0.1,
        vary={"mechanisms.facade.ties.force": "5, 8 kN", AREA: "314 mm^2"},
        spacing=9.0,
    )
    first, second = (each.reached.value for each in found.results.layouts if each.reached)
    assert first == pytest.approx(second, rel=1e-9)


def test_a_wider_base_moves_the_hinge(tmp_path: Path) -> None:
    """A toe of width b and height 2 b before a wall of t x h: the hinge is b farther out, alpha_0 by hand."""
    path = facade(
        tmp_path, (f'  {{ kind = "tie", force = "8 kN", at = [-0.3, 0, 5.5], anchor = [-10.3, 0, 5.5], {BAR} }},\n', "")
    )
    text = path.read_text(encoding="utf-8").replace(
        '"mechanisms.facade.loads[1]" = "measured: design of the ties"\n', ""
    )
    path.write_text(text, encoding="utf-8")
    found = assess.retrofit(path, target="index", reach=0.01, vary={BASE: "0.5 m"}, price={BASE: 1.0})
    assert found.tables is not None
    out = assess.write_retrofit(found, tmp_path / "out", jobs=1)
    branch = build(load(out)).mechanisms[0].variants.starting.positive
    b, t, h = 0.5, 0.6, 6.0
    lever, height = t * h * (b + t / 2) + 2 * b * b * b / 2, t * h * h / 2 + 2 * b * b * b
    assert branch.restoring[0] / branch.excitation[0] / 9.80665 == pytest.approx(lever / height, rel=1e-6)


def test_a_lighter_roof_is_a_share_of_its_mass(tmp_path: Path) -> None:
    roof = '  { kind = "mass", mass = "4 t", at = [0.1, 0, 6] },\n  # d20'
    path = facade(tmp_path, ("  # d20", roof), ("loads[1]", "loads[2]"))
    key = "mechanisms.facade.roof.factor"
    found = assess.retrofit(path, target="index", reach=0.01, vary={key: "0.5"}, price={key: 1.0})
    assert found.tables is not None
    assert found.tables["mechanisms"]["facade"]["loads"][0]["mass"] == "2000 kg"
    assert found.results.best is not None
    assert found.results.best.objective == 0.5


def test_no_tie_is_raised_above_the_wall(tmp_path: Path) -> None:
    project = load(facade(tmp_path))
    built = build_with_cases(project)
    subject = subject_of("facade", project.content, built.solids)
    assert subject is not None
    for factor, height in ((0.9, 4.95), (1.1, 6.0)):
        tables = with_tolerance(
            project.raw, project.content, {"facade": subject}, ("facade",), Tolerance(height=factor)
        )
        assert tables["mechanisms"]["facade"]["loads"][0]["at"][2] == pytest.approx(height)


@pytest.mark.parametrize(
    ("elevation", "highest"),
    [(4.0, 4.4), (4.8, 6.0 - 0.15 - 0.6), (5.5, 5.5)],  # t = 0.6 m, plate 0.3 m high
)
def test_no_plate_is_raised_until_its_cone_meets_the_top(tmp_path: Path, elevation: float, highest: float) -> None:
    path = facade(
        tmp_path, ('strength = "200 kN"', PLATE), OUTSIDE, ("at = [0.3, 0, 5.5]", f"at = [0.3, 0, {elevation}]")
    )
    project = load(path)
    subject = subject_of("facade", project.content, build_with_cases(project).solids)
    assert subject is not None
    for factor, height in ((0.9, 0.9 * elevation), (1.1, highest)):
        tables = with_tolerance(
            project.raw, project.content, {"facade": subject}, ("facade",), Tolerance(height=factor)
        )
        assert tables["mechanisms"]["facade"]["loads"][0]["at"][2] == pytest.approx(height)


def test_a_tie_in_a_gable_stays_below_its_slope(tmp_path: Path) -> None:
    """The slope of a gable 8 m wide and 4 to 6 m high is at 5 m over a point 2 m from its middle."""
    gable = "profile = [[-4, 0], [4, 0], [4, 4], [0, 6], [-4, 4]]\nlength = 0.6"
    path = facade(
        tmp_path,
        ("box = { thickness = 0.6, length = 8.0, height = 6.0 }", gable),
        ("direction = [1, 0, 0]", "direction = [0, 1, 0]"),
        ("at = [-0.3, 0, 5.5], anchor = [-10.3, 0, 5.5]", "at = [2, 0.3, 4.8], anchor = [2, -9.7, 4.8]"),
    )
    project = load(path)
    subject = subject_of("facade", project.content, build_with_cases(project).solids)
    assert subject is not None
    tables = with_tolerance(project.raw, project.content, {"facade": subject}, ("facade",), Tolerance(height=1.1))
    assert tables["mechanisms"]["facade"]["loads"][0]["at"][2] == pytest.approx(5.0)


def test_one_bar_of_two_mechanisms_is_paid_once(tmp_path: Path) -> None:
    """7850 kg/m3 x 314 mm2 x 10 m, however many mechanisms it holds; two bars where they are at two places."""
    path = facade(tmp_path)
    content = load(path).content
    first = content.mechanisms["facade"]
    (tie,) = first.loads  # type: ignore[union-attr]
    other = first.model_copy(update={"loads": (tie.model_copy(update={"area": 400e-6}),)})
    apart = first.model_copy(update={"loads": (tie.model_copy(update={"at": (-0.3, 1.0, 5.5)}),)})
    for second, areas in ((other, [400e-6]), (apart, [314e-6, 314e-6])):
        both = content.model_copy(update={"mechanisms": {"facade": first, "other": second}})
        assert [max(tie.load.area for tie in bar) for bar in bars_of(both, ("facade", "other"))] == pytest.approx(areas)


def test_the_index_of_the_building_is_that_of_its_worst_mechanism(tmp_path: Path) -> None:
    """Works on the whole wall leave its upper half, without a tie, where it was."""
    upper = UPPER.replace(UPPER[UPPER.index("loads = [") : UPPER.index("]\n\n") + 1], "")
    path = facade(tmp_path, ("[records]", f"{upper}[records]"))
    vary = {AREA: "200 mm^2", COUNT: "3..4"}
    results = assess.retrofit(path, target="index", reach=1.0, vary=vary).results
    run = assess.run(path, jobs=1)
    assert run.verdict is not None
    indices = {each.mechanism: each.answers[0].index for each in run.verdict.mechanisms}
    assert results.mechanisms == ("facade",)
    assert indices["upper"] is not None
    assert results.best is not None
    assert results.best.reached is not None
    reached = results.best.reached.value or 0.0
    assert results.building_index == pytest.approx(min(indices["upper"].value, reached))


def test_a_range_of_one_value_is_that_value(tmp_path: Path) -> None:
    found = assess.retrofit(facade(tmp_path), target="index", reach=0.1, vary={AREA: "314..314 mm^2", COUNT: "4..4"})
    assert [each.values for each in found.results.layouts] == [(314.0, 4.0)]


def test_the_stiffness_of_a_restraint_without_a_bar_is_tolerated_as_an_area_is(tmp_path: Path) -> None:
    project = load(facade(tmp_path, (BAR, 'stiffness = "2 MN/m", strength = "200 kN"')))
    tables = with_tolerance(project.raw, project.content, {}, ("facade",), Tolerance(area=0.9))
    (tie,) = read_content(tables, project.folder).mechanisms["facade"].loads
    assert tie.stiffness == pytest.approx(1.8e6)


def test_the_thread_of_a_bar_is_tolerated_as_its_area_is(tmp_path: Path) -> None:
    """A thread of twice the bar is the widest that may be drawn, and stays so with a bar of a tenth less."""
    path = facade(
        tmp_path, ('strength = "200 kN"', PLATE.replace("400 mm^2", "628 mm^2")), OUTSIDE, ('"8 kN"', '"3 kN"')
    )
    project = load(path)
    for factor in (0.9, 1.1):
        tables = with_tolerance(project.raw, project.content, {}, ("facade",), Tolerance(area=factor))
        (tie,) = read_content(tables, project.folder).mechanisms["facade"].loads
        assert tie.plate.thread_area == pytest.approx(factor * 628e-6)
        assert tie.area == pytest.approx(factor * 314e-6)
    vary = {AREA: "314 mm^2", COUNT: "2"}
    found = assess.retrofit(path, target="index", reach=0.05, vary=vary, spacing=9.0).results
    assert found.best is not None
    assert not any(proof.refused for proof in found.proofs)


@pytest.mark.parametrize(
    ("given", "error"),
    [
        ({"vary": {}}, "vary: nothing"),
        ({"vary": {"mechanisms.facade.tie.area": "1..2"}}, 'unknown key; did you mean "mechanisms.facade.ties.area"'),
        ({"vary": {"mechanisms.facad.ties.count": "1..2"}}, 'did you mean "mechanisms.facade.ties.count"'),
        ({"vary": {AREA: "100..200"}}, r"ties.area\": 100: not 1 to 20,000 mm\^2"),
        ({"vary": {"mechanisms.facade.loads.tie.area": "100, 200"}}, r"area\": 100: not 1 to 20,000 mm\^2"),
        ({"vary": {"mechanisms.facade.ties.colour": "1..2"}}, "known are ties.area"),
        ({"vary": {AREA: "800..100 mm^2"}}, "lesser end first"),
        ({"vary": {AREA: "100..800 kN"}}, "area"),
        ({"vary": {AREA: "9**9**9"}}, "is not a unit"),
        ({"vary": {AREA: "0..1e9 mm^2 by 1"}}, "200 at most"),
        ({"vary": {COUNT: "1.5, 2"}}, "whole numbers"),
        ({"vary": {"site.spectrum.f_0": "2..3"}}, "no works change it"),
        ({"vary": {"materials.stone.density": "500, 2000 kg/m^3"}}, "no works change it"),
        ({"vary": {"bodies.wall.box.height": "3, 6 m"}}, "no works change it"),
        ({"vary": {"mechanisms.facade.restitution": "0.5, 0.9"}}, "no works change it"),
        *(
            ({"vary": {f"mechanisms.facade.loads.tie.{key}": "0.1, 0.2"}}, "no works change it")
            for key in ("strength", "fracture_strain", "young_modulus", "length", "stiffness")
        ),
        ({"vary": {"mechanisms.facade.loads[1].yield_stress": "235, 900 MPa"}}, "shows in no steel"),
        ({"vary": {"bodies.wall.box.thickness": "0.6, 0.9 m"}}, "shows in no steel"),
        ({"vary": {BASE: "0.1..0.5 m"}}, "shows in no steel"),
        ({"target": "luck"}, "choose one of index"),
        ({"reach": float("nan")}, "write a number above 0"),
        ({"reach": 1e9}, "above 0 and up to 1e6"),
        ({"target": "probability", "reach": 1.0}, "below 1"),
        ({"price": {"gold": 1.0}}, "write a price"),
        ({"spacing": "3 kg"}, "spacing"),
        ({"limit_state": "XXX"}, "limit_state"),
        ({"target": "ratio", "limit_state": "SLC"}, "site.limit_state: .*SLC"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, given: dict[str, Any], error: str) -> None:
    path = facade(tmp_path)
    asked: dict[str, Any] = {"target": "index", "reach": 1.0, "vary": {AREA: "100..200 mm^2"}} | given
    with pytest.raises(AssessError, match=error):
        assess.retrofit(path, **asked)
