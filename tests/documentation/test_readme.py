"""README.md: its Python runs as it stands, and gives the values that its shell and its file give."""

from __future__ import annotations

import re
from math import isnan
from typing import Any

import pytest

from assess.cli.tables.analysis import run_text
from records.processing import at2_text
from tests.support.motions import noise
from tests.support.places import fenced, text_of

PAGE = text_of("README.md")


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The names of a Python session in which every block was typed, beside its project file and its record."""
    folder, names = tmp_path_factory.mktemp("readme"), {}
    (folder / "wall").mkdir()
    (folder / "wall" / "project.toml").write_text(next(fenced(PAGE, "toml"))[1], encoding="utf-8")
    (folder / "RSN753.AT2").write_text(at2_text(noise(npts=2000, peak=2.0)), encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        for _, text in fenced(PAGE, "python"):
            exec(text, names)
    return names | {"folder": folder}


def test_python_and_the_project_file_have_the_same_wall(session):
    found, file = session["block"].oscillator, session["run"].results.mechanisms[0].oscillator
    assert (found.p, found.slenderness, found.multiplier) == (
        file.p_eq_per_s, file.slenderness_rad, file.uplift_multiplier
    )  # fmt: skip


def test_the_motion_and_the_answers_are_there(session):
    motion = session["motion"]
    assert isnan(motion.max_ratio) if motion.overturned else motion.max_ratio > 0.0
    assert [check.procedure for check in session["answers"]] == ["ntc2018-nonlinear"]


def test_the_shell_prints_what_the_run_gives(session):
    printed = run_text(session["run"].results).splitlines()
    shown = re.findall(r"^ {4}((?:mechanism|overturning)\b.*)$", PAGE, re.MULTILINE)
    assert len(shown) == 2
    assert [line for line in shown if line not in printed] == []


def test_the_report_is_written(session):
    assert (session["folder"] / "report" / "report.pdf").is_file()
    assert not session["run"].table("checks").empty


@pytest.mark.parametrize("page", ["fragility", "risk", "uncertainty", "portfolio", "portfolio-tables", "records"])
def test_readme_leads_to_what_goes_beyond_one_verdict(page: str) -> None:
    assert f"(docs/{page}.md)" in PAGE.partition("## Where to read on")[2]


@pytest.mark.parametrize(
    "command", ["assess fragility", "assess batch", "assess records select", "analysis.uncertainty"]
)
def test_readme_names_the_commands(command: str) -> None:
    answers = PAGE.partition("## What it answers")[2].partition("## Where to read on")[0]
    assert f"`{command}" in answers or f"`[{command}]`" in answers
