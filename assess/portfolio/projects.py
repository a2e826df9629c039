"""The projects of a portfolio: those below a folder, or one for each row of a table that changes a template.

The template is a project file; a column of the table is named by the key whose value it gives. A project is known by
the hash of all that it reads: its file or row, and every file that it names.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import tomllib
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from glob import escape, glob
from pathlib import Path
from typing import Any

from assess.errors import ProjectError
from assess.messages.message import format_key
from assess.portfolio.tables import MOST_SHOWN, TableRow, point_for_comma, quote, read_table
from assess.short_repr import ShortRepr

ID = "id"
COLUMNS = "columns"  # the table of a template that maps headings to keys
CARRY, OTHERS = "carry", "*"  # in place of a key: the column is shown and no more; in place of a heading: all others
PROJECT_FILE = "project.toml"
RESULTS = "-results"  # how the folders end that `assess run` writes
A_PROJECT = re.compile(rb"^\s*\[\s*(site|mechanisms)\s*[\].]", re.MULTILINE)


@dataclass(frozen=True, repr=False)
class Task(ShortRepr):
    """One project of a portfolio.

    key : the path below the folder, or the row's id in the table; any text, not fit for a path
    title : what the project is called
    path : the project file, or the template that the row changes; absolute
    content : what the row changes in the template, as JSON text; None for a project file. `project_tree` applies it.
    sha256 : of everything the project is made of: its file or template, the row, and the files they name
    carried : headings and cells of the row that the ranked table shows, as they are typed
    """

    key: str
    title: str
    path: Path
    content: str | None
    sha256: str
    carried: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class KeyColumn:
    """A column of the table.

    key : in the template, written with dots; ID for that of the ids, "" for one that is carried alone
    unit : of its numbers, "" for none
    heading : under which the ranked table shows its cells, "" where it does not
    """

    key: str
    unit: str
    heading: str = ""


UnitFault = Callable[[Path, Mapping[str, Any], KeyColumn], str]
"""Says why the unit of a column cannot stand there, from the path and the tables of the template; "" if it can."""


def _no_unit_fault(path: Path, tables: Mapping[str, Any], column: KeyColumn) -> str:
    """Take any unit."""
    return ""


PlaceLoad = Callable[[Mapping[str, Any], str, float], float]
"""Returns the elevation [m] at a share of the height of a mechanism, from the tables of a project and its name."""


def _place_nothing(tables: Mapping[str, Any], mechanism: str, share: float) -> float:
    raise ProjectError("a load by a share of the height; it has no place here")


def find_tasks(
    source: Path,
    template: Path | None = None,
    unit_fault: UnitFault = _no_unit_fault,
    *,
    place_load: PlaceLoad = _place_nothing,
    decimal_comma: bool = False,
    progress: Callable[[int], object] = bool,
) -> tuple[Task, ...]:
    """Return the projects below a folder, or those that the rows of a table make of a template.

    Parameters
    ----------
    source : a folder, or a table as CSV or workbook
    template : the project file whose values the table changes; None for a folder
    unit_fault : checks the unit in the head of a column
    place_load : places loads that stand at the top, or at a share of the height
    decimal_comma : whether the numbers of the table have decimal commas; those between semicolons have them anyway
    progress : called with the number of tasks found so far

    Raises
    ------
    ProjectError : if the folder holds no project, or the table's header or the template cannot be used
    """
    if source.is_dir():
        if template is not None:
            raise ProjectError(f"{source}: a folder, whose projects need no template; leave out --template")
        return _counted(_tasks_below(source), progress)
    if template is None:
        raise ProjectError(f"{source}: a table needs the project that its rows change; add --template FILE.toml")
    return _counted(_tasks_of_table(source, template.absolute(), unit_fault, place_load, decimal_comma), progress)


def project_tree(task: Task) -> dict[str, Any]:
    """Return what a project of a table says: the template with the values of its row.

    Raises
    ------
    ProjectError : if the row has a value that cannot stand there
    """
    row = json.loads(task.content or "{}")
    if "fault" in row:
        raise ProjectError(str(row["fault"]))
    return with_row(read_template(task.path), {key: (text, unit) for key, text, unit in row["cells"]})


def row_fault(task: Task, text: str) -> str:
    """Return what is wrong with a project of a table by its line and column, instead of the template's name and key.

    Parameters
    ----------
    task : of a row
    text : what is wrong with the template that its values make
    """
    row = json.loads(task.content or "{}")
    name = "" if task.key == str(row["line"]) else f" ({quote(task.key)})"
    where, fault = f"{row['table']}: line {row['line']}{name}", text.removeprefix(f"{task.path}: ")
    if "fault" in row:
        return f"{where}: {fault}"
    places = keys_of(read_template(task.path))
    for key, *_ in row["cells"]:
        prefix = f"{format_key(places[key])}: "
        if fault.startswith(prefix):
            return f"{where}: column {quote(row.get('headings', {}).get(key, key))}: {fault.removeprefix(prefix)}"
    return f"{where}: with {task.path.name}: {fault}"


KeyPath = tuple[str | int, ...]
TITLE = "title"
TOP = ("top", "cima")
SHARE = re.compile(r"top|cima|(100|[0-9]{1,2}([.,][0-9]{1,6})?) ?%", re.IGNORECASE)
LOAD_PLACE = 6  # steps of the key of a coordinate of a load: mechanisms, name, loads, number, at, number
COLUMN_HEADER = re.compile(r"(.*?)\s*(?:\[([^\[\]]*)\])?\s*", re.DOTALL)
WHOLE_NUMBER = re.compile(r"[+-]?[0-9]{1,18}")
NUMBER = re.compile(r"[+-]?([0-9]{1,40}\.?[0-9]{0,40}|\.[0-9]{1,40})([eE][+-]?[0-9]{1,3})?|[+-]?(inf|nan)")
QUANTITY = re.compile(r"\s*[+-]?([0-9]|\.[0-9]|inf\b)")
QUANTITY_WITH_COMMA = re.compile(r"[+-]?[0-9]+,[0-9]+(\s*[^\s0-9,;]\S*)?")


def read_template(path: Path) -> Mapping[str, Any]:
    """Read the tables of a template.

    Raises
    ------
    ProjectError : it is missing, no TOML, or has no mechanism
    """
    try:
        size, changed = path.stat().st_size, path.stat().st_mtime_ns
    except (OSError, ValueError):
        raise ProjectError(f"{path}: no such file; give the project file whose values the table changes") from None
    return {name: table for name, table in _read_tables(path, size, changed).items() if name != COLUMNS}


def read_headings(path: Path) -> Mapping[str, str]:
    """Return what [columns] of a template says: by heading of the table a key with its unit, or CARRY; by key a share.

    Raises
    ------
    ProjectError : it is no table of texts
    """
    found = _read_tables(path, path.stat().st_size, path.stat().st_mtime_ns).get(COLUMNS, {})
    if not isinstance(found, Mapping) or not all(isinstance(each, str) for each in found.values()):
        raise ProjectError(f'{path}: columns: write headings with keys, such as "Spessore [cm]" = "{TITLE}"')
    return found


def keys_of(template: Mapping[str, Any]) -> dict[str, KeyPath]:
    """Return the keys of all single values of a template, written with dots, each with its place."""
    return {".".join(map(str, place)): place for place in _places(template, ())} | {TITLE: (TITLE,)}


def with_row(
    template: Mapping[str, Any], cells: Mapping[str, tuple[str, str]], known: Mapping[str, KeyPath] | None = None
) -> dict[str, Any]:
    """Return the tables of a template with the values of a row; those without one are the template's own.

    Parameters
    ----------
    template : its tables
    cells : by key, the text of the cell and the unit of its column
    known : `keys_of` the template, where many rows change it

    Raises
    ------
    ProjectError : a number has a decimal comma
    """
    tables, places = dict(template), keys_of(template) if known is None else known
    for key, (text, unit) in cells.items():
        place = places[key]
        tables = _with_value(tables, place, value_of(text, unit, like=_value_at(template, place), key=key))
    return tables


def value_of(text: str, unit: str, *, like: Any, key: str) -> Any:
    """Return the value of a cell, of the kind that the template has there.

    Text stays text where the template has text. Elsewhere a number is a number, with the unit of its column, and
    anything else stays as it is written: the project's own check tells whether it may stand there.
    """
    if isinstance(like, bool):
        return {"true": True, "false": False}.get(text.lower(), text)
    if not isinstance(like, int | float) and not _is_quantity(like):
        return text
    if QUANTITY_WITH_COMMA.fullmatch(text):
        raise ProjectError(f"{key}: {quote(text)}: a decimal comma; write {text.replace(',', '.')[:MOST_SHOWN]}")
    if NUMBER.fullmatch(text):
        return f"{text} {unit}" if unit else int(text) if WHOLE_NUMBER.fullmatch(text) else float(text)
    return text


def _counted(tasks: Iterator[Task], progress: Callable[[int], object]) -> tuple[Task, ...]:
    """Return tasks, counting them as they are found."""
    found = list[Task]()
    for task in tasks:
        found.append(task)
        progress(len(found))
    return tuple(found)


def _tasks_below(folder: Path) -> Iterator[Task]:
    """Yield a task for each project file below a folder, in the order of their paths."""
    files, hash_of = sorted(_project_files(folder)), _files_hash()
    if not files:
        raise ProjectError(
            f"{folder}: no project below it; give a folder with project files, or a table with --template"
        )
    yield from (_task_of_file(file, folder, hash_of) for file in files)


def _project_files(folder: Path) -> Iterator[Path]:
    """Yield every project.toml, and every other TOML file with a table [site] or [mechanisms]; results are skipped."""
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".") and not name.endswith(RESULTS)]
        for name in names:
            path = Path(place, name)
            if name == PROJECT_FILE or (name.endswith(".toml") and A_PROJECT.search(_bytes(path))):
                yield path


def _bytes(path: Path) -> bytes:
    """Return what a file holds; nothing if it cannot be read, which the run of the project tells."""
    try:
        return path.read_bytes() if path.is_file() else b""
    except OSError:
        return b""


def _task_of_file(file: Path, folder: Path, hash_of: FilesHash) -> Task:
    data, key = _bytes(file), file.relative_to(folder).as_posix()
    try:
        tables: Mapping[str, Any] = tomllib.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        tables = {}
    sha256 = hashlib.sha256(data + b"\0" + hash_of(tables, file.parent.absolute()).encode()).hexdigest()
    return Task(key, _title(tables), file.absolute(), None, sha256)


def _title(tables: Mapping[str, Any]) -> str:
    title = tables.get(TITLE)
    return title if isinstance(title, str) else ""


def _tasks_of_table(
    source: Path, template: Path, unit_fault: UnitFault, place_load: PlaceLoad, decimal_comma: bool
) -> Iterator[Task]:
    """Yield a task for each row of a table.

    Raises
    ------
    ProjectError : the header or the template cannot be used, there is no row, or two have the same id
    """
    tables, mapped = read_template(template), read_headings(template)
    rules = {key: text for key, text in mapped.items() if SHARE.fullmatch(text)}
    headings = {heading: key for heading, key in mapped.items() if heading not in rules}
    lines, seen = read_table(source, decimal_comma=decimal_comma), dict[str, int]()
    try:
        columns = _columns_of(
            _column_names(next(lines)), tables, headings, lambda column: unit_fault(template, tables, column)
        )
    except ProjectError as error:
        raise ProjectError(f"{source}: {error}") from None
    start, hash_of, known = hashlib.sha256(template.read_bytes()), _files_hash(), keys_of(tables)
    if wrong := [key for key in rules if not _is_load_height(known.get(key, ()), tables)]:
        raise ProjectError(
            f"{template}: columns.{quote(wrong[0])}: {quote(rules[wrong[0]])} is for the elevation of a load, such as "
            "mechanisms.NAME.loads.0.at.1"
        )
    for line in lines:
        key = _row_key(line, columns)
        if key in seen:
            raise ProjectError(
                f"{source}: lines {seen[key]} and {line.number}: {quote(key)} twice; give each row its own id"
            )
        seen[key] = line.number
        yield _task_of_row(
            source, line, key, columns, template, tables, known, start.copy(), hash_of, rules, place_load
        )
    if not seen:
        raise ProjectError(f"{source}: no row below the header; add one for each project")


def _column_names(line: TableRow) -> tuple[str, ...]:
    """Return the names of the columns, without empty ones at the end, which spreadsheets leave there."""
    names = list(line.cells)
    while names and not names[-1]:
        names.pop()
    return tuple(names)


def _row_key(line: TableRow, columns: Sequence[KeyColumn]) -> str:
    """Return the row's id, or the number of its line."""
    cells = (cell for column, cell in zip(columns, line.cells, strict=False) if column.key == ID)
    return next(cells, "") or str(line.number)


