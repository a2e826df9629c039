"""Rhino files, .3dm. The only door to rhino3dm."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from assess.geometry.formats.parts import MeshFile, Part, moved, part

UNITS = {  # rhino3dm.UnitSystem [m]
    "Microns": 1e-6,
    "Millimeters": 1e-3,
    "Centimeters": 1e-2,
    "Decimeters": 0.1,
    "Meters": 1.0,
    "Kilometers": 1e3,
    "Inches": 0.0254,
    "Feet": 0.3048,
    "Yards": 0.9144,
}
DEEPEST = 50  # instances within instances


def read_3dm(file: Path) -> MeshFile:
    """Meshes, and the render meshes of polysurfaces and extrusions, of a Rhino file; block instances in their places.

    openNURBS does not mesh: a surface saved without its render mesh comes as a part without triangles.
    """
    import rhino3dm

    model = rhino3dm.File3dm.FromByteArray(file.read_bytes())
    if model is None:
        raise ValueError("not a Rhino file")
    found = [
        each for item in model.Objects if not item.Attributes.IsInstanceDefinitionObject for each in _of(item, model)
    ]
    unit = UNITS.get(model.Settings.ModelUnitSystem.name)
    return MeshFile(tuple(found), unit=unit, up="z")


def _of(item: Any, model: Any, depth: int = 0) -> Iterator[Part]:
    """The parts of one object of the file; without triangles where it has a surface but no mesh."""
    names = [item.Attributes.Name, str(item.Attributes.Id)]
    kind = type(item.Geometry).__name__
    if kind == "InstanceReference":
        if depth > DEEPEST:
            raise ValueError("its blocks hold one another without end")
        yield from _instance(item, model, names, depth)
    elif kind == "Mesh":
        yield _mesh(names, [item.Geometry])
    elif kind == "Extrusion":
        yield _mesh(names, [_render(item.Geometry)])
    elif kind in ("Brep", "SubD", "Surface", "NurbsSurface"):
        faces = item.Geometry.Faces if kind == "Brep" else ()
        yield _mesh(names, [_render(faces[i]) for i in range(len(faces))])


def _instance(item: Any, model: Any, names: list[str], depth: int) -> Iterator[Part]:
    """The parts of a block's definition, moved to where the instance stands."""
    reference = item.Geometry
    matrix = np.array(reference.Xform.ToFloatArray(True), dtype=np.float64).reshape(4, 4)
    definition = model.InstanceDefinitions.FindId(reference.ParentIdefId)
    for identifier in definition.GetObjectIds():
        for each in _of(model.Objects.FindId(identifier), model, depth + 1):
            placed = moved(each, matrix)
            yield Part((*(name for name in names if name), *each.names), placed.vertices, placed.triangles)


def _render(surface: Any) -> Any:
    """The render mesh of an extrusion or of a face, None where the file has none."""
    import rhino3dm

    return surface.GetMesh(rhino3dm.MeshType.Any)


def _mesh(names: list[str], meshes: list[Any]) -> Part:
    """The Rhino meshes of one object as one part; nothing where one of them is missing."""
    if not meshes or any(each is None for each in meshes):
        return part(names, np.empty((0, 3)), np.empty((0, 4), dtype=np.int64))
    corners = [np.array([[v.X, v.Y, v.Z] for v in each.Vertices], dtype=np.float64) for each in meshes]
    starts = np.cumsum([0, *(len(each) for each in corners)])
    faces = [
        np.array([each.Faces[i] for i in range(len(each.Faces))], dtype=np.int64).reshape(-1, 4) + start
        for each, start in zip(meshes, starts[:-1], strict=True)
    ]
    return part(names, np.concatenate(corners), np.concatenate(faces))  # a triangle repeats its third corner
