"""What the lines of calculation sheets should hold that have no formula of printed numbers.

Found from the table of the branch, the spectrum, the suites and what was given, not by the functions that made the
lines. LINES is closed: a line without inputs has its formula there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf, isclose, pi, prod, sqrt

import numpy as np
from scipy.constants import g

from assess.codes.check import branch_of
from assess.oscillator import Branch, HingeForces, interpolant
from tests.support.printed_sheet import Sheet
from tests.support.subjects import FRICTION, SLIDING

PERMISSIBLE = {"other": (20.0, 16.0, 13.0), "first": (20.0, 18.0, 15.0), "top": (14.0, 14.0, 9.0)}  # Table 11-5


# ------------------------------------------------------------------------------------------------ lines without inputs


def largest_pga(sheet: Sheet) -> float:
    """The largest PGA up to a rotation [g]."""
    curve, end = sheet.subject.check.pga_curve, sheet.known["θ_1/2"]
    ratio = np.array(curve.rotation_ratio)
    below = ratio <= end / sheet.subject.branch.overturning
    return max(float(np.array(curve.pga_g)[below].max()), sheet.curve(end))


def solved(sheet: Sheet) -> float:
    """The rotation printed, where the curve of the answer has the level there; 0 where it needs more everywhere."""
    if not sheet.step.value:
        return still(sheet)
    theta = sheet.step.value
    theta = theta if sheet.step.symbol == "θ" else theta * sheet.subject.branch.overturning
    return sheet.step.value if isclose(sheet.curve(theta), sheet.level / g, rel_tol=2e-3) else inf


def solved_or_not(sheet: Sheet) -> float | None:
    """The same; None where the curve never reaches the level, at any rotation up to overturning."""
    highest = max(sheet.subject.check.pga_curve.pga_g)
    return None if sheet.level / g > highest else solved(sheet)


def still(sheet: Sheet) -> float:
    """0 where no rotation of the curve needs so little PGA."""
    return 0.0 if sheet.level / g <= min(sheet.subject.check.pga_curve.pga_g) * (1 + 1e-9) else inf


def limit_or_end(sheet: Sheet) -> float:
    end = sheet.subject.check.pga_curve.rotation_ratio[-1] * sheet.subject.branch.overturning
    return min(sheet.known["θ_lim"], end)


def counted(sheet: Sheet) -> float:
    fallen = sum(each is None for each in sheet.suite)
    return float(len(sheet.suite) if sheet.step.symbol == "n" else fallen)


def shares(sheet: Sheet, of: float) -> list[float | None]:
    """d* of each record over a displacement."""
    over = sheet.subject.branch.overturning
    return [None if r is None else sheet.moved(r * over) / sheet.mass / sheet.e / of for r in sheet.suite]


def farthest(sheet: Sheet) -> float | None:
    """None where every record overturns; the others have a formula."""
    return None if all(each is None for each in sheet.suite) else inf


def shares_that_hold(sheet: Sheet, pga: float) -> tuple[float, float]:
    """Of all choices of a run for each record at a PGA [m/s2] the share that stands, and of 500 of these that holds."""
    suite = min(sheet.subject.context.suites, key=lambda each: abs(each.pga - pga))
    runs = [[run for run in each if hold_one(sheet, run)] for each in suite.runs.ratio.T.tolist()]
    standing = float(np.prod([len(each) / len(suite.runs.ratio) for each in runs]))
    if standing == 0.0:
        return standing, 0.0
    parts = np.random.default_rng(1).random((len(runs), 500))
    chosen = [[each[int(part * len(each))] for part in row] for each, row in zip(runs, parts.tolist(), strict=True)]
    return standing, float(hold(sheet, np.array(chosen)).mean())


def hold_one(sheet: Sheet, ratio: float) -> bool:
    """Whether a run stands: it does not overturn and, by the Italian codes, does not pass d0*."""
    if np.isinf(ratio) or sheet.subject.check.procedure.startswith("asce"):
        return bool(np.isfinite(ratio))
    moved = sheet.spline("excitation").antiderivative()
    turned = ratio * sheet.subject.branch.overturning
    return bool(moved(turned) - moved(0.0) <= sheet.moved(sheet.subject.branch.unstable))


def hold(sheet: Sheet, ratio: np.ndarray) -> np.ndarray:
    """Whether the rule holds for records [records, draws]: the mean in rotation, or in displacement against d_LS."""
    branch, stand = sheet.subject.branch, np.isfinite(ratio)
    turned = np.where(stand, ratio, 0.0) * branch.overturning
    if sheet.subject.check.procedure.startswith("asce"):
        return stand.all(axis=0) & (turned.mean(axis=0) / branch.unstable <= 0.5)
    moved = sheet.spline("excitation").antiderivative()
    moved, limit = moved(turned) - moved(0.0), sheet.known[f"d_{sheet.subject.check.limit_state}"]
    within = (moved <= sheet.moved(branch.unstable)).all(axis=0)
    return stand.all(axis=0) & within & (moved.mean(axis=0) / sheet.mass / sheet.e <= limit)


def scanned(sheet: Sheet) -> float | None:
    """The last PGA before the first at which too few draws hold [g]; the suites of the levels are the scan, too."""
    needed = {"PGA_84": 0.84, "PGA_50": 0.5, "PGA_16": 0.16}[sheet.step.symbol]
    last = None
    for suite in sheet.subject.context.incremental:
        own = np.array([[inf if each is None else each] for each in suite.ratio])
        if prod(shares_that_hold(sheet, suite.pga)) < needed or (needed > 0.8 and not hold(sheet, own).all()):
            return last
        last = suite.pga / g
    return None


def permissible(sheet: Sheet) -> float:
    """The wall stands in the upper of two storeys: its own row, or the strictest."""
    column = int(sheet.known["S_X1"] > 0.24) + int(sheet.known["S_X1"] > 0.37)
    return PERMISSIBLE["top"][column]


def stated(sheet: Sheet) -> float:
    context, branch = sheet.subject.context, sheet.subject.check.branch
    spans = context.support == "spanning" or context.held.get(branch, 0.0) >= sheet.known.get("S_a", inf) / 2.0
    if sheet.step.symbol == "T0":
        return sheet.subject.context.free_period.value
    return {"q_a": 2.0 if spans else 1.0, "γ_a": 1.0, "δ_all": SLIDING, "μ": FRICTION}[sheet.step.symbol]


def spectral(sheet: Sheet) -> float:
    """S_e(X): at the period X of a line before, with the damping of the building's first mode or of the limit state."""
    symbol = sheet.step.symbol[4:-1]
    first = symbol.startswith("T1")
    damping = sheet.mode_damping(symbol) if first else 0.05 if symbol == "T0" else sheet.subject.check.damping
    return sheet.ordinate(sheet.known[symbol], damping)


