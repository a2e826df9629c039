"""The walls of the Great House of Casa Grande, made to the rocking parameters of a published table.

Mehrotra, chapter 8, gives p, slenderness and radius of each mechanism (Table 8.2), the elevation of its base
(Table 8.3), walls of 1.25 m average thickness in courses of 0.61-0.76 m, and "substantial section losses at their
bases" of 33-50 %; the shapes stand in figures only. So these are walls of our own: a face with courses and weathering,
an eroded band where the mechanism begins, ends that follow cracks, a broken top. Their sizes are solved so that each
mechanism has the tabled radius, slenderness and p.

      ____----     broken top          the part above a band has its centroid midway between the
     |        |                        edges of the band, R cos(alpha) above it, and
      \\      /                            J / M = g R / p^2 - R^2
       |    |      eroded band,
      /      \\     2 R sin(alpha) wide
     |________|
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import cos, pi, sin

import numpy as np
from scipy.optimize import root

from assess.examples.surfaces import ClosedSurface, slab
from assess.geometry.solid import polyhedron
from spectra.arrays import FloatArray
from spectra.gravity import g

COURSE = 0.69  # m: average height of a course of caliche
ROW = 0.115  # m: a sixth of a course between the rows of the mesh
COLUMNS = 13
THICKNESS = 1.25  # m: the average of the house
ROUGHNESS = 0.025  # m: of the faces


@dataclass(frozen=True)
class PublishedBlock:
    """Published rocking parameters: p [1/s], slenderness [rad], radius [m]; elevation of the mechanism's base [m]."""

    p: float
    slenderness: float
    radius: float
    elevation: float = 0.0


@dataclass(frozen=True)
class ErodedBand:
    """Eroded band: the wall is narrowest at `elevation`, `width` across about x = `centre`; it ends at `reach` [m]."""

    elevation: float
    width: float
    centre: float
    reach: float


@dataclass(frozen=True)
class ErodedWall:
    """Length at each of some elevations, the last the top; thickness between bands; lean and break of the top [m].

    seed : turns the weathering, so that no two walls look alike [rad]
    """

    elevations: tuple[float, ...]
    lengths: tuple[float, ...]
    thickness: float
    bands: tuple[ErodedBand, ...]
    lean: float
    broken: float
    seed: float


TABLE = {  # Tables 8.2 and 8.3
    "W0a": PublishedBlock(1.60, 0.14, 2.84),
    "W0b": PublishedBlock(3.36, 0.54, 0.62, 4.98),
    "W1": PublishedBlock(2.15, 0.25, 1.75, 3.11),
    "W2": PublishedBlock(1.60, 0.23, 2.88),
    "W3": PublishedBlock(1.62, 0.20, 2.71),
    "W4": PublishedBlock(2.67, 0.34, 1.04, 3.76),
    "W5": PublishedBlock(1.63, 0.24, 2.72),
    "W6": PublishedBlock(2.26, 0.21, 1.46, 4.77),
}


def surface(wall: ErodedWall, *, above: float = 0.0) -> ClosedSurface:
    """Return the wall from the elevation `above` [m], the ground or a band, to its top."""
    rows = _rows(wall)
    rows = rows[rows >= above]
    along = np.linspace(-0.5, 0.5, COLUMNS)
    z = rows[:, None] - _lost(wall, rows)[:, None] * (0.5 + along) ** 2
    y = along * np.interp(rows, wall.elevations, wall.lengths)[:, None]
    y = y + 0.05 * np.sin(2.3 * rows + wall.seed)[:, None] * (2.0 * along) ** 3
    front, back = _faces(wall, rows[:, None], y)
    return slab(np.stack([front, y, z], -1), np.stack([back, y, z], -1))


def _rows(wall: ErodedWall) -> FloatArray:
    """Return the elevations of the rows of the mesh; bands and corners of the elevation lie on a row each [m]."""
    fixed = sorted({*wall.elevations, *(band.elevation for band in wall.bands)})
    pieces = [
        np.linspace(low, high, max(3, round((high - low) / ROW)), endpoint=False) for low, high in pairwise(fixed)
    ]
    return np.concatenate([*pieces, fixed[-1:]])


def _lost(wall: ErodedWall, rows: FloatArray) -> FloatArray:
    """Return what the broken top has lost at its lower end, none at the last band [m]."""
    start = wall.bands[-1].elevation
    return wall.broken * np.clip((rows - start) / (wall.elevations[-1] - start), 0.0, 1.0) ** 2


