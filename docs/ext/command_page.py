"""Pages of the commands: one for each, made from the help that it prints."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import typer.main

from assess.cli.app import app
from docs.ext.markdown import cell, escape

FOLDER = "commands"


@dataclass(frozen=True)
class Shown:
    """A command with the words that call it, such as ("records", "select")."""

    words: tuple[str, ...]
    command: Any

    @property
    def name(self) -> str:
        return " ".join(("assess", *self.words))


def commands() -> tuple[Shown, ...]:
    """Return every command that does something, in the order of `assess --help`."""
    return tuple(_commands(Shown((), typer.main.get_command(app))))


def _commands(group: Shown) -> Iterator[Shown]:
    for name, command in group.command.commands.items():
        each = Shown((*group.words, name), command)
        if hasattr(command, "commands"):
            yield from _commands(each)
        elif not command.hidden:
            yield each


def pages() -> dict[str, str]:
    """Return each page by its name, as Markdown."""
    return {f"{FOLDER}/{'-'.join(each.words)}.md": _page(each) for each in commands()}


def first_sentence(shown: Shown) -> str:
    """Return what a command does, in one line."""
    return str(shown.command.help).split("\n")[0].strip()


def _page(shown: Shown) -> str:
    return "\n".join(
        (
            f"# `{shown.name}`",
            "",
            "```text",
            usage(shown),
            "```",
            "",
            *(f"{_prose(part)}\n" for part in str(shown.command.help).split("\n\n")),
            *_table(shown, "argument", "Arguments"),
            *_table(shown, "option", "Options"),
        )
    )


def usage(shown: Shown) -> str:
    """Return the line with which the help begins."""
    return " ".join(shown.command.get_usage(_context(shown)).removeprefix("Usage: ").split())


def _context(shown: Shown) -> Any:
    return shown.command.make_context(shown.name, [], resilient_parsing=True)


def _table(shown: Shown, kind: str, title: str) -> list[str]:
    """Return the table of the arguments, or of the options, as the help names them."""
    context = _context(shown)
    found = [each.get_help_record(context) for each in shown.command.params if each.param_type_name == kind]
    rows = [_row(*each) for each in found if each is not None]
    return [f"## {title}", "", "| name | what it is | default |", "|---|---|---|", *rows, ""] if rows else []


def _row(names: str, text: str) -> str:
    """Return a row from what the help says, which ends with `[default: …]` or `[required]`."""
    about, _, more = text.partition("  [")
    default = more.removesuffix("]").removeprefix("default: ")
    shown = f"**{default}**" if default == "required" else f"`{default}`" if default else "–"
    return f"| `{cell(names)}` | {cell(escape(about))} | {shown} |"


def _prose(text: str) -> str:
    return escape(re.sub(r"\s+", " ", text.replace("\b", "").strip()))
