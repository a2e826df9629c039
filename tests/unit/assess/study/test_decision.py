"""The verdict alone is that of the whole run, of every shipped example and where histories decide."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from assess.codes.verdict import Verdict
from assess.examples import EXAMPLES, copy_example
from assess.portfolio.projects import Task
from assess.portfolio.tasks import Job, ProjectRow, row_of_verdict
from assess.project.build import build, build_to_decide
from assess.project.project_file import load
from assess.study import run
from assess.study.run import find_outcome, find_verdict, run_study
from assess.study.suites import motions_of
from tests.support.projects import NTC, project_toml


def without_limit(found: Verdict | None) -> Verdict:
    """Return a verdict without what the tolerance of the survey may tell."""
    assert found is not None
    mechanisms = tuple(
        replace(one, at_the_limit=False, answers=tuple(replace(each, at_the_limit=False) for each in one.answers))
        for one in found.mechanisms
    )
    return replace(found, at_the_limit=False, mechanisms=mechanisms)


def row_of(found: Verdict | None, folder: Path) -> ProjectRow:
    """Return the row of a portfolio that a verdict gives."""
    return row_of_verdict(Job(Task("wall", "Wall", folder / "project.toml", None, ""), folder, "rows", ""), found)


@pytest.mark.study
@pytest.mark.parametrize("name", EXAMPLES)
def test_verdict_alone_is_that_of_the_run(name: str, tmp_path: Path) -> None:
    if EXAMPLES[name].models():
        pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    project = replace(load(copy_example(name, tmp_path / name)), sweeps=())
    study = replace(build(project), pulses=None, variables=())
    assert without_limit(find_verdict(build_to_decide(project))) == without_limit(run_study(study).verdict)


@pytest.mark.parametrize(
    ("verdict", "asked", "scan"),
    [
        ({}, False, True),
        ({"basis": "ntc2018", "limit_state": "SLV", "procedures": ["ntc2018-history"]}, True, True),
        ({"basis": "ntc2018", "limit_state": "SLV", "procedures": ["ntc2018-history"]}, True, False),
        ({"basis": "asce43-05", "procedures": ["asce43-05-history"]}, True, True),
        ({"basis": "asce43-05", "procedures": ["asce43-05-history"]}, True, False),
    ],
)
def test_motions_are_made_where_they_decide_alone(
    verdict: dict[str, object], asked: bool, scan: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "project.toml").write_text(
        project_toml(
            site={"spectrum": NTC, "limit_state": "SLV"},
            materials={"brick": {"density": 1800, "disintegration": "excluded"}},
            records={"synthetic": {"count": 3, "duration": "10 s"}},
            verdict={**verdict, "survey_tolerance": 0.0},
            building={"ground_elevation": 0},
            analysis={"scan": scan},
            report={"sources": {"materials.brick.disintegration": "measured: one opening"}},
        )
    )
    project = load(tmp_path)
    whole, made = run_study(build(project)).verdict, []
    monkeypatch.setattr(run, "motions_of", lambda *given, **more: made.append(1) or motions_of(*given, **more))
    assert find_verdict(build_to_decide(project)) == whole
    assert bool(made) is asked
    assert row_of(find_outcome(build_to_decide(project)), tmp_path) == row_of(whole, tmp_path)


@pytest.mark.parametrize(("thickness", "sides"), [(0.2, "one"), (0.38, "one"), (0.7, "two")])
@pytest.mark.parametrize(("basis", "state"), [("ntc2018", "SLV"), ("asce43-05", "DBE")])
def test_row_of_the_outcome_alone_is_that_of_the_verdict(
    thickness: float, sides: str, basis: str, state: str, tmp_path: Path
) -> None:
    """By histories with their scan, of walls that fail and that stand."""
    (tmp_path / "project.toml").write_text(
        project_toml(
            site={"spectrum": {**NTC, "a_g": "0.2 g"}, "limit_state": state},
            materials={"brick": {"density": 1800, "disintegration": "excluded"}},
            bodies={"wall": {"material": "brick", "box": {"thickness": thickness, "length": 3, "height": 6}}},
            mechanisms={"wall": {"kind": "single-block", "blocks": ["wall"], "direction": [1, 0, 0], "sides": sides}},
            records={"synthetic": {"count": 7, "duration": "25 s"}},
            verdict={"basis": basis, "limit_state": state, "procedures": [f"{basis}-history"]},
            building={"ground_elevation": 0},
            report={"sources": {"materials.brick.disintegration": "measured: one opening"}},
        )
    )
    study = build_to_decide(load(tmp_path))
    assert row_of(find_outcome(study), tmp_path) == row_of(find_verdict(study), tmp_path)
