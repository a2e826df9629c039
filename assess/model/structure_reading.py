"""A structure read from model files: bodies, their shapes, what they touch, what they are, and where outside is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import mean

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import MAX_LISTED, Up
from assess.geometry.formats.readers import WITHOUT_UNIT
from assess.geometry.mesh import size_warning
from assess.geometry.solid import scale_density
from assess.messages.message import Message, Quantity, first_names, note, warning, whole_number
from assess.model.part_bodies import DrawnBody, DrawnModel, leave_out, read_bodies
from assess.model.part_contacts import find_contacts
from assess.model.part_kinds import first_kind, kind_in_place, masonry_layers, reason_to_leave_out, says_level
from assess.model.part_shapes import Shape, shape_of
from assess.model.part_sides import face_outwards
from assess.model.part_splitting import split_body
from assess.model.structure import COVERINGS, KINDS, LeftOut, Part, PartContact, PartKind, Storey, Structure

MASONRY_DENSITY = 1800.0  # kg/m3: between rubble and solid brick of Circolare 7/2019, Table C8.5.I (19 and 18 kN/m3)
COVERING_DENSITY = 1000.0  # kg/m3: 0.25 m of it weigh 250 kg/m2, as a floor of timber with screed or of hollow blocks
LARGEST_OVERLAP = 0.5  # of a part's volume: one that lies in others by more is left out
SAME_BODY = (
    0.95  # of a part's volume: one that lies in others by more is in them, and nothing of the building is missing
)
Densities = float | Mapping[str, float]


def read_structure(
    files: Sequence[Path], *, unit: float | None = None, up: Up | None = None, density: Densities | None = None
) -> Structure:
    """Read the structure of a building from the files of its model.

    Parameters
    ----------
    files : of any known format; what several hold is one building
    unit : length of the files' unit [m]; their own if None, the metre where they have none
    up : axis of the files that points up; the format's if None
    density : of all masonry, or by the name of its material [kg/m3]; what the model states or else 1800 kg/m3 if None

    Raises
    ------
    GeometryError : a file cannot be read, or nothing in them is masonry
    """
    models = [read_bodies(file, unit=unit, up=up) for file in files]
    structure = structure_of_models(models, files=[file.name for file in files], density=density)
    return replace(structure, warnings=(*_sizes(structure.parts, unit), *structure.warnings))


def _sizes(parts: Sequence[Part], unit: float | None) -> Iterator[Message]:
    """Yield a warning of each kind on sizes and places that suggest a slip, of the first part that has it.

    unit : that the files were read in, where the caller states it [m]
    """
    told: set[str] = set()
    for part in parts:
        used = unit or (1.0 if Path(part.file).suffix.lower() in WITHOUT_UNIT else None)
        found = size_warning(part.solid, unit=used)
        if found is not None and found.key not in told:
            told.add(found.key)
            yield found


def structure_of_models(
    models: Sequence[DrawnModel], *, files: Sequence[str], density: Densities | None = None
) -> Structure:
    """Return the structure of a building from the bodies of its models.

    Parameters
    ----------
    models : what the files hold
    files : their names
    density : as in `read_structure`

    Raises
    ------
    GeometryError : nothing in them is masonry
    """
    left_out = [each for model in models for each in model.left_out]
    drafts: list[_Draft] = []
    for model in models:
        for body in model.bodies:
            read = _drafts_of(body)
            drafts += [each for each in read if isinstance(each, _Draft)]
            left_out += [each for each in read if isinstance(each, LeftOut)]
    parts = [_first_part(draft, number, density) for number, draft in enumerate(drafts)]
    by_name = dict(zip((part.name for part in parts), drafts, strict=True))
    if not parts:
        raise GeometryError(_nothing(files[0], left_out))
    found = find_contacts(parts)
    first = Structure(tuple(parts), found.contacts)
    placed: list[Part] = []
    for part in parts:
        draft = by_name[part.name]
        share = found.shared[part.name] / part.volume
        twice = note("left-out-twice", share=Quantity(100.0 * share, "percent", 2)) if share > LARGEST_OVERLAP else None
        kind = twice or kind_in_place(part, draft.shape, draft.body.element, first)
        if isinstance(kind, Message):
            left_out.append(leave_out(draft.body, kind, told=twice is None or share > SAME_BODY))
        else:
            placed.append(replace(part, kind=kind, shared=found.shared[part.name]))
    if not placed:
        raise GeometryError(_nothing(files[0], left_out))
    there = {part.name for part in placed}
    contacts = [_bonded(each, by_name) for each in found.contacts if each.first in there and each.second in there]
    storeys = _storeys([each for model in models for each in model.storeys], placed)
    finished = [
        replace(part, storey=part.storey or _storey_of(part, storeys)) for part in face_outwards(placed, contacts)
    ]
    order = sorted(finished, key=lambda part: (KINDS.index(part.kind), round(part.base, 2)))
    names = _names(order, by_name)
    structure = Structure(
        parts=tuple(
            replace(part, name=names[part.name], solid=replace(part.solid, name=names[part.name])) for part in order
        ),
        contacts=tuple(replace(each, first=names[each.first], second=names[each.second]) for each in contacts),
        storeys=storeys,
        left_out=tuple(left_out),
        warnings=(
            *_on_its_side(drafts),
            *_splits(drafts),
            *_layers(order, names, by_name),
            *_unborne(order, names, contacts),
            *_assumptions(order),
        ),
        files=tuple(files),
    )
    guessed = [warning("one-shell")] if structure.is_one_shell else []
    return replace(structure, warnings=(*guessed, *structure.warnings))


def _on_its_side(drafts: Sequence[_Draft]) -> Iterator[Message]:
    """Yield a warning where most parts lie or stand as their names or classes do not say that they do.

    Of parts that say nothing it is their thickness: floors are no thicker than walls.
    """
    lies = {"level": True, "sloped": True, "curved": True, "upright": False}
    said = [(says_level(each.body.element), lies.get(each.shape.kind), each) for each in drafts]
    told = [each for each in said if each[0] is not None and each[1] is not None]
    against = [draft for level, lying, draft in told if level != lying]
    if len(against) > len(told) / 2.0:
        yield warning("lying-by-names", number=whole_number(len(against)), part=against[0].body.name)
    plates = [(lying, draft.shape.thickness) for _, lying, draft in said if draft.shape.thickness < THICKEST_PLATE]
    level, upright = ([thickness for lying, thickness in plates if lying is way] for way in (True, False))
    if not told and level and upright and mean(level) > mean(upright):
        words = {"level": mean(level), "upright": mean(upright)}
        yield warning("lying-by-thickness", **{key: Quantity(each, "length", 2) for key, each in words.items()})


THICKEST_PLATE = 2.0  # m: what is thicker is no floor and seldom a wall
LISTED_FAULTS = 2  # of a file in which nothing is masonry: most of its parts have the same one


def _nothing(file: str, left_out: Sequence[LeftOut]) -> str:
    """Return the text of an error where nothing is masonry."""
    reasons = "; ".join(f"{each.name}: {each.reason}" for each in left_out[:LISTED_FAULTS])
    reasons += f"; and {len(left_out) - LISTED_FAULTS} more" if len(left_out) > LISTED_FAULTS else ""
    unit = "the unit (--unit), " if Path(file).suffix.lower() in WITHOUT_UNIT else ""
    cure = f"check {unit}the axis that is up (--up) and the names"
    return f"{file}: nothing in it is read as masonry ({reasons}); {cure}"


@dataclass(frozen=True)
class _Draft:
    """A body that is read as masonry, its shape and its first kind; piece: its number where it was split."""

    body: DrawnBody
    shape: Shape
    kind: PartKind
    piece: int | None = None


def _drafts_of(body: DrawnBody) -> list[_Draft | LeftOut]:
    """Return the parts that a body is, or why it is none."""
    shape = shape_of(body.solid)
    reason = reason_to_leave_out(body.element, shape)
    if reason is not None:
        return [leave_out(body, reason)]
    kind = first_kind(body.element, shape)
    if kind is not None:
        return [_Draft(body, shape, kind)]
    pieces, rest = split_body(body, shape)
    drafts: list[_Draft | LeftOut] = list(rest)
    for number, (piece, look, what) in enumerate(pieces, start=1):
        drafts.append(_Draft(piece, look, what, number if len(pieces) > 1 else None))
    return drafts


def _first_part(draft: _Draft, number: int, density: Densities | None) -> Part:
    """Return a part by the first kind of its body, under a number for its name."""
    body, shape, element = draft.body, draft.shape, draft.body.element
    masonry = masonry_layers(element) or element.layers
    material = max(masonry, key=lambda layer: layer[1] or 0.0, default=("", None))[0]
    given = density.get(material) if isinstance(density, Mapping) else density if draft.kind not in COVERINGS else None
    stated = given or element.density
    used = stated or (COVERING_DENSITY if draft.kind in COVERINGS else MASONRY_DENSITY)
    low, high = float(body.solid.vertices[:, 2].min()), float(body.solid.vertices[:, 2].max())
    return Part(
        name=str(number),
        kind=draft.kind,
        solid=scale_density(body.solid, used),
        base=low,
        top=high,
        thickness=shape.thickness,
        length=shape.length,
        height=high - low,
        normal=shape.normal,
        along=shape.along,
        storey=element.storey,
        density=used,
        density_stated=stated is not None,
        material=material,
        source=body.source,
        file=body.file,
        element=element.identifier or next(iter(element.names), ""),
        whole=body.shell is None and draft.piece is None,
        openings=shape.openings,
        eaves=shape.eaves,
    )


def _bonded(contact: PartContact, drafts: Mapping[str, _Draft]) -> PartContact:
    """Return the contact of two pieces of one body, which are drawn bonded; others as they are."""
    one, other = drafts[contact.first], drafts[contact.second]
    same = one.piece is not None and (one.body.source, one.body.name) == (other.body.source, other.body.name)
    return replace(contact, relation="bonded-to") if same and contact.relation == "leans-on" else contact


NEAR_LEVEL = 0.5  # m: floors nearer one another are of one storey


def _storeys(stated: Sequence[tuple[str, float]], parts: Sequence[Part]) -> tuple[Storey, ...]:
    """Return the storeys that a model states, or those between its floors.

    Elevations that a model gives wrongly, two storeys at one level, are taken from the walls of each storey.
    """
    if stated and len({round(level, 2) for _, level in stated}) < len(stated):
        bases = {name: [part.base for part in parts if part.storey == name] for name, _ in stated}
        stated = [(name, min(bases[name])) for name, _ in stated if bases[name]]
    if not stated:
        tops = sorted(part.top for part in parts if part.kind == "floor")
        lowest = min(part.base for part in parts)
        levels = [lowest]
        levels += [top for k, top in enumerate(tops) if top - ([lowest, *tops][k]) > NEAR_LEVEL]
        stated = [(f"storey {number}", level) for number, level in enumerate(levels)]
    ordered = sorted(stated, key=lambda each: each[1])
    ends = [level for _, level in ordered[1:]]
    heights = [end - level for (_, level), end in zip(ordered, ends, strict=False)]
    return tuple(Storey(name, level, height) for (name, level), height in zip(ordered, [*heights, None], strict=True))


def _storey_of(part: Part, storeys: Sequence[Storey]) -> str:
    """Return the storey that a part stands in, of a floor that over it."""
    level = part.top if part.kind in COVERINGS else part.base
    below = [storey for storey in storeys if storey.elevation <= level + NEAR_LEVEL]
    return (below or list(storeys[:1]))[-1].name if storeys else ""


def _names(parts: Sequence[Part], drafts: Mapping[str, _Draft]) -> dict[str, str]:
    """Return the name of each part: the model's, numbered where several have it, or else its kind and a number."""
    wanted = {part.name: drafts[part.name].body.name or part.kind for part in parts}
    many = Counter(wanted.values())
    taken: Counter[str] = Counter()
    found: dict[str, str] = {}
    for part in parts:
        name = wanted[part.name]
        taken[name] += 1
        alone = many[name] == 1 and bool(drafts[part.name].body.name)
        found[part.name] = name if alone else f"{name} {taken[name]}"
    return found


