"""From a project file to its study and results: spectra, scaling, notices, scans."""

from __future__ import annotations

import dataclasses
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.amplification import BaseMotion
from assess.errors import AssessError, GeometryError, MechanismError, ProjectError
from assess.project.build import build
from assess.project.project_file import load
from assess.study.histories import scan_levels
from assess.study.level_peaks import RockingCase
from assess.study.mechanism_results import parameters
from assess.study.run import run_study
from assess.study.study import Study
from assess.study.suites import motions_of
from records.response import response_spectrum
from tests.support import projects
from tests.support.answered import step_values
from tests.support.motions import write_noise
from tests.support.projects import block, lines, project_toml, wall

ASCE = 'code = "asce7-16"\ns_ds = "0.5 g"\ns_d1 = "0.2 g"\nt_l = 6'
QUIET = 'files = ["a.csv", "b.csv"]'
SOFT = 'interface = { model = "flexible", '


def as_they_are(motions):
    """The ground's motions at the base of a mechanism that is not amplified."""
    return tuple(BaseMotion(motion.record, 1.0) for motion in motions)


def study_of(folder: Path, *, spectrum=ASCE, mechanism="", records=QUIET, analysis="", amplitude=1.0, tail="") -> Study:
    for seed, name in enumerate(("a.csv", "b.csv")):
        write_noise(folder / name, seed=seed, amplitude=amplitude)
    text = project_toml(
        site={"spectrum": spectrum},
        materials={"m": {"density": 2000}},
        bodies={"w": wall(0.6, 4.0, 4.5, material="m")},
        mechanisms={"m": lines(block("w", direction=[1, 0, 0]), mechanism)},
        records=records,
        analysis=analysis,
    )
    if any(line.startswith("direction") for line in mechanism.splitlines()):  # in place of the project's own
        text = text.replace("direction = [1, 0, 0]\n", "", 1)
    return projects.study_of(folder, text, tail)


def test_levels_rise_and_default_to_the_sites_own_pga(tmp_path):
    assert study_of(tmp_path).levels == pytest.approx((0.2 * g,))
    asked = study_of(tmp_path, analysis='levels = ["0.3 g", "0.1 g"]').levels
    assert asked == pytest.approx((0.1 * g, 0.2 * g, 0.3 * g))  # the site's own among them


def test_site_pga_scales_ordinates_and_keeps_corners(tmp_path):
    plain = study_of(tmp_path).spectrum
    scaled = study_of(tmp_path, spectrum=ASCE.replace("code", "damping = 0.05\ncode"), tail="").spectrum
    assert plain is not None
    assert scaled is not None
    text = (tmp_path / "project.toml").read_text().replace("[site.spectrum]", '[site]\npga = "0.3 g"\n[site.spectrum]')
    (tmp_path / "project.toml").write_text(text)
    raised = build(load(tmp_path)).spectrum
    period = np.array([0.0, 0.05, 0.3, 1.0, 8.0])
    np.testing.assert_allclose(raised.acceleration(period), 1.5 * plain.acceleration(period), rtol=1e-12)


@pytest.mark.parametrize("scale_to", ["spectrum", "pga", "none"])
def test_records_are_scaled_as_asked_and_levels_multiply(tmp_path, scale_to):
    study = study_of(tmp_path, records=f'{QUIET}\nscale_to = "{scale_to}"', analysis='levels = ["0.1 g", "0.4 g"]')
    results = run_study(study)
    for used, raw in zip(results.records, study.records, strict=True):
        assert used.pga_g * g == pytest.approx(used.scale_factor * raw.pga, rel=1e-12)
        if scale_to == "pga":
            assert used.pga_g == pytest.approx(0.2, rel=1e-12)
        if scale_to == "none":
            assert used.scale_factor == 1.0
    histories = results.mechanisms[0].histories
    assert [h.scale_factor / r.scale_factor for h, r in zip(histories, [*results.records] * 3, strict=True)] == (
        pytest.approx([0.5, 0.5, 1.0, 1.0, 2.0, 2.0], rel=1e-12)
    )


