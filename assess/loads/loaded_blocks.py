"""Which block of a mechanism a body loads: the one whose masonry, as cut, it stands on or pushes against."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from math import inf

from assess.errors import GeometryError
from assess.geometry.boolean import shortest_distance
from assess.geometry.contact import Contact, find_contact, join_contacts
from assess.geometry.outline import distance
from assess.geometry.piece import Piece
from assess.geometry.solid import Solid
from assess.loads.bearing import carries_weight
from assess.loads.definitions import BodyLoad
from assess.loads.load import Point
from assess.loads.plane import point_in_plane
from assess.loads.roofs_and_vaults import arch_of
from assess.messages.message import Message, warning, whole_number
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class Blocks:
    """The blocks of a mechanism as a body meets them.

    pieces : base first; crack : elevation at which two of them part, where it tells them apart [m], else None
    parted : whether that crack parts one body; along : unit vector of the motion [3]; where : what an error names
    """

    pieces: tuple[Piece, ...]
    crack: float | None
    parted: bool
    along: FloatArray
    where: str


@dataclass(frozen=True)
class Loaded:
    """The block that a body loads, and the one whose contact gives place, share and bearing."""

    block: int
    contact: int


Found = tuple[tuple[Loaded, ...], tuple[Message, ...]]  # and warnings


def loaded_blocks(load: BodyLoad, body: Solid | None, *, among: Blocks, taken: Collection[int | None] = ()) -> Found:
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
        return (Loaded(load.block or 0, 0),), ()
    contacts = contacts_of(load, body, among.pieces)
    if not contacts:
        number = load.block if load.block is not None else nearest_block(load, body, among)
        return (Loaded(number, number),), ()
    axis = springing(load, body, along=among.along)
    bears = [number for number, each in contacts.items() if carries_weight(each, axis=axis)]
    if load.block is not None:
        left_out = [number for number in bears if number not in taken]
        return as_given(load, load.block, contacts, [*bears, *contacts][0], left_out, among=among)
    found = bears if bears and load.bearing is not False else list(contacts)
    if len(found) > 1:
        refuse_ambiguous(load, found, contacts, bears, among=among)
    return tuple(Loaded(number, number) for number in found), ()


def contacts_of(load: BodyLoad, body: Solid | None, pieces: Sequence[Piece]) -> dict[int, Contact]:
    """Find where a body meets each block that it touches, by the number of the block."""
    if body is None:
        return {}
    met = {number: _met(piece.solids, body, load.tolerance) for number, piece in enumerate(pieces)}
    return {number: each for number, each in met.items() if each is not None}


def as_given(
    load: BodyLoad,
    given: int,
    contacts: Mapping[int, Contact],
    touched: int,
    left_out: Sequence[int],
    *,
    among: Blocks,
) -> Found:
    """Check the block that the user gives against the contact; raise GeometryError if the contact is with another.

    touched : the block that the contact tells; left_out : those that it bears on, without a load
    """
    if given in contacts:
        cracked = among.parted and at_one_place(contacts, tolerance=load.tolerance)
        return (Loaded(given, given),), (_left_out(load, left_out[0]),) if left_out and not cracked else ()
    if load.at is None:
        raise GeometryError(
            f'{among.where}: load "{load.body}": block = {given}, yet it touches block {touched}; remove block, or '
            "give `at`, the place where it acts on the block given"
        )
    numbers = {"given": whole_number(given), "touched": whole_number(touched)}
    return (Loaded(given, touched),), (warning("load-on-other-block", load=load.body, **numbers),)


def _left_out(load: BodyLoad, number: int) -> Message:
    return warning("load-part-left-out", load=load.body, block=whole_number(number))


def refuse_ambiguous(
    load: BodyLoad,
    found: Sequence[int],
    contacts: Mapping[int, Contact],
    bears: Sequence[int],
    *,
    among: Blocks,
) -> None:
    """Raise GeometryError for a body on several blocks whose parts the statics of its contacts cannot tell."""
    which = f'{among.where}: load "{load.body}"'
    numbers = " and ".join(str(number) for number in found)
    if among.parted and at_one_place(contacts, tolerance=load.tolerance):
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


def at_one_place(contacts: Mapping[int, Contact], *, tolerance: float) -> bool:
    """Return whether the contacts lie at one elevation, as where a crack divides what a body touches."""
    heights = [float(each.centroid[2]) for each in contacts.values()]
    return len(heights) > 1 and max(heights) - min(heights) <= tolerance


def springing(load: BodyLoad, body: Solid | None, *, along: FloatArray) -> FloatArray | None:
    """Return the axis along which a vault also springs from upright faces [3]; None for other bodies."""
    arch = arch_of(load, body, along=along) if body is not None and load.role == "vault" else None
    return None if arch is None else arch.axis


def nearest_block(load: BodyLoad, body: Solid | None, among: Blocks) -> int:
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
    off = [_off(piece, at) for piece in among.pieces]
    if off.count(min(off)) > 1 or not all(piece.body.outline for piece in among.pieces):
        raise GeometryError(
            f'{among.where}: load "{load.body}": it is not known which block it stands on at ({x:.4g}, {z:.4g}) m; '
            "give block, counted from 0 at the base"
        )
    return off.index(min(off))


def _off(piece: Piece, at: Point) -> float:
    return distance(piece.body.outline, at) if piece.body.outline else 0.0


def _met(solids: Sequence[Solid], body: Solid, tolerance: float) -> Contact | None:
    met = (find_contact(solid, body, tolerance=tolerance) for solid in solids)
    return join_contacts([each for each in met if each is not None])
