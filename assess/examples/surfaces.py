"""Closed triangle surfaces: how the examples' bodies are made and written, and the bodies of three examples."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt, tan

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray, IntArray
from spectra.gravity import g


@dataclass(frozen=True)
class ClosedSurface:
    """A closed surface: points [n, 3] [m]; triangles of them, anticlockwise seen from outside [m, 3]."""

    points: FloatArray
    triangles: IntArray


def slab(front: ArrayLike, back: ArrayLike) -> ClosedSurface:
    """Return the body between two faces, each a grid of rows from bottom to top and columns along y.

    front, back : [rows, columns, 3] [m]; front is the face at larger x, the bottom and the top row close the body.
    """
    faces = np.concatenate([np.asarray(front), np.asarray(back)[:, ::-1]], axis=1)
    rows, around, _ = faces.shape
    ring = np.arange(around)
    rings = ring + around * np.arange(rows)[:, None]
    j = np.arange(around // 2 - 1)
    bottom = _split_quadrangles(around - 1 - j, around - 2 - j, j + 1, j)
    top = _split_quadrangles(j, j + 1, around - 2 - j, around - 1 - j) + around * (rows - 1)
    sides = _split_quadrangles(rings[:-1], np.roll(rings, -1, axis=1)[:-1], np.roll(rings, -1, axis=1)[1:], rings[1:])
    return ClosedSurface(faces.reshape(-1, 3), np.concatenate([sides, bottom, top]))


def revolve(profile: ArrayLike, *, faces: int) -> ClosedSurface:
    """Revolve a polygon of (radius, elevation) about the vertical axis, as a prism of so many `faces`.

    Faces touch the circles, an even number of them: the middles of two are at x = -r and x = r, and a section has the
    area n tan(pi / n) r^2.

    profile : corners anticlockwise, the first not repeated [k, 2] [m]; those of radius 0 lie on the axis
    """
    radius, elevation = np.asarray(profile, dtype=np.float64).T
    step = 2.0 * np.pi / faces
    angle = (np.arange(faces) + 0.5) * step
    x, y = radius[:, None] / np.cos(step / 2.0) * np.stack([np.cos(angle), np.sin(angle)])[:, None]
    points = np.stack([x, y, np.broadcast_to(elevation[:, None], x.shape)], -1)
    number = np.arange(len(radius) * faces).reshape(len(radius), faces)
    number[radius == 0.0] = number[radius == 0.0, :1]
    turned, raised = np.roll(number, -1, axis=1), np.roll(number, -1, axis=0)
    return _drop_degenerate(
        points.reshape(-1, 3), _split_quadrangles(number, turned, np.roll(raised, -1, axis=1), raised)
    )


def ply(surface: ClosedSurface) -> bytes:
    """Write the surface as a PLY file (binary, double precision), the same bytes on every machine."""
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment metres\n"
        f"element vertex {len(surface.points)}\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face {len(surface.triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(len(surface.triangles), dtype=[("corners", "u1"), ("index", "<i4", 3)])
    faces["corners"], faces["index"] = 3, surface.triangles
    return header.encode("ascii") + surface.points.astype("<f8").tobytes() + faces.tobytes()


def _split_quadrangles(a: IntArray, b: IntArray, c: IntArray, d: IntArray) -> IntArray:
    """Split each quadrangle a, b, c, d into two triangles."""
    return np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], -2).reshape(-1, 3)


def _drop_degenerate(points: FloatArray, triangles: IntArray) -> ClosedSurface:
    """Drop degenerate triangles and unused points."""
    a, b, c = triangles.T
    whole = triangles[(a != b) & (b != c) & (c != a)]
    used, numbers = np.unique(whole, return_inverse=True)
    return ClosedSurface(points[used], numbers.reshape(whole.shape))


FACADE_OUTSIDE, FACADE_INSIDE = -16.8, -16.0  # m, along the nave: its two faces
FACADE_HALF_WIDTH, FACADE_EAVES, FACADE_RIDGE = 5.0, 7.5, 10.5  # m


def facade_meshes() -> dict[str, ClosedSurface]:
    """Return the façade of `chiesa`, a wall with a gable of our own making, by its path in the folder."""
    return {"facade.ply": slab(_facade_face(FACADE_INSIDE), _facade_face(FACADE_OUTSIDE))}


def _facade_face(y: float) -> FloatArray:
    """Return a face of the façade, from the foot to the edge of the roof, three points in each row."""
    across = np.array([FACADE_HALF_WIDTH, 0.0, -FACADE_HALF_WIDTH])
    foot, roof = np.zeros(3), np.array([FACADE_EAVES, FACADE_RIDGE, FACADE_EAVES])
    return np.stack([np.column_stack([across, np.full(3, y), row]) for row in (foot, roof)])


RING_OUTER, RING_INNER = 3.99, 2.12  # m: radii of the ring at the foot, Table 7.1
TOWER_WEIGHT = 24003.94e3  # N: Table 7.1
TOWER_DENSITY = 2000.0  # kg/m3: brick, Table 4.5
TOWER_LAYERS, TOWER_LAYER = 20, 3.0  # -, m: section 4.3.2
TOWER_FACES = 24  # of the prism that stands for the round tower
TOWER_HEIGHT = TOWER_LAYERS * TOWER_LAYER
SHAFT_AREA = TOWER_WEIGHT / (g * TOWER_DENSITY * TOWER_HEIGHT)  # m2: of the shaft's section, on average
PRISM_AREA_FACTOR = TOWER_FACES * tan(pi / TOWER_FACES)  # area of the prism's section over r^2, in place of pi


def tower_meshes() -> dict[str, ClosedSurface]:
    """Return two readings of the Dharahara tower, Kathmandu, by the file that the project names.

    Mehrotra gives the ring at the foot of the shaft and the tower's weight (Table 7.1), twenty layers of 3.0 m of which
    the shaft was built in a discrete-element model, its "tapering form", and the density (section 4.3.2). The shape
    stands in figures only. What is left open, how the ring becomes the shaft, is closed by the weight, in two ways:

    - `tapered_tower`: the ring shrinks evenly with height, its outline and its hole alike;
    - `prismatic_tower`: the outer radius stays, the wall is even and thinner than the ring at the foot.
    """
    return {"tower/tapered.ply": tapered_tower(), "tower/even.ply": prismatic_tower()}


def tapered_tower() -> ClosedSurface:
    """Return a tower whose section shrinks evenly with height.

    The ring times a factor that falls evenly from 1 at the foot to q at the top: mean area A (1 + q + q^2) / 3.
    """
    foot = PRISM_AREA_FACTOR * (RING_OUTER**2 - RING_INNER**2)
    q = (sqrt(12.0 * SHAFT_AREA / foot - 3.0) - 1.0) / 2.0
    return _tower_shell(
        np.linspace(RING_OUTER, q * RING_OUTER, TOWER_LAYERS + 1),
        np.linspace(RING_INNER, q * RING_INNER, TOWER_LAYERS + 1),
    )


def prismatic_tower() -> ClosedSurface:
    """Return a tower of constant section: a pipe of the outer radius."""
    inner = sqrt(RING_OUTER**2 - SHAFT_AREA / PRISM_AREA_FACTOR)
    return _tower_shell(np.full(TOWER_LAYERS + 1, RING_OUTER), np.full(TOWER_LAYERS + 1, inner))


def _tower_shell(outer: FloatArray, inner: FloatArray) -> ClosedSurface:
    """Return the shell between two radii at the joints of the layers [LAYERS + 1] [m]."""
    z = np.linspace(0.0, TOWER_HEIGHT, TOWER_LAYERS + 1)
    return revolve([*zip(outer, z, strict=True), *zip(inner[::-1], z[::-1], strict=True)], faces=TOWER_FACES)


SPIRE_FOOT, SPIRE_HEIGHT = 18.25, 4.0  # m: Table 5.1
SPIRE_RADIUS, SPIRE_WALL = 0.76, 0.23  # m: radius of the foot, and level thickness of the wall
SPIRE_FACES = 24
SPIRE_ROWS = 13


def spire_meshes() -> dict[str, ClosedSurface]:
    """Return the spire of San Leonardo Limosino, a hollow cone, by the file that the project names.

    Mehrotra, Table 5.1, gives p and slenderness of what a crack leaves of the spire, for cracks that start at a depth
    h_c below the tip and rise at an angle beta; the elevation of the start is h. All h + h_c are 22.25 m and h_c = H is
    at 18.25 m, so the spire is H = 4.0 m high. Its width stands in a figure only. Radius and wall are those of the cone
    that fits the table best: 0.76 m and 0.23 m, two numbers found from twelve by least squares of their relative
    distances.
    """
    return {"spire.ply": spire()}


def spire(*, radius: float = SPIRE_RADIUS, wall: float = SPIRE_WALL) -> ClosedSurface:
    """Return a cone of `radius` at its foot, hollow but for a wall of horizontal thickness `wall` [m]."""
    outer, inner = np.linspace(radius, 0.0, SPIRE_ROWS), np.linspace(0.0, radius - wall, SPIRE_ROWS)
    hollow = SPIRE_HEIGHT * (1.0 - wall / radius)
    up, down = np.linspace(0.0, SPIRE_HEIGHT, SPIRE_ROWS), np.linspace(hollow, 0.0, SPIRE_ROWS)
    return revolve(
        [*zip(outer, SPIRE_FOOT + up, strict=True), *zip(inner, SPIRE_FOOT + down, strict=True)], faces=SPIRE_FACES
    )
