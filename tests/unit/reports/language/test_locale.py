"""Texts of a document in letters: numbers in either unit system, lists, references, and words that stay as they are."""

from __future__ import annotations

import pytest
from scipy.constants import foot, g, psi

from assess.messages.message import UNITS as MESSAGE_UNITS
from assess.messages.message import Message, Quantity, Severity, note
from reports.language.locale import UNITS, Locale
from reports.language.texts import Date, Listing, Paragraph, Reference, Verbatim, count, quantity, say, say_count
from tests.support.letters import letters

SI, US, ITALIAN = Locale(), Locale("en", "US"), Locale("it")


@pytest.mark.parametrize(
    ("value", "dimension", "si", "us"),
    [
        (6.89e9, "stress", "6.89 GPa", "999.3 ksi"),
        (120.0 * psi, "stress", "827.4 kPa", "120 psi"),
        (0.25, "ground acceleration", "0.25 g", "0.25 g"),
        (0.5 * g, "acceleration", "4.903 m/s²", "0.5 g"),
        (10 * foot, "length", "3.048 m", "10 ft"),
        (237_900.0, "force", "237.9 kN", "53.48 kip"),
        (0.5235987756, "angle", "30°", "30°"),
        (475.0, "return period", "475 years", "475 years"),
    ],
)
def test_quantities_are_converted_from_their_whole_value(value: float, dimension: str, si: str, us: str) -> None:
    assert (letters(quantity(value, dimension), SI), letters(quantity(value, dimension), US)) == (si, us)


def test_every_dimension_of_a_message_has_units() -> None:
    assert set(MESSAGE_UNITS) <= set(UNITS["SI"])
    assert set(UNITS["SI"]) == set(UNITS["US"])


@pytest.mark.parametrize(
    ("day", "italian", "british", "american"),
    [
        ("2026-11-28", "28 novembre 2026", "28 November 2026", "November 28, 2026"),
        ("2026-05-01", "1 maggio 2026", "1 May 2026", "May 1, 2026"),
        ("12 May", "12 May", "12 May", "12 May"),
        ("2026-02-30", "2026-02-30", "2026-02-30", "2026-02-30"),
    ],
)
def test_a_day_is_written_as_the_language_does(day: str, italian: str, british: str, american: str) -> None:
    assert tuple(each.text(Date(day)) for each in (ITALIAN, SI, US)) == (italian, british, american)


def test_texts_of_the_user_stay_letter_for_letter() -> None:
    label = Verbatim("Wall 6 m, {0} 1.5")
    for locale in (SI, US, ITALIAN):
        assert label.text in locale.text(say("Notes: {notes}", notes=label))


def test_a_list_with_commas_of_its_own_is_set_apart_by_semicolons() -> None:
    assert letters(Listing((Verbatim("a"), Verbatim("b"), Verbatim("c"))), SI) == "a, b and c"
    assert letters(Listing((Verbatim("a"), Verbatim("b, the top"), Verbatim("c"))), SI) == "a; b, the top and c"
    assert letters(Listing((Verbatim("a"), Verbatim("b")), "or"), ITALIAN) == "a o b"


def test_things_are_counted_in_the_plural_of_the_language() -> None:
    texts = [letters(say_count("{number} impact", "{number} impacts", number), SI) for number in (0, 1, 2)]
    assert texts == ["0 impacts", "1 impact", "2 impacts"]


def test_a_reference_is_the_number_of_its_block() -> None:
    locale = SI.with_titles({("Figure", "01-wall-view"): 5})
    assert letters(Paragraph((say("See {it}.", it=Reference("Figure", "01-wall-view")),)), locale) == "See Figure 5."


def test_a_message_is_written_anew_from_its_values() -> None:
    told = note("fails-below", "W1", pga=Quantity(0.123456, "ground acceleration"))
    assert "0.1235 g" in letters(told, SI)
    assert "0,1235 g" in letters(told, ITALIAN)


def test_a_message_of_another_version_keeps_its_own_words() -> None:
    from dataclasses import replace

    told = replace(
        note("fails-below", "W1", pga=Quantity(0.1, "ground acceleration")), text="words of an older version"
    )
    assert SI.text(told) == "words of an older version"


def test_whole_numbers_are_written_whole() -> None:
    assert SI.text(count(12345)) == "12345"


def test_a_message_of_a_version_with_other_gaps_keeps_its_english() -> None:
    older = Message("too-few-records", Severity.NOTE, "", "1 records; at least 3", {"number": "1"})
    assert letters(older, ITALIAN) == "1 records; at least 3"
