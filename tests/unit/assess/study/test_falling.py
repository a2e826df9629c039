"""A mechanism that falls under its own loads fails beside the others, with its multiplier."""

from pathlib import Path

import pytest

from assess.codes.verdict import Decision
from assess.project.build import build
from assess.project.project_file import load
from assess.results.json import dumps, read
from assess.study.run import find_verdict, run_study
from tests.support.projects import NTC, block, lines, project_toml, wall

THICKNESS, LENGTH, HEIGHT, DENSITY = 0.5, 3.0, 5.0, 1800.0
PUSH, UP = 60e3, 4.5  # a thrust [N] and the height at which it acts [m]


def project(folder: Path, *, stands: bool) -> Path:
    """Write a project with a wall that a thrust pushes over, and another that stands if so asked."""
    thrust = f'loads = [{{ kind = "force", force = "{PUSH} N", direction = [1, 0], at = [0.25, {UP}] }}]'
    mechanisms = {"pushed": lines(block(direction=[1, 0, 0], sides="one"), thrust)}
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        building={"height": HEIGHT, "storeys": 1, "use_class": "II"},
        materials={"m": {"density": DENSITY, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey"}},
        analysis={"procedures": ["ntc2018-nonlinear"], "scan": False},
        records={"synthetic": {"count": 1, "duration": "25 s"}},
        bodies={
            "wall": wall(THICKNESS, LENGTH, HEIGHT, material="m"),
            "other": wall(0.8, LENGTH, 3.0, material="m", base=[10.0, 0.0, 0.0]),
        },
        mechanisms=mechanisms | ({"free": lines(block("other", direction=[1, 0, 0]))} if stands else {}),
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    return folder / "project.toml"


def test_it_fails_with_its_multiplier_and_the_others_keep_their_answers(tmp_path: Path) -> None:
    """By hand about the hinge: (W t / 2 - F h) / (W H / 2) = (132.4 * 0.25 - 60 * 4.5) / (132.4 * 2.5) = -0.716."""
    weight = DENSITY * 9.80665 * THICKNESS * LENGTH * HEIGHT
    multiplier = (weight * THICKNESS / 2 - PUSH * UP) / (weight * HEIGHT / 2)
    results = run_study(build(load(project(tmp_path, stands=True))), jobs=1)
    (falling,) = results.falling
    assert falling.uplift_multiplier == pytest.approx(multiplier, rel=1e-9)
    assert results.verdict is not None
    free, pushed = results.verdict.mechanisms
    assert (results.verdict.outcome, free.outcome, pushed.outcome) == (Decision.FAIL, Decision.PASS, Decision.FAIL)
    assert (pushed.mechanism, pushed.margin) == ("pushed", 0.0)
    assert "-0.716" in pushed.answers[0].reason.text


def test_a_building_of_which_everything_falls_fails(tmp_path: Path) -> None:
    study = build(load(project(tmp_path, stands=False)))
    assert (study.mechanisms, [each.name for each in study.falling]) == ((), ["pushed"])
    assert find_verdict(study).outcome == Decision.FAIL
    assert run_study(study, jobs=1).verdict == find_verdict(study)


def test_results_with_a_falling_mechanism_are_read_as_they_were_written(tmp_path: Path) -> None:
    results = run_study(build(load(project(tmp_path, stands=True))), jobs=1)
    (tmp_path / "results.json").write_text(dumps(results), encoding="utf-8")
    assert read(tmp_path / "results.json") == results
