"""A project as another folder has it: paths, which are relative to the project file, seen from there."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from assess.project.project_file import Project
from assess.project.section import ProjectSection


def relocate_paths(tables: Mapping[str, Any], project: Project, folder: Path) -> Mapping[str, Any]:
    """Return tables whose paths, which are relative to the project file, are relative to another folder.

    Parameters
    ----------
    tables : of the project, with works
    project : as it was read
    folder : the other one
    """
    changed: Any = tables
    for path in _path_keys((), project.content):
        changed = _with_paths(changed, path, project.folder, folder)
    return changed  # type: ignore[no-any-return]


def _path_keys(path: tuple[str | int, ...], value: Any) -> Iterator[tuple[str | int, ...]]:
    """Yield the keys at which content has a path or a list of paths."""
    if isinstance(value, Path) or (
        isinstance(value, tuple) and value and all(isinstance(each, Path) for each in value)
    ):
        yield path
    elif isinstance(value, ProjectSection | Mapping):
        entries = value.entries() if isinstance(value, ProjectSection) else value
        for key, each in entries.items():
            yield from _path_keys((*path, key), each)
    elif isinstance(value, tuple):
        for number, each in enumerate(value):
            yield from _path_keys((*path, number), each)


def _with_paths(node: Any, path: Sequence[str | int], old: Path, new: Path) -> Any:
    """Return tables with the paths at a key as seen from another folder; as they are where the key is not there."""
    if not path:
        if isinstance(node, list):
            return [seen_from(each, old, new) for each in node]
        return seen_from(node, old, new)
    step, rest = path[0], path[1:]
    if isinstance(node, Mapping) and step in node:
        return {**node, step: _with_paths(node[step], rest, old, new)}
    if isinstance(node, list) and isinstance(step, int) and step < len(node):
        return [*node[:step], _with_paths(node[step], rest, old, new), *node[step + 1 :]]
    return node


def seen_from(text: Any, old: Path, new: Path) -> Any:
    """Return a path or pattern of a file in one folder as a file in another has it; what is no such text as it is.

    Parameters
    ----------
    text : the path or pattern
    old, new : the folders
    """
    if not isinstance(text, str) or Path(text).is_absolute():
        return text
    try:
        between = Path(os.path.relpath(old.absolute(), new.absolute())).as_posix()
    except ValueError:  # on another drive
        between = old.absolute().as_posix()
    if between == ".":
        return text
    literal = (old / text).exists() or not glob.has_magic(text)
    return f"{between if literal else glob.escape(between)}/{text}"
