"""The project file: read, checked against its schema, every quantity in SI, and what in it looks like a slip.

    load(path) -> Project      raises ProjectError with one line: file: key: value: what is wrong; remedy
    load_tree(tables, path)    the same of tables that no file holds, such as a template with the values of a row
    resolve(project)           every key with its value and whether it was given or is a default
    json_schema()              the schema itself, for editors

The tables are the classes of `assess.project.sections`. The faults of the JSON Schema lie at the key that is wrong. Of
an alternative of tables, `oneOf`, a validator says no more than that none of them fits, so that an editor underlines
the whole table. Where their keys tell the tables apart, the schema asks for them instead and has the faults of the one
that is meant.
"""

from __future__ import annotations

import hashlib
import json
import re
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

from assess.errors import Faults, ProjectError, locate_errors
from assess.geometry.formats.readers import READERS
from assess.messages.message import Message, Quantity, escape_text, note, warning
from assess.project.key_errors import KeyPath, key_text, look_up, value_text
from assess.project.keys import (
    KeySweep,
    UncertainValue,
    covs_of,
    key_sweeps,
    keyed_values,
    read_content,
    stated_values,
    take_means,
    uncertain_values,
)
from assess.project.reading import UNCERTAIN_MARK, quantity_schema
from assess.project.section import EVIDENCE, ProjectSection, UncertainNumber
from assess.project.sections.content import Content
from assess.project.units import KINDS, USUAL, is_weight, quantity_pattern
from assess.project.values import PATTERN_MARK
from assess.results import ResolvedValue
from assess.results.provenance import count_from_0, count_from_1
from records.reading import relative_path
from spectra.arrays import is_number
from spectra.gravity import g

T = TypeVar("T")
FORMAT = 1
FILE_NAME = "project.toml"
_DECIMAL_COMMA = re.compile(r"=\s*([+-]?[0-9]+,[0-9]+)(?![.0-9\]])")
_UPGRADES: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}  # from format n to n + 1; there is only one yet


@dataclass(frozen=True, repr=False)
class Project:
    """A project file as read.

    content : its tables, every quantity an SI float, every path absolute or below `folder`
    path : the project file; sha256 : of its bytes
    sweeps : each with the content of every case
    messages : what looks like a slip in the file as it was written
    raw : what the file says, in the newest format, as it was written, with the means of uncertain numbers
    uncertain : numbers given as { mean, cov }
    """

    content: Content
    path: Path
    sha256: str
    sweeps: tuple[KeySweep, ...]
    messages: tuple[Message, ...]
    raw: Mapping[str, Any]
    uncertain: tuple[UncertainValue, ...] = ()

    def __repr__(self) -> str:
        return f"Project({str(self.path)!r}, mechanisms: {', '.join(self.content.mechanisms)})"[:200]

    @property
    def folder(self) -> Path:
        """The folder of the project file; its paths are relative to this."""
        return self.path.parent


def load(path: Path | str, *, before: Path | str | None = None) -> Project:
    """Read the project in the file `path`, or in `project.toml` of the folder `path`.

    Raises ProjectError for a file that is missing, is not TOML, or breaks the schema.

    Parameters
    ----------
    path : of the project
    before : results of the state before the works, in place of those that `[verdict] before` names
    """
    file = _project_file(Path(path))
    if file.suffix.lower() in READERS and file.is_file():
        cure = f"`assess new DIR --from {file}` makes a project of it"
        raise ProjectError(f"{file}: a model, and no project file; {cure}")
    data = _bytes(file)
    try:
        tables = parse_toml(_text(data))
    except ProjectError as error:
        raise ProjectError(f"{file}: {error}") from None
    verdict = tables.setdefault("verdict", {}) if before is not None else None
    if isinstance(verdict, dict):
        verdict["before"] = str(Path(before or "").resolve())
    return load_tree(tables, file, sha256=hashlib.sha256(data).hexdigest())


