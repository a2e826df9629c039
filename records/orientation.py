"""Which way a component of motion points, from its name."""

from __future__ import annotations

import re
from math import radians

COMPASS = {"N": 0.0, "E": 90.0, "S": 180.0, "W": 270.0}
WORDS = {"NORTH": "N", "EAST": "E", "SOUTH": "S", "WEST": "W", "NS": "N", "SN": "N", "EW": "E", "WE": "E"}
VERTICAL = {"UP", "U", "V", "Z", "UD", "DU", "VERT", "VERTICAL", "DOWN", "DWN", "DN"}

QUADRANT = re.compile(r"([NS])(\d{1,2})([EW])")
DEGREES = re.compile(r"(\d{1,3})(?:DEG)?")
SIGNED = re.compile(r"-\s*[\d-]")  # a hyphen before a digit or another is a sign, or damage
CHANNEL = re.compile(r"[A-Z][A-Z]([NEZ])")  # SEED: band, instrument, orientation
NUMBERED = re.compile(r"([A-Z-]+)[12]")  # KiK-net: 1 in the borehole, 2 at the surface


def azimuth_of(component: str) -> float | None:
    """Return the direction of positive motion of `component`, clockwise from north [rad].

    None if it is vertical, reversed or unknown. Understood are degrees ("360", "90 DEG"), quadrants ("N28W"), letters
    ("E", "EW", "E-W", "EW2": each positive towards north or east) and SEED channels ("HNE"; SEED manual 2.4, appendix
    A).
    """
    if component.lstrip().startswith("-") or SIGNED.search(component):
        return None
    name = _plain(component)
    quadrant, degrees = QUADRANT.fullmatch(name), DEGREES.fullmatch(name)
    if quadrant and float(quadrant[2]) <= 90.0:
        return radians(_from_quadrant(quadrant[1], float(quadrant[2]), quadrant[3]))
    if degrees:
        return radians(float(degrees[1]) % 360.0) if float(degrees[1]) <= 360.0 else None
    letter = WORDS.get(name, name)
    return radians(COMPASS[letter]) if letter in COMPASS else None


def is_vertical(component: str) -> bool:
    """Return whether `component` is named as a vertical one ("UP", "U-D", "UD2", "HNZ")."""
    return _plain(component) in VERTICAL


def _plain(component: str) -> str:
    """Return the name in capitals without blanks and hyphens; the orientation alone of a channel or a numbered name."""
    name = re.sub(r"[\s.-]", "", component.upper())
    found = CHANNEL.fullmatch(name) or NUMBERED.fullmatch(name)
    return found[1] if found and name not in VERTICAL else name


def _from_quadrant(start: str, angle: float, towards: str) -> float:
    """Return the azimuth [deg] of "N28W": `angle`, at most 90, from north or south `towards` east or west."""
    clockwise = (start == "N") == (towards == "E")
    return (COMPASS[start] + (angle if clockwise else -angle)) % 360.0
