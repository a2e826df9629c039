"""The document as one page of HTML that needs nothing else: figures to enlarge, bodies to turn, tables to sort.

The page's frame, look and behaviour are in the folder web. Text becomes markup here and only here, escaped.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache, singledispatchmethod
from html import escape
from importlib.resources import files
from math import isfinite
from pathlib import Path
from string import Template

from assess.messages.message import Quantity
from reports.document import (
    Banner,
    Block,
    BulletList,
    Cell,
    Column,
    Document,
    Equations,
    Facts,
    Figure,
    FigureRow,
    FileLines,
    Link,
    OutcomeCell,
    Photograph,
    Prose,
    Section,
    Sheet,
    Signatures,
    SpatialModel,
    Table,
    WritingBox,
)
from reports.language.locale import mark_up, truncate, visible
from reports.language.texts import Kind, Phrase, Text, say
from reports.render.table_text import (
    CONTENTS,
    SHEET_HEADS,
    SIGNATURE_HEADS,
    SheetRow,
    column_texts,
    equations_line,
    is_numeric,
    program_and_stamp,
    sheet_rows,
    verdict_word,
)
from reports.render.vector import SvgPicture

SCRIPTS = (  # in the order they need each other
    "gestures.js",
    "picture.js",
    "model.js",
    "viewer.js",
    "tables.js",
    "sifting.js",
    "sideways.js",
    "contents.js",
)

FRAME: Mapping[str, Phrase] = {  # words of the frame of the page
    "to_report": say("To the report"),
    "contents_word": CONTENTS,
    "enlarge": say("Enlarge"),
    "turn": say("Turn in 3D"),
    "enlarged": say("Figure, enlarged"),
    "hint_shift": say("Drag to shift, wheel or pinch to enlarge, double click to start again; keys: arrows, +, −, 0."),
    "hint_turn": say(
        "Drag to turn, with Shift or two fingers to shift, wheel or pinch to enlarge; keys: arrows, +, −, 0."
    ),
    "outcome_word": say("Outcome"),
    "all_outcomes": say("all"),
    "words": say("With the words"),
    "every_row": say("show more than 1,000 rows"),
    "rows_found": say("Rows found:"),
    "larger": say("Larger"),
    "smaller": say("Smaller"),
    "reset": say("Reset"),
    "close": say("Close"),
    "stage": say("Figure, to be moved by the arrow keys"),
}
_LONGEST_TITLE, _LONGEST_HEADING = 120, 180


def write_html(document: Document, path: Path, *, pictures: Mapping[str, SvgPicture]) -> Path:
    """Write the document to `path`; the path written. pictures: its figures by name."""
    elements = Elements(document, pictures)
    style, script = web_resource("report.css"), "\n".join(map(web_resource, SCRIPTS))
    opening, *rest = [_section(*each, elements) for each in enumerate(document.sections)] or [""]
    page = Template(web_resource("page.html")).substitute(
        **{name: elements.text(text) for name, text in FRAME.items()},
        language=markup(document.locale.language),
        policy=_content_security_policy(style=style, script=script),
        program=elements.text(program_and_stamp(document)),
        title=_short(elements.locale.text(document.title), _LONGEST_TITLE),
        subject=elements.text(document.subject),
        running=" · ".join(map(elements.text, document.running)),
        style=style,
        script=script,
        definitions="\n".join(_definitions(pictures).values()),
        logo="" if document.logo is None else elements.image(document.logo),
        facts=elements.facts(document.facts),
        contents=_contents(document.sections, elements),
        opening=opening,
        sections="\n".join(rest),
    )
    path.write_text(page, encoding="utf-8", newline="\n")
    return path


@cache
def web_resource(name: str) -> str:
    """Return the text of a file of reports/render/web."""
    return files("reports.render").joinpath("web", name).read_text(encoding="utf-8")


SIDEWAYS = say("Scroll sideways to see the whole table →")
_LONG = 400  # characters, from which a cell scrolls
_WORDS = 16  # characters, from which a column is that of sentences
_ENLARGED = 1.85  # pixels to the point, at which letters of a figure are as high as those around it


def markup(text: str) -> str:
    """Return plain text as markup that shows it letter for letter, between tags and in attributes."""
    return escape(visible(text))


class Elements:
    """Makes an element of each block of a document."""

    def __init__(self, document: Document, pictures: Mapping[str, SvgPicture]) -> None:
        self.locale, self.pictures = document.writer, pictures

    def text(self, text: Text) -> str:
        """Return a text of the document as markup."""
        return markup(self.locale.text(text))

    @singledispatchmethod
    def element(self, block: Block) -> str:
        """Return the element of a block."""
        raise TypeError(f"{type(block).__name__}: not a block of a document")

    @element.register
    def _(self, block: Prose) -> str:
        return "\n".join(f"<p>{self.text(text)}</p>" for text in block.paragraphs)

    @element.register
    def _(self, block: BulletList) -> str:
        return "<ul>" + "\n".join(f"<li>{self.text(text)}</li>" for text in block.points) + "</ul>"

    @element.register
    def _(self, block: Banner) -> str:
        word, headline = self.text(verdict_word(block)), self.text(block.headline)
        return f'<p class="banner {block.outcome}"><strong>{word}</strong> <span>{headline}</span></p>'

    @element.register
    def _(self, block: Facts) -> str:
        return self.facts(block.pairs)

    @element.register
    def _(self, block: FileLines) -> str:
        return f"<pre>{chr(10).join(map(markup, block.lines))}</pre>"

    @element.register
    def _(self, block: Table) -> str:
        columns = list(zip(*block.rows, strict=True)) or [()] * len(block.columns)
        made = [self._column(*each) for each in zip(block.columns, columns, strict=True)]
        muted = [_classes("muted" if place in block.muted else "") for place in range(len(block.rows))]
        shown = zip(muted, zip(*(cells for _, cells in made), strict=True), strict=True)
        rows = [f"<tr{look}>{''.join(row)}</tr>\n" for look, row in shown]
        heads = [head for head, _ in made]
        look = f"sortable{' small' if block.small else ''}{' sifted' if block.sifted else ''}"
        return self._wide(block, "Table", look, heads, rows)

    @element.register
    def _(self, block: Sheet) -> str:
        heads = [_head(self.text(text)) for text in SHEET_HEADS]
        return self._wide(block, "Sheet", "sheet", heads, map(_step, sheet_rows(block.steps, self.locale)))

    @element.register
    def _(self, block: Equations) -> str:
        line = equations_line(block.steps, self.locale, _formula)
        return f'<p class="equations"><strong>{self.text(block.lead)}</strong> {line}</p>'

    @element.register
    def _(self, block: Figure) -> str:
        picture, name = self.pictures[block.name], self._anchor("Figure", block.name)
        size = f'width="{_ENLARGED * picture.width:.0f}" {picture.box}'
        drawing = f'<svg role="img" aria-labelledby="{name}-caption" {size}>{picture.upright}</svg>'
        data = "" if block.model is None else _data(block.model)
        return f'<figure id="{name}"><div class="picture">{drawing}</div>\n{self._figcaption(block)}{data}</figure>'

    @element.register
    def _(self, block: FigureRow) -> str:
        return f'<div class="row">{"".join(map(self.element, block.figures))}</div>'

    @element.register
    def _(self, block: Photograph) -> str:
        name = self._anchor("Figure", block.name)
        return f'<figure id="{name}" class="photograph">{self.image(block)}\n{self._figcaption(block)}</figure>'

    @element.register
    def _(self, block: WritingBox) -> str:
        strut = f'<svg width="1" height="{block.height:g}mm" aria-hidden="true"></svg>'
        return f'<div class="writing"><p>{self.text(block.title)}</p>{strut}</div>'

    @element.register
    def _(self, block: Signatures) -> str:
        heads = "".join(_head(self.text(text)) for text in SIGNATURE_HEADS)
        rows = "".join(
            f'<tr><th scope="row">{self.text(role)}</th><td>{self.text(name)}</td><td></td><td></td></tr>'
            for role, name in block.places
        )
        return self._scrolling(
            f'<table class="signature"><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>',
            label=f'aria-label="{self.text(SIGNATURE_HEADS[2])}"',
        )

    def facts(self, pairs: Iterable[tuple[Text, Text]]) -> str:
        """Return labels and what they say as a list of terms; nothing where there are none."""
        made = "".join(f"<dt>{self.text(label)}</dt><dd>{self.text(text)}</dd>" for label, text in pairs)
        return f"<dl>{made}</dl>" if made else ""

    def image(self, photograph: Photograph) -> str:
        """Return a picture of the user, whose caption is read in its place."""
        size = f'width="{photograph.width}" height="{photograph.height}"'
        source = f"data:{photograph.media_type};base64,{escape(photograph.data)}"
        return f'<img src="{source}" {size} alt="{self.text(photograph.caption)}">'

    def _anchor(self, kind: Kind, name: str) -> str:
        """Return the id of a block: figure-1."""
        return f"{kind.lower()}-{self.locale.titles[kind, name]}"

    def _caption(self, kind: Kind, block: Figure | Photograph | Table | Sheet) -> str:
        return f"<b>{markup(self.locale.title(kind, block.name))}.</b> {self.text(block.caption)}"

    def _figcaption(self, block: Figure | Photograph) -> str:
        name = self._anchor("Figure", block.name)
        return f'<figcaption id="{name}-caption">{self._caption("Figure", block)}</figcaption>'

    def _wide(self, block: Table | Sheet, kind: Kind, look: str, heads: Iterable[str], rows: Iterable[str]) -> str:
        """Return a table with its caption, which scrolls within the page where it is wider."""
        name = self._anchor(kind, block.name)
        return self._scrolling(
            f'<table class="{look}" id="{name}">'
            f'<caption id="{name}-caption"><span>{self._caption(kind, block)}</span></caption>\n'
            f"<thead><tr>{''.join(heads)}</tr></thead>\n<tbody>{''.join(rows)}</tbody></table>",
            label=f'aria-labelledby="{name}-caption"',
        )

    def _scrolling(self, table: str, *, label: str) -> str:
        """Return a region in which a wide table scrolls, after a hint shown while some of it is out of sight."""
        hint = f'<p class="sideways" hidden>{self.text(SIDEWAYS)}</p>'
        return f'{hint}<div class="wide" tabindex="0" role="region" {label}>{table}</div>'

    def _column(self, column: Column, cells: tuple[Cell, ...]) -> tuple[str, list[str]]:
        """Return the head of a column, and the cells below it."""
        texts, number = column_texts(cells, column, self.locale), is_numeric(cells)
        words = any(len(text) > _WORDS for text in texts)
        look = "number" if number else "words" if words else ""
        head = markup(self.locale.heading(column.label, column.dimension))
        return _head(head, look), [_cell(*each, number=number) for each in zip(cells, texts, strict=True)]


def _content_security_policy(*, style: str, script: str) -> str:
    """Return the content security policy of a page: this style sheet, this script, and nothing from elsewhere."""
    allowed = f"style-src '{_digest(style)}'; script-src '{_digest(script)}'; img-src data:"
    return f"default-src 'none'; {allowed}; base-uri 'none'; form-action 'none'"


def _digest(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _definitions(pictures: Mapping[str, SvgPicture]) -> dict[str, str]:
    """Return letters and windows of all pictures, each once."""
    return {name: element for picture in pictures.values() for name, element in picture.definitions.items()}


def _contents(sections: tuple[Section, ...], elements: Elements) -> str:
    """Return the headings as links, those of parts below their chapter's."""
    made, depth = [], -1
    for place, section in enumerate(sections):
        made += ["<ul>"] * (section.level - depth) if section.level > depth else []
        made += ["</li></ul>"] * (depth - section.level) + ["</li>"] if section.level <= depth else []
        made.append(f'<li><a href="#section-{place}">{_title(section, elements)}</a>')
        depth = section.level
    return "\n".join([*made, *["</li></ul>"] * (depth + 1)])


