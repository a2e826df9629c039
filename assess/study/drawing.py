"""A mechanism drawn to scale: in its plane of motion at rest and turned far enough to be seen, and in space.

Bodies in space are simplified for the results and for drawing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import floor, log10

import numpy as np

from assess.geometry.cut import Scene
from assess.geometry.planar import Outline, projected_outline
from assess.geometry.solid import Solid, drawn_surface
from assess.geometry.surface import Surface, area, simplify
from assess.loads.load import Force, Load, Point, PointMass
from assess.mechanisms.chain import Chain, hinge_names, mirror_point, move, trace_point
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Branch, Oscillator
from assess.results import BodyEdges, DisplacedDrawing, Drawing, DrawnLoad, HingeAxis, NamedPoint, Place, Ring, View
from spectra.arrays import FloatArray, IntArray

BlockOutline = tuple[Ring, int]  # an outline and its block
LARGEST_MOVE = 0.12  # of the drawing's size: how far the farthest point of a displaced mechanism has moved, at most
FIXED = -1  # the block of what does not move
DOWN = (0.0, -1.0)


def draw(mechanism: Mechanism, oscillator: Oscillator, scene: Scene | None = None) -> Drawing:
    """Draw the mechanism at rest, and turned to each side to which it rocks; the scene has the bodies that stay."""
    chain = mechanism.positive
    mass = sum(block.mass for block in chain.blocks)
    x, z = (sum(block.mass * block.centroid[i] for block in chain.blocks) / mass for i in (0, 1))
    pieces = pieces_of(chain, mechanism.outlines)
    return Drawing(
        blocks=tuple(ring for ring, _ in pieces),
        hinges=hinges_of(mechanism),
        loads=tuple(_drawn_load(load, load.at, chain) for load in chain.loads),
        centroid=(x, z),
        block_of=tuple(block for _, block in pieces),
        centroids=tuple(block.centroid for block in chain.blocks),
        displaced=_draw_rotation(chain, oscillator.positive, pieces, mark=""),
        displaced_negative=_draw_negative_side(mechanism, oscillator),
        fixed=() if scene is None else _fixed_outlines(scene, level=chain.level),
        masses_kg=()
        if chain.level or mechanism.kind == "equivalent-block"
        else tuple(block.mass for block in chain.blocks),
    )


def pieces_of(chain: Chain, outlines: Sequence[Outline]) -> list[BlockOutline]:
    """Return every ring of the outlines with its block, FIXED where it does not move."""
    return [(ring, block) for block, outline in zip(_block_numbers(chain), outlines, strict=True) for ring in outline]


def hinges_of(mechanism: Mechanism) -> tuple[NamedPoint, ...]:
    """Return hinges A, B, … of the positive branch and A', B', … of the negative one, at rest, not mirrored."""
    negative = () if mechanism.negative is None else _hinges_of_chain(mechanism.negative, "'")
    back = (NamedPoint(hinge.name, mirror_point(hinge.at)) for hinge in negative)
    return (*_hinges_of_chain(mechanism.positive, ""), *back)


VIEW_TRIANGLES = 4000  # triangles of a view
COORDINATE_FIGURES = 5  # of a coordinate, counted from the first of the bodies' size
RING_CORNERS = 300  # of a section's ring


def view_in_space(mechanism: Mechanism, scene: Scene) -> View:
    """Return the bodies with their axes of rotation, at rest."""
    members = [*zip(scene.members, _block_numbers(mechanism.positive), strict=True), (scene.fixed, FIXED)]
    surfaces = [
        (*_join_surfaces([drawn_surface(each) for each in solids]), owner) for solids, owner in members if solids
    ]
    bodies = [solid for solids, _ in members for solid in solids]
    size = np.ptp([corner for solid in bodies for corner in solid.bounds], axis=0)
    decimals = COORDINATE_FIGURES - 1 - floor(log10(float(size.max())))
    simplified = simplify_surfaces(surfaces)
    starts = np.cumsum([0, *(len(vertices) for vertices, _, _ in simplified)])
    return View(
        vertices=rounded_points(np.concatenate([vertices for vertices, _, _ in simplified]), decimals),
        triangles=tuple(
            (a, b, c)
            for start, (_, triangles, _) in zip(starts, simplified, strict=False)
            for a, b, c in (triangles + start).tolist()
        ),
        block_of=tuple(owner for _, triangles, owner in simplified for _ in range(len(triangles))),
        axes=_hinge_axes(mechanism, scene, decimals),
        sections=tuple(rounded_points(_thin_ring(ring), decimals) for ring in scene.sections),
        direction=_as_point(scene.direction),
        size=rounded_points(size[None], decimals)[0],
        given=sum(len(solid.triangles) for solid in bodies),
    )


SHARP = 0.77  # cosine of the angle between two faces, 40 degrees, from which on their common edge is drawn
EDGE_TRIANGLES = 1000  # of a body of which the edges alone are drawn


def edges_in_space(solid: Solid) -> BodyEdges:
    """Return the sharp edges of a body."""
    vertices, triangles = simplify(solid.vertices, solid.triangles, limit=EDGE_TRIANGLES)
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    ends = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges, index, count = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
    added = np.zeros((len(edges), 3))
    np.add.at(added, index.ravel(), np.tile(normals, (3, 1)))
    cosine = (np.sum(added**2, axis=1) - 2.0) / 2.0  # |a + b|^2 = 2 + 2 a . b
    drawn = vertices[edges[(count != 2) | (cosine < SHARP)]]
    decimals = COORDINATE_FIGURES - 1 - floor(log10(float(np.ptp(vertices, axis=0).max())))
    return BodyEdges(solid.name, tuple((a, b) for a, b in (rounded_points(edge, decimals) for edge in drawn)))


def rounded_points(points: FloatArray, decimals: int) -> tuple[Place, ...]:
    """Return points [k, 3] as plain numbers, rounded."""
    return tuple((x, y, z) for x, y, z in (np.round(points, decimals) + 0.0).tolist())


def _block_numbers(chain: Chain) -> tuple[int, ...]:
    """Return the block of each outline of a mechanism, FIXED where it does not move."""
    if not chain.parts:
        return tuple(range(len(chain.blocks)))
    return tuple(FIXED if number is None else number for _, number in chain.parts)


def _fixed_outlines(scene: Scene, *, level: bool) -> tuple[Ring, ...]:
    """Return the outlines in the plane of motion of the bodies that do not move, simplified where they are scans."""
    rings: list[Ring] = []
    for solid in scene.fixed:
        vertices, triangles = drawn_surface(solid)
        up = vertices @ _across(scene) if level else vertices[:, 2]
        points = np.column_stack([vertices @ scene.direction, up])
        rings += projected_outline(points, triangles if level else triangles[:, ::-1])
    return tuple(rings)


def _draw_negative_side(mechanism: Mechanism, oscillator: Oscillator) -> DisplacedDrawing | None:
    """Draw the mechanism turned to its negative side; None if it rocks to one side only."""
    chain, branch = mechanism.negative, oscillator.negative
    if chain is None or branch is None:
        return None
    outlines = [
        tuple(tuple(mirror_point(point) for point in ring) for ring in outline) for outline in mechanism.outlines
    ]
    turned = _draw_rotation(chain, branch, pieces_of(chain, outlines), mark="'")
    return replace(
        turned,
        blocks=tuple(tuple(mirror_point(point) for point in ring) for ring in turned.blocks),
        hinges=tuple(replace(hinge, at=mirror_point(hinge.at)) for hinge in turned.hinges),
        loads=tuple(
            replace(
                load, at=mirror_point(load.at), towards=None if load.towards is None else mirror_point(load.towards)
            )
            for load in turned.loads
        ),
        centroids=tuple(mirror_point(point) for point in turned.centroids),
    )


def _hinges_of_chain(chain: Chain, mark: str) -> tuple[NamedPoint, ...]:
    """Return hinges A, B, … of a chain, in its own sign."""
    hinges = ((round(x, ROUNDED) + 0.0, round(z, ROUNDED) + 0.0) for x, z in chain.hinges)
    return tuple(NamedPoint(f"{name}{mark}", at) for name, at in zip(hinge_names(chain), hinges, strict=True))


ROUNDED = 7  # decimals of a hinge [m]: what cuts of meshes leave beside 0 is 0


def _draw_rotation(chain: Chain, branch: Branch, pieces: Sequence[BlockOutline], *, mark: str) -> DisplacedDrawing:
    """Draw the chain after the rotation at which it is shown, in its own sign."""
    rotation = _display_rotation(chain, branch.overturning, pieces)

    def turned(points: Sequence[Point], block: int) -> Ring:
        moved = _move_points(chain, np.array(points), block=block, rotation=rotation)
        return tuple((float(x), float(z)) for x, z in moved)

    return DisplacedDrawing(
        rotation_rad=rotation,
        blocks=tuple(turned(ring, block) for ring, block in pieces),
        block_of=tuple(block for _, block in pieces),
        hinges=tuple(
            NamedPoint(hinge.name, turned([hinge.at], max(before, 0))[0])
            for before, hinge in enumerate(_hinges_of_chain(chain, mark), start=-1)
        ),
        loads=tuple(_drawn_load(load, turned([load.at], load.block)[0], chain) for load in chain.loads),
        centroids=tuple(turned([block.centroid], number)[0] for number, block in enumerate(chain.blocks)),
    )


def _display_rotation(chain: Chain, overturning: float, pieces: Sequence[BlockOutline]) -> float:
    """Return the rotation to show [rad], two figures: at most overturning, and a move by LARGEST_MOVE."""
    sets = [(np.array(ring), block) for ring, block in pieces]
    sets += [(np.array([block.centroid]), number) for number, block in enumerate(chain.blocks)]
    size = float(np.ptp(np.concatenate([*(points for points, _ in sets), chain.hinges]), axis=0).max())
    farthest_move = max(
        float(np.linalg.norm(_move_points(chain, points, block=block, rotation=overturning) - points, axis=1).max())
        for points, block in sets
    )
    largest = overturning * min(1.0, LARGEST_MOVE * size / farthest_move)
    step = 10.0 ** (floor(log10(largest)) - 1)
    return round(floor(largest / step + 1e-9) * step, 12)


def _move_points(chain: Chain, points: FloatArray, *, block: int, rotation: float) -> FloatArray:
    """Return points [k, 2] of a block after a rotation [rad], by the motion of two of its points."""
    if block == FIXED:
        return points
    motion = move(chain, np.array([rotation]))
    moved = [trace_point(motion, block=block, at=corner) for corner in ((0.0, 0.0), (1.0, 0.0))]
    origin, end = (np.array([each.x[0], each.z[0]]) for each in moved)
    along = end - origin
    return np.asarray(origin + points[:, :1] * along + points[:, 1:] * [-along[1], along[0]], dtype=np.float64)


def _drawn_load(load: Load, at: Point, chain: Chain) -> DrawnLoad:
    """Return a load that acts at a point [m], with the direction of its weight, of the force, or of the tie's pull."""
    if isinstance(load, PointMass):
        return DrawnLoad(load.name, at, "mass", DOWN if load.bearing and not chain.level else None)
    if isinstance(load, Force):
        return DrawnLoad(load.name, at, "force", _unit_vector(load.force))
    if load.anchor is not None:
        return DrawnLoad(load.name, at, "tie", _unit_vector((load.anchor[0] - at[0], load.anchor[1] - at[1])))
    return DrawnLoad(load.name, at, "tie", load.direction)


