"""The hinges of an arch: of all mechanisms over given joints, the one with the least uplift multiplier.

By the kinematic theorem of limit analysis (no sliding, no crushing) every admissible mechanism gives at least the
multiplier at which the arch starts to move, and the least is that multiplier.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, islice, pairwise

import numpy as np

from assess.errors import MechanismError
from assess.geometry.planar import PlanarBody, join_planar
from assess.mechanisms.chain import Block, Chain, Point
from spectra.arrays import ComplexArray, FloatArray, IntArray

Joint = tuple[Point, Point]

AT_ONCE = 20_000  # choices of four joints evaluated together: 80 voussoirs have 1.7 million


@dataclass(frozen=True)
class ArchHinges:
    """A mechanism of an arch: its four joints, their hinges A to D, and its uplift multiplier [-]."""

    joints: tuple[int, int, int, int]
    hinges: tuple[Point, Point, Point, Point]
    multiplier: float


def weakest_hinges(voussoirs: Sequence[Block], joints: Sequence[Joint], *, name: str) -> ArchHinges:
    """Find the four hinges, at alternate faces, that open under the least horizontal acceleration along +x.

    Parameters
    ----------
    voussoirs : from the springing on the left to that on the right
    joints : before, between and after them, each by its two ends (x, z) [m]; first ends on one face, second ends on
        the other
    name : of the mechanism, for errors

    Raises
    ------
    MechanismError : fewer than three voussoirs, no four joints make a mechanism that resists, or the arch does not
        stand under its own weight
    """
    if len(joints) < 4 or len(joints) != len(voussoirs) + 1:
        raise MechanismError(
            f'mechanism "{name}": {len(voussoirs)} voussoirs with {len(joints)} joints; an arch that hinges has at '
            "least three voussoirs and one joint more than voussoirs"
        )
    ends = np.array([[complex(*end) for end in joint] for joint in joints])
    least, face, chosen = min(_least(voussoirs, ends, face=face) for face in (0, 1))
    if least == -np.inf:
        falling = ", ".join(str(joint + 1) for joint in chosen)
        raise MechanismError(
            f'mechanism "{name}": already falling: its own weight opens joints {falling}, counted from the first; '
            "the arch is too thin, or its joints are not those it has"
        )
    if least == np.inf:
        raise MechanismError(
            f'mechanism "{name}": no four of its joints make a mechanism that resists; check the joints'
        )
    places = [ends[joint, (face + number) % 2] for number, joint in enumerate(chosen)]
    a, b, c, d = ((float(at.real), float(at.imag)) for at in places)
    first, second, third, last = chosen
    return ArchHinges((first, second, third, last), (a, b, c, d), least)


def divide_arch(voussoirs: Sequence[PlanarBody], hinging: ArchHinges) -> tuple[list[PlanarBody], Chain]:
    """Divide an arch into the three blocks between its hinges; return the blocks and their chain.

    Parameters
    ----------
    voussoirs : from the springing on the left to that on the right
    hinging : the joints that open and their hinges
    """
    spans = list(pairwise(hinging.joints))
    bodies = [join_planar(voussoirs[a:b], name=f"block {n}") for n, (a, b) in enumerate(spans, start=1)]
    numbers = [next((n for n, (a, b) in enumerate(spans) if a <= i < b), None) for i in range(len(voussoirs))]
    parts = tuple((block_of(part), number) for part, number in zip(voussoirs, numbers, strict=True))
    return bodies, Chain(tuple(block_of(body) for body in bodies), hinging.hinges, parts=parts)


def block_of(body: PlanarBody) -> Block:
    """Return the mass, centroid and inertia of a body."""
    return Block(body.mass, body.centroid, body.inertia)


def _least(voussoirs: Sequence[Block], ends: ComplexArray, *, face: int) -> tuple[float, int, tuple[int, ...]]:
    """Return the least multiplier with the first hinge on `face`, that face, and the first four joints that have it."""
    least, found = np.inf, tuple(range(4))
    choices = combinations(range(len(ends)), 4)
    while len(chosen := np.array(list(islice(choices, AT_ONCE)))):
        values = _multipliers(voussoirs, ends, chosen, face=face)
        best = int(values.argmin())
        if values[best] < least:
            least, found = float(values[best]), tuple(chosen[best].tolist())
    return least, face, found


def _multipliers(voussoirs: Sequence[Block], ends: ComplexArray, chosen: IntArray, *, face: int) -> FloatArray:
    """Return the uplift multiplier of each choice of four joints [k, 4], the first hinge on `face`.

    inf if it cannot move that way, or is not driven by a push along +x; -inf if it falls under its own weight.
    """
    hinges = np.stack([ends[chosen[:, n], (face + n) % 2] for n in range(4)], axis=1)
    others = np.stack([ends[chosen[:, n], (face + n + 1) % 2] for n in range(4)], axis=1)
    arms = np.diff(hinges, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        second = -_cross(arms[:, 0], arms[:, 2]) / _cross(arms[:, 1], arms[:, 2])
        third = -_cross(arms[:, 1], arms[:, 0]) / _cross(arms[:, 1], arms[:, 2])
    turning = np.stack([np.ones(len(chosen)), second, third], axis=1)
    mass, moment = _sums(voussoirs, chosen)
    at_start = np.concatenate([np.zeros((len(chosen), 1)), np.cumsum(-1j * arms * turning, axis=1)], axis=1)[:, :3]
    momentum = mass * at_start - 1j * turning * (moment - mass * hinges[:, :3])
    work = momentum.sum(axis=1)
    still = np.zeros((len(chosen), 1))
    relative = np.diff(np.concatenate([still, turning, still], axis=1), axis=1)
    opening = -1j * relative * (others - hinges)
    ahead = _ahead(voussoirs, ends)[chosen]
    opens = np.all((opening * np.conj(ahead)).real > 0.0, axis=1) & np.isfinite(work)
    admissible = opens & (work.real > 0.0)
    values = np.full(len(chosen), np.inf)
    values[admissible] = work.imag[admissible] / work.real[admissible]
    values[opens & (work.imag <= 0.0)] = -np.inf
    return values


def _sums(voussoirs: Sequence[Block], chosen: IntArray) -> tuple[FloatArray, ComplexArray]:
    """Return mass and first moment (x + iz) of the three blocks between the joints of each choice [k, 3]."""
    mass = np.concatenate([[0.0], np.cumsum([part.mass for part in voussoirs])])
    moment = np.concatenate([[0.0], np.cumsum([part.mass * complex(*part.centroid) for part in voussoirs])])
    return np.diff(mass[chosen], axis=1), np.diff(moment[chosen], axis=1)


def _ahead(voussoirs: Sequence[Block], ends: ComplexArray) -> ComplexArray:
    """Return a vector across each joint from the voussoir before it to the one after [joints]."""
    centres = np.array([complex(*part.centroid) for part in voussoirs])
    middles = ends.mean(axis=1)
    before = np.concatenate([[2 * middles[0] - centres[0]], centres])
    after = np.concatenate([centres, [2 * middles[-1] - centres[-1]]])
    return np.asarray(after - before)


def _cross(a: ComplexArray, b: ComplexArray) -> FloatArray:
    return np.asarray((np.conj(a) * b).imag, dtype=np.float64)
