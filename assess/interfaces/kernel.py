"""The contact of two faces in relative rotation, compiled: no tension, linear up to the strength, plastic beyond.

With the depth z from the compressed edge, closing u_e of that edge and rotation phi, the stress is

    sigma(z) = clip(k (u_e - phi z), 0, f)        open beyond a = u_e / phi, crushed up to a_2 = (u_e - f / k) / phi

Let A(z), S(z), T(z) be area, first moment of depth and first moment across, of the part of the section up to z. As
clip(k u, 0, f) = k <u> - k <u - f / k>, what the stress carries is an integral over the elastic zone alone,

    N = k phi int A dz        N a_f = k phi int S dz        N t = k phi int T dz        z from a_2 to a

(beyond the far edge A stays constant), so that no closed form for each regime is needed, and every term is positive.
k phi = f / (a - a_2): where the zone lies inside the section these are f times the means of A, S, T, which remain exact
for a stiff joint, whose zone is thin.

A section is made of pieces, in each of which the width is linear, and of discs, which count as positive or negative.
"""

from __future__ import annotations

import math

import numpy as np

from assess.kernel import compiled, entry, reachable
from spectra.arrays import FloatArray, IntArray

# pieces, discs; depth [m], area [m2], centroid [m]: see `Section`
Table = tuple[FloatArray, FloatArray, float, float, float]
Given = tuple[float, float, float]  # stiffness k [Pa/m], strength f [Pa], rotation phi [rad]
Four = tuple[float, float, float, float]
Five = tuple[float, float, float, float, float]

# columns of `pieces` [m + 1, 12]: where the piece begins; its width W0 + W1 d and the integral of the offset over the
# width, V0 + V1 d + V2 d^2, at the distance d from there; up to there A, S, T and their integrals over depth
BEGIN, W0, W1, V0, V1, V2, A, S, T, SUM_A, SUM_S, SUM_T = range(12)
# columns of `discs` [d, 3]: radius [m], depth of its own edge [m], 1 where it adds and -1 where it takes away
RADIUS, EDGE, SIGN = range(3)
# columns of `found` [n, 9], as the attributes of `Contact`
RESULTANT, SIDEWAYS, PIVOT, CLOSING, DEPTH, CRUSHED_DEPTH, PEAK_STRESS, OPEN_AREA, CRUSHED_AREA = range(9)
# what `find` looks for: the closing that carries a force, the depth of a plastic block, of a triangle at the strength
FORCE, PLASTIC, CRUSHING = range(3)

LONG = 1.0 / 64.0
"""Of the depth of the section: the pieces of a shorter stretch are summed one by one, because the difference of sums
from the edge loses digits."""
SHORT = 0.1
"""Arc of a disc [rad], about, below which the integrals of its width are taken by Gauss' rule, exact there to rounding,
because the difference of closed forms loses digits."""
SHALLOW = 0.5
"""Of the radius: down to here the moments of a disc are power series, because their closed forms lose digits."""
THIN = 1e-9
"""Of the plastic depth: a thinner elastic zone is none; what it moves goes with the square of this."""
CLOSE = 1e-9
"""Relative length of a step of Newton's method after which the error, which goes with its square, is rounding."""
ROUNDING = 1e-15
"""Relative width of a bracket that need not shrink any more."""

POWERS = np.arange(22.0)
# the width of a disc, 2 (2 x)^(1/2) (1 - x / 2)^(1/2), in powers of its depth x; then integrated term by term
BINOMIAL = np.cumprod(np.append(2.0 * math.sqrt(2.0), (POWERS[1:] - 1.5) / POWERS[1:] / 2.0))
SERIES = BINOMIAL[:, None] / np.column_stack([
    POWERS + 1.5, POWERS + 2.5, (POWERS + 1.5) * (POWERS + 2.5), (POWERS + 2.5) * (POWERS + 3.5),
])  # fmt: skip
NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)


# ------------------------------------------------------------------------------------------------ moments of a section


@compiled
def disc_upto(x: float) -> Four:
    """A, S and their integrals over depth of a disc of radius 1, up to the depth x in [0, 2] from its edge."""
    if x > SHALLOW:
        sine, cosine = math.sqrt(x * (2.0 - x)), 1.0 - x
        angle, cube = math.acos(cosine), 2.0 / 3.0 * sine**3
        area = angle - sine * cosine
        first = area - cube
        second = area - 2.0 * cube + (angle + sine * cosine * (2.0 * sine**2 - 1.0)) / 4.0
        return area, first, x * area - first, x * first - second
    area, first, area_sum, first_sum = 0.0, 0.0, 0.0, 0.0
    for n in range(SERIES.shape[0] - 1, -1, -1):
        area, first = area * x + SERIES[n, 0], first * x + SERIES[n, 1]
        area_sum, first_sum = area_sum * x + SERIES[n, 2], first_sum * x + SERIES[n, 3]
    root = math.sqrt(x) * x
    return area * root, first * root * x, area_sum * root * x, first_sum * root * x * x


