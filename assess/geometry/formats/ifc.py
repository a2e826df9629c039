"""IFC files (ISO 16739), read and meshed by ifcopenshell in processes of its own; the only door to it.

Numbers that are none, or lost their decimal point, are refused here: ifcopenshell reads them without a warning. What
crashes it is a message, and where that is one element, the others are meshed.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from assess.geometry.formats.isolation import ReaderCrashError, call_in_subprocess
from assess.geometry.formats.mesh_file import Element, ElementMesh, MeshFile, element_without_mesh, make_element_mesh
from assess.geometry.formats.step import ANGULAR_DEFLECTION, refuse_damaged
from assess.messages.message import note

NOT_BUILT = ("IfcSpace", "IfcOpeningElement", "IfcVirtualElement", "IfcAnnotation", "IfcGrid")
NO_BODIES = ("Curve2D", "Curve3D", "Curve", "Point", "PointCloud", "Annotation2D", "GeometricCurveSet", "BoundingBox")

WHOLE_BODIES = (
    "IfcSolidModel", "IfcBooleanResult", "IfcFaceBasedSurfaceModel", "IfcShellBasedSurfaceModel",
    "IfcTessellatedItem", "IfcCsgPrimitive3D", "IfcMappedItem",
)  # fmt: skip
FAILED = re.compile(r"^\[error\].*Failed to convert:\s*#(\d+)=", re.MULTILINE)
MISSING = re.compile(r"^\[error\].*Instance reference #\d+ used by instance #(\d+)\b.* not found", re.MULTILINE)
SCHEMA, LONGEST_SCHEMA = re.compile(rb"FILE_SCHEMA\s*\(\s*\(\s*'([^']*)'"), 64
NOT_MEASURED = ("Axis", "FootPrint", "Box", "Annotation", "Profile", "Reference", "Clearance", "CoG", "Lighting")
UNMESHED = "its body could not be built from what the file says of it; repair or export this element again"
CRASHED = "IfcOpenShell crashed on it; draw this element again, or export it alone in another format"
KERNEL = "opencascade"  # others lose geometry without a message (IfcOpenShell 8052)
READER = "IfcOpenShell"
Storeys = tuple[tuple[str, float], ...]
"""The name and the elevation [m] of each storey, from the lowest up."""


def read_ifc(file: Path) -> MeshFile:
    """Read every element of a building model that has a body, less its openings, in metres and world coordinates.

    Only the elements selected are meshed, which takes nearly all of the time.
    """
    import ifcopenshell  # noqa: F401  # the caller reports its absence; it runs in a process of its own

    refuse_damaged(file)
    _refuse_schema(file)
    elements, storeys = call_in_subprocess(_read_elements, file, name=READER)
    return MeshFile(elements, partial(_mesh_selected, file, elements), unit=1.0, up="z", storeys=storeys)


def _mesh_selected(file: Path, elements: Sequence[Element], places: Sequence[int]) -> tuple[ElementMesh, ...]:
    """Mesh the selected elements; after a crash by halves, so that only the element that causes it has no mesh."""
    if not places:
        return ()
    try:
        meshes = call_in_subprocess(partial(_mesh_products, places=tuple(places)), file, name=READER)
    except ReaderCrashError:
        if len(places) == 1:
            return (element_without_mesh(elements[places[0]], CRASHED),)
        half = len(places) // 2
        return tuple(mesh for part in (places[:half], places[half:]) for mesh in _mesh_selected(file, elements, part))
    return tuple(replace(mesh, element=elements[place]) for mesh, place in zip(meshes, places, strict=True))


def _read_elements(file: Path) -> tuple[tuple[Element, ...], Storeys]:
    """Return the elements that have a body, and the storeys; raise where numbers or references are damaged."""
    model, missing = _open(file)
    _refuse_lost(model, missing)
    refuse_commas(file, cache(partial(_attributes, model.schema_identifier)))
    above = cache(partial(_classes, model.schema_identifier))
    scale = _unit_of(model)
    elements = tuple(_element(each, above, scale=scale) for each in _products(model))
    return elements, _storeys(model, scale=scale)


def _open(file: Path) -> tuple[Any, frozenset[int]]:
    """Open a model; with it, the numbers of the entities that refer to others absent from the file."""
    import ifcopenshell

    model = ifcopenshell.open(str(file))
    return model, frozenset(map(int, MISSING.findall(ifcopenshell.get_log())))


def _products(model: Any) -> list[Any]:
    """Return the products that have a body, in the order in which a file's elements are numbered."""
    return [each for each in model.by_type("IfcProduct") if _has_body(each)]


