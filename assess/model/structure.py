"""A building above the waist: its parts, its storeys, what touches what, and what was not read as masonry.

A structure says what a drawing says, and no more: whether walls that meet are bonded, only a survey can tell.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from assess.errors import GeometryError
from assess.geometry.solid import Solid
from assess.geometry.surface import volume
from assess.mechanisms.mechanism import Vector
from assess.messages.message import Message
from assess.short_repr import ShortRepr

if TYPE_CHECKING:
    from pandas import DataFrame

    from assess.model.candidates import Candidates

PartKind = Literal[
    "wall", "gable", "parapet", "pier", "spandrel", "floor", "roof", "vault", "arch", "tower", "chimney", "pinnacle",
    "tie",
]  # fmt: skip
Relation = Literal["stands-on", "leans-on", "bears-on", "bonded-to", "held-by"]
"""What a part does with another: stands on it (masonry on masonry), bears on it (floor, roof or vault on what carries
it), leans on it (upright faces touch), is bonded to it (drawn as one body), or is held by it (a tie)."""
KINDS: tuple[PartKind, ...] = get_args(PartKind)
PLATES: tuple[PartKind, ...] = ("wall", "gable", "parapet", "pier", "spandrel")
"""Kinds of parts that are upright plates, with a thickness, a length and a normal."""
COVERINGS: tuple[PartKind, ...] = ("floor", "roof", "vault")
"""Kinds of parts that bear on walls and load them."""
End = Literal["start", "end", "between"]


@dataclass(frozen=True)
class Opening:
    """A hole through a wall.

    left, right : its sides, along the wall from its start [m]
    base, top : elevations [m]
    """

    left: float
    right: float
    base: float
    top: float


@dataclass(frozen=True, kw_only=True, repr=False)
class Part(ShortRepr):
    """One part of a building.

    name : in the structure, unique
    kind : what it is
    solid : its body, of the density below
    base, top : its lowest and highest elevation [m]
    thickness : between the faces of a plate, the depth of a floor, else the shorter side of its box in plan [m]
    length : along `along` [m]
    height : from base to top; of a floor the thickness [m]
    normal : horizontal unit vector across it (x, y, 0), outwards where `outward`
    along : horizontal unit vector of its length (x, y, 0), a quarter turn anticlockwise from the normal
    outward : whether the normal points out of the building: it does on façades
    storey : name of the storey that it stands in; empty where the model has none
    density : of its masonry [kg/m3]
    density_stated : whether the model or the caller states the density; else it is assumed
    material : its name in the model; empty where there is none
    source : what it was read from: class and GlobalId, or the file and the shell
    file, element : what selects it in the model: the file's name, and a GlobalId or a name; empty for the whole file
    whole : whether the element holds this part alone; else it is one shell of several, or a piece of one
    openings : holes through it
    eaves : elevation at which its pitched top begins; None where the top is level [m]
    shared : volume that another part counts already, as at a corner where two walls are drawn over each other [m3]
    """

    name: str
    kind: PartKind
    solid: Solid
    base: float
    top: float
    thickness: float
    length: float
    height: float
    normal: Vector
    along: Vector
    outward: bool = False
    storey: str = ""
    density: float
    density_stated: bool = False
    material: str = ""
    source: str = ""
    file: str = ""
    element: str = ""
    whole: bool = True
    openings: tuple[Opening, ...] = ()
    eaves: float | None = None
    shared: float = 0.0

    @property
    def mass(self) -> float:
        """Its mass as it is drawn, corners that it shares with other parts included [kg]."""
        return self.solid.mass

    @property
    def volume(self) -> float:
        """Its volume [m3]."""
        return volume(self.solid.vertices, self.solid.triangles)

    @property
    def is_plate(self) -> bool:
        """Whether it is an upright plate, with a thickness and a normal."""
        return self.kind in PLATES

    @property
    def start(self) -> float:
        """Where it begins along `along`, from the origin [m]."""
        return float(np.min(self.solid.vertices @ np.array(self.along)))

    @property
    def middle(self) -> float:
        """Where the middle between its faces lies along `normal`, from the origin [m]."""
        across = self.solid.vertices @ np.array(self.normal)
        return float(across.min() + across.max()) / 2.0


@dataclass(frozen=True)
class PartContact:
    """The contact of two parts: the first stands on, bears on, leans on, is bonded to or is held by the second.

    first, second : names of the parts
    relation : what the first does with the second
    area : of the faces in contact, in plan where the first is built in [m2]
    gap : left between their faces [m]
    eccentricity : of the middle of that area from the middle between the faces of the second, along its normal [m]
    elevation : of the middle of that area [m]
    centroid : of that area (x, y, z) [m]
    normal : mean outward unit normal of the second there
    """

    first: str
    second: str
    relation: Relation
    area: float
    gap: float
    eccentricity: float
    elevation: float
    centroid: Vector
    normal: Vector

    def other(self, name: str) -> str:
        """Return the name of the other part."""
        return self.second if name == self.first else self.first


@dataclass(frozen=True)
class CrossWall:
    """A wall that meets another at an angle.

    part : the wall that meets it
    contact : where
    end : at which end of the wall that is met, or between its ends
    at : along the wall that is met, from its start [m]
    """

    part: Part
    contact: PartContact
    end: End
    at: float


@dataclass(frozen=True)
class Storey:
    """A storey; height is None where nothing above ends it [m]."""

    name: str
    elevation: float
    height: float | None = None


@dataclass(frozen=True)
class LeftOut:
    """What was not read as masonry.

    name : what the model calls it
    reason : why it was left out
    size : of the box around it, x, y, z [m]; None where it has no body
    volume : [m3]; None where it is not closed
    source : class and GlobalId, or the file and the shell
    low : lowest corner of the box around it [m]; None where it has no body
    may_be_wall : whether it may be a masonry wall all the same, as one whose surface is open
    """

    name: str
    reason: Message
    size: Vector | None = None
    volume: float | None = None
    source: str = ""
    low: Vector | None = None
    may_be_wall: bool = False

    @property
    def shown(self) -> str:
        """Its name; of what has none, its size and place too."""
        if self.name != NAMELESS or self.size is None or self.low is None:
            return self.name
        size, middle = self.size, [low + side / 2.0 for low, side in zip(self.low, self.size, strict=True)]
        place = ", ".join(f"{each + 0.0:.3g}" for each in middle)
        return f"{NAMELESS}, {' by '.join(f'{side:.3g}' for side in size)} m, around ({place}) m"


NAMELESS = "without name"


@dataclass(frozen=True, repr=False)
class Structure(ShortRepr):
    """A building: its parts and how they touch.

    parts : walls first, from the ground up
    contacts : of parts, by name
    storeys : from the lowest up
    left_out : what is not read as masonry
    warnings : about the model as a whole
    files : that it was read from
    """

    parts: tuple[Part, ...]
    contacts: tuple[PartContact, ...] = ()
    storeys: tuple[Storey, ...] = ()
    left_out: tuple[LeftOut, ...] = ()
    warnings: tuple[Message, ...] = ()
    files: tuple[str, ...] = ()

    @cached_property
    def _by_name(self) -> Mapping[str, Part]:
        return {part.name: part for part in self.parts}

    @cached_property
    def _contacts_by_name(self) -> Mapping[str, tuple[PartContact, ...]]:
        found: dict[str, list[PartContact]] = {part.name: [] for part in self.parts}
        for contact in self.contacts:
            found[contact.first].append(contact)
            found[contact.second].append(contact)
        return {name: tuple(each) for name, each in found.items()}

    @property
    def left_out_texts(self) -> tuple[str, ...]:
        """What is left out and why, a text for those that read alike, with their number."""
        alike = Counter(f"{each.shown}: {each.reason}" for each in self.left_out)
        return tuple(text if number == 1 else f"{text} ({number} of them)" for text, number in alike.items())

    def part(self, name: str) -> Part:
        """Return a part by its name.

        Raises
        ------
        GeometryError : there is none of this name
        """
        if name not in self._by_name:
            raise GeometryError(f'the building has no part "{name}"; it has {", ".join(self._by_name) or "none"}')
        return self._by_name[name]

    def of_kind(self, *kinds: PartKind) -> tuple[Part, ...]:
        """Return the parts of some kinds."""
        return tuple(part for part in self.parts if part.kind in kinds)

    @property
    def walls(self) -> tuple[Part, ...]:
        """The walls; gables, parapets, piers and spandrels are kinds of their own."""
        return self.of_kind("wall")

    @property
    def plates(self) -> tuple[Part, ...]:
        """All upright plates: walls, gables, parapets, piers and spandrels."""
        return self.of_kind(*PLATES)

    @property
    def mass(self) -> float:
        """The mass of all parts, what two of them share counted once [kg]."""
        return sum(part.mass - part.shared * part.density for part in self.parts)

    @property
    def is_one_shell(self) -> bool:
        """Whether pieces of one closed body that had to be split make up most of it: what they were is a guess."""
        pieces = Counter((part.source, part.element) for part in self.parts if not part.whole)
        split = [part.volume for part in self.parts if not part.whole and pieces[part.source, part.element] > 1]
        return sum(split) > sum(part.volume for part in self.parts) / 2.0

    @property
    def lowest(self) -> float:
        """The lowest elevation of all parts [m]."""
        return min(part.base for part in self.parts)

    def contacts_of(self, name: str) -> tuple[PartContact, ...]:
        """Return the contacts of a part."""
        return self._contacts_by_name[self.part(name).name]

    def standing_on(self, name: str) -> tuple[Part, ...]:
        """Return the parts that stand on a part."""
        return self._firsts(name, "stands-on")

    def bearing_on(self, name: str) -> tuple[Part, ...]:
        """Return the floors, roofs and vaults that bear on a part."""
        return self._firsts(name, "bears-on")

    def below(self, name: str) -> tuple[Part, ...]:
        """Return the parts that a part stands or bears on."""
        carried = [each for each in self.contacts_of(name) if each.first == name]
        return tuple(self.part(each.second) for each in carried if each.relation in ("stands-on", "bears-on"))

    def ties_of(self, name: str) -> tuple[Part, ...]:
        """Return the ties that hold a part."""
        held = [each for each in self.contacts_of(name) if each.first == name and each.relation == "held-by"]
        return tuple(self.part(each.second) for each in held)

    def cross_walls(self, name: str) -> tuple[CrossWall, ...]:
        """Return the walls that meet a wall at an angle, from its start to its end.

        A wall meets an end where the middle of its contact lies within its thickness, plus that of the wall, of it.
        """
        wall = self.part(name)
        along, start = np.array(wall.along), wall.start
        found = []
        for contact in self.contacts_of(name):
            other = self.part(contact.other(name))
            if contact.relation not in ("leans-on", "bonded-to") or not other.is_plate:
                continue
            if abs(float(np.dot(other.normal, wall.normal))) > IN_LINE:
                continue
            at = float(contact.centroid @ along) - start
            reach = (other.thickness + wall.thickness) / 2.0
            end: End = "start" if at <= reach else "end" if at >= wall.length - reach else "between"
            found.append(CrossWall(other, contact, end, at))
        return tuple(sorted(found, key=lambda each: each.at))

    def stack_of(self, name: str) -> tuple[Part, ...]:
        """Return the walls that stand on one another in the plane of a wall, itself among them, from the ground up."""
        wall = self.part(name)

        def in_plane(others: Sequence[Part]) -> list[Part]:
            return [each for each in others if each.is_plate and abs(float(np.dot(each.normal, wall.normal))) > IN_LINE]

        found, new = {wall.name: wall}, [wall]
        while new:
            near = [each for part in new for each in in_plane((*self.below(part.name), *self.standing_on(part.name)))]
            new = [each for each in {part.name: part for part in near}.values() if each.name not in found]
            found |= {part.name: part for part in new}
        return tuple(sorted(found.values(), key=lambda part: (part.base, part.name)))

    def mechanisms(self) -> Candidates:
        """Return the mechanisms that the building can have, the weakest first, and the parts that have none."""
        from assess.model.candidates import find_candidates  # late: it stands above this module

        return find_candidates(self)

    def table(self, name: str = "parts") -> DataFrame:
        """Return a table of the building, a row to each thing that it lists.

        Units stand in the names of the columns.

        Parameters
        ----------
        name : "parts", "contacts", "storeys" or "left_out"

        Raises
        ------
        GeometryError : for a name that is none of these
        """
        import pandas as pd  # late: it takes a third of a second

        if name not in TABLES:
            raise GeometryError(f'there is no table "{name}" of a building; known are {", ".join(TABLES)}')
        columns = TABLES[name]
        rows = [[value(each) for value in columns.values()] for each in getattr(self, name)]
        return pd.DataFrame(rows, columns=list(columns))

    def _firsts(self, name: str, relation: Relation) -> tuple[Part, ...]:
        carried = [each for each in self.contacts_of(name) if each.second == name and each.relation == relation]
        return tuple(self.part(each.first) for each in carried)


IN_LINE = 0.94  # cosine: plates whose normals are within 20 degrees of each other are in line, others cross


Column = Callable[[Any], Any]
TABLES: Mapping[str, Mapping[str, Column]] = {
    "parts": {
        "name": lambda part: part.name,
        "kind": lambda part: part.kind,
        "storey": lambda part: part.storey,
        "thickness_m": lambda part: part.thickness,
        "length_m": lambda part: part.length,
        "height_m": lambda part: part.height,
        "base_m": lambda part: part.base,
        "top_m": lambda part: part.top,
        "normal_x": lambda part: part.normal[0],
        "normal_y": lambda part: part.normal[1],
        "outward": lambda part: part.outward,
        "openings": lambda part: len(part.openings),
        "volume_m3": lambda part: part.volume,
        "shared_m3": lambda part: part.shared,
        "density_kg_per_m3": lambda part: part.density,
        "mass_kg": lambda part: part.mass,
        "material": lambda part: part.material,
        "source": lambda part: part.source,
    },
    "contacts": {
        "first": lambda contact: contact.first,
        "relation": lambda contact: contact.relation,
        "second": lambda contact: contact.second,
        "area_m2": lambda contact: contact.area,
        "gap_m": lambda contact: contact.gap,
        "eccentricity_m": lambda contact: contact.eccentricity,
        "elevation_m": lambda contact: contact.elevation,
    },
    "storeys": {
        "name": lambda storey: storey.name,
        "elevation_m": lambda storey: storey.elevation,
        "height_m": lambda storey: storey.height,
    },
    "left_out": {
        "name": lambda each: each.name,
        "size_x_m": lambda each: each.size[0] if each.size else None,
        "size_y_m": lambda each: each.size[1] if each.size else None,
        "size_z_m": lambda each: each.size[2] if each.size else None,
        "volume_m3": lambda each: each.volume,
        "reason": lambda each: str(each.reason),
        "source": lambda each: each.source,
    },
}
"""The columns of each table, and how each is read from what the table lists."""
