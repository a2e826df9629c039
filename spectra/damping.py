"""What damping other than 5 % does to a design spectrum, one function for each code's rule."""

from __future__ import annotations

import numpy as np

from spectra.arrays import is_number
from spectra.errors import SpectrumError

B_DAMPING = (0.02, 0.05, 0.10, 0.20, 0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 1.00)
B_FACTOR = (0.8, 1.0, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0, 3.3, 3.6, 4.0)
ETA_FLOOR = 0.55


def asce7_b_factor(damping: float) -> float:
    """Return the damping coefficient B that spectral ordinates are divided by [-], for a `damping` ratio [-].

    Linear between the rows of the table; its first row is "2 % or less", its last "100 % or more".
    Raises SpectrumError for a negative damping or one that is not a number.
    Source: ASCE 7-16 Table 18.7-1 (7-05 and 7-10 Table 18.6-1); not checked against the printed standard.
    """
    return float(np.interp(check_damping(damping), B_DAMPING, B_FACTOR))


def ec8_eta(damping: float) -> float:
    """Return eta = sqrt(10 / (5 + xi)) >= 0.55 [-], by which damping of xi per cent multiplies ordinates.

    `damping` is the ratio xi / 100 [-]. Raises SpectrumError for a negative damping or one that is not a number.
    Source: EN 1998-1:2004, 3.2.2.2(3), eq. (3.6).
    """
    xi = 100.0 * check_damping(damping)
    return max(float(np.sqrt(10.0 / (5.0 + xi))), ETA_FLOOR)


def check_damping(damping: float) -> float:
    """Return the damping ratio [-]; refuse one that is negative or not finite."""
    if not (is_number(damping) and np.isfinite(damping) and damping >= 0.0):
        raise SpectrumError(f"damping ratio {damping}: it must be a number from 0 up (0.05 is 5 % of critical)")
    return damping
