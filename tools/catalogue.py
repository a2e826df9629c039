"""The English entries that a catalogue of the report must have, collected from the source by Babel and by key.

    python -m tools.catalogue it      brings it.po up to date with the source, and lists what it lacks

Texts of the report are the literals of `say` and `say_count`; messages are those of `assess.messages.texts`; terms are
the fixed words that results hold, of `tests.languages.fixed_terms`.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_dir
from babel.messages.pofile import read_po, write_po

from assess.messages.texts import TEXTS
from reports.language.locale import FOLDER, UNIT_WORDS
from tests.languages.fixed_terms import fixed_terms
from tests.support.places import SOURCES

KEYWORDS = {"say": None, "say_count": (1, 2)}
HEAD = "# Italian sentences of the report, by the English ones. `make catalogue` keeps the entries up to date."
DATE = datetime(2026, 11, 22, tzinfo=UTC)
LOCALE_WORDS = ("Figure", "Table", "Sheet", "{first} and {last}", "{first} or {last}", *UNIT_WORDS)
WORD = re.compile(r"\b[A-Za-z][a-z]+\b")
UNCHANGED = {"max", "min", "sin", "cos", "tan", "ln", "exp", "rad", "kg", "Hz", "Pa"}
"""Functions of formulas and units, which are the same in every language."""


@dataclass(frozen=True)
class Entry:
    """An English entry. several: that of a plural, "" for none; place: the file or the table that it is from."""

    english: str
    several: str
    place: str


def english_entries() -> Iterator[Entry]:
    """Yield every entry, some of them more than once."""
    for file, _, found, _, _ in extract_from_dir(SOURCES / "reports", [("**.py", "python")], keywords=KEYWORDS):
        one, several = found if isinstance(found, tuple) else (found, "")
        yield Entry(one, several, f"reports/{file}")
    yield from (Entry(text, "", "assess/messages/texts.py") for text in TEXTS.values())
    yield from (Entry(text, "", "reports/language/locale.py") for text in LOCALE_WORDS)
    yield from (Entry(text, "", "fixed terms of results") for text in fixed_terms() if not is_symbolic(text))


def is_symbolic(term: str) -> bool:
    """Return whether a fixed term has no word of a language: a clause number, a formula, a unit, a standard."""
    return not set(WORD.findall(term)) - UNCHANGED


def catalogue_of(language: str) -> Catalog:
    """Return the catalogue of a language as it is."""
    with (FOLDER / f"{language}.po").open("rb") as file:
        return read_po(file, locale=language)


def template() -> Catalog:
    """Return a catalogue with every entry and no translation."""
    made = Catalog(fuzzy=False)
    for entry in sorted(english_entries(), key=lambda each: (each.place, each.english)):
        made.add((entry.english, entry.several) if entry.several else entry.english, locations=[(entry.place, 0)])
    return made


def update(language: str) -> list[str]:
    """Write the catalogue of a language with the entries of today; return those without a translation."""
    path = FOLDER / f"{language}.po"
    known = catalogue_of(language) if path.exists() else Catalog(locale=language, fuzzy=False)
    known.update(template(), no_fuzzy_matching=True)
    known.obsolete.clear()
    _sign(known)
    with path.open("wb") as file:
        write_po(file, known, width=120, sort_by_file=True, include_lineno=False)
    return [str(each.id) for each in known if each.id and not is_translated(each.string)]


def _sign(known: Catalog) -> None:
    """Give the file a head without dates that change by themselves."""
    known.project, known.version, known.header_comment = "rocking-assess", "", HEAD
    known.creation_date = known.revision_date = DATE
    known.last_translator, known.language_team, known.msgid_bugs_address = "", "", ""


def is_translated(translated: object) -> bool:
    """Return whether a translation has all of its forms."""
    return all(translated) if isinstance(translated, tuple | list) else bool(translated)


if __name__ == "__main__":
    lacking = update(sys.argv[1])
    sys.stdout.write("\n".join([*lacking, f"{len(lacking)} entries without a translation", ""]))
