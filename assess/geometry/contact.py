"""Contact between a body and a block: on facing surfaces, or where the body is built in (thesis 3.2.2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from assess.geometry.boolean import intersect
from assess.geometry.solid import THINNEST, Solid, keep_of_bodies
from assess.geometry.surface import area_vectors, areas_and_normals, cross
from spectra.arrays import FloatArray, IntArray

CONTACT_TOLERANCE = 0.01  # m: faces this near each other touch; joints are as thick, and drawings no better
JOINT = CONTACT_TOLERANCE  # m: a body that is let down onto a block bears where less than this is left between them
PARALLEL = 0.98  # minus the cosine between the normals of two faces: they face each other within 11 degrees
OBLIQUE = 0.5  # the same of faces that meet along an edge: within 60 degrees
STEEP = 0.26  # vertical part of a unit normal: a face within 15 degrees of upright, like a battered wall, bears nothing


@dataclass(frozen=True)
class ContactArea:
    """The area where a body meets a block.

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
    """Pieces of faces: area [k] [m2], centroid [k, 3] [m], unit normal [k, 3], least distance of what they face [k]."""

    area: FloatArray
    centroid: FloatArray
    normal: FloatArray
    distance: FloatArray


def find_contact(
    block: Solid, body: Solid, *, tolerance: float = CONTACT_TOLERANCE, joint: float = JOINT
) -> ContactArea | None:
    """Find where a body meets a block; None where it does not, or where it lies under the block and carries it.

    The tolerance says only whether they touch: where a gap of at most that is left between faces that face each other,
    it is closed, and they are in contact where what is then left between them fits into a joint, or where they
    penetrate each other by no more than `JOINT`. So the contact is the same at any tolerance that finds it, and a
    rafter over the edge of a wall meets the wall's top in the strip along that edge as wide as its slope has it. A body
    that penetrates the block by more is built in, and bears on its underside. Where the body bears, only that region
    counts, since its weight goes there; otherwise the faces it pushes against count.

    Parameters
    ----------
    block : the body that may carry
    body : the body that may be carried
    tolerance : on the distance of faces [m]
    joint : what may be left between faces once the gap is closed [m]

    Raises
    ------
    GeometryError : the bodies overlap and the surface of one is not that of a solid
    """
    margin = max(tolerance, JOINT)
    (low, high), (foot, head) = block.bounds, body.bounds
    if any(a - margin > b for a, b in zip((*low, *foot), (*head, *high), strict=True)):
        return None
    return _contact_of((block, body), tolerance, joint)


@keep_of_bodies
def _contact_of(solids: tuple[Solid, ...], tolerance: float, joint: float) -> ContactArea | None:
    def contact(cosine: float, *, bearing: bool) -> ContactArea | None:
        faces = _facing_parts(solids, tolerance, cosine, bearing)
        gap = _gap(faces)
        if gap is None:
            return None
        if (reach := gap + joint) != tolerance:
            faces = _facing_parts(solids, reach, cosine, bearing)
        return _join_patches(faces, bearing=bearing)

    bears = [contact(PARALLEL, bearing=True), _embedded_contact(solids)]
    found = [each for each in bears if each is not None]
    if found:
        return max(found, key=lambda each: each.area)
    return contact(OBLIQUE, bearing=True) or contact(PARALLEL, bearing=False) or contact(OBLIQUE, bearing=False)


def facing_patches(block: Solid, body: Solid, *, tolerance: float = CONTACT_TOLERANCE) -> FacePatches:
    """Return the upright parts of a block's faces that a face of a body faces within the tolerance.

    Parameters
    ----------
    block : whose faces are returned
    body : whose faces they may face
    tolerance : on the distance of faces [m]
    """
    return _facing_parts((block, body), tolerance, PARALLEL, False)


def join_contacts(contacts: Sequence[ContactArea]) -> ContactArea | None:
    """Combine the contacts of a body with the parts of one block; None where there are none."""
    bearing = any(each.bearing for each in contacts)
    chosen = [each for each in contacts if each.bearing == bearing]
    if not chosen:
        return None
    area, centroid, normal = (
        np.array([getattr(each, key) for each in chosen]) for key in ("area", "centroid", "normal")
    )
    return _join_patches(FacePatches(area, centroid, normal, np.zeros(len(chosen))), bearing=bearing)


