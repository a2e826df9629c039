"""The key `amplification` of a mechanism: how the ground's motion reaches its base in histories and envelopes."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Tag

from assess.project.quantities import NotNegativeLength, PositiveFrequency, PositiveLength, PositiveRatio
from assess.project.section import Section, quote_names

METHODS = ("none", "srss", "srss-relative", "modal-filter", "ec8", "ec8-resonance", "ec8-printed", "nzs1170.5")


class NoAmplification(Section):
    """The ground's motion as it is."""

    method: Literal["none"] = "none"
    """"none\""""


class RaisedAmplification(Section):
    """What every method that amplifies needs."""

    height: NotNegativeLength | None = None
    """of the mechanism's base above the ground; by its elevation if absent"""


class FirstModeAmplification(RaisedAmplification):
    """The first mode of the structure, its shape linear in height."""

    method: Literal["srss", "srss-relative", "modal-filter"]
    """"srss" (thesis 3.48), "srss-relative" (pulses by 3.47), or "modal-filter": through the first mode"""
    natural_frequency: PositiveFrequency | None = None
    """first natural frequency, like "2.5 Hz"; [building]'s, or Rayleigh's of the bodies if absent"""
    effective_height: PositiveLength | None = None
    """height of the resultant of the first mode's inertia; [building]'s, or Rayleigh's of the bodies if absent"""


class FloorAmplification(RaisedAmplification):
    """A floor factor of a code, from the height of [building]."""

    method: Literal["ec8", "ec8-resonance", "nzs1170.5"]
    """"ec8" (EN 1998-1 4.3.5.2, rigid part), "ec8-resonance" (T_a = T_1), or "nzs1170.5" (8.3)"""


class PrintedAmplification(RaisedAmplification):
    """The floor factor of EN 1998-1 as thesis eq. 3.49 prints it."""

    method: Literal["ec8-printed"]
    """"ec8-printed": S [3 (1 + h/H) - 0.5]"""
    soil_factor: PositiveRatio
    """soil factor S, like 1.15"""


def _tag(value: Any) -> str | None:
    method = value.get("method") if isinstance(value, dict) else getattr(value, "method", None)
    return _TAGS.get(method) if isinstance(method, str) else None


_TAGS = {
    "none": "<none>",
    "srss": "<mode>",
    "srss-relative": "<mode>",
    "modal-filter": "<mode>",
    "ec8": "<floor>",
    "ec8-resonance": "<floor>",
    "nzs1170.5": "<floor>",
    "ec8-printed": "<printed>",
}

AmplificationSection = Annotated[
    Annotated[NoAmplification, Tag("<none>")]
    | Annotated[FirstModeAmplification, Tag("<mode>")]
    | Annotated[FloorAmplification, Tag("<floor>")]
    | Annotated[PrintedAmplification, Tag("<printed>")],
    Discriminator(
        _tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("method",), "names": quote_names(METHODS)},
    ),
]
