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

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from math import hypot
from typing import Literal

import numpy as np

from assess.errors import MechanismError
from assess.interfaces.contact import Contact, contact, semi_flexible_shift
from assess.loads.load import Force, Load, PointMass, Tie, length_to_anchor, pull_at_rest, upward
from assess.mechanisms.chain import (
    FACING_BLOCKS,
    Chain,
    FacingBlocks,
    Joint,
    Work,
    close_loop,
    cross,
    generalised_moment,
    hinge_names,
    move,
    solve_block_rates,
    top_loads,
    trace_point,
    virtual_work,
)
from assess.short_repr import ShortRepr
from spectra.arrays import ComplexArray, FloatArray
from spectra.gravity import g

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

    def at_point(self, block: int, point: ComplexArray) -> ComplexArray:
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
        holding = [
            _holding_moment(self.jointed, found.configuration, points, [action]) for action in self.chain.actions
        ]
        return -np.array(holding).reshape(-1, rotation.size)

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
        near = _contacts_of(self.jointed, self.jointed.configuration(rotation, np.zeros(shape)), normal)
        return solve_joint_equilibrium(self.jointed, rotation, self.rest, contact_arrays(near, "resultant", shape))

    def _points(self, found: JointEquilibrium, what: Literal["resultant", "instantaneous_centre"]) -> ComplexArray:
        """Return the resultants or the instantaneous centres of all joints [hinges, n]."""
        return found.configuration.corner + contact_arrays(
            found.contacts, what, found.closure.shape
        ) * self.jointed.faces(found.configuration)

    def _marks(self, found: JointEquilibrium) -> ComplexArray:
        """Return where each resultant presses on its block, which the thesis takes for the hinge (6.51) [hinges, n]."""
        configuration = found.configuration
        pressing = self.jointed.inward[:, None] * configuration.turn[[block for _, block in self.jointed.pairs]]
        return np.asarray(
            configuration.corner + contact_arrays(found.contacts, "resultant", found.closure.shape) * pressing
        )

    def _field(self, points: ComplexArray) -> BlockVelocities:
        """Return the velocities of the blocks rotating about points [hinges, n], the first one at the rate 1."""
        blocks, n = len(self.chain.blocks), points.shape[1]
        rate = np.ones((1, n))
        velocity = np.zeros((1, n), dtype=np.complex128)
        if blocks > 1:
            arms = np.diff(points, axis=0)[:blocks]
            rate = np.concatenate([rate, solve_block_rates(arms, -arms[0])])
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
            v = moving.at_point(number, self.jointed.place(configuration, number, at))
            excitation += mass * v.real
            participation += mass * v.real**2
            inertia += mass * (v.real**2 + bearing * v.imag**2) + turned * moving.rate[number] ** 2
            lift += mass * bearing * v.imag
        weight = _holding_moment(self.jointed, configuration, points, masses, blocks=True)
        return Work(
            inertia,
            weight,
            -_holding_moment(self.jointed, configuration, points, self.chain.actions),
            excitation,
            participation,
            lift,
        )


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
    def pairs(self) -> tuple[FacingBlocks, ...]:
        """For each hinge the block that holds the face and the one that presses."""
        return FACING_BLOCKS[len(self.chain.blocks)]

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
    def places(self) -> list[str]:
        """What errors call each joint."""
        return [f'mechanism "{self.name}": interface {hinge_name}' for hinge_name in hinge_names(self.chain)]

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
        facing = [level if face is None else configuration.turn[face] for face, _ in self.pairs]
        return np.asarray(self.inward[:, None] * np.array(facing) * np.cos(self.relative(configuration)))

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


Contacts = tuple[Contact | None, ...]
ROUNDS = 60
CONVERGED = 1e-13  # of the size of the chain: a smaller change from round to round is convergence
STALLED = 1e-9  # of the size: so is a change below this that no longer decreases
ROUGH = 1e-7  # of the size: and a change below this after all rounds, by rounding, as in very stiff joints at rest
OPENING = 1e-9  # rad: a joint that rotates back by more would open at its hinge
LEVEL = 1e-15  # rad: a smaller rotation of a joint is rounding


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


