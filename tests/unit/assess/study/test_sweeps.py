"""Sweeps of a study: which case controls, what stands in the results, and that a case is a project of its own."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.constants import g

from assess.codes.bases import BASES
from assess.codes.check import Check
from assess.codes.question import Action, MechanismChecks, Question
from assess.codes.verdict import mark_deciding, verdict
from assess.results import MechanismResult
from assess.results.json import dumps
from assess.study.mechanism_results import case_parameters, parameters
from assess.study.run import run_study
from assess.study.variations import MechanismInCase, controlling_index
from tests.support.answered import rotation_check
from tests.support.motions import write_noise
from tests.support.projects import ASCE7, block, project_toml, study_of, wall

PROJECT = project_toml(
    verdict={"basis": "asce43-05", "procedures": ["asce43-05-spectrum"]},
    site={"limit_state": "DBE", "spectrum": ASCE7},
    materials={"stone": {"density": 2000}, "brick": {"density": 1800}},
    bodies={
        "wall": wall(length=4.0, height=4.5, material="stone"),
        "cap": wall(length=4.0, height=1.5, base=[0, 0, 4.5]),
    },
    mechanisms={"capped": block(["wall", "cap"]), "wall": block()},
    records={"files": ["a.csv"]},
    analysis={"levels": ["0.1 g", "0.25 g"], "procedures": ["asce43-05-spectrum", "dmi2008-linear"]},
)
HEIGHT = '[analysis.sweep]\nkey = "bodies.cap.box.height"\nvalues = ["1.0 m", "2.0 m", "1.5 m"]\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_noise(tmp_path / "a.csv", duration=12.0)
    return tmp_path


@pytest.fixture
def result(folder: Path) -> MechanismResult:
    return parameters(study_of(folder, PROJECT))[0]


def case(
    result: MechanismResult, *checks: Check, uplift: float = 0.1, basis: str | None = "asce43-05"
) -> MechanismInCase:
    """The mechanism with these checks and this multiplier, judged at 0.1 g."""
    methods = ("asce43-05-history", "asce43-05-spectrum")
    question = Question(None if basis is None else BASES[basis], Action(0.1, "DBE"), procedures=methods)
    found = verdict(question, [MechanismChecks(result.name, checks)]).mechanisms[0]
    weaker = replace(result.oscillator, uplift_multiplier=uplift)
    marked = mark_deciding(checks, found, question.basis, question.action)
    return MechanismInCase(replace(result, checks=marked, oscillator=weaker, oscillator_negative=None), found)


def test_a_failing_case_controls_before_an_incomplete_one_and_that_before_one_that_passes(
    result: MechanismResult,
) -> None:
    """A larger ratio for comparison, or at another level, does not make a case control."""
    cases = [
        case(result, rotation_check(ratio=0.9), rotation_check("fail", ratio=7.0, procedure="dmi2008-linear")),
        case(result, rotation_check(ratio=0.8), rotation_check("fail", ratio=9.0, level=0.3)),
        case(result, rotation_check("not-answered")),
    ]
    assert [each.verdict.outcome for each in cases] == ["pass", "pass", "incomplete"]
    assert controlling_index(cases) == 2
    assert controlling_index(cases[:2]) == 0
    assert controlling_index([*cases, case(result, rotation_check("fail", ratio=1.01))]) == 3


def test_of_equal_verdicts_the_least_margin_controls_then_the_ratio(result: MechanismResult) -> None:
    cases = [
        case(result, rotation_check("fail", ratio=1.5, capacity_pga_g=0.08)),
        case(result, rotation_check("fail", ratio=1.2, capacity_pga_g=0.07)),
    ]
    assert controlling_index(cases) == 1
    fallen = case(result, rotation_check("fail"))  # it overturns, and at which PGA it would not is unknown
    assert controlling_index([*cases, fallen, case(result, rotation_check("fail", ratio=3.0))]) == 2
    passing = [case(result, rotation_check(ratio=0.4)), case(result, rotation_check(ratio=0.5, capacity_pga_g=0.2))]
    assert controlling_index(passing) == 1


def test_without_a_basis_all_checks_of_codes_tell_which_case_controls(result: MechanismResult) -> None:
    none = {"basis": None}
    cases = [
        case(result, rotation_check(ratio=0.5), rotation_check(ratio=1.2, level=0.2), **none),
        case(result, rotation_check(ratio=1.3, reading="thesis"), rotation_check(ratio=0.4), **none),
        case(result, rotation_check("not-applicable", ratio=9.0), rotation_check(ratio=0.3), **none),
        case(result, rotation_check("fail", ratio=1.25), **none),
    ]
    assert controlling_index(cases) == 3
    assert controlling_index([*cases, case(result, rotation_check("fail"), rotation_check(ratio=0.1), **none)]) == 4


def test_where_nothing_is_answered_the_least_capacity_controls_then_the_multiplier(result: MechanismResult) -> None:
    silent = {"outcome": "not-answered", "ratio": 2.0}
    cases = [
        case(result, rotation_check(capacity_pga_g=0.4, **silent), uplift=0.05),
        case(result, rotation_check(capacity_pga_g=0.3, **silent)),
        case(result, rotation_check(**silent), uplift=0.01),
    ]
    assert controlling_index(cases) == 1
    assert controlling_index([case(result, uplift=u) for u in (0.2, 0.15, 0.15 + 1e-13, 0.3)]) == 1


def test_equals_leave_the_first(result: MechanismResult) -> None:
    cases = [case(result, rotation_check(ratio=ratio)) for ratio in (0.7, 0.7 * (1 + 1e-12), 0.7)]
    assert controlling_index(cases) == 0


def test_only_what_depends_on_the_key_is_swept_and_its_worst_case_stands(folder: Path) -> None:
    results = run_study(study_of(folder, PROJECT + HEIGHT))
    (sweep,) = results.sweeps
    assert (sweep.mechanism, sweep.key, sweep.unit, sweep.value) == (
        "capped",
        "bodies.cap.box.height",
        "m",
        (1.0, 2.0, 1.5),
    )
    cap = np.array(sweep.value)
    height = (2000 * 4.5 * 2.25 + 1800 * cap * (4.5 + cap / 2)) / (2000 * 4.5 + 1800 * cap)  # of the centroid
    np.testing.assert_allclose(sweep.uplift_multiplier, 0.3 / height, rtol=1e-12)
    assert (sweep.controlling, sweep.governs) == (1, True)
    standing = results.mechanisms[0]
    assert standing.oscillator.uplift_multiplier == sweep.uplift_multiplier[1]
    (deciding,) = [c for c in standing.checks if c.role == "deciding"]
    assert (deciding.procedure, deciding.level_pga_g) == ("asce43-05-spectrum", 0.2)
    assert deciding.ratio == sweep.demand_capacity[1]
    assert results.verdict is not None
    assert results.verdict.mechanisms[0].outcome == sweep.outcome[1]
    assert [row.demand_capacity for row in results.comparison if row.mechanism == "capped"] == [
        c.ratio for c in standing.checks
    ]
    assert [(n.key, n.where) for n in results.warnings if n.key == "sweep"] == [("sweep", "mechanisms.capped")]
    assert "bodies.cap.box.height = 2 m" in " ".join(notice.text for notice in results.warnings)


def test_a_sweep_of_stiffness_tells_how_the_mechanism_stands_on_its_joint(folder: Path) -> None:
    """Full contact turns about the middle of the base: omega^2 = (k l b^3 / 12 - W h) / I."""
    joint = 'interface = { model = "flexible", stiffness = "1 GPa/m", strength = "inf" }\n'
    text = PROJECT.replace('blocks = ["wall"]\n', 'blocks = ["wall"]\n' + joint)
    key = '[analysis.sweep]\nkey = "mechanisms.wall.interface.stiffness"\nvalues = ["1 GPa/m", "4 GPa/m"]\n'
    (sweep,) = run_study(study_of(folder, text + key)).sweeps
    b, length, H, mass = 0.6, 4.0, 4.5, 2000 * 0.6 * 4.0 * 4.5
    inertia = mass * ((b**2 + H**2) / 12 + (H / 2) ** 2)
    omega2 = (np.array([1e9, 4e9]) * length * b**3 / 12 - mass * g * H / 2) / inertia
    np.testing.assert_allclose(np.array(sweep.elastic_frequency_hz), np.sqrt(omega2) / (2 * np.pi), rtol=1e-6)
    soft, stiff = sweep.overturning_flexible_rad
    assert soft is not None
    assert stiff is not None
    assert soft < stiff < sweep.overturning_rad[0] == sweep.overturning_rad[1]
    assert sweep.uplift_multiplier == (None, None)


@pytest.mark.parametrize(
    ("key", "value", "old"),
    [
        ("bodies.cap.box.height", "2.0", "height = 1.5"),
        ("site.spectrum.s_ds", '"0.7 g"', 's_ds = "0.5 g"'),
        ("analysis.levels.1", '"0.3 g"', '"0.25 g"'),
    ],
)
def test_a_case_is_what_the_project_with_its_value_would_be(folder: Path, key: str, value: str, old: str) -> None:
    sweep = f'[analysis.sweep]\nkey = "{key}"\nvalues = [{value}]\n'
    swept = run_study(study_of(folder, PROJECT + sweep))
    assert PROJECT.count(old) == 1
    alone = run_study(study_of(folder, PROJECT.replace(old, f"{old.split('=')[0]}= {value}" if "=" in old else value)))
    assert swept.mechanisms == alone.mechanisms
    assert swept.comparison == alone.comparison


def test_the_worst_of_several_sweeps_stands(folder: Path) -> None:
    lighter = '[[analysis.sweep]]\nkey = "materials.brick.density"\nvalues = [1000, 1900]\n'
    results = run_study(study_of(folder, PROJECT + lighter + HEIGHT.replace("[analysis.sweep]", "[[analysis.sweep]]")))
    first, second = results.sweeps
    assert (first.mechanism, second.mechanism) == ("capped", "capped")
    assert (first.governs, second.governs) == (False, True)
    assert results.mechanisms[0].oscillator.uplift_multiplier == second.uplift_multiplier[second.controlling]


def test_the_density_of_one_of_two_bodies_moves_their_centroid(folder: Path) -> None:
    sweep = '[analysis.sweep]\nkey = "materials.brick.density"\nfrom = 900\nto = 3600\ncount = 4\n'
    study = study_of(folder, PROJECT + sweep)
    found = case_parameters(study)
    density = np.array([900.0, 1800.0, 2700.0, 3600.0])
    wall, cap = 2000 * 4.5, density * 1.5
    height = (wall * 2.25 + cap * 5.25) / (wall + cap)
    np.testing.assert_allclose([m.oscillator.uplift_multiplier for m in found], 0.3 / height, rtol=1e-12)
    np.testing.assert_allclose([m.oscillator.mass_kg for m in found], 0.6 * 4 * (wall + cap), rtol=1e-12)
    assert found[0].name == "capped, brick.density = 900 kg/m^3"


def test_lengths_times_a_number_divide_p_squared_by_it(folder: Path) -> None:
    trimesh.creation.box(extents=(0.6, 4.0, 4.5)).export(folder / "wall.stl")
    text = PROJECT.replace("box = { thickness = 0.6, length = 4.0, height = 4.5 }", 'mesh = "wall.stl"\nmesh_unit = 1')
    study = study_of(folder, text + '[analysis.sweep]\nkey = "bodies.wall.mesh_unit"\nvalues = [1, 2, 10]\n')
    found = [m for m in case_parameters(study) if m.name.startswith("wall")]
    p = np.array([m.oscillator.p_eq_per_s for m in found])
    np.testing.assert_allclose(p**2 * np.array([1, 2, 10]), p[0] ** 2, rtol=1e-9)
    assert len({round(m.oscillator.uplift_multiplier or 0.0, 9) for m in found}) == 1


def test_results_do_not_depend_on_jobs(folder: Path) -> None:
    every = PROJECT.replace('procedures = ["asce43-05-spectrum", ', 'procedures = ["asce43-05-history", ')
    study = study_of(folder, every + HEIGHT.replace(', "1.5 m"', ""))
    assert dumps(run_study(study, jobs=1)) == dumps(run_study(study, jobs=3))


def test_progress_counts_the_cases(folder: Path) -> None:
    said: list[tuple[str, int, int]] = []
    run_study(study_of(folder, PROJECT + HEIGHT), progress=lambda *told: said.append(told))
    assert [(done, total) for stage, done, total in said if stage == "cases of sweeps"] == [(0, 3), (1, 3), (2, 3)]


def test_without_sweeps_nothing_is_swept(folder: Path) -> None:
    results = run_study(study_of(folder, PROJECT))
    assert results.sweeps == ()
    assert [mechanism.direction_sweep for mechanism in results.mechanisms] == [None, None]


def test_the_verdict_of_a_swept_site_stands_at_the_action_of_the_case_that_controls(folder: Path) -> None:
    scaled = PROJECT.replace("[site]\n", '[site]\npga = "0.2 g"\n')
    swept = run_study(study_of(folder, f'{scaled}[analysis.sweep]\nkey = "site.pga"\nvalues = ["0.15 g", "0.28 g"]\n'))
    alone = run_study(study_of(folder, scaled.replace('pga = "0.2 g"', 'pga = "0.28 g"')))
    assert swept.verdict is not None
    assert swept.verdict.action.pga_g == pytest.approx(0.28, rel=1e-12)
    assert alone.verdict is not None
    for one, other in zip(swept.verdict.mechanisms, alone.verdict.mechanisms, strict=True):
        assert (one.outcome, one.margin) == (other.outcome, other.margin)
    assert swept.verdict.outcome == "fail"


@pytest.mark.parametrize(
    ("key", "values", "of_a_case"),
    [
        ("bodies.wall.box.thickness", '["2.5 m", "3 m"]', False),
        ("bodies.wall.box.thickness", '["10 cm", "250 cm"]', True),
        ("bodies.wall.box.height", '["1 cm", "20 cm"]', False),
        ("site.pga", '["0.01 g", "0.015 g"]', False),
    ],
)
def test_a_mechanism_counts_as_the_file_has_it_beside_the_cases_of_its_sweep(
    tmp_path: Path, key: str, values: str, of_a_case: bool
) -> None:
    """A wall 0.2 m thick that fails does not pass because its sweep begins at 2.5 m, or skips what the file has."""
    project = swept_wall(key, values)
    alone = run_study(study_of(tmp_path, project.partition("[analysis.sweep]")[0]), jobs=1)
    found = run_study(study_of(tmp_path, project), jobs=1)
    assert alone.verdict is not None
    assert found.verdict is not None
    assert alone.verdict.outcome == found.verdict.outcome == "fail"
    assert found.sweeps[0].governs is of_a_case
    assert (found.mechanisms == alone.mechanisms) is not of_a_case
    assert ("sweep-as-typed" in [each.key for each in found.warnings]) is not of_a_case


def swept_wall(key: str, values: str) -> str:
    """Return the project of a wall 0.2 m thick and 4.5 m high on an EC8 site, which fails, with a sweep."""
    whole = project_toml(
        site={"limit_state": "ULS", "spectrum": {"code": "ec8", "a_g": "0.1 g", "ground_type": "C"}},
        bodies={"wall": wall(0.2, height=4.5)},
        mechanisms={"wall": block()},
        analysis={"procedures": ["ec8-element"], "scan": False},
    )
    return f'{whole}\n[analysis.sweep]\nkey = "{key}"\nvalues = {values}\n'