def _unit_vector(vector: Point) -> Point | None:
    """Return the unit vector along a vector; None for a zero vector."""
    length = float(np.hypot(*vector))
    return (vector[0] / length, vector[1] / length) if length else None


def _join_surfaces(surfaces: Sequence[Surface]) -> Surface:
    """Return several surfaces as one."""
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in surfaces[:-1])])
    triangles = [each + start for (_, each), start in zip(surfaces, starts, strict=True)]
    return np.concatenate([vertices for vertices, _ in surfaces]), np.concatenate(triangles)


def simplify_surfaces(surfaces: Sequence[tuple[FloatArray, IntArray, int]]) -> list[tuple[FloatArray, IntArray, int]]:
    """Simplify surfaces to no more than VIEW_TRIANGLES triangles in all, shared by area."""
    if sum(len(triangles) for _, triangles, _ in surfaces) <= VIEW_TRIANGLES:
        return list(surfaces)
    areas = np.array([area(vertices, triangles) for vertices, triangles, _ in surfaces])
    shares = np.maximum(12, (VIEW_TRIANGLES * areas / areas.sum()).astype(np.int64))
    return [
        (*simplify(vertices, triangles, limit=int(share)), owner)
        for (vertices, triangles, owner), share in zip(surfaces, shares, strict=True)
    ]


