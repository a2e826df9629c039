"""The multiplier of linear checks, worked out for the calculation sheets."""

from __future__ import annotations

from assess.codes.calculation_step import Step, step
from assess.oscillator import Branch, multiplier, resisted


def multiplier_step(symbol: str, description: str, clause: str, branch: Branch) -> Step:
    """The line of `resisted`: the multiplier at rest, or on joints the largest of the curve [-]."""
    found = resisted(branch)
    if found > float(multiplier(branch)[0]):
        return step(symbol, description, clause, "largest (V' − M) / (g B)", found, remark="of the curve")
    resisting, shaken = float(branch.restoring[0]), float(branch.excitation[0])
    given = {"V'(0) − M": (resisting, "N m"), "B0": (shaken, "kg m")}
    return step(symbol, description, clause, "(V'(0) − M) / (g B0)", found, given=given)
