"""Rocking blocks of tests, in closed form or tabulated by the program, and branches with actions that end."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from scipy.constants import g

from assess.oscillator import Branch, Oscillator, RockingBlock, plain_branch


def branch(
    p: float = 2.0, alpha: float = 0.2, restitution: float = 0.9, *, swell: float = 0.0, nodes: int = 257
) -> Branch:
    """Return the branch of a rectangular block of M R = 1 kg m, whose inertia grows by `swell` phi.

    Parameters
    ----------
    p : frequency parameter [1/s]; alpha : slenderness [rad]; restitution [-]; swell [1/rad]
    nodes : of the table, evenly up to 1.5 alpha
    """
    phi = np.linspace(0.0, 1.5 * alpha, nodes)
    one = np.ones_like(phi)
    inertia = g / p**2 * (1.0 + swell * phi)
    return Branch(phi, inertia, g * np.sin(alpha - phi), np.cos(alpha - phi), one, one, restitution, alpha, alpha)


def block(
    p: float = 2.0, alpha: float = 0.2, restitution: float = 0.9, *, sides: int = 2, nodes: int = 257, **columns: Any
) -> Oscillator:
    """Return a rectangular block of M R = 1 kg m that rocks to both sides, or to one; columns: of its branch."""
    side = replace(branch(p, alpha, restitution, nodes=nodes), **columns)
    return Oscillator(side, side if sides == 2 else None, 1.0)


def unlike_block(*, jump: bool = False) -> Oscillator:
    """Return branches that differ, with inertia that varies; the moment may drop where a tie goes slack."""
    sides = []
    for alpha, p, slope, restitution in ((0.25, 1.8, 2.0, 0.8), (0.2, 2.1, -1.0, 0.9)):
        phi = np.linspace(0.0, 1.5 * alpha, 65)
        if jump:
            phi = np.sort(np.append(phi, phi[20]))
        inertia = g / p**2 * (1.0 + slope * phi + 2.0 * phi**2)
        moment, excitation = g * np.sin(alpha - phi), np.cos(alpha - phi) * (1.0 + 0.3 * phi)
        if jump:
            moment[:21] += 0.2 * moment[0]
        one = np.ones_like(phi)
        sides.append(Branch(phi, inertia, moment, excitation, one, one, restitution, alpha, alpha))
    return Oscillator(sides[0], sides[1], 1.0)


def tabulated_block(
    p: float, alpha: float = 0.2, restitution: float = 0.9, *, sides: int = 2, end: float = 1.5
) -> Oscillator:
    """Return the block as the program tabulates it, up to `end` alpha."""
    side = plain_branch(RockingBlock(1.0, 1.0, alpha, g / p**2), restitution=restitution, end=end)
    return Oscillator(side, side if sides == 2 else None, 1.0)


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
