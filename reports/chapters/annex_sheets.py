"""Annex A: for each mechanism its parameters, loads, joints and hinges, and the sheets of the methods that decide."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from operator import attrgetter
from typing import Any

from assess.codes.calculation_sheet import Step
from assess.codes.check import Check
from assess.messages.message import Quantity
from assess.results import ContactSheet, HingeForceResult, LoadResult, MechanismResult, OscillatorResult, Results
from reports import governing
from reports.chapters.cells import BRANCHES, NONE, OUTCOMES
from reports.chapters.mechanism_page import left_for_annex
from reports.document import (
    NOTHING,
    Block,
    Cell,
    Column,
    Field,
    Figure,
    Prose,
    Section,
    Sheet,
    Table,
    nonempty,
    tabulate,
)
from reports.figures import capacity, sketch
from reports.figures.sketch import SEEN_FROM_ABOVE, model_of_view
from reports.language.texts import Listing, Phrase, Term, Text, Verbatim, quantity, say, say_count
from reports.mechanisms import (
    JOINT_MODELS,
    check_title,
    deformable_joints,
    file_stem,
    joints_of_branch,
    mechanism_number,
    mechanism_title,
    peak_rotation,
    values_at,
)

MARK = "A"


def sections(results: Results) -> list[Section]:
    """Return the annex, a part for each mechanism."""
    introduction = say(
        "The sheets are worked in SI units, as the constants of the clauses are printed. Each line gives the formula, "
        "the numbers put into it and the result, in enough digits to redo it by hand."
    )
    head = Section(say("Calculation sheets"), 0, (Prose((introduction,)),), starts_page=True, mark=MARK)
    parts = [_sheets_section(results, each, place) for place, each in enumerate(results.mechanisms, start=1)]
    return [head, *parts]


LIFTS, NOT_GIVEN, ROCKS_FIRST = say("lifts"), say("not given"), say("rocks first")

PARAMETERS: tuple[tuple[str, Phrase, str, str], ...] = (
    ("mass_kg", say("Moved mass"), "M", "mass"),
    ("inertia_kg_m2", say("Moment of inertia about the hinge"), "I", "inertia"),
    ("radius_m", say("Radius of the equivalent block"), "R", "length"),
    ("slenderness_rad", say("Slenderness of the equivalent block"), "α", "rotation"),
    ("p_eq_per_s", say("Frequency parameter"), "p", "angular frequency"),
    ("uplift_multiplier", say("Load multiplier at uplift"), "λ", "ratio"),
    ("overturning_rad", say("Overturning rotation, rigid"), "φₒᵥ", "rotation"),
    ("overturning_flexible_rad", say("Overturning rotation on its joints, from rest"), "", "rotation"),
    ("equilibrium_rad", say("Rotation at rest"), "φₑ", "rotation"),
    ("elastic_frequency_hz", say("Frequency of small motions about rest"), "", "frequency"),
    ("restitution", say("Coefficient of restitution"), "η", "ratio"),
    ("critical_rad", say("Rotation about which the equation is linearised"), "φ_cr", "rotation"),
    ("linearised.inertia_kg_m2", say("Linearised: inertia"), "I", "inertia"),
    ("linearised.stiffness_n_m_per_rad", say("Linearised: stiffness"), "K", "rotational stiffness"),
    ("linearised.excitation_kg_m", say("Linearised: excitation"), "B", "first moment"),
    ("linearised.moment_n_m", say("Linearised: moment of the applied forces"), "M", "moment"),
    ("linearised.overturning_rad", say("Linearised: overturning rotation"), "φₒᵥ = φ_cr − M/K", "rotation"),
    ("linearised.uplift_multiplier", say("Linearised: load multiplier"), "λ = K φₒᵥ / (g B)", "ratio"),
)
"""The way to each parameter in `OscillatorResult`, what it is called, its symbol and dimension."""


def parameters_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the rocking parameters of both branches."""
    branches = [(say("Positive branch"), mechanism.oscillator)]
    caption = say("Rocking parameters. The mechanism rocks to one side only.")
    if mechanism.oscillator_negative is not None:
        branches.append((say("Negative branch"), mechanism.oscillator_negative))
        caption = say("Rocking parameters of each branch, that is, of each direction of rotation.")
    columns = (Column(say("Parameter")), Column(say("Symbol"), share=0.2))
    rows = tuple(
        (label, Verbatim(symbol), *(_parameter_cell(branch, key, dimension) for _, branch in branches))
        for key, label, symbol, dimension in PARAMETERS
    )
    return Table(name, caption, (*columns, *(Column(title, share=0.18) for title, _ in branches)), rows, small=True)


