"""The walls at the far ends of ties, found on the bodies of a project, each at the crack at which it holds least.

The far wall is the upright body in which the anchor lies. It turns towards the tied wall about a level crack below the
anchor, of those above which nothing stops it. What stops it touches its inner face all along what turns, and stands, or
reaches a body that stands or the tied wall, as a floor does. It turns as far along itself as the ties in it hold it,
1.5 m to either side of each; what bears on it goes with it where that leaves less.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from assess.errors import AssessError, GeometryError
from assess.geometry.contact import ContactArea, facing_patches, find_contact
from assess.geometry.cut import level_plane, split_upright
from assess.geometry.solid import Solid, keep_of_bodies
from assess.loads.anchorage import CLOSE, Figure, Plate, farthest_edge, weakest_cone
from assess.loads.far_wall import FarEnd, FarWall, SiteAction, action_at
from assess.loads.load import (
    BodyLoad,
    Load,
    LoadDefinition,
    PointMass,
    TieLoad,
    point_in_plane,
    share_ends,
    unit_in_plane,
)
from assess.mechanisms.chain import Chain, virtual_work
from assess.mechanisms.mechanism import Vector
from assess.mechanisms.single_block import SingleBlock
from assess.model.bodies import Bodies
from assess.model.plates import OFF_FACE, Wall, elevation_around, meeting_cones, outwards, run_through
from assess.model.turning import TurningStack
from spectra.arrays import FloatArray
from spectra.gravity import g

CRACKS = 12  # level cracks that are looked at, from the foot of the far wall up to the anchor
FOOT = 0.1  # of the height above a crack: what touches the wall lower, as a pavement does, does not stop it
AHEAD = 0.7  # cosine between a touched face and the motion that the contact stops: within 45 degrees
SMALLEST = 0.01  # m2: less contact is a slip of drawing
SLICES = 8  # of a strip along the wall: what stops it touches each of them
BEYOND = 1.0  # m: behind an anchor, within which a wall is one that it should lie in
ASIDE = 1e-3  # m: by which the line through a wall is moved off the edges of its triangles
MORE = 1.001  # times the drawn thickness, beyond which an injected length leaves the wall
LoadsOn = Callable[[SingleBlock], tuple[Load, ...]]


@dataclass(frozen=True, eq=False)
class _AtFarEnd:
    """The far wall as its ties meet it.

    name, solid : of the body; thickness : along the tie at the anchor [m]
    inwards : horizontal unit vector towards the tied wall [3]
    strip : what of it turns, from `first` to `last` along it [m]; whole : its own length [m]
    ties : that hold the strip, the one that is looked at first
    """

    name: str
    solid: Solid
    thickness: float
    inwards: FloatArray
    strip: tuple[Solid, ...]
    first: float
    last: float
    whole: float
    ties: tuple[TieLoad, ...]

    @property
    def direction(self) -> Vector:
        """In which it turns."""
        x, y, z = self.inwards.tolist()
        return (x, y, z)


def far_wall_of(
    tie: TieLoad,
    loads: Sequence[LoadDefinition],
    bodies: Bodies,
    *,
    moving: Sequence[str],
    loads_on: LoadsOn,
    where: str,
) -> tuple[FarWall | None, FarEnd]:
    """Return the far wall of a tie at the crack at which it holds least, and what else is known of it.

    The first is None where the anchor lies in no upright body, where bodies beside it stop the wall above all cracks,
    or the action of the site or what it carries is not known.

    Parameters
    ----------
    tie : with a plate; where : its plate, for errors
    loads : of its mechanism, whose ties share the far wall and whose floors may bear on it
    bodies : of the project; moving : names of those of the mechanism
    loads_on : finds the loads of the far wall

    Raises
    ------
    GeometryError : a body that is named is none, or the anchor lies off it or off a wall that the tie meets; an
        injected end is longer than its wall
    """
    assert tie.plate is not None
    around = [*loads, *tie.others, *tie.neighbours]
    met = _met(tie, around, bodies, moving=moving, where=where)
    if met is None:
        return None, FarEnd()
    if (length := tie.plate.embedment) is not None and length > MORE * met.thickness:
        raise GeometryError(
            f'{where}.embedment = {length:.4g} m: the wall "{met.name}" is {met.thickness:.4g} m thick at the anchor; '
            "give the length of the hole within it"
        )
    cone = _injected_cone(tie, met, around)
    end = FarEnd(met.name, "", stack=_stacked(met, bodies, moving=moving), cone=cone)
    if tie.site is None or not met.strip:
        return None, replace(end, unexamined="no site")
    floors = _floors_on(met.solid, [*loads, *tie.floors], bodies)
    whole = SingleBlock(blocks=((met.name,),), direction=met.direction, sides="one", loads=floors)
    beside = {*moving, met.name, *(floor.body for floor in floors)}
    solids = {key: each.solid for key, each in bodies.items() if each.solid is not None and key != met.name}
    held_by = [key for key in solids if key not in beside and _touches_ahead(met, solids[key])]
    held_by = [key for key in held_by if _stands_beyond(key, met, solids, moving=moving)]
    stops = _faces_ahead(met, [solids[key] for key in held_by])
    if any(float(area.sum()) <= SMALLEST / SLICES for _, area in stops):
        held_by, stops = [], [(np.zeros(0), np.zeros(0))]
    try:
        borne = _share_of(loads_on(whole), (met.last - met.first) / met.whole)
    except AssessError:
        return None, replace(end, unexamined="no loads")
    site = _on_drawing(tie.site, bodies)
    found = [
        _turning(chain, crack, met, site, FC=tie.plate.confidence)
        for carried in dict.fromkeys(((), borne))
        for crack, chain in _cracked(met, carried, stops)
    ]
    turned = [each for each in found if each.levers > 0.0]  # a tie that falls steeply presses it down above a crack
    least = min(turned, key=lambda each: each.strength, default=None)
    return least, replace(end, unexamined="" if turned else "pressed" if found else "held", held_by=tuple(held_by))


def _met(
    tie: TieLoad, loads: Sequence[LoadDefinition], bodies: Bodies, *, moving: Sequence[str], where: str
) -> _AtFarEnd | None:
    """Return the far wall as drawn; None where the anchor lies in no upright body."""
    assert tie.plate is not None
    inwards, named = outwards(tie), tie.plate.far_wall
    if inwards is None:
        return None
    beside = {key: each.solid for key, each in bodies.items() if each.solid is not None and key not in moving}
    if named is not None and named not in beside:
        raise GeometryError(
            f'{where}.far_wall = "{named}": no body with geometry beside the mechanism; choose of {", ".join(beside)}'
        )
    runs = {key: _run(solid, tie) for key, solid in beside.items() if named in (None, key)}
    upright = {key: run for key, run in runs.items() if run is not None and run < _height_of(beside[key])}
    if not upright:
        if named is not None:
            raise GeometryError(f'{where}.far_wall = "{named}": the anchor does not lie in it; move `anchor` into it')
        if all(run is None for run in runs.values()):
            _require_no_wall_beside(tie, beside, inwards, where=where)
        return None
    name = max(upright, key=lambda key: upright[key])
    along = (-float(inwards[1]), float(inwards[0]), 0.0)
    places = beside[name].vertices @ along
    low, high = float(places.min()), float(places.max())
    first, last, ties = _held_by(tie, [each for each in loads if isinstance(each, TieLoad)], beside[name], along)
    first, last = max(first, low), min(last, high)
    strip = _between((beside[name],), along, first, last)
    return _AtFarEnd(name, beside[name], upright[name], inwards, strip, first, last, high - low, ties)


def _require_no_wall_beside(tie: TieLoad, beside: Mapping[str, Solid], inwards: FloatArray, *, where: str) -> None:
    """Raise GeometryError for an anchor in the air where the tie or its line a little beyond meets a wall."""
    at, anchor = np.array(tie.at), np.array(tie.anchor or tie.at)
    out, along = -inwards, np.array([-inwards[1], inwards[0], 0.0])
    for name, solid in beside.items():
        met = run_through(Wall((solid,), along, out), float(anchor @ along) + ASIDE, float(anchor[2]) - ASIDE)
        if met is None:
            continue
        face, thickness = met
        across = thickness < _height_of(solid) and thickness < float(np.ptp(solid.vertices @ along))
        if across and float(at @ out) < face and face - thickness < float(anchor @ out) + BEYOND:
            first, last = (
                np.round(anchor + (end - float(anchor @ out)) * out, 3) + 0.0 for end in (face - thickness, face)
            )
            raise GeometryError(
                f"{where}: the anchor of its tie lies in no body, and the tie or its line up to {BEYOND:g} m beyond "
                f'meets the wall "{name}" from [{", ".join(f"{each:g}" for each in first)}] to '
                f"[{', '.join(f'{each:g}' for each in last)}]; move `anchor` into "
                "the wall that holds it, or draw that wall"
            )


def _injected_cone(tie: TieLoad, met: _AtFarEnd, loads: Sequence[LoadDefinition]) -> float | None:
    """Return the surface of the cone of an injected end that edges and cones of others leave to it [m2]; None without.

    It opens from the end of the hole to the inner face, as that of a round plate of the width of the hole does.
    """
    assert tie.plate is not None
    if tie.plate.hole is None or tie.plate.embedment is None:
        return None
    wall = Wall((met.solid,), np.array([-met.inwards[1], met.inwards[0], 0.0]), met.inwards)

    def figure(each: TieLoad, hole: float) -> Figure:
        anchor = np.array(each.anchor)
        return Plate(diameter=hole), float(anchor @ wall.across), float(anchor[2])

    others = [
        figure(each, each.plate.hole)
        for each in loads
        if isinstance(each, TieLoad) and each.plate is not None and each.plate.hole is not None
        if _run(met.solid, each) is not None
    ]
    depth = tie.plate.embedment
    figures = meeting_cones(figure(tie, tie.plate.hole), others, depth)
    reach = farthest_edge(figures, depth) + depth + max(each[0].sides[0] for each in figures)
    seen = elevation_around(wall, [each[1:] for each in figures], reach)
    return min(weakest_cone(figures[:n], depth, seen)[0] / n for n in range(1, len(figures) + 1))


def _height_of(solid: Solid) -> float:
    return solid.bounds[1][2] - solid.bounds[0][2]


def _run(solid: Solid, tie: TieLoad) -> float | None:
    """Return the thickness of a body along a tie, at its anchor [m]; None where the anchor does not lie in or on it."""
    inwards = outwards(tie)
    if inwards is None or tie.anchor is None or len(tie.anchor) != 3:
        return None
    wall = Wall((solid,), np.array([-inwards[1], inwards[0], 0.0]), -inwards)
    at = np.array(tie.anchor)
    found = run_through(wall, float(at @ wall.across) + ASIDE, float(at[2]) - ASIDE)
    if found is None:
        return None
    face, thickness = found
    return thickness if face - thickness - OFF_FACE <= float(at @ wall.out) <= face + OFF_FACE else None


def _held_by(
    tie: TieLoad, others: Sequence[TieLoad], solid: Solid, along: tuple[float, ...]
) -> tuple[float, float, tuple[TieLoad, ...]]:
    """Return what a tie holds along its far wall, with all whose parts meet its own: from, to [m], and the ties."""
    ties = [tie]
    for each in others:
        if _pull_alike(tie, each) and _run(solid, each) is not None:
            ties += [] if any(share_ends(each, one) for one in ties) else [each]
    middles = sorted((float(np.dot(each.anchor or each.at, along)), place) for place, each in enumerate(ties))
    groups = [[middles[0]]]
    for before, after in pairwise(middles):
        if after[0] - before[0] > CLOSE:
            groups.append([])
        groups[-1].append(after)
    own = next(group for group in groups if any(place == 0 for _, place in group))
    held = tuple(ties[place] for place in sorted(place for _, place in own))
    return own[0][0] - CLOSE / 2.0, own[-1][0] + CLOSE / 2.0, held


def _pull_alike(one: TieLoad, other: TieLoad) -> bool:
    """Return whether two ties pull what they are anchored in the same way, within 45 degrees in plan."""
    ways = outwards(one), outwards(other)
    return ways[0] is not None and ways[1] is not None and float(ways[0] @ ways[1]) > AHEAD


@keep_of_bodies
def _between(solids: tuple[Solid, ...], along: tuple[float, ...], first: float, last: float) -> tuple[Solid, ...]:
    """Return what of bodies lies between two places along a wall [m]."""
    kept, way = list(solids), np.array(along)
    for place, sign in ((first, 1.0), (last, -1.0)):
        parts = [part for solid in kept for part in split_upright(solid, point=place * way, normal=way)]
        kept = [part for part in parts if sign * (float(part.centroid @ way) - place) > 0.0]
    return tuple(kept)


def _floors_on(solid: Solid, loads: Sequence[LoadDefinition], bodies: Bodies) -> tuple[BodyLoad, ...]:
    """Return the weights of bodies among loads of the project that bear on a wall, each once."""
    found: dict[str, BodyLoad] = {}
    for load in loads:
        body = bodies[load.body].solid if isinstance(load, BodyLoad) else None
        if isinstance(load, BodyLoad) and body is not None and load.body not in found:
            contact = find_contact(solid, body, tolerance=load.tolerance)
            if contact is not None and contact.bearing:
                found[load.body] = BodyLoad(body=load.body, tolerance=load.tolerance, mass=load.mass)
    return tuple(found.values())


def _share_of(loads: Sequence[Load], share: float) -> tuple[Load, ...]:
    """Return a part of weights that are spread evenly along a wall."""
    return tuple(replace(load, mass=share * load.mass) for load in loads if isinstance(load, PointMass))


def _faces_ahead(met: _AtFarEnd, beside: Sequence[Solid]) -> list[tuple[FloatArray, FloatArray]]:
    """Return the elevations [k] [m] and areas [k] [m2] of what of the inner face bodies touch, by slices along it."""
    edges = np.linspace(met.first, met.last, SLICES + 1).tolist()
    along = (-float(met.inwards[1]), float(met.inwards[0]), 0.0)
    touched = []
    for first, last in pairwise(edges):
        slices = _between(met.strip, along, first, last)
        found = [facing_patches(part, other) for part in slices for other in beside]
        ahead = [each.normal @ met.inwards > AHEAD for each in found]
        level = [each.centroid[kept, 2] for each, kept in zip(found, ahead, strict=True)]
        area = [each.area[kept] for each, kept in zip(found, ahead, strict=True)]
        touched.append((np.concatenate([*level, np.zeros(0)]), np.concatenate([*area, np.zeros(0)])))
    return touched


def _touches_ahead(met: _AtFarEnd, other: Solid) -> bool:
    return any(float(area.sum()) > SMALLEST for _, area in _faces_ahead(met, [other]))


def _stands_beyond(name: str, met: _AtFarEnd, solids: Mapping[str, Solid], *, moving: Sequence[str]) -> bool:
    """Return whether a body stands by itself or reaches what does, other than by the far wall and the tied one.

    Both walls are shaken in one sense: what reaches the tied wall alone would push it outwards.
    """
    foot = met.solid.bounds[0][2] + FOOT * _height_of(met.solid)
    reached = [name]
    for each in reached:  # grows as it goes
        if solids[each].bounds[0][2] <= foot:
            return True
        reached += [key for key in solids if key not in (*reached, *moving) and _touch(solids[each], solids[key])]
    return False


def _touch(one: Solid, other: Solid) -> bool:
    return any(each is not None for each in _contacts(one, other))


def _stacked(met: _AtFarEnd, bodies: Bodies, *, moving: Sequence[str]) -> tuple[str, ...]:
    """Return the walls that stand on the far wall or under it, as bodies that are higher than they are deep."""
    return tuple(
        name
        for name, each in bodies.items()
        if each.solid is not None and name not in (*moving, met.name)
        if float(np.ptp(each.solid.vertices @ met.inwards)) < _height_of(each.solid)
        if any(found is not None and found.bearing for found in _contacts(met.solid, each.solid))
    )


def _contacts(one: Solid, other: Solid) -> tuple[ContactArea | None, ContactArea | None]:
    return find_contact(one, other), find_contact(other, one)


def _cracked(
    met: _AtFarEnd, loads: tuple[Load, ...], stops: Sequence[tuple[FloatArray, FloatArray]]
) -> Iterator[tuple[float, Chain]]:
    """Yield the strip above each crack below the anchor at which nothing stops it, with the elevation [m]."""
    stack = TurningStack(met.strip, loads, met.direction)
    low = min(part.bounds[0][2] for part in met.strip)
    high = max(part.bounds[1][2] for part in met.strip)
    for crack in np.linspace(low, float((met.ties[0].anchor or met.ties[0].at)[2]), CRACKS, endpoint=False).tolist():
        foot = crack + FOOT * (high - crack)
        if any(float(area[level > foot].sum()) <= SMALLEST / SLICES for level, area in stops):
            with suppress(GeometryError):  # a crack through an opening
                yield crack, stack.above(level_plane(crack) if crack > low else None)


def _turning(chain: Chain, crack: float, met: _AtFarEnd, site: SiteAction, *, FC: float) -> FarWall:
    """Return the moments of a strip above a crack about its edge, and the arms of its ties."""
    work = virtual_work(chain, np.zeros(1))
    arms = [_arm(each, chain, met.direction) for each in met.ties]
    assert site.ground is not None
    assert site.height is not None
    Z = max(crack - site.ground, 0.0)
    return FarWall(
        body=met.name,
        crack=crack,
        stabilising=float(work.restoring[0]),
        overturning=g * float(work.excitation[0]),
        levers=sum(each for each in arms if each > 0.0),
        ties=sum(each > 0.0 for each in arms),
        action=action_at(pga=site.pga, FC=FC, Z=Z, H=site.height),
        FC=FC,
        pga=site.pga,
        rise=min(Z / site.height, 1.0),
        length=met.last - met.first,
    )


def _arm(tie: TieLoad, chain: Chain, direction: Vector) -> float:
    """Return the moment of a unit pull of a tie at its anchor about the edge at which the wall turns [m]."""
    anchor = tie.anchor or tie.at
    (x, z), (x_e, z_e) = point_in_plane(anchor, direction), chain.hinges[0]
    along, up = unit_in_plane(np.subtract(tie.at, anchor).tolist(), direction)
    return along * (z - z_e) - up * (x - x_e)


def _on_drawing(site: SiteAction, bodies: Bodies) -> SiteAction:
    """Return the action of a site with ground and height of the building, of the drawing where they are not given."""
    ends = [each.solid.bounds for each in bodies.values() if each.solid is not None]
    ground = min(low[2] for low, _ in ends) if site.ground is None else site.ground
    height = max(high[2] for _, high in ends) - ground if site.height is None else site.height
    return replace(site, ground=ground, height=height)
