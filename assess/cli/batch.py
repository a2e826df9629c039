"""`assess batch`: a portfolio of projects, as one ranked table."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import Jobs

if TYPE_CHECKING:
    from assess.portfolio.batch import Portfolio
    from assess.portfolio.tasks import Keep


def batch(
    source: Annotated[
        Path, typer.Argument(metavar="FOLDER|TABLE.csv", help="A folder with projects below it, or a table of them.")
    ],
    template: Annotated[
        Path | None,
        typer.Option("--template", metavar="FILE", help="The project whose values the rows of the table change."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="DIR",
            help="Output folder (default: NAME-results beside the folder or table NAME).",
        ),
    ] = None,
    jobs: Jobs = None,
    resume: Annotated[
        bool, typer.Option("--resume", help="Keep the projects that are done, and go on with the others.")
    ] = False,
    scheduler: Annotated[
        str | None,
        typer.Option("--scheduler", metavar="ADDRESS", help="Compute on the workers of a Dask scheduler, tcp://…"),
    ] = None,
    shard: Annotated[
        str, typer.Option("--shard", metavar="i/n", help="Compute only the i-th of n shares of the projects.")
    ] = "1/1",
    no_report: Annotated[
        bool, typer.Option("--no-report", help="Write only results.json of each project, and the ranked table.")
    ] = False,
    rows_only: Annotated[
        bool, typer.Option("--rows-only", help="Write nothing of each project besides its row in the ranked table.")
    ] = False,
) -> None:
    """Assess every project below a folder, or one for each row of a table, and rank them.

    Writes ranked.html, ranked.xlsx and ranked.csv, and a report for each project. A project that cannot be assessed is
    a row with its reason. The exit code is the worst of the projects', in the order 70, 2, 1, 3, 0.
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
