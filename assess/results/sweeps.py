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
    overturning_rad of rigid joints, overturning_flexible_rad and elastic_frequency_hz on its own, None where rigid.
    demand_capacity [n]: the largest of the checks that decide, and capacity_pga_g [n] the least; where none decides, of
    all checks by the letter of a code at all levels; None where the mechanism overturned (overturned is true) or none
    is answered. outcome [n]: the verdict of the mechanism in each case. controlling: the case that is worst, from 0.
    governs: whether that case stands for the mechanism in `mechanisms` and in the comparison, as the worst of
    the mechanism's sweeps does.
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
