"""Contact between a body and a block: on facing surfaces, or where the body is built in (thesis 3.2.2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from assess.geometry.boolean import intersect
from assess.geometry.solid import THINNEST, Solid
from assess.geometry.surface import area_vectors, areas_and_normals
from spectra.arrays import FloatArray, IntArray

CONTACT_TOLERANCE = 0.01  # m: faces this near each other touch; joints are as thick, and drawings no better
PARALLEL = 0.98  # minus the cosine between the normals of two faces: they face each other within 11 degrees
OBLIQUE = 0.5  # the same of faces that meet along an edge: within 60 degrees
STEEP = 0.26  # vertical part of a unit normal: a face within 15 degrees of upright, like a battered wall, bears nothing


@dataclass(frozen=True)
class ContactArea:
    """The area where a body meets a block.

    Attributes
    ----------
    area : of the faces in contact; in plan where the body is built in [m2]
    centroid : of that area [3] [m]
    normal : mean outward unit normal of the block's faces there [3]
    bearing : whether the block carries the body there; otherwise the body only pushes against an upright face
    """

    area: float
    centroid: FloatArray
    normal: FloatArray
    bearing: bool


@dataclass(frozen=True)
class FacePatches:
    """Pieces of faces: area [k] [m2], centroid [k, 3] [m], unit normal [k, 3]."""

    area: FloatArray
    centroid: FloatArray
    normal: FloatArray


def find_contact(block: Solid, body: Solid, *, tolerance: float = CONTACT_TOLERANCE) -> ContactArea | None:
    """Find where a body meets a block; None where it does not, or where it lies under the block and carries it.

    Faces are in contact where they face each other at a distance within the tolerance, whether they are separated by a
    gap or penetrate each other. A body that penetrates the block by more is built in, and bears on its underside. A
    rafter on the edge of a wall meets the wall's top in the strip along that edge where the distance is within the
    tolerance. Where the body bears, only that region counts, since its weight goes there; otherwise the faces it pushes
    against count.

    Parameters
    ----------
    block : the body that may carry
    body : the body that may be carried
    tolerance : on the distance of faces [m]

    Raises
    ------
    GeometryError : the bodies overlap and the surface of one is not that of a solid
    """
    smallest = tolerance**2
    faces = _facing_parts(block, body, tolerance=tolerance, cosine=PARALLEL)
    bears = [_bearing_contact(faces, smallest=smallest), _embedded_contact(block, body, tolerance=tolerance)]
    found = [each for each in bears if each is not None]
    if found:
        return max(found, key=lambda each: each.area)
    edges = _facing_parts(block, body, tolerance=tolerance, cosine=OBLIQUE)
    return (
        _bearing_contact(edges, smallest=smallest)
        or _upright_contact(faces, smallest=smallest)
        or _upright_contact(edges, smallest=smallest)
    )


def facing_patches(block: Solid, body: Solid, *, tolerance: float = CONTACT_TOLERANCE) -> FacePatches:
    """Return the upright parts of a block's faces that a face of a body faces within the tolerance.

    Parameters
    ----------
    block : whose faces are returned
    body : whose faces they may face
    tolerance : on the distance of faces [m]
    """
    faces = _facing_parts(block, body, tolerance=tolerance, cosine=PARALLEL)
    upright = np.abs(faces.normal[:, 2]) < STEEP
    return FacePatches(faces.area[upright], faces.centroid[upright], faces.normal[upright])


def join_contacts(contacts: Sequence[ContactArea]) -> ContactArea | None:
    """Combine the contacts of a body with the parts of one block; None where there are none."""
    bearing = any(each.bearing for each in contacts)
    chosen = [each for each in contacts if each.bearing == bearing]
    if not chosen:
        return None
    patches = FacePatches(
        np.array([each.area for each in chosen]),
        np.array([each.centroid for each in chosen]),
        np.array([each.normal for each in chosen]),
    )
    return _join_patches(patches, np.ones(len(chosen), dtype=np.bool_), bearing=bearing, smallest=0.0)


def _bearing_contact(faces: FacePatches, *, smallest: float) -> ContactArea | None:
    """Return the contact on the block's bearing faces, None if no larger than the smallest area [m2]."""
    return _join_patches(faces, faces.normal[:, 2] >= STEEP, bearing=True, smallest=smallest)