def test_scaling_to_a_table_that_ends_early_uses_the_periods_it_has(tmp_path):
    (tmp_path / "s.csv").write_text("period [s],acceleration [g]\n0,0.2\n0.1,0.5\n0.4,0.5\n1.0,0.2\n")
    study = study_of(tmp_path, spectrum='code = "table"\nfile = "s.csv"')
    (motion, _) = motions_of(study, study.spectrum)
    period = np.geomspace(0.1, 2.0, 41)
    period = period[period <= 1.0]
    own = response_spectrum(motion.record, period)
    expected = np.exp(np.mean(np.log(study.spectrum.acceleration(period) / own)))
    assert motion.scaling.factor == pytest.approx(expected, rel=1e-12)
    assert run_study(study).mechanisms[0].checks  # nothing fails for the periods the table lacks


def test_the_scan_begins_below_uplift_whatever_the_records_scale(tmp_path):
    study = study_of(tmp_path, records=f'{QUIET}\nscale_to = "none"', amplitude=5.0)
    motions = motions_of(study, study.spectrum)
    shaken = RockingCase("m", study.mechanisms[0].oscillator, "exact", as_they_are(motions))
    scan = scan_levels(shaken, motions, site_pga=study.spectrum.pga, threads=1)
    assert scan[0].mean == 0.0
    assert scan[-1].overturned
    assert [suite.pga for suite in scan] == sorted(suite.pga for suite in scan)


def test_the_scan_of_a_mechanism_on_joints_rises_too(tmp_path):
    """It has no uplift at rest to begin from."""
    joint = 'interface = { model = "flexible", stiffness = "1 GPa/m", strength = "1 MPa" }'
    study = study_of(tmp_path, records=QUIET, mechanism=joint)
    motions = motions_of(study, study.spectrum)

    shaken = RockingCase("m", study.mechanisms[0].oscillator, "exact", as_they_are(motions))
    scan = scan_levels(shaken, motions, site_pga=study.spectrum.pga, threads=1)
    assert 0.0 < scan[0].pga < scan[1].pga
    assert scan[-1].overturned


def test_results_do_not_depend_on_how_the_path_was_typed(tmp_path, monkeypatch):
    study_of(tmp_path)
    monkeypatch.chdir(tmp_path)
    typed = [run_study(build(load(path))) for path in (".", str(tmp_path), tmp_path / "project.toml")]
    assert typed[0] == typed[1] == typed[2]
    assert typed[0].records[0].path == "a.csv"


def test_two_records_of_one_name_are_told_apart(tmp_path):
    (tmp_path / "sub").mkdir()
    study_of(tmp_path)
    write_noise(tmp_path / "sub" / "a.csv", seed=5)
    study = study_of(tmp_path, records='files = ["a.csv", "sub/a.csv"]')
    assert [one.id for one in study.records] == ["a", "a (2)"]


def test_one_history_of_each_mechanism_carries_its_trace(tmp_path):
    results = run_study(study_of(tmp_path, analysis='levels = ["0.2 g", "0.4 g"]'))
    traced = [h for h in results.mechanisms[0].histories if h.trace is not None]
    (worst,) = traced
    assert worst.level_pga_g == pytest.approx(0.4)
    largest = max(abs(phi) for phi in worst.trace.rotation_rad)
    if worst.max_rotation_rad is not None:
        assert largest <= abs(worst.max_rotation_rad) * (1 + 1e-9)
        assert largest == pytest.approx(abs(worst.max_rotation_rad), rel=1e-2)  # sampled beside exact


def test_one_sided_histories_never_turn_the_other_way(tmp_path):
    results = run_study(study_of(tmp_path, mechanism='sides = "one"', analysis='levels = ["0.5 g"]'))
    (mechanism,) = results.mechanisms
    assert mechanism.oscillator_negative is None
    assert mechanism.curve.negative is None
    (trace,) = [h.trace for h in mechanism.histories if h.trace is not None]
    assert min(trace.rotation_rad) >= 0.0
    assert {check.branch for check in mechanism.checks} == {"positive"}


