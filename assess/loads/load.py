"""What a block carries or is pulled by besides itself: as an engineer states it, and in the plane of motion.

What is stated is declared: numbers are in the SI unit of their dimension, a sentence like "1200 kg" shows how a project
file writes them. A place that is stated is [x, y, z], or (distance along the direction, elevation) [m]; so is a
direction. In the plane of motion places and forces are (distance along the direction, elevation), and a load is fixed
to its block.

A force or tie may end before the mechanism collapses. `until` says when: "collapse" where it is still there then, or
the displacement of its point [m] at which it ends; None where it is not shown to last.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from math import dist, hypot, inf
from typing import Annotated, Any, ClassVar, Literal, TypeGuard, get_args

import numpy as np

from assess.declaration import (
    BOUGHT,
    CHOSEN,
    NO_THEN_YES,
    UNCERTAIN,
    Evidence,
    Fault,
    FileDefault,
    Length,
    Name,
    NotAKey,
    NotNegativeLength,
    Number,
    PositiveAreaMass,
    PositiveForce,
    PositiveLength,
    PositiveMass,
    Safe,
    Share,
    StatedDirection,
    StatedPlace,
)
from assess.geometry.contact import CONTACT_TOLERANCE
from assess.loads.anchorage import STATED_ALONE, Anchorage, Plate
from assess.loads.far_wall import SiteAction
from assess.messages.message import Message, Term
from spectra.arrays import FloatArray
from spectra.gravity import g

NO_BAR = "of which no tie is made; check the value and its unit"
BarModulus = Annotated[float, Number("stress", above=0, least=1e9, most=300e9, beyond=f"not 1 to 300 GPa, {NO_BAR}")]
BarYield = Annotated[float, Number("stress", above=0, least=50e6, most=1.5e9, beyond=f"not 50 to 1500 MPa, {NO_BAR}")]
BarArea = Annotated[float, Number("area", above=0, least=1e-6, most=0.02, beyond=f"not 1 to 20,000 mm^2, {NO_BAR}")]
Spring = Annotated[
    float,
    Number(
        "spring stiffness", above=0, least=1e3, most=1e9, beyond="not 1 kN/m to 1 GN/m; check the value and its unit"
    ),
]
BarStrain = Annotated[float, Number("ratio", above=0, most=0.4)]
LEAST_THREAD, MOST_THREAD = 0.5, 2.0  # times the area of the bar: a thread cut into it, and an end that is upset
LONGER = 1.25
"""Length over which a tie stretches, over the distance of its ends, beyond which the two contradict each other."""

ON_PLANE = 1e-9
"""Part of a vector across the plane of motion that is rounding."""

SAME_END = 0.05
"""Distance up to which ends of ties are one [m]."""

DUCTILE = 1.25
"""Anchorage over yield force of the bar, from which on the bar is taken to yield first."""

Place = tuple[float, ...]
Point = tuple[float, float]
Until = float | Literal["collapse"] | None
Through = Literal["joint", "fixed"] | None
SourceParts = tuple[Term | Message, ...]
VariedKey = tuple[str, Literal["loads", "tie_force"]]
"""The number of a load that a sensitivity and the survey's tolerance vary, and its key in [analysis.sensitivity]."""
LoadFault = tuple[int, str, str]
"""The number of a load, from 0, its key, and what is wrong; remedy."""
StatedUntil = Annotated[
    float | Literal["collapse"],
    Number(
        "length",
        above=0,
        beyond='must be greater than 0; write the displacement of its point at which it ends, or "collapse"',
        form='not a displacement; write that of its point at which it ends, or "collapse"',
    ),
]
StatedForce = Annotated[
    tuple[float, float] | float,
    Number(
        "force",
        above=0,
        beyond="must be greater than 0; turn its direction instead",
        form="not a force; write [along the direction, up], or a size with direction",
    ),
]
BlockNumber = Annotated[int, Number(least=0, most=2)]
WHERE_DRAWN = Evidence("drawn", "either", "as drawn; an unknown eccentricity is a sixth of the thickness outwards")
ITS_BLOCK = Evidence("drawn", "either", "the block that it touches")
ITS_SEAT = Evidence("measured", "up", "absent: SLC is not answered, and a pass at SLV is conditional", safe=Safe.ABSENT)
BY_WHERE_IT_RESTS = "a weight holds a wall down or drives it over, by where it rests"
WHERE_IT_HURTS = Evidence("loads", "either", "nothing where it helps", judged=BY_WHERE_IT_RESTS, safe=Safe.WITHOUT)
AS_ITS_BODY = Evidence("loads", "either", "as its body", judged=BY_WHERE_IT_RESTS, safe=Safe.ABSENT)
ITS_WAY = Evidence("drawn", "either", "as drawn")
ITS_END = Evidence("measured", "up", "absent: it counts in the multiplier alone", safe=Safe.ABSENT)


