"""`assess run`: the whole assessment."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.arguments import ProjectPath


def run(
    project: ProjectPath,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="DIR",
            help="Where to write; NAME-results beside the project file NAME.toml if absent.",
        ),
    ] = None,
    jobs: Annotated[
        int | None, typer.Option("--jobs", metavar="N", min=1, help="Processor cores to use; all if absent.")
    ] = None,
    no_report: Annotated[bool, typer.Option("--no-report", help="Write results.json only.")] = False,
) -> None:
    """Assess every mechanism and write the report.

    Writes report.pdf, report.html, results.json, tables.xlsx, tables/*.csv and figures/*.svg; prints the verdicts and
    the path of the report. Ends with 0 when no check fails, 1 when some check does; what could not be answered is told.
    """
    from assess.project.schema import load

    loaded = load(project)  # before the physics is imported, which takes seconds: a slip of the pen is told at once
    from assess.cli.outputs import RESULTS, staged
    from assess.cli.processes import processes
    from assess.cli.progress import progress
    from assess.cli.summary import some_check_fails, summary
    from assess.project.build import build
    from assess.project.run import run as run_study
    from assess.results_io import dumps

    folder = output or loaded.folder / f"{loaded.path.stem}-results"
    with staged(folder) as stage, progress() as said:
        with processes(jobs) as executor:
            study = build(loaded, executor=executor)
        results = run_study(study, jobs=jobs or os.cpu_count() or 1, progress=said.count)
        main_file = stage / RESULTS
        main_file.write_bytes(dumps(results).encode())
        if not no_report:
            from reports.writing import write_all

            main_file = write_all(results, stage, jobs=jobs or 0, progress=said.step)
    print(summary(results), end="")
    print(folder / main_file.relative_to(stage))
    raise typer.Exit(1 if some_check_fails(results) else 0)
