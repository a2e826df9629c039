"""An empirical fragility curve: the share of records that reach a state, between intensities at which they were run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class Empirical(ShortRepr):
    """Shares of records at intensities, linear in the logarithm of intensity between them; they need not rise.

    Below the first intensity and above the last its own share is held: nothing is known there.
    intensity [n] positive, rising; share [n] [-]
    """

    intensity: FloatArray
    share: FloatArray

    def probability(self, intensity: ArrayLike) -> FloatArray:
        """Return the share at each intensity, any shape [-]."""
        at = np.asarray(intensity, dtype=np.float64)
        with np.errstate(divide="ignore"):
            return np.asarray(np.interp(np.log(at), np.log(self.intensity), self.share))
