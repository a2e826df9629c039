"""The section of a contact as lines of a calculation sheet: its sizes, its area and its centroid."""

from __future__ import annotations

from assess.codes.calculation_step import Given, Step, step
from assess.interfaces.kernel.moments import BEGIN, RADIUS, W0, W1
from assess.interfaces.section import Section

BALANCE, GEOMETRY = "equilibrium", "geometry of the contact"
MOST_STRIPS = 6
"""Strips that are worked one by one; of outlines with more, and of discs, integrals are given over a whole zone."""
BY_BALANCE = "found by equilibrium: the resultant of the stresses is N"
CRUSHED, ELASTIC = "depth crushed, at the strength", "depth of the elastic zone"
CENTROID = "centroid from the compressed edge"
AREA = "area of the contact"


def rectangle_width(section: Section) -> float | None:
    """Return the width of a section that is a rectangle along the motion [m]; None for any other."""
    if len(section.pieces) != 2:
        return None
    slope, width = float(section.pieces[0, W1]), float(section.pieces[0, W0])
    return width if abs(slope) * section.depth <= 1e-12 * width else None


def section_steps(section: Section) -> tuple[Step, ...]:
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
    width = rectangle_width(section)
    if width is None:
        return (depth, *_piece_steps(section))
    sizes: Given = {"b": (section.depth, "m"), "l": (width, "m")}
    return (
        depth,
        step("l", "width of the contact, across the motion", GEOMETRY, "given", width, "m"),
        step("A", AREA, GEOMETRY, "b l", section.area, "m2", given=sizes),
    )


def _disc_steps(section: Section) -> tuple[Step, ...]:
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


def _piece_steps(section: Section) -> tuple[Step, ...]:
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
