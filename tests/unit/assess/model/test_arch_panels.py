"""Panels that bulge out between cross walls: hand formulas, half panels turned as rectangles, and what is refused."""

from __future__ import annotations

from math import asin, cos, hypot, sin

import numpy as np
import pytest

import assess
from assess.errors import GeometryError, MechanismError
from assess.mechanisms.arch_in_plan import thrust_held_beyond
from assess.oscillator import displacement, multiplier
from spectra.gravity import g
from spectra.registry import spectrum

DENSITY, T, HEIGHT, SPAN = 1900.0, 0.5, 3.0, 4.0
H = 30e3
SITE = spectrum("ntc2018", a_g=0.15 * g, f_0=2.4, t_c_star=0.3, soil="A")


def wall(length: float = 9.0, middle: float = 0.0, name: str = "wall", **more) -> assess.Body:
    """A wall along x whose inner face is at y = 0, which falls towards +y."""
    given = {"thickness": length, "length": T, "height": HEIGHT, "density": DENSITY, "base": (middle, T / 2, 0.0)}
    return assess.box(**(given | more), name=name)


def cross(at: float, name: str) -> assess.Body:
    return assess.box(thickness=0.4, length=3.0, height=HEIGHT, density=DENSITY, base=(at, -1.5, 0.0), name=name)


CROSSES = (cross(-SPAN / 2 - 0.2, "left"), cross(SPAN / 2 + 0.2, "right"))


def panel(body=None, *, ends=(H, 2 * H), around=(), direction=(0.0, 1.0, 0.0), **more) -> assess.Block:
    return assess.horizontal_arch(
        body or wall(), between=("left", "right"), ends=ends, direction=direction, around=(*CROSSES, *around), **more
    )


WEIGHT = g * DENSITY * T * HEIGHT * SPAN
DEPTH = H / (1e6 * HEIGHT)
RISE = T - DEPTH


def test_the_multiplier_is_that_of_the_thrust_by_hand() -> None:
    found = panel()
    assert found.oscillator.mass == pytest.approx(WEIGHT / g, rel=1e-9)
    assert found.oscillator.multiplier == pytest.approx(8.0 * H * RISE / (WEIGHT * SPAN), rel=1e-9)


def test_the_curve_falls_to_zero_where_the_rise_is_lost() -> None:
    """In the displacement of the middle d, twice that of the masses: 4 H (r - d) / (W sqrt(l^2 - (r - d)^2))."""
    oscillator = panel().mechanism.oscillator
    branch = oscillator.positive
    moved = 2.0 * displacement(branch, branch.rotation, mass=oscillator.mass)
    left = RISE - moved
    by_hand = 4.0 * H * left / (WEIGHT * np.sqrt((SPAN / 2.0) ** 2 + RISE**2 - left**2))
    np.testing.assert_allclose(multiplier(branch), by_hand, rtol=1e-6, atol=1e-9)
    assert branch.overturning == pytest.approx(asin(RISE / hypot(SPAN / 2.0, RISE)), rel=1e-9)


def test_half_panels_turned_as_rectangles_do_the_same_work() -> None:
    """Each half as its four corners, turned about the end that it presses on until both meet in the middle again.

    The ends slide apart along the wall, each half as far, against H.
    """
    branch = panel().mechanism.oscillator.positive
    pivot = np.array([T - DEPTH / 2.0, 0.0])  # (out, along): the first half reaches from it to the middle of the span
    corners = np.array([[0.0, 0.0], [T, 0.0], [T, SPAN / 2], [0.0, SPAN / 2]])
    tip = np.array([DEPTH / 2.0, SPAN / 2])

    def placed(phi: float) -> tuple[float, float]:
        """How far the middle of the half has moved out, and the end along the wall, at a rotation."""
        turn = np.array([[cos(phi), sin(phi)], [-sin(phi), cos(phi)]])
        turned = (corners - pivot) @ turn.T + pivot
        slid = float(((tip - pivot) @ turn.T + pivot)[1] - tip[1])  # the tip stays in the middle: the end gives way
        return float(turned[:, 0].mean()), slid

    for node in (0, 40, 90, 140):
        phi = float(branch.rotation[node])
        (out_1, end_1), (out_0, end_0) = placed(phi + 1e-6), placed(phi - 1e-6)
        alpha = H * 2.0 * (end_1 - end_0) / (WEIGHT * (out_1 - out_0))
        assert multiplier(branch)[node] == pytest.approx(alpha, rel=1e-6)


def test_ends_that_are_not_given_hold_what_the_wall_beyond_does() -> None:
    """Beyond the far faces of the cross walls 2.1 m of wall are left: W l / (2 h)."""
    beyond = 4.5 - SPAN / 2 - 0.4
    weight = g * DENSITY * T * HEIGHT * beyond
    held = thrust_held_beyond(weight=weight, length=beyond, lever=HEIGHT)
    depth = held / (1e6 * HEIGHT)
    found = panel(ends=None).oscillator.multiplier
    assert found == pytest.approx(8.0 * held * (T - depth) / (WEIGHT * SPAN), rel=1e-9)
    assert held == pytest.approx(weight * beyond / 6.0)
    slides = panel(wall(density=assess.Material(name="smooth", density=DENSITY, friction=0.1)), ends=None)
    assert slides.oscillator.multiplier < found


