"""How chains move, against a four-bar and a slider-crank built here by circle intersection.

The constructions below use real sums, products and square roots alone. So they also take complex rotations, and the
imaginary part of a place at phi + i 1e-30 over 1e-30 is its derivative to the last digit.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, pi, sin

import numpy as np
import pytest
from scipy.optimize import brentq

from assess.errors import MechanismError
from assess.mechanisms.chain import (
    Chain,
    RigidBlock,
    geometric_limit,
    mirror_chain,
    mirror_point,
    move,
    point_text,
    require_movable,
    trace_point,
)

STEP = 1e-30
COUNT = {1: 1, 3: 2, 4: 3}  # blocks by hinges


def chain_of(*hinges, loads=()):
    block = RigidBlock(1000.0, (0.0, 1.0), 100.0)
    return Chain((block,) * COUNT[len(hinges)], hinges, loads)


# Portals of many shapes, then linkages: open or crossed, leaning, with bases at different levels. Equal columns just
# touch their flat place, where the construction goes on in two ways: they have a test of their own.
LOOPS = {
    "asymmetric portal": ((0.5, 0.0), (0.0, 4.0), (3.0, 4.6), (3.4, 0.7)),
    "its negative hinges mirrored": ((0.1, 0.0), (-0.4, 4.0), (-3.5, 4.4), (-2.9, 0.7)),
    "base of D below": ((0.5, 0.0), (0.0, 4.0), (3.0, 4.2), (3.8, -3.0)),
    "leaning left": ((0.5, 0.0), (-1.0, 3.0), (1.5, 3.5), (3.0, 0.2)),
    "leaning right": ((0.0, 0.0), (1.2, 3.0), (4.0, 2.8), (3.0, 0.0)),
    "arch": ((-5.2, 0.3), (-3.1, 3.9), (1.6, 5.1), (4.8, 0.1)),
    "vault on its wall": ((0.0, 6.0), (2.5, 7.4), (4.6, 5.8), (6.0, 0.0)),
    "crossed": ((0.0, 0.0), (0.4, 3.0), (3.6, -0.8), (3.0, 2.0)),
    "crossed, bowed": ((0.0, 0.0), (0.0, 2.0), (2.0, -1.0), (1.5, 1.2)),
    "C below the chord": ((0.0, 0.0), (0.0, 4.0), (2.0, 1.0), (4.0, 0.0)),
    "drag link": ((0.0, 0.0), (0.0, 3.0), (2.0, 3.5), (1.0, 0.0)),
    "D beside A": ((0.0, 0.0), (0.2, 3.0), (1.5, 4.0), (0.0, 0.5)),
}
SLIDERS = {
    "plain wall": ((0.4, 0.0), (0.0, 2.2), (0.4, 4.0)),
    "top at the other face": ((0.4, 0.0), (0.0, 2.2), (0.0, 4.0)),
    "high crack": ((0.4, 0.0), (-0.1, 3.6), (0.45, 4.0)),
    "low crack": ((0.4, 0.3), (0.0, 0.9), (0.4, 4.0)),
    "leaning": ((1.0, 0.0), (0.0, 2.0), (-1.2, 4.5)),
    "leaning far": ((0.0, -1.0), (1.4, 1.0), (3.0, 2.0)),
    "C below B": ((0.4, 0.0), (0.0, 3.0), (0.5, 1.0)),
    "long link": ((0.4, 0.0), (0.0, 1.0), (0.1, 4.0)),
}
EVERY = {**LOOPS, **SLIDERS}
CHAINS = pytest.mark.parametrize("hinges", EVERY.values(), ids=EVERY)


@dataclass(frozen=True)
class Drawing:
    """Where the hinges of a chain stand at a rotation, which may be complex."""

    hinges: tuple

    def hinges_at(self, phi):
        """All hinges (x, z) at phi."""
        a, turned = self.hinges[0], self.corner_b(phi)
        if len(self.hinges) == 3:
            return (a, turned, self._slid(turned))
        return (a, turned, self._met(turned, self._side()), self.hinges[3])

    def corner_b(self, phi):
        """The hinge that the leading block carries round A."""
        a, b, *_ = self.hinges
        x, z = b[0] - a[0], b[1] - a[1]
        return (a[0] + x * np.cos(phi) + z * np.sin(phi), a[1] - x * np.sin(phi) + z * np.cos(phi))

    def room(self, phi):
        """Square of the half chord that two circles share, or of the height of the slider over hinge B; < 0: none."""
        b = self.corner_b(phi)
        return self._room_of_slider(b) if len(self.hinges) == 3 else self._room_of_circles(b)

    def _slid(self, b):
        up = 1.0 if self.hinges[2][1] > self.hinges[1][1] else -1.0
        return (self.hinges[2][0], b[1] + up * np.sqrt(self._room_of_slider(b)))

    def _room_of_slider(self, b):
        (_, b0, c0) = self.hinges
        return (c0[0] - b0[0]) ** 2 + (c0[1] - b0[1]) ** 2 - (c0[0] - b[0]) ** 2

    def _radii(self):
        _, b, c, d = self.hinges
        return ((c[0] - b[0]) ** 2 + (c[1] - b[1]) ** 2, (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2)

    def _room_of_circles(self, b):
        bc2, cd2 = self._radii()
        d = self.hinges[3]
        far2 = (d[0] - b[0]) ** 2 + (d[1] - b[1]) ** 2
        return bc2 - (bc2 - cd2 + far2) ** 2 / (4 * far2)

    def _met(self, b, side):
        """The corner C at `side` of the chord from B to D."""
        bc2, cd2 = self._radii()
        d = self.hinges[3]
        dx, dz = d[0] - b[0], d[1] - b[1]
        far2 = dx**2 + dz**2
        along = (bc2 - cd2 + far2) / (2 * far2)
        out = side * np.sqrt(self._room_of_circles(b) / far2)
        return (b[0] + along * dx - out * dz, b[1] + along * dz + out * dx)

    def _side(self):
        _, b, c, d = self.hinges
        return np.sign((d[0] - b[0]) * (c[1] - b[1]) - (d[1] - b[1]) * (c[0] - b[0]))

    def carried(self, point, block, phi):
        """Place of a point that block `block` carries along, by its coordinates from hinge to hinge."""
        (px, pz), (qx, qz) = self.hinges[block], self.hinges[block + 1]
        ux, uz = qx - px, qz - pz
        size = ux**2 + uz**2
        s = ((point[0] - px) * ux + (point[1] - pz) * uz) / size
        t = ((point[1] - pz) * ux - (point[0] - px) * uz) / size
        (px, pz), (qx, qz) = self.hinges_at(phi)[block : block + 2]
        return (px + s * (qx - px) - t * (qz - pz), pz + s * (qz - pz) + t * (qx - px))

    def slope(self, point, block, phi):
        """d(x, z)/d phi by the complex step."""
        x, z = self.carried(point, block, phi + 1j * STEP)
        return np.array([x.imag, z.imag]) / STEP

    def end(self):
        """The first rotation where the construction has no more room, at most pi."""
        scan = np.linspace(1e-9, pi, 20001)
        gone = np.flatnonzero(self.room(scan) < 0.0)
        return brentq(self.room, scan[gone[0] - 1], scan[gone[0]], xtol=1e-15, rtol=1e-14) if gone.size else pi


def points_of(hinges):
    """Two points of each block, off the lines of the hinges."""
    return [(block, at) for block in range(COUNT[len(hinges)]) for at in ((0.7, 1.9), (-2.0, 5.3))]


@CHAINS
def test_places_over_the_whole_range_are_those_of_circle_intersection(hinges):
    drawing = Drawing(hinges)
    phi = np.linspace(0.0, drawing.end() * (1 - 1e-9), 400)
    motion = move(chain_of(*hinges), phi)
    for block, at in points_of(hinges):
        found = trace_point(motion, block=block, at=at)
        # at the very limit a square root of a vanishing number is left of 16 digits with 8: one step off, 1e-10
        inside = slice(0, -1)
        np.testing.assert_allclose([found.x[inside], found.z[inside]], _drawn(drawing, at, block, phi[inside]),
                                   rtol=0.0, atol=1e-10)  # fmt: skip
        np.testing.assert_allclose([found.x[-1], found.z[-1]], _drawn(drawing, at, block, phi[-1]), rtol=0.0, atol=1e-5)


def _drawn(drawing, at, block, phi):
    x, z = drawing.carried(at, block, phi)
    return np.array([x + 0 * phi, z + 0 * phi])


@CHAINS
def test_first_derivatives_to_1e_minus_10(hinges):
    drawing = Drawing(hinges)
    phi = np.linspace(0.0, 0.97 * drawing.end(), 60)
    motion = move(chain_of(*hinges), phi)
    for block, at in points_of(hinges):
        found, expected = trace_point(motion, block=block, at=at), drawing.slope(at, block, phi)
        size = np.abs(expected).max()
        np.testing.assert_allclose([found.dx, found.dz], expected, rtol=1e-10, atol=1e-12 * size)


@CHAINS
def test_hinges_are_one_point_of_both_blocks_and_supports_stay(hinges):
    chain = chain_of(*hinges)
    phi = np.linspace(0.0, 0.999 * geometric_limit(chain), 200)
    motion = move(chain, phi)
    last = len(chain.blocks) - 1
    for number in range(last):
        one, other = (trace_point(motion, block=number + n, at=hinges[number + 1]) for n in (0, 1))
        for name in ("x", "z", "dx", "dz"):
            np.testing.assert_allclose(getattr(one, name), getattr(other, name), rtol=0, atol=0, err_msg=name)
    end = trace_point(motion, block=last, at=hinges[-1])
    fixed = [(end.x, end.dx)] + [(end.z, end.dz)] * (last == 2)
    for number, (at, first) in enumerate(fixed):
        np.testing.assert_allclose(at, hinges[-1][number], rtol=0.0, atol=1e-12)
        np.testing.assert_allclose(first, 0.0, rtol=0.0, atol=1e-13 * np.abs(motion.rate).max())


@CHAINS
def test_blocks_are_rigid_and_turn_by_their_angle(hinges):
    motion = move(chain_of(*hinges), np.linspace(0.0, 0.9 * geometric_limit(chain_of(*hinges)), 50))
    for block in range(COUNT[len(hinges)]):
        first, second = (trace_point(motion, block=block, at=at) for at in ((0.3, 1.0), (2.0, 3.5)))
        across, up = second.x - first.x, second.z - first.z
        np.testing.assert_allclose(np.hypot(across, up), np.hypot(1.7, 2.5), rtol=1e-13)
        turned = np.unwrap(np.arctan2(up, across)) - atan2(2.5, 1.7)
        whole = np.round((turned + motion.angle[block]) / (2 * pi)) * 2 * pi
        np.testing.assert_allclose(turned + motion.angle[block], whole, rtol=0.0, atol=1e-12)


@CHAINS
def test_the_limit_is_where_the_construction_ends(hinges):
    assert geometric_limit(chain_of(*hinges)) == pytest.approx(Drawing(hinges).end(), rel=1e-9)


def test_limits_by_hand():
    """A folds flat over B when the link is upright; a wall's blocks stand in line when it is straight again."""
    assert geometric_limit(chain_of((0.0, 0.0))) == pi
    wall = chain_of((0.4, 0.0), (0.0, 2.2), (0.4, 4.0))
    assert Drawing(wall.hinges).corner_b(geometric_limit(wall))[0] == pytest.approx(0.4 + np.hypot(0.4, 1.8), rel=1e-12)


