"""Joints in the report: table, figures and sentences against closed forms of a rectangular contact."""

from __future__ import annotations

from dataclasses import replace
from math import sin, sqrt

import pytest
from scipy.constants import g

from assess.project.build import build
from assess.project.project_file import load
from assess.results import HistoryResult, HistoryTrace, MechanismResult
from assess.study.mechanism_results import parameters
from reports.chapters import annex_sheets
from reports.chapters.annex_sheets import parameters_table as table_of_parameters
from reports.document import Figure, Prose, Sheet, Table
from reports.figures import capacity
from reports.language.locale import Locale
from reports.language.texts import Verbatim, quantity
from reports.mechanisms import joints_of_branch, peak_rotation, values_at
from tests.support.letters import letters
from tests.support.projects import block, project_toml, wall

SOFT = {"interface": {"model": "flexible", "stiffness": "0.2 GPa/m"}}
PROJECT = project_toml(
    site=None,
    materials={"stone": {"density": 1800, "compressive_strength": "1.5 MPa"}},
    bodies={"wall": wall(1, 2, 6, material="stone"), "slim": wall(0.5, 1, 4, material="stone")},
    mechanisms={
        "rigid": block(direction=[1, 0, 0]),
        "flexible": {"label": "<b>on joints</b>"} | block(direction=[1, 0, 0], **SOFT),
        "other": block(direction=[1, 0, 0], sides="one", **SOFT),
        "two": block("slim", kind="two-block", direction=[1, 0, 0], crack="2.4 m", **SOFT)
        | {"loads": [{"kind": "overburden", "force": "20 kN", "eccentricity": 0.25}]},
    },
)
W, B, L, K, F = 1800 * 12 * g, 1.0, 2.0, 0.2e9, 1.5e6  # N, m, m, Pa/m, Pa: of the wall


@pytest.fixture(scope="module")
def mechanisms(tmp_path_factory) -> dict[str, MechanismResult]:
    path = tmp_path_factory.mktemp("joints") / "project.toml"
    path.write_text(PROJECT)
    return {found.name: found for found in parameters(build(load(path)))}


def with_one_history(mechanism: MechanismResult, rotation: float | None) -> MechanismResult:
    """The mechanism with one history that reaches a rotation [rad], or overturns it."""
    fell, trace = rotation is None, HistoryTrace((0.0,), (0.0,), (0.0,))
    ratio = None if rotation is None else abs(rotation) / mechanism.oscillator.overturning_rad
    side = "negative" if rotation is not None and rotation < 0 else "positive"
    one = HistoryResult("r <1>", 1, 0.3, 1.0, 1.0, rotation, ratio, None, 3, fell, None, trace, side)
    return replace(mechanism, histories=(one,))


@pytest.mark.parametrize("rotation", [0.01, -0.03])
def test_the_contact_at_the_peak_is_that_of_the_closed_form(mechanisms, rotation):
    """Thesis 6.6: partial contact, elastic, a = sqrt(2 W / (k l phi)), stress k phi a, resultant a / 3."""
    a = sqrt(2 * W / (K * L * sin(abs(rotation))))
    mechanism = with_one_history(mechanisms["flexible"], rotation)
    assert peak_rotation(mechanism, mechanism.histories[0]) == abs(rotation)
    (joint,) = joints_of_branch(mechanism, mechanism.histories[0].branch)
    stress, resultant, opened, crushed = values_at(joint, abs(rotation))
    assert stress == pytest.approx(K * sin(abs(rotation)) * a, rel=1e-3)  # the curve is read between its points
    assert resultant == pytest.approx(a / 3, rel=1e-3)
    assert opened == pytest.approx(1 - a / B, rel=1e-3)
    assert crushed == 0.0
    told = letters(annex_sheets.joints_at_peak(mechanism))
    hinge = "A" if rotation > 0 else "A'"
    assert f"joint {hinge} presses with up to {letters(quantity(stress, 'stress', 3))} (strength 1.5 MPa)" in told
    assert f"{letters(quantity(100 * opened, 'percent', 2))} of it open and none crushed" in told


def test_what_has_no_peak_says_so(mechanisms):
    flexible = mechanisms["flexible"]
    assert "No time history" in letters(annex_sheets.joints_at_peak(flexible))
    assert "overturns the mechanism" in letters(annex_sheets.joints_at_peak(with_one_history(flexible, None)))
    assert "does not move" in letters(annex_sheets.joints_at_peak(with_one_history(flexible, 0.0)))


def test_a_history_counts_from_rest_and_a_joint_from_upright(mechanisms):
    """Two blocks under an eccentric load stand at phi_e, which is negative here."""
    two = mechanisms["two"]
    rest = two.oscillator.equilibrium_rad
    assert rest < 0.0
    there, back = with_one_history(two, 0.02), with_one_history(two, -0.02)
    assert peak_rotation(there, there.histories[0]) == pytest.approx(0.02 + rest, rel=1e-12)
    assert peak_rotation(back, back.histories[0]) == pytest.approx(0.02 - rest, rel=1e-12)