def _faces(wall: ErodedWall, z: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return x of the front and back face at elevation z and position y along the wall [m]."""
    middle = wall.lean * z / wall.elevations[-1]
    half, weathering = np.full_like(z, wall.thickness / 2.0), np.full_like(z, ROUGHNESS)
    for band in wall.bands:
        eroded = np.clip(1.0 - np.abs(z - band.elevation) / band.reach, 0.0, 1.0) ** 2
        middle = middle + eroded * (band.centre - wall.lean * band.elevation / wall.elevations[-1])
        half = half + eroded * (band.width - wall.thickness) / 2.0
        weathering = weathering * (1.0 - eroded)
    front = middle + half + weathering * _weather(y, z, wall.seed)
    return front, middle - half - weathering * _weather(y, z, wall.seed + 2.0)


def _weather(y: FloatArray, z: FloatArray, seed: float) -> FloatArray:
    """Return the weathering: rounded courses and gullies of several sizes, of the order of 1 [-]."""
    courses = np.abs(np.sin(pi * z / COURSE)) ** 0.5 - 0.7
    gullies = np.sin(3.1 * y + 1.7 * z + seed) + 0.7 * np.sin(5.3 * y - 2.9 * z + 3.0 * seed)
    return np.asarray(courses + 0.6 * gullies + 0.4 * np.sin(9.7 * y + 7.9 * z + 5.0 * seed), dtype=np.float64)


def misfit(wall: ErodedWall, targets: Sequence[PublishedBlock]) -> FloatArray:
    """Return how far the part above each band is from its target.

    Centroid by R, and J / M by R^2 [3 per target] [-].
    """
    differences: list[float] = []
    for band, target in zip(wall.bands, targets, strict=True):
        part = surface(wall, above=band.elevation)
        solid = polyhedron(part.points, part.triangles, density=1.0, name="wall")
        R = target.radius
        differences += [
            (solid.centroid[0] - band.centre) / R,
            (solid.centroid[2] - band.elevation) / R - cos(target.slenderness),
            solid.inertia[1, 1] / (solid.mass * R**2) - (g / (target.p**2 * R) - 1.0),
        ]
    return np.array(differences)


def solve(
    form: Callable[[FloatArray], ErodedWall], guess: Sequence[float], targets: Sequence[PublishedBlock]
) -> ErodedWall:
    """Find the wall of a `form` whose free sizes meet the targets."""

    def distance(sizes: FloatArray) -> FloatArray:
        return misfit(form(sizes), targets)

    found = root(distance, guess, tol=1e-13)
    return form(found.x)


def _band(target: PublishedBlock, centre: float, reach: float) -> ErodedBand:
    return ErodedBand(target.elevation, 2.0 * target.radius * sin(target.slenderness), centre, reach)


def wall_on(
    target: PublishedBlock,
    *,
    length: float,
    reach: float,
    lean: float,
    broken: float,
    seed: float,
    thickness: float = THICKNESS,
) -> ErodedWall:
    """Solve for a wall with one band, `length` long on average above it [m]: height, flare and centre of the band."""

    def form(sizes: FloatArray) -> ErodedWall:
        centre, height, flare = map(float, sizes)
        band = _band(target, centre, reach)
        below = {0.0: length, band.elevation - reach: length} if band.elevation else {}
        above = {band.elevation: length * (1.0 - flare), band.elevation + height: length * (1.0 + flare)}
        lengths = below | above
        return ErodedWall(tuple(lengths), tuple(lengths.values()), thickness, (band,), lean, broken, seed)

    return solve(form, (0.0, 2.0 * target.radius * cos(target.slenderness), 0.0), (target,))


def wall_0() -> ErodedWall:
    """Solve for the wall of two mechanisms: W0a, the whole, and W0b, its top."""
    whole, top = TABLE["W0a"], TABLE["W0b"]

    def form(sizes: FloatArray) -> ErodedWall:
        foot, neck, height, *lengths = map(float, sizes)
        elevations = (0.0, 2.5, top.elevation, top.elevation + height)
        bands = (_band(whole, foot, 0.6), _band(top, neck, 0.7))
        return ErodedWall(elevations, (2.4, *lengths), 1.0, bands, 0.05, 0.1, 0.0)

    return solve(form, (0.0, 0.0, 0.95, 2.2, 1.8, 1.4), (whole, top))


def walls() -> dict[str, ErodedWall]:
    """Return the seven walls."""
    return {
        "wall_0": wall_0(),
        "wall_1": wall_on(TABLE["W1"], length=2.4, reach=0.9, lean=0.05, broken=0.3, seed=1.0),
        "wall_2": wall_on(TABLE["W2"], length=3.2, reach=0.35, lean=0.06, broken=0.4, seed=2.0, thickness=1.36),
        "wall_3": wall_on(TABLE["W3"], length=2.8, reach=0.6, lean=-0.08, broken=0.5, seed=3.0),
        "wall_4": wall_on(TABLE["W4"], length=2.2, reach=0.4, lean=0.04, broken=0.15, seed=4.0),
        "wall_5": wall_on(TABLE["W5"], length=3.0, reach=0.35, lean=0.10, broken=0.5, seed=5.0, thickness=1.36),
        "wall_6": wall_on(TABLE["W6"], length=2.6, reach=0.5, lean=0.05, broken=0.3, seed=6.0),
    }


def meshes() -> dict[str, ClosedSurface]:
    """Return the walls' surfaces, by the file that the project names."""
    return {f"walls/{name}.ply": surface(wall) for name, wall in walls().items()}
