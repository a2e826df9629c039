"""The table [analysis.pulses]: the pulses of overturning envelopes."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StrictInt, model_validator
from scipy.constants import g

from assess.project.quantities import Acceleration, Angle, PositiveFrequency, Ratio
from assess.project.section import Section, wrong

MOST = 1000  # frequencies or amplitudes
WITH_GAMMA = "mavroeidis-papageorgiou"


class Frequencies(Section):
    """The frequencies of the pulses: { from, to, count }."""

    start: PositiveFrequency = Field(0.2, alias="from")
    """the first"""
    to: PositiveFrequency = 10.0
    """the last"""
    count: Annotated[StrictInt, Field(ge=2, le=MOST)] = 100
    """how many, with both ends"""
    spacing: Literal["linear", "log"] = "linear"
    """"linear", or "log" for a constant ratio"""

    @model_validator(mode="after")
    def _rise(self) -> Frequencies:
        if not self.to > self.start:
            raise wrong("to", f"{self.to:g} Hz, not above from, {self.start:g} Hz; frequencies rise")
        return self


class Amplitudes(Section):
    """The peak accelerations of the pulses: { from, to, count }."""

    start: Annotated[Acceleration, Field(ge=0)] = Field(0.0, alias="from")
    """the first"""
    to: Annotated[Acceleration, Field(gt=0)] = 3 * g
    """the last, up to which the least pulse that overturns is sought"""
    count: Annotated[StrictInt, Field(ge=2, le=MOST)] = 100
    """how many, with both ends"""

    @model_validator(mode="after")
    def _rise(self) -> Amplitudes:
        if not self.to > self.start:
            raise wrong("to", f"{self.to / g:g} g, not above from, {self.start / g:g} g; amplitudes rise")
        return self


class Pulses(Section):
    """Overturning envelopes: pulses of the ground by frequency and amplitude; without this table `run` makes none."""

    shape: Literal["sine", "cosine", "half-sine", "ricker", "ricker-antisymmetric", "mavroeidis-papageorgiou"] = "sine"
    """shape of the acceleration"""
    frequency: Frequencies = Field(default_factory=Frequencies)
    """{ from, to, count } of the frequencies"""
    amplitude: Amplitudes = Field(default_factory=Amplitudes)
    """{ from, to, count } of the peak ground accelerations"""
    gamma: Annotated[Ratio, Field(gt=1, le=50)] | None = None
    """of a mavroeidis-papageorgiou pulse: more is longer; 2 if absent"""
    nu: Angle | None = None
    """of a mavroeidis-papageorgiou pulse: phase of its carrier; 0 if absent"""

    @model_validator(mode="after")
    def _only_one_shape_has_parameters(self) -> Pulses:
        for key in ("gamma", "nu"):
            if getattr(self, key) is not None and self.shape != WITH_GAMMA:
                raise wrong(key, f'not of a pulse "{self.shape}"; only "{WITH_GAMMA}" has it, remove it')
        return self
