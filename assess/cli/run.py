"""`assess run`: the whole assessment."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import Jobs, ProjectPath, flag, folder_option

if TYPE_CHECKING:
    from assess.results import Results


def run(
    project: ProjectPath,
    output: Annotated[
        Path | None, folder_option("Output folder (default: NAME-results beside the project file NAME.toml).")
    ] = None,
    jobs: Jobs = None,
    no_report: Annotated[bool, flag("--no-report", "Write only results.json.")] = False,
) -> None:
    """Assess every mechanism and write the report.

    Writes report.pdf, report.html, results.json, tables.xlsx, tables/*.csv and figures/*.svg, and prints the verdicts
    and the path of the report. The exit code is 0 for a pass, 1 for a fail and 3 for an incomplete verdict; the last
    lines then say what is missing.
    """
    results, path = _assess(project, output, jobs, report=not no_report)
    from assess.cli.tables.summary import exit_code, summary

    print(summary(results), end="")
    print(path)
    raise typer.Exit(exit_code(results))


def _assess(project: Path, output: Path | None, jobs: int | None, *, report: bool) -> tuple[Results, Path]:
    """Run the study and write its files; return the results and the path of the report, or of results.json."""
    from assess.project.schema import load

    loaded = load(project)  # before the physics is imported, which takes seconds, so that an error is reported at once
    from assess.cli.interruption import on_interruption
    from assess.cli.progress import progress
    from assess.cli.stderr import print_detail, print_message
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import REPORT, RESULTS
    from assess.project.build import build
    from assess.results.json import dumps
    from assess.study.run import run as run_study
    from assess.workers import available_cores, process_pool

    folder = output or loaded.folder / f"{loaded.path.stem}-results"
    wanted = (RESULTS, *(REPORT if report else ()))
    with (
        output_folder(folder, command="assess run", wanted=wanted, tell=print_message) as stage,
        on_interruption(f"nothing was written into {folder}"),
        progress() as shown,
    ):
        with process_pool(jobs) as executor:
            study = build(loaded, executor=executor)
        results = run_study(study, jobs=jobs or available_cores(), progress=shown.count)
        for record in results.records:
            print_detail(f"record {record.path or record.id}, factor {record.scale_factor:.4g}")
        main_file = stage / RESULTS
        main_file.write_bytes(dumps(results).encode())
        if report:
            from reports.writing import write_all

            main_file = write_all(results, stage, jobs=jobs or 0, progress=shown.step)
    return results, folder / main_file.relative_to(stage)
