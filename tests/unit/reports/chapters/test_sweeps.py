"""Parametric studies and the weakest direction in the report."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assess.results import Results
from reports.assessment import assessment
from reports.chapters import sweeps
from reports.document import Figure, Text
from reports.figures import directions, sweep


def test_the_controlling_case_is_marked_and_overturning_said(results: Results) -> None:
    table = sweeps.table(results.sweeps[0], name="s")
    assert [row[-1] for row in table.rows] == ["controls", "", ""]
    assert [row[5] for row in table.rows] == ["overturned", 1.31, 0.87]
    assert table.columns[0].heading == "Value [-]"
    assert "mechanisms.parapet.uplift" in table.caption


def test_the_report_says_what_stands_for_the_mechanism(results: Results) -> None:
    assert "0.09 controls. This case represents" in sweeps.sentence(results.sweeps[0])
    other = replace(results.sweeps[0], governs=False, unit="deg")
    assert "0.09 deg controls. In the rest of this report" in sweeps.sentence(other)
    assert sweeps.controlling_cases([other], {"parapet": "Parapet"}) == []
    (text,) = sweeps.controlling_cases(results.sweeps, {"parapet": "Parapet"})
    assert isinstance(text, Text)
    assert "Parapet, mechanisms.parapet.uplift = 0.09" in text.paragraphs[0]


def test_each_mechanism_shows_its_own_studies(results: Results) -> None:
    names = [figure.name for figure in assessment(results).figures]
    assert "02-parapet-sweep-01" in names
    assert "01-wall-6-directions" in names
    assert not any(name.startswith(("01-wall-6-sweep", "02-parapet-directions")) for name in names)
    plain = replace(results, sweeps=(), mechanisms=tuple(replace(m, direction_sweep=None) for m in results.mechanisms))
    titles = {section.title for section in assessment(plain).sections}
    assert "Parametric studies" not in titles


def test_the_figure_shows_the_values_in_their_order(results: Results) -> None:
    shuffled = replace(
        results.sweeps[0], value=(0.17, 0.09, 0.13), demand_capacity=(0.87, 1.4, 1.31), overturned=(False,) * 3
    )
    figure = sweep.draw(shuffled)
    assert [len(axes.lines) for axes in figure.axes] == [2, 2, 3]
    np.testing.assert_array_equal(figure.axes[2].lines[0].get_xdata(), [0.09, 0.13, 0.17])
    np.testing.assert_array_equal(figure.axes[2].lines[0].get_ydata(), [1.4, 1.31, 0.87])
    silent = sweep.draw(replace(shuffled, demand_capacity=(None,) * 3, uplift_multiplier=(None,) * 3))
    assert [axes.get_ylabel() for axes in silent.axes] == ["frequency parameter p [1/s]"]


def test_joints_add_columns_and_take_the_place_of_an_unknown_threshold(results: Results) -> None:
    rigid = results.sweeps[0]
    on_joints = replace(
        rigid,
        uplift_multiplier=(None,) * 3,
        overturning_flexible_rad=(None, 0.11, 0.12),
        elastic_frequency_hz=(None, 2.0, 3.0),
    )
    figure = sweep.draw(on_joints)
    assert [len(axes.lines[0].get_xdata()) for axes in figure.axes] == [2, 3, 2]  # no panel without a value
    assert "overturning on joints" in figure.axes[0].get_ylabel()
    table = sweeps.table(on_joints, name="s")
    headings = [column.heading for column in table.columns]
    places = [headings.index(heading) for heading in ("φₒᵥ on joints [rad]", "Elastic frequency [Hz]")]
    assert [[row[place] for row in table.rows] for place in places] == [[None, 0.11, 0.12], [None, 2.0, 3.0]]
    assert {len(row) for row in table.rows} == {len(headings)}
    assert len(sweeps.table(rigid, name="s").columns) == len(headings) - 2
    assert "rigid joints" in table.caption
    assert "rigid joints" not in sweeps.table(rigid, name="s").caption


def test_the_weakest_direction_is_drawn_and_said(results: Results) -> None:
    found = results.mechanisms[0].direction_sweep
    assert found is not None
    turned = replace(found, weakest_deg=62.299999999999)
    assert "62.3° from +x" in sweeps.direction_sentence(turned)
    (ray, dot) = directions.draw(turned).axes[0].lines[1:]
    np.testing.assert_allclose(ray.get_xdata(), np.radians([62.3, 62.3]), rtol=1e-9)
    np.testing.assert_allclose(dot.get_ydata(), [min(found.uplift_multiplier)], rtol=1e-15)


def test_a_key_is_only_text(results: Results) -> None:
    key = "mechanisms.<b>$x$ \\frac{1}{2} & %.cut" + "x" * 400
    hostile = replace(results.sweeps[0], key=key)
    assert len(sweeps.sentence(hostile)) < 300
    blocks = sweeps.studies([hostile], name="n").blocks
    figures = [block for block in blocks if isinstance(block, Figure)]
    assert figures[0].draw().axes