def _upright_contact(faces: FacePatches, *, smallest: float) -> ContactArea | None:
    """Return the contact on the block's upright faces, None if no larger than the smallest area [m2]."""
    return _join_patches(faces, np.abs(faces.normal[:, 2]) < STEEP, bearing=False, smallest=smallest)


def _join_patches(
    patches: FacePatches, which: NDArray[np.bool_], *, bearing: bool, smallest: float
) -> ContactArea | None:
    """Combine the chosen patches into one contact, None if no larger than the smallest area [m2]."""
    A = patches.area[which]
    area = float(A.sum())
    if area <= smallest:
        return None
    centroid, normal = (A @ each[which] / area for each in (patches.centroid, patches.normal))
    return ContactArea(area, centroid, normal / (float(np.linalg.norm(normal)) or 1.0), bearing)


def _facing_parts(block: Solid, body: Solid, *, tolerance: float, cosine: float) -> FacePatches:
    """Return the parts of the block's faces that a face of the body faces within tolerance [m] and cosine."""
    origin = (body.vertices.min(axis=0) + body.vertices.max(axis=0)) / 2.0
    one, other = _triangles_near(block, body, origin=origin, margin=tolerance)
    (one, n), (other, m) = _with_normals(one), _with_normals(other)
    pairs = _pairs(one, n, other, m, margin=tolerance, cosine=cosine)
    found = [_clip_facing(one[i], n[i], other[j], tolerance=tolerance) for i, j in pairs]
    area, centroid, normal = (np.concatenate(each) for each in zip(_EMPTY, *found, strict=True))
    return FacePatches(area, centroid + origin, normal)


_EMPTY = (np.empty(0), np.empty((0, 3)), np.empty((0, 3)))


def _triangles_near(block: Solid, body: Solid, *, origin: FloatArray, margin: float) -> tuple[FloatArray, FloatArray]:
    """Return the triangles [m, 3, 3] of each body inside the bounding box of the other, from the origin."""
    corners = [(solid.vertices - origin)[solid.triangles] for solid in (block, body)]
    chosen = []
    for own, other in (corners, corners[::-1]):
        low, high = other.min(axis=(0, 1)) - margin, other.max(axis=(0, 1)) + margin
        chosen.append(own[np.all((own.max(axis=1) >= low) & (own.min(axis=1) <= high), axis=1)])
    return chosen[0], chosen[1]


