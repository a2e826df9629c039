"""Quantities of the project file."""

import math
from collections.abc import Iterator
from contextlib import suppress
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import foot, g, inch, lb, lbf, psi

from assess.errors import ProjectError
from assess.project.units import KINDS, USUAL, is_weight, pint_factor, to_si

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
    ("130 pcf", "density", 130 * lb / foot**3),
    ("130 lbf/ft^3", "density", 130 * lb / foot**3),
    ("20 kN/m^3", "density", 20e3 / g),
    ("20 kN/m³", "density", 20e3 / g),
    ("0.02 MN/m³", "density", 20e3 / g),
    ("2000 kgf/m³", "density", 2000.0),
    ("100 psf", "stress", 100 * lbf / foot**2),
    ("4′", "length", 4 * foot),
    ('6"', "length", 6 * inch),
    ("30′", "angle", math.pi / 360),
    ("30º", "angle", math.pi / 6),
    ("5 ‰", "ratio", 0.005),
    ("−3.5 m", "length", -3.5),
    ("1.5e−3\u00a0m", "length", 0.0015),
    ("10\u200b kN", "force", 1e4),
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
    ("1,25 m", "length", 'a decimal comma; write "1.25 m"'),
    ("0,10 g", "acceleration", 'a decimal comma; write "0.10 g"'),
    ("-,5 m", "length", 'a decimal comma; write "-0.5 m"'),
    ("0,100 m", "length", 'a decimal comma; write "0.100 m"'),
    ("1,250 mm", "length", 'write "1.250 mm" for a decimal comma, "1250 mm" for thousands'),
    ("05 m", "length", 'a 0 before the digits; write "5", or "0.5" if a point was lost'),
    ("-00.16 g", "acceleration", "a 0 before the digits"),
    ("1,250.5 mm", "length", 'thousands set apart; write "1250.5 mm"'),
    ("1.250,5 mm", "length", 'thousands set apart; write "1250.5 mm"'),
    ("1 250 mm", "length", 'thousands set apart; write "1250 mm"'),
    ("1\u202f250\u00a0mm", "length", 'thousands set apart; write "1250 mm"'),
    ("1'250 mm", "length", 'thousands set apart; write "1250 mm"'),
    ("1.2.3 m", "length", "more in the number than one decimal point"),
    ("4 ft 6 in", "length", "feet and inches in one"),
    ("4′ 6″", "length", "feet and inches in one"),
    ("٣ m", "length", "not a number with a unit"),
    ("１２ kN/m^3", "density", "not a number with a unit"),
    ("½ m", "length", "not a number with a unit"),
    ("1.2×10³ kg", "mass", "is not a unit"),
    ("2 ton", "mass", '1000 kg to some and 2000 lb to others; write "t" or "short_ton"'),
    ("1.5 ton/m^3", "density", "1000 kg to some"),
    ("20 kN/m^2", "density", '"kN/m^2" is not a unit of density'),
    ("20 kN", "density", '"kN" is not a unit of density'),
    ("20 kN/m^3", "mass per area", "is not a unit of mass per area"),
    ("4′", "mass", "is not a unit of mass"),
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

