"""STEP files (ISO 10303-21), meshed with Open CASCADE by cascadio; the only door to it.

Where a file does not state its unit, Open CASCADE assumes millimetres without a warning.
"""

from __future__ import annotations

import re
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from assess.geometry.formats.gltf import read_glb
from assess.geometry.formats.isolation import run_in_subprocess
from assess.geometry.formats.mesh_file import ElementMesh, MeshFile

ANGULAR_DEFLECTION = 0.05  # rad: largest turn between neighbouring facets; a circle's area is then 0.04 % small
LINEAR_DEFLECTION = 0.01  # of an edge's length: largest distance of a facet from its surface
MESH = """
import sys
sys.modules["trimesh"] = None  # which cascadio would import to extend it: four fifths of its time
import cascadio
sys.exit(cascadio.step_to_glb(sys.argv[1], sys.argv[2], {}, {}, True))
"""


def read_step(file: Path) -> MeshFile:
    """Read the solids of a STEP file as meshes, in metres, or in the file's unit where it does not state which that is.

    Single precision, by way of glTF.
    """
    import cascadio  # noqa: F401  # the caller reports its absence; it runs in a process of its own

    refuse_damaged(file)
    with tempfile.TemporaryDirectory() as folder:
        glb = Path(folder) / "meshed.glb"
        failed = run_in_subprocess(
            MESH.format(LINEAR_DEFLECTION, ANGULAR_DEFLECTION), file, str(glb), name="Open CASCADE"
        )
        if failed or not glb.is_file():
            raise ValueError("Open CASCADE finds no shape in it")
        found = replace(read_glb(glb), up="z")
    return found if states_unit(file) else replace(found, mesh=partial(_in_own_unit, found), unit=None)


def _in_own_unit(found: MeshFile, places: Sequence[int]) -> tuple[ElementMesh, ...]:
    """Return the meshes in the numbers of the file, which were taken for millimetres and converted to metres."""
    return tuple(replace(each, vertices=each.vertices * 1000.0) for each in found.mesh(places))


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


END = b"END-ISO-10303-21;"
NUMBERED = re.compile(rb"^[ \t]*#(\d+)\s*=", re.MULTILINE)
NAMELESS = re.compile(rb"^[ \t]*#(\d+)\s*=\s*(?:\(\s*[^A-Z!\s/(]|\(\s*\()", re.MULTILINE | re.IGNORECASE)


def refuse_damaged(file: Path) -> None:
    """Raise where an exchange file lacks its end, has an entity without a name, or numbers two alike.

    Readers would take a truncated file as complete, one of the two entities at random, and crash on one without a name.

    Raises
    ------
    ValueError : its last keyword is missing, or a number is used twice or for no entity
    """
    content = file.read_bytes()
    if END not in content[-1000:].replace(b" ", b""):
        raise ValueError("it does not end as it must, is it whole?")
    if nameless := NAMELESS.search(content):
        raise ValueError(f"#{nameless[1].decode()} has no name of an entity in it; it is damaged, export it again")
    numbers = NUMBERED.findall(content)
    if len(set(numbers)) < len(numbers):
        number = Counter(numbers).most_common(1)[0][0].decode()
        raise ValueError(f"#{number} is defined twice in it; it is damaged, export it again")
