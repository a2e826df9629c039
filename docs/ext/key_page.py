"""The page of the project file's keys, docs/reference/keys.md: every table with its keys, made from the schema."""

from __future__ import annotations

import inspect
from itertools import groupby

from assess.project.units import KINDS
from docs.ext.key_values import default_words, symbol, value_words
from docs.ext.markdown import capital, cell, contents, escape
from docs.ext.schema_examples import example
from docs.ext.schema_tables import Place, Table, form, keys, places, title

HEAD = """# Keys of the project file

Every table of the [project file](../project-file.md) with its keys, made from the schema that reads it.
[What each key rests on](../evidence.md) says who vouches for a key and which way it helps a wall.

A quantity is a number in the SI unit in brackets, or a string with its unit, like `"1.25 m"`. NAME is a name that you
choose, `[]` each item of a list. `{ mean, cov }` stands where a number may be given by its mean and its coefficient of
variation ([uncertainty](../uncertainty.md)). A dash in the last column: nothing is taken where the key is absent.

`assess schema` prints the same as a JSON Schema, with which editors complete and check a project file.
"""
TITLES = {"project": "Top of the file"}


def text() -> str:
    """Return the page as Markdown."""
    grouped = {
        TITLES.get(name, f"`[{name}]`"): list(found) for name, found in groupby(places(), lambda each: each.page)
    }
    parts = [HEAD, contents(grouped), *_quantities()]
    for heading, found in grouped.items():
        parts += [f"## {heading}\n", *map(_section, found)]
    return "\n".join(parts)


def _quantities() -> list[str]:
    """Return a table of the kinds of quantities with their units."""
    rows = [f'| {kind.name} | {symbol(kind)} | `"{kind.example}"` |' for kind in KINDS.values() if symbol(kind)]
    return ["| quantity | SI unit | like |", "|---|---|---|", *rows, ""]


def _section(place: Place) -> str:
    table = place.table
    return "\n".join(
        (f"### {capital(title(table))}", "", _where(place), "", *_meaning(table), *_rows(table), "", *_example(place))
    )


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
        cells = (f"`{key}`", escape(meanings.get(key, "")), value_words(field), default_words(field))
        rows.append("| " + " | ".join(map(cell, cells)) + " |")
    return rows


def _example(place: Place) -> list[str]:
    found = example(place)
    return [f"```toml\n{found}```\n"] if found else []