def test_equal_columns_go_no_further_than_flat_on_the_ground():
    """A parallelogram only touches its flat place: the cosine there is 1 but for rounding, to either side."""
    rng = np.random.default_rng(0)
    for t, h, span, x in np.round(rng.uniform([0.2, 2, 1, -5], [1, 8, 9, 5], (200, 4)), 2):
        chain = chain_of((x + t, 0.0), (x, h), (x + span, h), (x + span + t, 0.0))
        assert geometric_limit(chain) == pytest.approx(
            pi / 2 + atan2(t, h), abs=1e-6
        )  # of a cosine near 1: half the digits
        phi = np.linspace(0.0, geometric_limit(chain) * (1 - 1e-6), 50)
        for number, at in enumerate((chain.hinges[0], chain.hinges[1], chain.hinges[3])):
            origin = trace_point(move(chain, phi), block=number, at=at)
            apart = trace_point(move(chain, phi), block=number, at=(at[0], at[1] + 1.0))
            angle = np.arctan2(apart.x - origin.x, apart.z - origin.z)
            np.testing.assert_allclose(angle, 0.0 if number == 1 else phi, rtol=0.0, atol=1e-6)  # the beam stays level


@CHAINS
def test_a_mirrored_chain_moves_as_the_mirror_image(hinges):
    chain = chain_of(*hinges)
    image = mirror_chain(chain.blocks, hinges)
    phi = np.linspace(0.0, 0.5 * geometric_limit(image), 30)
    drawing = Drawing(hinges)
    motion = move(image, phi)
    for block, at in points_of(hinges):
        found = trace_point(motion, block=block, at=mirror_point(at))
        x, z = drawing.carried(at, block, -phi)  # the chain itself, turned the other way
        np.testing.assert_allclose(found.x, -x + 0 * phi, rtol=0.0, atol=1e-12)
        np.testing.assert_allclose(found.z, z + 0 * phi, rtol=0.0, atol=1e-12)


