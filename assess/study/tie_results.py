"""Ties that stretch as results: stiffness, yield, anchorage, what fails first, and the sheet of the anchorage.

Where no clause gives a formula the sheet says whose it is: derived here, or from memory of a printed text.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import inf

from assess.codes.calculation_sheet import Given, Step, step
from assess.loads.anchorage import (
    GAMMA_M,
    GAMMA_M0,
    GAMMA_M2,
    RISING,
    THREAD,
    VERTICAL,
    Anchorage,
    Link,
    LinkName,
    bar_strength,
    bond_strength,
    courses_under,
    plate_area,
    punching_strength,
    round_cone,
    shear_strength,
)
from assess.loads.far_wall import FarWall
from assess.loads.load import DUCTILE, Tie, stretches
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, Severity, Term, Value, message
from assess.results import StretchingTie

OWN = "own derivation, of no clause"
OF_BARS = "EN 1993-1-1 6.2.3, from memory of the printed text"
OF_THREADS = "EN 1993-1-8 table 3.4, from memory of the printed text"
OF_ARCHES = "EN 1996-1-1 6.3.2, from memory of the printed text"
OF_RIGID = "EN 1998-1 4.3.5.2, from memory of the printed text"
OF_CONES = "own derivation, of no clause; its round outline is read in a design note"
PROJECT = "project"
NOT_ANSWERED = "not answered: the project does not give what it needs"
AS_STATED = "as stated"
STATED = Term("the anchorage fails")
FAILS: Mapping[LinkName, Term] = {
    "thread": Term("the thread of the bar breaks"),
    "plate": Term("the plate bends"),
    "bearing": Term("the masonry under the plate crushes"),
    "punching": Term("the plate punches through the wall"),
    "sliding": Term("the units under the plate slide on their beds"),
    "between": Term("the wall between the ties gives way"),
    "far end": Term("the far end gives way"),
    "far wall": Term("the wall at the far end turns inwards"),
}
YIELDS = Term("the bar yields")
LETS_GO = Term("it lets go")


def tie_result(tie: Tie) -> StretchingTie | None:
    """Return a tie that stretches as a result; None for one of constant force."""
    if tie.stiffness is None:
        return None
    known = tie.strength is not None
    return StretchingTie(
        stiffness_n_m=tie.stiffness,
        slack_m=tie.slack,
        yield_n=tie.yield_force or 0.0,
        anchorage_n=tie.strength,
        ductile=tie.ductile if known else None,
        fails=(LETS_GO if tie.is_spring else YIELDS if tie.ductile else _link(tie)) if known else None,
        gone_m=tie.elongation if known else None,
        steps=() if tie.anchorage is None else tuple(_steps(tie, tie.anchorage)),
    )


def tie_messages(mechanism: Mechanism) -> Iterator[Message]:
    """Yield a warning for each tie that stretches whose anchorage fails before its bar yields, and for its far wall.

    The far wall is told where it holds less than what is stated of the far end, or turns by itself.
    """
    where = f"mechanisms.{mechanism.name}"
    for tie in mechanism.positive.loads:
        if not stretches(tie) or tie.is_spring:
            continue
        if tie.strength is not None and not tie.ductile:
            values: dict[str, Value] = {
                "load": tie.name,
                "link": _link(tie),
                "strength": Quantity(tie.strength, "force", 3),
                "yielding": Quantity(tie.yield_force or 0.0, "force", 3),
                "spare": Quantity(DUCTILE, figures=3),
                "elongation": Quantity(tie.elongation or 0.0, "short length", 3),
            }
            yield message("tie-brittle", values, severity=Severity.WARNING, where=where)
        if tie.anchorage is not None and (wall := tie.anchorage.far_wall) is not None:
            values = {
                "load": tie.name,
                "body": wall.body,
                "crack": Quantity(wall.crack, "length", 3),
                "action": Quantity(wall.action, figures=3),
                "strength": Quantity(wall.strength, "force", 3),
            }
            given = (tie.anchorage.plate.far_strength, tie.anchorage.stated)
            stated = min((each for each in given if each), default=0.0)
            if not tie.anchorage.far_wall_holds:
                values["multiplier"] = Quantity(wall.multiplier, figures=3)
                yield message("far-wall-falls", values, severity=Severity.WARNING, where=where)
            elif wall.strength < stated:
                values["stated"] = Quantity(stated, "force", 3)
                yield message("far-wall-less", values, severity=Severity.WARNING, where=where)


def far_end_conditions(mechanism: Mechanism) -> Iterator[Message]:
    """Yield the conditions of a pass on the walls at the far ends of ties, those of several ties as one."""
    found: dict[tuple[str, str, tuple[str, ...], str], list[str]] = {}
    for tie in mechanism.positive.loads:
        if not isinstance(tie, Tie) or tie.anchorage is None or not tie.anchorage.far_wall_holds:
            continue
        end = tie.anchorage.far_end
        if tie.anchorage.plate.hole is not None:
            found.setdefault(("far-cone-masonry", "", (), ""), []).append(tie.name)
        if end.unexamined not in ("", "held"):
            found.setdefault(("far-wall-unexamined", end.body, (), end.unexamined), []).append(tie.name)
        for key, bodies in (("far-wall-held", end.held_by), ("far-wall-part", end.stack)):
            if bodies:
                found.setdefault((key, end.body, bodies, ""), []).append(tie.name)
    for (key, body, bodies, why), ties in found.items():
        values: dict[str, Value] = {"what": ", ".join(ties)}
        if key == "far-wall-unexamined":
            values["reason"] = UNEXAMINED[why]
        elif bodies:
            values |= {"body": body, "bodies": ", ".join(bodies)}
        yield message(key, values, severity=Severity.WARNING)


def _link(tie: Tie) -> Term:
    """Return what of the anchorage fails first."""
    name = None if tie.anchorage is None else tie.anchorage.governing
    return STATED if name is None else FAILS[name]


def _steps(tie: Tie, of: Anchorage) -> Iterator[Step]:
    """Yield the lines of the sheet: bar, thread, plate, masonry, wall between the ties, far end, and their least."""
    bar: Given = {"A": (of.bar_area, "m2"), "f_y": (of.bar_yield, "Pa")}
    yield step("N_y", "force at which the bar yields", PROJECT, "A · f_y", tie.yield_force, "N", given=bar)
    design = bar_strength(A=of.bar_area, f_y=of.bar_yield)
    given: Given = {**bar, "γ_M0": GAMMA_M0}
    yield step("N_Rd", "design strength of the bar", OF_BARS, "A · f_y / γ_M0", design, "N", given=given)
    links = {link.name: link for link in of.links}
    plate, by = of.plate, {"γ_M": GAMMA_M, "FC": of.plate.confidence}
    thread: Given = {
        "k_2": THREAD,
        "A_s": (plate.thread_area or 0.0, "m2"),
        "f_u": (plate.tensile_strength or 0.0, "Pa"),
        "γ_M2": GAMMA_M2,
    }
    yield _link_step("N_1", "thread of the bar", OF_THREADS, "k_2 · A_s · f_u / γ_M2", links["thread"], thread)
    bent: Given = {
        "A_p": (plate_area(plate), "m2"),
        "t_p": (plate.thickness or 0.0, "m"),
        "f_yp": (plate.yield_stress or 0.0, "Pa"),
        "γ_M0": GAMMA_M0,
        "c": (plate.overhang or 0.0, "m"),
    }
    words = "plate in bending beyond its nut, washer or rib"
    yield _link_step("N_2", words, OWN, "A_p · t_p² · f_yp / (2 · γ_M0 · c²)", links["plate"], bent)
    pressed: Given = {"A_b": (of.site.bearing_area, "m2"), "f_h": (plate.bearing_strength or 0.0, "Pa"), **by}
    words = "masonry under the plate, as far as there is any behind it"
    yield _link_step("N_3", words, OWN, "A_b · f_h / (γ_M · FC)", links["bearing"], pressed)
    yield from _punching(of, links["punching"], by)
    yield from _sliding(of, links.get("sliding"))
    yield _between(of, links["between"], by)
    yield from _far_end(of, links["far end"], by)
    yield from _far_wall(of, of.far_wall)
    stated = of.stated is not None
    at: Given = {"N_typed": (of.stated or 0.0, "N")} if stated else {}
    words = "strength of the anchorage, the least of these and of what is stated"
    why = "" if of.strength else NOT_ANSWERED
    yield step("N_a", words, OWN, "min(N_1, …, N_8)", of.strength, "N", at=at, remark=why)
    if of.strength is not None:
        ratio: Given = {"N_a": (of.strength, "N"), "N_y": (tie.yield_force or 0.0, "N")}
        words = "spare of the anchorage over the bar: from 1.25 on the bar is taken to yield first"
        yield step("r", words, OWN, "N_a / N_y", of.strength / (tie.yield_force or inf), given=ratio)


def _link_step(symbol: str, description: str, clause: str, formula: str, link: Link, given: Given) -> Step:
    """Write the strength of a link; where it is not answered, what it lacks."""
    if link.strength is None:
        lacks = ", ".join(link.missing)
        return step(symbol, description, clause, formula, None, "N", remark=NOT_ANSWERED, subject=lacks)
    if link.strength == inf:
        return step(symbol, description, clause, formula, None, "N", remark=NO_LIMIT)
    return step(symbol, description, clause, formula, link.strength, "N", given=given)


NO_LIMIT = "no limit"
NOT_EXAMINED = "not examined: the project does not give the units"
UNEXAMINED: Mapping[str, Term] = {
    "no wall": Term("no wall is drawn at the anchor"),
    "no site": Term("the project has no site that shakes it"),
    "no loads": Term("what it carries is not known"),
    "held": Term("what touches it from within stops it"),
    "pressed": Term("the tie presses it down above every crack"),
}
HOLDS_NOTHING = "less than 1 % of what the bar bears: it counts as nothing"
ARCH = "f_h / (γ_M · FC) · t² · h_s / s"
CLOSE_BY = "no limit: ties up to 3 m apart, and 1.5 m from the ends of the wall"


def _punching(of: Anchorage, link: Link, by: Mapping[str, float]) -> Iterator[Step]:
    plate = of.plate
    if link.strength is None or of.site.surface is None:
        yield _link_step("N_4", "punching of the leaf that the plate grips", OF_CONES, "S · f_vd / n", link, {})
        return
    given: Given = {"f_v0": (plate.shear_strength or 0.0, "Pa"), **by}
    formula = "f_v0 / (γ_M · FC)"
    if plate.friction:
        yield _compression(of)
        formula = "(f_v0 + μ · σ_n) / (γ_M · FC)"
        given = {**given, "μ": plate.friction, "σ_n": (of.normal_stress, "Pa")}
    S, n, weight = of.cone
    f_vd = punching_strength(plate, 1.0, 1, weight)
    words = "design strength of the masonry in shear along the cone"
    yield step("f_vd", words, OF_CONES, formula, f_vd, "Pa", given=given)
    yield step(
        "S",
        "surface of the cone through the leaf, of all plates whose cones meet, without what edges and openings cut off",
        OF_CONES,
        "from the drawing",
        S,
        "m2",
        at={"t": (of.leaf or 0.0, "m")},
    )
    given = {"S": (S, "m2"), "f_vd": (f_vd, "Pa"), "n": float(n)}
    yield _link_step("N_4", "punching of the leaf that the plate grips", OF_CONES, "S · f_vd / n", link, given)


def _sliding(of: Anchorage, link: Link | None) -> Iterator[Step]:
    """Yield the lines of units that slide on their beds before a cone breaks them; where they are not given, that."""
    words = "units under the plate that slide on their beds; head joints bear nothing"
    if link is None:
        yield step(
            "N_8", words, OWN, "S_b · f_vd", None, "N", remark=NOT_EXAMINED, subject="plate.course, plate.overlap"
        )
        return
    plate, n = of.plate, courses_under(of.plate.sides[1], of.plate.course or inf)
    given: Given = {
        "t": (of.leaf or 0.0, "m"),
        "b": of.site.beds,
        "a": (plate.sides[0], "m"),
        "n": float(n),
        "o": (plate.overlap or 0.0, "m"),
    }
    surface, beds = of.sliding_surface, "beds of these units that rub, those above and below them and at their ends"
    yield step("S_b", beds, OWN, "t · (b · a + 2 · (n − 1) · o)", surface, "m2", given=given)
    sheared = {"f_v0": plate.shear_strength or 0.0, "mu": plate.friction, "sigma_n": of.normal_stress}
    f_vd = shear_strength(**sheared, gamma_M=GAMMA_M, FC=plate.confidence)
    yield _link_step("N_8", words, OWN, "S_b · f_vd", link, {"S_b": (surface, "m2"), "f_vd": (f_vd, "Pa")})


def _compression(of: Anchorage) -> Step:
    """Write the compression around a cone, as stated or of the masonry above."""
    words = "least compression around the cone: weight of the masonry above it, less the vertical motion"
    if of.plate.normal_stress is not None:
        return step("σ_n", words, PROJECT, AS_STATED, of.normal_stress, "Pa")
    weight: Given = {"ψ_v": RISING, "k_v": VERTICAL, "σ_w": (of.cone[2], "Pa")}
    return step("σ_n", words, OWN, "(1 − ψ_v · k_v) · σ_w", of.normal_stress, "Pa", given=weight)


def _between(of: Anchorage, link: Link, by: Mapping[str, float]) -> Step:
    words, plate, site = "wall between the ties, as a level arch", of.plate, of.site
    if plate.between is not None:
        return step("N_5", words, PROJECT, AS_STATED, plate.between, "N")
    if link.strength == inf:
        return step("N_5", words, OWN, ARCH, None, "N", remark=CLOSE_BY, at={"s": (site.bay or 0.0, "m")})
    given: Given = {
        "f_h": (plate.bearing_strength or 0.0, "Pa"),
        **by,
        "t": (of.leaf or 0.0, "m"),
        "h_s": (of.strip, "m"),
        "s": (site.bay or 0.0, "m"),
    }
    return _link_step("N_5", words, OF_ARCHES, ARCH, link, given)


def _far_end(of: Anchorage, link: Link, by: Mapping[str, float]) -> Iterator[Step]:
    plate, words = of.plate, "what holds the far end"
    if plate.far_strength is not None:
        yield step("N_6", words, PROJECT, AS_STATED, plate.far_strength, "N")
        return
    if link.strength is None or plate.hole is None or plate.embedment is None or plate.bond_strength is None:
        yield _link_step("N_6", words, OWN, AS_STATED, link, {})
        return
    d, length, f_b = plate.hole, plate.embedment, plate.bond_strength
    hole: Given = {"d": (d, "m"), "l": (length, "m")}
    bond = bond_strength(d=d, l=length, f_b=f_b, gamma_M=GAMMA_M, FC=plate.confidence)
    given: Given = {**hole, "f_b": (f_b, "Pa"), **by}
    yield step("N_b", "bond of the injected far end", OWN, "π · d · l · f_b / (γ_M · FC)", bond, "N", given=given)
    f_v0, FC = plate.shear_strength or 0.0, plate.confidence
    drawn = of.far_end.cone
    surface = round_cone(d, length) if drawn is None else drawn
    cone = surface * shear_strength(f_v0=f_v0, mu=0.0, sigma_n=0.0, gamma_M=GAMMA_M, FC=FC)
    sheared: Given = {"f_v0": (f_v0, "Pa"), **by}
    words = "cone of masonry around the injected far end"
    if drawn is None:
        formula, given = "π · (d + l) · l · f_v0 / (γ_M · FC)", {**hole, **sheared}
    else:
        formula, given = "S_c · f_v0 / (γ_M · FC)", {"S_c": (drawn, "m2"), **sheared}
        edges = (
            "surface of the cone of the injected far end that edges of its wall and cones of its neighbours leave to it"
        )
        yield step("S_c", edges, OF_CONES, "from the drawing", drawn, "m2", at={"l": (length, "m")})
    yield step("N_c", words, OF_CONES, formula, cone, "N", given=given)
    least: Given = {"N_b": (bond, "N"), "N_c": (cone, "N")}
    yield step("N_6", "what holds the far end", OWN, "min(N_b, N_c)", link.strength, "N", given=least)


def _far_wall(of: Anchorage, wall: FarWall | None) -> Iterator[Step]:
    """Yield the lines of the wall at the far end as a mechanism of its own; where it is none, that."""
    turns, formula = (
        "wall at the far end that turns inwards, by virtual work; its ties share it evenly",
        "(M_s − α · M_h) / Σh",
    )
    if wall is None:
        why = str(UNEXAMINED[of.far_end.unexamined])
        yield step("N_7", turns, OWN, formula, None, "N", remark=why, subject=of.far_end.body)
        return
    given: Given = {"FC": wall.FC, "a_gS": wall.pga, "r_Z": wall.rise}
    words = "peak acceleration over g at the crack of the wall at the far end"
    yield step(
        "α", words, OF_RIGID, "FC · a_gS · (1 + 1.5 · r_Z)", wall.action, given=given, at={"z": (wall.crack, "m")}
    )
    given = {
        "M_s": (wall.stabilising, "N m"),
        "α": wall.action,
        "M_h": (wall.overturning, "N m"),
        "Σh": (wall.levers, "m"),
    }
    why = "" if of.far_wall_holds else HOLDS_NOTHING
    at: Given = {"l": (wall.length, "m"), "n": float(wall.ties)}
    yield step("N_7", turns, OWN, formula, wall.strength, "N", given=given, at=at, remark=why, subject=wall.body)
