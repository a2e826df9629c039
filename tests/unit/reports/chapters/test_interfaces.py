"""Joints in the report: table, figures and sentences against closed forms of a rectangular contact."""

from __future__ import annotations

from dataclasses import replace
from math import sin, sqrt

import numpy as np
import pytest
from reports.chapters.parameters import parameters as table_of_parameters
from reports.language.measures import render_measures
from scipy.constants import g

from assess.project.build import build
from assess.project.schema import load
from assess.results import HistoryResult, MechanismResult, Resolved, Results, Trace
from assess.study.parameters import parameters
from reports import joints
from reports.assessment import assessment
from reports.chapters import descriptions, interface_variants, interfaces
from reports.document import Figure, Table, Text
from reports.figures import capacity, contact, moment_rotation
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


def shaken(mechanism: MechanismResult, rotation: float | None) -> MechanismResult:
    """The mechanism with one history that reaches a rotation [rad], or overturns it."""
    fell, trace = rotation is None, Trace((0.0,), (0.0,), (0.0,))
    ratio = None if rotation is None else abs(rotation) / mechanism.oscillator.overturning_rad
    side = "negative" if rotation is not None and rotation < 0 else "positive"
    one = HistoryResult("r <1>", 1, 0.3, 1.0, 1.0, rotation, ratio, None, 3, fell, None, trace, side)
    return replace(mechanism, histories=(one,))


@pytest.mark.parametrize("rotation", [0.01, -0.03])
def test_the_contact_at_the_peak_is_that_of_the_closed_form(mechanisms, rotation):
    """Thesis 6.6: partial contact, elastic, a = sqrt(2 W / (k l phi)), stress k phi a, resultant a / 3."""
    a = sqrt(2 * W / (K * L * sin(abs(rotation))))
    mechanism = shaken(mechanisms["flexible"], rotation)
    assert joints.peak_rotation(mechanism, mechanism.histories[0]) == abs(rotation)
    (joint,) = joints.joints_of_branch(mechanism, mechanism.histories[0].branch)
    stress, resultant, opened, crushed = joints.values_at(joint, abs(rotation))
    assert stress == pytest.approx(K * sin(abs(rotation)) * a, rel=1e-3)  # the curve is read between its points
    assert resultant == pytest.approx(a / 3, rel=1e-3)
    assert opened == pytest.approx(1 - a / B, rel=1e-3)
    assert crushed == 0.0
    told = render_measures(interfaces.at_peak(mechanism), units="SI")
    assert f"joint {'A' if rotation > 0 else chr(65) + chr(39)} presses with up to {stress / 1e6:.3g}" in told
    assert "(strength 1.50 MPa)" in told
    assert f"{100 * opened:.0f} % of it open and none crushed" in told


def test_what_has_no_peak_says_so(mechanisms):
    flexible = mechanisms["flexible"]
    assert "No time history" in interfaces.at_peak(flexible)
    assert "overturns the mechanism" in interfaces.at_peak(shaken(flexible, None))
    assert "does not move" in interfaces.at_peak(shaken(flexible, 0.0))


def test_a_history_counts_from_rest_and_a_joint_from_upright(mechanisms):
    """Two blocks under an eccentric load stand at phi_e, which is negative here."""
    two = mechanisms["two"]
    rest = two.oscillator.equilibrium_rad
    assert rest < 0.0
    there, back = shaken(two, 0.02), shaken(two, -0.02)
    assert joints.peak_rotation(there, there.histories[0]) == pytest.approx(0.02 + rest, rel=1e-12)
    assert joints.peak_rotation(back, back.histories[0]) == pytest.approx(0.02 - rest, rel=1e-12)


