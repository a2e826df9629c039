"""The multiplier of linear checks, worked out for the calculation sheets."""

from __future__ import annotations

from assess.oscillator import Branch, multiplier, resisted


def multiplier_worked(branch: Branch) -> tuple[str, str, float]:
    """Formula, numbers and value of `resisted`: the multiplier at rest, or on joints the largest of the curve [-]."""
    found = resisted(branch)
    if found > float(multiplier(branch)[0]):
        return "largest (V' − M) / (g B)", "of the curve", found
    return "(V'(0) − M) / (g B0)", f"{branch.restoring[0]:.5g} / (9.80665 · {branch.excitation[0]:.5g})", found
