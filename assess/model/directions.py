"""The direction of a mechanism: as given, the weakest of a few candidates, or the weakest all around ("sweep").

Candidates are what the edges of the base face in plan, and the opposites: there the multiplier of a block is least. Of
a wall held at base and top they are the two ways across its thickness. The least uplift multiplier, with all loads and
the crack in place, is the first filter; of the candidates near it the one of least d0* stays. Bodies beside the
mechanism (return walls, a building behind, a buttress) stop its motion towards them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from math import inf, tan
from typing import Any, TypeVar

import numpy as np

from assess.errors import AssessError, FallingError, MechanismError, ProjectError
from assess.geometry.contact import CONTACT_TOLERANCE, FacePatches, facing_patches
from assess.geometry.cut import Piece, divide
from assess.geometry.planar import (
    base_of_section,
    hull_edge_normals,
    join_bodies,
    lowest_corners,
    planar_body_without_outline,
)
from assess.geometry.solid import Solid
from assess.loads.body_loads import BlockContact, Surroundings, find_block_contact
from assess.loads.load import BodyLoad, bodies_of, point_in_plane
from assess.mechanisms.assembly import ASKEW, LEVEL_RISE, hinge_beside
from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import Chain, uplift_multiplier
from assess.mechanisms.directions import DirectionCandidate, DirectionSweep, direction_angle, direction_at
from assess.mechanisms.kinds import MECHANISM_KINDS, Definition
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, CutPlane, Mechanism, Vector
from assess.mechanisms.oscillators import collapse_branch
from assess.mechanisms.restitution import Restitution
from assess.mechanisms.wedged_block import Corner
from assess.messages.message import Message, Quantity, Severity, Term, Value, format_key, message, warning
from assess.model.assembly import Built, mechanism_of, on_rigid_hinges
from assess.model.bodies import Bodies, cut_of, solids_of_block
from assess.model.loading import loads_of
from assess.model.wedges import outward_directions
from assess.oscillator import displacement, multiplier
from spectra.arrays import FloatArray


def mechanism_in_direction(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism of a definition, in its weakest direction if none is given.

    Parameters
    ----------
    name : of the mechanism
    definition : the mechanism as stated
    bodies : of the building, by name

    Returns
    -------
    The mechanism with its candidate directions and messages, and its bodies in space

    Raises
    ------
    ProjectError : the direction must be given; the text lists the candidates
    MechanismError or GeometryError : it cannot rock as described, or a hinge is stated beside its contact
    """
    try:
        built = _built_in_direction(name, definition, bodies)
    except FallingError as error:
        if error.beside:
            raise MechanismError(f'mechanism "{name}": {error.beside}') from None
        raise
    if beside := hinge_beside(built.mechanism.warnings):
        raise MechanismError(f'mechanism "{name}": {beside}')
    return built


def _built_in_direction(name: str, definition: Definition, bodies: Bodies) -> Built:
    if isinstance(definition, Corner) and definition.direction is None:
        return mechanism_of(name, _corner_towards_weakest(name, definition, bodies), bodies)
    if (
        not isinstance(definition, BlockMechanism)
        or not MECHANISM_KINDS[definition.kind].direction_sought
        or definition.direction == "sweep"
        or not _has_geometry(definition, bodies)
    ):
        return mechanism_as_given(name, definition, bodies)
    search = _prepare_search(name, definition, bodies)
    if definition.direction is None:
        return build_in_weakest_direction(search)
    return _build_in_given_direction(search)


def _corner_towards_weakest(name: str, definition: Corner, bodies: Bodies) -> Corner:
    """Return a corner in the weakest of the directions between the outward ones of its walls."""

    def multiplier_of(towards: Corner) -> float:
        try:
            return uplift_multiplier(on_rigid_hinges(name, towards, bodies)[0].positive)
        except FallingError as error:
            return -inf if error.multiplier is None else error.multiplier

    ways = outward_directions(name, definition, bodies)
    return min((_turn_towards(definition, way) for way in ways), key=multiplier_of)


