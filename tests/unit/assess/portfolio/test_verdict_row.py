"""The row of a project tells of its worst mechanism, and is the same without a report as with one."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from assess.codes.question import Action
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.messages.message import message
from assess.portfolio.projects import Task
from assess.portfolio.tasks import Job, Keep, folder_name, row_of_verdict
from assess.project import build
from assess.verbs import assess_project
from tests.support.honest_projects import SURVEY, honest
from tests.support.honest_projects import block as block_of
from tests.support.honest_projects import wall as wall_of
from tests.support.portfolios import task
from tests.support.projects import NTC, block, project_toml, wall
from tools.adversary.projects import ITALY

SAID = message("missing-key", {"key": "site", "text": "why"}, where="site")


def answer(outcome: Decision, ratio: float | None, state: str = "SLV") -> Answer:
    return Answer(state, outcome, "ntc2018-nonlinear", ratio, None, SAID)


def verdict(*mechanisms: MechanismVerdict) -> Verdict:
    outcome = mechanisms[0].outcome
    return Verdict("ntc2018", "", Action(0.15, "SLV"), 1.0, outcome, False, (), (), mechanisms)


def mechanism(name: str, outcome: Decision, margin: float | None, *answers: Answer) -> MechanismVerdict:
    return MechanismVerdict(name, outcome, margin, False, answers)


@pytest.mark.parametrize("turned", [False, True])
def test_the_worst_mechanism_fails_with_the_least_margin(turned: bool) -> None:
    fail, wanting, good = Decision.FAIL, Decision.INCOMPLETE, Decision.PASS
    mechanisms = [
        mechanism("worst", fail, 0.4, answer(good, 0.2, "SLD"), answer(fail, 2.5), answer(fail, 2.0, "SLC")),
        mechanism("better", fail, 0.7, answer(fail, 1.4)),
        mechanism("unknown", fail, None, answer(fail, None)),
        mechanism("wanting", wanting, 0.1, answer(wanting, None)),
        mechanism("good", good, 1.2, answer(good, 0.8)),
    ]
    found = replace(verdict(*mechanisms), mechanisms=tuple(mechanisms[::-1] if turned else mechanisms))
    row = row_of_verdict(Job(task("a"), Path(), "rows", ""), found)
    assert (row.worst_mechanism, row.margin, row.demand_capacity, row.limit_state) == ("worst", 0.4, 2.5, "SLV")
    assert (row.outcome, row.exit_code, row.mechanisms) == ("fail", 1, 5)


def test_without_a_verdict_or_a_mechanism_it_is_incomplete() -> None:
    job = Job(task("a"), Path(), "rows", "")
    assert row_of_verdict(job, None).exit_code == 3
    row = row_of_verdict(job, replace(verdict(mechanism("a", Decision.PASS, 1.0)), mechanisms=()))
    assert (row.worst_mechanism, row.margin) == ("", None)


def test_the_row_alone_is_the_row_of_a_full_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is built and computed as far as the verdict depends on it: the study as a whole is built once."""
    built: list[Path] = []
    whole_study = build.study_of
    monkeypatch.setattr(build, "study_of", lambda *one, **more: built.append(one[0].path) or whole_study(*one, **more))
    text = project_toml(
        site={"limit_state": "SLV", "spectrum": NTC},
        bodies={"low": wall(0.4, height=3.0), "high": wall(0.4, height=6.0)},
        mechanisms={"low": block("low"), "high": block("high")},
    )
    (tmp_path / "project.toml").write_text(text)
    one = Task("Two walls", "", tmp_path / "project.toml", None, "")
    alone, whole = (assess_project(Job(one, tmp_path / "out", keep, "")) for keep in ("rows", "results"))
    place = folder_name("Two walls")
    assert len(built) == 1
    assert whole == replace(alone, results=f"{place}/results.json")
    assert (tmp_path / "out" / place / "results.json").is_file()
    assert alone.worst_mechanism == "high"


@pytest.mark.parametrize("keep", ["rows", "results"])
@pytest.mark.parametrize("sourced", [False, True])
def test_a_row_that_hangs_on_a_value_without_a_source_is_that_of_the_worse_state(
    tmp_path: Path, keep: Keep, sourced: bool
) -> None:
    """A stiff joint: with its source a pass, of which the row need not tell; without it a fail that names it."""
    joint = {"model": "flexible", "stiffness": "100 GPa/m"}
    project = honest("ntc2018", ITALY | {"a_g": "0.22 g"}, wall_of(0.6, 3.0), block_of(interface=joint))
    if sourced:
        project["report"]["sources"]["mechanisms.wall.interface"] = SURVEY
    (tmp_path / "project.toml").write_text(project_toml(**project))
    one = Task("Tied", "", tmp_path / "project.toml", None, "")
    row = assess_project(Job(one, tmp_path / "out", keep, ""))
    assert row.outcome == ("pass" if sourced else "fail")
    assert row.unsourced == ("" if sourced else "mechanisms.wall.interface.stiffness")


@pytest.mark.parametrize("keep", ["rows", "results"])
def test_a_row_counts_the_warnings_on_its_input(tmp_path: Path, keep: Keep) -> None:
    """A wall of 600 m is computed as it is given; in the table nothing else would say that its unit may be wrong."""
    for height, warned in ((6.0, False), (600.0, True)):
        text = project_toml(
            site={"limit_state": "SLV", "spectrum": NTC}, bodies={"high": wall(0.4, height=height)},
            mechanisms={"high": block("high")}, records={"synthetic": {"count": 1, "duration": "25 s"}},
        )  # fmt: skip
        (tmp_path / "project.toml").write_text(text)
        one = Task("One wall", "", tmp_path / "project.toml", None, "")
        assert (assess_project(Job(one, tmp_path / "out", keep, "")).warnings > 0) is warned
