"""The multiplier of linear checks, as a line of their calculation sheets."""

from __future__ import annotations

from assess.codes.calculation_step import Step, step
from assess.oscillator import Branch, linear_multiplier, multiplier


def multiplier_step(symbol: str, description: str, clause: str, branch: Branch) -> Step:
    """Write the multiplier at rest, or on flexible joints the largest of the curve [-].

    Parameters
    ----------
    symbol, description, clause : as the sheet prints them
    branch : the direction of rocking

    Returns
    -------
    Step
    """
    found = linear_multiplier(branch)
    if found > float(multiplier(branch)[0]):
        return step(symbol, description, clause, "largest (V' − M) / (g B)", found, remark="of the curve")
    resisting, shaken = float(branch.restoring[0]), float(branch.excitation[0])
    given = {"V'(0) − M": (resisting, "N m"), "B0": (shaken, "kg m")}
    return step(symbol, description, clause, "(V'(0) − M) / (g B0)", found, given=given)
