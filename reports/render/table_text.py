"""Tables and calculation sheets in letters, as all renderers show them, and the words that these add themselves."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isclose, nan
from pathlib import Path
from typing import TypeGuard

from assess.codes.calculation_sheet import INPUT_FIGURES, RESULT_FIGURES, Step, substitute, values_text, write_plain
from assess.messages.message import Quantity
from reports.document import Banner, Cell, Column, Document, Link, OutcomeCell, Sheet, Table
from reports.language.locale import UNITS, Locale, visible
from reports.language.texts import Term, Text, Verbatim, say
from spectra.arrays import is_number
from spectra.formulas import harmless_cell
from spectra.gravity import g

PlainCell = str | float | int | bool | None
NOTHING = "—"
_WHOLE = 12  # figures of a whole number


def cell_text(cell: Cell, column: Column, locale: Locale) -> str:
    """Return a cell in the letters of a locale.

    Parameters
    ----------
    cell : of a table
    column : whose unit a number has
    locale : language and units

    Returns
    -------
    A dash where there is nothing.
    """
    if cell is None:
        return NOTHING
    if isinstance(cell, bool):
        return locale.text(YES if cell else NO)
    if isinstance(cell, int | float):
        return _number(cell, column, locale)
    return locale.text(cell.text if isinstance(cell, OutcomeCell | Link) else cell) or NOTHING


def column_texts(cells: Sequence[Cell], column: Column, locale: Locale) -> list[str]:
    """Return the cells of a column in letters; zeros follow a number as far as others have decimals, and it figures.

    Parameters
    ----------
    cells : of the column, from above
    column : whose unit numbers have
    locale : language and units
    """
    texts = [cell_text(cell, column, locale) for cell in cells]
    kept = [
        len(text.partition(locale.point)[2]) if _is_measure(cell, text) else 0
        for cell, text in zip(cells, texts, strict=True)
    ]
    pairs = zip(cells, texts, strict=True)
    return [_padded(cell, column, locale, max(kept)) if _is_measure(cell, text) else text for cell, text in pairs]


def is_numeric(cells: tuple[Cell, ...]) -> bool:
    """Return whether a column has numbers alone."""
    return any(map(is_number, cells)) and all(cell is None or is_number(cell) for cell in cells)


def plain_cell(cell: Cell, column: Column, locale: Locale) -> PlainCell:
    """Return a number in the unit of its column; a quantity with a unit of its own as the report shows it.

    A quantity of the dimension of its column, or without a unit, is a number as well; a link is its path.
    """
    if isinstance(cell, float):  # most are
        return _in_unit(cell, column.dimension, locale)
    if isinstance(cell, Link):
        return cell.path
    content = cell.text if isinstance(cell, OutcomeCell) else cell
    if isinstance(content, Quantity) and content.dimension in ("ratio", column.dimension):
        return _in_unit(content.value, content.dimension, locale)
    if content is None or isinstance(content, bool):
        return content
    if isinstance(content, int):
        return _in_unit(content, column.dimension, locale)
    return locale.text(content)


SAME = 1e-3  # of a number: what one printed to four figures stands for
SIGNS: Mapping[str, str] = {"": "", "<=": "≤ ", ">=": "≥ "}
_DECIMAL = re.compile(r"(?<=\d)\.(?=\d)")  # in a formula, which has no other points between digits
_POWERS = str.maketrans("23", "²³")


@dataclass(frozen=True)
class SheetRow:
    """One step.

    numbers : the formula with them after "=", or where the value was read; empty where neither is known
    beside : the result in US units, empty in SI
    """

    symbol: str
    description: str
    clause: str
    formula: str
    numbers: str
    result: str
    beside: str


def sheet_rows(steps: Iterable[Step], locale: Locale) -> Iterator[SheetRow]:
    """Yield the steps of a sheet in the letters of a locale: in SI, and in US units where the locale has them."""
    for step in steps:
        yield SheetRow(
            step.symbol,
            ", ".join(part for part in (_word(step.description, locale), step.subject) if part),
            _word(step.clause, locale),
            _formula(step, locale),
            _numbers(step, locale),
            _result(step, locale),
            _result_in_locale_unit(step, locale),
        )


def equations_line(steps: Sequence[Step], locale: Locale, formula: Callable[[str], str]) -> str:
    """Return the steps in one line, each with what it takes that no step before it gives.

    Parameters
    ----------
    steps : in the order of the calculation
    locale : language, and units beside the SI ones in which formulas are worked
    formula : escapes and marks up what it is given

    Returns
    -------
    "T = 2 π √(d / a) = 1.6 s [d = 0.11]; …".
    """
    written, known = [], {"g": g}
    for step, row in zip(steps, sheet_rows(steps, locale), strict=True):
        repeated = row.formula == row.symbol
        left = row.symbol if repeated or not row.formula else f"{row.symbol} = {row.formula}"
        new = [
            f"{each.symbol} = {locale.number(each.value)}"
            for each in (*step.inputs, *step.at)
            if not isclose(known.get(each.symbol, nan), each.value, rel_tol=SAME)
        ]
        beside = " ".join(part for part in (row.beside and f"({row.beside})", new and f"[{', '.join(new)}]") if part)
        written.append(f"{formula(left)} = {formula(f'{row.result} {beside}'.rstrip())}")
        known |= {each.symbol: each.value for each in (*step.inputs, *step.at)}
        known |= {step.symbol: step.value} if step.value is not None else {}
    return "; ".join(written)


_SHEET_COLUMNS = (
    say("Symbol"),
    say("Description"),
    say("Clause"),
    say("Formula"),
    say("Substituted"),
    say("Value"),
    say("Unit"),
)
_US_COLUMNS = (say("Value, US"), say("Unit, US"))


def sheet_as_table(sheet: Sheet, locale: Locale) -> Table:
    """Return a calculation sheet as a plain table, worked in SI, with results in US units where the locale has them."""
    besides = locale.system == "US"
    columns = tuple(map(Column, (*_SHEET_COLUMNS, *(_US_COLUMNS if besides else ()))))
    rows = tuple(
        (*_cells_in_si(step, row, locale), *(_cells_in_locale_unit(step, locale) if besides else ()))
        for step, row in zip(sheet.steps, sheet_rows(sheet.steps, locale), strict=True)
    )
    return Table(sheet.name, sheet.caption, columns, rows)


CONTENTS = say("Contents")
SHEET_HEADS: tuple[Text, ...] = (say("Symbol"), say("Meaning; clause"), say("Formula; numbers"), say("Value"))
SIGNATURE_HEADS: tuple[Text, ...] = (Verbatim(""), say("Name"), say("Signature"), say("Place and date"))
STAMP = say("stamp")
YES, NO = say("yes"), say("no")

_VERDICTS: Mapping[tuple[str, bool], Text] = {
    ("pass", False): say("PASS"),
    ("fail", False): say("FAIL"),
    ("incomplete", False): say("INCOMPLETE"),
    ("pass", True): say("PASS AT THE LIMIT"),
    ("fail", True): say("FAIL AT THE LIMIT"),
    ("incomplete", True): say("INCOMPLETE"),
}


def verdict_word(banner: Banner) -> Text:
    """Return the outcome in capitals."""
    return _VERDICTS[banner.outcome, banner.near]


def program_and_stamp(document: Document) -> Text:
    """Return the program, and the stamp of the results."""
    program = Verbatim(document.program)
    if not document.stamp:
        return program
    return say("{program}, stamp {stamp}", program=program, stamp=Verbatim(document.stamp))


PlainRows = tuple[tuple[PlainCell, ...], ...]


@dataclass(frozen=True)
class PlainTables:
    """The tables and the calculation sheets of a document, each with its cells in the document's locale."""

    tables: tuple[tuple[Table, PlainRows], ...]
    sheets: tuple[tuple[Table, PlainRows], ...]


