"""Walls held at base and top: what presses on them, and where they crack."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scipy.constants import g

from assess.errors import CrackError
from assess.geometry.cut import Parts, divide, level
from assess.geometry.planar import base_of_section, planar, top
from assess.geometry.solid import Solid
from assess.loads import Force, Load, PointMass
from assess.mechanisms.chain import Block, Chain, mirrored_chain
from assess.mechanisms.crack import ARM, crack_ratio, least
from assess.mechanisms.motion import move
from assess.mechanisms.two_block import Hinges
from assess.mechanisms.virtual_work import virtual_work
from assess.project import sections
from assess.project.bodies import Piece, as_one, standing_on
from assess.project.overburdens import UPPER
from assess.project.plane import point_in_plane


@dataclass(frozen=True)
class Wall:
    """The two blocks of a wall, all its loads, and what was decided on the way."""

    pieces: tuple[Piece, Piece]
    loads: tuple[Load, ...]
    notices: tuple[str, ...]


@dataclass(frozen=True)
class Panel:
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


def cracked(
    name: str,
    section: sections.TwoBlock,
    pieces: Sequence[Piece],
    content: sections.Content,
    loads: tuple[Load, ...],
    *,
    front: Hinges | None,
) -> Wall:
    """The wall of one table: its two bodies as they are, or one body cut at its crack.

    Raises CrackError where there is nothing to find the crack from, or it does not lie in the wall.
    """
    if len(pieces) == 2:
        return Wall((pieces[0], pieces[1]), loads, ())
    whole = pieces[0]
    if not whole.solids:
        raise CrackError("its body has no geometry to crack; give it a mesh, box or profile, or two bodies")
    strength = content.materials[material_of(section.blocks[0], content)].tensile_strength or 0.0
    panel = panel_of(section, whole, loads, strength=strength)
    crack = section.crack
    if crack is None:
        crack = front[1][1] if front is not None else "sorrentino"
    if crack == "sorrentino":
        elevation, notice = by_formula(panel, sides="two" if section.two_sided else "one")
    elif crack == "minimum":
        elevation, notice = by_search(section, whole, panel, loads)
    else:
        elevation, notice = float(crack), ""
    parts = divide(whole.solids, level(elevation), where=f'mechanism "{name}", crack')
    if not parts.below:
        raise CrackError(f"the crack at z = {elevation:.4g} m is at the foot of the wall; give one above it")
    lower, upper = below(parts, whole, section.towards), standing_on(parts, section.towards)
    return Wall((lower, upper), loads, (notice,) if notice else ())


def material_of(block: Sequence[str], content: sections.Content) -> str:
    """The material of the first body of a block that has geometry."""
    bodies = (content.bodies[name] for name in block)
    return next(body.material for body in bodies if not isinstance(body, sections.DirectBody))


def panel_of(section: sections.TwoBlock, whole: Piece, loads: Sequence[Load], *, strength: float) -> Panel:
    """The box around a wall and the load on it: forces and bearing masses of the upper block, as if at the top."""
    points = np.concatenate([solid.vertices for solid in whole.solids])
    along = np.array(section.towards) / np.linalg.norm(section.towards)
    x, y = points @ along, points @ np.array([-along[1], along[0], 0.0])
    upper = [load for load in loads if load.block == UPPER]
    pressing = [(-load.force[1], load.at[0]) for load in upper if isinstance(load, Force)]
    pressing += [(g * load.mass, load.at[0]) for load in upper if isinstance(load, PointMass) and load.bearing]
    overburden = sum(force for force, _ in pressing)
    moment = sum(force * at for force, at in pressing)
    middle = float(x.min() + x.max()) / 2.0
    return Panel(
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


def by_formula(panel: Panel, *, sides: str) -> tuple[float, str]:
    """The crack by 3.27, or its general form where the load is off the middle: elevation [m] and how it was found.

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
    form = "thesis eq. 3.27"
    if abs(place - 0.5) > 1e-9:
        form = f"the general form of {form}, load at {place:.3g} of the thickness from the edge support"
    return elevation, (
        f"crack at z = {elevation:.4g} m, {ratio:.3f} of the height, by {form}: N / W = {n:.3g}, "
        f"tension f_mt l b / W = {t:.3g}; the formula is for a plain rectangular wall"
    )


def by_search(section: sections.TwoBlock, whole: Piece, panel: Panel, loads: Sequence[Load]) -> tuple[float, str]:
    """The crack of least uplift multiplier: elevation [m] and how it was found."""
    multiplier = partial(uplift, section, whole, panel, tuple(loads))
    elevation = least(multiplier, low=panel.base, high=panel.base + panel.height)
    ratio = (elevation - panel.base) / panel.height
    held = " with the mortar's tension before it opens" if panel.tension else ""
    return elevation, (
        f"crack at z = {elevation:.4g} m, {ratio:.3f} of the height, where the uplift multiplier "
        f"is least, {multiplier(elevation):.4g}{held}"
    )


def uplift(section: sections.TwoBlock, whole: Piece, panel: Panel, loads: tuple[Load, ...], elevation: float) -> float:
    """The multiplier that opens a crack at `elevation` [m], the least of the sides that rock."""
    parts = divide(whole.solids, level(elevation), where="crack")
    blocks = (weight_of(parts.below, section.towards), weight_of(parts.above, section.towards))
    base, joint, head = whole.body.base, base_of_section(parts.foot, direction=section.towards), top(whole.body)
    assert base is not None  # a piece with solids has a base and a top
    assert head is not None
    found = []
    for ahead in (True, False) if section.two_sided else (True,):
        hinges = (base[ahead], joint[not ahead], head[ahead])
        chain = Chain(blocks, hinges, loads) if ahead else mirrored_chain(blocks, hinges, loads)
        work, turning = virtual_work(chain, np.zeros(1)), move(chain, np.zeros(1)).rate[:, 0]
        held = panel.tension * ARM * panel.thickness * float(turning[0] - turning[1])
        found.append(float((work.restoring[0] + held) / (g * work.excitation[0])))
    return min(found)


def weight_of(solids: Sequence[Solid], direction: Sequence[float]) -> Block:
    """Solids that move as one, for statics: mass and centroid in the plane of motion."""
    masses = np.array([solid.mass for solid in solids])
    centre = masses @ np.array([solid.centroid for solid in solids]) / masses.sum()
    return Block(float(masses.sum()), point_in_plane(centre.tolist(), direction), 0.0)


def below(parts: Parts, whole: Piece, direction: Sequence[float]) -> Piece:
    """The lower side of a crack as a block, on the base of the whole."""
    body = as_one([planar(solid, direction=direction) for solid in parts.below])
    return replace(whole, body=replace(body, base=whole.body.base), solids=parts.below)
