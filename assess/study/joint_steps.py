"""The contact of each joint of a chain as a calculation sheet: its force, its section, a_SF and its stresses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import inf, isclose

import numpy as np
from scipy.constants import g

from assess.codes.calculation_step import Given, Step, step
from assess.loads.load import Load, PointMass
from assess.mechanisms.flexible import FlexibleChain
from assess.mechanisms.joint import Joint
from assess.mechanisms.joint_equilibrium import JointEquilibrium
from assess.mechanisms.joint_forces import block_forces, hinge_reactions, load_force
from assess.oscillator import Branch, multiplier
from assess.results import ContactSheet
from assess.study.contact_states import Turned, block_steps, state_steps
from assess.study.contact_steps import rest_steps, threshold_steps
from assess.study.middle_hinge_steps import MiddleHinge, horizontal_step, middle_hinge, points_at_rest, vertical_step
from assess.study.section_steps import BALANCE
from spectra.arrays import ComplexArray, FloatArray

AT_REST = "equilibrium of each block at rest"
AT_ROTATION = "equilibrium of each block at that rotation"
OF_BLOCKS = "the rotations of the blocks that it joins"
MULTIPLIER = "rotation at the largest multiplier"
OVERTURNING = "rotation at overturning"
SAID = {"m": MULTIPLIER, "u": OVERTURNING}
Parts = dict[str, tuple[float, str]]
"""Vertical forces by symbol, down positive [N]."""
LEVEL = 1e-9  # of a force: a horizontal or vertical part that is less is none
SAME = 1e-6  # relative: a normal force that is the one at rest
LEAST_SLOPE = 1e-9  # rad: a joint that has rotated by less rests


@dataclass(frozen=True)
class Rotated:
    """The joints of a chain at the rotations of two states.

    marks : of the states, behind each symbol; rotation : of the mechanism [2] [rad]
    found : their equilibrium; relative : rotation of each joint [hinges, 2] [rad]
    """

    marks: tuple[str, ...]
    rotation: FloatArray
    found: JointEquilibrium
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
    reactions, rotated = _reactions(flexible, rest), _rotated(flexible, branch, equilibrium)
    for number, (name, joint) in enumerate(zip(names, flexible.jointed.joints, strict=False)):
        if joint is None or rest.contacts[number] is None:
            continue
        N = float(rest.normal_force[number, 0])
        steps = (*_force_steps(flexible, number, rest, reactions), *rest_steps(joint, N))
        yield ContactSheet(name, (*steps, *_contact_steps(joint, N), *_state_steps(joint, number, N, rotated)))


def _contact_steps(joint: Joint, N: float) -> tuple[Step, ...]:
    return block_steps(joint, N) if joint.law.stiffness == inf else threshold_steps(joint, N)


def _rotated(flexible: FlexibleChain, branch: Branch, equilibrium: float) -> Rotated:
    """Return the joints where the multiplier is largest and at overturning."""
    standing = np.where(branch.rotation <= branch.unstable, multiplier(branch), -np.inf)
    largest = float(branch.rotation[int(np.argmax(standing))])
    rotation = np.array([largest, min(branch.unstable, float(branch.rotation[-1]))]) + equilibrium
    rotation = np.maximum(rotation, 0.0)
    found = flexible.solve_joints(rotation)
    return Rotated(("m", "u"), rotation, found, flexible.jointed.relative(found.configuration))


def _state_steps(joint: Joint, number: int, N: float, rotated: Rotated) -> Iterator[Step]:
    """Yield the lines of a joint in each state in which it has rotated."""
    contact = rotated.found.contacts[number]
    for place, mark in enumerate(rotated.marks):
        if contact is None or not contact.rotation[place] > LEAST_SLOPE:
            continue
        turned = Turned(mark, joint, float(contact.rotation[place]), contact, place)
        if joint.law.stiffness == inf and isclose(turned.force[1], N, rel_tol=SAME):
            continue  # the block at rest
        yield from _rotation_steps(turned, float(rotated.rotation[place]), float(rotated.relative[number, place]))
        yield from state_steps(turned)


def _rotation_steps(turned: Turned, rotation: float, relative: float) -> tuple[Step, ...]:
    mark, (N, force) = turned.mark, turned.force
    return (
        step(f"φ_{mark}", SAID[mark], "capacity curve", "from the geometry", rotation, "rad"),
        step(N, "normal force then", BALANCE, AT_ROTATION, force, "N"),
        step(f"ψ_{mark}", "rotation of the joint then", BALANCE, OF_BLOCKS, relative, "rad"),
        step(f"s_{mark}", "slope of its faces to each other", BALANCE, f"sin(ψ_{mark})", turned.slope,
             given={f"ψ_{mark}": (relative, "rad")}),
    )  # fmt: skip


# -------------------------------------------------------------------------------------------------- the force at rest


def _reactions(flexible: FlexibleChain, rest: JointEquilibrium) -> ComplexArray:
    """Return the force of each hinge at rest on the chain beyond it [hinges] [N]."""
    jointed = flexible.jointed
    points = points_at_rest(jointed, rest)
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
        middle = middle_hinge(flexible, rest)
        over = vertical_step(middle, above=number > 1)
        lines += [*middle.moments, over]
        parts["V_C"] = (over.value or 0.0, "N")
    total = sum(value for value, _ in parts.values())
    level = abs(normal.real) <= LEVEL
    name = "N" if level else "V"
    words = "weights and loads that the joint carries"
    lines.append(step(name, words, BALANCE, " + ".join(parts), total, "N", given=parts))
    if level and isclose(total, N, rel_tol=SAME):
        return tuple(lines)
    if level or not isclose(abs(reaction.imag), abs(total), rel_tol=SAME, abs_tol=SAME * abs(N)):
        return (_solved(N),)
    return (*lines, *_inclined_steps(reaction, normal, N, middle))


def _solved(N: float) -> Step:
    return step("N", "normal force on the joint at rest", BALANCE, AT_REST, N, "N")


def _inclined_steps(reaction: complex, normal: complex, N: float, middle: MiddleHinge | None) -> tuple[Step, ...]:
    """Write the normal force on faces that are not level."""
    side = 1.0 if reaction.imag >= 0.0 else -1.0
    H, V, n_x, n_z = side * reaction.real, side * reaction.imag, side * normal.real, side * normal.imag
    given: Given = {"H": (H, "N"), "n_x": (n_x, "-"), "V": (V, "N"), "n_z": (n_z, "-")}
    along = None if middle is None else horizontal_step(middle, H)
    return (
        along or step("H", "horizontal force on the joint at rest", BALANCE, AT_REST, H, "N"),
        step("N", "square to the faces, of the normal n", BALANCE, "H n_x + V n_z", N, "N", given=given),
    )


def _top_steps(flexible: FlexibleChain, N: float) -> tuple[Step, ...]:
    """Write the force of the joint at the top of a wall: of the loads that act through it."""
    lines, parts = list[Step](), Parts()
    _add_loads(flexible, flexible.jointed.at_top, lines, parts)
    words = "force on the joint at rest: the loads through it"
    return (*lines, step("N", words, BALANCE, " + ".join(parts), N, "N", given=parts))


def _weights(flexible: FlexibleChain, blocks: Iterable[int]) -> tuple[list[Step], Parts]:
    """Return the weights of blocks and of what they carry, as lines and as parts of a sum."""
    lines, parts, blocks = list[Step](), Parts(), list(blocks)
    for block in blocks:
        mass, name = flexible.jointed.chain.blocks[block].mass, f"W_{block + 1}"
        lines.append(step(name, "weight of a block", BALANCE, "m g", mass * g, "N", given={"m": (mass, "kg")}))
        parts[name] = (mass * g, "N")
    loads = [load for load in flexible.jointed.chain.loads if load.block in blocks]
    _add_loads(flexible, loads, lines, parts)
    return lines, parts


def _add_loads(flexible: FlexibleChain, loads: Sequence[Load], lines: list[Step], parts: Parts) -> None:
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
