"""The verdict alone is that of the whole run, of every shipped example and where histories decide."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from assess.codes.verdict import Verdict
from assess.examples import EXAMPLES, copy_example
from assess.project.build import build, build_to_decide
from assess.project.project_file import load
from assess.study import run
from assess.study.run import find_verdict, run_study
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
