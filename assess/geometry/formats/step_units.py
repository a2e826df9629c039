"""Whether a STEP file states its unit; where not, Open CASCADE assumes millimetres without a warning."""

from __future__ import annotations

import re
from pathlib import Path

ARGUMENTS = rb"((?:[^;']|'[^']*')*)\)\s*;"  # up to the end of an instance; strings may hold what ends one
COMPLEX = re.compile(rb"#\s*(\d+)\s*=\s*\(" + ARGUMENTS)
SHAPE = re.compile(
    rb"=\s*(?:(?:ADVANCED|FACETED|ELEMENTARY)_BREP|(?:MANIFOLD|GEOMETRICALLY_BOUNDED)_SURFACE|TESSELLATED|CSG)"
    rb"_SHAPE_REPRESENTATION\s*\(" + ARGUMENTS
)
CONTEXT = {b"GEOMETRIC_REPRESENTATION_CONTEXT", b"GLOBAL_UNIT_ASSIGNED_CONTEXT", b"REPRESENTATION_CONTEXT"}
METRE = re.compile(
    rb"SI_UNIT\s*\(\s*(?:\$|\.(?:EXA|PETA|TERA|GIGA|MEGA|KILO|HECTO|DECA|DECI|CENTI|MILLI|MICRO|NANO|PICO|FEMTO|ATTO)\.)"
    rb"\s*,\s*\.METRE\.\s*\)"
)
REFERENCE = re.compile(rb"#\s*(\d+)")


def states_unit(file: Path) -> bool:
    """Return whether the contexts of all shapes of a file name a unit of length (ISO 10303-41, -42).

    Raises
    ------
    ValueError : those of some do, those of others do not; a unit is damaged
    """
    data = re.sub(rb"/\*.*?\*/", b"", file.read_bytes(), flags=re.DOTALL)
    instances = [(number, _words(text), text) for number, text in COMPLEX.findall(data)]
    lengths = {number for number, words, text in instances if _is_length(words, text)}
    known = {
        number
        for number, words, text in instances
        if words >= CONTEXT and lengths.intersection(REFERENCE.findall(text))
    }
    used = [references[-1] in known for text in SHAPE.findall(data) if (references := REFERENCE.findall(text))]
    if any(used) and not all(used):
        raise ValueError("some of its shapes state no unit")
    return all(used) and bool(known)


def _words(text: bytes) -> set[bytes]:
    """Return the entities of a complex instance."""
    return set(re.findall(rb"([A-Z_0-9]+)\s*\(", re.sub(rb"'[^']*'", b"", text)))


def _is_length(words: set[bytes], text: bytes) -> bool:
    """Return whether a complex instance is a unit of length; raise ValueError where it names none that exists."""
    if not {b"LENGTH_UNIT", b"NAMED_UNIT"} <= words:
        return False
    if b"SI_UNIT" in words and not METRE.search(text):
        raise ValueError("its unit of length is no metre with a prefix; it is damaged")
    return bool(words & {b"SI_UNIT", b"CONVERSION_BASED_UNIT"})