def load_tree(tables: dict[str, Any], file: Path, *, sha256: str) -> Project:
    """Read the project that parsed TOML says.

    Parameters
    ----------
    tables : the parsed TOML
    file : the project file, or that of the template; messages name it, and paths are relative to its folder
    sha256 : of what the project is made of

    Raises
    ------
    ProjectError : it breaks the schema; its notes are the other faults that show beside the first
    """
    faults = Faults()
    uncertain: tuple[UncertainValue, ...] = ()
    varied: tuple[KeySweep, ...] = ()
    with locate_errors(str(file)):
        raw, stated = take_means(_upgrade(tables), file.parent, faults)
        with faults.gather():
            content = read_content(raw, file.parent)
            with faults.gather():
                uncertain = uncertain_values(content, stated)
            with faults.gather():
                varied = key_sweeps(content, raw, file.parent)
            with faults.gather():
                _check_sources(content, file.parent)
        faults.raise_all()
    messages = (*bare_number_messages(raw), *_weight_density_messages(content, raw))
    return Project(content, file, sha256, varied, messages, raw, uncertain)


def resolve(project: Project) -> dict[str, ResolvedValue]:
    """Return every key, written with dots, with its value in SI and whether it was given or is a default.

    Paths are written relative to the project file.
    """
    found = resolved_values(project.content, project.folder)
    kinds = {key: place.kind.name for key, place in keyed_values(project.content).items() if place.kind is not None}
    covs = covs_of(project.uncertain)
    return {key: replace(each, dimensions=_below(key, kinds), cov=_covs(key, covs)) for key, each in found.items()}


def resolved_values(content: Content, folder: Path) -> dict[str, ResolvedValue]:
    """Return every key of a content as `resolve` does, without dimensions and scatter.

    Parameters
    ----------
    content : of a project file
    folder : of that file, to which paths are relative
    """
    return dict(_resolve("", content, True, folder))


HUGE = 60.0  # m: a body larger than this, by a number alone, was rather meant in another unit
BUILT = {"thickness": (0.1, 6.0), "length": (0.2, HUGE), "height": (0.2, HUGE)}  # m, of what is assessed
SHORTER = ("mm", "in", "cm", "ft")  # units that sizes are typed in, besides m
WEAK = 0.1 * g  # m/s2: below it a number alone was rather meant in g
SPECTRUM: KeyPath = ("site", "spectrum")
ACCELERATION_KEYS: tuple[KeyPath, ...] = (
    ("site", "pga"),
    *((*SPECTRUM, key) for key in ("s_ds", "s_d1", "s_s", "s_1", "a_g")),
)
MATERIALS: Mapping[str, tuple[str, tuple[tuple[float, float, str], ...]]] = {
    "density": ("density", ((1.0, 4.0, "t/m^3"), (10.0, 35.0, "kN/m^3"), (60.0, 200.0, "lb/ft^3"))),
    "young_modulus": ("stress", ((0.05, 100.0, "GPa"), (100.0, 1e5, "MPa"), (1e5, 2e7, "psi"))),
    "compressive_strength": ("stress", ((0.1, 200.0, "MPa"), (200.0, 5e4, "psi"))),
    "tensile_strength": ("stress", ((0.001, 10.0, "MPa"), (10.0, 2e3, "psi"))),
}
"""For each number of a material its dimension and the ranges in SI that no masonry has, each with the unit meant."""


def bare_number_messages(raw: Mapping[str, Any]) -> Iterator[Message]:
    """Warn of each plain number of the file that is implausible for an earthquake, a wall or a masonry."""
    yield from _acceleration_messages(raw)
    for name, body in _tables(raw, "bodies"):
        yield from _size_messages(("bodies", name), body)
    for name, material in _tables(raw, "materials"):
        yield from _material_messages(("materials", name), material)


TITLE = "Project file of assess"
"""Title of the schema, by which its file is known."""
_REFERENCE = "#/$defs/"


