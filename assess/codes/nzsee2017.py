"""NZSEE/MBIE Guidelines 2017, C8.8.5 and Appendix C8B: a cracked wall loaded on its face, by displacement.

The usable rotation of the wall is compared with the demand of NZS 1170.5, section 8, and gives its %NBS. The Guidelines
write the equation of motion of the leading block, J phi'' + b - a phi = ..., with displacements at mid-height; here it
is that of the oscillator, in rotations, for any mechanism of walls:

    b, a    the straight line of the restoring moment: at rest, and its slope down to phi_i, where it is zero
    phi_m = usable phi_i                               the largest usable rotation
    T_p = 4.07 sqrt(J / a)                             J = I at rest; four times the way back from 0.6 phi_m
    phi_D = (B / J) (T_p / 2 pi)^2 C_p(T_p) g R_p      gamma = B h / (2 J) of the Guidelines is that of mid-height
    %NBS = 100 phi_m / phi_D

A wall that spans counts with its effective thickness, t_eff = k t, k = 0.975 - 0.025 P/W: the corners of its joints
are not sharp. The arms of b are shares of t, and the wall's weight W goes with t, while the load P stays; so

    b = k^2 b_W + k b_P        a = k a_W + a_P        J = k J_W + k^2 J_P        B = k B_W + B_P        phi_i = b / a

with W what is the wall's own and P what presses on it; moments of ties and of horizontal forces, whose arms are
heights, stay. (The wall's share of J is W h^2 / 12 g but for terms of (t/h)^2, that of P an arm in t squared.) Of the
uniform walls of C8B, case 0 has b_W = W t/2, b_P = P t, a_W = W h/2, a_P = P h: Delta_i = k t/2; T_p hardly moves.

The base reaction of such a wall is at its face, e_b = t/2, only where the drawing has masonry or a foundation below it
that bears it from face to face; on a beam, on the edge of a slab and where nothing is drawn e_b = 0. What the hinge at
the edge gives beyond that comes off b and J. The slope psi of the storey tilts a wall that spans: it takes psi (W_b y_b
+ W_t y_t) = psi g B off b.

The factor of T_p is 4 arcosh(1 / (1 - r)), r the rotation let go over phi_i: r = 0.6 x 0.6 gives 4.07. The period that
the Guidelines print for walls that stand free, sqrt(0.65 h (1 + (t/h)^2)), is 3.10 sqrt(J / a), which is r = 0.8 x 0.3:
so it belongs to a usable 0.3. Formulas are from memory and re-derived; numbers of clauses are unsure. One function for
each.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from assess.codes.calculation_sheet import Given, Step, instability_step, integral_step, moment_column, step
from assess.codes.check import (
    NEW_ZEALAND,
    ORDINATE,
    TABLE_SPECTRUM,
    Check,
    CodeProcedure,
    DefaultRun,
    Family,
    Outcome,
    PgaCurve,
    Premise,
    Reason,
    caveats_of,
    check_worst_branch,
    missing_ordinate,
    reason_message,
)
from assess.codes.context import Context, Gravity, WallSupport
from assess.codes.pga_rotation import pga_rotation, to_pga_curve
from assess.declaration import Evidence, Number, PositiveAcceleration, Safe, Share
from assess.messages.message import Message, Quantity, Term, message
from assess.oscillator import Branch, BranchName, Oscillator, energy, threshold
from spectra.arrays import FloatArray
from spectra.floor import NZS_LOW, NZS_SHARE, nzs1170_5_height_coefficient, part_shape
from spectra.gravity import g
from spectra.nzs1170_5 import return_period_factor

EDITION = "NZSEE/MBIE Guidelines 2017, C8"
CLAUSE, PARTS = "NZSEE 2017 C8.8.5", "NZS 1170.5, 8.2-8.4"
CAVEAT = "formulas from memory, re-derived, not checked against the printed Guidelines; numbers of clauses unsure"
CAVEAT_FREE = (
    "the usable 0.3 of walls that stand free is unsure (0.6 in 2006); whether this is a wall, the engineer must judge"
)
SCORE = "%NBS"
DAMPING = 0.05
USABLE: dict[WallSupport, float] = {"spanning": 0.6, "free": 0.3}  # phi_m / phi_i
THICKNESS = (0.975, 0.025)  # t_eff / t without overburden, and what each P/W takes off
LET_GO: dict[WallSupport, float] = {"spanning": 0.6, "free": 0.8}  # rotation from which T_p is counted, over phi_m
LARGEST_FLOOR_FACTOR = 3.0  # C_Hi, NZS 1170.5, 8.3


USABLE_ROTATION = Evidence(
    "code", "up", "0.6 of walls that span, 0.3 of others; a larger one is for comparison", safe=Safe.ABSENT
)
STOREY_SLOPE = 0.005  # psi of buildings of masonry; 0.025 with frames
STOREY_DRIFT = Evidence(
    "code", "down", "0.005 of buildings of masonry, where less; 0.025 with frames", safe=STOREY_SLOPE
)
RISK_FACTOR = Evidence("code", "down", "1.0, where less", safe=1.0)


@dataclass(frozen=True)
class Nzsee2017Options:
    """Options of the face-loaded walls of NZSEE 2017, C8."""

    usable: Annotated[Share | None, USABLE_ROTATION] = None
    """usable rotation over that at instability; if absent 0.6 for walls that span, 0.3 for those that stand free; a
    larger one is shown for comparison"""
    risk_factor: Annotated[float, Number("ratio", least=0.9), RISK_FACTOR] = 1.0
    """risk factor R_p of the part, NZS 1170.5 Table 8.1"""
    storey_slope: Annotated[float, Number("ratio", least=0, most=0.1), STOREY_DRIFT] = STOREY_SLOPE
    """slope psi of the storey between the supports of a wall that spans: 0.005 in buildings of masonry, 0.025 with
    frames"""
    c_0: Annotated[PositiveAcceleration | None, ORDINATE] = None
    """C(0) at the site's own peak ground acceleration; needed where the spectrum is a table"""


