"""The calculation sheet of a face-loaded wall."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import Step, step
from assess.codes.context import Context
from assess.codes.nzsee2017.clauses import part_coefficient, period_factor
from assess.codes.nzsee2017.response import Response
from assess.codes.table_steps import instability_step, integral_step, moment_column
from assess.oscillator import Branch
from spectra.floor import NZS_LOW, NZS_SHARE

CLAUSE, PARTS = "NZSEE 2017 C8.8.5", "NZS 1170.5, 8.2-8.4"
AT_REST = "table of the mechanism, at rest"


def sheet(branch: Branch, context: Context, found: Response, *, level: float) -> tuple[Step, ...]:
    """Write all lines of the sheet but the score; level: PGA [m/s2]."""
    return (
        *_wall_steps(branch, found),
        *_thickness_steps(found),
        *_capacity_steps(context, found),
        *_part_steps(context, found, level),
        *_displacement_steps(context, found, found.per_pga * level),
        *_end_steps(found, level),
    )


def _wall_steps(branch: Branch, found: Response) -> tuple[Step, ...]:
    """Write the wall with its own thickness."""
    line, at_rest = found.whole.line, branch.overturning_flexible is None
    phi_i, mark = line.instability, "" if found.gravity is None else "0"
    slope = {f"b{mark}": (line.b, "N m"), f"φ_i{mark}": (phi_i, "rad")}
    return (
        instability_step(f"φ_i{mark}", "rotation at instability", CLAUSE, branch),
        *_moment_steps(branch, f"b{mark}", f"φ_i{mark}", line.b, at_rest=at_rest),
        step(f"a{mark}", "slope of the straight line", CLAUSE, f"b{mark} / φ_i{mark}", line.a, "N m/rad", given=slope),
        step(f"J{mark}", "inertia at rest, about the hinges", CLAUSE, "Σ m (x'² + z'²) + J_G θ'²", found.whole.J,
             "kg m2", remark=AT_REST),
        step(f"B{mark}", "excitation at rest", CLAUSE, "Σ m x'", found.whole.B, "kg m", remark=AT_REST),
    )  # fmt: skip


def _moment_steps(branch: Branch, symbol: str, end: str, moment: float, *, at_rest: bool) -> tuple[Step, ...]:
    """Write b: at rest, or of the straight line that stores the work of the curve up to instability."""
    if at_rest:
        return (step(symbol, "resisting moment", CLAUSE, "V'(0) − M", moment, "N m", remark=AT_REST),)
    stored = "work stored up to instability"
    work = integral_step("E", stored, CLAUSE, moment_column(branch), branch.unstable, "J", upper=end)
    given = {"E": (work.value or 0.0, "J"), end: (branch.unstable, "rad")}
    words = "resisting moment of the straight line that stores the work of the curve"
    return work, step(symbol, words, CLAUSE, f"2 E / {end}", moment, "N m", given=given)


def _thickness_steps(found: Response) -> tuple[Step, ...]:
    """Write the wall with its effective thickness."""
    if found.gravity is None:
        return ()
    gravity, whole, part, k = found.gravity, found.whole, found.part, found.thickness
    taken = {"k": (k, "-")}
    moments = {"b0": (whole.line.b, "N m"), "b_W": (gravity.own_moment, "N m"), "b_P": (gravity.moment, "N m")}
    slopes = {"a0": (whole.line.a, "N m/rad"), "a_W": (gravity.own_slope, "N m/rad")}
    turned = {"J0": (whole.J, "kg m2"), "J_W": (gravity.own_inertia, "kg m2"), "J_P": (gravity.inertia, "kg m2")}
    shaken = {"B0": (whole.B, "kg m"), "B_W": (gravity.own_excitation, "kg m")}
    unstable = {"b": (part.line.b, "N m"), "a": (part.line.a, "N m/rad")}
    words = "effective thickness over thickness; P presses on the wall, W is its own weight"
    return (
        step("k", words, CLAUSE, "0.975 − 0.025 P/W", k, given={"P/W": gravity.overburden_ratio}),
        step("b", "resisting moment, the wall's by k², of P by k", CLAUSE, "b0 − (1 − k²) b_W − (1 − k) b_P",
             part.line.b, "N m", given={**moments, **taken}),
        step("a", "slope, the wall's by k", CLAUSE, "a0 − (1 − k) a_W", part.line.a, "N m/rad",
             given={**slopes, **taken}),
        step("J", "inertia, the wall's by k, of P by k²", CLAUSE, "J0 − (1 − k) J_W − (1 − k²) J_P", part.J, "kg m2",
             given={**turned, **taken}),
        step("B", "excitation, the wall's by k", CLAUSE, "B0 − (1 − k) B_W", part.B, "kg m", given={**shaken, **taken}),
        step("φ_i", "rotation at instability", CLAUSE, "b / a", found.instability, "rad", given=unstable),
    )  # fmt: skip


def _capacity_steps(context: Context, found: Response) -> tuple[Step, ...]:
    factor, part = period_factor(context.support), found.part
    usable = {"s": (found.usable, "-"), "φ_i": (found.instability, "rad")}
    turned = {"c": (factor, "-"), "J": (part.J, "kg m2"), "a": (part.line.a, "N m/rad")}
    return (
        step("φ_m", "usable rotation, its share of that at instability", CLAUSE, "s φ_i", found.usable_rotation, "rad",
             given=usable),
        step("T_p", "period of the part, c by its support", CLAUSE, "c √(J / a)", found.Tp, "s", given=turned),
    )  # fmt: skip


def _part_steps(context: Context, found: Response, level: float) -> tuple[Step, ...]:
    Ci = part_coefficient(found.Tp, floor=1.0)
    C_0 = level / g * found.surface
    Cp = C_0 * found.floor * Ci
    coefficients = {"C(0)": (C_0, "g"), "C_Hi": (found.floor, "-"), "C_i(T_p)": (Ci, "-")}
    demanded = {
        "B": (found.part.B, "kg m"),
        "J": (found.part.J, "kg m2"),
        "T_p": (found.Tp, "s"),
        "C_p(T_p)": (Cp, "-"),
        "R_p": (found.risk_factor, "-"),
    }
    return (
        _floor_step(context, found.floor),
        step("C_i(T_p)", "spectral shape of the part: 2 to 0.75 s, 0.5 from 1.5 s", PARTS,
             "min(2, max(0.5, 2 (1.75 − T_p)))", Ci, given={"T_p": (found.Tp, "s")}),
        step("C_p(T_p)", "part coefficient", PARTS, "C(0) C_Hi C_i(T_p)", Cp, given=coefficients),
        step("φ_D", "demand", CLAUSE, "B / J (T_p / 2π)² C_p(T_p) g R_p", found.per_pga * level, "rad", given=demanded),
    )  # fmt: skip


def _floor_step(context: Context, floor: float) -> Step:
    """Write C_Hi: the least of the rules that apply at the height of the supports."""
    symbol, words = "C_Hi", "floor height coefficient: h_i the mean height of the supports, h_n of the building"
    h_n = None if context.building is None else context.building.height
    h = context.support_height if h_n is None else min(context.support_height, h_n)
    low = h < NZS_LOW
    if h <= 0.0 or (h_n is None and not low):
        return step(symbol, words, PARTS, "1 at the ground, 3 at most", floor, at={"h_i": (h, "m")})
    rules, given = (["1 + h_i / 6"] if low else []), {"h_i": (h, "m")}
    if h_n is not None and h < NZS_SHARE * h_n:
        rules.append("1 + 10 h_i / h_n")
        given["h_n"] = (h_n, "m")
    return step(symbol, words, PARTS, f"min({', '.join([*rules, '3'])})", floor, given=given)


def _displacement_steps(context: Context, found: Response, phi_d: float) -> tuple[Step, ...]:
    """Write the displacements of the Guidelines: at mid-height of a wall that spans, at the top of a free one."""
    if context.wall is None:
        return ()
    h, spanning = context.wall.height, context.support == "spanning"
    arm, over, place = (h / 2.0, " / 2", "at mid-height") if spanning else (h, "", "at the top")

    def line(name: str, angle: str, words: str, rotation: float) -> Step:
        given = {angle: (rotation, "rad"), "h": (h, "m")}
        return step(name, words, CLAUSE, f"{angle} h{over}", rotation * arm, "m", given=given, remark=place)

    return (
        line("Δ_i", "φ_i", "displacement at instability", found.instability),
        line("Δ_m", "φ_m", "usable displacement", found.usable_rotation),
        line("D_ph", "φ_D", "displacement demand", phi_d),
    )


def _end_steps(found: Response, level: float) -> tuple[Step, ...]:
    phi_d, uplift = found.per_pga * level, found.uplift
    rocks = uplift is None or level > uplift
    capable = {
        "φ_m": (found.usable_rotation, "rad"),
        "PGA": (level / g, "g"),
        "φ_D": (phi_d, "rad"),
        "PGA_u": ((uplift or 0.0) / g, "g"),
    }
    held = {"φ_D": (phi_d, "rad"), "φ_m": (found.usable_rotation, "rad")}
    ratio = phi_d / found.usable_rotation
    return (
        _uplift_step(found),
        step("PGA_100", "PGA at 100 %NBS", CLAUSE, "max(φ_m PGA / φ_D, PGA_u)", found.capacity / g, "g", given=capable),
        step("D/C", "ratio", CLAUSE, "φ_D / φ_m", ratio, given=held)
        if rocks
        else step("D/C", "ratio", CLAUSE, "0", 0.0, remark="no motion below uplift"),
    )


def _uplift_step(found: Response) -> Step:
    if found.uplift is None or found.multiplier is None:
        return step("PGA_u", "PGA at uplift: none on joints without a threshold", PARTS, "C_p(0) R_p = λ", None, "g")
    stiff = part_coefficient(0.0, floor=1.0)
    given = {"λ": found.multiplier, "C_Hi": found.floor, "C_i(0)": stiff, "R_p": found.risk_factor, "s": found.surface}
    words = "PGA at uplift, λ = b / (g B) the multiplier at rest, s = C(0)/PGA"
    return step("PGA_u", words, PARTS, "λ / (s C_Hi C_i(0) R_p)", found.uplift / g, "g", given=given)
