"""The section of a contact: its shape seen in a direction of rocking, its width over the depth, and the moments of
that.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import shapely
from numpy.typing import ArrayLike

from assess.declaration import UNCERTAIN, Evidence, Fault, PositiveLength
from assess.errors import GeometryError
from assess.geometry.solid import THINNEST, Corners
from assess.interfaces.kernel import columns
from assess.interfaces.kernel.columns import BEGIN, EDGE, RADIUS, SIGN, W0, W1
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray

DirectionVector = Sequence[float] | FloatArray
ALONG_X: DirectionVector = (1.0, 0.0)
ROUNDING = 1e-14  # of the depth: vertices no further apart are at one depth


JointSize = Annotated[PositiveLength, UNCERTAIN, Evidence("drawn", "up", "the outline of the mesh at the hinge")]
CONTACT_SIZES = {
    "rectangle": "[t, l]",
    "hollow_rectangle": "[t, l, t_in, l_in]",
    "circle": "d",
    "annulus": "[d, d_in]",
    "polygon": "[[x, y], …]",
}


@dataclass(frozen=True, kw_only=True)
class Shape:
    """The contact by one of its sizes, the first along the direction of motion, the second across."""

    rectangle: tuple[JointSize, JointSize] | None = None
    """[thickness, length]"""
    hollow_rectangle: tuple[JointSize, JointSize, JointSize, JointSize] | None = None
    """[thickness, length, inner thickness, inner length]"""
    circle: JointSize | None = None
    """diameter"""
    annulus: tuple[JointSize, JointSize] | None = None
    """[diameter, inner diameter]"""
    polygon: Annotated[Corners, Evidence("drawn", "up", "the outline of the mesh at the hinge")] | None = None
    """corners [[x, y], …] in plan"""

    def faults(self) -> Iterator[Fault]:
        """Yield a second size beside the one that there must be, and a hole as large as the outline."""
        given = [key for key in CONTACT_SIZES if getattr(self, key) is not None]
        if len(given) != 1:
            yield given[-1] if given else "rectangle", f"one shape is needed, not {len(given)}"
        for key in ("hollow_rectangle", "annulus"):
            sizes = getattr(self, key) or ()
            for outside, inside in zip(sizes[: len(sizes) // 2], sizes[len(sizes) // 2 :], strict=True):
                if inside >= outside:
                    yield key, f"the hole, {inside:g} m, must be smaller than the outside, {outside:g} m"


@dataclass(frozen=True, repr=False)
class ContactSection(ShortRepr):
    """A plane region seen in one direction of rocking: pieces of linear width, and discs.

    The depth x runs from the compressed extreme fibre, 0, to the far one; the offset y along the axis of rotation
    from the centroid, positive to the left of the direction of rocking.

    depth : extent in the direction of rocking [m]; breadth : extent across [m]
    area : [m2]
    centroid : its distance from the compressed edge [m]
    pieces : begin of each piece, its width and the integral of the offset over the width as polynomials from there,
        moments up to there; a last row for the far edge; no rows for discs alone; see `kernel.moments` [m + 1, 12]
    discs : radius [m], depth of the disc's own edge [m] and 1 or -1 where it adds or takes away [d, 3]
    """

    depth: float
    breadth: float
    area: float
    centroid: float
    pieces: FloatArray
    discs: FloatArray

    @property
    def table(self) -> columns.MomentTable:
        """The arrays and numbers that the kernel reads."""
        return self.pieces, self.discs, self.depth, self.area, self.centroid


def rectangle(width: float, length: float, *, direction: DirectionVector = ALONG_X) -> ContactSection:
    """Return a rectangle rocking in a direction of its plane.

    Parameters
    ----------
    width, length : along x and along y [m]
    direction : (x, y), of any length
    """
    return polygon(_centred_box(width, length), direction=direction)


def hollow_rectangle(
    width: float, length: float, *, inner: tuple[float, float], direction: DirectionVector = ALONG_X
) -> ContactSection:
    """Return a rectangle with a concentric rectangular hole.

    Parameters
    ----------
    width, length : along x and along y [m]
    inner : width and length of the hole [m]
    direction : (x, y), of any length
    """
    _require_smaller_hole(inner[0], width, "width")
    _require_smaller_hole(inner[1], length, "length")
    frame = shapely.Polygon(_centred_box(width, length).exterior, holes=[_centred_box(*inner).exterior])
    return polygon(frame, direction=direction)


def circle(diameter: float) -> ContactSection:
    """Return a disc of the diameter [m]."""
    return _section_of_discs(_require_size("diameter", diameter) / 2.0)


def annulus(diameter: float, *, inner: float) -> ContactSection:
    """Return a disc with a concentric hole.

    Parameters
    ----------
    diameter : of the disc [m]
    inner : diameter of the hole [m]
    """
    _require_smaller_hole(_require_size("inner diameter", inner), _require_size("diameter", diameter), "diameter")
    return _section_of_discs(diameter / 2.0, inner=inner / 2.0)


def polygon(region: shapely.Polygon | shapely.MultiPolygon, *, direction: DirectionVector) -> ContactSection:
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
    _require_area(region)
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
    return _section_of_pieces(knots, widths=widths, sides=sides, breadth=float(np.ptp(across)))


def mirror(section: ContactSection) -> ContactSection:
    """Return the same region rocking the other way."""
    if not section.pieces.size:
        return section  # discs are concentric
    X, (W0, W1, V0, V1, V2) = section.pieces[::-1, columns.BEGIN], section.pieces[-2::-1, columns.W0 : columns.A].T
    L = -np.diff(X)
    widths = np.column_stack([W0 + W1 * L, W0])
    sides = np.column_stack([V0 + d * (V1 + d * V2) for d in (L, L / 2.0, 0.0 * L)])
    return _section_of_pieces(X[0] - X, widths=widths, sides=-sides, breadth=section.breadth)


POINTS, WEIGHTS = np.polynomial.legendre.leggauss(64)

EXACT_POINTS, EXACT_WEIGHTS = np.polynomial.legendre.leggauss(3)
"""Of Gauss' rule: over angles of a disc; and over a piece of linear width, where the integrand is a cubic at most."""