ULS_YEARS = {1: 100.0, 2: 500.0, 3: 1000.0, 4: 2500.0}
"""Return period of ULS by importance level, of buildings meant for 50 years (NZS 1170.0, Table 3.3; from memory)."""


def required_return_factor(importance_level: int) -> float:
    """Return R of ULS [-] at an importance level from 1 to 4 (NZS 1170.0, Table 3.3; NZS 1170.5, Table 3.5)."""
    return return_period_factor(ULS_YEARS[importance_level])


def assess_face_loaded_wall(
    oscillator: Oscillator, context: Context, *, options: Nzsee2017Options
) -> tuple[Check, ...]:
    """Check phi_m against phi_D at C(0) = the level, on the worse branch of each level, with its %NBS (C8.8.5).

    Where a larger usable rotation than the Guidelines' is given, the checks by theirs come first, and those by the
    given one are for comparison.
    """
    most = USABLE.get(context.support)
    if most is None or options.usable is None or options.usable <= most:
        return _checks(oscillator, context, options)
    values = {"given": Quantity(options.usable), "deciding": Quantity(most)}
    beyond = message("larger-usable-rotation", values)
    shown = _checks(oscillator, context, options)
    return (
        *_checks(oscillator, context, replace(options, usable=None)),
        *(replace(check, informs=True, remarks=(*check.remarks, beyond)) for check in shown),
    )


