"""Overturning under one pulse: the closed forms of the linearised block, and envelopes by integration."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any


def solve_pulses(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return overturning amplitudes A = a_p / (g tan α), or a_p / (g λ) of the linearised block, by Ω = ω_p / p.

    Parameters
    ----------
    folder : of the case, not read
    given : `frequencies`, Ω [-]; `p` [1/s], `slenderness` [rad] and `restitution` [-] of a plain block; `highest` A of
        the envelope

    Returns
    -------
    Mapping
        `without_impact` and `half_sine`: closed forms; `first` and `last`: A between which a block overturns after one
        impact; `envelope.linearised` and `envelope.exact`: the least A that overturns under a sine, by integration.
    """
    from assess.dynamics import sine_branches

    restitution = given["restitution"]
    tree: dict[str, dict[str, Any]] = {key: {} for key in ("without_impact", "half_sine", "first", "last", "envelope")}
    for omega in given["frequencies"]:
        row = f"{omega:g}"
        tree["without_impact"][row] = sine_branches.without_impact(omega)
        tree["half_sine"][row] = sine_branches.half_sine(omega)
        impacts = (
            *sine_branches.impact_in_pulse(omega, restitution),
            *sine_branches.impact_after_pulse(omega, restitution),
        )
        if impacts:
            tree["first"][row], tree["last"][row] = min(impacts), max(impacts)
    tree["envelope"] = {equation: _envelope(given, equation) for equation in ("linearised", "exact")}
    return tree


def _envelope(given: Mapping[str, Any], equation: Any) -> Mapping[str, float]:
    from math import pi

    import numpy as np
    from scipy.constants import g

    from assess.dynamics.envelope import envelope, uplift_acceleration
    from assess.oscillator import Oscillator, SingleBlock, plain_branch
    from records.pulses import SHAPES

    plain = SingleBlock(1.0, 1.0, given["slenderness"], g / given["p"] ** 2)
    side = plain_branch(plain, restitution=given["restitution"], end=4.0)
    body = Oscillator(side, side, 1.0)
    unit, p = uplift_acceleration(body, equation), side.linearised.p if equation == "linearised" else given["p"]
    omegas = np.array(given["frequencies"])
    amplitudes = np.array([0.0, given["highest"]]) * unit
    found = envelope(body, SHAPES["sine"], omegas * p / (2 * pi), amplitudes, equation=equation, threads=1)
    return {f"{omega:g}": float(a) / unit for omega, a in zip(omegas, found.lower_bound, strict=True)}
