"""The joints of a mechanism: table, figures, and what they carry in the governing record."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from assess.results import ContactSheet, MechanismResult
from reports import governing, joints
from reports.chapters.cells import BRANCHES
from reports.document import Block, Cell, Column, Figure, Prose, Sheet, Table
from reports.figures import contact, moment_rotation
from reports.language.texts import Listing, Phrase, Text, Verbatim, quantity, say, say_count

RIGID, UNLIMITED, NEVER = say("rigid"), say("unlimited"), say("never")
PRIMED = "'"  # of hinges of the negative branch
LEAST_SHARE = 0.005  # of a joint below which a part is called less than 1 %


def blocks(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return table, figures and sentence on the joints of a mechanism; none where all are rigid."""
    if not joints.deformable_joints(mechanism):
        return []
    moment = say(
        "Restoring moment of the positive branch over rotation, divided by the largest with rigid joints: with rigid "
        "joints, with hinges fixed at a_SF, and with the joints of this mechanism (as thesis Fig. 8.8). Open circle: "
        "a joint begins to open; filled: its edge begins to crush."
    )
    pressed = say(
        "Each joint over the rotation of the mechanism, on a logarithmic axis: distance of the resultant from the "
        "compressed edge, and the stress at that edge. Joints that are alike share a line; dashed: negative branch."
    )
    return [
        table(mechanism, name=f"{stem}-interfaces"),
        Prose((at_peak(mechanism),)),
        Figure(f"{stem}-moment", moment, partial(moment_rotation.draw, mechanism)),
        Figure(f"{stem}-contact", pressed, partial(contact.draw, mechanism)),
        *sheets(mechanism, stem),
    ]


def sheets(mechanism: MechanismResult, stem: str) -> list[Sheet]:
    """Return the calculation sheet of each joint that is unlike those before it, its force at rest to its stresses."""
    found: dict[tuple[str, ...], list[ContactSheet]] = {}
    for each in mechanism.contact_sheets:
        found.setdefault(_as_printed(each), []).append(each)
    return [_sheet(alike, stem) for alike in found.values()]


def _as_printed(sheet: ContactSheet) -> tuple[str, ...]:
    return tuple(f"{each.symbol} {each.subject} {each.substituted}" for each in sheet.steps)


def _sheet(alike: Sequence[ContactSheet], stem: str) -> Sheet:
    first, hinges = alike[0], Listing(tuple(Verbatim(each.hinge) for each in alike))
    name = f"{stem}-contact-{first.hinge.replace(PRIMED, '-negative')}"
    caption = say_count(
        "Contact of joint {hinges}: force at rest, section, opening and crushing, the fixed hinge a_SF, and the "
        "stresses where the multiplier is largest (m) and at overturning (u).",
        "Contact of joints {hinges}: force at rest, section, opening and crushing, the fixed hinge a_SF, and the "
        "stresses where the multiplier is largest (m) and at overturning (u).",
        len(alike),
        hinges=hinges,
    )
    return Sheet(name, caption, first.steps)


def table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate every hinge of both branches with the contact that it presses on."""
    columns = (
        Column(say("Hinge")),
        Column(say("Model"), share=0.16),
        Column(say("Stiffness"), "stiffness"),
        Column(say("Strength"), "stress"),
        Column(say("Force at rest"), "force"),
        Column(say("Area"), "area"),
        Column(say("Depth"), "length"),
        Column(say("Opens at"), "rotation"),
        Column(say("Crushes at"), "rotation"),
    )
    caption = say(
        "Joints under the hinges. Depth: along the motion; rotations: of the joint itself, under its force at rest, at "
        "which it begins to open and its edge to crush."
    )
    return Table(name, caption, columns, tuple(map(_row, mechanism.interfaces)), small=True)


def _row(found: dict[str, Any]) -> tuple[Cell, ...]:
    start = (Verbatim(found["hinge"]), joints.MODELS[found["model"]])
    if found["curve"] is None:
        return (*start, RIGID, UNLIMITED, found["normal_force_n"], None, None, found["opening_rad"], NEVER)
    return (
        *start,
        RIGID if found["stiffness_pa_m"] is None else found["stiffness_pa_m"],
        UNLIMITED if found["strength_pa"] is None else found["strength_pa"],
        found["normal_force_n"],
        found["area_m2"],
        found["depth_m"],
        NEVER if found["opening_rad"] is None else found["opening_rad"],
        NEVER if found["crushing_rad"] is None else found["crushing_rad"],
    )


def at_peak(mechanism: MechanismResult) -> Text:
    """Describe what the joints carry at the largest rotation of the governing record."""
    found = governing.history(mechanism)
    if found is None:
        return say("No time history was run: the contact stress at the peak of a record is not known.")
    one, _ = found
    record, pga = Verbatim(one.record), quantity(one.level_pga_g, "ground acceleration")
    if one.max_rotation_rad is None:
        return say(
            "The governing record ({record}, PGA {pga}) overturns the mechanism: there is no peak rotation at which to "
            "give the contact stress.",
            record=record,
            pga=pga,
        )
    if one.max_rotation_rad == 0.0:
        return say("The governing record ({record}, PGA {pga}) does not move the mechanism.", record=record, pga=pga)
    turned = joints.peak_rotation(mechanism, one)
    pressed = tuple(_pressed(interface, turned) for interface in joints.joints_of_branch(mechanism, one.branch))
    return say(
        "At the largest rotation under the governing record ({record}, PGA {pga}), φ = {rotation} of the {branch} "
        "branch: {joints}.",
        record=record,
        pga=pga,
        rotation=quantity(turned, "rotation"),
        branch=BRANCHES[one.branch],
        joints=Listing(pressed),
    )


def _pressed(interface: dict[str, Any], rotation: float) -> Phrase:
    """Return stress, resultant, open and crushed parts of one joint at a rotation of the mechanism [rad]."""
    stress, resultant, opened, crushed = joints.values_at(interface, rotation)
    values: dict[str, Text] = {
        "hinge": Verbatim(interface["hinge"]),
        "stress": quantity(stress, "stress", 3),
        "resultant": quantity(resultant, "length", 3),
        "opened": _percent(opened),
        "crushed": _percent(crushed),
    }
    if interface["strength_pa"] is None:
        return say(
            "joint {hinge} presses with up to {stress}, resultant {resultant} from the edge, {opened} of it open and "
            "{crushed} crushed",
            **values,
        )
    return say(
        "joint {hinge} presses with up to {stress} (strength {strength}), resultant {resultant} from the edge, "
        "{opened} of it open and {crushed} crushed",
        strength=quantity(interface["strength_pa"], "stress", 3),
        **values,
    )


def _percent(share: float) -> Text:
    if share == 0.0:
        return say("none")
    return quantity(100.0 * share, "percent", 2) if share >= LEAST_SHARE else say("less than 1 %")