@dataclass(frozen=True)
class WallResponse:
    """One branch by the clause.

    nominal, effective : with its own and with its effective thickness; gravity : None where they are the same
    slope : psi [-], 0 of a wall that stands free; it is in neither of the two walls
    Tp : period [s]; usable : phi_m / phi_i [-]; floor : C_Hi [-]; risk_factor : R_p [-]
    surface : C(0) over the PGA of the spectrum [-]
    per_pga : phi_D over PGA [rad s2/m]; multiplier : at rest [-], uplift : PGA below which nothing rocks [m/s2]; both
    None on joints without a threshold
    """

    nominal: FaceLoadedWall
    effective: FaceLoadedWall
    gravity: Gravity | None
    slope: float
    Tp: float
    usable: float
    floor: float
    risk_factor: float
    surface: float
    per_pga: float
    multiplier: float | None
    uplift: float | None

    @property
    def thickness(self) -> float:
        """t_eff / t [-]."""
        return 1.0 if self.gravity is None else thickness_factor(self.gravity.overburden_ratio)

    @property
    def tilted(self) -> MomentLine:
        """The line of the wall that the storey tilts."""
        return tilted_line(self.effective, self.slope)

    @property
    def instability(self) -> float:
        """phi_i [rad]."""
        return self.tilted.instability

    @property
    def usable_rotation(self) -> float:
        """phi_m [rad]."""
        return self.usable * self.instability

    @property
    def capacity(self) -> float:
        """PGA at 100 %NBS [m/s2]."""
        return max(self.usable_rotation / self.per_pga, self.uplift or 0.0)


def wall_response(branch: Branch, name: BranchName, context: Context, options: Nzsee2017Options) -> WallResponse:
    """Return line, period and demand of one branch.

    Parameters
    ----------
    branch, name : the direction of rocking
    context : site, building and size of the wall
    options : usable rotation, R_p and C(0), where they are given

    Returns
    -------
    WallResponse
    """
    whole, floor = nominal(branch), floor_factor(context)
    gravity = gravity_of(whole, name, context)
    wall = whole if gravity is None else with_effective_thickness(seated_wall(whole, gravity), gravity)
    Tp, R_p, at_rest = part_period(wall, support=context.support), options.risk_factor, threshold(branch)
    slope = options.storey_slope if context.support == "spanning" else 0.0
    tilted = tilted_line(wall, slope)
    multiplier = None if at_rest is None else at_rest * (tilted.b / wall.B) / (whole.line.b / whole.B)
    surface = 1.0 if options.c_0 is None else options.c_0 / context.spectrum.pga
    return WallResponse(
        nominal=whole,
        effective=wall,
        gravity=gravity,
        slope=slope,
        Tp=Tp,
        usable=USABLE[context.support] if options.usable is None else options.usable,
        floor=floor,
        risk_factor=R_p,
        surface=surface,
        per_pga=surface * demand_per_pga(wall, Tp, floor=floor, risk_factor=R_p),
        multiplier=multiplier,
        uplift=uplift_pga(multiplier, floor=surface * floor, risk_factor=R_p),
    )


def is_overloaded(name: BranchName, context: Context) -> bool:
    """Return whether the load on the wall leaves it no effective thickness."""
    gravity = {} if context.wall is None else context.wall.gravity
    return name in gravity and thickness_factor(gravity[name].overburden_ratio) == 0.0


def gravity_of(whole: FaceLoadedWall, name: BranchName, context: Context) -> Gravity | None:
    """Return what the effective thickness acts on; None for a wall that stands free.

    Where the wall's weight and load are not known apart, all of it counts as the wall's own.
    """
    if context.support != "spanning":
        return None
    known = {} if context.wall is None else context.wall.gravity
    return known.get(name, Gravity(0.0, whole.line.b, 0.0, whole.line.a, whole.J, 0.0, whole.B))


@dataclass(frozen=True)
class MomentLine:
    """The restoring moment as a straight line: b at rest [N m], slope a [N m/rad], b = a phi_i."""

    b: float
    a: float

    @property
    def instability(self) -> float:
        """phi_i [rad]."""
        return self.b / self.a


@dataclass(frozen=True)
class FaceLoadedWall:
    """One branch as the clause sees it: its line, J [kg m2] and B [kg m] at rest."""

    line: MomentLine
    J: float
    B: float


def nominal(branch: Branch) -> FaceLoadedWall:
    """Return the branch with its own thickness."""
    return FaceLoadedWall(straight_line(branch), float(branch.inertia[0]), float(branch.excitation[0]))


