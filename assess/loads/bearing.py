"""How much of a body a block carries, and where: statics of a rigid body on what it bears on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.errors import GeometryError
from assess.geometry.boolean import shortest_distance
from assess.geometry.contact import CONTACT_TOLERANCE, Contact, find_contact, join_contacts
from assess.geometry.solid import Solid
from spectra.arrays import FloatArray

ACROSS = 0.7  # cosine: an upright face within 45 degrees of square to the axis of a vault is one it springs from


@dataclass(frozen=True)
class Support:
    """How a body meets a block and the other bodies that carry it.

    contact : with the block
    others : contact of each other body that carries it, by name
    """

    contact: Contact
    others: Mapping[str, Contact]


@dataclass(frozen=True)
class Overburden:
    """The weight on a block of the bodies that it carries: its size [N], and where it acts [3] [m]."""

    force: float
    at: FloatArray


def support(
    body: Solid, *, block: Sequence[Solid], others: Iterable[Solid], tolerance: float = CONTACT_TOLERANCE
) -> Support | None:
    """Find how a body meets the solids of a block and the other solids; None if it does not touch the block."""
    met = (find_contact(solid, body, tolerance=tolerance) for solid in block)
    contact = join_contacts([each for each in met if each is not None])
    if contact is None:
        return None
    found: dict[str, list[Contact]] = {}
    for other in others:
        each = find_contact(other, body, tolerance=tolerance)
        if each is not None:
            found.setdefault(other.name, []).append(each)
    joined = {name: join_contacts(each) for name, each in found.items()}
    return Support(contact, {name: each for name, each in joined.items() if each is not None})


def shares(contacts: Sequence[Contact], *, centroid: FloatArray) -> FloatArray:
    """Return the share of a body's weight that goes to each contact [n]; they add up to 1.

    The body is rigid and each contact yields in proportion to its area A. With d the place of a contact in plan from
    their common centre, and e that of the body's centroid, equilibrium of weight and of both moments gives

        r = A / sum A + A d . K+ e        K = sum A d d^T

    Two contacts are a beam on two supports whatever their areas: r = 1 - x / l along the line between them. K+ is the
    pseudo-inverse: moments that the contacts cannot take (across that line, or about a single one) are left out.
    A negative part is one that would have to hold the body down.
    """
    A = np.array([each.area for each in contacts])
    at = np.array([each.centroid[:2] for each in contacts])
    middle = A @ at / A.sum()
    d, e = at - middle, centroid[:2] - middle
    return np.asarray(A / A.sum() + A * (d @ (np.linalg.pinv((A * d.T) @ d, rcond=1e-9) @ e)), dtype=np.float64)


def share_of(found: Support, *, centroid: FloatArray) -> float:
    """Return the share of a body's weight that goes to the block: 0 if it would hold the body down, at most 1."""
    r = shares([found.contact, *found.others.values()], centroid=centroid)
    return float(np.clip(r[0], 0.0, 1.0))


def bearing_contacts(found: Support, *, axis: FloatArray | None = None) -> Support:
    """Return the support without the other bodies that the body only pushes against.

    axis : along which a vault springs [3]; its faces across that carry it though they are upright
    """
    others = {name: each for name, each in found.others.items() if carries_weight(each, axis=axis)}
    return Support(found.contact, others)


def carries_weight(contact: Contact, *, axis: FloatArray | None) -> bool:
    """Return whether weight passes through a contact: it bears, or a vault springs from it along the axis [3]."""
    return contact.bearing or (axis is not None and abs(float(contact.normal @ axis)) > ACROSS)


def overburden(
    bodies: Sequence[Solid], *, block: Sequence[Solid], others: Sequence[Solid], tolerance: float = CONTACT_TOLERANCE
) -> Overburden:
    """Return the weight that bodies put on a block, at the weighted centroid of their contacts.

    Raises
    ------
    GeometryError : a body does not bear on the block or would lift off it, or there is none
    """
    weights, places = [], []
    for body in bodies:
        found = support(body, block=block, others=others, tolerance=tolerance)
        if found is None or not found.contact.bearing:
            raise GeometryError(f'body "{body.name}": it does not bear on the block; {nearest(body, block=block)}')
        share = share_of(bearing_contacts(found), centroid=body.centroid)
        if share == 0.0:
            raise GeometryError(f'body "{body.name}": by statics it lifts off the block; give its load as a force')
        weights.append(g * body.mass * share)
        places.append(found.contact.centroid)
    if not weights:
        raise GeometryError("overburden: it has no bodies; name at least one")
    force = float(sum(weights))
    return Overburden(force, np.asarray(np.array(weights) @ np.array(places) / force, dtype=np.float64))


def nearest(body: Solid, *, block: Sequence[Solid]) -> str:
    """Say how far a body that does not load the block is from it, and what to do."""
    if any((find_contact(body, solid) or _NO_CONTACT).bearing for solid in block):
        return "the block stands on it, so it is no load of the block; remove it from `loads`"
    distance = min(shortest_distance(solid, body) for solid in block)
    if distance == 0.0:
        return "they meet along an edge or at a point only; move it onto or into the block"
    return f"it lies {distance:.3g} m away; move it, or raise `tolerance`"


_NO_CONTACT = Contact(0.0, np.zeros(3), np.zeros(3), bearing=False)