def _task_of_row(
    source: Path,
    line: TableRow,
    key: str,
    columns: Sequence[KeyColumn],
    template: Path,
    tables: Mapping[str, Any],
    known: Mapping[str, KeyPath],
    start: Any,
    hash_of: FilesHash,
    rules: Mapping[str, str],
    place_load: PlaceLoad,
) -> Task:
    """Return the task of a row; start: the hash of the template."""
    pairs = [(column, text) for column, text in zip(columns, line.cells, strict=False) if text]
    carried = tuple((column.heading, text) for column, text in pairs if column.heading)
    row: dict[str, Any] = {"cells": [(c.key, text, c.unit) for c, text in pairs if c.key not in ("", ID)]}
    if headings := {c.key: c.heading for c, _ in pairs if c.key and c.heading}:
        row["headings"] = headings
    title, named = next((text for c, text in pairs if c.key == TITLE), _title(tables)), tables
    try:
        if line.decimal_comma:
            row["cells"] = [(name, _with_point(name, text, known, tables), unit) for name, text, unit in row["cells"]]
        stated = {name for name, *_ in row["cells"]}
        placed = {name: text for name, text in rules.items() if name not in stated}
        placed |= {name: text for name, text, _ in row["cells"] if _is_share(text, known[name], tables)}
        row["cells"] = [cell for cell in row["cells"] if cell[0] not in placed]
        named = with_row(tables, {name: (text, unit) for name, text, unit in row["cells"]}, known)
        row["cells"] += [(n, f"{place_load(named, known[n][1], _share_of(t)):.12g}", "m") for n, t in placed.items()]  # type: ignore[arg-type]
        named = with_row(tables, {name: (text, unit) for name, text, unit in row["cells"]}, known)
        _check_number(line, columns)
    except ProjectError as error:
        row = {"fault": str(error)}
    hashed = row | {"carried": carried} if carried else row
    start.update(
        _compact_json(hashed).encode("utf-8", "surrogatepass") + b"\0" + hash_of(named, template.parent).encode()
    )
    content = _compact_json({"table": str(source), "line": line.number, **row})
    return Task(key, title, template, content, start.hexdigest(), carried)


