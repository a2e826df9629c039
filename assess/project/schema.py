"""The project file: read, checked against its schema, every quantity in SI.

    load(path) -> Project      raises ProjectError with one line: file: key: value: what is wrong; remedy
    load_tree(tables, path)    the same of tables that no file holds, such as a template with the values of a row
    resolve(project)          every key with its value and whether it was given or is a default
    json_schema()              the schema itself, for editors

The tables are the classes of `assess.project.sections`.
"""

from __future__ import annotations

import hashlib
import json
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

from assess.errors import ProjectError
from assess.messages.message import Message
from assess.project.bare_numbers import bare_number_messages
from assess.project.key_text import error_line, escape_text, value_text
from assess.project.keys import places_of
from assess.project.quantity_patterns import with_quantity_patterns
from assess.project.schema_faults import with_located_faults
from assess.project.section import Section
from assess.project.sections.content import Content
from assess.project.sections.uncertain_number import with_uncertain_numbers
from assess.project.uncertain_values import UncertainValue, covs_of, take_means, uncertain_values
from assess.project.variations import Variation, variations
from assess.project.weight_densities import weight_density_messages
from assess.results import Resolved
from records.paths import relative_path

T = TypeVar("T")
FORMAT = 1
FILE_NAME = "project.toml"
TITLE = "Project file of assess"
"""Title of the schema, by which its file is known."""
_DECIMAL_COMMA = re.compile(r"=\s*([+-]?\d+,\d+)(?![.\d\]])")
_UPGRADES: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}  # from format n to n + 1; there is only one yet


@dataclass(frozen=True, repr=False)
class Project:
    """A project file as read.

    content : its tables, every quantity an SI float, every path absolute or below `folder`
    path : the project file; sha256 : of its bytes
    variations : its sweeps, each with the content of every case
    messages : what looks like a slip in the file as it was written
    raw : what the file says, in the newest format, as it was written, with the means of uncertain numbers
    uncertain : numbers given as { mean, cov }
    """

    content: Content
    path: Path
    sha256: str
    variations: tuple[Variation, ...]
    messages: tuple[Message, ...]
    raw: Mapping[str, Any]
    uncertain: tuple[UncertainValue, ...] = ()

    def __repr__(self) -> str:
        return f"Project({str(self.path)!r}, mechanisms: {', '.join(self.content.mechanisms)})"[:200]

    @property
    def folder(self) -> Path:
        """The folder of the project file; its paths are relative to this."""
        return self.path.parent


def load(path: Path | str) -> Project:
    """Read the project in the file `path`, or in `project.toml` of the folder `path`.

    Raises ProjectError for a file that is missing, is not TOML, or breaks the schema.
    """
    file = _project_file(Path(path))
    data = _bytes(file)
    try:
        tables = _toml(_text(data))
    except ProjectError as error:
        raise ProjectError(f"{file}: {error}") from None
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
    ProjectError : it breaks the schema
    """
    raw = tables
    try:
        raw, stated = take_means(_upgraded(tables), file.parent)
        content = Content.model_validate(raw, context={"folder": file.parent})
        uncertain = uncertain_values(content, stated)
        varied = variations(content, raw, file.parent)
    except ValidationError as error:
        raise ProjectError(f"{file}: {error_line(error, raw=raw)}") from None
    except ProjectError as error:
        raise ProjectError(f"{file}: {error}") from None
    messages = (*bare_number_messages(raw), *weight_density_messages(content, raw))
    project = Project(content, file, sha256, varied, messages, raw, uncertain)
    _check_sources(project)
    return project


def _check_sources(project: Project) -> None:
    """Check that every key of [report.sources] is one of the file, or the beginning of one."""
    if not project.content.report.sources:
        return
    every = _resolved("", project.content, True, project.folder)
    keys = [key for key, _ in every if not key.startswith("report.sources.")]
    starts = {".".join(key.split(".")[: n + 1]) for key in keys for n in range(key.count(".") + 1)}
    for key in project.content.report.sources:
        if key not in starts:
            near = get_close_matches(key, starts, n=1)
            remedy = f"do you mean {value_text(near[0])}?" if near else 'write one like "materials.NAME.density"'
            raise ProjectError(f"{project.path}: report.sources: {value_text(key)}: not a key of this file; {remedy}")


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


def _toml(text: str) -> dict[str, Any]:
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


def _upgraded(raw: dict[str, Any]) -> dict[str, Any]:
    """Convert the content to the newest format, one pure step at a time."""
    given = raw.get("format", FORMAT)
    if not isinstance(given, int) or isinstance(given, bool) or given < 1:
        raise ProjectError(f"format: {value_text(given)}: not a format number; write format = {FORMAT}")
    if given > FORMAT:
        raise ProjectError(f"format: {given}: newer than this program, which reads up to {FORMAT}; update it")
    for step in range(given, FORMAT):
        raw = _UPGRADES[step](raw)
    return raw


def resolve(project: Project) -> dict[str, Resolved]:
    """Return every key, written with dots, with its value in SI and whether it was given or is a default.

    Paths are written relative to the project file.
    """
    found = dict(_resolved("", project.content, True, project.folder))
    kinds = {key: place.kind.name for key, place in places_of(project.content).items() if place.kind is not None}
    covs = covs_of(project.uncertain)
    return {key: replace(each, dimensions=_below(key, kinds), cov=_covs(key, covs)) for key, each in found.items()}


def _covs(key: str, covs: Mapping[str, float]) -> dict[str, float]:
    """Return the scatter of the numbers at and below a key; one number may stand for the keys of a table, above it."""
    above = [cov for written, cov in covs.items() if key.startswith(f"{written}.")]
    return {"": above[0]} if above else _below(key, covs)


def _below(key: str, known: Mapping[str, T]) -> dict[str, T]:
    """Return what is known of the numbers at and below a key, by the way to them."""
    if key in known:
        return {"": known[key]}
    return {way[len(key) + 1 :]: each for way, each in known.items() if way.startswith(f"{key}.")}


def _resolved(key: str, value: Any, given: bool, folder: Path) -> Iterator[tuple[str, Resolved]]:
    if isinstance(value, Section):
        names = zip(type(value).model_fields, value.entries().items(), strict=True)
        for name, (written, item) in names:
            yield from _resolved(f"{key}.{written}".lstrip("."), item, given and value.has_key(name), folder)
    elif isinstance(value, Mapping):
        for name, item in value.items():
            yield from _resolved(f"{key}.{name}", item, given, folder)
    else:
        yield key, Resolved(_plain(value, folder), given)


def _plain(value: Any, folder: Path) -> Any:
    """Return a value as JSON holds it."""
    if isinstance(value, Path):
        return relative_path(value, folder)
    if isinstance(value, Section):
        return {key: _plain(item, folder) for key, item in value.entries().items()}
    return [_plain(item, folder) for item in value] if isinstance(value, tuple) else value


def schema_text() -> str:
    """Return the JSON Schema of the project file as the text of a file."""
    return json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the project file."""
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": TITLE}
    found = with_quantity_patterns(with_uncertain_numbers(Content.model_json_schema()))
    return {**with_located_faults(found), **head}
