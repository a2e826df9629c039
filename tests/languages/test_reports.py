"""Reports of the shipped examples in other languages: nothing that they say is left in English."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, is_dataclass
from typing import get_args

import pytest

from assess.results import Results
from reports.assessment import assessment
from reports.chapters.data_tables import tables
from reports.document import Sheet
from reports.language.locale import Locale
from reports.language.texts import Term, Text, Verbatim, listing, say
from reports.render.table_text import sheet_rows
from tests.languages.test_catalogues import OTHERS
from tests.support.examples import example_results
from tools.catalogue import is_symbolic

EXAMPLES = ("casa_grande_table", "chiesa", "nepal_monuments", "san_leonardo_church")


@dataclass(frozen=True)
class Listener(Locale):
    """A locale that keeps the English words which it has no entry for."""

    unknown: set[str] = field(default_factory=set)

    def word(self, english: str) -> str:
        from reports.language.locale import read_catalogue

        known = read_catalogue(self.language)._catalog  # type: ignore[attr-defined]
        if not {english, (english, 0)} & known.keys() and not is_symbolic(english):
            self.unknown.add(english)
        return super().word(english)


def texts_in(data: object) -> Iterator[Text | Sheet]:
    """Every text and calculation sheet within parts of a document."""
    if isinstance(data, (Sheet, *get_args(Text))):
        yield data
        data = data.caption if isinstance(data, Sheet) else None
    if is_dataclass(data):
        data = tuple(getattr(data, each.name) for each in fields(data) if each.name not in {"draw", "model", "locale"})
    if isinstance(data, tuple | list):
        yield from (each for part in data for each in texts_in(part))


def unknown_words(results: Results, language: str) -> set[str]:
    document = assessment(results, detail="full")
    listener = Listener(language, titles=document.numbers)
    for text in texts_in((document, tuple(tables(results)))):
        if isinstance(text, Sheet):
            assert list(sheet_rows(text.steps, listener))
        else:
            listener.text(text)
    return listener.unknown


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("name", EXAMPLES)
def test_every_word_of_a_report_has_an_entry(name: str, language: str) -> None:
    assert unknown_words(example_results(name), language) == set()


def test_words_without_an_entry_are_found() -> None:
    listener = Listener("it")
    listener.text(listing((Term("words of no catalogue"), Term("C8.7.1.2"), say("words of another"))))
    assert listener.unknown == {"words of no catalogue", "words of another"}


def test_a_listing_with_decimal_commas_is_set_apart_by_semicolons() -> None:
    lengths = listing([Verbatim("0 m"), Verbatim("−16,8 m"), Verbatim("6 m")], "")
    assert Locale("it").text(lengths) == "0 m; −16,8 m; 6 m"
    assert Locale("it").text(listing([Verbatim("M1"), Verbatim("M2")], "")) == "M1, M2"