def seated_wall(wall: FaceLoadedWall, gravity: Gravity) -> FaceLoadedWall:
    """Return the wall with its base reaction where the drawing bears it.

    Parameters
    ----------
    wall : with its reaction at the hinge of the base
    gravity : with what that hinge gives beyond the drawing

    Returns
    -------
    FaceLoadedWall
    """
    line = MomentLine(wall.line.b - gravity.edge_moment, wall.line.a)
    return replace(wall, line=line, J=wall.J - gravity.edge_inertia)


def with_effective_thickness(wall: FaceLoadedWall, gravity: Gravity) -> FaceLoadedWall:
    """Return the wall with its effective thickness, by the formulas at the top of this file.

    Parameters
    ----------
    wall : the wall with its own thickness
    gravity : what its own weight and the overburden give to it

    Returns
    -------
    FaceLoadedWall
    """
    k = thickness_factor(gravity.overburden_ratio)
    b = wall.line.b - (1.0 - k**2) * gravity.own_moment - (1.0 - k) * gravity.moment
    a = wall.line.a - (1.0 - k) * gravity.own_slope
    J = wall.J - (1.0 - k) * gravity.own_inertia - (1.0 - k**2) * gravity.inertia
    return FaceLoadedWall(MomentLine(b, a), J, wall.B - (1.0 - k) * gravity.own_excitation)


def tilted_line(wall: FaceLoadedWall, slope: float) -> MomentLine:
    """Return the line of a wall between supports that the storey tilts: b less psi g B, of the same fall a.

    Parameters
    ----------
    wall : upright
    slope : psi of the storey [-]

    Returns
    -------
    With b of 0 or less where the slope alone brings the wall down.
    """
    return MomentLine(wall.line.b - slope * g * wall.B, wall.line.a)


def thickness_factor(overburden_ratio: float) -> float:
    """Return k = t_eff / t = 0.975 - 0.025 P/W [-]; 0 from P = 39 W on, where no effective thickness is left."""
    whole, taken = THICKNESS
    return max(whole - taken * max(overburden_ratio, 0.0), 0.0)


def straight_line(branch: Branch) -> MomentLine:
    """Return the line from the restoring moment at rest down to phi_i.

    On flexible joints the moment at rest is zero: there the line does the same work up to phi_i as the curve.
    """
    phi_i = branch.unstable
    if branch.overturning_flexible is None:
        b = float(branch.restoring[0])
    else:
        b = 2.0 * float(energy(branch, np.array(phi_i))) / phi_i
    return MomentLine(b, b / phi_i)


def part_period(wall: FaceLoadedWall, *, support: WallSupport) -> float:
    """Return T_p = factor sqrt(J / a).

    Parameters
    ----------
    wall : the wall
    support : how it is held

    Returns
    -------
    float [s]
    """
    return period_factor(support) * float(np.sqrt(wall.J / wall.line.a))


def period_factor(support: WallSupport) -> float:
    """Return 4 arcosh(1 / (1 - r)) [-]: 4.07 for a wall that spans, 3.10 for one that stands free."""
    r = USABLE[support] * LET_GO[support]
    return float(4.0 * np.arccosh(1.0 / (1.0 - r)))


def floor_factor(context: Context) -> float:
    """Return C_Hi at the height of the supports [-] (NZS 1170.5, 8.3).

    Without a building it is the largest that this height can have; supports above the building count as at its top.
    """
    height = context.support_height
    if height <= 0.0:
        return 1.0
    if context.building is not None:
        return nzs1170_5_height_coefficient(
            min(height, context.building.height), building_height=context.building.height
        )
    return min(1.0 + height / 6.0, LARGEST_FLOOR_FACTOR) if height < NZS_LOW else LARGEST_FLOOR_FACTOR


def part_coefficient(Tp: float, *, floor: float) -> float:
    """Return C_p(T_p) / C(0) = C_Hi C_i(T_p) (NZS 1170.5, 8.2).

    Parameters
    ----------
    Tp : period of the part [s]
    floor : C_Hi [-]

    Returns
    -------
    float [-]
    """
    return floor * float(part_shape(Tp))


