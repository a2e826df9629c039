"""The least static multiplier of a mechanism of a building over its free parameters, on the exact cut.

A stack of parts is cut where it may crack, and turns by the sums of virtual work of any mechanism. What is found is
built once more as a project would, so that a project with this mechanism finds the same multiplier.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from math import atan2, cos, inf, pi, radians, sin, tan
from typing import Literal

import numpy as np
import shapely

from assess.errors import AssessError, FallingError
from assess.geometry.boolean import shortest_distance
from assess.geometry.contact import CONTACT_TOLERANCE, ContactArea
from assess.geometry.cut import Plane, divide, inclined_plane, level_plane
from assess.geometry.planar import base_of_section, lowest_corners, top_edge
from assess.geometry.solid import Solid
from assess.loads.bearing import shares
from assess.loads.load import BodyLoad, Force, OverburdenLoad, PointMass, bodies_of
from assess.mechanisms.arch_in_plan import HorizontalArch
from assess.mechanisms.chain import Chain, uplift_multiplier
from assess.mechanisms.four_hinge import FourHinge, RadialJoints
from assess.mechanisms.least import Least, find_least
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, Vector
from assess.mechanisms.partial_walls import STEEPEST, CornerLoad, SideWall, corner
from assess.mechanisms.single_block import SingleBlock
from assess.mechanisms.two_block import TwoBlock
from assess.mechanisms.wedged_block import Corner, FacadeWithWedges, Wedge, WedgedBlock
from assess.messages.message import Quantity
from assess.model.assembly import on_rigid_hinges
from assess.model.bodies import Bodies, Body, Material, pieces_of
from assess.model.covering_paths import NO_SHARE, LoadPath, load_paths
from assess.model.directions import edge_towards
from assess.model.loading import loads_of
from assess.model.structure import Part, PartContact, Structure
from assess.model.turning import NEAR_LEVEL, TurningStack

LOWEST = 0.15  # of the height of what stands above a level: the least that breaks off
STEEP = radians(75.0)  # of a crack through a tower, from the horizontal: the steepest that is published
AS_WEAK = 1e-3  # relative: a direction no weaker than this below another is as weak
VOUSSOIRS = 16  # of an arch whose joints are not drawn
AT_SPRINGING = radians(0.5)  # by which its first and last joints lie inside it
NAME = "found"  # of a mechanism while its multiplier is looked for
Parameters = Mapping[str, Quantity]


@dataclass(frozen=True)
class Alternative:
    """Another way in which the same parts can fail: its multiplier [-], direction and parameters."""

    multiplier: float
    direction: Vector
    parameters: Parameters


@dataclass(frozen=True)
class Found:
    """The least multiplier of a mechanism.

    multiplier : [-]; not above 0 where it falls as drawn; None where it cannot be built, and why
    direction : in which it falls
    parameters : at the least, by their names
    definition : as a project file states it; None where it states no such mechanism
    others : the runners-up, the weakest first
    evaluations : multipliers that the search took
    why_not : why there is no multiplier; empty where there is one
    tied : roofs and vaults that would push it over as it stands, so that something takes their thrust
    """

    multiplier: float | None
    direction: Vector
    parameters: Parameters = field(default_factory=dict)
    definition: BlockMechanism | None = None
    others: tuple[Alternative, ...] = ()
    evaluations: int = 0
    why_not: str = ""
    tied: tuple[str, ...] = ()


@dataclass(frozen=True)
class Drawing:
    """A structure as mechanisms see it: its parts as bodies.

    thrusts_taken : of each wall, the roofs and vaults that would push it over as it stands: something takes their
        thrust, in every mechanism of that wall
    """

    structure: Structure
    thrusts_taken: Mapping[str, frozenset[str]] = field(default_factory=dict)

    @cached_property
    def bodies(self) -> Bodies:
        """The parts as bodies, by name."""
        return {
            part.name: Body(
                name=part.name,
                solid=part.solid if part.solid.name == part.name else replace(part.solid, name=part.name),
                material=Material(name=part.material or "masonry", density=part.density),
            )
            for part in self.structure.parts
        }

    @cached_property
    def paths(self) -> Mapping[str, tuple[LoadPath, ...]]:
        """The ways in which the weight of each part that may load a wall may go down, by name."""
        return {part.name: load_paths(part, self.structure) for part in self.structure.parts}

    def loads_on(self, parts: Sequence[Part], *, above: float, tied: bool = False) -> tuple[BodyLoad, ...]:
        """Return the coverings that bear on parts above an elevation, as loads; tied: roofs and vaults do not push.

        One that is drawn some way off its wall bears on it all the same. One that by statics rests on others, and may
        come down here, has the largest share that it may have.
        """
        names = {part.name for part in parts}
        found: dict[str, BodyLoad] = {}
        for part in parts:
            for contact in self.structure.contacts_of(part.name):
                covering = self.structure.part(contact.first)
                if contact.relation != "bears-on" or contact.first in names or contact.elevation <= above + NEAR_LEVEL:
                    continue
                paths = self.paths[covering.name]
                on_parts = [path.on(dict.fromkeys(names, 1.0)) for path in paths]
                if max(path.shares.get(part.name, 0.0) for path in paths) < NO_SHARE:
                    continue  # it rests on the others
                off = shortest_distance(part.solid, covering.solid)
                near = CONTACT_TOLERANCE if off < CONTACT_TOLERANCE else round(off + CONTACT_TOLERANCE, 3)
                near = max(near, found[covering.name].tolerance) if covering.name in found else near
                role: Role = THRUSTING.get(covering.kind, "floor")
                taken = tied or any(covering.name in self.thrusts_taken.get(name, ()) for name in names)
                held = True if taken and role != "floor" else None
                share = None if on_parts[0] >= NO_SHARE else round(max(on_parts), 3)
                found[covering.name] = BodyLoad(body=covering.name, role=role, tolerance=near, tied=held, share=share)
        return tuple(found.values())

    def around(self, definition: BlockMechanism) -> Bodies:
        """Return the bodies of a mechanism, those that load it, and what else carries these."""
        loads = [body for load in definition.loads for body in bodies_of(load)]
        beside = [each.other(body) for body in loads for each in self.structure.contacts_of(body)]
        return {
            name: self.bodies[name]
            for name in dict.fromkeys((*definition.bodies, *definition.neighbours, *loads, *beside))
        }

    def bearing_elevations(self, part: Part) -> tuple[float, ...]:
        """Return the elevations at which coverings bear on a part, rising [m]."""
        contacts = [each for each in self.structure.contacts_of(part.name) if each.relation == "bears-on"]
        return distinct_levels([each.elevation for each in contacts if each.second == part.name])

    def stopped_by(self, parts: Sequence[Part], direction: Vector, *, above: float) -> tuple[str, ...]:
        """Return the parts that stop a motion of `parts` above an elevation towards a direction."""
        names, found = {part.name for part in parts}, []
        for part in parts:
            for contact in self.structure.contacts_of(part.name):
                other = contact.other(part.name)
                if contact.relation not in ("leans-on", "bonded-to") or other in names or contact.elevation < above:
                    continue
                outwards = np.array(contact.normal) * (1.0 if contact.second == part.name else -1.0)
                if float(outwards @ np.array(direction)) > AHEAD:
                    found.append(other)
        return tuple(dict.fromkeys(found))

    def share_of(self, contact: PartContact) -> float:
        """Return the share of a covering's weight that goes to one of its contacts, by statics; 0 if it lifts off."""
        covering = self.structure.part(contact.first)
        carried = [each for each in self.structure.contacts_of(covering.name) if each.first == covering.name]
        carried = [each for each in carried if each.relation == "bears-on"]
        r = shares([_contact_area(each) for each in carried], centroid=covering.solid.centroid)
        return max(float(r[carried.index(contact)]), 0.0)

    def weight_per_length(self, part: Part) -> tuple[float, float]:
        """Return the mass that coverings put on a wall, along it [kg/m], and its mean elevation [m]."""
        bearing = [each for each in self.structure.contacts_of(part.name) if each.relation == "bears-on"]
        borne = [
            (self.share_of(each) * self.structure.part(each.first).mass, each.elevation)
            for each in bearing
            if each.second == part.name
        ]
        mass = sum(each for each, _ in borne)
        moment = sum(each * elevation for each, elevation in borne)
        return mass / part.length, (moment / mass if mass else part.top)


