"""Boolean operations on closed surfaces, the overlap of bodies and the distance between them.

The only door to manifold3d.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, groupby, product
from math import inf
from operator import sub
from typing import Any

import numpy as np

from assess.errors import GeometryError
from assess.geometry.solid import THINNEST, Solid, keep_of_bodies, polyhedron
from assess.geometry.surface import Surface, merge_vertices, volume
from assess.messages.message import Message, Quantity, warning
from spectra.arrays import BoolArray, FloatArray, IntArray

NEAR_FINE_MESHES = 0.05  # m: fine meshes nearer than this are measured face by face
MANY_PAIRS = 1e8  # pairs of triangles: to compare more of them takes seconds


@dataclass(frozen=True)
class Intersection:
    """The volume common to two bodies.

    corners : of the triangles of its surface, anticlockwise seen from outside [m, 3, 3] [m]
    of_second : which of them belong to the second body's surface [m]
    volume : [m3]
    share : volume over that of the smaller body [-]
    """

    corners: FloatArray
    of_second: BoolArray
    volume: float
    share: float


def triangulate(rings: Sequence[FloatArray]) -> IntArray:
    """Triangulate the area to the left of closed rings, with all their corners and no others.

    Parameters
    ----------
    rings : corners of each, anticlockwise around the area and clockwise around its holes, without the first at the end
        [k, 2] [m]

    Returns
    -------
    triangles, anticlockwise: indices into the corners of all rings, one ring after the other [m, 3]
    """
    from manifold3d import triangulate as triangulate_rings

    return np.array(triangulate_rings([np.array(ring, order="C") for ring in rings]), dtype=np.int64).reshape(-1, 3)


def unite(shells: Sequence[Surface], *, where: str) -> Surface:
    """Unite closed shells into one surface, the larger first, each over those before it.

    Shells that face outwards add material, those that face inwards (cavities) take it away; so a cavity empties the
    body around it, and a body within a cavity stands in it.
    """
    from manifold3d import Manifold, OpType

    middle = shells[0][0].mean(axis=0)  # coordinates far from the origin cost no digits
    sized = sorted(((volume(*shell), shell) for shell in shells), key=lambda each: -abs(each[0]))
    whole = Manifold()
    for material, group in groupby(sized, key=lambda each: each[0] > 0.0):
        bodies = [_manifold((v - middle, t if material else t[:, ::-1]), where=where) for _, (v, t) in group]
        whole = Manifold.batch_boolean([whole, *bodies], OpType.Add if material else OpType.Subtract)
    vertices, triangles = _surface(whole)
    return merge_vertices(vertices + middle, triangles)


def intersect(first: Solid, second: Solid) -> Intersection | None:
    """Return the volume that two bodies share, None where they share none.

    Parameters
    ----------
    first, second : the bodies

    Raises
    ------
    GeometryError : a surface is not that of a solid
    """
    return None if _bounds_gap(first, second) > 0.0 else _intersect((first, second))


@keep_of_bodies
def _intersect(solids: tuple[Solid, ...]) -> Intersection | None:
    first, second = solids
    origin = (first.vertices.min(axis=0) + first.vertices.max(axis=0)) / 2.0
    one, two = (_manifold_of_solid(solid, origin).as_original() for solid in (first, second))
    shared = one ^ two
    volume, smaller = float(shared.volume()), min(float(one.volume()), float(two.volume()))
    if volume <= THINNEST * smaller:  # faces that only touch leave a film
        return None
    mesh = shared.to_mesh64()
    corners = np.array(mesh.vert_properties, dtype=np.float64)[:, :3][np.array(mesh.tri_verts, dtype=np.int64)]
    ends = np.array(mesh.run_index, dtype=np.int64) // 3
    of_second = np.repeat(np.array(mesh.run_original_id, dtype=np.int64) == two.original_id(), ends[1:] - ends[:-1])
    corners += origin
    for shared_array in (corners, of_second):
        shared_array.flags.writeable = False
    return Intersection(corners, of_second, volume, volume / smaller)


def shortest_distance(first: Solid, second: Solid, *, limit: float = inf) -> float:
    """Return the shortest distance between two bodies [m]; 0 where they touch or overlap.

    Between fine meshes that are clearly apart, the distance between their vertices is taken.

    Parameters
    ----------
    first, second : the bodies
    limit : returned where they are farther apart [m]

    Raises
    ------
    GeometryError : a surface is not that of a solid
    """
    return limit if _bounds_gap(first, second) >= limit else _shortest_distance((first, second), limit)


@keep_of_bodies
def _shortest_distance(solids: tuple[Solid, ...], limit: float) -> float:
    first, second = solids
    origin = (first.vertices.min(axis=0) + first.vertices.max(axis=0)) / 2.0
    one, two = (_manifold_of_solid(solid, origin) for solid in (first, second))
    from scipy.spatial import KDTree

    reach = min(limit, float(np.min(KDTree(first.vertices).query(second.vertices)[0])) * (1.0 + THINNEST))
    fine = len(first.triangles) * len(second.triangles) > MANY_PAIRS
    looked = min(reach, NEAR_FINE_MESHES) if fine else reach
    found = float(one.min_gap(two, looked)) if looked > 0.0 else 0.0
    return found if found < looked else reach


def count_once(solids: Sequence[Solid]) -> tuple[Solid, ...]:
    """Return bodies that move as one so that what they share belongs to the first of them alone, whatever its density.

    A body that lies wholly in those before it is left out. Bodies whose boxes do not overlap are not compared.

    Parameters
    ----------
    solids : the bodies, each with its own density

    Raises
    ------
    GeometryError : bodies overlap and the surface of one is not that of a solid
    """
    return _count_once(tuple(solids))


@keep_of_bodies
def _count_once(solids: tuple[Solid, ...]) -> tuple[Solid, ...]:
    kept: list[Solid] = []
    for solid in solids:
        met = [other for other in kept if find_overlap(other, solid) is not None]
        remainder = subtract(solid, met) if met else solid
        kept += [] if remainder is None else [remainder]
    return tuple(kept)


def subtract(solid: Solid, others: Sequence[Solid], *, film: float = 0.0) -> Solid | None:
    """Return a body less others, with its density; None where nothing is left.

    Parameters
    ----------
    solid : the body
    others : bodies that take from it
    film : what is left thinner than this goes too [m]
    """
    from manifold3d import Manifold, OpType

    origin = (solid.vertices.min(axis=0) + solid.vertices.max(axis=0)) / 2.0
    whole, *taken = (_manifold_of_solid(each, origin) for each in (solid, *others))
    rest = Manifold.batch_boolean([whole, *taken], OpType.Subtract)
    if float(rest.volume()) <= NEGLIGIBLE_OVERLAP * float(whole.volume()):
        return None
    rest = rest.simplify(film) if film else rest
    return _piece_of(solid, rest, origin, density=solid.mass / float(whole.volume()))


def common_part(solid: Solid, other: Solid, *, film: float = 0.0) -> Solid | None:
    """Return the part of a body that lies in another, with its density; None where they share nothing.

    Parameters
    ----------
    solid : the body
    other : which bounds it
    film : what of it is thinner than this is left out [m]
    """
    origin = (solid.vertices.min(axis=0) + solid.vertices.max(axis=0)) / 2.0
    whole, within = (_manifold_of_solid(each, origin) for each in (solid, other))
    shared = whole ^ within
    if float(shared.volume()) <= NEGLIGIBLE_OVERLAP * float(whole.volume()):
        return None
    shared = shared.simplify(film) if film else shared
    return _piece_of(solid, shared, origin, density=solid.mass / float(whole.volume()))


OVERLAP_WARNED = 5e-3  # of the smaller body's volume: bodies that share less are taken to touch
SAME_PLACE = 0.1  # of the smaller body's volume: a body that shares more with a block is another state of it


def overlap_warnings(bodies: Sequence[Solid], *, built_into: Sequence[Solid] = ()) -> Iterator[Message]:
    """Warn of each pair of bodies that overlap where they move as one: their common volume counts once (`count_once`).

    Parameters
    ----------
    bodies : any number
    built_into : others, into which these may be drawn by a tenth, as the ends of a floor are
    """
    pairs = [(pair, OVERLAP_WARNED) for pair in combinations(bodies, 2)]
    pairs += [(pair, SAME_PLACE) for pair in product(built_into, bodies)]
    for (one, other), most in pairs:
        shared = intersect(one, other) if _boxes_overlap(one, other) else None
        if shared is not None and shared.share > most:
            yield warning(
                "overlap",
                one=one.name,
                other=other.name,
                volume=Quantity(shared.volume, "volume", 3),
                share=Quantity(100.0 * shared.share, "percent", 3),
            )


def mass_within(block: Sequence[Solid], other: Solid) -> float:
    """Return the mass of a body that lies in the solids of a block, which count that volume themselves [kg].

    Parameters
    ----------
    block : its solids, no two of which overlap
    other : the body
    """
    share, shared = shared_volume([solid for solid in block if _boxes_overlap(solid, other)], other)
    return other.mass * shared / abs(volume(other.vertices, other.triangles)) if share > NEGLIGIBLE_OVERLAP else 0.0


def shared_volume(block: Sequence[Solid], other: Solid) -> tuple[float, float]:
    """Return the overlap of a body with the solids of a block.

    Parameters
    ----------
    block : its solids
    other : the body

    Returns
    -------
    largest share of the smaller body [-], and the volume [m3]
    """
    shared = [each for solid in block if (each := intersect(solid, other)) is not None]
    return max((each.share for each in shared), default=0.0), sum(each.volume for each in shared)


NEGLIGIBLE_OVERLAP = 1e-6  # of a body's size, and of the smaller volume: bodies that share less touch


def find_overlap(one: Solid, other: Solid) -> Intersection | None:
    """Return what two bodies share; None where it is no more than the rounding of a drawing."""
    shared = intersect(one, other) if _boxes_overlap(one, other) else None
    return shared if shared is not None and shared.share > NEGLIGIBLE_OVERLAP else None


def _boxes_overlap(one: Solid, other: Solid) -> bool:
    """Return whether the boxes around two bodies share more than the rounding of a drawing."""
    size = min(float(max(map(sub, *solid.bounds[::-1]))) for solid in (one, other))
    return _bounds_gap(one, other) < -NEGLIGIBLE_OVERLAP * size


def _piece_of(solid: Solid, piece: Any, origin: FloatArray, *, density: float) -> Solid:
    """Return a piece of a body, a manifold3d object with coordinates from an origin [3], as a body of its name."""
    vertices, triangles = _surface(piece)
    return replace(polyhedron(vertices + origin, triangles, density=density, name=solid.name), history=solid.history)


def _bounds_gap(first: Solid, second: Solid) -> float:
    """Return the largest gap between the bounding boxes along an axis [m], negative where they overlap."""
    (low_a, high_a), (low_b, high_b) = first.bounds, second.bounds
    return float(max(*map(sub, low_b, high_a), *map(sub, low_a, high_b)))


def _manifold_of_solid(solid: Solid, origin: FloatArray) -> Any:
    """Convert a body, with coordinates from an origin [3], to a manifold3d object."""
    return _manifold((solid.vertices - origin, solid.triangles), where=f'body "{solid.name}"')


def _manifold(surface: Surface, *, where: str) -> Any:
    from manifold3d import Error, Manifold, Mesh64

    vertices, triangles = surface
    body = Manifold(Mesh64(np.array(vertices, order="C"), np.array(triangles, dtype=np.uint64, order="C")))
    if body.status() != Error.NoError:
        raise GeometryError(
            f"{where} cannot be cut, united or set against another ({body.status().name}); is its surface closed?"
        )
    return body


def _surface(body: Any) -> Surface:
    mesh = body.to_mesh64()
    vertices: FloatArray = np.array(mesh.vert_properties, dtype=np.float64)[:, :3]
    return vertices, np.array(mesh.tri_verts, dtype=np.int64)
