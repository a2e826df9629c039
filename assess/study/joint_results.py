"""The joints of a mechanism in the results: the force and the contact at each hinge, and its calculation sheet.

A sheet has the force of the joint at rest, its section, the fixed hinge a_SF, and its stresses where the multiplier is
largest and at overturning. The force of the hinge C of three blocks follows from moments of two of the blocks.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import inf, isclose, isfinite
from typing import Any

import numpy as np

from assess.codes.calculation_sheet import Given, Step, step
from assess.interfaces.contact import thresholds
from assess.loads.load import Load, PointMass
from assess.mechanisms.branch_table import NODES
from assess.mechanisms.chain import FLAT, Chain, Joint, geometric_limit, virtual_work
from assess.mechanisms.flexible_chain import (
    FlexibleChain,
    JointedChain,
    JointEquilibrium,
    block_forces,
    contact_arrays,
    hinge_reactions,
    load_force,
)
from assess.mechanisms.hinge_forces import hinge_compressions
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Branch, Oscillator, multiplier
from assess.results import BranchMoment, ContactSheet, InterfaceCurves
from assess.study.contact_steps import BALANCE, RotatedJoint, block_steps, rest_steps, state_steps, threshold_steps
from spectra.arrays import ComplexArray, FloatArray
from spectra.gravity import g

MOST_CURVE_POINTS = 200  # of a curve, at most


def interface_results(mechanism: Mechanism, oscillator: Oscillator, names: Sequence[str]) -> tuple[dict[str, Any], ...]:
    """Return the force at every hinge of both branches, and how its contact opens and crushes."""
    found: list[dict[str, Any]] = []
    for chain, side in zip(mechanism.chains, oscillator.branches, strict=True):
        if chain.joints:
            found += _flexible_joints(chain, side, names[len(found) :], mechanism.name)
        else:
            forces = hinge_compressions(chain)
            found += [_rigid_joint(name, force) for name, force in zip(names[len(found) :], forces, strict=False)]
    return tuple(found)


def sheets_of_joints(mechanism: Mechanism, oscillator: Oscillator, names: Sequence[str]) -> Iterator[ContactSheet]:
    """Yield the calculation sheets of the joints of both branches that yield or crush."""
    for chain, side, rest in zip(mechanism.chains, oscillator.branches, oscillator.equilibria, strict=False):
        if chain.joints:
            yield from contact_sheets(FlexibleChain(chain, mechanism.name), side, names, equilibrium=rest)
        names = names[len(chain.hinges) :]


def interface_curves(mechanism: Mechanism, rigid: Sequence[Branch]) -> InterfaceCurves:
    """Return the moment of the positive branch with rigid joints, and about its fixed hinges a_SF."""
    chain = FlexibleChain(mechanism.positive, mechanism.name).fixed_hinge_chain
    rotation = np.linspace(0.0, min(rigid[0].rotation[-1], geometric_limit(chain) * (1.0 - FLAT)), NODES)
    fixed = virtual_work(chain, rotation).restoring  # may be zero from the start, where the joint still resists
    return InterfaceCurves(_branch_moment(rigid[0].rotation, rigid[0].restoring), _branch_moment(rotation, fixed))


AT_REST = "equilibrium of each block at rest"
AT_ROTATION = "equilibrium of each block at that rotation"
OF_BLOCKS = "the rotations of the blocks that it joins"
MULTIPLIER = "rotation at the largest multiplier"
OVERTURNING = "rotation at overturning"
STATE_DESCRIPTIONS = {"m": MULTIPLIER, "u": OVERTURNING}

VerticalForces = dict[str, tuple[float, str]]
"""Vertical forces by symbol, down positive [N]."""
LEVEL = 1e-9  # of a force: a horizontal or vertical part that is less is none
SAME_FORCE = 1e-6  # relative: of two forces that are one
LEAST_SLOPE = 1e-9  # rad: a joint that has rotated by less rests


@dataclass(frozen=True)
class RotatedJoints:
    """The joints of a chain at the rotations of two states.

    marks : of the states, behind each symbol; rotation : of the mechanism [2] [rad]
    equilibrium : of all joints; relative : rotation of each joint [hinges, 2] [rad]
    """

    marks: tuple[str, ...]
    rotation: FloatArray
    equilibrium: JointEquilibrium
    relative: FloatArray


def contact_sheets(
    flexible: FlexibleChain, branch: Branch, names: Sequence[str], *, equilibrium: float
) -> Iterator[ContactSheet]:
    """Yield the sheet of each joint that yields or crushes.

    Parameters
    ----------
    flexible : the chain on its joints
    branch : of its oscillator
    names : of its hinges
    equilibrium : rotation at rest from which the branch counts [rad]
    """
    rest = flexible.solve_joints(np.zeros(1))
    reactions, joints = _reactions(flexible, rest), _rotated_joints(flexible, branch, equilibrium)
    for number, (name, joint) in enumerate(zip(names, flexible.jointed.joints, strict=False)):
        if joint is None or rest.contacts[number] is None:
            continue
        N = float(rest.normal_force[number, 0])
        at_rest = (*_force_steps(flexible, number, rest, reactions), *rest_steps(joint, N))
        opening = block_steps(joint, N) if joint.law.stiffness == inf else threshold_steps(joint, N)
        yield ContactSheet(name, (*at_rest, *opening, *_state_steps(joint, number, N, joints)))


@dataclass(frozen=True)
class MiddleHinge:
    """The force of the hinge C on the third block at rest.

    moments : lines of the two moments; given : what its formulas hold; force : to the right and up [N]
    """

    moments: tuple[Step, Step]
    given: Given
    force: complex


def _rigid_joint(hinge: str, normal_force: float) -> dict[str, Any]:
    """Return a rigid contact, without curve; its force is that at incipient motion, negative in tension."""
    return {
        "hinge": hinge,
        "model": "rigid",
        "normal_force_n": normal_force,
        "area_m2": None,
        "stiffness_pa_m": None,
        "strength_pa": None,
        "opening_rad": 0.0,
        "crushing_rad": None,
        "curve": None,
    }


def _flexible_joints(chain: Chain, side: Branch, names: Sequence[str], name: str) -> list[dict[str, Any]]:
    """Return the joints of one chain: forces at rest, rotations of the joints themselves.

    mechanism_rotation_rad is that of the chain from its geometry; the branch counts from phi_e.
    """
    stride = -(-side.rotation.size // MOST_CURVE_POINTS)
    rotation = np.unique(side.rotation)[::stride]
    flexible = FlexibleChain(chain, name)
    equilibrium, rest = flexible.solve_equilibrium(rotation), flexible.solve_joints(np.zeros(1)).normal_force[:, 0]
    found = []
    for number, joint in enumerate(chain.joints):
        force = float(rest[number])
        contact = equilibrium.contacts[number]
        if joint is None or contact is None:
            found.append(_rigid_joint(names[number], hinge_compressions(chain)[number]))
            continue
        opening, crushing = thresholds(joint.section, joint.law, normal_force=force)
        found.append({
            "hinge": names[number],
            "model": joint.model,
            "normal_force_n": force,
            "area_m2": joint.section.area,
            "depth_m": joint.section.depth,
            "stiffness_pa_m": _finite(joint.law.stiffness),
            "strength_pa": _finite(joint.law.strength),
            "opening_rad": _finite(opening),
            "crushing_rad": _finite(crushing),
            "curve": {
                "rotation_rad": tuple((equilibrium.relative[number] + 0.0).tolist()),
                "mechanism_rotation_rad": tuple(rotation.tolist()),
                "resultant_m": tuple(contact.resultant.tolist()),
                "peak_stress_pa": tuple(contact.peak_stress.tolist()),
                "open_share": tuple((contact.open_area / joint.section.area).tolist()),
                "crushed_share": tuple((contact.crushed_area / joint.section.area).tolist()),
            },
        })  # fmt: skip
    return found


def _finite(value: float) -> float | None:
    """Return the value, None in place of inf."""
    return float(value) if isfinite(value) else None


def _branch_moment(rotation: FloatArray, restoring: FloatArray) -> BranchMoment:
    return BranchMoment(tuple(rotation.tolist()), tuple(restoring.tolist()))


def _rotated_joints(flexible: FlexibleChain, branch: Branch, equilibrium: float) -> RotatedJoints:
    """Return the joints where the multiplier is largest and at overturning."""
    standing = np.where(branch.rotation <= branch.unstable, multiplier(branch), -np.inf)
    largest = float(branch.rotation[int(np.argmax(standing))])
    rotation = np.array([largest, min(branch.unstable, float(branch.rotation[-1]))]) + equilibrium
    rotation = np.maximum(rotation, 0.0)
    equilibrium_there = flexible.solve_joints(rotation)
    return RotatedJoints(
        ("m", "u"), rotation, equilibrium_there, flexible.jointed.relative(equilibrium_there.configuration)
    )


def _state_steps(joint: Joint, number: int, N: float, joints: RotatedJoints) -> Iterator[Step]:
    """Yield the lines of a joint in each state in which it has rotated."""
    contact = joints.equilibrium.contacts[number]
    for place, mark in enumerate(joints.marks):
        if contact is None or not contact.rotation[place] > LEAST_SLOPE:
            continue
        rotated = RotatedJoint(mark, joint, float(contact.rotation[place]), contact, place)
        if joint.law.stiffness == inf and isclose(rotated.force[1], N, rel_tol=SAME_FORCE):
            continue  # the block at rest
        yield from _rotation_steps(rotated, float(joints.rotation[place]), float(joints.relative[number, place]))
        yield from state_steps(rotated)


def _rotation_steps(rotated: RotatedJoint, rotation: float, relative: float) -> tuple[Step, ...]:
    mark, (N, force) = rotated.mark, rotated.force
    return (
        step(f"φ_{mark}", STATE_DESCRIPTIONS[mark], "capacity curve", "from the geometry", rotation, "rad"),
        step(N, "normal force then", BALANCE, AT_ROTATION, force, "N"),
        step(f"ψ_{mark}", "rotation of the joint then", BALANCE, OF_BLOCKS, relative, "rad"),
        step(f"s_{mark}", "slope of its faces to each other", BALANCE, f"sin(ψ_{mark})", rotated.slope,
             given={f"ψ_{mark}": (relative, "rad")}),
    )  # fmt: skip


def _reactions(flexible: FlexibleChain, rest: JointEquilibrium) -> ComplexArray:
    """Return the force of each hinge at rest on the chain beyond it [hinges] [N]."""
    jointed = flexible.jointed
    points = _points_at_rest(jointed, rest)
    forces = block_forces(jointed, rest.configuration, points[:, None], jointed.chain.loads)
    return np.asarray(hinge_reactions(points[:, None], *forces)[:, 0])


def _force_steps(
    flexible: FlexibleChain, number: int, rest: JointEquilibrium, reactions: ComplexArray
) -> tuple[Step, ...]:
    """Write the normal force of a joint at rest: the sum of what it carries, where its faces are level."""
    jointed, count, N = flexible.jointed, len(flexible.jointed.chain.blocks), float(rest.normal_force[number, 0])
    if number == 2 and count == 2:
        return _top_steps(flexible, N)
    normal = complex(jointed.normal[number]) * (-1.0 if number > 1 else 1.0)
    reaction = complex(reactions[number])
    lines, parts = _weights(flexible, [] if number == 2 else [2] if number == 3 else range(number, min(count, 2)))
    middle = None
    if count == 3:
        middle = _middle_hinge(flexible, rest)
        over = _vertical_step(middle, above=number > 1)
        lines += [*middle.moments, over]
        parts["V_C"] = (over.value or 0.0, "N")
    total = sum(value for value, _ in parts.values())
    level = abs(normal.real) <= LEVEL
    name = "N" if level else "V"
    words = "weights and loads that the joint carries"
    lines.append(step(name, words, BALANCE, " + ".join(parts), total, "N", given=parts))
    if level and isclose(total, N, rel_tol=SAME_FORCE):
        return tuple(lines)
    if level or not isclose(abs(reaction.imag), abs(total), rel_tol=SAME_FORCE, abs_tol=SAME_FORCE * abs(N)):
        return (step("N", "normal force on the joint at rest", BALANCE, AT_REST, N, "N"),)
    return (*lines, *_inclined_steps(reaction, normal, N, middle))


def _inclined_steps(reaction: complex, normal: complex, N: float, middle: MiddleHinge | None) -> tuple[Step, ...]:
    """Write the normal force on faces that are not level."""
    side = 1.0 if reaction.imag >= 0.0 else -1.0
    H, V, n_x, n_z = side * reaction.real, side * reaction.imag, side * normal.real, side * normal.imag
    given: Given = {"H": (H, "N"), "n_x": (n_x, "-"), "V": (V, "N"), "n_z": (n_z, "-")}
    along = None if middle is None else _horizontal_step(middle, H)
    return (
        along or step("H", "horizontal force on the joint at rest", BALANCE, AT_REST, H, "N"),
        step("N", "square to the faces, of the normal n", BALANCE, "H n_x + V n_z", N, "N", given=given),
    )


def _top_steps(flexible: FlexibleChain, N: float) -> tuple[Step, ...]:
    """Write the force of the joint at the top of a wall: of the loads that act through it."""
    lines, parts = list[Step](), VerticalForces()
    _add_loads(flexible, flexible.jointed.at_top, lines, parts)
    words = "force on the joint at rest: the loads through it"
    return (*lines, step("N", words, BALANCE, " + ".join(parts), N, "N", given=parts))


def _weights(flexible: FlexibleChain, blocks: Iterable[int]) -> tuple[list[Step], VerticalForces]:
    """Return the weights of blocks and of what they carry, as lines and as parts of a sum."""
    lines, parts, blocks = list[Step](), VerticalForces(), list(blocks)
    for block in blocks:
        mass, name = flexible.jointed.chain.blocks[block].mass, f"W_{block + 1}"
        lines.append(step(name, "weight of a block", BALANCE, "m g", mass * g, "N", given={"m": (mass, "kg")}))
        parts[name] = (mass * g, "N")
    loads = [load for load in flexible.jointed.chain.loads if load.block in blocks]
    _add_loads(flexible, loads, lines, parts)
    return lines, parts


def _add_loads(flexible: FlexibleChain, loads: Sequence[Load], lines: list[Step], parts: VerticalForces) -> None:
    """Add the vertical forces of loads at rest to lines and parts of a sum."""
    for load in loads:
        name = f"P_{sum(part.startswith('P') for part in parts) + 1}"
        down = -float(load_force(flexible.jointed, load, np.array([complex(*load.at)]))[0].imag) + 0.0
        if down == 0.0:
            continue
        parts[name] = (down, "N")
        if isinstance(load, PointMass):
            mass: Given = {"m": (load.mass, "kg")}
            lines.append(step(name, "weight of a load", BALANCE, "m g", down, "N", given=mass, subject=load.name))
        else:
            words = "vertical part of a force, down"
            lines.append(step(name, words, BALANCE, "given", down, "N", subject=load.name))


LEAST_ARM = 1e-9  # m: a shorter one is rounding

ForceAt = tuple[complex, complex]
"""Place, x + iz [m], and force to the right and up [N]."""


def _points_at_rest(jointed: JointedChain, rest: JointEquilibrium) -> ComplexArray:
    """Return the resultants of the joints at rest, x + iz [hinges] [m]."""
    inside = contact_arrays(rest.contacts, "resultant", rest.closure.shape)
    return np.asarray((rest.configuration.corner + inside * jointed.faces(rest.configuration))[:, 0])


DENOMINATOR = "((x_B − x_C) (z_C − z_D) − (z_B − z_C) (x_C − x_D))"


def _middle_hinge(flexible: FlexibleChain, rest: JointEquilibrium) -> MiddleHinge:
    """Solve the force of C, from the moments of the second block about B and of the third about D.

    Parameters
    ----------
    flexible : the chain of three blocks
    rest : its joints at rest
    """
    B, C, D = (complex(each) for each in _points_at_rest(flexible.jointed, rest)[1:])
    second, M_2 = _moment_step(flexible, 1, "M_2", ("x_B", "z_B"), B)
    third, M_3 = _moment_step(flexible, 2, "M_3", ("x_D", "z_D"), D)
    arm, other = B - C, C - D
    given: Given = {
        "M_2": (M_2, "N m"), "M_3": (M_3, "N m"),
        "x_B": (B.real, "m"), "z_B": (B.imag, "m"), "x_C": (C.real, "m"), "z_C": (C.imag, "m"),
        "x_D": (D.real, "m"), "z_D": (D.imag, "m"),
    }  # fmt: skip
    force = (M_2 * other - M_3 * arm) / (arm.real * other.imag - arm.imag * other.real)
    return MiddleHinge((second, third), given, force)


def _vertical_step(hinge: MiddleHinge, *, above: bool) -> Step:
    """Write the vertical force of C, down: what presses on the third block (above), or else on the second."""
    moments = "(M_3 (z_B − z_C) − M_2 (z_C − z_D))" if above else "(M_2 (z_C − z_D) − M_3 (z_B − z_C))"
    down = -hinge.force.imag if above else hinge.force.imag
    words = "vertical force of C, by both moments"
    return step("V_C", words, BALANCE, f"{moments} / {DENOMINATOR}", down, "N", given=hinge.given)


def _horizontal_step(hinge: MiddleHinge, H: float) -> Step | None:
    """Write the horizontal force of a joint where it is that of C; None where loads change it between them."""
    along = hinge.force.real
    if not isclose(abs(H), abs(along), rel_tol=SAME_FORCE):
        return None
    forward = "(M_2 (x_C − x_D) − M_3 (x_B − x_C))"
    moments = forward if H * along > 0.0 else "(M_3 (x_B − x_C) − M_2 (x_C − x_D))"
    words = "horizontal force, that of C"
    return step("H", words, BALANCE, f"{moments} / {DENOMINATOR}", H, "N", given=hinge.given)


def _moment_step(
    flexible: FlexibleChain, block: int, symbol: str, axis: tuple[str, str], about: complex
) -> tuple[Step, float]:
    """Write the clockwise moment of weights and loads of a block about the resultant of one of its joints."""
    x_0, z_0 = axis
    given: dict[str, tuple[float, str]] = {}
    terms, total = list[str](), 0.0
    for number, (at, force) in enumerate(_weight_and_loads(flexible, block), start=1):
        for name, value, place, pole, origin in (
            (f"V_{number}", -force.imag, ("x", at.real), x_0, about.real),
            (f"H_{number}", force.real, ("z", at.imag), z_0, about.imag),
        ):
            if value == 0.0:
                continue
            here, there = f"{place[0]}_{number}", place[1] if abs(place[1] - origin) > LEAST_ARM else origin
            given |= {name: (value, "N"), here: (there, "m"), pole: (origin, "m")}
            terms.append(f"{name} ({here} − {pole})")
            total += value * (there - origin)
    words = "clockwise moment of weight and loads"
    return step(symbol, words, BALANCE, " + ".join(terms), total, "N m", given=given), total


def _weight_and_loads(flexible: FlexibleChain, number: int) -> list[ForceAt]:
    """Return weight and loads of a block at rest."""
    block = flexible.jointed.chain.blocks[number]
    acting = [(complex(*block.centroid), -1j * g * block.mass)]
    for load in flexible.jointed.chain.loads:
        if load.block == number:
            at = complex(*load.at)
            acting.append((at, complex(load_force(flexible.jointed, load, np.array([at]))[0])))
    return acting