def demand_per_pga(wall: FaceLoadedWall, Tp: float, *, floor: float, risk_factor: float) -> float:
    """Return phi_D over C(0) g: (B / J) (T_p / 2 pi)^2 C_Hi C_i(T_p) R_p.

    Parameters
    ----------
    wall : the wall
    Tp : its period [s]
    floor : C_Hi [-]
    risk_factor : R_p [-]

    Returns
    -------
    float [rad s2/m]
    """
    return wall.B / wall.J * (Tp / (2.0 * np.pi)) ** 2 * part_coefficient(Tp, floor=floor) * risk_factor


def uplift_pga(multiplier: float | None, *, floor: float, risk_factor: float) -> float | None:
    """Return the PGA at which the part coefficient of a rigid body, C_p(0) R_p, reaches the multiplier at rest.

    C_i(0) = 2 is that of parts stiffer than 0.75 s, so this is half of what lifts a rigid wall off a rigid floor.

    Parameters
    ----------
    multiplier : at rest [-]; None on joints without a threshold
    floor : C_Hi [-]
    risk_factor : R_p [-]

    Returns
    -------
    PGA [m/s2]; None without a threshold.
    """
    return None if multiplier is None else multiplier * g / (part_coefficient(0.0, floor=floor) * risk_factor)


NZSEE2017_FACE_LOADED = CodeProcedure(
    name="nzsee2017-face-loaded",
    family=Family.PART,
    assess=assess_face_loaded_wall,
    title=Term("NZSEE 2017, face-loaded wall"),
    short_title=Term("NZSEE 2017"),
    work="nzsee2017",
    options="nzsee2017",
    spectra=NEW_ZEALAND,
    default_run=DefaultRun(spectra=NEW_ZEALAND),
    premises=(Premise.ANCHORAGE,),
)


def _checks(oscillator: Oscillator, context: Context, options: Nzsee2017Options) -> tuple[Check, ...]:
    def one(branch: Branch, name: BranchName, level: float) -> Check:
        empty = _check(name, context, level)
        if context.support == "hinged":
            return empty
        if context.spectrum.code == TABLE_SPECTRUM and options.c_0 is None:
            why = missing_ordinate(CLAUSE, "C(0)", "procedures.nzsee2017.c_0")
            return replace(empty, verdict=Outcome.NOT_ANSWERED, reason=why)
        if is_overloaded(name, context):
            return replace(empty, verdict=Outcome.NOT_ANSWERED, reason=reason_message(Reason.OVERLOADED, clause=CLAUSE))
        response = wall_response(branch, name, context, options)
        if response.tilted.b <= 0.0:
            down = reason_message(Reason.OVERTURNS)
            return replace(empty, verdict=Outcome.FAIL, reason=down, capacity_pga_g=0.0)
        return _answered(empty, branch, context, response, level)

    return tuple(_scored(check) for check in check_worst_branch(oscillator, context.levels, one))


def _check(name: BranchName, context: Context, level: float) -> Check:
    return Check(
        procedure=NZSEE2017_FACE_LOADED.name,
        edition=EDITION,
        branch=name,
        limit_state="ULS",
        level_pga_g=level / g,
        input_at="mechanism base" if context.above_ground else "ground",
        damping=DAMPING,
        quantity="rotation",
        unit="rad",
        verdict=Outcome.NOT_APPLICABLE,
        reason=reason_message(Reason.NOT_A_WALL, clause=CLAUSE),
        **caveats_of(
            CAVEAT,
            *([CAVEAT_FREE] if context.support == "free" else []),
            *NZSEE2017_FACE_LOADED.spectrum_caveats(context.spectrum.code),
        ),
    )


