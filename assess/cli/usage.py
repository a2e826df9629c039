"""A command that was typed wrongly, told in one line."""

from __future__ import annotations

from typing import Any

from typer import BadParameter

WRONG_USAGE: Any = BadParameter.__mro__[1]  # typer does not export this parent, of unknown commands and options too


def usage(error: Any) -> str | None:
    """What is wrong with the command, and where to read on; None for any other error."""
    if not isinstance(error, WRONG_USAGE):
        return None
    command = "assess" if error.ctx is None else error.ctx.command_path
    return f"{error.format_message().rstrip('.?')}; see `{command} --help`"
