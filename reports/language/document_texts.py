"""Every text of a document through one function: headings, captions, cells, sentences, steps, letters of figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial, singledispatch

from matplotlib.axis import Axis
from matplotlib.figure import Figure as Drawn
from matplotlib.text import Text as Letters
from matplotlib.ticker import FixedFormatter, FuncFormatter

from reports.document import (
    Banner,
    Block,
    Cell,
    Code,
    Column,
    Document,
    Figure,
    Items,
    Line,
    Model,
    Section,
    Sheet,
    Signatures,
    Table,
    Text,
)

Say = Callable[[str], str]


def map_texts(document: Document, say: Say) -> Document:
    """Return the document with `say` applied to each of its texts, in figures when they are drawn.

    Left as they are: the author, code, names of tables and files, verdicts, and what was given without a unit.
    """
    return replace(
        document,
        title=say(document.title),
        subject=say(document.subject),
        facts=tuple((say(label), say(text)) for label, text in document.facts),
        sections=tuple(_section(section, say) for section in document.sections),
        data=tuple(_table(table, say) for table in document.data),
    )


def _section(section: Section, say: Say) -> Section:
    return replace(section, title=say(section.title), blocks=tuple(_block(block, say) for block in section.blocks))


@singledispatch
def _block(block: Block, say: Say) -> Block:
    raise TypeError(f"{type(block).__name__}: not a block of a document")


@_block.register
def _(block: Text, say: Say) -> Block:
    return Text(tuple(map(say, block.paragraphs)))


@_block.register
def _(block: Items, say: Say) -> Block:
    return Items(tuple(map(say, block.points)))


@_block.register
def _(block: Code, say: Say) -> Block:
    return block


@_block.register
def _(block: Banner, say: Say) -> Block:
    return replace(block, headline=say(block.headline))


@_block.register
def _(block: Signatures, say: Say) -> Block:
    return Signatures(tuple((say(role), name) for role, name in block.places))


@_block.register
def _table(block: Table, say: Say) -> Table:
    columns = tuple(replace(column, label=say(column.label), unit=say(column.unit)) for column in block.columns)
    rows = tuple(
        tuple(_cell(cell, column, say) for cell, column in zip(row, block.columns, strict=True)) for row in block.rows
    )
    return replace(block, caption=say(block.caption), columns=columns, rows=rows)


def _cell(cell: Cell, column: Column, say: Say) -> Cell:
    own = column.kind == "verdict" or (column.kind == "given" and not column.unit)
    return cell if own or not isinstance(cell, str) else say(cell)


@_block.register
def _(block: Sheet, say: Say) -> Block:
    return replace(block, caption=say(block.caption), lines=tuple(_line(line, say) for line in block.lines))


def _line(line: Line, say: Say) -> Line:
    return replace(
        line,
        symbol=say(line.symbol),
        description=say(line.description),
        clause=say(line.clause),
        formula=say(line.formula),
        substituted=say(line.substituted),
        unit=say(line.unit),
    )


@_block.register
def _(block: Figure, say: Say) -> Block:
    model = None if block.model is None else _model(block.model, say)
    return replace(block, caption=say(block.caption), draw=partial(_drawn, block.draw, say), model=model)


def _model(model: Model, say: Say) -> Model:
    return replace(model, wires=tuple(replace(wire, name=say(wire.name)) for wire in model.wires))


def _drawn(draw: Callable[[], Drawn], say: Say) -> Drawn:
    """Return the figure with its letters changed; formatters write lettered ticks anew at each drawing."""
    figure = draw()
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            _ticks(axis, say)
    for letters in figure.findobj(Letters):
        assert isinstance(letters, Letters)
        letters.set_text(say(letters.get_text()))
    return figure


def _ticks(axis: Axis, say: Say) -> None:
    formatter = axis.get_major_formatter()
    if isinstance(formatter, FixedFormatter):
        formatter.seq = [say(text) for text in formatter.seq]
    elif isinstance(formatter, FuncFormatter):  # as set_yticks(places, names) makes one
        axis.set_major_formatter(FuncFormatter(partial(_tick, formatter.func, say)))


def _tick(written: Callable[..., str], say: Say, value: float, place: int | None = None) -> str:
    return say(written(value, place))
