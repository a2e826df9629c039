"""The joint that a hinge presses on, and the contact of its faces: resultant, open and crushed depth.

A joint has no tension, is linear up to its strength and plastic beyond. One solver serves every section and regime
(full or partial contact, elastic or crushed); thesis 6.2-6.45 are its special cases. The rotation is that of one face
relative to the other and compresses the edge at depth 0; for the other sense use the section that `mirror` returns.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf, isfinite
from typing import Annotated, Literal

import numpy as np
from numpy.typing import ArrayLike

from assess.declaration import (
    UNCERTAIN,
    Evidence,
    Fault,
    Forms,
    JointStiffness,
    PositiveLength,
    Range,
    Safe,
    Strength,
    Tried,
)
from assess.errors import InterfaceError
from assess.interfaces.section import CONTACT_SIZES, ContactSection, Shape, mirror
from assess.messages.message import Message, Quantity, warning
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

JointModel = Literal["rigid", "flexible", "semi-flexible", "flexible-thesis"]
STIFFNESSES = ("0.15 GPa/m", "4 GPa/m", "100 GPa/m")
"""From a metre of the softest cracked masonry, E = 0.15 GPa, that deforms about the joint, to a stiff bed, and one
between; thesis 7.2.3 takes a metre too, and 85 MPa/m to 13.5 GPa/m on soil."""
WORST_JOINT = "the worst over rigid joints and stiffnesses from 0.15 to 100 GPa/m"
RIGID_JOINT = Tried(Safe.ABSENT, 'model = "rigid"', (("model", "rigid"),))
STIFFNESS_EVIDENCE = Evidence(
    "measured", "either", WORST_JOINT, safe=Range((*(Tried(each) for each in STIFFNESSES), RIGID_JOINT))
)
COURSE_EVIDENCE = Evidence(
    "measured",
    "either",
    WORST_JOINT,
    safe=Range((*(Tried(Safe.ABSENT, each, (("stiffness", each),)) for each in STIFFNESSES), RIGID_JOINT)),
)
MODEL_EVIDENCE = Evidence("measured", "either", '"flexible"', safe=Range((Tried("flexible"),)))
OUTLINE_OR_SIZE = Forms("outline", tuple(CONTACT_SIZES.items()))
OWN_STRENGTH = Evidence(
    "measured",
    "up",
    "the material's, 50 MPa at most",
    judged="an infinite strength is the rigid reading and stays; it helps where crushing is modelled",
    safe=Safe.ABSENT,
)


@dataclass(frozen=True, kw_only=True)
class Interface:
    """What a hinge presses on: without tension, linear up to the strength, then plastic without memory."""

    model: Annotated[JointModel, MODEL_EVIDENCE] = "rigid"
    """"rigid" (with strength: crushing only), "flexible"; with its moment, but inertia about a fixed hinge:
    "semi-flexible", about the resultant: "flexible-thesis\""""
    stiffness: Annotated[JointStiffness, UNCERTAIN, STIFFNESS_EVIDENCE] | None = None
    """normal stiffness per area, like "10 GPa/m"; or give course_thickness"""
    course_thickness: Annotated[PositiveLength, UNCERTAIN, COURSE_EVIDENCE] | None = None
    """thickness of the layer that yields: stiffness = young_modulus of the material / course_thickness"""
    strength: Annotated[Strength, UNCERTAIN, OWN_STRENGTH] | None = None
    """in compression, like "1 MPa", or "inf"; the material's if absent (not for a rigid one)"""
    shape: Annotated[
        Literal["outline"] | Shape,
        OUTLINE_OR_SIZE,
        Evidence("drawn", "up", "the outline of the mesh at the hinge", safe=Safe.ABSENT),
    ] = "outline"
    """"outline" of the mesh at the hinge, or { rectangle | hollow_rectangle | circle | annulus | polygon = … }"""

    def faults(self) -> Iterator[Fault]:
        """Yield a stiffness that is given twice, or not at all, or of a rigid joint."""
        given = [key for key in ("stiffness", "course_thickness") if getattr(self, key) is not None]
        if self.model == "rigid" and given:
            yield given[0], 'is for flexible interfaces; write model = "flexible", or remove it'
        if self.model != "rigid" and len(given) != 1:
            yield "stiffness", "give either stiffness or course_thickness"


