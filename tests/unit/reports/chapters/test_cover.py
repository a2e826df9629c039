"""Page 1 tells what the verdict of the results says, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from assess.codes.verdict import Decision, Index, Missing
from assess.messages.message import Message, Severity
from assess.results import Results
from reports.chapters import cover, mechanism_verdicts
from reports.document import Banner, Code, Items, Section, Table, Text

JudgedAt = Callable[[Results, float], Results]
WEAK = Missing("materials.old stone.disintegration", "whether it may disintegrate", 'disintegration = "excluded"')


def words(section: Section) -> str:
    texts = (block.paragraphs for block in section.blocks if isinstance(block, Text))
    points = (block.points for block in section.blocks if isinstance(block, Items))
    return "\n".join(text for each in (*texts, *points) for text in each)


def asked(section: Section) -> dict[object, object]:
    table = next(block for block in section.blocks if isinstance(block, Table) and block.name == "verdict-asked")
    return dict(table.rows)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("pga_g", "outcome", "said"),
    [
        (0.067, Decision.PASS, "All 2 mechanisms hold at the site’s own action, PGA 0.067 g."),
        (0.45, Decision.FAIL, "1 of 2 mechanisms fails at the site’s own action, PGA 0.45 g."),
    ],
)
def test_the_banner_is_the_verdict_at_the_sites_own_action(
    results: Results, judged_at: JudgedAt, pga_g: float, outcome: Decision, said: str
) -> None:
    """At 0.45 g linear analysis fails both; it is no method of the basis and decides nothing."""
    found = judged_at(results, pga_g)
    assert cover.section(found).blocks[0] == Banner(outcome.value, said, near=False)


def test_what_lies_at_the_limit_says_so(results: Results) -> None:
    assert results.verdict is not None
    near = replace(results, verdict=replace(results.verdict, at_the_limit=True))
    banner = cover.section(near).blocks[0]
    assert isinstance(banner, Banner)
    assert banner.word == "PASS AT THE LIMIT"


def test_the_question_stands_beside_the_answer(results: Results) -> None:
    assert asked(cover.section(results)) == {
        "Basis": "asce43-05: ASCE/SEI 43-05",
        "Limit state": "DBE",
        "Site’s own action": "PGA 0.067 g, stated for DBE",
        "Methods that may decide": "asce43-05-history, asce43-05-spectrum",
        "Target of the index": "1",
        "Index of the building": "at least D/C 0",
    }
    assert results.verdict is not None
    share = replace(results.verdict, index=Index("%NBS", 45.0, "C"), target=67.0)
    found = asked(cover.section(replace(results, verdict=share)))
    assert (found["Index of the building"], found["Target of the index"]) == ("at most 45.0 %NBS, grade C", "67")


def test_an_incomplete_verdict_gives_the_lines_to_paste(results: Results) -> None:
    assert results.verdict is not None
    open_ended = replace(
        results.verdict, outcome=Decision.INCOMPLETE, missing=(WEAK,), provisional=Decision.FAIL, at_the_limit=True
    )
    section = cover.section(replace(results, verdict=open_ended))
    (code,) = (block for block in section.blocks if isinstance(block, Code))
    assert code.lines == ('[materials."old stone"]', 'disintegration = "excluded"')
    assert "With all of these given, at the safe value where there is one, the verdict would be: fail." in words(
        section
    )
    assert "materials.old stone.disintegration: whether it may disintegrate." in words(section)
    banner = section.blocks[0]
    assert isinstance(banner, Banner)
    assert (banner.word, banner.near) == ("INCOMPLETE", False)


def test_conditions_and_warnings_that_bear_stand_on_page_1(results: Results) -> None:
    assert results.verdict is not None
    anchored = Message("premise-anchorage", Severity.WARNING, "", "a pass holds where the wall is anchored")
    note = Message("mesh", Severity.NOTE, "bodies.wall", "one hole filled")
    found = replace(
        results,
        verdict=replace(results.verdict, conditions=(anchored,)),
        warnings=(*results.warnings, note),
    )
    said = words(cover.section(found))
    assert "a pass holds where the wall is anchored" in said
    assert results.warnings[0].text in said
    assert note.text not in said


def test_each_mechanism_has_the_answer_that_decides(results: Results, judged_at: JudgedAt) -> None:
    found = judged_at(results, 0.45)
    table = mechanism_verdicts.table(found)
    heads = [column.label for column in table.columns]
    rows = {row[0]: dict(zip(heads, row, strict=True)) for row in table.rows}
    assert rows["parapet"]["Verdict"] == "fail"
    assert rows["parapet"]["Decided by"] == "asce43-05-history"
    assert rows["parapet"]["Why"] == "overturns: no rotation balances this demand"
    wall = rows["Wall 6, eroded base"]
    assert (wall["Verdict"], wall["Decided by"], wall["Index"]) == ("pass", "asce43-05-spectrum", "D/C 0.840")
    assert "Answer" not in wall
    margin = found.verdict.mechanisms[0].margin  # type: ignore[union-attr]
    assert margin is not None
    assert wall["Holds up to"] == f"{margin * 0.45:#.3g} g = {margin:#.3g} x the site's"


def test_a_run_without_a_basis_says_so_and_how_to_name_one(results: Results) -> None:
    from assess.codes.verdict import Action, MechanismChecks, Question, verdict

    silent = verdict(
        Question(None, Action(0.067, None)), [MechanismChecks(m.name, m.checks) for m in results.mechanisms]
    )
    section = cover.section(replace(results, verdict=silent))
    banner = section.blocks[0]
    assert isinstance(banner, Banner)
    assert banner.headline.startswith("No deciding basis is named")
    (code,) = (block for block in section.blocks if isinstance(block, Code))
    assert code.lines[0] == "[verdict]"
    assert cover.section(replace(results, verdict=None)).blocks == (Text(("No verdict: nothing was assessed.",)),)
