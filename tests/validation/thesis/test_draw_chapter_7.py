"""The figures of chapter 7: what their curves show, and that the script writes them."""

from __future__ import annotations

import draw_chapter_7 as drawn
import numpy as np
import pytest
from chapter_7 import RELEASE, STIFFNESSES

from assess.dynamics.history import free_rocking


def test_curves_of_free_rocking_pass_the_impacts_and_peaks_that_events_find():
    case = drawn.wall_of(STIFFNESSES[2])
    for model, time, ratio, fell in drawn.curves(case, lambda c, m: drawn.released(c, m, duration=12.0)):
        found = free_rocking(case.make(model), rotation=RELEASE * case.slenderness, duration=12.0)
        assert not fell
        assert ratio[0] == pytest.approx(RELEASE, rel=1e-9)
        at_impact = np.interp(found.impact_time, time, ratio)
        np.testing.assert_allclose(at_impact, 0.0, rtol=0.0, atol=3e-3)  # a line between samples
        at_peak = np.interp(found.peak_time, time, ratio) * case.slenderness
        np.testing.assert_allclose(at_peak, found.peak_rotation, rtol=1e-4)


def test_a_history_that_overturns_is_cut_and_marked(tmp_path):
    group = dict(drawn.of_storeys())
    axes = group["7-15-two-block-history"].axes
    falls = [line for line in axes[1].lines if line.get_marker() == "x"]
    assert len(falls) == 3
    rigid, flexible, semi_flexible = (float(line.get_xdata()[-1]) for line in falls)
    assert flexible == pytest.approx(semi_flexible, rel=0.02)
    assert rigid > flexible
    for name, figure in group.items():
        assert all("[" in axis.get_ylabel() for axis in figure.axes)
        assert figure.axes[-1].get_xlabel() == "time t [s]"
        paths = drawn.written(name, figure, tmp_path)
        assert [path.suffix for path in paths] == [".png", ".svg"]
        assert all(path.stat().st_size > 10_000 for path in paths)