def _section(place: int, section: Section, elements: Elements) -> str:
    rank = section.level + 2
    blocks = "\n".join(map(elements.element, section.blocks))
    return f'<section><h{rank} id="section-{place}">{_title(section, elements)}</h{rank}>\n{blocks}</section>'


def _title(section: Section, elements: Elements) -> str:
    title = _short(elements.locale.text(section.title), _LONGEST_HEADING)
    return f'<span class="mark">{markup(section.mark)}</span> {title}' if section.mark else title


def _short(text: str, limit: int) -> str:
    return markup(truncate(text, limit))


def _head(label: str, look: str = "") -> str:
    return f'<th scope="col"{_classes(look)}>{label}</th>'


def _cell(cell: Cell, text: str, *, number: bool) -> str:
    """Return one cell; a number carries its value to the last figure, to be sorted by."""
    outcome = cell.outcome if isinstance(cell, OutcomeCell) else ""
    value = _sorting_value(cell)
    data = "" if value is None else f' data-value="{value!r}"'
    look = _classes("number" if number else "", outcome, "empty" if cell is None else "")
    content = f'<a href="{markup(cell.address)}">{markup(text)}</a>' if isinstance(cell, Link) else _whole(text)
    return f"<td{look}{data}>{content}</td>"


def _sorting_value(cell: Cell) -> float | int | None:
    """Return the number by which a cell is sorted; None where its text is."""
    content = cell.text if isinstance(cell, OutcomeCell | Link) else cell
    value = content.value if isinstance(content, Quantity) else content
    return value if isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value) else None


