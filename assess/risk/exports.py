"""Fragility curves in the formats of other programs: a plain table, NRML of OpenQuake, and pelicun.

NRML 0.5: `mean` and `stddev` of a continuous function are those of the intensity itself, not of its logarithm:
m exp(beta^2 / 2) and mean sqrt(exp(beta^2) - 1) (OpenQuake manual, "Fragility models"). All functions of a model have
the same limit states, from the mildest on, whose names are words.

pelicun 3, "Damage and loss model database files": a row for each component, a lognormal for each limit state; columns
ID, Incomplete, Demand-Type, Demand-Unit, Demand-Offset, Demand-Directional and, for each limit state, Family, Theta_0
(median), Theta_1 (dispersion) and DamageStateWeights. Demand-Directional is 1: with 0 pelicun takes the larger of two
directions times 1.2, as for demands of FEMA P-58 that have none.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal
from xml.etree import ElementTree as ET

import numpy as np

from assess.risk.estimates import EmpiricalCurve, Lognormal
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray
from spectra.formulas import harmless_cell

MeasureUnit = Literal["g", "m/s", "-"]
OmissionReason = Literal["no-name-of-measure", "state-without-curve", "state-left-out", "curves-cross"]


@dataclass(frozen=True, repr=False)
class ExportedState(ShortRepr):
    """A state and its curve.

    name : like "rocking", "rotation-0.5", "overturning"
    lognormal : None where the data do not bound one
    intensity, records, reached, low, high [k] : the empirical curve at rising intensity, with its Wilson interval
    """

    name: str
    lognormal: Lognormal | None
    intensity: FloatArray
    records: IntArray
    reached: IntArray
    low: FloatArray
    high: FloatArray

    @property
    def share(self) -> FloatArray:
        """Share of records that reach the state at each intensity [k] [-]."""
        return self.reached / self.records


@dataclass(frozen=True, repr=False)
class ExportedCurve(ShortRepr):
    """The curves of one mechanism by one measure.

    name : of the mechanism; text of the user
    measure : "pga", "pgv", "sa", "sa-average", "pga/(g tan alpha)", "p pgv/(g tan alpha)"
    period : of "sa" [s], else None
    unit : of intensities
    states : the mildest first
    """

    name: str
    measure: str
    period: float | None
    unit: MeasureUnit
    states: tuple[ExportedState, ...]


@dataclass(frozen=True, repr=False)
class LeftOut(ShortRepr):
    """A curve that a format has no place for, or that is not as a format wants it.

    reason : "no-name-of-measure" and "state-without-curve", of its severest state: it is not in the file;
        "state-left-out": a milder state that it does not have is in no curve of the file; "curves-cross": it is in
        the file, but a severer state is somewhere more likely than a milder one, which programs that take differences
        cannot use
    """

    name: str
    measure: str
    period: float | None
    reason: OmissionReason
    state: str = ""


@dataclass(frozen=True, repr=False)
class Export(ShortRepr):
    """The text of a file, and what it leaves out."""

    text: str
    left_out: tuple[LeftOut, ...]


CSV_HEADER = (
    "mechanism", "measure", "period_s", "unit", "state", "curve", "intensity", "records", "reached", "share", "low",
    "high", "median", "dispersion",
)  # fmt: skip


def csv_text(curves: Sequence[ExportedCurve]) -> Export:
    """Return the table of all curves; it has a place for everything.

    Rows of "empirical" have intensity, records, reached, share and its Wilson interval; those of "lognormal" median and
    dispersion.

    Parameters
    ----------
    curves : of the mechanisms
    """
    rows: list[tuple[Cell, ...]] = [CSV_HEADER]
    for curve in curves:
        for state in curve.states:
            first = (curve.name, curve.measure, curve.period, curve.unit, state.name)
            rows += [(*first, *row) for row in _csv_rows(state)]
    return Export(table_text(rows), ())


NrmlFormat = Literal["continuous", "discrete"]
NAMESPACE = "http://openquake.org/xmlns/nrml/0.5"
WIDTH = 4.0  # standard deviations beyond the outermost medians to which a continuous function reaches
SLIGHT = 1e-3  # of the first intensity: where discrete functions begin that are above zero there
CROSSING = 1e-3  # of probability: curves that cross in their far tails do not count
CM = 100.0  # in a metre: OpenQuake's PGV is in cm/s


def nrml_text(curves: Sequence[ExportedCurve], *, format: NrmlFormat, description: str = "") -> Export:
    """Return a fragility model of all curves whose measure has a name in OpenQuake: PGA, PGV, SA(T).

    The taxonomy of a function is the name of its mechanism, with the measure behind it where a mechanism has several.

    Parameters
    ----------
    curves : with the same states each
    format : "continuous": lognormal curves; "discrete": the empirical ones
    description : of the model; text of the user
    """
    exported, left_out = _exported_curves(curves, format)
    states = [] if not exported else [_openquake_word(each.name) for each in exported[0].states]
    root = ET.Element("nrml", xmlns=NAMESPACE)
    model = ET.SubElement(root, "fragilityModel", id="rocking", assetCategory="buildings", lossCategory="structural")
    ET.SubElement(model, "description").text = printable(description) or "Rocking of masonry mechanisms"
    ET.SubElement(model, "limitStates").text = " ".join(states)
    for taxonomy, each in zip(_taxonomies(exported), exported, strict=True):
        function = ET.SubElement(model, "fragilityFunction", id=taxonomy, format=format)
        (_continuous if format == "continuous" else _discrete)(function, each)
    ET.indent(root)
    return Export(f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n', left_out)


def printable(text: str) -> str:
    """Return a text without the characters that XML 1.0 has no place for."""
    return re.sub(r"[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "", text)


PELICUN_UNITS = {"g": "g", "m/s": "mps", "-": "ea"}


def pelicun_text(curves: Sequence[ExportedCurve]) -> Export:
    """Return the damage parameters of all curves whose measure has a name in pelicun: PGA, PGV, spectral acceleration.

    Limit states keep their order and are the same in all rows, as states in pelicun follow one another.

    Parameters
    ----------
    curves : of the mechanisms
    """
    named, unnamed = _named_curves(curves, _pelicun_demand)
    exported, incomplete = _common_states(named, fitted=True)
    rows: list[list[Cell]] = []
    most_states = max((len(each.states) for each in exported), default=0)
    names = [each.name for each in exported]
    for each in exported:
        demand = str(_pelicun_demand(each))
        name = _pelicun_identifier(f"{each.name}.{demand}" if names.count(each.name) > 1 else each.name)
        alike = sum(str(row[0]).split("..")[0] == name for row in rows)
        rows.append(_pelicun_row(each, demand, f"{name}..{alike + 1}" if alike else name))
    return Export(table_text([_pelicun_header(most_states), *rows]), (*unnamed, *incomplete))


Cell = str | float | int | None


def table_text(rows: Iterable[Iterable[Cell]]) -> str:
    """Return rows, the header first, as the text of a CSV file; None is an empty cell."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([_cell_text(cell) for cell in row] for row in rows)
    return stream.getvalue()


