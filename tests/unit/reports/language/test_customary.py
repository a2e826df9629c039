"""US customary units against pint's own definitions."""

from __future__ import annotations

import pint
import pytest
from reports.language.customary import KNOWN, customary

REGISTRY = pint.UnitRegistry()


def as_pint(unit: str) -> str:
    return {"g": "standard_gravity"}.get(unit, unit).replace("²", "**2").replace("³", "**3").replace(" ", "*")


@pytest.mark.parametrize("unit", KNOWN)
def test_factors_are_those_of_pint(unit: str) -> None:
    found = customary(unit)
    assert found is not None
    one = REGISTRY.Quantity(1.0, as_pint(unit))
    assert found.factor == pytest.approx(one.to(as_pint(found.unit)).magnitude, rel=1e-12)


@pytest.mark.parametrize(("spelt", "unit"), [("m/s2", "g"), ("kg/m^3", "lb/ft³"), ("kg m2", "lb ft²")])
def test_powers_may_be_written_without_raised_digits(spelt: str, unit: str) -> None:
    found = customary(spelt)
    assert found is not None
    assert found.unit == unit


@pytest.mark.parametrize("unit", ["g", "rad", "s", "Hz", "-", "deg", "1/s", "years", "", "ft"])
def test_what_both_systems_share_stays(unit: str) -> None:
    assert customary(unit) is None