def solve_joint_equilibrium(
    jointed: JointedChain, rotation: FloatArray, rest: FloatArray, near: FloatArray
) -> JointEquilibrium:
    """Solve the equilibrium of all joints by fixed-point iteration.

    It converges because the closure of one joint moves the others by little. From the second round on the step is
    corrected by the last two changes (Anderson 1965, with one step of memory).

    Parameters
    ----------
    jointed : the chain
    rotation : of its leading block [n] [rad]
    rest : closures at rest, from which sinking counts; nothing has sunk at rotation 0 [hinges] [m]
    near : first guess of the resultants [hinges, n] [m]

    Raises
    ------
    MechanismError : no equilibrium, or a joint that would open at its hinge
    """
    shape = (len(jointed.joints), rotation.size)
    now, before, change, last = np.array([np.zeros(shape), near]), None, np.inf, np.inf
    for _ in range(ROUNDS):
        configuration = jointed.configuration(rotation, now[0])
        points = configuration.corner + now[1] * jointed.faces(configuration)
        loads = block_forces(jointed, configuration, points, jointed.chain.loads)
        normal = _normal_forces(jointed, configuration, hinge_reactions(points, *loads))
        contacts = _contacts_of(jointed, configuration, normal)
        closure = contact_arrays(contacts, "closure", shape)
        found = np.array([(closure - rest[:, None]) * (rotation > 0.0), contact_arrays(contacts, "resultant", shape)])
        residual = found - now
        change = float(np.abs(residual).max())
        if change <= CONVERGED * jointed.size or (change <= STALLED * jointed.size and change >= last):
            _require_open(jointed, configuration)
            return JointEquilibrium(configuration, normal, contacts, closure)
        last, after = change, (found, residual)
        now = found if before is None else found - _anderson_share(residual, before[1]) * (found - before[0])
        before = after
    if change <= ROUGH * jointed.size:
        _require_open(jointed, configuration)
        return JointEquilibrium(configuration, normal, contacts, closure)
    raise MechanismError(
        f'mechanism "{jointed.name}": its joints find no equilibrium (they still move by {last:.2g} m); check their '
        "stiffness and strength"
    )


def contact_arrays(contacts: Contacts, name: str, shape: tuple[int, ...]) -> FloatArray:
    """Return one array of every contact.

    Parameters
    ----------
    contacts : of the joints; None for a rigid one
    name : of the array
    shape : of the result, [hinges, n]

    Returns
    -------
    Zeros for a rigid joint.
    """
    return np.array([np.zeros(shape[1]) if found is None else getattr(found, name) for found in contacts])


def block_forces(
    jointed: JointedChain,
    configuration: Configuration,
    points: ComplexArray,
    loads: Iterable[Load],
    *,
    blocks: bool = True,
) -> tuple[ComplexArray, FloatArray]:
    """Return the force on each block and its moment about the origin, anticlockwise [blocks, n] [N, N m].

    Parameters
    ----------
    jointed, configuration : the chain and its configuration
    points : of the resultants at the hinges [hinges, n] [m]
    loads : to include
    blocks : whether to include the weights of the blocks
    """
    shape = (len(jointed.chain.blocks), points.shape[1])
    force, moment = np.zeros(shape, dtype=np.complex128), np.zeros(shape)
    for number, block in enumerate(jointed.chain.blocks if blocks else ()):
        force[number] = -1j * g * block.mass
        moment[number] = -g * block.mass * jointed.place(configuration, number, complex(*block.centroid)).real
    for load in loads:
        here = points[2] if load in jointed.at_top else jointed.place(configuration, load.block, complex(*load.at))
        pull = load_force(jointed, load, here)
        force[load.block] += pull
        moment[load.block] += cross(here, pull)
    return force, moment


def hinge_reactions(points: ComplexArray, force: ComplexArray, moment: FloatArray) -> ComplexArray:
    """Return the force of each hinge on the chain beyond it [hinges, n] [N]; a moment holds the leading block.

    Every block k is in equilibrium: P_k - P_(k+1) + F_k = 0, and likewise its moments, but for the leading block.

    Parameters
    ----------
    points : of the resultants at the hinges [hinges, n] [m]
    force, moment : on each block, about the origin [blocks, n] [N, N m]
    """
    if len(force) == 1:
        return -force
    arm, turn = points[1] - points[2], cross(points[1], force[1]) - moment[1]
    if len(force) == 2:
        last = -turn / arm.imag + 0j  # the support at the top has no vertical reaction
        return np.array([last - force[0] - force[1], last - force[1], last])
    other, back = points[2] - points[3], cross(points[3], force[2]) - moment[2]
    third = (turn * other - back * arm) / cross(arm, other)
    return np.array([third - force[0] - force[1], third - force[1], third, third + force[2]])


