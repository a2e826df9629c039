"""Joints that open and crush under a given force and rotation."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any


def solve_joints(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return what a joint does, by its name in `given`.

    Parameters
    ----------
    folder : of the case, not read
    given : by joint `shape`, a function of `assess.interfaces.shapes`, its `sizes` [m], across them `inner` ones if it
        is hollow; `stiffness` [Pa/m] and `strength` [Pa], either absent if infinite; `force` [N]; `rotations`, one at
        least [rad]

    Returns
    -------
    Mapping
        `opening` and `crushing`, rotations at which it opens and starts to crush [rad]; `fixed`, place of the fixed
        hinge of the semi-flexible model from the compressed edge [m]; by rotation `resultant`, `depth` and `crushed`,
        places of the force and depths of contact and of crushing from that edge [m].
    """
    return {name: _joint(each) for name, each in given.items()}


def _joint(given: Mapping[str, Any]) -> Mapping[str, Any]:
    from math import inf

    from assess.interfaces import shapes
    from assess.interfaces.contact import contact, semi_flexible_shift, thresholds
    from assess.interfaces.law import JointLaw

    inner = {"inner": given["inner"]} if "inner" in given else {}
    section = getattr(shapes, given["shape"])(*given["sizes"], **inner)
    law, force = JointLaw(given.get("stiffness", inf), given.get("strength", inf)), given["force"]
    rotations = given["rotations"]
    found = contact(section, law, normal_force=force, rotation=rotations)
    by_rotation = {"resultant": found.resultant, "depth": found.depth, "crushed": found.crushed_depth}
    tree: dict[str, Any] = {
        key: {f"{at:g}": float(value) for at, value in zip(rotations, values, strict=True)}
        for key, values in by_rotation.items()
    }
    if "stiffness" in given:
        tree["opening"], tree["crushing"] = thresholds(section, law, normal_force=force)
        tree["fixed"] = semi_flexible_shift(section, law, normal_force=force)
    return tree