def floor_demands(sheet: Sheet, xi: float) -> list[tuple[float, float]]:
    """Displacement that the floor asks at T_SLV, and T1' from 1.5 to 2.0 T1, with damping xi (C7.2.5 to C8.7.1.12)."""
    T, damping, share = sheet.known["T_SLV"], sheet.subject.check.damping, sheet.known["γψ"]
    softened = np.unique([*np.linspace(1.5, 2.0, 501), T / 0.8 / sheet.house.period, T / 1.1 / sheet.house.period])
    periods = (softened * sheet.house.period)[(softened >= 1.5) & (softened <= 2.0)]
    ground, found = sheet.ordinate(T, damping), []
    for first, ordinate in zip(periods.tolist(), sheet.ordinates(periods, xi).tolist(), strict=True):
        peak = ordinate * share * sqrt(1 + (2 * xi) ** 2)
        A = max(1.1 * sqrt(10 / (5 + 100 * damping)) / sqrt(xi), 1.0)
        low, high = 1 - T / (0.8 * first), T / (1.1 * first) - 1
        fall = 1 + (A - 1) * (max(low, 0.0) ** 1.6 + max(high, 0.0) ** 1.2)
        at_T = max(A * peak / fall, ground if first < T else 0.0)
        least = A * peak * (1.1 * first / (2 * pi)) ** 2 if 1.1 * first < T else 0.0
        found.append((max(at_T * (T / (2 * pi)) ** 2, least), first))
    return found


