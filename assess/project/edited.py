"""A project file under edit: values that are tried, taken back step by step, and written with the comments kept."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from math import ceil, log10
from pathlib import Path
from typing import Any

from assess.codes.question import Missing, toml_lines
from assess.errors import OutputError, ProjectError
from assess.outputs.writing import replace_file
from assess.project import sections
from assess.project.bars import with_bars
from assess.project.found_mechanisms import FoundMechanisms, add_mechanisms
from assess.project.key_errors import KeyPath, key_text, look_up
from assess.project.keys import Setting, dependents, keyed_values, read_content, with_values
from assess.project.project_file import Project, load, load_tree, parse_toml
from assess.project.toml_text import with_changes
from assess.study.states import STRUCK_OUT
from spectra.arrays import is_number

PLACES = frozenset({"direction", "cut", "crack", "profile", "base", "at", "anchor", "hinges", "point", "centroid"})
"""Keys of places and directions, which are not numbers to be varied one by one."""
SOURCES: KeyPath = ("report", "sources")
PURE = frozenset({"ratio", "number"})
"""Kinds of quantities without a unit."""
FIGURES = 9
"""Of a number that is typed."""
CHANGED = "has changed since it was read; nothing was written: press “Read again”, which forgets what is tried"


@dataclass(frozen=True)
class Number:
    """A number of the file on which a mechanism depends: its key, its value in SI and the unit, empty for none."""

    path: KeyPath
    value: float
    unit: str

    @property
    def text(self) -> str:
        """The key as users write it."""
        return key_text(self.path)

    @property
    def decimals(self) -> int:
        """How many decimals are taken of a number that is typed in place of it."""
        return min(12, max(0, FIGURES - ceil(log10(abs(self.value) or 1.0))))

    def file_value(self, value: float) -> Any:
        """Return another value of it as the project file writes it."""
        return f"{value:.{FIGURES}g} {self.unit}" if self.unit else float(f"{value:.{FIGURES}g}")


class EditedProject:
    """A project file with the values that are tried on it, each a step that can be taken back.

    project : as the file has it
    changes : what is tried, the oldest first
    revision : rises with each change of either
    """

    def __init__(self, path: Path) -> None:
        self._written: list[tuple[bytes, bytes]] = []
        self.project: Project = load(path)
        self.changes: tuple[Setting, ...] = ()
        self.revision = 0

    def read(self) -> None:
        """Read the file anew, and forget what is tried.

        Raises
        ------
        ProjectError : it breaks the schema
        """
        self.project = load(self.project.path)
        self._try(())

    def _try(self, changes: tuple[Setting, ...]) -> None:
        self.changes, self.revision = changes, self.revision + 1

    @property
    def can_undo(self) -> bool:
        """Whether something was tried or written that can be taken back."""
        return bool(self.changes or self._written)

    def content(self, directed: Project) -> sections.Content:
        """Return the tables with what is tried, of a project with directions that its file may leave open.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        return read_content(self._tried(directed.raw), directed.folder)

    def tried_project(self) -> Project:
        """Return the project as the file would be read once what is tried is written.

        Raises
        ------
        ProjectError : it would not be read, or the file has changed since it was
        """
        text = self._unchanged_bytes().decode("utf-8-sig")
        return load_tree(dict(self._tried(parse_toml(text))), self.project.path, sha256=self.project.sha256)

    def numbers(self, name: str, directed: Project) -> tuple[Number, ...]:
        """Return the numbers that the file gives and a mechanism depends on, as they are tried, but for places.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        content = self.content(directed)
        return tuple(
            Number(
                each.path, float(each.value), "" if each.kind is None or each.kind.name in PURE else each.kind.symbol
            )
            for each in keyed_values(content).values()
            if each.path[0] in ("materials", "bodies", "mechanisms")
            and is_number(each.value)
            and PLACES.isdisjoint(each.path)
            and look_up(self.project.raw, each.path)[0]
            and name in dependents(content, each.path[:2])
        )

    def tried_value(self, key: KeyPath) -> Any:
        """Return what the file says at a key with what is tried; None where it says nothing."""
        return look_up(self._tried(self.project.raw), key)[1]

    @property
    def outlived(self) -> str:
        """Which sources of the file vouched for values that are others in what is tried; empty where none did."""
        before, after = look_up(self.project.raw, SOURCES)[1] or {}, self.tried_value(SOURCES) or {}
        changed = [key_text(key) for setting in self.changes for key in setting]
        found = [
            f"{key} ({source})"
            for key, source in before.items()
            if after.get(key) == source and any(_is_within(each, key) or _is_within(key, each) for each in changed)
        ]
        return f"its source vouched for the value before: {'; '.join(found)}" if found else ""

    def change(self, setting: Setting, *, goes_on: bool = False) -> None:
        """Try other values at some keys.

        Parameters
        ----------
        setting : the values by their keys
        goes_on : whether they take the place of those tried last at the same keys
        """
        setting = with_bars(setting, self.project.content)
        same = goes_on and self.changes and self.changes[-1].keys() == setting.keys()
        self._try((*(self.changes[:-1] if same else self.changes), setting))

    def add_lines(self, missing: Missing, text: str, *, source: str = "") -> None:
        """Try a line for what is missing.

        Parameters
        ----------
        missing : what it is for
        text : the line of TOML
        source : who vouches for the value; empty where nobody does

        Raises
        ------
        ProjectError : it is no TOML, or the project cannot be read with it; it is not tried then
        """
        heading = next(iter(toml_lines([missing], ())), "")
        try:
            tables = tomllib.loads(f"{heading}\n{text}\n")
        except tomllib.TOMLDecodeError as error:
            raise ProjectError(f"{missing.key}: {text!r:.60}: {error}; write it as the example shows") from None
        setting: dict[KeyPath, Any] = dict(_leaves((), tables))
        asked: list[KeyPath] = []
        with suppress(tomllib.TOMLDecodeError):  # of an example whose values are dots
            asked = [path for path, _ in _leaves((), tomllib.loads(f"{heading}\n{missing.toml}\n"))]
        for path in setting:
            if not (_is_within(key_text(path), missing.key) or any(path[: len(each)] == each for each in asked)):
                raise ProjectError(f"{key_text(path)}: these lines are for {missing.key} alone; nothing was tried")
        if source:
            vouched = {".".join(map(str, path)): source for path in setting}
            setting |= self._with_entries(SOURCES, vouched)
        self._change_if_read(setting)

    def strike_out(self, name: str, reason: str) -> None:
        """Try the project without a mechanism, which cannot occur for a reason.

        Raises
        ------
        ProjectError : there is no reason, or it is the last mechanism; it is not tried then
        """
        self._change_if_read(self._with_entries(STRUCK_OUT, {name: reason}))

    def state_front(self, key: str, text: str) -> None:
        """Try a text of the report's front matter, of a key of [report]; typed on, it is one step.

        Raises
        ------
        ProjectError : it cannot be read; it is not tried then
        """
        self._change_if_read({("report", key): text}, goes_on=True)

    def _with_entries(self, table: KeyPath, entries: Mapping[str, str]) -> dict[KeyPath, Any]:
        stated = self.tried_value(table)
        return {table: {**(stated if isinstance(stated, Mapping) else {}), **entries}}

    def _change_if_read(self, setting: Setting, *, goes_on: bool = False) -> None:
        before = self.changes
        self.change(setting, goes_on=goes_on)
        try:
            self.tried_project()
        except ProjectError:
            self._try(before)
            raise

    def undo(self) -> str:
        """Take back what was tried last, or else what was written last; return what was done.

        Raises
        ------
        ProjectError : the file has changed since it was written
        """
        if self.changes:
            self._try(self.changes[:-1])
            return "taken back"
        if not self._written:
            return "nothing to take back"
        before, after = self._written[-1]
        self._replace(after, before)
        self._written.pop()
        self.read()
        return "the file is as it was before"

    def write(self) -> str:
        """Write what is tried into the project file, whose comments stay; return what was done.

        Raises
        ------
        ProjectError : the file has changed since it was read, or would no longer be read; nothing is written then
        """
        if not self.changes:
            return "nothing to write"
        before = self._unchanged_bytes()
        text = before.decode("utf-8-sig")
        tables = dict(self._tried(parse_toml(text)))
        load_tree(dict(tables), self.project.path, sha256="")
        made, kept = with_changes(text, tables)
        after = made.encode()
        self._replace(before, after)
        self._written.append((before, after))
        self.read()
        return f"written into {self.project.path.name}" + ("" if kept else ", without its comments")

    def add_found(self, found: FoundMechanisms | None) -> str:
        """Write the mechanisms that were found and are not in the file at its end; return what was done.

        Raises
        ------
        ProjectError : the file has changed since it was read, or values are tried that would be lost
        """
        if found is None or not found.new:
            return "nothing to add"
        if self.changes:
            raise ProjectError("values are tried that are not written: write them, or undo, and add then")
        before = self._unchanged_bytes()
        names = add_mechanisms(self.project, found)
        self._written.append((before, self.project.path.read_bytes()))
        self.read()
        return f"{len(names)} added to {self.project.path.name}"

    def _tried(self, tables: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return tables of the file with what is tried."""
        for setting in self.changes:
            tables = with_values(tables, setting, self.project.content)
        return tables

    def _unchanged_bytes(self) -> bytes:
        found = self.project.path.read_bytes()
        if sha256(found).hexdigest() != self.project.sha256:
            raise ProjectError(f"{self.project.path}: {CHANGED}")
        return found

    def _replace(self, before: bytes, after: bytes) -> None:
        path = self.project.path
        try:
            with replace_file(
                path, command="assess serve", is_replaceable=lambda there: there.read_bytes() == before
            ) as made:
                made.write_bytes(after)
        except OutputError:
            if path.exists() and path.read_bytes() != before:
                raise ProjectError(f"{path}: {CHANGED}") from None
            raise


def _is_within(key: str, table: str) -> bool:
    """Return whether a key, as users write it, is another or below it."""
    return key == table or key.startswith((f"{table}.", f"{table}["))


def _leaves(path: KeyPath, tables: Mapping[str, Any]) -> Iterator[tuple[KeyPath, Any]]:
    for name, value in tables.items():
        below = [*_leaves((*path, name), value)] if isinstance(value, dict) else []
        yield from below or [((*path, name), value)]