def _gap(faces: FacePatches) -> float | None:
    """Return the gap that parts the faces [m], 0 if they penetrate; None if no more than a splinter is near."""
    order = np.argsort(faces.distance, kind="stable")
    enough = np.flatnonzero(np.cumsum(faces.area[order]) > SPLINTER)
    return max(0.0, round(float(faces.distance[order[enough[0]]]), DIGITS)) if enough.size else None


def _join_patches(faces: FacePatches, *, bearing: bool) -> ContactArea | None:
    """Combine patches into one contact, None if they are no larger than a splinter."""
    A = faces.area
    area = float(A.sum())
    if area <= SPLINTER:
        return None
    centroid, normal = (A @ each / area for each in (faces.centroid, faces.normal))
    normal = normal / (float(np.linalg.norm(normal)) or 1.0)
    centroid.flags.writeable = normal.flags.writeable = False
    return ContactArea(area, centroid, normal, bearing)


SPLINTER = JOINT**2  # m2: what meets in less does not touch
DIGITS = 9  # of a gap in metres: beyond them it is rounding of coordinates


@keep_of_bodies
def _facing_parts(solids: tuple[Solid, ...], reach: float, cosine: float, bearing: bool) -> FacePatches:
    """Return the parts of a block's faces that a face of a body faces within reach [m] and cosine.

    Of the block only faces that bear count, or only upright ones. The body's face is at most the reach away, and at
    most `JOINT` inside the block.
    """
    margin = max(reach, JOINT)
    origin, (one, n), (other, m) = _faces_near(solids, margin)
    chosen = n[:, 2] >= STEEP if bearing else np.abs(n[:, 2]) < STEEP
    one, n = one[chosen], n[chosen]
    pairs = _pairs(one, n, other, m, margin=margin, cosine=cosine)
    found = [_clip_facing(one[i], n[i], other[j], reach=reach) for i, j in pairs if len(i)]
    area, centroid, normal, distance = (np.concatenate(each) for each in zip(_EMPTY, *found, strict=True))
    centroid = centroid + origin
    for shared in (area, centroid, normal, distance):
        shared.flags.writeable = False
    return FacePatches(area, centroid, normal, distance)


_EMPTY = (np.empty(0), np.empty((0, 3)), np.empty((0, 3)), np.empty(0))


Faces = tuple[FloatArray, FloatArray]
"""Triangles [m, 3, 3] and their unit normals [m, 3]."""


@keep_of_bodies
def _faces_near(solids: tuple[Solid, ...], margin: float) -> tuple[FloatArray, Faces, Faces]:
    """Return the middle of the second of two bodies, and from there the faces of each inside the box of the other."""
    low, high = solids[1].bounds
    origin = (np.array(low) + np.array(high)) / 2.0
    corners = [(solid.vertices - origin)[solid.triangles] for solid in solids]
    one, two = (_with_normals(_inside_box(own, other, margin)) for own, other in (corners, corners[::-1]))
    for shared in (origin, *one, *two):
        shared.flags.writeable = False
    return origin, one, two


def _inside_box(own: FloatArray, other: FloatArray, margin: float) -> FloatArray:
    """Return the triangles [m, 3, 3] of one body inside the bounding box of those of another, widened by a margin."""
    low, high = other.min(axis=(0, 1)) - margin, other.max(axis=(0, 1)) + margin
    return own[np.all((own.max(axis=1) >= low) & (own.min(axis=1) <= high), axis=1)]


def _with_normals(corners: FloatArray) -> Faces:
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
        if not own.size:
            continue
        low, high = one[own].min(axis=1), one[own].max(axis=1)
        tree = shapely.STRtree(shapely.box(low_b[:, u], low_b[:, v], high_b[:, u], high_b[:, v]))
        a, j = tree.query(shapely.box(low[:, u], low[:, v], high[:, u], high[:, v]))
        i = own[a]
        meet = (low[a, axis] <= high_b[j, axis]) & (high[a, axis] >= low_b[j, axis])
        meet &= np.einsum("si,si->s", n[i], m[j]) < -cosine
        yield i[meet], j[meet]


