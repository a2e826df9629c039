"""The commands under one name. Heavy modules are imported inside the commands, so that --help stays fast."""

from __future__ import annotations

from typing import Annotated

import typer

from assess.cli.analysis import batch, envelope, fragility, run
from assess.cli.geometry import geometry
from assess.cli.options import Quiet, Verbose, first_sentence, with_verbosity
from assess.cli.project import check, mechanisms, new, parameters, schema
from assess.cli.records import records
from assess.cli.results import diff, report, summary
from assess.cli.retrofit import retrofit
from assess.cli.serve import serve
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
    new, mechanisms, check, run, batch, parameters, spectrum, envelope,
    fragility, retrofit, geometry, serve, report, diff, summary, verify, schema,
)  # fmt: skip

for command in COMMANDS:
    app.command(short_help=first_sentence(command))(with_verbosity(command))
app.add_typer(records, name="records", short_help=records.info.help)


def _print_version(given: bool) -> None:
    if given:
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
