"""The multiplier of linear checks, as a line of their calculation sheets."""

from __future__ import annotations

import numpy as np

from assess.codes.calculation_step import Given, Step, step
from assess.codes.table_steps import EVERY_POINT
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
    found, along = linear_multiplier(branch), multiplier(branch)
    if found <= float(along[0]):
        at_rest = {
            "V'(0) − M": (float(branch.restoring[0]), "N m"),
            "B0": (float(branch.excitation[0]), "kg m"),
        }
        return step(symbol, description, clause, "(V'(0) − M) / (g B0)", found, given=at_rest)
    standing = np.where(branch.rotation <= branch.unstable, along, -np.inf)
    place = int(np.argmax(standing))
    given: Given = {
        "R_m": (float(branch.restoring[place]), "N m"),
        "B_m": (float(branch.excitation[place]), "kg m"),
    }
    at = {"φ_m": (float(branch.rotation[place]), "rad")}
    return step(symbol, description, clause, "R_m / (g B_m)", found, given=given, remark=EVERY_POINT, at=at)
