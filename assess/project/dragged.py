"""What of a mechanism is dragged in a drawing: its crack and the ends of its ties, and what the file then says."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import asin, atan2, cos, degrees, sin
from typing import Any

import numpy as np

from assess.loads.load import TieLoad
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, CutPlane
from assess.mechanisms.single_block import SingleBlock
from assess.mechanisms.two_block import TwoBlock
from assess.project.key_errors import KeyPath
from assess.results import MechanismResult, Place
from spectra.arrays import FloatArray, is_number

LEVEL = 0.0005  # rad: a crack less inclined than this is written as an elevation
DECIMALS = 4  # of a coordinate [m], and of a normal


@dataclass(frozen=True)
class Crack:
    """The plane of a crack.

    point : of it [x, y, z] [m]
    angle : from the horizontal in the plane of motion, positive where it falls towards the direction [rad]
    aside : of one given by its normal, the angle of that to the plane of motion, positive to the left [rad]
    turns : whether it can be inclined
    """

    point: Place
    angle: float
    aside: float = 0.0
    turns: bool = True


def crack_of(definition: object, result: MechanismResult | None) -> Crack | None:
    """Return the crack of a mechanism of one block, or of one body that parts in two; None where none can be moved.

    Parameters
    ----------
    definition : the mechanism as it is stated
    result : of it, whose drawing has the place of a crack that the program finds
    """
    if result is None or result.view is None:
        return None
    along = np.array(result.view.direction)
    if isinstance(definition, SingleBlock):
        cut, axis = definition.cut, result.view.axes[0].ends
        if isinstance(cut, CutPlane):
            normal = np.array(cut.normal) / np.linalg.norm(cut.normal)
            across = float(np.clip(normal @ [-along[1], along[0], 0.0], -1.0, 1.0))
            return Crack(_as_place(cut.point), atan2(float(normal @ along), normal[2]), asin(across))
        if isinstance(cut, CutAngle):
            return Crack(_as_place(cut.point), cut.angle)
        x, y, z = _middle(axis)
        return Crack((x, y, z if cut is None else cut), 0.0)
    if isinstance(definition, TwoBlock) and len(definition.blocks) == 1 and definition.hinges is None:
        at = next((each.ends for each in result.view.axes if each.name == "B"), None)
        if at is not None:
            x, y, z = _middle(at)
            return Crack((x, y, definition.crack if is_number(definition.crack) else z), 0.0, turns=False)
    return None


def crack_entry(
    name: str, before: Crack, after: Crack, written: Mapping[str, Any], along: Place
) -> tuple[KeyPath, Any]:
    """Return the key of a crack and what the file then says there.

    Parameters
    ----------
    name : of the mechanism
    before, after : the crack as it is, and as it is to be: coordinates that are the same stay as written
    written : the table of the mechanism as it is tried
    along : the direction of motion
    """
    cut = written.get("cut")
    given = cut.get("point", before.point) if isinstance(cut, Mapping) else before.point
    point = [
        stated if new == old else round(float(new), DECIMALS) + 0.0
        for stated, old, new in zip(given, before.point, after.point, strict=True)
    ]
    elevation = f"{point[2]:.6g} m" if is_number(point[2]) else point[2]
    if not before.turns:
        return ("mechanisms", name, "crack"), elevation
    key: KeyPath = ("mechanisms", name, "cut")
    if isinstance(cut, Mapping) and "normal" in cut:
        if after.angle == before.angle:
            return key, {"point": point, "normal": list(cut["normal"])}
        normal = np.round(_normal(after, np.array(along)), DECIMALS) + 0.0
        return key, {"point": point, "normal": normal.tolist()}
    if abs(after.angle) <= LEVEL and not isinstance(cut, Mapping):
        return key, elevation
    return key, {"point": point, "angle": f"{degrees(after.angle):.2f} deg"}


def tie_ends(name: str, definition: object, result: MechanismResult | None) -> dict[KeyPath, Place]:
    """Return the ends of the ties of a mechanism in space [m], by their keys in the file.

    Parameters
    ----------
    name, definition : of the mechanism
    result : of it, in whose drawing two numbers have their place; None where it has none, and ends are those of three
    """
    if not isinstance(definition, BlockMechanism):
        return {}
    return dict(_ends(name, definition, None if result is None or result.view is None else result))


def end_value(at: Sequence[float], given: Sequence[Any], along: Sequence[float]) -> list[float]:
    """Return an end of a tie as the file has it: as three numbers, or as two where it was given as two.

    Parameters
    ----------
    at : [x, y, z] [m]
    given : what the file says
    along : the direction of motion
    """
    value = at if len(given) == 3 else (at[0] * along[0] + at[1] * along[1], at[2])
    return [round(float(each), DECIMALS) + 0.0 for each in value]


def _ends(name: str, definition: BlockMechanism, result: MechanismResult | None) -> Iterator[tuple[KeyPath, Place]]:
    for number, load in enumerate(definition.loads):
        if not isinstance(load, TieLoad):
            continue
        for key, at in (("at", load.at), ("anchor", load.anchor)):
            if at is not None and (len(at) == 3 or result is not None):
                yield ("mechanisms", name, "loads", number, key), _in_space(at, result)


def _in_space(at: Sequence[float], result: MechanismResult | None) -> Place:
    """Return a place in space; of two numbers at the middle of the base hinge."""
    if len(at) == 3 or result is None or result.view is None:
        return _as_place(at)
    (x, y, _), middle = result.view.direction, _middle(result.view.axes[0].ends)
    across = middle[1] * x - middle[0] * y
    return (at[0] * x - across * y, at[0] * y + across * x, at[1])


def _normal(crack: Crack, along: FloatArray) -> FloatArray:
    """Return the unit normal of a crack, upwards [3]."""
    across, up = np.array([-along[1], along[0], 0.0]), np.array([0.0, 0.0, 1.0])
    return np.asarray(cos(crack.aside) * (sin(crack.angle) * along + cos(crack.angle) * up) + sin(crack.aside) * across)


def _middle(ends: tuple[Place, Place]) -> Place:
    x, y, z = ((a + b) / 2.0 for a, b in zip(*ends, strict=True))
    return (x, y, z)


def _as_place(at: Sequence[float]) -> Place:
    x, y, z = (float(each) for each in at)
    return (x, y, z)
