"""Uncertainty: closed forms of a lognormal ratio, groups, inputs without influence, seeds, jobs, what is left out."""

from __future__ import annotations

from dataclasses import replace
from math import asin, exp, log, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from scipy.special import ndtr, ndtri

from assess.cli.tables.analysis import run_text, uncertainty_lines
from assess.results import Results
from assess.results.diff import differences
from assess.results.json import dumps, loads
from assess.results.run import UncertainAnswer
from assess.results.table import table
from assess.study.run import run_study
from assess.study.uncertainty import sobol_points, total_influence, values_at_point
from tests.support.motions import write_noise
from tests.support.projects import ASCE7, NTC, block, project_toml, results_of, study_of, wall

THICK = {"mean": "0.60 m", "cov": 0.1}
SUITE = None
"""The artificial records of a project that names none, which meet the rules of the code."""
LINEAR = "ntc2018-linear"
HISTORIES: dict[str, Any] = {"records": SUITE, "procedures": [LINEAR, "ntc2018-nonlinear", "ntc2018-history"]}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_noise(tmp_path / "a.csv", duration=6.0)
    return tmp_path


@pytest.fixture(scope="module")
def histories(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """The results of a wall of uncertain thickness, histories among them."""
    return assessed(tmp_path_factory.mktemp("histories"), bodies={"wall": wall(THICK)}, **HISTORIES)


def project(*more: str, samples: int = 16, procedures: Any = (LINEAR,), **tables: Any) -> str:
    uncertainty = {"samples": samples, **tables.pop("uncertainty", {})}
    plain = {
        "site": {"spectrum": {**NTC, "a_g": "0.21 g"}, "limit_state": "SLV"},
        "mechanisms": {"wall": block(direction=[1, 0, 0])},
        "records": {"files": ["a.csv"]},
    }
    analysis = {"procedures": list(procedures), "uncertainty": uncertainty, **tables.pop("analysis", {})}
    return project_toml(*more, **{**plain, **tables, "analysis": analysis})


def assessed(folder: Path, *more: str, jobs: int = 1, **tables: Any) -> Results:
    return results_of(folder, project(*more, **tables), jobs=jobs)


def answer_of(results: Results, procedure: str = LINEAR, state: str = "SLV") -> UncertainAnswer:
    (one,) = [each for each in results.uncertainty.answers if (each.procedure, each.limit_state) == (procedure, state)]
    return one


def ratios(answer: UncertainAnswer) -> Any:
    return np.array([np.nan if each is None else each for each in answer.ratios])


@pytest.mark.parametrize(
    ("answer", "exact"),
    [
        (lambda x: x[:, 0] + 0.0 * x[:, 1], (1.0, 0.0)),
        (lambda x: (x[:, 0] - 0.5) ** 2, (1.0, 0.0)),  # no rank correlation at all
        (lambda x: (x[:, 0] - 0.5) * (x[:, 1] - 0.5), (1.0, 1.0)),  # neither does anything by itself
        (lambda x: np.where(x[:, 0] > 0.5, np.inf, 1.0), (1.0, 0.0)),  # overturns, or does not
        (lambda x: ndtri(x[:, 0]) + ndtri(x[:, 1]), 2 * (1.0 - 6.0 / pi * asin(0.25),)),
    ],
)
def test_total_influences_are_sobols(answer: Any, exact: tuple[float, float]) -> None:
    """Of the ranks: two sums of normals that share one have the correlation 1/2, and their ranks 6/pi asin(1/4)."""
    rng = np.random.default_rng(5)
    x, other = rng.random((2, 4096, 2))
    for column, wanted in enumerate(exact):
        swapped = x.copy()
        swapped[:, column] = other[:, column]
        found = total_influence(answer(x), answer(swapped))
        assert found is not None
        assert found == pytest.approx(wanted, abs=0.05)  # three standard errors of 4096 samples


A_G = {"mean": "0.21 g", "cov": 0.3}


def test_an_uncertain_a_g_moves_the_demand(folder: Path) -> None:
    """On rock the linear check compares a_g with what the wall resists, so D/C is a_g times a constant."""
    site = {"spectrum": {**NTC, "a_g": A_G, "soil": "A"}, "limit_state": "SLV"}
    answer = answer_of(assessed(folder, samples=64, site=site))
    b = sqrt(log(1.09))
    assert answer.at_mean is not None
    assert answer.answered == 64
    np.testing.assert_allclose(np.std(np.log(ratios(answer))), b, rtol=0.02)
    np.testing.assert_allclose(np.median(ratios(answer)), answer.at_mean * exp(-(b**2) / 2.0), rtol=0.03)
    (influence,) = answer.influences
    assert influence.keys == ("site.spectrum.a_g",)
    assert influence.rank_correlation == pytest.approx(1.0)


def test_records_scaled_to_the_spectrum_grow_with_an_uncertain_a_g(folder: Path) -> None:
    """A sample is the answer of the project at a level of that PGA."""
    site = {"spectrum": {**NTC, "a_g": A_G, "soil": "A"}, "limit_state": "SLV"}
    study = study_of(folder, project(site=site, samples=16, **HISTORIES))
    results = run_study(study, jobs=1)
    answer = answer_of(results, "ntc2018-history")
    values = [values_at_point(study.sampling, point)[0] for point in sobol_points(study.sampling, 16)]
    place = int(np.argsort(values)[4])
    site = {"spectrum": {**NTC, "a_g": "0.21 g", "soil": "A"}, "limit_state": "SLV"}
    plain = project(site=site, bodies={"wall": wall(THICK)}, analysis={"levels": [values[place]]}, **HISTORIES)
    (mechanism,) = run_study(study_of(folder, plain), jobs=1).mechanisms
    by_level = {each.level_pga_g: each.ratio for each in mechanism.checks if each.procedure == "ntc2018-history"}
    assert answer.ratios[place] == pytest.approx(by_level[min(by_level)], rel=1e-9)
    assert min(by_level) == pytest.approx(values[place] / 9.80665)
    assert len({each for each in answer.ratios if each is not None}) > 8


def test_totals_are_found_where_shares_explain_little(histories: Results) -> None:
    found = [answer.influences[0] for answer in histories.uncertainty.answers if answer.influences]
    for only in found:
        assert (only.total is None) is (only.share is None or only.share >= 0.9)
        if only.total is not None:  # nothing else varies
            assert only.total > 0.5
    assert any(each.total is not None for each in found)


def test_a_lognormal_thickness_gives_a_lognormal_ratio(folder: Path) -> None:
    """The linear check compares with t / h, so D/C = c / t: ln(D/C) is normal, and P(D/C > 1) = P(t < c)."""
    results = assessed(folder, samples=64, bodies={"wall": wall(THICK)})
    answer = answer_of(results)
    assert answer.at_mean is not None
    c, b = answer.at_mean * 0.6, sqrt(log(1.01))
    median = 0.6 * exp(-(b**2) / 2.0)
    percents = np.array([0.05, 0.16, 0.50, 0.84, 0.95])
    exact = c / median * np.exp(b * ndtri(percents))
    np.testing.assert_allclose(answer.quantiles, exact, rtol=2e-2)  # type: ignore[arg-type]
    np.testing.assert_allclose(np.std(np.log(ratios(answer))), b, rtol=0.02)
    fails = float(ndtr((log(c) - log(median)) / b))
    assert answer.probability is not None
    assert 0.05 < fails < 0.95
    assert abs(answer.probability - fails) <= 1.0 / 64  # one sample in each of 64 equal cells
    assert answer.interval is not None
    assert answer.interval[0] < fails < answer.interval[1]
    (influence,) = answer.influences
    assert (influence.rank_correlation, influence.share) == (pytest.approx(-1.0), pytest.approx(1.0))
    assert (answer.answered, answer.failed, len(answer.ratios)) == (64, round(answer.probability * 64), 64)


def test_density_of_a_free_wall_changes_nothing_and_the_results_say_so(folder: Path) -> None:
    tables = {
        "materials": {"brick": {"density": {"mean": 1800, "cov": 0.2}}},
        "bodies": {"wall": wall(THICK)},
        "procedures": [LINEAR, "ntc2018-nonlinear", "ntc2018-history"],
        "records": SUITE,
    }
    results = assessed(folder, **tables)
    assert answer_of(results, "ntc2018-history").answered == 16
    told = [note for note in results.uncertainty.notes if note.key == "uncertainty-idle"]
    assert [note.values["keys"] for note in told] == ["materials.brick.density"]
    for answer in results.uncertainty.answers:
        if answer.answered:
            density, thickness = answer.influences
            assert (density.group, density.rank_correlation, density.share) == ("materials.brick.density", None, None)
            assert thickness.rank_correlation is not None
            assert [note.key for note in answer.notes] == ["uncertainty-no-influence"]
    alone = assessed(folder, samples=16, materials={"brick": {"density": {"mean": 1800, "cov": 0.2}}})
    np.testing.assert_allclose(ratios(answer_of(alone)), answer_of(alone).at_mean, rtol=1e-12)  # type: ignore[arg-type]


def test_numbers_of_one_group_vary_together(folder: Path) -> None:
    """Thickness and height in proportion leave t / h as it is; one by one they spread it by sqrt(2) of each."""
    high = {"mean": "4 m", "cov": 0.1}
    together = {"wall": wall({**THICK, "group": "size"}, height={**high, "group": "size"})}
    answer = answer_of(assessed(folder, bodies=together))
    np.testing.assert_allclose(ratios(answer), answer.at_mean, rtol=1e-12)  # type: ignore[arg-type]
    apart = answer_of(assessed(folder, samples=128, bodies={"wall": wall(THICK, height=high)}))
    np.testing.assert_allclose(np.std(np.log(ratios(apart))), sqrt(2.0 * log(1.01)), rtol=0.05)
    first, second = apart.influences
    assert first.rank_correlation is not None
    assert second.rank_correlation is not None
    assert first.rank_correlation < 0.0 < second.rank_correlation
    np.testing.assert_allclose([first.share, second.share], 0.5, atol=0.1)  # type: ignore[arg-type]


def test_the_same_bytes_for_any_number_of_jobs_and_a_seed_of_its_own(folder: Path, histories: Results) -> None:
    assert answer_of(histories, "ntc2018-history").answered == 16
    assert dumps(histories) == dumps(assessed(folder, bodies={"wall": wall(THICK)}, **HISTORIES, jobs=2))
    other = assessed(folder, bodies={"wall": wall(THICK)}, uncertainty={"seed": 2})
    assert other.uncertainty.seed == 2
    assert answer_of(histories).ratios != answer_of(other).ratios
    assert loads(dumps(histories)) == histories


def test_records_stay_as_they_are_and_the_rest_of_the_results_too(folder: Path) -> None:
    study = study_of(folder, project(bodies={"wall": wall(THICK)}, samples=16))
    results, plain = run_study(study), run_study(replace(study, sampling=None))
    assert results == replace(plain, uncertainty=results.uncertainty)


def test_a_sample_is_the_project_with_that_number_in_it(folder: Path, histories: Results) -> None:
    linear = answer_of(histories)
    assert answer_of(histories, "ntc2018-history").answered == 16
    assert linear.at_mean is not None
    place = int(np.argmin(ratios(linear)))
    thickness = linear.at_mean * 0.6 / ratios(linear)[place]
    scatter = {"brick": {"density": {"mean": 1800, "cov": 0.01}}}
    single = assessed(folder, bodies={"wall": wall(float(thickness))}, materials=scatter, **HISTORIES)
    for procedure, rtol in ((LINEAR, 1e-9), ("ntc2018-nonlinear", 1e-9), ("ntc2018-history", 1e-3)):
        at = answer_of(single, procedure).at_mean
        assert at is not None
        np.testing.assert_allclose(ratios(answer_of(histories, procedure))[place], at, rtol=rtol)  # histories amplify


def test_a_mesh_is_thickened_as_the_box_it_is(folder: Path) -> None:
    trimesh.creation.box((0.6, 3.0, 4.0), trimesh.transformations.translation_matrix((0, 0, 2))).export(
        folder / "w.stl"
    )
    mesh = {"wall": {"material": "brick", "mesh": "w.stl"}}
    density = {"brick": {"density": {"mean": 1800, "cov": 0.05}}}
    by_mesh = assessed(folder, bodies=mesh, uncertainty={"thickness": 0.1})
    np.testing.assert_allclose(
        ratios(answer_of(by_mesh)),
        ratios(answer_of(assessed(folder, bodies={"wall": wall(THICK)}))),
        rtol=1e-6,  # single precision of the file
    )
    (given,) = by_mesh.uncertainty.inputs
    assert (given.key, given.group, given.cov, given.mean) == (
        "thickness of wall", "thickness", 0.1, pytest.approx(0.6, rel=1e-6),
    )  # fmt: skip
    study = study_of(folder, project(samples=16, bodies=mesh, materials=density))
    assert study.sampling is not None
    (mechanism,) = study.sampling.study_at((1950.0,))("wall").mechanisms
    np.testing.assert_allclose(mechanism.variants.deciding.mass, 1950.0 * 0.6 * 3.0 * 4.0, rtol=1e-6)


def test_what_cannot_be_thickened_or_is_swept_is_told(folder: Path) -> None:
    direct = {"mass": "12000 kg", "centroid": [0, 2], "inertia": 16000}
    mechanisms = {
        "wall": block(direction=[1, 0, 0]),
        "stone": block("stone", hinges={"A": [0.3, 0]}, hinges_negative={"A": [-0.3, 0]}),
    }
    results = assessed(
        folder,
        samples=16,
        bodies={"wall": wall(), "stone": direct},
        mechanisms=mechanisms,
        uncertainty={"thickness": 0.1},
    )
    assert [note.where for note in results.uncertainty.notes if note.key == "uncertainty-thickness-left-out"] == [
        "mechanisms.stone"
    ]
    assert {each.mechanism for each in results.uncertainty.answers} == {"wall"}
    sweep = {"sweep": {"key": "bodies.wall.box.height", "values": [4, 5]}}
    swept = assessed(folder, bodies={"wall": wall(THICK)}, analysis=sweep)
    assert swept.uncertainty.answers == ()
    assert [note.key for note in swept.uncertainty.notes] == ["uncertainty-left-out", "uncertainty-idle"]


def test_a_sensitivity_beside_is_that_of_the_means(folder: Path) -> None:
    sensitivity = {"sensitivity": {"thickness": "2 cm"}}
    both = assessed(folder, bodies={"wall": wall(THICK)}, analysis=sensitivity)
    alone = assessed(folder, bodies={"wall": wall("0.6 m")}, analysis=sensitivity,
                     materials={"brick": {"density": {"mean": 1800, "cov": 0.1}}})  # fmt: skip
    assert both.sensitivity == alone.sensitivity != ()


def test_a_sample_that_cannot_be_built_is_not_answered_with_its_reason(folder: Path) -> None:
    """A hollow joint whose hole scatters beyond its outside."""
    shape = {"hollow_rectangle": [0.6, 3.0, {"mean": 0.5, "cov": 0.2}, 2.5]}
    joint = {"model": "flexible", "stiffness": "1 GPa/m", "strength": "inf", "shape": shape}
    sources = {"mechanisms.wall.interface": "measured: cores through the bed, 2019"}
    mechanisms = {"wall": block(direction=[1, 0, 0], interface=joint)}
    results = assessed(folder, samples=32, mechanisms=mechanisms, report={"sources": sources})
    answer = answer_of(results)
    exact = float(ndtr(log(0.6 / 0.5 * sqrt(1.04)) / sqrt(log(1.04))))
    assert abs(answer.answered / 32 - exact) <= 1.0 / 32
    (note,) = [each for each in answer.notes if each.key == "uncertainty-not-built"]
    assert str(note.values["number"]) == str(32 - answer.answered)
    assert "hollow_rectangle" in note.text
    assert [at is None for at in answer.ratios].count(False) == answer.answered


def test_restitutions_beyond_one_are_cut_off_and_told(folder: Path) -> None:
    mechanisms = {"wall": block(direction=[1, 0, 0], restitution={"mean": 0.97, "cov": 0.04})}
    results = assessed(folder, samples=16, mechanisms=mechanisms)
    (note,) = [each for each in results.uncertainty.notes if each.key == "uncertainty-cut-off"]
    assert note.where == "mechanisms.wall.restitution"
    b = sqrt(log(1.0 + 0.04**2))
    z = (
        log(1.0 / 0.97) / b + b / 2.0
    )  # of 1; the mean of a lognormal that is cut there is ndtr(z - b) / ndtr(z) of its own
    assert note.values["mean"].value == pytest.approx(float(ndtr(z - b) / ndtr(z)), rel=1e-5)


def test_table_summary_and_differences(folder: Path) -> None:
    premises = '[report.sources]\n"materials.brick.disintegration" = "measured: test"\n'
    tables = {
        "materials": {"brick": {"density": 1800, "disintegration": "excluded"}},
        "bodies": {"wall": wall({**THICK, "group": "walls"})},
        "procedures": ["ntc2018-nonlinear"],
        "samples": 16,
    }
    results = assessed(folder, premises, **tables)
    frame = table(results, "uncertainty")
    assert list(frame["mechanism"]) == ["wall"] * len(results.uncertainty.answers)
    assert frame["quantile_50"][0] == results.uncertainty.answers[0].quantiles[2]
    said = " ".join(run_text(results).split())
    assert "uncertainty: 16 samples of 1 uncertain number in 1 group wall: ntc2018-nonlinear SLV: fails in" in said
    assert "most by walls (share 1)" in said
    assert list(uncertainty_lines(None)) == []
    other = assessed(folder, premises, **{**tables, "bodies": {"wall": wall({**THICK, "cov": 0.2, "group": "walls"})}})
    differing = [each for each in differences(results, other) if each.kind == "uncertainty"]
    assert ("bodies.wall.box.thickness, cov", 0.1, 0.2) in [(each.what, each.before, each.after) for each in differing]
    assert any(each.what.startswith("demand_capacity, 95 %") for each in differing)
    assert not [each for each in differences(results, results) if each.kind == "uncertainty"]


def test_a_mechanism_without_an_answer_has_no_influence_to_tell(folder: Path) -> None:
    """An impact that keeps nothing is outside ASCE 43-05 A.2, the only method asked for."""
    body = {"kind": "equivalent-block", "p": {"mean": 2.4, "cov": 0.1}, "uplift": 0.2, "radius": 1.2, "restitution": 0}
    code = {
        "site": {"spectrum": ASCE7, "limit_state": "DBE"},
        "verdict": {"basis": "asce43-05", "procedures": ["asce43-05-spectrum"]},
    }
    found = assessed(folder, mechanisms={"wall": body}, procedures=["asce43-05-spectrum"], **code)
    assert found.uncertainty is not None
    assert found.uncertainty.answers == ()