@dataclass(frozen=True, kw_only=True)
class MassLoad:
    """A point mass: a floor, a roof, a wall that moves with the block."""

    kind: ClassVar[Literal["mass"]] = "mass"
    term: ClassVar[Term] = Term("a point mass that moves with the mechanism")
    varied: ClassVar[VariedKey] = ("mass", "loads")
    mass: Annotated[PositiveMass, UNCERTAIN, WHERE_IT_HURTS]
    """like "1200 kg\""""
    at: Annotated[StatedPlace, WHERE_DRAWN]
    """[x, y, z], or [distance along the direction, elevation]"""
    bearing: Annotated[
        bool,
        Evidence("drawn", "either", "false where the drawing shows no support", judged=BY_WHERE_IT_RESTS),
    ] = True
    """true: weight and inertia; false: its weight is carried elsewhere, horizontal inertia only"""
    seat: Annotated[PositiveLength | None, ITS_SEAT] = None
    """of a bearing mass: how far its point can move along the direction before it falls off, like "0.12 m\""""
    block: Annotated[BlockNumber, ITS_BLOCK] = 0
    """which block it acts on, from 0 at the base"""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        if self.seat is not None and not self.bearing:
            yield "seat", "only what bears on the block has a seat; remove it, or write bearing = true"


@dataclass(frozen=True, kw_only=True)
class ForceLoad:
    """A dead force: the thrust of a vault or roof."""

    kind: ClassVar[Literal["force"]] = "force"
    term: ClassVar[Term] = Term("a given force")
    varied: ClassVar[VariedKey] = ("force", "loads")
    force: Annotated[
        StatedForce, UNCERTAIN, Evidence("loads", "either", "none where it holds the wall", safe=Safe.WITHOUT)
    ]
    """[along the direction, up], or a size with `direction`"""
    at: Annotated[StatedPlace, WHERE_DRAWN]
    """[x, y, z], or [distance along the direction, elevation]"""
    direction: Annotated[StatedDirection | None, ITS_WAY] = None
    """where a force given by its size points: [x, y, z], or [along the direction, up]"""
    until: Annotated[StatedUntil | None, ITS_END] = None
    """where it resists: "collapse" if it is shown to be there up to collapse, with a source in [report.sources]; or the
    displacement of its point at which it ends; if absent it counts in the multiplier alone"""
    block: Annotated[BlockNumber, ITS_BLOCK] = 0
    """which block it acts on, from 0 at the base"""
    evidence: Annotated[str, NotAKey()] = ""
    """where it is shown that it lasts as `until` says; empty where it is not"""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        if not isinstance(self.force, tuple) and self.direction is None:
            yield "direction", "missing; a force given by its size needs one, or write force = [x, z]"
        if isinstance(self.force, tuple) and self.direction is not None:
            yield "direction", "beside components of the force; remove one of them"