def _common_states(curves: Sequence[ExportedCurve], *, fitted: bool) -> tuple[list[ExportedCurve], list[LeftOut]]:
    """Return curves with the states that all of them have, and what is left out.

    A curve without its severest state is left out whole. A milder state that one curve lacks is left out of all,
    as rocking by PGA, which a rigid block begins at one PGA without scatter.

    Parameters
    ----------
    curves : of one file, whose limit states are those of each of them
    fitted : whether a state needs a lognormal
    """

    def names_of(curve: ExportedCurve) -> list[str]:
        return [each.name for each in curve.states if each.lognormal is not None or not fitted]

    complete = [each for each in curves if each.states[-1].name in names_of(each)]
    names = dict.fromkeys(state.name for each in complete for state in each.states)
    common = [name for name in names if all(name in names_of(each) for each in complete)]
    left_out = [
        LeftOut(each.name, each.measure, each.period, "state-without-curve", each.states[-1].name)
        for each in curves
        if not any(each is other for other in complete)
    ]
    left_out += [
        LeftOut(each.name, each.measure, each.period, "state-left-out", name)
        for name in names
        for each in complete
        if name not in names_of(each)
    ]
    kept = [replace(each, states=tuple(state for state in each.states if state.name in common)) for each in complete]
    return kept, left_out


