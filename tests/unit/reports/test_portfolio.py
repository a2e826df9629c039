"""The ranked table of a portfolio as CSV, workbook and page: every row once, in order, inert, with its links."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import pytest
from openpyxl import load_workbook

from assess.portfolio.tasks import ProjectRow
from reports.figures.portfolio import draw_margins
from reports.language.locale import Locale, languages
from reports.portfolio import FILES, write_ranking

HOSTILE = ('=HYPERLINK("http://x")', "<script>alert(1)</script>", "@SUM(A1)", "a\nb", "x" * 500)
ROWS = (
    ProjectRow("b", "Second", "2", "done", "", "pass", "ntc2018", "SLV", "wall", 1.5, 2 / 3, "ntc2018-nonlinear", 0, 1),
    ProjectRow("a", "First", "1", "done", "", "fail", "ntc2018", "SLV", "wall", 0.5, 2.0, "ntc2018-nonlinear", 0, 1,
        report="a #1?/report.html", results='a" onclick="x/results.json'),
    ProjectRow("c", "Open", "3", "done", outcome="incomplete", missing=2, mechanisms=1),
    *(ProjectRow(text, text, "4", "broken", reason=f"{text}: not a length", exit_code=2) for text in HOSTILE),
)  # fmt: skip


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("ranked")
    assert [path.name for path in write_ranking(ROWS, folder)] == list(FILES)
    return folder


def test_csv_has_every_row_in_order_at_full_precision(written: Path) -> None:
    with (written / "ranked.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["Project"] for row in rows[:3]] == ["a", "c", "b"]
    assert [row["Outcome"] for row in rows] == ["fail", "incomplete", "pass", *["broken"] * len(HOSTILE)]
    assert float(rows[2]["D/C [-]"]) == 2 / 3
    assert rows[0]["Report"] == "a #1?/report.html"
    assert not any(cell.startswith(("=", "@")) for row in rows for cell in row.values())


def test_workbook_has_filters_a_frozen_head_links_and_no_formula(written: Path) -> None:
    sheet = load_workbook(written / "ranked.xlsx").active
    assert sheet.title == "ranked"
    assert sheet.auto_filter.ref == f"A2:N{len(ROWS) + 2}"
    assert sheet.freeze_panes == "B3"
    assert {cell.data_type for row in sheet.iter_rows() for cell in row} <= {"s", "n", "inlineStr"}
    targets = [cell.hyperlink.target for row in sheet.iter_rows() for cell in row if cell.hyperlink]
    assert len(targets) == 2
    assert targets[0].replace("\\", "/") == "a%20%231%3F/report.html"


def test_page_is_whole_and_inert(written: Path) -> None:
    text = (written / "ranked.html").read_text(encoding="utf-8")
    assert "<script>alert" not in text
    assert not re.search(r'(src|href)="(?!data:|#|\./)', text)
    assert 'href="./a%20%231%3F/report.html"' in text
    assert 'href="./a%22%20onclick%3D%22x/results.json"' in text
    assert text.count("<tr") == len(ROWS) + 1


def test_same_rows_in_any_order_are_the_same_bytes(written: Path, tmp_path: Path) -> None:
    for path in write_ranking(ROWS[::-1], tmp_path):
        assert path.read_bytes() == (written / path.name).read_bytes()


@pytest.mark.parametrize("language", languages())
def test_empty_and_single_portfolios_are_written_in_every_language(language: str, tmp_path: Path) -> None:
    for rows in ((), ROWS[:1]):
        write_ranking(rows, tmp_path, language=language)
        text = (tmp_path / "ranked.html").read_text(encoding="utf-8")
        assert f'<html lang="{language}">' in text


def test_numbers_of_a_long_table_are_shown_to_three_figures(tmp_path: Path) -> None:
    write_ranking(
        [ProjectRow(f"{n}", "", "", "done", outcome="pass", margin=1 + 1 / (n + 3)) for n in range(600)], tmp_path
    )
    sheet = load_workbook(tmp_path / "ranked.xlsx")["ranked"]
    assert sheet["D300"].number_format == "0.00"


def test_margins_are_counted_in_bars(tmp_path: Path) -> None:
    """0.05, 0.3 and 0.99 fail; 1.0 is the first that passes; what is 2 and more stands in the last bar."""
    margins = [0.05, 0.3, 0.99, 1.0, 2.0, 7.5]
    bars = draw_margins(margins, Locale()).axes[0].patches
    counted = {round(bar.get_x(), 1): int(bar.get_height()) for bar in bars if bar.get_height()}  # type: ignore[attr-defined]
    assert counted == {0.0: 1, 0.3: 1, 0.9: 1, 1.0: 1, 2.0: 2}
    rows = [ProjectRow(f"{margin}", "", "", "done", outcome="pass", margin=margin) for margin in margins]
    write_ranking(rows, tmp_path)
    assert (tmp_path / "ranked.html").read_text(encoding="utf-8").count("<figure") == 1
