"""What a floor, roof or vault puts on a block: its weight where they touch, and its thrust (thesis 3.2.2).

The block that it loads is the one whose masonry, as cut, it stands on or pushes against.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf

import numpy as np

from assess.errors import GeometryError
from assess.geometry.boolean import OVERLAP_WARNED, SAME_PLACE, shared_volume, shortest_distance
from assess.geometry.contact import CONTACT_TOLERANCE, ContactArea, find_contact, join_contacts
from assess.geometry.cut import Piece
from assess.geometry.planar import distance_to_outline
from assess.geometry.solid import Solid
from assess.loads.bearing import (
    Support,
    bearing_contacts,
    carries_weight,
    no_contact_text,
    readings,
    share_of,
    support,
    unsure_share_warning,
    unsure_shares,
)
from assess.loads.load import BodyLoad, Force, Load, Point, PointMass, point_in_plane
from assess.loads.roofs_and_vaults import Arch, Thrust, arch_of, body_mass, extent_along, thrust_of
from assess.messages.message import Message, Quantity, Term, Value, message, warning, whole_number
from spectra.arrays import FloatArray
from spectra.gravity import g


def find_block_contact(load: BodyLoad, body: Solid | None, around: Surroundings) -> BlockContact:
    """Find where a body meets the block and what else carries it, whichever way the motion goes.

    Parameters
    ----------
    load : the body as a load
    body : its solid; None without geometry
    around : the block, and what stands around it

    Returns
    -------
    The contacts, None if the user states all that follows from them, and warnings

    Raises
    ------
    GeometryError : the body touches nothing of the block, or has no geometry where it needs one
    """
    given = load.at is not None and load.bearing is not None
    found = _find_support(load, body, given=given, around=around)
    if found is not None:
        met = _without_overlapping_bodies(load, found, around=around)
        if load.share is not None or body is None:
            return met
        return replace(met, others=tuple(_other_readings(load, body, met, around=around)))
    if body is None or given:
        return BlockContact(None)
    below = any(find_contact(solid, body, tolerance=load.tolerance) for solid in around.fixed)
    why = BELOW_THE_CUT if below else no_contact_text(body, block=around.block)
    raise GeometryError(f'{around.where}: load "{load.body}" touches nothing of the block: {why}, or {BY_ITSELF[0]}')


def body_loads(
    load: BodyLoad,
    *,
    block: int,
    body: Solid | None,
    mass: float,
    around: Surroundings,
    once: float = 1.0,
    within: float = 0.0,
    find: FindContact = find_block_contact,
) -> LoadSet:
    """Return the point mass of a body, and the force of its thrust if it has one.

    Parameters
    ----------
    load : the body as a load
    block : number of the block that it loads
    body : its solid; None without geometry
    mass : of the whole body as given or by its volume [kg]
    around : the block, and what stands around it
    once : what no other load counts of the body, over its mass [-]; its thrust is that of the whole, so that an
        overlap in the drawing takes none away
    within : mass of it that lies in the block, which counts it: it rests there, so that all of it leaves the part that
        the block carries [kg]
    find : finds where it meets the block

    Raises
    ------
    GeometryError : the body touches nothing of the block, has no geometry where it needs one, or would lift off
    """
    meeting = find(load, body, around)
    found = meeting.support
    roof = body if load.role != "floor" else None
    arch = None if roof is None else arch_of(load, roof, along=around.along)
    at = _load_place(load, found, along=around.along)
    side = 0.0 if roof is None else _side_of_span(roof, found, arch, at, along=around.along)
    placed = BodyOnBlock(load, body, found, arch, side, meeting.others, where=f'{around.where}: load "{load.body}"')
    whole, of = body_mass(load, body, mass=mass)
    bearing, how = _bears_on_block(placed)
    within = within if bearing else 0.0  # what only pushes keeps its inertia whole
    part = _carried_share(placed, bearing=bearing)
    source, pushed = [of, part.source, how, *_place_source(load, found, along=around.along)], list[Force]()
    if once < 1.0:
        source.insert(1, message("load-counted-once", {"share": Quantity(100.0 * once, "percent", 3)}))
    if within > 0.0:
        source.insert(1, message("load-within-block", {"mass": Quantity(within, "mass", 3)}))
    if roof is not None:
        thrust = _thrust_on(placed, V=g * part.share * whole, along=around.along)
        force = Force(f"{load.body} (thrust)", (thrust.size, 0.0), at, block, tuple(thrust.source))
        pushed += [force] if thrust.size else []
        source += [] if thrust.size else thrust.source
    if load.seat is not None and not bearing:
        raise GeometryError(f"{placed.where}: it only pushes, so it has no seat; remove seat, or write bearing = true")
    own = part.share * whole * once
    rest = max(own - within, 0.0)
    warnings = [*meeting.warnings, *part.warnings]
    if own > 0.0 and not rest:
        masses = {"mass": Quantity(own, "mass", 3), "within": Quantity(within, "mass", 3)}
        warnings.append(warning("load-lies-within", placed.where, **masses))
    carried = PointMass(load.body, rest, at, bearing, block, tuple(source), load.seat)
    return LoadSet((carried, *pushed) if rest else tuple(pushed), tuple(warnings))


def loaded_blocks(
    load: BodyLoad, body: Solid | None, *, among: MechanismBlocks, taken: Collection[int | None] = ()
) -> LoadedBlocks:
    """Find the blocks that a body loads: the one given, else all that it bears on, or the one that it pushes against.

    Parameters
    ----------
    load : the body as a load
    body : its solid; None without geometry
    among : the blocks of the mechanism
    taken : blocks that other loads of the same body are given on

    Returns
    -------
    The blocks, and warnings

    Raises
    ------
    GeometryError : neither the contact nor the entry shows it, or they contradict each other
    """
    if len(among.pieces) == 1:
        return (LoadedBlock(load.block or 0, 0),), ()
    contacts = _contacts_with_blocks(load, body, among.pieces)
    if not contacts:
        number = load.block if load.block is not None else _nearest_block(load, body, among)
        return (LoadedBlock(number, number),), ()
    axis = _springing_axis(load, body, along=among.along)
    bears = [number for number, each in contacts.items() if carries_weight(each, axis=axis)]
    if load.block is not None:
        left_out = [number for number in bears if number not in taken]
        return _check_given_block(load, load.block, contacts, [*bears, *contacts][0], left_out, among=among)
    found = bears if bears and load.bearing is not False else list(contacts)
    if len(found) > 1:
        _refuse_ambiguous(load, found, contacts, bears, among=among)
    return tuple(LoadedBlock(number, number) for number in found), ()


BETWEEN = 1 / 8  # of the span: a contact this near its middle holds both feet of a roof or vault
BELOW_THE_CUT = "it stands on what the cut leaves still, so it is no load of the mechanism; remove it from `loads`"
BY_ITSELF = ("give `at` and `bearing`", "give it a mesh, box or profile, or write mass and force loads")


@dataclass(frozen=True)
class Surroundings:
    """The surroundings of a load.

    block : solids of the block that it touches, as cut; others : the project's other solids, as the mechanism cuts them
    fixed : what cuts leave standing; along : unit vector of the motion [3]; where : what an error names
    """

    block: tuple[Solid, ...]
    others: tuple[Solid, ...]
    fixed: tuple[Solid, ...]
    along: FloatArray
    where: str


@dataclass(frozen=True)
class LoadSet:
    """The loads that bodies bring, and warnings about them.

    block_by_place : of each load, whether its block follows from where it acts
    """

    loads: tuple[Load, ...]
    warnings: tuple[Message, ...]
    block_by_place: tuple[bool, ...] = ()


@dataclass(frozen=True)
class BodyOnBlock:
    """A body as a load: its definition, its solid (None without geometry), its contacts, and its shape as an arch.

    side : how far from the middle of its span a roof or vault meets the block, over the span, positive with the
        motion [-]
    others : its contacts by other readings of the drawing
    """

    load: BodyLoad
    body: Solid | None
    support: Support | None
    arch: Arch | None
    side: float
    others: tuple[Support, ...]
    where: str

    @property
    def one_foot(self) -> bool:
        """Whether the block holds one foot of a roof or vault, and something else the other."""
        return abs(self.side) > BETWEEN

    @property
    def springs(self) -> FloatArray | None:
        """The axis along which a vault springs from upright faces too [3]; None for other bodies."""
        return self.arch.axis if self.arch is not None and self.load.role == "vault" else None


BEARS_AS_GIVEN = {True: Term("bears (given)"), False: Term("only pushes (given)")}
PUSHES_WHOLE = Term("all of it pushes, its weight is carried elsewhere (Mehrotra 3.2.2)")
HALF = Term("share 0.5 (its other foot is not in the project)")
SOLE_SUPPORT = Term("share 1 (nothing else in the project carries it)")


@dataclass(frozen=True)
class BlockContact:
    """Where a body meets the block and others, None if the user states all of it; and warnings.

    others : where it does by other readings of the drawing, as `readings` lists them
    """

    support: Support | None
    warnings: tuple[Message, ...] = ()
    others: tuple[Support, ...] = ()


FindContact = Callable[[BodyLoad, Solid | None, Surroundings], BlockContact]


@dataclass(frozen=True)
class CarriedShare:
    """The share of a body that the block carries, its source, and warnings."""

    share: float
    source: Term | Message
    warnings: tuple[Message, ...] = ()


@dataclass(frozen=True)
class MechanismBlocks:
    """The blocks of a mechanism as a body meets them.

    pieces : base first; crack : elevation at which two of them part, where it tells them apart [m], else None
    cracked : whether that crack parts one body; along : unit vector of the motion [3]; where : what an error names
    """

    pieces: tuple[Piece, ...]
    crack: float | None
    cracked: bool
    along: FloatArray
    where: str

    def pieces_at(self, number: int) -> tuple[Piece, ...]:
        """Return what is drawn as one with a block: the block, or both parts of a body that a crack parts."""
        return self.pieces if self.cracked else self.pieces[number : number + 1]


@dataclass(frozen=True)
class LoadedBlock:
    """The block that a body loads, and the one whose contact gives place, share and bearing."""

    block: int
    contact: int


def _find_support(load: BodyLoad, body: Solid | None, *, given: bool, around: Surroundings) -> Support | None:
    """Find where the body meets the block and others; None if it does not, or if that is not known.

    given : whether the user says all that follows from it

    Raises GeometryError where nothing can tell, and the user does not either.
    """
    place, shape = BY_ITSELF
    where = f'{around.where}: load "{load.body}"'
    if body is None or not around.block:
        whose = "it" if body is None else "the block"
        if load.role != "floor":
            raise GeometryError(f"{where}: {whose} has no geometry, from which a thrust could be found; {shape}")
        if not given:
            raise GeometryError(f"{where}: {whose} has no geometry, so it is not known where they touch; {place}")
        return None
    found = support(body, block=around.block, others=(*around.others, *around.fixed), tolerance=load.tolerance)
    return None if found is None else _without_shared_space(found, around.block)


def _other_readings(load: BodyLoad, body: Solid, met: BlockContact, *, around: Surroundings) -> Iterator[Support]:
    """Yield the contacts of a body by other readings of the drawing, without bodies that stand where the block does."""
    others = (*around.others, *around.fixed)
    for tolerance, joint in readings(load.tolerance):
        found = support(body, block=around.block, others=others, tolerance=tolerance, joint=joint)
        if found is not None:
            read = _without_overlapping_bodies(load, _without_shared_space(found, around.block), around=around)
            yield from (() if read.support is None else (read.support,))


def _without_shared_space(found: Support, block: tuple[Solid, ...]) -> Support:
    """Leave out contacts with what a cut separated from the block, where both lie at one elevation.

    There the face that the cut made is as near to the body as the face on which it stands.
    """
    own, height = {solid.name for solid in block}, float(found.contact.centroid[2])
    kept = {
        name: each
        for name, each in found.others.items()
        if name not in own or abs(float(each.centroid[2]) - height) > CONTACT_TOLERANCE
    }
    return Support(found.contact, kept)


def _without_overlapping_bodies(load: BodyLoad, found: Support, *, around: Surroundings) -> BlockContact:
    """Leave out contacts with bodies that stand where the block does, and warn of each that overlaps it."""
    kept, warnings = dict(found.others), list[Message]()
    for other in (solid for solid in around.others if solid.name in found.others):
        part, volume = shared_volume(around.block, other)
        if part > SAME_PLACE:
            del kept[other.name]
            warnings.append(warning("load-stands-in-block", load=load.body, other=other.name))
        elif part > OVERLAP_WARNED:
            common = Quantity(volume, "volume", 3)
            warnings.append(warning("load-touches-overlapping", load=load.body, other=other.name, volume=common))
    return BlockContact(Support(found.contact, kept), tuple(warnings))


def _bears_on_block(placed: BodyOnBlock) -> tuple[bool, Term | Message]:
    """Return whether the block carries the body or is only pushed, and the source."""
    given = placed.load.bearing
    if placed.support is None:
        return bool(given), BEARS_AS_GIVEN[bool(given)]
    contact = placed.support.contact
    shown = carries_weight(contact, axis=placed.springs)
    area = {"area": Quantity(contact.area, "area", 3)}
    seen = message("load-bears" if shown else "load-pushes", area)
    if given is None:
        return shown, seen
    return given, message("load-bears-given" if given else "load-pushes-given", {"seen": seen})


def _carried_share(placed: BodyOnBlock, *, bearing: bool) -> CarriedShare:
    """Return the share of the body that the block carries."""
    carried = None if placed.support is None else bearing_contacts(placed.support, axis=placed.springs)
    statics = None
    if placed.body is not None and carried is not None and carried.others:
        statics = share_of(carried, centroid=placed.body.centroid)
    if placed.load.share is not None:
        share = {"share": Quantity(placed.load.share, "ratio", 3)}
        if statics is None:
            return CarriedShare(placed.load.share, message("load-share-given", share))
        if statics == 0.0:
            return CarriedShare(placed.load.share, message("load-share-beside-none", share))
        beside = Quantity(statics, "ratio", 3)
        return CarriedShare(placed.load.share, message("load-share-beside", {**share, "statics": beside}))
    if not bearing:
        warnings = (warning("load-weight-not-carried", load=placed.load.body),) if statics is None else ()
        doubts = () if placed.load.bearing is False else _reading_warnings(placed, 0.0)
        return CarriedShare(1.0, PUSHES_WHOLE, (*warnings, *doubts))
    if statics is None or carried is None:
        found = _share_of_sole_support(placed)
        return replace(found, warnings=(*found.warnings, *_reading_warnings(placed, found.share)))
    if statics == 0.0:
        raise GeometryError(f"{placed.where}: by statics it lifts off the block; give share, or bearing = false")
    names = ", ".join(f'"{name}"' for name in carried.others)
    values: dict[str, Value] = {"share": Quantity(statics, "ratio", 3), "bodies": names}
    return CarriedShare(statics, message("load-share-statics", values), _reading_warnings(placed, statics))


def _reading_warnings(placed: BodyOnBlock, share: float) -> tuple[Message, ...]:
    """Warn where the share of a body on the block hangs on how the drawing is read."""
    if placed.body is None:
        return ()
    ends = unsure_shares(share, [_share_by_reading(each, placed, placed.body) for each in placed.others])
    return () if ends is None else (unsure_share_warning(placed.load.body, share, ends),)


def _share_by_reading(found: Support, placed: BodyOnBlock, body: Solid) -> float:
    """Return the share of a body on the block by one reading of its contacts, 0 if it only pushes against the block."""
    if not (placed.load.bearing or carries_weight(found.contact, axis=placed.springs)):
        return 0.0
    carried = bearing_contacts(found, axis=placed.springs)
    return share_of(carried, centroid=body.centroid) if carried.others else _share_of_sole_support(placed).share


def _share_of_sole_support(placed: BodyOnBlock) -> CarriedShare:
    """Return the share of a body that nothing else in the project carries: all, or half if it has another foot."""
    if placed.arch is not None and placed.one_foot:
        return CarriedShare(0.5, HALF, (warning("load-half-taken", load=placed.load.body),))
    return CarriedShare(1.0, SOLE_SUPPORT, (warning("load-all-taken", load=placed.load.body),))


def _load_place(load: BodyLoad, found: Support | None, *, along: FloatArray) -> Point:
    """Return where the load acts, in the plane of motion [m]."""
    at = load.at
    if at is None:
        assert found is not None  # `_find_support` raises where neither is known
        at = tuple(found.contact.centroid.tolist())
    return point_in_plane(at, along.tolist())


def _place_source(load: BodyLoad, found: Support | None, *, along: FloatArray) -> list[Term | Message]:
    """Say that the load acts at the given place in place of the contact, if it does."""
    if load.at is None:
        return []
    if found is None:
        return [Term("place given")]
    x, z = point_in_plane(found.contact.centroid.tolist(), along.tolist())
    return [message("load-place-given", {"x": Quantity(x, "length"), "z": Quantity(z, "length")})]


def _side_of_span(roof: Solid, found: Support | None, arch: Arch | None, at: Point, *, along: FloatArray) -> float:
    """Return how far from mid-span a roof or vault meets the block, over the span; positive with the motion."""
    axis, place = along, at[0]
    if found is not None and arch is not None:
        axis, place = arch.axis, float(found.contact.centroid @ arch.axis)
    low, high = extent_along(roof, axis=axis)
    return (place - (low + high) / 2.0) / (high - low)


def _thrust_on(placed: BodyOnBlock, *, V: float, along: FloatArray) -> Thrust:
    """Return the thrust of a roof or vault on the block, outwards; V: its vertical reaction there [N]."""
    given = placed.load.thrust is not None
    if given and not placed.one_foot:
        raise GeometryError(
            f"{placed.where}: it meets the block about the middle of its span, so it is not clear which way is "
            'outwards; write the thrust as a load of kind = "force"'
        )
    if not given and not _bears_on_block(placed)[0]:
        return Thrust(0.0, [Term("no thrust: it does not stand on the block")])
    found = thrust_of(placed.load, placed.arch, along=along, V=V)
    if not found.size:
        return found
    if not placed.one_foot:
        return Thrust(0.0, [Term("no thrust: both its feet stand on the block, or none near its ends")])
    return Thrust(float(np.copysign(found.size, placed.side)), [*found.source, Term("outwards")])


LoadedBlocks = tuple[tuple[LoadedBlock, ...], tuple[Message, ...]]  # and warnings


def _contacts_with_blocks(load: BodyLoad, body: Solid | None, pieces: Sequence[Piece]) -> dict[int, ContactArea]:
    """Find where a body meets each block that it touches, by the number of the block."""
    if body is None:
        return {}
    met = {number: _contact_with(piece.solids, body, load.tolerance) for number, piece in enumerate(pieces)}
    return {number: each for number, each in met.items() if each is not None}


def _check_given_block(
    load: BodyLoad,
    given: int,
    contacts: Mapping[int, ContactArea],
    touched: int,
    left_out: Sequence[int],
    *,
    among: MechanismBlocks,
) -> LoadedBlocks:
    """Check the block that the user gives against the contact; raise GeometryError if the contact is with another.

    touched : the block that the contact tells; left_out : those that it bears on, without a load
    """
    if given in contacts:
        cracked = among.cracked and _at_one_elevation(contacts, tolerance=load.tolerance)
        return (LoadedBlock(given, given),), (_left_out_warning(load, left_out[0]),) if left_out and not cracked else ()
    if load.at is None:
        raise GeometryError(
            f'{among.where}: load "{load.body}": block = {given}, yet it touches block {touched}; remove block, or '
            "give `at`, the place where it acts on the block given"
        )
    numbers = {"given": whole_number(given), "touched": whole_number(touched)}
    return (LoadedBlock(given, touched),), (warning("load-on-other-block", load=load.body, **numbers),)


def _left_out_warning(load: BodyLoad, number: int) -> Message:
    return warning("load-part-left-out", load=load.body, block=whole_number(number))


def _refuse_ambiguous(
    load: BodyLoad,
    found: Sequence[int],
    contacts: Mapping[int, ContactArea],
    bears: Sequence[int],
    *,
    among: MechanismBlocks,
) -> None:
    """Raise GeometryError for a body on several blocks whose parts the statics of its contacts cannot tell."""
    which = f'{among.where}: load "{load.body}"'
    numbers = " and ".join(str(number) for number in found)
    if among.cracked and _at_one_elevation(contacts, tolerance=load.tolerance):
        raise GeometryError(
            f"{which}: the crack at z = {among.crack:.4g} m runs through its contact with the wall; give block, 0 "
            "below the crack or 1 above it, or another crack"
        )
    if list(found) != list(bears):
        raise GeometryError(f"{which}: it pushes against blocks {numbers}; give block, the one that it moves with")
    single = [key for key in ("share", "at") if getattr(load, key) is not None]
    if single:
        raise GeometryError(
            f"{which}: it bears on blocks {numbers}, and {single[0]} is of one; remove {single[0]}, or write a load "
            "for each block, with block"
        )


def _at_one_elevation(contacts: Mapping[int, ContactArea], *, tolerance: float) -> bool:
    """Return whether the contacts lie at one elevation, as where a crack divides what a body touches."""
    heights = [float(each.centroid[2]) for each in contacts.values()]
    return len(heights) > 1 and max(heights) - min(heights) <= tolerance


def _springing_axis(load: BodyLoad, body: Solid | None, *, along: FloatArray) -> FloatArray | None:
    """Return the axis along which a vault also springs from upright faces [3]; None for other bodies."""
    arch = arch_of(load, body, along=along) if body is not None and load.role == "vault" else None
    return None if arch is None else arch.axis


def _nearest_block(load: BodyLoad, body: Solid | None, among: MechanismBlocks) -> int:
    """Return the block nearest to the given place, else to the body, if no contact tells.

    Raises GeometryError where that is not known either.
    """
    if load.at is None:
        away = [
            min((shortest_distance(solid, body) for solid in piece.solids), default=inf)
            for piece in among.pieces
            if body
        ]
        return away.index(min(away)) if away else 0  # `met` says what is missing
    x, z = at = point_in_plane(load.at, among.along.tolist())
    if among.crack is not None:
        return int(z >= among.crack)
    off = [(distance_to_outline(piece.body.outline, at) if piece.body.outline else 0.0) for piece in among.pieces]
    if off.count(min(off)) > 1 or not all(piece.body.outline for piece in among.pieces):
        raise GeometryError(
            f'{among.where}: load "{load.body}": it is not known which block it stands on at ({x:.4g}, {z:.4g}) m; '
            "give block, counted from 0 at the base"
        )
    return off.index(min(off))


def _contact_with(solids: Sequence[Solid], body: Solid, tolerance: float) -> ContactArea | None:
    met = (find_contact(solid, body, tolerance=tolerance) for solid in solids)
    return join_contacts([each for each in met if each is not None])
