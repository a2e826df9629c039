"""What `assess check` prints of the list of mechanisms that the building can have."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap

from assess.project.key_text import escape_text
from assess.project.sections import Content
from assess.project.sections.checklist import checklist
from assess.results import ChecklistItem

WIDE = 100  # characters of a line


def checklist_lines(content: Content) -> list[str]:
    """Return the list by what became of its items, and an empty line; nothing without a type of building."""
    items = checklist(content.report, content.mechanisms)
    if not items:
        return []
    return [
        f"possible mechanisms of a {content.report.building_type}",
        *_line("examined", [_examined(each) for each in items if each.outcome == "examined"]),
        *_line("absent", [each.key for each in items if each.outcome == "absent"]),
        *_line("not examined", [each.key for each in items if each.outcome == "not-examined" and each.spoken_for]),
        *_line("not named", [each.key for each in items if not each.spoken_for]),
        "",
    ]


def _examined(item: ChecklistItem) -> str:
    return f"{item.key} by {escape_text(' and '.join(item.mechanisms))}"


def _line(what: str, words: Sequence[str]) -> list[str]:
    """Return the items of one outcome, wrapped; nothing where there are none."""
    indent = " " * 16
    return wrap(
        ", ".join(words), WIDE, initial_indent=f"  {what}".ljust(16), subsequent_indent=indent, break_on_hyphens=False
    )
