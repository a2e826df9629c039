"""The waist of the program: every mechanism is one rocking oscillator of one degree of freedom.

    I(phi) phi'' + 1/2 I'(phi) phi'^2 + restoring(phi) = -B(phi) u_g''          restoring = dV/dphi - M(phi)

phi [rad] is the rotation of the leading block. A `Branch` tabulates one direction of rotation in its own mirrored
sign (rotation >= 0, restoring > 0 resists, excitation > 0); an `Oscillator` is one or two of them. Geometry and
mechanisms, which make it, know nothing of codes; dynamics and codes, which use it, know nothing of blocks or meshes.

Beside it pass the rotations at which ties and forces end and floors lose their seats, the side walls toothed into a
block, and the forces at the hinges when the mechanism starts to rock, with the friction that they need. H along the
branch's own direction and V up act on the block that presses at a hinge; with n square to the faces there,

    N = H n_x + V n_z        T = H n_z - V n_x        friction needed: |T| / N

Below the acceleration at which the mechanism starts to rock, N and T of a single block are linear in the acceleration.
A chain of blocks is then statically indeterminate: N is taken as when it starts to rock, and T as growing in proportion
to the acceleration.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import inf
from typing import TYPE_CHECKING, Literal

import numpy as np

from assess.errors import MechanismError
from assess.messages.message import Message, Term
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray
from spectra.gravity import g

if TYPE_CHECKING:
    from scipy.interpolate import PPoly

BranchName = Literal["positive", "negative"]
BRANCH_NAMES: tuple[BranchName, BranchName] = ("positive", "negative")


@dataclass(frozen=True, eq=False, repr=False)
class Branch:
    """One direction of rocking, tabulated over rotation; between nodes the table is a cubic spline.

    Compared by identity: its splines are made once.

    rotation : phi, from 0, not decreasing; a jump is two nodes at one rotation [n] [rad]
    inertia : I = sum m (x'^2 + z'^2) + J theta'^2 [n] [kg m2]
    restoring : dV/dphi - M [n] [N m]
    excitation : B = sum m x' over all masses that shake [n] [kg m]
    participation : sum m x'^2 [n] [kg m2]
    lift : C = sum m z' [n] [kg m]
    restitution : |velocity after| / |velocity before| of the impact that ends this branch [-]
    overturning : phi_ov, rigid: the first rotation > 0 where restoring goes from + to - [rad]
    critical : phi_cr, about which the equation is linearised: dV/dphi = 0 [rad]
    overturning_flexible : phi_ov on the interfaces in use [rad]; None if they are rigid
    """

    rotation: FloatArray
    inertia: FloatArray
    restoring: FloatArray
    excitation: FloatArray
    participation: FloatArray
    lift: FloatArray
    restitution: float
    overturning: float
    critical: float
    overturning_flexible: float | None = None

    def __repr__(self) -> str:
        return (
            f"Branch({self.rotation.size} rotations to {self.rotation[-1]:.4g} rad, "
            f"overturning={self.unstable:.4g} rad, restitution={self.restitution:.4g})"
        )

    @property
    def unstable(self) -> float:
        """Rotation at which the restoring moment of the table falls to zero [rad]."""
        return self.overturning if self.overturning_flexible is None else self.overturning_flexible

    @cached_property
    def restoring_spline(self) -> PPoly:
        """Restoring moment [N m] over rotation [rad]."""
        return interpolant(self.rotation, self.restoring)

    @cached_property
    def excitation_spline(self) -> PPoly:
        """Excitation B [kg m] over rotation [rad]."""
        return interpolant(self.rotation, self.excitation)

    @cached_property
    def inertia_spline(self) -> PPoly:
        """Inertia I [kg m2] over rotation [rad]."""
        return interpolant(self.rotation, self.inertia)

    @cached_property
    def energy_spline(self) -> PPoly:
        """Work stored from rest [J] over rotation [rad]: the integral of the restoring moment."""
        return self.restoring_spline.antiderivative()

    @cached_property
    def excitation_integral(self) -> PPoly:
        """Integral of B dphi from rest [kg m] over rotation [rad]."""
        return self.excitation_spline.antiderivative()

    @cached_property
    def linearised(self) -> Linearised:
        """The branch linearised about phi_cr, the unstable equilibrium of the weights (thesis 3.3-3.7).

        At phi_cr dV/dphi = 0, so there restoring = -M, and K = M' - V'' = -restoring'.
        """
        at = self.critical
        columns = interpolant(self.rotation, np.stack([self.inertia, self.excitation, self.restoring], axis=1))
        inertia, excitation, restoring = columns(at)
        return Linearised(
            inertia=float(inertia),
            stiffness=-float(columns(at, 1)[2]),
            excitation=float(excitation),
            moment=-float(restoring),
            critical=at,
            restitution=self.restitution,
        )


@dataclass(frozen=True, repr=False)
class TieLaw(ShortRepr):
    """A tie on an oscillator.

    stiffness : k, of bar and anchorage [N/m]
    strength : force at yield [N]
    gone : elongation at which it breaks or its anchor fails [m]; below strength / stiffness it never yields
    elongation, rate : e [m] and de/dphi [m] at the rotations of each branch, at rest what its pretension gives;
        the positive branch first [branches][n]
    """

    stiffness: float
    strength: float
    gone: float
    elongation: tuple[FloatArray, ...]
    rate: tuple[FloatArray, ...]

    def __post_init__(self) -> None:
        """Refuse what is no tie, or one that shortens again after it has yielded."""
        for name in ("stiffness", "strength"):
            if not 0.0 < getattr(self, name) < inf:
                raise MechanismError(f"a tie has {name} {getattr(self, name):.6g}; it must be positive and finite")
        for e, rate in zip(self.elongation, self.rate, strict=True):
            if (rate[e > self.strength / self.stiffness] <= 0.0).any():
                raise MechanismError(
                    "a tie yields and then shortens again before the mechanism overturns, which histories do not "
                    "follow: look at its anchor"
                )

    @property
    def energy_at_rest(self) -> float:
        """What it holds by its pretension [J]."""
        return self.stiffness * max(float(self.elongation[0][0]), 0.0) ** 2 / 2


@dataclass(frozen=True, repr=False)
class Memory(ShortRepr):
    """What an oscillator without memory lacks: its motion depends on how far it has rocked.

    bare : the oscillator without ties that stretch and without friction
    ties : on it
    friction : moment of the side walls as the mechanism opens, at the rotations of each branch [branches][n] [N m];
        empty if there is none
    """

    bare: Oscillator
    ties: tuple[TieLaw, ...] = ()
    friction: tuple[FloatArray, ...] = ()


@dataclass(frozen=True, repr=False)
class Oscillator:
    """A mechanism as the dynamics and the codes see it.

    positive, negative : the branches; negative is None for one-sided rocking, and the positive one if both are equal
    mass : total moved mass, bearing or not [kg]
    equilibrium, equilibrium_negative : phi_e, the rotation at rest from which each branch counts, in its own sign
        [rad]; not zero if a flexible joint carries an eccentric load
    memory : of ties that stretch, whose tables are those of the first way out; None without any
    """

    positive: Branch
    negative: Branch | None
    mass: float
    equilibrium: float = 0.0
    equilibrium_negative: float = 0.0
    memory: Memory | None = None

    def __repr__(self) -> str:
        sides = "one-sided" if self.negative is None else "two-sided"
        with np.errstate(all="ignore"):
            return (
                f"Oscillator(p={self.p:.4g} 1/s, slenderness={self.slenderness:.4g} rad, {sides}, {self.mass:.4g} kg)"
            )

    @property
    def p(self) -> float:
        """Frequency parameter p_eq of the positive branch, linearised [1/s]."""
        return self.positive.linearised.p

    @property
    def slenderness(self) -> float:
        """Slenderness of the equivalent single block of the positive branch [rad].

        At rest, or at phi_cr on flexible joints, which carry no moment at rest.
        """
        rotation = 0.0 if threshold(self.positive) is not None else self.positive.critical
        return block_at(self.positive, rotation, mass=self.mass).slenderness

    @property
    def multiplier(self) -> float | None:
        """Acceleration in g that starts the positive branch, lambda at rest [-]; None without a threshold of uplift."""
        return threshold(self.positive)

    @property
    def branches(self) -> tuple[Branch, ...]:
        """The positive and, if rocking is two-sided, the negative branch."""
        return (self.positive,) if self.negative is None else (self.positive, self.negative)

    @property
    def equilibria(self) -> tuple[float, float]:
        """The rotations at rest from which the positive and the negative branch count [rad]."""
        return self.equilibrium, self.equilibrium_negative

    @property
    def bare(self) -> Oscillator:
        """The oscillator to whose overturning rotations the ratios of its histories refer: without what remembers."""
        return self if self.memory is None else self.memory.bare

    @property
    def symmetric(self) -> bool:
        """Whether both directions share one branch, so that a reversed motion gives the mirrored response."""
        return self.negative is self.positive


@dataclass(frozen=True)
class Linearised:
    """The branch linearised about phi_cr (thesis 3.3-3.12): phi'' = p^2 (phi - overturning) - (B / I) u_g''.

    inertia I [kg m2], stiffness K [N m/rad], excitation B [kg m], moment M [N m] of the given forces,
    critical phi_cr [rad], restitution [-].
    """

    inertia: float
    stiffness: float
    excitation: float
    moment: float
    critical: float
    restitution: float

    @property
    def p(self) -> float:
        """Frequency parameter p_eq = sqrt(K / I) [1/s] (thesis 3.10)."""
        return float(np.sqrt(self.stiffness / self.inertia))

    @property
    def overturning(self) -> float:
        """phi_ov = phi_cr - M / K [rad] (thesis 3.12)."""
        return self.critical - self.moment / self.stiffness

    @property
    def multiplier(self) -> float:
        """lambda = (K phi_cr - M) / (g B), the acceleration in g that starts the linearised motion (thesis 3.11)."""
        return self.stiffness * self.overturning / (g * self.excitation)


@dataclass(frozen=True)
class RockingBlock:
    """The plain block equivalent to the mechanism at rest.

    mass M [kg], radius R [m], slenderness alpha [rad], inertia I_O about the hinge [kg m2].
    """

    mass: float
    radius: float
    slenderness: float
    inertia: float


def interpolant(rotation: FloatArray, values: FloatArray) -> PPoly:
    """Return the piecewise cubic through values over rotation: one not-a-knot spline between jumps.

    A piece of two nodes is a line, of three a parabola. Jumps (two nodes at one rotation) keep an empty interval, so
    that interval i of the result always lies between nodes i and i + 1.

    Parameters
    ----------
    rotation : not decreasing [n] [rad]
    values : at the nodes [n, …]
    """
    from scipy.interpolate import CubicSpline, PPoly  # late: to read a project or results needs none

    coefficients = np.zeros((4, rotation.size - 1, *values.shape[1:]))
    ends = [0, *(np.flatnonzero(np.diff(rotation) == 0.0) + 1).tolist(), rotation.size]
    for first, last in pairwise(ends):
        x, y = rotation[first:last], values[first:last]
        if x.size == 3:  # by its width: scipy solves a parabola by equations that a narrow one makes ill-conditioned
            width = x[-1] - x[0]
            powers = (width ** np.arange(-3.0, 1.0)).reshape(4, *[1] * y.ndim)
            coefficients[:, first : last - 1] = CubicSpline((x - x[0]) / width, y).c * powers
        elif x.size > 1:
            coefficients[:, first : last - 1] = CubicSpline(x, y).c
    return PPoly.construct_fast(coefficients, rotation)


def restoring_moment(branch: Branch, rotation: FloatArray) -> FloatArray:
    """Return the restoring moment [N m].

    Parameters
    ----------
    branch : one direction of rocking
    rotation : of any shape [rad]
    """
    return np.asarray(branch.restoring_spline(rotation), dtype=np.float64)


def energy(branch: Branch, rotation: FloatArray) -> FloatArray:
    """Return the work stored from rest: the integral of the restoring moment [J].

    Parameters
    ----------
    branch : one direction of rocking
    rotation : of any shape [rad]
    """
    return np.asarray(branch.energy_spline(rotation), dtype=np.float64)


def displacement(branch: Branch, rotation: FloatArray, *, mass: float) -> FloatArray:
    """Return the displacement of the control point, the centre of all participating masses [m].

    It is (integral of B dphi) / mass.

    Parameters
    ----------
    branch : one direction of rocking
    rotation : of any shape [rad]
    mass : total moved mass [kg]
    """
    return np.asarray(branch.excitation_integral(rotation), dtype=np.float64) / mass


def multiplier(branch: Branch) -> FloatArray:
    """Return lambda(phi) = restoring / (g B) at the nodes [n]: the acceleration in g in equilibrium there."""
    return branch.restoring / (g * branch.excitation)


def threshold(branch: Branch) -> float | None:
    """Return lambda at rest, the uplift multiplier [-]; None without a threshold, as on joints that deform at once."""
    at_rest = float(multiplier(branch)[0])
    return at_rest if at_rest > 0.0 else None


def linear_multiplier(branch: Branch) -> float:
    """Return lambda for linear checks [-]: at rest, or on flexible joints, where it may rise, the largest."""
    if branch.overturning_flexible is None:
        return float(multiplier(branch)[0])
    return float(multiplier(branch)[branch.rotation <= branch.unstable].max())


def elastic_frequency(branch: Branch) -> float | None:
    """Return the frequency of small motions about rest [Hz]; None if there is a threshold of uplift."""
    if threshold(branch) is not None:
        return None
    stiffness = float(branch.restoring_spline(0.0, 1))
    return float(np.sqrt(max(stiffness, 0.0) / branch.inertia[0]) / (2 * np.pi))


def participating_mass(branch: Branch) -> FloatArray:
    """Return M* = B^2 / sum m x'^2 at the nodes [n] [kg]."""
    return branch.excitation**2 / branch.participation