@dataclass(frozen=True, kw_only=True)
class TieLoad:
    """A tie: of constant pretension, slack on the branch where it shortens; or, with `area`, a bar that stretches.

    A constant one counts up to collapse only with until = "collapse", strength, length, fracture_strain and a source. A
    bar pulls with its pretension, or from its slack on, and young_modulus area / length for each metre that it
    lengthens, up to area yield_stress; it yields, goes slack when the wall comes back, and breaks at fracture_strain.
    `strength` is then that of its anchorage: below 1.25 times the yield force the bar does not yield first, and the tie
    is gone where it is reached.
    """

    kind: ClassVar[Literal["tie"]] = "tie"
    term: ClassVar[Term] = Term("a tie of given force")
    varied: ClassVar[VariedKey] = ("force", "tie_force")
    at: Annotated[StatedPlace, CHOSEN, WHERE_DRAWN]
    """where it holds the block: [x, y, z], or [distance along the direction, elevation]"""
    force: Annotated[
        PositiveForce | None,
        UNCERTAIN,
        CHOSEN,
        Evidence("measured", "up", "the wall without the tie", safe=Safe.WITHOUT),
    ] = None
    """pretension, like "30 kN"; only a tie that stretches may have none"""
    slack: Annotated[
        NotNegativeLength, CHOSEN, Evidence("measured", "down", "as stated: without it the tie pulls at once")
    ] = 0.0
    """of a tie that stretches: how far its ends move apart before it pulls, like "5 mm"; 0 if absent"""
    direction: Annotated[StatedDirection | None, ITS_WAY] = None
    """the way it pulls: [x, y, z], or [along the direction, up]; or give anchor"""
    anchor: Annotated[StatedPlace | None, CHOSEN, ITS_WAY] = None
    """the fixed end: [x, y, z], or [distance along the direction, elevation]; a tie askew to the motion in plan holds
    with what of its pull lies in the plane of motion"""
    both: Annotated[bool, Evidence("measured", NO_THEN_YES, "false: slack where it shortens", safe=Safe.FIRST)] = False
    """true: taut on both branches"""
    until: Annotated[StatedUntil | None, ITS_END] = None
    """"collapse" if it is shown to be there up to collapse; or the displacement of its point at which it breaks; if
    absent it counts in the multiplier alone"""
    strength: Annotated[
        PositiveForce | None, UNCERTAIN, Evidence("measured", "up", "the wall without the tie", safe=Safe.ABSENT)
    ] = None
    """least of bar, plate, masonry and far wall; it never pulls with more. With `area`: of all but the bar"""
    area: Annotated[
        BarArea | None, UNCERTAIN, CHOSEN, Evidence("measured", "up", "the wall without the tie", safe=Safe.WITHOUT)
    ] = None
    """of the bar's section, like "314 mm^2"; the tie then stretches, by young_modulus and yield_stress, to an anchor"""
    young_modulus: Annotated[
        BarModulus | None, Evidence("measured", "up", "the wall without the tie", safe=Safe.ABSENT)
    ] = None
    """of the bar, like "210 GPa\""""
    yield_stress: Annotated[
        BarYield | None, UNCERTAIN, BOUGHT, Evidence("measured", "up", "the wall without the tie", safe=Safe.ABSENT)
    ] = None
    """of the bar, like "235 MPa\""""
    stiffness: Annotated[
        Spring | None, UNCERTAIN, Evidence("measured", "up", "the wall without the tie", safe=Safe.WITHOUT)
    ] = None
    """in place of a bar: of a floor or another restraint that holds the wall elastically, like "5 MN/m"; where it pulls
    with `strength` it lets go for good"""
    length: Annotated[
        PositiveLength | None, Evidence("drawn", "up", "absent: it does not last to collapse", safe=Safe.ABSENT)
    ] = None
    """of the bar, over which it stretches"""
    fracture_strain: Annotated[
        BarStrain | None, Evidence("measured", "up", "absent: it does not last to collapse", safe=Safe.ABSENT)
    ] = None
    """of the bar; it breaks where it has lengthened by more than this times its length"""
    plate: Annotated[Plate | None, Evidence("measured", "up", STATED_ALONE, safe=Safe.ABSENT)] = None
    """of a tie that stretches, on the outer face of the wall: its anchorage is then computed, and its `strength` is the
    least of that and of what is stated"""
    block: Annotated[BlockNumber, ITS_BLOCK] = 0
    """which block it acts on, from 0 at the base"""
    others: Annotated[tuple[TieLoad, ...], NotAKey()] = ()
    """ties with plates of other mechanisms on the same bodies, whose cones may meet its own"""
    neighbours: Annotated[tuple[TieLoad, ...], NotAKey()] = ()
    """ties with plates of mechanisms on other bodies, which may be anchored in its far wall too"""
    floors: Annotated[tuple[BodyLoad, ...], NotAKey()] = ()
    """bodies that load other mechanisms, and may bear on its far wall"""
    site: Annotated[SiteAction | None, NotAKey()] = None
    """what shakes its far wall, which is not examined without"""
    evidence: Annotated[str, NotAKey()] = ""
    """where it is shown that it lasts as `until` says; empty where it is not"""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        if (self.direction is None) == (self.anchor is None):
            yield "anchor", "give either anchor or direction, the way the tie pulls"
        apart = None
        if self.anchor is not None and len(self.anchor) == len(self.at):
            apart = float(np.linalg.norm(np.subtract(self.anchor, self.at)))
        if apart and self.length is not None and self.length > LONGER * apart:
            yield "length", f"its ends lie {apart:.4g} m apart, over which it stretches; measure it again"
        bar = {key: getattr(self, key) for key in ("area", "young_modulus", "yield_stress")}
        if self.stiffness is not None:
            yield from self._faults_of_spring()
            return
        if all(value is None for value in bar.values()):
            if self.force is None:
                yield "force", "missing; a tie that does not stretch pulls with its pretension"
            for key in ("slack", "plate"):
                if getattr(self, key):
                    yield key, "of a tie that stretches; give area, young_modulus and yield_stress too, or remove it"
            return
        for key, value in {**bar, "length": self.length, "fracture_strain": self.fracture_strain}.items():
            if value is None:
                yield (
                    key,
                    "missing; a tie that stretches needs area, young_modulus, yield_stress, length, fracture_strain",
                )
        if self.plate is not None:
            thread = self.plate.thread_area
            if self.area and thread and not LEAST_THREAD <= thread / self.area <= MOST_THREAD:
                yield (
                    "area",
                    f"{self.area * 1e6:.0f} mm^2, where the thread of its plate has {thread * 1e6:.4g} mm^2, not "
                    f"{LEAST_THREAD:g} to {MOST_THREAD:g} times as much; check both and their units",
                )
            for key in ("at", "anchor"):
                if len(getattr(self, key) or (0, 0, 0)) != 3:
                    yield key, "beside a plate it must be [x, y, z], by which it lies on its wall"
        if self.anchor is None:
            yield "anchor", "missing; a tie that stretches does so towards its fixed end"
        if self.until is not None:
            yield "until", "a tie that stretches ends by its own law; remove until"
        if apart and self.length is not None and self.length * LONGER < apart:
            yield "length", f"its ends lie {apart:.4g} m apart, and a tie that stretches does so over all of them"
        most = min((self.area or inf) * (self.yield_stress or inf), self.strength or inf)
        if self.force is not None and self.slack:
            yield "slack", "a slack tie has no pretension; remove slack, or force"
        if self.force is not None and self.force > most:
            yield "force", f"a pretension above what bar and anchorage bear, {most / 1e3:.4g} kN"

    def _faults_of_spring(self) -> Iterator[Fault]:
        """Yield the keys that do not go with a stiffness."""
        for key in (
            "area",
            "young_modulus",
            "yield_stress",
            "length",
            "fracture_strain",
            "plate",
            "until",
            "direction",
        ):
            if getattr(self, key) is not None:
                yield key, "beside stiffness, which stands for a restraint of no bar; remove one of them"
        for key in ("anchor", "strength"):
            if getattr(self, key) is None:
                yield key, "missing; a restraint of a stiffness acts towards its anchor, up to its strength"
        if self.force is not None and self.slack:
            yield "slack", "a slack tie has no pretension; remove slack, or force"
        if self.force is not None and self.strength is not None and self.force > self.strength:
            yield "force", f"a pretension above its strength, {self.strength / 1e3:.4g} kN"