LOAD_FIELDS: tuple[Field[LoadResult], ...] = (
    (Column(say("Load"), share=0.22), lambda load: Verbatim(load.name)),
    (Column(say("x"), "length"), lambda load: round(load.at[0], 9) + 0.0),
    (Column(say("z"), "length"), lambda load: round(load.at[1], 9) + 0.0),
    (Column(say("Mass"), "mass"), lambda load: load.mass_kg),
    (Column(say("Bearing")), lambda load: load.bearing),
    (Column(say("Force along"), "force"), lambda load: load.force_n and load.force_n[0]),
    (Column(say("Force up"), "force"), lambda load: load.force_n and load.force_n[1]),
    (Column(say("Found"), share=0.22), lambda load: Listing(load.found or (Term(load.source),), "")),
)


def loads_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the loads of each block and their source; of what moves in a level plane, by their place in plan."""
    if mechanism.kind in SEEN_FROM_ABOVE:
        caption = say(
            "Loads in plan, at x along the direction of motion and s along the wall; forces along the direction. Both "
            "halves of the panel take them at their centroids: only their horizontal inertia and push act on it."
        )
        across = (Column(say("s"), "length"), LOAD_FIELDS[2][1])
        return tabulate(name, caption, (*LOAD_FIELDS[:2], across, *LOAD_FIELDS[3:]), mechanism.loads, small=True)
    caption = say(
        "Loads, at x along the direction of motion and elevation z; forces along the direction and up. The weight of a "
        "non-bearing mass is carried elsewhere: only its horizontal inertia acts on the block."
    )
    return tabulate(name, caption, LOAD_FIELDS, mechanism.loads, small=True)


def _parameter_cell(branch: OscillatorResult, key: str, dimension: str) -> Cell:
    """Return a parameter of a branch with its unit; "none" where joints have no threshold of uplift."""
    value: float | None = attrgetter(key)(branch)
    if value is None:
        return NONE if key == "uplift_multiplier" else None
    return Quantity(value, dimension)


HINGE_FIELDS: tuple[Field[HingeForceResult], ...] = (
    (Column(say("Hinge")), lambda forces: Verbatim(forces.hinge)),
    (Column(say("Rocks from"), "ground acceleration"), lambda forces: forces.activation_g),
    (Column(Verbatim("H"), "force"), lambda forces: forces.horizontal_n),
    (Column(Verbatim("V"), "force"), lambda forces: forces.vertical_n),
    (Column(Verbatim("N"), "force"), lambda forces: forces.normal_n),
    (Column(Verbatim("T"), "force"), lambda forces: forces.shear_n),
    (
        Column(say("Friction needed"), "ratio", figures=3),
        lambda forces: LIFTS if forces.needed_friction is None else forces.needed_friction,
    ),
    (
        Column(say("Friction"), "ratio", figures=3),
        lambda forces: NOT_GIVEN if forces.friction is None else forces.friction,
    ),
    (Column(say("Slides from"), "ground acceleration"), lambda forces: _sliding_cell(forces)),
    (Column(say("Remark"), share=0.2), lambda forces: _hinge_remark(forces)),
)


def hinge_forces_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the forces at each hinge when the mechanism starts to rock, and the friction that they need."""
    caption = say(
        "Forces at the hinges when rocking starts, from equilibrium of the blocks: on the block that presses, H along "
        "the direction of the branch and V upwards, N normal to its faces and T along them. The mechanism slides "
        "before it rocks where |T| / N exceeds the friction of the joint."
    )
    return tabulate(name, caption, HINGE_FIELDS, mechanism.hinge_forces, small=True)


