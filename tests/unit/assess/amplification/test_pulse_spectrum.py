"""The one-sine pulse spectrum against an integrator, limits, and numbers found elsewhere."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from assess.amplification import largest_pseudo, largest_relative, largest_total

RATIO = [0.05, 0.2, 0.5, 0.8, 1.0, 1.5, 2.0, 4.0, 10.0]


def integrated(r: float, *, ground: float, shape: float, damping: float) -> float:
    """Largest |ground a_g + shape u''| by DOP853, in units of 1 / w and of the pulse's amplitude."""
    motion = lambda t, y, pulse: [y[1], -pulse * np.sin(r * t) - 2 * damping * y[1] - y[0]]  # noqa: E731
    peak, state = 0.0, [0.0, 0.0]
    for start, end, pulse in ((0.0, 2 * np.pi / r, 1.0), (2 * np.pi / r, 2 * np.pi / r + 13.0, 0.0)):
        out = solve_ivp(motion, (start, end), state, "DOP853", args=(pulse,), rtol=1e-10, atol=1e-13, dense_output=True)
        t = np.linspace(start, end, 40_000)
        a = pulse * np.sin(r * t)
        u, v = out.sol(t)
        peak, state = max(peak, np.abs(ground * a + shape * (-a - 2 * damping * v - u)).max()), out.y[:, -1]
    return peak


@pytest.mark.parametrize("r", [0.11, 0.8, 1.0, 3.3])
@pytest.mark.parametrize("shape", [0.4, 1.0, 1.6])
def test_it_is_that_of_an_integrator(r: float, shape: float) -> None:
    assert largest_total(r, shape=shape) == pytest.approx(
        integrated(r, ground=1.0, shape=shape, damping=0.05), rel=1e-6
    )
    assert largest_relative(r, damping=0.02) == pytest.approx(
        integrated(r, ground=0.0, shape=1.0, damping=0.02), rel=1e-6
    )


def test_known_numbers_of_5_percent() -> None:
    """By an event-exact integrator, three figures."""
    relative = [0.046, 0.198, 0.787, 2.323, 2.693, 1.822, 1.727, 1.307, 1.063]
    total = [1.011, 1.043, 1.624, 2.781, 2.713, 1.794, 1.151, 0.326, 0.064]
    np.testing.assert_allclose(largest_relative(RATIO), relative, atol=6e-4)
    np.testing.assert_allclose(largest_total(RATIO, shape=1.0), total, atol=6e-4)


def test_limits() -> None:
    assert largest_total(1e-2, shape=1.0) == pytest.approx(1.0, rel=3e-3)  # a rigid structure moves with the ground
    assert largest_relative(1e3) == pytest.approx(1.0, rel=1e-3)  # a soft one stays where it is
    np.testing.assert_allclose(largest_total(RATIO, shape=0.0), 1.0, rtol=1e-6)
    rare = largest_pseudo(RATIO, damping=1e-4) / largest_total(RATIO, shape=1.0, damping=1e-4)
    np.testing.assert_allclose(rare, 1.0, atol=2e-4)  # without damping w^2 u is the total acceleration
    assert largest_total(np.ones((2, 3)), shape=1.0).shape == (2, 3)


@pytest.mark.parametrize(("ratio", "damping"), [(0.0, 0.05), (-1.0, 0.05), (np.nan, 0.05), (1.0, 0.0), (1.0, 1.0)])
def test_what_no_structure_has_is_refused(ratio: float, damping: float) -> None:
    with pytest.raises(ValueError, match="must"):
        largest_relative([1.0, ratio], damping=damping)
