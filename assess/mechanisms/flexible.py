"""A chain whose hinges press on deformable joints: its equilibrium, the forces of its joints, its virtual work.

Each joint closes by u at its edge and turns by psi; its stress puts the resultant at a distance a inside the edge (see
`interfaces.contact`). The closures follow from equilibrium at a given rotation phi, held by a moment on the leading
block, so that phi alone describes the chain, and V(phi) is the potential energy of weights and joints together.

    normal force      of every joint, by the equilibrium of every block
    restoring         dV/dphi - M, the moment that holds the leading block

with each hinge at the resultant of its joint. V is never differentiated through a(phi): as the joints are in
equilibrium, that derivative is zero (tested with the energy of the joints). Inertia is that of the true motion, in
which the faces rotate about `Contact.instantaneous_centre`, neglecting the small change of forces along the motion.
Closures count from the state of rest, in which the geometry was measured.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from assess.interfaces.contact import contact, semi_flexible_shift
from assess.loads.load import PointMass
from assess.mechanisms.chain import Chain
from assess.mechanisms.joint import Joint
from assess.mechanisms.joint_equilibrium import (
    Contacts,
    JointEquilibrium,
    contacts_of,
    each_contact,
    solve_joint_equilibrium,
)
from assess.mechanisms.joint_forces import holding_moment
from assess.mechanisms.jointed_chain import JointedChain
from assess.mechanisms.motion import solve_turnings
from assess.mechanisms.virtual_work import Work, virtual_work
from assess.short_repr import ShortRepr
from spectra.arrays import ComplexArray, FloatArray

PLASTIC = 1.0  # rad: any rotation, for a rigid joint with a strength


@dataclass(frozen=True, repr=False)
class EquilibriumState(ShortRepr):
    """A chain held at n rotations.

    work : the sums of virtual work; relative : rotation psi of each joint [hinges, n] [rad]
    normal_force : on each joint [hinges, n] [N]; contacts : None for a rigid joint
    """

    work: Work
    relative: FloatArray
    normal_force: FloatArray
    contacts: Contacts


@dataclass(frozen=True, repr=False)
class BlockVelocities(ShortRepr):
    """Velocities of the blocks: of a point of each [blocks, n] [m], and the rate of its rotation [blocks, n]."""

    points: ComplexArray
    velocity: ComplexArray
    rate: FloatArray

    def at(self, block: int, point: ComplexArray) -> ComplexArray:
        """Return the velocity [n] of a point of a block."""
        return np.asarray(self.velocity[block] - 1j * self.rate[block] * (point - self.points[block]))


@dataclass(frozen=True, repr=False)
class FlexibleChain(ShortRepr):
    """A chain on joints, solved at any rotations; name : of the mechanism, for errors."""

    chain: Chain
    name: str

    @cached_property
    def jointed(self) -> JointedChain:
        """The geometry of the chain and its joints."""
        return JointedChain(self.chain, self.name)

    def solve_equilibrium(self, rotation: FloatArray) -> EquilibriumState:
        """Solve the equilibrium of the chain at given rotations.

        Parameters
        ----------
        rotation : of the leading block, not negative [n] [rad]

        Raises
        ------
        MechanismError : the joints find no equilibrium
        InterfaceError : a joint in tension or overloaded
        """
        found = self.solve_joints(rotation)
        configuration, models = found.configuration, {joint.model for joint in self.jointed.joints if joint}
        centres = self._marks(found) if "flexible-thesis" in models else self._points(found, "instantaneous_centre")
        work = self._work(found, self._field(centres))
        if "semi-flexible" in models:
            fixed = virtual_work(self.fixed_hinge_chain, rotation)
            work = replace(work, inertia=fixed.inertia, participation=fixed.participation)
        return EquilibriumState(work, self.jointed.relative(configuration), found.normal_force, found.contacts)

    @cached_property
    def fixed_hinge_chain(self) -> Chain:
        """The rigid chain with each hinge at a_SF inside its edge; a rigid joint with a strength: at its resultant."""
        forces = self.solve_joints(np.zeros(1)).normal_force[:, 0]
        inside = np.array([
            _fixed_shift(joint, float(force), where=where) if joint else 0.0
            for joint, force, where in zip(self.jointed.joints, forces, self.jointed.places, strict=True)
        ])  # fmt: skip
        hinges = tuple((float(at.real), float(at.imag)) for at in self.jointed.hinges + inside * self.jointed.inward)
        return replace(self.chain, hinges=hinges, joints=())

    def moments(self, rotation: FloatArray) -> FloatArray:
        """Return the moment of each action at `rotation` [n] [rad]; positive overturns [actions, n] [N m]."""
        found = self.solve_joints(rotation)
        points = self._points(found, "resultant")
        held = [holding_moment(self.jointed, found.configuration, points, [action]) for action in self.jointed.actions]
        return -np.array(held).reshape(-1, rotation.size)

    @cached_property
    def at_rest(self) -> JointEquilibrium:
        """The joints at rest, where each resultant is in the middle."""
        middle = np.array([joint.section.centroid if joint else 0.0 for joint in self.jointed.joints])
        return solve_joint_equilibrium(self.jointed, np.zeros(1), np.zeros(len(self.jointed.joints)), middle[:, None])

    @cached_property
    def rest(self) -> FloatArray:
        """Closure of each joint at rest [hinges] [m]."""
        return self.at_rest.closure[:, 0]

    def solve_joints(self, rotation: FloatArray) -> JointEquilibrium:
        """Solve the equilibrium of the joints at `rotation` [n] [rad]."""
        shape = (len(self.jointed.joints), rotation.size)
        normal = np.broadcast_to(self.at_rest.normal_force, shape)
        near = contacts_of(self.jointed, self.jointed.configuration(rotation, np.zeros(shape)), normal)
        return solve_joint_equilibrium(self.jointed, rotation, self.rest, each_contact(near, "resultant", shape))

    def _points(self, found: JointEquilibrium, what: Literal["resultant", "instantaneous_centre"]) -> ComplexArray:
        """Return the resultants or the instantaneous centres of all joints [hinges, n]."""
        return found.configuration.corner + each_contact(
            found.contacts, what, found.closure.shape
        ) * self.jointed.faces(found.configuration)

    def _marks(self, found: JointEquilibrium) -> ComplexArray:
        """Return where each resultant presses on its block, which the thesis takes for the hinge (6.51) [hinges, n]."""
        configuration = found.configuration
        pressing = self.jointed.inward[:, None] * configuration.turn[[block for _, block in self.jointed.pairs]]
        return np.asarray(
            configuration.corner + each_contact(found.contacts, "resultant", found.closure.shape) * pressing
        )

    def _field(self, points: ComplexArray) -> BlockVelocities:
        """Return the velocities of the blocks rotating about points [hinges, n], the first one at the rate 1."""
        blocks, n = len(self.chain.blocks), points.shape[1]
        rate = np.ones((1, n))
        velocity = np.zeros((1, n), dtype=np.complex128)
        if blocks > 1:
            arms = np.diff(points, axis=0)[:blocks]
            rate = np.concatenate([rate, solve_turnings(arms, -arms[0])])
            velocity = np.concatenate([velocity, np.cumsum(-1j * rate[:-1] * arms[: blocks - 1], axis=0)])
        return BlockVelocities(points[:blocks], velocity, rate)

    def _work(self, found: JointEquilibrium, moving: BlockVelocities) -> Work:
        """Return the sums of virtual work: holding moments of weights and forces, masses in the true motion."""
        configuration, points = found.configuration, self._points(found, "resultant")
        inertia, excitation, participation, lift = np.zeros((4, points.shape[1]))
        bodies = [(b.mass, complex(*b.centroid), True, b.inertia, k) for k, b in enumerate(self.chain.blocks)]
        masses = [load for load in self.chain.loads if isinstance(load, PointMass)]
        bodies += [(load.mass, complex(*load.at), load.bearing, 0.0, load.block) for load in masses]
        for mass, at, bearing, turned, number in bodies:
            v = moving.at(number, self.jointed.place(configuration, number, at))
            excitation += mass * v.real
            participation += mass * v.real**2
            inertia += mass * (v.real**2 + bearing * v.imag**2) + turned * moving.rate[number] ** 2
            lift += mass * bearing * v.imag
        weight = holding_moment(self.jointed, configuration, points, masses, blocks=True)
        return Work(
            inertia,
            weight,
            -holding_moment(self.jointed, configuration, points, self.jointed.actions),
            excitation,
            participation,
            lift,
        )


def _fixed_shift(joint: Joint, force: float, *, where: str) -> float:
    """Return the distance of the fixed hinge of a joint from its edge [m]."""
    if joint.model == "rigid":
        found = contact(joint.section, joint.law, normal_force=force, rotation=PLASTIC, where=where)
        return float(found.resultant[0])
    return semi_flexible_shift(joint.section, joint.law, normal_force=force, where=where)
