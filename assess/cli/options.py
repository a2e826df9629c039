"""Arguments and options that several commands share, and what is wrong with those that were typed, in one line.

They are checked and completed as they are parsed, whether or not a file needs them; what that takes is imported only
when the shell asks for it or the value is given.
"""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any

import typer

from assess.cli import stderr
from assess.messages.message import escape_text

FIGURE_ENDINGS = (".svg", ".pdf", ".png")


def _limit_jobs(jobs: int | None) -> int | None:
    """Limit the number of processes to the cores of the machine; more would only wait for each other."""
    from assess.workers import available_cores

    return None if jobs is None else min(jobs, available_cores())


class Language(StrEnum):
    """Languages in which a report can be written."""

    ENGLISH = "en"
    ITALIAN = "it"


class UpAxis(StrEnum):
    """The axis of a file that points up."""

    Y = "y"
    Z = "z"


ProjectPath = Annotated[
    Path, typer.Argument(metavar="PROJECT", help="The project file, or the folder that contains project.toml.")
]

FigurePath = Annotated[
    Path | None, typer.Option("-o", "--output", metavar="FIGURE", help="Draw a figure: a .svg, .pdf or .png file.")
]

JobsOption = Annotated[
    int | None,
    typer.Option(
        "--jobs",
        metavar="N",
        min=1,
        callback=_limit_jobs,
        help="Number of processor cores to use, at most those of the machine (default: all).",
    ),
]


def folder_option(words: str) -> Any:
    """Return the option -o of a command that writes into a folder."""
    return typer.Option("-o", "--output", metavar="DIR", help=words)


@contextmanager
def optional_output(folder: Path | None, *, command: str, owner: str, expected: Sequence[str]) -> Iterator[Path | None]:
    """Give a temporary folder as `output_folder` does, and print what is recovered; None where no folder is named.

    Parameters
    ----------
    folder : to write into
    command, owner, expected : as for `output_folder`
    """
    if folder is None:
        yield None
        return
    from assess.outputs.writing import output_folder

    with output_folder(folder, command=command, owner=owner, expected=expected, tell=stderr.print_message) as stage:
        yield stage


def flag(name: str, words: str) -> Any:
    """Return an option that is given or not."""
    return typer.Option(name, help=words)


def refuse_two_formats(*, as_json: bool, as_csv: bool) -> None:
    """Raise BadParameter where two formats are requested."""
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")


def check_figure_path(output: Path | None) -> None:
    """Raise BadParameter for a figure's path with another extension, or in a folder that does not exist."""
    if output is not None and output.suffix.lower() not in FIGURE_ENDINGS:
        raise typer.BadParameter(f"{output}: a figure is written as {', '.join(FIGURE_ENDINGS)}; use one of these")
    if output is not None and not output.parent.is_dir():
        raise typer.BadParameter(f"{output}: the folder {output.parent} does not exist; create it first")


def check_share(number: float) -> float:
    """Return a number; raise BadParameter unless it is from 0 to 1."""
    if not 0.0 <= number <= 1.0:
        raise typer.BadParameter(f"{number:g}; it must be from 0 to 1")
    return number


def check_damping(damping: float) -> float:
    """Return a damping ratio; raise BadParameter for one that is impossible."""
    if not 0.0 <= damping < 1.0:
        raise typer.BadParameter(f"{damping:g}; it must be at least 0 and below 1")
    return damping


def _set_level(name: str, other: str) -> Callable[[bool], None]:
    def set_level(given: bool) -> None:
        if not given:
            return
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

VERBOSITY = [
    inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=False, annotation=annotation)
    for name, annotation in (("quiet", Quiet), ("verbose", Verbose))
]


