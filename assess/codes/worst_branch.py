"""Every procedure runs on both branches at every level; the worse branch is the answer."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import inf

from assess.codes.check import BranchName, Check
from assess.oscillator import Branch, Oscillator

OneCheck = Callable[[Branch, BranchName, float], Check]
NAMES: tuple[BranchName, BranchName] = ("positive", "negative")


def check_worst_branch(oscillator: Oscillator, levels: Sequence[float], one: OneCheck) -> tuple[Check, ...]:
    """For each PGA of `levels` [m/s2] the worse of `one(branch, name, level)` over the oscillator's branches.

    PGA at capacity and at uplift are the smaller of the branches', whichever is the worse at the level. Of a branch
    that serves both ways the positive one is asked.
    """
    branches = tuple(dict.fromkeys(oscillator.branches))
    named = tuple(zip(branches, NAMES, strict=False))
    return tuple(worst_branch_check([one(branch, name, level) for branch, name in named]) for level in levels)


def branch_of(oscillator: Oscillator, name: BranchName) -> Branch:
    """The branch of a check; the positive one where there is no other."""
    return oscillator.positive if name == "positive" or oscillator.negative is None else oscillator.negative


def worst_branch_check(checks: Sequence[Check]) -> Check:
    """The check of the worse branch, with the smaller PGA at capacity and at uplift of all."""
    return replace(
        worst_check(checks),
        capacity_pga_g=least_known([check.capacity_pga_g for check in checks]),
        uplift_pga_g=least_known([check.uplift_pga_g for check in checks]),
    )


def least_known(values: Sequence[float | None]) -> float | None:
    """The smallest, None where one is not known."""
    known = [value for value in values if value is not None]
    return min(known) if len(known) == len(values) else None


def worst_check(checks: Sequence[Check]) -> Check:
    """The check that fails, then the one with the larger demand/capacity, then the smaller PGA at collapse.

    The first of equals (the positive branch) stands.
    """

    def severity(check: Check) -> tuple[bool, float, float]:
        ratio = inf if check.ratio is None else check.ratio
        at_collapse = inf if check.capacity_pga_g is None else check.capacity_pga_g
        return check.verdict == "fail", ratio, -at_collapse

    return max(checks, key=severity)
