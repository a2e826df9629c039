"""`assess envelope`: overturning envelopes, and the critical mechanism for each frequency."""

from __future__ import annotations

import sys
from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.arguments import Jobs, ProjectPath


def envelope(
    project: ProjectPath,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="DIR",
            help="Write envelopes.pdf, envelopes.html, envelopes.json, tables and figures there.",
        ),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print mechanisms' envelopes and the critical ones as in results.json.")
    ] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the lower bounds as CSV, at full precision.")] = False,
    jobs: Jobs = None,
) -> None:
    """Find which pulses of the ground overturn each mechanism, and which mechanism is critical at each frequency.

    The pulses are those of [analysis.pulses]; else sines of 0.2 to 10 Hz and up to 3 g. No spectrum is needed. Prints
    tables; writes files only with -o. Sweeps are left out: mechanisms stand as the project has them.
    """
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")
    from assess.project.schema import load

    loaded = load(project)
    from assess.cli.description import warned
    from assess.cli.envelope_table import csv_text, json_text, table_text
    from assess.cli.processes import cores, processes
    from assess.cli.progress import progress
    from assess.cli.warning import tell
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import ENVELOPES
    from assess.project.build import build
    from assess.results.json import dumps
    from assess.study.envelope_run import envelope as of_study

    wanted = (ENVELOPES, "envelopes.pdf", "envelopes.html", "tables.xlsx")
    place = (
        nullcontext()
        if output is None
        else output_folder(output, command="assess envelope", owner=ENVELOPES, wanted=wanted, tell=tell)
    )
    with place as stage, progress() as said:
        with processes(jobs) as executor:
            study = build(loaded, executor=executor)
        results = of_study(study, jobs=jobs or cores(), progress=said.count)
        if stage is not None:
            from reports.assessment import envelope_report
            from reports.writing import write_document

            (stage / ENVELOPES).write_bytes(dumps(results).encode())
            write_document(envelope_report(results), stage, name="envelopes.pdf", jobs=jobs or 0, progress=said.step)
    if as_json or as_csv:  # the table ends with them
        print(warned(results.warnings), end="", file=sys.stderr)
    print((json_text if as_json else csv_text if as_csv else table_text)(results), end="")
    if output is not None and not (as_json or as_csv):
        print(output / "envelopes.pdf")
