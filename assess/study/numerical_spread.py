"""The twins of a record: the same motion with the PGA times 1 + 10^-u and 1 - 10^-u, u = 3, 4, 5, 6, at every level.

Twins differ by less than any accelerograph resolves. Where a history is not chaotic they give the same digits; where it
is, they say how far its maximum can be trusted. A record that hardly rocks keeps all of its twins short of what codes
allow, so that a scan over rising PGA may run it alone (see `still_below`).
"""

from __future__ import annotations

import numpy as np

from assess.mechanisms.limits import limits
from assess.mechanisms.mechanism import Mechanism

EXPONENTS = (3, 4, 5, 6)
FACTORS = np.array([1.0, *(1.0 + sign * 10.0**-u for u in EXPONENTS for sign in (1.0, -1.0))])
"""On the PGA: of the record as it is, then of its eight twins [9]."""
TWINS, OUTER, INNER = slice(1, 9), slice(1, 3), slice(3, 9)  # of them: all twins, those with u = 3, the others
CALM = 0.01  # of the ratio: outer twins that differ by no more leave the inner ones nowhere else to be
LEAST_SHARE = 0.4  # of the rotation that overturns: the least that a code allows a suite of histories
GROWTH = 4.0  # by how much a twin of a record that hardly rocks may exceed it, at most


def still_below(mechanism: Mechanism) -> float:
    """Return the ratio |rotation| / phi_ov below which no twin of a record reaches what a code allows.

    A quarter of the least rotation allowed: 0.4 of what overturns the mechanism with its joints, or where a seat is
    lost or an action ends.

    Parameters
    ----------
    mechanism : Mechanism
        Whose histories are run.
    """
    oscillator = mechanism.variants.deciding
    sides = dict(zip(("positive", "negative"), oscillator.branches, strict=False))
    allowed = [LEAST_SHARE * side.unstable / side.overturning for side in sides.values()]
    allowed += [each.rotation / sides[each.branch].overturning for each in limits(mechanism) if each.branch in sides]
    return min(allowed) / GROWTH
