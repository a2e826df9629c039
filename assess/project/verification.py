"""The annex of verification beside a project: found for a run, and signed with the project's front matter."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from assess.errors import ProjectError, ResultsError
from assess.messages.message import Message, list_values, warning, whole_number
from assess.outputs.manifest import VERIFICATION
from assess.project.file_digests import file_sha256
from assess.project.report_matter import report_matter_of
from assess.project.schema import Project, resolve
from assess.results import Input
from assess.results.files import read_verification
from assess.results.program import describe_program
from assess.results.solved_cases import exercised_by_case, keys_for
from assess.results.uses import USES
from assess.results.verification import AnnexResult, VerificationResults
from records.paths import relative_path

WHERE = "report.verification"
SHOWN = ("report.language", "report.paper", "report.units")
"""Keys that say how the annex of a project looks."""


def with_project(results: VerificationResults, project: Project) -> VerificationResults:
    """Return results with the front matter of the project whose cases these are.

    Parameters
    ----------
    results : of the cases
    project : as read
    """
    values = {key: each for key, each in resolve(project).items() if key in ("title", *SHOWN)}
    return replace(
        results,
        inputs=(Input(project.path.name, project.sha256),),
        project=values,
        report=report_matter_of(project.content, project.folder),
    )


def annex_file(project: Project) -> Path | None:
    """Return the verification.json that a project names, or that stands in its default place; None if there is none."""
    named = project.content.report.verification
    if named is not None:
        return named
    place = project.folder / f"{project.path.stem}-verification" / VERIFICATION
    return place if place.is_file() else None


def annex_files(project: Project, annex: AnnexResult | None) -> tuple[Path, ...]:
    """Return the files of the annex that the report names: its results, and the PDF beside them; none without one."""
    file = None if annex is None else annex_file(project)
    return () if file is None else tuple(each for each in (file, file.with_suffix(".pdf")) if each.is_file())


def _messages(annex: AnnexResult) -> Iterator[Message]:
    """Yield what limits the annex that a run names."""
    where = WHERE
    if annex.program.sha256 != describe_program().sha256:
        yield warning("annex-other-sources", where, file=annex.path)
    if annex.failures:
        failures, cases = whole_number(annex.failures), whole_number(annex.cases)
        yield warning("annex-failures", where, file=annex.path, failures=failures, cases=cases)
    if annex.quick:
        yield warning("annex-quick", where, file=annex.path)
    if annex.left_out and not annex.quick:
        yield warning("annex-left-out", where, file=annex.path, number=whole_number(annex.left_out))
    if annex.foreign:
        yield warning("annex-foreign", where, file=annex.path, number=whole_number(annex.foreign))
    if not annex.pdf_as_written:
        yield warning("annex-pdf", where, file=annex.path)
    if annex.uncovered:
        yield warning(
            "annex-uncovered", where, file=annex.path, uses=list_values(*map(USES.__getitem__, annex.uncovered))
        )


def annex_of(project: Project, uses: Sequence[str]) -> tuple[AnnexResult | None, tuple[Message, ...]]:
    """Return what a run says of its annex, None if there is none, and the messages on it.

    An annex in the default place that cannot be read gets a message, and the run goes on as without one.

    Parameters
    ----------
    project : as read
    uses : what it uses, in the words of `assess.results.uses`

    Raises
    ------
    ProjectError : the project names a file that cannot be read as verification.json, was changed since it was written,
        or has no cases
    """
    file = annex_file(project)
    if file is None:
        return None, ()
    try:
        annex = _annex(file, project, uses)
    except ResultsError as error:
        if project.content.report.verification is not None:
            raise ProjectError(f"{WHERE}: {error}") from None
        path, why = relative_path(file, project.folder), str(error).removeprefix(f"{file}: ")
        return None, (warning("annex-left-aside", WHERE, file=path, why=why),)
    return annex, tuple(_messages(annex))


def _annex(file: Path, project: Project, uses: Sequence[str]) -> AnnexResult:
    """Read an annex; what it leaves out is counted for this project, whatever it was made for."""
    found = read_verification(file)
    if not found.cases:
        raise ResultsError(f"{file}: has no cases; run `assess verify` again")
    run = {each.key for each in found.cases}
    pdf = file.with_suffix(".pdf")
    pdf_sha256 = file_sha256(pdf) if pdf.is_file() else ""
    return AnnexResult(
        path=relative_path(file, project.folder),
        sha256=file_sha256(file),
        pdf_sha256=pdf_sha256,
        program=found.program,
        cases=len(found.cases),
        failures=len(found.failures),
        quick=found.quick,
        uncovered=tuple(use for use in uses if use not in found.passed_uses),
        left_out=len(keys_for(exercised_by_case(), uses) - run),
        foreign=len(found.foreign),
        pdf_as_written=bool(pdf_sha256) and pdf_sha256 == found.pdf_sha256,
    )
