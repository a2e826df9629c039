"""The contact of a joint as lines of a calculation sheet: its section, as it opens and crushes, and once rotated.

Formulas are those of the closed forms of a rectangle (thesis 6.2-6.7) and, for any other outline, of equilibrium; what
equilibrium alone gives is taken from the solver and checked by integrating the stresses, strip by strip.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import inf, isclose

from assess.codes.calculation_sheet import Given, Step, step
from assess.interfaces.contact import Contact, contact, semi_flexible_shift, thresholds
from assess.interfaces.kernel.columns import BEGIN, RADIUS, W0, W1
from assess.interfaces.section import ContactSection, stress_integrals
from assess.mechanisms.chain import Joint

PROJECT = "project"
SHIFT = "Mehrotra 6.3.1.2"
SHIFT_DESCRIPTION = "fixed hinge: resultant as crushing begins"
OPENS, CRUSHES = "rotation at which the far edge opens", "rotation at which crushing begins"
SAME_STRESS = 1e-9  # of the strength: an edge that opens at it does so before it crushes


def rest_steps(joint: Joint, normal_force: float) -> tuple[Step, ...]:
    """Write section, law and stress of a joint at rest.

    Parameters
    ----------
    joint : with its section and law
    normal_force : N at rest [N]

    Returns
    -------
    tuple of Step
    """
    section, law = joint.section, joint.law
    pressed: Given = {"N": (normal_force, "N"), "A": (section.area, "m2")}
    lines = [*_section_steps(section)]
    if law.stiffness < inf:
        lines.append(step("k", "normal stiffness of the joint, per area", PROJECT, "given", law.stiffness, "Pa/m"))
    if law.strength < inf:
        lines.append(step("f", "compressive strength of the joint", PROJECT, "given", law.strength, "Pa"))
    stress = normal_force / section.area
    return (*lines, step("σ_0", "stress at rest", BALANCE, "N / A", stress, "Pa", given=pressed))


def threshold_steps(joint: Joint, normal_force: float) -> tuple[Step, ...]:
    """Write the rotations at which a joint that yields opens and crushes, and the fixed hinge a_SF.

    Parameters
    ----------
    joint : with a finite stiffness
    normal_force : N at rest [N]

    Returns
    -------
    tuple of Step
    """
    opening, crushing = thresholds(joint.section, joint.law, normal_force=normal_force)
    first = _opening_steps(joint, normal_force, opening)
    if crushing == inf:
        never = "the strength is unlimited: the edge never crushes"
        return (*first, step("a_SF", SHIFT_DESCRIPTION, SHIFT, "none", 0.0, "m", remark=never))
    return (*first, *_crushing_steps(joint, normal_force, crushing))


BY_AREA = "found by equilibrium: the area up to it is N / f"
ANY_ROTATION = 1.0  # rad: any rotation, for a rigid joint with a strength
FULL_CONTACT = 1e-9  # of the depth: a contact that is not open by more is full
THIN_BLOCK = 0.05  # of the elastic depth: a difference that leaves less is not worked with the digits printed
DEPTH = "depth of the contact"
PLACE = "resultant from the compressed edge"
NEAR, FAR = "stress at the compressed edge", "stress at the far edge"
START: NamedValue = ("p", 0.0)


@dataclass(frozen=True)
class Zone:
    """A stretch of the contact in which the stress is linear.

    start : depth at which it begins [m]; length : [m]; stress : at its start and at its end [Pa]
    """

    start: NamedValue
    length: NamedValue
    stress: tuple[NamedValue, NamedValue]


StressLines = tuple[tuple[Step, ...], tuple[Zone, ...]]
"""Lines, and the zones of stress that they give."""


@dataclass(frozen=True)
class RotatedJoint:
    """A joint at one rotation of its mechanism.

    mark : behind each symbol; rotation : of the joint [rad]; slope : its sine, that of one face on the other
    place : number of the rotation in the contact
    """

    mark: str
    joint: Joint
    slope: float
    contact: Contact
    place: int

    def value(self, name: str) -> float:
        """Return an attribute of the contact at this rotation."""
        return float(getattr(self.contact, name)[self.place])

    @property
    def force(self) -> NamedValue:
        """The normal force [N]."""
        return f"N_{self.mark}" if self.mark in "mu" else "N", self.value("normal_force")

    @property
    def is_crushed(self) -> bool:
        """Whether a part of the contact is at its strength."""
        return self.value("crushed_depth") > 0.0

    @property
    def is_full(self) -> bool:
        """Whether no part of the contact is open."""
        return self.value("depth") >= self.joint.section.depth * (1.0 - FULL_CONTACT)

    @property
    def is_block(self) -> bool:
        """Whether all of the contact is at its strength: no elastic zone is left."""
        return self.value("crushed_depth") == self.value("depth")

    @property
    def width(self) -> float | None:
        """Of a rectangle [m]; None for another outline."""
        return _rectangle_width(self.joint.section)

    @property
    def gradient(self) -> Given:
        """Stiffness and slope, the product of which is the gradient of stress over depth."""
        return {"k": (self.joint.law.stiffness, "Pa/m"), f"s_{self.mark}": (self.slope, "-")}


def state_steps(rotated: RotatedJoint) -> tuple[Step, ...]:
    """Write the stresses on a joint that has rotated, their two integrals, and the place of the resultant.

    Parameters
    ----------
    rotated : the joint, in partial or full contact, crushed or not

    Returns
    -------
    tuple of Step
    """
    if rotated.is_block:
        lines, zones = _crushed_throughout(rotated)
    elif rotated.is_crushed:
        lines, zones = _crushed_full_contact(rotated) if rotated.is_full else _crushed_partial_contact(rotated)
    else:
        lines, zones = _full_contact(rotated) if rotated.is_full else _partial_contact(rotated)
    checks, arm = _resultant_steps(StressState(rotated.joint.section, rotated.mark, zones, rotated.force))
    named = replace(arm, symbol=f"a_f{rotated.mark}", description=PLACE, value=rotated.value("resultant"))
    return (*lines, *checks, named)


def block_steps(joint: Joint, normal_force: float) -> tuple[Step, ...]:
    """Write the plastic block of a rigid joint with a strength, which forms as soon as the joint rotates.

    Parameters
    ----------
    joint : rigid, with a strength
    normal_force : N [N]

    Returns
    -------
    tuple of Step
    """
    found = contact(joint.section, joint.law, normal_force=normal_force, rotation=ANY_ROTATION)
    return state_steps(RotatedJoint("p", joint, ANY_ROTATION, found, 0))


STRIP_FORCE = "force of a strip, ∫ σ w dx"
STRIP_PLACE = "its place, ∫ σ w x dx over that force"

NO_STRESS = 1e-12
"""Fraction of the largest stress: less is none, but for rounding."""

NamedValue = tuple[str, float]
"""A symbol with its value, in SI."""


@dataclass(frozen=True)
class Strip:
    """A zone or a part of one. width : at its start and end [m]; None where it is not linear between them."""

    zone: Zone
    width: tuple[NamedValue, NamedValue] | None


@dataclass(frozen=True)
class StressState:
    """A contact whose stresses are known.

    mark : behind each symbol; zones : from the compressed edge on; normal_force : [N]
    """

    section: ContactSection
    mark: str
    zones: tuple[Zone, ...]
    normal_force: NamedValue


def _opening_steps(joint: Joint, N: float, opening: float) -> tuple[Step, ...]:
    """Write the rotation of opening, before crushing or, under more than half of what a rectangle bears, after it."""
    section, k, f = joint.section, joint.law.stiffness, joint.law.strength
    b, A, x_c, width = section.depth, section.area, section.centroid, _rectangle_width(section)
    given: Given = {"N": (N, "N"), "k": (k, "Pa/m"), "b": (b, "m")}
    before = k * opening * b <= f * (1.0 + SAME_STRESS)
    if width is not None:
        given = {**given, "l": (width, "m")}
        if before:
            return (step("φ_o", OPENS, "Mehrotra 6.2", "2 N / (k l b²)", opening, "rad", given=given),)
        given = {**given, "f": (f, "Pa")}
        return (step("φ_o", OPENS, BALANCE, "f / (2 k (b − N / (f l)))", opening, "rad", given=given),)
    if before:
        given = {**given, "A": (A, "m2"), "x_c": (x_c, "m")}
        return (step("φ_o", OPENS, BALANCE, "N / (k A (b − x_c))", opening, "rad", given=given),)
    opens = step("φ_o", OPENS, BALANCE, BY_BALANCE, opening, "rad")
    return (opens, *_opening_checks(joint, N, opening))


def _opening_checks(joint: Joint, N: float, opening: float) -> tuple[Step, ...]:
    """Write the stresses as the far edge opens behind a crushed zone, and their resultant."""
    k, f, b = joint.law.stiffness, joint.law.strength, joint.section.depth
    c = f / (k * opening)
    turned: Given = {"f": (f, "Pa"), "k": (k, "Pa/m"), "φ_o": (opening, "rad")}
    sizes: Given = {"b": (b, "m"), "c_o": (c, "m")}
    lines = (
        step("c_o", ELASTIC, BALANCE, "f / (k φ_o)", c, "m", given=turned),
        step("a_2o", CRUSHED, BALANCE, "b − c_o", b - c, "m", given=sizes),
    )
    zones = (
        Zone(("p", 0.0), ("a_2o", b - c), (("f", f), ("f", f))),
        Zone(("a_2o", b - c), ("c_o", c), (("f", f), ("σ_o", 0.0))),
    )
    checks, _ = _resultant_steps(StressState(joint.section, "o", zones, ("N", N)))
    return (*lines, *checks)


def _crushing_steps(joint: Joint, N: float, crushing: float) -> tuple[Step, ...]:
    """Write the contact as its edge begins to crush, and from it a_SF."""
    section, k, f = joint.section, joint.law.stiffness, joint.law.strength
    b, width = section.depth, _rectangle_width(section)
    found = contact(section, joint.law, normal_force=N, rotation=crushing)
    a = f / (k * crushing)
    pressed: Given = {"N": (N, "N"), "f": (f, "Pa")}
    turned: Given = {"k": (k, "Pa/m"), "φ_c": (crushing, "rad")}
    if a < b:
        words, end = "depth of the contact then", 0.0
        lines: tuple[Step, ...] = (
            step("a_c", words, BALANCE, BY_BALANCE, a, "m")
            if width is None
            else step("a_c", words, "Mehrotra 6.3", "2 N / (f l)", a, "m", given={**pressed, "l": (width, "m")}),
            step("φ_c", CRUSHES, "Mehrotra 6.4", "f / (k a_c)", crushing, "rad",
                 given={"f": (f, "Pa"), "k": (k, "Pa/m"), "a_c": (a, "m")}),
        )  # fmt: skip
        zone = Zone(("p", 0.0), ("a_c", a), (("f", f), ("σ_c", 0.0)))
    else:
        end = f - k * crushing * b
        rest: Given = {**pressed, "k": (k, "Pa/m"), "A": (section.area, "m2")}
        half: Given = {"b": (b, "m")} if width is not None else {"x_c": (section.centroid, "m")}
        formula = "2 (f − N / A) / (k b)" if width is not None else "(f − N / A) / (k x_c)"
        lines = (
            step("φ_c", CRUSHES, BALANCE, formula, crushing, "rad", given={**rest, **half}),
            step("σ_c", "stress at the far edge then", BALANCE, "f − k φ_c b", end, "Pa",
                 given={"f": (f, "Pa"), **turned, "b": (b, "m")}),
        )  # fmt: skip
        zone = Zone(("p", 0.0), ("b", b), (("f", f), ("σ_c", end)))
    checks, arm = _resultant_steps(StressState(section, "c", (zone,), ("N", float(found.normal_force[0]))))
    shift = semi_flexible_shift(section, joint.law, normal_force=N)
    return (*lines, *checks, replace(arm, symbol="a_SF", description=SHIFT_DESCRIPTION, clause=SHIFT, value=shift))


def _crushed_throughout(rotated: RotatedJoint) -> StressLines:
    """A block at the strength and nothing else: N = f l a for a rectangle."""
    (N, force), width, f = rotated.force, rotated.width, rotated.joint.law.strength
    name, depth = f"a_2{rotated.mark}", rotated.value("crushed_depth")
    given: Given = {N: (force, "N"), "f": (f, "Pa")}
    line = (
        step(name, CRUSHED, BALANCE, BY_AREA, depth, "m")
        if width is None
        else step(name, CRUSHED, BALANCE, f"{N} / (f l)", depth, "m", given={**given, "l": (width, "m")})
    )
    return (line,), (Zone(START, (name, depth), (("f", f), ("f", f))),)


def _full_contact(rotated: RotatedJoint) -> StressLines:
    """Full contact, elastic (thesis 6.5 for a rectangle)."""
    section, m, (N, force) = rotated.joint.section, rotated.mark, rotated.force
    b, A, x_c, slope = section.depth, section.area, section.centroid, rotated.slope
    rise = rotated.joint.law.stiffness * slope
    given: Given = {N: (force, "N"), "A": (A, "m2"), **rotated.gradient}
    near, far = force / A + rise * x_c, force / A - rise * (b - x_c)
    width = rotated.width
    half: Given = {"b": (b, "m")} if width is not None else {"x_c": (x_c, "m")}
    both: Given = {"b": (b, "m"), **half}
    inner, outer = ("b / 2", "b / 2") if width is not None else ("x_c", "(b − x_c)")
    lines = (
        step(f"σ_1{m}", NEAR, BALANCE, f"{N} / A + k s_{m} {inner}", near, "Pa", given={**given, **half}),
        step(f"σ_2{m}", FAR, BALANCE, f"{N} / A − k s_{m} {outer}", far, "Pa", given={**given, **both}),
    )
    return lines, (Zone(START, ("b", b), ((f"σ_1{m}", near), (f"σ_2{m}", far))),)


def _partial_contact(rotated: RotatedJoint) -> StressLines:
    """A triangle of stress over a part of the contact (thesis 6.6 for a rectangle)."""
    m, (N, force), width, a = rotated.mark, rotated.force, rotated.width, rotated.value("depth")
    near, given = rotated.joint.law.stiffness * rotated.slope * a, rotated.gradient
    depth = (
        step(f"a_{m}", DEPTH, BALANCE, BY_BALANCE, a, "m")
        if width is None
        else step(f"a_{m}", DEPTH, "Mehrotra 6.6", f"√(2 {N} / (k s_{m} l))", a, "m",
                  given={N: (force, "N"), **given, "l": (width, "m")})
    )  # fmt: skip
    edge = step(f"σ_1{m}", NEAR, BALANCE, f"k s_{m} a_{m}", near, "Pa", given={**given, f"a_{m}": (a, "m")})
    return (depth, edge), (Zone(START, (f"a_{m}", a), ((f"σ_1{m}", near), (f"σ_2{m}", 0.0))),)


def _crushed_partial_contact(rotated: RotatedJoint) -> StressLines:
    """A block at the strength and a triangle behind it (thesis 6.7 for a rectangle)."""
    m, (N, force), width, f = rotated.mark, rotated.force, rotated.width, rotated.joint.law.strength
    a_2, c = rotated.value("crushed_depth"), f / (rotated.joint.law.stiffness * rotated.slope)
    behind: Given = {f"c_{m}": (c, "m")}
    elastic = step(f"c_{m}", ELASTIC, BALANCE, f"f / (k s_{m})", c, "m", given={"f": (f, "Pa"), **rotated.gradient})
    given: Given = {N: (force, "N"), "f": (f, "Pa"), **behind}
    block = (
        step(f"a_2{m}", CRUSHED, BALANCE, BY_BALANCE, a_2, "m")
        if width is None or a_2 < THIN_BLOCK * c
        else step(f"a_2{m}", CRUSHED, "Mehrotra 6.7", f"{N} / (f l) − c_{m} / 2", a_2, "m",
                  given={**given, "l": (width, "m")})
    )  # fmt: skip
    sizes: Given = {f"a_2{m}": (a_2, "m"), **behind}
    whole = step(f"a_{m}", DEPTH, BALANCE, f"a_2{m} + c_{m}", a_2 + c, "m", given=sizes)
    return (elastic, block, whole), _two_zones(rotated, a_2, c, 0.0)


def _crushed_full_contact(rotated: RotatedJoint) -> StressLines:
    """A block at the strength, and behind it a trapezium that reaches the far edge."""
    m, (N, force), width = rotated.mark, rotated.force, rotated.width
    b, f, a_2 = rotated.joint.section.depth, rotated.joint.law.strength, rotated.value("crushed_depth")
    c, given = b - a_2, rotated.gradient
    far = f - rotated.joint.law.stiffness * rotated.slope * c
    depth: Given = {"b": (b, "m")}
    if width is None:
        sizes = (
            step(f"a_2{m}", CRUSHED, BALANCE, BY_BALANCE, a_2, "m"),
            step(f"c_{m}", ELASTIC, BALANCE, f"b − a_2{m}", c, "m", given={**depth, f"a_2{m}": (a_2, "m")}),
        )
    else:
        bearing: Given = {"f": (f, "Pa"), **depth, "l": (width, "m"), N: (force, "N"), **given}
        sizes = (
            step(f"c_{m}", ELASTIC, BALANCE, f"√(2 (f b l − {N}) / (k s_{m} l))", c, "m", given=bearing),
            step(f"a_2{m}", CRUSHED, BALANCE, f"b − c_{m}", a_2, "m", given={**depth, f"c_{m}": (c, "m")}),
        )
    last: Given = {"f": (f, "Pa"), **given, f"c_{m}": (c, "m")}
    edge = step(f"σ_2{m}", FAR, BALANCE, f"f − k s_{m} c_{m}", far, "Pa", given=last)
    return (*sizes, edge), _two_zones(rotated, a_2, c, far)


def _two_zones(rotated: RotatedJoint, a_2: float, c: float, far: float) -> tuple[Zone, ...]:
    m, f = rotated.mark, rotated.joint.law.strength
    block = Zone(START, (f"a_2{m}", a_2), (("f", f), ("f", f)))
    return block, Zone((f"a_2{m}", a_2), (f"c_{m}", c), (("f", f), (f"σ_2{m}", far)))


BALANCE, GEOMETRY = "equilibrium", "geometry of the contact"

MOST_STRIPS = 6
"""Strips that are worked one by one; of outlines with more, and of discs, integrals are given over a whole zone."""
BY_BALANCE = "found by equilibrium: the resultant of the stresses is N"
CRUSHED, ELASTIC = "depth crushed, at the strength", "depth of the elastic zone"
CENTROID = "centroid from the compressed edge"
AREA = "area of the contact"


def _rectangle_width(section: ContactSection) -> float | None:
    """Return the width of a section that is a rectangle along the motion [m]; None for any other."""
    if len(section.pieces) != 2:
        return None
    slope, width = float(section.pieces[0, W1]), float(section.pieces[0, W0])
    return width if abs(slope) * section.depth <= 1e-12 * width else None


def _section_steps(section: ContactSection) -> tuple[Step, ...]:
    """Write sizes, area and centroid of a contact.

    Parameters
    ----------
    section : seen in the direction in which it is compressed

    Returns
    -------
    tuple of Step
    """
    depth = step("b", "depth of the contact, along the motion", GEOMETRY, "given", section.depth, "m")
    if section.discs.size:
        return (depth, *_disc_steps(section))
    width = _rectangle_width(section)
    if width is None:
        return (depth, *_piece_steps(section))
    sizes: Given = {"b": (section.depth, "m"), "l": (width, "m")}
    return (
        depth,
        step("l", "width of the contact, across the motion", GEOMETRY, "given", width, "m"),
        step("A", AREA, GEOMETRY, "b l", section.area, "m2", given=sizes),
    )


def _disc_steps(section: ContactSection) -> tuple[Step, ...]:
    d = 2.0 * float(section.discs[0, RADIUS])
    outer: Given = {"b": (d, "m")}
    middle = step("x_c", CENTROID, GEOMETRY, "b / 2", section.centroid, "m", given=outer)
    if len(section.discs) == 1:
        return (
            step("A", AREA, GEOMETRY, "π b² / 4", section.area, "m2", given=outer,
                 remark="the width w at the depth x is 2 √(x (b − x))"),
            middle,
        )  # fmt: skip
    inner = 2.0 * float(section.discs[1, RADIUS])
    both: Given = {**outer, "d_i": (inner, "m")}
    return (
        step("d_i", "diameter of the hole", GEOMETRY, "given", inner, "m"),
        step("A", AREA, GEOMETRY, "π (b² − d_i²) / 4", section.area, "m2", given=both,
             remark="the width w at the depth x is 2 √(x (b − x)), less 2 √(d_i² / 4 − (b / 2 − x)²) at the hole"),
        middle,
    )  # fmt: skip


def _piece_steps(section: ContactSection) -> tuple[Step, ...]:
    """Write the area by pieces of linear width, where they are few."""
    count = len(section.pieces) - 1
    if count > MOST_STRIPS:
        at: Given = {"b": (section.depth, "m")}
        return (
            step("A", AREA, GEOMETRY, "∫ w dx", section.area, "m2", at=at),
            step("x_c", CENTROID, GEOMETRY, "∫ w x dx / A", section.centroid, "m", at=at),
        )
    lines, areas, moments = list[Step](), dict[str, tuple[float, str]](), dict[str, tuple[float, str]]()
    for number, (piece, after) in enumerate(zip(section.pieces[:-1], section.pieces[1:], strict=True), start=1):
        p, L = float(piece[BEGIN]), float(after[BEGIN] - piece[BEGIN])
        w, v = float(piece[W0]), max(float(piece[W0] + piece[W1] * L), 0.0)
        area, place = L * (w + v) / 2.0, p + L * (w + 2.0 * v) / (3.0 * (w + v))
        sizes: Given = {"L": (L, "m"), "w": (w, "m"), "v": (v, "m")}
        lines += [
            step(f"A_{number}", "area of a strip of width w to v", GEOMETRY, "L (w + v) / 2", area, "m2",
                 given=sizes),
            step(f"x_{number}", "its centroid from the compressed edge", GEOMETRY,
                 "p + L (w + 2 v) / (3 (w + v))", place, "m", given={"p": (p, "m"), **sizes}),
        ]  # fmt: skip
        areas[f"A_{number}"], moments[f"x_{number}"] = (area, "m2"), (place, "m")
    summed = " + ".join(f"{a} {x}" for a, x in zip(areas, moments, strict=True))
    total = {**areas, **moments, "A": (section.area, "m2")}
    return (
        *lines,
        step("A", AREA, GEOMETRY, " + ".join(areas), section.area, "m2", given=areas),
        step("x_c", CENTROID, GEOMETRY, f"({summed}) / A", section.centroid, "m", given=total),
    )


def _resultant_steps(state: StressState) -> tuple[tuple[Step, ...], Step]:
    """Write the two integrals of the stress, strip by strip: the resultant, which is the normal force, and its place.

    Parameters
    ----------
    state : of the contact

    Returns
    -------
    steps : its lines
    arm : the line for the distance of the resultant from the compressed edge, which the caller names
    """
    strips = _strips(state.section, state.zones)
    ends = [state.mark] if len(strips) == 1 else [f"{state.mark}{number}" for number in range(1, len(strips) + 1)]
    pairs = [_strip_steps(state.section, strip, end) for strip, end in zip(strips, ends, strict=True)]
    if len(pairs) == 1:
        ((force, place),) = pairs
        return (force, _balance_step(force.symbol, force.value or 0.0, state.normal_force)), place
    lines = [line for pair in pairs for line in pair]
    by_symbol: Given = {line.symbol: (line.value or 0.0, line.unit) for line in lines}
    parts: Given = {force.symbol: by_symbol[force.symbol] for force, _ in pairs}
    name, total = f"R_{state.mark}", sum(force.value or 0.0 for force, _ in pairs)
    lines.append(step(name, "resultant of the stresses", BALANCE, " + ".join(parts), total, "N", given=parts))
    lines.append(_balance_step(name, total, state.normal_force))
    moment = " + ".join(f"{force.symbol} {place.symbol}" for force, place in pairs)
    arm = sum((force.value or 0.0) * (place.value or 0.0) for force, place in pairs) / total
    whole: Given = {**by_symbol, name: (total, "N")}
    return tuple(lines), step("x", STRIP_PLACE, BALANCE, f"({moment}) / {name}", arm, "m", given=whole)


def _balance_step(name: str, total: float, normal_force: NamedValue) -> Step:
    symbol, force = normal_force
    given: Given = {name: (total, "N"), symbol: (force, "N")}
    formula = f"{name} / {symbol}"
    return step(formula, "check of equilibrium: R over N", BALANCE, formula, total / force,
                given=given)  # fmt: skip


def _strips(section: ContactSection, zones: tuple[Zone, ...]) -> list[Strip]:
    """Return the zones, divided where the width is no longer linear; not where that makes too many."""
    width = _rectangle_width(section)
    if width is not None:
        return [Strip(zone, (("l", width), ("l", width))) for zone in zones]
    cut = [strip for zone in zones for strip in _linear_strips(section, zone)] if section.pieces.size else []
    return cut if 0 < len(cut) <= MOST_STRIPS else [Strip(zone, None) for zone in zones]


def _linear_strips(section: ContactSection, zone: Zone) -> Iterator[Strip]:
    """Yield the parts of a zone over which the width is linear."""
    (_, start), (_, length), ((first, before), (_, after)) = zone.start, zone.length, zone.stress
    spans = [
        (piece, max(start, piece[BEGIN]), min(start + length, following[BEGIN]))
        for piece, following in zip(section.pieces[:-1], section.pieces[1:], strict=True)
    ]
    spans = [span for span in spans if span[2] - span[1] > 1e-9 * length]
    for piece, low, high in spans:
        here, there = (float(piece[W0] + piece[W1] * (x - piece[BEGIN])) for x in (low, high))
        ends = ("w", "w") if isclose(here, there, rel_tol=NO_STRESS) else ("w", "v")
        part = zone
        if len(spans) > 1:
            stress = [before + (after - before) * (x - start) / length for x in (low, high)]
            stress = [each if each > NO_STRESS * before else 0.0 for each in stress]
            names = (first, first) if before == after else ("σ", "τ")
            part = Zone(("p", float(low)), ("L", float(high - low)), ((names[0], stress[0]), (names[1], stress[1])))
        yield Strip(part, ((ends[0], here), (ends[1], max(there, 0.0))))


def _strip_steps(section: ContactSection, strip: Strip, end: str) -> tuple[Step, Step]:
    """Write force and place of the stress on a strip."""
    if strip.width is None:
        return _integral_steps(section, strip.zone, end)
    (p, start), (L, length) = strip.zone.start, strip.zone.length
    ((s, first), (t, last)), ((w, here), (v, there)) = strip.zone.stress, strip.width
    N = length * (2.0 * (first * here + last * there) + first * there + last * here) / 6.0
    moment = length**2 * (first * here + first * there + last * here + 3.0 * last * there) / 12.0
    force, place = _force_formula(strip.zone, (w, v)), _place_formula(strip.zone, (w, v), f"R_{end}")
    symbols: Given = {p: (start, "m"), L: (length, "m"), w: (here, "m"), v: (there, "m"), s: (first, "Pa"),
                    t: (last, "Pa"), f"R_{end}": (N, "N")}  # fmt: skip
    return (
        step(f"R_{end}", STRIP_FORCE, BALANCE, force, N, "N", given=_symbols_of(force, symbols)),
        step(f"x_{end}", STRIP_PLACE, BALANCE, place, start + moment / N, "m", given=_symbols_of(place, symbols)),
    )


def _symbols_of(formula: str, given: Given) -> Given:
    """Return what stands in a formula."""
    words = formula.translate(str.maketrans("()²", "   ")).split()
    return {symbol: value for symbol, value in given.items() if symbol in words}


def _force_formula(zone: Zone, width: tuple[str, str]) -> str:
    """Return the integral of stress times width over a strip, both linear."""
    (L, _), ((s, first), (t, last)), (w, v) = zone.length, zone.stress, width
    if w == v:
        return f"{w} {L} {s}" if first == last else f"{w} {L} ({s} + {t}) / 2" if last else f"{w} {L} {s} / 2"
    if first == last:
        return f"{s} {L} ({w} + {v}) / 2"
    return f"{L} (2 {s} {w} + 2 {t} {v} + {s} {v} + {t} {w}) / 6" if last else f"{L} {s} (2 {w} + {v}) / 6"


def _place_formula(zone: Zone, width: tuple[str, str], force: str) -> str:
    """Return the integral of stress times width times depth over a strip, divided by its force."""
    (p, start), (L, _), ((s, first), (t, last)), (w, v) = zone.start, zone.length, zone.stress, width
    if w == v:
        inside = f"{L} / 2" if first == last else f"{L} ({s} + 2 {t}) / (3 ({s} + {t}))" if last else f"{L} / 3"
    elif first == last:
        inside = f"{L} ({w} + 2 {v}) / (3 ({w} + {v}))"
    elif last:
        inside = f"{L}² ({s} {w} + {s} {v} + {t} {w} + 3 {t} {v}) / (12 {force})"
    else:
        inside = f"{L} ({w} + {v}) / (2 (2 {w} + {v}))"
    return f"{p} + {inside}" if start else inside


def _integral_steps(section: ContactSection, zone: Zone, end: str) -> tuple[Step, Step]:
    """Write force and place of the stress on a zone whose width is no line, by quadrature."""
    (p, start), (L, length), ((s, first), (t, last)) = zone.start, zone.length, zone.stress
    force, moment = stress_integrals(section, start=start, end=start + length, stress=(first, last))
    at: Given = {**({p: (start, "m")} if start else {}), L: (length, "m"), s: (first, "Pa"), t: (last, "Pa")}
    return (
        step(f"R_{end}", STRIP_FORCE, BALANCE, "∫ σ w dx", force, "N", at=at),
        step(f"x_{end}", STRIP_PLACE, BALANCE,
             "∫ σ w x dx / ∫ σ w dx", moment / force, "m", at=at),
    )  # fmt: skip
