"""One answer of one code procedure: demand beside capacity, and every step between."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

Role = Literal["code", "informative"]
NO_LASTING = "yet the method finds no lasting rotation at this demand"  # how a reason ends: it lifts off
GROUND_AT_HEIGHT = (  # in a caveat
    "at height the motion of the ground is taken as it is: unconservative where the building amplifies it"
)
BEYOND_SPECTRUM = "rotation beyond the allowable, and beyond the end of the spectrum"  # a reason
Verdict = Literal["pass", "fail", "not-applicable"]
BranchName = Literal["positive", "negative"]
InputAt = Literal["ground", "mechanism base"]
Bound = Literal["", "<=", ">="]
Unbounded = Literal["", "overturned", "beyond the spectrum"]


@dataclass(frozen=True)
class Step:
    """One line of a calculation sheet: the formula, the numbers put into it, and what came out.

    bound : "<=" or ">=" where all that is known is that it is no more, or no less, than `value`
    """

    symbol: str
    description: str
    clause: str
    formula: str
    substituted: str
    value: float | None
    unit: str
    bound: Bound = ""


@dataclass(frozen=True)
class PgaCurve:
    """Peak ground acceleration that takes the mechanism to each rotation, by one procedure.

    rotation_ratio [n]: rotation / rigid overturning rotation; pga_g [n]: in g.
    """

    rotation_ratio: tuple[float, ...]
    pga_g: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class Check:
    """Demand, capacity, ratio and verdict of one procedure at one level, with the steps that led there.

    `demand`, `capacity` are in `unit` and measure `quantity`; None where there is no finite value (a body that
    overturns has no largest rotation). `uplift_pga_g` is None on joints that answer to any motion. `caveat` says what
    could not be compared with the printed standard. A check that does not apply leaves its numbers out.
    `rotation_ratio` and `allowable_ratio` put the same answer as rotation /
    rigid overturning rotation of the branch, None where the procedure knows no rotation or the body overturned.
    `score`: what the code itself counts the answer in, by name, as {"%NBS": 43.1}; empty where it has nothing.
    `safety_index` (capacity over demand, both as PGA) and `return_period_years` of the capacity stand where the code
    and the site have them; `return_period_bound` is "<=" or ">=" where the capacity lies beyond the rows of the hazard,
    whose end it then is.
    """

    procedure: str
    edition: str
    role: Role
    branch: BranchName
    limit_state: str
    level_pga_g: float
    input_at: InputAt
    damping: float | None
    damping_rule: str = ""
    quantity: str
    unit: str
    demand: float | None = None
    capacity: float | None = None
    ratio: float | None = None
    verdict: Verdict
    reason: str
    capacity_pga_g: float | None = None
    uplift_pga_g: float | None = None
    capacity_rotation_ratio: float | None = None
    rotation_ratio: float | None = None
    pga_curve: PgaCurve = PgaCurve((), ())
    steps: tuple[Step, ...] = ()
    caveat: str = ""
    score: dict[str, float] = field(default_factory=dict)
    safety_index: float | None = None
    return_period_years: float | None = None
    return_period_bound: Bound = ""

    @property
    def unbounded(self) -> Unbounded:
        """Why it fails without a finite demand: the body overturns, or the spectrum ends first; "" where it slides."""
        if self.verdict != "fail" or self.demand is not None or self.quantity == "sliding":
            return ""
        return "beyond the spectrum" if self.reason == BEYOND_SPECTRUM else "overturned"
