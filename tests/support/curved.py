"""Branches with actions that end, made by hand from a plain block."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assess.oscillator import Branch, Oscillator


def pulled(branch: Branch, moment: float, *, until: float) -> Branch:
    """The branch with a restoring `moment` [N m] up to a rotation [rad], where it ends: two nodes at one rotation."""
    place = int(np.searchsorted(branch.rotation, until))
    columns = {
        name: np.concatenate((column[:place], [np.interp(until, branch.rotation, column)] * 2, column[place:]))
        for name in ("rotation", "inertia", "restoring", "excitation", "participation", "lift")
        for column in (getattr(branch, name),)
    }
    held = np.arange(columns["rotation"].size) <= place
    return replace(branch, **{**columns, "restoring": columns["restoring"] + moment * held})


def thrust(branch: Branch, moment: float) -> Branch:
    """The branch with a moment [N m] that drives at every rotation, and overturns where the sum is zero."""
    restoring = branch.restoring - moment
    return replace(branch, restoring=restoring, overturning=float(np.interp(0.0, -restoring, branch.rotation)))


def both(branch: Branch, oscillator: Oscillator) -> Oscillator:
    """An oscillator with this branch on both sides."""
    return replace(oscillator, positive=branch, negative=branch)