def participation_ratio(branch: Branch, *, mass: float) -> float:
    """Return e* = M* / mass at rest [-]; 1 for a plain block.

    Parameters
    ----------
    branch : one direction of rocking
    mass : total moved mass [kg]
    """
    return float(participating_mass(branch)[0] / mass)


def equivalent_block(branch: Branch, *, mass: float) -> RockingBlock:
    """Return the single block with the mass, restoring moment, excitation and inertia of the mechanism at rest.

    Parameters
    ----------
    branch : one direction of rocking
    mass : total moved mass [kg]
    """
    height, half_width = branch.excitation[0] / mass, branch.restoring[0] / (mass * g)
    radius, slenderness = float(np.hypot(height, half_width)), float(np.arctan2(half_width, height))
    return RockingBlock(mass, radius, slenderness, float(branch.inertia[0]))


def block_at(branch: Branch, rotation: float, *, mass: float) -> RockingBlock:
    """Return the single block with the restoring moment, excitation and inertia of the mechanism at a rotation.

    For a plain block it is the same at every rotation; on a flexible joint it is thesis 6.50-6.52.

    Parameters
    ----------
    branch : one direction of rocking
    rotation : [rad]
    mass : total moved mass [kg]
    """
    R, B = float(branch.restoring_spline(rotation)), float(branch.excitation_spline(rotation))
    inertia = float(branch.inertia_spline(rotation))
    return RockingBlock(mass, float(np.hypot(R / g, B)) / mass, rotation + float(np.arctan2(R / g, B)), inertia)