@compiled
def disc_between(x0: float, x1: float, length: float) -> Four:
    """Integrals over depth of width, depth times width, A and S of a disc of radius 1; length: x1 - x0, unrounded."""
    if x0 <= 0.0:
        return disc_upto(x1)
    a0, s0, f0, g0 = disc_upto(x0)
    if length > SHORT * math.sqrt(x1 * (2.0 - x0)):
        a1, s1, f1, g1 = disc_upto(x1)
        return a1 - a0, s1 - s0, f1 - f0, g1 - g0
    area, first, area_sum, first_sum = 0.0, 0.0, a0 * length, s0 * length
    start, end = 2.0 * math.asin(math.sqrt(0.5 * x0)), 2.0 * math.asin(math.sqrt(0.5 * x1))
    middle, half = 0.5 * (start + end), 0.5 * (end - start)
    for n in range(NODES.size):
        angle = middle + half * NODES[n]
        x, part = 2.0 * math.sin(0.5 * angle) ** 2, 2.0 * half * WEIGHTS[n] * math.sin(angle) ** 2
        area, first = area + part, first + x * part
        area_sum, first_sum = area_sum + (x1 - x) * part, first_sum + (x1 - x) * x * part
    return area, first, area_sum, first_sum


@compiled
def of_disc(radius: float, edge: float, z0: float, z1: float) -> Four:
    """Integrals from z0 to z1 of width, depth times width, A and S of a disc, by depth from the section's edge."""
    end = edge + 2.0 * radius
    low, high, beyond = max(z0, edge), min(z1, end), max(z1 - max(z0, end), 0.0)
    area, first, area_sum, first_sum = 0.0, 0.0, 0.0, 0.0
    if high > low:
        x0, x1 = max((low - edge) / radius, 0.0), min((high - edge) / radius, 2.0)
        area, first, area_sum, first_sum = disc_between(x0, x1, (high - low) / radius)
    square, whole = radius * radius, math.pi * radius * radius
    area, first, area_sum = square * area, square * radius * first, square * radius * area_sum + whole * beyond
    first_sum = square * square * first_sum + whole * radius * beyond
    return area, first + edge * area, area_sum, first_sum + edge * area_sum


@compiled
def of_piece(p: FloatArray, i: int, d0: float, d1: float, length: float) -> Five:
    """As `zone`, from d0 to d1 inside piece i; length: d1 - d0, unrounded."""
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
def piece(pieces: FloatArray, z: float, i: int) -> int:
    """The piece that holds the depth z, looked for from piece i on."""
    while i > 0 and z < pieces[i, BEGIN]:
        i -= 1
    while i < pieces.shape[0] - 2 and z >= pieces[i + 1, BEGIN]:
        i += 1
    return i


@compiled
def of_pieces(p: FloatArray, z0: float, z1: float, hint: IntArray) -> Five:
    """As `zone`, for the pieces alone; hint [2]: where z0 and z1 were last time."""
    i, j = piece(p, z0, hint[0]), piece(p, z1, hint[1])
    hint[0], hint[1] = i, j
    x0, x1 = p[i, BEGIN], p[j, BEGIN]
    if i == j:
        return of_piece(p, i, z0 - x0, z1 - x1, z1 - z0)
    n = i + 1
    a, s, f, g, h = of_piece(p, i, z0 - x0, p[n, BEGIN] - x0, p[n, BEGIN] - z0)
    if x1 - p[n, BEGIN] > LONG * p[p.shape[0] - 1, BEGIN]:
        a, s, f = a + (p[j, A] - p[n, A]), s + (p[j, S] - p[n, S]), f + (p[j, SUM_A] - p[n, SUM_A])
        g, h, n = g + (p[j, SUM_S] - p[n, SUM_S]), h + (p[j, SUM_T] - p[n, SUM_T]), j
    while n <= j:
        length = (z1 if n == j else p[n + 1, BEGIN]) - p[n, BEGIN]
        da, ds, df, dg, dh = of_piece(p, n, 0.0, length, length)
        a, s, f, g, h, n = a + da, s + ds, f + df, g + dg, h + dh, n + 1
    return a, s, f, g, h


