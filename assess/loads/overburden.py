"""The entries `overburden` of a wall of two blocks: dead vertical loads at its top, without mass (thesis 3.2.3)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from assess.errors import GeometryError
from assess.geometry.boolean import SAME_PLACE, shared_volume
from assess.geometry.cut import Piece
from assess.geometry.planar import top_edge
from assess.geometry.solid import Solid
from assess.loads.bearing import Overburden, overburden
from assess.loads.definitions import OverburdenLoad
from assess.loads.load import Force, point_in_plane
from assess.messages.message import Quantity, message

UPPER = 1  # the block it stands on
ROUNDING = 1e-9  # of the thickness: a load this near its edge is on it
WEIGHT = "a weight, which stays"


def overburden_of(
    number: int,
    load: OverburdenLoad,
    *,
    piece: Piece,
    solids: Mapping[str, Solid | None],
    moving: Sequence[str],
    direction: Sequence[float],
    where: str,
) -> Force:
    """Return an overburden as a force on the top of a wall.

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
    name = name_of(number)
    head = top_edge(piece.body)
    if head is None:
        raise GeometryError(f'{where}: {name}: the wall has no geometry, so no top; write a load of kind = "force"')
    middle, elevation = (head[0][0] + head[1][0]) / 2.0, head[0][1]
    require_on_top(load, thickness=head[1][0] - head[0][0], where=f"{where}: {name}")
    if load.force is not None:
        at = (middle + (load.eccentricity or 0.0), elevation)
        return Force(name, (0.0, -load.force), at, UPPER, until="collapse", evidence=WEIGHT)
    found, states = weight_of(load, piece, solids, moving, where=f"{where}: {name}")
    x = point_in_plane(found.at.tolist(), direction)[0]
    if load.eccentricity is not None or load.through == "joint":
        x = middle + (load.eccentricity or 0.0)  # at rest the resultant of a joint is in its middle
    aside = Quantity(x - middle, "length", 3)
    said = [message("load-overburden", {"bodies": ", ".join(load.bodies), "aside": aside})]
    said += [message("load-not-shared", {"bodies": ", ".join(states)})] if states else []
    return Force(name, (0.0, -found.force), (x, elevation), UPPER, tuple(said), until="collapse", evidence=WEIGHT)


def weight_of(
    load: OverburdenLoad, piece: Piece, solids: Mapping[str, Solid | None], moving: Sequence[str], *, where: str
) -> tuple[Overburden, list[str]]:
    """Return the weight that bodies put on the wall, and the bodies left out because they are drawn in its place."""
    carried = [require_solid(body, solids, where=where) for body in load.bodies]
    beside = [solid for key, solid in solids.items() if solid is not None and key not in (*moving, *load.bodies)]
    states = [solid.name for solid in beside if shared_volume(piece.solids, solid)[0] > SAME_PLACE]
    others = [solid for solid in beside if solid.name not in states]
    return overburden(carried, block=piece.solids, others=others), states


def require_on_top(load: OverburdenLoad, *, thickness: float, where: str) -> None:
    """Raise GeometryError if the eccentricity puts a load beside the top of the wall; thickness: of the top [m]."""
    beyond = abs(load.eccentricity or 0.0) - thickness / 2.0
    if beyond > ROUNDING * thickness:
        raise GeometryError(
            f"{where}: eccentricity {load.eccentricity:.4g} m is {beyond:.3g} m outside the wall, whose top is "
            f"{thickness:.4g} m thick; give at most {thickness / 2.0:.4g} m from mid-thickness"
        )


def require_solid(body: str, solids: Mapping[str, Solid | None], *, where: str) -> Solid:
    """Return the solid of a body that presses; raise GeometryError for one without geometry."""
    solid = solids[body]
    if solid is None:
        raise GeometryError(f'{where}: body "{body}" has no geometry; give its weight as `force`')
    return solid


def name_of(number: int) -> str:
    """Return the name of the overburden that is entry `number` of the loads, from 1."""
    return f"overburden {number}"