Role = Literal["floor", "roof", "vault"]
THRUSTING: Mapping[str, Role] = {"roof": "roof", "vault": "vault"}
AHEAD = 0.7  # cosine: within 45 degrees of a direction
Vertical = Callable[[float], Chain]


def distinct_levels(elevations: Sequence[float]) -> tuple[float, ...]:
    """Return elevations [m], rising, each once."""
    found: list[float] = []
    for each in sorted(elevations):
        if not found or each > found[-1] + NEAR_LEVEL:
            found.append(each)
    return tuple(found)


def turning_stack(definition: SingleBlock, bodies: Bodies) -> TurningStack:
    """Return the bodies of a mechanism as they turn; raise GeometryError for a load that does not touch them."""
    pieces = pieces_of(NAME, definition, bodies)
    load_set = loads_of(NAME, definition, pieces, bodies)
    return TurningStack(pieces[0].solids, load_set.loads, definition.towards)


def weakest_turn(
    parts: Sequence[Part], direction: Vector, drawing: Drawing, *, low: float, high: float, stations: int = 4
) -> Found:
    """Find the crack, level between two elevations [m], above which parts turn at the least multiplier.

    Parts that the thrust of a roof or vault would push over stand today: something takes it, and it is left out.
    """
    found = _turn(parts, direction, drawing, low=low, high=high, stations=stations, tied=False)
    pushing = tuple(load.body for load in drawing.loads_on(parts, above=low) if load.role in THRUSTING)
    if found.multiplier is None or found.multiplier > 0.0 or not pushing:
        return found
    return replace(_turn(parts, direction, drawing, low=low, high=high, stations=stations, tied=True), tied=pushing)


