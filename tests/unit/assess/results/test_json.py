"""Results to and from JSON."""

import json
import math
from dataclasses import fields, replace
from pathlib import Path

import pytest

from assess.codes import calculation_sheet
from assess.codes.bases import BASES
from assess.codes.calculation_sheet import step
from assess.codes.check import Check, Outcome, PgaCurve, Reason, reason_message
from assess.codes.question import Action, MechanismChecks, Missing, Question
from assess.codes.verdict import Decision, verdict
from assess.errors import ResultsError
from assess.messages.message import Message, Quantity, Severity
from assess.results import (
    SCHEMA_VERSION,
    AmplificationResult,
    BranchCurve,
    CapacityCurve,
    ChecklistItem,
    ComparisonRow,
    ContactSheet,
    DisplacedDrawing,
    Drawing,
    DrawnLoad,
    HingeAxis,
    Input,
    LinearisedResult,
    LoadResult,
    MechanismResult,
    NamedPoint,
    OscillatorResult,
    Picture,
    Program,
    ReportMatter,
    ResolvedValue,
    Results,
    Revision,
    SpectrumResult,
    SweepResult,
    View,
)
from assess.results.json import (
    RESULTS_TREE,
    _validate_at_once,
    _validate_step_by_step,
    dumps,
    dumps_mechanisms,
    loads,
    read,
)

LINEARISED = LinearisedResult(5000.0, 14450.0, 2000.0, 0.0, 0.1, 0.1, 0.074)
OSCILLATOR = OscillatorResult(1000.0, 5000.0, 2.0, 0.1, 1.7, None, 0.1, None, 0.1, 0.0, None, 0.95, LINEARISED)
CHECK = Check(
    procedure="asce43-05-spectrum", edition="2005", role="deciding", branch="positive",
    limit_state="no overturning", level_pga_g=0.1, input_at="ground", damping=None, damping_rule="",
    quantity="rotation", unit="rad", demand=None, capacity=0.05, ratio=None,
    verdict=Outcome.FAIL, reason=reason_message(Reason.OVERTURNS), rotation_ratio=None,
    pga_curve=PgaCurve((0.0, 0.5), (0.1, 1 / 3)),
    steps=(step("f", "frequency", "A.2", "f = 1 / T", 0.5, "Hz", given={"T": (2.0, "s")}),), caveat="",
    remarks=(reason_message(Reason.SLIDES_LATER, pga=Quantity(0.3, "ground acceleration")),),
    capacity_pga_g=0.4, uplift_pga_g=0.1, capacity_rotation_ratio=0.5,
)  # fmt: skip
RING, HINGE, LOAD = ((0.0, 0.0), (1.0, 0.0), (1.0, 4.0)), NamedPoint("A", (1.0, 0.0)), ("f", (1.0, 3.0), "force")
LOADS = (DrawnLoad(*LOAD, (-0.6, 0.8)), DrawnLoad("m", (1.0, 4.0), "mass", None))
DISPLACED = DisplacedDrawing(0.1, (RING,), (0,), (HINGE,), LOADS, ((0.5, 2.0),))
DRAWING = Drawing((RING,), (HINGE,), LOADS, (0.5, 2.0), (0,), ((0.5, 2.0),), DISPLACED, None, ())
CORNERS = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 4.0))
AXIS = HingeAxis("A", (CORNERS[1], CORNERS[2]))
VIEW = View(CORNERS, ((0, 1, 2),), (0,), (AXIS,), (CORNERS,), (1.0, 0.0, 0.0), (1.0, 1.0, 4.0), 1)
CURVE = CapacityCurve(BranchCurve(*[(0.0, 0.1, 0.2)] * 6), None)
MECHANISM = MechanismResult(
    "w", "<b>&", "single-block", "two", "exact", DRAWING, VIEW, OSCILLATOR, None, CURVE,
    ({"hinge": "A", "x": [1.5]},), AmplificationResult("none", ()), (CHECK,), (), (), None, "given",
    (LoadResult("<i>", "mass", 0, (0.1, 2.0), 5.0, True, None, "given"),), None,
    contact_sheets=(ContactSheet("A", (step("N", "w", "e", "m g", 9.8, "N", given={"m": (1.0, "kg")}),)),),
)  # fmt: skip
MISSING = Missing("building.use_class", "on which <the> target hangs", 'use_class = "II"')
CONDITION = Message("premise", Severity.WARNING, "", "a pass holds where it is anchored")
QUESTION = Question(
    BASES["asce43-05"], Action(0.1, "DBE", return_period_years=475.0), procedures=("asce43-05-spectrum",)
)
OTHER = replace(CHECK, verdict=Outcome.PASS, ratio=0.97)
JUDGED = (MechanismChecks("w", (CHECK,)), MechanismChecks("v", (OTHER,), (MISSING,), (CONDITION,)))
VERDICT = verdict(QUESTION, JUDGED)
"""A verdict with a failing answer, a missing key, a condition and no margin."""


