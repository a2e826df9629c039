"""The motion at the base of a mechanism, compared with that of the ground."""

from __future__ import annotations

from dataclasses import dataclass

from assess.messages.message import Message
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class Factor(ShortRepr):
    """The factor by which a record is amplified up the building [-]."""

    record: str
    factor: float


@dataclass(frozen=True, repr=False)
class CarriedMotion(ShortRepr):
    """The record that is amplified most, scaled to the target, at the ground and at the base of the mechanism.

    Response spectra [k]: of 5 % damping.
    """

    record: str
    time_s: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats
    period_s: Floats
    ground_spectrum_g: Floats
    base_spectrum_g: Floats


@dataclass(frozen=True, repr=False)
class AmplificationResult(ShortRepr):
    """The amplification of the ground motion up to the mechanism.

    height_m: of its base above the ground, None where nothing is amplified; said: description of the method, with its
    numbers and assumptions; motion: present if the motion is filtered, not only multiplied.
    """

    method: str
    factors: tuple[Factor, ...]
    height_m: float | None = None
    said: tuple[Message | str, ...] = ()
    motion: CarriedMotion | None = None