def test_masonry_that_crushes_leaves_a_tenth_of_the_thickness() -> None:
    weak = panel(ends=(1e9, 1e9), strength=0.2e6)
    thrust = 0.2e6 * 0.1 * T * HEIGHT
    assert weak.oscillator.multiplier == pytest.approx(8.0 * thrust * 0.9 * T / (WEIGHT * SPAN), rel=1e-9)


def test_an_opening_takes_of_weight_and_of_what_crushes() -> None:
    """A door of 1 x 2 m in the middle: three bodies that are one wall."""
    parts = [
        wall(4.0, -2.5, "a"), wall(4.0, 2.5, "b"),
        wall(1.0, 0.0, "lintel", height=1.0, base=(0.0, T / 2, 2.0)),
    ]  # fmt: skip
    found = panel(parts, ends=(1e9, 1e9))
    weight = g * DENSITY * T * (HEIGHT * SPAN - 2.0)
    assert found.oscillator.mass == pytest.approx(weight / g, rel=1e-9)
    thrust = 1e6 * 0.1 * T * 1.0
    inside = (1.5 * 3.0 * 1.25 + 0.5 * 1.0 * 0.25) / (1.5 * 3.0 + 0.5)  # of half a panel from the middle
    lever = 1.0 - inside / (SPAN / 2.0)  # its middle moves less the farther it is from that of the wall
    by_hand = 4.0 * thrust * 0.9 * T / (SPAN * lever * weight)
    assert found.oscillator.multiplier == pytest.approx(by_hand, rel=1e-9)


def test_floors_on_a_panel_move_with_it() -> None:
    slab = assess.box(thickness=SPAN, length=T, height=0.2, density=2500.0, base=(0, T / 2, HEIGHT), name="slab")
    found = panel(around=[slab], loads=[assess.BodyLoad(body="slab")])
    weight = WEIGHT + g * slab.mass
    assert found.oscillator.multiplier == pytest.approx(8.0 * H * RISE / (weight * SPAN), rel=1e-6)


def test_a_wall_of_a_turned_building_is_the_same() -> None:
    straight = panel(direction=(0.0, 2.0, 0.0))
    assert straight.oscillator.multiplier == pytest.approx(panel().oscillator.multiplier, rel=1e-12)
    one = assess.box(thickness=T, length=9.0, height=HEIGHT, density=DENSITY, base=(T / 2, 0.0, 0.0), name="wall")
    crosses = [assess.box(thickness=3.0, length=0.4, height=HEIGHT, density=DENSITY, base=(-1.5, s * 2.2, 0), name=name)
               for s, name in ((-1, "left"), (1, "right"))]  # fmt: skip
    turned = assess.horizontal_arch(
        one, between=("right", "left"), ends=(H, 2 * H), direction=(1, 0, 0), around=crosses
    )
    assert turned.oscillator.multiplier == pytest.approx(straight.oscillator.multiplier, rel=1e-9)


def test_the_kinematic_checks_answer_and_nothing_else_does() -> None:
    block = panel()
    answering, others = ("ntc2018-linear", "ntc2018-nonlinear"), ("ntc2018-history", "sliding", "ec8-element")
    building = assess.building(height=6.0, storeys=2)
    checks = assess.answers(block, SITE, procedures=(*answering, *others), building=building)
    found = {each.procedure: each for each in checks}
    assert {found[name].verdict for name in answering} <= {"pass", "fail"}
    assert {found[name].verdict for name in others} == {"not-answered"}
    assert {found[name].reason.key for name in others} == {"histories-unknown"}


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: panel(wall(SPAN + 0.8), ends=None), "ends: nothing of the wall lies beyond a cross wall"),
        (lambda: panel(direction=(1.0, 0.0, 0.0)), "between: no span is left between them"),
        (
            lambda: assess.horizontal_arch(wall(), between=("left", "far"), direction=(0, 1, 0), around=CROSSES),
            'between: "far" is no body',
        ),
        (
            lambda: assess.horizontal_arch(wall(), between=("left", "wall"), direction=(0, 1, 0), around=CROSSES),
            "it moves, or it stays",
        ),
        (
            lambda: panel(loads=[assess.TieLoad(force=1e3, at=(0, 0.5, 2), anchor=(0, -5, 2))]),
            "an arch takes masses and bodies",
        ),
        (lambda: panel(ends=(1e9, 1e9, 1e9)), "too many"),
        (lambda: panel(ends=(-1.0, 1e3)), "must be greater than 0"),
        (lambda: panel(cut=5.0), "nothing of the wall lies between them above the cut"),
    ],
)
def test_what_is_refused(make, told: str) -> None:
    with pytest.raises((MechanismError, GeometryError), match=told):
        make()
