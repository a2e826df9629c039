"""Rhino files, .3dm; the only door to rhino3dm."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from assess.geometry.formats.isolation import run_in_subprocess
from assess.geometry.formats.mesh_file import (
    MAX_INSTANCES,
    Element,
    ElementMesh,
    MeshFile,
    element_without_mesh,
    file_from_meshes,
    make_element_mesh,
    transform,
)
from spectra.arrays import FloatArray

READ = "import sys, rhino3dm; sys.exit(rhino3dm.File3dm.FromByteArray(open(sys.argv[1], 'rb').read()) is None)"
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
MAX_DEPTH = 50  # instances within instances
SURFACES = ("Brep", "SubD", "Surface", "NurbsSurface", "Extrusion")
NO_MESH = (
    "it is a {kind} saved without its render mesh, and no program but Rhino meshes it; in Rhino set a shaded view and "
    'save (not "Save small"), or turn it into a mesh (_Mesh), or export the model as STEP'
)


def read_3dm(file: Path) -> MeshFile:
    """Read the meshes of a Rhino file, the render meshes of its polysurfaces and extrusions, and its block instances.

    openNURBS does not mesh: a surface saved without its render mesh is an element without triangles.
    """
    import rhino3dm

    refused = run_in_subprocess(READ, file, name="openNURBS")  # after tens of seconds of some damaged files
    model = None if refused else rhino3dm.File3dm.FromByteArray(file.read_bytes())
    if model is None:
        raise ValueError("not a Rhino file")
    found: list[ElementMesh] = []
    for item in model.Objects:
        if not item.Attributes.IsInstanceDefinitionObject:
            for each in _object_meshes(item, model):
                found.append(each)
                if len(found) > MAX_INSTANCES:
                    raise ValueError(f"its blocks make more than {MAX_INSTANCES} parts")
    return file_from_meshes(found, unit=UNITS.get(model.Settings.ModelUnitSystem.name), up="z")


def _object_meshes(item: Any, model: Any, depth: int = 0) -> Iterator[ElementMesh]:
    """Return the meshes of one object of the file, without triangles where it has a surface but no mesh."""
    kind = type(item.Geometry).__name__
    names = (item.Attributes.Name,) if item.Attributes.Name else ()
    element = Element(names=names, identifier=str(item.Attributes.Id), kinds=(kind,))
    if kind == "InstanceReference":
        if depth > MAX_DEPTH:
            raise ValueError("its blocks hold one another without end")
        yield from _instance(item, model, element, depth)
    elif kind == "Mesh":
        yield _mesh(element, [item.Geometry])
    elif kind == "Extrusion":
        yield _mesh(element, [_render(item.Geometry)])
    elif kind in SURFACES:
        faces = item.Geometry.Faces if kind == "Brep" else ()
        yield _mesh(element, [_render(faces[i]) for i in range(len(faces))])


def _instance(item: Any, model: Any, element: Element, depth: int) -> Iterator[ElementMesh]:
    """Return the meshes of a block's definition, transformed to the instance."""
    reference = item.Geometry
    matrix = np.array(reference.Xform.ToFloatArray(True), dtype=np.float64).reshape(4, 4)
    definition = model.InstanceDefinitions.FindId(reference.ParentIdefId)
    for identifier in definition.GetObjectIds():
        for each in _object_meshes(model.Objects.FindId(identifier), model, depth + 1):
            own = each.element
            # the same object stands in every instance of its block
            within = (*element.names, element.identifier, *own.within, *own.names, own.identifier)
            one = replace(own, names=(), identifier=f"{element.identifier}/{own.identifier}", within=within)
            yield replace(transform(each, matrix), element=one)


def _render(surface: Any) -> Any:
    """Return the render mesh of an extrusion or of a face, None where the file has none."""
    import rhino3dm

    return surface.GetMesh(rhino3dm.MeshType.Any)


def _mesh(element: Element, meshes: list[Any]) -> ElementMesh:
    """Join the Rhino meshes of one object into one, without triangles where one of them is missing."""
    if not meshes or any(each is None for each in meshes):
        return element_without_mesh(element, NO_MESH.format(kind=_surface_name(element.kinds[0])))
    corners = [_points(each) for each in meshes]
    starts = np.cumsum([0, *(len(each) for each in corners)])
    faces = [
        np.array([each.Faces[i] for i in range(len(each.Faces))], dtype=np.int64).reshape(-1, 4) + start
        for each, start in zip(meshes, starts[:-1], strict=True)
    ]
    return make_element_mesh(
        element, np.concatenate(corners), np.concatenate(faces)
    )  # a triangle repeats its third corner


def _points(shape: Any) -> FloatArray:
    """Return the vertices of a Rhino mesh [n, 3], point by point, as rhino3dm provides them."""
    values = np.fromiter((value for v in shape.Vertices for value in (v.X, v.Y, v.Z)), dtype=np.float64)
    return values.reshape(-1, 3)


def _surface_name(kind: str) -> str:
    return {"Brep": "polysurface (Brep)", "SubD": "SubD"}.get(kind, f"surface ({kind})")