RESULTS = Results(
    schema_version=SCHEMA_VERSION,
    program=Program("assess", "0.1.0"),
    inputs=(Input("project.toml", "00ff"),),
    warnings=(
        Message("x", Severity.WARNING, "records", "a “sentence” with \n and \x07", {"a": Quantity(0.1, "length")}),
    ),
    project={
        "title": ResolvedValue("é", True),
        "levels": ResolvedValue([0.1, 0.2], False),
        "site.pga": ResolvedValue(None, False),
    },
    spectrum=SpectrumResult("asce7-05", {"s_ds": 1, "hazard": "design"}, 0.05, "", "", 0.067, (0.0, 1.0), (1 / 3, 1)),
    records=(),
    mechanisms=(MECHANISM, replace(MECHANISM, name="v")),
    critical=None,
    comparison=(ComparisonRow("w", 0.1, "asce43-05-spectrum", None, 0.5, None),),
    verdict=VERDICT,
    sweeps=(
        SweepResult(
            "w",
            "a.b",
            "deg",
            (1, 2.5),
            *[(0.5, 0.6)] * 6,
            (None, 1.2),
            (True, False),
            (0.1, None),
            (Decision.FAIL, Decision.PASS),
            0,
            True,
        ),
    ),
)


MATTER = ReportMatter(
    client="<b>&",
    coordinates=(42.35, 13.4),
    revisions=(Revision("0", "2024-01-01", "first issue", "A. B."),),
    building_type="house",
    logo=Picture("logo.png", "", "image/png", 2, 1, "AAAA"),
    checklist=(
        ChecklistItem("gable", None, "examined", ("w",)),
        ChecklistItem("corner", None, "not-examined", (), "no access"),
        ChecklistItem("in-plane", None, "not-examined", spoken_for=False),
    ),
)


def test_round_trip_keeps_every_value() -> None:
    assert loads(dumps(RESULTS)) == RESULTS


def test_the_matter_of_the_report_comes_back_whole_and_is_empty_in_older_files() -> None:
    written = dumps(replace(RESULTS, report=MATTER))
    assert loads(written).report == MATTER
    assert loads(dumps(replace(RESULTS, report=replace(MATTER, coordinates="near the well")))).report
    older = json.loads(written)
    del older["report"]
    assert loads(json.dumps(older)).report == ReportMatter()


def test_a_contact_comes_back_as_lines_and_is_none_in_older_files() -> None:
    written = dumps(RESULTS)
    (sheet,) = loads(written).mechanisms[0].contact_sheets
    assert isinstance(sheet, ContactSheet)
    assert sheet.steps[0].inputs == (calculation_sheet.SymbolValue("m", 1.0, "mass"),)
    older = json.loads(written)
    del older["mechanisms"][0]["contact_sheets"]
    assert loads(json.dumps(older)).mechanisms[0].contact_sheets == ()


def test_letters_within_a_picture_do_not_slow_the_reading() -> None:
    logo = Picture("logo.png", "", "image/png", 2, 1, "AANaN+NaN/InfinityAA")
    written = dumps(replace(RESULTS, report=ReportMatter(logo=logo)))
    assert _validate_at_once(written, RESULTS_TREE) == loads(written)


def test_an_examined_item_names_mechanisms_of_the_results() -> None:
    wrong = replace(MATTER, checklist=(ChecklistItem("gable", None, "examined", ("nobody",)),))
    with pytest.raises(ResultsError, match=r"report.checklist\[0\].mechanism: \"nobody\" is none of the mechanisms"):
        loads(dumps(replace(RESULTS, report=wrong)))


def test_the_verdict_comes_back_whole() -> None:
    found = loads(dumps(RESULTS)).verdict
    assert found == VERDICT
    assert found is not None
    assert [(one.outcome, one.provisional) for one in found.mechanisms] == [("fail", None), ("incomplete", "pass")]
    plain = json.loads(dumps(RESULTS))["verdict"]
    assert plain["outcome"] == "fail"
    assert plain["missing"][0]["key"] == "building.use_class"
    assert plain["action"] == {
        "pga_g": 0.1,
        "limit_state": "DBE",
        "return_period_years": 475.0,
        "over_periods": False,
    }
    answer = plain["mechanisms"][1]["answers"][0]
    assert (answer["procedure"], answer["index"]["name"], answer["at_the_limit"]) == ("asce43-05-spectrum", "D/C", True)