def _turn(
    parts: Sequence[Part], direction: Vector, drawing: Drawing, *, low: float, high: float, stations: int, tied: bool
) -> Found:
    try:
        stack = _stack_of(parts, direction, drawing, above=low, tied=tied)
    except AssessError as error:
        return Found(None, direction, why_not=_why(error))
    base = min(part.base for part in parts)

    def multiplier(at: tuple[float, ...]) -> float:
        return _value(lambda: stack.above(None if at[0] <= base + NEAR_LEVEL else level_plane(at[0])))

    least = find_least(multiplier, bounds=((low, high),), stations=(stations,), starts=1, halvings=4)
    elevation = round(least.at[0], 3)
    moved = [part for part in parts if part.top > elevation + NEAR_LEVEL]
    definition = SingleBlock(
        blocks=(tuple(part.name for part in moved),),
        direction=direction,
        sides="one",
        cut=elevation if any(part.base < elevation - NEAR_LEVEL for part in moved) else None,
        loads=drawing.loads_on(moved, above=elevation, tied=tied),
    )
    return built(definition, drawing.around(definition), {"hinge": Quantity(elevation, "length")}, least)


def _stack_of(parts: Sequence[Part], direction: Vector, drawing: Drawing, *, above: float, tied: bool) -> TurningStack:
    """Return parts as they turn, with the loads on them above an elevation."""
    loads = drawing.loads_on(parts, above=above, tied=tied)
    whole = SingleBlock(blocks=(tuple(part.name for part in parts),), direction=direction, sides="one", loads=loads)
    return turning_stack(whole, drawing.around(whole))