@pytest.mark.parametrize(
    ("mechanism", "words"),
    [
        ("hinges = { A = [0.3, 2] }", "not on the base"),
        ("direction = [1, 0.05, 0]", "at a point, not along an edge"),
    ],
)
def test_doubtful_hinges_are_pointed_out(tmp_path, mechanism, words):
    notices = study_of(tmp_path, mechanism=f"{mechanism}\nrestitution = 0.9").messages
    assert any(words in notice.text and notice.where == "mechanisms.m" for notice in notices)


def test_plain_walls_raise_no_doubt_about_their_hinges(tmp_path):
    for direction in ("[1, 0, 0]", "[0, -1, 0]"):
        notices = study_of(tmp_path, mechanism=f"direction = {direction}").messages
        assert not [notice for notice in notices if notice.key == "mechanism"]


def test_hinge_of_a_direction_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(MechanismError, match="hinges_negative"):
        study_of(tmp_path, mechanism='sides = "one"\nhinges_negative = { A = [-0.3, 0] }')


CRUSHING = 'interface = { strength = "1 MPa" }'
TWIN = '[mechanisms.n]\nkind = "single-block"\nblocks = ["w"]'
LC2 = '[procedures.dmi2008]\nknowledge_level = "LC2"'


@pytest.mark.parametrize(
    ("mechanism", "tail", "words"),
    [
        ("", "", None),
        ("", LC2, "is not modelled in m:"),
        (CRUSHING, f"{LC2}\n{TWIN}", "is not modelled in n:"),
        (CRUSHING, LC2, None),
        ('interface = { strength = "inf" }', LC2, "is not modelled in m:"),
        ("", "[procedures.dmi2008]\nconfidence_factor = 1.2", "is not modelled in m:"),
        ("", "[procedures.dmi2008]\nconfidence_factor = 1.4", None),
        ("", '[procedures.dmi2008]\nknowledge_levels = { m = "LC3" }', "is not modelled in m:"),
    ],
)
def test_levels_and_factors_that_do_not_decide_without_crushing_are_told(tmp_path, mechanism, tail, words):
    study = study_of(tmp_path, mechanism=mechanism, tail=tail)
    texts = [notice.text for notice in study.messages if notice.key == "confidence-factor"]
    assert len(texts) == (words is not None)
    assert all(words in text and "1.35" in text for text in texts)


def test_the_scan_on_flexible_joints_rises_from_a_level_that_moves_little(tmp_path):
    joint = 'interface = { model = "flexible", stiffness = "0.1 GPa/m", strength = "1 MPa" }'
    study = study_of(tmp_path, mechanism=joint)
    motions = motions_of(study, study.spectrum)
    scan = scan_levels(
        RockingCase("m", study.mechanisms[0].oscillator, "exact", as_they_are(motions)),
        motions,
        site_pga=study.spectrum.pga,
        threads=1,
    )
    assert 0.0 < scan[0].mean < 0.2
    assert scan[-1].overturned
    np.testing.assert_allclose(np.diff(np.log([suite.pga for suite in scan])), np.log(1.05), rtol=1e-9)


def test_parameters_need_no_site_and_agree_with_the_run(tmp_path):
    study = study_of(tmp_path)
    alone = parameters(dataclasses.replace(study, spectrum=None))
    full = run_study(study).mechanisms
    assert [m.oscillator for m in alone] == [m.oscillator for m in full]
    assert full[0].interfaces[0]["normal_force_n"] == pytest.approx(0.6 * 4 * 4.5 * 2000 * g, rel=1e-12)


def test_a_level_that_fails_bounds_the_pga_at_capacity(tmp_path):
    study = study_of(tmp_path, analysis='levels = ["0.2 g", "0.6 g", "1.2 g"]')
    five = dataclasses.replace(study, records=study.records * 3)
    checks = [c for c in run_study(five).mechanisms[0].checks if c.procedure == "asce43-05-history"]
    failing = [c.level_pga_g for c in checks if c.ratio is None or c.ratio > 1.0]  # two tones: not answered
    assert failing
    assert checks[0].capacity_pga_g < min(failing)


