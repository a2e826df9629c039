"""Models up to an oscillator: the program beside `trimesh.load`, which only opens the file."""

from __future__ import annotations

import tempfile
from functools import partial
from pathlib import Path

from assess.geometry.mesh import load_solid
from assess.geometry.planar import planar_body
from assess.mechanisms.single_block import single_block
from tools.benchmarks.bench_mesh import stl, wall
from tools.benchmarks.peers.installed import Peer
from tools.benchmarks.peers.measure import Program, Table, least, measure, off, order

VOLUME, DENSITY = 1.25 * 3.0 * 8.0, 2000.0


def oscillator_volume(file: Path) -> float:
    """Load, check and close the mesh, outline it and make its mechanism; return the volume [m3] that rocks."""
    body = planar_body(load_solid(file, density=DENSITY, name="wall"), direction=[0.8, 0.6, 0.0])
    _ = single_block("wall", body).oscillator
    return body.mass / DENSITY


def table(trimesh: Peer, *, rounds: int, seconds: float, triangles: int) -> Table:
    """Compare on a wall as CAD programs mesh it, as binary STL."""

    def opened(file: Path) -> float:
        return float(trimesh.module.load(file).volume)  # type: ignore[union-attr]

    with tempfile.TemporaryDirectory() as folder:
        sizes = [triangles // 25, triangles // 5, triangles]
        files = [Path(folder) / f"{size}.stl" for size in sizes]
        for file, size in zip(files, sizes, strict=True):
            file.write_bytes(stl(*wall(size)))
        programs = [Program("this program", "load, outline, mechanism", partial(oscillator_volume, files[-1]))]
        if trimesh.module is not None:
            programs.append(Program("trimesh", "load and volume", partial(opened, files[-1])))
        rows = measure(programs, partial(off, VOLUME), rounds=rounds, seconds=seconds)
        works = (oscillator_volume, opened)[: len(programs)]
        grown = [[least(partial(work, file), rounds=2) for file in files] for work in works]
    powers = [order([float(size) for size in sizes], each) for each in grown]
    return Table(
        "A model from its file",
        f"A wall of 1.25 x 3 x 8 m in {triangles:,} triangles of binary STL (single precision). trimesh opens it and "
        "has its volume; this program also checks and closes the surface, takes the outline seen along the wall and "
        "makes the mechanism that rocks.",
        ("error of the volume",),
        rows,
        ("With the number of triangles time grows to the power "
         + ", ".join(f"{power:.2f} ({program.name})" for power, program in zip(powers, programs, strict=True)) + ".",),
    )  # fmt: skip
