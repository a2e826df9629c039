"""A joint that has rotated, as lines of a calculation sheet: its stresses, their resultant and where it acts."""

from __future__ import annotations

from dataclasses import dataclass, replace

from assess.codes.calculation_step import Given, Step, step
from assess.interfaces.contact import Contact, contact
from assess.mechanisms.joint import Joint
from assess.study.section_steps import BALANCE, BY_BALANCE, CRUSHED, ELASTIC, rectangle_width
from assess.study.stress_steps import Named, State, Zone, resultant_steps

BY_AREA = "found by equilibrium: the area up to it is N / f"
PLASTIC = 1.0  # rad: any rotation, for a rigid joint with a strength
WITHIN = 1e-9  # of the depth: a contact that is not open by more is full
THIN = 0.05  # of the elastic depth: a difference that leaves less is not worked with the digits printed
DEPTH = "depth of the contact"
PLACE = "resultant from the compressed edge"
NEAR, FAR = "stress at the compressed edge", "stress at the far edge"

START: Named = ("p", 0.0)

Found = tuple[tuple[Step, ...], tuple[Zone, ...]]
"""Lines, and the zones of stress that they give."""


@dataclass(frozen=True)
class Turned:
    """A joint at one rotation of its mechanism.

    mark : behind each symbol; rotation : of the joint [rad]; slope : its sine, that of one face on the other
    place : number of the rotation in `contact`
    """

    mark: str
    joint: Joint
    slope: float
    found: Contact
    place: int

    def value(self, name: str) -> float:
        """Return an attribute of the contact at this rotation."""
        return float(getattr(self.found, name)[self.place])

    @property
    def force(self) -> Named:
        """The normal force [N]."""
        return f"N_{self.mark}" if self.mark in "mu" else "N", self.value("normal_force")

    @property
    def is_crushed(self) -> bool:
        """Whether a part of the contact is at its strength."""
        return self.value("crushed_depth") > 0.0

    @property
    def is_full(self) -> bool:
        """Whether no part of the contact is open."""
        return self.value("depth") >= self.joint.section.depth * (1.0 - WITHIN)

    @property
    def is_block(self) -> bool:
        """Whether all of the contact is at its strength: no elastic zone is left."""
        return self.value("crushed_depth") == self.value("depth")

    @property
    def width(self) -> float | None:
        """Of a rectangle [m]; None for another outline."""
        return rectangle_width(self.joint.section)

    @property
    def gradient(self) -> Given:
        """Stiffness and slope, the product of which is the gradient of stress over depth."""
        return {"k": (self.joint.law.stiffness, "Pa/m"), f"s_{self.mark}": (self.slope, "-")}


def state_steps(turned: Turned) -> tuple[Step, ...]:
    """Write the stresses on a joint that has rotated, their two integrals, and the place of the resultant.

    Parameters
    ----------
    turned : the joint, in partial or full contact, crushed or not

    Returns
    -------
    tuple of Step
    """
    if turned.is_block:
        lines, zones = _block(turned)
    elif turned.is_crushed:
        lines, zones = _crushed_full(turned) if turned.is_full else _crushed(turned)
    else:
        lines, zones = _full(turned) if turned.is_full else _partial(turned)
    checks, arm = resultant_steps(State(turned.joint.section, turned.mark, zones, turned.force))
    named = replace(arm, symbol=f"a_f{turned.mark}", description=PLACE, value=turned.value("resultant"))
    return (*lines, *checks, named)


def _block(turned: Turned) -> Found:
    """A block at the strength and nothing else: N = f l a for a rectangle."""
    (N, force), width, f = turned.force, turned.width, turned.joint.law.strength
    name, depth = f"a_2{turned.mark}", turned.value("crushed_depth")
    given: Given = {N: (force, "N"), "f": (f, "Pa")}
    line = (
        step(name, CRUSHED, BALANCE, BY_AREA, depth, "m")
        if width is None
        else step(name, CRUSHED, BALANCE, f"{N} / (f l)", depth, "m", given={**given, "l": (width, "m")})
    )
    return (line,), (Zone(START, (name, depth), (("f", f), ("f", f))),)


