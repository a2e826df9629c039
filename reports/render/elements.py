"""The blocks of a document as elements of HTML. Text becomes markup here and only here, escaped."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from functools import singledispatchmethod
from html import escape

from reports.document import (
    SHEET_HEADS,
    SIGNATURE_HEADS,
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
    Sheet,
    Signatures,
    Table,
    Text,
)
from reports.language.formula import mark_up
from reports.language.lettering import visible
from reports.language.numerals import cell_text, step_result
from reports.language.outcome_words import outcome_colour, spell_out
from reports.render.svg import Picture

_LONG = 400  # characters


def markup(text: str) -> str:
    """Return plain text as markup that shows it letter for letter, between tags and in attributes."""
    return escape(visible(text))


class Elements:
    """Makes an element of each block of a document."""

    def __init__(self, document: Document, pictures: Mapping[str, Picture]) -> None:
        self.titles, self.pictures, self.translate = document.titles, pictures, document.translate

    @singledispatchmethod
    def of(self, block: Block) -> str:
        """Return the element of a block."""
        raise TypeError(f"{type(block).__name__}: not a block of a document")

    @of.register
    def _(self, block: Text) -> str:
        return "\n".join(f"<p>{markup(text)}</p>" for text in block.paragraphs)

    @of.register
    def _(self, block: Items) -> str:
        return "<ul>" + "\n".join(f"<li>{markup(text)}</li>" for text in block.points) + "</ul>"

    @of.register
    def _(self, block: Banner) -> str:
        word, headline = markup(self.translate(block.word)), markup(block.headline)
        return f'<p class="banner {block.verdict}"><strong>{word}</strong> <span>{headline}</span></p>'

    @of.register
    def _(self, block: Code) -> str:
        return f"<pre>{markup(chr(10).join(block.lines))}</pre>"

    @of.register
    def _(self, block: Table) -> str:
        heads = [_head(column.heading, _kind(column)) for column in block.columns]
        rows = [
            _row(row, block.columns, muted=place in block.muted, translate=self.translate)
            for place, row in enumerate(block.rows)
        ]
        return _wide("sortable", self.titles["Table", block.name], block.caption, heads, rows)

    @of.register
    def _(self, block: Sheet) -> str:
        heads = [_head(text, "") for text in map(self.translate, SHEET_HEADS)]
        return _wide("sheet", self.titles["Sheet", block.name], block.caption, heads, map(_step, block.lines))

    @of.register
    def _(self, block: Figure) -> str:
        title, picture = self.titles["Figure", block.name], self.pictures[block.name]
        name = anchor(title)
        return (
            f'<figure id="{name}"><div class="picture">'
            f'<svg role="img" aria-labelledby="{name}-caption" {picture.box}>{picture.upright}</svg></div>\n'
            f'<figcaption id="{name}-caption"><b>{title}.</b> {markup(block.caption)}</figcaption>'
            f"{'' if block.model is None else _data(block.model)}</figure>"
        )

    @of.register
    def _(self, block: Signatures) -> str:
        heads = "".join(f'<th scope="col">{markup(text)}</th>' for text in map(self.translate, SIGNATURE_HEADS))
        rows = "".join(
            f'<tr><th scope="row">{markup(role)}</th><td>{markup(name)}</td><td></td><td></td></tr>'
            for role, name in block.places
        )
        return f'<div class="wide"><table class="signature"><thead><tr>{heads}</tr></thead>{rows}</table></div>'


def anchor(title: str) -> str:
    """Return the id of a title: figure-1."""
    return title.lower().replace(" ", "-")


def _wide(kind: str, title: str, caption: str, heads: Iterable[str], rows: Iterable[str]) -> str:
    """Return a table that scrolls within the page where it is wider."""
    name = anchor(title)
    return (
        f'<div class="wide" tabindex="0" role="region" aria-labelledby="{name}-caption">'
        f'<table class="{kind}" id="{name}">'
        f'<caption id="{name}-caption"><span><b>{title}.</b> {markup(caption)}</span></caption>\n'
        f"<thead><tr>{''.join(heads)}</tr></thead>\n<tbody>{''.join(rows)}</tbody></table></div>"
    )


def _head(text: str, kind: str) -> str:
    return f'<th scope="col"{_classes(kind)}>{markup(text)}</th>'


def _row(row: tuple[Cell, ...], columns: tuple[Column, ...], *, muted: bool, translate: Callable[[str], str]) -> str:
    cells = "".join(_cell(cell, column, translate) for cell, column in zip(row, columns, strict=True))
    return f"<tr{_classes('muted' if muted else '')}>{cells}</tr>\n"


def _cell(cell: Cell, column: Column, translate: Callable[[str], str]) -> str:
    """Return one cell; a number carries its value to the last figure, to be sorted by."""
    number = isinstance(cell, int | float) and not isinstance(cell, bool)
    empty = "empty" if cell is None or cell == "" else ""
    value = f' data-value="{cell!r}"' if number else ""
    text = cell_text(spell_out(cell, column, translate), column.kind)
    return f"<td{_classes(_kind(column), outcome_colour(cell, column), empty)}{value}>{_whole(text)}</td>"


def _whole(text: str) -> str:
    """Return the text of a cell; a long one scrolls within it."""
    return markup(text) if len(text) <= _LONG else f'<div class="long" tabindex="0">{markup(text)}</div>'


def _kind(column: Column) -> str:
    return "number" if column.kind == "number" else ""


def _step(line: Line) -> str:
    clause = f'<span class="clause">{markup(line.clause)}</span>' if line.clause else ""
    numbers = f'<span class="numbers">= {_formula(line.substituted)}</span>' if line.substituted else ""
    value = markup(step_result(line.value, line.unit, line.beside))
    return (
        f'<tr><th scope="row">{_formula(line.symbol)}</th><td>{_formula(line.description)}{clause}</td>'
        f"<td>{_formula(line.formula)}{numbers}</td><td>{value}</td></tr>\n"
    )


def _formula(text: str) -> str:
    return mark_up(markup(text), index=("<sub>", "</sub>"), power=("<sup>", "</sup>"))


def _data(model: Model) -> str:
    """Return a model as data that no reader takes for markup."""
    text = json.dumps(vars(model), default=vars, separators=(",", ":")).replace("<", "\\u003c")
    return f'<script type="application/json">{text}</script>'


def _classes(*names: str) -> str:
    found = " ".join(name for name in names if name)
    return f' class="{found}"' if found else ""