@compiled
def zone(table: Table, z0: float, z1: float, hint: IntArray) -> Five:
    """Integrals over depth from z0 to z1 of width and depth times width; of A, S and T."""
    pieces, discs, _, _, _ = table
    a, s, f, g, h = 0.0, 0.0, 0.0, 0.0, 0.0
    if pieces.shape[0] > 0:
        a, s, f, g, h = of_pieces(pieces, z0, z1, hint)
    for n in range(discs.shape[0]):
        da, ds, df, dg = of_disc(discs[n, RADIUS], discs[n, EDGE], z0, z1)
        a, s, f, g = a + discs[n, SIGN] * da, s + discs[n, SIGN] * ds, f + discs[n, SIGN] * df, g + discs[n, SIGN] * dg
    return a, s, f, g, h


@compiled
def width(table: Table, z: float, i: int) -> float:
    """Width of the section at the depth z [m]; i: a piece near it."""
    pieces, discs, _, _, _ = table
    total = 0.0
    if pieces.shape[0] > 0:
        i = piece(pieces, z, i)
        total = pieces[i, W0] + pieces[i, W1] * (z - pieces[i, BEGIN])
    for n in range(discs.shape[0]):
        x = z - discs[n, EDGE]
        total += discs[n, SIGN] * 2.0 * math.sqrt(max(x * (2.0 * discs[n, RADIUS] - x), 0.0))
    return total


@compiled
def upto(table: Table, z: float, i: int) -> tuple[float, float, float]:
    """Area [m2], first moment by depth and across [m3] up to the depth z; i: a piece near it."""
    p, discs, _, _, _ = table
    a, s, t = 0.0, 0.0, 0.0
    if p.shape[0] > 0:
        i = piece(p, z, i)
        d = z - p[i, BEGIN]
        rise = d * (p[i, W0] + d * 0.5 * p[i, W1])
        a, s = p[i, A] + rise, p[i, S] + p[i, BEGIN] * rise + d * d * (0.5 * p[i, W0] + (1 / 3) * d * p[i, W1])
        t = p[i, T] + d * (p[i, V0] + d * (0.5 * p[i, V1] + (1 / 3) * d * p[i, V2]))
    for n in range(discs.shape[0]):
        da, ds, _, _ = of_disc(discs[n, RADIUS], discs[n, EDGE], 0.0, z)
        a, s = a + discs[n, SIGN] * da, s + discs[n, SIGN] * ds
    return a, s, t


# ---------------------------------------------------------------------------------------------------------- equilibrium


@compiled
def extent(table: Table, given: Given, closing: float) -> tuple[float, float, float]:
    """Depth crushed, depth in contact [m], and closing of the far edge, zero where that is open [m].

    Where the contact is crushed, the last is what makes the stress at a_2 the strength, however thin the zone is.
    """
    k, f, phi = given
    over = closing - phi * table[2]
    a = table[2] if over >= 0.0 else closing / phi
    if k * closing <= f:
        return 0.0, a, max(over, 0.0)
    a_2 = min((closing - f / k) / phi, a)
    return a_2, a, max(f / k - phi * (a - a_2), 0.0) if over > 0.0 else 0.0


@compiled
def scale(given: Given, a_2: float, a: float, over: float) -> float:
    """Stress that falls off over a unit of depth [Pa/m]: k phi, in such a form that force and strength agree."""
    k, f, phi = given
    return f / (a - a_2) if a_2 > 0.0 and over == 0.0 else k * phi


@compiled
def by_closing(table: Table, given: Given, closing: float, hint: IntArray) -> tuple[float, float]:
    """Force [N], and its derivative by the closing of the compressed edge."""
    a_2, a, over = extent(table, given, closing)
    elastic, _, f, _, _ = zone(table, a_2, a, hint)
    return scale(given, a_2, a, over) * f + given[0] * over * table[3], given[0] * elastic


@compiled
def by_plastic_depth(table: Table, given: Given, z: float, hint: IntArray) -> tuple[float, float]:
    """Area up to z [m2], and its derivative."""
    return upto(table, z, hint[1])[0], width(table, z, hint[1])


@compiled
def by_crushing_depth(table: Table, given: Given, z: float, hint: IntArray) -> tuple[float, float]:
    """Force over strength [m2] of a triangle of stress up to z, and its derivative."""
    _, s, f, _, _ = zone(table, 0.0, z, hint)
    return f / z, s / z**2


@compiled
def rising(which: int, table: Table, given: Given, x: float, hint: IntArray) -> tuple[float, float]:
    """One of the functions above, all of which increase, and its derivative.

    A number says which, and not a function handed over or closed over: numba caches no entry point with the former,
    and the latter get one name, under which the caches of two entry points, once both are loaded, are mistaken.
    """
    if which == FORCE:
        return by_closing(table, given, x, hint)
    if which == PLASTIC:
        return by_plastic_depth(table, given, x, hint)
    return by_crushing_depth(table, given, x, hint)


