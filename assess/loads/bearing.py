"""How much of a body a block carries, and where: statics of a rigid body on what it bears on; overburdens of walls.

An overburden is a dead vertical load at the top of a wall of two blocks, without mass of its own (thesis 3.2.3).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from assess.errors import GeometryError
from assess.geometry.boolean import SAME_PLACE, shared_volume, shortest_distance
from assess.geometry.contact import CONTACT_TOLERANCE, JOINT, ContactArea, find_contact, join_contacts
from assess.geometry.cut import Piece
from assess.geometry.planar import top_edge
from assess.geometry.solid import Solid, keep_of_bodies
from assess.geometry.surface import volume
from assess.loads.load import Force, OverburdenLoad, point_in_plane
from assess.messages.message import Message, Quantity, message, warning
from spectra.arrays import FloatArray
from spectra.gravity import g

DRAWN_APART = 0.05  # m: bodies that touch may be drawn this far apart, and a bed or a wall plate be this thick
UNSURE = 0.1  # of a share: readings of a drawing that differ by more do not tell it
LEAST_SHARE = 1e-3  # of the weight of a body: less is none
ACROSS = 0.7  # cosine: an upright face within 45 degrees of square to the axis of a vault is one it springs from


@dataclass(frozen=True)
class Support:
    """How a body meets a block and the other bodies that carry it.

    contact : with the block
    others : contact of each other body that carries it, by name
    """

    contact: ContactArea
    others: Mapping[str, ContactArea]


@dataclass(frozen=True)
class Overburden:
    """The weight on a block of the bodies that it carries: its size [N], and where it acts [3] [m].

    unsure : of each body whose share hangs on how the drawing is read, by name: the share, and the least and largest
    """

    force: float
    at: FloatArray
    unsure: Mapping[str, tuple[float, tuple[float, float]]] = field(default_factory=dict)


def support(
    body: Solid,
    *,
    block: Sequence[Solid],
    others: Iterable[Solid],
    tolerance: float = CONTACT_TOLERANCE,
    joint: float = JOINT,
) -> Support | None:
    """Find how a body meets the solids of a block and the other solids; None if it does not touch the block."""
    return _support((body, *block, *others), len(block), tolerance, joint)


@keep_of_bodies
def _support(solids: tuple[Solid, ...], of_block: int, tolerance: float, joint: float) -> Support | None:
    body, block, others = solids[0], solids[1 : 1 + of_block], solids[1 + of_block :]
    met = (find_contact(solid, body, tolerance=tolerance, joint=joint) for solid in block)
    contact = join_contacts([each for each in met if each is not None])
    if contact is None:
        return None
    found: dict[str, list[ContactArea]] = {}
    for other in others:
        each = find_contact(other, body, tolerance=tolerance, joint=joint)
        if each is not None:
            found.setdefault(other.name, []).append(each)
    joined = {name: join_contacts(each) for name, each in found.items()}
    return Support(contact, {name: each for name, each in joined.items() if each is not None})


def readings(tolerance: float) -> tuple[tuple[float, float], ...]:
    """Return the tolerances and joints [m] by which a drawing can be read as well as by this tolerance and `JOINT`.

    A contact does not depend on them, but they tell which bodies touch, and how wide a slope bears on an edge.
    """
    near = tuple(each for each in (min(tolerance, CONTACT_TOLERANCE), max(tolerance, DRAWN_APART)) if each != tolerance)
    return (*((each, JOINT) for each in near), (tolerance, DRAWN_APART))


def unsure_shares(share: float, others: Iterable[float]) -> tuple[float, float] | None:
    """Return the least and the largest share of a body by all readings of its contacts, None if they agree."""
    every = (share, *others)
    least, most = min(every), max(every)
    return (least, most) if most - least > UNSURE * max(share, least) else None


def unsure_share_warning(
    body: str, share: float, ends: tuple[float, float], *, key: str = "load-share-unsure"
) -> Message:
    """Warn that the share of a body, and its least and largest by other readings of the drawing, differ.

    key : of the warning, whose remedy is a key that the load has
    """
    values = {"share": share, "least": ends[0], "most": ends[1]}
    apart = Quantity(DRAWN_APART, "length", 3)
    return warning(key, load=body, apart=apart, **{k: Quantity(v, "ratio", 3) for k, v in values.items()})


def shares(contacts: Sequence[ContactArea], *, centroid: FloatArray) -> FloatArray:
    """Return the share of a body's weight that goes to each contact [n]; they add up to 1.

    The body is rigid and each contact yields in proportion to its area A. With d the place of a contact in plan from
    their common centre, and e that of the body's centroid, equilibrium of weight and of both moments gives

        r = A / sum A + A d . K+ e        K = sum A d d^T

    Two contacts are a beam on two supports whatever their areas: r = 1 - x / l along the line between them. K+ is the
    pseudo-inverse: moments that the contacts cannot take (across that line, or about a single one) are left out.
    A negative part is one that would have to hold the body down.

    Parameters
    ----------
    contacts : of the body with what carries it
    centroid : of the body [3] [m]
    """
    A = np.array([each.area for each in contacts])
    at = np.array([each.centroid[:2] for each in contacts])
    middle = A @ at / A.sum()
    d, e = at - middle, centroid[:2] - middle
    return np.asarray(A / A.sum() + A * (d @ (np.linalg.pinv((A * d.T) @ d, rcond=1e-9) @ e)), dtype=np.float64)


def share_of(found: Support, *, centroid: FloatArray) -> float:
    """Return the share of a body's weight that goes to the block, at most 1; 0 if it would hold it down."""
    share = min(float(shares([found.contact, *found.others.values()], centroid=centroid)[0]), 1.0)
    return share if share >= LEAST_SHARE else 0.0