def _splits(drafts: Sequence[_Draft]) -> list[Message]:
    """Warn of bodies that were split."""
    pieces = Counter((draft.body.source, draft.body.name) for draft in drafts if draft.piece is not None)
    return [
        warning("split-body", body=name or source, number=whole_number(number))
        for (source, name), number in pieces.items()
    ]


def _layers(parts: Sequence[Part], names: Mapping[str, str], drafts: Mapping[str, _Draft]) -> list[Message]:
    """Warn of walls whose bodies include layers that are no masonry."""
    elements = {part.name: drafts[part.name].body.element for part in parts if part.is_plate}
    built = [names[name] for name, each in elements.items() if len(masonry_layers(each)) < len(each.layers)]
    if not built:
        return []
    listed = first_names(built, MAX_LISTED)
    return [warning("layers-of-finish", number=whole_number(len(built)), names=listed)]


def _unborne(parts: Sequence[Part], names: Mapping[str, str], contacts: Sequence[PartContact]) -> list[Message]:
    """Warn of floors, roofs and vaults that bear on nothing, whose weight no mechanism has."""
    borne = {each.first for each in contacts if each.relation == "bears-on"}
    loose = [names[part.name] for part in parts if part.kind in COVERINGS and part.name not in borne]
    if not loose:
        return []
    return [warning("bears-on-nothing", number=whole_number(len(loose)), names=first_names(loose, MAX_LISTED))]


def _assumptions(parts: Sequence[Part]) -> list[Message]:
    """Warn of densities that the model does not state."""
    assumed = [part for part in parts if not part.density_stated and part.kind != "tie"]
    if not assumed:
        return []
    masonry, covering = (Quantity(each, "density") for each in (MASONRY_DENSITY, COVERING_DENSITY))
    return [warning("density-assumed", number=whole_number(len(assumed)), masonry=masonry, covering=covering)]
