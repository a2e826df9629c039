"""The files that a project reads: their hashes for its results, and that none of them changed while they were read.

Several readers are other people's and open a file by its path, so that bytes and hash cannot come from one opening. The
state of every file is noted before the first is read and compared after the last is hashed: a hash is that of the bytes
that were used, or the run ends with an error.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path

from assess.errors import AssessError, ProjectError
from assess.geometry.formats.gltf import companions
from assess.project import sections
from assess.project.project_file import Project
from assess.project.question import hazard_files
from assess.project.record_set import files_of_lock
from assess.project.report import annex_file, annex_files, picture_files
from assess.results import Input
from assess.results.provenance import FileState, file_sha256, file_state
from assess.results.verification import AnnexResult
from records.reading import relative_path
from records.record import Record

FileStates = Mapping[Path, FileState | None]
"""The state of each file; None for one that is not there, and for a folder."""


def note_states(project: Project) -> FileStates:
    """Return the state of every file that a project names, with those that these name."""
    content = project.content
    annex = annex_file(project)
    named = [*_model_and_table_files(content), *hazard_files(content), *picture_files(content)]
    with suppress(AssessError):  # of a lock; who reads it says what is wrong
        named += record_files(content.records, content.records.files)
    return {path: _state(path) for path in (*named, *(() if annex is None else (annex, annex.with_suffix(".pdf"))))}


def refuse_changes(states: FileStates) -> None:
    """Raise ProjectError for a file that is no longer in its state."""
    for path, state in states.items():
        if _state(path) != state:
            raise ProjectError(f"{path}: changed while it was read; run again once it is whole")


def inputs_of(project: Project, records: Iterable[Record], annex: AnnexResult | None) -> Iterator[Input]:
    """Hash the project file and every file it names; if records are selected or locked, only those used.

    Parameters
    ----------
    project : as read
    records : in use
    annex : of verification, whose files are hashed too; None if there is none
    """
    yield Input(project.path.name, project.sha256)
    content = project.content
    used = record_files(content.records, [project.folder / record.path for record in records])
    named = [*hazard_files(content), *picture_files(content), *annex_files(project, annex)]
    for path in dict.fromkeys([*_model_and_table_files(content), *used, *named]):
        yield Input(relative_path(path, project.folder), file_sha256(path))


def record_files(section: sections.Records, paths: Iterable[Path]) -> tuple[Path, ...]:
    """Return the files that the records come from; paths: those of the records in use."""
    if section.lock is not None:
        return files_of_lock(section.lock)
    beside = [path for path in (section.flatfile, section.response) if path is not None]
    return (*(section.files if section.selection is None else paths), *beside)


def _model_and_table_files(content: sections.Content) -> Iterator[Path]:
    """Yield the models of bodies with the files that they name, the table of the spectrum, results of before works."""
    for body in content.bodies.values():
        if isinstance(body, sections.MeshBody):
            yield body.mesh
            yield from companions(body.mesh) if body.mesh.suffix.lower() == ".gltf" else ()
    table = getattr(content.site.spectrum, "file", None) if content.site is not None else None
    yield from (path for path in (table, content.verdict.before) if path is not None)


def _state(path: Path) -> FileState | None:
    """Return the state of a file; None if there is none, or of a folder, where a catalogue is written meanwhile."""
    try:
        return None if path.is_dir() else file_state(path)
    except (OSError, ValueError):
        return None
