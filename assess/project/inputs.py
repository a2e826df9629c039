"""The files that a project is made of, each with its hash."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from assess.project import sections
from assess.project.file_digests import file_sha256
from assess.project.fragility import hazard_files
from assess.project.locked_records import files_of_lock
from assess.project.report_matter import picture_files
from assess.project.schema import Project
from assess.project.verification import annex_files
from assess.results import Input
from assess.results.verification import AnnexResult
from records.paths import relative_path
from records.record import Record


def inputs_of(project: Project, records: Sequence[Record], annex: AnnexResult | None) -> Iterator[Input]:
    """Hash the project file and every file it names; if records are selected or locked, only those used.

    Parameters
    ----------
    project : as read
    records : in use
    annex : of verification, whose files are hashed too; None if there is none
    """
    yield Input(project.path.name, project.sha256)
    content = project.content
    bodies = [body.mesh for body in content.bodies.values() if isinstance(body, sections.MeshBody)]
    table = content.site.spectrum if content.site is not None else None
    tables = [table.file] if isinstance(table, sections.TableSpectrum) else []
    used = record_files(content.records, [project.folder / record.path for record in records])
    named = [*hazard_files(content), *picture_files(content), *annex_files(project, annex)]
    for path in dict.fromkeys([*bodies, *tables, *used, *named]):
        yield Input(relative_path(path, project.folder), file_sha256(path))


def record_files(section: sections.Records, paths: Iterable[Path]) -> tuple[Path, ...]:
    """Return the files that the records come from; paths: those of the records in use."""
    if section.lock is not None:
        return files_of_lock(section.lock)
    beside = [path for path in (section.flatfile, section.response) if path is not None]
    return (*(section.files if section.selection is None else paths), *beside)
