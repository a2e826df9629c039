"""What the formulas of calculation sheets begin with: inputs that no line has come to, by symbol and dimension.

The lists are closed, and found as `readings` finds the lines that are read.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import acosh, atan2, hypot, inf, pi, sqrt

import numpy as np
from readings import Sheet, floor_demands
from scipy.constants import g
from scipy.integrate import quad
from subjects import AMPLIFIED, FRICTION, HOUSE, S_X1, SPECTRUM, VERTICAL


def period_factor(sheet: Sheet) -> float:
    """4 arcosh(1 / (1 − r)), r = 0.36 for a wall that spans and 0.24 for one that stands free (NZSEE C8.8.5)."""
    return 4 * acosh(1 / (1 - (0.36 if sheet.subject.context.support == "spanning" else 0.24)))


def gravity(sheet: Sheet, name: str) -> float:
    return float(getattr(sheet.subject.context.wall.gravity[sheet.subject.check.branch], name))


def secant(sheet: Sheet) -> float:
    """The multiplier where the secant is drawn."""
    symbol = next(key for key in ("d_s*", "d_SLV") if key in sheet.known)
    return sheet.multiplier(sheet.rotation_of(sheet.known[symbol]))


def linearised(sheet: Sheet, symbol: str) -> float:
    """The straight line that touches the moment where it falls to zero, without given forces, and B there."""
    critical = sheet.instability()
    slope, B = -float(sheet.spline("restoring")(critical, 1)), float(sheet.spline("excitation")(critical))
    return {"K": slope, "φ_cr": critical, "M": 0.0, "B": B}[symbol]


def softened(sheet: Sheet) -> float:
    """T1' over T1 from 1.5 to 2.0: of the largest acceleration, the first of equals, or of the largest displacement."""
    ratios = np.linspace(1.5, 2.0, 51)
    if sheet.step.symbol == "T1'_a":
        return float(ratios[np.argmax([sheet.ordinate(each * HOUSE.period, 0.10) for each in ratios])])
    return max(floor_demands(sheet, 0.10))[1] / HOUSE.period


def hinge_value(sheet: Sheet, name: str) -> float:
    hinge = sheet.hinge()
    return {
        "H": hinge.horizontal,
        "V": hinge.vertical,
        "n_x": hinge.face[0],
        "n_z": hinge.face[1],
        "T": hinge.starting.shear,
        "N": hinge.starting.normal,
        "N_0": hinge.resting.normal if hinge.single else hinge.starting.normal,
        "T_0": hinge.resting.shear if hinge.single else 0.0,
        "H_0": 0.0,
        "λ": hinge.acceleration / g,
    }[name]


def record(number: int) -> Callable[[Sheet], float]:
    def ratio(sheet: Sheet) -> float:
        share = sheet.suite[number]
        return inf if share is None else share * sheet.subject.branch.overturning / sheet.instability()

    return ratio


def demand(sheet: Sheet) -> float:
    return sheet.subject.check.demand


def normal(sheet: Sheet) -> float:
    """What presses on the base: all that bears."""
    chain = sheet.subject.mechanism.positive
    return g * (sum(b.mass for b in chain.blocks) + sum(load.mass for load in chain.loads if load.bearing))


