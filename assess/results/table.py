"""The tables of results as pandas DataFrames: the numbers of results.json, a row to each thing it lists."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any

from assess.codes.check import Check
from assess.codes.verdict import Answer
from assess.errors import AssessError
from assess.messages.message import Message
from assess.results.mechanism import EnvelopeResult, HistoryResult, LinearisedResult, OscillatorResult, SuiteResult
from assess.results.run import (
    QUANTILES,
    ComparisonRow,
    RecordResult,
    Results,
    SensitivityResult,
    SweepResult,
    UncertainAnswer,
)

if TYPE_CHECKING:
    from pandas import DataFrame


Row = dict[str, Any]
_DTYPES = {"float": "float64", "float | None": "float64", "int | None": "Int64"}
UNITS: Mapping[str, str] = {
    "stiffness_n_m_per_rad": "N m/rad",
    "vs30_m_per_s": "m/s",
    "_per_s": "1/s",
    "_kg_m2": "kg m2",
    "_kg_m": "kg m",
    "_n_m": "N m",
    "_kg": "kg",
    "_km": "km",
    "_rad": "rad",
    "_hz": "Hz",
    "_years": "years",
    "_g": "g",
    "_m": "m",
    "_s": "s",
}
"""The units that endings of names stand for, the longest endings first."""


def table(results: Results, name: str) -> DataFrame:
    """Return a table of the results by its name.

    Columns have the names of results.json, in which units stand: `level_pga_g`, `radius_m`; `frame.attrs["units"]`
    lists them, column by column. Numbers are those of results.json; one that is not known is nan.

    Parameters
    ----------
    results : of a run
    name : a key of `TABLES`: "parameters", "checks", "histories", "suites", "verdict", "envelopes", "records",
        "comparison", "sweeps", "sensitivity", "uncertainty"

    Returns
    -------
    DataFrame
        one row for each branch, check, history, …, in the order of the results; no rows where there are none

    Raises
    ------
    AssessError : for a name that is none of these
    """
    import pandas as pd  # late: it takes a third of a second

    if name not in tuple(TABLES):
        raise AssessError(f'there is no table "{name}" of results; known are {", ".join(TABLES)}')
    columns, rows = TABLES[name]
    frame = pd.DataFrame.from_records(list(rows(results)), columns=list(columns))
    frame = frame.astype({column: _DTYPES[kind] for column, kind in columns.items() if kind in _DTYPES})
    frame.attrs["units"] = {column: unit for column in columns if (unit := _unit(column))}
    return frame


def _unit(column: str) -> str:
    """The unit that a name ends in, empty where it has none."""
    return next((unit for ending, unit in UNITS.items() if column.endswith(ending)), "")


def _columns(of: type, *, without: tuple[str, ...] = (), prefix: str = "") -> dict[str, str]:
    """The names of a dataclass as columns, with the types that they are declared with."""
    return {f"{prefix}{field.name}": str(field.type) for field in fields(of) if field.name not in without}


def _cells(of: Any, columns: Mapping[str, str], *, prefix: str = "") -> Row:
    """The fields of `of` that are among the columns."""
    assert is_dataclass(of)
    names = ((field.name, f"{prefix}{field.name}") for field in fields(of))
    return {column: _cell(getattr(of, name)) for name, column in names if column in columns}


def _cell(value: Any) -> Any:
    """A value as one cell: a message as its sentence, several things as one text."""
    if isinstance(value, Message):
        return value.text
    if isinstance(value, Enum):
        return value.value
    return "; ".join(str(_cell(each)) for each in value) if isinstance(value, tuple) else value


def _values(of: Any, columns: Mapping[str, str]) -> Iterator[Row]:
    """The rows of a dataclass whose columns are fields of one length."""
    names = [field.name for field in fields(of) if field.name in columns]
    for values in zip(*(getattr(of, name) for name in names), strict=True):
        yield {name: _cell(value) for name, value in zip(names, values, strict=True)}


def _rows_of_run(field: str, columns: Mapping[str, str]) -> Callable[[Results], Iterator[Row]]:
    """A row for each thing that a run lists in a field."""
    return lambda results: (_cells(each, columns) for each in getattr(results, field))


def _rows_of_mechanisms(field: str, columns: Mapping[str, str]) -> Callable[[Results], Iterator[Row]]:
    """A row for each thing that the mechanisms list in a field."""
    return lambda results: (
        {"mechanism": mechanism.name, **_cells(each, columns)}
        for mechanism in results.mechanisms
        for each in getattr(mechanism, field)
    )


MECHANISM = {"mechanism": "str"}
CHECKS = {**MECHANISM, **_columns(Check, without=("pga_curve", "steps", "score", "caveats", "numerical"))}
HISTORIES = {**MECHANISM, **_columns(HistoryResult, without=("trace", "variant"))}
SUITES = {**MECHANISM, **_columns(SuiteResult)}
RECORDS = _columns(RecordResult, without=("spectrum", "primary_pulses"))
COMPARISON = _columns(ComparisonRow)
SENSITIVITY = _columns(SensitivityResult, without=("remarks",))
_LINEARISED = "linearised_"
PARAMETERS = {
    **MECHANISM,
    "branch": "str",
    **_columns(OscillatorResult, without=("linearised",)),
    **_columns(LinearisedResult, prefix=_LINEARISED),
}


def _parameters(results: Results) -> Iterator[Row]:
    for mechanism in results.mechanisms:
        sides = (("positive", mechanism.oscillator), ("negative", mechanism.oscillator_negative))
        for branch, oscillator in sides:
            if oscillator is not None:
                linearised = _cells(oscillator.linearised, PARAMETERS, prefix=_LINEARISED)
                yield {"mechanism": mechanism.name, "branch": branch, **_cells(oscillator, PARAMETERS), **linearised}


_ANSWER = ("limit_state", "procedure", "ratio", "reason")
VERDICT = {
    **MECHANISM,
    "outcome": "str",
    "margin": "float",
    "at_the_limit": "bool",
    "answer": "str",
    **{name: kind for name, kind in _columns(Answer).items() if name in _ANSWER},
    "index_name": "str",
    "index_value": "float",
}


def _verdict(results: Results) -> Iterator[Row]:
    """The answers that decide, a row for each mechanism and limit state."""
    for one in () if results.verdict is None else results.verdict.mechanisms:
        judged = {"mechanism": one.mechanism, "outcome": one.outcome.value}
        for answer in one.answers:
            index = (None, None) if answer.index is None else (answer.index.name, answer.index.value)
            yield {
                **judged,
                "margin": one.margin,
                "at_the_limit": one.at_the_limit,
                "answer": answer.outcome.value,
                **{name: _cell(getattr(answer, name)) for name in _ANSWER},
                **dict(zip(("index_name", "index_value"), index, strict=True)),
            }


_OF_ENVELOPE = ("shape", "gamma", "nu_rad", "equation", "amplitude_g", "overturned", "case")
_BOUNDS = dict.fromkeys(_columns(EnvelopeResult, without=(*_OF_ENVELOPE, "polarity", "islands")), "float")
ENVELOPES = {**MECHANISM, "shape": "str", **_BOUNDS, "polarity": "int", "islands": "int"}


def _envelopes(results: Results) -> Iterator[Row]:
    for mechanism in results.mechanisms:
        if mechanism.envelope is not None:
            own = {"mechanism": mechanism.name, "shape": mechanism.envelope.shape}
            columns = {name: kind for name, kind in ENVELOPES.items() if name not in own}
            yield from ({**own, **row} for row in _values(mechanism.envelope, columns))


_OF_SWEEP = ("mechanism", "key", "unit")
_CASES = dict.fromkeys(_columns(SweepResult, without=(*_OF_SWEEP, "controlling", "governs")), "float")
SWEEPS = {**MECHANISM, "key": "str", "unit": "str", **_CASES, "overturned": "bool", "outcome": "str"}


def _sweeps(results: Results) -> Iterator[Row]:
    for sweep in results.sweeps:
        own = {name: getattr(sweep, name) for name in _OF_SWEEP}
        yield from ({**own, **row} for row in _values(sweep, {name: "" for name in SWEEPS if name not in own}))


UNCERTAINTY = {
    **_columns(UncertainAnswer, without=("interval", "quantiles", "ratios", "influences", "notes")),
    "interval_low": "float | None",
    "interval_high": "float | None",
    **{f"quantile_{percent}": "float | None" for percent in QUANTILES},
    "influences": "str",
    "notes": "str",
}


def _uncertainty(results: Results) -> Iterator[Row]:
    for answer in () if results.uncertainty is None else results.uncertainty.answers:
        low, high = answer.interval or (None, None)
        shares = [f"{each.group} {each.share:.3g}" for each in answer.influences if each.share is not None]
        yield {
            **_cells(answer, UNCERTAINTY),
            "interval_low": low,
            "interval_high": high,
            **{f"quantile_{percent}": each for percent, each in zip(QUANTILES, answer.quantiles, strict=True)},
            "influences": "; ".join(shares),
        }


TABLES: Mapping[str, tuple[Mapping[str, str], Callable[[Results], Iterator[Row]]]] = {
    "parameters": (PARAMETERS, _parameters),
    "checks": (CHECKS, _rows_of_mechanisms("checks", CHECKS)),
    "histories": (HISTORIES, _rows_of_mechanisms("histories", HISTORIES)),
    "suites": (SUITES, _rows_of_mechanisms("suites", SUITES)),
    "verdict": (VERDICT, _verdict),
    "envelopes": (ENVELOPES, _envelopes),
    "records": (RECORDS, _rows_of_run("records", RECORDS)),
    "comparison": (COMPARISON, _rows_of_run("comparison", COMPARISON)),
    "sweeps": (SWEEPS, _sweeps),
    "sensitivity": (SENSITIVITY, _rows_of_run("sensitivity", SENSITIVITY)),
    "uncertainty": (UNCERTAINTY, _uncertainty),
}
"""What tables there are: their columns with the types of these, and their rows."""