def stress_integrals(
    section: ContactSection, *, start: float, end: float, stress: tuple[float, float]
) -> tuple[float, float]:
    """Return the force [N] and its first moment about the compressed edge [N m] of a stress linear over depth.

    Parameters
    ----------
    section : of the contact
    start, end : depths between which it acts [m]
    stress : at the start and at the end [Pa]

    Returns
    -------
    Integrals of sigma w dx and of sigma x w dx.
    """
    force, moment = 0.0, 0.0
    for x, area in _strips(section, start, end):
        sigma = stress[0] + (stress[1] - stress[0]) * (x - start) / (end - start)
        force += float(sigma @ area)
        moment += float((sigma * x) @ area)
    return force, moment


def _widths(edges: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return knots [m + 1], widths [m, 2] and sides [m, 3] of a region, see `_section_of_pieces`.

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


def _centred_box(width: float, length: float) -> shapely.Polygon:
    """Return a rectangle centred on the origin."""
    x, y = _require_size("width", width) / 2.0, _require_size("length", length) / 2.0
    return shapely.box(-x, -y, x, y)


def _require_size(what: str, value: float) -> float:
    """Return the value, or raise GeometryError if it is not a size."""
    if not (np.isfinite(value) and value > 0.0):
        raise GeometryError(f"section: its {what} is {value:g} m; give a positive finite number")
    return float(value)


def _require_smaller_hole(inner: float, outer: float, what: str) -> None:
    """Raise GeometryError for a hole that leaves nothing."""
    if inner >= outer:
        raise GeometryError(f"section: the {what} of its hole, {inner:g} m, is not less than its own, {outer:g} m")


def _require_area(region: shapely.Polygon | shapely.MultiPolygon) -> None:
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


def _unit(direction: DirectionVector) -> FloatArray:
    """Return the unit vector [2] of a direction of any length, or raise GeometryError."""
    vector = np.asarray(direction, dtype=np.float64)
    if vector.shape != (2,) or not np.isfinite(vector).all() or not vector.any():
        raise GeometryError(f"section: its direction is {list(direction)}; give two finite numbers, not both zero")
    vector = vector / np.abs(vector).max()  # first, so that the norm of tiny or huge numbers keeps its digits
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)