def _named_curves(
    curves: Sequence[ExportedCurve], measure_name: Callable[[ExportedCurve], str | None]
) -> tuple[list[ExportedCurve], list[LeftOut]]:
    """Return the curves whose measure has a name in a format, and the others as left out."""
    left_out = [
        LeftOut(each.name, each.measure, each.period, "no-name-of-measure")
        for each in curves
        if measure_name(each) is None
    ]
    return [each for each in curves if measure_name(each) is not None], left_out


def _csv_rows(state: ExportedState) -> Iterator[tuple[Cell, ...]]:
    columns = (state.intensity, state.records, state.reached, state.share, state.low, state.high)
    for im, records, reached, share, low, high in zip(*columns, strict=True):
        yield "empirical", float(im), int(records), int(reached), float(share), float(low), float(high), None, None
    if state.lognormal is not None:
        yield "lognormal", *[None] * 6, float(state.lognormal.median), float(state.lognormal.dispersion)


def _openquake_measure(curve: ExportedCurve) -> str | None:
    """Return the name of a curve's measure in OpenQuake; None where it has none."""
    if curve.measure == "sa" and curve.period is not None:
        return f"SA({curve.period:g})"
    return {"pga": "PGA", "pgv": "PGV"}.get(curve.measure)


def _openquake_word(name: str) -> str:
    """Return a name as OpenQuake takes it for limit states: letters, digits and underscores, a letter first."""
    word = re.sub(r"[^A-Za-z0-9_]", "_", name)
    return word if re.match(r"[A-Za-z_]", word) else f"_{word}"


def _taxonomies(curves: Sequence[ExportedCurve]) -> list[str]:
    """Return names that differ, without the characters that OpenQuake refuses in them."""
    names, taxonomies = [each.name for each in curves], list[str]()
    for each in curves:
        text = each.name if names.count(each.name) == 1 else f"{each.name} {_openquake_measure(each)}"
        word = re.sub("[#'\"]", "_", printable(text))
        alike = sum(other == word or other.startswith(f"{word} ..") for other in taxonomies)
        taxonomies.append(f"{word} ..{alike + 1}" if alike else word)
    return taxonomies


def _exported_curves(
    curves: Sequence[ExportedCurve], format: NrmlFormat
) -> tuple[list[ExportedCurve], tuple[LeftOut, ...]]:
    """Return the curves that the model has a place for, and what it leaves out."""
    named, unnamed = _named_curves(curves, _openquake_measure)
    exported, incomplete = _common_states(named, fitted=format == "continuous")
    crossing_states = ((each, _crossing_state(each, format)) for each in exported)
    crossing = [
        LeftOut(each.name, each.measure, each.period, "curves-cross", state.name)
        for each, state in crossing_states
        if state
    ]
    return exported, (*unnamed, *incomplete, *crossing)


def _crossing_state(curve: ExportedCurve, format: NrmlFormat) -> ExportedState | None:
    """Return the first state that is somewhere more likely than the milder one before it; None where there is none."""
    at = _lognormal_range(curve) if format == "continuous" else _empirical_intensities(curve)
    before = np.ones_like(at)
    for state in curve.states:
        here = state.lognormal.probability(at) if format == "continuous" and state.lognormal else _shares(state, at)
        if (here > before + CROSSING).any():
            return state
        before = here
    return None


