"""A document with every block and every kind of text, all that a user can write being hostile, and its page."""

from __future__ import annotations

from base64 import b64encode
from functools import partial
from io import BytesIO
from math import radians
from pathlib import Path

from matplotlib.figure import Figure as Drawn
from PIL import Image

from assess.codes.calculation_sheet import Step, step
from assess.messages.message import message
from reports.document import (
    NOTHING,
    Banner,
    Block,
    BulletList,
    Cell,
    ColouredFaces,
    Column,
    Document,
    Facts,
    Figure,
    FigureRow,
    FileLines,
    OutcomeCell,
    Photograph,
    Point,
    Prose,
    Section,
    Sheet,
    Signatures,
    SpatialModel,
    Table,
    Wire,
    WritingBox,
)
from reports.figures.style import printable
from reports.language.locale import Locale
from reports.language.texts import (
    Paragraph,
    Reference,
    Term,
    Text,
    Verbatim,
    count,
    listing,
    names,
    quantity,
    say,
    say_count,
)
from reports.render.html import write_html
from reports.render.table_text import PlainCell, plain_cell
from reports.render.vector import svg_picture, trace_figure

HOSTILE = "=cmd|'/c calc'!A0 <b>&amp;</p> <script>alert(1)</script> ]]> $x$ {gap} %s ../../etc \u202e \x07"
"""What a user may write: a formula of spreadsheets, markup, gaps of templates, a path, characters that are not seen."""


def hostile(tag: str) -> Verbatim:
    """Return hostile text with a tag by which a test finds it."""
    return Verbatim(f"{HOSTILE} {tag}#")


def sample_document(locale: Locale | None = None, *, tall: int = 12) -> Document:
    """Return the document. tall : rows of its wide table."""
    return Document(
        title=hostile("title"),
        subject=say("Seismic assessment of masonry by rocking dynamics"),
        author=hostile("author").text,
        program="assess 9.9.9",
        paper="A4",
        facts=((say("Client"), hostile("client")), (say("Reference"), hostile("reference"))),
        sections=_sections(tall),
        data=(_long_table(),),
        running=(hostile("running"), say("Revision {revision}", revision=hostile("revision"))),
        logo=_photograph("logo"),
        stamp="0123456789abcdef",
        locale=locale or Locale(),
    )


def _sections(tall: int) -> tuple[Section, ...]:
    return (
        Section(say("Verdict"), 0, _verdict(), mark="1"),
        Section(say("Key plan"), 0, (_figure("key-plan", model=_model()), _wide_table(tall)), mark="2"),
        Section(hostile("mechanism"), 0, _mechanism(), starts_page=True, mark="M1"),
        Section(say("Answers"), 1, (_narrow_table(),)),
        Section(say("Signatures"), 0, (_signatures(), WritingBox(say("Judgement of the engineer"))), mark="3"),
        Section(say("Calculation sheets"), 0, (_sheet(),), starts_page=True, mark="A"),
    )


def _verdict() -> tuple[Block, ...]:
    headline = say("Every mechanism holds at {pga}.", pga=quantity(0.25, "ground acceleration"))
    return (
        Banner("pass", headline),
        Banner("fail", hostile("headline"), near=True),
        Banner("incomplete", say("Nothing has been answered.")),
        Facts(((say("Basis"), hostile("basis")), (say("Height"), quantity(12.3456, "length")))),
        BulletList((hostile("point"), say_count("{number} wall", "{number} walls", 3))),
    )


def _mechanism() -> tuple[Block, ...]:
    """Return every kind of text, figures in a row, a photograph and lines to copy."""
    travel = message("seat-travel", {"what": "message#", "moved": quantity(0.0123, "length")})
    said = message("seats-hold", {"state": HOSTILE, "seats": travel})
    sentence = say(
        "{figure} and {table} show {name}, {height} high.",
        figure=Reference("Figure", "row-1"),
        table=Reference("Table", "wide"),
        name=hostile("name"),
        height=quantity(2.84, "length"),
    )
    both = listing((hostile("listed"), quantity(1234.5, "force"), count(4)))
    return (
        Prose((sentence, Paragraph((Term("natural frequency"), both)), said, names(("Wall 6 m", "Wall, 7")))),
        FigureRow((_figure("row-1"), _figure("row-2"))),
        _photograph("photograph"),
        FileLines((HOSTILE, "[report]", 'title = "x"')),
    )


def _photograph(name: str) -> Photograph:
    stream = BytesIO()
    Image.new("RGB", (120, 80), (20, 90, 160)).save(stream, "PNG")
    return Photograph(name, hostile(name), "image/png", 120, 80, b64encode(stream.getvalue()).decode())


def _figure(name: str, model: SpatialModel | None = None) -> Figure:
    return Figure(name, hostile(f"caption-{name}"), partial(draw_sample, name), model)


