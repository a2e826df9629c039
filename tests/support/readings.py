"""What the lines of calculation sheets should hold that have no formula of printed numbers.

Found from the table of the branch, the spectrum, the suites and what was given, not by the functions that made the
lines. LINES is closed: a line without inputs has its formula there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import inf, isclose, pi, sqrt

import numpy as np
from scipy.constants import g
from scipy.integrate import quad
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq
from subjects import AMPLIFIED, FRICTION, HOUSE, LEVELS, SLIDING, SPECTRUM, SUITES, Subject

from assess.codes.check import Step
from assess.hinge_forces import HingeForces

PERMISSIBLE = {"other": (20.0, 16.0, 13.0), "first": (20.0, 18.0, 15.0), "top": (14.0, 14.0, 9.0)}  # Table 11-5


@dataclass
class Sheet:
    """One answer as its lines are read, with what those before have come to."""

    subject: Subject
    known: dict[str, float | None] = field(default_factory=dict)
    step: Step | None = None

    @property
    def level(self) -> float:
        """PGA [m/s2]."""
        return self.subject.check.level_pga_g * g

    @property
    def scale(self) -> float:
        """The level over the spectrum's own PGA."""
        return self.level / SPECTRUM.pga

    @property
    def mass(self) -> float:
        return self.subject.rocker.mass

    def rest(self, column: str) -> float:
        """A column of the branch at rest."""
        return float(getattr(self.subject.branch, column)[0])

    def spline(self, column: str) -> CubicSpline:
        branch = self.subject.branch
        return CubicSpline(branch.rotation, getattr(branch, column))

    def instability(self) -> float:
        """Where the restoring moment falls to zero [rad]."""
        branch = self.subject.branch
        last = int(np.flatnonzero(branch.restoring > 0.0)[-1])
        return float(brentq(self.spline("restoring"), branch.rotation[last], branch.rotation[last + 1], xtol=1e-15))

    def moved(self, rotation: float) -> float:
        """The integral of B up to a rotation [kg m]."""
        return float(quad(self.spline("excitation"), 0.0, rotation, epsrel=1e-11)[0])

    def rotation_of(self, moved: float) -> float:
        """Where d* is so large [rad]."""
        top = self.subject.branch.rotation[-1]
        return float(brentq(lambda phi: self.moved(phi) / self.mass / self.e - moved, 0.0, top, xtol=1e-14))

    @property
    def e(self) -> float:
        """e* [-]."""
        return self.rest("excitation") ** 2 / self.rest("participation") / self.mass

    def multiplier(self, rotation: float) -> float:
        return float(self.spline("restoring")(rotation) / self.spline("excitation")(rotation) / g)

    def ordinate(self, period: float, damping: float = 0.05) -> float:
        """Of the site's spectrum at the level [m/s2]."""
        return float(SPECTRUM.acceleration(period, damping=damping)) * self.scale

    def over_pga(self, period: float, damping: float) -> float:
        """The ordinate of the motion at the base over the PGA of the ground."""
        floor = self.subject.context.floor_spectrum if self.subject.context.above_ground else None
        own = self.subject.check.procedure == "asce43-05-spectrum" and floor is not None
        return float((floor if own else SPECTRUM).acceleration(period, damping=damping)) / SPECTRUM.pga

    def curve(self, rotation: float) -> float:
        """PGA over rotation of the answer [g]."""
        curve = self.subject.check.pga_curve
        over = rotation / self.subject.branch.overturning
        return float(np.interp(over, curve.rotation_ratio, curve.pga_g))

    @property
    def suite(self) -> tuple[float | None, ...]:
        """Largest rotations over the overturning rotation at the level."""
        return SUITES[int(np.argmin(np.abs(np.array(LEVELS) - self.level)))].ratio

    def hinge(self) -> HingeForces:
        """That whose letter the line bears, else that whose V the sheet has."""
        names = {each.hinge: each for each in self.subject.context.hinges}
        own = self.step.symbol.partition("_")[2]
        main = next(each.symbol[2:] for each in self.subject.check.steps if each.symbol.startswith("V_"))
        return names.get(own) or names[main]


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


def mean(sheet: Sheet) -> float | None:
    found = shares(sheet, sheet.known["d_SLV"])
    return None if None in found else float(np.mean(found))


def farthest(sheet: Sheet) -> float:
    return max(each for each in shares(sheet, sheet.known["d0*"]) if each is not None)


def permissible(sheet: Sheet) -> float:
    """The wall stands in the upper of two storeys: its own row, or the strictest."""
    column = int(sheet.known["S_X1"] > 0.24) + int(sheet.known["S_X1"] > 0.37)
    return PERMISSIBLE["top"][column]


