"""The anchorage of a tie: a plate on the wall, what it grips, and what holds the other end.

    far end  =============== bar ===============[|   N --->  pulls the plate into the leaf that it grips
                                            ____/|
                        cone of 45 degrees |  t  |   it punches along the faces of a cone through that leaf,
                                           |     |   under the weight above, where it does not meet an edge

Each function is one way to fail and returns the force N at which it does [N]. Most of them are derivations of our own:
no clause of NTC 2018 or of its Circolare gives a formula for the plates of ties. Strengths of masonry are divided by
gamma_M and FC. What is not given is not answered, with the keys that it lacks; the least of what is answered, and of a
strength that is stated, is that of the anchorage.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from math import ceil, inf, isfinite, pi
from typing import Annotated, Literal

import numpy as np
import shapely

from assess.declaration import (
    BOUGHT,
    UNCERTAIN,
    Evidence,
    Fault,
    MasonryStrength,
    Name,
    NotAKey,
    Number,
    PositiveLength,
    RatioToOne,
)
from assess.loads.far_wall import NOT_DRAWN, FarEnd, FarWall

GAMMA_M = 2.0  # of existing masonry in seismic checks (Circolare 7/2019, C8.7.1)
GAMMA_M0, GAMMA_M2 = 1.05, 1.25  # of steel: yield and fracture (NTC 2018, table 4.2.VII)
THREAD = 0.9  # k_2, of a thread in tension (EN 1993-1-8 table 3.4)
LEAST_KNOWLEDGE = 1.35  # FC of LC1
RISING = 0.4  # share of the vertical motion that acts with the horizontal one
VERTICAL = 1.0  # |w_g''| / g, which no vertical motion of a design spectrum exceeds
CLOSE = 3.0  # m: ties no farther apart hold the wall between them
LEVEL = 1.0  # m: plates whose centres lie within it are of one row
SLICES = 24  # of the depth of a cone, by the middle of each
COARSE = 4  # slices by which the ways are found, of those that a cone may run out, that can leave it least
SLIGHT = 0.01  # of the yield force of a bar, below which a far wall holds nothing
NO_FAR_WALL = "a far wall that holds"
FEW = 4  # such ways: those that leave it least by these slices
ON_EDGE = 1e-6  # m: a side this near an edge lies on it

NO_PLATE = "of which no plate is made; check the value and its unit"
PlateSide = Annotated[float, Number("length", above=0, least=0.02, most=3.0, beyond=f"not 20 mm to 3 m, {NO_PLATE}")]
PlateDepth = Annotated[float, Number("length", above=0, least=1e-3, most=0.2, beyond=f"not 1 to 200 mm, {NO_PLATE}")]
SteelStress = Annotated[
    float, Number("stress", above=0, least=50e6, most=1.5e9, beyond=f"not 50 to 1500 MPa, {NO_PLATE}")
]
SteelArea = Annotated[float, Number("area", above=0, least=1e-6, most=0.02, beyond=f"not 1 to 20,000 mm^2, {NO_PLATE}")]
ShearStrength = Annotated[
    float,
    Number(
        "stress",
        above=0,
        most=0.5e6,
        beyond="must be greater than 0 and 0.5 MPa or less: of masonry in shear without compression",
    ),
]
BondStrength = Annotated[
    float,
    Number(
        "stress",
        above=0,
        most=1e6,
        beyond="must be greater than 0 and 1 MPa or less: of grout around a hole in masonry",
    ),
]
Compression = Annotated[
    float,
    Number(
        "stress", least=0, most=1e6, beyond="not 0 to 1 MPa, which no wall has at a plate; check the value and its unit"
    ),
]
AnchorForce = Annotated[
    float,
    Number(
        "force",
        above=0,
        most=1e6,
        beyond="not above 0 and up to 1 MN, which no wall bears; check the value and its unit",
    ),
]
HoleWidth = Annotated[
    float, Number("length", above=0, least=0.01, most=0.2, beyond="not 10 to 200 mm, which no hole of a bar has")
]
Embedment = Annotated[
    float, Number("length", above=0, most=2.0, beyond="not above 0 and up to 2 m, which no wall is thicker than")
]
NUT_SHARE = 0.5  # of the lesser side of a plate, above which its nut, washer or rib is not one of it
STATED_ALONE = "the stated strength alone"
AS_SURVEYED = Evidence("measured", "up", STATED_ALONE)  # where no source vouches for it, the table is left out


@dataclass(frozen=True, kw_only=True)
class Plate:
    """The plate of a tie on the outer face of the wall, what it presses on, and what holds the other end."""

    width: Annotated[PlateSide | None, BOUGHT, AS_SURVEYED] = None
    """level side of a rectangular plate, or of a bar in place of one, like "300 mm\""""
    height: Annotated[PlateSide | None, BOUGHT, AS_SURVEYED] = None
    """upright side of a rectangular plate"""
    diameter: Annotated[PlateSide | None, BOUGHT, AS_SURVEYED] = None
    """of a round plate"""
    thickness: Annotated[PlateDepth | None, BOUGHT, AS_SURVEYED] = None
    """of the plate, like "15 mm\""""
    yield_stress: Annotated[SteelStress | None, BOUGHT, AS_SURVEYED] = None
    """of the plate, like "235 MPa\""""
    nut: Annotated[PositiveLength | None, BOUGHT, AS_SURVEYED] = None
    """width of the nut, washer or rib that the plate bends about"""
    thread_area: Annotated[SteelArea | None, BOUGHT, AS_SURVEYED] = None
    """weakest section of the bar's end: of its thread or key hole; more than the bar's where the end is upset"""
    tensile_strength: Annotated[SteelStress | None, BOUGHT, AS_SURVEYED] = None
    """of the bar, f_u, like "360 MPa\""""
    shear_strength: Annotated[ShearStrength | None, UNCERTAIN, AS_SURVEYED] = None
    """of the masonry without compression, f_v0, like "0.02 MPa\""""
    friction: Annotated[RatioToOne, UNCERTAIN, AS_SURVEYED] = 0.0
    """mu, with which the weight above adds to f_v0, like 0.4; 0, no part of it, if absent"""
    normal_stress: Annotated[Compression | None, AS_SURVEYED] = None
    """in the wall at the plate, least in the earthquake; if absent 0.6 of the weight of the masonry above the cone"""
    bearing_strength: Annotated[MasonryStrength | None, UNCERTAIN, AS_SURVEYED] = None
    """of the masonry across the face of the wall, f_h: tested, else half of its strength in compression"""
    course: Annotated[PositiveLength | None, AS_SURVEYED] = None
    """height of a course of the masonry, with its bed, like "0.15 m"; with `overlap` units that slide are examined"""
    overlap: Annotated[PositiveLength | None, AS_SURVEYED] = None
    """of units on those of the course below, like "0.10 m\""""
    leaf: Annotated[PositiveLength | None, AS_SURVEYED] = None
    """thickness of the leaf that the plate grips, no more than is drawn; that of the drawn body if absent"""
    between: Annotated[AnchorForce | None, AS_SURVEYED] = None
    """pull of the tie that the wall between it and the next one, or its end, can bring to it, by a calculation of its
    own; needed where that is farther than 3 m between ties, or 1.5 m to an end, and no arch spans it: none does beside
    the outermost tie of a row"""
    far_strength: Annotated[AnchorForce | None, AS_SURVEYED] = None
    """of what holds the other end: plate, masonry and wall there; or hole, embedment and bond_strength"""
    far_wall: Annotated[Name | None, Evidence("drawn", "either", "the upright body in which the anchor lies")] = None
    """name of the body in which the anchor lies, which is looked for if absent: that it turns inwards is examined"""
    hole: Annotated[HoleWidth | None, BOUGHT, AS_SURVEYED] = None
    """diameter of the hole of an injected far end"""
    embedment: Annotated[Embedment | None, BOUGHT, AS_SURVEYED] = None
    """length of an injected far end in its wall"""
    bond_strength: Annotated[BondStrength | None, AS_SURVEYED] = None
    """of grout and masonry around that hole, tested"""
    confidence: Annotated[float, NotAKey()] = LEAST_KNOWLEDGE
    """FC, that of the level of knowledge"""

    @property
    def sides(self) -> tuple[float, float]:
        """Width and height of what is around it [m]."""
        return (self.diameter, self.diameter) if self.diameter else (self.width or 0.0, self.height or 0.0)

    @property
    def overhang(self) -> float | None:
        """The longest arm of the plate beyond what it bends about, c [m]."""
        return None if self.nut is None else (max(self.sides) - self.nut) / 2.0

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        for key in ("width", "height"):
            if (getattr(self, key) is None) == (self.diameter is None):
                yield key, "give width and height of a rectangular plate, or diameter of a round one"
        if self.nut is not None and self.nut > NUT_SHARE * min(self.sides):
            yield "nut", "wider than half of the plate's lesser side; give the width of nut, washer or rib"
        for key, other in (("course", "overlap"), ("overlap", "course")):
            if getattr(self, key) is None and getattr(self, other) is not None:
                yield key, f"missing; units that slide on their beds need it beside {other}"
        injected = {key: getattr(self, key) for key in ("hole", "embedment", "bond_strength")}
        if any(injected.values()):
            for key, value in injected.items():
                if value is None:
                    yield key, "missing; an injected far end needs hole, embedment and bond_strength"
            if self.far_strength is not None:
                yield "far_strength", "beside an injected far end; remove one of them"


