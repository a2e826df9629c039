"""ASCE/SEI 41-13, 11.3.3, Table 11-5 (41-06 Table 7-5): walls that need no analysis out of their plane.

A wall anchored at floors and roof is taken as stable for life safety and collapse prevention where its height over
thickness does not exceed the table's. Parapets have limits of their own, those of the checklist for nonstructural
components. Table, bounds and limits are from memory, not checked against the printed standard; the later edition
(41-17) may differ. One check for each level; one function for each rule.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Literal

from assess.codes.calculation_sheet import UNANSWERED, Step, step
from assess.codes.check import (
    AMERICAN,
    ORDINATE,
    TABLE_SPECTRUM,
    Check,
    CodeProcedure,
    DefaultRun,
    Family,
    Outcome,
    Premise,
    Reason,
    caveats_of,
    check_worst_branch,
    missing_ordinate,
    reason_message,
)
from assess.codes.context import PLINTH, Building, Context, Wall
from assess.declaration import Evidence, PositiveAcceleration, Safe
from assess.messages.message import Message, Quantity, Severity, Term, message
from assess.oscillator import Branch, BranchName, Oscillator, threshold
from spectra.gravity import g

EDITION = "ASCE/SEI 41-13"
CLAUSE, CHECKLIST = "ASCE 41-13 Table 11-5", "ASCE 41-13, checklist for nonstructural components"
CAVEAT = (
    "Table 11-5 is from memory, not checked against the printed standard; it presumes a wall anchored at its base and "
    "top; S_X1 is that of the site's spectrum at the level, whatever hazard it represents"
)
CAVEAT_PARAPET = "the limits for parapets are from memory, not checked against the printed standard"
KEY = "procedures.asce41-13.s_x1"
PERIOD, DAMPING = 1.0, 0.05  # s, of S_X1
DERIVED = "s_x1"  # parameter of a spectrum whose code derives S_X1 otherwise than as S_a(1 s)
Position = Literal["one-storey", "first-storey", "top-storey", "other"]
STRICTEST: Position = "top-storey"
MILDEST: Position = "first-storey"
Masonry = Literal["coursed", "rubble"]
Seismicity = Literal["moderate", "high"]


POSITION = Evidence(
    "code",
    "either",
    "by storeys and elevation, else the strictest row for a pass",
    judged="the wall of a top storey may be less slender, that of a first storey more",
    safe=Safe.ABSENT,
)
MASONRY = Evidence(
    "measured",
    ("rubble", "coursed"),
    'absent: "coursed" is a condition of a pass',
    judged='"coursed" takes a condition from a pass, "rubble" leaves the wall without an answer',
    safe=Safe.ABSENT,
)


@dataclass(frozen=True)
class Asce41Options:
    """Options of the permissible h/t of ASCE 41-13."""

    position: Annotated[Position | None, POSITION] = None
    """row of Table 11-5: "one-storey", "first-storey", "top-storey" or "other"; if absent by [building], elevation"""
    masonry: Annotated[Masonry | None, MASONRY] = None
    """"coursed", or "rubble", which the table is not for; if absent a pass holds on condition that it is coursed"""
    seismicity: Annotated[Seismicity, Evidence("code", ("high", "moderate"), '"high"', safe=Safe.FIRST)] = "high"
    """level of seismicity, on which the limit of parapets hangs: "high", h/t 1.5, or "moderate", 2.5"""
    s_x1: Annotated[PositiveAcceleration | None, ORDINATE] = None
    """S_X1 at the site's own peak ground acceleration; if absent the spectrum at 1 s; needed where that is a table"""


