"""An example of each table of the project file, as a project shipped with the program writes it."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping, Sequence
from datetime import date
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from assess.examples import EXAMPLES, source
from assess.project.project_file import FILE_NAME, load
from assess.project.section import ProjectSection
from docs.ext.schema_tables import Place, Table

LONGEST = 110  # columns of a line


def example(place: Place) -> str:
    """Return a table of a shipped project as TOML, the one with the most keys; "" if none has it."""
    written = _written().get(place.table, [])
    if not written or not place.path:
        return ""
    path, most = max(written, key=lambda each: sum(not _is_long(value) for value in each[1].values()))
    lines = [f"{key} = {toml(value)}" for key, value in most.items() if not _is_long(value)]
    return "\n".join((f"[{path}]" if "[" not in path else f"# in {path}", *lines)) + "\n" if lines else ""


@cache
def _written() -> dict[Table, list[tuple[str, Mapping[str, Any]]]]:
    """Return, for each class, its tables in the shipped projects with their paths."""
    found: dict[Table, list[tuple[str, Mapping[str, Any]]]] = {}
    with TemporaryDirectory() as folder:
        for name, shipped in EXAMPLES.items():
            if shipped.file == FILE_NAME:
                place = shutil.copytree(source(name), Path(folder) / name)
                for path in (*shipped.meshes(), *shipped.tables(), *shipped.models()):
                    (place / path).parent.mkdir(exist_ok=True)
                    (place / path).touch()  # that it is there is all that reading a project file asks
                project = load(place)
                for path, table, raw in _tables(project.content, project.raw, ""):
                    found.setdefault(type(table), []).append((path, raw))
    return found


def _tables(value: Any, raw: Any, path: str) -> Iterator[tuple[str, ProjectSection, Mapping[str, Any]]]:
    """Yield every table within a value that was read, beside how it was written."""
    if isinstance(value, ProjectSection) and isinstance(raw, Mapping):
        yield path, value, raw
        for key, inner in value.entries().items():
            if key in raw:
                yield from _tables(inner, raw[key], f"{path}.{key}".lstrip("."))
    elif isinstance(value, Mapping) and isinstance(raw, Mapping):
        for key, inner in value.items():
            yield from _tables(inner, raw.get(key), f"{path}.{key}")
    elif isinstance(value, tuple) and isinstance(raw, list):
        for number, (inner, one) in enumerate(zip(value, raw, strict=False)):
            yield from _tables(inner, one, f"{path}[{number}]")


def _is_long(value: Any) -> bool:
    return len(toml(value)) > LONGEST


def toml(value: Any) -> str:
    """Return a value as inline TOML."""
    match value:
        case bool():
            return str(value).lower()
        case str():
            return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
        case Mapping():
            return "{ " + ", ".join(f"{key} = {toml(each)}" for key, each in value.items()) + " }"
        case Sequence():
            return "[" + ", ".join(map(toml, value)) + "]"
        case date():
            return value.isoformat()
        case _:
            return repr(value)
