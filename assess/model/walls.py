"""Walls held at base and top: what presses on them, and where they crack: eq. 3.27, its general form, and a search."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf, sqrt
from typing import Literal

import numpy as np

from assess.errors import CrackError
from assess.geometry.contact import CONTACT_TOLERANCE, find_contact
from assess.geometry.cut import Division, Piece, divide, level_plane
from assess.geometry.planar import base_of_section, join_bodies, planar_body, top_edge
from assess.geometry.solid import Solid
from assess.loads.bearing import UPPER
from assess.loads.body_loads import LoadSet
from assess.loads.load import Force, Load, LoadDefinition, PointMass
from assess.mechanisms.chain import Chain, mirror_chain, move, virtual_work
from assess.mechanisms.mechanism import Sides, Vector
from assess.mechanisms.two_block import Hinges, TwoBlock
from assess.messages.message import Message, Quantity, Value, warning
from assess.model.bodies import Bodies, Body, Material, materials_of, piece_above_cut, pieces_of
from assess.model.check import check_definition, with_floats
from assess.model.loading import loads_of
from assess.model.turning import static_block
from spectra.gravity import g


@dataclass(frozen=True)
class Crack:
    """Where a wall of one body cracks: elevation [m], how it was found, and the loads that it was found with."""

    elevation: float
    warnings: tuple[Message, ...] = ()
    loads: tuple[Load, ...] | None = None


@dataclass(frozen=True)
class WallPanel:
    """The wall as eq. 3.27 sees it: the box around it [m], its weight [N], the mortar's tensile strength [Pa].

    overburden : vertical load downwards [N]; place : of the load along the direction [m]; low, high : faces [m]
    """

    low: float
    high: float
    length: float
    base: float
    height: float
    weight: float
    strength: float
    overburden: float
    place: float

    @property
    def thickness(self) -> float:
        """Size along the direction [m]."""
        return self.high - self.low

    @property
    def tension(self) -> float:
        """Tensile strength of the mortar times the area of the base [N]."""
        return self.strength * self.thickness * self.length


def crack(
    body: Body,
    *,
    direction: Vector,
    method: float | Literal["sorrentino", "minimum"] = "sorrentino",
    sides: Sides = "two",
    loads: Sequence[LoadDefinition] = (),
    around: Sequence[Body] = (),
) -> Crack:
    """Find where a wall held at its base and its top cracks.

    Parameters
    ----------
    body : the wall
    direction : of the motion, horizontal (x, y, 0)
    method : "sorrentino" (thesis eq. 3.27), "minimum" (least uplift multiplier), or an elevation [m]
    sides : "one" where the wall rocks towards the direction alone
    loads : what stands on the wall; those of bodies are found among `around`
    around : other bodies of the building

    Returns
    -------
    The elevation of the crack [m], how it was found, and the loads that it was found with

    Raises
    ------
    CrackError : there is nothing to find the crack from
    MechanismError : a value that no wall can have
    """
    bodies = {each.name: each for each in (body, *around)}
    definition = with_floats(
        TwoBlock(blocks=((body.name,),), direction=direction, crack=method, sides=sides, loads=tuple(loads))
    )
    check_definition(body.name, definition, bodies)
    (whole,) = pieces_of(body.name, definition, bodies)
    return crack_of(definition, whole, bodies, lambda: loads_of(body.name, definition, (whole,), bodies), front=None)


def crack_of(
    definition: TwoBlock,
    whole: Piece,
    bodies: Bodies,
    loads: Callable[[], LoadSet],
    *,
    front: Hinges | None,
) -> Crack:
    """Find where a wall of one body cracks; loads: finds those of the whole wall, before it cracks.

    Raises CrackError where there is nothing to find the crack from.
    """
    if not whole.solids:
        raise CrackError("its body has no geometry to crack; give it a mesh, box or profile, or two bodies")
    crack = definition.crack
    if crack is None:
        crack = front[1][1] if front is not None else "sorrentino"
    if not isinstance(crack, str):
        return Crack(float(crack))
    find = _crack_by_formula if crack == "sorrentino" else _crack_by_search
    load_set = loads()
    strength = next(materials_of(definition.blocks[0], bodies)).tensile_strength or 0.0
    elevation, notice = find(definition, whole, load_set, strength=strength)
    return Crack(elevation, (notice,), _loads_above(load_set, elevation))


def blocks_at(elevation: float, name: str, definition: TwoBlock, whole: Piece) -> tuple[Piece, Piece]:
    """Return the two blocks of a wall that cracks at an elevation [m].

    Raises CrackError where the crack does not lie in the wall.
    """
    parts = divide(whole.solids, level_plane(elevation), where=f'mechanism "{name}": crack')
    if not parts.below:
        raise CrackError(f"the crack at z = {elevation:.4g} m is at the foot of the wall; give one above it")
    return _block_below_crack(parts, whole, definition.towards), piece_above_cut(parts, definition.towards)


def require_as_found(crack: Crack | None, loads: Sequence[Load]) -> None:
    """Raise CrackError if the crack was found with loads on other blocks than those they rest on once it is cut."""
    if crack is None or crack.loads is None:
        return
    before, after = ({(load.name, load.block) for load in each} for each in (crack.loads, loads))
    for name, _ in sorted(before ^ after):
        raise CrackError(
            f'the crack at z = {crack.elevation:.4g} m is found with load "{name}" on one side of it, yet the load '
            "stands on the other too; give a crack elevation"
        )


STATIONS = 41  # of the search, before it is refined
MARGIN = 0.02  # of the height: least distance of a crack from base or top
FINE = 1e-6  # of the height: accuracy of the search
TENSION_ARM = 0.5  # of the thickness: lever arm of the tensile block at the crack, in eq. 3.27


def crack_ratio(*, load: float, tension: float, place: float, arm: float = TENSION_ARM) -> float:
    """Return the height of the crack over that of a plain rectangular wall, for the least uplift multiplier.

    h_c / h = sqrt(a) / (sqrt(a) + sqrt(c)) with a = 1 + n + arm t and c = (1 - xi) n + arm t. With the load at
    mid-thickness (xi = 1/2) and arm = 1/2 it is thesis eq. 3.27 (Sorrentino et al. 2008).

    Parameters
    ----------
    load : n, vertical load over the weight of the wall [-]
    tension : t, tensile strength of the mortar times the area of the base over the weight of the wall [-]
    place : xi, distance of the load from the edge support over the thickness [-]; see two_block
    arm : lever arm of the tensile block over the thickness [-]

    Raises
    ------
    CrackError : there is neither load nor tension, so that the crack would be at the top
    """
    a, c = 1.0 + load + arm * tension, (1.0 - place) * load + arm * tension
    if c <= 0.0:
        raise CrackError(
            "eq. 3.27 puts the crack at the very top, for there is neither load nor tensile strength to hold it lower"
        )
    return sqrt(a) / (sqrt(a) + sqrt(c))


def find_least_multiplier(
    multiplier: Callable[[float], float], *, low: float, high: float, jumps: Sequence[float] = (), apart: float = 0.0
) -> float:
    """Find the elevation of the crack at which the multiplier of a wall is least [m].

    Parameters
    ----------
    multiplier : of the wall cracked at an elevation [m] -> [-]
    low, high : elevations of base and top [m]
    jumps : elevations at which the multiplier jumps [m]
    apart : least distance of the crack from a jump [m]

    Raises
    ------
    CrackError : the multiplier is least at an end, so that no crack between controls
    """
    ends = (low + MARGIN * (high - low), high - MARGIN * (high - low))
    parts = list(_split_range(ends, jumps, apart=apart))
    best, at, bounds = inf, low, ends
    for start, end in parts:
        stations = np.linspace(start, end, STATIONS)
        values = [multiplier(float(each)) for each in stations]
        lowest = int(np.argmin(values))
        if values[lowest] < best:
            best, at = values[lowest], float(stations[lowest])
            bounds = (float(stations[max(lowest - 1, 0)]), float(stations[min(lowest + 1, STATIONS - 1)]))
    if not parts or at in (parts[0][0], parts[-1][1]):
        raise CrackError(
            f'crack = "minimum": the least multiplier is at an end, at z = {at:.4g} m, so no crack between '
            "base and top controls; give an overburden load, the material's tensile_strength, a crack elevation, or "
            "hinges"
        )
    from scipy.optimize import minimize_scalar

    found = minimize_scalar(multiplier, bounds=bounds, method="bounded", options={"xatol": FINE * (high - low)})
    return float(found.x)


def _loads_above(load_set: LoadSet, elevation: float) -> tuple[Load, ...]:
    """Assign the loads of a wall to its blocks, if it cracks at an elevation [m]."""
    return tuple(
        replace(load, block=UPPER if load.at[1] >= elevation else 0) if by_place else load
        for load, by_place in zip(load_set.loads, load_set.block_by_place, strict=True)
    )


def _panel_of(definition: TwoBlock, whole: Piece, loads: Sequence[Load], *, strength: float) -> WallPanel:
    """Return the box around a wall and the load on its top: forces and bearing masses of the upper block."""
    points = np.concatenate([solid.vertices for solid in whole.solids])
    along = definition.along
    x, y = points @ along, points @ np.array([-along[1], along[0], 0.0])
    upper = [load for load in loads if load.block == UPPER]
    pressing = [(-load.force[1], load.at[0]) for load in upper if isinstance(load, Force)]
    pressing += [(g * load.mass, load.at[0]) for load in upper if isinstance(load, PointMass) and load.bearing]
    overburden = sum(force for force, _ in pressing)
    moment = sum(force * at for force, at in pressing)
    middle = float(x.min() + x.max()) / 2.0
    return WallPanel(
        low=float(x.min()),
        high=float(x.max()),
        length=float(np.ptp(y)),
        base=float(points[:, 2].min()),
        height=float(np.ptp(points[:, 2])),
        weight=whole.body.mass * g,
        strength=strength,
        overburden=overburden,
        place=moment / overburden if overburden > 0.0 else middle,
    )


def _crack_by_formula(
    definition: TwoBlock, whole: Piece, load_set: LoadSet, *, strength: float
) -> tuple[float, Message]:
    """Find the crack by eq. 3.27 with the loads above it: elevation [m] and how it was found.

    The crack depends on what stands above it, and that on the crack: each set of loads is tried that a crack can leave
    above it. Where more than one agrees with its own crack, the one of the least uplift multiplier counts.

    Raises CrackError where none does, or where one puts the crack at the very top.
    """
    found = list(_consistent_cracks(definition, whole, load_set, strength=strength))
    if not found:
        raise CrackError(
            'crack = "sorrentino": wherever the formula puts the crack, other loads stand above it than it was found '
            "with; give a crack elevation"
        )
    _, elevation, notice = min(found, key=lambda each: each[:2])
    return elevation, notice


def _consistent_cracks(
    definition: TwoBlock, whole: Piece, load_set: LoadSet, *, strength: float
) -> Iterator[tuple[float, float, Message]]:
    """Find the cracks by eq. 3.27 that agree with the loads above them: uplift multiplier, elevation, and how.

    A load within MARGIN of the top stands on it.
    """
    heights = sorted(
        {load.at[1] for load, by_place in zip(load_set.loads, load_set.block_by_place, strict=True) if by_place}
    )
    for lowest, next_one in pairwise((-inf, *heights, inf)):
        loads = _loads_above(load_set, next_one)
        panel = _panel_of(definition, whole, loads, strength=strength)
        on_top = panel.base + (1.0 - MARGIN) * panel.height
        if lowest > on_top:
            return
        try:
            elevation, notice = _crack_of_panel(panel, sides="two" if definition.two_sided else "one")
        except CrackError:
            if next_one < on_top:
                continue
            raise
        if lowest < elevation <= next_one:
            yield _cracked_multiplier(definition, whole, panel, loads, elevation), elevation, notice


def _crack_of_panel(panel: WallPanel, *, sides: str) -> tuple[float, Message]:
    """Find the crack by eq. 3.27, or by its general form for an eccentric load: elevation [m] and how it was found.

    Where the wall rocks to both sides the load is taken at the face that is worse.
    """
    n, t = panel.overburden / panel.weight, panel.tension / panel.weight
    ahead = (panel.high - panel.place) / panel.thickness
    place = max(ahead, 1.0 - ahead) if sides == "two" else ahead
    try:
        ratio = crack_ratio(load=n, tension=t, place=place)
    except CrackError as error:
        raise CrackError(
            f'crack = "sorrentino": {error}; give an overburden load, the material\'s tensile_strength, a crack '
            "elevation, or hinges"
        ) from None
    elevation = panel.base + ratio * panel.height
    values: dict[str, Value] = {
        "z": Quantity(elevation, "length"),
        "share": Quantity(ratio, figures=3),
        "load": Quantity(n, figures=3),
        "tension": Quantity(t, figures=3),
    }
    if abs(place - 0.5) > 1e-9:
        return elevation, warning("crack-by-general-formula", place=Quantity(place, figures=3), **values)
    return elevation, warning("crack-by-formula", **values)


def _crack_by_search(
    definition: TwoBlock, whole: Piece, load_set: LoadSet, *, strength: float
) -> tuple[float, Message]:
    """Find the crack of least uplift multiplier: elevation [m] and how it was found.

    The multiplier jumps where the crack passes a load, from one block to the other; there it is looked for on both
    sides, out of reach of the contact.
    """
    panel = _panel_of(definition, whole, _loads_above(load_set, -inf), strength=strength)

    def multiplier(elevation: float) -> float:
        return _cracked_multiplier(definition, whole, panel, _loads_above(load_set, elevation), elevation)

    jumps = [load.at[1] for load, by_place in zip(load_set.loads, load_set.block_by_place, strict=True) if by_place]
    elevation = find_least_multiplier(
        multiplier, low=panel.base, high=panel.base + panel.height, jumps=jumps, apart=2.0 * CONTACT_TOLERANCE
    )
    ratio = (elevation - panel.base) / panel.height
    found = warning(
        "crack-of-least-multiplier-with-tension" if panel.tension else "crack-of-least-multiplier",
        z=Quantity(elevation, "length"),
        share=Quantity(ratio, figures=3),
        multiplier=Quantity(multiplier(elevation)),
    )
    return elevation, found


def _cracked_multiplier(
    definition: TwoBlock, whole: Piece, panel: WallPanel, loads: tuple[Load, ...], elevation: float
) -> float:
    """Return the multiplier that opens a crack at an elevation [m], the least of the sides that rock."""
    parts = divide(whole.solids, level_plane(elevation), where="crack")
    blocks = (static_block(parts.below, definition.towards), static_block(parts.above, definition.towards))
    base, joint, head = whole.body.base, base_of_section(parts.foot, direction=definition.towards), top_edge(whole.body)
    assert base is not None  # a piece with solids has a base and a top
    assert head is not None
    found = []
    for ahead in (True, False) if definition.two_sided else (True,):
        hinges = (base[ahead], joint[not ahead], head[ahead])
        chain = Chain(blocks, hinges, loads) if ahead else mirror_chain(blocks, hinges, loads)
        work, turning = virtual_work(chain, np.zeros(1)), move(chain, np.zeros(1)).rate[:, 0]
        resisted = panel.tension * TENSION_ARM * panel.thickness * float(turning[0] - turning[1])
        found.append(float((work.restoring[0] + resisted) / (g * work.excitation[0])))
    return min(found)


def _block_below_crack(parts: Division, whole: Piece, direction: Sequence[float]) -> Piece:
    """Return the lower side of a crack as a block on the base of the whole wall."""
    body = join_bodies([planar_body(solid, direction=direction) for solid in parts.below])
    return replace(whole, body=replace(body, base=whole.body.base), solids=parts.below)


def _split_range(ends: tuple[float, float], jumps: Sequence[float], *, apart: float) -> Iterator[tuple[float, float]]:
    """Split a range at jumps, leaving out what is nearer than `apart` to one."""
    start = ends[0]
    for jump in sorted(each for each in set(jumps) if ends[0] < each + apart and each - apart < ends[1]):
        if jump - apart > start:
            yield start, jump - apart
        start = max(start, jump + apart)
    if start < ends[1]:
        yield start, ends[1]


WHOLE = 0.95  # of the base of a wall: what bears on it from below reaches both faces
FOOT = 1e-3  # of the height of a body, within which its faces are those of its base


def stands_on_masonry(definition: TwoBlock, bodies: Bodies) -> bool:
    """Return whether masonry or a foundation, drawn below a wall and at least as thick, bears it from face to face.

    A body of another material bears only where it lies on the ground, as the lowest of all: upstairs it is a beam or
    the edge of a slab, on which the reaction does not reach the face. Above a cut the wall stands on its own masonry.

    Parameters
    ----------
    definition : of the wall
    bodies : all that are drawn
    """
    if definition.cut is not None:
        return True
    lower = [bodies[name] for name in definition.blocks[0]]
    walls = [(each.solid, each.material) for each in lower if each.solid is not None]
    others = [each for name, each in bodies.items() if name not in definition.bodies and each.solid is not None]
    ground = min((float(each.solid.vertices[:, 2].min()) for each in bodies.values() if each.solid), default=0.0)
    return bool(walls) and all(
        _borne_area(solid, [each.solid for each in others if each.solid is not None and _bears(each, material, ground)])
        >= WHOLE * _base_area(solid)
        for solid, material in walls
    )


def _bears(below: Body, material: Material | None, ground: float) -> bool:
    """Return whether a body is of the wall's own masonry, or a foundation."""
    assert below.solid is not None
    founded = float(below.solid.vertices[:, 2].min()) <= ground + CONTACT_TOLERANCE
    return founded or (below.material is not None and below.material == material)


def _borne_area(wall: Solid, others: Sequence[Solid]) -> float:
    """Return the area of its base on which other bodies bear a wall [m2]."""
    foot = float(wall.vertices[:, 2].min())
    near = [
        each
        for each in others
        if float(each.vertices[:, 2].min()) < foot <= float(each.vertices[:, 2].max()) + CONTACT_TOLERANCE
    ]
    found = [find_contact(each, wall) for each in near]
    return sum(each.area for each in found if each is not None and each.bearing)


def _base_area(wall: Solid) -> float:
    """Return the area in plan of the faces at the foot of a wall [m2]."""
    corners = wall.vertices[wall.triangles]
    height = float(wall.vertices[:, 2].max() - wall.vertices[:, 2].min())
    at_foot = (corners[:, :, 2] <= wall.vertices[:, 2].min() + FOOT * height).all(axis=1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.abs(normal[at_foot, 2]).sum() / 2.0)