def plain_branch(block: RockingBlock, *, restitution: float, end: float = 1.5) -> Branch:
    """Tabulate a plain block.

    Parameters
    ----------
    block : its mass, radius, slenderness and inertia
    restitution : of the impact that ends the branch [-]
    end : of the table, as a multiple of the slenderness [-]
    """
    M, R, alpha = block.mass, block.radius, block.slenderness
    phi = np.linspace(0.0, end * alpha, 257)
    up, along = M * R * np.sin(alpha - phi), M * R * np.cos(alpha - phi)
    return Branch(
        rotation=phi,
        inertia=np.full_like(phi, block.inertia),
        restoring=g * up,
        excitation=along,
        participation=along**2 / M,
        lift=up,
        restitution=restitution,
        overturning=alpha,
        critical=alpha,
    )


Vector = tuple[float, float]


@dataclass(frozen=True)
class LocalLimit:
    """A rotation of one branch at which a tie or force ends ("break") or a floor or beam loses its seat ("seat") [rad].

    what : the load, by its name; rotation : counted as the table of the branch
    """

    kind: Literal["break", "seat"]
    what: str
    branch: BranchName
    rotation: float


@dataclass(frozen=True)
class OpenSeat:
    """A floor or beam that rests on the mechanism on a seat whose length is not given, in one branch.

    what : the load, by its name
    rotation, travel : of the branch, counted as its table [rad], and how far its point has then moved on the seat [m],
        both [n]
    """

    what: str
    branch: BranchName
    rotation: FloatArray
    travel: FloatArray


