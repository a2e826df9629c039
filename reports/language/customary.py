"""US customary units: what each unit of the report becomes, and the exact factor (NIST Handbook 44, appendix C).

Forces become kips throughout, so that moments (kip ft) go with them; masses become pounds. Accelerations are in g, as
American codes give them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from scipy.constants import foot, g, giga, inch, kilo, lbf, mega, mile, milli, pound, psi

KIP = kilo * lbf
_RAISED = str.maketrans("23", "²³")


@dataclass(frozen=True)
class Customary:
    """A US customary unit. factor : how many of them are one of the unit that it stands for."""

    unit: str
    factor: float


_UNITS: Mapping[str, Customary] = {
    "mm": Customary("in", milli / inch),
    "m": Customary("ft", 1 / foot),
    "km": Customary("mi", kilo / mile),
    "m²": Customary("ft²", 1 / foot**2),
    "m³": Customary("ft³", 1 / foot**3),
    "m/s": Customary("ft/s", 1 / foot),
    "m/s²": Customary("g", 1 / g),
    "kg": Customary("lb", 1 / pound),
    "kg m": Customary("lb ft", 1 / (pound * foot)),
    "kg m²": Customary("lb ft²", 1 / (pound * foot**2)),
    "kg/m²": Customary("lb/ft²", foot**2 / pound),
    "kg/m³": Customary("lb/ft³", foot**3 / pound),
    "N": Customary("kip", 1 / KIP),
    "kN": Customary("kip", kilo / KIP),
    "MN": Customary("kip", mega / KIP),
    "N m": Customary("kip ft", 1 / (KIP * foot)),
    "kN m": Customary("kip ft", kilo / (KIP * foot)),
    "MN m": Customary("kip ft", mega / (KIP * foot)),
    "N m/rad": Customary("kip ft/rad", 1 / (KIP * foot)),
    "Pa": Customary("psi", 1 / psi),
    "kPa": Customary("psi", kilo / psi),
    "MPa": Customary("psi", mega / psi),
    "GPa": Customary("psi", giga / psi),
    "Pa/m": Customary("psi/in", inch / psi),
    "MPa/m": Customary("psi/in", mega * inch / psi),
    "GPa/m": Customary("psi/in", giga * inch / psi),
}
KNOWN = tuple(sorted(_UNITS, key=len, reverse=True))
"""The units that become others, the longest first."""


def customary(unit: str) -> Customary | None:
    """Return the US unit for a unit, also written as m2 or kg/m^3; None for one that both systems share."""
    return _UNITS.get(unit.replace("^", "").translate(_RAISED))
