"""Tables of results as DataFrames: the numbers of results.json."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import assess.examples
from assess.codes.verdict import Decision
from assess.errors import AssessError
from assess.project.build import build
from assess.project.project_file import load
from assess.results import Results, SweepResult
from assess.results.json import dumps
from assess.results.table import TABLES, table
from assess.study.run import run_study

PROJECT = Path(assess.examples.__file__).parent / "projects" / "single_wall" / "project.toml"


@pytest.fixture(scope="module")
def results() -> Results:
    return run_study(build(load(PROJECT)), jobs=1)


@pytest.fixture(scope="module")
def plain(results: Results) -> Any:
    """results.json, read as JSON."""
    return json.loads(dumps(results))


def cell(value: Any) -> Any:
    """A value of results.json as its cell of a table."""
    if isinstance(value, dict):
        return value["text"]
    return "; ".join(str(cell(each)) for each in value) if isinstance(value, list) else value


def assert_rows(frame: pd.DataFrame, rows: list[dict[str, Any]]) -> None:
    """Each row of the frame has the values of results.json, to the last bit; nan is null."""
    assert len(frame) == len(rows)
    for place, row in enumerate(rows):
        for name in set(frame.columns) & set(row):
            found, expected = frame[name].iloc[place], cell(row[name])
            assert (pd.isna(found) and expected is None) or found == expected, (place, name)


@pytest.mark.parametrize("name", ["checks", "histories", "suites"])
def test_tables_of_mechanisms_hold_the_numbers_of_the_file(results: Results, plain: Any, name: str) -> None:
    assert_rows(
        table(results, name), [{"mechanism": each["name"], **row} for each in plain["mechanisms"] for row in each[name]]
    )


@pytest.mark.parametrize("name", ["records", "comparison", "sensitivity"])
def test_tables_of_the_run_hold_the_numbers_of_the_file(results: Results, plain: Any, name: str) -> None:
    assert_rows(table(results, name), plain[name])


def test_parameters_have_a_row_for_each_branch(results: Results, plain: Any) -> None:
    frame = table(results, "parameters")
    rows = []
    for mechanism in plain["mechanisms"]:
        for branch, key in (("positive", "oscillator"), ("negative", "oscillator_negative")):
            if mechanism[key] is not None:
                linearised = {f"linearised_{name}": value for name, value in mechanism[key]["linearised"].items()}
                rows.append({"mechanism": mechanism["name"], "branch": branch, **mechanism[key], **linearised})
    assert_rows(frame, rows)
    assert set(frame.columns) == set(rows[0]) - {"linearised"}


def test_the_verdict_has_a_row_for_each_answer_that_decides(results: Results, plain: Any) -> None:
    frame = table(results, "verdict")
    judged = plain["verdict"]["mechanisms"]
    assert_rows(frame, [{**answer, **one} for one in judged for answer in one["answers"]])
    assert frame["answer"].tolist() == [answer["outcome"] for one in judged for answer in one["answers"]]
    assert frame["index_value"].isna().tolist() == [a["index"] is None for one in judged for a in one["answers"]]


def test_envelopes_have_a_row_for_each_frequency(results: Results, plain: Any) -> None:
    expected = []
    for mechanism in plain["mechanisms"]:
        envelope = mechanism["envelope"] or {"frequency_hz": []}
        for place in range(len(envelope["frequency_hz"])):
            names = ("frequency_hz", "lower_bound_g", "polarity", "islands", "uplift_g", "factor", "omega")
            expected.append({"mechanism": mechanism["name"], **{name: envelope[name][place] for name in names}})
    assert_rows(table(results, "envelopes"), expected)


def test_sweeps_have_a_row_for_each_case(results: Results) -> None:
    twice = (0.5, 0.6)
    sweep = SweepResult(
        "wall", "bodies.wall.box.thickness", "m", twice, (1.7, 1.6), (None, 0.2), twice, (None, None), (None, None),
        twice, (None, 0.3), (True, False), (None, 0.4), (Decision.FAIL, Decision.PASS), 0, True,
    )  # fmt: skip
    frame = table(replace(results, sweeps=(sweep,)), "sweeps")
    assert frame["value"].tolist() == [0.5, 0.6]
    assert frame["outcome"].tolist() == ["fail", "pass"]
    assert frame["overturned"].tolist() == [True, False]
    assert frame["demand_capacity"].isna().tolist() == [True, False]
    assert (frame["key"] == "bodies.wall.box.thickness").all()


@pytest.mark.parametrize("name", list(TABLES))
def test_every_number_is_a_number_also_where_none_is_known(results: Results, name: str) -> None:
    frame, (columns, _) = table(results, name), TABLES[name]
    assert list(frame.columns) == list(columns)
    assert all(frame[column].dtype == np.float64 for column, kind in columns.items() if kind.startswith("float"))


def test_units_stand_beside_the_names(results: Results) -> None:
    units = table(results, "parameters").attrs["units"]
    assert units["p_eq_per_s"] == "1/s"
    assert units["linearised_stiffness_n_m_per_rad"] == "N m/rad"
    assert units["inertia_kg_m2"] == "kg m2"
    assert "restitution" not in units


def test_an_unknown_table_is_told_with_the_known_ones(results: Results) -> None:
    with pytest.raises(AssessError, match='no table "check" of results; known are parameters, checks, '):
        table(results, "check")
