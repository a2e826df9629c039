"""STEP files (ISO 10303-21). The only door to cascadio, which meshes them with Open CASCADE."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from assess.geometry.formats.apart import run_apart
from assess.geometry.formats.by_trimesh import read_glb
from assess.geometry.formats.part21 import refuse_damaged
from assess.geometry.formats.parts import MeshFile

ANGULAR = 0.05  # rad: largest turn between neighbouring facets; a circle's area is then 0.04 % small
LINEAR = 0.01  # of an edge's length: largest distance of a facet from its surface
MESH = "import sys, cascadio; sys.exit(cascadio.step_to_glb(sys.argv[1], sys.argv[2], {}, {}, True))"


def read_step(file: Path) -> MeshFile:
    """The solids of a STEP file as meshes, in metres whatever the file's unit; single precision, by way of glTF."""
    import cascadio  # noqa: F401  # absent: told by the caller; it runs in a process of its own

    refuse_damaged(file)
    with tempfile.TemporaryDirectory() as folder:
        glb = Path(folder) / "meshed.glb"
        failed = run_apart(MESH.format(LINEAR, ANGULAR), file, str(glb), name="Open CASCADE")
        if failed or not glb.is_file():
            raise ValueError("Open CASCADE finds no shape in it")
        return replace(read_glb(glb), up="z")