LinkName = Literal["thread", "plate", "bearing", "punching", "sliding", "between", "far end", "far wall"]


@dataclass(frozen=True)
class Link:
    """One way in which an anchorage fails.

    strength : pull at which it does [N]; inf where it never does, None where that is not answered
    missing : the keys of the project file that would answer it
    """

    name: LinkName
    strength: float | None
    missing: tuple[str, ...] = ()


@dataclass(frozen=True)
class PlateSite:
    """Where a plate sits, by the drawing.

    leaf : thickness of the leaf behind it [m]; None without geometry
    bearing_area : of the plate, as far as there is masonry behind it [m2]
    beds : of the beds above and below what it presses, the part that is in the wall, from 0 to 2
    surface : of the cone that it punches, of itself and of its group, seen along the depth [m2]; None without geometry
    group : how many plates punch with it, itself among them: of those whose cones meet, as many as leave it least
    weights : weight of the masonry above either, over the leaf's area: of the least of the columns above it [Pa]
    bay : farthest distance to the next tie of its row, or twice that to the end of the wall [m]; None if not known
    at_end : whether that is to an end, or beside the outermost tie, beyond which nothing takes the thrust of an arch
    meeting : plates whose cones meet its own, or that of another of them, itself among them
    """

    leaf: float | None
    bearing_area: float
    surface: tuple[float, float] | None
    group: int
    weights: tuple[float, float]
    bay: float | None
    at_end: bool
    meeting: int = 1
    beds: float = 2.0