def test_the_table_has_every_hinge_and_its_thresholds(mechanisms):
    """Thesis 6.2 and 6.4 with W < f A / 2: the joint opens at 2 W / (k l b^2), crushes at f^2 l / (2 k W)."""
    table = interfaces.table(mechanisms["flexible"], name="t")
    headings = [column.heading for column in table.columns]
    for row in table.rows:
        found = dict(zip(headings, row, strict=True))
        assert found["Stiffness [Pa/m]"] == K
        assert found["Force at rest [N]"] == pytest.approx(W, rel=1e-12)
        assert found["Opens at [rad]"] == pytest.approx(2 * W / (K * L * B**2), rel=1e-9)
        assert found["Crushes at [rad]"] == pytest.approx(F**2 * L / (2 * K * W), rel=1e-9)
    assert [row[0] for row in table.rows] == ["A", "A'"]
    rigid = interfaces.table(mechanisms["rigid"], name="t").rows[0]
    assert (rigid[2], rigid[3], rigid[8]) == ("rigid", "unlimited", "never")


def test_only_mechanisms_with_joints_have_the_pages(mechanisms):
    assert interfaces.blocks(mechanisms["rigid"], name="x") == []
    made = interfaces.blocks(mechanisms["flexible"], name="x")
    assert [type(block) for block in made] == [Table, Text, Figure, Figure]
    assert list(interfaces.limits((mechanisms["rigid"],))) == []
    assert len(list(interfaces.limits(tuple(mechanisms.values())))) == 1


def test_parameters_show_rest_frequency_and_no_threshold(mechanisms):
    rows = {row[0]: row[2:] for row in table_of_parameters(mechanisms["flexible"], name="p").rows}
    assert rows["Load multiplier at uplift, λ"] == ("none", "none")
    assert rows["Rotation at rest, φₑ"] == (0.0, 0.0)
    frequency = mechanisms["flexible"].oscillator.elastic_frequency_hz
    assert rows["Frequency of small motions about rest"] == (frequency, frequency)


def test_the_moment_figure_marks_opening_and_crushing_on_the_curve(mechanisms):
    axes = moment_rotation.draw(mechanisms["flexible"]).axes[0]
    marks = [line.get_xydata()[0] for line in axes.lines if line.get_marker() == "o" and len(line.get_xdata())]
    opening, crushing = 2 * W / (K * L * B**2), F**2 * L / (2 * K * W)
    assert [x for x, _ in marks] == pytest.approx([opening, crushing], rel=1e-4)
    # at opening, full contact: M = W (R sin(alpha - phi) - a cos phi), the resultant at b / 3; of W b / 2
    turned = 0.5 - 3.0 * sin(opening) - B / 3
    assert marks[0][1] == pytest.approx(turned / 0.5, rel=1e-3)
    assert [line.get_label() for line in axes.lines[:3]] == [
        "rigid joints",
        "hinges fixed at a_SF",
        "its joints: flexible",
    ]


def test_the_capacity_curve_has_a_mark_for_each_overturning_and_its_caption_tells_both(mechanisms):
    for name, marks in (("flexible", ["o", "s"]), ("rigid", ["o"])):
        found = mechanisms[name]
        axes = capacity.draw(found).axes[0]
        drawn = [line.get_marker() for line in axes.lines if line.get_marker() in ("o", "s")]
        assert drawn == marks
        assert ("square on its joints" in descriptions.capacity_caption(found)) == (len(marks) == 2)


def test_the_name_of_overturning_on_joints_leaves_the_curve_free(mechanisms):
    figure = capacity.draw(mechanisms["flexible"])
    figure.draw_without_rendering()
    for axes in figure.axes:
        (name,) = [text for text in axes.texts if "interface" in text.get_text()]
        box = name.get_window_extent()
        for line in axes.lines[:2]:
            rotation, height = line.get_data()
            fine = np.linspace(rotation[0], rotation[-1], 2000)
            assert not box.count_contains(axes.transData.transform(np.c_[fine, np.interp(fine, rotation, height)]))


def test_joints_that_are_alike_share_a_line(mechanisms):
    assert [hinges for *_, hinges in contact.distinct_curves(mechanisms["flexible"])] == ["A, A'"]
    assert [hinges for *_, hinges in contact.distinct_curves(mechanisms["other"])] == ["A"]
    two = [hinges for *_, hinges in contact.distinct_curves(mechanisms["two"])]
    assert two[:3] == ["A, A'", "B, B'", "C"]
    stress = contact.draw(mechanisms["flexible"]).axes[1]
    assert max(line.get_ydata().max() for line in stress.lines[:1]) == pytest.approx(F / 1e6, rel=1e-12)