@dataclass(frozen=True, repr=False)
class Toothing(ShortRepr):
    """Side walls toothed into the back of a single block, and what of it may turn with them.

    walls : how many; course, overlap, thickness : h_b, l, t_s [m]; density [kg/m3]; friction : mu [-]
    height : of what turns, measured down from where the side walls end, rising to that of the block itself [n] [m]
    restoring : of its weights and loads at rest, about its front edge [n] [N m]
    excitation : B of it at rest [n] [kg m]
    depth : from its front edge to the side walls [n] [m]
    """

    walls: int
    course: float
    overlap: float
    thickness: float
    density: float
    friction: float
    height: FloatArray
    restoring: FloatArray
    excitation: FloatArray
    depth: FloatArray


@dataclass(frozen=True)
class Pressure:
    """The force on the block that presses, square to the faces (compression > 0) and along them [N]."""

    normal: float
    shear: float


@dataclass(frozen=True)
class HingeForces:
    """One hinge of one branch when the mechanism starts to rock.

    hinge : its letter, with a prime on the negative branch; single : whether it is that of a single block
    horizontal, vertical : force on the block that presses, along the branch's own direction and up [N]
    face : unit vector (x, z) square to the faces, to the block that presses; found : on the geometry, else taken level
    starting, resting : square to the faces and along them, when it starts to rock and without any acceleration
    acceleration : of the ground at which it starts to rock [m/s2]
    friction : coefficient [-], None where it is not known; remedy : the input that would give it
    held : whether a support holds it besides friction, as it does the top of a wall
    """

    hinge: str
    branch: BranchName
    single: bool
    horizontal: float
    vertical: float
    face: Vector
    found: bool
    starting: Pressure
    resting: Pressure
    acceleration: float
    friction: float | None
    remedy: Term | Message
    held: bool

    @property
    def required_friction(self) -> float | None:
        """The coefficient of friction below which it slides before it rocks [-]; None where it lifts."""
        return required_friction(self.starting)

    def pressure_at(self, acceleration: float) -> Pressure:
        """Return the force at an acceleration of the ground [m/s2]; beyond incipient motion it does not change."""
        share = min(acceleration / self.acceleration, 1.0)
        low, high = self.resting, self.starting
        return Pressure(
            low.normal + share * (high.normal - low.normal),
            low.shear + share * (high.shear - low.shear),
        )

    def mobilised_friction(self, acceleration: float) -> float | None:
        """Return the friction coefficient needed up to an acceleration of the ground [m/s2]; None where it lifts.

        |T| / N of two linear functions is largest at an end.
        """
        ends = [required_friction(self.resting), required_friction(self.pressure_at(acceleration))]
        known = [each for each in ends if each is not None]
        return max(known) if len(known) == len(ends) else None

    @property
    def sliding_acceleration(self) -> float | None:
        """The ground acceleration at which |T| = mu N [m/s2]; None where that is not before it starts to rock."""
        if self.friction is None:
            return None
        reached = [share for side in (1.0, -1.0) if (share := self._share(side, self.friction)) is not None]
        return min(reached) * self.acceleration if reached else None

    def _share(self, side: float, mu: float) -> float | None:
        """Return the share of the acceleration at which `side` T = mu N; 0 if it slides at rest, None if never."""
        first, last = (side * each.shear - mu * each.normal for each in (self.resting, self.starting))
        if first > 0.0:
            return 0.0
        return -first / (last - first) if last > 0.0 else None


def required_friction(pressure: Pressure) -> float | None:
    """Return |T| / N [-]; None where nothing presses."""
    return abs(pressure.shear) / pressure.normal if pressure.normal > 0.0 else None