def _is_share(text: str, place: KeyPath, tables: Mapping[str, Any]) -> bool:
    """Whether a cell places a load at the top or at a share of the height."""
    return SHARE.fullmatch(text) is not None and _is_load_height(place, tables)


def _is_load_height(place: KeyPath, tables: Mapping[str, Any]) -> bool:
    """Whether a key is the elevation of the place of a load."""
    if len(place) != LOAD_PLACE or (place[0], place[2], place[4]) != ("mechanisms", "loads", "at"):
        return False
    return place[-1] == len(_value_at(tables, place[:-1])) - 1


def _share_of(text: str) -> float:
    """Return a share of the height [-] as it is written: "top" or "50 %"."""
    return 1.0 if text.lower() in TOP else float(text.rstrip(" %").replace(",", ".")) / 100.0


def _with_point(name: str, text: str, known: Mapping[str, KeyPath], tables: Mapping[str, Any]) -> str:
    """Return the text of a cell with a decimal point, where the template has a number."""
    if not _is_number(_value_at(tables, known[name])):
        return text
    try:
        return point_for_comma(text)
    except ProjectError as error:
        raise ProjectError(f"{name}: {error}") from None


def _compact_json(row: Mapping[str, Any]) -> str:
    return json.dumps(row, ensure_ascii=False, separators=(",", ":"))


