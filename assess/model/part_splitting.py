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
from assess.model.part_kinds import first_kind, reason_to_leave_out
from assess.model.part_shapes import SLENDER, Region, Shape, core_of, shape_of
from assess.model.structure import LeftOut, PartKind
from spectra.arrays import FloatArray

UPRIGHT = 0.26  # vertical part of a normal: steeper faces are those of walls
SAME_WAY, SAME_PLANE = 0.985, 0.08  # cosine, and m: triangles nearer one another are of one face
LEAST_FACE, LEAST_PAIR = 0.3, 0.5  # m2
WALL = (0.1, 2.5)  # m: thickness
CORNER = 1.5  # m: by which one face of a wall passes the other at a corner, at most
FILM, SLIVER = 0.002, 0.005  # m: by which a cut passes the face it follows; what is thinner is no masonry
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
    faces = _faces_of(body.solid)
    if (curved := _curved_wall(body, shape, faces)) is not None:
        return [curved], []
    rest: Solid | None = body.solid
    pieces: list[Piece] = []
    left_out: list[LeftOut] = []
    for box in _walls_between(faces):
        cut = None if rest is None else common_part(rest, box, film=SLIVER)
        walls = [each for each in _separate(cut, body) if each[1].kind == "upright"] if cut is not None else []
        for wall in walls:
            pieces.append(wall)
            rest = None if rest is None else subtract(rest, [wall[0].solid], film=SLIVER)
    if not pieces:
        return [], [leave_out(body, note("left-out-unknown"), told=False)]
    unknown = note("left-out-unknown")
    for each in _separate(rest, body) if rest is not None else ():
        kind = first_kind(body.element, each[1])
        reason = unknown if kind is None or each[1].kind == "bar" else None
        reason = reason or reason_to_leave_out(body.element, each[1])
        if reason is not None or kind is None:
            left_out.append(leave_out(each[0], reason or unknown, told=reason not in (None, unknown)))
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
        piece = _without_slivers(piece, shape_of(piece))
        shape = shape_of(piece)
        yield replace(body, solid=piece), shape, first_kind(body.element, shape) or "wall"


def _without_slivers(piece: Solid, shape: Shape) -> Solid:
    """Return a piece cut to its extent without the slivers that other cuts left on it."""
    low, high = core_of(piece, shape)
    if not (np.isfinite([low, high]).all() and (high > low).all()):
        return piece
    normal = np.array(shape.normal)
    front = _Face(normal, high[0] * normal, shapely.Point(), 0.0)
    kept = common_part(piece, _box(front, high[0] - low[0], along=(low[1], high[1]), up=(low[2], high[2])))
    return kept or piece


@dataclass(frozen=True)
class _Face:
    """A plane upright face: unit normal, a point of it, its region along it and up, and how uneven it is [m]."""

    normal: FloatArray
    point: FloatArray
    region: Region
    uneven: float


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
            faces.append(_Face(n, point, region, float(np.abs((corners[own] - point) @ n).max())))
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
                pairs.append((round(distance, 1), -shared.area, distance + other.uneven, one, facing, shared))
    for _, _, depth, one, facing, shared in sorted(pairs, key=lambda pair: pair[:2]):
        low, base, high, top = shared.bounds
        start, _, end, _ = shapely.union(one.region, facing).bounds
        low, high = max(start, low - CORNER), min(end, high + CORNER)
        yield _box(one, depth, along=(low, high), up=(base, top))


def _box(face: _Face, depth: float, *, along: tuple[float, float], up: tuple[float, float]) -> Solid:
    """Return the box behind a face to a depth, a little larger, so that no film of the body is left."""
    n, side = face.normal, np.array([-face.normal[1], face.normal[0], 0.0])
    front = float(face.point @ n)
    corners = [
        across * n + a * side + np.array([0.0, 0.0, z])
        for z in (up[0] - FILM, up[1] + FILM)
        for across, a in (
            (front - depth - FILM, along[0] - FILM),
            (front + face.uneven + FILM, along[0] - FILM),
            (front + face.uneven + FILM, along[1] + FILM),
            (front - depth - FILM, along[1] + FILM),
        )
    ]
    quads = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return polyhedron(np.array(corners), triangles, density=1.0, name="")


THIN = 0.25  # of its width in plan: a wall that bends is thinner
FACET = 1.0  # m: wider faces are those of straight walls
MOSTLY_UPRIGHT = 0.75  # of its surface


def _curved_wall(body: DrawnBody, shape: Shape, faces: Sequence[_Face]) -> Piece | None:
    """Return a wall that bends in plan as one part, facing its convex side, and a full ring as a tower; else None.

    faces : the upright plane faces of the body; of a wall that bends they are narrow
    """
    vertices, triangles = body.solid.vertices, body.solid.triangles
    area, normal = areas_and_normals(vertices[triangles])
    upright = np.abs(normal[:, 2]) < UPRIGHT
    thickness = 2.0 * volume(vertices, triangles) / float(area[upright].sum() or np.inf)
    thin = WALL[0] <= thickness <= min(WALL[1], THIN * shape.width) and shape.height > 2.0 * thickness
    if not thin or area[upright].sum() < MOSTLY_UPRIGHT * area.sum():
        return None
    apart = [part for face in faces for part in shapely.get_parts(face.region)]  # its two ends lie in one plane
    widths = [(part.area, part.bounds[2] - part.bounds[0]) for part in apart]
    if widths and np.average([w for _, w in widths], weights=[a for a, _ in widths]) > max(FACET, SLENDER * thickness):
        return None
    middle = shapely.get_coordinates(shapely.MultiPoint(vertices[:, :2]).convex_hull.centroid)[0]
    away = body.solid.centroid[:2] - middle
    if np.hypot(*away) <= thickness / 4.0:
        return body, replace(shape, kind="shaft", thickness=shape.width, hollow=True), "tower"
    x, y = (away / np.hypot(*away)).tolist()
    length = float(np.ptp(vertices[:, :2] @ np.array([-y, x])))
    turned = replace(shape, normal=(x, y, 0.0), along=(-y, x, 0.0), length=length)
    return body, replace(turned, kind="upright", thickness=thickness), "wall"