def _refuse_schema(file: Path) -> None:
    """Raise where the name of the schema is so long that ifcopenshell would crash on it."""
    found = SCHEMA.search(file.read_bytes())
    if found and len(found[1]) > LONGEST_SCHEMA:
        raise ValueError(f"{found[1].decode('latin-1'):.12}… is no name of a schema; it is damaged, export it again")


def _refuse_lost(model: Any, missing: Set[int]) -> None:
    """Raise where an absent entity would remove an element or an opening without a trace.

    missing : numbers of the entities that refer to others absent from the file
    """
    for number in sorted(missing):
        entity = model.by_id(number)
        shapeless = entity.is_a("IfcElement") and not entity.Representation
        empty = entity.is_a("IfcRepresentation") and not entity.Items
        if shapeless or empty or entity.is_a("IfcProductRepresentation") or entity.is_a("IfcRelVoidsElement"):
            raise ValueError(
                f"{entity.is_a()} #{number} refers to an entity that is not in it, so that an element or an opening "
                "would be lost; it is damaged, export it again"
            )


def _has_body(product: Any) -> bool:
    """Return whether an element is built and has a representation that may be its body."""
    shapes = getattr(product.Representation, "Representations", ()) if product.Representation else ()
    return not any(product.is_a(kind) for kind in NOT_BUILT) and any(
        shape.RepresentationIdentifier not in NOT_MEASURED and shape.RepresentationType not in NO_BODIES and shape.Items
        for shape in shapes
    )


def _element(product: Any, above: Any, *, scale: float) -> Element:
    """Return an element's names and classes, what it belongs to and what it is made of; scale: of the unit [m]."""
    owners = tuple(_owners(product))
    holders = [link.RelatingStructure for each in (product, *owners) for link in _links(each, "ContainedInStructure")]
    within = [word for each in owners for word in (each.Name, each.GlobalId, *above(each.is_a())) if word]
    return Element(
        names=(product.Name,) if product.Name else (),
        identifier=product.GlobalId,
        kinds=above(product.is_a()),
        storey=next((each.Name or each.is_a() for each in holders), ""),
        within=tuple(dict.fromkeys(within)),
        predefined=str(getattr(product, "PredefinedType", None) or ""),
        **_made_of(product, scale=scale),
    )


def _owners(product: Any) -> Iterator[Any]:
    """Return the assemblies that an element belongs to, the innermost first."""
    seen = {product.id()}
    links = _links(product, "Decomposes")
    while links:
        owner = links[0].RelatingObject
        if owner.id() in seen or not owner.is_a("IfcElement"):
            return
        seen.add(owner.id())
        yield owner
        links = _links(owner, "Decomposes")


def _links(product: Any, name: str) -> Sequence[Any]:
    return getattr(product, name, None) or ()


def _classes(schema: str, name: str) -> tuple[str, ...]:
    """Return a class and its superclasses, the most specific first."""
    from ifcopenshell import ifcopenshell_wrapper

    found, declaration = [], ifcopenshell_wrapper.schema_by_name(schema).declaration_by_name(name).as_entity()
    while declaration is not None:
        found.append(declaration.name())
        declaration = declaration.supertype()
    return tuple(found)


def _attributes(schema: str, name: str) -> int | None:
    """Return the number of attributes of a class; None where the schema has no such class."""
    from ifcopenshell import ifcopenshell_wrapper

    try:
        return int(ifcopenshell_wrapper.schema_by_name(schema).declaration_by_name(name).as_entity().attribute_count())
    except (RuntimeError, AttributeError):
        return None


