"""Every sentence that the source can say has an entry in every language, with the same gaps."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from string import Formatter

import pytest

from reports.language.locale import ENGLISH, Locale, decimal_point, languages
from reports.language.texts import quantity, say, say_count
from tests.languages.fixed_terms import fixed_terms
from tools.catalogue import Entry, catalogue_of, english_entries, is_symbolic, is_translated

OTHERS = [language for language in languages() if language != ENGLISH]


@cache
def entries() -> Mapping[str, Entry]:
    return {entry.english: entry for entry in english_entries()}


def gaps(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


@pytest.mark.parametrize("language", OTHERS)
def test_every_english_entry_is_translated(language: str) -> None:
    known = catalogue_of(language)
    lacking = [text for text in entries() if (found := known.get(text)) is None or not is_translated(found.string)]
    assert not lacking, f"{len(lacking)} without a translation, as {lacking[:3]}; run make catalogue"


@pytest.mark.parametrize("language", OTHERS)
def test_translations_have_the_gaps_of_the_english_entry(language: str) -> None:
    for message in catalogue_of(language):
        if not message.id or not message.string:
            continue
        forms = message.string if isinstance(message.string, tuple | list) else (message.string,)
        english = message.id if isinstance(message.id, tuple | list) else (message.id,)
        for form in forms:
            assert gaps(form) in [gaps(text) for text in english], message.id


@pytest.mark.parametrize("language", OTHERS)
def test_catalogues_hold_no_entry_that_nothing_says(language: str) -> None:
    known = [message.id for message in catalogue_of(language) if message.id]
    unused = [each for each in known if (each[0] if isinstance(each, tuple | list) else each) not in entries()]
    assert not unused


@pytest.mark.parametrize("language", OTHERS)
def test_numbers_of_translations_have_the_decimal_sign_of_the_language(language: str) -> None:
    """A number of 0.… or before a unit is none of a clause."""
    number = re.compile(r"(?<![\w.])(0\.\d|\d+\.\d+ (?:m|s|g|Hz|%)(?!\w))")
    assert decimal_point(language) == ","
    for message in catalogue_of(language):
        forms = message.string if isinstance(message.string, tuple | list) else (message.string,)
        assert not [form for form in forms if message.id and number.search(form)]


def test_terms_without_words_hold_no_decimal_numbers() -> None:
    assert not [term for term in fixed_terms() if is_symbolic(term) and re.search(r"(?<![\w.])0\.\d", term)]


def test_entries_are_collected_from_the_source() -> None:
    places = {entry.place for entry in entries().values()}
    assert Entry("Figure", "", "reports/language/locale.py") in entries().values()
    assert {"assess/messages/texts.py", "reports/chapters/annex_sheets.py"} <= places


def test_italian_has_a_decimal_comma_and_plural_forms() -> None:
    italian = Locale("it")
    assert italian.text(quantity(0.25, "ground acceleration")) == "0,25\u00a0g"
    impacts = [italian.text(say_count("{number} impact", "{number} impacts", number)) for number in (1, 2)]
    assert impacts == ["1 urto", "2 urti"]


def test_a_language_does_not_change_texts_of_the_user() -> None:
    from reports.language.texts import Verbatim

    said = say("Notes: {notes}", notes=Verbatim("Wall 6 m, {x} 1.5 and %s"))
    assert "Wall 6 m, {x} 1.5 and %s" in Locale("it", "US").text(said)
