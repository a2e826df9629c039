"""`assess run`: the whole assessment."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.arguments import Jobs, ProjectPath
from assess.cli.writer import Begin, writer

if TYPE_CHECKING:
    from assess.results import Results

WRITTEN = ("report.pdf", "report.html", "tables.xlsx")
"""What the report is, beside its tables and figures."""


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
    jobs: Jobs = None,
    no_report: Annotated[bool, typer.Option("--no-report", help="Write results.json only.")] = False,
) -> None:
    """Assess every mechanism and write the report.

    Writes report.pdf, report.html, results.json, tables.xlsx, tables/*.csv and figures/*.svg; prints the verdicts and
    the path of the report. Ends with 0 when the verdict is pass, 1 when it is fail, 3 when it is incomplete; the last
    lines then say what is missing.
    """
    with nullcontext() if no_report else writer(jobs) as report:
        results, path = _assessed(project, output, jobs, report)
    from assess.cli.summary import exit_code, summary

    print(summary(results), end="")
    print(path)
    raise typer.Exit(exit_code(results))


def _assessed(project: Path, output: Path | None, jobs: int | None, report: Begin | None) -> tuple[Results, Path]:
    """The results, and the path of what was written: the PDF where `report` writes one, else results.json."""
    from assess.project.schema import load

    loaded = load(project)  # before the physics is imported, which takes seconds: a slip of the pen is told at once
    from assess.cli.processes import cores, processes
    from assess.cli.progress import progress
    from assess.cli.warning import tell
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import RESULTS
    from assess.project.build import build
    from assess.results.json import dumps
    from assess.study.run import run as run_study

    folder = output or loaded.folder / f"{loaded.path.stem}-results"
    wanted = (RESULTS, *(WRITTEN if report else ()))
    with output_folder(folder, command="assess run", wanted=wanted, tell=tell) as stage, progress() as said:
        with processes(jobs) as executor:
            study = build(loaded, executor=executor)
        results = run_study(study, jobs=jobs or cores(), progress=said.count)
        written = report(results, stage, said.step) if report else None
        main_file = stage / RESULTS
        main_file.write_bytes(dumps(results).encode())
        main_file = written() if written else main_file
    return results, folder / main_file.relative_to(stage)
