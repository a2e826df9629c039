"""The commands that analyse: `run` a project, `batch` for many, `envelope` under pulses, `fragility` under records."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import JobsOption, ProjectPath, flag, folder_option, optional_output, refuse_two_formats
from assess.cli.stderr import (
    NOTHING_WRITTEN,
    is_verbose,
    on_interruption,
    print_detail,
    print_message,
    print_messages,
    print_note,
    progress,
)

if TYPE_CHECKING:
    from assess.portfolio.batch import Portfolio
    from assess.portfolio.tasks import Keep
    from assess.results import Results


MOST_WORST = 5  # projects of a portfolio that are named
MOST_REASONS = 5  # that leave projects of a portfolio incomplete or broken
FORMATS = ("nrml", "pelicun", "csv")
"""The keys of `EXPORT_FORMATS`, whose module takes a second to import."""


def run(
    project: ProjectPath,
    output: Annotated[
        Path | None, folder_option("Output folder (default: NAME-results beside the project file NAME.toml).")
    ] = None,
    jobs: JobsOption = None,
    no_report: Annotated[bool, flag("--no-report", "Write only results.json.")] = False,
    verify: Annotated[
        bool, flag("--verify", "First do what `assess verify --for PROJECT` does; its page ends the report.")
    ] = False,
    before: Annotated[
        Path | None,
        typer.Option(
            "--before",
            metavar="RESULTS",
            help="The results.json of the state before the works, in place of that which [verdict] before names.",
        ),
    ] = None,
) -> None:
    """Assess every mechanism and write the report.

    Writes report.pdf, report.html, results.json, tables.xlsx, tables/*.csv and figures/*.svg, and prints the verdict,
    that of each mechanism and the path of the report; notes that bear on nothing that decides only with -v. The exit
    code is 0 for a pass, 1 for a fail and 3 for an incomplete verdict; the last lines then say what is missing.
    """
    results, path = _run_project(project, output, jobs, report=not no_report, verify=verify, before=before)
    from assess.cli.tables.analysis import exit_code, run_text

    print(run_text(results, verbose=is_verbose()), end="")
    print(path)
    raise typer.Exit(exit_code(results))


def batch(
    source: Annotated[
        Path,
        typer.Argument(
            metavar="FOLDER|TABLE", help="A folder with projects below it, or a table of them (CSV or XLSX)."
        ),
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
    jobs: JobsOption = None,
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
    decimal_comma: Annotated[
        bool, flag("--decimal-comma", "Numbers of the table have decimal commas, as they have between semicolons.")
    ] = False,
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
            decimal_comma=decimal_comma,
            tell=print_note,
            progress=shown.count,
        )
    print(_portfolio_text(found), end="")
    raise typer.Exit(found.exit_code)


def envelope(
    project: ProjectPath,
    output: Annotated[
        Path | None, folder_option("Folder to write envelopes.pdf, .html and .json, tables and figures to.")
    ] = None,
    as_json: Annotated[bool, flag("--json", "Print envelopes and critical mechanisms as in results.json.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the lower bounds as CSV at full precision.")] = False,
    jobs: JobsOption = None,
) -> None:
    """Find the ground pulses that overturn each mechanism, and the critical mechanism at each frequency.

    The pulses are those of [analysis.pulses], by default sines from 0.2 to 10 Hz and up to 3 g. No spectrum is needed.
    Prints tables; files are written only with -o. Sweeps are ignored: the envelopes use the values in the project file.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.project.project_file import load

    loaded = load(project)
    from assess.cli.tables.analysis import envelopes_csv, envelopes_table
    from assess.outputs.manifest import ENVELOPES
    from assess.project.build import build
    from assess.results.json import dumps, dumps_envelopes
    from assess.study.envelopes import run_envelopes
    from assess.workers import available_cores, process_pool

    expected = (ENVELOPES, "envelopes.pdf", "envelopes.html", "tables.xlsx")
    place = optional_output(output, command="assess envelope", owner=ENVELOPES, expected=expected)
    with place as stage, on_interruption(NOTHING_WRITTEN), progress() as shown:
        with process_pool(jobs) as executor:
            study = build(loaded, executor=executor)
        results = run_envelopes(study, jobs=jobs or available_cores(), progress=shown.count)
        if stage is not None:
            from reports.assessment import envelope_report, write_document

            (stage / ENVELOPES).write_bytes(dumps(results).encode())
            write_document(envelope_report(results), stage, name="envelopes.pdf", jobs=jobs or 0, progress=shown.step)
    if as_json or as_csv:  # the table includes them
        print_messages(results.warnings)
    print((dumps_envelopes if as_json else envelopes_csv if as_csv else envelopes_table)(results), end="")
    if output is not None and not (as_json or as_csv):
        print(output / "envelopes.pdf")


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
            callback=_check_formats,
            autocompletion=_complete_formats,
        ),
    ] = None,
    as_json: Annotated[bool, flag("--json", "Print what fragility.json holds, in place of the table.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print medians, dispersions and rates as CSV.")] = False,
    jobs: JobsOption = None,
) -> None:
    """Find how likely each mechanism is to rock and to overturn at each intensity, and how often it does so.

    Measures, states and method are those of [analysis.fragility], the hazard that of [analysis.risk] or of an Italian
    site over return periods. Records are scaled from what they are, not from the spectrum. Prints a table; files are
    written only with -o. Sweeps are ignored.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    if export is not None and output is None:
        raise typer.BadParameter("--export needs -o, the folder to write to")
    from assess.project.project_file import load

    loaded = load(project)
    from assess.cli.tables.analysis import fragility_csv, fragility_table
    from assess.outputs.manifest import FRAGILITY
    from assess.project.build import build
    from assess.results.json import dumps_fragility
    from assess.study.fragility import EXPORT_FORMATS, export_curves, run_fragility
    from assess.workers import available_cores, process_pool

    formats = [] if export is None else list(dict.fromkeys(export.split(",")))
    exported = [name for format in formats for name in EXPORT_FORMATS[format]]
    expected = (FRAGILITY, "fragility.pdf", "fragility.html", "tables.xlsx", *exported)
    place = optional_output(output, command="assess fragility", owner=FRAGILITY, expected=expected)
    with place as stage, on_interruption(NOTHING_WRITTEN), progress() as shown:
        with process_pool(jobs) as executor:
            study = build(loaded, executor=executor)
        results = run_fragility(study, jobs=jobs or available_cores(), progress=shown.count)
        if stage is not None:
            from reports.assessment import fragility_report, write_document

            (stage / FRAGILITY).write_bytes(dumps_fragility(results).encode())
            write_document(fragility_report(results), stage, name="fragility.pdf", jobs=jobs or 0, progress=shown.step)
            files, left_out = export_curves(results, formats)
            for name, text in files.items():
                (stage / name).write_bytes(text.encode())
            print_messages(left_out)
    if as_json or as_csv:  # the table includes them
        print_messages(results.warnings)
    print(
        dumps_fragility(results) if as_json else fragility_csv(results) if as_csv else fragility_table(results), end=""
    )
    if output is not None and not (as_json or as_csv):
        print(output / "fragility.pdf")


def _run_project(
    project: Path, output: Path | None, jobs: int | None, *, report: bool, verify: bool, before: Path | None
) -> tuple[Results, Path]:
    """Run the study and write its files; return the results and the path of the report, or of results.json.

    verify : whether solved cases are run before, into the folder of the annex that the project names
    before : results of the state before the works, in place of those that the project names
    """
    from assess.project.project_file import load

    loaded = load(project, before=before)  # before physics is imported, which takes seconds: errors come at once
    if verify:
        from assess.cli.verify import verify_project

        verify_project(loaded, jobs=jobs)
    from assess.outputs.manifest import REPORT, RESULTS
    from assess.outputs.writing import output_folder
    from assess.project.build import build
    from assess.results.json import dumps
    from assess.study.run import run_study
    from assess.workers import available_cores, process_pool

    folder = output or loaded.folder / f"{loaded.path.stem}-results"
    expected = (RESULTS, *(REPORT if report else ()))
    with (
        output_folder(folder, command="assess run", expected=expected, tell=print_message) as stage,
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
            from reports.assessment import write_all

            main_file = write_all(results, stage, jobs=jobs or 0, progress=shown.step)
    return results, folder / main_file.relative_to(stage)


def _portfolio_text(found: Portfolio) -> str:
    """Write how many projects came to what, the worst of them, why others have no answer, and where the table is."""
    counts = found.count()
    parts = [
        f"{counts[name]} {name}" for name in ("fail", "incomplete", "pass", "no verdict", "broken") if counts[name]
    ]
    number = len(found.rows)
    lines = [f"{number} project{'' if number == 1 else 's'}{': ' if parts else ''}{', '.join(parts)}"]
    from assess.messages.message import count_noun
    from assess.portfolio.tables import quote
    from assess.portfolio.tasks import rank

    worst = [row for row in rank(found.rows) if row.status == "done" and row.outcome in ("fail", "incomplete")]
    for row in worst[:MOST_WORST]:
        margin = "margin not known" if row.margin is None else f"margin {row.margin:.3g}"
        name = f"{quote(row.key)} {quote(row.title)}" if row.title else quote(row.key)
        lines.append(
            f"  {name}: {row.outcome}, {margin}{f', {quote(row.worst_mechanism)}' * bool(row.worst_mechanism)}"
        )
    if len(worst) > MOST_WORST:
        lines.append(f"  and {count_noun(len(worst) - MOST_WORST, 'other project')} that do not pass, in the table")
    reasons = found.count_reasons()
    lines += [f"  {count} x {reason}" for reason, count in reasons[:MOST_REASONS]]
    if len(reasons) > MOST_REASONS:
        lines.append(f"  and {count_noun(len(reasons) - MOST_REASONS, 'other reason')}, in the table")
    if found.table is None:
        lines.append(f"{found.left} of other shares are not done; the last share to end writes the ranked table")
    else:
        lines.append(str(found.table))
    return "".join(f"{line}\n" for line in lines)


def _check_formats(text: str | None) -> str | None:
    """Return the formats of an export, separated by commas; raise BadParameter for one that is not known."""
    for name in [] if text is None else text.split(","):
        if name not in FORMATS:
            raise typer.BadParameter(f'"{name}" is no format of exports; write of {",".join(FORMATS)}')
    return text


def _complete_formats(incomplete: str) -> Sequence[str]:
    """Complete the last of the formats of an export, which stand between commas."""
    before, comma, last = incomplete.rpartition(",")
    return [f"{before}{comma}{name}" for name in FORMATS if name.startswith(last) and name not in before.split(",")]
