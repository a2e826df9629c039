"""`assess records`: commands on files of ground motions."""

from __future__ import annotations

import typer

from assess.cli.records.convert import convert
from assess.cli.records.index import index
from assess.cli.records.list_records import list_records
from assess.cli.records.scale import scale
from assess.cli.records.select import select
from assess.cli.records.spectra import spectra
from assess.cli.verbosity import first_sentence, with_verbosity

records = typer.Typer(
    help="List, process, convert, select and scale records of ground motion.",
    no_args_is_help=False,
    invoke_without_command=True,
    rich_markup_mode=None,
)


@records.callback()
def _records(context: typer.Context) -> None:
    if context.invoked_subcommand is None:
        print(context.get_help())
        raise typer.Exit(2)


records.command("list", short_help=first_sentence(list_records))(with_verbosity(list_records))
for command in (convert, index, spectra, select, scale):
    records.command(short_help=first_sentence(command))(with_verbosity(command))
