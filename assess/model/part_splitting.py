"""One closed body that holds several parts, split into them: walls between opposite upright faces, then what is left.

A house drawn as one body, or a church of one surface, has no parts of its own. Each pair of faces that look away from
each other, no farther apart than a wall is thick, bounds one wall; a corner goes to the wall with the thinner pair, or
the larger. What walls leave over, as floors, is told by its shape.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from assess.geometry.boolean import common_part, subtract
from assess.geometry.shells import separate_shells
from assess.geometry.solid import Solid, polyhedron
from assess.geometry.surface import areas_and_normals, volume
from assess.messages.message import note
from assess.model.part_bodies import DrawnBody, leave_out
from assess.model.part_kinds import first_kind
from assess.model.part_shapes import Region, Shape, shape_of
from assess.model.structure import LeftOut, PartKind
from spectra.arrays import FloatArray

UPRIGHT = 0.26  # vertical part of a normal: steeper faces are those of walls
SAME_WAY, SAME_PLANE = 0.985, 0.08  # cosine, and m: triangles nearer one another are of one face
LEAST_FACE, LEAST_PAIR = 0.3, 0.5  # m2
WALL = (0.1, 2.5)  # m: thickness
CORNER = 1.5  # m: by which the outer face of a wall passes its inner one, at most
LEAST_PIECE = 0.05  # m3: smaller ones are mouldings
LARGEST_FACES = 200  # faces that are looked at, the largest first

Piece = tuple[DrawnBody, Shape, PartKind]


def split_body(body: DrawnBody, shape: Shape) -> tuple[list[Piece], list[LeftOut]]:
    """Split a body into parts; what cannot be told is left out.

    Parameters
    ----------
    body : that is none by itself
    shape : of it
    """
    rest: Solid | None = body.solid
    pieces: list[Piece] = []
    left_out: list[LeftOut] = []
    for box in _walls_between(_faces_of(body.solid)):
        cut = None if rest is None else common_part(rest, box)
        walls = [each for each in _separate(cut, body) if each[1].kind == "upright"] if cut is not None else []
        for wall in walls:
            pieces.append(wall)
            rest = None if rest is None else subtract(rest, [wall[0].solid])
    if not pieces and (curved := _curved_wall(body, shape)) is not None:
        return [curved], []
    if not pieces:
        return [], [leave_out(body, note("left-out-unknown"))]
    for each in _separate(rest, body) if rest is not None else ():
        kind = first_kind(body.element, each[1])
        if kind is None or (each[1].kind == "bar"):
            left_out.append(leave_out(each[0], note("left-out-unknown")))
        else:
            pieces.append((each[0], each[1], kind))
    return pieces, left_out


def _separate(solid: Solid | None, body: DrawnBody) -> Iterator[Piece]:
    """Return the pieces of a cut that hang together, with their shapes; splinters are dropped."""
    if solid is None:
        return
    for vertices, triangles in separate_shells((solid.vertices, solid.triangles)):
        used, index = np.unique(triangles, return_inverse=True)
        if volume(vertices, triangles) < LEAST_PIECE:
            continue
        piece = polyhedron(vertices[used], index.reshape(-1, 3), density=1.0, name=body.name)
        shape = shape_of(piece)
        yield replace(body, solid=piece), shape, first_kind(body.element, shape) or "wall"


@dataclass(frozen=True)
class _Face:
    """A plane upright face: unit normal, a point of it, and its region along it and up."""

    normal: FloatArray
    point: FloatArray
    region: Region


def _faces_of(solid: Solid) -> list[_Face]:
    """Return the upright plane faces of a body, the largest first."""
    corners = solid.vertices[solid.triangles]
    area, normal = areas_and_normals(corners)
    centre = corners.mean(axis=1)
    left = (np.abs(normal[:, 2]) < UPRIGHT) & (area > 0.0)
    faces: list[_Face] = []
    while left.any() and len(faces) < LARGEST_FACES:
        first = int(np.argmax(np.where(left, area, 0.0)))
        n = normal[first] * [1.0, 1.0, 0.0]
        n = n / np.linalg.norm(n)
        own = left & (normal @ n > SAME_WAY) & (np.abs((centre - centre[first]) @ n) < SAME_PLANE)
        own[first] = True
        left &= ~own
        if area[own].sum() >= LEAST_FACE:
            frame = np.array([[-n[1], n[0], 0.0], [0.0, 0.0, 1.0]]).T
            region = shapely.union_all(shapely.polygons(corners[own] @ frame), grid_size=1e-6)
            point = np.average(centre[own], axis=0, weights=area[own])
            faces.append(_Face(n, point, region))
    return faces


def _walls_between(faces: Sequence[_Face]) -> Iterator[Solid]:
    """Return the box between each pair of faces that bound a wall, the thinner and then the larger first."""
    pairs = []
    for one in faces:
        for other in faces:
            distance = float((one.point - other.point) @ one.normal)
            if one.normal @ other.normal > -SAME_WAY or not WALL[0] <= distance <= WALL[1]:
                continue
            facing = shapely.transform(other.region, lambda at: at * [-1.0, 1.0])  # along it, seen from the other side
            shared: Region = shapely.intersection(one.region, facing)
            if shared.area >= LEAST_PAIR and one.region.area >= other.region.area - 1e-9:
                pairs.append((round(distance, 1), -shared.area, distance, one, shared))
    for _, _, distance, one, shared in sorted(pairs, key=lambda pair: pair[:2]):
        low, base, high, top = shared.bounds
        start, bottom, end, crest = one.region.bounds
        low, high = max(start, low - CORNER), min(end, high + CORNER)
        yield _box(one, distance, along=(low, high), up=(max(bottom, base - CORNER), min(crest, top + CORNER)))


def _box(face: _Face, depth: float, *, along: tuple[float, float], up: tuple[float, float]) -> Solid:
    """Return the box behind a face to a depth, a little larger, so that no film of the body is left."""
    more = SAME_PLANE / 2.0
    n, side = face.normal, np.array([-face.normal[1], face.normal[0], 0.0])
    front = float(face.point @ n)
    corners = [
        across * n + a * side + np.array([0.0, 0.0, z])
        for z in (up[0] - more, up[1] + more)
        for across, a in (
            (front - depth - more, along[0] - more),
            (front + more, along[0] - more),
            (front + more, along[1] + more),
            (front - depth - more, along[1] + more),
        )
    ]
    quads = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return polyhedron(np.array(corners), triangles, density=1.0, name="")


THIN = 0.25  # of its width in plan: a wall that bends is thinner
MOSTLY_UPRIGHT = 0.75  # of its surface


def _curved_wall(body: DrawnBody, shape: Shape) -> Piece | None:
    """Return a wall that bends in plan as one part, facing its convex side; None where the body is none."""
    vertices, triangles = body.solid.vertices, body.solid.triangles
    area, normal = areas_and_normals(vertices[triangles])
    upright = np.abs(normal[:, 2]) < UPRIGHT
    thickness = 2.0 * volume(vertices, triangles) / float(area[upright].sum() or np.inf)
    thin = WALL[0] <= thickness <= min(WALL[1], THIN * shape.width) and shape.height > 2.0 * thickness
    if not thin or area[upright].sum() < MOSTLY_UPRIGHT * area.sum():
        return None
    middle = shapely.get_coordinates(shapely.MultiPoint(vertices[:, :2]).convex_hull.centroid)[0]
    away = body.solid.centroid[:2] - middle
    if np.hypot(*away) > thickness / 4.0:
        x, y = (away / np.hypot(*away)).tolist()
        along = np.array([-y, x])
        length = float(np.ptp(vertices[:, :2] @ along))
        shape = replace(shape, normal=(x, y, 0.0), along=(-y, x, 0.0), length=length)
    return body, replace(shape, kind="upright", thickness=thickness), "wall"