@dataclass(frozen=True)
class JointLaw:
    """A joint without tension, linear up to its strength and plastic beyond, without memory.

    stiffness : per unit of area, k_n = E / thickness [Pa/m]; infinite: rigid
    strength : in compression, f_m [Pa]; infinite: elastic
    """

    stiffness: float = inf
    strength: float = inf


@dataclass(frozen=True, repr=False)
class Contact(ShortRepr):
    """The contact at n rotations, read-only arrays [n].

    rotation : phi [rad]; normal_force : N [N]
    resultant : distance of the resultant from the compressed edge, a_f [m]
    out_of_plane_eccentricity : distance of the resultant from the centroid along the axis of rotation, positive to the
        left of the direction of rocking [m]; zero for a section symmetric about the plane of motion
    instantaneous_centre : distance from the compressed edge of the line about which the faces turn under a constant
        force, d closure / d rotation: the centroid of the elastic zone [m]
    closure : of the compressed edge, u_e [m]
    depth : in contact, a [m]; crushed_depth : a_2 [m]
    peak_stress : at the compressed edge [Pa]; infinite for a rigid joint without limit of strength
    open_area, crushed_area : [m2]
    """

    rotation: FloatArray
    normal_force: FloatArray
    resultant: FloatArray
    out_of_plane_eccentricity: FloatArray
    instantaneous_centre: FloatArray
    closure: FloatArray
    depth: FloatArray
    crushed_depth: FloatArray
    peak_stress: FloatArray
    open_area: FloatArray
    crushed_area: FloatArray


def contact(
    section: ContactSection, law: JointLaw, *, normal_force: ArrayLike, rotation: ArrayLike, where: str = "interface"
) -> Contact:
    """Solve the contact under a normal force at given rotations.

    A rigid joint (infinite stiffness) is the limit of a stiff one: the plastic block, or the edge itself. At rest its
    resultant may be anywhere between there and the centroid; returned is the state as soon as it rotates.

    Parameters
    ----------
    section : seen in the direction in which the rotation compresses it
    law : stiffness and strength of the joint
    normal_force : compression > 0, one or [n] [N]
    rotation : not negative, one or [n] [rad]
    where : what an error names

    Raises
    ------
    InterfaceError : no compression, a force the section cannot carry, no stiffness or strength, a negative rotation
    """
    from assess.interfaces.kernel.equilibrium import touch  # brings numba

    forces, turns = (np.atleast_1d(np.asarray(each, dtype=np.float64)) for each in (normal_force, rotation))
    _require_rotation(turns, where=where)
    _require_load(section, law, forces, where=where)
    columns = np.empty((11, max(turns.size, forces.size)))
    columns[0], columns[1] = turns, forces
    found = np.empty((columns.shape[1], 9))
    touch(section.table, float(law.stiffness), float(law.strength), columns[1], columns[0], found)
    columns[2:] = found.T
    columns.setflags(write=False)
    return Contact(*columns)


