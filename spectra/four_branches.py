"""The curve that EN 1998-1 and the Italian code share: rising, level, falling as 1/T, falling as 1/T^2."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from spectra.arrays import FloatArray
from spectra.damping import ec8_eta
from spectra.spectrum import check_periods

DISPLACEMENT_FACTOR = 0.025  # of d_g = 0.025 a_g S T_C T_D; 1 / (2 pi)^2 rounded, so that S_De steps by 1.3 % at T_E


@dataclass(frozen=True)
class FourBranches:
    """An elastic spectrum of four branches.

    ground : ordinate at zero period, a_g S [m/s2]
    amplification : ordinate of the level branch over `ground` at 5 % damping: 2.5, 3.0 or F_0 [-]
    t_b, t_c, t_d : corner periods [s]
    """

    ground: float
    amplification: float
    t_b: float
    t_c: float
    t_d: float

    def ordinates(self, period: FloatArray, damping: float) -> FloatArray:
        """Return S_e [m/s2] at `period` [s] (same shape) and `damping` [-].

            T < T_B           a (1 + T / T_B (eta F - 1))         a = ground, F = amplification
            T_B <= T <= T_C   a eta F
            T_C < T <= T_D    a eta F T_C / T
            T > T_D           a eta F T_C T_D / T^2

        Source: EN 1998-1:2004 (3.2)-(3.5); NTC 2018 (3.2.2), whose first branch is the same in other letters.
        """
        a, F, T_B = self.ground, ec8_eta(damping) * self.amplification, self.t_b
        T = np.maximum(check_periods(period), T_B)
        falling = a * F * np.minimum(1.0, self.t_c / T) * np.minimum(1.0, self.t_d / T)
        return np.asarray(np.where(period < T_B, a * (1.0 + period / T_B * (F - 1.0)), falling), dtype=np.float64)

    def displacements(self, period: FloatArray, damping: float, *, t_e: float, t_f: float) -> FloatArray:
        """Return S_De [m] at `period` [s] (same shape): S_e (T / 2 pi)^2 up to T_E, then towards d_g, reached at T_F.

        Source: EN 1998-1:2004 (3.7), Annex A (A.1), (A.2), (3.12); NTC 2018 (3.2.10)-(3.2.12).
        """
        F, T = ec8_eta(damping) * self.amplification, check_periods(period)
        d_g = DISPLACEMENT_FACTOR * self.ground * self.t_c * self.t_d
        towards = np.clip((T - t_e) / (t_f - t_e), 0.0, 1.0)
        short = self.ordinates(np.minimum(T, t_e), damping) * (np.minimum(T, t_e) / (2.0 * np.pi)) ** 2
        return np.asarray(np.where(towards > 0.0, d_g * (F + towards * (1.0 - F)), short), dtype=np.float64)
