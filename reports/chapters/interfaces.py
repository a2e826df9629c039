"""The joints of a mechanism: table, figures, and what they carry in the governing record."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from assess.results import MechanismResult
from reports import governing, joints
from reports.document import Block, Cell, Column, Figure, Table, Text
from reports.figures import contact, moment_rotation
from reports.language.measures import measure
from reports.language.numerals import numeral

RIGID, UNLIMITED, NEVER = "rigid", "unlimited", "never"

ASSUMED = (
    "Joints: no tension, linear in compression up to the strength, then plastic. Crushing leaves no "
    "memory: the moment depends on the current rotation alone, so that unloading recovers what crushing "
    "took. Normal forces follow from static equilibrium at each rotation, without the vertical inertia of "
    "the motion; the tangential force stays at the hinge’s edge of the contact. Model “flexible” takes "
    "the inertia about the instantaneous centre of the faces, “flexible-thesis” about the resultant "
    "(thesis 6.50), “semi-flexible” about hinges fixed at a_SF. The coefficient of restitution is that of "
    "hinges at a_SF, and acts at each passage through rest, however small the rotation before it was."
)


def blocks(mechanism: MechanismResult, *, name: str) -> list[Block]:
    """Return table, figures and sentence on the joints of a mechanism; none where all are rigid."""
    if not joints.deformable_joints(mechanism):
        return []
    moment = (
        "Restoring moment of the positive branch over rotation, divided by the largest with rigid joints: "
        "with rigid joints, with hinges fixed at a_SF, and with the joints of this mechanism (as thesis "
        "Fig. 8.8). Open circle: a joint begins to open; filled: its edge begins to crush."
    )
    pressed = (
        "Each joint over the rotation of the mechanism, on a logarithmic axis: distance of the resultant from the "
        "compressed edge, and the stress at that edge. Joints that are alike share a line; dashed: of the negative "
        "branch."
    )
    return [
        table(mechanism, name=f"{name}-interfaces"),
        Text((at_peak(mechanism),)),
        Figure(f"{name}-moment", moment, partial(moment_rotation.draw, mechanism)),
        Figure(f"{name}-contact", pressed, partial(contact.draw, mechanism)),
    ]


def table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate every hinge of both branches with the contact that it presses on."""
    columns = (
        Column("Hinge"),
        Column("Model"),
        Column("Stiffness", "Pa/m", "number"),
        Column("Strength", "Pa", "number"),
        Column("Force at rest", "N", "number"),
        Column("Area", "m²", "number"),
        Column("Depth", "m", "number"),
        Column("Opens at", "rad", "number"),
        Column("Crushes at", "rad", "number"),
    )
    caption = (
        "Joints under the hinges. Depth: along the motion; rotations: of the joint itself, under its force at rest, at "
        "which it begins to open and its edge to crush."
    )
    return Table(name, caption, columns, tuple(map(_row, mechanism.interfaces)))


def _row(found: dict[str, Any]) -> tuple[Cell, ...]:
    start = (found["hinge"], found["model"])
    if found["curve"] is None:
        return (*start, RIGID, UNLIMITED, found["normal_force_n"], None, None, found["opening_rad"], NEVER)
    return (
        *start,
        RIGID if found["stiffness_pa_m"] is None else found["stiffness_pa_m"],
        UNLIMITED if found["strength_pa"] is None else found["strength_pa"],
        found["normal_force_n"],
        found["area_m2"],
        found["depth_m"],
        NEVER if found["opening_rad"] is None else found["opening_rad"],
        NEVER if found["crushing_rad"] is None else found["crushing_rad"],
    )


def at_peak(mechanism: MechanismResult) -> str:
    """Describe what the joints carry at the largest rotation of the governing record."""
    found = governing.history(mechanism)
    if found is None:
        return "No time history was run: the contact stress at the peak of a record is not known."
    one, _ = found
    record = f"governing record ({one.record}, PGA {one.level_pga_g:.3g} g)"
    if one.max_rotation_rad is None:
        return f"The {record} overturns the mechanism: there is no peak rotation at which to give the contact stress."
    if one.max_rotation_rad == 0.0:
        return f"The {record} does not move the mechanism."
    turned = joints.peak_rotation(mechanism, one)
    each = "; ".join(_pressed(interface, turned) for interface in joints.joints_of_branch(mechanism, one.branch))
    return f"At the largest rotation under the {record}, φ = {numeral(turned)} rad of the {one.branch} branch: {each}."


def _pressed(interface: dict[str, Any], rotation: float) -> str:
    """Return stress, resultant, open and crushed parts of one joint at a rotation of the mechanism [rad]."""
    stress, resultant, opened, crushed = joints.values_at(interface, rotation)
    strength = interface["strength_pa"]
    limit = "" if strength is None else f" (strength {_aligned(strength / 1e6, 'MPa')})"
    return (
        f"joint {interface['hinge']} presses with up to {_aligned(stress / 1e6, 'MPa')}{limit}, resultant "
        f"{_aligned(resultant, 'm')} from the edge, {_percent(opened)} of it open and {_percent(crushed)} crushed"
    )


def _aligned(value: float, unit: str) -> str:
    return measure(value, unit, figures=3, style="aligned")


def _percent(share: float) -> str:
    return "none" if share == 0.0 else f"{100.0 * share:.0f} %" if share >= 0.005 else "less than 1 %"


def limits(mechanisms: tuple[MechanismResult, ...]) -> Iterator[str]:
    """Yield the limits of the model of the joints, where there are any."""
    if any(joints.deformable_joints(mechanism) for mechanism in mechanisms):
        yield ASSUMED