def share_ends(one: TieLoad, other: TieLoad) -> bool:
    """Return whether two ties have the same ends, and so are one bar.

    Parameters
    ----------
    one, other : as an engineer states them, each with its places in space or in its own plane
    """
    pairs = ((one.at, other.at), (one.anchor, other.anchor))
    return one.direction == other.direction and all(
        a is b if a is None or b is None else len(a) == len(b) and dist(a, b) <= SAME_END for a, b in pairs
    )


@dataclass(frozen=True, kw_only=True)
class OverburdenLoad:
    """What presses on the top of a wall of two blocks: a dead vertical load, without mass of its own."""

    kind: ClassVar[Literal["overburden"]] = "overburden"
    term: ClassVar[Term] = Term("a load on the top of a cracked wall")
    varied: ClassVar[VariedKey] = ("force", "loads")
    force: Annotated[PositiveForce | None, UNCERTAIN, WHERE_IT_HURTS] = None
    """vertical load, like "40 kN\""""
    bodies: Annotated[tuple[Name, ...], Evidence("drawn", "either", "as drawn")] = ()
    """or what stands on the wall: its weight, by its share, where it touches"""
    eccentricity: Annotated[Length | None, Evidence("loads", "either", "a sixth of the thickness outwards")] = None
    """of the load from mid-thickness of the top towards `direction`; 0, or where the bodies touch, if absent"""
    through: Annotated[
        Through,
        Evidence(
            "measured",
            ("fixed", "joint"),
            "fixed",
            judged="a load that moves to the edge that closes rights the wall",
            safe=Safe.FIRST,
        ),
    ] = None
    """"joint": it presses where the top does, from mid-thickness to the edge as the wall turns (rigid: at hinge C);
    "fixed": it stays in its place on the wall; if absent "joint" on the middle of a joint at C, else "fixed\""""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        if (self.force is None) == (not self.bodies):
            yield "force", "give either force, or the bodies that press"
        if self.through == "joint" and self.eccentricity:
            reason = 'a load through the joint presses where the joint does; remove eccentricity, or write "fixed"'
            yield "through", reason


