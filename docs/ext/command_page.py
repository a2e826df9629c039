"""The page of the commands, docs/reference/commands.md: the help that each prints, at the width of the page."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import typer
import typer.main

from assess.cli.app import app
from docs.ext.markdown import contents

HEAD = """# Commands

The help that each command prints. How they work together, and the exit codes, are in [the guide](../command-line.md).
"""
WIDTH = 90  # columns of a help


def text() -> str:
    """Return the page as Markdown."""
    helps = {each.command_path: help_text(each) for each in commands()}
    sections = [f"## {name}\n\n```text\n{shown}\n```\n" for name, shown in helps.items()]
    return "\n".join((HEAD, contents(helps), *sections))


def commands() -> Iterator[typer.Context]:
    """Yield every command that does something as it is called, in the order of `assess --help`."""
    return _commands(_called(typer.main.get_command(app), "assess", None))


def _commands(group: typer.Context) -> Iterator[typer.Context]:
    members: dict[str, Any] = vars(group.command)["commands"]
    for name, command in members.items():
        context = _called(command, name, group)
        if hasattr(command, "commands"):
            yield from _commands(context)
        elif not command.hidden:
            yield context


def _called(command: Any, name: str, parent: typer.Context | None) -> typer.Context:
    context: typer.Context = command.make_context(
        name, [], parent=parent, resilient_parsing=True, terminal_width=WIDTH, color=False
    )
    return context


def help_text(context: typer.Context) -> str:
    """Return what a command prints for `--help`."""
    lines = context.get_help().splitlines()
    return "\n".join(line.rstrip() for line in lines)
