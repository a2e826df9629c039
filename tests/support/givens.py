"""What the formulas of calculation sheets begin with: inputs that no line has come to, by symbol and dimension.

The lists are closed, and found as `readings` finds the lines that are read.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import acosh, atan2, hypot, inf, pi, sqrt

import numpy as np
from scipy.constants import g

from assess.oscillator import interpolant
from tests.support.printed_sheet import Sheet
from tests.support.readings import breaking, first_to_slide, floor_demands, shares
from tests.support.subjects import AMPLIFIED, FRICTION, S_X1, VERTICAL


def period_factor(sheet: Sheet) -> float:
    """4 arcosh(1 / (1 − r)), r = 0.36 for a wall that spans and 0.24 for one that stands free (NZSEE C8.8.5)."""
    return 4 * acosh(1 / (1 - (0.36 if sheet.subject.context.support == "spanning" else 0.24)))


def gravity(sheet: Sheet, name: str) -> float:
    return float(getattr(sheet.subject.context.wall.gravity[sheet.subject.check.branch], name))


def secant(sheet: Sheet) -> float:
    """The multiplier where the secant is drawn, or just after an action ends."""
    side = breaking(sheet)
    if sheet.step.symbol == "λ / λ_max":
        end = next(each.rotation for each in sheet.subject.context.limits if each.kind == "break") * (1 + 1e-6)
    else:
        symbol = next(key for key in ("d_s*", "d_SLV", "d_SLC") if key in sheet.known)
        end = sheet.rotation_of(sheet.known[symbol]) * (1 - 1e-9)
    moment, B = (interpolant(side.rotation, each) for each in (side.restoring, side.excitation))
    return float(moment(end) / B(end) / g)


def largest(sheet: Sheet) -> float:
    side = breaking(sheet)
    return float((side.restoring / side.excitation).max() / g)


def linearised(sheet: Sheet, symbol: str) -> float:
    """The straight line that touches the moment where it falls to zero, without given forces, and B there."""
    critical = sheet.instability()
    slope, B = -float(sheet.spline("restoring")(critical, 1)), float(sheet.spline("excitation")(critical))
    return {"K": slope, "φ_cr": critical, "M": 0.0, "B": B}[symbol]


def softened(sheet: Sheet) -> float:
    """T1' over T1: from 1 up of the largest acceleration, the first of equals; else of the largest displacement."""
    T1, T0 = sheet.house.period, sheet.known.get("T0")
    if sheet.step.symbol != "T1'_a":
        return max(floor_demands(sheet, 0.10), key=lambda each: each[0])[1] / T1
    stated = sheet.house.limit_states.get(sheet.subject.check.limit_state)
    ratios = np.linspace(1.0, 2.0 if stated is None else stated.period / T1, 401)
    if T0 is None:
        return float(ratios[np.argmax([sheet.ordinate(each * T1, sheet.mode_damping("T1'")) for each in ratios])])
    own = next(each.value for each in sheet.step.inputs if each.symbol == "k")
    found = [at_the_floor(sheet, each * T1, T0) for each in (*ratios, own)]
    return own if np.isclose(own, ratios, rtol=1e-9).any() and found[-1] >= max(found) * (1 - 1e-9) else inf


def at_the_floor(sheet: Sheet, first: float, period: float) -> float:
    """S_eZ at 5 % under a softened first mode (C7.2.5 to C7.2.8)."""
    xi = sheet.mode_damping("T1'")
    peak = sheet.ordinate(first, xi) * sheet.known["γψ"] * sqrt(1 + (2 * xi) ** 2)
    A = 1.1 / sqrt(xi)
    low, high = 1 - period / (0.8 * first), period / (1.1 * first) - 1
    fall = 1 + (A - 1) * (max(low, 0.0) ** 1.6 + max(high, 0.0) ** 1.2)
    return max(A * peak / fall, sheet.ordinate(period) if first < period else 0.0)


