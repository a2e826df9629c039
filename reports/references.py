"""References from one block of a document to another, numbered when the document is whole."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Literal

from reports.document import Block, Document, Text

_OPEN, _CLOSE = "\ufdd2", "\ufdd3"  # Unicode noncharacters: no text has them
_MARK = re.compile(f"{_OPEN}([A-Za-z]+):([^{_CLOSE}]+){_CLOSE}")


def reference(kind: Literal["Figure", "Table", "Sheet"], name: str) -> str:
    """Return a mark for the title of a block, "Figure 5", kept in a paragraph until the document is whole."""
    return f"{_OPEN}{kind}:{name}{_CLOSE}"


def resolve_references(document: Document) -> Document:
    """Return the document with the marks in its paragraphs replaced by titles. Raises KeyError for an unknown block."""
    titles = document.titles

    def resolved(block: Block) -> Block:
        if not isinstance(block, Text):
            return block
        return Text(tuple(_MARK.sub(lambda mark: titles[mark[1], mark[2]], text) for text in block.paragraphs))

    sections = (
        replace(section, blocks=tuple(resolved(block) for block in section.blocks)) for section in document.sections
    )
    return replace(document, sections=tuple(sections))
