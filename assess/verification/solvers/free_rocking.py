"""A block that is let go from a tilt and rocks without ground motion."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any


def solve_free_rocking(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return times of impacts times p, and amplitudes, of free rocking.

    Parameters
    ----------
    folder : of the case, not read
    given : `thickness`, `height` [m] of a block of uniform density; `tilts`, initial rotations over the overturning
        rotation; `equation`; `duration` [s]; `restitution` if not Housner's

    Returns
    -------
    Mapping
        `period_p`, by tilt: the time between the first and the third impact times p of the equation [-].
    """
    from dataclasses import replace

    from assess.dynamics.history import free_rocking
    from assess.model.make_body import box
    from assess.study.block_kinds import single_block

    wall = box(thickness=given["thickness"], length=1.0, height=given["height"], density=2000.0)
    rocking = single_block(wall, direction=(1.0, 0.0, 0.0)).rocking
    if "restitution" in given:
        branch = replace(rocking.positive, restitution=given["restitution"])
        rocking = replace(rocking, positive=branch, negative=branch)
    side = rocking.positive
    p = side.linearised.p
    periods = {}
    for tilt in given["tilts"]:
        rotation = tilt * side.linearised.overturning
        found = free_rocking(rocking, rotation=rotation, duration=given["duration"], equation=given["equation"])
        periods[f"{tilt:g}"] = p * float(found.impact_time[2] - found.impact_time[0])
    return {"period_p": periods}
