"""Wilson's interval of a share.

Source: Wilson 1927, "Probable inference, the law of succession, and statistical inference", J. Am. Stat. Assoc. 22,
209-212; Brown, Cai and DasGupta 2001, Statistical Science 16(2), section 3.1.1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ndtri

from spectra.arrays import FloatArray


def wilson(reached: ArrayLike, records: ArrayLike, *, confidence: float = 0.95) -> tuple[FloatArray, FloatArray]:
    """Return the lower and upper bounds of the probability behind each share, each of the shape given.

    Records count as independent: those of one earthquake are not, and their interval is then too narrow.

    Parameters
    ----------
    reached : how many reach the state
    records : how many there are, at least one
    confidence : of the interval [-]
    """
    n = np.asarray(records, dtype=np.float64)
    p = np.asarray(reached, dtype=np.float64) / n
    z = float(ndtri(0.5 + 0.5 * confidence))
    centre = (p + z**2 / (2.0 * n)) / (1.0 + z**2 / n)
    half = z / (1.0 + z**2 / n) * np.sqrt(p * (1.0 - p) / n + z**2 / (4.0 * n**2))
    low = np.where(p == 0.0, 0.0, np.clip(centre - half, 0.0, 1.0))
    return low, np.where(p == 1.0, 1.0, np.clip(centre + half, 0.0, 1.0))
