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
from assess.codes.check import BranchName, Check, Outcome, Reason, Step, because
from assess.codes.context import Context, Wall
from assess.codes.family import foreign
from assess.codes.governing import governing
from assess.oscillator import Branch, Oscillator, threshold

NAME = "asce41-13-ht"
CLAUSE = "ASCE 41-13 Table 11-5"
PERIOD, DAMPING = 1.0, 0.05  # s, of S_X1
FREE = "; this wall stands free in the mechanism, for which the table is not meant: for information"


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Table 11-5: h/t of the wall against the permissible at S_X1; it decides for walls that span between supports."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        if context.wall is None:
            return _check(branch, name, context, level)
        position = options.position or position_of(context.wall, context.elevation, context.building)
        return _answered(_check(branch, name, context, level), context.wall, position, context, given=options.position)

    return governing(oscillator, context.levels, one)


def _check(branch: Branch, name: BranchName, context: Context, level: float) -> Check:
    uplift = threshold(branch)
    return Check(
        procedure=NAME,
        edition=EDITION,
        branch=name,
        limit_state="life safety, collapse prevention",
        level_pga_g=level / g,
        input_at="ground",
        damping=DAMPING,
        quantity="h/t",
        unit="-",
        verdict=Outcome.NOT_APPLICABLE,
        reason=because(Reason.NO_WALL_SIZE, clause=CLAUSE),
        uplift_pga_g=uplift,
        caveat=CAVEAT + FREE * (context.support == "free") + foreign(NAME, context.spectrum.code),
    )


def _answered(check: Check, wall: Wall, position: Position, context: Context, *, given: Position | None) -> Check:
    ordinate = float(context.spectrum.acceleration(PERIOD, damping=DAMPING)) / context.spectrum.pga  # S_X1 over PGA
    slenderness, s_x1 = wall.height / wall.thickness, ordinate * check.level_pga_g
    most, bound = permissible(position, s_x1), largest_s_x1(position, slenderness)
    verdict = Outcome.PASS if slenderness <= most else Outcome.FAIL
    permitted = f"the permissible h/t ({PLACES[position]})"
    source = "given" if given is not None else "by storeys and elevation"
    if given is None and position == "other" and (context.building is None or context.building.storeys is None):
        source = "not known, so all other walls; give [building] storeys, or the position"
    return replace(
        check,
        demand=slenderness,
        capacity=most,
        ratio=slenderness / most,
        verdict=verdict,
        reason=because(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=permitted),
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
