"""Parameters and forces at the hinges, against the results."""

from __future__ import annotations

from assess.results import Results
from reports import parameters


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