@dataclass(frozen=True)
class Anchorage:
    """A plate in its place.

    bar_area, bar_yield : section [m2] and yield stress [Pa] of the bar
    stated : strength that is stated beside it [N]; None if not
    far_wall : the wall at the other end as a mechanism of its own; None where that is not examined
    far_end : what else is known of that wall
    """

    plate: Plate
    site: PlateSite
    bar_area: float
    bar_yield: float
    stated: float | None = None
    far_wall: FarWall | None = None
    far_end: FarEnd = NOT_DRAWN

    @property
    def leaf(self) -> float | None:
        """Thickness of the leaf that it grips [m]."""
        return self.site.leaf if self.plate.leaf is None else self.plate.leaf

    @property
    def cone(self) -> tuple[float, int, float]:
        """Surface of the cone that bears least for each of its plates [m2], their number, and the weight above [Pa]."""
        if self.site.surface is None:
            return 0.0, 1, 0.0
        cones = zip(self.site.surface, (1, self.site.group), self.site.weights, strict=True)
        return min(cones, key=lambda each: punching_strength(self.plate, *each))

    @property
    def normal_stress(self) -> float:
        """Least compression of the wall around the cone in the earthquake [Pa]."""
        return compression(self.plate, self.cone[2])

    @property
    def sliding_surface(self) -> float:
        """Beds on which the units under the plate slide inwards, where their sizes are given [m2]."""
        width, height = self.plate.sides
        n, o, t = courses_under(height, self.plate.course or inf), self.plate.overlap or 0.0, self.leaf or 0.0
        return sliding_surface(a=width, t=t, n=n, o=o, beds=self.site.beds)

    @property
    def strip(self) -> float:
        """Height of the strip of wall that a tie holds [m]: its plate, and 45 degrees above and below."""
        return self.plate.sides[1] + 2.0 * (self.leaf or 0.0)

    @property
    def links(self) -> tuple[Link, ...]:
        """Every way in which it fails, from the bar's thread to the far wall."""
        return tuple(_links(self))

    @property
    def missing(self) -> tuple[str, ...]:
        """The keys that are missing before all ways are answered, unless a strength is stated; or a far wall."""
        lacking = dict.fromkeys(key for link in self.links for key in link.missing)
        return tuple(key for key in lacking if key == NO_FAR_WALL or not self.stated)

    @property
    def far_wall_holds(self) -> bool:
        """Whether the far wall, where it is examined, holds more than a slight part of what the bar bears."""
        return self.far_wall is None or self.far_wall.strength >= SLIGHT * self.bar_area * self.bar_yield

    @property
    def strength(self) -> float | None:
        """The least of what is answered and stated [N]; None where something is neither."""
        known = [link.strength for link in self.links if link.strength is not None]
        if self.missing:
            return None
        return min([*known, inf if self.stated is None else self.stated])

    @property
    def governing(self) -> LinkName | None:
        """The way in which it fails first; None where that is the stated strength, or not known."""
        least = self.strength
        return next((link.name for link in self.links if link.strength is not None and link.strength == least), None)


