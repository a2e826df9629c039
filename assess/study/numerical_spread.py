"""The twins of a record: the same motion with the PGA times 1 + 10^-u and 1 - 10^-u, u = 3, 4, 5, 6, at every level.

Twins differ by less than any accelerograph resolves. Where a history is not chaotic they give the same digits; where it
is, they say how far its maximum can be trusted. That a record hardly rocks does not keep its twins small: of one that
reached 0.05 of the rotation that overturns, twins have reached 0.01 and 0.33.
"""

from __future__ import annotations

import numpy as np

EXPONENTS = (3, 4, 5, 6)
FACTORS = np.array([1.0, *(1.0 + sign * 10.0**-u for u in EXPONENTS for sign in (1.0, -1.0))])
"""On the PGA: of the record as it is, then of its eight twins [9]."""
TWINS, OUTER, INNER = slice(1, 9), slice(1, 3), slice(3, 9)  # of them: all twins, those with u = 3, the others
CALM = 0.01  # of the ratio: where outer twins differ by no more, the inner ones are not run in a scan