LOADED = """loads = [
  { kind = "mass", mass = "1200 kg", at = [0.1, 0, 4.0] },
  { kind = "mass", mass = "500 kg", at = [0.0, 4.2], bearing = false },
  { kind = "force", force = "2 kN", direction = [1, 0, 0], at = [-0.3, 3.5] },
  { kind = "force", force = ["0.5 kN", "-1 kN"], at = [0, 3.0] },
  { kind = "tie", force = "5 kN", at = [0.3, 0, 4.3], anchor = [-5, 0, 4.3] },
]"""


def test_loads_of_the_project_file_reach_the_oscillator_and_the_drawing(tmp_path):
    study = study_of(tmp_path, mechanism=LOADED)
    (mechanism,) = parameters(study)
    wall = 0.6 * 4 * 4.5 * 2000
    resisting = wall * g * 0.3 + 1200 * g * 0.2 - 2000 * 3.5 - 500 * 3.0 + 1000 * 0.3 + 5000 * 4.3
    driving = g * (wall * 2.25 + 1200 * 4.0 + 500 * 4.2)
    assert mechanism.oscillator.uplift_multiplier == pytest.approx(resisting / driving, rel=1e-12)
    assert mechanism.oscillator.mass_kg == pytest.approx(wall + 1700, rel=1e-12)
    assert [load.name for load in mechanism.drawing.loads] == ["mass 1", "mass 2", "force 3", "force 4", "tie 5"]
    assert mechanism.interfaces[0]["normal_force_n"] == pytest.approx((wall + 1200) * g + 1000, rel=1e-12)
    assert len(run_study(study).mechanisms[0].checks) > 3


def test_direction_of_a_force_is_seen_in_the_plane_of_motion(tmp_path):
    load = 'loads = [{ kind = "force", force = "1 kN", direction = [3, 4, 0], at = [0, 0, 3] }]\ndirection = [0, 1, 0]'
    (mechanism,) = study_of(tmp_path, mechanism=load).mechanisms
    assert mechanism.positive.loads[0].force == pytest.approx((800.0, 0.0))


@pytest.mark.parametrize(
    ("load", "words"),
    [
        ('{ kind = "mas", mass = 1, at = [0, 1] }', "not a supported load"),
        ('{ kind = "mass", mass = "1200 N", at = [0, 1] }', "not a unit of mass"),
        ('{ kind = "force", force = "2 kN", at = [0, 1] }', "needs one"),
        ('{ kind = "force", force = [1, 2, 3], at = [0, 1] }', "not a force"),
        ('{ kind = "force", force = [1, 2], direction = [1, 0], at = [0, 1] }', "remove one"),
        ('{ kind = "tie", force = "5 kN", at = [0, 1] }', "either anchor or direction"),
        ('{ kind = "tie", force = "5 kN", at = [0, 1], direction = [0, 0, 0] }', "no direction"),
        ('{ kind = "mass", mass = 1, at = [0, 1], block = 1 }', "must be 0 or less"),
        ('{ kind = "body", body = "floor" }', "no such body"),
    ],
)
def test_wrong_loads_are_refused_in_one_line(tmp_path, load, words):
    with pytest.raises(ProjectError, match=words) as refused:
        study_of(tmp_path, mechanism=f"loads = [{load}]")
    assert "mechanisms.m.loads[1]" in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_level_cut_is_the_mechanism_of_what_lies_above(tmp_path):
    (whole,) = study_of(tmp_path).mechanisms
    study = study_of(tmp_path, mechanism='cut = "1.5 m"')
    (mechanism,) = study.mechanisms
    assert (mechanism.elevation, whole.elevation) == (1.5, 0.0)
    (block,) = mechanism.positive.blocks
    assert block.mass == pytest.approx(2000 * 0.6 * 4 * 3, rel=1e-12)
    assert block.inertia == pytest.approx(block.mass * (0.6**2 + 3**2) / 12, rel=1e-12)
    np.testing.assert_allclose(block.centroid, (0.0, 3.0), atol=1e-12)
    np.testing.assert_allclose(mechanism.positive.hinges[0], (0.3, 1.5), atol=1e-12)
    assert min(z for _, z in mechanism.outlines[0][0]) == 1.5
    assert "not-amplified" in {notice.key for notice in study.messages}
    (at_base,) = study_of(tmp_path, mechanism="cut = 0").mechanisms
    for field in fields(whole):
        assert getattr(at_base, field.name) == getattr(whole, field.name), field.name


