"""The figures of a Python session: their axes hold the numbers of what is drawn, and what has none is refused."""

from __future__ import annotations

import numpy as np
import pytest

import assess
from assess.errors import AssessError
from tests.support.buildings import house
from tests.support.motions import noise

BLOCK = assess.equivalent_block(p=1.5, uplift=0.15, radius=3.3)
RECORD = noise(3, peak=3.0)


@pytest.mark.parametrize("scale", [0.6, 6.0])
def test_motion_is_drawn_over_the_rotation_that_overturns(scale):
    motion = assess.respond(BLOCK, RECORD, scale=scale)
    ground, rotation = assess.plot(motion).axes
    time, ratio = rotation.lines[0].get_data()
    np.testing.assert_array_equal(time, motion.time)
    np.testing.assert_allclose(ratio, motion.rotation / 0.15, rtol=1e-12)  # linearised: phi_ov is the slenderness
    np.testing.assert_allclose(ground.lines[0].get_ydata(), scale * RECORD.acceleration[: time.size] / assess.g)
    assert motion.overturned is (scale > 1.0)


def test_record_is_drawn_with_its_spectrum():
    above, below = assess.plot(RECORD).axes
    assert np.abs(above.lines[0].get_ydata()).max() == pytest.approx(RECORD.pga / assess.g)
    period, ordinates = below.lines[0].get_data()
    assert ordinates[0] == pytest.approx(RECORD.pga / assess.g, rel=0.1)  # a stiff oscillator follows the ground
    assert period[-1] == pytest.approx(5.0)


def test_mechanism_is_drawn_as_its_capacity():
    wall = assess.single_block(assess.box(thickness=0.6, length=4.0, height=4.5, density=2000.0))
    below = assess.plot(wall).axes[1]
    assert below.lines[0].get_ydata()[0] == pytest.approx(0.6 / 4.5, rel=1e-6)  # the multiplier at rest is b / h


def test_envelope_and_spectrum_and_building_are_drawn():
    frequency, amplitude = np.linspace(0.5, 3.0, 6), np.linspace(0.5, 12.0, 24)
    found = assess.envelope(BLOCK, "sine", frequency=frequency, amplitude=amplitude)
    bound = assess.plot(found).axes[0].lines[1].get_ydata()
    np.testing.assert_allclose(bound, found.lower_bound / assess.g)
    target = assess.spectrum("ec8", a_g=2.0, ground_type="A")
    plateau = max(line.get_ydata().max() for line in assess.plot(target).axes[0].lines if len(line.get_ydata()) > 2)
    assert plateau == pytest.approx(2.5 * 2.0 / assess.g)
    assert assess.plot(house()).axes[0].collections


def test_a_list_is_drawn_together():
    records = [noise(seed, peak=3.0) for seed in range(3)]
    motions = assess.respond(BLOCK, records)
    axes = assess.plot(motions).axes[0]
    for line, motion in zip(axes.lines, motions, strict=True):
        np.testing.assert_allclose(line.get_ydata(), motion.rotation / 0.15, rtol=1e-12)
    spectra = assess.plot(records).axes[0]
    for record in records:
        ordinates = assess.plot(record).axes[1].lines[0].get_ydata()
        assert any(
            line.get_ydata().shape == ordinates.shape and np.allclose(line.get_ydata(), ordinates, rtol=0.02)
            for line in spectra.lines
        )
    curves = assess.fragility(BLOCK, records, measures=["pga"]).mechanisms[0].curves
    assert len(assess.plot(curves).axes[0].get_legend_handles_labels()[0]) >= len(curves) - 1
    with pytest.raises(AssessError, match="or a list of motions, records, curves"):
        assess.plot([RECORD, BLOCK])


def test_a_notebook_shows_small_tables():
    motion = assess.respond(BLOCK, RECORD)
    envelope = assess.envelope(BLOCK, "sine", frequency=[1.0, 2.0], amplitude=[1.0, 30.0])
    found = assess.fragility(BLOCK, [RECORD, noise(4, peak=3.0)], measures=["pga"])
    for thing, shown in (
        (motion, f"<td>{motion.max_ratio:.4g}</td>"),
        (RECORD, f"<td>{RECORD.pga / assess.g:.4g}</td>"),
        (BLOCK, "<td>1.5</td>"),
        (envelope, f"<td>{envelope.lower_bound[0] / assess.g:.3g}</td>"),
        (found, "<td>overturning</td>"),
        (found.mechanisms[0], "<th>block</th><td>overturning</td>"),
    ):
        html = thing._repr_html_()
        assert shown in html
        assert html.startswith("<table>")
        assert len(html) < 1500


def test_what_has_no_figure_is_refused_with_what_has_one():
    with pytest.raises(AssessError, match=r"int: there is no figure of it; give a motion, a record, .* a building"):
        assess.plot(3)