RIGID, UNLIMITED, NEVER = say("rigid"), say("unlimited"), say("never")
PRIMED = "'"  # of hinges of the negative branch
LEAST_SHARE = 0.005  # of a joint below which a part is called less than 1 %


def _if_tie(load: LoadResult, key: str) -> Cell:
    return NOTHING if (value := getattr(load.tie, key)) is None else value


DUCTILE, BRITTLE = say("ductile"), say("brittle")
TIE_FIELDS: tuple[Field[LoadResult], ...] = (
    (Column(say("Tie")), lambda load: Verbatim(load.name)),
    (Column(say("Stiffness"), "spring stiffness"), lambda load: _if_tie(load, "stiffness_n_m")),
    (Column(say("Slack"), "short length", figures=3), lambda load: _if_tie(load, "slack_m")),
    (Column(say("Bar yields"), "force", figures=3), lambda load: _if_tie(load, "yield_n")),
    (Column(say("Anchorage"), "force", figures=3), lambda load: _if_tie(load, "anchorage_n")),
    (Column(say("Fails first"), share=0.24), lambda load: _if_tie(load, "fails")),
    (Column(say("Kind")), lambda load: _kind_of_tie(load)),
    (Column(say("Gone at"), "short length", figures=3), lambda load: _if_tie(load, "gone_m")),
)


def _kind_of_tie(load: LoadResult) -> Cell:
    return NOT_GIVEN if load.tie is None or load.tie.ductile is None else DUCTILE if load.tie.ductile else BRITTLE


def ties_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the ties that stretch, with what fails first; no rows where there are none."""
    caption = say(
        "Ties that stretch: stiffness of the bar, the slack before it pulls, where it yields, strength of its "
        "anchorage, what fails first, and the elongation from rest at which it breaks or its anchorage fails. A tie is "
        "ductile where the anchorage has 1.25 times the force at which the bar yields."
    )
    ties = [load for load in mechanism.loads if load.tie is not None]
    return tabulate(name, caption, TIE_FIELDS, ties, small=True)


def anchorage_sheets(mechanism: MechanismResult, stem: str) -> Iterator[Sheet]:
    """Yield the calculation sheet of each anchorage that is computed and unlike those before it."""
    found: dict[tuple[str, ...], list[tuple[int, str, tuple[Step, ...]]]] = {}
    for place, load in enumerate(mechanism.loads, start=1):
        if load.tie is not None and (steps := load.tie.steps):
            printed = (*_as_printed(steps), *("" if each.value is None else f"{each.value:.5g}" for each in steps))
            found.setdefault(printed, []).append((place, load.name, steps))
    for alike in found.values():
        place, _, steps = alike[0]
        caption = say(
            "Anchorage of {tie}: what each part of it bears. No clause gives formulas for plates of ties: those "
            "derived for this program, or from memory of a printed text, are marked and left to the engineer’s "
            "judgement.",
            tie=Listing(tuple(Verbatim(name) for _, name, _ in alike)),
        )
        yield Sheet(f"{stem}-anchorage-{place:02d}", caption, steps)


def joint_blocks(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return table, figures and sentence on the joints of a mechanism; none where all are rigid."""
    if not deformable_joints(mechanism):
        return []
    moment = say(
        "Restoring moment of the positive branch over rotation, divided by the largest with rigid joints: with rigid "
        "joints, with hinges fixed at a_SF, and with the joints of this mechanism (as Mehrotra Fig. 8.8). Open circle: "
        "a joint begins to open; filled: its edge begins to crush."
    )
    pressed = say(
        "Each joint over the rotation of the mechanism, on a logarithmic axis: distance of the resultant from the "
        "compressed edge, and the stress at that edge. Joints that are alike share a line; dashed: negative branch."
    )
    return [
        joints_table(mechanism, name=f"{stem}-interfaces"),
        Prose((joints_at_peak(mechanism),)),
        Figure(f"{stem}-moment", moment, partial(capacity.draw_moment_rotation, mechanism)),
        Figure(f"{stem}-contact", pressed, partial(capacity.draw_contact, mechanism)),
        *contact_sheets(mechanism, stem),
    ]


