"""The gallery shows every value of a case beside ours, draws it, and runs a case again only where something changed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from assess.verification.case_files import CaseFile, read_cases
from assess.verification.verify import compare_case
from docs.ext import gallery
from docs.ext.case_figures import difference_share, draw_agreement
from docs.ext.case_pages import Shown, case_page, number

CASE = """
title = "Period of a block"
theory = "A closed form."
field = "Slender blocks."
uses = ["single-block", "rigid"]
solver = "free-rocking"
given = { thickness = 0.2, height = 4.0, tilts = [0.1], equation = "linearised", duration = 40.0 }
source = { citation = "Somebody, S. (1963). A paper", standing = "derived", place = "eq. 7" }
[[quantities]]
name = "p T"
path = "period_p.{row}"
tolerance = { relative = 1e-6, reason = "seven digits are given" }
values = { "0.1" = 1.868581, "0.5" = 5.267832, "0.9" = 11.972892 }
"""
TREE = {"period_p": {"0.1": 1.868581, "0.5": 5.267832, "0.9": 12.5}}


@pytest.fixture
def case(tmp_path) -> CaseFile:
    (tmp_path / "somebody").mkdir()
    (tmp_path / "somebody" / "free.toml").write_text(CASE, encoding="utf-8")
    (found,) = read_cases(tmp_path)
    return found


@pytest.fixture
def result(case):
    return compare_case(case, TREE)


def test_a_page_has_source_values_tolerance_and_file(case, result):
    page = case_page(case, result, [Shown("a.svg", "A figure", half=False)])
    assert "Somebody, S. (1963)" in page
    assert "| 0.1 | 1.868581 | 1.868581 | 0 | 1.9e−06 | pass |" in page
    assert "| 0.9 | 11.97289 | 12.5 | 0.53 | 1.2e−05 | **fail** |" in page
    assert "![A figure](a.svg)" in page
    assert "seven digits are given" in page
    assert 'solver = "free-rocking"' in page


def test_a_page_names_what_is_not_reproduced_and_the_list_has_a_dash_without_a_share(case, result):
    page = case_page(case, replace(result, departures=("the source prints 2, the program gives 3",)), ())
    assert "## Printed and not reproduced\n\n- the source prints 2, the program gives 3" in page
    assert "Printed and not reproduced" not in case_page(case, result, ())
    assert gallery._row("a", result, "a.svg").split(" | ")[3] == f"{max(result.shares):.2f}"
    (quantity,) = result.quantities
    exact = replace(quantity, tolerance=replace(quantity.tolerance, relative=0.0))
    assert gallery._row("a", replace(result, quantities=(exact,)), "a.svg").split(" | ")[3] == "–"
    assert difference_share(exact, exact.values[0]) is None


def test_the_hash_of_the_program_covers_its_data(monkeypatch):
    before = gallery._program()
    monkeypatch.setattr(gallery, "sources_digest", lambda folder: "another")
    assert gallery._program.__wrapped__() != before


def test_the_figure_has_every_value(result):
    over, within = draw_agreement(result).axes
    points = [line.get_xydata()[0] for line in over.lines if line.get_marker() == "o"]
    assert sorted(map(tuple, points)) == [(1.868581, 1.868581), (5.267832, 5.267832), (11.972892, 12.5)]
    shares = [line.get_xdata()[0] for line in within.lines if line.get_marker() == "o"]
    assert sorted(shares) == [0.0, 0.0, 1.5]


def test_a_difference_is_told_in_tolerances(result):
    (quantity,) = result.quantities
    assert difference_share(quantity, quantity.values[2]) == pytest.approx((12.5 - 11.972892) / 11.972892e-6)


def test_a_case_runs_again_only_when_something_changed(case, monkeypatch, tmp_path):
    runs: list[str] = []
    monkeypatch.setattr(gallery, "KEPT", tmp_path / "kept")
    monkeypatch.setattr(gallery, "solve_case", lambda file: runs.append(file.key) or TREE)
    folder = gallery.keep_case(case)
    assert gallery.keep_case(case) == folder
    assert runs == [case.key]
    monkeypatch.setattr(gallery, "_program", lambda: "another")
    assert gallery.keep_case(case) != folder
    assert len(runs) == 2


def test_files_of_a_case_are_its_page_its_figures_and_its_row(case, monkeypatch, tmp_path: Path):
    monkeypatch.setattr(gallery, "KEPT", tmp_path / "kept")
    monkeypatch.setattr(gallery, "solve_case", lambda file: TREE)
    names = {path.name for path in gallery.keep_case(case).iterdir()}
    page = gallery.page_name(case)
    assert names == {f"{page}.md", f"{page}-agreement.svg", "row.txt"}


def test_numbers_are_written_with_a_minus():
    assert (number(-0.00012, digits=2), number(None)) == ("−0.00012", "–")
