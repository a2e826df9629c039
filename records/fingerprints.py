"""SHA-256 of numbers, rounded so that the last digits of another machine do not change it."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from math import isclose

import numpy as np

from records.candidates import DAMPING, PERIODS
from records.record import Record
from spectra.spectrum import Spectrum

FIGURES = 6  # of an ordinate over the peak ground acceleration
STEP = 1e-4  # m/s2, to which samples are rounded
SAME_PGA = 1e-9  # relative difference of peak ground accelerations that are one


@dataclass(frozen=True)
class TargetMark:
    """What tells one target spectrum from another.

    code : as in the project file
    pga : peak ground acceleration [m/s2]
    sha256 : of the shape, the 5 % ordinates over the peak ground acceleration
    """

    code: str
    pga: float
    sha256: str

    def is_of(self, spectrum: Spectrum) -> bool:
        """Return whether a spectrum has this shape and this peak ground acceleration."""
        other = target_mark(spectrum)
        return other.sha256 == self.sha256 and isclose(other.pga, self.pga, rel_tol=SAME_PGA)


def target_mark(spectrum: Spectrum) -> TargetMark:
    """Return what tells a target spectrum from others."""
    period = PERIODS[spectrum.longest_period >= PERIODS]
    shape = spectrum.acceleration(period, damping=DAMPING) / spectrum.pga
    text = " ".join(f"{each:.{FIGURES}g}" for each in shape.tolist())
    return TargetMark(spectrum.code, spectrum.pga, hashlib.sha256(text.encode()).hexdigest())


def samples_sha256(record: Record) -> str:
    """Return the SHA-256 of the step and the samples of a record, rounded to 1e-4 m/s2."""
    rounded = np.round(record.acceleration / STEP).astype("<i8")
    return hashlib.sha256(f"{record.dt:.9g} ".encode() + rounded.tobytes()).hexdigest()