def bearing_contacts(found: Support, *, axis: FloatArray | None = None) -> Support:
    """Return the support without the other bodies that the body only pushes against.

    axis : along which a vault springs [3]; its faces across that carry it though they are upright
    """
    others = {name: each for name, each in found.others.items() if carries_weight(each, axis=axis)}
    return Support(found.contact, others)


def carries_weight(contact: ContactArea, *, axis: FloatArray | None) -> bool:
    """Return whether weight passes through a contact: it bears, or a vault springs from it along the axis [3]."""
    return contact.bearing or (axis is not None and abs(float(contact.normal @ axis)) > ACROSS)


def overburden(
    bodies: Sequence[Solid], *, block: Sequence[Solid], others: Sequence[Solid], tolerance: float = CONTACT_TOLERANCE
) -> Overburden:
    """Return the weight that bodies put on a block, at the weighted centroid of their contacts.

    What a body shares with the block is the block's, and has its weight there already.

    Raises
    ------
    GeometryError : a body does not bear on the block or would lift off it, or there is none
    """
    weights, places, unsure = [], [], {}
    for body in bodies:
        found = support(body, block=block, others=others, tolerance=tolerance)
        if found is None or not found.contact.bearing:
            raise GeometryError(
                f'body "{body.name}": it does not bear on the block; {no_contact_text(body, block=block)}'
            )
        share = share_of(bearing_contacts(found), centroid=body.centroid)
        if share == 0.0:
            raise GeometryError(f'body "{body.name}": by statics it lifts off the block; give its load as a force')
        other = (
            support(body, block=block, others=others, tolerance=near, joint=joint)
            for near, joint in readings(tolerance)
        )
        read = [share_of(bearing_contacts(each), centroid=body.centroid) for each in other if each is not None]
        if (ends := unsure_shares(share, read)) is not None:
            unsure[body.name] = (share, ends)
        own = 1.0 - min(1.0, shared_volume(block, body)[1] / volume(body.vertices, body.triangles))
        weights.append(g * body.mass * own * share)
        places.append(found.contact.centroid)
    if not weights:
        raise GeometryError("overburden: it has no bodies; name at least one")
    force = float(sum(weights))
    return Overburden(force, np.asarray(np.array(weights) @ np.array(places) / force, dtype=np.float64), unsure)


def no_contact_text(body: Solid, *, block: Sequence[Solid]) -> str:
    """Say how far a body that does not load the block is from it, and what to do."""
    if any((find_contact(body, solid) or _NO_CONTACT).bearing for solid in block):
        return "the block stands on it, so it is no load of the block; remove it from `loads`"
    distance = min(shortest_distance(solid, body) for solid in block)
    if distance == 0.0:
        return "they meet along an edge or at a point only; move it onto or into the block"
    return f"it lies {distance:.3g} m away; move it, or raise `tolerance`"