def hinge_value(sheet: Sheet, name: str) -> float:
    first = first_to_slide(sheet) if sheet.step.symbol == "PGA_s" else None
    hinge = first or sheet.hinge()
    if first is not None and name.startswith("T"):
        return abs((first.resting if name == "T_0" else first.starting).shear)
    return {
        "N_r": hinge.starting.normal,
        "a_r": hinge.acceleration,
        "μ": FRICTION,
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


def elastic(sheet: Sheet) -> float:
    """Frequency of small motions on the joint [Hz]."""
    return float(sqrt(sheet.spline("restoring")(0.0, 1) / sheet.rest("inertia")) / (2 * pi))


def resonance_damping(sheet: Sheet) -> float:
    """eta at 5 % for the accelerations, and for the displacements, which come after, at that of the limit state."""
    displaced = any(key.startswith("d_SL") for key in sheet.known)
    return sqrt(10.0 / (5.0 + 100.0 * (sheet.subject.check.damping if displaced else 0.05)))


def on_elastic(sheet: Sheet) -> bool:
    """Whether a line is of the elastic building: it names T1, or is A and the latest a_Z before it is of T1."""
    peaks = [name for name in sheet.known if name.startswith("a_Z(")]
    return "(T1)" in sheet.step.symbol or (sheet.step.symbol == "A" and peaks[-1:] == ["a_Z(T1)"])


def largest_acceleration(sheet: Sheet) -> float:
    """Of ground and floor, at T0 where the element has a period before it lifts off."""
    free = "S_e(T0)" in sheet.known
    names = ("S_e(T0)", "S_eZ(T0)") if free else ("a_Z",)
    found = [value for key, value in sheet.known.items() if key.startswith(names) and value is not None]
    return max(found, default=0.0) if free else max([sheet.pga, *found])


def pga_in_line(sheet: Sheet) -> float:
    """The site's own where the PGA of a limit state is found, else that."""
    return sheet.subject.context.spectrum.pga if sheet.step.symbol.startswith("PGA_S") else sheet.pga


def point(name: str) -> Callable[[Sheet], float]:
    """An ordinate of a line that reads a table: of the points on either side, of the largest, or of Simpson's rule."""

    def reading(sheet: Sheet) -> float:
        letter, place = name.split("_")
        side = breaking(sheet) if sheet.step.symbol in ("R", "B") else sheet.subject.branch
        columns = {"φ": side.rotation, "R": side.restoring, "B": side.excitation}
        line = {each.symbol: each.value for each in (*sheet.step.inputs, *sheet.step.at)}
        if place == "m":
            return float(columns[letter][np.argmax(side.restoring / side.excitation)])
        if "φ_1" in line:
            read = sheet.step.symbol in ("R", "B")
            at = next(iter(line.values())) if read else sheet.instability()
            return float(columns[letter][np.searchsorted(side.rotation, at) - 2 + int(place)])
        strips = sum(each.startswith(f"{letter}_") for each in line) - 1
        return float(interpolant(side.rotation, columns[letter])(next(iter(line.values())) * int(place) / strips))

    return reading


def local_limit(sheet: Sheet, kind: str) -> float:
    """The rotation where a tie ends, or a seat is lost."""
    here = [each for each in sheet.subject.context.limits if each.branch == sheet.subject.check.branch]
    return next(each.rotation for each in here if each.kind == kind)


def share(number: int, of: str) -> Callable[[Sheet], float]:
    """d* of a record over a displacement."""

    def ratio(sheet: Sheet) -> float:
        found = shares(sheet, sheet.known[of])[number]
        return inf if found is None else found

    return ratio


def row(sheet: Sheet, name: str) -> float:
    """A row of the hazard beside the PGA at capacity."""
    hazard, (what, place) = sheet.subject.context.hazard, name.rsplit("_", 1)
    above = int(np.searchsorted(hazard.pga, sheet.subject.check.capacity_pga_g * g))
    return {"T": hazard.return_period, "PGA": hazard.pga}[what][above - 2 + int(place)]


def demand_damping(sheet: Sheet) -> float:
    """Of an ordinate: 5 % before uplift, 10 % of a sliding body, else of the check."""
    return {"S_e(T0)": 0.05, "f_es": 0.10}.get(sheet.step.symbol) or sheet.subject.check.damping


Reading = Callable[[Sheet], float]
POINTS = tuple(f"{letter}_{place}" for letter in "φRB" for place in (*range(17), "m"))
KINDS = {"φ": "rotation", "R": "moment", "B": "first moment"}
COMMON: Mapping[tuple[str, str], Reading] = {
    ("B0", "first moment"): lambda s: s.rest("excitation"),
    ("M", "mass"): lambda s: s.mass,
    ("V'(0) − M", "moment"): lambda s: s.rest("restoring"),
    **{(name, KINDS[name[0]]): point(name) for name in POINTS},
    ("φ_break1", "rotation"): lambda s: local_limit(s, "break"),
    ("φ_seat1", "rotation"): lambda s: local_limit(s, "seat"),
    ("n", "ratio"): lambda s: float(np.searchsorted(s.subject.branch.rotation, s.step.at[0].value)),
    **{(name, "return period"): (lambda s, name=name: row(s, name)) for name in ("T_1", "T_2")},
    **{(name, "acceleration"): (lambda s, name=name: row(s, name)) for name in ("PGA_1", "PGA_2")},
    ("PGA_C", "acceleration"): lambda s: s.subject.check.capacity_pga_g * g,
    ("T_R", "return period"): lambda s: s.step.value,
    ("ξ", "ratio"): demand_damping,
    ("level", "ground acceleration"): lambda s: s.level / g,
    ("least PGA(θ)", "ground acceleration"): lambda s: min(s.subject.check.pga_curve.pga_g),
    ("T", "time"): lambda s: 1 / s.known["f_e"],
    ("T0", "time"): lambda s: 0.0,  # of what does not move before it lifts off
    ("κ", "ratio"): lambda s: 6.2,
    ("L", "length"): lambda s: 4.0,
    ("t", "length"): lambda s: 0.3,
    ("ρ", "density"): lambda s: 1800.0,
    ("E", "stress"): lambda s: 7e8,
    ("I_O", "inertia"): lambda s: s.rest("inertia"),
    ("Σ m δx", "first moment"): lambda s: s.rest("excitation"),
    ("Σ m δx²", "inertia"): lambda s: s.rest("participation"),
    ("∫ B dφ", "first moment"): lambda s: s.moved(s.instability()),
    ("e*", "ratio"): lambda s: s.e,
    ("S_aV/S_aH", "ratio"): lambda s: VERTICAL,
    ("C_R", "ratio"): lambda s: s.subject.branch.restitution,
    ("φ_ov", "rotation"): lambda s: s.instability(),
    ("E", "energy"): lambda s: float(s.spline("restoring").integrate(0.0, s.known["θ"])),
    ("R", "length"): lambda s: hypot(s.rest("restoring") / g, s.rest("excitation")) / s.mass,
    ("α", "rotation"): lambda s: atan2(s.rest("restoring") / g, s.rest("excitation")),
    ("level", "acceleration"): lambda s: s.level,
    ("PGA_L", "acceleration"): lambda s: s.level,
    ("PGA", "acceleration"): pga_in_line,
    ("PGA", "ground acceleration"): lambda s: (s.pga if s.step.symbol == "ζ_E" else s.level) / g,
    ("C(0)", "ground acceleration"): lambda s: s.level / g,
    ("PGA_C", "ground acceleration"): lambda s: s.subject.check.capacity_pga_g,
    ("q", "ratio"): lambda s: 2.0,
    ("D", "acceleration"): demand,
    ("D", "length"): demand,
    ("T1", "time"): lambda s: s.house.period,
    ("S_e(T1)", "acceleration"): lambda s: s.ordinate(s.house.period),
    ("S_De(T1)", "length"): lambda s: s.ordinate(s.house.period) * (s.house.period / (2 * pi)) ** 2,
    ("ψ", "ratio"): lambda s: min(s.subject.context.support_height / s.house.height, 1.0),
    ("γ", "ratio"): lambda s: 3.0 * 2 / (2 * 2 + 1),
    ("N", "ratio"): lambda s: 2.0,
    ("Z", "length"): lambda s: min(s.subject.context.support_height, s.house.height),
    ("z", "length"): lambda s: s.subject.context.support_height,
    ("H", "length"): lambda s: s.house.height,
    ("ξ1", "ratio"): lambda s: 0.2 if s.step.symbol == "d(20 %)" else s.mode_damping("T1" if on_elastic(s) else "T1'"),
    ("η", "ratio"): resonance_damping,
    ("b", "ratio"): lambda s: 1.1,
    ("a", "ratio"): lambda s: 0.8,
    ("a_max", "acceleration"): largest_acceleration,
    ("k", "ratio"): lambda s: 0.4 if s.subject.check.procedure.startswith("dmi") else softened(s),
    ("λ", "ratio"): secant,
    ("λ_max", "ratio"): largest,
    ("S_e(T_SLV)", "acceleration"): lambda s: s.ordinate(s.known["T_SLV"], s.subject.check.damping),
    ("S_eZ(T1')", "acceleration"): lambda s: s.known["A"] * s.known["a_Z(T1')"],
    ("T_1", "time"): lambda s: s.house.period,
    ("α S", "ratio"): lambda s: s.level / g,
    ("S_a(1 s)/PGA", "ratio"): lambda s: s.over_pga(1.0, 0.05) if S_X1 is None else S_X1 / (s.spectrum.pga / g),
    ("s", "ratio"): lambda s: 1.0 if s.step.symbol == "PGA_u" else (0.6 if spans(s) else 0.3),
    ("c", "ratio"): period_factor,
    ("h_i", "length"): lambda s: s.subject.context.support_height,
    ("h_n", "length"): lambda s: s.house.height,
    ("R_p", "ratio"): lambda s: 1.0,
    ("h", "length"): lambda s: s.subject.context.wall.height,
    ("C_i(0)", "ratio"): lambda s: 2.0,
    ("P/W", "ratio"): lambda s: gravity(s, "overburden_ratio"),
    ("b_W", "moment"): lambda s: gravity(s, "own_moment"),
    ("b_P", "moment"): lambda s: gravity(s, "moment"),
    ("a_W", "rotational stiffness"): lambda s: gravity(s, "own_slope"),
    ("J_W", "inertia"): lambda s: gravity(s, "own_inertia"),
    ("J_P", "inertia"): lambda s: gravity(s, "inertia"),
    ("b_A", "moment"): lambda s: gravity(s, "edge_moment"),
    ("J_A", "inertia"): lambda s: gravity(s, "edge_inertia"),
    ("B_W", "first moment"): lambda s: gravity(s, "own_excitation"),
    ("f", "ratio"): lambda s: AMPLIFIED,
    ("f", "frequency"): elastic,
    **{
        (f"S a_g,{state}", "acceleration"): (lambda s, state=state: s.subject.context.hazard.spectra[state].pga)
        for state in ("SLD", "SLV", "SLC")
    },
    **{(f"r_{number}", "ratio"): record(number - 1) for number in range(1, 8)},
}
OWN: Mapping[str, Mapping[tuple[str, str], Reading]] = {
    "dmi2008-nonlinear-thesis": {
        ("K", "rotational stiffness"): lambda s: linearised(s, "K"),
        ("φ_cr", "rotation"): lambda s: linearised(s, "φ_cr"),
        ("M", "moment"): lambda s: linearised(s, "M"),
        ("B", "first moment"): lambda s: linearised(s, "B"),
    },
    **{
        f"{code}-history": {
            **{(f"c_{number}", "ratio"): share(number - 1, "d0*") for number in range(1, 8)},
            **{(f"r_{number}", "ratio"): share(number - 1, "d_SLV") for number in range(1, 8)},
        }
        for code in ("dmi2008", "ntc2018")
    },
    "asce43-05-spectrum": {("c", "ratio"): lambda s: 0.4},
    "asce43-05-spectrum-thesis": {("S_aV/S_aH", "ratio"): lambda s: 0.0},
    "asce43-05-history": {("c", "ratio"): lambda s: 0.4},
    "ec8-element": {
        ("κ", "ratio"): lambda s: 2.2 if spans(s) else 6.2,
        ("L", "length"): lambda s: s.subject.context.wall.height,
        ("t", "length"): lambda s: s.subject.context.wall.thickness,
        ("ρ", "density"): lambda s: 2200.0,
        ("E", "stress"): lambda s: 0.15e9,
    },
    "asce43-05-sliding": {
        ("μ", "ratio"): lambda s: FRICTION,
        ("N", "force"): normal,
    },
    "nzsee2017-face-loaded": {
        ("λ", "ratio"): lambda s: s.known.get("b_ψ", s.known["b"]) / (g * s.known["B"]),
        ("ψ", "ratio"): lambda s: 0.005,
    },
    "sliding": {
        **{
            (name, kind): (lambda s, name=name: hinge_value(s, name))
            for name, kind in (("H", "force"), ("V", "force"), ("n_x", "ratio"), ("n_z", "ratio"), ("T", "force"),
                               ("N", "force"), ("N_0", "force"), ("T_0", "force"), ("N_r", "force"), ("T_r", "force"),
                               ("a_r", "acceleration"), ("μ", "ratio"), ("H_0", "force"), ("λ", "ratio"))
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