def _answered(check: Check, branch: Branch, context: Context, response: WallResponse, level: float) -> Check:
    demanded = 0.0 if level <= (response.uplift or 0.0) else response.per_pga * level
    ratio = demanded / response.usable_rotation
    verdict = Outcome.PASS if ratio <= 1.0 else Outcome.FAIL
    stands = demanded < response.instability
    return replace(
        check,
        demand=demanded,
        capacity=response.usable_rotation,
        ratio=ratio,
        verdict=verdict,
        reason=_reason(demanded, verdict),
        capacity_pga_g=response.capacity / g,
        uplift_pga_g=None if response.uplift is None else response.uplift / g,
        capacity_rotation_ratio=response.usable_rotation / branch.overturning,
        rotation_ratio=demanded / branch.overturning if stands else None,
        pga_curve=_curve(branch, response),
        steps=_sheet_steps(branch, context, response, level=level),
    )


def _reason(demanded: float, verdict: Outcome) -> Message:
    if demanded == 0.0:
        return reason_message(Reason.NO_ROCKING)
    return reason_message(
        Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=Term("the usable rotation")
    )


def _curve(branch: Branch, response: WallResponse) -> PgaCurve:
    def pga_of(rotation: FloatArray) -> FloatArray:
        return rotation / response.per_pga

    return to_pga_curve(pga_rotation(pga_of, overturning=response.instability, uplift=response.uplift or 0.0), branch)


def _scored(check: Check) -> Check:
    """Return the check with its %NBS: PGA at capacity over the PGA of the level, no ratio of rotations below uplift."""
    if check.capacity_pga_g is None:
        return check
    score = 100.0 * check.capacity_pga_g / check.level_pga_g
    given = {"PGA_100": (check.capacity_pga_g, "g"), "PGA": (check.level_pga_g, "g")}
    line = step(SCORE, "share of the new building standard", CLAUSE, "100 PGA_100 / PGA", score, "%", given=given)
    return replace(check, score={SCORE: score}, steps=(*check.steps, line))


AT_REST = "table of the mechanism, at rest"


def _sheet_steps(branch: Branch, context: Context, response: WallResponse, *, level: float) -> tuple[Step, ...]:
    """Write all lines of the sheet but the score; level: PGA [m/s2]."""
    return (
        *_wall_steps(branch, response),
        *_seat_steps(response),
        *_thickness_steps(response),
        *_slope_steps(response),
        *_capacity_steps(context, response),
        *_part_steps(context, response, level),
        *_displacement_steps(context, response, response.per_pga * level),
        *_end_steps(response, level),
    )


