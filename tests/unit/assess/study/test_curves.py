"""The curves that a screen draws of a mechanism: both branches in one, rising along the axis."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assess.study.curves import capacity, envelope, pga
from assess.study.envelopes import run_envelopes
from assess.study.mechanism_results import parameters
from assess.study.study import Study
from tests.support.projects import block, project_toml, study_of


@pytest.fixture
def study(tmp_path: Path) -> Study:
    return study_of(tmp_path, project_toml(mechanisms={"wall": block(direction=[1, 0, 0], sides="two")}))


def test_the_moment_of_a_two_sided_wall_is_odd_and_falls_to_zero_where_it_overturns(study):
    """By hand: W t / 2 at rest, for a wall of 0.6 x 3 x 4 m at 1800 kg/m3."""
    (result,) = parameters(study)
    curve = capacity(result)
    assert (np.diff(curve.x) >= 0.0).all()
    largest = 9.80665 * 1800.0 * 0.6 * 3.0 * 4.0 * 0.3 / 1e3
    assert np.isclose(curve.y.max(), largest, rtol=1e-6)
    assert np.isclose(curve.y.min(), -largest, rtol=1e-6)


def test_nothing_to_draw_is_no_curve():
    for curve in (capacity(None), pga(()), envelope(None)):
        assert curve.x.size == 0
        assert np.isnan(curve.data[1]).all()


def test_an_envelope_rises_along_frequency(study):
    (result,) = run_envelopes(study).mechanisms
    curve = envelope(result.envelope)
    assert (np.diff(curve.x) > 0.0).all()
    assert np.isfinite(curve.y).any()