def test_a_message_has_key_severity_where_values_and_text() -> None:
    (warning,) = json.loads(dumps(RESULTS))["warnings"]
    assert list(warning) == ["key", "severity", "where", "text", "values"]
    assert warning["values"] == {"a": {"value": 0.1, "dimension": "length", "figures": 4}}


def test_read_at_once_as_step_by_step() -> None:
    text = dumps(RESULTS)
    assert _validate_at_once(text, RESULTS_TREE) == _validate_step_by_step(text, "results", RESULTS_TREE) == RESULTS
    told = replace(RESULTS, warnings=(Message("NaN", Severity.NOTE, "Infinity", "a word, not a number"),))
    assert loads(dumps(told)) == told


def test_text_is_the_same_each_time_and_after_reading() -> None:
    text = dumps(RESULTS)
    assert text == dumps(replace(RESULTS)) == dumps(loads(text))
    assert text.endswith("}\n")
    assert json.loads(text)["spectrum"]["acceleration_g"][0] == 1 / 3


def test_field_names_and_order_are_those_of_the_classes() -> None:
    data = json.loads(dumps(RESULTS))
    assert list(data) == [field.name for field in fields(Results)]
    assert list(data["mechanisms"][0]) == [field.name for field in fields(MechanismResult)]
    assert list(data["mechanisms"][0]["checks"][0]) == [field.name for field in fields(Check)]


def test_whole_number_in_a_field_of_floats_becomes_a_float() -> None:
    assert '"acceleration_g": [0.3333333333333333, 1.0]' in dumps(RESULTS)


def test_mechanisms_alone_are_the_block_of_the_results() -> None:
    assert json.loads(dumps_mechanisms((MECHANISM,))) == json.loads(dumps(RESULTS))["mechanisms"][:1]


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_infinite_number_is_refused_with_its_place(bad: float) -> None:
    broken = replace(MECHANISM, oscillator=replace(OSCILLATOR, restitution=bad))
    with pytest.raises(ValueError, match=r"mechanisms\[0\]\.oscillator\.restitution is") as caught:
        dumps(replace(RESULTS, mechanisms=(broken,)))
    assert not isinstance(caught.value, ResultsError)  # a bug of the program, not of the user's file


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "line 1: not JSON"),
        ("{", "not JSON"),
        ("[1, 2]", "not a results file"),
        ("{}", "no schema_version"),
        ('{"schema_version": 99}', "schema_version: 99: this program reads 2; run the project again"),
        ('{"schema_version": 1}', "schema_version: 1: this program reads 2; run the project again"),
        ('{"schema_version": 2}', "program: "),
        ('{"schema_version": NaN}', "NaN"),
        ("[" * 100_000, "nested too deeply"),
    ],
)
def test_junk_is_one_line(text: str, expected: str) -> None:
    with pytest.raises(ResultsError) as caught:
        loads(text, source="results.json")
    assert str(caught.value).startswith("results.json: ")
    assert expected in str(caught.value)
    assert str(caught.value).isprintable()


def test_wrong_value_is_named() -> None:
    data = json.loads(dumps(RESULTS))
    data["mechanisms"][0]["sides"] = "three"
    with pytest.raises(ResultsError, match=r"mechanisms\.0\.sides"):
        loads(json.dumps(data))


@pytest.mark.parametrize(
    ("part", "told"),
    [
        ("mechanisms", 'mechanisms[1].name: "v" a second time'),
        ("comparison", 'comparison[0].mechanism: "x" is none of the mechanisms'),
        ("sweeps", 'sweeps[0].mechanism: "x" is none of the mechanisms'),
        ("verdict", 'verdict.mechanisms[0].mechanism: "x" is none of the mechanisms'),
    ],
)
def test_a_name_that_was_edited_in_one_place_is_refused(part: str, told: str) -> None:
    data = json.loads(dumps(RESULTS))
    if part == "mechanisms":
        data["mechanisms"][0]["name"] = "v"
    else:
        (data["verdict"]["mechanisms"] if part == "verdict" else data[part])[0]["mechanism"] = "x"
    with pytest.raises(ResultsError) as caught:
        loads(json.dumps(data))
    assert told in str(caught.value)


def test_missing_and_binary_files(tmp_path: Path) -> None:
    with pytest.raises(ResultsError, match="No such file"):
        read(tmp_path / "results.json")
    (tmp_path / "results.json").write_bytes(bytes(range(256)))
    with pytest.raises(ResultsError, match="not a text file"):
        read(tmp_path / "results.json")
    with pytest.raises(ResultsError, match="directory"):
        read(tmp_path)