def plain_tables(document: Document) -> PlainTables:
    """Return every table and calculation sheet of a document with its plain cells, for all files that hold them."""
    locale = document.writer
    sheets = (sheet_as_table(sheet, locale) for sheet in document.sheets)
    tables, of_sheets = (
        tuple((table, _plain_rows(table, locale)) for table in each) for each in (document.tables, sheets)
    )
    return PlainTables(tables, of_sheets)


def write_csv(document: Document, folder: Path, plain: PlainTables | None = None) -> tuple[Path, ...]:
    """Write every table and calculation sheet into `folder` as name.csv (UTF-8); the paths written.

    The last column is the stamp of the results: a row that is copied elsewhere takes it along. Numbers have a decimal
    point in every language.

    Parameters
    ----------
    document : of any tables
    folder : to write into
    plain : of the document, where they are known
    """
    locale, found = document.writer, plain or plain_tables(document)
    each = (*found.tables, *found.sheets)
    return tuple(_write(table, rows, folder, locale, stamp=document.stamp) for table, rows in each)


def csv_field(cell: PlainCell) -> str:
    """Return a cell as CSV text: numbers to full precision, text that looks like a formula behind an apostrophe."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "true" if cell else "false"
    if isinstance(cell, int | float):
        return repr(float(cell)) if isinstance(cell, float) else repr(cell)
    return harmless_cell(cell, shown=visible(cell))


def csv_lines(rows: Iterable[Iterable[PlainCell]]) -> str:
    """Return rows, the header first, as the text of a CSV file; every cell goes through `csv_field`."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([csv_field(cell) for cell in row] for row in rows)
    return stream.getvalue()


