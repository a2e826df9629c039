"""The units that most project files are written in, so that pint, which takes half a second to begin, seldom has to."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

INCH, FOOT = Fraction("0.0254"), Fraction("0.3048")
POUND = Fraction("0.45359237")
G = Fraction("9.80665")  # standard gravity [m/s2]
POUND_FORCE = POUND * G
PI = Fraction("3.1415926535897932384626433832795028841971693993751")  # as pint has it

USUAL: Mapping[str, Mapping[str, Fraction]] = {
    "length": {
        "m": Fraction(1),
        "cm": Fraction(1, 100),
        "mm": Fraction(1, 1000),
        "ft": FOOT,
        "in": INCH,
        "'": FOOT,
        '"': INCH,
    },
    "mass": {"kg": Fraction(1), "t": Fraction(1000), "lb": POUND},
    "time": {"s": Fraction(1), "ms": Fraction(1, 1000)},
    "duration": {"years": Fraction(1), "year": Fraction(1)},
    "acceleration": {"m/s^2": Fraction(1), "m/s2": Fraction(1), "cm/s^2": Fraction(1, 100)},
    "force": {"N": Fraction(1), "kN": Fraction(1000), "MN": Fraction(10**6), "lbf": POUND_FORCE},
    "stress": {
        "Pa": Fraction(1),
        "kPa": Fraction(1000),
        "MPa": Fraction(10**6),
        "GPa": Fraction(10**9),
        "N/mm^2": Fraction(10**6),
        "psi": POUND_FORCE / INCH**2,
        "ksi": 1000 * POUND_FORCE / INCH**2,
    },
    "stiffness per area": {
        "GPa/m": Fraction(10**9),
        "MPa/m": Fraction(10**6),
        "N/mm^3": Fraction(10**9),
        "psi/in": POUND_FORCE / INCH**3,
    },
    "density": {
        "kg/m^3": Fraction(1),
        "kg/m3": Fraction(1),
        "t/m^3": Fraction(1000),
        "lb/ft^3": POUND / FOOT**3,
        "pcf": POUND / FOOT**3,
        "kN/m^3": 1000 / G,
        "kN/m3": 1000 / G,
        "kN/m³": 1000 / G,
    },
    "mass per area": {"kg/m^2": Fraction(1), "kg/m2": Fraction(1)},
    "angle": {"rad": Fraction(1), "deg": PI / 180},
    "frequency": {"Hz": Fraction(1)},
    "rate": {"1/s": Fraction(1)},
    "ratio": {"%": Fraction(1, 100)},
}
"""SI units of a kind, by its name in `units.KINDS`, that one of each unit is, as it is typed."""
WEIGHTS = frozenset({"kN/m^3", "kN/m3", "kN/m³", "pcf"})
"""Units of weight per volume among those of density."""
DEFINED = ("pcf = pound_force / foot ** 3", "psf = pound_force / foot ** 2", "lbm = pound")
"""Units of American engineers that pint does not know, as its definitions."""
AMBIGUOUS: Mapping[str, str] = dict.fromkeys(
    ("ton", "tons"), '1000 kg to some and 2000 lb to others; write "t" or "short_ton"'
)
"""What is wrong with units that mean different things in different countries, and the remedy."""