def assess_slenderness(oscillator: Oscillator, context: Context, *, options: Asce41Options) -> tuple[Check, ...]:
    """Check h/t of a wall that spans between supports against Table 11-5 at S_X1, of a parapet against its limit."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        return _check(branch, name, context, options, level)

    return check_worst_branch(oscillator, context.levels, one)


def s_x1_over_pga(context: Context, options: Asce41Options) -> float:
    """Return S_X1 over the PGA of the same level [-]."""
    pga = context.spectrum.pga
    if options.s_x1 is not None:
        return options.s_x1 / pga
    derived = context.spectrum.parameters.get(DERIVED)
    if isinstance(derived, float):
        return derived * context.spectrum.factor / pga
    return float(context.spectrum.acceleration(PERIOD, damping=DAMPING)) / pga


PERMITTED: Mapping[Position | Seismicity, str] = {
    "one-storey": "the permissible h/t (wall of a one-storey building)",
    "first-storey": "the permissible h/t (first-storey wall of a multistorey building)",
    "top-storey": "the permissible h/t (wall in the top storey of a multistorey building)",
    "other": "the permissible h/t (all other walls)",
    "moderate": "the permissible h/t of parapets in moderate seismicity",
    "high": "the permissible h/t of parapets in high seismicity",
}
SEISMICITY: Mapping[Seismicity, str] = {"moderate": "moderate seismicity, given", "high": "high seismicity, given"}
PLACES: Mapping[Position, str] = {
    "one-storey": "wall of a one-storey building",
    "first-storey": "first-storey wall of a multistorey building",
    "top-storey": "wall in the top storey of a multistorey building",
    "other": "all other walls",
}
BOUNDS = (0.24, 0.37)  # g: S_X1 up to which the first and the second column hold
PERMISSIBLE: Mapping[Position, tuple[float, float, float]] = {  # h/t [-], Table 11-5
    "one-storey": (20.0, 16.0, 13.0),
    "first-storey": (20.0, 18.0, 15.0),
    "top-storey": (14.0, 14.0, 9.0),
    "other": (20.0, 16.0, 13.0),
}
PARAPET: Mapping[Seismicity, float] = {"moderate": 2.5, "high": 1.5}  # h/t [-]
NEAR_ROOF = 0.5  # m: what stands free no lower than this under the top of the building stands on it


def permissible_slenderness(position: Position, s_x1: float) -> float:
    """Return the largest permissible h/t of a wall (Table 11-5).

    Parameters
    ----------
    position : row of the table
    s_x1 : S_X1 [g]

    Returns
    -------
    float [-]
    """
    return PERMISSIBLE[position][sum(s_x1 > bound for bound in BOUNDS)]


def permitted_s_x1(position: Position, slenderness: float) -> float | None:
    """Return the S_X1 up to which a wall is permitted (Table 11-5).

    Parameters
    ----------
    position : row of the table
    slenderness : h/t [-]

    Returns
    -------
    S_X1 [g]; 0 where the wall never is, None where it always is.
    """
    within = [slenderness <= most for most in PERMISSIBLE[position]]
    return None if all(within) else (0.0, *BOUNDS)[sum(within)]


def position_of(wall: Wall, elevation: float, building: Building | None) -> Position | None:
    """Return the row of Table 11-5 of a wall; None where the building's storeys are not known.

    A wall whose top is within half a storey of the building's is in the top storey, the stricter row.

    Parameters
    ----------
    wall : its size
    elevation : of its base above the ground [m]
    building : the structure it belongs to

    Returns
    -------
    Position or None
    """
    if building is None or building.storeys is None:
        return None
    if building.storeys == 1:
        return "one-storey"
    storey = building.height / building.storeys
    if elevation + wall.height >= building.height - storey / 2.0:
        return "top-storey"
    return "first-storey" if elevation <= PLINTH else "other"


def is_parapet(context: Context) -> bool:
    """Return whether the masonry stands free on top of a building whose height is known."""
    building = context.building
    return context.support == "free" and building is not None and context.elevation >= building.height - NEAR_ROOF


ASCE41_13_SLENDERNESS = CodeProcedure(
    name="asce41-13-ht",
    family=Family.TABLE,
    assess=assess_slenderness,
    title=Term("ASCE 41-13, slenderness"),
    short_title=Term("ASCE 41-13"),
    work="asce41-13",
    options="asce41_13",
    spectra=AMERICAN,
    default_run=DefaultRun(spectra=AMERICAN),
    premises=(Premise.ANCHORAGE, Premise.COLLAR_JOINTS),
)


def _check(branch: Branch, name: BranchName, context: Context, options: Asce41Options, level: float) -> Check:
    verdict, reason = _outcome_without_numbers(context, options)
    parapet = is_parapet(context)
    empty = Check(
        procedure=ASCE41_13_SLENDERNESS.name,
        edition=EDITION,
        branch=name,
        limit_state="life safety, collapse prevention",
        level_pga_g=level / g,
        input_at="ground",
        damping=None if parapet else DAMPING,
        quantity="h/t",
        unit="-",
        verdict=verdict,
        reason=reason,
        uplift_pga_g=threshold(branch),
        **caveats_of(
            CAVEAT_PARAPET if parapet else CAVEAT, *ASCE41_13_SLENDERNESS.spectrum_caveats(context.spectrum.code)
        ),
        conditions=() if options.masonry else (message("premise-coursed", severity=Severity.WARNING),),
        steps=(step("h/t", "slenderness", CLAUSE, "h / t", None, remark=UNANSWERED),),
    )
    if verdict != Outcome.PASS or context.wall is None:
        return empty
    return _of_parapet(empty, context.wall, options) if parapet else _of_wall(empty, context.wall, context, options)


def _outcome_without_numbers(context: Context, options: Asce41Options) -> tuple[Outcome, Message]:
    """Return why no check can be made; a pass where one can."""
    not_for = Outcome.NOT_APPLICABLE
    if context.support != "spanning" and not is_parapet(context):
        return not_for, reason_message(Reason.NOT_SPANNING, clause=CLAUSE)
    if context.wall is None:
        return not_for, reason_message(Reason.NO_WALL_SIZE, clause=CLAUSE)
    if options.masonry == "rubble":
        return not_for, reason_message(Reason.RUBBLE, clause=CLAUSE)
    if context.support == "spanning" and options.s_x1 is None:
        if context.spectrum.code == TABLE_SPECTRUM:
            return Outcome.NOT_ANSWERED, missing_ordinate(CLAUSE, "S_X1", KEY)
        if context.spectrum.longest_period < PERIOD:
            end = Quantity(context.spectrum.longest_period, "time")
            return Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=Term("S_X1 at 1 s"), end=end)
    return Outcome.PASS, reason_message(Reason.WITHIN, capacity=Term("the permissible h/t"))


def _of_parapet(check: Check, wall: Wall, options: Asce41Options) -> Check:
    most, slenderness = PARAPET[options.seismicity], wall.height / wall.thickness
    answered = _answered(check, slenderness, most, PERMITTED[options.seismicity])
    limit = step("max h/t", "permissible slenderness of parapets", CHECKLIST,
                 "1.5 in high seismicity, 2.5 in moderate", most, remark=SEISMICITY[options.seismicity])  # fmt: skip
    return replace(answered, steps=(*_size_steps(wall), limit, _ratio_step(slenderness, most)))


def _of_wall(check: Check, wall: Wall, context: Context, options: Asce41Options) -> Check:
    """Check the row of the wall; if it is not known, only a pass by the strictest row and a fail by all count."""
    known = options.position or position_of(wall, context.elevation, context.building)
    if known is not None:
        return _in_row(check, wall, context, options, known)
    strict, mild = (_in_row(check, wall, context, options, row) for row in (STRICTEST, MILDEST))
    if strict.verdict == mild.verdict:
        return strict
    reason = reason_message(Reason.STOREY_UNKNOWN, clause=CLAUSE)
    return replace(strict, verdict=Outcome.NOT_ANSWERED, provisional=strict.verdict, reason=reason)


def _in_row(check: Check, wall: Wall, context: Context, options: Asce41Options, position: Position) -> Check:
    ordinate = s_x1_over_pga(context, options)
    slenderness, s_x1 = wall.height / wall.thickness, ordinate * check.level_pga_g
    most, bound = permissible_slenderness(position, s_x1), permitted_s_x1(position, slenderness)
    answered = _answered(check, slenderness, most, PERMITTED[position])
    ratio = "S_X1/PGA" if DERIVED in context.spectrum.parameters else "S_a(1 s)/PGA"
    factors = {ratio: (ordinate, "-"), "PGA": (check.level_pga_g, "g")}
    return replace(
        answered,
        capacity_pga_g=None if bound is None else bound / ordinate,
        steps=(
            *_size_steps(wall),
            step("S_X1", "spectrum at 1 s", CLAUSE, f"{ratio} PGA", s_x1, "g", given=factors),
            step("max h/t", PLACES[position], CLAUSE, "row of the wall, column of S_X1", most,
                 remark=_source(context, options), at={"S_X1": (s_x1, "g")}),
            _ratio_step(slenderness, most),
        ),
    )  # fmt: skip


def _answered(check: Check, slenderness: float, most: float, permitted: str) -> Check:
    verdict = Outcome.PASS if slenderness <= most else Outcome.FAIL
    reason = reason_message(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=Term(permitted))
    return replace(check, demand=slenderness, capacity=most, ratio=slenderness / most, verdict=verdict, reason=reason)


def _source(context: Context, options: Asce41Options) -> str:
    if options.position is not None:
        return "row given"
    if context.building is None or context.building.storeys is None:
        return "row not known: the strictest; give [building] height and storeys, or the position"
    return "row by storeys and elevation"


def _size_steps(wall: Wall) -> tuple[Step, ...]:
    h, t = wall.height, wall.thickness
    return (
        step("h", "height of the wall between its supports, or of what stands free", CLAUSE, "geometry", h, "m"),
        step("t", "thickness of the wall", CLAUSE, "geometry", t, "m"),
        step("h/t", "slenderness", CLAUSE, "h / t", h / t, given={"h": (h, "m"), "t": (t, "m")}),
    )


def _ratio_step(slenderness: float, most: float) -> Step:
    given = {"h/t": slenderness, "max h/t": most}
    return step("D/C", "ratio", CLAUSE, "h/t / max h/t", slenderness / most, given=given)
