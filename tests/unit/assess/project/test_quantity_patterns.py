"""The patterns of the JSON Schema accept what is read, and refuse only what is not."""

from __future__ import annotations

import re
import tomllib
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator
from pydantic import TypeAdapter, ValidationError

from assess.examples import EXAMPLES, source
from assess.project.project_file import json_schema
from assess.project.sections.analysis import DensityChange, ForceChange, LengthChange, ShareChange, StressChange
from assess.project.units import KINDS, USUAL, prefixes_and_names, quantity_pattern, reads_unit, to_si
from assess.project.values import length_of_unit
from tests.support.projects import as_editors_see

CHANGES = {
    "length": TypeAdapter(LengthChange),
    "density": TypeAdapter(DensityChange),
    "stress": TypeAdapter(StressChange),
    "ratio": TypeAdapter(ShareChange),
    "force": TypeAdapter(ForceChange),
}
UNITS = sorted({unit for units in USUAL.values() for unit in units} | {"g", "gal", "ton", "°", "′", "″", "‰", "meters"})
TYPED = st.sampled_from([*UNITS, "1", "m", "kg", "s"]).flatmap(
    lambda unit: st.sampled_from([unit, f"{unit}^2", f"{unit}²", f"{unit}**-1", f"{unit}s", f"k{unit}", f"{unit}⁻²"])
)
PRODUCTS = st.lists(TYPED, min_size=1, max_size=3).flatmap(
    lambda units: st.sampled_from(["/", "*", " * ", " ", "·", "⋅"]).map(lambda sign: sign.join(units))
)
NUMBERS = st.from_regex(r"[+−-]?([0-9]{1,3}(\.[0-9]{0,3})?|\.[0-9]{1,3})([eE][+-]?[0-9])?", fullmatch=True)


def accepts(text: str, kind: str, form: Any = "quantity") -> bool:
    return re.search(quantity_pattern(kind, form), text) is not None


def is_read(text: str, kind: str) -> bool:
    try:
        to_si(text, kind, key="x")
    except ValueError:
        return False
    return True


@given(
    kind=st.sampled_from(sorted(KINDS)),
    number=NUMBERS,
    space=st.sampled_from(["", " ", "  ", "\u00a0", "\u200b"]),
    unit=PRODUCTS | st.sampled_from(UNITS) | st.just(""),
    end=st.sampled_from(["", " ", "."]),
)
def test_what_is_read_is_accepted(kind: str, number: str, space: str, unit: str, end: str) -> None:
    text = f"{number}{space}{unit}{end}"
    assert accepts(text, kind) or not is_read(text, kind), text


@given(kind=st.sampled_from(sorted(KINDS)), data=st.data())
def test_every_name_that_pint_gives_a_unit_is_accepted_with_its_prefixes(kind: str, data: st.DataObject) -> None:
    prefixes, names = prefixes_and_names(KINDS[kind])
    every = sorted({name for each in KINDS.values() for name in prefixes_and_names(each)[1]})
    name = data.draw(st.sampled_from(names) | st.sampled_from(every) if names else st.sampled_from(every))
    text = f"2 {data.draw(st.sampled_from(['', *prefixes]))}{name}{data.draw(st.sampled_from(['', 's']))}"
    assert accepts(text, kind) or not is_read(text, kind), text


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_usual_units_are_accepted_by_the_keys_that_take_them_and_by_no_others(kind: str) -> None:
    wrong = [unit for unit in UNITS if unit.isascii() and accepts(f"2 {unit}", kind) != reads_unit(unit, KINDS[kind])]
    assert wrong == []


@pytest.mark.parametrize(
    "text", ["0.6", "0.6 kg", "0.6 metrs", "0.6 M", "0,6 m", "1 m 2", "2 kN/m^3", "m", "", "0.6 m/", "5 ton", "1.2.3 m"]
)
def test_an_editor_shows_a_wrong_length(text: str) -> None:
    assert not accepts(text, "length")
    assert not is_read(text, "length")