def thresholds(
    section: ContactSection, law: JointLaw, *, normal_force: float, where: str = "interface"
) -> tuple[float, float]:
    """Return the rotations at which the far edge opens and the compressed edge starts to crush [rad]; inf: never.

    The strength less the stress is the stress of the mirrored section under its bearing capacity less the force. So
    opening of the one is crushing of the other, and two formulas hold for all regimes, also if crushing comes first
    (thesis 6.2-6.4 and their equivalents for other shapes are the case of opening first).

    Parameters
    ----------
    section : seen in the direction in which the rotation compresses it
    law : stiffness and strength of the joint
    normal_force : compression > 0 [N]
    where : what an error names

    Raises
    ------
    InterfaceError : as for `contact`
    """
    _require_load(section, law, np.array([float(normal_force)]), where=where)
    k, f, N = law.stiffness, law.strength, float(normal_force)
    if k == inf:
        return 0.0, 0.0 if f < inf else inf
    from assess.interfaces.kernel.equilibrium import crushing_depth

    far = section.depth - section.centroid
    opening = N / (k * section.area * far)
    if f == inf:
        return opening, inf
    if opening * k * section.depth <= f:
        return opening, f / (k * crushing_depth(section.table, N / f))
    missing = f * section.area - N
    crushing = missing / (k * section.area * section.centroid)
    return f / (k * crushing_depth(mirror(section).table, missing / f)), crushing


def semi_flexible_shift(
    section: ContactSection, law: JointLaw, *, normal_force: float, where: str = "interface"
) -> float:
    """Return the distance of the fixed hinge from the compressed edge, a_SF: of the resultant when crushing starts [m].

    It does not depend on the stiffness, and is zero for infinite strength (thesis 6.3.1.2).

    Parameters
    ----------
    section : seen in the direction in which the rotation compresses it
    law : stiffness and strength of the joint
    normal_force : compression > 0 [N]
    where : what an error names

    Raises
    ------
    InterfaceError : as for `contact`
    """
    _require_load(section, law, np.array([float(normal_force)]), where=where)
    if law.strength == inf:
        return 0.0
    any_joint = JointLaw(stiffness=law.strength / section.depth, strength=law.strength)
    _, crushing = thresholds(section, any_joint, normal_force=normal_force)
    return float(contact(section, any_joint, normal_force=normal_force, rotation=crushing).resultant[0])


def out_of_plane_warning(section: ContactSection, found: Contact, *, interface: str) -> Message | None:
    """Return a warning if the resultant leaves the plane of motion by more than a hundredth of the breadth.

    Parameters
    ----------
    section : of the joint
    found : its contact at all rotations of interest
    interface : its letter
    """
    largest = float(np.abs(found.out_of_plane_eccentricity).max())
    if largest <= 0.01 * section.breadth:
        return None
    share = Quantity(100.0 * largest / section.breadth, "percent", 2)
    away = Quantity(largest, "length", 3)
    return warning("contact-not-symmetric", interface=interface, distance=away, share=share)


def _require_rotation(turns: FloatArray, *, where: str) -> None:
    """Raise InterfaceError for a rotation that is negative or not finite."""
    wrong = turns[~(np.isfinite(turns) & (turns >= 0.0))]
    if wrong.size:
        raise InterfaceError(
            f"{where}: a rotation is {wrong[0]:g} rad; give zero or more, and the mirrored section for the other sense"
        )


def _require_load(section: ContactSection, law: JointLaw, forces: FloatArray, *, where: str) -> None:
    """Raise InterfaceError for an impossible law, or a force that the section cannot carry."""
    for what, value, unit in (("stiffness", law.stiffness, "Pa/m"), ("strength", law.strength, "Pa")):
        if not value > 0.0:
            raise InterfaceError(f"{where}: its {what} is {value:g} {unit}; give a positive number, or inf")
    wrong = forces[~(np.isfinite(forces) & (forces > 0.0))]
    if wrong.size:
        how = f", so it would have to pull with {-wrong[0]:g} N" if isfinite(wrong[0]) else ""
        raise InterfaceError(
            f"{where}: its normal force is {wrong[0]:g} N{how}; a joint without tension needs pressure"
        )
    most, bearing = float(forces.max()), section.area * law.strength
    if most >= bearing:
        raise InterfaceError(
            f"{where}: its normal force, {most:.6g} N, is {most / bearing:.4g} times what it can carry, "
            f"{bearing:.6g} N = {section.area:.4g} m2 x {law.strength:.4g} Pa; give it more strength or area"
        )
