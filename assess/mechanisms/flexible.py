"""A chain whose hinges press on joints that give way: where it stands, what its joints carry, how it moves on.

Each joint closes by u at its edge and turns by psi; its stress puts the resultant at a distance a inside the edge (see
`interfaces.contact`). The closures follow from equilibrium at a given rotation phi, held by a moment on the leading
block, so that phi alone describes the chain, and V(phi) is the potential energy of weights and joints together.

    normal force      of every joint, by the balance of forces and moments on every block
    restoring         dV/dphi - M, the moment that holds the leading block

with each hinge where the resultant of its joint passes. V is never differentiated
through a(phi): as the joints are in equilibrium, that derivative is zero (tested with the energy of the joints).
Inertia is that of the true motion, in which the faces turn about `Contact.instantaneous_centre`, neglecting the small
change of forces along the motion. Closures count from the state of rest, in which the geometry was measured.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from math import hypot
from typing import Literal

import numpy as np
from scipy.constants import g

from assess.errors import MechanismError
from assess.interfaces.contact import Contact, contact, semi_flexible_shift
from assess.loads.load import Action, Force, Load, PointMass, Tie, pull_at_rest, upward
from assess.mechanisms.chain import Chain, hinge_names
from assess.mechanisms.joint import PAIRS, Joint, Pair
from assess.mechanisms.motion import close_loop, move, solve_turnings, trace_point
from assess.mechanisms.virtual_work import Work, generalised_moment, virtual_work
from assess.short_repr import ShortRepr
from spectra.arrays import ComplexArray, FloatArray

Contacts = tuple[Contact | None, ...]

ROUNDS = 60
CONVERGED = 1e-13  # of the chain's size: what moves by less from round to round is found
FOUND = 1e-9  # of the same: and so is what moves by less, but does not come nearer any more
ROUGH = 1e-7  # of the same: and what still moves by less in the end, by rounding, as very stiff joints do at rest
BACK = 1e-9  # rad: a joint that turns back by more would open at its hinge
AT_HINGE = 1e-6  # of a wall's height: a load this near the hinge at the top of a wall comes through its joint
LEVEL = 1e-15  # rad: a joint that has turned by less has not, but for rounding
PLASTIC = 1.0  # rad: any rotation, for a rigid joint with a strength


@dataclass(frozen=True, repr=False)
class Configuration(ShortRepr):
    """Where the blocks stand at n rotations.

    turn : exp(-i theta) of each block [blocks, n]; angle : theta [blocks, n] [rad]
    corner : of the pressing block at each hinge, x + iz [hinges, n] [m]
    """

    turn: ComplexArray
    angle: FloatArray
    corner: ComplexArray


@dataclass(frozen=True, repr=False)
class JointEquilibrium(ShortRepr):
    """The joints in equilibrium at n rotations.

    configuration; normal_force : on each joint [hinges, n] [N]; contacts : None for a rigid joint
    closure : of the edge of each joint [hinges, n] [m]
    """

    configuration: Configuration
    normal_force: FloatArray
    contacts: Contacts
    closure: FloatArray


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
    """Velocities of the blocks: of a point of each [blocks, n] [m] and its rate of turning [blocks, n]."""

    points: ComplexArray
    velocity: ComplexArray
    rate: FloatArray

    def at(self, block: int, trace_point: ComplexArray) -> ComplexArray:
        """Velocity [n] of a point of a block."""
        return np.asarray(self.velocity[block] - 1j * self.rate[block] * (trace_point - self.points[block]))


@dataclass(frozen=True, repr=False)
class FlexibleChain(ShortRepr):
    """A chain with its joints, to be asked at many rotations; name : of the mechanism, for errors."""

    chain: Chain
    name: str

    def solve_equilibrium(self, rotation: FloatArray) -> EquilibriumState:
        """The chain in equilibrium at `rotation` [n] [rad], none negative.

        Raises MechanismError where a joint finds no equilibrium, InterfaceError where it is pulled or overloaded.
        """
        found = self.solve_joints(rotation)
        configuration, models = found.configuration, {joint.model for joint in self.joints if joint}
        centres = self._marks(found) if "flexible-thesis" in models else self._points(found, "instantaneous_centre")
        work = self._work(found, self._field(centres))
        if "semi-flexible" in models:
            fixed = virtual_work(self.fixed_hinge_chain, rotation)
            work = replace(work, inertia=fixed.inertia, participation=fixed.participation)
        return EquilibriumState(work, self.relative(configuration), found.normal_force, found.contacts)

    @cached_property
    def fixed_hinge_chain(self) -> Chain:
        """The rigid chain with each hinge at a_SF inside its edge; a rigid joint with a strength: at its resultant."""
        forces = self.solve_joints(np.zeros(1)).normal_force[:, 0]
        inside = np.array([
            _fixed_shift(joint, float(force), where=where) if joint else 0.0
            for joint, force, where in zip(self.joints, forces, self._places, strict=True)
        ])  # fmt: skip
        hinges = tuple((float(at.real), float(at.imag)) for at in self.hinges + inside * self.inward)
        return replace(self.chain, hinges=hinges, joints=())

    @cached_property
    def joints(self) -> tuple[Joint | None, ...]:
        """One for each hinge."""
        return self.chain.joints or (None,) * len(self.chain.hinges)

    @cached_property
    def pairs(self) -> tuple[Pair, ...]:
        """Of each hinge the block that holds the face and the one that presses."""
        return PAIRS[len(self.chain.blocks)]

    @cached_property
    def hinges(self) -> ComplexArray:
        """At rest, x + iz [hinges] [m]."""
        return np.array([complex(*hinge) for hinge in self.chain.hinges])

    @cached_property
    def inward(self) -> ComplexArray:
        """Unit vector from each hinge along its joint at rest [hinges]; 0 where it is rigid."""
        return np.array([complex(*joint.inward) if joint else 0j for joint in self.joints])

    @cached_property
    def sense(self) -> FloatArray:
        """1 where the joint turns clockwise, -1 where it turns back [hinges]."""
        rate = move(self.chain, np.zeros(1)).rate[:, 0]
        return np.array([
            np.copysign(1.0, rate[pressing] - (0.0 if face is None else rate[face])) for face, pressing in self.pairs
        ])  # fmt: skip

    @cached_property
    def normal(self) -> ComplexArray:
        """Unit vector from each face to the block that presses on it [hinges]: where the joint opens to, inside."""
        return np.asarray(-1j * self.sense * self.inward)

    @cached_property
    def size(self) -> float:
        """Of the chain [m]."""
        points = [*self.chain.hinges, *(block.centroid for block in self.chain.blocks)]
        return hypot(*np.ptp(np.array(points), axis=0))

    @cached_property
    def at_top(self) -> tuple[Load, ...]:
        """Loads that come through the joint at the top of a wall of two blocks."""
        if len(self.chain.blocks) != 2 or self.joints[2] is None:
            return ()
        return top_loads(self.chain)

    @cached_property
    def slack(self) -> tuple[Load, ...]:
        """Ties that shorten when the chain leaves rest, and so do not pull."""
        leaving = move(self.chain, np.zeros(1))
        ties = [load for load in self.chain.loads if isinstance(load, Tie)]
        return tuple(
            tie for tie in ties if not generalised_moment(tie, trace_point(leaving, block=tie.block, at=tie.at)).any()
        )

    @cached_property
    def actions(self) -> tuple[Action, ...]:
        """The forces and ties on it."""
        return tuple(load for load in self.chain.loads if not isinstance(load, PointMass))

    def moments(self, rotation: FloatArray) -> FloatArray:
        """Generalised moment of each force and tie at `rotation` [n] [rad]; positive overturns [actions, n] [N m]."""
        found = self.solve_joints(rotation)
        points = self._points(found, "resultant")
        held = [self._holding(found.configuration, points, [action]) for action in self.actions]
        return -np.array(held).reshape(-1, rotation.size)

    @cached_property
    def at_rest(self) -> JointEquilibrium:
        """The joints at rest, where each resultant is in the middle."""
        middle = np.array([joint.section.centroid if joint else 0.0 for joint in self.joints])
        return self._iterate(np.zeros(1), np.zeros(len(self.joints)), middle[:, None])

    @cached_property
    def rest(self) -> FloatArray:
        """Closing of each joint at rest [hinges] [m]."""
        return self.at_rest.closure[:, 0]

    @cached_property
    def _places(self) -> list[str]:
        return [f'mechanism "{self.name}", interface {letter}' for letter in hinge_names(self.chain)]

    # ------------------------------------------------------------------------------------------------- equilibrium

    def solve_joints(self, rotation: FloatArray) -> JointEquilibrium:
        """The joints in equilibrium at `rotation` [n] [rad]."""
        shape = (len(self.joints), rotation.size)
        normal = np.broadcast_to(self.at_rest.normal_force, shape)
        near = self._contacts(self._configuration(rotation, np.zeros(shape)), normal)
        return self._iterate(rotation, self.rest, _each(near, "resultant", shape))

    def _iterate(self, rotation: FloatArray, rest: FloatArray, near: FloatArray) -> JointEquilibrium:
        """Round by round, each of which gains digits, since what one joint closes moves the others by little.

        rest : closures from which sinking counts [hinges]; at rotation 0 nothing has sunk; near : resultants to begin
        with [hinges, n]. From the second round on the step is corrected by what the last two rounds changed (Anderson
        1965, with one step of memory).
        """
        shape = (len(self.joints), rotation.size)
        now, before, change, last = np.array([np.zeros(shape), near]), None, np.inf, np.inf
        for _ in range(ROUNDS):
            configuration = self._configuration(rotation, now[0])
            points = configuration.corner + now[1] * self._faces(configuration)
            loads = self._loads(configuration, points, self.chain.loads)
            normal = self._normal_forces(configuration, self._reactions(points, *loads))
            contacts = self._contacts(configuration, normal)
            closure = _each(contacts, "closure", shape)
            found = np.array([(closure - rest[:, None]) * (rotation > 0.0), _each(contacts, "resultant", shape)])
            residual = found - now
            change = float(np.abs(residual).max())
            if change <= CONVERGED * self.size or (change <= FOUND * self.size and change >= last):
                self._require_open(configuration)
                return JointEquilibrium(configuration, normal, contacts, closure)
            last, after = change, (found, residual)
            now = found if before is None else found - _memory(residual, before[1]) * (found - before[0])
            before = after
        if change <= ROUGH * self.size:
            self._require_open(configuration)
            return JointEquilibrium(configuration, normal, contacts, closure)
        raise MechanismError(
            f'mechanism "{self.name}": its joints find no equilibrium (they still move by {last:.2g} m); check their '
            "stiffness and strength"
        )

    def _configuration(self, rotation: FloatArray, sunk: FloatArray) -> Configuration:
        """The blocks at `rotation` [n] with the joints sunk [hinges, n] [m]: a loop of arms with those offsets."""
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

    def _faces(self, configuration: Configuration) -> ComplexArray:
        """From each corner along the face it presses on, for each metre of the pressing face [hinges, n].

        A pressure on a point of the turned face acts where that is seen square to the held one, cos psi as far away.
        What slides is kept at the corner, in line with the held face, so it has no arm about this point.
        """
        level = np.ones_like(configuration.turn[0])
        held = [level if face is None else configuration.turn[face] for face, _ in self.pairs]
        return np.asarray(self.inward[:, None] * np.array(held) * np.cos(self.relative(configuration)))

    def relative(self, configuration: Configuration) -> FloatArray:
        """Rotation psi of each joint [hinges, n] [rad]."""
        turned = [
            configuration.angle[pressing] - (0.0 if face is None else configuration.angle[face])
            for face, pressing in self.pairs
        ]
        return np.asarray(self.sense[:, None] * np.array(turned), dtype=np.float64)

    def _contacts(self, configuration: Configuration, normal: FloatArray) -> Contacts:
        """The contact of each joint under its force [hinges, n] [N]."""
        psi = self.relative(configuration)
        found: list[Contact | None] = []
        for joint, force, turned, where in zip(self.joints, normal, psi, self._places, strict=True):
            if joint is None:
                found.append(None)
                continue
            slope = np.sin(np.clip(turned, 0.0, np.pi / 2)) * (turned > LEVEL)
            found.append(contact(joint.section, joint.law, normal_force=force, rotation=slope, where=where))
        return tuple(found)

    def _require_open(self, configuration: Configuration) -> None:
        """Raise MechanismError where a joint would open at its hinge."""
        for joint, turned, where in zip(self.joints, self.relative(configuration), self._places, strict=True):
            if joint and turned.min() < -BACK:
                raise MechanismError(
                    f"{where}: its faces turn by {-turned.min():.3g} rad away from the hinge, which would open there; "
                    "put the hinge at the other face"
                )

    def _loads(
        self, configuration: Configuration, points: ComplexArray, loads: Iterable[Load], *, blocks: bool = True
    ) -> tuple[ComplexArray, FloatArray]:
        """Force on each block and its moment about the origin, anticlockwise [blocks, n] [N, N m].

        loads : those that count; blocks : whether their own weights do
        """
        shape = (len(self.chain.blocks), points.shape[1])
        force, moment = np.zeros(shape, dtype=np.complex128), np.zeros(shape)
        for number, block in enumerate(self.chain.blocks if blocks else ()):
            force[number] = -1j * g * block.mass
            moment[number] = -g * block.mass * self._place(configuration, number, complex(*block.centroid)).real
        for load in loads:
            here = points[2] if load in self.at_top else self._place(configuration, load.block, complex(*load.at))
            pull = self._force(load, here)
            force[load.block] += pull
            moment[load.block] += _cross(here, pull)
        return force, moment

    def _reactions(self, points: ComplexArray, force: ComplexArray, moment: FloatArray) -> ComplexArray:
        """Force at each hinge on what lies beyond it [hinges, n] [N], the leading block held by a moment.

        Every block k keeps its balance: P_k - P_(k+1) + F_k = 0, and the same with moments, but for the leading one.
        """
        if len(force) == 1:
            return -force
        arm, turn = points[1] - points[2], _cross(points[1], force[1]) - moment[1]
        if len(force) == 2:
            last = -turn / arm.imag + 0j  # the support at the top pushes along only
            return np.array([last - force[0] - force[1], last - force[1], last])
        other, back = points[2] - points[3], _cross(points[3], force[2]) - moment[2]
        third = (turn * other - back * arm) / _cross(arm, other)
        return np.array([third - force[0] - force[1], third - force[1], third, third + force[2]])

    def _normal_forces(self, configuration: Configuration, reactions: ComplexArray) -> FloatArray:
        """N of each joint [hinges, n] [N], 0 where it is rigid."""
        forces = np.zeros(reactions.shape)
        for i, ((face, _), joint) in enumerate(zip(self.pairs, self.joints, strict=True)):
            if joint is None:
                continue
            if len(self.chain.blocks) == i == 2:
                forces[i] = -sum(upward(load) for load in self.at_top)
                continue
            normal = self.normal[i] * (1.0 if face is None else configuration.turn[face])
            away = -1.0 if i > 1 else 1.0  # beyond the middle of the chain the pressing block comes before its face
            forces[i] = away * (np.conj(normal) * reactions[i]).real
        return forces

    def _holding(
        self, configuration: Configuration, points: ComplexArray, loads: Iterable[Load], *, blocks: bool = False
    ) -> FloatArray:
        """The clockwise moment that holds the leading block against loads, and the weights of the blocks [n] [N m]."""
        force, moment = self._loads(configuration, points, loads, blocks=blocks)
        reactions = self._reactions(points, force, moment)
        passed_on = _cross(points[1], reactions[1]) if len(force) > 1 else 0.0
        return np.asarray(_cross(points[0], reactions[0]) + moment[0] - passed_on, dtype=np.float64)

    # ------------------------------------------------------------------------------------------------ virtual work

    def _points(self, found: JointEquilibrium, what: Literal["resultant", "instantaneous_centre"]) -> ComplexArray:
        """Where each hinge is for this purpose [hinges, n]."""
        return found.configuration.corner + _each(found.contacts, what, found.closure.shape) * self._faces(
            found.configuration
        )

    def _marks(self, found: JointEquilibrium) -> ComplexArray:
        """Where the resultant of each joint presses on the block, which the thesis takes for the hinge (6.51)."""
        configuration = found.configuration
        pressing = self.inward[:, None] * configuration.turn[[block for _, block in self.pairs]]
        return np.asarray(configuration.corner + _each(found.contacts, "resultant", found.closure.shape) * pressing)

    def _field(self, points: ComplexArray) -> BlockVelocities:
        """The blocks turning about points [hinges, n], the first one at the rate 1."""
        blocks, n = len(self.chain.blocks), points.shape[1]
        rate = np.ones((1, n))
        velocity = np.zeros((1, n), dtype=np.complex128)
        if blocks > 1:
            arms = np.diff(points, axis=0)[:blocks]
            rate = np.concatenate([rate, solve_turnings(arms, -arms[0])])
            velocity = np.concatenate([velocity, np.cumsum(-1j * rate[:-1] * arms[: blocks - 1], axis=0)])
        return BlockVelocities(points[:blocks], velocity, rate)

    def _place(self, configuration: Configuration, block: int, at: complex) -> ComplexArray:
        """Where a point of a block is [n], given at rest."""
        corner = (0, 1, 3)[block]
        return np.asarray(configuration.corner[corner] + (at - self.hinges[corner]) * configuration.turn[block])

    def _force(self, load: Load, here: ComplexArray) -> ComplexArray:
        """The force of a load where it is now [n] [N]."""
        if isinstance(load, PointMass):
            return np.full_like(here, -1j * g * load.mass * load.bearing)
        if isinstance(load, Force):
            return np.full_like(here, complex(*load.force))
        if load in self.slack:
            return np.zeros_like(here)
        if load.anchor is None:
            return np.full_like(here, complex(*pull_at_rest(load)))
        towards = complex(*load.anchor) - here
        return load.tension * towards / np.abs(towards)

    def _work(self, found: JointEquilibrium, moving: BlockVelocities) -> Work:
        """The sums: what holds weights and forces, and the masses in the field of the true motion."""
        configuration, points = found.configuration, self._points(found, "resultant")
        inertia, excitation, participation, lift = np.zeros((4, points.shape[1]))
        bodies = [(b.mass, complex(*b.centroid), True, b.inertia, k) for k, b in enumerate(self.chain.blocks)]
        masses = [load for load in self.chain.loads if isinstance(load, PointMass)]
        bodies += [(load.mass, complex(*load.at), load.bearing, 0.0, load.block) for load in masses]
        for mass, at, bearing, turned, number in bodies:
            v = moving.at(number, self._place(configuration, number, at))
            excitation += mass * v.real
            participation += mass * v.real**2
            inertia += mass * (v.real**2 + bearing * v.imag**2) + turned * moving.rate[number] ** 2
            lift += mass * bearing * v.imag
        weight = self._holding(configuration, points, masses, blocks=True)
        return Work(
            inertia, weight, -self._holding(configuration, points, self.actions), excitation, participation, lift
        )


def _cross(a: ComplexArray, b: ComplexArray) -> FloatArray:
    """Moment about the origin of forces b at places a, anticlockwise [n]."""
    return np.asarray((np.conj(a) * b).imag)


def _memory(residual: FloatArray, before: FloatArray) -> FloatArray:
    """How much of the last step to take back, for each rotation [n]: what makes the residual [2, hinges, n] least."""
    step = residual - before
    square = np.sum(step * step, axis=(0, 1))
    share = np.sum(residual * step, axis=(0, 1)) / np.where(square > 0.0, square, 1.0)
    return np.asarray(share, dtype=np.float64)


def top_loads(chain: Chain) -> tuple[Load, ...]:
    """Loads that stand at the hinge at the top of a wall of two blocks, and so come through its joint."""
    x, z = chain.hinges[2]
    near = AT_HINGE * (z - chain.hinges[0][1])
    return tuple(load for load in chain.loads if load.block == 1 and hypot(load.at[0] - x, load.at[1] - z) <= near)


def _each(contacts: Contacts, name: str, shape: tuple[int, ...]) -> FloatArray:
    """One of the arrays of every contact [hinges, n]; zeros where a joint is rigid."""
    return np.array([np.zeros(shape[1]) if found is None else getattr(found, name) for found in contacts])


def _fixed_shift(joint: Joint, force: float, *, where: str) -> float:
    """Where the hinge of a joint is taken to be fixed, inside its edge [m]."""
    if joint.model == "rigid":
        found = contact(joint.section, joint.law, normal_force=force, rotation=PLASTIC, where=where)
        return float(found.resultant[0])
    return semi_flexible_shift(joint.section, joint.law, normal_force=force, where=where)
