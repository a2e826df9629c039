"""The arrays that describe a section to the kernel, and their columns."""

from __future__ import annotations

from spectra.arrays import FloatArray

# pieces, discs; depth [m], area [m2], centroid [m]: see `Section`
MomentTable = tuple[FloatArray, FloatArray, float, float, float]
# columns of `pieces` [m + 1, 12]: where the piece begins; its width W0 + W1 d and the integral of the offset over the
# width, V0 + V1 d + V2 d^2, at the distance d from there; up to there A, S, T and their integrals over depth
BEGIN, W0, W1, V0, V1, V2, A, S, T, SUM_A, SUM_S, SUM_T = range(12)
# columns of `discs` [d, 3]: radius [m], depth of its own edge [m], 1 where it adds and -1 where it takes away
RADIUS, EDGE, SIGN = range(3)