def built(definition: BlockMechanism, bodies: Bodies, parameters: Parameters, least: Least | None = None) -> Found:
    """Build a mechanism as a project would and return its multiplier, the least of the ways that it rocks."""
    count = 1 if least is None else least.evaluations + 1
    found = Found(None, definition.towards, parameters, definition, evaluations=count)
    try:
        mechanism, _ = on_rigid_hinges(NAME, definition, bodies)
    except FallingError as error:
        return replace(found, multiplier=error.multiplier)
    except AssessError as error:
        return replace(found, why_not=_why(error))
    return replace(found, multiplier=min(map(uplift_multiplier, mechanism.chains)))


def weakest_wedges(
    parts: Sequence[Part],
    direction: Vector,
    drawing: Drawing,
    side_walls: Sequence[Sequence[Part]],
    *,
    elevation: float,
) -> Found:
    """Find the angle of the cracks in the side walls of the least multiplier of a wall that turns with their wedges.

    Nothing holds along the cracks, as nothing is known of the bond; at an angle of 0 the wall turns alone.

    Parameters
    ----------
    side_walls : each with what stands on it and cracks with it
    """
    turned = weakest_turn(parts, direction, drawing, low=elevation, high=elevation)
    if turned.multiplier is None:
        return replace(turned, definition=None)
    stack = _stack_of(parts, direction, drawing, above=elevation, tied=bool(turned.tied))
    alone = stack.above(level_plane(elevation) if elevation > min(p.base for p in parts) + NEAR_LEVEL else None)
    back = base_of_section(lowest_corners(stack.solids), direction=direction)[0][0]
    across = np.array(direction)
    behind = [part for group in side_walls for part in group]

    def with_wedges(at: tuple[float, ...]) -> float:
        solids = [part.solid for part in behind]
        wedges = _wedges(solids, across, back, elevation, at[0]) if at[0] > 0.0 else []
        masses = [PointMass(f"wedge {i}", *_mass_at(each, direction), True) for i, each in enumerate(wedges)]
        return _value(lambda: replace(alone, loads=(*alone.loads, *masses)))

    least = find_least(with_wedges, bounds=((0.0, STEEPEST),), stations=(4,), starts=1, halvings=3)
    steepest = Alternative(with_wedges((STEEPEST,)), direction, {"angle": Quantity(STEEPEST, "angle", 3)})
    parameters = {"hinge": Quantity(elevation, "length"), "angle": Quantity(least.at[0], "angle", 3)}
    found = Found(least.value, direction, parameters, None, (steepest,), least.evaluations, tied=turned.tied)
    if least.at[0] == 0.0:
        return found  # it turns alone
    definition = FacadeWithWedges(
        blocks=(tuple(part.name for part in (*parts, *behind)),),
        direction=direction,
        cut=elevation if any(part.base < elevation - NEAR_LEVEL for part in (*parts, *behind)) else None,
        wedges=tuple(
            Wedge(walls=tuple(part.name for part in group), angle=round(least.at[0], 6)) for group in side_walls
        ),
    )
    return _cut_exactly(definition, drawing, (*parts, *behind), found)


def _cut_exactly(definition: WedgedBlock, drawing: Drawing, parts: Sequence[Part], found: Found) -> Found:
    """Return what was found by the exact cut, with the coverings that bear on what moves; as it was without a cut.

    A thrust that would push it over as it stands is left out, as of a wall that turns alone.
    """
    low, tied = found.parameters["hinge"].value, found.tied
    exact = _add_loads(definition, drawing, drawing.loads_on(parts, above=low, tied=bool(tied)))
    if exact.multiplier is not None and exact.multiplier <= 0.0 and not tied:
        tied = tuple(load.body for load in drawing.loads_on(parts, above=low) if load.role in THRUSTING)
        exact = _add_loads(definition, drawing, drawing.loads_on(parts, above=low, tied=True))
    if exact.multiplier is None:
        return found
    return replace(found, multiplier=exact.multiplier, definition=exact.definition, tied=tied)


