"""`assess verify`: solved cases run again on this machine, a line for each, and the annex that reports them."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import JobsOption, Language, flag, optional_output
from assess.cli.stderr import NOTHING_WRITTEN, on_interruption, progress
from assess.cli.tables import on_one_line
from assess.messages.message import count_noun

if TYPE_CHECKING:
    from assess.project.project_file import Project
    from assess.results.verification import CaseResult, Spread, ValueResult, VerificationResults
    from assess.verification.case_files import CaseFile


WIDEST = 160  # characters of a line
MOST_FAILURES = 5  # values that fail, of one case
DIGITS, MOST_DIGITS = 6, 17  # of a value; with the latter every number differs from every other


def verify(
    names: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="CASE", autocompletion=_complete_cases, help="Keys of cases, or of their sources (default: all)."
        ),
    ] = None,
    project: Annotated[
        Path | None,
        typer.Option("--for", metavar="PROJECT", help="Run the cases that concern what a project uses."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="DIR",
            help="Output folder (default: verification, or NAME-verification beside the project file NAME.toml; none "
            "where cases are named, with --list and with --json).",
        ),
    ] = None,
    quick: Annotated[bool, flag("--quick", "Leave out the cases that take long.")] = False,
    listed: Annotated[bool, flag("--list", "List the cases and run none.")] = False,
    as_json: Annotated[bool, flag("--json", "Print what verification.json holds, in place of the lines.")] = False,
    language: Annotated[
        Language | None, typer.Option("--language", help="Language of the annex (default: that of the project, or en).")
    ] = None,
    cases: Annotated[
        Path | None,
        typer.Option("--cases", metavar="DIR", help="Read the cases from this folder, such as the one written before."),
    ] = None,
    jobs: JobsOption = None,
) -> None:
    """Run solved cases and compare them with their sources.

    Writes verification.pdf and verification.html, the annex that NTC 2018 10.2 asks for, verification.json, and the
    folder `cases` with every input file. Prints a line for each case. The exit code is 1 where one fails.
    """
    begun = time.perf_counter()
    from assess.errors import AssessError
    from assess.verification.case_files import cases_for, choose_cases, read_cases

    if cases is not None and not cases.is_dir():
        raise AssessError(f"{cases}: is no folder; give one with files of cases")
    every = read_cases() if cases is None else read_cases(cases)
    chosen = choose_cases(every, names or ())
    loaded, uses = (None, ()) if project is None else _load_project(project)
    chosen = chosen if loaded is None else cases_for(chosen, uses)
    if listed:
        print(_list_cases(chosen), end="")
        return
    if not chosen:
        raise AssessError("there is no such case; list them with `assess verify --list`")
    if quick and not any(each.case.quick for each in chosen):
        raise AssessError("these cases take long; leave out --quick")
    folder = output
    if folder is None and not (names or as_json):
        folder = Path("verification") if loaded is None else _default_folder(loaded)
    results = _run_cases(chosen, folder, loaded, uses, quick=quick, jobs=jobs, language=language)
    if as_json:
        from assess.results.json import dumps_verification

        print(dumps_verification(results), end="")
    else:
        print(verification_text(results, seconds=time.perf_counter() - begun), end="")
        if folder is not None:
            print(folder / "verification.pdf")
    raise typer.Exit(1 if results.failures else 0)


def verify_project(loaded: Project, *, jobs: int | None) -> VerificationResults:
    """Run the cases that concern a project into the folder of its annex, as `assess verify --for PROJECT` does.

    Parameters
    ----------
    loaded : the project as read
    jobs : processes to use, None for as many as there are cores

    Raises
    ------
    ProjectError : the project names a file of another name than what is written
    """
    from assess.errors import ProjectError
    from assess.outputs.manifest import VERIFICATION
    from assess.project.build import uses_of_project
    from assess.verification.case_files import cases_for, read_cases

    uses, named = uses_of_project(loaded), loaded.content.report.verification
    if named is not None and named.name != VERIFICATION:
        raise ProjectError(f'report.verification: "{named.name}" is not what --verify writes: name a {VERIFICATION}')
    folder = _default_folder(loaded) if named is None else named.parent
    return _run_cases(cases_for(read_cases(), uses), folder, loaded, uses, quick=False, jobs=jobs, language=None)


def verification_text(results: VerificationResults, *, seconds: float) -> str:
    """Write a line for each case, what is wrong with those that fail, and the totals.

    Parameters
    ----------
    results : of `assess verify`
    seconds : that it took
    """
    return "".join(
        f"{on_one_line(line, WIDEST)}\n" for line in (*_case_lines(results), *_total_lines(results, seconds))
    )


def _complete_cases(incomplete: str) -> Sequence[str]:
    """Complete the key of a solved case, or of all cases of one source."""
    from assess.results.verification import exercised_by_case

    keys = set(exercised_by_case())
    return [key for key in sorted(keys | {key.partition("/")[0] for key in keys}) if key.startswith(incomplete)]


def _load_project(path: Path) -> tuple[Project, tuple[str, ...]]:
    """Return a project as read, and what it uses."""
    from assess.project.project_file import load

    loaded = load(path)
    from assess.project.build import uses_of_project

    return loaded, uses_of_project(loaded)


def _default_folder(loaded: Project) -> Path:
    return loaded.folder / f"{loaded.path.stem}-verification"


def _run_cases(
    chosen: tuple[CaseFile, ...],
    folder: Path | None,
    loaded: Project | None,
    uses: tuple[str, ...],
    *,
    quick: bool,
    jobs: int | None,
    language: str | None,
) -> VerificationResults:
    """Run cases and write what was asked for; all of it or nothing."""
    from dataclasses import replace

    from assess.outputs.manifest import VERIFICATION
    from assess.verification.verify import coverage_of, note_scope
    from assess.verification.verify import verify as run_cases

    expected = (VERIFICATION, "verification.pdf", "verification.html")
    place = optional_output(folder, command="assess verify", owner=VERIFICATION, expected=expected)
    with place as stage, on_interruption(NOTHING_WRITTEN), progress() as shown:
        results = run_cases(chosen, quick=quick, jobs=jobs, progress=shown.count)
        results = note_scope(replace(results, coverage=coverage_of(uses, results.cases)), uses)
        if loaded is not None:
            from assess.project.report import with_project

            results = with_project(results, loaded)
        if stage is not None:
            from assess.outputs.manifest import digest
            from assess.results.json import dumps_verification
            from assess.verification.case_files import write_cases
            from reports.assessment import verification_report, write_pages

            shown.step("annex")
            write_cases(chosen, results.cases, stage / "cases")
            write_pages(verification_report(results, language), stage, name="verification.pdf", jobs=jobs or 0)
            results = replace(results, pdf_sha256=digest(stage / "verification.pdf") or "")
            (stage / VERIFICATION).write_bytes(dumps_verification(results).encode())
    return results


def _list_cases(cases: tuple[CaseFile, ...]) -> str:
    """Write the key, standing and title of each case."""
    width = max((len(each.key) for each in cases), default=0)
    lines = (f"{each.key:<{width}}  {each.case.source.standing:<14}  {each.case.title}" for each in cases)
    text = "".join(f"{on_one_line(line, WIDEST)}\n" for line in lines)
    if not text:
        sys.stderr.write("assess: note: no case\n")
    return text


def _case_lines(results: VerificationResults) -> Iterator[str]:
    width = max((len(each.key) for each in results.cases), default=0)
    for case in results.cases:
        parts = [count_noun(len(case.values), "value")]
        if case.shares:
            parts.append(f"worst {max(case.shares):.2g} of the tolerance")
        elif case.outcome == "pass":
            parts.append("exact")
        if case.misprints:
            parts.append(count_noun(case.misprints, "misprint"))
        if case.is_indicative:
            parts.append("indicative only")
        remark = case.fault or ", ".join(parts)
        word = "FAIL" if case.outcome == "fail" else "pass"
        yield f"{word}  {case.key:<{width}}  {remark}"
        if case.outcome == "fail" and not case.fault:
            yield from _failures(case)


def _failures(case: CaseResult) -> Iterator[str]:
    wrong = [(each.name, value) for each in case.quantities for value in each.values if value.outcome == "fail"]
    for name, value in wrong[:MOST_FAILURES]:
        yield f"      {name}{f', {value.row}' if value.row else ''}: {_compared(value)}"
    if len(wrong) > MOST_FAILURES:
        yield f"      and {len(wrong) - MOST_FAILURES} more"


def _compared(value: ValueResult) -> str:
    """Write both numbers, with so many digits that they differ."""
    if value.found is None:
        return f"{value.reference:.{DIGITS}g} expected, none found"
    pairs = ((f"{value.reference:.{n}g}", f"{value.found:.{n}g}") for n in range(DIGITS, MOST_DIGITS + 1))
    expected, found = next((each for each in pairs if each[0] != each[1]), (repr(value.reference), repr(value.found)))
    return f"{expected} expected, {found} found"


def _total_lines(results: VerificationResults, seconds: float) -> Iterator[str]:
    from assess.results.verification import USES

    values = sum(len(each.values) for each in results.quantities)
    parts = (
        count_noun(len(results.cases), "case"),
        count_noun(len(results.quantities), "quantity", "quantities"),
        count_noun(values, "value"),
        count_noun(sum(each.misprints for each in results.cases), "misprint"),
        f"{len(results.failures)} failed",
    )
    yield f"{', '.join(parts)}, in {seconds:.0f} s{' (quick cases only)' if results.quick else ''}"
    if results.shares.worst is not None:
        yield f"difference over tolerance: {_spread(results.shares)}"
    if results.relative.worst is not None:
        yield f"over the largest value of its quantity: {_spread(results.relative)} ({', '.join(results.farthest)})"
    indicative = len(results.cases) - len(results.evidence)
    if indicative:
        yield f"{count_noun(indicative, 'case')} indicative only: no evidence, not among these differences"
    if results.foreign:
        yield f"{count_noun(len(results.foreign), 'case')} not as with the program: {', '.join(results.foreign)}"
    bare = [str(USES[each.use]) for each in results.coverage if each.use not in results.passed_uses]
    if bare:
        yield f"used by the project, without a case that passes and is evidence: {'; '.join(bare)}"


def _spread(spread: Spread) -> str:
    if spread.median is None or spread.worst is None:
        return "none"
    return f"median {spread.median:.2g}, worst {spread.worst:.2g}"
