"""The table of permissible h/t asked of a wall; one check for each level."""

from __future__ import annotations

from dataclasses import replace

from scipy.constants import g

from assess.codes.asce41_13.clauses import (
    CAVEAT,
    EDITION,
    PLACES,
    Options,
    Position,
    largest_s_x1,
    permissible,
    position_of,
)
from assess.codes.check import BranchName, Check, Role, Step, Verdict
from assess.codes.context import Context, Wall
from assess.codes.family import foreign, role_on
from assess.codes.governing import governing
from assess.oscillator import Branch, Oscillator, threshold

NAME = "asce41-13-ht"
CLAUSE = "ASCE 41-13 Table 11-5"
PERIOD, DAMPING = 1.0, 0.05  # s, of S_X1
FREE = "; this wall stands free in the mechanism, for which the table is not meant: for information"


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Table 11-5: h/t of the wall against the permissible at S_X1; it decides for walls that span between supports."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        missing = unanswerable(context)
        if missing or context.wall is None:
            return _check(branch, name, context, level, reason=missing)
        position = options.position or position_of(context.wall, context.elevation, context.building)
        return _answered(_check(branch, name, context, level), context.wall, position, context, given=options.position)

    return governing(oscillator, context.levels, one)


def unanswerable(context: Context) -> str:
    """Why Table 11-5 says nothing of the mechanism; empty where it does."""
    if context.support == "hinged":
        return f"{CLAUSE} is of walls between floors; a chain of three blocks is none"
    if context.wall is None:
        return f"{CLAUSE} needs height and thickness of the wall; this mechanism has no geometry"
    end = context.spectrum.longest_period
    return f"S_X1 at 1 s lies beyond the end of the spectrum at {end:.4g} s: extend its table" if end < PERIOD else ""


def _check(branch: Branch, name: BranchName, context: Context, level: float, *, reason: str = "") -> Check:
    uplift, decides = threshold(branch), context.support == "spanning"
    role: Role = role_on(NAME, context.spectrum.code) if decides else "informative"
    return Check(
        procedure=NAME,
        edition=EDITION,
        role=role,
        branch=name,
        limit_state="life safety, collapse prevention",
        level_pga_g=level / g,
        input_at="ground",
        damping=DAMPING,
        quantity="h/t",
        unit="-",
        verdict="not-applicable",
        reason=reason,
        uplift_pga_g=uplift,
        caveat=CAVEAT + FREE * (context.support == "free") + foreign(NAME, context.spectrum.code),
    )


def _answered(check: Check, wall: Wall, position: Position, context: Context, *, given: Position | None) -> Check:
    ordinate = float(context.spectrum.acceleration(PERIOD, damping=DAMPING)) / context.spectrum.pga  # S_X1 over PGA
    slenderness, s_x1 = wall.height / wall.thickness, ordinate * check.level_pga_g
    most, bound = permissible(position, s_x1), largest_s_x1(position, slenderness)
    verdict: Verdict = "pass" if slenderness <= most else "fail"
    within = "within" if verdict == "pass" else "beyond"
    source = "given" if given is not None else "by storeys and elevation"
    if given is None and position == "other" and (context.building is None or context.building.storeys is None):
        source = "not known, so all other walls; give [building] storeys, or the position"
    return replace(
        check,
        demand=slenderness,
        capacity=most,
        ratio=slenderness / most,
        verdict=verdict,
        reason=f"h/t {within} the permissible of the table ({PLACES[position]})",
        capacity_pga_g=None if bound is None else bound / ordinate,
        steps=_steps(wall, ordinate, check.level_pga_g, position, source, most),
    )


def _steps(
    wall: Wall, ordinate: float, level_g: float, position: Position, source: str, most: float
) -> tuple[Step, ...]:
    h, t, s_x1 = wall.height, wall.thickness, ordinate * level_g
    row, column = f"{PLACES[position]}: {source}", f"S_X1 = {s_x1:.4g} g"
    ratio = f"{h / t:.5g} / {most:g}"
    return (
        Step("h", "height of the wall between its supports", CLAUSE, "geometry", f"{h:.5g}", h, "m"),
        Step("t", "thickness of the wall", CLAUSE, "geometry", f"{t:.5g}", t, "m"),
        Step("h/t", "slenderness", CLAUSE, "h / t", f"{h:.5g} / {t:.5g}", h / t, "-"),
        Step("S_X1", "spectrum at 1 s", CLAUSE, "S_a(1 s)/PGA · PGA", f"{ordinate:.5g} · {level_g:.5g}", s_x1, "g"),
        Step("max h/t", row, CLAUSE, "row of the wall, column of S_X1", column, most, "-"),
        Step("D/C", "ratio", CLAUSE, "demand / capacity", ratio, h / t / most, "-"),
    )
