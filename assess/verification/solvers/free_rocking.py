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
        By tilt: `first_p` and `period_p`, the time of the first impact and that between the first and the third times p
        of the equation [-]. `amplitude` of the last tilt, by number of impacts: the peak after it over the overturning
        rotation [-].
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
    tree: dict[str, dict[str, Any]] = {"first_p": {}, "period_p": {}, "amplitude": {}}
    for tilt in given["tilts"]:
        rotation = tilt * side.linearised.overturning
        found = free_rocking(rocking, rotation=rotation, duration=given["duration"], equation=given["equation"])
        row = f"{tilt:g}"
        tree["first_p"][row] = p * float(found.impact_time[0])
        tree["period_p"][row] = p * float(found.impact_time[2] - found.impact_time[0])
        peaks = abs(found.peak_rotation) / side.linearised.overturning
        tree["amplitude"] = {str(number): float(peak) for number, peak in enumerate(peaks[:20], 1)}
    return tree
