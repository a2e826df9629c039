"""The text of a TOML file with other values at some keys, its comments and its order kept as far as that can be done.

A scanner finds where each value stands in the text; what differs is replaced, added or appended there. What a comment
holds ready, as `# [site.spectrum]` or `# soil = "B"`, is filled in where it stands. The new text is read again: where
it does not say what it should, the whole is written anew, without comments.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date, time
from typing import Any

Path = tuple[str | int, ...]
Span = tuple[int, int]
Edit = tuple[int, int, str]
"""What stands in the text from one place to another is replaced."""
_SPACE = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_BLANK = re.compile(r"[ \t]*")
_KEY = re.compile(r'[A-Za-z0-9_-]+|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'')
_STRINGS = (
    re.compile(r'"""(?:\\.|[^\\])*?"""(?:"{0,2})', re.DOTALL),
    re.compile(r"'''.*?'''(?:'{0,2})", re.DOTALL),
    re.compile(r'"(?:[^"\\\n]|\\.)*"'),
    re.compile(r"'[^'\n]*'"),
)
_BARE = re.compile(r"[^,\]}#\r\n]+")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


class UnknownFormError(ValueError):
    """The text cannot be changed in place."""


def with_changes(text: str, after: Mapping[str, Any]) -> tuple[str, bool]:
    """Return the text of a TOML file that says `after`, and whether its comments are kept.

    Parameters
    ----------
    text : of a TOML file that can be read
    after : the tables that it is to hold
    """
    try:
        edits = list(_edits(text, tomllib.loads(text), after))
        made, at = "", 0
        for start, end, new in sorted(edits, key=lambda edit: edit[0]):
            made, at = f"{made}{text[at:start]}{new}", end
        made += text[at:]
        if tomllib.loads(made) == after:
            return made, True
    except (UnknownFormError, tomllib.TOMLDecodeError):
        pass
    return whole_text(after), False


def whole_text(tables: Mapping[str, Any]) -> str:
    """Return the text of a TOML file with these tables."""
    lines = [f"{_key(key)} = {value_text(value)}\n" for key, value in tables.items() if not isinstance(value, Mapping)]
    for name, table in tables.items():
        if isinstance(table, Mapping):
            lines += [f"\n[{_key(name)}]\n", *(f"{_key(key)} = {value_text(value)}\n" for key, value in table.items())]
    return "".join(lines)


def value_text(value: Any) -> str:
    """Write a value as TOML does, on one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):  # quoted as in JSON, and DEL too
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        inside = ", ".join(f"{_key(key)} = {value_text(each)}" for key, each in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, Sequence):
        return f"[{', '.join(map(value_text, value))}]"
    return value.isoformat() if isinstance(value, date | time) else repr(value)


def _key(name: str) -> str:
    return name if _BARE_KEY.fullmatch(name) else value_text(name)


@dataclass
class _Places:
    """Where values and the heads of tables stand in a text."""

    text: str
    values: dict[Path, Span] = field(default_factory=dict)
    heads: dict[Path, int] = field(default_factory=dict)
    counts: dict[Path, int] = field(default_factory=dict)

    def has_tables_on_lines(self, path: Path) -> bool:
        """Return whether a table holds others on one line each, as `[bodies]` may."""
        below = (start for each, (start, _) in self.values.items() if each[:-1] == path)
        return any(self.text.startswith("{", start) for start in below)


def _edits(text: str, before: Mapping[str, Any], after: Mapping[str, Any]) -> Iterator[Edit]:
    """Yield what differs between what a text says and what it is to say."""
    places = _places_of(text)
    yield from _edits_below((), before, after, places)


def _edits_below(path: Path, before: Any, after: Any, places: _Places) -> Iterator[Edit]:
    if before == after and type(before) is type(after):
        return
    if isinstance(before, Mapping) and isinstance(after, Mapping):
        if set(before) - set(after):
            raise UnknownFormError("a key is gone")
        for key, value in after.items():
            if key in before:
                yield from _edits_below((*path, key), before[key], value, places)
            else:
                yield from _insertion(path, key, value, places)
    elif isinstance(before, list) and isinstance(after, list) and len(before) <= len(after):
        for number, (one, other) in enumerate(zip(before, after, strict=False)):
            yield from _edits_below((*path, number), one, other, places)
        if more := after[len(before) :]:
            yield _appended(path, len(before), more, places)
    elif path in places.values:
        yield (*places.values[path], value_text(after))
    else:
        raise UnknownFormError("a value without a place")


HEADED = 2  # steps: a table as deep has a head of its own, a deeper one stands on one line


def _insertion(path: Path, key: str, value: Any, places: _Places) -> Iterator[Edit]:
    """Yield what adds a key to a table."""
    line = f"{_key(key)} = {value_text(value)}"
    if path in places.values:
        start, end = places.values[path]
        last = places.text[start + 1 : end - 1].rstrip()
        at = start + 1 + len(last)
        yield at, at, f", {line}" if last.strip() else f" {line} "
    elif isinstance(value, Mapping) and value and len(path) < HEADED and not places.has_tables_on_lines(path):
        yield from _new_table((*path, key), value, places)
    elif path in places.heads:
        at = places.heads[path]
        start, end = _commented(places.text, at, key) or (at, at)
        yield start, end, line if end > start else f"\n{line}"
    elif path:
        yield from _new_table(path, {key: value}, places)
    else:
        raise UnknownFormError("a value above all tables")


