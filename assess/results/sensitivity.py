"""How the answers of a mechanism change with one number at a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.check import Outcome, Role
from assess.messages.message import Message, Term
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class SensitivityResult(ShortRepr):
    """One answer of a mechanism with one number at its low and at its high value, all others unchanged.

    parameter : thickness, density, …; key : its key in the project, or the bodies it belongs to
    base, low, high : of the parameter [unit], None if it is not varied, for the reason in `remarks`
    remark : the English of `remarks`
    role : whether the procedure decides the limit state at this level
    quantity : "demand_capacity" at level_pga_g, None where the body overturns or there is no answer; "index" of the
        check that decides, named by `index`; "capacity_pga_g", of all levels, which procedures by histories do not have
        here; "" if nothing is varied
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
    remarks: tuple[Term | Message, ...] = ()