def _with_normals(corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the triangles [m, 3, 3] that have an area, and their unit normals [m, 3]."""
    normals = area_vectors(corners)
    length = np.linalg.norm(normals, axis=1)
    sides = np.ptp(corners, axis=1).max(axis=1, initial=0.0)
    real = length > THINNEST * sides**2
    return corners[real], normals[real] / length[real, None]


def _pairs(
    one: FloatArray, n: FloatArray, other: FloatArray, m: FloatArray, *, margin: float, cosine: float
) -> Iterator[tuple[IntArray, IntArray]]:
    """Find the pairs of triangles that face each other and whose bounding boxes meet within the margin [m].

    They are sought in the projection along the axis that the block's face looks along most, where neither is narrow.
    """
    looks = np.abs(n).argmax(axis=1)
    low_b, high_b = other.min(axis=1) - margin, other.max(axis=1) + margin
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        own = np.flatnonzero(looks == axis)
        low, high = one[own].min(axis=1), one[own].max(axis=1)
        tree = shapely.STRtree(shapely.box(low_b[:, u], low_b[:, v], high_b[:, u], high_b[:, v]))
        a, j = tree.query(shapely.box(low[:, u], low[:, v], high[:, u], high[:, v]))
        i = own[a]
        meet = (low[a, axis] <= high_b[j, axis]) & (high[a, axis] >= low_b[j, axis])
        meet &= np.einsum("si,si->s", n[i], m[j]) < -cosine
        yield i[meet], j[meet]


def _clip_facing(
    one: FloatArray, n: FloatArray, other: FloatArray, *, tolerance: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Clip triangles [s, 3, 3] with normals n [s, 3] to what the others face within the tolerance [m].

    Area [k], centroid on the first triangles [k, 3], their normals [k, 3]. The distance of the other triangle is
    linear over the plane of the first, so the tolerance leaves a strip of that plane.
    """
    origin = one[:, 0]
    u = one[:, 1] - origin
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    frame = np.stack([u, np.cross(n, u), n], axis=1)
    own, facing = (np.einsum("sij,skj->ski", frame, each - origin[:, None]) for each in (one, other))
    distance = facing[:, :, 2]
    within = (distance.min(axis=1) <= tolerance) & (distance.max(axis=1) >= -tolerance)
    own, facing, origin, frame, n = own[within], facing[within], origin[within], frame[within], n[within]
    shared = shapely.intersection(shapely.polygons(own[:, :, :2]), shapely.polygons(facing[:, :, :2]))
    leaning = np.flatnonzero(np.abs(facing[:, :, 2]).max(axis=1, initial=0.0) > tolerance)
    shared[leaning] = shapely.intersection(shared[leaning], _strips(facing[leaning], tolerance=tolerance))
    area = shapely.area(shared)
    real = area > 0.0
    at = shapely.get_coordinates(shapely.centroid(shared[real]))
    return area[real], origin[real] + np.einsum("si,sij->sj", at, frame[real, :2]), n[real]


def _strips(corners: FloatArray, *, tolerance: float) -> NDArray[np.object_]:
    """Return the strips of z = 0 within the tolerance of the planes through corners [s, 3, 3]."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normal = np.cross(first, second)
    slope = -normal[:, :2] / normal[:, 2:]  # of the plane
    steepness = np.linalg.norm(slope, axis=1, keepdims=True)
    down = slope / steepness
    level = corners[:, 0, :2] - down * (corners[:, 0, 2:] / steepness)  # where the plane meets z = 0, below a corner
    across = tolerance / steepness * down
    reach = np.abs(corners).max(axis=(1, 2))[:, None] + np.abs(level - corners[:, 0, :2]).max(axis=1, keepdims=True)
    along = 4.0 * reach * down[:, ::-1] * [-1.0, 1.0]
    ring = np.stack([level - across - along, level + across - along, level + across + along, level - across + along], 1)
    return np.asarray(shapely.polygons(ring), dtype=np.object_)


def _embedded_contact(block: Solid, body: Solid, *, tolerance: float) -> ContactArea | None:
    """Find where the underside of a body lies inside the block by more than the tolerance [m] in plan."""
    shared = intersect(block, body)
    if shared is None:
        return None
    underside, normals = _with_normals(shared.corners[shared.of_second])
    faces_down = normals[:, 2] < -STEEP
    underside = underside[faces_down]
    if not len(underside):
        return None
    origin = underside.mean(axis=(0, 1))
    plan = shapely.union_all(shapely.polygons(underside[:, :, :2] - origin[:2]))
    region = _open_region(plan, width=tolerance)
    area = float(shapely.area(region))
    if area <= tolerance**2:
        return None
    weight = -normals[faces_down, 2] * areas_and_normals(underside)[0]
    z = float(weight @ underside[:, :, 2].mean(axis=1) / weight.sum())
    centre = shapely.get_coordinates(shapely.centroid(region))[0] + origin[:2]
    return ContactArea(area, np.array([*centre, z]), np.array([0.0, 0.0, 1.0]), True)


def _open_region(region: shapely.Geometry, *, width: float) -> shapely.Geometry:
    """Remove strips narrower than the width [m], where faces overlap by an inaccuracy of the drawing."""
    narrowed = shapely.buffer(region, -width / 2.0, join_style="mitre")
    return shapely.intersection(region, shapely.buffer(narrowed, 1.001 * width / 2.0, join_style="mitre"))