def _new_table(path: Path, table: Mapping[str, Any], places: _Places) -> Iterator[Edit]:
    """Yield what adds a table under its head: where a comment has the head of it, or else at the end."""
    below = {key: each for key, each in table.items() if isinstance(each, Mapping) and each and len(path) < HEADED}
    own = {key: f"{_key(key)} = {value_text(each)}" for key, each in table.items() if key not in below}
    head = f"[{'.'.join(_key(str(step)) for step in path)}]"
    text = places.text
    ready = re.search(rf"^#[ \t]*{re.escape(head)}[ \t]*$", text, re.MULTILINE)
    if own and ready and text[_skip(text, ready.end()) :][:1] in ("", "["):
        filled = {key: place for key in own if (place := _commented(text, ready.end(), key))}
        yield *ready.span(), "\n".join([head, *(line for key, line in own.items() if key not in filled)])
        yield from ((*place, own[key]) for key, place in filled.items())
    elif own:
        end = len(text)
        yield end, end, "\n".join(["\n", head, *own.values(), ""])
    for key, each in below.items():
        yield from _new_table((*path, key), each, places)


def _commented(text: str, start: int, key: str) -> Span | None:
    """Return the line of comment that holds a key ready below the head of its table; None where there is none."""
    end = re.compile(r"^(?:#[ \t]*)?\[", re.MULTILINE).search(text, start + 1)
    line = re.compile(rf"^# ?{re.escape(_key(key))} = .*$", re.MULTILINE)
    found = line.search(text, start, end.start() if end else len(text))
    return found.span() if found else None


def _appended(path: Path, number: int, items: Sequence[Any], places: _Places) -> Edit:
    """Return what adds items at the end of a list that has a number of them."""
    if path in places.values:
        texts = [value_text(item) for item in items]
        if not number:
            at = places.values[path][0] + 1
            return at, at, ", ".join(texts)
        start, end = places.values[(*path, number - 1)]
        before = places.text[places.text.rfind("\n", 0, start) + 1 : start]
        gap = f",\n{before}" if _BLANK.fullmatch(before) else ", "
        return end, end, "".join(f"{gap}{each}" for each in texts)
    if path in places.counts:
        head = f"[[{'.'.join(_key(str(step)) for step in path)}]]"
        blocks = ["".join(f"{_key(k)} = {value_text(v)}\n" for k, v in item.items()) for item in items]
        end = len(places.text)
        return end, end, "".join(f"\n\n{head}\n{block}" for block in blocks)
    raise UnknownFormError("a list without a place")


def _places_of(text: str) -> _Places:
    """Find where every value stands in the text of a TOML file."""
    places, table, at = _Places(text), tuple[str | int, ...](), _skip(text, 0)
    while at < len(text):
        if text.startswith("[", at):
            several = text.startswith("[[", at)
            keys, at = _dotted(text, _BLANK.match(text, at + 1 + several).end())  # type: ignore[union-attr]
            end = text.index("]]" if several else "]", at) + 1 + several
            table = _resolved(keys, places.counts, several=several)
            line_end = text.find("\n", end)
            at = places.heads[table] = len(text) if line_end < 0 else line_end
        else:
            keys, at = _dotted(text, at)
            at = _value(places, (*table, *keys), _BLANK.match(text, at + 1).end())  # type: ignore[union-attr]
        at = _skip(text, at)
    return places


def _resolved(keys: Path, counts: dict[Path, int], *, several: bool) -> Path:
    """Return the path of the table of a head, in the last table of each array of tables on its way."""
    path: Path = ()
    for number, key in enumerate(keys, start=1):
        path = (*path, key)
        if several and number == len(keys):
            counts[path] = counts.get(path, 0) + 1
        if path in counts:
            path = (*path, counts[path] - 1)
    return path


def _skip(text: str, at: int) -> int:
    found = _SPACE.match(text, at)
    return found.end() if found else at


def _dotted(text: str, at: int) -> tuple[Path, int]:
    """Read a key with dots; return it, and the place of the sign behind it."""
    keys: list[str] = []
    while True:
        found = _KEY.match(text, at)
        if found is None:
            raise UnknownFormError("no key")
        name = found[0]
        keys.append(next(iter(tomllib.loads(f"{name} = 0"))) if name[0] in "\"'" else name)
        at = _BLANK.match(text, found.end()).end()  # type: ignore[union-attr]
        if not text.startswith(".", at):
            return tuple(keys), at
        at = _BLANK.match(text, at + 1).end()  # type: ignore[union-attr]


def _value(places: _Places, path: Path, start: int) -> int:
    """Note where a value and those below it stand; return the place behind it."""
    text = places.text
    if text.startswith("[", start):
        at, number = _skip(text, start + 1), 0
        while not text.startswith("]", at):
            at = _comma(text, _value(places, (*path, number), at))
            number += 1
        end = at + 1
    elif text.startswith("{", start):
        at = _skip(text, start + 1)
        while not text.startswith("}", at):
            keys, at = _dotted(text, at)
            at = _comma(text, _value(places, (*path, *keys), _skip(text, at + 1)))
        end = at + 1
    elif found := next((match for each in _STRINGS if (match := each.match(text, start))), None):
        end = found.end()
    elif bare := _BARE.match(text, start):
        end = start + len(bare[0].rstrip())
    else:
        raise UnknownFormError("no value")
    places.values[path] = (start, end)
    return end


def _comma(text: str, at: int) -> int:
    """Return the place of the next item, or of the end of the list."""
    at = _skip(text, at)
    return _skip(text, at + 1) if text.startswith(",", at) else at