@dataclass(frozen=True, kw_only=True)
class BodyLoad:
    """A floor, roof or vault given as a body: what it puts on the block is found where it touches it."""

    kind: ClassVar[Literal["body"]] = "body"
    term: ClassVar[Term] = Term("a floor, roof or vault that bears on a block")
    varied: ClassVar[VariedKey] = ("mass", "loads")
    body: Annotated[Name, Evidence("drawn", "either", "as drawn")]
    """the name of a table [bodies.NAME] that is not part of the block"""
    role: Annotated[Literal["floor", "roof", "vault"], Evidence("drawn", "either", "as its faces show")] = "floor"
    """"floor" (weight), or "roof" or "vault" (weight and thrust)"""
    tolerance: Annotated[PositiveLength, Evidence("clamped", "either", "the default")] = CONTACT_TOLERANCE
    """faces this near each other touch"""
    share: Annotated[
        Share | None, Evidence("loads", "either", "by statics from what else carries it", safe=Safe.ABSENT)
    ] = None
    """part of the body that this block carries, in (0, 1]; by statics from what else carries it if absent"""
    bearing: Annotated[bool | None, Evidence("drawn", "either", "as the contact shows", safe=Safe.ABSENT)] = None
    """true: the block carries weight; false: it is only pushed; as the contact shows if absent"""
    seat: Annotated[PositiveLength | None, ITS_SEAT] = None
    """how far the contact can move along the direction before the body falls off the block, like "0.12 m\""""
    at: Annotated[StatedPlace | None, WHERE_DRAWN] = None
    """where it acts: [x, y, z], or [distance along the direction, elevation]; centroid of the contact if absent"""
    mass: Annotated[PositiveMass | None, UNCERTAIN, AS_ITS_BODY] = None
    """of the whole body; its volume times the density of its material if absent"""
    thrust: Annotated[
        PositiveForce | None,
        UNCERTAIN,
        Evidence("loads", "down", "from its shape, where that is more", safe=Safe.ABSENT),
    ] = None
    """of a roof or vault on this block, along the direction of motion, outwards; from its shape if absent"""
    span: Annotated[PositiveLength | None, Evidence("drawn", "down", "from its bounding box", safe=Safe.ABSENT)] = None
    """of a roof or vault along its thrust; from its bounding box if absent"""
    rise: Annotated[PositiveLength | None, Evidence("drawn", "up", "from its bounding box", safe=Safe.ABSENT)] = None
    """of the ridge or crown above the springing; from the bounding box if absent"""
    tied: Annotated[
        bool | None, FileDefault(False), Evidence("loads", NO_THEN_YES, "false: its thrust acts", safe=Safe.FIRST)
    ] = None
    """true: ties or tie-beams take the thrust"""
    vault: Annotated[
        Literal["barrel", "quadripartite"] | None, Evidence("drawn", "either", "as the faces of the mesh show")
    ] = None
    """as the faces of the mesh show if absent"""
    construction: Annotated[int | None, Number(least=1, most=5), AS_ITS_BODY] = None
    """weight of a vault by Ungewitter's case 1 to 5 over its intrados, in place of the mesh's volume"""
    fill: Annotated[PositiveAreaMass | None, UNCERTAIN, AS_ITS_BODY] = None
    """fill and plaster over the plan of a vault, beside its own weight, like "80 kg/m^2\""""
    block: Annotated[BlockNumber | None, ITS_BLOCK] = None
    """which block it acts on, from 0 at the base; if absent the one that it touches, or all that it bears on"""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        for key in ("thrust", "span", "rise", "tied"):
            if self.role == "floor" and getattr(self, key) is not None:
                yield key, 'only a roof or a vault has a thrust; write role = "roof" or "vault", or remove it'
        for key in ("vault", "construction", "fill"):
            if self.role != "vault" and getattr(self, key) is not None:
                yield key, 'only of a vault; write role = "vault", or remove it'
        instead = {"thrust": ("tied", "span", "rise"), "mass": ("construction", "fill")}
        for number, keys in instead.items():
            for key in keys:
                if getattr(self, key) and getattr(self, number) is not None:
                    yield key, f"beside {number}, which leaves nothing for it to say; remove one of them"


