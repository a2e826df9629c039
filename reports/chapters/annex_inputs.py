"""Annex E: what the results were made from, every value in words, and the messages of the run."""

from __future__ import annotations

from assess.results import ResolvedValue, Results
from reports.chapters.cells import blocks_to_paste
from reports.document import Block, Cell, Column, Section, Table, nonempty
from reports.language.texts import Verbatim, say
from reports.project_values import project_values

MARK = "E"
LEFT_OUT = ("report.", "notes", "title")

GIVEN, DEFAULT = say("given"), say("default")


def sections(results: Results) -> list[Section]:
    """Return the annex: files, values of the project and messages."""
    blocks: list[Block] = [
        *nonempty(files_table(results)),
        *nonempty(_values_in_use_table(results)),
        *nonempty(messages_table(results)),
        *([] if results.verdict is None else blocks_to_paste(results, results.verdict)),
    ]
    return [Section(say("Inputs"), 0, tuple(blocks), starts_page=True, mark=MARK)]


def files_table(results: Results) -> Table:
    """Tabulate the files that were read."""
    columns = (Column(say("File"), share=0.42), Column(say("SHA-256")))
    rows = tuple((Verbatim(each.path), Verbatim(each.sha256)) for each in results.inputs)
    return Table("inputs", say("Files read, with their SHA-256."), columns, rows, small=True)


def values_table(results: Results) -> Table:
    """Tabulate every value of the project as it was used."""
    return _table_of_values(results.project, "values")


def messages_table(results: Results) -> Table:
    """Tabulate the warnings and notes of the run."""
    severities = {"error": say("error"), "warning": say("warning"), "note": say("note")}
    rows = tuple((severities[each.severity.value], Verbatim(each.where), each) for each in results.warnings)
    columns = (Column(say("Severity"), share=0.1), Column(say("Where"), share=0.22), Column(say("Message")))
    return Table("warnings", say("Warnings and notes of this run."), columns, rows, small=True)


def _values_in_use_table(results: Results) -> Table:
    """Tabulate the values that were given, and the defaults that are in use."""
    project = {key: each for key, each in results.project.items() if _in_use(key, each)}
    return _table_of_values(project, "values-set")


def _in_use(key: str, each: ResolvedValue) -> bool:
    return not key.startswith(LEFT_OUT) and (each.given or each.value not in (None, "", [], {}))


def _table_of_values(project: dict[str, ResolvedValue], name: str) -> Table:
    columns = (Column(say("Key"), share=0.45), Column(say("Value")), Column(say("Source"), share=0.12))
    rows: tuple[tuple[Cell, ...], ...] = tuple(
        (Verbatim(entry.key), entry.cell, GIVEN if each.given else DEFAULT)
        for key, each in project.items()
        for entry in project_values(key, each)
    )
    muted = frozenset(place for place, row in enumerate(rows) if row[-1] is DEFAULT)
    caption = say("Every value of the project file as it was used. Defaults of the program are grey.")
    return Table(name, caption, columns, rows, muted, small=True)
