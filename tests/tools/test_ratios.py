"""The table of ratios to fixed work names a stage that has become slower, and can be written into the page."""

from __future__ import annotations

from pathlib import Path

from tools.benchmarks.bench_ratios import PAGE, read_last, table, write_page

LAST = {"slow": 2.0, "same": 1.0}


def test_a_stage_that_costs_more_is_named() -> None:
    text = table({"slow": 2.4, "same": 1.14, "new": 5.0}, LAST)
    assert text.splitlines()[2:5] == ["| slow | 2.4 | 2 | 1.20 |", "| same | 1.14 | 1 | 1.14 |", "| new | 5 | - | - |"]
    assert text.splitlines()[-1] == "1.15 times its last figure or more: slow."


def test_none_is_named_where_none_is_slower() -> None:
    assert table({"slow": 2.2, "same": 0.5}, LAST).endswith("No stage has become slower.")


def test_the_page_takes_the_table(tmp_path: Path) -> None:
    page = tmp_path / "speed.md"
    page.write_text(PAGE.read_text(encoding="utf-8"), encoding="utf-8")
    for text in ("| one |", "| two |"):
        write_page(text, page)
        assert text in page.read_text(encoding="utf-8")
    assert "| one |" not in page.read_text(encoding="utf-8")
    assert len(page.read_text(encoding="utf-8")) > 0.9 * len(PAGE.read_text(encoding="utf-8"))


def test_figures_that_are_kept_are_read_back_and_without_any_nothing_is_said_of_speed(tmp_path: Path) -> None:
    kept = tmp_path / "last.csv"
    kept.write_text('"slow, of joints",2.5\nsame,1\n', encoding="utf-8")
    assert read_last(kept) == {"slow, of joints": 2.5, "same": 1.0}
    kept.write_text("", encoding="utf-8")
    assert table({"slow": 2.4}, read_last(kept)).endswith("No figures of a release are kept yet.")
