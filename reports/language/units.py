"""The units in which each dimension is shown, in SI and in US customary units.

Factors are exact (NIST Handbook 44, appendix C). In US reports forces are in kips throughout, so that moments (kip ft)
go with them, masses in pounds, and accelerations in g, as American codes give them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from typing import Literal

from scipy.constants import foot, g, giga, inch, kilo, lbf, mega, mile, milli, pound, psi

System = Literal["SI", "US"]
KIP = kilo * lbf


@dataclass(frozen=True)
class Unit:
    """A unit. size : of one of them in the SI unit of its dimension."""

    name: str
    size: float = 1.0


@dataclass(frozen=True)
class DimensionUnits:
    """The units of one dimension in one system: that of tables, and those of single numbers, the smallest first."""

    table: Unit
    single: tuple[Unit, ...]

    def of(self, value: float) -> Unit:
        """Return the unit of a single number: the largest of which there is at least one."""
        return next((unit for unit in reversed(self.single) if abs(value) >= unit.size), self.single[0])


def _one(name: str, size: float = 1.0) -> DimensionUnits:
    return DimensionUnits(Unit(name, size), (Unit(name, size),))


def _several(table: str, **sizes: float) -> DimensionUnits:
    units = tuple(Unit(name.replace("_", " "), size) for name, size in sizes.items())
    return DimensionUnits(next(unit for unit in units if unit.name == table), units)


_PER_METRE = DimensionUnits(
    Unit("GPa/m", giga), (Unit("Pa/m"), Unit("kPa/m", kilo), Unit("MPa/m", mega), Unit("GPa/m", giga))
)
_SI: Mapping[str, DimensionUnits] = {
    "ratio": _one(""),
    "percent": _one("%"),
    "length": _one("m"),
    "short length": _one("mm", milli),
    "distance": _one("km", kilo),
    "area": _one("m²"),
    "volume": _one("m³"),
    "time": _one("s"),
    "velocity": _one("m/s"),
    "acceleration": _one("m/s²"),
    "ground acceleration": _one("g"),
    "frequency": _one("Hz"),
    "rotation": _one("rad"),
    "angle": _one("°", pi / 180.0),
    "angular frequency": _one("1/s"),
    "mass": _several("kg", kg=1.0, t=kilo),
    "inertia": _several("kg m²", **{"kg m²": 1.0, "t m²": kilo}),
    "first moment": _several("kg m", **{"kg m": 1.0, "t m": kilo}),
    "density": _one("kg/m³"),
    "weight density": _one("kN/m³", kilo),
    "area density": _one("kg/m²"),
    "force": _several("kN", N=1.0, kN=kilo, MN=mega),
    "moment": _several("kN m", N_m=1.0, kN_m=kilo, MN_m=mega),
    "energy": _several("kJ", J=1.0, kJ=kilo, MJ=mega),
    "stress": _several("MPa", Pa=1.0, kPa=kilo, MPa=mega, GPa=giga),
    "stiffness": _PER_METRE,
    "rotational stiffness": _several("kN m/rad", **{"N m/rad": 1.0, "kN m/rad": kilo, "MN m/rad": mega}),
    "return period": _one("years"),
    "annual rate": _one("1/year"),
}
_US: Mapping[str, DimensionUnits] = {
    "length": _one("ft", foot),
    "short length": _one("in", inch),
    "distance": _one("mi", mile),
    "area": _one("ft²", foot**2),
    "volume": _one("ft³", foot**3),
    "velocity": _one("ft/s", foot),
    "acceleration": _one("g", g),
    "mass": _one("lb", pound),
    "inertia": _one("lb ft²", pound * foot**2),
    "first moment": _one("lb ft", pound * foot),
    "density": _one("lb/ft³", pound / foot**3),
    "weight density": _one("lbf/ft³", lbf / foot**3),
    "area density": _one("lb/ft²", pound / foot**2),
    "force": _one("kip", KIP),
    "moment": _one("kip ft", KIP * foot),
    "energy": _one("kip ft", KIP * foot),
    "stress": _several("psi", psi=psi, ksi=kilo * psi),
    "stiffness": _several("psi/in", **{"psi/in": psi / inch, "ksi/in": kilo * psi / inch}),
    "rotational stiffness": _one("kip ft/rad", KIP * foot),
}
UNITS: Mapping[System, Mapping[str, DimensionUnits]] = {"SI": _SI, "US": {**_SI, **_US}}
UNIT_WORDS = ("years", "1/year")
"""Units that are words of a language."""
