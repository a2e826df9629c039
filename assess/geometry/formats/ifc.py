"""IFC files (ISO 16739). The only door to ifcopenshell, which meshes them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assess.geometry.formats.part21 import refuse_cut_short
from assess.geometry.formats.parts import MeshFile, part

ANGULAR = 0.05  # rad: largest turn between neighbouring facets; a circle's area is then 0.04 % small
NOT_BUILT = ("IfcSpace", "IfcOpeningElement", "IfcVirtualElement", "IfcAnnotation", "IfcGrid")


def read_ifc(file: Path) -> MeshFile:
    """Every element of a building model that has a body, openings taken off, in metres and world coordinates.

    A part is called by its Name and by its GlobalId.
    """
    import ifcopenshell
    import ifcopenshell.geom

    refuse_cut_short(file)
    model = ifcopenshell.open(str(file))
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    settings.set("mesher-angular-deflection", ANGULAR)
    iterator = ifcopenshell.geom.iterator(settings, model, exclude=list(NOT_BUILT))
    found = []
    more = iterator.initialize()
    while more:
        shape = iterator.get()
        corners = np.array(shape.geometry.verts, dtype=np.float64).reshape(-1, 3)
        faces = np.array(shape.geometry.faces, dtype=np.int64).reshape(-1, 3)
        found.append(part([shape.name, shape.guid], corners, faces))
        more = iterator.next()
    return MeshFile(tuple(each for each in found if len(each.triangles)), unit=1.0, up="z")
