"""Response of plain blocks and oscillators to a ground motion given sample by sample, or as a sum of sines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any


def solve_motion(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the largest response of plain blocks, and the response spectrum of the motion.

    Parameters
    ----------
    folder : of the case, not read
    given : `blocks`, by name `p` [1/s], `slenderness` [rad], `restitution` [-] and `scale` of the motion [-];
        `equation`; `step` [s] of the motion; `samples` [m/s2], or `duration` [s] and `sines` of which the samples are
        taken, each with amplitude [m/s2], frequency [Hz] and phase [rad]; `periods` [s] of the spectrum

    Returns
    -------
    Mapping
        By name of a block `max_ratio` (|θ|/α), `impacts` and `overturned` (0 or 1); `spectrum_g`, pseudo-acceleration
        [g] at 5 % of damping by period, such as "0.3 s".
    """
    import numpy as np
    from scipy.constants import g

    from assess.dynamics.history import peaks, product
    from assess.oscillator import Oscillator, SingleBlock, plain_branch
    from records.record import make_record
    from records.response import response_spectrum

    step = given["step"]
    motion = make_record("given", np.array(given["samples"] if "samples" in given else _sum(given)), step)
    periods = given.get("periods", [])
    spectrum = response_spectrum(motion, periods) / g
    tree: dict[str, Any] = {"spectrum_g": {f"{T:g} s": float(a) for T, a in zip(periods, spectrum, strict=True)}}
    for name, block in given.get("blocks", {}).items():
        plain = SingleBlock(1.0, 1.0, block["slenderness"], g / block["p"] ** 2)
        side = plain_branch(plain, restitution=block["restitution"])
        job = product(1, 1, [block["scale"]])
        found = peaks([Oscillator(side, side, 1.0)], [motion], job, equation=given["equation"])
        tree[name] = {
            "max_ratio": float(found.max_ratio[0]),
            "impacts": int(found.impacts[0]),
            "overturned": int(found.overturned[0]),
        }
    return tree


def _sum(given: Mapping[str, Any]) -> Sequence[float]:
    """Return the samples of a sum of sines."""
    from math import pi, sin

    times = [step * given["step"] for step in range(round(given["duration"] / given["step"]) + 1)]
    return [sum(a * sin(2 * pi * f * t + phase) for a, f, phase in given["sines"]) for t in times]