def test_a_seeded_crowd_of_loops_and_walls():
    """Three hundred chains at random: places, rates and limits."""
    rng = np.random.default_rng(5)
    seen = 0
    for number in range(300):
        count = 3 + number % 2
        hinges = tuple((float(x), float(z)) for x, z in rng.uniform(-3.0, 3.0, (count, 2)))
        if count == 3 and abs(hinges[2][1] - hinges[1][1]) < 0.2:
            continue
        drawing = Drawing(hinges)
        end = drawing.end()
        if end < 0.02 or drawing.room(0.0) < 1e-3:
            continue
        seen += 1
        chain = chain_of(*hinges)
        assert geometric_limit(chain) == pytest.approx(end, rel=1e-9, abs=1e-12)
        phi = np.linspace(0.0, 0.95 * end, 9)
        motion = move(chain, phi)
        for block in range(COUNT[count]):
            found = trace_point(motion, block=block, at=(0.7, 1.9))
            np.testing.assert_allclose([found.x, found.z], _drawn(drawing, (0.7, 1.9), block, phi), atol=1e-10, rtol=0)
            slope = drawing.slope((0.7, 1.9), block, phi)
            np.testing.assert_allclose([found.dx, found.dz], slope, rtol=1e-8, atol=1e-10 * np.abs(slope).max())
    assert seen > 200