def _is_measure(cell: Cell, text: str) -> TypeGuard[float]:
    return isinstance(cell, float) and cell != 0.0 and "×" not in text


def _padded(cell: float, column: Column, locale: Locale, most: int) -> str:
    """Return a number with zeros up to `most` decimals, as far as its figures go."""
    whole, point, decimals = _number(cell, column, locale, aligned=True).partition(locale.point)
    return f"{whole}{point}{decimals[:most]}" if most else whole


def _number(cell: float, column: Column, locale: Locale, *, aligned: bool = False) -> str:
    value = cell / locale.table_unit(column.dimension).size if column.dimension else cell
    return locale.number(value, figures=column.figures if isinstance(cell, float) else _WHOLE, aligned=aligned)


def _in_unit(number: float, dimension: str, locale: Locale) -> float:
    """Return a number in SI in the unit of tables of its dimension."""
    size = locale.table_unit(dimension).size if dimension else 1.0
    return number if size == 1.0 else number / size


def _word(english: str, locale: Locale) -> str:
    return locale.text(Term(english)) if english else ""


def _formula(step: Step, locale: Locale) -> str:
    """Return the formula with the decimal sign of the locale; where nothing is put in it may be words."""
    if not step.inputs:
        return _word(step.formula, locale)
    return _DECIMAL.sub(locale.point, step.formula)


def _numbers(step: Step, locale: Locale) -> str:
    """Return the formula with its numbers, where a value was read, and a remark; empty where these add nothing."""
    if not (step.inputs or step.at or step.remark):
        plain = step.value is not None and step.substituted == write_plain(step.value)
        return "" if plain or step.substituted == step.formula else _word(step.substituted, locale)

    def write(value: float) -> str:
        return locale.number(value, figures=INPUT_FIGURES)

    substituted = substitute(_formula(step, locale), step.inputs, write) if step.inputs else ""
    if substituted and substituted != values_text(step.inputs, write):  # its symbols stand in the formula
        substituted = f"= {substituted}"
    return ", ".join(part for part in (substituted, values_text(step.at, write), _word(step.remark, locale)) if part)


def _result(step: Step, locale: Locale) -> str:
    """Return the result in the SI unit in which the formula is worked."""
    if step.value is None:
        return NOTHING
    unit = "" if step.unit == "-" else step.unit.translate(_POWERS)
    number = locale.number(step.value, figures=RESULT_FIGURES)
    return f"{SIGNS[step.bound]}{number}" + (f"\N{NO-BREAK SPACE}{locale.word(unit)}" if unit else "")


def _result_in_locale_unit(step: Step, locale: Locale) -> str:
    """Return the result in the units of the locale where they are others; empty where not."""
    here, in_si = (UNITS[system].get(step.dimension) for system in (locale.system, "SI"))
    if step.value is None or here is None or here == in_si:
        return ""
    return SIGNS[step.bound] + locale.text(Quantity(step.value, step.dimension))


def _cells_in_si(step: Step, row: SheetRow, locale: Locale) -> tuple[Cell, ...]:
    texts = map(Verbatim, (row.symbol, row.description, row.clause, row.formula, row.numbers.removeprefix("= ")))
    return (*texts, _bounded(step, step.value, locale), Verbatim(step.unit))


def _cells_in_locale_unit(step: Step, locale: Locale) -> tuple[Cell, ...]:
    """Return a result in the unit of tables of the locale; nothing where that is no other unit."""
    here, in_si = (UNITS[system].get(step.dimension) for system in (locale.system, "SI"))
    if step.value is None or here is None or here == in_si:
        return None, None
    return _bounded(step, step.value / here.table.size, locale), Verbatim(here.table.name)


def _bounded(step: Step, value: float | None, locale: Locale) -> Cell:
    """Return a result as a number; as text where it is known only to be no more, or no less."""
    return value if value is None or not step.bound else Verbatim(SIGNS[step.bound] + locale.number(value))


def _plain_rows(table: Table, locale: Locale) -> PlainRows:
    return tuple(
        tuple(plain_cell(cell, column, locale) for cell, column in zip(row, table.columns, strict=True))
        for row in table.rows
    )


def _write(table: Table, rows: PlainRows, folder: Path, locale: Locale, *, stamp: str) -> Path:
    path = folder / f"{table.name}.csv"
    last = [stamp] if stamp else []
    head = [locale.heading(column.label, column.dimension) for column in table.columns]
    named = [*head, *([locale.text(STAMP)] if stamp else [])]
    path.write_text(csv_lines([named, *([*row, *last] for row in rows)]), encoding="utf-8", newline="")
    return path
