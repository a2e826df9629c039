"""The sentences of the report in another language: pairs, the English one first, from one file of each language.

A file is languages/CODE.toml. Its table `furniture` and those under `sentences` and `phrases` hold pairs
"English" = "other", with gaps {0}, {1}, …; what stands in a gap is looked up in its turn. Phrases, like the lists
"{0} and {1}", hold only where everything in their gaps is known: a sentence that nobody has translated is not half
translated. `unchanged` lists words that are alike in both languages.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from reports.language.template import Template, has_gaps, template, words

FOLDER = Path(__file__).parent / "catalogues"
ENGLISH = "en"


@dataclass(frozen=True)
class Catalogue:
    """The sentences of one language.

    language : its code (ISO 639-1)
    furniture : words of the renderers, by the English ones
    exact : sentences without gaps, those words among them
    by_word : sentences with gaps, under the longest word of each
    phrases : those that hold where everything in their gaps is known, the longest first
    unchanged : words that are alike in both languages
    english : every English sentence
    """

    language: str
    furniture: Mapping[str, str]
    exact: Mapping[str, str]
    by_word: Mapping[str, tuple[Template, ...]]
    phrases: tuple[Template, ...]
    unchanged: frozenset[str]
    english: tuple[str, ...]

    def candidates(self, text: str) -> Iterator[Template]:
        """Yield the templates that may fit, those with most fixed letters first."""
        found = [each for word in dict.fromkeys(("", *words(text))) for each in self.by_word.get(word, ())]
        yield from sorted(found, key=lambda each: -each.size)


def languages() -> tuple[str, ...]:
    """Return the codes of all languages that a report can be written in, English first."""
    return (ENGLISH, *sorted(path.stem for path in FOLDER.glob("*.toml")))


@cache
def catalogue(language: str) -> Catalogue:
    """Return the sentences of a language; raises ValueError where there is no file of it."""
    path = FOLDER / f"{language}.toml"
    if language not in languages()[1:]:
        raise ValueError(f'report.language: "{language}" has no catalogue; known are {", ".join(languages())}')
    return parse_catalogue(tomllib.loads(path.read_text(encoding="utf-8")), language=language)


def parse_catalogue(content: Mapping[str, Any], *, language: str) -> Catalogue:
    """Return the catalogue of a parsed file; raises ValueError for a sentence given twice, or with other gaps."""
    phrases = _merge([*content["phrases"].values()])
    sentences = _merge([content["furniture"], *content["sentences"].values()])
    pairs = _merge([sentences, phrases])
    by_word: dict[str, list[Template]] = {}
    for one in filter(has_gaps, sentences):
        made = template(one, sentences[one])
        by_word.setdefault(made.word, []).append(made)
    lists = [template(one, phrases[one]) for one in filter(has_gaps, phrases)]
    return Catalogue(
        language=language,
        furniture=content["furniture"],
        exact={one: other for one, other in pairs.items() if not has_gaps(one)},
        by_word={word: tuple(found) for word, found in by_word.items()},
        phrases=tuple(sorted(lists, key=lambda each: -each.size)),
        unchanged=frozenset(content["unchanged"]),
        english=tuple(pairs),
    )


def _merge(tables: list[dict[str, str]]) -> dict[str, str]:
    found: dict[str, str] = {}
    for one, other in (pair for table in tables for pair in table.items()):
        if found.setdefault(one, other) != other:
            raise ValueError(f'"{one}" stands twice, as "{found[one]}" and as "{other}"; keep one')
    return found