def contact_sheets(mechanism: MechanismResult, stem: str) -> list[Sheet]:
    """Return the calculation sheet of each joint that is unlike those before it, its force at rest to its stresses."""
    found: dict[tuple[str, ...], list[ContactSheet]] = {}
    for each in mechanism.contact_sheets:
        found.setdefault(_as_printed(each.steps), []).append(each)
    return [_contact_sheet(alike, stem) for alike in found.values()]


def _as_printed(steps: Sequence[Step]) -> tuple[str, ...]:
    return tuple(f"{each.symbol} {each.subject} {each.substituted}" for each in steps)


def _contact_sheet(alike: Sequence[ContactSheet], stem: str) -> Sheet:
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


JointValues = dict[str, Any]
JOINT_FIELDS: tuple[Field[JointValues], ...] = (
    (Column(say("Hinge")), lambda joint: Verbatim(joint["hinge"])),
    (Column(say("Model"), share=0.16), lambda joint: JOINT_MODELS[joint["model"]]),
    (Column(say("Stiffness"), "stiffness"), lambda joint: _if_deformable(joint, "stiffness_pa_m", RIGID)),
    (Column(say("Strength"), "stress"), lambda joint: _if_deformable(joint, "strength_pa", UNLIMITED)),
    (Column(say("Force at rest"), "force"), lambda joint: joint["normal_force_n"]),
    (Column(say("Area"), "area"), lambda joint: _if_deformable(joint, "area_m2", None)),
    (Column(say("Depth"), "length"), lambda joint: _if_deformable(joint, "depth_m", None)),
    (Column(say("Opens at"), "rotation"), lambda joint: _opening_cell(joint)),
    (Column(say("Crushes at"), "rotation"), lambda joint: _if_deformable(joint, "crushing_rad", NEVER)),
)


