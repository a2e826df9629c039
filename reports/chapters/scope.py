"""What this report covers, the limits of its methods that matter for these results, and what it refers to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite

from assess.codes.check import Check, Outcome, Reason
from assess.messages.message import Message
from assess.results import MechanismResult, Results
from reports import joints
from reports.chapters import methods, missing_inputs, references, verdict
from reports.chapters.mechanism_list import mechanism_list
from reports.document import Block, Items, Prose, Section, nonempty
from reports.language.texts import Paragraph, Term, Text, Verbatim, listing, quantity, say, say_count
from reports.project_text import project_text
from reports.titles import mechanism_number, procedure_title

SLIDING = "sliding"
GROUND_AT_HEIGHT = "ground-motion"  # key of a remark


def sections(results: Results) -> list[Section]:
    """Return scope and limits, then methods with their editions, then references."""
    limits = tuple(limits_of(results))
    blocks: list[Block] = [
        Prose((scope(results),)),
        *_notes(results),
        Prose((say("Limits that matter for these results:"),)),
        Items(limits),
    ]
    return [
        Section(say("Scope and limits"), 0, (*blocks, *_left_over(results))),
        Section(
            say("Codes and methods"),
            1,
            (*nonempty(methods.table(results)), *nonempty(methods.rules(results)), *_uncompared(results)),
        ),
        Section(say("References"), 1, (Items(references.cited_works(results)),)),
    ]


def _notes(results: Results) -> list[Block]:
    """Return what the engineer notes on the project, which may restrict the results."""
    notes = project_text(results, "notes").strip()
    return [Prose((say("Notes: {notes}", notes=Verbatim(notes)),))] if notes else []


def scope(results: Results) -> Text:
    """Return what was assessed and what was not."""
    return Paragraph(
        (
            say_count(
                "This report assesses {number} local mechanism of masonry by rocking dynamics, at the action stated on "
                "the first page.",
                "This report assesses {number} local mechanisms of masonry by rocking dynamics, at the action stated "
                "on the first page.",
                len(results.mechanisms),
            ),
            say(
                "It does not assess walls in their own plane, floors, foundations or the ground, nor the response of "
                "the building as a whole."
            ),
            say("Finding the mechanisms that matter is the task of the engineer; the key plan lists them."),
        )
    )


def limits_of(results: Results) -> Iterator[Text]:
    """Yield the limits that apply to these results."""
    yield say(
        "The bodies are rigid between their joints and move in one vertical plane: bending and torsion of the masonry "
        "and out-of-plane coupling are not modelled."
    )
    yield from _of_histories(results)
    yield from _of_joints(results)
    yield sliding(results)
    yield from _of_input(results)
    yield from _of_equation(results)
    if len({check.procedure for check in _answered(results)}) > 1:
        yield say(
            "The methods allow different rotations and take different equivalent periods: their ratios D/C measure "
            "different margins and are not to be compared number by number."
        )


def _of_histories(results: Results) -> Iterator[Text]:
    if not any(mechanism.histories for mechanism in results.mechanisms):
        return
    yield say(
        "One rocking history cannot be predicted: a small change of the motion or the geometry can turn a large "
        "rotation into collapse or into rest. Only the statistics of many records are meaningful."
    )
    yield say(
        "Coefficients of restitution from formulas assume impacts without bouncing, which dissipate the most and are "
        "slightly unconservative (thesis 3.3). Tested values are better."
    )


def _of_joints(results: Results) -> Iterator[Text]:
    soft = [each.name for each in results.mechanisms if joints.deformable_joints(each)]
    rigid = [each.name for each in results.mechanisms if each.name not in soft]
    if rigid:
        yield say(
            "The joints of {mechanisms} are rigid and do not crush, which overestimates the resistance of large walls "
            "of weak masonry.",
            mechanisms=mechanism_list(results, rigid),
        )
    if soft:
        yield say(
            "The joints of {mechanisms} take no tension and are linear in compression up to the strength, then "
            "plastic; crushing leaves no memory, so that unloading recovers the deformation. Normal forces follow from "
            "static equilibrium, without the vertical inertia of the motion.",
            mechanisms=mechanism_list(results, soft),
        )


def sliding(results: Results) -> Text:
    """Return where friction was checked, and where it is only assumed to be sufficient."""
    unchecked = [each.name for each in results.mechanisms if not _is_checked(each)]
    assumed = _assumed_friction(results, unchecked)
    held = say("While a mechanism rocks, no sliding, no bouncing and no separation other than rocking are modelled.")
    if len(unchecked) == len(results.mechanisms):
        return Paragraph((assumed, held))
    checked = say("Sliding was checked by equilibrium up to the moment at which the mechanism starts to rock.")
    return Paragraph((checked, *((assumed,) if unchecked else ()), held))


def _assumed_friction(results: Results, unchecked: Sequence[str]) -> Text:
    """Return for which mechanisms friction is assumed, and how much of it the start of their motion needs."""
    which = mechanism_list(results, unchecked)
    needed = [
        (force.needed_friction, mechanism.name)
        for mechanism in results.mechanisms
        if mechanism.name in unchecked
        for force in mechanism.hinge_forces
        if force.needed_friction is not None and isfinite(force.needed_friction)
    ]
    if not needed:
        return say("Friction is assumed to be sufficient for {mechanisms}; it was not checked.", mechanisms=which)
    most, owner = max(needed)
    return say(
        "Friction is assumed to be sufficient for {mechanisms}; it was not checked. The start of the motion needs a "
        "coefficient of friction of up to {needed} ({mechanism}).",
        mechanisms=which,
        needed=quantity(most, figures=3),
        mechanism=Verbatim(mechanism_number(results, owner)),
    )


def _is_checked(mechanism: MechanismResult) -> bool:
    silent = (Outcome.NOT_APPLICABLE, Outcome.NOT_ANSWERED)
    return any(check.procedure == SLIDING and check.verdict not in silent for check in mechanism.checks)


def _of_input(results: Results) -> Iterator[Text]:
    """Yield mechanisms above the ground whose check takes the ground motion."""
    raised = [(m, check) for m in results.mechanisms for check in m.checks if _takes_ground_motion(check)]
    if raised:
        yield say(
            "The ground motion acts unamplified on {mechanisms}, which are above the ground, in these methods: "
            "{procedures}. That is unconservative where the building amplifies it: such an answer may fail a mechanism "
            "and cannot pass it.",
            mechanisms=mechanism_list(results, (mechanism.name for mechanism, _ in raised)),
            procedures=listing(map(procedure_title, dict.fromkeys(check.procedure for _, check in raised)), ""),
        )


def _takes_ground_motion(check: Check) -> bool:
    found = {check.reason.key, *(each.key for each in check.remarks)}
    return check.reading == "letter" and bool(found & {Reason.GROUND_MOTION, GROUND_AT_HEIGHT})


def _of_equation(results: Results) -> Iterator[Text]:
    linear = [each.name for each in results.mechanisms if each.equation == "linearised" and each.histories]
    if linear:
        yield say(
            "The histories of {mechanisms} solve the linearised equation of motion, accurate for slender bodies only.",
            mechanisms=mechanism_list(results, linear),
        )


def _left_over(results: Results) -> Iterator[Block]:
    """Yield conditions, missing inputs and warnings in full where page 1 shows only the first of them."""
    found = results.verdict
    if found is None:
        return
    lists: tuple[tuple[Text, list[Text]], ...] = (
        (say("All conditions of the verdict:"), verdict.conditions(results, found)),
        (say("All that is missing:"), missing_inputs.missing_texts(results, found)),
        (say("All warnings that bear on the verdict:"), verdict.warnings(results)),
    )
    for title, points in lists:
        if verdict.is_shortened(points):
            yield from (Prose((title,)), Items(tuple(points)))


def _uncompared(results: Results) -> Iterator[Block]:
    """Yield what could not be compared with the printed standards, each sentence once."""
    caveats: dict[str, tuple[Text, list[str]]] = {}
    for check in _answered(results):
        if check.reading == "letter":
            for caveat in caveats_of(check):
                caveats.setdefault(str(caveat), (caveat, []))[1].append(check.procedure)
    points: list[Text] = [
        say("{procedures}: {caveat}", procedures=listing(map(procedure_title, dict.fromkeys(used)), ""), caveat=caveat)
        for caveat, used in caveats.values()
    ]
    found = results.verdict
    points = [*(Term(each) for each in (() if found is None else found.uncompared)), *points]
    if points:
        yield Prose((say("Not compared with the printed standards, to be checked by the engineer:"),))
        yield Items(tuple(points))


def _answered(results: Results) -> list[Check]:
    every = (check for mechanism in results.mechanisms for check in mechanism.checks)
    return [check for check in every if check.verdict in (Outcome.PASS, Outcome.FAIL)]


def caveats_of(check: Check) -> tuple[Term | Message, ...]:
    """Return what could not be compared of a check; in results of older versions one text."""
    return check.caveats or ((Term(check.caveat),) if check.caveat else ())
