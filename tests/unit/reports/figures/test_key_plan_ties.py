"""The key plan and the view in the browser have each tie once, named, in the colour of what becomes of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from reports.chapters.key_plan import ties_table
from reports.figures.key_plan import TIE_COLOURS, building_of, draw_key_plan, key_plan_caption, model_of_key_plan
from reports.language.locale import Locale
from tests.support.facade import with_ties

ENGLISH = Locale()


def test_the_view_in_space_has_a_named_line_for_each_tie():
    building = building_of(with_ties())
    wires = {wire.name: wire for wire in model_of_key_plan(building).wires if wire.name.startswith("T")}
    assert list(wires) == ["T1", "T2"]
    assert np.allclose(wires["T1"].points, with_ties().ties[0].ends)
    assert wires["T1"].colour == TIE_COLOURS["yields"]


def test_the_picture_explains_the_colour_of_ties():
    building = building_of(with_ties())
    figure = draw_key_plan(building, ENGLISH)
    legend = [text.get_text() for text in figure.legends[0].get_texts()]
    assert "tie, yields at the demand" in legend
    assert "one that holds several mechanisms is one" in ENGLISH.text(key_plan_caption(building))


def test_results_without_ties_have_none_drawn_and_no_table():
    bare = replace(with_ties(), ties=())
    assert building_of(bare).ties == ()
    assert ties_table(bare).rows == ()


def test_a_tie_of_no_mechanism_is_named_by_its_body_and_one_of_two_has_two_rows():
    first, second = with_ties().ties
    shared = replace(first, held=(*first.held, replace(second.held[0], mechanism="gable", outcome="elastic")))
    alone = replace(second, held=(), body="old bar")
    rows = ties_table(replace(with_ties(), ties=(shared, alone))).rows
    assert [ENGLISH.text(row[0]) for row in rows] == ["T1", "T1", "T2"]
    assert [ENGLISH.text(row[1]) for row in rows[:2]] == ["M1", "M2"]
    assert [ENGLISH.text(row[3]) for row in rows] == ["yields", "elastic", "not counted"]
    assert ENGLISH.text(rows[2][2]) == "old bar"
