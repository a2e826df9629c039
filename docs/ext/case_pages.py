"""The page of a solved case: its source, its figures, every value beside the program's, and its files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

from assess.examples import source
from assess.project.project_file import FILE_NAME
from assess.results.verification import CaseResult, QuantityResult, ValueResult
from assess.verification.case_files import CaseFile
from docs.ext.markdown import cell, escape

SHOWN = {".toml": "toml", ".csv": "text"}  # files that are shown, as what
LONGEST = 20_000  # bytes of a file that is shown
OUTCOMES = {"pass": "pass", "misprint": "misprint", "fail": "**fail**"}


@dataclass(frozen=True)
class Shown:
    """A figure of a page: the name of its file beside the page, its caption, and whether it takes half the width."""

    name: str
    caption: str
    half: bool


def case_page(file: CaseFile, result: CaseResult, figures: Sequence[Shown]) -> str:
    """Return the page of a case as Markdown."""
    uses = ", ".join(f"`{use}`" for use in result.uses)
    return "\n".join(
        (
            f"# {escape(result.title)}",
            "",
            f"**Source.** {escape(result.source.citation)}. The values are {result.source.standing}: "
            f"{escape(result.source.place)}.",
            "",
            f"**Theory.** {escape(result.theory)}",
            "",
            f"**Field of use.** {escape(result.field)}",
            "",
            f"**Uses.** {uses}. Run it again with `assess verify`; the key of the case is `{result.key}`.",
            "",
            *(_row_of_figures(tuple(each)) for _, each in groupby(figures, key=lambda figure: figure.half)),
            *(_quantity(each) for each in result.quantities),
            *_departures(result),
            *_fault(result),
            "## To run it again",
            "",
            *(_file(path) for path in (*file.paths, *_example(file))),
        )
    )


def _row_of_figures(figures: Sequence[Shown]) -> str:
    """Return figures of one width, those of half a page side by side."""
    shown = [f"![{escape(each.caption)}]({each.name})\n\n*{escape(each.caption)}*\n" for each in figures]
    if not figures[0].half:
        return "\n".join(shown)
    return "\n".join(
        (":::::{container} pair\n", *(f"::::{{container}} one\n{each}::::\n" for each in shown), ":::::\n")
    )


def _example(file: CaseFile) -> tuple[Path, ...]:
    """Return the project file of a shipped example that the case runs; nothing of other cases."""
    name = file.case.given.get("example")
    return () if name is None else (source(name) / FILE_NAME,)


def _quantity(quantity: QuantityResult) -> str:
    unit = f" [{quantity.unit}]" if quantity.unit else ""
    rows = [_row(quantity, value) for value in quantity.values]
    notes = [f"{value.row}: {value.misprint}" for value in quantity.values if value.misprint]
    return "\n".join(
        (
            f"## {escape(quantity.name + unit)}",
            "",
            "| | source | program | difference | tolerance | |",
            "|---|--:|--:|--:|--:|---|",
            *rows,
            "",
            f"Tolerance: {escape(quantity.tolerance.reason)}.",
            "",
            *(f"{escape(note)}.\n" for note in notes),
        )
    )


def _row(quantity: QuantityResult, value: ValueResult) -> str:
    read = "" if value.reading is None else f" ({number(value.reference)})"
    cells = (
        cell(escape(value.row)),
        f"{number(value.expected)}{read}",
        number(value.found),
        number(value.difference, digits=2),
        number(quantity.tolerance.around(value.reference), digits=2),
        OUTCOMES[value.outcome],
    )
    return f"| {' | '.join(cells)} |"


def number(value: float | None, *, digits: int = 7) -> str:
    """Return a number with so many significant digits; a dash for none."""
    return "–" if value is None else f"{value:.{digits}g}".replace("-", "−")


def _departures(result: CaseResult) -> list[str]:
    """Return what the source prints and the program does not give; nothing where there is none."""
    lines = [f"- {escape(each)}" for each in result.departures]
    return ["## Printed and not reproduced", "", *lines, ""] if lines else []


def _fault(result: CaseResult) -> list[str]:
    return [f"It could not be run: {escape(result.fault)}", ""] if result.fault else []


def _file(path: Path) -> str:
    """Return a file as a box that opens; of records and meshes the name and size."""
    if path.suffix not in SHOWN or path.stat().st_size > LONGEST:
        return f"- `{path.name}`, {path.stat().st_size / 1000:.0f} kB\n"
    text = path.read_text(encoding="utf-8").rstrip()
    return (
        f"<details><summary><code>{path.name}</code></summary>\n\n```{SHOWN[path.suffix]}\n{text}\n```\n\n</details>\n"
    )
