"""Makris & Vassiliou 2013, EESD 42:281: free-standing columns capped with a rigid beam.

With gamma = m_beam / (N m_column) the frame rocks as a single block of the columns' slenderness with
p_frame / p = sqrt((1 + 2 gamma) / (1 + 3 gamma)), p^2 = 3g / 4R; the beam does not change the uplift acceleration
g tan(alpha); restitution (1 - 1.5 sin^2(alpha) + 3 gamma cos(2 alpha)) / (1 + 3 gamma).
"""

from __future__ import annotations

from math import atan2, cos, hypot, sin, sqrt, tan

import numpy as np
import pytest
from scipy.constants import g

from assess.oscillator import multiplier, participation_ratio, restoring_moment
from tests.support.projects import block, mechanism_of, tables_toml, wall

B, H = 0.9, 5.4  # width and height of a column


def portal(folder, gamma, *, span=4.0, x=0.0):
    """Two columns of density 2400 under a beam of gamma times their mass, in a project file."""
    beam, length, half = 0.8, span + B, B / 2
    front = ((x + half, 0), (x - half, H), (x + span - half, H), (x + span + half, 0))
    back = ((x - half, 0), (x + half, H), (x + span + half, H), (x + span - half, 0))
    hinges = {"hinges": dict(zip("ABCD", front, strict=True)), "hinges_negative": dict(zip("ABCD", back, strict=True))}
    text = tables_toml(
        materials={
            "column": {"density": 2400},
            "beam": {"density": gamma * 2 * 2400 * B * H / (beam * length)},
        },
        bodies={
            "left": wall(B, 1.1, H, base=[x, 0, 0], material="column"),
            "right": wall(B, 1.1, H, base=[x + span, 0, 0], material="column"),
            "beam": wall(length, 1.1, beam, base=[x + span / 2, 0, H], material="beam"),
        },
        mechanisms={"p": block("left", "beam", "right", kind="four-hinge", **hinges)},
    )
    return mechanism_of(folder, text)


@pytest.mark.parametrize("gamma", [0.01, 0.6])
def test_frame_is_one_larger_block(tmp_path, gamma):
    R, alpha = hypot(B, H) / 2, atan2(B, H)
    p = sqrt(3 * g / (4 * R))
    rocker = portal(tmp_path, gamma).oscillator
    assert rocker.mass == pytest.approx(2 * 2400 * B * H * 1.1 * (1 + gamma), rel=1e-12)
    for side in rocker.branches:
        form = side.linearised
        assert form.p / p == pytest.approx(sqrt((1 + 2 * gamma) / (1 + 3 * gamma)), rel=1e-8)
        assert (form.multiplier, side.overturning) == pytest.approx((alpha, alpha), rel=1e-8)
        assert multiplier(side)[0] == pytest.approx(tan(alpha), rel=1e-12)
        eta = (1 - 1.5 * sin(alpha) ** 2 + 3 * gamma * cos(2 * alpha)) / (1 + 3 * gamma)
        assert side.restitution == pytest.approx(eta, rel=1e-12)


def test_direct_equivalence_holds_at_every_rotation(tmp_path):
    """Not only linearised: I does not change, the restoring moment is a sine, and both directions are alike."""
    alpha, R = atan2(B, H), hypot(B, H) / 2
    rocker = portal(tmp_path, 0.6).oscillator
    phi = np.linspace(0.0, 1.4 * alpha, 40)
    size = g * R * 2 * 2400 * B * H * 1.1 * (1 + 2 * 0.6)
    for side in rocker.branches:
        np.testing.assert_allclose(restoring_moment(side, phi), size * np.sin(alpha - phi), rtol=0.0, atol=1e-9 * size)
        np.testing.assert_allclose(side.inertia, side.inertia[0], rtol=1e-11)
    assert participation_ratio(rocker.positive, mass=rocker.mass) < 1.0  # the beam moves twice as far as the columns


@pytest.mark.parametrize("x", [0.1, -4.12, 1.69, 3.33])
@pytest.mark.parametrize("span", [1.33, 2.0, 6.36])
def test_tables_are_made_wherever_the_portal_stands(tmp_path, span, x):
    """Equal columns touch a flat place, and rounding of the hinges must not carry the search of phi_ov across it."""
    side = portal(tmp_path, 0.6, span=span, x=x).oscillator.positive
    assert np.isfinite(side.inertia).all()
    assert side.overturning == pytest.approx(atan2(B, H), rel=1e-9)
