"""STEP files (ISO 10303-21). The only door to cascadio, which meshes them with Open CASCADE."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

from assess.geometry.formats.by_trimesh import read_glb
from assess.geometry.formats.part21 import refuse_cut_short
from assess.geometry.formats.parts import MeshFile

ANGULAR = 0.05  # rad: largest turn between neighbouring facets; a circle's area is then 0.04 % small
LINEAR = 0.01  # of an edge's length: largest distance of a facet from its surface
MESH = "import sys, cascadio; sys.exit(cascadio.step_to_glb(sys.argv[1], sys.argv[2], {}, {}, True))"
LEAST, SPEED = 15.0, 20e3  # s that any file may take, and bytes to a further second


def read_step(file: Path) -> MeshFile:
    """The solids of a STEP file as meshes, in metres whatever the file's unit; single precision, by way of glTF."""
    import cascadio  # noqa: F401  # absent: told by the caller; it runs in a process of its own

    refuse_cut_short(file)
    with tempfile.TemporaryDirectory() as folder:
        glb = Path(folder) / "meshed.glb"
        _mesh(file, glb)
        return replace(read_glb(glb), up="z")


def _mesh(file: Path, glb: Path) -> None:
    """Have Open CASCADE mesh `file` in a process of its own: it crashes or never ends on some damaged files.

    Raises
    ------
    ValueError : it crashed, took too long, or found no shape
    """
    allowed = LEAST + file.stat().st_size / SPEED
    command = [sys.executable, "-c", MESH.format(LINEAR, ANGULAR), str(file.absolute()), str(glb)]
    try:
        ended = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=allowed, check=False)
    except subprocess.TimeoutExpired:
        raise ValueError(
            f"Open CASCADE has not meshed it after {allowed:.0f} s; is it damaged? save it again"
        ) from None
    if ended.returncode < 0:
        raise ValueError("Open CASCADE crashed on it; it is damaged, save it again")
    if ended.returncode or not glb.is_file():
        raise ValueError("Open CASCADE finds no shape in it")