def stated(sheet: Sheet) -> float:
    spans = sheet.subject.context.support == "spanning"
    return {"q_a": 2.0 if spans else 1.0, "γ_a": 1.0, "δ_all": SLIDING, "μ": FRICTION}[sheet.step.symbol]


def spectral(sheet: Sheet) -> float:
    """S_e(X): at the period X of a line before, with the damping of the building's first mode or of the limit state."""
    symbol = sheet.step.symbol[4:-1]
    damping = 0.05 if symbol == "T1" else 0.10 if symbol.startswith("T1'") else sheet.subject.check.damping
    return sheet.ordinate(sheet.known[symbol], damping)


def floor_demands(sheet: Sheet, xi: float) -> list[tuple[float, float]]:
    """Displacement that the floor asks at T_SLV, and T1' from 1.5 to 2.0 T1, with damping xi (C7.2.5 to C8.7.1.12)."""
    T, damping, share = sheet.known["T_SLV"], sheet.subject.check.damping, sheet.known["γψ"]
    found = []
    for first in np.unique([*np.linspace(1.5, 2.0, 501), T / 0.8 / 0.24, T / 1.1 / 0.24]) * HOUSE.period:
        if not 1.5 * HOUSE.period <= first <= 2.0 * HOUSE.period:
            continue
        peak = sheet.ordinate(first, xi) * share * sqrt(1 + (2 * xi) ** 2)
        A = max(1.1 * sqrt(10 / (5 + 100 * damping)) / sqrt(xi), 1.0)
        low, high = 1 - T / (0.8 * first), T / (1.1 * first) - 1
        fall = 1 + (A - 1) * (max(low, 0.0) ** 1.6 + max(high, 0.0) ** 1.2)
        at_T = max(A * peak / fall, sheet.ordinate(T, damping) if first < T else 0.0)
        least = A * peak * (1.1 * first / (2 * pi)) ** 2 if 1.1 * first < T else 0.0
        found.append((max(at_T * (T / (2 * pi)) ** 2, least), float(first)))
    return found


def shown(sheet: Sheet) -> float:
    """The largest demand with 20 % of damping."""
    return max(floor_demands(sheet, 0.2))[0]


def sliding_frequency(sheet: Sheet) -> float | None:
    """The lowest frequency at which the spectrum of 10 % reaches c_s; None where the plateau is below it."""
    c_s = sheet.known["c_s"]
    period = np.geomspace(0.02, 40.0, 20001)
    above = period[SPECTRUM.acceleration(period, damping=0.10) * sheet.scale >= c_s]
    return 1 / float(above[-1]) if above.size else None


def slides_from(sheet: Sheet) -> float | None:
    """PGA at which a hinge that nothing else holds slides before it rocks, |T| = mu N, T from rest on in proportion."""
    found = []
    for hinge in sheet.subject.context.hinges:
        low, high = hinge.resting, hinge.starting
        if hinge.held or abs(high.shear) <= FRICTION * high.normal:
            continue
        first, last = (abs(each.shear) - FRICTION * each.normal for each in (low, high))
        found.append(-first / (last - first) * hinge.acceleration / AMPLIFIED / g)
    return min(found, default=None)


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
    "[building] period": lambda s: HOUSE.period,
    "geometry": lambda s: getattr(s.subject.context.wall, {"h": "height", "t": "thickness"}[s.step.symbol]),
    "row of the wall, column of S_X1": permissible,
    "1.5 in high seismicity, 2.5 in moderate": lambda s: 1.5,
    "1 at the ground, 3 at most": lambda s: 1.0,
    # the table of the branch
    "restoring moment = 0": Sheet.instability,
    "restoring moment at rest": lambda s: s.rest("restoring"),
    "Σ m (x'² + z'²) + J_G θ'²": lambda s: s.rest("inertia"),
    "Σ m x'": lambda s: s.rest("excitation"),
    "∫ B dφ / M": lambda s: s.moved(s.instability()) / s.mass,
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
    "T0 ≤ T ≤ T_SLV": lambda s: s.known["T_SLV"],  # displacements of ASCE 7 never fall with the period
    "as above, with ξ1 = 0.2": shown,
    "S_A(f_es, 10 %) = c_s": sliding_frequency,
    "c_s / (2π f_es)²": lambda s: 0.0 if s.known["f_es"] is None else inf,
    # the suites
    "count": counted,
    "Σ max |φ(t)| / φ_u / n": lambda s: None if None in s.suite else inf,
    "largest d* / d0*": farthest,
    "mean": mean,
    # the forces at the hinges
    "equilibrium of each block at a_r": force,
    "|T| = μ N, over the amplification": slides_from,
    "|T| / N": lambda s: None if s.hinge().starting.normal <= 0.0 else inf,
    # no answer
    "-": nothing,
    "h / t": nothing,
}