def joints_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate every hinge of both branches with the contact that it presses on."""
    caption = say(
        "Joints under the hinges. Depth: along the motion; rotations: of the joint itself, under its force at rest, at "
        "which it begins to open and its edge to crush."
    )
    return tabulate(name, caption, JOINT_FIELDS, mechanism.interfaces, small=True)


def joints_at_peak(mechanism: MechanismResult) -> Text:
    """Describe what the joints carry at the largest rotation of the governing record."""
    found = governing.governing_history(mechanism)
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
    turned = peak_rotation(mechanism, one)
    pressed = tuple(_joint_at_peak(interface, turned) for interface in joints_of_branch(mechanism, one.branch))
    return say(
        "At the largest rotation under the governing record ({record}, PGA {pga}), φ = {rotation} of the {branch} "
        "branch: {joints}.",
        record=record,
        pga=pga,
        rotation=quantity(turned, "rotation"),
        branch=BRANCHES[one.branch],
        joints=Listing(pressed),
    )


def _sheets_section(results: Results, mechanism: MechanismResult, place: int) -> Section:
    stem = file_stem(mechanism.name, place)
    blocks: list[Block] = [
        *_view(mechanism, stem),
        *left_for_annex(results, mechanism, stem),
        parameters_table(mechanism, name=f"{stem}-parameters"),
        *nonempty(loads_table(mechanism, name=f"{stem}-loads")),
        *nonempty(ties_table(mechanism, name=f"{stem}-ties")),
        *anchorage_sheets(mechanism, stem),
        *joint_blocks(mechanism, stem),
        *nonempty(hinge_forces_table(mechanism, name=f"{stem}-hinge-forces")),
        *_check_sheets(results, mechanism, stem),
    ]
    return Section(
        Verbatim(mechanism_title(mechanism)), 1, tuple(blocks), mark=mechanism_number(results, mechanism.name)
    )


def _view(mechanism: MechanismResult, stem: str) -> list[Figure]:
    """Return the bodies of a mechanism in space, which a reader can turn; none without geometry."""
    bodies = mechanism.view
    if bodies is None:
        return []
    positive = len(mechanism.drawing.displaced.hinges)
    caption = say(
        "The bodies in space, cracks dashed; axes of rotation of the positive side red, of the negative side blue and "
        "dashed; the arrow is the direction of motion."
    )
    return [
        Figure(
            f"{stem}-view",
            caption,
            partial(sketch.draw_view, bodies, positive),
            model_of_view(bodies, positive=positive),
        )
    ]


def _check_sheets(results: Results, mechanism: MechanismResult, stem: str) -> list[Sheet]:
    checks = governing.worst_per_procedure(governing.checks_at_site(results, mechanism))
    shown = [check for check in checks if check.steps and _may_decide(results, check)]
    return [_check_sheet(check, mechanism, f"{stem}-sheet-{place:02d}") for place, check in enumerate(shown, start=1)]


def _may_decide(results: Results, check: Check) -> bool:
    """Return whether a check decides or its method is accepted; without a basis, whether it follows a code's letter."""
    accepted = () if results.verdict is None else results.verdict.methods
    return check.role == "deciding" or check.procedure in accepted or (not accepted and check.reading == "letter")


def _check_sheet(check: Check, mechanism: MechanismResult, name: str) -> Sheet:
    caption = say(
        "{method} ({edition}), {branch} branch, at PGA {pga}: {outcome}.",
        method=check_title(check, mechanism.checks),
        edition=Term(check.edition),
        branch=BRANCHES[check.branch],
        pga=quantity(check.level_pga_g, "ground acceleration"),
        outcome=_outcome(check),
    )
    return Sheet(name, caption, check.steps)


def _outcome(check: Check) -> Text:
    outcome = OUTCOMES[check.verdict.value]
    return say("{outcome}, deciding", outcome=outcome) if check.role == "deciding" else outcome


def _sliding_cell(forces: HingeForceResult) -> Cell:
    """Return the acceleration that slides the hinge; None where its friction is not known."""
    if forces.friction is None:
        return None
    return ROCKS_FIRST if forces.sliding_g is None else forces.sliding_g


def _hinge_remark(forces: HingeForceResult) -> Cell:
    if forces.held:
        return say("held at the top, by friction or an anchorage")
    return None if forces.face_found else say("faces taken as level")


def _if_deformable(joint: JointValues, key: str, otherwise: Cell) -> Cell:
    """Return a value of a joint that opens or crushes; `otherwise` where it is rigid or has none."""
    value: float | None = None if joint["curve"] is None else joint[key]
    return otherwise if value is None else value


def _opening_cell(joint: JointValues) -> Cell:
    value: float | None = joint["opening_rad"]
    return NEVER if value is None and joint["curve"] is not None else value


def _joint_at_peak(interface: JointValues, rotation: float) -> Phrase:
    """Return stress, resultant, open and crushed parts of one joint at a rotation of the mechanism [rad]."""
    stress, resultant, opened, crushed = values_at(interface, rotation)
    values: dict[str, Text] = {
        "hinge": Verbatim(interface["hinge"]),
        "stress": quantity(stress, "stress", 3),
        "resultant": quantity(resultant, "length", 3),
        "opened": _share_text(opened),
        "crushed": _share_text(crushed),
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


def _share_text(share: float) -> Text:
    if share == 0.0:
        return say("none")
    return quantity(100.0 * share, "percent", 2) if share >= LEAST_SHARE else say("less than 1 %")