@pytest.mark.parametrize(("text", "right"), [("inf", True), ("Infinite", True), (" 3 MPa ", True), ("endless", False)])
def test_a_strength_may_be_infinite(text: str, right: bool) -> None:
    assert accepts(text, "stress", "quantity or infinite") is right
    assert not accepts("inf", "stress")


@pytest.mark.parametrize(("text", "right"), [("mm", True), (" ft", True), ("3 mm", False), ("kg", False), ("", False)])
def test_a_unit_alone_has_no_number(text: str, right: bool) -> None:
    assert accepts(text, "length", "unit") is right
    if right:
        assert length_of_unit(text) > 0.0
    else:
        with pytest.raises(ValueError, match="unit"):
            length_of_unit(text)


@given(
    kind=st.sampled_from(["length", "density", "stress", "ratio", "force"]),
    number=NUMBERS,
    space=st.sampled_from(["", " ", "\u00a0"]),
    unit=PRODUCTS | st.sampled_from([*UNITS, "%", "percent", "permille", "Percent", ""]),
)
def test_a_change_that_is_read_is_accepted(kind: str, number: str, space: str, unit: str) -> None:
    text = f"{number}{space}{unit}"
    try:
        CHANGES[kind].validate_python(text)
    except ValidationError:
        return
    assert accepts(text, kind, "change"), text


@pytest.mark.parametrize(
    "text", ["2", "2 cm", "5 %", "5 permille", "-0.1", "5 kg", "cm", "5 %%", "2 cm 3", "5 percents"]
)
def test_an_editor_shows_a_wrong_change_of_a_length(text: str) -> None:
    try:
        CHANGES["length"].validate_python(text)
    except ValidationError:
        assert not accepts(text, "length", "change") or text in ("2", "-0.1")  # signs and sizes are the reader's
    else:
        assert accepts(text, "length", "change")


@pytest.fixture(scope="module")
def schema() -> Draft202012Validator:
    Draft202012Validator.check_schema(json_schema())
    return Draft202012Validator(json_schema())


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_editor_finds_no_fault_in_an_example(name: str, schema: Draft202012Validator) -> None:
    tables = as_editors_see(tomllib.loads((source(name) / EXAMPLES[name].file).read_text(encoding="utf-8")))
    assert [f"{fault.json_path}: {fault.message}" for fault in schema.iter_errors(tables)] == []


def test_an_editor_finds_the_key_of_a_wrong_unit(schema: Draft202012Validator) -> None:
    tables = tomllib.loads((source("single_wall") / "project.toml").read_text(encoding="utf-8"))
    (material,) = tables["materials"].values()
    material["density"] = "1800 kg/m^2"
    assert [fault.json_path.rpartition(".")[2] for fault in schema.iter_errors(tables)] == ["density"]


@pytest.mark.parametrize(
    ("thickness", "right"),
    [
        ({"mean": "0.6 m", "sd": "2 cm"}, True),
        ({"mean": 0.6, "cov": "5 %"}, True),
        ({"mean": "0.6", "cov": 0.05}, False),
        ({"mean": "0.6 m", "sd": "2 kg"}, False),
        ({"mean": "0.6 m", "sd": "2"}, False),
    ],
)
def test_an_editor_knows_the_unit_of_an_uncertain_number(
    thickness: dict[str, Any], right: bool, schema: Draft202012Validator
) -> None:
    tables = tomllib.loads((source("single_wall") / "project.toml").read_text(encoding="utf-8"))
    (body,) = tables["bodies"].values()
    body["box"]["thickness"] = thickness
    assert schema.is_valid(tables) is right


def test_an_editor_knows_the_unit_of_a_change(schema: Draft202012Validator) -> None:
    tables = tomllib.loads((source("single_wall") / "project.toml").read_text(encoding="utf-8"))
    tables["analysis"]["sensitivity"] = {"thickness": "2 cm", "density": "5 %", "friction": False, "loads": 0.1}
    assert schema.is_valid(tables)
    tables["analysis"]["sensitivity"]["thickness"] = "2 kg"
    assert not schema.is_valid(tables)
