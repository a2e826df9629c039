"""A joint at rest and as it opens and crushes, with a_SF, as lines of a calculation sheet.

Formulas are those of the closed forms of a rectangle (thesis 6.2-6.7) and, for any other outline, of equilibrium; what
equilibrium alone gives is taken from the solver and checked by integrating the stresses.
"""

from __future__ import annotations

from dataclasses import replace
from math import inf

from assess.codes.calculation_step import Given, Step, step
from assess.interfaces.contact import contact, semi_flexible_shift, thresholds
from assess.mechanisms.joint import Joint
from assess.study.section_steps import BALANCE, BY_BALANCE, CRUSHED, ELASTIC, rectangle_width, section_steps
from assess.study.stress_steps import State, Zone, resultant_steps

PROJECT = "project"
SHIFT = "thesis 6.3.1.2"
SHIFT_SAID = "fixed hinge: resultant as crushing begins"
OPENS, CRUSHES = "rotation at which the far edge opens", "rotation at which crushing begins"
WITHIN = 1e-9  # of the strength: an edge that opens at it does so before it crushes


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
    lines = [*section_steps(section)]
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
        return (*first, step("a_SF", SHIFT_SAID, SHIFT, "none", 0.0, "m", remark=never))
    return (*first, *_crushing_steps(joint, normal_force, crushing))


def _opening_steps(joint: Joint, N: float, opening: float) -> tuple[Step, ...]:
    """Write the rotation of opening, before crushing or, under more than half of what a rectangle bears, after it."""
    section, k, f = joint.section, joint.law.stiffness, joint.law.strength
    b, A, x_c, width = section.depth, section.area, section.centroid, rectangle_width(section)
    given: Given = {"N": (N, "N"), "k": (k, "Pa/m"), "b": (b, "m")}
    before = k * opening * b <= f * (1.0 + WITHIN)
    if width is not None:
        given = {**given, "l": (width, "m")}
        if before:
            return (step("φ_o", OPENS, "thesis 6.2", "2 N / (k l b²)", opening, "rad", given=given),)
        given = {**given, "f": (f, "Pa")}
        return (step("φ_o", OPENS, BALANCE, "f / (2 k (b − N / (f l)))", opening, "rad", given=given),)
    if before:
        given = {**given, "A": (A, "m2"), "x_c": (x_c, "m")}
        return (step("φ_o", OPENS, BALANCE, "N / (k A (b − x_c))", opening, "rad", given=given),)
    found = step("φ_o", OPENS, BALANCE, BY_BALANCE, opening, "rad")
    return (found, *_opening_checks(joint, N, opening))


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
    checks, _ = resultant_steps(State(joint.section, "o", zones, ("N", N)))
    return (*lines, *checks)


def _crushing_steps(joint: Joint, N: float, crushing: float) -> tuple[Step, ...]:
    """Write the contact as its edge begins to crush, and from it a_SF."""
    section, k, f = joint.section, joint.law.stiffness, joint.law.strength
    b, width = section.depth, rectangle_width(section)
    found = contact(section, joint.law, normal_force=N, rotation=crushing)
    a = f / (k * crushing)
    pressed: Given = {"N": (N, "N"), "f": (f, "Pa")}
    turned: Given = {"k": (k, "Pa/m"), "φ_c": (crushing, "rad")}
    if a < b:
        words, end = "depth of the contact then", 0.0
        lines: tuple[Step, ...] = (
            step("a_c", words, BALANCE, BY_BALANCE, a, "m")
            if width is None
            else step("a_c", words, "thesis 6.3", "2 N / (f l)", a, "m", given={**pressed, "l": (width, "m")}),
            step("φ_c", CRUSHES, "thesis 6.4", "f / (k a_c)", crushing, "rad",
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
    checks, arm = resultant_steps(State(section, "c", (zone,), ("N", float(found.normal_force[0]))))
    shift = semi_flexible_shift(section, joint.law, normal_force=N)
    return (*lines, *checks, replace(arm, symbol="a_SF", description=SHIFT_SAID, clause=SHIFT, value=shift))
