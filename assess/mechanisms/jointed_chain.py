"""A chain on joints: its geometry at rest, and its configurations as it rotates and its joints close."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import hypot

import numpy as np

from assess.loads.load import Action, Load, PointMass, Tie
from assess.mechanisms.chain import Chain, hinge_names
from assess.mechanisms.joint import PAIRS, Joint, Pair
from assess.mechanisms.motion import close_loop, move, trace_point
from assess.mechanisms.virtual_work import generalised_moment
from assess.short_repr import ShortRepr
from spectra.arrays import ComplexArray, FloatArray

AT_HINGE = 1e-6  # of a wall's height: a load this near the hinge at the top acts through its joint


@dataclass(frozen=True, repr=False)
class Configuration(ShortRepr):
    """The positions of the blocks at n rotations.

    turn : exp(-i theta) of each block [blocks, n]; angle : theta [blocks, n] [rad]
    corner : of the pressing block at each hinge, x + iz [hinges, n] [m]
    """

    turn: ComplexArray
    angle: FloatArray
    corner: ComplexArray


@dataclass(frozen=True, repr=False)
class JointedChain(ShortRepr):
    """A chain on joints, whose edges are its hinges; name : of the mechanism, for errors."""

    chain: Chain
    name: str

    @cached_property
    def joints(self) -> tuple[Joint | None, ...]:
        """One for each hinge."""
        return self.chain.joints or (None,) * len(self.chain.hinges)

    @cached_property
    def pairs(self) -> tuple[Pair, ...]:
        """For each hinge the block that holds the face and the one that presses."""
        return PAIRS[len(self.chain.blocks)]

    @cached_property
    def hinges(self) -> ComplexArray:
        """The hinges at rest, x + iz [hinges] [m]."""
        return np.array([complex(*hinge) for hinge in self.chain.hinges])

    @cached_property
    def inward(self) -> ComplexArray:
        """Unit vector from each hinge along its joint at rest [hinges]; 0 for a rigid one."""
        return np.array([complex(*joint.inward) if joint else 0j for joint in self.joints])

    @cached_property
    def sense(self) -> FloatArray:
        """1 for a joint that rotates clockwise, -1 for one that rotates back [hinges]."""
        rate = move(self.chain, np.zeros(1)).rate[:, 0]
        return np.array([
            np.copysign(1.0, rate[pressing] - (0.0 if face is None else rate[face])) for face, pressing in self.pairs
        ])  # fmt: skip

    @cached_property
    def normal(self) -> ComplexArray:
        """Unit vector from each face to the block that presses on it [hinges]."""
        return np.asarray(-1j * self.sense * self.inward)

    @cached_property
    def size(self) -> float:
        """Size of the chain [m]."""
        points = [*self.chain.hinges, *(block.centroid for block in self.chain.blocks)]
        return hypot(*np.ptp(np.array(points), axis=0))

    @cached_property
    def at_top(self) -> tuple[Load, ...]:
        """Loads that act through the joint at the top of a wall of two blocks."""
        if len(self.chain.blocks) != 2 or self.joints[2] is None:
            return ()
        return top_loads(self.chain)

    @cached_property
    def slack(self) -> tuple[Load, ...]:
        """Ties that shorten when the chain leaves rest, and so are slack."""
        leaving = move(self.chain, np.zeros(1))
        ties = [load for load in self.chain.loads if isinstance(load, Tie)]
        return tuple(
            tie for tie in ties if not generalised_moment(tie, trace_point(leaving, block=tie.block, at=tie.at)).any()
        )

    @cached_property
    def actions(self) -> tuple[Action, ...]:
        """The forces and ties on the chain."""
        return tuple(load for load in self.chain.loads if not isinstance(load, PointMass))

    @cached_property
    def places(self) -> list[str]:
        """What errors call each joint."""
        return [f'mechanism "{self.name}", interface {letter}' for letter in hinge_names(self.chain)]

    def configuration(self, rotation: FloatArray, sunk: FloatArray) -> Configuration:
        """Return the blocks at `rotation` [n], the joints sunk [hinges, n] [m]: a loop of arms with these offsets."""
        h, offset = self.hinges[:, None], sunk * self.normal[:, None]
        lead, base = np.exp(-1j * rotation), h[0] - offset[0]
        if len(h) == 1:
            return Configuration(lead[None, :], rotation[None, :], base[None, :])
        arms = [h[1] - h[0] - offset[1], np.broadcast_to(h[2] - h[1], rotation.shape)]
        if len(h) == 4:
            arms.append(h[3] - h[2] + offset[2])
        span = h[-1] - offset[-1] - base
        turned = close_loop(np.array(arms), lead=arms[0] * lead, span=span)
        turn = turned / np.array(arms)
        turn = turn / np.abs(turn)
        corner = [base, base + turned[0], base + turned[0] + turned[1], base + turned.sum(axis=0)]
        return Configuration(turn, -np.angle(turn), np.array(corner[: len(h)]))

    def faces(self, configuration: Configuration) -> ComplexArray:
        """Return the direction from each corner along the held face, per metre of the pressing face [hinges, n].

        A pressure on a point of the rotated face acts at its projection on the held face, cos psi as far away. Friction
        acts at the corner, in line with the held face, so that it has no arm about this point.
        """
        level = np.ones_like(configuration.turn[0])
        held = [level if face is None else configuration.turn[face] for face, _ in self.pairs]
        return np.asarray(self.inward[:, None] * np.array(held) * np.cos(self.relative(configuration)))

    def relative(self, configuration: Configuration) -> FloatArray:
        """Return the rotation psi of each joint [hinges, n] [rad]."""
        turned = [
            configuration.angle[pressing] - (0.0 if face is None else configuration.angle[face])
            for face, pressing in self.pairs
        ]
        return np.asarray(self.sense[:, None] * np.array(turned), dtype=np.float64)

    def place(self, configuration: Configuration, block: int, at: complex) -> ComplexArray:
        """Return where a point of a block, given at rest, is now [n]."""
        corner = (0, 1, 3)[block]
        return np.asarray(configuration.corner[corner] + (at - self.hinges[corner]) * configuration.turn[block])


def top_loads(chain: Chain) -> tuple[Load, ...]:
    """Return the loads at the hinge at the top of a wall of two blocks, which act through its joint."""
    x, z = chain.hinges[2]
    near = AT_HINGE * (z - chain.hinges[0][1])
    return tuple(load for load in chain.loads if load.block == 1 and hypot(load.at[0] - x, load.at[1] - z) <= near)
