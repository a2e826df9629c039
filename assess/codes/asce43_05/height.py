"""A mechanism above the ground whose check takes the ground's motion: the check says that nothing is amplified."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.check import GROUND_AT_HEIGHT, Check, Step
from assess.codes.context import ON_GROUND, Context


def told(checks: tuple[Check, ...], *, context: Context) -> tuple[Check, ...]:
    """The checks, those of a mechanism at height by the ground's motion with that in the caveat and on the sheet."""
    return checks if context.elevation <= ON_GROUND else tuple(_told(check, context.elevation) for check in checks)


def _told(check: Check, elevation: float) -> Check:
    if check.input_at != "ground":
        return check
    words = "height of the base above the ground; the motion is that of the ground, not amplified"
    step = Step("z", words, "", "z_base − z_ground", "geometry", elevation, "m")
    return replace(check, caveat=f"{check.caveat}; {GROUND_AT_HEIGHT}", steps=(step, *check.steps))
