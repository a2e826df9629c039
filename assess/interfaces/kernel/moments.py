"""Area A, first moments S and T and their integrals over depth, for a section of pieces and discs."""

from __future__ import annotations

import math

from assess.interfaces.kernel.columns import (
    BEGIN,
    EDGE,
    RADIUS,
    SIGN,
    SUM_A,
    SUM_S,
    SUM_T,
    V0,
    V1,
    V2,
    W0,
    W1,
    A,
    MomentTable,
    S,
    T,
)
from assess.interfaces.kernel.discs import integrate_disc
from assess.kernel import compiled
from spectra.arrays import FloatArray, IntArray

Five = tuple[float, float, float, float, float]
LONG = 1.0 / 64.0
"""Fraction of the depth of the section: the pieces of a shorter stretch are summed one by one, because a difference of
sums from the edge loses digits."""


@compiled
def integrate_piece(p: FloatArray, i: int, d0: float, d1: float, length: float) -> Five:
    """Return the integrals of `integrate_zone` from d0 to d1 inside piece i; length: d1 - d0, unrounded."""
    one, two = 0.5 * (d0 + d1), (d0 * d0 + d0 * d1 + d1 * d1) * (1 / 3)
    three = 0.25 * (d0 + d1) * (d0 * d0 + d1 * d1)
    w0, w1, x = p[i, W0], p[i, W1], p[i, BEGIN]
    area, rise = length * (w0 + w1 * one), w0 * one + 0.5 * w1 * two
    return (
        area,
        x * area + length * (w0 * one + w1 * two),
        length * (p[i, A] + rise),
        length * (p[i, S] + x * rise + 0.5 * w0 * two + (1 / 3) * w1 * three),
        length * (p[i, T] + p[i, V0] * one + 0.5 * p[i, V1] * two + (1 / 3) * p[i, V2] * three),
    )  # fmt: skip


@compiled
def find_piece(pieces: FloatArray, z: float, i: int) -> int:
    """Return the piece that holds the depth z, searching from piece i."""
    while i > 0 and z < pieces[i, BEGIN]:
        i -= 1
    while i < pieces.shape[0] - 2 and z >= pieces[i + 1, BEGIN]:
        i += 1
    return i


@compiled
def integrate_pieces(p: FloatArray, z0: float, z1: float, hint: IntArray) -> Five:
    """Return the integrals of `integrate_zone` for the pieces alone; hint [2]: the pieces of z0 and z1 last time."""
    i, j = find_piece(p, z0, hint[0]), find_piece(p, z1, hint[1])
    hint[0], hint[1] = i, j
    x0, x1 = p[i, BEGIN], p[j, BEGIN]
    if i == j:
        return integrate_piece(p, i, z0 - x0, z1 - x1, z1 - z0)
    n = i + 1
    a, s, f, g, h = integrate_piece(p, i, z0 - x0, p[n, BEGIN] - x0, p[n, BEGIN] - z0)
    if x1 - p[n, BEGIN] > LONG * p[p.shape[0] - 1, BEGIN]:
        a, s, f = a + (p[j, A] - p[n, A]), s + (p[j, S] - p[n, S]), f + (p[j, SUM_A] - p[n, SUM_A])
        g, h, n = g + (p[j, SUM_S] - p[n, SUM_S]), h + (p[j, SUM_T] - p[n, SUM_T]), j
    while n <= j:
        length = (z1 if n == j else p[n + 1, BEGIN]) - p[n, BEGIN]
        da, ds, df, dg, dh = integrate_piece(p, n, 0.0, length, length)
        a, s, f, g, h, n = a + da, s + ds, f + df, g + dg, h + dh, n + 1
    return a, s, f, g, h


@compiled
def integrate_zone(table: MomentTable, z0: float, z1: float, hint: IntArray) -> Five:
    """Integrate width, depth times width, A, S and T over depth from z0 to z1."""
    pieces, discs, _, _, _ = table
    a, s, f, g, h = 0.0, 0.0, 0.0, 0.0, 0.0
    if pieces.shape[0] > 0:
        a, s, f, g, h = integrate_pieces(pieces, z0, z1, hint)
    for n in range(discs.shape[0]):
        da, ds, df, dg = integrate_disc(discs[n, RADIUS], discs[n, EDGE], z0, z1)
        a, s, f, g = a + discs[n, SIGN] * da, s + discs[n, SIGN] * ds, f + discs[n, SIGN] * df, g + discs[n, SIGN] * dg
    return a, s, f, g, h


@compiled
def width(table: MomentTable, z: float, i: int) -> float:
    """Return the width of the section at the depth z [m]; i: a piece near it."""
    pieces, discs, _, _, _ = table
    total = 0.0
    if pieces.shape[0] > 0:
        i = find_piece(pieces, z, i)
        total = pieces[i, W0] + pieces[i, W1] * (z - pieces[i, BEGIN])
    for n in range(discs.shape[0]):
        x = z - discs[n, EDGE]
        total += discs[n, SIGN] * 2.0 * math.sqrt(max(x * (2.0 * discs[n, RADIUS] - x), 0.0))
    return total


@compiled
def moments_upto(table: MomentTable, z: float, i: int) -> tuple[float, float, float]:
    """Return area [m2] and first moments by depth and across [m3] up to the depth z; i: a piece near it."""
    p, discs, _, _, _ = table
    a, s, t = 0.0, 0.0, 0.0
    if p.shape[0] > 0:
        i = find_piece(p, z, i)
        d = z - p[i, BEGIN]
        rise = d * (p[i, W0] + d * 0.5 * p[i, W1])
        a, s = p[i, A] + rise, p[i, S] + p[i, BEGIN] * rise + d * d * (0.5 * p[i, W0] + (1 / 3) * d * p[i, W1])
        t = p[i, T] + d * (p[i, V0] + d * (0.5 * p[i, V1] + (1 / 3) * d * p[i, V2]))
    for n in range(discs.shape[0]):
        da, ds, _, _ = integrate_disc(discs[n, RADIUS], discs[n, EDGE], 0.0, z)
        a, s = a + discs[n, SIGN] * da, s + discs[n, SIGN] * ds
    return a, s, t
