"""The directions towards which a mechanism may topple, each with its multiplier and what stops it there.

They are what the edges of the base face in plan, and the opposites: there the multiplier of a block is least. Of a wall
held at base and top they are the two ways across its thickness.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import Any

import numpy as np
from scipy.constants import g

from assess.errors import AssessError, FallingError
from assess.geometry.footprint import edge_normals
from assess.geometry.planar import lowest_corners
from assess.loads.plane import point_in_plane
from assess.mechanisms.chain import Chain
from assess.mechanisms.directions import Candidate, Vector
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.variants import collapse_branch
from assess.mechanisms.virtual_work import virtual_work
from assess.model.assembly import on_rigid_hinges
from assess.model.body import Bodies
from assess.model.definitions import Chained, CutAngle, Restitution, SingleBlock, Turnable, TwoBlock
from assess.model.directions import S, block_above_cut, block_by_direction, normals_of, solids_of_blocks, turn_towards
from assess.model.obstacles import Obstacle, bodies_that_stop, obstacles_of
from assess.oscillator import displacement
from spectra.arrays import FloatArray

NEAR = 1.1  # multipliers up to this many times the least are compared by d0*
HELD = 1.5  # of the least multiplier: free directions this much stronger do not stand for a weak axis held both ways
ON_SIDE = (0.5, 1.1)  # of the half width of the base: a given hinge is on the side towards which it is as far out
OTHER_SIDE = "the hinge that is given lies on another side"
DIGITS = 6  # candidates that agree to so many are as weak

Towards = Callable[[Vector], Mechanism]


@dataclass(frozen=True)
class Look:
    """A mechanism whose directions are compared.

    definition : as stated; foot : corners [k, 3] of what it stands on [m]; obstacles : the bodies beside it
    ways : angles of the candidates [deg]
    at : the mechanism towards a direction, of one side and on rigid hinges
    """

    name: str
    definition: Turnable
    bodies: Bodies
    foot: FloatArray
    obstacles: tuple[Obstacle, ...]
    ways: tuple[float, ...]
    at: Towards

    @property
    def where(self) -> str:
        """The table, as messages name it."""
        return f"mechanisms.{self.name}"


def look_around(name: str, definition: Turnable, bodies: Bodies) -> Look:
    """Find the candidate directions of a mechanism and the bodies beside it."""
    standing, bare = solids_of_blocks(name, definition, bodies), plain(definition)
    if isinstance(bare, SingleBlock) and not isinstance(bare.cut, CutAngle):
        block = block_above_cut(name, bare, standing)
        standing, foot, at = block.solids, block.foot, block_by_direction(name, bare, block, bodies)
    else:
        foot = lowest_corners(standing)

        def at(way: Vector) -> Mechanism:
            return on_rigid_hinges(name, turn_towards(bare, way), bodies)[0]

    ways = ways_of(definition, foot, np.concatenate([solid.vertices for solid in standing]))
    return Look(name, definition, bodies, foot, obstacles_of(definition, standing, bodies), ways, at)


def ways_of(definition: Chained, foot: FloatArray, corners: FloatArray) -> tuple[float, ...]:
    """Return the angles [deg] of the candidates, rising, from the corners of the base and of the whole mechanism."""
    plan = edge_normals(corners)
    if isinstance(definition, TwoBlock):
        normals = across(corners[:, :2], plan)
    else:
        normals = plan if isinstance(definition.cut, CutAngle) else normals_of(foot)
    normals = normals if normals.size else plan
    return tuple(np.unique(np.round(np.concatenate([normals, normals + 180.0]), 9) % 360.0).tolist())


def plain(definition: S) -> S:
    """Return the definition for one side, without what depends on the impacts or is measured along the direction."""
    changes: dict[str, Any] = {"sides": "one", "restitution": Restitution(positive=0.0, negative=0.0)}
    if definition.direction is None:
        keys = set(definition.keys_along())
        flat = {key[1] for key in keys if key[0] == "loads"}
        changes["loads"] = tuple(load for place, load in enumerate(definition.loads) if place not in flat)
        if any(key[0] == "hinges" for key in keys):
            changes["hinges"] = None
    return replace(definition, **{**changes, "hinges_negative": None})


def across(plan: FloatArray, normals: FloatArray) -> FloatArray:
    """Return the normal [deg] among [k] along which a plan [n, 2] is thinnest, the first of equals."""
    at = np.radians(normals)
    width = np.ptp(plan @ np.array([np.cos(at), np.sin(at)]), axis=0)
    return normals[[int(np.argmin(np.round(width / width.max(), DIGITS)))]]


def evaluate_all(look: Look) -> tuple[Candidate, ...]:
    """Evaluate every candidate: its multiplier, or why it cannot rock that way, and what touches it there."""
    return tuple(evaluate(angle, look) for angle in look.ways)


def evaluate(angle: float, look: Look) -> Candidate:
    """Evaluate one candidate; raise FallingError if it already falls and no direction is given."""
    asked = Candidate(angle)
    asked = replace(asked, touching=bodies_that_stop(look.obstacles, asked.way))
    if not on_side(look, asked.way):
        return replace(asked, why=OTHER_SIDE)
    try:
        return replace(asked, multiplier=uplift(look.at(asked.way).positive))
    except FallingError as error:
        if look.definition.direction is None and not asked.touching:
            raise FallingError(
                f"{error} (towards {vector_text(asked.way)}, looked at as `direction` is absent)"
            ) from None
        return replace(asked, why=str(error))
    except AssessError as error:
        return replace(asked, why=str(error))


def on_side(look: Look, way: Vector) -> bool:
    """Return whether a hinge given in space lies on the side of the base towards `way`; true if none is given."""
    hinges = look.definition.hinge_points
    if hinges is None or len(hinges[0]) == 2:
        return True
    reach = look.foot @ np.array(way)
    low, high = float(reach.min()), float(reach.max())
    out = (point_in_plane(hinges[0], way)[0] - (low + high) / 2.0) / ((high - low) / 2.0)
    return ON_SIDE[0] < out < ON_SIDE[1]


def vector_text(way: Vector) -> str:
    """Write a direction as the project file does."""
    return "[" + ", ".join(f"{round(part, 6) + 0.0:g}" for part in way) + "]"


def uplift(chain: Chain) -> float:
    """Return the uplift multiplier of a chain on rigid hinges [-]."""
    work = virtual_work(chain, np.zeros(1))
    return float(work.restoring[0] / (g * work.excitation[0]))


def with_displacement(candidate: Candidate, look: Look) -> Candidate:
    """Return the candidate with d0* of its control point."""
    return replace(candidate, displacement=displacement_of(look.at(candidate.way).positive, name=look.name))


def displacement_of(chain: Chain, *, name: str) -> float | None:
    """Return d0* of a chain on rigid hinges, the displacement at overturning [m]; None if it never overturns.

    With what is shown to last to collapse: 0 where it stands only by other ties and forces.
    """
    try:
        side = collapse_branch(chain, name=name)
    except FallingError:
        return 0.0
    except AssessError:
        return None
    return float(displacement(side, np.array(side.overturning), mass=chain.mass))


def free_of(known: Sequence[Candidate]) -> tuple[list[Candidate], bool]:
    """Return the candidates that nothing stops; all of them, and True, if bodies hold the weak axis both ways.

    What holds a wall on both faces, as a floor and a buttress may, does not make its own plane its weak direction.
    """
    free = [each for each in known if not each.touching]
    least = min(known, key=rank)
    back = [each for each in known if abs((each.angle - least.angle) % 360.0 - 180.0) < 1e-6]
    both = bool(least.touching) and all(each.touching for each in back)
    if not free or (both and worth(min(free, key=rank)) > HELD * worth(least)):
        return list(known), True
    return free, False


def worth(candidate: Candidate) -> float:
    """Return the multiplier of a candidate that has one [-]."""
    assert candidate.multiplier is not None
    return candidate.multiplier


def near_least(pool: Sequence[Candidate]) -> list[Candidate]:
    """Return the candidates whose multiplier is near the least."""
    least = min(map(worth, pool))
    return [each for each in pool if worth(each) <= NEAR * max(least, 0.0) or worth(each) == least]


def weakest_of(near: Sequence[Candidate]) -> Candidate:
    """Return the candidate of least d0*; ties go to the least multiplier, then to the nearest to +x, then +y."""
    return min(near, key=lambda each: (figures(inf if each.displacement is None else each.displacement), *rank(each)))


def rank(candidate: Candidate) -> tuple[float, float, float]:
    """Return what candidates are sorted by: the multiplier, then nearness to +x, then to +y."""
    x, y, _ = candidate.way
    return figures(worth(candidate)), -round(x, DIGITS), -round(y, DIGITS)


def figures(value: float) -> float:
    """Round to so many figures that equals stay equal."""
    return float(f"{value:.{DIGITS}g}")