def test_one_block_turns_about_its_hinge():
    phi = np.array([0.0, 0.3, 1.2])
    found = trace_point(move(chain_of((0.4, 0.1)), phi), block=0, at=(-0.1, 2.1))
    r, beta = np.hypot(-0.5, 2.0), atan2(2.0, -0.5)
    for k, angle in enumerate(phi):
        assert (found.x[k] - 0.4, found.z[k] - 0.1) == pytest.approx((r * cos(beta - angle), r * sin(beta - angle)))
        assert (found.dx[k], found.dz[k]) == pytest.approx((found.z[k] - 0.1, 0.4 - found.x[k]))


@pytest.mark.parametrize(
    ("hinges", "words"),
    [
        (((0.4, 0.0), (0.4, 0.0), (0.4, 4.0)), r'"w": hinges A and B coincide at \(0.4, 0\) m'),
        (((0.4, 0.0), (0.0, 2.0), (1e-9, 2.0)), r"hinges B and C coincide at \(0, 2\) m"),
        (((0.0, 0.0), (0.0, 4.0), (3.0, 4.0), (8e5, 0.0)), r"hinges A and B lie 4 m apart, others 8e\+05 m; is one"),
        (((0.0, 0.0), (0.0, 4.0), (3.0, 4.0), (3.0, 4.0)), r"hinges C and D coincide at \(3, 4\) m"),
        (((0.4, 0.0), (0.0, 2.0), (0.9, 2.0)), r"hinges B \(0, 2\) m and C \(0.9, 2\) m lie at one elevation"),
        (((0.0, 0.0), (0.0, 4.0), (1.0, 3.0), (4.0, 0.0)), r"B \(0, 4\) m, C \(1, 3\) m, D \(4, 0\) m lie on one line"),
        (((0.0, 0.0), (0.0, 4.0), (5.0, -1.0), (4.0, 0.0)), "lie on one line"),
    ],
)  # fmt: skip
def test_chains_that_cannot_move_are_refused_with_the_hinges_at_fault(hinges, words):
    with pytest.raises(MechanismError, match=words):
        require_movable(chain_of(*hinges), name="w")


def test_a_chain_needs_the_hinges_of_its_blocks():
    block = RigidBlock(1.0, (0.0, 1.0), 1.0)
    with pytest.raises(MechanismError, match="2 blocks with 4 hinges"):
        require_movable(Chain((block,) * 2, ((0, 0), (0, 1), (1, 1), (1, 0))), name="w")
    with pytest.raises(MechanismError, match="4 blocks with 4 hinges"):
        require_movable(Chain((block,) * 4, ((0, 0), (0, 1), (1, 1), (1, 0))), name="w")


@CHAINS
def test_chains_that_move_are_not_refused(hinges):
    require_movable(chain_of(*hinges), name="w")


def test_rounding_is_written_as_nought():
    assert point_text((-5.561e-17, 4.0)) == "(0, 4) m"
    assert point_text((-1.25e-6, 1e-8)) == "(-1.25e-06, 0) m"