def test_an_inclined_cut_has_each_hinge_at_its_own_elevation(tmp_path):
    study = study_of(tmp_path, mechanism="cut = { point = [0, 0, 1.5], normal = [-0.5, 0, 1] }")
    (mechanism,) = study.mechanisms
    np.testing.assert_allclose(mechanism.positive.hinges[0], (0.3, 1.65), atol=1e-12)
    np.testing.assert_allclose(mechanism.negative.hinges[0], (0.3, 1.35), atol=1e-12)  # mirrored
    assert mechanism.elevation == pytest.approx(1.65, rel=1e-12)
    assert all("restitution" in notice.text for notice in study.messages if notice.key == "mechanism")
    (shown,) = run_study(study).mechanisms
    np.testing.assert_allclose([h.at for h in shown.drawing.hinges], [(0.3, 1.65), (-0.3, 1.35)], atol=1e-12)
    assert shown.oscillator.mass_kg == pytest.approx(2000 * 0.6 * 4 * 3, rel=1e-12)
    onto_low, onto_high = mechanism.restitution  # onto the hinge nearer to the centroid it turns faster
    assert onto_high > 1.0 > onto_low
    inertia, other = shown.oscillator.inertia_kg_m2, shown.oscillator_negative.inertia_kg_m2
    assert onto_high**2 * inertia < other  # yet no energy is added
    assert onto_low * other == pytest.approx(onto_high * inertia, rel=1e-12)
    assert shown.checks
    assert shown.histories


def test_clauses_above_ground_apply_to_a_cut_wall(tmp_path):
    building = '\n[building]\nheight = "9 m"\nstoreys = 2\n'
    asked = 'procedures = ["dmi2008-linear"]'
    for cut, at_floor in (("", 0), ("cut = 1.5", 1)):
        study = study_of(tmp_path, mechanism=cut, analysis=asked, tail=building)
        steps = run_study(study).mechanisms[0].checks[0].steps
        found = [step.inputs for step in steps if step.description.startswith("demand of the floor")]
        assert len(found) == at_floor
        assert all({each.symbol: each.value for each in inputs}["ψ"] == pytest.approx(1.5 / 9) for inputs in found)


def test_a_cut_that_slopes_across_the_motion_is_pointed_out(tmp_path):
    notices = study_of(tmp_path, mechanism="cut = { point = [0, 0, 1.5], normal = [0, 0.1, 1] }").messages
    (text,) = [notice.text for notice in notices if notice.key == "cut-slopes"]
    assert "slopes across the direction of motion and its extreme line rises by 0.4 m" in text


@pytest.mark.parametrize(
    ("mechanism", "words"),
    [
        (
            'cut = "9 m"',
            r"project\.toml: mechanisms\.m\.cut: the cut at z = 9 m misses the body, .* z = 4\.5 m",
        ),
        ("cut = { point = [0, 0, 1], normal = [1, 0, 0] }", r"mechanisms\.m\.cut: .* give one that points up"),
        ('sides = "one"\nhinges_negative = { A = [0, 0] }', r"mechanisms\.m\.hinges_negative: given with sides"),
        ('restitution = "sorrentino"', r'mechanisms\.m\.restitution = "sorrentino": not for a single-block'),
        ("hinges = { A = [0.2, 4.0] }", r"mechanisms\.m: the centroid lies .* check hinges and cut"),
        (f"{SOFT}stiffness = 1e5 }}", r"mechanisms\.m: it falls by itself: its joints are too soft"),
        (f'{SOFT}course_thickness = "10 cm" }}', r"mechanisms\.m: interface A: course_thickness needs young_modulus"),
    ],
)
def test_what_the_model_refuses_is_told_at_its_key(tmp_path, mechanism, words):
    with pytest.raises(AssessError, match=words):
        study_of(tmp_path, mechanism=mechanism)


