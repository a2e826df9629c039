"""From a mesh file of 20 thousand to a million triangles to its oscillator: seconds of each stage.

Run as a script. A wall as CAD programs mesh it, and a tower with the rough skin of a scan, whose outline is the costly
part; both as binary STL. The last column is the time together over that of `trimesh.load` for the same file; for a wall
of a million triangles at most half is wanted.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import trimesh

from assess.geometry.mesh import load_solid
from assess.geometry.planar import planar_body
from assess.mechanisms.single_block import single_block

Grid = tuple[np.ndarray, np.ndarray]  # vertices [n, 3], triangles [m, 3]


def tube(ring: np.ndarray, rise: np.ndarray) -> Grid:
    """A prism with rows of corners: rings [rows, n, 2] at heights [rows], closed by fans."""
    m, n = ring.shape[:2]
    skin = np.concatenate([ring, np.broadcast_to(rise[:, None, None], (m, n, 1))], axis=2).reshape(-1, 3)
    ends = [[*ring[row].mean(axis=0), rise[row]] for row in (0, -1)]
    i, k = np.meshgrid(np.arange(n), np.arange(m - 1))
    a, b = (k * n + i).ravel(), (k * n + (i + 1) % n).ravel()
    k, q = np.arange(n), (np.arange(n) + 1) % n
    foot = np.column_stack([np.full(n, n * m), q, k])
    head = np.column_stack([np.full(n, n * m + 1), k + (m - 1) * n, q + (m - 1) * n])
    faces = [np.column_stack([a, b, a + n]), np.column_stack([b, b + n, a + n]), foot, head]
    return np.concatenate([skin, ends]), np.concatenate(faces)


def tower(count: int) -> Grid:
    """Round, 8 m high, 3 m thick, with a roughness of 2 mm."""
    m = int(np.sqrt(count / 4.0))
    n = count // (2 * m)
    turn = 2.0 * np.pi * np.arange(n) / n
    radius = 1.5 + 0.002 * np.random.default_rng(4).normal(size=(m, n))
    return tube(radius[:, :, None] * np.column_stack([np.cos(turn), np.sin(turn)]), np.linspace(0.0, 8.0, m))


def wall(count: int) -> Grid:
    """A box of 1.25 x 3 x 8 m."""
    m = int(np.sqrt(count / 4.0))
    side = count // (8 * m)
    s = np.linspace(-1.0, 1.0, side + 1)[:-1]
    round_about = [np.column_stack(each) for each in ((s, -np.ones(side)), (np.ones(side), s))]
    ring = np.concatenate([*round_about, -round_about[0], -round_about[1]]) * [0.625, 1.5]
    return tube(np.broadcast_to(ring, (m, 4 * side, 2)), np.linspace(0.0, 8.0, m))


def stl(vertices: np.ndarray, triangles: np.ndarray) -> bytes:
    """Binary STL."""
    facets = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    facets["corners"] = vertices[triangles]
    return b"bench".ljust(80) + np.uint32(len(facets)).tobytes() + facets.tobytes()


def row(kind: str, make: Callable[[int], Grid], count: int, file: Path) -> str:
    """One line of the table, the best of three."""
    vertices, triangles = make(count)
    file.write_bytes(stl(vertices, triangles))
    best, opened = [np.inf] * 4, np.inf
    for _ in range(3):
        start = time.perf_counter()
        trimesh.load(file)
        opened = min(opened, time.perf_counter() - start)
        times = [time.perf_counter()]
        solid = load_solid(file, density=2000.0, name=kind)
        times.append(time.perf_counter())
        body = planar_body(solid, direction=[0.8, 0.6, 0.0])
        times.append(time.perf_counter())
        _ = single_block(kind, body).oscillator
        times.append(time.perf_counter())
        stages = np.diff(times).tolist()
        best = min(best, [*stages, sum(stages)], key=lambda each: each[-1])
    if solid.history:
        raise RuntimeError(f"a good mesh was changed: {solid.history}")
    return f"{kind:<8}{len(triangles):>10,d}" + "".join(f"{seconds:>12.3f}" for seconds in [*best, best[-1] / opened])


def main() -> None:
    """The table."""
    head = ("load s", "outline s", "mechanism s", "together s", "of trimesh")
    print(f"{'mesh':<8}{'triangles':>10}" + "".join(f"{each:>12}" for each in head))  # noqa: T201
    with tempfile.TemporaryDirectory() as folder:
        for count in (20_000, 1_000_000):
            print(row("wall", wall, count, Path(folder) / "wall.stl"))  # noqa: T201
            print(row("tower", tower, count, Path(folder) / "tower.stl"))  # noqa: T201


if __name__ == "__main__":
    main()