LoadDefinition = MassLoad | ForceLoad | TieLoad | OverburdenLoad | BodyLoad
LOADS: dict[str, type[LoadDefinition]] = {kind.kind: kind for kind in get_args(LoadDefinition)}
"""The loads by their kinds, as project files write them. What follows reads them and their tables alike."""


def direction_keys(load: Any) -> Iterator[str]:
    """Name what of a load is measured along the direction of motion: points of two numbers, eccentricities."""
    for key in ("force", "at", "direction", "anchor"):
        value = getattr(load, key, None)
        if isinstance(value, tuple) and len(value) == 2:
            yield key
    if getattr(load, "eccentricity", None):
        yield "eccentricity"


def bodies_of(load: LoadDefinition) -> tuple[str, ...]:
    """Return the names of the bodies that a load stands for."""
    body: str | None = getattr(load, "body", None)
    bodies: tuple[str, ...] = getattr(load, "bodies", ())
    return bodies if body is None else (body, *bodies)


def block_faults(loads: Sequence[LoadDefinition], kind: str, *, number_of_blocks: int) -> Iterator[LoadFault]:
    """Yield the loads that no block of a mechanism carries.

    Parameters
    ----------
    loads : as they stand in the mechanism
    kind, number_of_blocks : of the mechanism
    """
    last = number_of_blocks - 1
    for number, load in enumerate(loads):
        if load.kind == "overburden":
            if kind != "two-block":
                yield number, "kind", "is for two-block mechanisms; use a mass or a force"
        elif load.block is not None and load.block > last:
            yield number, "block", f"must be {last} or less, counted from 0 at the base"


def body_faults(
    loads: Sequence[LoadDefinition], bodies: Collection[str], *, moving: Collection[str], known: str
) -> Iterator[LoadFault]:
    """Yield the loads whose bodies do not exist, are part of the mechanism, or load the same block already.

    Parameters
    ----------
    loads : as they stand in the mechanism
    bodies : the names of all bodies; moving : of those that are part of the mechanism
    known : what an error says of the bodies that could be named
    """
    taken: dict[str, set[int | None]] = {}
    for number, load in enumerate(loads):
        if load.kind == "overburden" and not set(load.bodies) <= set(bodies) - set(moving):
            yield number, "bodies", f"no body beside the wall; {known}"
        if load.kind != "body":
            continue
        if load.body not in bodies:
            yield number, "body", f"no such body; {known}"
        blocks = taken.setdefault(load.body, set())
        if load.body in moving or load.block in blocks:
            yield number, "body", "it is part of a block, or a load of this block already; name another body"
        if blocks and (load.block is None or None in blocks):
            yield number, "body", "it is listed twice; give each of the entries its block, or keep one without"
        blocks.add(load.block)


def source_phrase(parts: SourceParts) -> str:
    """Return the parts of a source in one English phrase."""
    return "; ".join(map(str, parts))


