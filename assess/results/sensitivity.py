"""How the answers of a mechanism move with one number at a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.check import Outcome, Role
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class SensitivityResult(ShortRepr):
    """One answer of a mechanism with one number at its low and at its high value, all others as they are.

    parameter : thickness, density, …; key : where it stands in the project, or the bodies it is of
    base, low, high : of the parameter [unit], None where it is not varied, for which `remark` says why
    role : whether the procedure decides the limit state at this level
    quantity : "demand_capacity" at level_pga_g, None where the body overturns or nothing is known; "index" of what
        decides, named by `index`; or "capacity_pga_g", of all levels, which procedures by histories do not have here;
        "" where nothing is varied
    """

    mechanism: str
    parameter: str
    remark: str
    key: str = ""
    unit: str = ""
    base: float | None = None
    low: float | None = None
    high: float | None = None
    procedure: str = ""
    limit_state: str = ""
    level_pga_g: float | None = None
    quantity: Literal["index", "capacity_pga_g", "demand_capacity", ""] = ""
    at_base: float | None = None
    at_low: float | None = None
    at_high: float | None = None
    verdict_base: Outcome | None = None
    verdict_low: Outcome | None = None
    verdict_high: Outcome | None = None
    role: Role = "comparison"
    index: str = ""