def _check_number(line: TableRow, columns: Sequence[KeyColumn]) -> None:
    """Raise ProjectError unless a row has a cell, which may be empty, for each column, and no more."""
    count = f"{len(line.cells)} cell{'' if len(line.cells) == 1 else 's'} below {len(columns)} columns"
    if len(line.cells) < len(columns):
        raise ProjectError(f"{count}; write the missing ones, or their separators where the template's values stay")
    if any(line.cells[len(columns) :]):
        raise ProjectError(f"{count}; put a text with separators in quotes")


LONGEST_PATH = 1000  # characters of a text that may be a path
GLTF_ENDING = ".gltf"
LOCK_ENDING = ".toml"  # how a file of [records] ends that names files itself: the lock of a suite
FilesHash = Callable[[Mapping[str, Any], Path], str]


def _files_hash() -> FilesHash:
    """Return a function of a project's tables and folder: the hash of the files that they name.

    Each file is read once, however many projects name it.
    """
    digest = lru_cache(maxsize=None)(_file_digest)

    @lru_cache(maxsize=100_000)
    def named(text: str, folder: Path, of_records: bool) -> bytes:
        files = _files_named(text, folder, of_records=of_records)
        named_there = (each for file in files for each in _files_within(file, of_records=of_records))
        return b"".join(map(digest, (*files, *named_there)))

    def hash_of(tables: Mapping[str, Any], folder: Path) -> str:
        found = hashlib.sha256()
        for text, of_records in _texts(tables):
            found.update(named(text, folder, of_records))
        return found.hexdigest()

    return hash_of