def _links(of: Anchorage) -> Iterator[Link]:
    plate, site, leaf = of.plate, of.site, of.leaf
    by = {"gamma_M": GAMMA_M, "FC": plate.confidence}
    if thread := _lacking(plate, "thread_area", "tensile_strength"):
        yield Link("thread", None, thread)
    else:
        yield Link("thread", thread_strength(A_s=plate.thread_area or 0.0, f_u=plate.tensile_strength or 0.0))
    if steel := _lacking(plate, "thickness", "yield_stress", "nut"):
        yield Link("plate", None, steel)
    else:
        bent = {"t_p": plate.thickness or 0.0, "f_y": plate.yield_stress or 0.0, "c": plate.overhang or 0.0}
        yield Link("plate", bending_strength(A_p=plate_area(plate), **bent))
    if pressed := _lacking(plate, "bearing_strength"):
        yield Link("bearing", None, pressed)
    else:
        yield Link("bearing", bearing_strength(A_b=site.bearing_area, f_h=plate.bearing_strength or 0.0, **by))
    sheared = _lacking(plate, "shear_strength")
    if sheared or leaf is None or site.surface is None:
        yield Link("punching", None, (*sheared, *(["a body with geometry"] if site.surface is None else [])))
    else:
        yield Link("punching", punching_strength(plate, *of.cone))
    if plate.course and plate.overlap and not sheared and leaf is not None:
        f_vd = shear_strength(f_v0=plate.shear_strength or 0.0, mu=plate.friction, sigma_n=of.normal_stress, **by)
        yield Link("sliding", of.sliding_surface * f_vd)
    yield _between(of)
    if plate.far_strength is not None:
        yield Link("far end", plate.far_strength)
    elif plate.hole and plate.embedment and plate.bond_strength and not sheared:
        d, length = plate.hole, plate.embedment
        f_vd = shear_strength(f_v0=plate.shear_strength or 0.0, mu=0.0, sigma_n=0.0, **by)
        bond = bond_strength(d=d, l=length, f_b=plate.bond_strength, **by)
        cone = round_cone(d, length) if of.far_end.cone is None else of.far_end.cone
        yield Link("far end", min(bond, cone * f_vd))
    else:
        yield Link("far end", None, sheared if plate.hole else ("plate.far_strength",))
    if of.far_wall is not None:
        yield Link("far wall", of.far_wall.strength) if of.far_wall_holds else Link("far wall", None, (NO_FAR_WALL,))