def _whole(text: str) -> str:
    """Return the text of a cell; a long one scrolls within it."""
    return markup(text) if len(text) <= _LONG else f'<div class="long" tabindex="0">{markup(text)}</div>'


def _step(row: SheetRow) -> str:
    clause = f'<span class="clause">{markup(row.clause)}</span>' if row.clause else ""
    numbers = f'<span class="numbers">{_formula(row.numbers)}</span>' if row.numbers else ""
    beside = f' <span class="beside">({markup(row.beside)})</span>' if row.beside else ""
    return (
        f'<tr><th scope="row">{_formula(row.symbol)}</th><td>{_formula(row.description)}{clause}</td>'
        f"<td>{_formula(row.formula)}{numbers}</td><td>{markup(row.result)}{beside}</td></tr>\n"
    )


def _formula(text: str) -> str:
    return mark_up(markup(text), index=("<sub>", "</sub>"), power=("<sup>", "</sup>"))


def _data(model: SpatialModel) -> str:
    """Return a model as data that no reader takes for markup."""
    shown = replace(model, wires=tuple(replace(wire, name=visible(wire.name)) for wire in model.wires))
    text = json.dumps(vars(shown), default=vars, separators=(",", ":")).replace("<", "\\u003c")
    return f'<script type="application/json">{text}</script>'


def _classes(*names: str) -> str:
    found = " ".join(name for name in names if name)
    return f' class="{found}"' if found else ""
