"""`assess fragility`: how likely each mechanism is to rock and to overturn, and how often."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.completions import export_formats
from assess.cli.options import Jobs, ProjectPath, flag, folder_option, refuse_both

FORMATS = ("nrml", "pelicun", "csv")


def check_formats(text: str | None) -> str | None:
    """Return the formats of an export, separated by commas; raise BadParameter for one that is not known."""
    for name in [] if text is None else text.split(","):
        if name not in FORMATS:
            raise typer.BadParameter(f'"{name}" is no format of exports; write of {",".join(FORMATS)}')
    return text


def fragility(
    project: ProjectPath,
    output: Annotated[
        Path | None, folder_option("Folder to write fragility.pdf, .html and .json, tables, figures and exports to.")
    ] = None,
    export: Annotated[
        str | None,
        typer.Option(
            "--export",
            metavar="FORMATS",
            help="Also write the curves for other programs: nrml, pelicun, csv, or several with commas; needs -o.",
            callback=check_formats,
            autocompletion=export_formats,
        ),
    ] = None,
    as_json: Annotated[bool, flag("--json", "Print what fragility.json holds, in place of the table.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print medians, dispersions and rates as CSV.")] = False,
    jobs: Jobs = None,
) -> None:
    """Find how likely each mechanism is to rock and to overturn at each intensity, and how often it does so.

    Measures, states and method are those of [analysis.fragility], the hazard that of [analysis.risk] or of an Italian
    site over return periods. Records are scaled from what they are, not from the spectrum. Prints a table; files are
    written only with -o. Sweeps are ignored.
    """
    refuse_both(as_json=as_json, as_csv=as_csv)
    if export is not None and output is None:
        raise typer.BadParameter("--export needs -o, the folder to write to")
    from assess.project.schema import load

    loaded = load(project)
    from assess.cli.interruption import NOTHING_WRITTEN, on_interruption
    from assess.cli.optional_folder import optional_folder
    from assess.cli.progress import progress
    from assess.cli.stderr import print_messages
    from assess.cli.tables.fragility import csv_text, table_text
    from assess.outputs.manifest import FRAGILITY
    from assess.project.build import build
    from assess.results.json import dumps_fragility
    from assess.study.fragility.exports import FORMATS as FILES
    from assess.study.fragility.exports import export as export_curves
    from assess.study.fragility.fragility import run_fragility
    from assess.workers import available_cores, process_pool

    formats = [] if export is None else list(dict.fromkeys(export.split(",")))
    exported = [name for format in formats for name in FILES[format]]
    wanted = (FRAGILITY, "fragility.pdf", "fragility.html", "tables.xlsx", *exported)
    place = optional_folder(output, command="assess fragility", owner=FRAGILITY, wanted=wanted)
    with place as stage, on_interruption(NOTHING_WRITTEN), progress() as shown:
        with process_pool(jobs) as executor:
            study = build(loaded, executor=executor)
        results = run_fragility(study, jobs=jobs or available_cores(), progress=shown.count)
        if stage is not None:
            from reports.assessment import fragility_report
            from reports.writing import write_document

            (stage / FRAGILITY).write_bytes(dumps_fragility(results).encode())
            write_document(fragility_report(results), stage, name="fragility.pdf", jobs=jobs or 0, progress=shown.step)
            files, left_out = export_curves(results, formats)
            for name, text in files.items():
                (stage / name).write_bytes(text.encode())
            print_messages(left_out)
    if as_json or as_csv:  # the table includes them
        print_messages(results.warnings)
    print(dumps_fragility(results) if as_json else csv_text(results) if as_csv else table_text(results), end="")
    if output is not None and not (as_json or as_csv):
        print(output / "fragility.pdf")