Reading = Callable[[Sheet], float]
COMMON: Mapping[tuple[str, str], Reading] = {
    ("B0", "first moment"): lambda s: s.rest("excitation"),
    ("M", "mass"): lambda s: s.mass,
    ("V'(0) − M", "moment"): lambda s: s.rest("restoring"),
    ("R0", "moment"): lambda s: s.rest("restoring"),
    ("I_O", "inertia"): lambda s: s.rest("inertia"),
    ("Σ m δx", "first moment"): lambda s: s.rest("excitation"),
    ("Σ m δx²", "inertia"): lambda s: s.rest("participation"),
    ("∫ B dφ", "first moment"): lambda s: s.moved(s.instability()),
    ("e*", "ratio"): lambda s: s.e,
    ("S_aV/S_aH", "ratio"): lambda s: VERTICAL,
    ("C_R", "ratio"): lambda s: s.subject.branch.restitution,
    ("φ_ov", "rotation"): lambda s: s.instability(),
    ("E", "energy"): lambda s: float(quad(s.spline("restoring"), 0.0, s.known["θ"], epsrel=1e-11)[0]),
    ("R", "length"): lambda s: hypot(s.rest("restoring") / g, s.rest("excitation")) / s.mass,
    ("α", "rotation"): lambda s: atan2(s.rest("restoring") / g, s.rest("excitation")),
    ("level", "acceleration"): lambda s: s.level,
    ("PGA", "acceleration"): lambda s: s.level,
    ("PGA", "ground acceleration"): lambda s: s.level / g,
    ("C(0)", "ground acceleration"): lambda s: s.level / g,
    ("PGA_C", "ground acceleration"): lambda s: s.subject.check.capacity_pga_g,
    ("q", "ratio"): lambda s: 2.0,
    ("demand", "acceleration"): demand,
    ("demand", "length"): demand,
    ("T1", "time"): lambda s: HOUSE.period,
    ("S_e(T1)", "acceleration"): lambda s: s.ordinate(HOUSE.period),
    ("S_De(T1)", "length"): lambda s: s.ordinate(HOUSE.period) * (HOUSE.period / (2 * pi)) ** 2,
    ("ψ", "ratio"): lambda s: min(s.subject.context.support_height / HOUSE.height, 1.0),
    ("γ", "ratio"): lambda s: 3.0 * 2 / (2 * 2 + 1),
    ("N", "ratio"): lambda s: 2.0,
    ("Z", "length"): lambda s: min(s.subject.context.support_height, HOUSE.height),
    ("z", "length"): lambda s: s.subject.context.support_height,
    ("H", "length"): lambda s: HOUSE.height,
    ("ξ1", "ratio"): lambda s: (
        0.05 if s.subject.check.procedure == "ntc2018-linear" or "(T1)" in s.step.symbol else 0.10
    ),
    ("η", "ratio"): lambda s: sqrt(10.0 / (5.0 + 100.0 * s.subject.check.damping)),
    ("b", "ratio"): lambda s: 1.1,
    ("a", "ratio"): lambda s: 0.8,
    ("a_max", "acceleration"): lambda s: max(
        s.level, *(v for key, v in s.known.items() if key.startswith(("a_Z", "S_eZ")) and v is not None), 0.0
    ),
    ("k", "ratio"): lambda s: 0.4 if s.subject.check.procedure.startswith("dmi") else softened(s),
    ("λ", "ratio"): secant,
    ("S_e(T_SLV)", "acceleration"): lambda s: s.ordinate(s.known["T_SLV"], s.subject.check.damping),
    ("S_eZ(T1')", "acceleration"): lambda s: s.known["A"] * s.known["a_Z(T1')"],
    ("T_1", "time"): lambda s: HOUSE.period,
    ("T_a", "time"): lambda s: 0.0,
    ("α S", "ratio"): lambda s: s.level / g,
    ("S_a(1 s)/PGA", "ratio"): lambda s: s.over_pga(1.0, 0.05) if S_X1 is None else S_X1 / (SPECTRUM.pga / g),
    ("s", "ratio"): lambda s: 1.0 if s.step.symbol == "PGA_u" else (0.6 if spans(s) else 0.3),
    ("c", "ratio"): period_factor,
    ("h_i", "length"): lambda s: s.subject.context.support_height,
    ("h_n", "length"): lambda s: HOUSE.height,
    ("R_p", "ratio"): lambda s: 1.0,
    ("h", "length"): lambda s: s.subject.context.wall.height,
    ("C_i(0)", "ratio"): lambda s: 2.0,
    ("P/W", "ratio"): lambda s: gravity(s, "overburden_ratio"),
    ("b_W", "moment"): lambda s: gravity(s, "own_moment"),
    ("b_P", "moment"): lambda s: gravity(s, "moment"),
    ("a_W", "rotational stiffness"): lambda s: gravity(s, "own_slope"),
    ("J_W", "inertia"): lambda s: gravity(s, "own_inertia"),
    ("J_P", "inertia"): lambda s: gravity(s, "inertia"),
    ("B_W", "first moment"): lambda s: gravity(s, "own_excitation"),
    ("f", "ratio"): lambda s: AMPLIFIED,
    **{(f"r_{number}", "ratio"): record(number - 1) for number in range(1, 8)},
}
OWN: Mapping[str, Mapping[tuple[str, str], Reading]] = {
    "dmi2008-nonlinear-thesis": {
        ("K", "rotational stiffness"): lambda s: linearised(s, "K"),
        ("φ_cr", "rotation"): lambda s: linearised(s, "φ_cr"),
        ("M", "moment"): lambda s: linearised(s, "M"),
        ("B", "first moment"): lambda s: linearised(s, "B"),
    },
    "asce43-05-sliding": {
        ("μ", "ratio"): lambda s: FRICTION,
        ("N", "force"): normal,
    },
    "nzsee2017-face-loaded": {
        ("λ", "ratio"): lambda s: s.known["b"] / (g * s.known["B"]),
    },
    "sliding": {
        **{
            (name, kind): (lambda s, name=name: hinge_value(s, name))
            for name, kind in (("H", "force"), ("V", "force"), ("n_x", "ratio"), ("n_z", "ratio"), ("T", "force"),
                               ("N", "force"), ("N_0", "force"), ("T_0", "force"), ("H_0", "force"), ("λ", "ratio"))
        },
    },
}  # fmt: skip
"""By procedure, where a symbol means another thing."""


def spans(sheet: Sheet) -> bool:
    return sheet.subject.context.support == "spanning"


def given_value(sheet: Sheet, symbol: str, dimension: str) -> float | None:
    """What an input should be that no line has come to; None where the symbol is not known."""
    own = OWN.get(sheet.subject.check.procedure, {})
    reading = own.get((symbol, dimension)) or COMMON.get((symbol, dimension))
    return None if reading is None else reading(sheet)