def _add_loads(definition: BlockMechanism, drawing: Drawing, loads: Sequence[BodyLoad]) -> Found:
    """Build a mechanism with those of some coverings that bear on what moves of their walls."""
    found = built(definition, drawing.around(definition), {})
    for load in loads:
        loaded = replace(definition, loads=(*definition.loads, load))
        exact = built(loaded, drawing.around(loaded), {})
        if exact.multiplier is not None:
            definition, found = loaded, exact
    return found


def _wedges(solids: Sequence[Solid], across: np.ndarray, back: float, elevation: float, angle: float) -> list[Solid]:
    """Return the parts of side walls in front of a crack that rises from the back of a wall at an angle [rad]."""
    plane = Plane(np.array([*(back * across[:2]), elevation]), np.array([*(cos(angle) * across[:2]), sin(angle)]))
    found: list[Solid] = []
    for solid in solids:
        ahead = solid.vertices @ plane.normal > plane.point @ plane.normal
        low = solid.vertices[:, 2] < elevation
        if not ahead.any():
            continue
        kept = (solid,) if ahead.all() else divide((solid,), plane, where="crack").above
        found += kept if not low.any() else divide(kept, level_plane(elevation), where="crack").above
    return found


def _mass_at(solid: Solid, direction: Vector) -> tuple[float, tuple[float, float]]:
    return solid.mass, (float(solid.centroid @ np.array(direction)), float(solid.centroid[2]))


def weakest_crack(
    parts: Sequence[Part], directions: Sequence[Vector], drawing: Drawing, *, low: float, high: float
) -> Found:
    """Find elevation and inclination of the crack above which a tower or spire falls, with what stands on it.

    The crack is looked for in the direction in which it is weakest on a level one, then in any in which the crack that
    is found is weaker. A crack begins on the line up from the edge of the foot, between the two elevations [m]: one
    below would leave through the foot, and what it parts would still stand on what carries the foot.
    """
    lead, blocks = parts[0], (tuple(part.name for part in parts),)
    stacks: dict[Vector, TurningStack] = {}
    for direction in directions:
        definition = SingleBlock(blocks=blocks, direction=direction, sides="one")
        try:
            stacks[direction] = turning_stack(definition, drawing.around(definition))
        except AssessError as error:
            return Found(None, direction, why_not=_why(error))
    known: dict[tuple[Vector, tuple[float, ...]], float] = {}

    def value(way: Vector, at: tuple[float, ...]) -> float:
        x, y, _ = edge_towards(way, lead.solid.vertices)
        normal = (way[0] * sin(at[1]), way[1] * sin(at[1]), cos(at[1]))
        if (way, at) not in known:
            plane = inclined_plane((x, y, at[0]), normal, where="crack")
            known[way, at] = _value(lambda: stacks[way].above(plane))
        return known[way, at]

    towards = min(stacks, key=lambda way: _value(lambda: stacks[way].above(None)))
    tried: dict[Vector, Least] = {}
    while towards not in tried:
        tried[towards] = find_least(
            partial(value, towards), bounds=((low, high), (0.0, STEEP)), stations=(3, 6), starts=1, halvings=4
        )
        towards = min(tried, key=lambda way: tried[way].value)
        least = tried[towards]
        if least.value == inf:
            return Found(None, towards, why_not="no crack parts it")
        weaker = min(stacks, key=lambda way: value(way, least.at))
        towards = weaker if value(weaker, least.at) < (1.0 - AS_WEAK) * least.value else towards
    least = replace(least, evaluations=len(known))
    x, y, _ = edge_towards(towards, lead.solid.vertices)
    point = (x, y, least.at[0])
    definition = SingleBlock(blocks=blocks, direction=towards, sides="one", cut=CutAngle(point, least.at[1]))
    parameters = {"crack": Quantity(least.at[0], "length"), "angle": Quantity(least.at[1], "angle", 3)}
    beside = ((value(way, least.at), way) for way in stacks if way != towards)
    others = tuple(Alternative(each, way, {}) for each, way in sorted(beside) if each < inf)
    return replace(built(definition, drawing.around(definition), parameters, least), others=others)


