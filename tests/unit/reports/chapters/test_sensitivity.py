"""Sensitivities in the report: which numbers stand first, what is said of the verdict, the tornado and its table."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure as Drawn
from reports.chapters.sensitivity_ranking import rank_inputs
from reports.language.measures import in_units, render_measures

from assess.codes.check import Outcome
from assess.results import Results, SensitivityResult
from reports.assessment import assessment
from reports.chapters import sensitivity
from reports.document import Document, Figure, Table, Text
from reports.figures import tornado

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


def chapter(results: Results, found: tuple[SensitivityResult, ...]) -> tuple[Any, ...]:
    (section,) = sensitivity.chapter(replace(results, sensitivity=found), "wall-6", called="Wall 6", name="n")
    made = in_units(Document("", "", "", "", "A4", (), (section,), ()), "SI")
    return made.blocks


def test_what_moves_the_answer_most_stands_first(found: tuple[SensitivityResult, ...]) -> None:
    ordered = rank_inputs(found)
    assert [each.number.parameter for each in ordered] == ["thickness", "restitution", "density"]
    shown = [(row.quantity, row.procedure, row.level_pga_g) for row in ordered[0].shown]
    assert shown == [
        ("capacity_pga_g", "dmi2008-linear", None),
        ("demand_capacity", "dmi2008-linear", 0.2),  # the level nearest to 0.18 g
        ("demand_capacity", "asce43-05-history", 0.2),
    ]


def test_the_sentences_say_what_turns_and_what_does_not(results: Results, found: tuple[SensitivityResult, ...]) -> None:
    said = "\n".join(chapter(results, found)[0].paragraphs)
    assert "The verdict of Wall 6 changes with thickness at 0.63 m (pass)." in said
    assert "dmi2008-linear at 0.200 g with thickness at 0.63 m (FAIL → pass)" in said
    assert "asce43-05-history at 0.200 g with restitution at 0.945 (pass → FAIL)" in said
    assert (
        "The thickness affects the PGA at capacity (dmi2008-linear) most: 0.170 g at 0.57 m and 0.205 g at 0.63 m"
        in said
    )
    assert "it hardly changes with restitution, density of caliche" in said
    assert "overturned at 0.945, against 0.500 as assessed" in said
    still = tuple(row for row in found if row.parameter == "density")
    said = "\n".join(chapter(results, still)[0].paragraphs)
    assert "The verdict of Wall 6 does not change within these ranges: some check fails throughout." in said
    assert "None of them affects the PGA at capacity (dmi2008-linear), which is 0.180 g." in said


def test_the_table_holds_the_numbers_as_they_stand(results: Results, found: tuple[SensitivityResult, ...]) -> None:
    table = next(block for block in chapter(results, found) if isinstance(block, Table))
    shown = [row for each in rank_inputs(found) for row in each.shown]
    for row, cells in zip(shown, table.rows, strict=True):
        assert cells[2:4] == (row.low, row.high)
        ends = zip(cells[5:8], (row.at_low, row.at_base, row.at_high), strict=True)
        assert all(cell == value or (cell, value) == ("overturned", None) for cell, value in ends)
    (whole,) = sensitivity.data(replace(results, sensitivity=found))
    assert len(whole.rows) == len(found)
    assert whole.rows[0][:8] == (
        "wall-6",
        "density",
        "materials.caliche.density",
        "kg/m^3",
        2240.0,
        2128.0,
        2352.0,
        "dmi2008-linear",
    )
    assert {len(row) for row in whole.rows} == {len(whole.columns)}


def drawn(results: Results, found: tuple[SensitivityResult, ...]) -> Drawn:
    return next(block for block in chapter(results, found) if isinstance(block, Figure)).draw()


def test_bars_begin_at_the_answer_as_assessed(results: Results, found: tuple[SensitivityResult, ...]) -> None:
    capacity, ratio, shaken = drawn(results, found).axes
    bars = [(bar.get_x(), bar.get_x() + bar.get_width()) for bar in capacity.patches][:2]
    np.testing.assert_allclose(np.sort(bars), [(0.17, 0.18), (0.18, 0.205)], rtol=1e-12)
    limits = [line.get_xdata()[0] for line in (capacity.lines[1], ratio.lines[1])]  # type: ignore[index]
    assert limits == [0.2, 1.0]
    names = [label.get_text() for label in capacity.get_yticklabels()]
    assert names == [
        "thickness\n0.57 to 0.63 m",
        "restitution\n0.855 to 0.945",
        "density of caliche\n2128 to 2352 kg/m³",
    ]
    assert [text.get_text() for text in ratio.texts if text.get_text()] == ["pass", "limit"]
    assert [text.get_text() for text in shaken.texts if text.get_text()] == ["FAIL", "limit"]
    (arrow,) = (line for line in shaken.lines if line.get_marker() == ">")
    assert float(np.asarray(arrow.get_xdata())[0]) == shaken.get_xlim()[1]


def test_where_no_capacity_is_known_the_worst_ratio_is_shown(
    results: Results, found: tuple[SensitivityResult, ...]
) -> None:
    only = tuple(row for row in found if row.procedure.endswith("history"))
    assert [row.procedure for row in rank_inputs(only)[0].shown] == ["asce43-05-history"]
    assert rank_inputs(only)[0].number.parameter == "restitution"  # it overturns
    assert len(drawn(results, only).axes) == 1
    silent: dict[str, Any] = {
        "verdict_base": Outcome.NOT_ANSWERED,
        "verdict_low": None,
        "verdict_high": Outcome.NOT_ANSWERED,
    }
    unknown = tuple(replace(row, at_base=None, at_low=None, at_high=None, **silent) for row in only)
    assert drawn(results, unknown).axes


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
    assert sensitivity.answer_name(index) == "index D/C"


def ranges(row: SensitivityResult) -> str:
    return render_measures(sensitivity.range_text(row), units="SI")


def test_units_suit_the_number() -> None:
    row = replace(rows("p", 0.1, 0.2)[0], unit="Pa/m", base=1e10, low=5e9, high=1.5e10)
    assert ranges(row) == "5 to 15 GPa/m"
    assert (
        render_measures(sensitivity.range_text(replace(row, unit="Pa", base=1e6, low=7e5, high=1.3e6)), units="SI")
        == "0.7 to 1.3 MPa"
    )
    assert (
        render_measures(sensitivity.range_text(replace(row, unit="N", base=20e3, low=16e3, high=24e3)), units="SI")
        == "16 to 24 kN"
    )
    assert ranges(replace(row, unit="-", base=0.5, low=0.4, high=0.6)) == "0.4 to 0.6"


def test_names_tell_entries_and_joints() -> None:
    row = replace(rows("p", 0.1, 0.2)[0], parameter="loads", key="mechanisms.wall-6.loads[2].force[1]")
    assert sensitivity.quantity_name(row) == "load, entry 2 of loads"
    joint = replace(row, parameter="stiffness", key="mechanisms.wall-6.interfaces.B.stiffness")
    assert sensitivity.quantity_name(joint) == "stiffness, joint B"


def test_the_report_has_it_where_it_was_asked_for(results: Results, found: tuple[SensitivityResult, ...]) -> None:
    assert "Sensitivity" not in {section.title for section in assessment(results).sections}
    document = assessment(replace(results, sensitivity=found))
    assert [section.title for section in document.sections].count("Sensitivity") == 1
    assert "01-wall-6-sensitivity" in [figure.name for figure in document.figures]
    assert "sensitivity" in [table.name for table in document.tables]
    silent = SensitivityResult("parapet", "thickness", "not varied: its body has no geometry")
    sections = assessment(replace(results, sensitivity=(silent,))).sections
    (section,) = (section for section in sections if section.title == "Sensitivity")
    assert section.blocks == (Text(("thickness: not varied: its body has no geometry.",)),)


def test_names_are_only_text(results: Results, found: tuple[SensitivityResult, ...]) -> None:
    name = "<b>$x$ \\frac{1}{2}\x07‮" + "y" * 10_000
    hostile = tuple(replace(row, key=f"materials.{name}.density") for row in found if row.parameter == "density")
    said = chapter(results, hostile)[0].paragraphs
    assert max(map(len, said)) < 1000
    assert len(drawn(results, hostile).axes[0].get_yticklabels()[0].get_text()) < 120


def test_an_axis_shows_something_where_all_values_are_one() -> None:
    low, high = tornado.span([0.3, 0.3])
    assert low < 0.3 < high
    assert tornado.span([]) == pytest.approx((-0.12, 1.12))


def test_damage_does_not_stand_for_collapse() -> None:
    damage = [replace(row, limit_state="SLD") for row in rows("thickness", 0.08, 0.1, base=0.09)]
    life = [replace(row, limit_state="SLV") for row in rows("thickness", 0.17, 0.205)]
    assert {row.limit_state for row in rank_inputs([*damage, *life])[0].shown} == {"SLV"}
    assert {row.limit_state for row in rank_inputs(damage)[0].shown} == {"SLD"}