def _between(of: Anchorage) -> Link:
    """Return what the wall between a tie and the next one can bring to it: an arch of its own, or what is stated."""
    plate, site, leaf = of.plate, of.site, of.leaf
    if plate.between is not None:
        return Link("between", plate.between)
    if site.bay is None or leaf is None or (site.at_end and site.bay > CLOSE):
        return Link("between", None, ("plate.between",))
    if site.bay <= CLOSE:
        return Link("between", inf)
    if missing := _lacking(plate, "bearing_strength"):
        return Link("between", None, missing)
    f_h = plate.bearing_strength or 0.0
    arch = arch_strength(f_h=f_h, t=leaf, h_s=of.strip, s=site.bay, gamma_M=GAMMA_M, FC=plate.confidence)
    return Link("between", arch)


def _lacking(plate: Plate, *keys: str) -> tuple[str, ...]:
    return tuple(f"plate.{key}" for key in keys if getattr(plate, key) is None)


def compression(plate: Plate, weight: float) -> float:
    """Return the least compression of the wall at a plate in the earthquake [Pa]: as stated, or of the weight above.

    Parameters
    ----------
    plate : with what is stated; weight : of the masonry above its cone [Pa]
    """
    return (1.0 - RISING * VERTICAL) * weight if plate.normal_stress is None else plate.normal_stress


def punching_strength(plate: Plate, S: float, n: int, weight: float) -> float:
    """Return the pull of each of n plates at which they punch a leaf together, S f_vd / n [N] (own derivation).

    Parameters
    ----------
    plate : with the strength of the masonry
    S, n : surface of the cone [m2], number of the plates
    weight : of the masonry above the cone [Pa]
    """
    masonry = {"f_v0": plate.shear_strength or 0.0, "mu": plate.friction, "sigma_n": compression(plate, weight)}
    return S / n * shear_strength(**masonry, gamma_M=GAMMA_M, FC=plate.confidence)


def bar_strength(*, A: float, f_y: float) -> float:
    """Return the design strength of a bar that yields, A f_y / 1.05 [N] (EN 1993-1-1 6.2.3, from memory).

    Parameters
    ----------
    A, f_y : section [m2] and yield stress [Pa]
    """
    return A * f_y / GAMMA_M0


def thread_strength(*, A_s: float, f_u: float) -> float:
    """Return the strength of a threaded end, 0.9 A_s f_u / 1.25 [N] (EN 1993-1-8 table 3.4, from memory).

    Parameters
    ----------
    A_s, f_u : section of the thread [m2] and tensile strength [Pa]
    """
    return THREAD * A_s * f_u / GAMMA_M2


def bending_strength(*, A_p: float, t_p: float, f_y: float, c: float) -> float:
    """Return the pull at which a plate yields along the edge of what it bends about [N] (own derivation).

    The masonry presses evenly, p = N / A_p; along a line across the whole plate m = p c^2 / 2 = t_p^2 f_y / (4 x 1.05).

    Parameters
    ----------
    A_p, t_p, f_y : area [m2], thickness [m] and yield stress [Pa] of the plate
    c : overhang beyond nut, washer or rib [m]
    """
    return inf if c <= 0.0 else A_p * t_p**2 * f_y / (2.0 * GAMMA_M0 * c**2)


def bearing_strength(*, A_b: float, f_h: float, gamma_M: float, FC: float) -> float:
    """Return the pull at which the masonry under the plate crushes, A_b f_h / (gamma_M FC) [N] (own derivation).

    Rubble has no more strength under a part of its face than under all of it.

    Parameters
    ----------
    A_b, f_h : pressed area [m2], and strength across the face of the wall [Pa]
    """
    return A_b * f_h / (gamma_M * FC)


def shear_strength(*, f_v0: float, mu: float, sigma_n: float, gamma_M: float, FC: float) -> float:
    """Return the design strength of masonry in shear along a cone, (f_v0 + mu sigma_n) / (gamma_M FC) [Pa].

    Parameters
    ----------
    f_v0, mu, sigma_n : cohesion [Pa], friction [-] and compression [Pa]
    """
    return (f_v0 + mu * sigma_n) / (gamma_M * FC)


def courses_under(height: float, course: float) -> int:
    """Return the least number of courses that a plate presses on.

    Parameters
    ----------
    height, course : of the plate, and of a course [m]
    """
    return max(ceil(height / course - ON_EDGE), 1)


