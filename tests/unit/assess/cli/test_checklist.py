"""`assess check` prints what becomes of each possible mechanism."""

from __future__ import annotations

from assess.cli.tables.project import checklist_lines
from assess.examples import source
from assess.project.project_file import load
from assess.project.sections import Content

SPIRE = {"spire\n": {"kind": "equivalent-block", "p": 1.6, "uplift": 0.14, "radius": 2.8, "examines": 27}}


def test_each_item_stands_in_one_line_with_what_examines_it():
    report = {"building_type": "church", "absent": ["porch", "dome"], "not_examined": {"apse": "no access"}}
    lines = checklist_lines(Content.model_validate({"mechanisms": SPIRE, "report": report}))
    assert lines[:4] == [
        "possible mechanisms of a church",
        r"  examined      bell-tower by spire\n",
        "  absent        porch, dome",
        "  not examined  apse",
    ]
    assert lines[4].startswith("  not named     facade, facade-top, ")
    assert all(len(line) <= 100 for line in lines)
    named = " ".join(line.strip() for line in lines[4:]).removeprefix("not named").strip().split(", ")
    assert len(named) == 28 - 4
    assert named[-1] == "bell-cell"


def test_without_a_type_of_building_nothing_is_printed():
    assert checklist_lines(load(source("single_wall")).content) == []