def _mesh_products(file: Path, places: Sequence[int]) -> tuple[ElementMesh, ...]:
    """Mesh the elements at these indices; one without a mesh says why."""
    import ifcopenshell

    model, missing = _open(file)
    products = _products(model)
    selected = [products[i] for i in places]
    shapes = _shapes(model, selected)
    failed = {int(number) for number in FAILED.findall(ifcopenshell.get_log())}
    nothing = element_without_mesh(Element(), UNMESHED)
    found = []
    for product in selected:
        shape = shapes.get(product.id(), nothing)
        lost = [] if shape.fault or not failed | missing else _missing_items(model, product, failed, missing)
        found.append(replace(shape, warning=note("not-all-built", lost=", ".join(lost)) if lost else None))
    return tuple(found)


def _missing_items(model: Any, product: Any, failed: Set[int], missing: Set[int]) -> list[str]:
    """List the missing items of an element and its openings, and their bodies that failed; faces are skipped."""
    openings = [link.RelatedOpeningElement for link in _links(product, "HasOpenings")]
    made_of = [part for each in (product, *openings) for part in (each.Representation, each.ObjectPlacement) if part]
    owned = {item.id(): item for part in made_of for item in model.traverse(part)}.values()
    return sorted(
        f"{item.is_a()} #{item.id()}"
        for item in (product, *openings, *owned)
        if item.id() in missing or (item.id() in failed and any(map(item.is_a, WHOLE_BODIES)))
    )


def _shapes(model: Any, products: Sequence[Any]) -> Mapping[int, ElementMesh]:
    """Return the meshes that ifcopenshell makes, by the number of their element in the file."""
    import ifcopenshell.geom

    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    settings.set("mesher-angular-deflection", ANGULAR_DEFLECTION)
    iterator = ifcopenshell.geom.iterator(settings, model, include=list(products), geometry_library=KERNEL)
    found = {}
    more = iterator.initialize()
    while more:
        shape = iterator.get()
        faces = np.array(shape.geometry.faces, dtype=np.int64).reshape(-1, 3)
        if len(faces):
            found[shape.id] = make_element_mesh(Element(), np.array(shape.geometry.verts, dtype=np.float64), faces)
        more = iterator.next()
    return found


def _unit_of(model: Any) -> float:
    """Return the length of the unit of a model [m]."""
    from ifcopenshell.util.unit import calculate_unit_scale

    return float(calculate_unit_scale(model))


def _storeys(model: Any, *, scale: float) -> Storeys:
    """Return the name and the elevation [m] of each storey of a model, from the lowest up; scale: of the unit [m]."""
    from ifcopenshell.util.placement import get_local_placement

    found = []
    for storey in model.by_type("IfcBuildingStorey"):
        place = storey.ObjectPlacement
        level = storey.Elevation or 0.0 if place is None else get_local_placement(place)[2, 3]
        found.append((storey.Name or storey.is_a(), float(level) * scale))
    return tuple(sorted(found, key=lambda each: each[1]))


def _made_of(product: Any, *, scale: float) -> dict[str, Any]:
    """Return the layers of an element, and the density of the thickest where it is stated [kg/m3]."""
    from ifcopenshell.util.element import get_material

    whole = get_material(product, should_skip_usage=True)
    if whole is None:
        return {}
    parts: Sequence[Any] = next((found for name in MADE_OF if (found := getattr(whole, name, None))), (whole,))
    materials = [(getattr(each, "Material", None) or each, getattr(each, "LayerThickness", None)) for each in parts]
    named = [(m, None if size is None else float(size) * scale) for m, size in materials if hasattr(m, "Name")]
    thickest = max(named, key=lambda each: each[1] or 0.0, default=None)
    layers = tuple((material.Name or "", size) for material, size in named)
    return {"layers": layers, "density": None if thickest is None else _density_of(thickest[0])}


MADE_OF = ("MaterialLayers", "MaterialConstituents", "MaterialProfiles", "Materials")


def _density_of(material: Any) -> float | None:
    """Return the density that a material states [kg/m3]; None where it states none."""
    for group in _links(material, "HasProperties"):
        for each in getattr(group, "Properties", None) or getattr(group, "ExtendedProperties", None) or ():
            value = getattr(each, "NominalValue", None)
            if each.Name == "MassDensity" and value is not None and value.wrappedValue > 0.0:
                return float(value.wrappedValue)
    return None