def weakest_bend(
    part: Part, direction: Vector, drawing: Drawing, *, low: float, high: float, load: OverburdenLoad
) -> Found:
    """Find the crack between two levels that hold a wall at which it bends out at the least multiplier.

    A wall that goes on above the upper level is taken as the slice between the levels, which no project states.
    """
    goes_on = part.top - NEAR_LEVEL > high
    name, cut = part.name, low if low > part.base + NEAR_LEVEL else None
    if goes_on:
        name, cut = f"{part.name}, {low:.2f} to {high:.2f} m", None
    whole = TwoBlock(blocks=((name,),), direction=direction, sides="one", cut=cut, crack="sorrentino", loads=(load,))
    bodies = {name: _slice(drawing.bodies[part.name], name, low, high)} if goes_on else drawing.around(whole)
    try:
        formula, members = on_rigid_hinges(NAME, whole, bodies)
    except AssessError as error:
        return Found(None, direction, definition=whole, why_not=_why(error), evaluations=1)
    first = min(map(uplift_multiplier, formula.chains))
    (pressing,) = (each for each in formula.positive.loads if isinstance(each, Force))
    ends = top_edge(members[1].body)
    assert ends is not None  # it has geometry
    aside = pressing.at[0] - (ends[0][0] + ends[1][0]) / 2.0
    alone = replace(whole, loads=(OverburdenLoad(force=-pressing.force[1], eccentricity=aside),))
    own = {name: bodies[name]}
    least = find_least(
        lambda at: built(replace(alone, crack=at[0]), own, {}).multiplier or inf,
        bounds=((low + 0.4 * (high - low), high - 0.03 * (high - low)),),
        stations=(5,),
        starts=1,
        halvings=4,
    )
    searched = least.value < first
    crack = least.at[0] if searched else formula.positive.hinges[1][1]
    return Found(
        min(first, least.value),
        direction,
        {"crack": Quantity(crack, "length")},
        None if goes_on else replace(whole, crack="minimum" if searched else "sorrentino"),
        evaluations=least.evaluations + 1,
    )


def _slice(body: Body, name: str, low: float, high: float) -> Body:
    """Return the part of a body between two elevations [m]."""
    assert body.solid is not None
    kept = divide((body.solid,), level_plane(high), where=name).below[0]
    if float(kept.vertices[:, 2].min()) < low - NEAR_LEVEL:
        kept = divide((kept,), level_plane(low), where=name).above[0]
    return replace(body, name=name, solid=replace(kept, name=name))