def _texts(tables: Mapping[str, Any]) -> Iterator[tuple[str, bool]]:
    """Yield every text of a project, and whether it stands in [records]."""
    for name, value in tables.items():
        for text in _leaves(value):
            if text and len(text) <= LONGEST_PATH and "\0" not in text and "\n" not in text:
                yield text, name == "records"


def _leaves(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for each in value.values():
            yield from _leaves(each)
    elif isinstance(value, list):
        for each in value:
            yield from _leaves(each)


def _files_named(text: str, folder: Path, *, of_records: bool) -> list[Path]:
    """Return the files that a text names; only [records] has patterns and folders."""
    path = folder / text
    try:
        if path.is_file():
            return [path]
    except OSError:  # too long for a name, or in a folder that may not be read
        return []
    if not of_records:
        return []
    if path.is_dir():
        below = (each for each in path.rglob("*") if not each.name.startswith("."))
        return sorted(each for each in below if each.is_file())
    return sorted(each for each in map(Path, glob(str(Path(escape(str(folder))) / text), recursive=True)))


def _files_within(file: Path, *, of_records: bool) -> Iterable[Path]:
    """Return the files that a file names: those of the lock of a suite, and those that hold the meshes of a glTF."""
    if file.suffix.lower() == GLTF_ENDING:
        from assess.geometry.formats.gltf import companions

        return companions(file)
    return _files_of_lock(file) if of_records and file.suffix == LOCK_ENDING else ()


def _files_of_lock(lock: Path) -> list[Path]:
    """Return the files that a lock names, beside it; none if it cannot be read, which the run of the project tells."""
    try:
        tables = tomllib.loads(lock.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return []
    return [file for text, _ in _texts(tables) for file in _files_named(text, lock.parent, of_records=False)]


def _file_digest(path: Path) -> bytes:
    """Return the name and the hash of a file; of the name alone if it cannot be read."""
    try:
        with path.open("rb") as file:
            content = hashlib.file_digest(file, "sha256").digest()
    except OSError:
        content = b""
    return hashlib.sha256(str(path).encode("utf-8", "surrogateescape") + b"\0" + content).digest()


@lru_cache(maxsize=4)
def _read_tables(path: Path, size: int, changed: int) -> Mapping[str, Any]:
    """Read a template of that size and time, once in each process."""
    try:
        tables = tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except (OSError, UnicodeDecodeError, ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())
        raise ProjectError(f"{path}: cannot be read as TOML ({reason}); try it with `assess check` first") from None
    if not isinstance(tables.get("mechanisms"), Mapping):
        raise ProjectError(f"{path}: no table [mechanisms.NAME]; a template is a whole project file")
    return tables


def _places(value: Any, place: KeyPath) -> Iterator[KeyPath]:
    if isinstance(value, Mapping):
        for name, each in value.items():
            yield from _places(each, (*place, name))
    elif isinstance(value, list):
        for number, each in enumerate(value):
            yield from _places(each, (*place, number))
    else:
        yield place


def _columns_of(
    header: Sequence[str],
    template: Mapping[str, Any],
    headings: Mapping[str, str],
    unit_fault: Callable[[KeyColumn], str],
) -> list[KeyColumn]:
    """Return the columns of a table's header.

    Parameters
    ----------
    header : names of the columns, as they stand in the table
    template : its tables
    headings : `read_headings` of the template
    unit_fault : says why the unit of a column cannot stand there; "" if it can

    Raises
    ------
    ProjectError : names every column without a name, with the same key as another, with one that is no key of the
        template, or with a unit that does not fit; and every heading of [columns] that the table does not have
    """
    known, seen, faults, left = keys_of(template), set[str](), list[str](), dict(headings)
    found: list[KeyColumn] = []
    for number, cell in enumerate(header, 1):
        try:
            column = _column(cell, left, headings, known)
            if not cell or column.key in seen:
                why = f"{quote(column.key)} stands there twice; give each key one column"
                remedy = f"no name; write a key of the template, such as {quote(_example_key(known))}"
                raise ProjectError(f"column {number}: {why if cell else remedy}")
            seen |= {column.key} - {""}
            if column.key not in ("", ID):
                _check_column(column, known, template)
                if column.unit and (fault := unit_fault(column)):
                    raise ProjectError(f"column {quote(cell)}: {fault}")
            found.append(column)
        except ProjectError as error:
            faults.append(str(error))
    faults += [f"columns.{quote(each)}: no such heading in the table" for each in left if each != OTHERS]
    if faults:
        raise ProjectError("; ".join(faults))
    return found


def _column(cell: str, left: dict[str, str], headings: Mapping[str, str], known: Collection[str]) -> KeyColumn:
    """Return a column by its heading, with or without its unit in [columns], which is taken from those `left` there."""
    match = COLUMN_HEADER.fullmatch(cell)
    name, unit = (match[1].strip(), (match[2] or "").strip()) if match else (cell, "")
    mapped = left.pop(cell, None) or left.pop(name, None)
    if mapped is None:
        carried = headings.get(OTHERS) == CARRY and name not in (ID, *known)
        return KeyColumn("", "", cell) if carried else KeyColumn(name, unit)
    if mapped == CARRY:
        return KeyColumn("", "", cell)
    target = COLUMN_HEADER.fullmatch(mapped)
    key, own = (target[1].strip(), (target[2] or "").strip()) if target else (mapped, "")
    return KeyColumn(key, own or unit, "" if key in (ID, TITLE) else cell)


def _example_key(known: Mapping[str, KeyPath]) -> str:
    return next((key for key in known if key.startswith("bodies.")), TITLE)


def _check_column(column: KeyColumn, known: Mapping[str, KeyPath], template: Mapping[str, Any]) -> None:
    """Raise ProjectError for a key that the template does not have, and for a unit of what has none."""
    key, unit = column.key, column.unit
    if key not in known:
        near = get_close_matches(key, known, n=1, cutoff=0.0)
        below = [each for each in known if each.startswith(f"{key}.")]
        remedy = f"name one of its values, such as {quote(below[0])}" if below else f"do you mean {quote(near[0])}?"
        remedy += "" if below or column.heading else " (or map the heading in [columns] of the template)"
        raise ProjectError(
            f"column {quote(key)}: {'a table or list' if below else 'not a key'} of the template; {remedy}"
        )
    value = _value_at(template, known[key])
    if unit and not _is_number(value):
        raise ProjectError(
            f"column {quote(key)}: the template has {quote(str(value))} there, which takes no unit; leave out [{unit}]"
        )


def _with_value(tables: Any, place: KeyPath, value: Any) -> Any:
    """Return tables or a list with another value at a place; only what leads there is copied."""
    step, rest = place[0], place[1:]
    copied: Any = dict(tables) if isinstance(tables, Mapping) else list(tables)
    copied[step] = _with_value(copied[step], rest, value) if rest else value
    return copied


def _value_at(tables: Any, place: KeyPath) -> Any:
    for step in place:
        if isinstance(tables, Mapping) and step not in tables:
            return ""
        tables = tables[step]
    return tables


def _is_number(value: Any) -> bool:
    """Whether the template has a number, with its unit or without."""
    return not isinstance(value, bool) and (isinstance(value, int | float) or _is_quantity(value))


def _is_quantity(value: Any) -> bool:
    """Whether a value of the template is a number with its unit, as text."""
    return isinstance(value, str) and QUANTITY.match(value) is not None
