"""A report as data: sections of text, tables, figures and calculation sheets, before anyone has drawn a page.

All text is plain text, never markup; the renderers escape it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawn

Cell = float | int | str | bool | None
Kind = Literal["text", "number", "given", "verdict"]


@dataclass(frozen=True)
class Column:
    """One column of a table.

    kind : "text"; "number" to three figures, right-aligned; "given" to the figures and in the words it was given
    with; "verdict"
    """

    label: str
    unit: str = ""
    kind: Kind = "text"

    @property
    def heading(self) -> str:
        """Label and unit, as shown above the column."""
        return f"{self.label} [{self.unit}]" if self.unit else self.label


@dataclass(frozen=True)
class Text:
    """Paragraphs of plain text."""

    paragraphs: tuple[str, ...]


@dataclass(frozen=True)
class Items:
    """A list of points."""

    points: tuple[str, ...]


@dataclass(frozen=True)
class Code:
    """Lines to be copied letter for letter, as of a project file."""

    lines: tuple[str, ...]


@dataclass(frozen=True)
class Table:
    """A table of raw values. name: unique, safe as a file name; muted: rows for information only."""

    name: str
    caption: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]
    muted: frozenset[int] = frozenset()


Place = tuple[float, float, float]


@dataclass(frozen=True)
class Part:
    """The faces of a model that share a colour ("#rrggbb"): indices of vertices, anticlockwise seen from outside."""

    colour: str
    triangles: tuple[tuple[int, int, int], ...]


@dataclass(frozen=True)
class Wire:
    """A line through points [m] over a model, with its name at its last end; empty for none."""

    points: tuple[Place, ...]
    colour: str
    name: str = ""
    dashed: bool = False
    arrow: bool = False


@dataclass(frozen=True)
class Model:
    """Bodies in space [m], z upwards, for renderers on which a reader can turn them.

    edge : colour of the edges that are drawn
    sharp : angle between faces from which on their common edge is drawn [rad]
    eye : where the model is first seen from: azimuth from +x towards +y, elevation [rad]
    """

    vertices: tuple[Place, ...]
    parts: tuple[Part, ...]
    wires: tuple[Wire, ...]
    edge: str
    sharp: float
    eye: tuple[float, float]


@dataclass(frozen=True)
class Figure:
    """A figure that can be drawn any number of times. name: unique, safe as a file name; model: of bodies in space."""

    name: str
    caption: str
    draw: Callable[[], Drawn]
    model: Model | None = None


@dataclass(frozen=True)
class Line:
    """One step of a calculation: symbol, clause, formula, formula with numbers, result.

    value : a number, or in words where that is all that is known: "≥ 2475"
    beside : the value in another unit, and that unit
    """

    symbol: str
    description: str
    clause: str
    formula: str
    substituted: str
    value: float | str | None
    unit: str
    beside: tuple[float, str] | None = None


@dataclass(frozen=True)
class Sheet:
    """A calculation sheet. name: unique, safe as a file name."""

    name: str
    caption: str
    lines: tuple[Line, ...]


@dataclass(frozen=True)
class Signatures:
    """Places to sign: (role, name) each; an empty name leaves a line."""

    places: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Banner:
    """The outcome at a glance. near: whether it is at the limit; headline: its meaning in one sentence."""

    verdict: Literal["pass", "fail", "incomplete"]
    headline: str
    near: bool = False

    @property
    def word(self) -> str:
        """The outcome in capitals."""
        return self.verdict.upper() + " AT THE LIMIT" * self.near


SHEET_HEADS = ("Symbol", "Meaning; clause", "Formula; numbers", "Value")
SIGNATURE_HEADS = ("", "Name", "Signature", "Place and date")
Block = Text | Items | Code | Table | Figure | Sheet | Signatures | Banner


def nonempty(table: Table) -> list[Block]:
    """Return the table as blocks: none where it has no rows."""
    return [table] if table.rows else []


@dataclass(frozen=True)
class Section:
    """A heading and the blocks under it. level: 0 for a chapter, 1 for its parts."""

    title: str
    level: int
    blocks: tuple[Block, ...]
    starts_page: bool = False


STAMP = "stamp"


@dataclass(frozen=True)
class Document:
    """A report.

    facts : (label, text) pairs of the title block
    sections : in order; the contents come after the opening section
    data : tables too long to print, for the spreadsheet and the CSV files only
    program : name and version of the program that made it; stamp : of the results that it tells, "" for none
    paper : "A4" or "letter"
    language : of its sentences, as BCP 47 has it: "en", "it"
    verbatim : texts of the user, which are never translated: titles, names, notes, paths
    words : the renderers' own words in the language of the document, by the English ones; absent: English
    units : of the report; its tables, sentences and figures are made in SI and converted when it is written
    """

    title: str
    subject: str
    author: str
    program: str
    paper: Literal["A4", "letter"]
    facts: tuple[tuple[str, str], ...]
    sections: tuple[Section, ...]
    data: tuple[Table, ...]
    language: str = "en"
    verbatim: frozenset[str] = frozenset()
    units: Literal["SI", "US"] = "SI"
    words: Mapping[str, str] = field(default_factory=dict)
    stamp: str = ""

    @property
    def origin(self) -> str:
        """The program, and the stamp of the results."""
        return f"{self.program}, {STAMP} {self.stamp}" if self.stamp else self.program

    def translate(self, text: str) -> str:
        """Return a word of a renderer in the language of the document."""
        return self.words.get(text, text)

    @property
    def blocks(self) -> tuple[Block, ...]:
        """Every block in order of appearance."""
        return tuple(block for section in self.sections for block in section.blocks)

    @property
    def tables(self) -> tuple[Table, ...]:
        """Every table, the printed ones first."""
        return tuple(block for block in self.blocks if isinstance(block, Table)) + self.data

    @property
    def figures(self) -> tuple[Figure, ...]:
        """Every figure."""
        return tuple(block for block in self.blocks if isinstance(block, Figure))

    @property
    def sheets(self) -> tuple[Sheet, ...]:
        """Every calculation sheet."""
        return tuple(block for block in self.blocks if isinstance(block, Sheet))

    @property
    def titles(self) -> dict[tuple[str, str], str]:
        """The titles of figures, tables and sheets, counted as they come: (kind, name) -> "Figure 1"."""
        count: Counter[str] = Counter()
        titles = {}
        for block in self.blocks:
            if isinstance(block, Figure | Table | Sheet):
                kind = type(block).__name__
                count[kind] += 1
                titles[kind, block.name] = f"{self.translate(kind)} {count[kind]}"
        return titles
