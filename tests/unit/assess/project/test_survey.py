"""What the survey's tolerance takes from an index, against what it must by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.codes.question import MechanismChecks
from assess.codes.verdict import verdict
from assess.study.run import run_study
from assess.study.variations import survey_tolerances
from tests.support.projects import NTC, block, lines, project_toml, study_of, wall


def found(tmp_path: Path, *, pga: float, tolerance: float, more: str = ""):
    text = project_toml(
        site={"limit_state": "SLV", "pga": f"{pga} g", "spectrum": NTC},
        verdict={"survey_tolerance": f"{tolerance} mm"},
        building={"use_class": "II"},
        records={"synthetic": {"count": 1, "duration": "8 s"}},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey"}},
        bodies={"wall": wall(0.6, 3.0, 6.0, material="m")},
        mechanisms={"wall": lines(block(direction=[1, 0, 0]), more)},
    )
    study = study_of(tmp_path, text)
    return study, run_study(study, jobs=1)


def fall(tmp_path: Path, **given) -> float:
    one, results = found(tmp_path, **given)
    judged = verdict(one.question, [MechanismChecks(m.name, m.checks, *one.facts[m.name]) for m in results.mechanisms])
    return survey_tolerances(one.survey, one.spectrum, one.question, judged, results.mechanisms)["wall"]


def test_a_thinner_wall_loses_in_proportion(tmp_path):
    """d0* and a0* are both in proportion to the thickness, so the period stays and the index falls with it."""
    assert fall(tmp_path, pga=0.3, tolerance=30) == pytest.approx(30 / 600, rel=0.02)


def test_a_hinge_set_back_counts_as_half_the_thickness(tmp_path):
    hinges = "hinges = { A = [0.3, 0] }\nhinges_negative = { A = [-0.3, 0] }"
    both = fall(tmp_path, pga=0.3, tolerance=15, more=hinges)
    assert both == pytest.approx(2 * 15 / 300, rel=0.03)  # each of the two hinges, alone


def test_a_load_counts_with_five_per_cent(tmp_path):
    """A thrust at the top takes F h from the moment b W / 2, so 5 % of it is a share of what is left."""
    thrust = 'loads = [{ kind = "force", force = ["3 kN", "0 N"], at = [0.0, 6.0] }]'
    weight, moment = 1800 * 0.6 * 3.0 * 6.0 * 9.80665, 3e3 * 6.0
    left = weight * 0.3 - moment
    found = fall(tmp_path, pga=0.2, tolerance=0.001, more=thrust)
    assert found == pytest.approx(0.05 * moment / left, rel=0.6)
    assert found > 0.05 * moment / left  # d0* and a0* both fall, and the period with them


@pytest.mark.parametrize(("tolerance", "near"), [(20, False), (80, True)])
def test_the_tolerance_widens_what_is_at_the_limit(tmp_path, tolerance, near):
    index = found(tmp_path, pga=0.3, tolerance=0)[1].verdict.index.value
    _, results = found(tmp_path, pga=0.3 * index / 1.08, tolerance=tolerance)
    assert results.verdict.index.value == pytest.approx(1.08, rel=1e-6)
    assert results.verdict.at_the_limit is near


def test_an_index_far_from_its_threshold_is_not_looked_at(tmp_path):
    one, results = found(tmp_path, pga=0.02, tolerance=20)
    assert results.verdict.index.value > 1.5
    assert survey_tolerances(one.survey, one.spectrum, one.question, results.verdict, results.mechanisms) == {}
