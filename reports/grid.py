"""Tables and calculation sheets on the page: column widths, captions that repeat, rows that split over pages."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from reportlab.lib.colors import HexColor
from reportlab.platypus import Paragraph
from reportlab.platypus import Table as Grid

from reports.document import SHEET_HEADS, Cell, Column, Line, Sheet, Table
from reports.lettering import shortened
from reports.numerals import outcome, shown
from reports.page import only_measured
from reports.style import GRID, INK, MUTED
from reports.typeset import SMALL, STYLES, Lines, Plain, formula, markup, paragraph, width_of
from reports.worded import in_words

LONGEST = 400  # characters in a cell; the whole text stands in the CSV file and the spreadsheet
_LONGEST_STEP = 700
_PADDING, _NARROW, _WIDE = 5.0, 112.0, 240.0
_SHARES = (0.13, 0.35, 0.35, 0.17)
_LOOK: list[Any] = [
    ("VALIGN", (0, 0), (-1, -1), "TOP"),
    ("LEFTPADDING", (0, 0), (-1, -1), _PADDING / 2),
    ("RIGHTPADDING", (0, 0), (-1, -1), _PADDING / 2),
    ("TOPPADDING", (0, 0), (-1, -1), 1.6),
    ("BOTTOMPADDING", (0, 0), (-1, -1), 2.2),
    ("SPAN", (0, 0), (-1, 0)),
    ("BOTTOMPADDING", (0, 0), (-1, 0), 4),
    ("LEFTPADDING", (0, 0), (-1, 0), 0),
    ("BACKGROUND", (0, 1), (-1, 1), HexColor("#edf0f3")),
    ("LINEABOVE", (0, 1), (-1, 1), 0.8, HexColor(INK)),
    ("LINEBELOW", (0, 1), (-1, 1), 0.5, HexColor(MUTED)),
    ("LINEBELOW", (0, 2), (-1, -1), 0.3, HexColor(GRID)),
    ("NOSPLIT", (0, 0), (-1, 3)),
    ("NOSPLIT", (0, -3), (-1, -1)),
    ("LINEBELOW", (0, -1), (-1, -1), 0.5, HexColor(MUTED)),
]


class _Grid(Grid):
    """A table that is drawn only where it is kept: most of a report's time goes into cells."""

    def draw(self) -> None:
        if not only_measured(self.canv):
            self.canv.saveState()
            super().draw()
            self.canv.restoreState()


def table_grid(table: Table, *, title: str, width: float, said: Callable[[str], str] = str) -> Grid:
    """A table under its caption, `width` [pt] wide or as narrow as its text; caption and head repeat on each page.

    said : how verdicts, yes and no are said in the language of the document
    """
    texts = [[_text(cell, column, said) for cell, column in zip(row, table.columns, strict=True)] for row in table.rows]
    size = "" if sum(least_widths(table.columns, texts)) <= width else SMALL
    widths = column_widths(table.columns, texts, width, size=size)
    body = [
        [
            _cell(raw, text, column, muted=place in table.muted, size=size)
            for raw, text, column in zip(row, line, table.columns, strict=True)
        ]
        for place, (row, line) in enumerate(zip(table.rows, texts, strict=True))
    ]
    head = [Plain(c.heading, f"head-number{size}" if c.kind == "number" else f"head{size}") for c in table.columns]
    return _grid(f"{title}. {table.caption}", [head, *body], widths)


def sheet_grid(sheet: Sheet, *, title: str, width: float, said: Callable[[str], str] = str) -> Grid:
    """A calculation sheet: symbol; meaning and clause; formula and numbers; value and unit."""
    head = [Plain(text, "head") for text in map(said, SHEET_HEADS)]
    body = [_step(line) for line in sheet.lines]
    return _grid(f"{title}. {sheet.caption}", [head, *body], [share * width for share in _SHARES])


def column_widths(columns: tuple[Column, ...], texts: list[list[str]], width: float, *, size: str = "") -> list[float]:
    """Widths [pt] that keep words whole where there is room, and add up to no more than `width`."""
    least, natural = least_widths(columns, texts, size=size), []
    for place, column in enumerate(columns):
        lines = [1.02 * width_of(line, f"cell{size}") for line in {line[place] for line in texts}]
        head = 0.6 * width_of(column.heading, f"head{size}")
        natural.append(max(least[place], _PADDING + 1 + min(_WIDE, max([head, *lines]))))
    return _shared(least, natural, width)


def least_widths(columns: tuple[Column, ...], texts: list[list[str]], *, size: str = "") -> list[float]:
    """Widths [pt] below which words break; size: "" or `SMALL`, the ending of the styles."""
    least = []
    for place, column in enumerate(columns):
        words = [width_of(word, f"head{size}") for word in column.heading.split()]
        style = f"head{size}" if column.kind == "verdict" else f"cell{size}"
        inside = [1.02 * width_of(word, style) for line in {line[place] for line in texts} for word in line.split()]
        least.append(_PADDING + 1 + max([*words, min(_NARROW, max(inside, default=0.0))]))
    return least


def _shared(least: list[float], natural: list[float], width: float) -> list[float]:
    if sum(natural) <= width:
        return [value * min(1.25, width / sum(natural)) for value in natural]
    if sum(least) >= width:
        cap = _cap(least, width)
        return [min(value, cap) for value in least]
    spare = (width - sum(least)) / (sum(natural) - sum(least))
    return [low + spare * (high - low) for low, high in zip(least, natural, strict=True)]


def _cap(widths: list[float], total: float) -> float:
    """What the widest may have so that all together have `total`."""
    rest = total
    for place, narrow in enumerate(sorted(widths)):
        share = rest / (len(widths) - place)
        if narrow > share:
            return share
        rest -= narrow
    return max(widths)


def _grid(caption: str, rows: Sequence[list[Any]], widths: list[float]) -> Grid:
    first: list[Paragraph | str] = [paragraph(shortened(caption, 400), "caption"), *[""] * (len(widths) - 1)]
    grid = _Grid([first, *rows], colWidths=widths, repeatRows=2, hAlign="LEFT", spaceBefore=4, spaceAfter=11)
    grid.setStyle(_LOOK)
    return grid


def _text(cell: Cell, column: Column, said: Callable[[str], str]) -> str:
    return shortened(shown(in_words(cell, column, said), column.kind), LONGEST)


def _cell(raw: Cell, text: str, column: Column, *, muted: bool, size: str) -> Plain:
    right = "number" if column.kind == "number" else ""
    if muted:
        return Plain(text, f"muted-number{size}" if right else f"muted{size}")
    coloured = column.kind == "verdict" and raw in ("pass", "fail")
    return Plain(text, f"{raw if coloured else right or 'cell'}{size}")


def _step(line: Line) -> list[Paragraph]:
    clause = f'<br/><font color="{MUTED}">{_markup(line.clause)}</font>' if line.clause else ""
    numbers = f"<br/>= {_formula(line.substituted)}" if line.substituted else ""
    value = _markup(outcome(line.value, line.unit))
    what = (_formula(line.symbol), f"{_formula(line.description)}{clause}")
    how = (f"{_formula(line.formula)}{numbers}", value)
    return [Lines(cell, STYLES["cell"]) for cell in (*what, *how)]


def _formula(text: str) -> str:
    return formula(shortened(text, _LONGEST_STEP))


def _markup(text: str) -> str:
    return markup(shortened(text, _LONGEST_STEP))
