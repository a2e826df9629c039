"""Where the plates of ties sit: the leaf behind them, edges and openings, weight above, and ties of the same row.

Seen along the tie, across which its wall is taken to lie:

    z ^   +------------------------------+  top: no side of a cone above it
      |   |     [#]    bay     [#]       |  cones that meet punch together
      |   |            +---+             |
      +   |            |   |             |  openings and ends: no side there
          +------------------------------+---> s
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from math import hypot, inf, isfinite

import numpy as np
import shapely

from assess.errors import GeometryError
from assess.geometry.cut import Piece, section_edges
from assess.geometry.solid import Solid
from assess.geometry.surface import volume
from assess.loads.anchorage import (
    CLOSE,
    LEVEL,
    Anchorage,
    Figure,
    PlateSite,
    Way,
    cones_meet,
    farthest_edge,
    no_weight,
    plate_area,
    plate_shape,
    punching_strength,
    weakest_cone,
)
from assess.loads.load import LoadDefinition, TieLoad
from spectra.arrays import FloatArray
from spectra.gravity import g

LAYERS = 12  # of a column of masonry above a cone, whose thicknesses are averaged
SLIGHT = 1e-3  # m: by which an edge that is not straight is simplified
BESIDE = 1e-4  # m: by which a column stands beside an edge
INSET = 0.37  # of half a plate: places behind it where the leaf is measured, beside its centre
SLIVER = 1e-6  # m: by which triangles that meet are joined
OFF_FACE = 0.05  # m: of an uneven wall, by which a plate may be off the face that is drawn
STICKS_OUT = 1e-3  # m: by which a plate may do so within rounding of a drawing
SAME_FACE = 0.87  # cosine of 30 degrees: ties that are less askew are on one face of a wall
MORE = 1.001  # times the drawn thickness, beyond which a leaf that is stated contradicts the drawing


@dataclass(frozen=True, eq=False)
class Wall:
    """A block as a plate meets it: its solids, and unit vectors along the wall and out of it [3]."""

    solids: tuple[Solid, ...]
    across: FloatArray
    out: FloatArray


def anchorages_of(loads: Sequence[LoadDefinition], pieces: Sequence[Piece], *, where: str) -> dict[int, Anchorage]:
    """Return the anchorage of each tie with a plate, by its place among the loads.

    Parameters
    ----------
    loads : of the mechanism
    pieces : its blocks, or all in one
    where : the mechanism, for errors

    Raises
    ------
    GeometryError : a plate off the outer face or the edge of the wall, no masonry behind it, or a leaf thicker than the
        body that is drawn
    """
    plates = {place: each for place, each in enumerate(loads) if isinstance(each, TieLoad) and each.plate is not None}
    return {
        place: _anchorage(
            tie,
            [each for other, each in plates.items() if other != place],
            pieces,
            where=f"{where}: loads[{place + 1}].plate",
        )
        for place, tie in plates.items()
    }


def _anchorage(tie: TieLoad, beside: Sequence[TieLoad], pieces: Sequence[Piece], *, where: str) -> Anchorage:
    """Return the anchorage of a tie; beside: the other ties of its mechanism."""
    assert tie.plate is not None
    number, out = min(tie.block, len(pieces) - 1), outwards(tie)
    if out is None:
        raise GeometryError(f"{where}: its tie is upright; a plate on the face of a wall holds one that is level")
    wall = Wall(pieces[number].solids, np.array([-out[1], out[0], 0.0]), out)
    if not wall.solids:
        site = PlateSite(None, plate_area(tie.plate), None, 1, (0.0, 0.0), None, at_end=False)
    else:
        site = _site(tie, _on_face(beside, wall), _on_face(tie.others, wall), wall, where=where)
    return Anchorage(tie.plate, site, tie.area or 0.0, tie.yield_stress or 0.0, tie.strength)


def outwards(tie: TieLoad) -> FloatArray | None:
    """Return the level unit vector from the anchor to the plate [3]; None for an upright tie."""
    way = np.subtract(tie.at, tie.anchor or tie.at) * (1.0, 1.0, 0.0)
    length = float(np.hypot(way[0], way[1]))
    return way / length if length > SLIVER else None


def _on_face(ties: Sequence[TieLoad], wall: Wall) -> list[Figure]:
    """Return the plates of ties that are on one face of a wall."""
    sides = [(each, outwards(each)) for each in ties]
    figures = [_figure(each, wall) for each, side in sides if side is not None and float(side @ wall.out) > SAME_FACE]
    return [each for each in figures if _leaf(wall, each) is not None]


def _site(tie: TieLoad, row: Sequence[Figure], others: Sequence[Figure], wall: Wall, *, where: str) -> PlateSite:
    figure = _figure(tie, wall)
    plate = figure[0]
    drawn = _leaf(wall, figure)
    if drawn is None:
        raise GeometryError(f"{where}: no masonry behind it at the place of the tie; check `at`, and block")
    face, given = _outer_face(wall, figure), float(np.dot(tie.at, wall.out))
    if abs(face - given) > OFF_FACE:
        right = np.round(np.array(tie.at) + (face - given) * wall.out, 3) + 0.0
        raise GeometryError(
            f"{where}: `at` is {abs(face - given):.3g} m off the outer face, on which a plate lies, on the side away "
            f"from the anchor; there it is at = [{', '.join(f'{each:g}' for each in right)}]"
        )
    if plate.leaf is not None and plate.leaf > MORE * drawn:
        raise GeometryError(
            f"{where}.leaf = {plate.leaf:.4g} m: the body that is drawn is {drawn:.4g} m thick there; give the "
            "thickness of the leaf that the plate grips"
        )
    if any(_overlap(figure, each) for each in row):
        raise GeometryError(
            f"{where}: overlaps the plate of another tie; move one, or write both as one tie with the area of both bars"
        )
    leaf = drawn if plate.leaf is None else plate.leaf
    figures = meeting_cones(figure, [*row, *others], leaf)
    reach = farthest_edge(figures, leaf) + leaf + max(max(each[0].sides) for each in figures)
    seen = elevation_around(wall, [(each[1], each[2]) for each in figures], reach)
    behind = shapely.intersection(plate_shape(figure), seen)
    if (beyond := float(shapely.hausdorff_distance(plate_shape(figure), behind))) > STICKS_OUT:
        raise GeometryError(
            f"{where}: sticks out by {beyond * 1e3:.0f} mm beyond the edge of the wall, its top or into an "
            "opening, and masonry behind a part of it does not bear evenly; move it, or take a smaller one"
        )
    cones = [
        (n, *weakest_cone(figures[:n], leaf, seen, _weight_above(wall, figures[:n], leaf, drawn, seen)))
        for n in range(1, len(figures) + 1)
    ]
    number, together, weight = min(
        cones[1:] or cones, key=lambda each: (punching_strength(plate, each[1], each[0], each[2]), each[1] / each[0])
    )
    bay, at_end = _bay(figure, row, wall)
    return PlateSite(
        leaf=drawn,
        bearing_area=min(plate_area(plate), float(shapely.area(behind))),
        surface=(cones[0][1], together),
        group=number,
        weights=(cones[0][2], weight),
        bay=bay,
        at_end=at_end,
        meeting=len(figures),
        beds=_beds(figure, seen),
    )


def _beds(figure: Figure, seen: shapely.Geometry) -> float:
    """Return the part of the beds above and below what a plate presses that is in the wall, from 0 to 2."""
    plate, s, z = figure
    width, height = plate.sides
    if plate.course is None:
        return 2.0
    ends = ((z + height / 2.0, z + height / 2.0 + plate.course), (z - height / 2.0 - plate.course, z - height / 2.0))
    strips = [shapely.box(s - width / 2.0, low, s + width / 2.0, high) for low, high in ends]
    return sum(float(shapely.area(shapely.intersection(each, seen))) / (width * plate.course) for each in strips)


def _figure(tie: TieLoad, wall: Wall) -> Figure:
    assert tie.plate is not None
    return tie.plate, float(np.dot(tie.at, wall.across)), float(tie.at[2])


def meeting_cones(figure: Figure, others: Sequence[Figure], depth: float) -> list[Figure]:
    """Return the plates whose cones meet that of one, or that of another of them, the nearest first.

    Plates that overlap are one, which several mechanisms have.

    Parameters
    ----------
    figure : the one; others : on the same face
    depth : of the cones [m]
    """
    left: list[Figure] = []
    for each in others:
        if not any(_overlap(each, one) for one in (figure, *left)):
            left.append(each)
    found = [figure]
    for one in found:  # grows as it goes
        meeting = [each for each in left if cones_meet(one, each, depth)]
        found += meeting
        left = [each for each in left if not any(each is met for met in meeting)]
    return sorted(found, key=lambda each: hypot(each[1] - figure[1], each[2] - figure[2]))


def _overlap(one: Figure, other: Figure) -> bool:
    return float(shapely.area(shapely.intersection(plate_shape(one), plate_shape(other)))) > SLIVER


def _faces(wall: Wall) -> Iterator[tuple[Solid, FloatArray, FloatArray]]:
    """Yield the triangles of each solid as seen along the normal [n, 3, 2], with their depths outwards [n, 3]."""
    for solid in wall.solids:
        corners = solid.vertices[solid.triangles]
        yield solid, np.stack([corners @ wall.across, corners[..., 2]], axis=-1), corners @ wall.out


def _leaf(wall: Wall, figure: Figure) -> float | None:
    """Return the least thickness of the outermost solid behind a plate [m]; None where there is none."""
    return min((thickness for _, thickness in _behind(wall, figure)), default=None)


def _outer_face(wall: Wall, figure: Figure) -> float:
    """Return how far outwards the face of the wall behind a plate is, its middle where there is masonry [m]."""
    return _behind(wall, figure)[0][0]


def _behind(wall: Wall, figure: Figure) -> list[tuple[float, float]]:
    """Return what `run_through` finds behind the middle of a plate and its quarters, as far as there is anything."""
    plate, s, z = figure
    width, height = plate.sides
    shifts = [(0.01, 0.013), *((x, y) for x in (-INSET, INSET) for y in (-INSET * 1.01, INSET * 0.99))]
    found = [run_through(wall, s + x * width / 2.0, z + y * height / 2.0) for x, y in shifts]
    return [each for each in found if each is not None]


def run_through(wall: Wall, s: float, z: float) -> tuple[float, float] | None:
    """Return face and thickness of the outermost solid along a line through it [m]; None if the line misses all."""
    found = max(_runs(wall, s, z), default=None)
    return None if found is None else found[:2]


def _runs(wall: Wall, s: float, z: float) -> Iterator[tuple[float, float, float]]:
    """Yield face, thickness and density [kg/m3] of each solid along a line through it."""
    for solid, seen, depth in _faces(wall):
        a, b, c = seen[:, 0], seen[:, 1], seen[:, 2]
        area = _turn(b - a, c - a)
        flat = np.abs(area) < SLIVER**2
        size = np.where(flat, 1.0, area)
        at = np.array([s, z])
        v, w = _turn(at - a, c - a) / size, _turn(b - a, at - a) / size
        hit = ~flat & (v >= 0.0) & (w >= 0.0) & (v + w <= 1.0)
        met = np.unique(np.round((depth[:, 0] * (1.0 - v - w) + depth[:, 1] * v + depth[:, 2] * w)[hit], 9))
        if met.size > 1:
            density = solid.mass / volume(solid.vertices, solid.triangles)
            yield float(met[-1]), float(met[-1] - met[-2]), density


def elevation_around(wall: Wall, places: Sequence[tuple[float, float]], reach: float) -> shapely.Geometry:
    """Return the wall around and above some places as seen along its normal, with openings that go through it.

    Parameters
    ----------
    wall : as seen
    places : (s, z) of each; reach : around them [m]
    """
    first, last = np.min(places, axis=0) - reach, np.max(places, axis=0) + reach
    last[1] = max(last[1], *(solid.bounds[1][2] for solid in wall.solids))
    near = shapely.box(*first, *last)
    parts = []
    for _, seen, _ in _faces(wall):
        low, high = seen.min(axis=1), seen.max(axis=1)
        close = ((low <= last) & (high >= first)).all(axis=1)
        facing = close & (_turn(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0]) > 0.0)
        parts += list(shapely.polygons(seen[facing]))
    joined = shapely.union_all(shapely.buffer(parts, SLIVER, join_style="mitre"))
    whole: shapely.Geometry = shapely.intersection(shapely.buffer(joined, -SLIVER, join_style="mitre"), near)
    return whole


def _weight_above(
    wall: Wall, figures: Sequence[Figure], leaf: float, drawn: float, seen: shapely.Geometry
) -> Callable[[Way], float]:
    """Return what finds the weight of the masonry above a cone, over the area of the leaf, by the way it runs out [Pa].

    It is that of the least column above the outline, up to the next opening or the top. What runs up to an edge has
    none above it, and what runs down to one none that is sure to press there. Beside the plates, where an end or an
    opening leaves no masonry, there is no side to press on.
    """
    bounds = [shapely.bounds(plate_shape(each)) for each in figures]
    edges = shapely.get_coordinates(shapely.simplify(seen, SLIGHT))[:, 0]

    @cache
    def column(s: float, low: float, level: float) -> float:
        return _column(wall, seen, drawn, s, low=low, level=level)

    def least(first: float, last: float, low: float, level: float) -> float:
        inside = edges[(edges > first) & (edges < last)]
        places = {first, last, *np.round([*(inside - BESIDE), *(inside + BESIDE)], 5).tolist()}
        return min(column(s, low, level) for s in sorted(places) if first <= s <= last)

    @cache
    def above(west: float, east: float) -> float:
        if west == inf and east == -inf:
            return min(least(each[0] - leaf, each[2] + leaf, each[1], each[3] + leaf) for each in bounds)
        first, low = np.min(bounds, axis=0)[:2].tolist()
        last, high = np.max(bounds, axis=0)[2:].tolist()
        return least(min(first - leaf, west), max(last + leaf, east), low, high + leaf)

    def weight(way: Way) -> float:
        found = 0.0 if isfinite(way[1]) or isfinite(way[3]) else above(way[0], way[2])
        return found if isfinite(found) else 0.0

    return weight if figures[0][0].friction else no_weight


def _column(wall: Wall, seen: shapely.Geometry, drawn: float, s: float, *, low: float, level: float) -> float:
    """Return the weight of the column of masonry above a level at a place, over the area of the leaf [Pa].

    inf where no masonry is at the place between the plate's lower edge and that level; of what is thicker there than
    behind the plate, `drawn` [m], no more than that counts.
    """
    _, bottom, _, top = shapely.bounds(seen)
    runs = shapely.get_parts(shapely.intersection(seen, shapely.LineString([(s, bottom), (s, top)])))
    ends = [shapely.bounds(run)[[1, 3]] for run in runs]
    end = max((high for start, high in ends if start < level and high > low), default=None)
    if end is None:
        return inf
    if end <= level:
        return 0.0
    levels = level + (end - level) * (np.arange(LAYERS) + 0.5) / LAYERS
    met = [max(_runs(wall, s, z), default=None) for z in levels.tolist()]
    layers = [each[2] * min(each[1] / drawn, 1.0) for each in met if each is not None]
    return float(g * (end - level) * sum(layers) / LAYERS)


def _bay(figure: Figure, others: Sequence[Figure], wall: Wall) -> tuple[float, bool]:
    """Return the farthest distance to the next tie of a row, or twice that to an end of the wall; whether to an end.

    An end that is too far comes before a bay, however wide, which an arch may span. The thrust of an arch beside the
    outermost tie would have to be taken by the end of the wall, of which that is not known: such a bay is at an end.
    """
    _, s, z = figure
    edges = np.array([section_edges(solid, [z], direction=wall.across.tolist())[0] for solid in wall.solids])
    first, last = float(edges[:, 0].min()), float(edges[:, 1].max())
    row = sorted({each[1] for each in others if abs(each[2] - z) <= LEVEL} | {s})
    bays = [(b - a, {a, b}) for a, b in pairwise(row) if s in (a, b)]
    inner = [bay for bay, _ in bays]
    ends = [2.0 * (s - first)] * (s == row[0]) + [2.0 * (last - s)] * (s == row[-1])
    ends += [bay for bay, between in bays if bay > CLOSE and between & {row[0], row[-1]}]
    to_end, to_next = max(ends, default=0.0), max(inner, default=0.0)
    return (to_end, True) if to_end > CLOSE or to_end >= to_next else (to_next, False)


def _turn(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return the cross product of vectors in the plane [n, 2]."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])