def sliding_surface(*, a: float, t: float, n: int, o: float, beds: float) -> float:
    """Return the beds on which units under a plate slide: t (beds a + 2 (n - 1) o) [m2] (own derivation).

    The courses under the plate move inwards as they are, by units that are not broken. They rub on the beds above and
    below them over the width of the plate at least; between two courses that move the ends of one lie o beside those of
    the other at either side, and rub on what stays. Head joints bear nothing. N times the way is the work of all beds.

    Parameters
    ----------
    a, t : width of the plate, thickness of the leaf [m]
    n, o : courses that move; overlap of their units [m]
    beds : of those above and below them, the part that is in the wall, from 0 to 2
    """
    return t * (beds * a + 2.0 * (n - 1) * o)


def arch_strength(*, f_h: float, t: float, h_s: float, s: float, gamma_M: float, FC: float) -> float:
    """Return the pull that the wall between ties brings to one, as a level arch: f_h t^2 h_s / (s gamma_M FC) [N].

    An arch within the thickness bears q = f_d (t / s)^2 on each square metre (EN 1996-1-1 6.3.2, from memory; thrust
    0.15 f_d t, rise 0.83 t), and a tie holds the strip h_s over the bay s.

    Parameters
    ----------
    f_h, t : strength [Pa] and thickness [m] of the wall
    h_s, s : height of the strip, and distance of the ties [m]
    """
    return f_h / (gamma_M * FC) * t**2 * h_s / s


def bond_strength(*, d: float, l: float, f_b: float, gamma_M: float, FC: float) -> float:  # noqa: E741
    """Return the pull at which an injected bar leaves its hole, pi d l f_b / (gamma_M FC) [N] (own derivation).

    Parameters
    ----------
    d, l : diameter and length of the hole [m]
    f_b : bond between grout and masonry [Pa]
    """
    return pi * d * l * f_b / (gamma_M * FC)


def round_cone(diameter: float, depth: float) -> float:
    """Return the surface of a cone of 45 degrees under a round plate, seen along its depth: pi (D + t) t [m2].

    A design note has the outline pi (D + t) (Master Magazine 7, pp. 75 and 99).

    Parameters
    ----------
    diameter, depth : D and t [m]
    """
    return pi * (diameter + depth) * depth


def plate_area(plate: Plate) -> float:
    """Return the area of a plate [m2]."""
    width, height = plate.sides
    return pi * plate.diameter**2 / 4.0 if plate.diameter else width * height


Figure = tuple[Plate, float, float]
"""A plate with its centre on the face of the wall: (s, z) [m]."""


Way = tuple[float, ...]
"""Coordinates out to which a cone runs left, down, right and up [m]; inf, inf, -inf, -inf where it does not."""


def no_weight(way: Way) -> float:
    """Return 0, the weight above a cone where there is no friction, whichever way it runs out [Pa]."""
    return 0.0


def weakest_cone(
    figures: Sequence[Figure],
    depth: float,
    wall: shapely.Geometry | None = None,
    weight: Callable[[Way], float] = no_weight,
) -> tuple[float, float]:
    """Return surface [m2] and weight above [Pa] of the weakest cone along which plates punch a leaf together.

    Own derivation; the surface is that seen along the depth.

    At each depth the plates, grown by it on all sides, have one outline; where it lies outside the wall there is no
    side. A cone may also run out straight to edges, to either side, up or down, however far, where that is shorter;
    at a corner two sides of it are left. It does not run out to all edges: the wall itself would move. For one
    rectangle far from edges this is 2 (a + b + 2 t) t.

    Parameters
    ----------
    figures : plates on the face of the wall
    depth : thickness of the leaf, t [m]
    wall : the wall with its openings as seen along its normal; None: without edges
    weight : of the masonry above a cone, by the way it runs out, over the leaf's area [Pa]: with the friction at the
        first plate it makes one way stronger than another
    """
    plate = figures[0][0]
    within = None if wall is None else shapely.buffer(wall, -ON_EDGE)
    ways = [way for way in product(*_edges_around(figures, depth, within)) if not all(isfinite(each) for each in way)]
    for slices in (COARSE, SLICES):
        grown = [depth * (place + 0.5) / slices for place in range(slices)]
        outlines = np.mean([[_outline(figures, by, within, way) for by in grown] for way in ways], axis=1)
        weights = [weight(way) for way in ways]
        strengths = [punching_strength(plate, each, 1, w) for each, w in zip(outlines, weights, strict=True)]
        order = np.lexsort((outlines, strengths))[:FEW]
        ways = [ways[number] for number in order]
    return float(outlines[order[0]]) * depth, weights[order[0]]