def with_verbosity(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that also takes --quiet and --verbose; it need not know of them."""
    own = inspect.signature(command, eval_str=True)

    @functools.wraps(command)
    def run(**values: Any) -> None:
        command(**{name: value for name, value in values.items() if name in own.parameters})

    setattr(run, "__signature__", own.replace(parameters=[*own.parameters.values(), *VERBOSITY]))  # noqa: B010
    return run


def first_sentence(command: Callable[..., None]) -> str:
    """Return what a command does, whole, for the list of commands, which else cuts it off."""
    return " ".join((command.__doc__ or "").split("\n\n")[0].split())


Completion = Callable[[str], Sequence[str]]


def complete_words(*words: str) -> Completion:
    """Return the completion of an option that takes one of these words."""

    def complete(incomplete: str) -> Sequence[str]:
        return [word for word in words if word.startswith(incomplete)]

    return complete


def word_option(help: str, *words: str) -> Any:
    """Return an option that takes one of these words."""
    return typer.Option(metavar="WORD", help=help, autocompletion=complete_words(*words))


def complete_units(incomplete: str) -> Sequence[str]:
    """Complete a unit of acceleration."""
    from spectra.columns import ACCELERATION_UNITS

    return [unit for unit in ACCELERATION_UNITS if unit.startswith(incomplete)]


def _check_unit(unit: str | None) -> str | None:
    """Return a unit of acceleration; raise BadParameter for one that is not known."""
    if unit is not None:
        from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

        try:
            factor_of(unit, known=ACCELERATION_UNITS)
        except ColumnError as error:
            raise typer.BadParameter(str(error)) from None
    return unit


def _check_step(step: float | None) -> float | None:
    """Return a time step [s]; raise BadParameter for one that no record has."""
    if step is not None:
        from records.reading import COARSEST, FINEST

        if not FINEST <= step <= COARSEST:
            raise typer.BadParameter(f"time step {step:g} s; records have {FINEST:g} to {COARSEST:g} s")
    return step


def _check_response_file(path: Path | None) -> Path | None:
    """Return the file of an instrument's response; raise BadParameter where there is none."""
    if path is not None and not path.is_file():
        raise typer.BadParameter(f"{path}: no such file; give the StationXML of the instrument")
    return path


def check_azimuth(azimuth: float | None) -> float | None:
    """Return an azimuth [deg]; raise BadParameter beyond one turn."""
    if azimuth is not None and not abs(azimuth) <= 360.0:
        raise typer.BadParameter(f"{azimuth:g} deg; it must be from -360 to 360")
    return azimuth


Files = Annotated[list[Path], typer.Argument(metavar="FILES…", help="Record files of any known format.")]

UnitOption = Annotated[
    str | None,
    typer.Option(
        metavar="UNIT",
        help="Unit of acceleration where a file does not state it: g, m/s2, cm/s2, gal, mm/s2.",
        callback=_check_unit,
        autocompletion=complete_units,
    ),
]

StepOption = Annotated[
    float | None,
    typer.Option(metavar="SECONDS", help="Time step where a file does not state it.", callback=_check_step),
]

Response = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE", help="StationXML of the instrument, for MiniSEED and SAC files.", callback=_check_response_file
    ),
]

FlatfileOption = Annotated[
    Path | None, typer.Option(metavar="CSV", help="PEER flatfile with magnitude, distance, Vs30 and NGA number.")
]

CatalogueOption = Annotated[
    Path | None, typer.Option(metavar="FILE", help="Path of the catalogue (default: in the folder itself).")
]
TARGET = typer.Option(metavar="FILE", help="A project, for its site's spectrum, or a CSV of period and ordinate.")
Target = Annotated[Path, TARGET]


WRONG_USAGE: Any = typer.BadParameter.__mro__[1]
"""The parent, not exported by typer, of errors in unknown commands and options too."""

SENTENCES = (
    (r"Value error, ", ""),
    (r"Input should be a valid integer.*", '"{value}" is not a whole number'),
    (r"Input should be a valid number.*", '"{value}" is not a number'),
    (r"Input should be greater than or equal to (\S+)", r"{value}: must be at least \1"),
    (r"Input should be less than or equal to (\S+)", r"{value}: must be at most \1"),
    (r"\. Did you mean (.*)\?$", r"; did you mean \1?"),
    (r" \(Possible options: (.*)\)", r"; did you mean \1?"),
)
"""Patterns of the libraries' sentences, and the sentences that replace them."""


def usage_error(error: Any) -> str | None:
    """Return what is wrong with the command and where its help is; None for any other error."""
    if not isinstance(error, WRONG_USAGE):
        return None
    command = "assess" if error.ctx is None else error.ctx.command_path
    text = _usage_text(error)
    return f"{text} See `{command} --help`" if text.endswith("?") else f"{text}; see `{command} --help`"


def _usage_text(error: Any) -> str:
    """Return what is wrong, with the value where the library omits it."""
    text: str = error.format_message().rstrip(".")
    for theirs, ours in SENTENCES:
        text = re.sub(theirs, ours, text)
    return text.replace("{value}", _given_value(error))


def _given_value(error: Any) -> str:
    """Return the value given, as the library that checked it kept it."""
    for cause in (error.__cause__, error.__context__):
        if hasattr(cause, "errors"):
            return escape_text(str(cause.errors()[0]["input"]))
    return "this"