@dataclass(frozen=True)
class PointMass:
    """A floor, roof or wall that moves with the block at one point.

    mass [kg]; bearing: the block carries its weight, and it shares all its motion; not bearing: its weight is carried
    elsewhere, and only its horizontal inertia acts on the block (thesis 3.2.2, M_i and M_j).
    seat : horizontal displacement of its point at which it falls off the block [m]; None where it is not given.
    """

    name: str
    mass: float
    at: Point
    bearing: bool
    block: int = 0
    source_parts: SourceParts = ()
    seat: float | None = None

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.source_parts)


@dataclass(frozen=True)
class Force:
    """A dead force (x, z) [N] of constant size and direction: the thrust of a vault or roof.

    evidence : where it is shown that it lasts as `until` says; empty where it is not.
    """

    name: str
    force: Point
    at: Point
    block: int = 0
    source_parts: SourceParts = ()
    until: Until = None
    evidence: str = ""

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.source_parts)

    @property
    def missing(self) -> tuple[str, ...]:
        """The keys of the project file that are missing before it counts as lasting to collapse."""
        return _missing_keys({"until": self.until, "source": self.evidence})


@dataclass(frozen=True)
class Tie:
    """A tie of constant pretension `pull` [N] along `direction` (a unit vector), or always towards `anchor`.

    It is slack on the branch where it shortens, unless `both`. One with a stiffness k [N/m] and the force [N] at which
    its bar yields pulls with pull + k (e - slack), e its elongation from rest, between zero and that force.
    aside : how far its anchor lies out of the plane of motion through its point [m], across which nothing moves
    slack : by which its ends move apart before it pulls [m]; it then has no pretension
    strength : least of bar, plate, masonry and far wall [N], above which it never pulls; of one that stretches, of all
        but the bar
    anchorage : its plate in its place, of which that is the strength; None where the strength is stated alone
    length, fracture_strain : of the bar [m], [-]; it ends where it has lengthened by more than their product
    evidence : where it is shown that it lasts as `until` says; empty where it is not
    """

    name: str
    pull: float
    at: Point
    direction: Point | None = None
    anchor: Point | None = None
    both: bool = False
    block: int = 0
    source_parts: SourceParts = ()
    until: Until = None
    strength: float | None = None
    length: float | None = None
    fracture_strain: float | None = None
    evidence: str = ""
    stiffness: float | None = None
    yield_force: float | None = None
    slack: float = 0.0
    anchorage: Anchorage | None = None
    aside: float = 0.0

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.source_parts)

    @property
    def is_spring(self) -> bool:
        """Whether it is a restraint of a stiffness and no bar: at its strength it lets go."""
        return self.stiffness is not None and self.length is None

    @property
    def tension(self) -> float:
        """The force with which it pulls at rest [N]: its pretension, and never more than its strength."""
        return min(self.pull, self.most)

    @property
    def most(self) -> float:
        """The force that it never exceeds [N]: the lesser of bar and anchorage; inf where neither is known."""
        return min(each for each in (self.yield_force, self.strength, inf) if each is not None)

    @property
    def ductile(self) -> bool:
        """Whether the bar of a tie that stretches yields before its anchorage fails, with DUCTILE to spare."""
        return self.strength is not None and self.strength >= DUCTILE * (self.yield_force or 0.0)

    @property
    def elongation(self) -> float | None:
        """The elongation from rest at which it breaks, or its anchorage fails [m]; None if that is not known."""
        if self.is_spring:
            return self.elastic_elongation
        if self.length is None or self.fracture_strain is None:
            return None
        if self.stiffness is None:
            return self.length * self.fracture_strain
        return self.elastic_elongation + self.length * self.fracture_strain * self.ductile

    @property
    def elastic_elongation(self) -> float:
        """The elongation from rest at which a tie that stretches pulls with the most that it can [m]."""
        return self.slack + (self.most - self.tension) / (self.stiffness or inf)

    def pull_at(self, elongation: FloatArray) -> FloatArray:
        """Return the force of a tie that stretches as it first does [n] [N], before it breaks.

        Parameters
        ----------
        elongation : from rest, negative where it shortens [n] [m]
        """
        return np.clip(self.tension + (self.stiffness or 0.0) * (elongation - self.slack), 0.0, self.most)

    @property
    def missing(self) -> tuple[str, ...]:
        """The keys of the project file that are missing before it counts as lasting to collapse."""
        keys = ("strength",) if stretches(self) else ("until", "strength", "length", "fracture_strain")
        if self.anchorage is not None:
            return (*self.anchorage.missing, *_missing_keys({"source": self.evidence}))
        return _missing_keys({**{key: getattr(self, key) for key in keys}, "source": self.evidence})