def farthest_edge(figures: Sequence[Figure], depth: float) -> float:
    """Return the distance beyond which no edge makes a cone less [m]: to run out so far is longer than all its sides.

    Parameters
    ----------
    figures, depth : as of `weakest_cone`
    """
    return sum(float(shapely.length(plate_shape(each, depth / 2.0))) for each in figures) + depth


def cones_meet(one: Figure, other: Figure, depth: float) -> bool:
    """Return whether the cones of two plates overlap within the leaf.

    Parameters
    ----------
    one, other : plates on the face of the wall
    depth : thickness of the leaf [m]
    """
    return bool(shapely.intersects(plate_shape(one, depth), plate_shape(other, depth)))


def _edges_around(figures: Sequence[Figure], depth: float, within: shapely.Geometry | None) -> tuple[list[float], ...]:
    """Return the coordinates of the edges that cones may run out to, left, below, right and above, and of none [m]."""
    found: tuple[list[float], ...] = ([inf], [inf], [-inf], [-inf])
    if within is None:
        return found
    reach = farthest_edge(figures, depth)
    west, south, east, north = shapely.bounds(shapely.union_all([plate_shape(each, reach) for each in figures]))
    for figure in figures:
        a, b, c, d = shapely.bounds(plate_shape(figure))
        for by in (-2.0 * ON_EDGE, depth):  # beside the plate, and beside all of its cone
            strips = (
                (west, b - by, a, d + by),
                (a - by, south, c + by, b),
                (c, b - by, east, d + by),
                (a - by, d, c + by, north),
            )
            for side, strip in enumerate(strips):
                found[side].extend(_edges_in(strip, side, within))
    return tuple(sorted(set(np.round(each, 5))) for each in found)


def _edges_in(strip: tuple[float, float, float, float], side: int, within: shapely.Geometry) -> Iterator[float]:
    """Yield where masonry ends in a strip beside a plate, the nearest first, up to an end of its whole width."""
    near, across = (side + 2) % 4, (1 - side % 2, 3 - side % 2)
    sign = 1.0 if side > 1 else -1.0
    gaps = shapely.get_parts(shapely.difference(shapely.box(*strip), within))
    for gap in sorted(gaps, key=lambda each: sign * shapely.bounds(each)[near]):
        bounds = shapely.bounds(gap)
        if abs(bounds[near] - strip[near]) > 2.0 * ON_EDGE:
            yield bounds[near] + 6.0 * sign * ON_EDGE  # beyond the edge, also when it is rounded
        if shapely.area(gap) < 0.999 * (bounds[2] - bounds[0]) * (bounds[3] - bounds[1]):  # a sloping edge
            yield bounds[side]
        elif all(abs(bounds[each] - strip[each]) < 2.0 * ON_EDGE for each in across):
            return


def _outline(figures: Sequence[Figure], by: float, within: shapely.Geometry | None, way: Way) -> float:
    """Return the length of the outline at one depth, in the wall [m]; way: out to which edges it runs."""
    shapes = [plate_shape(each, by) for each in figures]
    if any(isfinite(each) for each in way):
        west, south, east, north = way
        bounds = [shapely.bounds(each) for each in shapes]
        shapes = [shapely.box(min(a, west), min(b, south), max(c, east), max(d, north)) for a, b, c, d in bounds]
    border = shapely.boundary(shapely.union_all(shapes))
    return float(shapely.length(border if within is None else shapely.intersection(border, within)))


def plate_shape(figure: Figure, by: float = 0.0) -> shapely.Geometry:
    """Return a plate on the face of the wall, grown on all sides.

    Parameters
    ----------
    figure : the plate with its centre
    by : length by which it is grown [m]
    """
    plate, s, z = figure
    width, height = plate.sides
    if plate.diameter:
        return shapely.Point(s, z).buffer(plate.diameter / 2.0 + by, quad_segs=64)
    return shapely.box(s - width / 2.0 - by, z - height / 2.0 - by, s + width / 2.0 + by, z + height / 2.0 + by)
