"""Checks of a mechanism above the ground that take the ground's motion: they say that nothing is amplified."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.check import Check, step
from assess.codes.context import Context
from assess.messages.message import Severity, message


def warn_at_height(checks: tuple[Check, ...], *, context: Context) -> tuple[Check, ...]:
    """Add a warning and a line of the sheet to checks by the ground's motion of a mechanism above the ground."""
    return tuple(_with_height(check, context.support_height) for check in checks) if context.above_ground else checks


def _with_height(check: Check, height: float) -> Check:
    if check.input_at != "ground":
        return check
    words = "height of what holds the mechanism; the motion is that of the ground, not amplified"
    line = step("z", words, "geometry", "z_base − z_ground", height, "m")
    remark = message("ground-motion", severity=Severity.WARNING)
    return replace(check, remarks=(*check.remarks, remark), steps=(line, *check.steps))
