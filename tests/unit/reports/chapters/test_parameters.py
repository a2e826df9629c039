"""Parameters and forces at the hinges, against the results."""

from __future__ import annotations

from dataclasses import replace

from assess.results import LoadResult, Results
from reports.chapters import parameters


def test_parameters_show_both_branches(results: Results) -> None:
    two, one = (parameters.parameters(mechanism, name="p") for mechanism in results.mechanisms)
    assert all(row[2] == row[3] for row in two.rows)
    assert all(row[3] is None for row in one.rows)
    assert "one side only" in one.caption


def test_forces_at_the_hinges_say_what_friction_holds(results: Results) -> None:
    table = parameters.hinge_forces(results.mechanisms[0], name="f")
    headings = [column.heading for column in table.columns]
    needed, friction, slides, remark = (headings.index(name) for name in (
        "Friction needed [-]", "Friction [-]", "Slides from [g]", "Remark"))  # fmt: skip
    assert [(row[needed], row[friction], row[slides], row[remark]) for row in table.rows] == [
        (0.862, 0.6, 0.278, ""),
        (0.124, 0.6, "rocks first", "faces taken level"),
        ("lifts", 0.6, 0.0, ""),
        (1.3, "not given", None, "held at the top, by friction or an anchorage"),
    ]
    assert not parameters.hinge_forces(results.mechanisms[1], name="f").rows


def test_a_load_in_the_middle_stands_at_zero_whatever_its_rounding(results: Results) -> None:
    load = LoadResult("floor", "mass", 0, (6e-17, -6e-17), 4000.0, True, None, "given")
    (row,) = parameters.loads(replace(results.mechanisms[0], loads=(load,)), name="l").rows
    assert row[1:3] == (0.0, 0.0)
    assert not any(str(cell).startswith("-") for cell in row[1:3])
