"""Parametric studies: one mechanism for several values of one number of the project."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.verdict import Decision
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class SweepResult(ShortRepr):
    """One mechanism for several values of one number of the project.

    value [n]: in `unit`, as the user wrote it, "-" for none. Parameters [n]: of the branch that uplifts first;
    overturning_rad with rigid joints; overturning_flexible_rad, elastic_frequency_hz: with its own, None if rigid.
    demand_capacity [n]: largest of the checks that decide, capacity_pga_g [n]: least of them; if none decides, of all
    checks by the letter of a code at all levels; None where the mechanism overturned (overturned is True) or no check
    was evaluated. outcome [n]: verdict of the mechanism in each case. controlling: the most critical case, from 0.
    governs: whether that case represents the mechanism in `mechanisms` and in the comparison.
    """

    mechanism: str
    key: str
    unit: str
    value: Floats
    p_eq_per_s: Floats
    uplift_multiplier: tuple[float | None, ...]
    overturning_rad: Floats
    overturning_flexible_rad: tuple[float | None, ...]
    elastic_frequency_hz: tuple[float | None, ...]
    restitution: Floats
    demand_capacity: tuple[float | None, ...]
    overturned: tuple[bool, ...]
    capacity_pga_g: tuple[float | None, ...]
    outcome: tuple[Decision, ...]
    controlling: int
    governs: bool
