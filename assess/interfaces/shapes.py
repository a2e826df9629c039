"""The shapes of a contact, each seen in a direction of rocking."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from assess.errors import GeometryError
from assess.interfaces.section import Section, section_of_discs, section_of_pieces
from spectra.arrays import FloatArray, IntArray

Direction = Sequence[float] | FloatArray

THINNEST = 1e-12  # of the extent squared: a region with less area is a line
ROUNDING = 1e-14  # of the depth: vertices no further apart are at one depth
ALONG: Direction = (1.0, 0.0)


def rectangle(width: float, length: float, *, direction: Direction = ALONG) -> Section:
    """Return a rectangle rocking in a direction of its plane.

    Parameters
    ----------
    width, length : along x and along y [m]
    direction : (x, y), of any length
    """
    return polygon(_box(width, length), direction=direction)


def hollow_rectangle(
    width: float, length: float, *, inner: tuple[float, float], direction: Direction = ALONG
) -> Section:
    """Return a rectangle with a concentric rectangular hole.

    Parameters
    ----------
    width, length : along x and along y [m]
    inner : width and length of the hole [m]
    direction : (x, y), of any length
    """
    _refuse_larger(inner[0], width, "width")
    _refuse_larger(inner[1], length, "length")
    frame = shapely.Polygon(_box(width, length).exterior, holes=[_box(*inner).exterior])
    return polygon(frame, direction=direction)


def circle(diameter: float) -> Section:
    """Return a disc of the diameter [m]."""
    return section_of_discs(_size("diameter", diameter) / 2.0)


def annulus(diameter: float, *, inner: float) -> Section:
    """Return a disc with a concentric hole.

    Parameters
    ----------
    diameter : of the disc [m]
    inner : diameter of the hole [m]
    """
    _refuse_larger(_size("inner diameter", inner), _size("diameter", diameter), "diameter")
    return section_of_discs(diameter / 2.0, inner=inner / 2.0)


def polygon(region: shapely.Polygon | shapely.MultiPolygon, *, direction: Direction) -> Section:
    """Return a region of one or several parts, concave or with holes, rocking in a direction of its plane.

    The compressed edge is the extreme fibre in that direction. Between two vertices the width is linear.

    Parameters
    ----------
    region : in x and y [m]
    direction : (x, y), of any length

    Raises
    ------
    GeometryError : the region has no area, crosses itself or holds a number that is not finite, or the direction has
        no length
    """
    _refuse_void(region)
    along = _unit(direction)
    middle = shapely.get_coordinates(region.centroid)[0]
    rings = [
        ring for part in shapely.get_parts(shapely.orient_polygons(region)) for ring in (part.exterior, *part.interiors)
    ]
    corners = [
        (shapely.get_coordinates(ring) - middle) @ np.column_stack([along, [-along[1], along[0]]]) for ring in rings
    ]
    reach = max(float(ring[:, 0].max()) for ring in corners)
    across = np.concatenate([ring[:, 1] for ring in corners])
    edges = np.concatenate([np.stack([ring[:-1], ring[1:]], axis=1) for ring in corners])
    edges[:, :, 0] = reach - edges[:, :, 0]
    knots, widths, sides = _widths(edges)
    return section_of_pieces(knots, widths=widths, sides=sides, breadth=float(np.ptp(across)))


def _widths(edges: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return knots [m + 1], widths [m, 2] and sides [m, 3] of a region, see `section_of_pieces`.

    edges : both ends (depth, offset) of each edge of its border, the region on its right in these axes [n, 2, 2] [m]

    A chord's length is the sum of the offsets of the edges it meets, those the border crosses downwards counted
    negative; so is twice the integral of the offset, of the squares.
    """
    knots, at = _knots(edges[:, :, 0])
    spans = np.abs(at[:, 1] - at[:, 0])
    edge = np.repeat(np.arange(len(edges)), spans)
    inside = np.arange(spans.sum()) - np.repeat(np.cumsum(spans) - spans, spans)
    piece = at.min(axis=1)[edge] + inside
    x0, x1, y0, y1 = *knots[at[edge]].T, *edges[edge, :, 1].T
    ends = knots[piece + np.array([[0], [1]])]
    y = y0 + (y1 - y0) * (ends - x0) / (x1 - x0)
    y = np.array([y[0], y.mean(axis=0), y[1]])
    sign = np.sign(x1 - x0)
    pieces = len(knots) - 1
    w, v = (
        np.array([np.bincount(piece, sign * each, minlength=pieces) for each in values]).T for values in (y, y**2 / 2.0)
    )
    return knots, np.maximum(w[:, [0, 2]], 0.0), v


def _knots(depths: FloatArray) -> tuple[FloatArray, IntArray]:
    """Return the distinct depths, increasing, and the index of each; depths that differ by rounding are one."""
    values, at = np.unique(depths, return_inverse=True)
    apart = np.append(True, np.diff(values) > ROUNDING * values[-1])
    return values[apart], (np.cumsum(apart) - 1)[at].reshape(depths.shape)


def _box(width: float, length: float) -> shapely.Polygon:
    """Return a rectangle centred on the origin."""
    x, y = _size("width", width) / 2.0, _size("length", length) / 2.0
    return shapely.box(-x, -y, x, y)


def _size(what: str, value: float) -> float:
    """Return the value, or raise GeometryError if it is not a size."""
    if not (np.isfinite(value) and value > 0.0):
        raise GeometryError(f"section: its {what} is {value:g} m; give a positive finite number")
    return float(value)


def _refuse_larger(inner: float, outer: float, what: str) -> None:
    """Raise GeometryError for a hole that leaves nothing."""
    if inner >= outer:
        raise GeometryError(f"section: the {what} of its hole, {inner:g} m, is not less than its own, {outer:g} m")


def _refuse_void(region: shapely.Polygon | shapely.MultiPolygon) -> None:
    """Raise GeometryError for a region without area, or that crosses itself."""
    if not np.isfinite(shapely.get_coordinates(region)).all():
        raise GeometryError("section: a corner is not two finite numbers")
    if not region.is_valid:
        raise GeometryError(
            "section: its sides cross or touch one another, or a hole is not inside; list the corners of each ring in "
            "order around it"
        )
    low_x, low_y, high_x, high_y = region.bounds if not region.is_empty else (0.0,) * 4
    if not region.area > THINNEST * max(high_x - low_x, high_y - low_y) ** 2:
        raise GeometryError(f"section: its area is {region.area:g} m2; give corners that enclose one")


def _unit(direction: Direction) -> FloatArray:
    """Return the unit vector [2] of a direction of any length, or raise GeometryError."""
    vector = np.asarray(direction, dtype=np.float64)
    if vector.shape != (2,) or not np.isfinite(vector).all() or not vector.any():
        raise GeometryError(f"section: its direction is {list(direction)}; give two finite numbers, not both zero")
    vector = vector / np.abs(vector).max()  # first, so that the norm of tiny or huge numbers keeps its digits
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)
