"""The entries `overburden` of a wall of two blocks: dead vertical loads at its top, without mass (thesis 3.2.3)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import dist
from typing import Literal

from assess.errors import GeometryError
from assess.geometry.planar import top_edge
from assess.geometry.solid import Solid
from assess.loads.bearing import overburden
from assess.loads.load import Force, Load
from assess.loads.plane import point_in_plane
from assess.mechanisms.chain import Chain
from assess.mechanisms.flexible import through_top
from assess.mechanisms.joint import Joint
from assess.model.overlaps import SAME_PLACE, shared_with
from assess.model.pieces import Piece, Solids
from assess.project import sections

UPPER = 1  # the block it stands on
ROUNDING = 1e-9  # of the thickness: a load this near its edge is on it
ON_MIDDLE = 1e-3  # of the depth of a joint: a load this near its middle comes through it unless said otherwise
THROUGH_TOP = (
    "interface C: the load on the middle of the top comes through the joint there, so its resultant moves to the edge "
    "as the wall turns, and is at hinge C in the rigid mechanism beside it; a load off the middle stays in its place, "
    'and so does one with through = "fixed"'
)

WEIGHT = "a weight, which stays"

Through = Literal["joint", "fixed"] | None


def overburden_of(
    number: int,
    load: sections.OverburdenLoad,
    *,
    piece: Piece,
    solids: Solids,
    moving: Sequence[str],
    direction: Sequence[float],
    where: str,
) -> Force:
    """One overburden of the wall whose upper block is `piece`, or is cut from it; moving: names of the wall's bodies.

    Raises GeometryError for a wall without geometry, a body that does not bear on it, or a load beside its top.
    """
    name = named(number)
    head = top_edge(piece.body)
    if head is None:
        raise GeometryError(f'{where}: {name}: the wall has no geometry, so no top; write a load of kind = "force"')
    middle, elevation = (head[0][0] + head[1][0]) / 2.0, head[0][1]
    require_on_top(load, thickness=head[1][0] - head[0][0], where=f"{where}: {name}")
    if load.force is not None:
        at = (middle + (load.eccentricity or 0.0), elevation)
        return Force(name, (0.0, -load.force), at, UPPER, until="collapse", evidence=WEIGHT)
    carried = [pressing(body, solids, where=f"{where}: {name}") for body in load.bodies]
    beside = [solid for key, solid in solids.items() if solid is not None and key not in (*moving, *load.bodies)]
    states = [solid.name for solid in beside if shared_with(piece.solids, solid)[0] > SAME_PLACE]
    others = [solid for solid in beside if solid.name not in states]
    found = overburden(carried, block=piece.solids, others=others)
    x = point_in_plane(found.at.tolist(), direction)[0]
    if load.eccentricity is not None or load.through == "joint":
        x = middle + (load.eccentricity or 0.0)  # at rest the resultant of a joint is in its middle
    source = f"weight of {', '.join(load.bodies)} on the wall, {x - middle:+.3g} m from mid-thickness"
    source += f"; not shared with {', '.join(states)}, which stands where the wall does" if states else ""
    return Force(name, (0.0, -found.force), (x, elevation), UPPER, source, until="collapse", evidence=WEIGHT)


def require_on_top(load: sections.OverburdenLoad, *, thickness: float, where: str) -> None:
    """Raise GeometryError where the eccentricity puts a load beside the top of the wall; thickness: of the top [m]."""
    beyond = abs(load.eccentricity or 0.0) - thickness / 2.0
    if beyond > ROUNDING * thickness:
        raise GeometryError(
            f"{where}: eccentricity {load.eccentricity:.4g} m is {beyond:.3g} m outside the wall, whose top is "
            f"{thickness:.4g} m thick; give at most {thickness / 2.0:.4g} m from mid-thickness"
        )


def pressing(body: str, solids: Solids, *, where: str) -> Solid:
    """The solid of a body that presses; raises GeometryError for one of direct values."""
    solid = solids[body]
    if solid is None:
        raise GeometryError(f'{where}: body "{body}" has no geometry; give its weight as `force`')
    return solid


def named(number: int) -> str:
    """Of the overburden that is entry `number` of the loads, from 1."""
    return f"overburden {number}"


def through_of(loads: Sequence[sections.LoadTable]) -> dict[str, Through]:
    """How each overburden comes to its wall, by the name of its force."""
    entries = enumerate(loads, start=1)
    return {named(number): load.through for number, load in entries if isinstance(load, sections.OverburdenLoad)}


def through_joint(chain: Chain, joint: Joint | None, through: Mapping[str, Through]) -> Chain:
    """The chain with the loads that come through the joint at the top of a wall moved to its hinge.

    On a joint their resultant is in the middle at rest all the same, and moves to the edge as the wall turns; where
    the top is rigid they press at the hinge of each direction.
    """
    if len(chain.blocks) != 2:
        return chain
    loads = [
        replace(load, at=chain.hinges[2]) if comes_through(load, chain, joint, through.get(load.name)) else load
        for load in chain.loads
    ]
    return replace(chain, loads=tuple(loads))


def comes_through(load: Load, chain: Chain, joint: Joint | None, through: Through) -> bool:
    """Whether a load of a wall comes through the joint at its top: as is said, else where it stands on the middle."""
    if through is not None:
        return through == "joint"
    if joint is None or load.block != UPPER:
        return False
    inside = joint.section.centroid
    middle = tuple(at + inside * way for at, way in zip(chain.hinges[2], joint.inward, strict=True))
    return dist(load.at, middle) <= ON_MIDDLE * joint.section.depth


def under_loads(
    chain: Chain, joints: tuple[Joint | None, ...], through: Mapping[str, Through]
) -> tuple[Joint | None, ...]:
    """The joints of a chain; without that at the top of a wall where all that stands at its hinge is fixed there."""
    if len(chain.blocks) != 2:
        return joints
    at_hinge = through_top(chain)
    fixed = bool(at_hinge) and all(through.get(load.name) == "fixed" for load in at_hinge)
    return (*joints[:2], None) if fixed else joints