def _clip_facing(
    one: FloatArray, n: FloatArray, other: FloatArray, *, reach: float
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Clip triangles [s, 3, 3] with normals n [s, 3] to what the others face within the reach [m].

    Area [k], centroid on the first triangles [k, 3], their normals [k, 3], least distance of the others [k]. The
    distance of the other triangle is linear over the plane of the first, so the reach leaves a strip of that plane.
    """
    origin = one[:, 0]
    u = one[:, 1] - origin
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    frame = np.stack([u, cross(n, u), n], axis=1)
    own, facing = (np.einsum("sij,skj->ski", frame, each - origin[:, None]) for each in (one, other))
    distance = facing[:, :, 2]
    within = (distance.min(axis=1) <= reach) & (distance.max(axis=1) >= -JOINT)
    if not within.any():
        return _EMPTY
    own, facing, origin, frame, n = own[within], facing[within], origin[within], frame[within], n[within]
    shared = shapely.intersection(shapely.polygons(own[:, :, :2]), shapely.polygons(facing[:, :, :2]))
    slope = _slopes(facing)
    leaning = np.flatnonzero((facing[:, :, 2].max(axis=1) > reach) | (facing[:, :, 2].min(axis=1) < -JOINT))
    leaning = leaning[np.any(slope[leaning] != 0.0, axis=1)]
    if leaning.size:
        strips = _strips(facing[leaning], slope[leaning], reach=reach)
        shared[leaning] = shapely.intersection(shared[leaning], strips)
    area = shapely.area(shared)
    real = area > 0.0
    at = shapely.get_coordinates(shapely.centroid(shared[real]))
    least = _least_distance(shared[real], facing[real, 0], slope[real])
    return area[real], origin[real] + np.einsum("si,sij->sj", at, frame[real, :2]), n[real], least


def _slopes(corners: FloatArray) -> FloatArray:
    """Return the gradient of the planes through corners [s, 3, 3] over x and y [s, 2]."""
    normal = area_vectors(corners)
    return np.asarray(-normal[:, :2] / normal[:, 2:], dtype=np.float64)


def _least_distance(regions: NDArray[np.object_], corner: FloatArray, slope: FloatArray) -> FloatArray:
    """Return the least z over regions [k] of planes through a corner [k, 3] with a slope [k, 2]."""
    points, place = shapely.get_coordinates(regions, return_index=True)
    z = corner[place, 2] + np.einsum("pi,pi->p", points - corner[place, :2], slope[place])
    least = np.full(len(regions), np.inf)
    np.minimum.at(least, place, z)
    return least


def _strips(corners: FloatArray, slope: FloatArray, *, reach: float) -> NDArray[np.object_]:
    """Return the strips of z = 0 where the planes through corners [s, 3, 3] are from a joint below it to the reach."""
    steepness = np.linalg.norm(slope, axis=1, keepdims=True)
    up = slope / steepness
    level = corners[:, 0, :2] - up * (corners[:, 0, 2:] / steepness)  # where the plane meets z = 0, below a corner
    inside, apart = JOINT / steepness * up, reach / steepness * up
    far = np.abs(corners).max(axis=(1, 2))[:, None] + np.abs(level - corners[:, 0, :2]).max(axis=1, keepdims=True)
    along = 4.0 * far * up[:, ::-1] * [-1.0, 1.0]
    ring = np.stack([level - inside - along, level + apart - along, level + apart + along, level - inside + along], 1)
    return np.asarray(shapely.polygons(ring), dtype=np.object_)


@keep_of_bodies
def _embedded_contact(solids: tuple[Solid, ...]) -> ContactArea | None:
    """Find where the underside of a body lies inside a block, in plan by more than a joint is thick."""
    block, body = solids
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
    region = _open_region(plan, width=JOINT)
    area = float(shapely.area(region))
    if area <= SPLINTER:
        return None
    weight = -normals[faces_down, 2] * areas_and_normals(underside)[0]
    z = float(weight @ underside[:, :, 2].mean(axis=1) / weight.sum())
    centre = shapely.get_coordinates(shapely.centroid(region))[0] + origin[:2]
    place, upwards = np.array([*centre, z]), np.array([0.0, 0.0, 1.0])
    place.flags.writeable = upwards.flags.writeable = False
    return ContactArea(area, place, upwards, True)


def _open_region(region: shapely.Geometry, *, width: float) -> shapely.Geometry:
    """Remove strips narrower than the width [m], where faces overlap by an inaccuracy of the drawing."""
    narrowed = shapely.buffer(region, -width / 2.0, join_style="mitre")
    return shapely.intersection(region, shapely.buffer(narrowed, 1.001 * width / 2.0, join_style="mitre"))
