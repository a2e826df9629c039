"""The declaration names analysis, program and controls with their numbers, and leaves room for the judgement."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.messages.message import Message, Severity
from assess.results import Control, Input, Program, ReportMatter, Results
from reports.chapters import declaration
from reports.document import OutcomeCell, Signatures, WritingBox
from tests.support.letters import letters, lines, rows, text_of
from tests.support.sample_results import with_verdict

NOTE = Message("n", Severity.NOTE, "", "by moments about the hinges")
MULTIPLIER = Control("hand-multiplier", "wall-6", "uplift multiplier", 0.14, 0.14, "ratio", 0.0, 1e-6, True, NOTE)
ENERGY = Control("energy", "wall-6", "energy balance", 10.0, 10.5, "energy", 0.05, 1e-3, False, NOTE)
NOT_MADE = Control("convergence", "parapet", "rotation", None, None, "rotation", None, 0.01, None, NOTE)


@pytest.mark.parametrize(
    ("made", "said"),
    [
        ((MULTIPLIER,), "The one automatic control that could be made is met."),
        ((MULTIPLIER, MULTIPLIER, NOT_MADE), "All 2 automatic controls made are met."),
        ((NOT_MADE,), "No automatic control could be made."),
        ((MULTIPLIER, ENERGY), "1 automatic control of 2 is not met"),
        ((ENERGY, ENERGY, MULTIPLIER), "2 automatic controls of 3 are not met"),
    ],
)
def test_controls_are_counted(made: tuple[Control, ...], said: str) -> None:
    assert letters(declaration.controls_summary(made)).startswith(said)


def test_a_control_shows_both_numbers_and_its_outcome(results: Results) -> None:
    table = declaration.controls_table(replace(results, controls=(MULTIPLIER, ENERGY, NOT_MADE)))
    wall = table.rows[0]
    assert [cell.outcome for cell in wall if isinstance(cell, OutcomeCell)] == ["fail", "pass"]
    assert (wall[3], wall[4]) == (0.14, 0.14)
    assert rows(table)[1][1:] == ["–"] * 6
    assert letters(table.columns[2].label) == "Energy balance, at most 0.001"


def test_the_worst_of_several_controls_is_shown(results: Results) -> None:
    small = replace(ENERGY, kind="equilibrium", difference=1e-9, met=True, tolerance=1e-6)
    large = replace(small, difference=1e-3, met=False)
    assert rows(declaration.controls_table(replace(results, controls=(large, small))))[0][1] == "0.001"


def test_what_is_not_met_or_not_made_has_its_note(results: Results) -> None:
    said = lines(declaration.sections(replace(results, controls=(MULTIPLIER, ENERGY, NOT_MADE))))
    assert "Energy balance, M1: by moments about the hinges" in said
    assert "Convergence, M2: by moments about the hinges" in said
    assert not any(line.startswith("Multiplier by hand, M1") for line in said)


def test_results_without_controls_say_so(results: Results) -> None:
    assert "These results hold no automatic controls." in lines(declaration.sections(replace(results, controls=())))


def test_every_control_is_in_the_data(results: Results) -> None:
    assert len(declaration.controls_in_full(replace(results, controls=(MULTIPLIER, ENERGY, NOT_MADE))).rows) == 3


def test_the_program_and_the_inputs_can_be_identified(results: Results) -> None:
    made = replace(results, program=Program("assess", "1.0", "MIT", "us", "ab" * 32), stamp="2e39")
    said = lines(declaration.sections(made))
    assert {"Version: 1.0", "Licence: MIT", "SHA-256 of the program: " + "ab" * 32, "Stamp of the results: 2e39"} <= {
        *said
    }
    assert any(line.endswith("(of the hashes of 2 files)") for line in said)
    changed = replace(made, inputs=(made.inputs[0], Input("wall.stl", "b8" * 32)))
    assert letters(declaration.inputs_text(changed)) != letters(declaration.inputs_text(made))
    single = replace(made, inputs=made.inputs[:1])
    assert letters(declaration.inputs_text(single)) == "3f" * 32 + " (1 file)"


def test_the_kind_of_analysis_is_that_of_the_methods_that_decide(results: Results) -> None:
    said = text_of(declaration.sections(results)[:1])
    assert "ASCE 43-05, approximate method: static and non-linear, by an equivalent oscillator" in said
    assert "DMI 2008" not in said


def test_large_rotations_are_claimed_only_of_methods_that_follow_them(results: Results) -> None:
    assert "with large rotations" in text_of(declaration.sections(results)[:1])
    linear = tuple(
        replace(each, checks=tuple(replace(check, procedure="ec8-element") for check in each.checks))
        for each in results.mechanisms
    )
    said = text_of(declaration.sections(replace(results, mechanisms=linear))[:1])
    assert "do not follow them through large rotations" in said


def test_the_clause_is_named_where_an_italian_code_decides(results: Results) -> None:
    italian = with_verdict(results, basis="ntc2018")
    assert letters(declaration.chapter_title(italian)) == "Calculation by computer (NTC 2018, 10.2)"
    assert "NTC" not in letters(declaration.chapter_title(results))


def test_there_is_room_for_the_judgement(results: Results) -> None:
    boxes = [
        block for section in declaration.sections(results) for block in section.blocks if isinstance(block, WritingBox)
    ]
    assert len(boxes) == 1


def test_whoever_is_named_has_a_place_to_sign(results: Results) -> None:
    matter = ReportMatter(author="A. Author", engineer="E. Engineer", office="Co.", licence_number="1", client="T")
    (section,) = declaration.signature_sections(replace(results, report=matter))
    assert {"Office: Co.", "Licence number: 1"} <= {*lines([section])}
    places = next(block for block in section.blocks if isinstance(block, Signatures)).places
    assert [(letters(role), letters(name)) for role, name in places] == [
        ("Author", "A. Author"),
        ("Engineer", "E. Engineer"),
        ("Checked by", ""),
        ("Received for the client", "T"),
    ]


def test_nobody_named_leaves_lines_to_sign(results: Results) -> None:
    (section,) = declaration.signature_sections(replace(results, project={}, report=ReportMatter()))
    places = next(block for block in section.blocks if isinstance(block, Signatures)).places
    assert [letters(name) for _, name in places] == ["", ""]