def weakest_corner(
    stacks: tuple[Sequence[Part], Sequence[Part]], drawing: Drawing, caps: tuple[Sequence[Part], Sequence[Part]]
) -> Found:
    """Find height, cracks and direction of the least multiplier of the corner of two façades, with what bears on it.

    Coverings load a corner by their weight along each wall, over the top of its wedge; thrusts of hips are not drawn.

    Parameters
    ----------
    stacks : the walls of each façade, from the ground up
    caps : gables and parapets on each façade, through which its crack goes on
    """
    first, second = np.array(stacks[1][0].normal), np.array(stacks[0][0].normal)
    walls = (_side_wall(stacks[0], first), _side_wall(stacks[1], second))
    top = min(max(part.top for part in stack) for stack in stacks)
    foot = max(min(part.base for part in stack) for stack in stacks)
    lines = [
        [drawing.weight_per_length(part) for part in (*stack, *on)] for stack, on in zip(stacks, caps, strict=True)
    ]
    faces = [_face(stacks[1], first), _face(stacks[0], second)]

    def caps_at(at: tuple[float, ...]) -> Iterator[CornerLoad]:
        for number, (way, other) in enumerate(((first, walls[1]), (second, walls[0]))):
            solids = [part.solid for part in caps[number]]
            for part in _wedges(solids, way, faces[number] - other.thickness, top - at[0], at[1 + number]):
                x, y = (float(part.centroid @ each) - face for each, face in zip((first, second), faces, strict=True))
                yield CornerLoad(name=part.name, at=(x, y, float(part.centroid[2]) - foot), mass=part.mass)

    def chain_at(at: tuple[float, ...]) -> Chain:
        loads = []
        for number, (wall, other) in enumerate((walls, walls[::-1])):
            length = other.thickness + min(at[0] * tan(at[1 + number]), wall.reach)
            back, aside = -length / 2.0, -wall.thickness / 2.0
            x, y = (back, aside) if number == 0 else (aside, back)
            loads += [
                CornerLoad(name=f"line {number}", at=(x, y, elevation - foot), mass=line * length)
                for line, elevation in lines[number]
                if line > 0.0
            ]
        loads += caps_at(at)
        return corner(walls, top=top - foot, height=at[0], angles=(at[1], at[2]), direction=at[3], loads=loads)

    height = top - foot
    least = find_least(
        lambda at: uplift_multiplier(chain_at(at)),
        bounds=((LOWEST * height, height), (0.0, STEEPEST), (0.0, STEEPEST), (0.0, pi / 2.0)),
        stations=(4, 3, 3, 3),
        starts=2,
        halvings=5,
    )

    def direction_of(at: tuple[float, ...]) -> Vector:
        towards = cos(at[3]) * first + sin(at[3]) * second
        return (float(towards[0]), float(towards[1]), 0.0)

    def parameters_of(at: tuple[float, ...]) -> Parameters:
        names = ("angle in the first wall", "angle in the second wall")
        angles = {name: Quantity(angle, "angle", 3) for name, angle in zip(names, at[1:3], strict=True)}
        return {"hinge": Quantity(top - at[0], "length")} | angles

    others = tuple(Alternative(value, direction_of(at), parameters_of(at)) for value, at in least.others)
    found = Found(least.value, direction_of(least.at), parameters_of(least.at), None, others, least.evaluations)
    elevation = round(top - least.at[0], 3)
    moving = [(*stack, *on) for stack, on in zip(stacks, caps, strict=True)]
    parts = [part for each in moving for part in each]
    definition = Corner(
        blocks=(tuple(part.name for part in parts),),
        direction=found.direction,
        cut=elevation if any(part.base < elevation - NEAR_LEVEL for part in parts) else None,
        wedges=tuple(
            Wedge(
                walls=tuple(part.name for part in each),
                angle=round(angle, 6),
                reach=wall.reach if any(part.openings for part in each) else None,
            )
            for each, wall, angle in zip(moving, walls, least.at[1:3], strict=True)
        ),
    )
    return _cut_exactly(definition, drawing, parts, found)


def _face(stack: Sequence[Part], outwards: np.ndarray) -> float:
    """Return how far walls reach outwards [m]."""
    return max(float((part.solid.vertices @ outwards).max()) for part in stack)


def arch_of_bay(wall: Part, between: tuple[Part, Part], drawing: Drawing, direction: Vector) -> Found:
    """Return the arch of a wall between two cross walls, of the weakest masonry, with the coverings that bear on it."""
    names = (between[0].name, between[1].name)
    definition = HorizontalArch(blocks=((wall.name,),), between=names, direction=direction)
    found = _add_loads(definition, drawing, drawing.loads_on((wall,), above=wall.base))
    if found.multiplier is None or found.multiplier <= 0.0 or found.definition is None:
        return found
    chain = on_rigid_hinges(NAME, found.definition, drawing.around(found.definition))[0].positive
    held = chain.actions[-1]
    assert isinstance(held, Force)  # the thrust that its ends are left with
    rise = chain.hinges[0][0] - chain.hinges[1][0]
    return replace(found, parameters={"thrust": Quantity(-held.force[1], "force"), "rise": Quantity(rise, "length")})


