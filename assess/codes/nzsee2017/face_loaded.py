"""C8.8.5: the usable rotation of a face-loaded wall against the demand of NZS 1170.5, section 8, as %NBS."""

from __future__ import annotations

from dataclasses import dataclass, replace

from scipy.constants import g

from assess.codes.check import BranchName, Check, Outcome, PgaCurve, Reason, Step, because
from assess.codes.context import Context
from assess.codes.family import foreign
from assess.codes.governing import governing
from assess.codes.nzsee2017.clauses import (
    CAVEAT,
    CAVEAT_FREE,
    EDITION,
    USABLE,
    Line,
    Options,
    demand_per_pga,
    floor_factor,
    part_coefficient,
    period,
    period_factor,
    straight_line,
    uplift_pga,
)
from assess.codes.relation import as_curve, relation
from assess.message import Message
from assess.oscillator import Branch, FloatArray, Oscillator

NAME, SCORE = "nzsee2017-face-loaded", "%NBS"
CLAUSE, PARTS = "NZSEE 2017 C8.8.5", "NZS 1170.5, 8.2-8.4"
DAMPING = 0.05


@dataclass(frozen=True)
class Response:
    """One branch by the clause.

    line : restoring moment; Tp : period [s]; usable : phi_m / phi_i [-]; floor : C_Hi [-]
    per_pga : phi_D over PGA [rad s2/m]; uplift : PGA below which nothing rocks [m/s2], None on yielding joints
    """

    line: Line
    Tp: float
    usable: float
    floor: float
    per_pga: float
    uplift: float | None

    @property
    def allowed(self) -> float:
        """phi_m [rad]."""
        return self.usable * self.line.instability

    @property
    def capacity(self) -> float:
        """PGA at 100 %NBS [m/s2]."""
        return max(self.allowed / self.per_pga, self.uplift or 0.0)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """C8.8.5: phi_m against phi_D at C(0) = the level; one check for each level, on the worse branch, with its %NBS."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        return _answered(_check(name, context, level), branch, context, options, level)

    return tuple(_scored(check) for check in governing(oscillator, context.levels, one))


def response(branch: Branch, context: Context, options: Options) -> Response:
    """Line, period and demand of one branch."""
    line, floor = straight_line(branch), floor_factor(context)
    Tp = period(branch, line, support=context.support)
    usable = USABLE[context.support] if options.usable is None else options.usable
    per_pga = demand_per_pga(branch, Tp, floor=floor, risk_factor=options.risk_factor)
    uplift = uplift_pga(branch, floor=floor, risk_factor=options.risk_factor)
    return Response(line, Tp, usable, floor, per_pga, uplift)


def _check(name: BranchName, context: Context, level: float) -> Check:
    return Check(
        procedure=NAME,
        edition=EDITION,
        branch=name,
        limit_state="ULS",
        level_pga_g=level / g,
        input_at="mechanism base" if context.above_ground else "ground",
        damping=DAMPING,
        quantity="rotation",
        unit="rad",
        verdict=Outcome.NOT_APPLICABLE,
        reason=because(Reason.NOT_A_WALL, clause=CLAUSE),
        caveat=CAVEAT + CAVEAT_FREE * (context.support == "free") + foreign(NAME, context.spectrum.code),
    )


def _answered(check: Check, branch: Branch, context: Context, options: Options, level: float) -> Check:
    found = response(branch, context, options)
    demanded = 0.0 if level <= (found.uplift or 0.0) else found.per_pga * level
    ratio = demanded / found.allowed
    verdict = Outcome.PASS if ratio <= 1.0 else Outcome.FAIL
    stands = demanded < found.line.instability
    return replace(
        check,
        demand=demanded,
        capacity=found.allowed,
        ratio=ratio,
        verdict=verdict,
        reason=_reason(demanded, verdict),
        capacity_pga_g=found.capacity / g,
        uplift_pga_g=None if found.uplift is None else found.uplift / g,
        capacity_rotation_ratio=found.allowed / branch.overturning,
        rotation_ratio=demanded / branch.overturning if stands else None,
        pga_curve=_curve(branch, found),
        steps=_steps(branch, context, options, found, level=level, demanded=demanded),
    )


def _reason(demanded: float, verdict: Outcome) -> Message:
    if demanded == 0.0:
        return because(Reason.NO_ROCKING)
    return because(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity="the usable rotation")


def _curve(branch: Branch, found: Response) -> PgaCurve:
    def pga_of(rotation: FloatArray) -> FloatArray:
        return rotation / found.per_pga

    return as_curve(relation(pga_of, overturning=branch.unstable, uplift=found.uplift or 0.0), branch)


def _scored(check: Check) -> Check:
    """The check with its %NBS: PGA at capacity over PGA of the level, which below uplift is no ratio of rotations."""
    if check.capacity_pga_g is None:
        return check
    score = 100.0 * check.capacity_pga_g / check.level_pga_g
    numbers = f"100 · {check.capacity_pga_g:.5g} / {check.level_pga_g:.5g}"
    step = Step(SCORE, "share of the new building standard", CLAUSE, "100 · PGA_100 / PGA", numbers, score, "%")
    return replace(check, score={SCORE: score}, steps=(*check.steps, step))


def _steps(
    branch: Branch, context: Context, options: Options, found: Response, *, level: float, demanded: float
) -> tuple[Step, ...]:
    line, at_rest = found.line, branch.overturning_flexible is None
    b_formula = "restoring moment at rest" if at_rest else "2 E(φ_i) / φ_i: the line with the work of the curve"
    phi_i, R_p = line.instability, options.risk_factor
    Ci = part_coefficient(found.Tp, floor=1.0)
    Cp, J, B = level / g * found.floor * Ci, float(branch.inertia[0]), float(branch.excitation[0])
    factor = period_factor(context.support)
    spectral = f"{B:.5g} / {J:.5g} · ({found.Tp:.5g} / 2π)² · {Cp:.5g} · 9.80665 · {R_p:g}"
    phi_d = found.per_pga * level
    capable = f"max({found.allowed:.5g} · {level / g:.5g} / {phi_d:.5g}, {(found.uplift or 0.0) / g:.5g})"
    return (
        Step("φ_i", "rotation at instability", CLAUSE, "restoring moment = 0", "curve", phi_i, "rad"),
        Step("b", "resisting moment", CLAUSE, b_formula, "curve", line.b, "N m"),
        Step("a", "slope of the straight line", CLAUSE, "b / φ_i", f"{line.b:.5g} / {phi_i:.5g}", line.a, "N m/rad"),
        Step("J", "inertia at rest, about the hinges", CLAUSE, "Σ m (x'² + z'²) + J_G θ'²", "curve", J, "kg m2"),
        Step("B", "excitation at rest", CLAUSE, "Σ m x'", "curve", B, "kg m"),
        Step("φ_m", "usable rotation", CLAUSE, "share · φ_i", f"{found.usable:g} · {phi_i:.5g}", found.allowed, "rad"),
        Step(
            "T_p",
            "period of the part",
            CLAUSE,
            f"{factor:.3g} √(J / a)",
            f"{factor:.5g} √({J:.5g} / {line.a:.5g})",
            found.Tp,
            "s",
        ),
        *_part_steps(context, found, Ci, Cp, level),
        Step("φ_D", "demand", CLAUSE, "B / J (T_p / 2π)² C_p(T_p) g R_p", spectral, phi_d, "rad"),
        *_at_height(context, found, phi_d),
        Step("C_p(0) = λ", "PGA at uplift", PARTS, "λ / (C_Hi C_i(0) R_p)", *_uplift_of(found)),
        Step("PGA_100", "PGA at 100 %NBS", CLAUSE, "max(φ_m PGA / φ_D, uplift)", capable, found.capacity / g, "g"),
        Step(
            "D/C",
            "ratio" if demanded else "ratio; below uplift nothing moves",
            CLAUSE,
            "demand / capacity",
            f"{demanded:.5g} / {found.allowed:.5g}",
            demanded / found.allowed,
            "-",
        ),
    )


def _uplift_of(found: Response) -> tuple[str, float | None, str]:
    if found.uplift is None:
        return "joints that answer at once", None, "g"
    return f"C_Hi = {found.floor:.5g}, C_i(0) = 2", found.uplift / g, "g"


def _part_steps(context: Context, found: Response, Ci: float, Cp: float, level: float) -> tuple[Step, ...]:
    building = context.building
    where = f"h_i = {context.support_height:.4g} m"
    where += f", h_n = {building.height:.4g} m" if building is not None else ", h_n not known"
    numbers = f"{level / g:.5g} · {found.floor:.5g} · {Ci:.5g}"
    shape = "2 to 0.75 s, 2 (1.75 − T_p) to 1.5 s, 0.5"
    rule = "least of 1 + h_i/6 (h_i < 12 m), 1 + 10 h_i/h_n, 3"
    return (
        Step("C_Hi", "floor height coefficient, mean of the supports", PARTS, rule, where, found.floor, "-"),
        Step("C_i(T_p)", "spectral shape of the part", PARTS, shape, f"T_p = {found.Tp:.5g} s", Ci, "-"),
        Step("C_p(T_p)", "part coefficient", PARTS, "C(0) C_Hi C_i(T_p)", numbers, Cp, "-"),
    )


def _at_height(context: Context, found: Response, phi_d: float) -> tuple[Step, ...]:
    """The displacements that the Guidelines print: at mid-height of a wall that spans, at the top of a free one."""
    if context.wall is None:
        return ()
    spanning = context.support == "spanning"
    arm, place = (context.wall.height / 2.0, "mid-height") if spanning else (context.wall.height, "top")
    symbol = "h / 2" if spanning else "h"

    def step(name: str, angle: str, words: str, rotation: float) -> Step:
        numbers = f"{rotation:.5g} · {arm:.5g}"
        return Step(name, f"{words}, {place}", CLAUSE, f"{angle} {symbol}", numbers, rotation * arm, "m")

    return (
        step("Δ_i", "φ_i", "displacement at instability", found.line.instability),
        step("Δ_m", "φ_m", "usable displacement", found.allowed),
        step("D_ph", "φ_D", "displacement demand", phi_d),
    )