_NO_CONTACT = ContactArea(0.0, np.zeros(3), np.zeros(3), bearing=False)
UPPER = 1  # the block it stands on
ROUNDING = 1e-9  # of the thickness: a load this near its edge is on it
WEIGHT = "a weight, which stays"


def overburden_force(
    number: int,
    load: OverburdenLoad,
    *,
    piece: Piece,
    solids: Mapping[str, Solid | None],
    moving: Sequence[str],
    direction: Sequence[float],
    where: str,
) -> tuple[Force, tuple[Message, ...]]:
    """Return an overburden as a force on the top of a wall, and warnings.

    Parameters
    ----------
    number : of the entry among the loads, from 1
    load : the overburden as stated
    piece : the upper block of the wall, or the wall that it is cut from
    solids : of all bodies, by name
    moving : names of the wall's bodies
    direction : of the motion, horizontal [3]
    where : what an error names

    Raises
    ------
    GeometryError : the wall has no geometry, a body does not bear on it, or the load is beside its top
    """
    name = overburden_name(number)
    head = top_edge(piece.body)
    if head is None:
        raise GeometryError(f'{where}: the wall has no geometry, so no top; write a load of kind = "force"')
    middle, elevation = (head[0][0] + head[1][0]) / 2.0, head[0][1]
    _require_on_top(load, thickness=head[1][0] - head[0][0], where=where)
    if load.force is not None:
        at = (middle + (load.eccentricity or 0.0), elevation)
        return Force(name, (0.0, -load.force), at, UPPER, until="collapse", evidence=WEIGHT), ()
    found, states = _weight_on_wall(load, piece, solids, moving, where=where)
    x = point_in_plane(found.at.tolist(), direction)[0]
    if load.eccentricity is not None or load.through == "joint":
        x = middle + (load.eccentricity or 0.0)  # at rest the resultant of a joint is in its middle
    aside = Quantity(x - middle, "length", 3)
    source = [message("load-overburden", {"bodies": ", ".join(load.bodies), "aside": aside})]
    source += [message("load-not-shared", {"bodies": ", ".join(states)})] if states else []
    force = Force(name, (0.0, -found.force), (x, elevation), UPPER, tuple(source), until="collapse", evidence=WEIGHT)
    key = "overburden-share-unsure"
    return force, tuple(unsure_share_warning(body, *each, key=key) for body, each in found.unsure.items())


def overburden_name(number: int) -> str:
    """Return the name of the overburden that is entry `number` of the loads, from 1."""
    return f"overburden {number}"


def _weight_on_wall(
    load: OverburdenLoad, piece: Piece, solids: Mapping[str, Solid | None], moving: Sequence[str], *, where: str
) -> tuple[Overburden, list[str]]:
    """Return the weight that bodies put on the wall, and the bodies left out because they are drawn in its place."""
    carried = [_require_solid(body, solids, where=where) for body in load.bodies]
    beside = [solid for key, solid in solids.items() if solid is not None and key not in (*moving, *load.bodies)]
    states = [solid.name for solid in beside if shared_volume(piece.solids, solid)[0] > SAME_PLACE]
    others = [solid for solid in beside if solid.name not in states]
    return overburden(carried, block=piece.solids, others=others), states


def _require_on_top(load: OverburdenLoad, *, thickness: float, where: str) -> None:
    """Raise GeometryError if the eccentricity puts a load beside the top of the wall; thickness: of the top [m]."""
    beyond = abs(load.eccentricity or 0.0) - thickness / 2.0
    if beyond > ROUNDING * thickness:
        raise GeometryError(
            f"{where}.eccentricity = {load.eccentricity:.4g} m: {beyond:.3g} m outside the wall, whose top is "
            f"{thickness:.4g} m thick; give at most {thickness / 2.0:.4g} m from mid-thickness"
        )


def _require_solid(body: str, solids: Mapping[str, Solid | None], *, where: str) -> Solid:
    """Return the solid of a body that presses; raise GeometryError for one without geometry."""
    solid = solids[body]
    if solid is None:
        raise GeometryError(f'{where}: body "{body}" has no geometry; give its weight as `force`')
    return solid
