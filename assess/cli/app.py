"""The commands under one name, and errors in their use in one line.

Heavy modules are imported inside the commands, so that --help stays fast.
"""

from __future__ import annotations

import re
from typing import Annotated, Any

import typer
from typer import BadParameter

from assess.cli.analysis import batch, envelope, fragility, run
from assess.cli.geometry import geometry
from assess.cli.options import Quiet, Verbose, first_sentence, with_verbosity
from assess.cli.project import check, new, parameters, schema
from assess.cli.records import records
from assess.cli.results import diff, report, summary
from assess.cli.spectrum import spectrum
from assess.cli.verify import verify

ABSENT = ("help", "quiet", "verbose", "install_completion", "show_completion")

app = typer.Typer(
    help="Seismic assessment of masonry walls: rocking dynamics and code checks, in a report to sign.",
    invoke_without_command=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={
        "help_option_names": ["-h", "--help"],
        # else typer 0.29 imports pydantic (0.2 s) for options that are absent
        "default_map": {**dict.fromkeys(ABSENT, False), "records": {"help": False}},
    },
)

COMMANDS = (
    new, check, run, batch, parameters, spectrum, envelope,
    fragility, geometry, report, diff, summary, verify, schema,
)  # fmt: skip

for command in COMMANDS:
    app.command(short_help=first_sentence(command))(with_verbosity(command))
app.add_typer(records, name="records", short_help=records.info.help)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        print(f"assess {version('rocking-assess')}")
        raise typer.Exit


@app.callback()
def _assess(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and exit.")
    ] = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> None:
    if context.invoked_subcommand is None:
        print(context.get_help())
        raise typer.Exit(2)


WRONG_USAGE: Any = BadParameter.__mro__[1]  # typer does not export this parent, of unknown commands and options too

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
    from assess.messages.message import escape_text

    for cause in (error.__cause__, error.__context__):
        if hasattr(cause, "errors"):
            return escape_text(str(cause.errors()[0]["input"]))
    return "this"