def _full(turned: Turned) -> Found:
    """Full contact, elastic (thesis 6.5 for a rectangle)."""
    section, m, (N, force) = turned.joint.section, turned.mark, turned.force
    b, A, x_c, slope = section.depth, section.area, section.centroid, turned.slope
    rise = turned.joint.law.stiffness * slope
    given: Given = {N: (force, "N"), "A": (A, "m2"), **turned.gradient}
    near, far = force / A + rise * x_c, force / A - rise * (b - x_c)
    width = turned.width
    half: Given = {"b": (b, "m")} if width is not None else {"x_c": (x_c, "m")}
    both: Given = {"b": (b, "m"), **half}
    inner, outer = ("b / 2", "b / 2") if width is not None else ("x_c", "(b − x_c)")
    lines = (
        step(f"σ_1{m}", NEAR, BALANCE, f"{N} / A + k s_{m} {inner}", near, "Pa", given={**given, **half}),
        step(f"σ_2{m}", FAR, BALANCE, f"{N} / A − k s_{m} {outer}", far, "Pa", given={**given, **both}),
    )
    return lines, (Zone(START, ("b", b), ((f"σ_1{m}", near), (f"σ_2{m}", far))),)


def _partial(turned: Turned) -> Found:
    """A triangle of stress over a part of the contact (thesis 6.6 for a rectangle)."""
    m, (N, force), width, a = turned.mark, turned.force, turned.width, turned.value("depth")
    near, given = turned.joint.law.stiffness * turned.slope * a, turned.gradient
    depth = (
        step(f"a_{m}", DEPTH, BALANCE, BY_BALANCE, a, "m")
        if width is None
        else step(f"a_{m}", DEPTH, "thesis 6.6", f"√(2 {N} / (k s_{m} l))", a, "m",
                  given={N: (force, "N"), **given, "l": (width, "m")})
    )  # fmt: skip
    edge = step(f"σ_1{m}", NEAR, BALANCE, f"k s_{m} a_{m}", near, "Pa", given={**given, f"a_{m}": (a, "m")})
    return (depth, edge), (Zone(START, (f"a_{m}", a), ((f"σ_1{m}", near), (f"σ_2{m}", 0.0))),)


def _crushed(turned: Turned) -> Found:
    """A block at the strength and a triangle behind it (thesis 6.7 for a rectangle)."""
    m, (N, force), width, f = turned.mark, turned.force, turned.width, turned.joint.law.strength
    a_2, c = turned.value("crushed_depth"), f / (turned.joint.law.stiffness * turned.slope)
    behind: Given = {f"c_{m}": (c, "m")}
    elastic = step(f"c_{m}", ELASTIC, BALANCE, f"f / (k s_{m})", c, "m", given={"f": (f, "Pa"), **turned.gradient})
    given: Given = {N: (force, "N"), "f": (f, "Pa"), **behind}
    block = (
        step(f"a_2{m}", CRUSHED, BALANCE, BY_BALANCE, a_2, "m")
        if width is None or a_2 < THIN * c
        else step(f"a_2{m}", CRUSHED, "thesis 6.7", f"{N} / (f l) − c_{m} / 2", a_2, "m",
                  given={**given, "l": (width, "m")})
    )  # fmt: skip
    sizes: Given = {f"a_2{m}": (a_2, "m"), **behind}
    whole = step(f"a_{m}", DEPTH, BALANCE, f"a_2{m} + c_{m}", a_2 + c, "m", given=sizes)
    return (elastic, block, whole), _two_zones(turned, a_2, c, 0.0)


def _crushed_full(turned: Turned) -> Found:
    """A block at the strength, and behind it a trapezium that reaches the far edge."""
    m, (N, force), width = turned.mark, turned.force, turned.width
    b, f, a_2 = turned.joint.section.depth, turned.joint.law.strength, turned.value("crushed_depth")
    c, given = b - a_2, turned.gradient
    far = f - turned.joint.law.stiffness * turned.slope * c
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
    return (*sizes, edge), _two_zones(turned, a_2, c, far)


def _two_zones(turned: Turned, a_2: float, c: float, far: float) -> tuple[Zone, ...]:
    m, f = turned.mark, turned.joint.law.strength
    block = Zone(START, (f"a_2{m}", a_2), (("f", f), ("f", f)))
    return block, Zone((f"a_2{m}", a_2), (f"c_{m}", c), (("f", f), (f"σ_2{m}", far)))


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
    found = contact(joint.section, joint.law, normal_force=normal_force, rotation=PLASTIC)
    return state_steps(Turned("p", joint, PLASTIC, found, 0))
