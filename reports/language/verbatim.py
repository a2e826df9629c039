"""The user's own texts: collected from the results, and kept out of reach of the translation."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import PurePath

from assess.results import Results

FREE = ("title", "engineer", "checker", "reference", "client", "date", "notes", "masonry_quality", "label", "name")
NAMED = ("mechanisms", "bodies", "materials")  # tables of the project file whose keys are names
SOURCES = "report.sources."
_FIRST_MARK = 0xF0000  # marks that replace texts: private use, plane 15
_KEPT = 8  # characters by which a shortened text is known


def verbatim(results: Results) -> frozenset[str]:
    """Return every text that the user, a file or a record gave: names, labels, titles, notes, paths, sources."""
    program = f"{results.program.name} {results.program.version}"
    found = {program, results.stamp, *_of_project(results), *_of_records(results), *_of_mechanisms(results)}
    return frozenset(text.strip() for text in found if text and text.strip())


def _of_project(results: Results) -> Iterator[str]:
    for key, resolved in results.project.items():
        table, _, rest = key.partition(".")
        if table in NAMED and rest:
            yield rest.partition(".")[0]
        if key.rpartition(".")[2] in FREE:
            yield str(resolved.value or "")
        if key.startswith(SOURCES):
            yield str(resolved.value).partition(":")[2]
        if key == "records.files" and isinstance(resolved.value, list):
            yield from map(str, resolved.value)


def _of_records(results: Results) -> Iterator[str]:
    for each in results.inputs:
        yield from (each.path, PurePath(each.path).name)
    for record in results.records:
        yield from (record.id, record.path, record.event, record.station, record.component)


def _of_mechanisms(results: Results) -> Iterator[str]:
    for mechanism in results.mechanisms:
        yield from (mechanism.name, mechanism.label)


@dataclass(frozen=True)
class Masks:
    """How texts are kept: a pattern that finds them whole or shortened, on one line or several."""

    pattern: re.Pattern[str] | None

    def around(self, change: Callable[[str], str], text: str) -> str:
        """Apply `change` to `text` with a mark for each text of the user; not where `text` has such marks itself."""
        if any(map(is_mark, text)):
            return text
        kept: list[str] = []

        def mark(found: re.Match[str]) -> str:
            kept.append(found[0])
            return chr(_FIRST_MARK + len(kept) - 1)

        masked = text if self.pattern is None else self.pattern.sub(mark, text)
        return "".join(kept[ord(letter) - _FIRST_MARK] if is_mark(letter) else letter for letter in change(masked))


def is_mark(letter: str) -> bool:
    """Return whether a letter represents a text of the user."""
    return ord(letter) >= _FIRST_MARK


def masks(texts: Iterable[str], *, spared: str) -> Masks:
    """Return masks of the texts, the longest first.

    spared : sentences of the catalogue; a text that is part of one, like "wall", is not masked inside of sentences
    """
    wanted = sorted((text for text in texts if not _part(text, spared)), key=lambda text: (-len(text), text))
    found = "|".join(map(_pattern, wanted))
    return Masks(re.compile(rf"(?<![\w-])(?:{found})(?![\w-])") if found else None)


def _pattern(text: str) -> str:
    whole = _spaced(text)
    return whole if len(text) <= _KEPT else rf"{whole}|{_spaced(text[:_KEPT].rstrip())}[^…]{{0,500}}…"


def _spaced(text: str) -> str:
    """Return a text that may be broken into lines at its spaces and hyphens."""
    return r"\s+".join(re.escape(word).replace(r"\-", r"\-\s*") for word in text.split())


def _part(text: str, sentences: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(text)}(?!\w)", sentences) is not None
