"""The end of the main part: what NTC 2018 10.2 asks of a calculation by computer, automatic controls, signatures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from hashlib import sha256

from assess.codes.bases import BASES
from assess.codes.check import Check, Family
from assess.codes.procedures import family_of
from assess.messages.message import Message
from assess.results import Control, ControlKind, MechanismResult, Results
from assess.results.verification import USES
from reports import document as doc
from reports.chapters.front_matter import author, checker, client, engineer, reference
from reports.language.texts import Paragraph, Phrase, Term, Text, Verbatim, listing, quantity, say, say_count
from reports.mechanisms import mechanism_list, numbered_title, procedure_title

ANALYSIS_KINDS: Mapping[Family, Phrase] = {
    Family.LINEAR: say(
        "{methods}: static and linear. The multiplier that starts the motion is compared with the spectrum reduced by "
        "q."
    ),
    Family.DISPLACEMENT: say(
        "{methods}: static and non-linear. The capacity curve, followed up to collapse, is compared with the "
        "displacement spectrum."
    ),
    Family.ENERGY: say(
        "{methods}: static and non-linear, by an equivalent oscillator that takes the same work up to the allowable "
        "rotation."
    ),
    Family.HISTORY: say(
        "{methods}: dynamic and non-linear. The equation of motion of the rocking mechanism is integrated under each "
        "record, with the loss of energy at each impact."
    ),
    Family.PART: say("{methods}: static and non-linear, as for a part of a building at its floor."),
    Family.TABLE: say("{methods}: a tabled limit of slenderness, without analysis."),
    Family.ELEMENT: say("{methods}: static and linear, as for a non-structural element at its floor."),
    Family.SLIDING: say("{methods}: static, by the energy that sliding takes up."),
    Family.FRICTION: say("{methods}: static, by equilibrium."),
}
"""The kind of analysis of each family of methods."""
FOLLOW_ROTATION = (Family.DISPLACEMENT, Family.ENERGY, Family.HISTORY, Family.PART)


def sections(results: Results) -> list[doc.Section]:
    """Return the chapter: analysis, program and controls, each with its own heading, and the box for the judgement."""
    return [
        doc.Section(chapter_title(results), 0, (doc.Prose(tuple(_analysis_sentences(results))),)),
        doc.Section(
            say("Program"),
            1,
            (doc.Facts(tuple(_program_facts(results))), doc.Prose((documentation(), *annex_texts(results)))),
        ),
        doc.Section(say("Automatic controls"), 1, tuple(_control_blocks(results))),
        doc.Section(say("Judgement"), 1, tuple(_judgement())),
    ]


def chapter_title(results: Results) -> Text:
    """Return the title of the chapter, with the clause that asks for it where an Italian code decides."""
    basis = None if results.verdict is None else BASES.get(results.verdict.basis)
    if basis is not None and basis.circular:
        return say("Calculation by computer (NTC 2018, 10.2)")
    return say("Calculation by computer")


def inputs_text(results: Results) -> Text:
    """Return one hash over those of all files read, with their number."""
    joined = "".join(each.sha256 for each in results.inputs).encode("ascii", "replace")
    return say_count(
        "{hash} ({number} file)",
        "{hash} (of the hashes of {number} files)",
        len(results.inputs),
        hash=Verbatim(sha256(joined).hexdigest() if len(results.inputs) > 1 else results.inputs[0].sha256),
    )


def documentation() -> Text:
    """Return what comes with the program."""
    return say(
        "Theory, field of use and examples that reproduce published cases, with their project files, come with the "
        "program. The same program and inputs give the same results, to the last digit, on one machine."
    )


def controls_summary(controls: tuple[Control, ...]) -> Text:
    """Return how many controls are met."""
    failed = sum(each.met is False for each in controls)
    made = sum(each.met is not None for each in controls)
    if failed:
        return say_count(
            "{number} automatic control of {made} is not met: the results of its mechanism are not to be used before "
            "the cause is known.",
            "{number} automatic controls of {made} are not met: the results of their mechanisms are not to be used "
            "before the cause is known.",
            failed,
            made=quantity(made, figures=12),
        )
    if not made:
        return say("No automatic control could be made.")
    return say_count(
        "The one automatic control that could be made is met.", "All {number} automatic controls made are met.", made
    )


def controls_table(results: Results) -> doc.Table:
    """Tabulate mechanism by control: relative differences, and both multipliers."""

    def made(mechanism: MechanismResult, kind: ControlKind) -> list[Control]:
        return [each for each in results.controls if each.mechanism == mechanism.name and each.kind == kind]

    def difference(kind: ControlKind) -> doc.Field[MechanismResult]:
        return doc.Column(_control_heading(results, kind)), lambda mechanism: _worst_difference(made(mechanism, kind))

    def by_hand(mechanism: MechanismResult) -> Control | None:
        return next(iter(made(mechanism, "hand-multiplier")), None)

    fields: tuple[doc.Field[MechanismResult], ...] = (
        (doc.Column(say("Mechanism"), share=0.26), lambda mechanism: numbered_title(results, mechanism.name)),
        difference("equilibrium"),
        difference("energy"),
        (
            doc.Column(say("Multiplier of the program"), "ratio", 5),
            lambda mechanism: None if (control := by_hand(mechanism)) is None else control.value,
        ),
        (
            doc.Column(say("Multiplier by hand"), "ratio", 5),
            lambda mechanism: None if (control := by_hand(mechanism)) is None else control.reference,
        ),
        difference("hand-multiplier"),
        difference("convergence"),
    )
    caption = say("Relative differences of the automatic controls. A dash stands for a control that was not made.")
    return doc.tabulate("controls", caption, fields, results.mechanisms if results.controls else (), small=True)


def controls_in_full(results: Results) -> doc.Table:
    """Tabulate every control with its numbers, for the spreadsheet and the CSV files."""
    fields: tuple[doc.Field[Control], ...] = (
        (doc.Column(say("Mechanism")), lambda each: numbered_title(results, each.mechanism)),
        (doc.Column(say("Control")), lambda each: CONTROL_TITLES[each.kind]),
        (doc.Column(say("Quantity")), lambda each: Term(each.quantity)),
        (doc.Column(say("Value")), lambda each: _value_text(each.value, each.dimension)),
        (doc.Column(say("Reference")), lambda each: _value_text(each.reference, each.dimension)),
        (doc.Column(say("Relative difference"), "ratio", 3), lambda each: each.difference),
        (doc.Column(say("Tolerance"), "ratio", 3), lambda each: each.tolerance),
        (doc.Column(say("Met")), lambda each: each.met),
        (doc.Column(say("Note")), lambda each: each.note),
    )
    caption = say("Every automatic control with its numbers.")
    return doc.tabulate("controls-in-full", caption, fields, results.controls)


SIGNED_STATEMENT = say(
    "The undersigned have examined the data, the choice of the mechanisms and the results of this report, and "
    "judge them fit for the purpose stated. The results hold for the inputs listed here and for no others."
)


def signature_sections(results: Results) -> list[doc.Section]:
    """Return the statement with the places to sign."""
    leader = engineer(results) or author(results)
    places: list[tuple[Text, Text]] = [(say("Engineer"), Verbatim(leader))]
    if author(results) not in ("", leader):
        places.insert(0, (say("Author"), Verbatim(author(results))))
    places.append((say("Checked by"), Verbatim(checker(results))))
    if client(results):
        places.append((say("Received for the client"), Verbatim(client(results))))
    blocks: tuple[doc.Block, ...] = (
        doc.Prose((SIGNED_STATEMENT,)),
        *_identity_facts(results),
        doc.Signatures(tuple(places)),
    )
    return [doc.Section(say("Signatures"), 0, blocks)]


def _analysis_sentences(results: Results) -> Iterator[Text]:
    """Yield the kind of analysis of the methods that decide, and why it was chosen."""
    deciding = [check for each in results.mechanisms for check in each.checks if check.role == "deciding"]
    yield from _kinds(deciding)
    if not deciding:
        yield say("No method decides; the kinds of analysis for comparison are listed under Codes and methods.")
    yield Paragraph(
        (
            _reason_for_rigid_bodies(deciding),
            say(
                "The seismic action is combined with the permanent loads of each mechanism; both directions of motion "
                "are analysed where the mechanism can rock both ways, and the worse one counts."
            ),
        )
    )
    yield say(
        "Loads, with their signs, are listed under Combination of actions and drawn on the page of each mechanism with "
        "its displaced shape, checks and units. Forces at the hinges and every step of the calculation are in annex A "
        "of the full report."
    )


def _reason_for_rigid_bodies(deciding: list[Check]) -> Text:
    """Return why the mechanisms are rigid bodies, with large rotations where a method that decides follows these."""
    if deciding and not any(family_of(check.procedure) in FOLLOW_ROTATION for check in deciding):
        return say(
            "Walls loaded out of their plane lose their equilibrium as nearly rigid bodies before their material "
            "fails: this is why the mechanisms are analysed as rigid bodies. The methods that decide do not follow "
            "them through large rotations."
        )
    return say(
        "Walls loaded out of their plane lose their equilibrium as nearly rigid bodies before their material "
        "fails, and hold well beyond the action that starts the motion: this is why the mechanisms are "
        "analysed as rocking bodies with large rotations."
    )


def _kinds(checks: list[Check]) -> Iterator[Text]:
    found: dict[Family, list[str]] = {}
    for check in checks:
        family = family_of(check.procedure)
        if family is not None:
            found.setdefault(family, []).append(check.procedure)
    for family, procedures in found.items():
        methods = listing(map(procedure_title, dict.fromkeys(procedures)))
        yield Phrase(ANALYSIS_KINDS[family].english, {"methods": methods})


def _program_facts(results: Results) -> Iterator[tuple[Text, Text]]:
    """Yield name, version, licence and origin of the program, and the hashes of program and inputs."""
    program = results.program
    facts = (
        (say("Program"), program.name),
        (say("Version"), program.version),
        (say("Licence"), program.licence),
        (say("Origin"), program.origin),
        (say("SHA-256 of the program"), program.sha256),
    )
    yield from ((label, Verbatim(text)) for label, text in facts if text)
    if results.inputs:
        yield say("SHA-256 of the inputs"), inputs_text(results)
    if results.stamp:
        yield say("Stamp of the results"), Verbatim(results.stamp)


def annex_texts(results: Results) -> Iterator[Text]:
    """Yield what the annex of verification says: cases, failures, its hashes, and what no case exercises."""
    annex = results.verification
    if annex is None:
        yield say(
            "These results name no annex of verification. The command {command} solves published cases again with this "
            "program and writes one.",
            command=Verbatim("assess verify --for PROJECT"),
        )
        return
    yield say_count(
        "Annex of verification: {file}, SHA-256 {hash}, with {number} solved case; {failures}.",
        "Annex of verification: {file}, SHA-256 {hash}, with {number} solved cases; {failures}.",
        annex.cases,
        file=Verbatim(annex.path),
        hash=Verbatim(annex.sha256),
        failures=say_count("{number} fails", "{number} fail", annex.failures) if annex.failures else say("none fails"),
    )
    if annex.pdf_as_written:
        yield say("SHA-256 of its PDF: {hash}.", hash=Verbatim(annex.pdf_sha256))
    else:
        yield say("Its PDF is missing or is not the one that was written with it: do not rely on the PDF.")
    if annex.program.sha256 != results.program.sha256:
        yield say(
            "It was made by other sources of the program than these results: version {version}, SHA-256 {hash}.",
            version=Verbatim(annex.program.version),
            hash=Verbatim(annex.program.sha256),
        )
    if annex.quick:
        yield say("It contains only the quick cases.")
    if annex.left_out:
        yield say_count(
            "It leaves out {number} case of the program that concerns this project.",
            "It leaves out {number} cases of the program that concern this project.",
            annex.left_out,
        )
    if annex.foreign:
        yield say_count(
            "{number} of its cases is not as it comes with the program.",
            "{number} of its cases are not as they come with the program.",
            annex.foreign,
        )
    if annex.uncovered:
        uses = listing([USES[use] if use in USES else Verbatim(use) for use in annex.uncovered])
        yield say(
            "Used here, and exercised by no solved case that passes and is more than indicative: {uses}.", uses=uses
        )


def _judgement() -> Iterator[doc.Block]:
    words = say(
        "The designer judges whether the program is reliable and fit for this building, from its documentation and "
        "test cases, and whether the results are acceptable, also by comparison with simple calculations of their own."
    )
    yield doc.Prose((words,))
    yield doc.WritingBox(say("Engineer’s judgement of the program and of the acceptability of the results"), 32.0)


CONTROL_TITLES: Mapping[ControlKind, Phrase] = {
    "equilibrium": say("Equilibrium of reactions"),
    "energy": say("Energy balance"),
    "hand-multiplier": say("Multiplier by hand"),
    "convergence": say("Convergence"),
}
WITHIN_ROUNDING = 1e-12  # relative difference below which a control is within rounding


def _control_blocks(results: Results) -> list[doc.Block]:
    """Return what was controlled, the table, and the notes on what was not made or not met."""
    if not results.controls:
        return [doc.Prose((say("These results hold no automatic controls."),))]
    return [
        doc.Prose((controls_summary(results.controls), _controls_explanation())),
        *doc.nonempty(controls_table(results)),
        *_control_notes(results),
    ]


def _controls_explanation() -> Text:
    """Return what the controls compare."""
    return say(
        "Equilibrium compares the reactions at the hinges with weights, loads and forces of inertia as the motion "
        "starts; the energy balance compares work done and energy lost along a motion; the multiplier that starts the "
        "motion is worked out again by moments about the hinges; convergence repeats an analysis with a coarser table "
        "and coarser steps."
    )


def _control_heading(results: Results, kind: ControlKind) -> Text:
    """Return the title of a kind of control with its tolerance."""
    found = [each.tolerance for each in results.controls if each.kind == kind and each.tolerance > 0.0]
    if not found:
        return CONTROL_TITLES[kind]
    return say(
        "{control}, at most {tolerance}", control=CONTROL_TITLES[kind], tolerance=quantity(max(found), figures=2)
    )


def _worst_difference(controls: list[Control]) -> doc.Cell:
    """Return the largest difference of some controls in the colour of their outcome; None where none was made."""
    made = [each for each in controls if each.difference is not None]
    if not made:
        return None
    worst = max(made, key=lambda each: (each.met is False, each.difference or 0.0))
    text = _difference(worst.difference or 0.0)
    if worst.met is None:
        return doc.OutcomeCell("comparison", text)
    return doc.OutcomeCell("pass" if worst.met else "fail", text)


def _difference(value: float) -> Text:
    return (
        say("below {least}", least=quantity(WITHIN_ROUNDING, figures=1))
        if value < WITHIN_ROUNDING
        else quantity(value, figures=2)
    )


def _control_notes(results: Results) -> Iterator[doc.Block]:
    """Yield what the program says of controls that were not made, not met, or need not agree, each sentence once."""
    found: dict[str, tuple[Control, Message, list[str]]] = {}
    for each in results.controls:
        if each.met is not True:
            found.setdefault(f"{each.kind} {each.note.text}", (each, each.note, []))[2].append(each.mechanism)
    if found:
        yield doc.BulletList(
            tuple(
                say(
                    "{control}, {mechanisms}: {note}",
                    control=CONTROL_TITLES[control.kind],
                    mechanisms=mechanism_list(results, owners),
                    note=note,
                )
                for control, note, owners in found.values()
            )
        )


def _value_text(value: float | None, dimension: str) -> Text | None:
    return None if value is None else quantity(value, dimension, 6)


def _identity_facts(results: Results) -> tuple[doc.Facts, ...]:
    """Return what identifies the issue that is signed."""
    matter = results.report
    facts = (
        (say("Office"), matter.office),
        (say("Licence number"), matter.licence_number),
        (say("Reference"), reference(results)),
        (say("Revision"), matter.revisions[-1].number if matter.revisions else ""),
        (say("Stamp of the results"), results.stamp),
    )
    pairs = tuple((label, Verbatim(text)) for label, text in facts if text)
    return (doc.Facts(pairs),) if pairs else ()
