"""The inputs: files, values of the project, and the warnings of the run."""

from __future__ import annotations

from dataclasses import replace

from assess.results import Results
from reports.document import Block, Column, Section, Table, Text, nonempty
from reports.language.message_text import message_text
from reports.language.numerals import entries

LONG = 120  # characters; longer titles are shortened where they head something and printed once in full


def annex(results: Results) -> Section:
    """Return the annex: title and notes in full, files, and values of the project."""
    title, notes = project_text(results, "title"), project_text(results, "notes")
    blocks: list[Block] = []
    blocks += [Text((f"Title in full: {title}",))] if len(title) > LONG else []
    blocks += [Text((f"Notes: {notes}",))] if notes else []
    blocks += [*nonempty(inputs(results)), *nonempty(values_present(results))]
    return Section("Annex: inputs", 0, tuple(blocks), starts_page=True)


def project_text(results: Results, key: str) -> str:
    """Return a text of the project file.

    Parameters
    ----------
    results : of a run
    key : with dots, as "report.language"

    Returns
    -------
    str
        empty where the project gives none
    """
    found = results.project.get(key)
    return "" if found is None or found.value is None else str(found.value)


def inputs(results: Results) -> Table:
    """Tabulate the files that were read."""
    rows = tuple((each.path, each.sha256) for each in results.inputs)
    return Table("inputs", "Files read, and their SHA-256.", (Column("File"), Column("SHA-256")), rows)


def values(results: Results, *, name: str = "values") -> Table:
    """Tabulate every value of the project as it was used."""
    columns = (Column("Key", kind="given"), Column("Value (SI)", kind="given"), Column("Source"))
    rows = tuple(
        (entry, cell, "given" if each.given else "default")
        for key, each in results.project.items()
        for entry, cell in entries(key, each.value)
    )
    muted = frozenset(place for place, (_, _, source) in enumerate(rows) if source == "default")
    caption = "Every value of the project file as it was used, in SI units; defaults (grey) were not given by the user."
    return Table(name, caption, columns, rows, muted)


def values_present(results: Results) -> Table:
    """Tabulate the values of the project without keys that are not given and have no default."""
    project = {key: each for key, each in results.project.items() if each.given or each.value not in (None, "", [], {})}
    return values(replace(results, project=project), name="values-set")


def warnings(results: Results) -> Table:
    """Tabulate the warnings and notes of the run."""
    rows = tuple((each.key, each.severity.value, each.where, message_text(each)) for each in results.warnings)
    columns = (Column("Code", kind="given"), Column("Severity"), Column("Where", kind="given"), Column("What"))
    return Table("warnings", "Warnings and notes of this run.", columns, rows)