@reachable
def find(which: int, table: Table, given: Given, target: float, start: float, high: float, hint: IntArray) -> float:
    """Where one of the functions reaches a target between 0 and `high`.

    Newton's method inside a bracket that only shrinks. Far away its steps are taken in logarithms, in which these
    functions, near to powers, are near to straight lines.
    """
    low, x, step = 0.0, start, high
    for _ in range(200):
        value, rate = rising(which, table, given, x, hint)
        if value > target:
            high = x
        else:
            low = x
        new, longest, close = x + (target - value) / rate, 0.5 * step, CLOSE
        if not 0.5 * target < value < 2.0 * target:
            new, longest = x * (target / value) ** (value / (x * rate)), high
        step = abs(new - x)
        if not (low <= new <= high and step <= longest):
            new, step, close = 0.5 * (low + high), 0.5 * (high - low), ROUNDING
        x = new
        if step <= close * x:
            break
    return x


@reachable
def closing(table: Table, given: Given, force: float, plastic: float, near: float, hint: IntArray) -> float:
    """Closing of the compressed edge under a force [m].

    plastic: depth of the plastic block [m]; near: what it is likely to be, or nan.
    """
    k, f, phi = given
    _, _, depth, area, centroid = table
    linear = force / (k * area) + phi * centroid
    if phi == 0.0 or (phi * depth <= linear and k * linear <= f):
        return linear
    most, start = force / (k * area) + phi * depth, linear
    if f < math.inf:
        most, start = f / k + phi * depth, min(phi * plastic + 0.5 * f / k, linear)
    return find(FORCE, table, given, force, near if 0.0 < near < most else start, most, hint)


@reachable
def rigid(table: Table, given: Given, plastic: float, found: FloatArray) -> None:
    """The contact of a joint without elastic zone; fills found [9]."""
    found[:] = 0.0
    if plastic > 0.0:
        crushed, first, side = upto(table, plastic, 0)
        found[RESULTANT], found[SIDEWAYS], found[CRUSHED_AREA] = first / crushed, side / crushed, crushed
    found[PIVOT], found[CLOSING], found[DEPTH], found[CRUSHED_DEPTH] = plastic, given[2] * plastic, plastic, plastic
    found[PEAK_STRESS], found[OPEN_AREA] = given[1], table[3] - found[CRUSHED_AREA]


@reachable
def elastic(table: Table, given: Given, u: float, hint: IntArray, found: FloatArray) -> None:
    """The contact with the compressed edge closed by u [m]; fills found [9]."""
    k, f, _ = given
    _, _, depth, area, centroid = table
    a_2, a, over = extent(table, given, u)
    da, ds, force, moment, moment_side = zone(table, a_2, a, hint)
    per, end = scale(given, a_2, a, over), k * over * area
    force = per * force + end
    found[RESULTANT], found[SIDEWAYS] = (per * moment + end * centroid) / force, per * moment_side / force
    found[PIVOT] = min(max(ds / da, a_2), a) if da > 0.0 else a
    found[CLOSING], found[DEPTH], found[CRUSHED_DEPTH], found[PEAK_STRESS] = u, a, a_2, min(k * u, f)
    found[CRUSHED_AREA] = upto(table, a_2, hint[0])[0] if a_2 > 0.0 else 0.0
    found[OPEN_AREA] = max(area - found[CRUSHED_AREA] - da, 0.0) if a < depth else 0.0


@entry
def touch(table: Table, k: float, f: float, force: FloatArray, phi: FloatArray, found: FloatArray) -> None:
    """The contact at each of n rotations [rad] under its force [N]; fills found [n, 9].

    k : stiffness [Pa/m], may be infinite; f : strength [Pa], may be infinite; 0 < force < f times the area
    """
    hint = np.zeros(2, dtype=np.int64)
    _, _, depth, area, _ = table
    plastic, last = 0.0, 0.0
    for n in range(phi.size):
        given = (k, f, phi[n])
        if f < math.inf and force[n] != last:
            last = force[n]
            plastic = find(PLASTIC, table, given, last / f, depth * last / (f * area), depth, hint)
        if k == math.inf or f <= THIN * k * phi[n] * plastic:
            rigid(table, given, plastic, found[n])
        else:
            near = math.nan
            if n > 0 and phi[n - 1] > 0.5 * phi[n]:
                near = found[n - 1, CLOSING] + found[n - 1, PIVOT] * (phi[n] - phi[n - 1])
            elastic(table, given, closing(table, given, force[n], plastic, near, hint), hint, found[n])


@entry
def crushing_depth(table: Table, share: float) -> float:
    """Depth of partial contact at which the edge starts to crush [m]; share: force over strength [m2]."""
    hint = np.zeros(2, dtype=np.int64)
    return find(CRUSHING, table, (0.0, 0.0, 0.0), share, table[2], table[2], hint)
