"""What a body of a model is: by its class and its names, then by its shape, then by what it touches.

What cannot be masonry, and what cannot be told, is left out with the reason.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from assess.geometry.formats.mesh_file import Element
from assess.messages.message import Message, Quantity, note
from assess.model.part_shapes import Shape
from assess.model.structure import COVERINGS, PLATES, Part, PartKind, Structure

UNCLASSED = ("IfcBuildingElementProxy", "IfcProxy", "IfcGeographicElement")
"""Classes that say nothing of what they hold: a whole building may be one element, as in a mesh."""
LEFT_OUT_CLASSES: Mapping[str, str] = {
    "IfcFurnishingElement": "furniture",
    "IfcFurniture": "furniture",
    "IfcWindow": "joinery",
    "IfcDoor": "joinery",
    "IfcCurtainWall": "joinery",
    "IfcPlate": "joinery",
    "IfcRailing": "railing",
    "IfcCovering": "finish",
    "IfcShadingDevice": "finish",
    "IfcStair": "stairs",
    "IfcStairFlight": "stairs",
    "IfcRamp": "stairs",
    "IfcRampFlight": "stairs",
    "IfcSite": "terrain",
    "IfcGeographicElement": "terrain",
    "IfcCivilElement": "terrain",
    "IfcFooting": "foundation",
    "IfcPile": "foundation",
    "IfcDeepFoundation": "foundation",
    "IfcDistributionElement": "services",
    "IfcTransportElement": "services",
    "IfcElementComponent": "fastener",
    "IfcReinforcingBar": "fastener",
    "IfcReinforcingMesh": "fastener",
    "IfcFeatureElement": "opening",
    "IfcSpatialElement": "room",
    "IfcSpatialStructureElement": "room",
    "IfcProjectionElement": "fastener",
}
"""Why elements of a class are no masonry, by class; the most specific class of an element counts."""
KINDS_BY_CLASS: Mapping[str, PartKind] = {
    "IfcWall": "wall",
    "IfcChimney": "chimney",
    "IfcColumn": "pier",
    "IfcSlab": "floor",
    "IfcRoof": "roof",
    "IfcTendon": "tie",
}
"""The kind that a class stands for; shape and place may make a wall a gable or a parapet."""
FRAME_CLASSES = ("IfcBeam", "IfcMember")

FINISH = re.compile(
    r"plaster|render(ing)?\b|stucco|intonac|\bputz|verputz|enduit|revoco|enlucido|insulat|isolant|isolier|d[äa]mm|"
    r"isolation|aislamiento|\bfinish|rivestiment|cladding|verkleidung|bardage|\bpaint|pittur|membran|guaina|"
    r"waterproof|vapou?r|\bair\b|\baria\b|\bluft|cavity\b|intercapedine",
    re.IGNORECASE,
)
NO_MASONRY = re.compile(
    r"\btimber|\bwood|legno|\bholz|\bbois\b|madera|\bsteel|acciaio|\bstahl|\bacier|\bglass|\bglas\b|vetro|verre|"
    r"gypsum|cartongesso|drywall|plasterboard|gipskarton|alumin|\bmetal",
    re.IGNORECASE,
)
THINGS: Mapping[str, re.Pattern[str]] = {
    "furniture": re.compile(
        r"furnitur|\barred|m[öo]bel|mobilier|\bchair|\bsedia|\btable\b|\btavol|\bsofa|\bbed\b|\bletto|wardrobe|"
        r"armadio|\bdesk\b|cabinet|\bpew|\bbanco\b|\baltar",
        re.IGNORECASE,
    ),
    "joinery": re.compile(
        r"\bwindow|finestr|\bfenster|fen[êe]tre|\bdoor|\bporta\b|\bt[üu]r\b|\bporte\b|glazing", re.IGNORECASE
    ),
    "lettering": re.compile(r"model text|\btext\b|\blettering|\bscritt[ae]\b|beschriftung|modelltext", re.IGNORECASE),
    "terrain": re.compile(
        r"terrain|topograph|\bterreno|gel[äa]nde|\bsite\b|\bground\b(?!.*(floor|wall|storey))|\btrees?\b|\balber",
        re.IGNORECASE,
    ),
}
"""Why a mesh of such a name is no masonry."""
TIE_WORDS = re.compile(r"\btie\b|\btie[- ]?rod|tirant|\bcaten[ae]\b|zuganker|\btendon", re.IGNORECASE)
LEVEL_WORDS = re.compile(
    r"\bfloor|\bslab|solai|\broof|\btett[oi]|copertur|\bdach|\btoit|\bdecke\b|plancher|forjado|cubierta", re.IGNORECASE
)
WALL_WORDS = re.compile(r"wall|\bmur|wand\b|mauer|parete|fa[cç]ad|facciata|gable|timpan|parapet|pier\b", re.IGNORECASE)
THINNEST_WALL, THINNEST_COVERING = 0.06, 0.02  # m: thinner plates are finishes
LARGEST_JOINERY = 0.12  # m: thicker things of such a name are walls around windows
TIE_DEPTH, TIE_LENGTH = 0.1, 1.5  # m: a bar no thicker and at least as long is a tie


def is_classed(element: Element) -> bool:
    """Return whether the class of an element says what it is."""
    return bool(element.kinds) and not any(kind in UNCLASSED for kind in element.kinds)


def class_of(element: Element) -> str:
    """Return the class, of an element or of what it is part of, that says what it is; empty where none does."""
    known = {*LEFT_OUT_CLASSES, *KINDS_BY_CLASS, *FRAME_CLASSES}
    of_owner = next((kind for kind in element.within if kind in ("IfcCurtainWall", "IfcRoof", "IfcStair")), "")
    return of_owner or next((kind for kind in element.kinds if kind in known), "")


def reason_by_class(element: Element) -> Message | None:
    """Return why elements of a class are no masonry; None where the class does not say so."""
    found = class_of(element)
    return note(f"left-out-{LEFT_OUT_CLASSES[found]}") if found in LEFT_OUT_CLASSES else None


def masonry_layers(element: Element) -> tuple[tuple[str, float | None], ...]:
    """Return the layers of an element, by name and thickness [m], that are no finish, timber, metal or air."""
    return tuple(each for each in element.layers if not FINISH.search(each[0]) and not NO_MASONRY.search(each[0]))


def reason_to_leave_out(element: Element, shape: Shape) -> Message | None:
    """Return why a body is not read as masonry, by its names, its materials and its thickness; None where it may be.

    Parameters
    ----------
    element : as the file names it
    shape : of its body
    """
    name = " ".join(element.names)
    upright = shape.kind in ("upright", "shaft", "arch", "block")
    if FINISH.search(name) and (not is_classed(element) or "IfcBuildingElementPart" in element.kinds):
        return note("left-out-finish")
    if element.layers and not masonry_layers(element):
        if all(FINISH.search(layer) for layer, _ in element.layers):
            return note("left-out-finish")
        if upright:
            return note("left-out-material", material=", ".join(dict.fromkeys(layer for layer, _ in element.layers)))
    for thing, words in THINGS.items():
        thick = thing == "joinery" and shape.thickness > LARGEST_JOINERY
        if not is_classed(element) and words.search(name) and not WALL_WORDS.search(name) and not thick:
            return note(f"left-out-{thing}")
    thin = THINNEST_WALL if shape.kind == "upright" else THINNEST_COVERING
    if shape.kind in ("upright", "level", "sloped", "curved") and shape.thickness < thin:
        return note("left-out-thin", thickness=Quantity(shape.thickness, "length", 2))
    if class_of(element) in FRAME_CLASSES and not is_tie(element, shape):
        return note("left-out-frame")
    return None


def says_level(element: Element) -> bool | None:
    """Return whether a class or name says that a body lies, as a floor does, or stands, as a wall; None for neither."""
    kind = KINDS_BY_CLASS.get(class_of(element))
    if kind is not None:
        return True if kind in COVERINGS else False if kind == "wall" else None
    name = " ".join(element.names)
    return False if WALL_WORDS.search(name) else True if LEVEL_WORDS.search(name) else None


def may_be_wall(element: Element, size: Sequence[float] | None = None, volume: float | None = None) -> bool:
    """Return whether what could not be read may be a masonry wall, by its names, its class and its size.

    Parameters
    ----------
    element : as the file names it
    size : sides of the box around it [m]; None where it has no body
    volume : [m3]; None where it is not closed
    """
    name = " ".join(element.names)
    patterns = (FINISH, TIE_WORDS, *THINGS.values())
    if not WALL_WORDS.search(name) and any(words.search(name) for words in patterns):
        return False
    kind = class_of(element)
    other = kind in (*FRAME_CLASSES, *LEFT_OUT_CLASSES) or KINDS_BY_CLASS.get(kind) in (*COVERINGS, "tie")
    small = size is not None and (max(size) < LEAST_WALL or sorted(size)[1] < LEAST_WALL / 2.0)
    return not other and not small and (volume is None or volume >= LEAST_VOLUME)


LEAST_WALL, LEAST_VOLUME = 1.0, 0.1  # m, half of it across, and m3: what is smaller may be left out


def is_tie(element: Element, shape: Shape) -> bool:
    """Return whether a body is a tie: of its class or name, or a thin long bar.

    Parameters
    ----------
    element : as the file names it
    shape : of the body
    """
    if class_of(element) == "IfcTendon":
        return True
    bar = shape.kind == "bar" and shape.length >= TIE_LENGTH
    return bar and (max(shape.width, shape.height) <= TIE_DEPTH or bool(TIE_WORDS.search(" ".join(element.names))))


def first_kind(element: Element, shape: Shape) -> PartKind | None:
    """Return the kind by class and shape alone; None where a body must be split, or cannot be told."""
    if is_tie(element, shape):
        return "tie"
    by_class = KINDS_BY_CLASS.get(class_of(element))
    if by_class in COVERINGS and shape.kind not in ("upright", "shaft"):
        roofed = element.predefined == "ROOF" or by_class == "roof"
        return "roof" if roofed else "vault" if shape.kind == "curved" else "floor"
    if by_class in ("chimney", "pier"):
        return by_class
    if shape.kind == "shaft" and shape.hollow and shape.height < TOWER_RATIO * shape.plan**0.5:
        return None
    return KINDS_BY_SHAPE.get(shape.kind)


KINDS_BY_SHAPE: Mapping[str, PartKind] = {
    "upright": "wall",
    "level": "floor",
    "sloped": "roof",
    "curved": "vault",
    "arch": "arch",
    "shaft": "pier",
    "bar": "parapet",
}
"""The kind to begin with; what a part touches decides."""

SUPPORTED = 0.5  # of its footprint: what a parapet or a pinnacle rests on
BRIDGED = 0.6  # of its footprint: a panel that rests on less spans an opening
LOW = 1.8  # m: a parapet and a spandrel are lower than a storey
STACK_LENGTH, STACK_RATIO = 1.6, 4.0  # m, and length over thickness: a chimney stack is no longer
TOWER_SIDE, TOWER_RATIO = 1.8, 1.8  # m, and height over the side
ABOVE_GROUND = 1.5  # m: what stands on a floor nearer the ground stands on the ground
BESIDE = 0.7  # of its height: a pier stands among walls of its storey, a chimney and a pinnacle rise above them
LINTEL = 0.5  # m: above the ground, where a panel may span an opening
NARROW_SLAB = 0.9  # m: a narrower slab is a beam or a coping


def kind_in_place(part: Part, shape: Shape, element: Element, structure: Structure) -> PartKind | Message:
    """Return the kind of a part by what it touches, or why it is left out.

    Parameters
    ----------
    part : of a first kind
    shape : of its body
    element : that it was read from
    structure : all parts of their first kinds, and their contacts
    """
    if part.kind in ("tie", "vault", "arch", "chimney", "tower"):
        return part.kind
    if element.predefined == "PARAPET":
        return "parapet"
    if part.kind in COVERINGS:
        return _covering_in_place(part, shape, element, structure)
    place = _Place(part, shape, structure)
    if shape.kind == "bar" or (class_of(element) != "IfcWall" and part.is_plate and part.height < part.thickness):
        on_ground = part.base <= structure.lowest + ABOVE_GROUND and not place.floats
        low_wall = on_ground and part.height >= part.thickness
        return "parapet" if place.on_top else "wall" if low_wall else note("left-out-frame")
    if shape.kind == "shaft" or part.kind == "pier":
        return _shaft_in_place(part, shape, element, place)
    if shape.eaves is not None:
        mostly_pitched = shape.eaves - part.base <= part.top - shape.eaves
        return "gable" if mostly_pitched and place.elevated else "wall"
    if place.on_top and part.height <= LOW:
        return "chimney" if part.length <= min(STACK_LENGTH, STACK_RATIO * part.thickness) else "parapet"
    if place.bridges and part.height <= LOW:
        return "spandrel"
    return "wall"


def _covering_in_place(part: Part, shape: Shape, element: Element, structure: Structure) -> PartKind | Message:
    if shape.kind == "sloped" and not is_classed(element):
        covered = any(
            other.base > part.top - LOW and _plans_overlap(part, other)
            for other in structure.of_kind(*COVERINGS)
            if other.name != part.name and other.kind == "floor"
        )
        if covered:
            return note("left-out-stairs")
    if shape.width < NARROW_SLAB and not is_classed(element):
        return note("left-out-frame")
    return part.kind


def _plans_overlap(one: Part, other: Part) -> bool:
    low, high = ([getattr(part.solid.vertices, end)(axis=0)[:2] for part in (one, other)] for end in ("min", "max"))
    return bool((low[0] < high[1]).all() and (low[1] < high[0]).all())


def _shaft_in_place(part: Part, shape: Shape, element: Element, place: _Place) -> PartKind:
    side = shape.plan**0.5
    if side >= TOWER_SIDE and part.height >= TOWER_RATIO * side:
        return "tower"
    if shape.tapers and place.free:
        return "pinnacle"
    if class_of(element) in ("IfcColumn", "IfcWall") or not place.on_top:
        return "chimney" if place.above_roof and class_of(element) != "IfcColumn" else "pier"
    if shape.tapers:
        return "pinnacle"
    return "pier" if place.among_walls else "chimney"


class _Place:
    """Where a part stands: what it rests on, what it carries, and what is beside it.

    free : whether it touches nothing, or is elevated and carries nothing
    elevated : whether it rests on another part, above the ground
    floats : whether it rests on nothing above the ground
    on_top : whether it is elevated, most of its base rests, and it carries nothing
    bridges : whether it spans between two uprights
    among_walls : whether walls stand beside it at its level
    above_roof : whether it stands on the ground, carries nothing and rises above all walls and roofs
    """

    def __init__(self, part: Part, shape: Shape, structure: Structure) -> None:
        contacts = structure.contacts_of(part.name)
        rests = [each for each in contacts if each.first == part.name and each.relation in ("stands-on", "bears-on")]
        carries = any(each.second == part.name and each.relation in ("bears-on", "stands-on") for each in contacts)
        area = sum(each.area for each in rests)
        above_ground = part.base > structure.lowest + ABOVE_GROUND
        self.elevated = above_ground and bool(rests)
        self.free = not contacts or (self.elevated and not carries)
        self.floats = above_ground and not rests
        self.on_top = self.elevated and not carries and area >= SUPPORTED * shape.plan
        others = [structure.part(each.other(part.name)) for each in contacts]
        uprights = {each.name for each in others if each.kind in (*PLATES, "pier")}
        self.bridges = len(uprights) >= 2 and area < BRIDGED * shape.plan and part.base > structure.lowest + LINTEL
        walls = [each for each in structure.of_kind("wall") if each.name != part.name and each.eaves is None]
        self.among_walls = any(
            min(other.top, part.top) - max(other.base, part.base) >= BESIDE * part.height for other in walls
        )
        roofs = [other for other in structure.of_kind(*COVERINGS) if _plans_overlap(part, other)]
        highest = max((other.top for other in (*walls, *roofs)), default=part.top)
        self.above_roof = not carries and bool(roofs) and part.top > highest and not rests