def shown(sheet: Sheet) -> float:
    """The largest demand with 20 % of damping."""
    return max(floor_demands(sheet, 0.2))[0]


def farthest_moved(sheet: Sheet) -> float:
    """The longest period of the largest displacement of the ground, from T_0 on; most spectra's never fall [s]."""
    end = sheet.known["T_SLV"]
    period = np.linspace(min(sheet.known.get("T0") or 1e-3, end), end, 20001)
    moved = sheet.spectrum.displacement(period, damping=sheet.subject.check.damping)
    longest = float(period[np.flatnonzero(moved >= moved.max() * (1 - 1e-9))[-1]])
    own = sheet.step.value or inf
    if not 0.99 * longest <= own <= end:
        return longest
    least = moved.max() * (1 - 1e-6)  # found over fewer periods
    return own if sheet.spectrum.displacement(own, damping=sheet.subject.check.damping) >= least else longest


def stated_mode(sheet: Sheet) -> float:
    return sheet.house.limit_states[sheet.subject.check.limit_state].period


def years(sheet: Sheet) -> float:
    """Return period of the capacity: log T_R over log PGA by the rows, the first or last row beyond them."""
    rows = sheet.subject.context.hazard
    at = np.interp(np.log(sheet.subject.check.capacity_pga_g * g), np.log(rows.pga), np.log(rows.return_period))
    return float(np.exp(at))


def read_from_table(sheet: Sheet) -> float:
    """R or B at the rotation of the line, on the branch with actions until they end."""
    side = breaking(sheet)
    column = {"R": side.restoring, "B": side.excitation}[sheet.step.symbol]
    return float(interpolant(side.rotation, column)(sheet.step.at[0].value))


def breaking(sheet: Sheet) -> Branch:
    """The branch with actions until they end."""
    rocker = sheet.subject.context.breaking or sheet.subject.rocker
    return branch_of(rocker, sheet.subject.check.branch)


def secant_rotation(sheet: Sheet) -> float:
    return sheet.rotation_of(sheet.known[sheet.step.at[0].symbol])


def on_joints(sheet: Sheet) -> float:
    """Period of small motions on the joint [s]."""
    if not sheet.subject.mechanism.flexible:
        return 0.0
    return float(2 * pi * sqrt(sheet.rest("inertia") / sheet.spline("restoring")(0.0, 1)))


def beyond(sheet: Sheet) -> float:
    """Displacement of the ground where the spectrum gives it itself [m]."""
    symbol = sheet.step.symbol[5:-1]
    own = sheet.spectrum.displacement(sheet.known[symbol], damping=sheet.subject.check.damping)
    return float(own) * sheet.scale


def sliding_frequency(sheet: Sheet) -> float | None:
    """The lowest frequency at which the spectrum of 10 % reaches c_s; None where the plateau is below it."""
    c_s = sheet.known["c_s"]
    period = np.geomspace(0.02, 40.0, 20001)
    above = period[sheet.spectrum.acceleration(period, damping=0.10) * sheet.scale >= c_s]
    return 1 / float(above[-1]) if above.size else None


def slides_from(sheet: Sheet) -> float | None:
    """The PGA at which a hinge slides: it has a formula where there is one."""
    return 0.0 if sheet.step.remark and first_to_slide(sheet) is not None else None


def first_to_slide(sheet: Sheet) -> HingeForces | None:
    """The hinge that nothing else holds which slides first, |T| = mu N, T from rest on in proportion."""
    found = []
    for hinge in sheet.subject.context.hinges:
        low, high = hinge.resting, hinge.starting
        if hinge.held or abs(high.shear) <= FRICTION * high.normal:
            continue
        first, last = (abs(each.shear) - FRICTION * each.normal for each in (low, high))
        found.append((-first / (last - first) * hinge.acceleration, hinge))
    return min(found, key=lambda each: each[0], default=(0.0, None))[1]


def force(sheet: Sheet) -> float:
    hinge = sheet.hinge()
    return hinge.horizontal if sheet.step.symbol.startswith("H") else hinge.vertical


