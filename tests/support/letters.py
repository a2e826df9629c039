"""The words of a chapter as a reader sees them, for tests of what it says."""

from __future__ import annotations

from collections.abc import Iterable

from reports.document import (
    Banner,
    Block,
    BulletList,
    Cell,
    Facts,
    FileLines,
    OutcomeCell,
    Prose,
    Section,
    Signatures,
    Table,
    WritingBox,
)
from reports.language.locale import Locale
from reports.language.texts import Text

ENGLISH = Locale()


def letters(text: Text, locale: Locale = ENGLISH) -> str:
    """A text in English and SI units, or as another locale has it, with plain spaces."""
    return locale.text(text).replace("\u00a0", " ")


def lines_of(texts: Iterable[Text], locale: Locale = ENGLISH) -> str:
    """Texts in English and SI units, or as another locale has them, a line each, with plain spaces."""
    return "\n".join(letters(text, locale) for text in texts)


def without_spaces(text: str) -> str:
    """A text without spaces and line ends, which pages place as they like."""
    return "".join(text.split())


def cell_letters(cell: Cell) -> str:
    """A cell: numbers as they are, a dash for none."""
    if cell is None:
        return "–"
    if isinstance(cell, OutcomeCell):
        return letters(cell.text)
    return str(cell) if isinstance(cell, bool | int | float) else letters(cell)


def rows(table: Table) -> list[list[str]]:
    """The cells of a table."""
    return [[cell_letters(cell) for cell in row] for row in table.rows]


def lines(sections: Iterable[Section]) -> list[str]:
    """Every paragraph, point, line of code, pair and row of some sections."""
    return [line for section in sections for block in section.blocks for line in _lines(block)]


def text_of(sections: Iterable[Section]) -> str:
    """What `lines` gives, a line each."""
    return "\n".join(lines(sections))


def prose(*sections: Section) -> str:
    """Every paragraph of some sections, a line each."""
    return "\n".join(lines_of(b.paragraphs) for each in sections for b in each.blocks if isinstance(b, Prose))


def _lines(block: Block) -> list[str]:
    if isinstance(block, Prose):
        return [letters(each) for each in block.paragraphs]
    if isinstance(block, BulletList):
        return [letters(each) for each in block.points]
    if isinstance(block, FileLines):
        return list(block.lines)
    if isinstance(block, Banner):
        return [letters(block.headline)]
    if isinstance(block, Facts):
        return [f"{letters(label)}: {letters(text)}" for label, text in block.pairs]
    if isinstance(block, Table):
        return [" | ".join(row) for row in rows(block)]
    if isinstance(block, Signatures):
        return [f"{letters(role)}: {letters(name)}" for role, name in block.places]
    return [letters(block.title)] if isinstance(block, WritingBox) else []


def table_of(sections: Iterable[Section], name: str) -> Table:
    """The table of this name."""
    return next(
        block for section in sections for block in section.blocks if isinstance(block, Table) and block.name == name
    )