def mechanism_as_given(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism without comparing candidates; a body without geometry has one plane only, taken as +x.

    Parameters
    ----------
    name : of the mechanism
    definition : the mechanism as stated, with its direction and sides
    bodies : of the building, by name
    """
    if isinstance(definition, BlockMechanism) and definition.direction == "sweep":
        return _sweep_directions(name, definition, bodies)
    return mechanism_of(name, definition, bodies)


def build_in_weakest_direction(search: DirectionSearch) -> Built:
    """Build the mechanism in its weakest direction; raise ProjectError with the candidates if it must be given."""
    evaluated = [_evaluate_candidate(angle, search) for angle in search.angles]
    candidates = tuple(candidate for candidate, _ in evaluated)
    known = [each for each in candidates if each.uplift_multiplier is not None]
    if not known:  # nor can it be built towards any: say why
        return mechanism_of(search.name, _turn_towards(search.definition, candidates[0].direction), search.bodies)
    reason = next(_reasons_for_given_direction(search.definition), "")
    if reason:
        raise ProjectError(f"{search.where}.direction: missing; {reason}; the candidates are {_list_directions(known)}")
    pool, blocked = _free_candidates(known)
    found = _weakest_of([_with_displacement(each, search) for each in _near_least(pool)])
    candidates = tuple(found if each.angle_deg == found.angle_deg else each for each in candidates)
    behind = () if blocked else _bodies_that_stop(search.obstacles, _opposite_direction(found.direction))
    definition = _with_sides(_turn_towards(search.definition, found.direction), behind)
    built = mechanism_of(search.name, definition, search.bodies)
    messages = [
        *_obstacle_messages(candidates, found, blocked=blocked, where=search.where),
        *_sides_messages(behind, search),
    ]
    messages += [_left_out_warning(*each, search.where) for each in evaluated if each[1] not in ("", OTHER_SIDE)]
    return _with_messages(built, candidates, messages, search)


NEAR = 1.1  # multipliers up to this many times the least are compared by d0*
MUCH_WEAKER = 1.1  # times its multiplier is below that of the given direction: it is examined too
MUCH_STRONGER = 1.5  # of the least multiplier: a free direction so strong does not stand for a weak axis held both ways
ON_SIDE = (0.5, 1.1)  # of the half width of the base: a given hinge is on the side towards which it is as far out
OTHER_SIDE = "the hinge that is given lies on another side"
DIGITS = 6  # candidates that agree to so many are as weak
KeyPath = tuple[str | int, ...]
Towards = Callable[[Vector], Mechanism]


@dataclass(frozen=True)
class DirectionSearch:
    """A mechanism whose directions are compared.

    definition : as stated; foot : corners [k, 3] of what it stands on [m]; corners : of all of it [k, 3] [m]
    obstacles : the bodies beside it
    angles : of the candidates [deg]
    mechanism_towards : the mechanism towards a direction, of one side and on rigid hinges
    """

    name: str
    definition: BlockMechanism
    bodies: Bodies
    foot: FloatArray
    corners: FloatArray
    obstacles: tuple[Obstacle, ...]
    angles: tuple[float, ...]
    mechanism_towards: Towards

    @property
    def where(self) -> str:
        """The table, as messages name it."""
        return f"mechanisms.{self.name}"


@dataclass(frozen=True)
class StandingBlock:
    """A block above its cut, before a direction is chosen.

    solids : what it is made of; foot : corners it stands on [k, 3] [m]; fixed : what lies below the cut and stays
    """

    solids: tuple[Solid, ...]
    foot: FloatArray
    fixed: tuple[Solid, ...] = ()


FOOT = 0.1  # of the height of the masonry: what touches it lower, as a pavement does, does not stop it
AHEAD = 0.7  # cosine between a touched face and the motion that the contact stops: within 45 degrees
SMALLEST = 0.01  # m2: less contact is a slip of drawing


@dataclass(frozen=True)
class Obstacle:
    """A body that touches the part of a mechanism above its hinge, and the faces of that part which it touches."""

    body: str
    faces: FacePatches

    def stops(self, direction: Vector) -> bool:
        """Return whether it stops a motion towards `direction`, a horizontal unit vector."""
        ahead = self.faces.normal @ np.array(direction) > AHEAD
        return float(self.faces.area[ahead].sum()) > SMALLEST


CLEARLY = 0.95  # of a given direction's multiplier: a candidate below it is clearly weaker
LISTED = 4


def _has_geometry(definition: BlockMechanism, bodies: Bodies) -> bool:
    """Return whether all bodies of a mechanism have geometry."""
    return all(bodies[body].solid is not None for body in definition.bodies)


def _with_sides(definition: BlocksT, behind: Sequence[str]) -> BlocksT:
    """Return the definition with its sides: those given, else one if bodies stand behind."""
    return replace(definition, sides=definition.sides or ("one" if behind else "two"))


def _reasons_for_given_direction(definition: BlockMechanism) -> Iterator[str]:
    """Say why the direction cannot be found for the user."""
    if definition.sides == "one":
        yield 'with sides = "one" it says which way the mechanism is free'
    for key in definition.keys_along():
        yield f"{format_key(key)} is measured along it"


def _list_directions(known: Sequence[DirectionCandidate]) -> str:
    """List directions with their multipliers, the weakest first."""
    rising = sorted(known, key=_rank_key)
    texts = [
        f"{_vector_text(each.direction)} with a multiplier of {each.uplift_multiplier:.4g}" for each in rising[:LISTED]
    ]
    return ", ".join(texts) + (f" and {len(rising) - LISTED} stronger" if len(rising) > LISTED else "")


def _opposite_direction(direction: Vector) -> Vector:
    """Return the opposite direction."""
    return (-direction[0], -direction[1], 0.0)


def _build_in_given_direction(search: DirectionSearch) -> Built:
    """Build the mechanism in the given direction, with a warning if another is clearly weaker."""
    ahead = direction_at(direction_angle(search.definition.towards))
    into = _bodies_that_stop(search.obstacles, ahead)
    behind = () if into else _bodies_that_stop(search.obstacles, _opposite_direction(ahead))
    built = mechanism_of(search.name, _with_sides(search.definition, behind), search.bodies)
    messages = [*_direction_warnings(into, ahead, search), *_sides_messages(behind, search)]
    keys_along = tuple(search.definition.keys_along())
    if search.definition.hinges is not None or any(key[0] != "loads" for key in keys_along):
        return _with_messages(built, (), messages, search)
    if keys_along:  # loads in the plane of motion turn with it: the wall without them says which way it is weak
        return _with_weaker_direction_of_bare_wall(built, ahead, keys_along, messages, search)
    candidates = tuple(_evaluate_candidate(angle, search)[0] for angle in search.angles)
    weakest = _weakest_unobstructed(candidates, search, one_sided=built.mechanism.sides == "one")
    own = min(map(uplift_multiplier, built.mechanism.chains))
    if weakest is not None and _multiplier_of(weakest) < CLEARLY * own:
        messages.append(_weaker_direction_warning(built.mechanism, weakest, search))
        if MUCH_WEAKER * _multiplier_of(weakest) < own:
            crack = _crack_towards(search.definition, weakest.direction, search.corners)
            begins = crack.point if isinstance(crack, CutAngle) else None
            built = replace(built, mechanism=replace(built.mechanism, weaker=weakest.direction, weaker_crack=begins))
    return _with_messages(built, candidates, messages, search)


def _with_weaker_direction_of_bare_wall(
    built: Built, ahead: Vector, keys_along: Sequence[KeyPath], messages: Sequence[Message], search: DirectionSearch
) -> Built:
    """Return the mechanism with the direction in which it is clearly weaker without the loads in its plane."""
    flat = {key[1] for key in keys_along}
    loads = tuple(load for place, load in enumerate(search.definition.loads) if place not in flat)
    try:
        bare = _prepare_search(search.name, replace(search.definition, loads=loads), search.bodies)
        both = (ahead, _opposite_direction(ahead)) if built.mechanism.sides == "two" else (ahead,)
        own = min(uplift_multiplier(bare.mechanism_towards(each).positive) for each in both)
        candidates = tuple(_evaluate_candidate(angle, bare)[0] for angle in bare.angles)
    except AssessError:  # it does not stand, or does not crack, without them
        return _with_messages(built, (), messages, search)
    weakest = _weakest_unobstructed(candidates, bare, one_sided=built.mechanism.sides == "one")
    if weakest is not None and MUCH_WEAKER * _multiplier_of(weakest) < own:
        built = replace(built, mechanism=replace(built.mechanism, weaker=weakest.direction))
    return _with_messages(built, (), messages, search)


def _direction_warnings(into: Sequence[str], ahead: Vector, search: DirectionSearch) -> Iterator[Message]:
    """Warn that the given direction leads into a body."""
    if into:
        values = {"direction": _vector_text(ahead), "bodies": ", ".join(into)}
        yield message("direction-into", values, severity=Severity.WARNING, where=search.where)


def _weakest_unobstructed(
    candidates: Sequence[DirectionCandidate], search: DirectionSearch, *, one_sided: bool
) -> DirectionCandidate | None:
    """Return the weakest candidate that nothing stops, of a one-sided mechanism among those ahead; None if none is."""
    ahead = np.array(direction_at(direction_angle(search.definition.towards)))
    unobstructed = [each for each in candidates if each.uplift_multiplier is not None and not each.touching]
    if one_sided:  # what stops it stands behind
        unobstructed = [each for each in unobstructed if np.array(each.direction) @ ahead > -AHEAD]
    if not unobstructed:
        return None
    return _weakest_of([_with_displacement(each, search) for each in _near_least(unobstructed)])


def _weaker_direction_warning(given: Mechanism, weak: DirectionCandidate, search: DirectionSearch) -> Message:
    """Return the warning that another direction is clearly weaker than the given one."""
    own = min(given.chains, key=uplift_multiplier)
    values: dict[str, Value] = {
        "direction": _vector_text(weak.direction),
        "weaker": Quantity(_multiplier_of(weak)),
        "weaker_d0": _length_text(weak.d0_m),
        "given": Quantity(uplift_multiplier(own)),
        "given_d0": _length_text(_displacement_of(own, name=search.name)),
    }
    return message("direction-weaker", values, severity=Severity.WARNING, where=search.where)


def _length_text(length: float | None) -> Value:
    """Return a displacement [m] as a value of a message."""
    return Term("none, as it never overturns,") if length is None else Quantity(length, "length")


def _obstacle_messages(
    candidates: Sequence[DirectionCandidate], found: DirectionCandidate, *, blocked: bool, where: str
) -> Iterator[Message]:
    """Tell which directions are stopped by bodies beside the mechanism."""
    for each in candidates:
        if each.uplift_multiplier is None or not each.touching:
            continue
        bodies, weaker = ", ".join(each.touching), Quantity(_multiplier_of(each))
        values: dict[str, Value] = {"direction": _vector_text(each.direction), "bodies": bodies, "weaker": weaker}
        if not blocked:
            yield message("direction-stopped", values, where=where)
        elif each.angle_deg == found.angle_deg:
            yield message("direction-held", values, severity=Severity.WARNING, where=where)


def _sides_messages(behind: Sequence[str], search: DirectionSearch) -> Iterator[Message]:
    """Tell that it rocks to one side because of what stands behind it."""
    if behind and search.definition.sides is None:
        yield message("sides-by-contact", {"bodies": ", ".join(behind)}, where=search.where)


def _left_out_warning(candidate: DirectionCandidate, why: str, where: str) -> Message:
    """Say why a direction was left out."""
    values = {"direction": _vector_text(candidate.direction), "why": why}
    return message("direction-left-out", values, severity=Severity.WARNING, where=where)


def _with_messages(
    built: Built, candidates: Sequence[DirectionCandidate], messages: Sequence[Message], search: DirectionSearch
) -> Built:
    """Return the mechanism with its candidates, the bodies beside it and the messages on them."""
    beside = tuple(obstacle.body for obstacle in search.obstacles)
    found = replace(built.mechanism, candidates=tuple(candidates), adjacent_bodies=beside, messages=tuple(messages))
    return replace(built, mechanism=found)


def _prepare_search(name: str, definition: BlockMechanism, bodies: Bodies) -> DirectionSearch:
    """Find the candidate directions of a mechanism and the bodies beside it."""
    standing, bare = _solids_of_blocks(name, definition, bodies), _one_sided_definition(definition)
    corners = np.concatenate([solid.vertices for solid in standing])
    if _turns_on_base(bare):
        block = _standing_above_cut(name, bare, standing)
        standing, foot, towards = block.solids, block.foot, _block_by_direction(name, bare, block, bodies)
    else:
        foot = lowest_corners(standing)

        def towards(direction: Vector) -> Mechanism:
            turned = replace(_turn_towards(bare, direction), cut=_crack_towards(bare, direction, corners))
            return on_rigid_hinges(name, turned, bodies)[0]

    angles = _candidate_angles(definition, foot, corners)
    obstacles = _obstacles_of(definition, standing, bodies)
    return DirectionSearch(name, definition, bodies, foot, corners, obstacles, angles, cache(towards))


def _candidate_angles(definition: BlockMechanism, foot: FloatArray, corners: FloatArray) -> tuple[float, ...]:
    """Return the angles [deg] of the candidates, rising, from the corners of the base and of the whole mechanism."""
    plan = hull_edge_normals(corners)
    if _is_held_at_top(definition):
        normals = _thinnest_normal(corners[:, :2], plan)
    else:
        normals = plan if isinstance(definition.cut, CutAngle) else _edge_normals_and_beside(foot)
    normals = normals if normals.size else plan
    return tuple(np.unique(np.round(np.concatenate([normals, normals + 180.0]), 9) % 360.0).tolist())


def _one_sided_definition(definition: BlocksT) -> BlocksT:
    """Return the definition for one side, without what depends on the impacts or is measured along the direction."""
    changes: dict[str, Any] = {"sides": "one", "restitution": Restitution(positive=0.0, negative=0.0)}
    if definition.direction is None:
        keys = set(definition.keys_along())
        flat = {key[1] for key in keys if key[0] == "loads"}
        changes["loads"] = tuple(load for place, load in enumerate(definition.loads) if place not in flat)
        if any(key[0] == "hinges" for key in keys):
            changes["hinges"] = None
    return replace(definition, **{**changes, "hinges_negative": None})


def _thinnest_normal(plan: FloatArray, normals: FloatArray) -> FloatArray:
    """Return the normal [deg] among [k] along which a plan [n, 2] is thinnest, the first of equals."""
    at = np.radians(normals)
    width = np.ptp(plan @ np.array([np.cos(at), np.sin(at)]), axis=0)
    return normals[[int(np.argmin(np.round(width / width.max(), DIGITS)))]]


def _evaluate_candidate(angle: float, search: DirectionSearch) -> tuple[DirectionCandidate, str]:
    """Return a candidate with its multiplier and what touches it there, and why it cannot rock that way, "" if it can.

    Raises FallingError if it already falls and no direction is given.
    """
    direction = direction_at(angle)
    candidate = DirectionCandidate(angle, None, None, _bodies_that_stop(search.obstacles, direction))
    if not _hinge_on_side(search, direction):
        return candidate, OTHER_SIDE
    try:
        multiplier_there = uplift_multiplier(search.mechanism_towards(direction).positive)
    except FallingError as error:
        if search.definition.direction is None and not candidate.touching:
            raise FallingError(
                f"{error} (towards {_vector_text(direction)}, looked at as `direction` is absent)",
                error.multiplier,
                beside=error.beside,
            ) from None
        return candidate, str(error)
    except AssessError as error:
        return candidate, str(error)
    return replace(candidate, uplift_multiplier=multiplier_there), ""


def _hinge_on_side(search: DirectionSearch, direction: Vector) -> bool:
    """Return whether a hinge given in space lies on the side of the base towards `direction`; true if none is given."""
    hinges = search.definition.hinge_points
    if hinges is None or len(hinges[0]) == 2:
        return True
    reach = search.foot @ np.array(direction)
    low, high = float(reach.min()), float(reach.max())
    out = (point_in_plane(hinges[0], direction)[0] - (low + high) / 2.0) / ((high - low) / 2.0)
    return ON_SIDE[0] < out < ON_SIDE[1]


def _vector_text(direction: Vector) -> str:
    """Write a direction as the project file does."""
    return "[" + ", ".join(f"{round(part, 6) + 0.0:g}" for part in direction) + "]"


def _with_displacement(candidate: DirectionCandidate, search: DirectionSearch) -> DirectionCandidate:
    """Return the candidate with d0* of its control point."""
    return replace(
        candidate,
        d0_m=_displacement_of(search.mechanism_towards(candidate.direction).positive, name=search.name),
    )


def _displacement_of(chain: Chain, *, name: str) -> float | None:
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


def _free_candidates(known: Sequence[DirectionCandidate]) -> tuple[list[DirectionCandidate], bool]:
    """Return the candidates that nothing stops; all of them, and True, if bodies hold the weak axis both ways.

    What holds a wall on both faces, as a floor and a buttress may, does not make its own plane its weak direction.
    """
    free = [each for each in known if not each.touching]
    least = min(known, key=_rank_key)
    back = [each for each in known if abs((each.angle_deg - least.angle_deg) % 360.0 - 180.0) < 1e-6]
    both = bool(least.touching) and all(each.touching for each in back)
    if not free or (both and _multiplier_of(min(free, key=_rank_key)) > MUCH_STRONGER * _multiplier_of(least)):
        return list(known), True
    return free, False


def _multiplier_of(candidate: DirectionCandidate) -> float:
    """Return the multiplier of a candidate that has one [-]."""
    assert candidate.uplift_multiplier is not None
    return candidate.uplift_multiplier


def _near_least(pool: Sequence[DirectionCandidate]) -> list[DirectionCandidate]:
    """Return the candidates whose multiplier is near the least."""
    least = min(map(_multiplier_of, pool))
    return [each for each in pool if _multiplier_of(each) <= NEAR * max(least, 0.0) or _multiplier_of(each) == least]


def _weakest_of(near: Sequence[DirectionCandidate]) -> DirectionCandidate:
    """Return the candidate of least d0*; ties go to the least multiplier, then to the nearest to +x, then +y."""
    return min(near, key=lambda each: (_round_rank(inf if each.d0_m is None else each.d0_m), *_rank_key(each)))


def _rank_key(candidate: DirectionCandidate) -> tuple[float, float, float]:
    """Return what candidates are sorted by: the multiplier, then nearness to +x, then to +y."""
    x, y, _ = candidate.direction
    return _round_rank(_multiplier_of(candidate)), -round(x, DIGITS), -round(y, DIGITS)


def _round_rank(value: float) -> float:
    """Round to so many figures that equals stay equal."""
    return float(f"{value:.{DIGITS}g}")


BlocksT = TypeVar("BlocksT", bound=BlockMechanism)
STEP = 5.0  # deg between directions, besides those that the edges of the base face
BESIDE = 0.01  # deg: of the normal of an edge that rises
SAME = 1e-6  # deg: directions this near are one
TIE = 1e-9  # multipliers this near the least are as weak
NEARLY_WEAKEST = 1.01  # multipliers up to this many times the least are nearly as weak
STEPS = 3600  # of the circle on which they are counted


def _sweep_directions(name: str, definition: BlockMechanism, bodies: Bodies) -> Built:
    """Build the mechanism in the weakest of directions all around."""
    standing = _solids_of_blocks(name, definition, bodies)
    corner: tuple[Message, ...] = ()
    if _turns_on_base(definition):
        block = _standing_above_cut(name, definition, standing)
        found = _resistance_by_direction(
            _block_by_direction(name, definition, block, bodies), _swept_angles(_edge_normals_and_beside(block.foot))
        )
        corner = (warning("turns-about-corner"),) if _has_slope(block.foot) else ()
    else:  # the crack turns with the direction, and with it the blocks
        plan = np.concatenate([solid.vertices for solid in standing])
        found = _resistance_by_direction(
            lambda direction: mechanism_of(name, _turn_towards(definition, direction), bodies).mechanism,
            _swept_angles(hull_edge_normals(plan)),
        )
    built = mechanism_of(name, _turn_towards(definition, direction_at(found.weakest_deg)), bodies)
    kept = (each for each in built.mechanism.warnings if each.key != ASKEW)  # every direction has been looked at
    return replace(built, mechanism=replace(built.mechanism, directions=found, warnings=(*kept, *corner)))


def _solids_of_blocks(name: str, definition: BlockMechanism, bodies: Bodies) -> tuple[Solid, ...]:
    """Return the solids of all blocks; raise MechanismError for a body without geometry, which has one plane only."""
    for body in definition.bodies:
        if bodies[body].solid is None:
            raise MechanismError(
                f'mechanism "{name}": direction = "sweep": body "{body}" has no geometry; give it a mesh, box or '
                "profile, or give the direction"
            )
    return tuple(solid for block in definition.blocks for solid in solids_of_block(block, bodies))


def _swept_angles(normals: FloatArray) -> tuple[float, ...]:
    """Return the directions [deg] to evaluate: even steps, and the normals [k] of the edges of the base.

    Where the multiplier of a block has a minimum, the hinge passes from one corner to the next: over an edge, or
    in every direction of a round base.
    """
    even = np.arange(0.0, 360.0, STEP)
    apart = np.abs((normals[:, None] - even[None, :] + 180.0) % 360.0 - 180.0).min(axis=1, initial=360.0) > SAME
    return tuple(np.sort(np.concatenate([even, normals[apart]])).tolist())


def _has_slope(foot: FloatArray) -> bool:
    """Return whether the corners [k, 3] of a base lie at different elevations."""
    return float(np.ptp(foot[:, 2])) > LEVEL_RISE


def _edge_normals_and_beside(foot: FloatArray) -> FloatArray:
    """Return the normals of the edges between corners [k, 3] [deg]; on a slope also just beside.

    There the lower end has the larger height to the centroid over it, and so the least multiplier.
    """
    normals = hull_edge_normals(foot)
    beside = [normals + turn for turn in (-BESIDE, 0.0, BESIDE)]
    return np.unique(np.concatenate(beside) % 360.0) if _has_slope(foot) else normals


def _turns_on_base(definition: BlockMechanism) -> bool:
    """Return whether a mechanism turns at the edges of one base or cut, whatever its direction."""
    return MECHANISM_KINDS[definition.kind].turns_on_base and not isinstance(definition.cut, CutAngle)


def _is_held_at_top(definition: BlockMechanism) -> bool:
    """Return whether a mechanism spans between supports."""
    return MECHANISM_KINDS[definition.kind].support == "spanning"


def _standing_above_cut(name: str, definition: BlockMechanism, solids: tuple[Solid, ...]) -> StandingBlock:
    """Return the block above its cut, which is the same in every direction."""
    plane = cut_of(definition, where=f'mechanism "{name}": cut')
    if plane is None:
        return StandingBlock(solids, lowest_corners(solids))
    parts = divide(solids, plane, where=f'mechanism "{name}": cut')
    return StandingBlock(parts.above, parts.foot, parts.below)


def _block_by_direction(
    name: str, definition: BlockMechanism, standing: StandingBlock, bodies: Bodies
) -> Callable[[Vector], Mechanism]:
    """Return a function of the direction that builds a block; it is cut once and its loads are found once."""
    build = MECHANISM_KINDS[definition.kind].build
    known: dict[str, BlockContact] = {}

    def find(load: BodyLoad, body: Solid | None, around: Surroundings) -> BlockContact:
        if load.body not in known:
            known[load.body] = find_block_contact(load, body, around)
        return known[load.body]

    def block(direction: Vector) -> Mechanism:
        body = join_bodies([planar_body_without_outline(solid, direction=direction) for solid in standing.solids])
        body = replace(body, base=base_of_section(standing.foot, direction=direction))
        pieces = [Piece(body, standing.solids, None, fixed=standing.fixed)]
        faced = _turn_towards(definition, direction)
        load_set = loads_of(name, faced, pieces, bodies, find=find)
        return build(name, faced, pieces, loads=load_set.loads)[0]

    return block


def _turn_towards(definition: BlocksT, direction: Vector) -> BlocksT:
    """Return the definition with a direction."""
    return replace(definition, direction=direction)


def _crack_towards(
    definition: BlockMechanism, direction: Vector, corners: FloatArray
) -> float | CutPlane | CutAngle | None:
    """Return the cut of a mechanism turned to another direction: an inclined crack begins at its height there too.

    Left where it is in space, a crack that meets the edge of a spire in one direction would leave through its foot in
    another.

    Parameters
    ----------
    definition : with the direction that the cut was stated for; without one it is left as it is
    direction : to turn to
    corners : of what may break off [k, 3] [m]
    """
    cut = definition.cut
    if not isinstance(cut, CutAngle) or not isinstance(definition.direction, tuple):
        return cut
    along = definition.along
    ahead = float((corners @ along).max() - np.array(cut.point) @ along)
    x, y, _ = edge_towards(direction, corners)
    return replace(cut, point=(x, y, cut.point[2] - tan(cut.angle) * ahead))


def edge_towards(direction: Vector, corners: FloatArray) -> Vector:
    """Return the point (x, y, mean z) ahead of the mean of corners [k, 3], as far out as they reach [m]."""
    middle, along = corners.mean(axis=0), np.array(direction)
    x, y, z = middle + along * float(((corners - middle) @ along).max())
    return float(x), float(y), float(z)


def _resistance_by_direction(
    mechanism_towards: Callable[[Vector], Mechanism], around: Sequence[float]
) -> DirectionSweep:
    """Find the resistance to positive rotation towards each of the angles `around` [n] [deg], rising.

    The smallest angle of the least multiplier is the weakest; opposite angles are the two signs of one plane.

    Raises
    ------
    AssessError : towards one of them it cannot rock as described; the angle is named
    """
    rows = []
    for angle in around:
        try:
            mechanism = mechanism_towards(direction_at(angle))
            leading = rigid_branch(mechanism.positive, restitution=mechanism.restitution[0], name=mechanism.name)
        except AssessError as error:
            raise type(error)(f'{error} (direction = "sweep", here {angle:.6g} deg from +x)') from None
        rows.append((float(multiplier(leading)[0]), leading.linearised.p, leading.overturning))
    multipliers, p, overturning = zip(*rows, strict=True)
    weakest = next(a for a, value in zip(around, multipliers, strict=True) if value <= min(multipliers) + TIE)
    return DirectionSweep(
        angle_deg=tuple(around),
        uplift_multiplier=multipliers,
        p_eq_per_s=p,
        overturning_rad=overturning,
        weakest_deg=weakest,
        variation=1.0 - min(multipliers) / max(multipliers),
        flat_deg=_flat_range(around, multipliers),
    )


def _flat_range(around: Sequence[float], multipliers: Sequence[float]) -> float:
    """Return the range of angles within one percent of the least multiplier, interpolated linearly [deg]."""
    circle = np.arange(STEPS) * (360.0 / STEPS)
    between = np.interp(circle, around, multipliers, period=360.0)
    return float(np.count_nonzero(between <= NEARLY_WEAKEST * min(multipliers)) * (360.0 / STEPS))


def _obstacles_of(definition: BlockMechanism, standing: Sequence[Solid], bodies: Bodies) -> tuple[Obstacle, ...]:
    """Find the bodies that touch what moves (`standing`), other than those of the mechanism and its loads."""
    low = min(float(solid.vertices[:, 2].min()) for solid in standing)
    high = max(float(solid.vertices[:, 2].max()) for solid in standing)
    foot = low + FOOT * (high - low)
    head = high - FOOT * (high - low) if _is_held_at_top(definition) else np.inf  # held there by what touches
    own = set(definition.bodies)
    own |= {body for load in definition.loads for body in bodies_of(load)}
    others = [each.solid for name, each in bodies.items() if each.solid is not None and name not in own]
    found = (
        (other, _touched_faces(standing, other, foot=foot, head=head))
        for other in others
        if _box_reaches(standing, other)
    )
    return tuple(Obstacle(other.name, faces) for other, faces in found if float(faces.area.sum()) > SMALLEST)


def _bodies_that_stop(obstacles: Sequence[Obstacle], direction: Vector) -> tuple[str, ...]:
    """Return the bodies that stop a motion towards `direction`."""
    return tuple(obstacle.body for obstacle in obstacles if obstacle.stops(direction))


def _box_reaches(standing: Sequence[Solid], other: Solid) -> bool:
    """Whether the bounding box of a body reaches one of those that move."""
    low, high = other.vertices.min(axis=0) - CONTACT_TOLERANCE, other.vertices.max(axis=0) + CONTACT_TOLERANCE
    return any(
        bool(np.all((solid.vertices.max(axis=0) >= low) & (solid.vertices.min(axis=0) <= high))) for solid in standing
    )


def _touched_faces(standing: Sequence[Solid], other: Solid, *, foot: float, head: float) -> FacePatches:
    """Return the upright faces of what moves that a body touches between two elevations [m].

    A body drawn in the same place, in another state or simply put at the origin too, is not beside it.
    """
    met = [facing_patches(solid, other) for solid in standing]
    area, centroid, normal, distance = (
        np.concatenate([getattr(each, key) for each in met]) for key in ("area", "centroid", "normal", "distance")
    )
    kept = (centroid[:, 2] > foot) & (centroid[:, 2] < head)
    return FacePatches(area[kept], centroid[kept], normal[kept], distance[kept])