COMMAS = "{what} has {found} values where it has {expected}; decimals take a point, not a comma"

SIZED = re.compile(
    rb"=\s*(IFC(?:\w+PROFILEDEF|\w+SOLID|\w+SOLIDTAPERED|CIRCLE|ELLIPSE|VECTOR|BLOCK|SPHERE|RECTANGULARPYRAMID|"
    rb"RIGHTCIRCULARCYLINDER|RIGHTCIRCULARCONE|SIUNIT|MEASUREWITHUNIT))\s*\(([^;]*)\)\s*;"
)
LIST = re.compile(rb"IFCCARTESIANPOINTLIST([23])D\s*\(\s*\(([^;]*?\))\s*\)[^;]*;")
DIRECTION = re.compile(rb"IFCDIRECTION\s*\(\s*\(([^()]*)\)\s*\)")
ZERO = re.compile(rb"\s*[-+]?0+\.?0*(?:E[-+]?\d+)?\s*", re.IGNORECASE)
POINT = re.compile(rb"IFC(?:CARTESIANPOINT|DIRECTION)\s*\(\s*\(([^()]*)\)\s*\)")
REAL = re.compile(rb"\s*[-+]?\d+\.\d*(?:E[-+]?\d+)?\s*", re.IGNORECASE)
WHOLE = re.compile(rb"\s*[-+]?\d+\s*")
HABIT = 0.01  # of the points: if more have whole numbers without a point, the program that wrote them leaves it out


def refuse_commas(file: Path, attributes: Callable[[str], int | None]) -> None:
    """Raise where points, profiles, solids or units have more or fewer values than possible.

    Parameters
    ----------
    attributes : number of attributes of a class of the file's schema; None where it has no such class

    Raises
    ------
    ValueError : a value is no number, or a number of values is impossible
    """
    text = re.sub(rb"/\*.*?\*/|'[^']*'", b"''", file.read_bytes(), flags=re.DOTALL)
    points = POINT.findall(text)
    for row in points:
        if not all(map(_is_finite, row.split(b","))):
            raise ValueError(f"({row.decode('latin-1'):.40}) in it are not numbers; it is damaged, export it again")
    for ratios in DIRECTION.findall(text):
        if all(map(ZERO.fullmatch, ratios.split(b","))):
            shown = ratios.decode("latin-1")
            raise ValueError(f"the direction ({shown:.40}) in it has no length; it is damaged, export it again")
    _points(points)
    for dimensions, rows in LIST.findall(text):
        for row in re.findall(rb"\(([^()]*)\)", rows):
            _coordinates(row.split(b","), {int(dimensions)})
    for name, arguments in SIZED.findall(text):
        expected, found = attributes(name.decode("latin-1")), _arguments(arguments)
        if expected not in (None, found):
            raise ValueError(COMMAS.format(what=f"an {name.decode('latin-1')}", found=found, expected=expected))


def _is_finite(value: bytes) -> bool:
    try:
        return not value.strip() or math.isfinite(float(value))
    except ValueError:
        return False


def _points(points: list[bytes]) -> None:
    rows = [point.split(b",") for point in points]
    for row in rows:
        _coordinates(row, {1, 2, 3})
    whole = [row for row in rows if any(map(WHOLE.fullmatch, row)) and any(map(REAL.fullmatch, row))]
    if whole and len(whole) <= HABIT * len(rows):
        shown = b",".join(whole[0]).decode("latin-1")
        raise ValueError(f"of the point ({shown:.40}) a number has no decimal point, as all others have")


def _coordinates(row: list[bytes], expected: set[int]) -> None:
    found = sum(1 for value in row if value.strip())
    if found != len(row) or found not in expected:
        raise ValueError(COMMAS.format(what="a point", found=len(row), expected=max(expected)))


def _arguments(text: bytes) -> int:
    """Count the arguments of an instance, a list as one."""
    inner = None
    while inner != text:
        inner, text = text, re.sub(rb"\([^()]*\)", b"", text)
    return text.count(b",") + 1
