"""Every procedure runs on both branches at every level; the check of the worse branch is kept."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import inf

from assess.codes.check import BranchName, Check
from assess.oscillator import Branch, Oscillator

OneCheck = Callable[[Branch, BranchName, float], Check]
NAMES: tuple[BranchName, BranchName] = ("positive", "negative")


def check_worst_branch(oscillator: Oscillator, levels: Sequence[float], one: OneCheck) -> tuple[Check, ...]:
    """Return for each level the check of the worse branch.

    PGA at capacity and at uplift are the smaller of the branches', whichever is the worse at the level. Where one
    branch serves both ways, it is the positive one.

    Parameters
    ----------
    oscillator : the mechanism
    levels : PGA [m/s2]
    one : makes the check of a branch, its name and a level

    Returns
    -------
    tuple of Check
    """
    branches = tuple(dict.fromkeys(oscillator.branches))
    named = tuple(zip(branches, NAMES, strict=False))
    return tuple(worst_branch_check([one(branch, name, level) for branch, name in named]) for level in levels)


def branch_of(oscillator: Oscillator, name: BranchName) -> Branch:
    """Return the branch of a name; the positive one where there is no other."""
    return oscillator.positive if name == "positive" or oscillator.negative is None else oscillator.negative


def worst_branch_check(checks: Sequence[Check]) -> Check:
    """Return the check of the worse branch, with the smallest PGA at capacity and at uplift of all."""
    return replace(
        worst_check(checks),
        capacity_pga_g=least_known([check.capacity_pga_g for check in checks]),
        uplift_pga_g=least_known([check.uplift_pga_g for check in checks]),
    )


def least_known(values: Sequence[float | None]) -> float | None:
    """Return the smallest value; None where one is not known."""
    known = [value for value in values if value is not None]
    return min(known) if len(known) == len(values) else None


def worst_check(checks: Sequence[Check]) -> Check:
    """Return the check that fails, then the one with the larger demand/capacity, then the smaller PGA at capacity.

    Of equals the first is kept, that of the positive branch.
    """

    def severity(check: Check) -> tuple[bool, float, float]:
        ratio = inf if check.ratio is None else check.ratio
        at_collapse = inf if check.capacity_pga_g is None else check.capacity_pga_g
        return check.verdict == "fail", ratio, -at_collapse

    return max(checks, key=severity)
