"""Pages of the project file's keys: one for each table at its top, made from the schema."""

from __future__ import annotations

import inspect
from itertools import groupby

from docs.ext.key_values import default_words, value_words
from docs.ext.markdown import cell, escape
from docs.ext.schema_examples import example
from docs.ext.schema_tables import Place, Table, anchor, form, keys, places, target, title

FOLDER = "keys"
TITLES = {"project": "Top of the file"}


def pages() -> dict[str, str]:
    """Return each page by its name, as Markdown."""
    grouped = {name: list(found) for name, found in groupby(places(), key=lambda place: place.page)}
    return {f"{FOLDER}/{name}.md": _page(name, found) for name, found in grouped.items()}


def _page(name: str, found: list[Place]) -> str:
    heading = TITLES.get(name, f"`[{name}]`")
    return "\n".join((f"# {heading}", "", *(_section(place) for place in found)))


def _section(place: Place) -> str:
    table = place.table
    head = [f"({target(table)})=", f"## {_capital(title(table))}", "", _where(place), "", *_meaning(table)]
    return "\n".join((*head, *_rows(table), "", _example(place), ""))


def _where(place: Place) -> str:
    if not place.path:
        return "Above the first table."
    apart = form(place.table)
    where = f"`[{place.path}]`" if "[]" not in place.path else f"`{place.path}`"
    return f"{where}, {apart[0]} = {apart[1]}" if apart else where


def _meaning(table: Table) -> list[str]:
    """Return what a table is, where that is more than its heading says."""
    sentences = " ".join(inspect.cleandoc(table.__doc__ or "").split("\n\n")[0].split())
    return [] if sentences.rstrip(".") == title(table) else [escape(sentences), ""]


def _rows(table: Table) -> list[str]:
    meanings = table.meanings()
    rows = ["| key | what it is | value | default |", "|---|---|---|---|"]
    for key, field in keys(table).items():
        cells = (
            f"[`{key}`]{{#{anchor(table)}-{key.lower().replace('_', '-')}}}",
            escape(meanings.get(key, "")),
            value_words(field),
            default_words(field),
        )
        rows.append("| " + " | ".join(map(cell, cells)) + " |")
    return rows


def _example(place: Place) -> str:
    text = example(place)
    return f"```toml\n{text}```\n" if text else ""


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
