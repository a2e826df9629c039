"""Plausibility of a body's size and coordinates, and the unit that was probably meant where they are not."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.errors import GeometryError
from assess.geometry.solid import Solid
from assess.geometry.surface import area, volume
from assess.geometry.thickness import extents, thin_direction
from assess.messages.message import Message, Quantity, Value, warning

LARGEST = 300.0  # m: no masonry body is longer
SMALLEST = 0.03  # m: none is shorter
USUAL = 5.0  # m: a body's usual length
UNITS = {"mm": 1e-3, "cm": 1e-2, "in": 0.0254, "ft": 0.3048, "m": 1.0, "km": 1e3}  # m
WALL_LENGTH = (1.0, 100.0)  # m: of the longest side of a usual wall
WALL_THICKNESS = (0.1, 3.0)  # m
TALL = 50.0  # m: a body that is longer and thicker than a usual wall suggests another unit
COARSE = 1e-4  # of the body's size: rounding of coordinates that moves results
TOO_COARSE = 0.01  # of its thickness: rounding that spoils them
SAME = 1e-12  # of the farthest coordinate: rounding of a change of units


def refuse_implausible(solid: Solid, *, unit: float, given: bool, single: bool, where: str) -> None:
    """Raise where a mesh cannot be a masonry body, by its size or by the precision of its coordinates.

    A small specimen is accepted where the project gives its unit.

    Parameters
    ----------
    solid : the body
    unit : length that the mesh was read in [m]
    given : whether the project gives that unit
    single : whether the file holds single precision; another with such numbers may have been drawn so
    where : named in errors

    Raises
    ------
    GeometryError : the body is longer than 300 m, or shorter than 3 cm without a given unit; its coordinates are in
        single precision that resolves no better than a hundredth of its thickness
    """
    size = _size(solid)
    if size > LARGEST or (size < SMALLEST and not given):
        limit = f"more than {LARGEST:g}" if size > LARGEST else f"less than {SMALLEST:g}"
        remedy = "give another mesh_unit" if given else "give mesh_unit, the unit of its coordinates"
        likely = _likely_unit(solid, unit=unit)
        hint = "No usual unit makes it a wall; check the model"
        if likely is not None:
            hint = f'With mesh_unit = "{likely.name}" it would measure {likely.size:.4g} m'
        raise GeometryError(
            f"{where}: it measures {size:.4g} m at its longest, {limit} m, which no masonry body does; {remedy}. {hint}"
        )
    resolution = _resolution(solid, unit=unit) if single else 0.0
    if resolution > 0.0 and resolution > TOO_COARSE * (thickness := _thickness(solid)):
        raise GeometryError(
            f"{where}: its coordinates are in single precision, which {np.abs(solid.vertices).max():.4g} m from the "
            f"origin resolves {resolution:.2g} m, more than 1 % of its thickness of {thickness:.3g} m; move the model "
            "near the origin before exporting it, or export it in double precision or as text"
        )


def size_warning(solid: Solid, *, unit: float | None = None) -> Message | None:
    """Return a warning where size or coordinates of a body suggest a slip, None otherwise.

    Parameters
    ----------
    solid : the body
    unit : length that the mesh was read in [m]; None for a body that is not a mesh
    """
    size = _size(solid)
    values: dict[str, Value] = {"body": solid.name, "size": Quantity(size, "length")}
    likely = None if unit is None else _likely_unit(solid, unit=unit)
    if likely is not None:
        values |= {"unit": likely.name, "other": Quantity(likely.size, "length")}
    behind = "" if likely is None else "-in-unit"
    if not SMALLEST <= size <= LARGEST:
        return warning(f"size{behind}", **values)
    if size > TALL and (thickness := _thickness(solid)) > WALL_THICKNESS[1]:
        return warning(f"size-thick{behind}", thickness=Quantity(thickness, "length", 3), **values)
    resolution = _resolution(solid, unit=unit or 1.0)
    if resolution > COARSE * size:
        distance, finest = float(np.abs(solid.vertices).max()), Quantity(resolution, "length", 2)
        return warning("far-from-origin", body=solid.name, distance=Quantity(distance, "length"), resolution=finest)
    return None


def _size(solid: Solid) -> float:
    """Return the longest side of the box around a body [m]."""
    return float(np.ptp(solid.vertices, axis=0).max())


def _thickness(solid: Solid) -> float:
    """Return the thickness of a body [m]: its least extent, or 1.5 times that of a plate of its volume and surface.

    The latter is less for walls that bend, and for several walls in one.
    """
    sides = extents(solid.vertices, thin_direction(solid.vertices, solid.triangles))
    plate = 2.0 * volume(solid.vertices, solid.triangles) / area(solid.vertices, solid.triangles)
    return min(*sides, 1.5 * plate)


def _resolution(solid: Solid, *, unit: float) -> float:
    """Return the spacing of single-precision numbers at a body's farthest coordinate [m].

    0 where coordinates hold more digits, and where they are so fine that they never matter.
    """
    farthest = float(np.abs(solid.vertices).max()) / unit
    spacing = float(np.spacing(np.float32(farthest)))
    if spacing * unit <= COARSE * _size(solid):
        return 0.0
    read = solid.vertices / unit
    single = np.abs(read - read.astype(np.float32)).max() <= SAME * farthest
    return spacing * unit if single else 0.0


@dataclass(frozen=True)
class _LikelyUnit:
    """The unit that was probably meant, and the longest side of the body in it [m]."""

    name: str
    size: float


def _likely_unit(solid: Solid, *, unit: float) -> _LikelyUnit | None:
    """Return the unit that makes a body a usual wall, or else gives it the size of one; None where none does."""
    length, thickness = _size(solid) / unit, _thickness(solid) / unit
    walls = [
        name
        for name, one in UNITS.items()
        if WALL_LENGTH[0] <= length * one <= WALL_LENGTH[1]
        and WALL_THICKNESS[0] <= thickness * one <= WALL_THICKNESS[1]
    ]
    likely = min(walls or UNITS, key=lambda name: abs(np.log(length * UNITS[name] / USUAL)))
    size = length * UNITS[likely]
    same = abs(UNITS[likely] / unit - 1.0) < SAME
    return None if same or not SMALLEST <= size <= LARGEST else _LikelyUnit(likely, size)
