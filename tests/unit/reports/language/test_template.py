"""Sentences with gaps, against regular expressions with lazy groups, which mean the same."""

from __future__ import annotations

import re

import pytest
from reports.language.template import template, words

PAIRS = (
    ("{0} fails from PGA {1} g and overturns, according to {2}", "W fails from PGA 3 g and overturns, according to x"),
    ("{0} of {1} mechanisms fail", "4 of 10 mechanisms fail"),
    ("{0} of {1} mechanisms fail", "mechanisms fail"),
    ("{0} and {1}", "A and B and C"),
    ("Notes: {0}", "Notes: "),
    ("Notes: {0}", "Notes: Notes: x"),
    ("a{0}a", "aa"),
    ("a{0}a", "aaa"),
    ("{0}; {1}.", "; ; x."),
)  # fmt: skip


@pytest.mark.parametrize(("one", "text"), PAIRS)
def test_match_is_that_of_a_lazy_regular_expression(one: str, text: str) -> None:
    made = template(one, one)
    found = re.fullmatch("(.+?)".join(re.escape(piece) for piece in made.fixed), text, re.DOTALL)
    assert made.match(text) == (None if found is None else dict(enumerate(found.groups())))


def test_gaps_may_change_places() -> None:
    made = template("{0} of {1} checks", "su {1} verifiche {0}")
    found = made.match("3 of 8 checks")
    assert found is not None
    assert made.fill(found) == "su 8 verifiche 3"


def test_every_way_to_divide_a_list() -> None:
    ways = [(found[0], found[1]) for found in template("{0} and {1}", "{0} e {1}").matches("a and b and c")]
    assert ways == [("a", "b and c"), ("a and b", "c")]


def test_what_fills_a_gap_is_no_template() -> None:
    assert template("Notes: {0}", "Note: {0}").fill({0: "{0} {1}"}) == "Note: {0} {1}"


@pytest.mark.parametrize(
    ("one", "other"), [("{0} of {1}", "{0}"), ("{0}", "{0} {1}"), ("{0}{1}", "{0}{1}"), ("{0} {0}", "{0}")]
)
def test_gaps_that_differ_or_touch_are_refused(one: str, other: str) -> None:
    with pytest.raises(ValueError, match="gap"):
        template(one, other)


def test_words_leave_out_symbols_and_indices() -> None:
    assert words("θ_lim = k g/(p² R0), φₒᵥ in kg m² of Wall-6") == ("lim", "in", "kg", "of", "Wall")


def test_a_long_hostile_text_is_no_match() -> None:
    made = template("{0} of {1} of {2} of {3} of {4} of {5} checks.", "{0}{1}{2}{3}{4}{5}")
    assert made.match(" of" * 30_000) is None
