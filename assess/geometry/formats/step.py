"""STEP files (ISO 10303-21), meshed with Open CASCADE by cascadio; the only door to it."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from assess.geometry.formats.gltf import read_glb
from assess.geometry.formats.mesh_file import MeshFile, Part
from assess.geometry.formats.part21 import refuse_damaged
from assess.geometry.formats.step_units import states_unit
from assess.geometry.formats.subprocess_reader import run_in_subprocess

ANGULAR_DEFLECTION = 0.05  # rad: largest turn between neighbouring facets; a circle's area is then 0.04 % small
LINEAR_DEFLECTION = 0.01  # of an edge's length: largest distance of a facet from its surface
MESH = "import sys, cascadio; sys.exit(cascadio.step_to_glb(sys.argv[1], sys.argv[2], {}, {}, True))"


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


def _in_own_unit(found: MeshFile, places: Sequence[int]) -> tuple[Part, ...]:
    """Return the parts in the numbers of the file, which were taken for millimetres and converted to metres."""
    return tuple(replace(each, vertices=each.vertices * 1000.0) for each in found.mesh(places))