def _wall_steps(branch: Branch, response: WallResponse) -> tuple[Step, ...]:
    """Write the wall with its own thickness."""
    line, at_rest = response.nominal.line, branch.overturning_flexible is None
    phi_i, mark = line.instability, "" if response.gravity is None else "0"
    slope = {f"b{mark}": (line.b, "N m"), f"φ_i{mark}": (phi_i, "rad")}
    return (
        instability_step(f"φ_i{mark}", "rotation at instability", CLAUSE, branch),
        *_moment_steps(branch, f"b{mark}", f"φ_i{mark}", line.b, at_rest=at_rest),
        step(f"a{mark}", "slope of the straight line", CLAUSE, f"b{mark} / φ_i{mark}", line.a, "N m/rad", given=slope),
        step(f"J{mark}", "inertia at rest, about the hinges", CLAUSE, "Σ m (x'² + z'²) + J_G θ'²", response.nominal.J,
             "kg m2", remark=AT_REST),
        step(f"B{mark}", "excitation at rest", CLAUSE, "Σ m x'", response.nominal.B, "kg m", remark=AT_REST),
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


AT_FACE = "C8B, cases 1 and 3: masonry or a foundation as thick bears the wall from face to face"
AT_MIDDLE = "C8B, cases 0 and 2: nothing is drawn below that bears the wall from face to face"


def _seat_steps(response: WallResponse) -> tuple[Step, ...]:
    """Write where the base reaction of a wall that spans is, and what that takes of the wall as modelled."""
    gravity, modelled = response.gravity, response.nominal
    if gravity is None:
        return ()
    seated, e_b = seated_wall(modelled, gravity), gravity.base_eccentricity
    words = "eccentricity of the base reaction from mid-thickness"
    seat = step("e_b", words, CLAUSE, "by the drawing", e_b, "m", remark=AT_FACE if e_b > 0.0 else AT_MIDDLE)
    if not gravity.edge_moment > 0.0:
        return (seat,)
    moments: Given = {"b0": (modelled.line.b, "N m"), "b_A": (gravity.edge_moment, "N m")}
    turned: Given = {"J0": (modelled.J, "kg m2"), "J_A": (gravity.edge_inertia, "kg m2")}
    return (
        seat,
        step("b_e", "resisting moment without that of the edge", CLAUSE, "b0 − b_A", seated.line.b, "N m",
             given=moments),
        step("J_e", "inertia without that of the edge", CLAUSE, "J0 − J_A", seated.J, "kg m2", given=turned),
    )  # fmt: skip


def _thickness_steps(response: WallResponse) -> tuple[Step, ...]:
    """Write the wall with its effective thickness."""
    if response.gravity is None:
        return ()
    gravity, wall, k = response.gravity, response.effective, response.thickness
    nominal, moved = seated_wall(response.nominal, gravity), gravity.edge_moment > 0.0
    b, J = ("b_e", "J_e") if moved else ("b0", "J0")
    taken = {"k": (k, "-")}
    moments = {b: (nominal.line.b, "N m"), "b_W": (gravity.own_moment, "N m"), "b_P": (gravity.moment, "N m")}
    slopes = {"a0": (nominal.line.a, "N m/rad"), "a_W": (gravity.own_slope, "N m/rad")}
    turned = {J: (nominal.J, "kg m2"), "J_W": (gravity.own_inertia, "kg m2"), "J_P": (gravity.inertia, "kg m2")}
    driven = {"B0": (nominal.B, "kg m"), "B_W": (gravity.own_excitation, "kg m")}
    words = "effective thickness over thickness; P presses on the wall, W is its own weight"
    return (
        step("k", words, CLAUSE, "0.975 − 0.025 P/W", k, given={"P/W": gravity.overburden_ratio}),
        step("b", "resisting moment, the wall's by k², of P by k", CLAUSE, f"{b} − (1 − k²) b_W − (1 − k) b_P",
             wall.line.b, "N m", given={**moments, **taken}),
        step("a", "slope, the wall's by k", CLAUSE, "a0 − (1 − k) a_W", wall.line.a, "N m/rad",
             given={**slopes, **taken}),
        step("J", "inertia, the wall's by k, of P by k²", CLAUSE, f"{J} − (1 − k) J_W − (1 − k²) J_P", wall.J, "kg m2",
             given={**turned, **taken}),
        step("B", "excitation, the wall's by k", CLAUSE, "B0 − (1 − k) B_W", wall.B, "kg m", given={**driven, **taken}),
    )  # fmt: skip


def _slope_steps(response: WallResponse) -> tuple[Step, ...]:
    """Write what the slope of the storey takes of a wall that spans, and its instability."""
    if response.gravity is None:
        return ()
    wall, tilted = response.effective, response.tilted
    given: Given = {"b": (wall.line.b, "N m"), "ψ": (response.slope, "-"), "B": (wall.B, "kg m")}
    unstable: Given = {"b_ψ": (tilted.b, "N m"), "a": (tilted.a, "N m/rad")}
    words = "resisting moment of the wall that the slope ψ of the storey tilts"
    return (
        step("b_ψ", words, CLAUSE, "b − ψ g B", tilted.b, "N m", given=given),
        step("φ_i", "rotation at instability", CLAUSE, "b_ψ / a", tilted.instability, "rad", given=unstable),
    )


def _capacity_steps(context: Context, response: WallResponse) -> tuple[Step, ...]:
    factor, wall = period_factor(context.support), response.effective
    usable = {"s": (response.usable, "-"), "φ_i": (response.instability, "rad")}
    turned = {"c": (factor, "-"), "J": (wall.J, "kg m2"), "a": (wall.line.a, "N m/rad")}
    return (
        step("φ_m", "usable rotation, its share of that at instability", CLAUSE, "s φ_i", response.usable_rotation,
             "rad", given=usable),
        step("T_p", "period of the part, c by its support", CLAUSE, "c √(J / a)", response.Tp, "s", given=turned),
    )  # fmt: skip


def _part_steps(context: Context, response: WallResponse, level: float) -> tuple[Step, ...]:
    Ci = part_coefficient(response.Tp, floor=1.0)
    C_0 = level / g * response.surface
    Cp = C_0 * response.floor * Ci
    coefficients = {"C(0)": (C_0, "g"), "C_Hi": (response.floor, "-"), "C_i(T_p)": (Ci, "-")}
    demanded = {
        "B": (response.effective.B, "kg m"),
        "J": (response.effective.J, "kg m2"),
        "T_p": (response.Tp, "s"),
        "C_p(T_p)": (Cp, "-"),
        "R_p": (response.risk_factor, "-"),
    }
    return (
        _floor_step(context, response.floor),
        step("C_i(T_p)", "spectral shape of the part: 2 to 0.75 s, 0.5 from 1.5 s", PARTS,
             "min(2, max(0.5, 2 (1.75 − T_p)))", Ci, given={"T_p": (response.Tp, "s")}),
        step("C_p(T_p)", "part coefficient", PARTS, "C(0) C_Hi C_i(T_p)", Cp, given=coefficients),
        step("φ_D", "demand", CLAUSE, "B / J (T_p / 2π)² C_p(T_p) g R_p", response.per_pga * level, "rad",
             given=demanded),
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


def _displacement_steps(context: Context, response: WallResponse, phi_d: float) -> tuple[Step, ...]:
    """Write the displacements of the Guidelines: at mid-height of a wall that spans, at the top of a free one."""
    if context.wall is None:
        return ()
    h, spanning = context.wall.height, context.support == "spanning"
    arm, over, place = (h / 2.0, " / 2", "at mid-height") if spanning else (h, "", "at the top")

    def line(name: str, angle: str, words: str, rotation: float) -> Step:
        given = {angle: (rotation, "rad"), "h": (h, "m")}
        return step(name, words, CLAUSE, f"{angle} h{over}", rotation * arm, "m", given=given, remark=place)

    return (
        line("Δ_i", "φ_i", "displacement at instability", response.instability),
        line("Δ_m", "φ_m", "usable displacement", response.usable_rotation),
        line("D_ph", "φ_D", "displacement demand", phi_d),
    )


def _end_steps(response: WallResponse, level: float) -> tuple[Step, ...]:
    phi_d, uplift = response.per_pga * level, response.uplift
    rocks = uplift is None or level > uplift
    capable = {
        "φ_m": (response.usable_rotation, "rad"),
        "PGA": (level / g, "g"),
        "φ_D": (phi_d, "rad"),
        "PGA_u": ((uplift or 0.0) / g, "g"),
    }
    held = {"φ_D": (phi_d, "rad"), "φ_m": (response.usable_rotation, "rad")}
    ratio = phi_d / response.usable_rotation
    return (
        _uplift_step(response),
        step(
            "PGA_100", "PGA at 100 %NBS", CLAUSE, "max(φ_m PGA / φ_D, PGA_u)", response.capacity / g, "g", given=capable
        ),
        step("D/C", "ratio", CLAUSE, "φ_D / φ_m", ratio, given=held)
        if rocks
        else step("D/C", "ratio", CLAUSE, "0", 0.0, remark="no motion below uplift"),
    )


def _uplift_step(response: WallResponse) -> Step:
    if response.uplift is None or response.multiplier is None:
        return step("PGA_u", "PGA at uplift: none on joints without a threshold", PARTS, "C_p(0) R_p = λ", None, "g")
    stiff = part_coefficient(0.0, floor=1.0)
    given = {
        "λ": response.multiplier,
        "C_Hi": response.floor,
        "C_i(0)": stiff,
        "R_p": response.risk_factor,
        "s": response.surface,
    }
    words = "PGA at uplift, λ = b / (g B) the multiplier at rest, of the tilted wall where it is, s = C(0)/PGA"
    return step("PGA_u", words, PARTS, "λ / (s C_Hi C_i(0) R_p)", response.uplift / g, "g", given=given)