def _continuous(function: ET.Element, curve: ExportedCurve) -> None:
    function.set("shape", "logncdf")
    factor, at = _openquake_factor(curve), _lognormal_range(curve)
    imls = ET.SubElement(
        function, "imls", imt=str(_openquake_measure(curve)), noDamageLimit=_all_digits(factor * at[0])
    )
    imls.set("minIML", _all_digits(factor * at[0]))
    imls.set("maxIML", _all_digits(factor * at[-1]))
    for state in curve.states:
        if state.lognormal is not None:
            mean, stddev = factor * state.lognormal.mean, factor * state.lognormal.standard_deviation
            ET.SubElement(
                function, "params", ls=_openquake_word(state.name), mean=_all_digits(mean), stddev=_all_digits(stddev)
            )


def _discrete(function: ET.Element, curve: ExportedCurve) -> None:
    factor, at = _openquake_factor(curve), _empirical_intensities(curve)
    shares = [_shares(state, at) for state in curve.states]
    zero = np.all([share == 0.0 for share in shares], axis=0)
    leading = int(np.argmin(zero)) if not zero.all() else zero.size
    limit = at[leading - 1] if leading else SLIGHT * at[0]
    imls = ET.SubElement(
        function, "imls", imt=str(_openquake_measure(curve)), noDamageLimit=_all_digits(factor * limit)
    )
    imls.text = " ".join(_all_digits(factor * each) for each in at)
    for state, share in zip(curve.states, shares, strict=True):
        ET.SubElement(function, "poes", ls=_openquake_word(state.name)).text = " ".join(
            _all_digits(each) for each in share
        )


def _lognormal_range(curve: ExportedCurve) -> FloatArray:
    """Return intensities over which the lognormal curves of a mechanism rise [200]."""
    fits = [each.lognormal for each in curve.states if each.lognormal is not None]
    low = min(float(np.log(each.median)) - WIDTH * each.dispersion for each in fits)
    high = max(float(np.log(each.median)) + WIDTH * each.dispersion for each in fits)
    return np.asarray(np.exp(np.linspace(low, high, 200)))


def _empirical_intensities(curve: ExportedCurve) -> FloatArray:
    """Return all intensities at which some state of a mechanism has an empirical point, rising."""
    return np.unique(np.concatenate([each.intensity for each in curve.states]))


def _shares(state: ExportedState, at: FloatArray) -> FloatArray:
    """Return the empirical shares of a state at intensities [n]."""
    return EmpiricalCurve(state.intensity, state.share).probability(at)


def _openquake_factor(curve: ExportedCurve) -> float:
    return CM if curve.unit == "m/s" else 1.0


def _all_digits(value: float) -> str:
    """Return a number with all its digits."""
    return repr(float(value))


def _pelicun_demand(curve: ExportedCurve) -> str | None:
    """Return the demand type of a curve's measure in pelicun; None where it has none."""
    if curve.measure == "sa" and curve.period is not None:
        return f"Spectral Acceleration|{curve.period:g}"
    return {"pga": "Peak Ground Acceleration", "pgv": "Peak Ground Velocity"}.get(curve.measure)


def _pelicun_identifier(name: str) -> str:
    """Return a name as an ID of pelicun, which splits them at hyphens: letters, digits, underscores, dots."""
    return re.sub(r"\.+", ".", re.sub(r"[^A-Za-z0-9.]+", "_", name)).strip("_.") or "_"


def _pelicun_header(states: int) -> list[str]:
    fixed = ["ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional"]
    parts = ("Family", "Theta_0", "Theta_1", "DamageStateWeights")
    return [*fixed, *(f"LS{at}-{part}" for at in range(1, states + 1) for part in parts)]


def _pelicun_row(curve: ExportedCurve, demand: str, name: str) -> list[Cell]:
    row: list[Cell] = [name, 0, demand, PELICUN_UNITS[curve.unit], 0, 1]
    for state in curve.states:
        if state.lognormal is not None:
            row += ["lognormal", float(state.lognormal.median), float(state.lognormal.dispersion), None]
    return row


def _cell_text(cell: Cell) -> str:
    if cell is None:
        return ""
    return harmless_cell(cell, shown=cell) if isinstance(cell, str) else repr(cell)
