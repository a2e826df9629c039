"""The closing of a contact that carries a given force, and what the contact is then."""

from __future__ import annotations

import math

import numpy as np

from assess.interfaces.kernel.moments import Table, upto, width, zone
from assess.kernel import compiled, entry, reachable
from spectra.arrays import FloatArray, IntArray

Given = tuple[float, float, float]  # stiffness k [Pa/m], strength f [Pa], rotation phi [rad]
# columns of `found` [n, 9], as the attributes of `Contact`
RESULTANT, SIDEWAYS, PIVOT, CLOSING, DEPTH, CRUSHED_DEPTH, PEAK_STRESS, OPEN_AREA, CRUSHED_AREA = range(9)
# what `find` looks for: the closing that carries a force, the depth of a plastic block, of a triangle at the strength
FORCE, PLASTIC, CRUSHING = range(3)
THIN = 1e-9
"""Fraction of the plastic depth: a thinner elastic zone is neglected; the error goes with the square of this."""
CLOSE = 1e-9
"""Relative length of a step of Newton's method after which the error, which goes with its square, is at rounding."""
ROUNDING = 1e-15
"""Relative width of a bracket at which bisection ends."""


@compiled
def extent(table: Table, given: Given, closing: float) -> tuple[float, float, float]:
    """Return the depth crushed, the depth in contact, and the closing of the far edge, zero where it is open [m].

    In a crushed contact the last makes the stress at a_2 equal the strength, however thin the elastic zone is.
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
    """Return the gradient of stress over depth, k phi [Pa/m], in a form in which force and strength agree."""
    k, f, phi = given
    return f / (a - a_2) if a_2 > 0.0 and over == 0.0 else k * phi


@compiled
def by_closing(table: Table, given: Given, closing: float, hint: IntArray) -> tuple[float, float]:
    """Return the force [N] and its derivative over the closing of the compressed edge."""
    a_2, a, over = extent(table, given, closing)
    elastic, _, f, _, _ = zone(table, a_2, a, hint)
    return scale(given, a_2, a, over) * f + given[0] * over * table[3], given[0] * elastic


@compiled
def by_plastic_depth(table: Table, given: Given, z: float, hint: IntArray) -> tuple[float, float]:
    """Return the area up to z [m2] and its derivative."""
    return upto(table, z, hint[1])[0], width(table, z, hint[1])


@compiled
def by_crushing_depth(table: Table, given: Given, z: float, hint: IntArray) -> tuple[float, float]:
    """Return force over strength [m2] for a triangle of stress up to z, and its derivative."""
    _, s, f, _, _ = zone(table, 0.0, z, hint)
    return f / z, s / z**2


@compiled
def rising(which: int, table: Table, given: Given, x: float, hint: IntArray) -> tuple[float, float]:
    """Return one of the functions above, all of which increase, and its derivative.

    It is chosen by a number: numba caches no entry point that takes functions, and closures of one factory share a
    name, so that of two cached entry points the one loaded second would be taken for the first.
    """
    if which == FORCE:
        return by_closing(table, given, x, hint)
    if which == PLASTIC:
        return by_plastic_depth(table, given, x, hint)
    return by_crushing_depth(table, given, x, hint)


@reachable
def find(which: int, table: Table, given: Given, target: float, start: float, high: float, hint: IntArray) -> float:
    """Return where one of the functions reaches a target between 0 and `high`.

    Newton's method inside a bracket that only shrinks. Far from the target its steps are taken in logarithms, in which
    these functions, close to powers, are close to straight lines.
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
    """Return the closing of the compressed edge under a force [m].

    plastic: depth of the plastic block [m]; near: a first guess, or nan.
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
    """Fill `found` [9] with the contact of a joint without elastic zone."""
    found[:] = 0.0
    if plastic > 0.0:
        crushed, first, side = upto(table, plastic, 0)
        found[RESULTANT], found[SIDEWAYS], found[CRUSHED_AREA] = first / crushed, side / crushed, crushed
    found[PIVOT], found[CLOSING], found[DEPTH], found[CRUSHED_DEPTH] = plastic, given[2] * plastic, plastic, plastic
    found[PEAK_STRESS], found[OPEN_AREA] = given[1], table[3] - found[CRUSHED_AREA]


@reachable
def elastic(table: Table, given: Given, u: float, hint: IntArray, found: FloatArray) -> None:
    """Fill `found` [9] with the contact whose compressed edge has closed by u [m]."""
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
    """Fill `found` [n, 9] with the contact at each of n rotations [rad] under its force [N].

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
    """Return the depth of partial contact at which the edge starts to crush [m]; share: force over strength [m2]."""
    hint = np.zeros(2, dtype=np.int64)
    return find(CRUSHING, table, (0.0, 0.0, 0.0), share, table[2], table[2], hint)