def _section_of_pieces(knots: ArrayLike, *, widths: ArrayLike, sides: ArrayLike, breadth: float) -> ContactSection:
    """Make a section whose width is linear between knots.

    Parameters
    ----------
    knots : depths from 0, increasing [m + 1] [m]
    widths : at the start and end of each piece, which need not match those of the next one [m, 2] [m]
    sides : integral of the offset from the centroid over the width, at the start, middle and end of each piece
        [m, 3] [m2]
    breadth : extent across [m]
    """
    X, w, v = (np.asarray(each, dtype=np.float64) for each in (knots, widths, sides))
    L = np.diff(X)
    W0, W1 = w[:, 0], (w[:, 1] - w[:, 0]) / L
    V0, V2 = v[:, 0], 2.0 * (v[:, 2] - 2.0 * v[:, 1] + v[:, 0]) / L**2
    V1 = (v[:, 2] - v[:, 0]) / L - V2 * L
    x = X[:-1]
    A, S, T = (_cumulative(_integral(each, L)) for each in ((W0, W1), (x * W0, x * W1 + W0, W1), (V0, V1, V2)))
    rises = (W0, W1 / 2.0), (x * W0, (x * W1 + W0) / 2.0, W1 / 3.0), (V0, V1 / 2.0, V2 / 3.0)
    sums = (_cumulative(_integral((each[:-1], *rise), L)) for each, rise in zip((A, S, T), rises, strict=True))
    last = (np.append(each, 0.0) for each in (W0, W1, V0, V1, V2))
    pieces = np.column_stack([X, *last, A, S, T, *sums])
    return ContactSection(
        float(X[-1]),
        float(breadth),
        float(A[-1]),
        float(S[-1] / A[-1]),
        _read_only(pieces),
        _read_only(np.empty((0, 3))),
    )


def _section_of_discs(outer: float, *, inner: float = 0.0) -> ContactSection:
    """Make a disc of the outer radius with a concentric hole of the inner radius [m]."""
    discs = np.array([[outer, 0.0, 1.0], [inner, outer - inner, -1.0]])[: 2 if inner > 0.0 else 1]
    area = float(np.pi * (outer - inner) * (outer + inner))
    return ContactSection(
        2.0 * outer, 2.0 * outer, area, float(outer), _read_only(np.empty((0, 12))), _read_only(discs)
    )


def _integral(powers: Sequence[FloatArray], L: FloatArray) -> FloatArray:
    """Integrate polynomials, coefficients [m] lowest power first, over pieces of lengths L [m]."""
    return np.asarray(sum(c * L ** (n + 1) / (n + 1) for n, c in enumerate(powers)), dtype=np.float64)


def _cumulative(parts: FloatArray) -> FloatArray:
    """Return the sums up to the start of each piece, and to the end of the last one [m + 1]."""
    return np.append(0.0, np.cumsum(parts))


def _read_only(array: FloatArray) -> FloatArray:
    """Return the array, contiguous and read-only."""
    kept = np.ascontiguousarray(array)
    kept.setflags(write=False)
    return kept


def _strips(section: ContactSection, start: float, end: float) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Yield depths [m] with the area that each stands for [m2], a stretch at a time; areas of holes are negative."""
    for piece, after in zip(section.pieces[:-1], section.pieces[1:], strict=True):
        low, high = max(start, piece[BEGIN]), min(end, after[BEGIN])
        if low < high:
            x = 0.5 * (low + high) + 0.5 * (high - low) * EXACT_POINTS
            yield x, 0.5 * (high - low) * EXACT_WEIGHTS * (piece[W0] + piece[W1] * (x - piece[BEGIN]))
    for disc in section.discs:
        radius = disc[RADIUS]
        first, last = (np.arccos(np.clip(1.0 - (x - disc[EDGE]) / radius, -1.0, 1.0)) for x in (start, end))
        if first < last:
            angle = 0.5 * (first + last) + 0.5 * (last - first) * POINTS
            x = disc[EDGE] + radius * (1.0 - np.cos(angle))
            yield x, disc[SIGN] * (last - first) * WEIGHTS * (radius * np.sin(angle)) ** 2
