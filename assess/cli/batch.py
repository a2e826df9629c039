"""`assess batch`: a portfolio of projects, as one ranked table."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import Jobs, flag, folder_option

if TYPE_CHECKING:
    from assess.portfolio.batch import Portfolio
    from assess.portfolio.tasks import Keep


def batch(
    source: Annotated[
        Path, typer.Argument(metavar="FOLDER|TABLE.csv", help="A folder with projects below it, or a table of them.")
    ],
    template: Annotated[
        Path | None,
        typer.Option(
            "--template",
            metavar="FILE",
            help="The project whose values the rows of TABLE.csv change; needed for a table.",
        ),
    ] = None,
    output: Annotated[
        Path | None, folder_option("Output folder (default: NAME-results beside the folder or table NAME).")
    ] = None,
    jobs: Jobs = None,
    resume: Annotated[bool, flag("--resume", "Keep the projects that are done, and go on with the others.")] = False,
    scheduler: Annotated[
        str | None,
        typer.Option(
            "--scheduler",
            metavar="ADDRESS",
            help="Compute on the workers of a Dask scheduler, such as tcp://10.0.0.1:8786, in place of --jobs.",
        ),
    ] = None,
    shard: Annotated[
        str,
        typer.Option(
            "--shard",
            metavar="I/N",
            show_default=False,
            help="Compute only the i-th of n shares of the projects, such as 1/4 (default: all).",
        ),
    ] = "1/1",
    no_report: Annotated[bool, flag("--no-report", "Write only results.json of each project and the table.")] = False,
    rows_only: Annotated[
        bool, flag("--rows-only", "Write only the ranked table, and nothing of each project.")
    ] = False,
) -> None:
    """Assess every project below a folder, or one for each row of a table, and rank them.

    Writes ranked.html, ranked.xlsx and ranked.csv, and a report for each project. A project that cannot be assessed is
    a row with its reason. The exit code is the worst of the projects' own: 70 for a bug in the program, 2 for wrong
    input, 1 for a fail, 3 for an incomplete verdict, 0 if all pass.
    """
    keep: Keep = "rows" if rows_only else "results" if no_report else "report"
    if scheduler is not None and jobs is not None:
        raise typer.BadParameter("--jobs is of this machine's processes; the scheduler has workers of its own")
    from assess.cli.interruption import on_interruption
    from assess.cli.progress import progress
    from assess.cli.stderr import print_note
    from assess.verbs import batch as run_batch

    whole = source.resolve()
    folder = output or whole.parent / f"{whole.name if whole.is_dir() else whole.stem}-results"
    with on_interruption(f"what is done is kept in {folder}; go on with --resume"), progress() as shown:
        found = run_batch(
            source,
            folder,
            template=template,
            jobs=jobs or 0,
            resume=resume,
            scheduler=scheduler,
            shard=shard,
            keep=keep,
            tell=print_note,
            progress=shown.count,
        )
    print(summary(found), end="")
    raise typer.Exit(found.exit_code)


def summary(found: Portfolio) -> str:
    """Write how many projects came to what, and where the table is."""
    counts = found.count()
    parts = [
        f"{counts[name]} {name}" for name in ("fail", "incomplete", "pass", "no verdict", "broken") if counts[name]
    ]
    number = len(found.rows)
    lines = [f"{number} project{'' if number == 1 else 's'}{': ' if parts else ''}{', '.join(parts)}"]
    if found.table is None:
        lines.append(f"{found.left} of other shares are not done; the last share to end writes the ranked table")
    else:
        lines.append(str(found.table))
    return "".join(f"{line}\n" for line in lines)
