"""Page 2 has the key plan, and after it the revisions and photographs that are given."""

from __future__ import annotations

from dataclasses import replace

from assess.results import Picture, ReportMatter, Results, Revision
from reports.chapters import key_plan
from reports.document import Figure, Photograph
from reports.figures.key_plan import building_of
from tests.support.letters import letters, lines


def test_the_plan_is_drawn_where_there_is_geometry(results: Results) -> None:
    sections = key_plan.sections(results, building_of(results))
    figure = sections[0].blocks[0]
    assert isinstance(figure, Figure)
    assert figure.name == "key-plan"
    assert figure.model is not None
    assert "Given by parameters, without geometry, and not drawn: M2." in lines(sections)
    assert [letters(section.title) for section in sections] == ["Key plan and list of mechanisms"]


def test_revisions_and_photographs_are_all_there(results: Results) -> None:
    revisions = tuple(Revision(str(number), "", f"issue {number}", "") for number in range(3))
    pictures = tuple(Picture("a.jpg", f"north, {n}", "image/jpeg", 4, 3, "aa") for n in range(2))
    made = key_plan.sections(replace(results, report=ReportMatter(revisions=revisions, figures=pictures)), None)
    assert sum("| issue " in line for line in lines(made)) == 3
    photographs = [block for section in made for block in section.blocks if isinstance(block, Photograph)]
    assert len({each.name for each in photographs}) == 2
    assert [letters(each.caption) for each in photographs] == ["north, 0", "north, 1"]
