"""Sentences on a mechanism, and the captions of its figures."""

from __future__ import annotations

from assess.results import MechanismResult, Results, View
from reports.language.lettering import truncate
from reports.language.lists import join_names
from reports.language.measures import measure, measures
from reports.language.message_text import message_text
from reports.mechanism_title import mechanism_title

KINDS = {
    "single-block": "a single rocking block",
    "two-block": "a wall held at its top and bottom that cracks between them (two blocks)",
    "four-hinge": "a chain of three blocks with four hinges",
    "equivalent-block": "an equivalent block, given by its rocking parameters instead of a geometry",
}


def description(mechanism: MechanismResult) -> str:
    """Describe in one sentence what the mechanism is and how it was analysed."""
    sides = (
        "rocks to both sides" if mechanism.sides == "two" else ("rocks to one side only, stopped by what is behind it")
    )
    equation = {"exact": "exact", "linearised": "linearised (thesis 3.9)"}[mechanism.equation]
    name = "" if mechanism.label in ("", mechanism.name) else f" “{mechanism.label}”"
    kind = KINDS.get(mechanism.kind, mechanism.kind)
    carried = (
        "the ground motion acts at its base"
        if mechanism.amplification.height_m is None
        else "in the time histories the ground motion is amplified up to its base"
    )
    return (
        f"Mechanism {mechanism.name}{name} is {kind}. It {sides}; {carried}; time histories solve the {equation} "
        f"equation of motion. Coefficient of restitution: {mechanism.restitution_source}."
    )


def amplification(mechanism: MechanismResult) -> tuple[str, ...]:
    """Describe how the ground motion reaches the base of a mechanism above the ground."""
    found = mechanism.amplification
    factors = [each.factor for each in found.factors]
    span = "" if not factors else f" Peak accelerations at the base are {_span(factors)} times those at the ground."
    height = measure(found.height_m or 0.0, "m", figures=3)
    return (
        f"The time histories act at the base of the mechanism, {height} above the ground, not at the "
        f"ground (method {found.method}).{span} The code procedures based on a spectrum use their own "
        "floor clause or floor spectrum, so their input differs.",
        f"Derivation: {'; '.join(map(message_text, found.said))}.",
    )


def input_locations(mechanism: MechanismResult) -> str:
    """State where each procedure takes its input; empty where all do at one place."""
    at = {
        place: dict.fromkeys(check.procedure for check in mechanism.checks if check.input_at == place)
        for place in ("ground", "mechanism base")
    }
    if not (at["ground"] and at["mechanism base"]):
        return ""
    return (
        f"The inputs differ: {join_names(at['mechanism base'])} by the motion at the base of the "
        f"mechanism, {join_names(at['ground'])} by that at the ground. Peak ground accelerations (PGA) "
        "refer to the ground throughout."
    )


def unequal_inputs(results: Results) -> tuple[str, ...]:
    """State which mechanisms have histories with another input than the ground's, for a comparison."""
    carried = [m for m in results.mechanisms if m.amplification.height_m is not None and m.histories]
    if not carried:
        return ()
    names = join_names(dict.fromkeys(truncate(mechanism_title(mechanism), 40) for mechanism in carried))
    return (
        f"The inputs differ: the time histories of {names} act at the base of the mechanism, amplified; "
        "those of the others act at the ground. The table of procedures gives the input of each.",
    )


def amplification_caption(mechanism: MechanismResult) -> str:
    """Return the caption of a filtered motion and its original."""
    motion = mechanism.amplification.motion
    name = "" if motion is None else motion.record
    return (
        f"{name}, scaled to the site’s spectrum, at the ground and at the base of the mechanism: acceleration over "
        "time and response spectra of 5 % damping. It is the record whose peak is amplified most."
    )


def _span(factors: list[float]) -> str:
    least, most = min(factors), max(factors)
    return f"{most:.3g}" if most - least < 5e-4 * most else f"{least:.3g} to {most:.3g}"


def capacity_caption(mechanism: MechanismResult) -> str:
    """Return the caption of the capacity curve, with its marks."""
    on_joints = mechanism.oscillator.overturning_flexible_rad is not None
    marks = (
        "Marks: overturning rotation of the positive branch, the dot with rigid joints, the square on its joints."
        if on_joints
        else "The dot marks the overturning rotation."
    )
    return f"Capacity curve: restoring moment and load multiplier λ over rotation. {marks}"


def sketch_caption(mechanism: MechanismResult) -> str:
    """Return the caption of the drawing of a mechanism."""
    drawing = mechanism.drawing
    back = drawing.displaced_negative
    turned = f"turned by φ = {drawing.displaced.rotation_rad:.2g} rad in its direction"
    turned += "" if back is None else f" and by φ = {back.rotation_rad:.2g} rad against it"
    hinges = "hinges A, B, … (circles, red)" if len(drawing.displaced.hinges) > 1 else "hinge A (circle, red)"
    hinges += "" if back is None else " and those of the negative branch (blue, with a prime)"
    loads = (
        "; loads: a dot for a mass, an arrow for a force, a tie or a weight that is carried" if drawing.loads else ""
    )
    centroids = "Centroid (cross) G"
    centroids = "Centroids of the blocks G1, G2, … and of all G" if len(drawing.centroids) > 1 else centroids
    stays = " Grey masonry does not move." if drawing.fixed else ""
    return (
        f"The mechanism in its plane of motion, to scale, at rest and {turned} (dashed: at rest). "
        f"{centroids}; {hinges}{loads}.{stays}"
    )


def view_caption(seen: View) -> str:
    """Return the caption of the picture of the bodies."""
    size = measures(seen.size, "m", figures=3, between=" × ")
    stays = " Grey masonry does not move." if -1 in seen.block_of else ""
    cut = " Thin dashes: the section at which it separates." if seen.sections else ""
    light = "" if len(seen.triangles) == seen.given else f" Simplified for drawing from {seen.given} triangles."
    return (
        f"The bodies in space, {size} along x, y and z: axis of rotation (red), of the negative "
        f"branch (blue, dashed), and direction of motion (arrow).{stays}{cut}{light}"
    )
