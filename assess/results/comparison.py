"""The comparison of mechanisms, levels and procedures."""

from __future__ import annotations

from dataclasses import dataclass

from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class ComparisonRow(ShortRepr):
    """One row of the comparison; rotation_ratio is None where the mechanism overturned or rotation is not known."""

    mechanism: str
    level_pga_g: float
    procedure: str
    rotation_ratio: float | None
    allowable_ratio: float | None
    demand_capacity: float | None