ForceOrTie = Force | Tie
Load = PointMass | Force | Tie


def stretches(load: Load) -> TypeGuard[Tie]:
    """Return whether a load is a tie whose force follows its elongation."""
    return isinstance(load, Tie) and load.stiffness is not None


def pull_at_rest(tie: Tie) -> Point:
    """Return the force (x, z) [N] of a taut tie at rest."""
    if tie.anchor is None:
        along, up = tie.direction or (0.0, 0.0)
        return (tie.tension * along + 0.0, tie.tension * up + 0.0)
    to_x, to_z = tie.anchor[0] - tie.at[0], tie.anchor[1] - tie.at[1]
    length = hypot(to_x, to_z, tie.aside)
    return (tie.tension * to_x / length + 0.0, tie.tension * to_z / length + 0.0)


def length_to_anchor(tie: Tie, to_x: FloatArray, to_z: FloatArray) -> FloatArray:
    """Return the distance of the ends of a tie in space [n] [m], by what of it lies in the plane of motion.

    Parameters
    ----------
    tie : with an anchor
    to_x, to_z : from its point to its anchor, in the plane of motion [n] [m]
    """
    return np.asarray(np.hypot(np.hypot(to_x, to_z), tie.aside))


def lasts(action: ForceOrTie) -> bool:
    """Return whether it is shown to last to collapse (NTC 2018, C8.7.1.2.1.6), but for a tie's fracture strain."""
    until = "collapse" if stretches(action) else action.until
    return until == "collapse" and not action.missing


def upward(load: Load) -> float:
    """Return the vertical force of a load at rest, up [N]."""
    if isinstance(load, PointMass):
        return -g * load.mass * load.bearing
    return (load.force if isinstance(load, Force) else pull_at_rest(load))[1]


def mirror_load(load: Load) -> Load:
    """Return the load as the negative branch sees it."""
    at = _mirror_vector(load.at)
    if isinstance(load, PointMass):
        return replace(load, at=at)
    if isinstance(load, Force):
        return replace(load, at=at, force=_mirror_vector(load.force))
    return replace(
        load,
        at=at,
        direction=None if load.direction is None else _mirror_vector(load.direction),
        anchor=None if load.anchor is None else _mirror_vector(load.anchor),
    )


def _missing_keys(shown: dict[str, object]) -> tuple[str, ...]:
    return tuple(key for key, value in shown.items() if value is None or value == "")


def _mirror_vector(vector: Point) -> Point:
    return (-vector[0], vector[1])


def point_in_plane(at: Sequence[float], direction: Sequence[float]) -> Point:
    """Return a place in the plane of motion: (distance along the direction from the origin, elevation) [m].

    Parameters
    ----------
    at : [x, y, z], or two numbers that are in the plane already [m]
    direction : of the motion, horizontal [3]
    """
    if len(at) == 2:
        return (at[0], at[1])
    along = np.asarray(direction) / np.linalg.norm(direction)
    return (float(np.asarray(at) @ along), at[2])


def out_of_plane(vector: Sequence[float], direction: Sequence[float]) -> float:
    """Return the part of a vector across the plane of motion; 0 of one that is given in it.

    Parameters
    ----------
    vector : [x, y, z], or (along the direction, up)
    direction : of the motion, horizontal [3]
    """
    if len(vector) == 2:
        return 0.0
    along = np.asarray(direction) / np.linalg.norm(direction)
    across = float(along[0] * vector[1] - along[1] * vector[0])
    return across if abs(across) > ON_PLANE * float(np.linalg.norm(vector)) else 0.0


def unit_in_plane(vector: Sequence[float], direction: Sequence[float]) -> Point:
    """Return the part of a unit vector in the plane of motion.

    Parameters
    ----------
    vector : [x, y, z], or (along the direction, up); of any length
    direction : of the motion, horizontal [3]
    """
    x, z = point_in_plane(vector, direction)
    return (x / float(np.linalg.norm(vector)), z / float(np.linalg.norm(vector)))
