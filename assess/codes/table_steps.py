"""Lines of calculation sheets that read the table of a mechanism: between two points, as an integral, at its zero.

Between the nodes of a table lies a cubic spline. Where a straight line between the neighbouring nodes, or Simpson's
rule with few ordinates, comes to the same within `TOLERANCE`, the line is that formula with its numbers; elsewhere it
names the points between which the spline was read.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isclose

import numpy as np
from scipy.interpolate import PPoly

from assess.codes.calculation_step import Given, Step, step
from assess.oscillator import Branch
from spectra.arrays import FloatArray

TOLERANCE = 5e-6  # relative: a tenth of half a unit of the fourth figure
STRIPS = (2, 4, 8, 16)  # of Simpson's rule
SPLINE = "cubic spline between the neighbouring points of the table"
INTEGRAL = "integral of the cubic spline through the table"
Point = tuple[float, float]
EVERY_POINT = "largest of all points of the table"


@dataclass(frozen=True)
class Column:
    """A column of the table of a branch: how a line writes it and its argument, its unit, its nodes and its spline."""

    letter: str
    unit: str
    rotation: FloatArray
    values: FloatArray
    spline: PPoly
    integral: PPoly


def moment_column(branch: Branch) -> Column:
    """Return the restoring moment R [N m]."""
    return Column("R", "N m", branch.rotation, branch.restoring, branch.restoring_spline, branch.energy_spline)


def excitation_column(branch: Branch) -> Column:
    """Return the excitation B [kg m]."""
    return Column("B", "kg m", branch.rotation, branch.excitation, branch.excitation_spline, branch.excitation_integral)


def integral_step(
    symbol: str, description: str, clause: str, column: Column, end: float, unit: str, *, upper: str = "φ"
) -> Step:
    """Write the integral of a column from rest to a rotation.

    Parameters
    ----------
    symbol, description, clause : as of `step`
    column : what is integrated
    end : rotation up to which [rad]
    unit : of the integral
    upper : symbol of that rotation

    Returns
    -------
    Step
        By Simpson's rule with the fewest ordinates that come to the integral; else a reading with its end.
    """
    value = float(column.integral(end))
    for strips in STRIPS:
        ordinates = np.asarray(column.spline(np.linspace(0.0, end, strips + 1)))
        weights = np.array([1.0, *([4.0, 2.0] * strips)[: strips - 1], 1.0])
        if isclose(end / (3.0 * strips) * float(weights @ ordinates), value, rel_tol=TOLERANCE):
            names = [f"{column.letter}_{number}" for number in range(strips + 1)]
            terms = [
                name if weight == 1.0 else f"{weight:g} {name}" for weight, name in zip(weights, names, strict=True)
            ]
            given: Given = {
                upper: (end, "rad"),
                **{name: (each, column.unit) for name, each in zip(names, ordinates.tolist(), strict=True)},
            }
            formula = f"{upper} / {3 * strips} ({' + '.join(terms)})"
            return step(symbol, description, clause, formula, value, unit, given=given)
    return step(
        symbol,
        description,
        clause,
        "∫ R dφ" if column.letter == "R" else "∫ B dφ",
        value,
        unit,
        remark=INTEGRAL,
        at={upper: (end, "rad"), "n": float(np.searchsorted(column.rotation, end))},
    )


def reading_step(
    symbol: str,
    description: str,
    clause: str,
    column: Column,
    rotation: float,
    *,
    value: float | None = None,
    argument: str = "φ",
) -> Step:
    """Write the value of a column at a rotation.

    Parameters
    ----------
    symbol, description, clause : as of `step`
    column : what is read
    rotation : where [rad]
    value : that was read; None for that of the spline
    argument : symbol of the rotation
    """
    found = float(column.spline(rotation)) if value is None else value
    (x1, y1), (x2, y2) = neighbours(column, rotation)
    given = {argument: (rotation, "rad"), **_points(column, rotation)}
    letter = column.letter
    if x2 > x1 and isclose(y1 + (y2 - y1) * (rotation - x1) / (x2 - x1), found, rel_tol=TOLERANCE):
        formula = f"{letter}_1 + ({letter}_2 − {letter}_1) ({argument} − φ_1) / (φ_2 − φ_1)"
        return step(symbol, description, clause, formula, found, column.unit, given=given)
    return step(symbol, description, clause, "table of the mechanism", found, column.unit, remark=SPLINE, at=given)


def instability_step(symbol: str, description: str, clause: str, branch: Branch) -> Step:
    """Write the rotation at which the restoring moment of the table falls to zero.

    Parameters
    ----------
    symbol, description, clause : as of `step`
    branch : the direction of rocking
    """
    column, value = moment_column(branch), branch.unstable
    (x1, y1), (x2, y2) = neighbours(column, value)
    given = _points(column, value)
    if y1 > y2 and isclose(x1 + y1 * (x2 - x1) / (y1 - y2), value, rel_tol=TOLERANCE):
        formula = "φ_1 + R_1 (φ_2 − φ_1) / (R_1 − R_2)"
        return step(symbol, description, clause, formula, value, "rad", given=given)
    return step(symbol, description, clause, "restoring moment = 0", value, "rad", remark=SPLINE, at=given)


def neighbours(column: Column, rotation: float) -> tuple[Point, Point]:
    """Return the points of a table on either side of a rotation [rad]; before a jump where it lies on one."""
    nodes = column.rotation
    high = int(np.clip(np.searchsorted(nodes, rotation, side="left"), 1, nodes.size - 1))
    first, last = ((float(nodes[at]), float(column.values[at])) for at in (high - 1, high))
    return first, last


def _points(column: Column, rotation: float) -> dict[str, float | tuple[float, str]]:
    (x1, y1), (x2, y2) = neighbours(column, rotation)
    letter, unit = column.letter, column.unit
    return {"φ_1": (x1, "rad"), f"{letter}_1": (y1, unit), "φ_2": (x2, "rad"), f"{letter}_2": (y2, unit)}