def nothing(sheet: Sheet) -> None:
    return None


LINES: Mapping[str, Callable[[Sheet], float | None]] = {
    # a value that is given, or that follows from what was
    "z_base − z_ground": lambda s: s.subject.context.elevation + s.subject.mechanism.rise / 2.0,
    "counted in B0": lambda s: 1.0,
    "5 %": lambda s: 0.05,
    "of the level of knowledge": lambda s: 1.0,  # LC3
    "given": stated,
    "[building] period": lambda s: s.house.period,
    "geometry": lambda s: getattr(s.subject.context.wall, {"h": "height", "t": "thickness"}[s.step.symbol]),
    "row of the wall, column of S_X1": permissible,
    "1.5 in high seismicity, 2.5 in moderate": lambda s: 1.5,
    "1 at the ground, 3 at most": lambda s: 1.0,
    # the table of the branch
    "V'(0) − M": lambda s: s.rest("restoring"),
    "table of the mechanism": read_from_table,
    "∫ R dφ": lambda s: float(s.spline("restoring").integrate(0.0, s.known[s.step.at[0].symbol])),
    "∫ B dφ = d* M e*": secant_rotation,
    "Σ m (x'² + z'²) + J_G θ'²": lambda s: s.rest("inertia"),
    "Σ m x'": lambda s: s.rest("excitation"),
    # the curve of the answer
    "largest PGA with θ ≤ θ_1/2": largest_pga,
    "PGA ≤ least PGA(θ)": still,
    "θ_lim, or where the curve ends": limit_or_end,
    "SA_H,DEM(θ) = SA_H,CAP(θ)": solved,
    "PGA(φ) = level": solved_or_not,
    "0": lambda s: 0.0 if s.level / g <= s.known["PGA_u"] else inf,
    # the spectrum
    "S_a(1/f_e, β_e) / PGA": lambda s: s.over_pga(1 / s.known["f_e"], s.known["β_e"]),
    "S_a(T) / PGA": lambda s: s.over_pga(s.known["T"], 0.05),
    "S_e(T, 5 %)": lambda s: s.ordinate(s.known["T_s"]),
    "S_e(T, ξ1)": spectral,
    "S_e(T, ξ)": spectral,
    "T0 ≤ T ≤ T_LS": farthest_moved,
    "as above, with ξ1 = 0.2": shown,
    "S_A(f_es, 10 %) = c_s": sliding_frequency,
    "c_s / (2π f_es)²": lambda s: 0.0 if s.known["f_es"] is None else inf,
    # the suites
    "count": counted,
    "Σ max |φ(t)| / φ_u / n": lambda s: None if None in s.suite else inf,
    "largest d* / d0*": farthest,
    "d* / d_LS": lambda s: None if None in s.suite else inf,
    "number of draws": lambda s: 500.0,
    "product of the records' shares of runs that stand": lambda s: shares_that_hold(s, s.pga)[0],
    "share of draws among the runs that stand": lambda s: shares_that_hold(s, s.pga)[1],
    "last PGA of the scan before the first that fails": scanned,
    # the forces at the hinges
    "equilibrium of each block at a_r": force,
    "|T| = μ N, over the amplification": slides_from,
    "|T| / N": lambda s: None if s.hinge().starting.normal <= 0.0 else inf,
    # no answer
    "-": nothing,
    "max |φ(t)| / φ_u": lambda s: None if all(each is None for each in s.suite) else inf,
    "C_p(0) R_p = λ": lambda s: None if s.subject.mechanism.flexible else inf,
    # what few sheets have
    "1": lambda s: 1.0 if s.subject.branch.restitution == 0.0 else inf,
    "1 at worst": lambda s: 1.0,
    "by the drawing": lambda s: 0.0,  # nothing is drawn below the walls
    "small motions; 0 on rigid joints": on_joints,
    "0: the building is not known": lambda s: 0.0,
    "first or last row of the hazard": years,
    "as stated": stated_mode,
    "displacement spectrum, T > T_E": beyond,
    "h / t": nothing,
}