def draw_sample(name: str, locale: Locale) -> Drawn:
    """Draw a line, with hostile text and a quantity on its axes."""
    figure = Drawn(figsize=(3.3, 2.2))
    axes = figure.add_subplot()
    axes.plot([0.0, 0.1, 0.2], [0.0, 2.0 / locale.table_unit("length").size, 1.0])
    axes.set_xlabel(locale.heading(say("rotation φ"), "rotation"), parse_math=False)
    axes.set_ylabel(printable(locale.heading(hostile("axis"), "length"))[-60:], parse_math=False)
    axes.set_title(name)
    return figure


def _model() -> SpatialModel:
    """Return two boxes, one upon the other, each with its number."""
    low, lower = box((0.0, 0.0, 0.0), (4.0, 0.6, 3.0))
    high, upper = box((0.0, 0.0, 3.0), (4.0, 0.6, 5.0))
    shifted = tuple((a + 8, b + 8, c + 8) for a, b, c in upper)
    wires = (
        Wire(((2.0, -0.5, 1.5), (2.0, -1.5, 2.0)), "#1b2733", "M1"),
        Wire(((2.0, -0.5, 4.0), (2.0, -1.5, 4.5)), "#1b2733", hostile("wire").text),
        Wire(((0.0, 0.0, 3.0), (4.0, 0.0, 3.0)), "#c1121f", dashed=True),
    )
    parts = (ColouredFaces("#b3380e", lower), ColouredFaces("#00694c", shifted))
    return SpatialModel((*low, *high), parts, wires, "#6f6350", radians(35), (-1.2, 0.4))


def box(low: Point, high: Point) -> tuple[tuple[Point, ...], tuple[tuple[int, int, int], ...]]:
    """Return the corners and the faces of a box."""
    corners = tuple((x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2]))
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return corners, tuple(face for a, b, c, d in quads for face in ((a, b, c), (a, c, d)))


def _narrow_table() -> Table:
    columns = (Column(say("Level"), "ground acceleration"), Column(say("Answer")))
    rows: tuple[tuple[Cell, ...], ...] = (
        (0.1, OutcomeCell("pass", say("holds"))),
        (0.25, OutcomeCell("fail", say("fails"))),
    )
    return Table("narrow", say("A table that fits."), columns, rows)


def _wide_table(tall: int) -> Table:
    """Return a matrix as that of the verdict, with every kind of cell."""
    words: tuple[Text, ...] = (say("Mechanism"), hostile("head"))
    columns = (
        *map(Column, words),
        Column(say("Height"), "length"),
        Column(say("Force"), "force"),
        Column(say("Records"), figures=12),
        Column(say("Flexible")),
        *(Column(say("Answer {number}", number=count(number))) for number in range(1, 7)),
    )
    rows = tuple(_wide_row(place) for place in range(1, tall + 1))
    return Table("wide", hostile("table"), columns, rows, muted=frozenset({1}), small=True)


def _wide_row(place: int) -> tuple[Cell, ...]:
    graded: tuple[Cell, ...] = (
        OutcomeCell("pass", say("holds to {factor} x the site's PGA", factor=quantity(2.7, figures=2))),
        OutcomeCell("fail", hostile("graded")) if place == 1 else OutcomeCell("fail", Verbatim("1.31")),
        OutcomeCell("incomplete", say("not answered")),
        OutcomeCell("comparison", Verbatim("0.84")),
        None,
        quantity(0.0123456, "length"),
    )
    label = hostile("cell") if place == 1 else Verbatim(f"M{place} Wall {place} m")
    return (
        label,
        Verbatim("@x" * (place == 2)),
        1.23456789 * place,
        98765.4321 / place,
        place,
        place % 2 == 0,
        *graded,
    )


def _long_table() -> Table:
    columns = (Column(hostile("long"), ""), Column(say("Height"), "length"))
    return Table("long", say("A table for the spreadsheet only."), columns, ((hostile("long-cell"), 2.0),))


def _signatures() -> Signatures:
    return Signatures(((say("Engineer"), hostile("engineer")), (say("Checker"), NOTHING)))


def _sheet() -> Sheet:
    return Sheet("sheet", hostile("sheet"), (_step(), _read(), _unknown()))


def _step() -> Step:
    given = {"a_g": (2.4525, "m/s2"), "h": (3.0, "m")}
    return step("a_{S,1}", "demand at the base", "C8.7.1", "a_g h^2", 22.0725, "m", given=given)


def _read() -> Step:
    return step("<b>=x", HOSTILE, HOSTILE, HOSTILE, 0.5, "-", bound="<=")


def _unknown() -> Step:
    return step("q", "behaviour factor", "", "none", None, "-")


def plain_rows(table: Table, locale: Locale) -> list[list[PlainCell]]:
    """Return the cells of a table as files hold them."""
    return [[plain_cell(*each, locale) for each in zip(row, table.columns, strict=True)] for row in table.rows]


def write_page(document: Document, path: Path) -> Path:
    """Write the page; the path written."""
    pictures = {figure.name: svg_picture(trace_figure(figure.draw(document.writer))) for figure in document.figures}
    return write_html(document, path, pictures=pictures)
