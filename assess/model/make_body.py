"""Bodies from sizes, a profile or a file, each of one masonry."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from numpy.typing import ArrayLike

from assess.errors import GeometryError
from assess.geometry import mesh as meshes
from assess.geometry import solid as solids
from assess.geometry.mesh import read_selected_meshes
from assess.model.body import Body, Material


def box(
    *,
    thickness: float,
    length: float,
    height: float,
    density: float | Material,
    base: tuple[float, float, float] = (0.0, 0.0, 0.0),
    name: str = "box",
) -> Body:
    """Return a rectangular body.

    Parameters
    ----------
    thickness : size along x [m]
    length : size along y [m]
    height : size along z [m]
    density : mass per volume [kg/m3], or the masonry
    base : centre of the base face (x, y, z) [m]
    name : what errors and mechanisms call it

    Raises
    ------
    GeometryError : a size or the density is not a positive finite number
    """
    masonry = _masonry(density, name)
    made = solids.box(thickness=thickness, length=length, height=height, base=base, density=masonry.density, name=name)
    return Body(name=name, solid=made, material=masonry)


def profile(corners: ArrayLike, *, length: float, density: float | Material, name: str = "profile") -> Body:
    """Return a polygon in the x-z plane, extruded along y and centred on y = 0.

    Parameters
    ----------
    corners : (x, z) of the polygon in order [n, 2] [m]
    length : of the extrusion [m]
    density : mass per volume [kg/m3], or the masonry
    name : what errors and mechanisms call it

    Raises
    ------
    GeometryError : the polygon crosses itself or has no area, or a number is not positive
    """
    masonry = _masonry(density, name)
    made = solids.profile(corners, length=length, density=masonry.density, name=name)
    return Body(name=name, solid=made, material=masonry)


def mesh(
    path: str | Path,
    *,
    density: float | Material,
    unit: float | None = None,
    up: Literal["y", "z"] | None = None,
    element: str | None = None,
    name: str = "mesh",
) -> Body:
    """Return a body bounded by the triangle mesh of a file, mended where it is not closed.

    Parameters
    ----------
    path : STL, OBJ, PLY, OFF, GLB, glTF or 3MF; STEP, Rhino .3dm or IFC with the extra packages
    density : mass per volume [kg/m3], or the masonry
    unit : of the file's coordinates [m]; the file's own where None, metres where it states none
    up : axis of the file that points up, "y" or "z"; "y" for glTF and "z" for all others where None
    element : only elements of the file: a name, a GlobalId, a class like "IfcWall", or a pattern; all where None
    name : what errors and mechanisms call it

    Raises
    ------
    GeometryError : the file cannot be read, or its mesh cannot be closed
    """
    if not isinstance(path, str | Path):
        raise GeometryError(f'body "{name}": path = {path!r:.60}: give the path of one file')
    if element is not None and not isinstance(element, str):
        raise GeometryError(f'body "{name}": element = {element!r:.60}: give a text')
    if up not in ("y", "z", None):
        raise GeometryError(f'body "{name}": up = {up!r}: write "y" or "z"')
    masonry, asked = _masonry(density, name), (Path(path), element)
    model = read_selected_meshes({name: asked})[asked]
    made = meshes.solid_from_meshes(model, density=masonry.density, name=name, scale=unit, up=up)
    return Body(name=name, solid=made, material=masonry)


def _masonry(density: float | Material, name: str) -> Material:
    """Return the masonry of a body; raise GeometryError for a name that mechanisms cannot call it by."""
    if not isinstance(name, str) or not name:
        raise GeometryError(f"name = {name!r:.60}: give a text, by which mechanisms call the body")
    return density if isinstance(density, Material) else Material(name=name, density=density)
