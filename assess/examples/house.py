"""The model of the example `house`: two storeys of stone under a gabled roof, as an IFC file of our own making.

The file is plain text (ISO 10303-21), so that the program writes it without a reader of IFC. In metres: x along the
street, y away from it, z up; the street front and the back wall carry floor and roof, the side walls end in gables.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from string import ascii_lowercase, ascii_uppercase, digits

LENGTH, DEPTH, WALL = 9.0, 7.0, 0.5  # of the plan, over all; thickness of the walls
FLOOR, EAVES, RIDGE = 3.0, 6.0, 7.2  # top of the upper floor; top of the walls; underside of the ridge
SLAB, BEARING = 0.25, 0.25  # thickness of the upper floor; its depth in the walls
ROOF, GAP = 0.3, 0.05  # rafters and tiles, upright; space between gables and roof
STOREYS = {"Ground floor": 0.0, "Upper floor": FLOOR, "Roof": EAVES}
ALPHABET = digits + ascii_uppercase + ascii_lowercase + "_$"  # of identifiers in IFC

Point = tuple[float, float]


@dataclass(frozen=True)
class Prism:
    """A polygon drawn along an axis.

    corners : of the polygon, in plan (x, y) or, for a prism along x, in section (y, z) [m]
    start, length : along the axis [m]
    axis : "x" or "z"
    """

    corners: tuple[Point, ...]
    start: float
    length: float
    axis: str = "z"


@dataclass(frozen=True)
class IfcElement:
    """An element of the building: its class, name, storey and body, and the bodies of its openings by name."""

    kind: str
    name: str
    storey: str
    body: Prism
    openings: Mapping[str, Prism] = field(default_factory=dict)


class StepFile:
    """The lines of a file in the form of ISO 10303-21, numbered as they are added."""

    def __init__(self) -> None:
        """Begin without lines."""
        self.lines: list[str] = []

    def add(self, kind: str, *values: object) -> str:
        """Add an entity and return its reference."""
        self.lines.append(f"#{len(self.lines) + 1}={kind}({','.join(map(_value, values))});")
        return f"#{len(self.lines)}"

    def root(self, kind: str, name: str, *values: object) -> str:
        """Add an entity that has an identifier, made from its name, and no owner or description."""
        return self.add(kind, _quote(_identifier(f"{kind} {name}")), None, _quote(name), None, *values)

    def point(self, *at: float) -> str:
        """Add a point [m]."""
        return self.add("IFCCARTESIANPOINT", at)

    def direction(self, *along: float) -> str:
        """Add a direction."""
        return self.add("IFCDIRECTION", along)


def model() -> str:
    """Return the house as the text of an IFC4 file; the same text each time."""
    step = StepFile()
    axes = step.add("IFCAXIS2PLACEMENT3D", step.point(0.0, 0.0, 0.0), None, None)
    origin = step.add("IFCLOCALPLACEMENT", None, axes)
    context = step.add("IFCGEOMETRICREPRESENTATIONCONTEXT", None, "'Model'", "3", "1.E-5", axes, None)
    units = step.add("IFCUNITASSIGNMENT", [step.add("IFCSIUNIT", "*", ".LENGTHUNIT.", None, ".METRE.")])
    project = step.root("IFCPROJECT", "House", None, None, None, [context], units)
    building = step.root("IFCBUILDING", "House", None, origin, None, None, ".ELEMENT.", None, None, None)
    storeys = {
        name: step.root("IFCBUILDINGSTOREY", name, None, origin, None, None, ".ELEMENT.", elevation)
        for name, elevation in STOREYS.items()
    }
    step.root("IFCRELAGGREGATES", "Buildings", project, [building])
    step.root("IFCRELAGGREGATES", "Storeys", building, list(storeys.values()))
    placed = [(part.storey, _add_with_openings(step, part, context, origin)) for part in elements()]
    for name, storey in storeys.items():
        here = [element for at, element in placed if at == name]
        step.root("IFCRELCONTAINEDINSPATIALSTRUCTURE", name, here, storey)
    return "\n".join((*HEADER, *step.lines, "ENDSEC;", "END-ISO-10303-21;", ""))


HEADER = (
    "ISO-10303-21;",
    "HEADER;",
    "FILE_DESCRIPTION(('ViewDefinition [ReferenceView_V1.2]'),'2;1');",
    "FILE_NAME('house.ifc','2024-01-01T00:00:00',('assess'),(''),'assess','assess','');",
    "FILE_SCHEMA(('IFC4'));",
    "ENDSEC;",
    "DATA;",
)


def elements() -> tuple[IfcElement, ...]:
    """Return walls, floor and roof."""
    inner, back = DEPTH - WALL, DEPTH - BEARING
    end = LENGTH - WALL
    floor = _box((WALL, end), (BEARING, back), (FLOOR - SLAB, FLOOR))
    return (
        _wall("Street front", (0.0, WALL), floor, {"door": (3.9, 5.1, 0.0, 2.2), **_windows((1.4, 6.6))}),
        _wall("Back wall", (inner, DEPTH), floor, _windows((1.4, 4.0, 6.6))),
        IfcElement("IFCWALL", "Side wall left", "Ground floor", _gable(0.0)),
        IfcElement("IFCWALL", "Side wall right", "Ground floor", _gable(end)),
        IfcElement("IFCSLAB", "Upper floor", "Upper floor", floor),
        IfcElement("IFCROOF", "Roof", "Roof", _roof()),
    )


def _windows(places: Iterable[float]) -> dict[str, tuple[float, float, float, float]]:
    """Return windows of 1.0 m by 1.3 m on both storeys that begin at places along the wall."""
    return {f"window {x:g} {sill:g}": (x, x + 1.0, sill, sill + 1.3) for x in places for sill in (0.9, 3.9)}


def _wall(name: str, thick: Point, floor: Prism, holes: Mapping[str, tuple[float, float, float, float]]) -> IfcElement:
    """Return a wall along the street, with doors and windows, and the slot in which the floor rests.

    Parameters
    ----------
    name : of the element
    thick : between which y the wall is [m]
    floor : the prism of the floor
    holes : by name, each between two x and two z [m]
    """
    body = _box((0.0, LENGTH), thick, (0.0, EAVES))
    openings = {f"{name} {hole}": _box((x0, x1), thick, (z0, z1)) for hole, (x0, x1, z0, z1) in holes.items()}
    return IfcElement("IFCWALL", name, "Ground floor", body, openings | {f"{name} slot": floor})


def _gable(start: float) -> Prism:
    """Return a side wall, between the walls along the street, up to its gable under the roof."""
    inner, top = DEPTH - WALL, RIDGE - GAP
    corners = ((WALL, 0.0), (inner, 0.0), (inner, EAVES - GAP), (DEPTH / 2, top), (WALL, EAVES - GAP))
    return Prism(corners, start, WALL, axis="x")


def _roof() -> Prism:
    """Return the roof, seated level on the walls along the street."""
    inner = DEPTH - WALL
    under = ((0.0, EAVES), (WALL, EAVES), (DEPTH / 2, RIDGE), (inner, EAVES), (DEPTH, EAVES))
    over = ((DEPTH, EAVES + ROOF), (DEPTH / 2, RIDGE + ROOF), (0.0, EAVES + ROOF))
    return Prism((*under, *over), 0.0, LENGTH, axis="x")


def _box(x: Point, y: Point, z: Point) -> Prism:
    """Return an upright box between two x, two y and two z [m]."""
    return Prism(((x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])), z[0], z[1] - z[0])


def _add_with_openings(step: StepFile, part: IfcElement, context: str, origin: str) -> str:
    """Add an element with its openings and return its reference."""
    element = _add_element(step, part.kind, part.name, part.body, context, origin)
    for name, prism in part.openings.items():
        opening = _add_element(step, "IFCOPENINGELEMENT", name, prism, context, origin)
        step.root("IFCRELVOIDSELEMENT", name, element, opening)
    return element


def _add_element(step: StepFile, kind: str, name: str, prism: Prism, context: str, origin: str) -> str:
    """Add an element whose body is a prism and return its reference."""
    closed = (*prism.corners, prism.corners[0])
    line = step.add("IFCPOLYLINE", [step.point(*corner) for corner in closed])
    profile = step.add("IFCARBITRARYCLOSEDPROFILEDEF", ".AREA.", None, line)
    along, first = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0)) if prism.axis == "z" else ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    start = step.point(*(prism.start * each for each in along))
    place = step.add("IFCAXIS2PLACEMENT3D", start, step.direction(*along), step.direction(*first))
    solid = step.add("IFCEXTRUDEDAREASOLID", profile, place, step.direction(0.0, 0.0, 1.0), prism.length)
    shape = step.add("IFCSHAPEREPRESENTATION", context, "'Body'", "'SweptSolid'", [solid])
    body = step.add("IFCPRODUCTDEFINITIONSHAPE", None, None, [shape])
    return step.root(kind, name, None, origin, body, None, None)


def _value(value: object) -> str:
    """Return a value as the file has it: a number, a list, a reference or a word as it stands, $ for None."""
    if value is None:
        return "$"
    if isinstance(value, float):
        return f"{value:.4f}".rstrip("0")
    if isinstance(value, Sequence) and not isinstance(value, str):
        return f"({','.join(map(_value, value))})"
    return str(value)


def _quote(text: str) -> str:
    return f"'{text}'"


def _identifier(name: str) -> str:
    """Return the 22 letters of an identifier of 128 bits, made from a name."""
    number = int.from_bytes(sha256(name.encode()).digest()[:16])
    return "".join(ALPHABET[number >> 6 * place & 63] for place in range(21, -1, -1))