def test_the_table_has_every_hinge_and_its_thresholds(mechanisms):
    """Thesis 6.2 and 6.4 with W < f A / 2: the joint opens at 2 W / (k l b^2), crushes at f^2 l / (2 k W)."""
    table = annex_sheets.joints_table(mechanisms["flexible"], name="t")
    headings = [letters(column.label) for column in table.columns]
    for row in table.rows:
        found = dict(zip(headings, row, strict=True))
        assert found["Stiffness"] == K
        assert found["Force at rest"] == pytest.approx(W, rel=1e-12)
        assert found["Opens at"] == pytest.approx(2 * W / (K * L * B**2), rel=1e-9)
        assert found["Crushes at"] == pytest.approx(F**2 * L / (2 * K * W), rel=1e-9)
    assert [row[0] for row in table.rows] == [Verbatim("A"), Verbatim("A'")]
    rigid = annex_sheets.joints_table(mechanisms["rigid"], name="t").rows[0]
    assert [letters(rigid[place]) for place in (2, 3, 8)] == ["rigid", "unlimited", "never"]


def test_only_mechanisms_with_joints_have_the_pages(mechanisms):
    assert annex_sheets.joint_blocks(mechanisms["rigid"], "x") == []
    made = annex_sheets.joint_blocks(mechanisms["flexible"], "x")
    assert [type(block) for block in made] == [Table, Prose, Figure, Figure, Sheet]


def test_joints_that_are_alike_share_a_sheet(mechanisms):
    (both,) = annex_sheets.contact_sheets(mechanisms["flexible"], "x")
    assert both.name == "x-contact-A"
    assert letters(both.caption).startswith("Contact of joints A and A': force at rest")
    (one,) = annex_sheets.contact_sheets(mechanisms["other"], "x")
    assert letters(one.caption).startswith("Contact of joint A: force at rest")
    assert one.steps == mechanisms["other"].contact_sheets[0].steps
    apart = [sheet.name for sheet in annex_sheets.contact_sheets(mechanisms["two"], "x")]
    assert apart[:4] == ["x-contact-A", "x-contact-B", "x-contact-C", "x-contact-A-negative"]
    assert annex_sheets.contact_sheets(mechanisms["rigid"], "x") == []


def test_parameters_show_rest_frequency_and_no_threshold(mechanisms):
    rows = {letters(row[0]): row[2:] for row in table_of_parameters(mechanisms["flexible"], name="p").rows}
    assert [*map(letters, rows["Load multiplier at uplift"])] == ["none", "none"]
    assert rows["Rotation at rest"] == (quantity(0.0, "rotation"),) * 2
    frequency = mechanisms["flexible"].oscillator.elastic_frequency_hz
    assert rows["Frequency of small motions about rest"] == (quantity(frequency, "frequency"),) * 2


def test_the_moment_figure_marks_opening_and_crushing_on_the_curve(mechanisms):
    axes = capacity.draw_moment_rotation(mechanisms["flexible"], Locale()).axes[0]
    marks = [line.get_xydata()[0] for line in axes.lines if line.get_marker() == "o" and len(line.get_xdata())]
    opening, crushing = 2 * W / (K * L * B**2), F**2 * L / (2 * K * W)
    assert [x for x, _ in marks] == pytest.approx([opening, crushing], rel=1e-4)
    # at opening, full contact: M = W (R sin(alpha - phi) - a cos phi), the resultant at b / 3; of W b / 2
    turned = 0.5 - 3.0 * sin(opening) - B / 3
    assert marks[0][1] == pytest.approx(turned / 0.5, rel=1e-3)
    assert [line.get_label() for line in axes.lines[:3]] == [
        "rigid joints",
        "hinges fixed at a_SF",
        "its joints",
    ]


def test_the_capacity_curve_has_a_mark_for_each_overturning(mechanisms):
    for name, marks in (("flexible", ["o", "s"]), ("rigid", ["o"])):
        found = mechanisms[name]
        axes = capacity.draw_capacity(found, Locale()).axes[0]
        drawn = [line.get_marker() for line in axes.lines if line.get_marker() in ("o", "s")]
        assert drawn == marks


def test_joints_that_are_alike_share_a_line(mechanisms):
    assert [hinges for *_, hinges in capacity.distinct_curves(mechanisms["flexible"])] == ["A, A'"]
    assert [hinges for *_, hinges in capacity.distinct_curves(mechanisms["other"])] == ["A"]
    two = [hinges for *_, hinges in capacity.distinct_curves(mechanisms["two"])]
    assert two[:3] == ["A, A'", "B, B'", "C"]
    stress = capacity.draw_contact(mechanisms["flexible"], Locale()).axes[1]
    assert max(line.get_ydata().max() for line in stress.lines[:1]) == pytest.approx(F / 1e6, rel=1e-12)


def test_ticks_of_the_logarithmic_axis_are_plain_numbers(mechanisms):
    figure = capacity.draw_contact(mechanisms["flexible"], Locale())
    figure.draw_without_rendering()
    for axes in figure.axes:
        told = {tick.get_text() for tick in axes.get_xticklabels()}
        assert {"0.001", "0.01"} <= told
        assert not any("$" in text for text in told)