@cache
def schema_text() -> str:
    """Return the JSON Schema of the project file as the text of a file."""
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": TITLE}
    found = with_quantity_patterns(with_uncertain_numbers(Content.model_json_schema()))
    return json.dumps({**with_located_faults(found), **head}, indent=2, ensure_ascii=False) + "\n"


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the project file."""
    found: dict[str, Any] = json.loads(schema_text())
    return found


def with_uncertain_numbers(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the JSON Schema of a project file with { mean, cov } allowed at every key that is marked."""
    defined: dict[str, Any] = {}

    def allow(node: Any) -> Any:
        if isinstance(node, list):
            return [allow(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: allow(each) for key, each in node.items() if key != UNCERTAIN_MARK}
        if UNCERTAIN_MARK not in node:
            return plain
        kept = {key: plain.pop(key) for key in ("description", "title", "default", EVIDENCE) if key in plain}
        kind = _quantity_kind(plain)
        name = f"{UncertainNumber.__name__}-of-{kind}".replace(" ", "-")
        defined[name] = _uncertain_number_schema(kind)
        return {"anyOf": [plain, {"$ref": f"#/$defs/{name}"}], **kept} if plain else kept

    found = allow(schema)
    return {**found, "$defs": {**found["$defs"], **dict(sorted(defined.items()))}}


def with_quantity_patterns(schema: dict[str, Any]) -> dict[str, Any]:
    """Return a JSON Schema in which every marked key refers to the definition of its quantity."""
    defined: dict[str, Any] = {}

    def refer(node: Any) -> Any:
        if isinstance(node, list):
            return [refer(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: refer(each) for key, each in node.items() if key != PATTERN_MARK}
        if PATTERN_MARK not in node:
            return plain
        kind, form = node[PATTERN_MARK]
        name = f"{form} of {kind}".replace(" ", "-")
        defined[name] = {"type": plain.pop("type"), "pattern": quantity_pattern(kind, form)}
        return {"$ref": f"#/$defs/{name}", **plain}

    found = refer(schema)
    return {**found, "$defs": {**found["$defs"], **dict(sorted(defined.items()))}}


def with_located_faults(schema: dict[str, Any]) -> dict[str, Any]:
    """Return a JSON Schema of a TOML file that accepts the same, and whose faults lie as deep as they can.

    TOML has no null: an alternative of one schema and null is that schema, and a default of null is none.
    """
    definitions = schema["$defs"]

    def locate(node: Any) -> Any:
        if isinstance(node, list):
            return [locate(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: locate(each) for key, each in node.items() if (key, each) != ("default", None)}
        return _without_choice(_without_null(plain), definitions)

    return {key: locate(each) for key, each in schema.items()}


def _check_sources(content: Content, folder: Path) -> None:
    """Check that every key of [report.sources] is one of the file, or the beginning of one."""
    faults = Faults()
    for key in content.report.sources:
        if not content.is_struck_out(key) and not _has_key(content, count_from_0(key)):
            near = get_close_matches(key, _keys_with_tables(content, folder), n=1)
            remedy = (
                f"do you mean {value_text(count_from_1(near[0]))}?"
                if near
                else 'write one like "materials.NAME.density"'
            )
            with faults.gather():
                raise ProjectError(f"report.sources: {value_text(key)}: not a key of this file; {remedy}")
    faults.raise_all()


def _has_key(value: Any, key: str) -> bool:
    """Whether a key, with dots and items counted from 0, stands below what was read."""
    below: Mapping[str, Any] = {}
    if isinstance(value, ProjectSection):
        below = value.entries()
    elif isinstance(value, tuple):
        below = {str(place): item for place, item in enumerate(value)}
    elif isinstance(value, Mapping):
        below = value
    return any(
        key == name or (key.startswith(f"{name}.") and _has_key(item, key[len(name) + 1 :]))
        for name, item in below.items()
    )


def _keys_with_tables(content: Content, folder: Path) -> set[str]:
    """Return every key of the file whose value may have a source, and every table above one."""
    every = _resolve("", content, True, folder)
    keys = [*keyed_values(content), *(key for key, _ in every if not key.startswith("report.sources."))]
    return {".".join(key.split(".")[: n + 1]) for key in keys for n in range(key.count(".") + 1)}


def _project_file(path: Path) -> Path:
    if "\0" in str(path):
        raise ProjectError(f"{value_text(str(path))}: not a path; give a project file or its folder")
    if not path.is_dir():
        return path
    if not (path / FILE_NAME).is_file():
        raise ProjectError(f"{path}: a folder without {FILE_NAME}; give a project file, or make one with `assess new`")
    return path / FILE_NAME


def _bytes(file: Path) -> bytes:
    if not file.exists():
        raise ProjectError(f"{file}: no such file; give a project file or its folder, or make one with `assess new`")
    if not file.is_file():
        raise ProjectError(f"{file}: not a file; give a project file or its folder")
    try:
        data = file.read_bytes()
    except OSError as error:
        raise ProjectError(f"{file}: cannot be read ({error.strerror}); check its permissions") from None
    if not data.strip():
        raise ProjectError(f"{file}: empty; start from an example with `assess new`")
    return data


def _text(data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        reason = f"byte {error.start + 1} ({data[error.start]:#04x}) is not UTF-8"
        raise ProjectError(f"{reason}; a project file is TOML text, save it as UTF-8") from None


def parse_toml(text: str) -> dict[str, Any]:
    """Parse the text of a project file; raise ProjectError with the line where it is not TOML."""
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise ProjectError("nested too deeply; a project file has tables and short lists") from None
    except tomllib.TOMLDecodeError as error:
        raise ProjectError(_toml_reason(str(error), text)) from None
    except ValueError:  # int() refuses thousands of digits
        raise ProjectError("not valid TOML: a number of thousands of digits; correct it") from None


def _toml_reason(message: str, text: str) -> str:
    """Return what tomllib found in the text, with the line in front."""
    match = re.fullmatch(r"(.*) \(at (?:line (\d+), column (\d+)|(end of document))\)", message, re.DOTALL)
    if match is None:
        return f"not valid TOML: {escape_text(message)}"
    where = "end of the file" if match[4] else f"line {match[2]}, column {match[3]}"
    if match[1].startswith(("Cannot declare", "Cannot overwrite", "Cannot mutate", "Duplicate inline table key")):
        lines = text.rstrip().split("\n")
        name = _twice(match[1], lines[int(match[2]) - 1 if match[2] else -1])
        return f"{where}: {escape_text(name) or 'this key'} stands there twice; give each its own name"
    comma = match[2] and _DECIMAL_COMMA.search(text.split("\n")[int(match[2]) - 1])
    if comma:
        return f"{where}: {comma[1]}: a decimal comma; write {comma[1].replace(',', '.')}"
    return f"{where}: not valid TOML: {escape_text(match[1])}; correct that line"


def _twice(message: str, line: str) -> str:
    """Return the key given twice, as tomllib names it or as the line begins; empty if neither shows it."""
    named = ".".join(re.findall(r"'([^']*)'", message))
    key = re.match(r"\s*([^=\[\]{}\"']+?)\s*=", line)
    return named or (key[1][:60] if key else "")


def _upgrade(raw: dict[str, Any]) -> dict[str, Any]:
    """Convert the content to the newest format, one pure step at a time."""
    given = raw.get("format", FORMAT)
    if not isinstance(given, int) or isinstance(given, bool) or given < 1:
        raise ProjectError(f"format: {value_text(given)}: not a format number; write format = {FORMAT}")
    if given > FORMAT:
        raise ProjectError(f"format: {given}: newer than this program, which reads up to {FORMAT}; update it")
    for step in range(given, FORMAT):
        raw = _UPGRADES[step](raw)
    return raw


def _covs(key: str, covs: Mapping[str, float]) -> dict[str, float]:
    """Return the scatter of the numbers at and below a key; one number may stand for the keys of a table, above it."""
    above = [cov for written, cov in covs.items() if key.startswith(f"{written}.")]
    return {"": above[0]} if above else _below(key, covs)


def _below(key: str, known: Mapping[str, T]) -> dict[str, T]:
    """Return what is known of the numbers at and below a key, by the way to them."""
    if key in known:
        return {"": known[key]}
    return {way[len(key) + 1 :]: each for way, each in known.items() if way.startswith(f"{key}.")}


def _resolve(key: str, value: Any, given: bool, folder: Path) -> Iterator[tuple[str, ResolvedValue]]:
    if isinstance(value, ProjectSection):
        names = zip(type(value).model_fields, value.entries().items(), strict=True)
        for name, (written, item) in names:
            yield from _resolve(f"{key}.{written}".lstrip("."), item, given and value.has_key(name), folder)
    elif isinstance(value, Mapping):
        for name, item in value.items():
            yield from _resolve(f"{key}.{name}", item, given, folder)
    else:
        yield key, ResolvedValue(_plain(value, folder), given)


def _plain(value: Any, folder: Path) -> Any:
    """Return a value as JSON holds it."""
    if isinstance(value, Path):
        return relative_path(value, folder)
    if isinstance(value, ProjectSection):
        return {key: _plain(item, folder) for key, item in value.entries().items()}
    return [_plain(item, folder) for item in value] if isinstance(value, tuple) else value


def _tables(raw: Mapping[str, Any], table: str) -> Iterable[tuple[str, Mapping[str, Any]]]:
    named = look_up(raw, (table,))[1]
    return [(name, each) for name, each in _entries_of(named) if isinstance(each, Mapping)]


def _entries_of(table: object) -> Iterable[tuple[str, Any]]:
    return table.items() if isinstance(table, Mapping) else ()


def _size_messages(body: KeyPath, raw: Mapping[str, Any]) -> Iterator[Message]:
    """Warn of each size of a box or profile if one of them is huge and all are written without a unit."""
    sizes = {key: (words, size) for key, words, size in _sizes(raw) if is_number(size)}
    if not any(size > HUGE for _, size in sizes.values()):
        return
    units = [unit for unit in SHORTER if all(_is_built(words, size, unit) for words, size in sizes.values())]
    for key, (_, size) in sizes.items():
        if size > HUGE or units:
            likely = " / ".join(f'"{Quantity(size)} {unit}"' for unit in units or ("mm",))
            yield warning("box-size", key_text((*body, *key)), given=Quantity(size, "length"), likely=likely)


def _sizes(raw: Mapping[str, Any]) -> Iterator[tuple[KeyPath, str, Any]]:
    """Yield the sizes of a body with their keys and names."""
    for name, size in _entries_of(raw.get("box")):
        if name in BUILT:
            yield ("box", name), name, size
    corners = raw.get("profile")
    if isinstance(corners, list) and corners:
        yield ("length",), "length", raw.get("length")
        for name, axis in (("thickness", 0), ("height", 1)):
            yield ("profile",), name, _extent(corners, axis)


def _extent(corners: Sequence[Any], axis: int) -> float | None:
    """Return the extent along an axis of corners written without a unit."""
    along = [corner[axis] for corner in corners if isinstance(corner, list) and len(corner) == 2]
    return max(along) - min(along) if along and all(map(is_number, along)) else None


def _is_built(words: str, size: float, unit: str) -> bool:
    least, most = BUILT[words]
    return least <= size * float(USUAL["length"][unit]) <= most


def _material_messages(material: KeyPath, raw: Mapping[str, Any]) -> Iterator[Message]:
    """Warn of each number of a material that no masonry has, with the unit that was likely meant."""
    for name, (dimension, ranges) in MATERIALS.items():
        value: Any = raw.get(name)
        unit = next((unit for low, high, unit in ranges if is_number(value) and low <= value < high), "")
        if unit:
            given = Quantity(value, dimension)
            yield warning(
                "material-unit", key_text((*material, name)), given=given, likely=f'"{Quantity(value)} {unit}"'
            )


def _acceleration_messages(raw: Mapping[str, Any]) -> Iterator[Message]:
    levels = look_up(raw, ("analysis", "levels"))[1] or ()
    rows = look_up(raw, (*SPECTRUM, "hazard"))[1] or ()
    listed: list[KeyPath] = [("analysis", "levels", place) for place in range(len(levels))]
    listed += [(*SPECTRUM, "hazard", place, "a_g") for place in range(len(rows))]
    for key in (*ACCELERATION_KEYS, *listed):
        value = look_up(raw, key)[1]
        if isinstance(value, int | float) and value < WEAK:
            given, as_g = Quantity(value, "acceleration"), Quantity(value / g, "ground acceleration", 3)
            yield warning("unit", key_text(key), given=given, as_g=as_g, number=Quantity(value))


DENSITY = KINDS["density"]


def _weight_density_messages(content: Content, raw: Mapping[str, Any]) -> Iterator[Message]:
    """Note each density of the `raw` file that is a weight per volume."""
    for place in stated_values(content):
        typed = look_up(raw, place.path)[1] if place.kind == DENSITY else None
        if isinstance(typed, str) and is_weight(typed, DENSITY):
            density = Quantity(place.value, "density", 6)
            yield note("weight-density", key_text(place.path), given=typed, density=density)


def _quantity_kind(node: dict[str, Any]) -> str:
    """Return the kind of quantity that a key holds, a ratio where it has no unit, as a restitution."""
    marks = (each[PATTERN_MARK] for each in (node, *node.get("anyOf", ())) if PATTERN_MARK in each)
    kind: str = next(marks, ("ratio",))[0]
    return kind


def _uncertain_number_schema(kind: str) -> dict[str, Any]:
    """Return the schema of an uncertain number of a kind of quantity."""
    schema = UncertainNumber.model_json_schema()
    mean, sd = (schema["properties"][key] for key in ("mean", "sd"))
    mean.update(quantity_schema(kind))
    sd["anyOf"][0].update(quantity_schema(kind))
    return schema


def _without_null(node: dict[str, Any]) -> dict[str, Any]:
    choices = node.get("anyOf")
    if not isinstance(choices, list) or {"type": "null"} not in choices:
        return node
    left = [each for each in choices if each != {"type": "null"}]
    return (
        {**left[0], **{key: node[key] for key in node if key != "anyOf"}} if len(left) == 1 else node | {"anyOf": left}
    )


def _without_choice(node: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    """Return `node` with the tables of its `oneOf` told apart by their keys; as it is where these do not tell.

    The tables stand in an `anyOf` that accepts anything beside: editors take the keys they offer from there.
    """
    choices = node.get("oneOf", ())
    if not choices or not all(set(each) == {"$ref"} for each in choices):
        return node
    tables = [definitions[each["$ref"].removeprefix(_REFERENCE)] for each in choices]
    if not all("properties" in table for table in tables):
        return node
    kinds = [key for key in tables[0]["properties"] if all(_words_of_key(each, key) for each in tables)]
    signs = _signs(tables, kinds)
    if signs is None:  # a table may have all keys of another and some of its own: it is told first
        choices = sorted(
            choices, key=lambda each: -len(definitions[each["$ref"].removeprefix(_REFERENCE)]["properties"])
        )
        signs = _signs([definitions[each["$ref"].removeprefix(_REFERENCE)] for each in choices], kinds)
    if signs is None:
        return node
    found = signs[-1]
    for sign, choice in reversed(list(zip(signs, choices, strict=False))):
        found = {"if": sign, "then": choice, "else": found}
    return {**{key: node[key] for key in node if key != "oneOf"}, **found, "anyOf": [*choices, {}]}


def _signs(tables: list[dict[str, Any]], kinds: list[str]) -> list[dict[str, Any]] | None:
    """Return for each table a schema that it meets and no later one does; at the end, one for what meets none.

    Parameters
    ----------
    tables : the schemas of tables
    kinds : keys that take one word or a few in each of them, like `kind`

    Returns
    -------
    None where no key tells a table from the later ones
    """
    signs: list[dict[str, Any]] = []
    for number, table in enumerate(tables):
        required, properties = table.get("required", ()), table["properties"]
        sign: dict[str, Any] = {}
        if kinds:
            sign["properties"] = {key: {"enum": _words_of_key(table, key)} for key in kinds}
            sign["required"] = [key for key in kinds if key in required]
        others = [*tables[:number], *tables[number + 1 :]] if not kinds else tables[number + 1 :]
        rivals = [
            each
            for each in others
            if all(set(_words_of_key(table, key)) & set(_words_of_key(each, key)) for key in kinds)
        ]
        own = [key for key in properties if not any(key in each["properties"] for each in rivals)]
        if rivals and not set(own) & set(required):
            return None
        signs.append({**sign, "anyOf": [{"required": [key]} for key in own]} if rivals else sign)
    if not kinds:
        return [*signs, {"anyOf": list(signs)}]
    every = {key: {"enum": sorted({word for table in tables for word in _words_of_key(table, key)})} for key in kinds}
    return [*signs, {"properties": every, "required": kinds}]


def _words_of_key(table: dict[str, Any], key: str) -> list[str]:
    """Return the words that a key of a table takes; none for a key of another type."""
    found = table["properties"].get(key, {})
    return [found["const"]] if "const" in found else list(found.get("enum", ()))