USED: dict[str, tuple[str, float]] = {
    **{unit: ("length", one) for unit, one in {"m": 1.0, "cm": 0.01, "mm": 1e-3, "ft": foot, "in": inch}.items()},
    **{unit: ("mass", one) for unit, one in {"kg": 1.0, "t": 1e3, "lb": lb, "lbm": lb}.items()},
    **{unit: ("force", one) for unit, one in {"N": 1.0, "kN": 1e3, "MN": 1e6, "lbf": lbf, "kip": 1e3 * lbf}.items()},
    **{unit: ("stress", one) for unit, one in {"Pa": 1.0, "MPa": 1e6, "GPa": 1e9, "psi": psi}.items()},
    **{unit: ("stress", one) for unit, one in {"N/mm^2": 1e6, "ksi": 1e3 * psi, "psf": lbf / foot**2}.items()},
    **{unit: ("density", one) for unit, one in {"kg/m^3": 1.0, "t/m^3": 1e3, "lb/ft^3": lb / foot**3}.items()},
    **{unit: ("density", one) for unit, one in {"kN/m^3": 1e3 / g, "N/m^3": 1 / g, "pcf": lb / foot**3}.items()},
    **{unit: ("mass per area", one) for unit, one in {"kg/m^2": 1.0, "lb/ft^2": lb / foot**2}.items()},
    **{unit: ("inertia", one) for unit, one in {"kg*m^2": 1.0, "t*m^2": 1e3}.items()},
    **{unit: ("acceleration", one) for unit, one in {"g": g, "m/s^2": 1.0, "cm/s^2": 0.01, "in/s^2": inch}.items()},
    **{unit: ("angle", one) for unit, one in {"rad": 1.0, "deg": math.pi / 180, "°": math.pi / 180}.items()},
    **{unit: ("stiffness", one) for unit, one in {"GPa/m": 1e9, "N/mm^3": 1e9, "psi/in": psi / inch}.items()},
    **{unit: ("time", one) for unit, one in {"s": 1.0, "ms": 1e-3}.items()},
    **{unit: ("speed", one) for unit, one in {"m/s": 1.0, "ft/s": foot}.items()},
    "Hz": ("frequency", 1.0), "1/s": ("rate", 1.0), "%": ("ratio", 0.01), "‰": ("ratio", 1e-3),
}  # fmt: skip
"""Units that project files use, as they are typed, with what they measure and what one of each is in SI."""


@pytest.mark.parametrize(("value", "kind", "expected"), GOOD)
def test_quantity_in_si(value: object, kind: str, expected: float) -> None:
    assert to_si(value, kind, key="k") == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize(("value", "kind", "reason"), BAD)
def test_wrong_quantity_names_key_value_and_remedy(value: object, kind: str, reason: str) -> None:
    with pytest.raises(ProjectError) as caught:
        to_si(value, kind, key="bodies.wall.box.height")
    text = str(caught.value)
    assert text.startswith("bodies.wall.box.height: ")
    assert repr(value)[:80] in text
    assert reason in text
    assert "; write " in text
    assert "\n" not in text


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


def forms(unit: str) -> Iterator[str]:
    """A unit in the ways that people and programs type it."""
    raised = unit.replace("^", "")
    yield from (unit, unit.replace("^", "**"), raised)
    yield raised.translate(str.maketrans("234", "²³⁴")) if "^" in unit else unit.replace("*", "·")


@given(st.sampled_from(sorted(USED)), st.decimals("-1e6", "1e6", places=3), st.data())
def test_a_unit_in_usual_use_is_read_in_every_form(unit: str, number: Decimal, data: st.DataObject) -> None:
    """Beside scipy's constants; signs of word processors are those of the keyboard."""
    kind, factor = USED[unit]
    sign = data.draw(st.sampled_from("-−‑"))
    space = data.draw(st.sampled_from(("", " ", "  ", "\u00a0", "\u2009", "\u202f")))
    form = data.draw(st.sampled_from(sorted(set(forms(unit)))))
    typed = f"{number:f}".replace("-", sign) + (space if form[0] != "1" else " ") + form
    if abs(float(number) * factor) < 1e-12 and number:
        return
    assert to_si(typed, kind, key="k") == pytest.approx(float(number) * factor, rel=1e-12)


@given(st.from_regex(r"[-+0-9.,'_ *e]{1,12}", fullmatch=True))
def test_what_is_read_as_a_number_is_one(number: str) -> None:
    """No text of digits and signs is evaluated, nor cut short."""
    with suppress(ProjectError):
        assert to_si(f"{number} m", "length", key="k") == float(number)


@pytest.mark.parametrize("value", ["0 1 m", "5 1 m", "3 m 1"])
def test_a_second_number_is_no_unit(value: str) -> None:
    assert to_si("3 1/s", "rate", key="k") == 3.0
    with pytest.raises(ProjectError, match="; write "):
        to_si(value, "length", key="k")


def test_weights_are_told_from_masses() -> None:
    density = KINDS["density"]
    weights = ("20 kN/m^3", "20 kN/m³", "130 pcf", "130 lbf/ft^3", "2000 kgf/m^3")
    assert [typed for typed in weights if not is_weight(typed, density)] == []
    assert [typed for typed in ("2 t/m^3", "130 lb/ft^3", "2000 kg/m³") if is_weight(typed, density)] == []
    assert not is_weight("2 m", KINDS["length"])
