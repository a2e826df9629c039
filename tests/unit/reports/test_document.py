"""Tables made of fields: a row for each part of a thing, which repeats what the thing has."""

from __future__ import annotations

from reports.document import Column, Field, tabulate_parts
from reports.language.texts import Verbatim


def test_parts_stand_beside_what_they_are_of_and_a_thing_without_parts_has_no_row() -> None:
    wholes: tuple[Field[str], ...] = ((Column(Verbatim("word")), Verbatim),)
    parts: tuple[Field[str], ...] = ((Column(Verbatim("code"), "ratio"), ord),)
    table = tabulate_parts(
        "letters", Verbatim(""), (wholes, ("ab", "", "c")), (parts, tuple), muted=lambda letter: letter == "b"
    )
    assert table.columns == (wholes[0][0], parts[0][0])
    assert table.rows == ((Verbatim("ab"), 97), (Verbatim("ab"), 98), (Verbatim("c"), 99))
    assert table.muted == {1}
