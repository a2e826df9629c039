"""Sensitivities in the report: which inputs stand first over all mechanisms, what is said, the tornado."""

from __future__ import annotations

from dataclasses import replace
from math import inf
from typing import Any

import pytest

from assess.codes.check import Outcome
from assess.results import Results, SensitivityResult
from reports.chapters import sensitivity
from reports.chapters.sensitivity import rank_inputs
from reports.document import Figure, Section
from reports.language.locale import Locale
from tests.support.letters import lines_of, prose, table_of

EN = Locale()

UNITS = {"density": ("materials.caliche.density", "kg/m^3", 2240.0), "thickness": ("thickness of wall", "m", 0.6)}
LEVELS = (0.1, 0.2)


def rows(parameter: str, low: float, high: float, *, mechanism: str = "wall-6", base: float = 0.18) -> list[Any]:
    """A number that takes the PGA at capacity [g] from `base` to `low` and `high`; the ratio is level over that."""
    key, unit, value = UNITS.get(parameter, (f"mechanisms.{mechanism}.{parameter}", "-", 0.9))
    common = {"mechanism": mechanism, "parameter": parameter, "key": key, "unit": unit, "remark": ""}
    common |= {"base": value, "low": 0.95 * value, "high": 1.05 * value, "procedure": "dmi2008-linear"}
    made = [SensitivityResult(**common, quantity="capacity_pga_g", at_base=base, at_low=low, at_high=high)]  # type: ignore[arg-type]
    for level in LEVELS:
        verdicts = [Outcome.FAIL if level > at else Outcome.PASS for at in (base, low, high)]
        ratios = dict(zip(("at_base", "at_low", "at_high"), (level / at for at in (base, low, high)), strict=True))
        turned = dict(zip(("verdict_base", "verdict_low", "verdict_high"), verdicts, strict=True))
        made.append(SensitivityResult(**common, quantity="demand_capacity", level_pga_g=level, **ratios, **turned))  # type: ignore[arg-type]
    return made


def history(parameter: str, at_high: float | None) -> SensitivityResult:
    """The ratio of the histories at 0.2 g, None where the body overturns at the high value of the number."""
    row = rows(parameter, 0.18, 0.18)[-1]
    return replace(
        row,
        procedure="asce43-05-history",
        at_base=0.5,
        at_low=0.5,
        at_high=at_high,
        verdict_base=Outcome.PASS,
        verdict_low=Outcome.PASS,
        verdict_high=Outcome.FAIL if at_high is None else Outcome.PASS,
    )


@pytest.fixture
def found() -> tuple[SensitivityResult, ...]:
    still = [*rows("density", 0.18, 0.18 + 1e-15), history("density", 0.5)]
    loses = [*rows("restitution", 0.18, 0.18), history("restitution", None)]
    return (*still, *loses, *rows("thickness", 0.17, 0.205), history("thickness", 0.45))


def chapter(results: Results, found: tuple[SensitivityResult, ...]) -> Section:
    (section,) = sensitivity.sections(replace(results, sensitivity=found))
    return section


def test_what_moves_the_answer_most_stands_first(found: tuple[SensitivityResult, ...]) -> None:
    ordered = rank_inputs(found)
    assert [each.number.parameter for each in ordered] == ["thickness", "restitution", "density"]
    shown = [(row.quantity, row.procedure, row.level_pga_g) for row in ordered[0].shown]
    assert shown == [
        ("capacity_pga_g", "dmi2008-linear", None),
        ("demand_capacity", "dmi2008-linear", 0.2),  # the level nearest to 0.18 g
        ("demand_capacity", "asce43-05-history", 0.2),
    ]


def test_the_chapter_says_what_to_survey_first(results: Results, found: tuple[SensitivityResult, ...]) -> None:
    said = prose(chapter(results, found))
    assert "Survey first: thickness" in said
    assert "The outcome changes within the ranges of thickness (M1) and restitution (M1)." in said
    still = tuple(row for row in found if row.parameter == "density")
    said = prose(chapter(results, still))
    assert "None of the values moves an answer within its range." in said


def test_an_input_has_one_row_in_the_mechanism_that_it_moves_most(
    results: Results, found: tuple[SensitivityResult, ...]
) -> None:
    other = tuple(rows("thickness", 0.10, 0.35, mechanism="parapet"))
    table = table_of([chapter(results, (*found, *other))], "influences")
    cells = [lines_of(row).split("\n") for row in table.rows]  # type: ignore[arg-type]  all are texts
    assert [row[0] for row in cells].count("thickness") == 1
    first = cells[0]
    assert first[:7] == ["thickness", "0.57 m to 0.63 m", "M2 parapet", "PGA at capacity", "0.1 g", "0.18 g", "0.35 g"]
    assert first[7] == "passes"
    assert "unchanged" in cells[-1]


