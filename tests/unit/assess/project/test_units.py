"""Quantities of the project file."""

import math
import time

import pytest
from scipy.constants import foot, g, inch, lb, lbf, psi

from assess.errors import ProjectError
from assess.project.units import KINDS, pint_factor, to_si
from assess.project.usual_units import USUAL

GOOD = [
    (3, "length", 3.0),
    (1.25, "length", 1.25),
    ("1.25 m", "length", 1.25),
    ("690 mm", "length", 0.69),
    ("4 ft", "length", 4 * foot),
    ("-3.5e1cm", "length", -0.35),
    ("6.89 GPa", "stress", 6.89e9),
    ("100 psi", "stress", 100 * psi),
    ("10 GPa/m", "stiffness", 1e10),
    ("2240 kg/m^3", "density", 2240.0),
    ("2240 kg/m3", "density", 2240.0),
    ("2.24 t/m³", "density", 2240.0),
    ("140 lb/ft^3", "density", 140 * lb / foot**3),
    ("10 kip", "force", 1e4 * lbf),
    ("12 lb ft^2", "inertia", 12 * lb * foot**2),
    ("0.10 g", "acceleration", 0.10 * g),
    ("1g", "acceleration", 9.80665),
    ("0.5 m/s^2", "acceleration", 0.5),
    ("0.5 m s⁻²", "acceleration", 0.5),
    ("10 in/s**2", "acceleration", 10 * inch),
    ("981 Gal", "acceleration", 9.81),
    ("2.5 Hz", "frequency", 2.5),
    ("1.60 1/s", "rate", 1.6),
    ("1.60 rad/s", "rate", 1.6),
    ("30 deg", "angle", math.pi / 6),
    ("30°", "angle", math.pi / 6),
    ("5 %", "ratio", 0.05),
    ("0.577", "ratio", 0.577),
]

BAD = [
    (True, "length", "not a number"),
    (None, "length", "not a number"),
    ([1.0], "length", "not a number"),
    (math.nan, "length", "not a finite number"),
    (-math.inf, "length", "not a finite number"),
    (10**400, "length", "not a finite number"),
    ("1e999 m", "length", "not a finite number"),
    ("nan m", "length", "not a number with a unit"),
    ("", "length", "not a number with a unit"),
    ("3", "length", "no unit"),
    ("1,25 m", "length", "comma"),
    ("3 s", "length", '"s" is not a unit of length'),
    ("3 fathomz", "length", "unknown unit"),
    ("9**9**9 m", "length", "is not a unit"),
    ("1 m**9**9**9", "length", "is not a unit"),
    ("1 m^999999999", "length", "is not a unit"),
    ("1 (m)", "length", "is not a unit"),
    ("1 __import__('os')", "length", "is not a unit"),
    ("5 g", "mass", '"g" is standard gravity'),
    ("2.2 g/cm^3", "density", '"g" is standard gravity'),
    ("3 g*m", "acceleration", '"g" is standard gravity'),
    ("1 mg", "acceleration", "is not a unit of acceleration"),
    ("30 deg", "ratio", "is not a unit of ratio"),
    ("5 %", "angle", "is not a unit of angle"),
    ("2 rad/s", "frequency", "is not a unit of frequency"),
    ("2 Hz", "rate", "is not a unit of rate"),
    ("20 degC", "length", "is not a unit of length"),
]


@pytest.mark.parametrize(("value", "kind", "expected"), GOOD)
def test_quantity_in_si(value: object, kind: str, expected: float) -> None:
    assert to_si(value, kind, key="k") == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize(("value", "kind", "reason"), BAD)
def test_wrong_quantity_names_key_value_and_remedy(value: object, kind: str, reason: str) -> None:
    started = time.perf_counter()
    with pytest.raises(ProjectError) as caught:
        to_si(value, kind, key="bodies.wall.box.height")
    text = str(caught.value)
    assert text.startswith("bodies.wall.box.height: ")
    assert repr(value)[:80] in text
    assert reason in text
    assert "; write " in text
    assert "\n" not in text
    assert time.perf_counter() - started < 2.0


@pytest.mark.parametrize("value", ["1e300 Gm", 1e19, "1e-13 m", -1e19, 1e-300])
def test_what_no_structure_has_is_refused(value: object) -> None:
    assert to_si("1e9 Gm", "length", key="k") == 1e18
    with pytest.raises(ProjectError, match=r"beyond anything built|not a finite number"):
        to_si(value, "length", key="k")


@pytest.mark.parametrize("kind", KINDS)
def test_example_of_each_kind_is_read(kind: str) -> None:
    example = KINDS[kind].example
    assert to_si(example, kind, key="k") > 0
    with pytest.raises(ProjectError, match=KINDS[kind].name):
        to_si("1 candela", kind, key="k")


@pytest.mark.parametrize(("name", "unit"), [(name, unit) for name, units in USUAL.items() for unit in units])
def test_usual_unit_is_what_pint_makes_of_it(name: str, unit: str) -> None:
    (kind,) = (kind for kind in KINDS.values() if kind.name == name)
    assert USUAL[name][unit] == pint_factor(unit, kind)