def load_force(jointed: JointedChain, load: Load, here: ComplexArray) -> ComplexArray:
    """Return the force of a load.

    Parameters
    ----------
    jointed : the chain that carries it
    load : a mass, force or tie
    here : its point now [n] [m]

    Returns
    -------
    ComplexArray
        [n] [N]
    """
    if isinstance(load, PointMass):
        return np.full_like(here, -1j * g * load.mass * load.bearing)
    if isinstance(load, Force):
        return np.full_like(here, complex(*load.force))
    if load in jointed.slack:
        return np.zeros_like(here)
    if load.anchor is None:
        return np.full_like(here, complex(*pull_at_rest(load)))
    towards = complex(*load.anchor) - here
    return load.tension * towards / length_to_anchor(load, towards.real, towards.imag)


def _fixed_shift(joint: Joint, force: float, *, where: str) -> float:
    """Return the distance of the fixed hinge of a joint from its edge [m]."""
    if joint.model == "rigid":
        found = contact(joint.section, joint.law, normal_force=force, rotation=PLASTIC, where=where)
        return float(found.resultant[0])
    return semi_flexible_shift(joint.section, joint.law, normal_force=force, where=where)


def _contacts_of(jointed: JointedChain, configuration: Configuration, normal: FloatArray) -> Contacts:
    """Return the contact of each joint under its normal force [hinges, n] [N]."""
    psi = jointed.relative(configuration)
    found: list[Contact | None] = []
    for joint, force, turned, where in zip(jointed.joints, normal, psi, jointed.places, strict=True):
        if joint is None:
            found.append(None)
            continue
        slope = np.sin(np.clip(turned, 0.0, np.pi / 2)) * (turned > LEVEL)
        found.append(contact(joint.section, joint.law, normal_force=force, rotation=slope, where=where))
    return tuple(found)


def _require_open(jointed: JointedChain, configuration: Configuration) -> None:
    """Raise MechanismError if a joint would open at its hinge."""
    for joint, turned, where in zip(jointed.joints, jointed.relative(configuration), jointed.places, strict=True):
        if joint and turned.min() < -OPENING:
            raise MechanismError(
                f"{where}: its faces turn by {-turned.min():.3g} rad away from the hinge, which would open there; "
                "put the hinge at the other face"
            )


def _anderson_share(residual: FloatArray, before: FloatArray) -> FloatArray:
    """Return the share of the last step to take back at each rotation [n], for the least residual [2, hinges, n]."""
    step = residual - before
    square = np.sum(step * step, axis=(0, 1))
    share = np.sum(residual * step, axis=(0, 1)) / np.where(square > 0.0, square, 1.0)
    return np.asarray(share, dtype=np.float64)


def _normal_forces(jointed: JointedChain, configuration: Configuration, reactions: ComplexArray) -> FloatArray:
    """Return the normal force of each joint [hinges, n] [N], 0 for a rigid one."""
    forces = np.zeros(reactions.shape)
    for i, ((face, _), joint) in enumerate(zip(jointed.pairs, jointed.joints, strict=True)):
        if joint is None:
            continue
        if len(jointed.chain.blocks) == i == 2:
            forces[i] = -sum(upward(load) for load in jointed.at_top)
            continue
        normal = jointed.normal[i] * (1.0 if face is None else configuration.turn[face])
        away = -1.0 if i > 1 else 1.0  # beyond the middle of the chain the pressing block comes before its face
        forces[i] = away * (np.conj(normal) * reactions[i]).real
    return forces


def _holding_moment(
    jointed: JointedChain,
    configuration: Configuration,
    points: ComplexArray,
    loads: Iterable[Load],
    *,
    blocks: bool = False,
) -> FloatArray:
    """Return the clockwise moment that holds the leading block against loads [n] [N m].

    Parameters
    ----------
    jointed, configuration : the chain and its configuration
    points : of the resultants at the hinges [hinges, n] [m]
    loads : to include
    blocks : whether to include the weights of the blocks
    """
    force, moment = block_forces(jointed, configuration, points, loads, blocks=blocks)
    reactions = hinge_reactions(points, force, moment)
    passed_on = cross(points[1], reactions[1]) if len(force) > 1 else 0.0
    return np.asarray(cross(points[0], reactions[0]) + moment[0] - passed_on, dtype=np.float64)
