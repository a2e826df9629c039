"""Fragility curves as pelicun reads them: a row for each component, a lognormal for each limit state.

Source: pelicun 3, "Damage and loss model database files": columns ID, Incomplete, Demand-Type, Demand-Unit,
Demand-Offset, Demand-Directional and, for each limit state, Family, Theta_0 (median), Theta_1 (dispersion) and
DamageStateWeights. Demand-Directional is 1: with 0 pelicun takes the larger of two directions times 1.2, as for demands
of FEMA P-58 that have none.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from assess.risk.exports.curve import Export, ExportedCurve, LeftOut, common_states
from assess.risk.exports.table import Cell, table_text

UNITS = {"g": "g", "m/s": "mps", "-": "ea"}


def pelicun_text(curves: Sequence[ExportedCurve]) -> Export:
    """Return the damage parameters of all curves whose measure has a name in pelicun: PGA, PGV, spectral acceleration.

    Limit states keep their order and are the same in all rows, as states in pelicun follow one another.

    Parameters
    ----------
    curves : of the mechanisms
    """
    unnamed = [each for each in curves if demand_of(each) is None]
    left_out = [LeftOut(each.name, each.measure, each.period, "no-name-of-measure") for each in unnamed]
    inside, lacking = common_states([each for each in curves if demand_of(each) is not None], fitted=True)
    rows: list[list[Cell]] = []
    number = max((len(each.states) for each in inside), default=0)
    names = [each.name for each in inside]
    for each in inside:
        demand = str(demand_of(each))
        name = identifier(f"{each.name}.{demand}" if names.count(each.name) > 1 else each.name)
        alike = sum(str(row[0]).split("..")[0] == name for row in rows)
        rows.append(_row(each, demand, f"{name}..{alike + 1}" if alike else name))
    return Export(table_text([_header(number), *rows]), (*left_out, *lacking))


def demand_of(curve: ExportedCurve) -> str | None:
    """Return the demand type of a curve's measure in pelicun; None where it has none."""
    if curve.measure == "sa" and curve.period is not None:
        return f"Spectral Acceleration|{curve.period:g}"
    return {"pga": "Peak Ground Acceleration", "pgv": "Peak Ground Velocity"}.get(curve.measure)


def identifier(name: str) -> str:
    """Return a name as an ID of pelicun, which splits them at hyphens: letters, digits, underscores, dots."""
    return re.sub(r"\.+", ".", re.sub(r"[^A-Za-z0-9.]+", "_", name)).strip("_.") or "_"


def _header(states: int) -> list[str]:
    fixed = ["ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional"]
    parts = ("Family", "Theta_0", "Theta_1", "DamageStateWeights")
    return [*fixed, *(f"LS{at}-{part}" for at in range(1, states + 1) for part in parts)]


def _row(curve: ExportedCurve, demand: str, name: str) -> list[Cell]:
    row: list[Cell] = [name, 0, demand, UNITS[curve.unit], 0, 1]
    for state in curve.states:
        if state.lognormal is not None:
            row += ["lognormal", float(state.lognormal.median), float(state.lognormal.dispersion), None]
    return row