def test_a_block_of_several_bodies_is_cut_and_one_without_geometry_is_not(tmp_path):
    study_of(tmp_path, mechanism="cut = 1.5")
    text = (tmp_path / "project.toml").read_text().replace('blocks = ["w"]', 'blocks = [["w", "v"]]')
    second = '[bodies.v]\nmaterial = "m"\nbox = { thickness = 1, length = 4, height = 1, base = [0, 0, 4.5] }\n'
    direct = "[bodies.v]\nmass = 100\ncentroid = [0, 5]\ninertia = 10\n"
    (tmp_path / "project.toml").write_text(text.replace("[mechanisms.m]", second + "[mechanisms.m]"))
    (mechanism,) = build(load(tmp_path)).mechanisms
    assert mechanism.positive.blocks[0].mass == pytest.approx(2000 * (0.6 * 4 * 3 + 4), rel=1e-12)
    assert len(mechanism.outlines[0]) == 2
    (tmp_path / "project.toml").write_text(text.replace("[mechanisms.m]", direct + "[mechanisms.m]"))
    with pytest.raises(GeometryError, match=r'mechanisms\.m\.cut: body "v" has no geometry to cut'):
        build(load(tmp_path))


SOFT = 'interface = { model = "flexible", stiffness = "1 GPa/m", strength = "1 MPa" }'
SUITE = 'synthetic = { count = 5, duration = "10 s" }'


def test_joints_that_answer_at_once_have_no_pga_at_uplift_by_any_procedure(tmp_path):
    """It is null, not zero; the rigid one lifts off at its multiplier, 0.6 / 4.5."""
    soft = run_study(study_of(tmp_path, records=SUITE, mechanism=SOFT)).mechanisms[0]
    rigid = run_study(study_of(tmp_path, records=SUITE)).mechanisms[0]
    assert soft.oscillator.uplift_multiplier is None
    assert {check.procedure: check.uplift_pga_g for check in soft.checks} == dict.fromkeys(
        check.procedure for check in rigid.checks
    )
    assert len(soft.checks) >= 6
    own = [check.uplift_pga_g * step_values(check).get("FC", 1.0) for check in rigid.checks]
    assert own == pytest.approx([0.6 / 4.5] * len(rigid.checks), rel=1e-9)
    for check in soft.checks:
        assert "lift" not in check.reason.text


def test_one_sided_joints_that_lean_on_their_support_keep_their_small_threshold(tmp_path):
    force = '{ kind = "force", force = ["-2 kN", "0 N"], at = [0, 4.5], until = "collapse" }'
    leaning = f'sides = "one"\nloads = [{force}]\n{SOFT}'
    shown = '\n[report.sources]\n"mechanisms.m.loads[1]" = "measured: it stays"\n'
    found = run_study(study_of(tmp_path, records=SUITE, mechanism=leaning, tail=shown)).mechanisms[0]
    at_rest = found.oscillator.uplift_multiplier
    assert 0.0 < at_rest < 0.6 / 4.5
    own = [check.uplift_pga_g * step_values(check).get("FC", 1.0) for check in found.checks]
    assert own == pytest.approx([at_rest] * len(found.checks), rel=1e-9)


@pytest.mark.parametrize(
    ("joint", "equation", "told"),
    [
        (SOFT, "linearised", True),
        (SOFT.replace("flexible", "semi-flexible"), "linearised", True),
        (SOFT, "exact", False),
        ("", "linearised", False),
        ('interface = { strength = "1 MPa" }', "linearised", False),  # crushes, yet lifts off as the rigid one does
    ],
)
def test_the_linearised_equation_on_joints_without_a_threshold_is_told(tmp_path, joint, equation, told):
    """Below the threshold of the linearised equation nothing moves, where the exact one always does."""
    made = study_of(tmp_path, mechanism=joint, analysis=f'equation = "{equation}"\nlevels = ["0.02 g"]', records=SUITE)
    texts = [notice.text for notice in made.messages if (notice.key, notice.where) == ("equation", "analysis.equation")]
    assert len(texts) == told
    assert all("the joints of m do not have" in text for text in texts)
    histories = run_study(made).mechanisms[0].histories
    moved = [history.max_rotation_rad for history in histories if history.level_pga_g < 0.1]
    assert len(moved) == 5
    assert any(moved) == (equation == "exact")