def test_ticks_of_the_logarithmic_axis_are_plain_numbers(mechanisms):
    figure = contact.draw(mechanisms["flexible"])
    figure.draw_without_rendering()
    for axes in figure.axes:
        told = {tick.get_text() for tick in axes.get_xticklabels()}
        assert {"0.001", "0.01"} <= told
        assert not any("$" in text for text in told)


def project_of(mechanisms: dict[str, MechanismResult]) -> dict[str, Resolved]:
    """What results.json says of them, in short."""
    said = {"rigid": ("wall", "two"), "flexible": ("wall", "two"), "other": ("wall", "one"), "two": ("slim", "two")}
    found = {}
    for name, (body, sides) in said.items():
        model = joints.model_name(mechanisms[name])
        for key, value in (("blocks", [body]), ("sides", sides), ("label", name), ("interface.model", model)):
            found[f"mechanisms.{name}.{key}"] = Resolved(value, True)
    return found


@pytest.fixture
def compared(results: Results, mechanisms: dict[str, MechanismResult]) -> Results:
    """Results of the four mechanisms, with the checks of others."""
    first = results.mechanisms[0]
    weaker = tuple(replace(c, capacity_pga_g=c.capacity_pga_g and 0.9 * c.capacity_pga_g) for c in first.checks)
    made = tuple(
        replace(mechanisms[name], checks=checks)
        for name, checks in (("flexible", weaker), ("rigid", first.checks), ("other", weaker), ("two", weaker))
    )
    return replace(results, mechanisms=made, project=project_of(mechanisms), comparison=(), sweeps=())


def test_what_differs_by_its_interface_alone_stands_side_by_side(compared):
    (group,) = interface_variants.find_variants(compared)
    assert list(group.members) == ["rigid", "flexible"]
    assert interface_variants.earlier_variants(compared) == {"rigid": "flexible"}
    table = interface_variants.table((group,), name="t")
    assert [column.heading for column in table.columns] == ["Procedure", "Mechanism", "rigid [g]", "flexible [g]"]
    procedures = {row[0]: row[2:] for row in table.rows}
    stiff, weak = procedures["asce43-05-spectrum"]
    assert weak == pytest.approx(0.9 * stiff, rel=1e-12)
    assert procedures["dmi2008-linear"] == (None, None)
    muted = {table.rows[place][0] for place in table.muted}
    assert muted == {"asce43-05-spectrum-thesis"}


def with_twin(compared: Results, twin: MechanismResult) -> Results:
    """The results with one mechanism more, of which the project says what it says of `flexible`."""
    project = {k.replace(".flexible.", f".{twin.name}."): v for k, v in compared.project.items() if ".flexible." in k}
    return replace(compared, mechanisms=(*compared.mechanisms, twin), project={**compared.project, **project})


def test_two_of_one_model_have_a_column_each(compared):
    flexible = compared.mechanisms[0]
    softer = tuple({**interface, "normal_force_n": 1.0} for interface in flexible.interfaces)
    (group,) = interface_variants.find_variants(with_twin(compared, replace(flexible, name="again", interfaces=softer)))
    assert list(group.members) == ["rigid", "flexible", "flexible 2"]


def test_what_has_the_same_interface_too_is_not_said_to_differ_by_it(compared):
    more = with_twin(compared, replace(compared.mechanisms[0], name="again"))
    (group,) = interface_variants.find_variants(more)
    assert [mechanism.name for mechanism in group.members.values()] == ["rigid", "flexible"]
    assert set(interface_variants.earlier_variants(more)) == {
        "rigid",
        "again",
    }  # their bodies are the same all the same
    twins = replace(more, mechanisms=(more.mechanisms[0], more.mechanisms[-1]))
    assert interface_variants.blocks(twins, name="t") == []


def test_bodies_in_space_are_drawn_once_for_siblings(compared, mechanisms):
    names = [figure.name for figure in assessment(compared).figures if figure.name.endswith("-view")]
    assert names == ["01-flexible-view", "03-other-view", "04-two-view"]
