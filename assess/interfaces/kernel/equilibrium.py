"""The closure of a contact that carries a given force, and what the contact is then."""

from __future__ import annotations

import math

import numpy as np

from assess.interfaces.kernel.columns import MomentTable
from assess.interfaces.kernel.moments import integrate_zone, moments_upto, width
from assess.kernel import compiled, entry, reachable
from spectra.arrays import FloatArray, IntArray

JointState = tuple[float, float, float]  # stiffness k [Pa/m], strength f [Pa], rotation phi [rad]
# columns of `found` [n, 9], as the attributes of `Contact`
RESULTANT, ECCENTRICITY, CENTRE, CLOSURE, DEPTH, CRUSHED_DEPTH, PEAK_STRESS, OPEN_AREA, CRUSHED_AREA = range(9)
# what `solve` looks for: the closing that carries a force, the depth of a plastic block, of a triangle at the strength
FORCE, PLASTIC, CRUSHING = range(3)
THIN = 1e-9
"""Fraction of the plastic depth: a thinner elastic zone is neglected; the error goes with the square of this."""
CLOSE = 1e-9
"""Relative length of a step of Newton's method after which the error, which goes with its square, is at rounding."""
ROUNDING = 1e-15
"""Relative width of a bracket at which bisection ends."""


@compiled
def extent(table: MomentTable, given: JointState, closure: float) -> tuple[float, float, float]:
    """Return the depth crushed, the depth in contact, and the closure of the far edge, zero where it is open [m].

    In a crushed contact the last makes the stress at a_2 equal the strength, however thin the elastic zone is.
    """
    k, f, phi = given
    over = closure - phi * table[2]
    a = table[2] if over >= 0.0 else closure / phi
    if k * closure <= f:
        return 0.0, a, max(over, 0.0)
    a_2 = min((closure - f / k) / phi, a)
    return a_2, a, max(f / k - phi * (a - a_2), 0.0) if over > 0.0 else 0.0


@compiled
def stress_gradient(given: JointState, a_2: float, a: float, over: float) -> float:
    """Return the gradient of stress over depth, k phi [Pa/m], in a form in which force and strength agree."""
    k, f, phi = given
    return f / (a - a_2) if a_2 > 0.0 and over == 0.0 else k * phi


@compiled
def force_at_closure(table: MomentTable, given: JointState, closure: float, hint: IntArray) -> tuple[float, float]:
    """Return the force [N] and its derivative over the closure of the compressed edge."""
    a_2, a, over = extent(table, given, closure)
    elastic, _, f, _, _ = integrate_zone(table, a_2, a, hint)
    return stress_gradient(given, a_2, a, over) * f + given[0] * over * table[3], given[0] * elastic


@compiled
def area_at_depth(table: MomentTable, given: JointState, z: float, hint: IntArray) -> tuple[float, float]:
    """Return the area up to z [m2] and its derivative."""
    return moments_upto(table, z, hint[1])[0], width(table, z, hint[1])


@compiled
def force_at_crushing(table: MomentTable, given: JointState, z: float, hint: IntArray) -> tuple[float, float]:
    """Return force over strength [m2] for a triangle of stress up to z, and its derivative."""
    _, s, f, _, _ = integrate_zone(table, 0.0, z, hint)
    return f / z, s / z**2


@compiled
def evaluate(which: int, table: MomentTable, given: JointState, x: float, hint: IntArray) -> tuple[float, float]:
    """Return one of the functions above, all of which increase, and its derivative.

    It is chosen by a number: numba caches no entry point that takes functions, and closures of one factory share a
    name, so that of two cached entry points the one loaded second would be taken for the first.
    """
    if which == FORCE:
        return force_at_closure(table, given, x, hint)
    if which == PLASTIC:
        return area_at_depth(table, given, x, hint)
    return force_at_crushing(table, given, x, hint)


@reachable
def solve(
    which: int, table: MomentTable, given: JointState, target: float, start: float, high: float, hint: IntArray
) -> float:
    """Return where one of the functions reaches a target between 0 and `high`.

    Newton's method inside a bracket that only shrinks. Far from the target its steps are taken in logarithms, in which
    these functions, close to powers, are close to straight lines.
    """
    low, x, step = 0.0, start, high
    for _ in range(200):
        value, rate = evaluate(which, table, given, x, hint)
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
def find_closure(
    table: MomentTable, given: JointState, force: float, plastic: float, near: float, hint: IntArray
) -> float:
    """Return the closure of the compressed edge under a force [m].

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
    return solve(FORCE, table, given, force, near if 0.0 < near < most else start, most, hint)


@reachable
def rigid(table: MomentTable, given: JointState, plastic: float, found: FloatArray) -> None:
    """Fill `found` [9] with the contact of a joint without elastic zone."""
    found[:] = 0.0
    if plastic > 0.0:
        crushed, first, side = moments_upto(table, plastic, 0)
        found[RESULTANT], found[ECCENTRICITY], found[CRUSHED_AREA] = first / crushed, side / crushed, crushed
    found[CENTRE], found[CLOSURE], found[DEPTH], found[CRUSHED_DEPTH] = plastic, given[2] * plastic, plastic, plastic
    found[PEAK_STRESS], found[OPEN_AREA] = given[1], table[3] - found[CRUSHED_AREA]


@reachable
def elastic(table: MomentTable, given: JointState, u: float, hint: IntArray, found: FloatArray) -> None:
    """Fill `found` [9] with the contact whose compressed edge has closed by u [m]."""
    k, f, _ = given
    _, _, depth, area, centroid = table
    a_2, a, over = extent(table, given, u)
    da, ds, force, moment, moment_side = integrate_zone(table, a_2, a, hint)
    per, end = stress_gradient(given, a_2, a, over), k * over * area
    force = per * force + end
    found[RESULTANT], found[ECCENTRICITY] = (per * moment + end * centroid) / force, per * moment_side / force
    found[CENTRE] = min(max(ds / da, a_2), a) if da > 0.0 else a
    found[CLOSURE], found[DEPTH], found[CRUSHED_DEPTH], found[PEAK_STRESS] = u, a, a_2, min(k * u, f)
    found[CRUSHED_AREA] = moments_upto(table, a_2, hint[0])[0] if a_2 > 0.0 else 0.0
    found[OPEN_AREA] = max(area - found[CRUSHED_AREA] - da, 0.0) if a < depth else 0.0


@entry
def touch(table: MomentTable, k: float, f: float, force: FloatArray, phi: FloatArray, found: FloatArray) -> None:
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
            plastic = solve(PLASTIC, table, given, last / f, depth * last / (f * area), depth, hint)
        if k == math.inf or f <= THIN * k * phi[n] * plastic:
            rigid(table, given, plastic, found[n])
        else:
            near = math.nan
            if n > 0 and phi[n - 1] > 0.5 * phi[n]:
                near = found[n - 1, CLOSURE] + found[n - 1, CENTRE] * (phi[n] - phi[n - 1])
            elastic(table, given, find_closure(table, given, force[n], plastic, near, hint), hint, found[n])


@entry
def crushing_depth(table: MomentTable, share: float) -> float:
    """Return the depth of partial contact at which the edge starts to crush [m]; share: force over strength [m2]."""
    hint = np.zeros(2, dtype=np.int64)
    return solve(CRUSHING, table, (0.0, 0.0, 0.0), share, table[2], table[2], hint)