def _hinge_axes(mechanism: Mechanism, scene: Scene, decimals: int) -> tuple[HingeAxis, ...]:
    """Return the axis of each hinge over the moving bodies: across the direction, or upright."""
    along, up, across = scene.direction, np.array([0.0, 0.0, 1.0]), _across(scene)
    if mechanism.positive.level:
        up, across = across, up
    reach = np.concatenate([solid.vertices for member in scene.members for solid in member]) @ across
    found = []
    for hinge in hinges_of(mechanism):
        middle = hinge.at[0] * along + hinge.at[1] * up
        first, last = rounded_points(np.array([middle + reach.min() * across, middle + reach.max() * across]), decimals)
        found.append(HingeAxis(hinge.name, (first, last)))
    return tuple(found)


def _across(scene: Scene) -> FloatArray:
    """Return the horizontal unit vector square to the direction, to its left [3]."""
    return np.array([-scene.direction[1], scene.direction[0], 0.0])


def _thin_ring(ring: FloatArray) -> FloatArray:
    """Thin a closed ring [k, 3] evenly to no more than RING_CORNERS corners."""
    step = -(-(len(ring) - 1) // RING_CORNERS)
    return np.concatenate([ring[:-1:step], ring[:1]])


def _as_point(point: FloatArray) -> Place:
    """Return a point [3] as plain numbers."""
    x, y, z = point.tolist()
    return (x, y, z)
