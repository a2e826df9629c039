"""A report as data: sections of text, tables, figures and calculation sheets, before anyone has drawn a page.

No block has a language or a unit system: its texts are those of `reports.language.texts`, its numbers are in SI. The
renderers turn both into letters by a `Locale`, and escape them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, TypeVar
from urllib.parse import quote

from assess.codes.calculation_sheet import Step
from reports.language.locale import Locale
from reports.language.texts import Kind, Phrase, Text, Verbatim

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawn

OutcomeColour = Literal["pass", "fail", "incomplete", "comparison"]


@dataclass(frozen=True)
class OutcomeCell:
    """A cell coloured by an outcome; "comparison" for an answer that does not decide."""

    outcome: OutcomeColour
    text: Text


@dataclass(frozen=True)
class Link:
    """A cell that leads to a file. path: of the file, relative to the document, with slashes."""

    text: Text
    path: str

    @property
    def address(self) -> str:
        """The path as an address within this folder: no scheme, no markup, no break."""
        return f"./{quote(self.path.lstrip('/'), errors='replace')}"


Cell = Text | OutcomeCell | Link | float | int | bool | None
"""A number is in SI, of the dimension of its column; a `Quantity` shows its own unit; None is a dash."""


@dataclass(frozen=True)
class Column:
    """One column of a table.

    dimension : of its numbers, a key of `reports.language.locale.UNITS`, shown in the heading; "" for text
    figures : significant figures of its numbers
    share : of the width of the table, 0 to share what is left by the length of its cells
    """

    label: Text
    dimension: str = ""
    figures: int = 4
    share: float = 0.0


@dataclass(frozen=True)
class Prose:
    """Paragraphs."""

    paragraphs: tuple[Text, ...]


@dataclass(frozen=True)
class BulletList:
    """A list of points."""

    points: tuple[Text, ...]


@dataclass(frozen=True)
class FileLines:
    """Lines to be copied letter for letter, as of a project file."""

    lines: tuple[str, ...]


@dataclass(frozen=True)
class Table:
    """A table.

    name : unique, safe as a file name
    muted : rows for information only; small : set in smaller letters
    sifted : whether a page offers to show the rows of one outcome only, or those with some words
    """

    name: str
    caption: Text
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]
    muted: frozenset[int] = frozenset()
    small: bool = False
    sifted: bool = False


Item = TypeVar("Item")
Whole = TypeVar("Whole")
Value = TypeVar("Value")
Field = tuple[Column, Callable[[Item], Cell]]
"""A column of a table, with what its cell is for an item."""


Point = tuple[float, float, float]


@dataclass(frozen=True)
class ColouredFaces:
    """The faces of a model that share a colour ("#rrggbb"): indices of vertices, anticlockwise seen from outside."""

    colour: str
    triangles: tuple[tuple[int, int, int], ...]


@dataclass(frozen=True)
class Wire:
    """A line through points [m] over a model, with its name at its last end; empty for none."""

    points: tuple[Point, ...]
    colour: str
    name: str = ""
    dashed: bool = False
    arrow: bool = False


@dataclass(frozen=True)
class SpatialModel:
    """Bodies in space [m], z upwards, for renderers on which a reader can turn them.

    edge : colour of the edges that are drawn
    sharp : angle between faces from which on their common edge is drawn [rad]
    eye : where the model is first seen from: azimuth from +x towards +y, elevation [rad]
    """

    vertices: tuple[Point, ...]
    parts: tuple[ColouredFaces, ...]
    wires: tuple[Wire, ...]
    edge: str
    sharp: float
    eye: tuple[float, float]


@dataclass(frozen=True)
class Figure:
    """A figure that can be drawn any number of times, in any language and units.

    name : unique, safe as a file name
    draw : draws it; a function of a module or a `partial` of one, so that another process can call it
    model : of bodies in space
    """

    name: str
    caption: Text
    draw: Callable[[Locale], Drawn]
    model: SpatialModel | None = None


@dataclass(frozen=True)
class FigureRow:
    """Figures side by side, each with its caption below."""

    figures: tuple[Figure, ...]


@dataclass(frozen=True)
class Photograph:
    """A picture of the user, decoded and encoded anew. data: base64; width, height: in pixels."""

    name: str
    caption: Text
    media_type: Literal["image/png", "image/jpeg"]
    width: int
    height: int
    data: str


@dataclass(frozen=True)
class Sheet:
    """A calculation sheet, worked in SI. name: unique, safe as a file name."""

    name: str
    caption: Text
    steps: tuple[Step, ...]


@dataclass(frozen=True)
class Equations:
    """Steps of a calculation in running text, each as symbol, formula and value. lead: what they lead to."""

    lead: Text
    steps: tuple[Step, ...]


@dataclass(frozen=True)
class Facts:
    """Labels and what they say, in two columns without a frame."""

    pairs: tuple[tuple[Text, Text], ...]


@dataclass(frozen=True)
class WritingBox:
    """An empty box in which the engineer writes. title: what is asked; height: [mm]."""

    title: Text
    height: float = 40.0


@dataclass(frozen=True)
class Signatures:
    """Places to sign: (role, name) each; an empty name leaves a line."""

    places: tuple[tuple[Text, Text], ...]


@dataclass(frozen=True)
class Banner:
    """The outcome at a glance. near: whether it is at the limit; headline: its meaning in one sentence."""

    outcome: Literal["pass", "fail", "incomplete"]
    headline: Text
    near: bool = False


Block = (
    Prose
    | BulletList
    | FileLines
    | Table
    | Figure
    | FigureRow
    | Photograph
    | Sheet
    | Equations
    | Facts
    | WritingBox
    | Signatures
    | Banner
)


def nonempty(table: Table) -> list[Block]:
    """Return the table as blocks: none where it has no rows."""
    return [table] if table.rows else []


def tabulate(
    name: str,
    caption: Text,
    fields: Iterable[Field[Item]],
    items: Iterable[Item],
    *,
    muted: Callable[[Item], bool] | None = None,
    small: bool = False,
) -> Table:
    """Return the table of some items, a row for each.

    Parameters
    ----------
    name, caption, small : as of `Table`
    fields : the columns, each with its cell
    items : in the order of the rows
    muted : tells of an item whether its row is for information only
    """
    columns, cells = zip(*fields, strict=True)
    every = tuple(items)
    rows = tuple(tuple(cell(item) for cell in cells) for item in every)
    for_information = frozenset(place for place, item in enumerate(every) if muted is not None and muted(item))
    return Table(name, caption, columns, rows, for_information, small)


def tabulate_parts(
    name: str,
    caption: Text,
    wholes: tuple[Iterable[Field[Whole]], Iterable[Whole]],
    parts: tuple[Iterable[Field[Item]], Callable[[Whole], Iterable[Item]]],
    *,
    muted: Callable[[Item], bool] | None = None,
    small: bool = False,
) -> Table:
    """Return the table of the parts of some things, a row for each part.

    Parameters
    ----------
    name, caption, muted, small : as of `tabulate`
    wholes : the columns that a thing has, which come first, and the things
    parts : the columns that its part has, and what its parts are
    """
    fields, things = wholes
    part_fields, parts_of = parts
    leading: list[Field[tuple[Whole, Item]]] = [(column, _of_whole(cell)) for column, cell in fields]
    own: list[Field[tuple[Whole, Item]]] = [(column, _of_part(cell)) for column, cell in part_fields]
    pairs = [(thing, part) for thing in things for part in parts_of(thing)]
    return tabulate(name, caption, (*leading, *own), pairs, muted=muted and _of_part(muted), small=small)


def _of_whole(cell: Callable[[Whole], Cell]) -> Callable[[tuple[Whole, Any]], Cell]:
    return lambda pair: cell(pair[0])


def _of_part(cell: Callable[[Item], Value]) -> Callable[[tuple[Any, Item]], Value]:
    return lambda pair: cell(pair[1])


@dataclass(frozen=True)
class Section:
    """A heading and the blocks under it.

    level : 0 for a chapter, 1 for its parts
    mark : before the title: "3", "A", "M2"; "" for none
    shares_page : whether one that starts a page may follow on another's, where it fits whole
    """

    title: Text
    level: int
    blocks: tuple[Block, ...]
    starts_page: bool = False
    mark: str = ""
    shares_page: bool = False


@dataclass(frozen=True)
class Document:
    """A report.

    facts : labels and what they say, for the title block
    running : in the head of each page, besides the title: reference, revision, status
    sections : in order; the first is the first page, the contents come after the second
    data : tables for the spreadsheet and the CSV files only
    worksheets : of the spreadsheet: the name of each and the tables that stand on it; others have sheets of their own
    parts : beginnings of the names of tables that each of several things has, with what the thing is called: on a
        worksheet these tables are one
    program : name and version of the program that made it; stamp : of the results that it tells, "" for none
    date : of the report as the project gives it, "" for none
    locale : in which it is to be written
    """

    title: Text
    subject: Text
    author: str
    program: str
    paper: Literal["A4", "letter"]
    facts: tuple[tuple[Text, Text], ...]
    sections: tuple[Section, ...]
    data: tuple[Table, ...] = ()
    worksheets: tuple[tuple[Phrase, tuple[str, ...]], ...] = ()
    parts: tuple[tuple[str, Text], ...] = ()
    running: tuple[Text, ...] = ()
    logo: Photograph | None = None
    stamp: str = ""
    date: str = ""
    locale: Locale = field(default_factory=Locale)

    @property
    def writer(self) -> Locale:
        """The locale, with the numbers of the blocks for references."""
        return self.locale.with_titles(self.numbers)

    @property
    def blocks(self) -> tuple[Block, ...]:
        """Every block in order of appearance, figures of a row one by one."""
        every = (block for section in self.sections for block in section.blocks)
        return tuple(one for block in every for one in (block.figures if isinstance(block, FigureRow) else (block,)))

    @property
    def tables(self) -> tuple[Table, ...]:
        """Every table once, the printed ones first."""
        printed = tuple(block for block in self.blocks if isinstance(block, Table))
        return (*printed, *(table for table in self.data if table not in printed))

    @property
    def figures(self) -> tuple[Figure, ...]:
        """Every figure."""
        return tuple(block for block in self.blocks if isinstance(block, Figure))

    @property
    def sheets(self) -> tuple[Sheet, ...]:
        """Every calculation sheet."""
        return tuple(block for block in self.blocks if isinstance(block, Sheet))

    @property
    def numbers(self) -> dict[tuple[Kind, str], int]:
        """The numbers of figures, photographs among them, tables and sheets, counted as they come."""
        found: dict[tuple[Kind, str], int] = {}
        counted: Counter[Kind] = Counter()
        for block in self.blocks:
            kind = _KINDS.get(type(block))
            if kind is not None:
                counted[kind] += 1
                found[kind, block.name] = counted[kind]  # type: ignore[union-attr]  # these kinds have names
        return found


_KINDS: dict[type, Kind] = {Figure: "Figure", Photograph: "Figure", Table: "Table", Sheet: "Sheet"}
NOTHING = Verbatim("")