def test_the_most_critical_mechanisms_are_drawn_and_the_others_go_to_the_annex(
    results: Results, found: tuple[SensitivityResult, ...]
) -> None:
    many = [row for place in range(7) for row in rows(f"p{place}", 0.1, 0.2, mechanism="parapet")]
    asked = replace(results, sensitivity=(*found, *many))
    assert [len(names) for names in drawn(asked)] == [2, 0]  # of three and of seven bars
    more = replace(asked, sensitivity=(*asked.sensitivity, *rows("loads", 0.1, 0.2, mechanism="parapet")))
    first, rest = drawn(more)
    assert first != rest
    assert sorted([*first, *rest]) == ["01-wall-6-sensitivity", "02-parapet-sensitivity"]


def drawn(results: Results) -> list[list[str]]:
    """The names of the figures of the chapter, and of those in the annex."""
    return [
        [block.name for section in made for block in section.blocks if isinstance(block, Figure)]
        for made in (sensitivity.sections(results), sensitivity.annex_sections(results))
    ]


def test_a_tornado_begins_at_the_answer_as_assessed(found: tuple[SensitivityResult, ...]) -> None:
    capacity, ratio, shaken = sensitivity.panels(rank_inputs(found))
    assert (capacity.base, capacity.limit and capacity.limit[0]) == (0.18, 0.2)
    assert [(bar.low, bar.high) for bar in capacity.bars[:2]] == [(0.17, 0.205), (0.18, 0.18)]
    assert ratio.limit is not None
    assert ratio.limit[0] == 1.0
    assert [lines_of(text for text in bar.verdicts if text is not None) for bar in ratio.bars] == ["pass", "", ""]
    assert shaken.bars[1].high == inf
    assert lines_of(capacity.bars[2].lines) == "density of caliche\n2128 kg/m³ to 2352 kg/m³"


def test_names_tell_entries_and_joints() -> None:
    row = replace(rows("p", 0.1, 0.2)[0], parameter="loads", key="mechanisms.wall-6.loads[2].force[1]")
    assert lines_of([sensitivity.input_name(row)]) == "load 2"
    joint = replace(row, parameter="stiffness", key="mechanisms.wall-6.interfaces.B.stiffness")
    assert lines_of([sensitivity.input_name(joint)]) == "stiffness, joint B"


def test_what_is_not_varied_is_told_even_where_nothing_is(results: Results) -> None:
    assert sensitivity.sections(results) == []
    silent = SensitivityResult("parapet", "thickness", "not varied: its body has no geometry")
    assert prose(chapter(results, (silent,))) == "M2, thickness: not varied: its body has no geometry."


def test_where_no_answer_is_known_the_chapter_is_still_made(
    results: Results, found: tuple[SensitivityResult, ...]
) -> None:
    silent: dict[str, Any] = {"verdict_base": Outcome.NOT_ANSWERED, "verdict_low": None, "verdict_high": None}
    unknown = tuple(replace(row, at_base=None, at_low=None, at_high=None, **silent) for row in found)
    assert "not known" in [
        lines_of([cell]) for cell in table_of([chapter(results, unknown)], "influences").rows[0][4:7]
    ]  # type: ignore[list-item]


def test_what_decides_stands_before_what_is_for_comparison() -> None:
    """The index of the deciding procedure and its PGA at capacity; the verdict changes by its rows alone."""
    made = []
    for row in rows("thickness", 0.17, 0.205):
        made += [row, replace(row, procedure="asce43-05-spectrum", role="deciding")]
    index = replace(made[-1], quantity="index", index="D/C", verdict_base=Outcome.PASS, verdict_low=Outcome.PASS)
    (found,) = rank_inputs([*made, index])
    shown = [(row.quantity, row.procedure) for row in found.shown]
    assert shown == [("index", "asce43-05-spectrum"), ("capacity_pga_g", "asce43-05-spectrum")]
    assert {row.procedure for row in found.decisive} == {"asce43-05-spectrum"}
    assert EN.text(sensitivity.answer_name(index)) == "index D/C"


def test_damage_does_not_stand_for_collapse() -> None:
    damage = [replace(row, limit_state="SLD") for row in rows("thickness", 0.08, 0.1, base=0.09)]
    life = [replace(row, limit_state="SLV") for row in rows("thickness", 0.17, 0.205)]
    assert {row.limit_state for row in rank_inputs([*damage, *life])[0].shown} == {"SLV"}
    assert {row.limit_state for row in rank_inputs(damage)[0].shown} == {"SLD"}


def test_a_capacity_without_ratios_is_told_and_one_that_is_not_known_is_left_out(results: Results) -> None:
    alone = tuple(row for row in rows("density", 0.1, 0.2) if row.quantity == "capacity_pga_g")
    unknown = tuple(replace(row, at_base=None, at_low=None, at_high=None) for row in alone)
    assert chapter(results, alone).blocks
    assert sensitivity.sections(replace(results, sensitivity=unknown)) == []
