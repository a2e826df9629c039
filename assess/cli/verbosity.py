"""What every command has: the options --quiet and --verbose, also before it, and its line in the list of commands."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Annotated, Any

import typer


def _set_level(name: str, other: str) -> Callable[[bool], None]:
    def set_level(wanted: bool) -> None:
        if not wanted:
            return
        from assess.cli import stderr

        if stderr.LOG.level == getattr(stderr, other):
            raise typer.BadParameter("--quiet and --verbose exclude each other")
        stderr.LOG.setLevel(getattr(stderr, name))

    return set_level


Quiet = Annotated[
    bool,
    typer.Option(
        "--quiet",
        "-q",
        callback=_set_level("QUIET", "VERBOSE"),
        expose_value=False,
        help="Print results and errors only: no progress, warnings or notes on stderr.",
    ),
]
Verbose = Annotated[
    bool,
    typer.Option(
        "--verbose",
        "-v",
        callback=_set_level("VERBOSE", "QUIET"),
        expose_value=False,
        help="Print on stderr what is done: stages with their times, records, compiled code.",
    ),
]
_OPTIONS = [
    inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=False, annotation=annotation)
    for name, annotation in (("quiet", Quiet), ("verbose", Verbose))
]


def with_verbosity(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that also takes --quiet and --verbose; it need not know of them."""
    own = inspect.signature(command, eval_str=True)

    @functools.wraps(command)
    def run(**values: Any) -> None:
        command(**{name: value for name, value in values.items() if name in own.parameters})

    setattr(run, "__signature__", own.replace(parameters=[*own.parameters.values(), *_OPTIONS]))  # noqa: B010
    return run


def first_sentence(command: Callable[..., None]) -> str:
    """Return what a command does, whole, for the list of commands, which else cuts it off."""
    return " ".join((command.__doc__ or "").split("\n\n")[0].split())
