"""Sentences on a mechanism: what it is, how it moves, where it stands, what it carries."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import atan2, degrees

from assess.messages.message import Message, Severity
from assess.results import MechanismResult, Results
from reports import joints
from reports.chapters.mechanism_keys import split_key
from reports.language.texts import (
    Listing,
    Paragraph,
    Phrase,
    Term,
    Text,
    Verbatim,
    listing,
    names,
    quantity,
    say,
    say_count,
)

KINDS: Mapping[str, Phrase] = {
    "single-block": say("A single block"),
    "two-block": say("A wall held at its top and bottom, cracked between them into two blocks,"),
    "four-hinge": say("A chain of three blocks with four hinges"),
    "equivalent-block": say("An equivalent block, given by its rocking parameters instead of a geometry,"),
}
AMPLIFICATIONS: Mapping[str, Text] = {
    "modal-filter": say("filtered by the first mode"),
    "srss": say("thesis eq. 3.48"),
    "srss-relative": say("thesis eq. 3.48, for pulses 3.47"),
    "ec8": say("EN 1998-1, 4.3.5.2, for a rigid part"),
    "ec8-resonance": say("EN 1998-1, 4.3.5.2, at resonance"),
    "ec8-printed": say("thesis eq. 3.49"),
    "nzs1170.5": say("NZS 1170.5, 8.3"),
}
"""How the motion of the ground is carried up a building, by the methods of the project file."""
AXES: Mapping[int, str] = {0: "+x", 90: "+y", 180: "−x", -180: "−x", -90: "−y"}
ON_GROUND = 0.005  # height of a base that is on the ground [m]
FOUND = ("hinges-found-positive", "hinges-found-negative")  # notes that belong on the page
MOST = 5
"""Loads that are named in a sentence; of more only the number is given."""


def description(mechanism: MechanismResult) -> Paragraph:
    """Describe what the mechanism is and how it moves, where it stands, its joints and its loads."""
    return Paragraph((_motion(mechanism), *_base(mechanism), _joints(mechanism), *_loads(mechanism)))


def _motion(mechanism: MechanismResult) -> Text:
    kind = KINDS.get(mechanism.kind, Verbatim(mechanism.kind))
    way = direction(mechanism)
    if way is None:
        if mechanism.sides == "two":
            return say("{kind} that rocks to both sides.", kind=kind)
        return say("{kind} that rocks to one side only.", kind=kind)
    if mechanism.sides == "two":
        return say("{kind} that rocks to both sides, positive towards {direction}.", kind=kind, direction=way)
    return say("{kind} that rocks to one side only, towards {direction}.", kind=kind, direction=way)


def direction(mechanism: MechanismResult) -> Text | None:
    """Return the direction of positive rotation: an axis, or its angle; None for an equivalent block."""
    if mechanism.direction is None:
        return None
    along, across, _ = mechanism.direction
    angle = round(degrees(atan2(across, along)), 3)
    if angle in AXES:
        return Verbatim(AXES[int(angle)])
    return say("{angle} from +x towards +y", angle=quantity(atan2(across, along), "angle", 3))


def _base(mechanism: MechanismResult) -> Iterator[Text]:
    height, carried = mechanism.base_elevation_m, mechanism.amplification
    if height is not None and not mechanism.above_ground:
        yield say("Its base is on the ground.")
    elif height is not None and abs(height) < ON_GROUND and mechanism.input_height_m is not None:
        yield say(
            "Its base is on the ground, and it is held above: the input acts at the mean height of its supports, "
            "{height}.",
            height=quantity(mechanism.input_height_m, "length", 3),
        )
    elif height is not None:
        yield say("Its base is {height} above the ground.", height=quantity(height, "length", 3))
    if carried.height_m is not None:
        yield say(
            "In the time histories the ground motion is amplified up to it ({method}).",
            method=AMPLIFICATIONS.get(carried.method, Verbatim(carried.method)),
        )
    elif mechanism.above_ground and mechanism.histories:
        yield say("The time histories apply the ground motion to it unamplified.")
    if mechanism.direction_sweep is not None:
        yield say_count(
            "The direction is the only one tried.",
            "The direction is the weakest of {number} around the circle.",
            len(mechanism.direction_sweep.angle_deg),
        )


def _joints(mechanism: MechanismResult) -> Text:
    return say(
        "Joints: {model}; coefficient of restitution: {source}.",
        model=listing(joints.MODELS.get(model, Verbatim(model)) for model in joints.model_names(mechanism)),
        source=Listing(mechanism.restitution_said or (Term(mechanism.restitution_source),), ""),
    )


def _loads(mechanism: MechanismResult) -> Iterator[Text]:
    loads = mechanism.loads
    if len(loads) > MOST:
        yield say_count("It carries {number} load.", "It carries {number} loads.", len(loads))
    elif loads:
        yield say("Loads: {names}.", names=names(load.name for load in loads))


def representation(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """State the case that represents a mechanism that was swept."""
    for sweep in results.sweeps:
        if sweep.mechanism == mechanism.name and sweep.governs:
            yield say_count(
                "One value of {key} was studied; this page shows it: {value}.",
                "{number} values of {key} were studied; this page shows the most critical one: {value}.",
                len(sweep.value),
                key=Verbatim(sweep.key),
                value=swept_value(sweep.value[sweep.controlling], sweep.unit),
            )


def swept_value(value: float, unit: str) -> Text:
    """Return a value of a study in the unit in which the user wrote it."""
    shown = quantity(value, figures=10)
    return shown if unit == "-" else say("{value} {unit}", value=shown, unit=Verbatim(unit))


def warnings(results: Results, mechanism: MechanismResult) -> tuple[Message, ...]:
    """Return the warnings that concern the mechanism by its name, each once, and how its hinges were found."""
    found = (each for each in results.warnings if each.severity != Severity.NOTE or each.key in FOUND)
    own = {each.text: each for each in found if split_key(results, each.where)[0] == mechanism.name}
    return tuple(own.values())