def _side_wall(stack: Sequence[Part], outwards: np.ndarray) -> SideWall:
    """Return the walls of a façade as they run back from a corner at their end towards `outwards`, to an opening."""
    reach = min(part.length for part in stack)
    for part in stack:
        at_end = float(outwards @ np.array(part.along)) > 0.0
        reach = min([reach, *(part.length - each.right if at_end else each.left for each in part.openings)])
    thickness, density = min(part.thickness for part in stack), stack[0].density
    return SideWall(thickness=thickness, density=density, reach=max(reach, thickness))


def weakest_portal(piers: tuple[Part, Part], over: Sequence[Part], drawing: Drawing) -> Found:
    """Return the sway of two piers and what stands on both, towards the second."""
    across = np.array(piers[1].solid.centroid - piers[0].solid.centroid) * (1.0, 1.0, 0.0)
    along = across / float(np.linalg.norm(across))
    spans = [(float((p.solid.vertices @ along).min()), float((p.solid.vertices @ along).max())) for p in piers]
    (a, b), (c, d) = spans
    base, top = [part.base for part in piers], [part.top for part in piers]
    definition = FourHinge(
        blocks=((piers[0].name,), tuple(part.name for part in over), (piers[1].name,)),
        direction=(float(along[0]), float(along[1]), 0.0),
        hinges=((b, base[0]), (a, top[0]), (c, top[1]), (d, base[1])),
        hinges_negative=((a, base[0]), (b, top[0]), (d, top[1]), (c, base[1])),
        sides="two",
    )
    return built(definition, drawing.around(definition), {})


def weakest_arch(part: Part, drawing: Drawing) -> Found:
    """Find the four hinges of an arch at which it resists least, over even joints that point to its centre.

    The centre is that of the circle through the crown of its intrados and its inner springings.
    """
    direction = part.along
    (seen,) = (drawing.bodies[part.name].in_plane(direction),)
    shape = shapely.union_all([shapely.Polygon(ring) for ring in seen.outline])
    low_x, low_z, high_x, high_z = shape.bounds
    middle = (low_x + high_x) / 2.0
    crown = shape.intersection(shapely.LineString([(middle, low_z - 1.0), (middle, high_z + 1.0)]))
    level = low_z + 0.01 * (high_z - low_z)
    feet = shape.intersection(shapely.LineString([(low_x - 1.0, level), (high_x + 1.0, level)]))
    if crown.is_empty or not isinstance(feet, shapely.MultiLineString):
        return Found(None, direction, why_not="its outline is not that of an arch on two feet")
    inner, rise = middle - float(feet.geoms[0].bounds[2]), crown.bounds[1] - low_z
    radius = (inner**2 + rise**2) / (2.0 * rise)
    centre = crown.bounds[1] - radius
    first = atan2(low_z - centre, -inner) % (2.0 * pi) - AT_SPRINGING
    definition = FourHinge(
        blocks=((part.name,),),
        direction=direction,
        hinges="minimum",
        joints=RadialJoints((middle, centre), first, pi - first, VOUSSOIRS),
    )
    return built(definition, drawing.around(definition), {"radius": Quantity(radius, "length")})


def _why(error: AssessError) -> str:
    return str(error).removeprefix(f'mechanism "{NAME}": ')


def _value(chain: Callable[[], Chain]) -> float:
    """Return the multiplier of a chain; inf where there is none of it."""
    try:
        found = chain()
        return uplift_multiplier(found) if found.blocks[0].mass > 0.0 else inf
    except AssessError:
        return inf


def _contact_area(contact: PartContact) -> ContactArea:
    return ContactArea(contact.area, np.array(contact.centroid), np.array(contact.normal), True)
