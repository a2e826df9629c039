"""What NTC 2018 10.2 asks of a calculation by computer: analysis, program, controls, and the engineer's judgement."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from hashlib import sha256

from assess.codes.check import Check, Family
from assess.codes.families import FAMILIES
from assess.results import Results
from assess.results.uses import USES
from reports.chapters import controls
from reports.document import Block, Facts, Prose, Section, Writing
from reports.language.texts import Paragraph, Phrase, Text, Verbatim, listing, say, say_count
from reports.titles import procedure_title

ITALIAN_BASES = ("ntc2018", "dmi2008")
KINDS: Mapping[Family, Phrase] = {
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


def sections(results: Results) -> list[Section]:
    """Return the chapter: analysis, program and controls, each with its own heading, and the box for the judgement."""
    return [
        Section(title(results), 0, (Prose(tuple(analysis(results))),)),
        Section(say("Program"), 1, (Facts(tuple(program(results))), Prose((documents(), *verification(results))))),
        Section(say("Automatic controls"), 1, tuple(controls.blocks(results))),
        Section(say("Judgement"), 1, tuple(_judgement())),
    ]


def title(results: Results) -> Text:
    """Return the title of the chapter, with the clause that asks for it where an Italian code decides."""
    if results.verdict is not None and results.verdict.basis in ITALIAN_BASES:
        return say("Calculation by computer (NTC 2018, 10.2)")
    return say("Calculation by computer")


def analysis(results: Results) -> Iterator[Text]:
    """Yield the kind of analysis of the methods that decide, and why it was chosen."""
    deciding = [check for each in results.mechanisms for check in each.checks if check.role == "deciding"]
    yield from _kinds(deciding)
    if not deciding:
        yield say("No method decides; the kinds of analysis for comparison are listed under Codes and methods.")
    yield Paragraph(
        (
            _reason(deciding),
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


def _reason(deciding: list[Check]) -> Text:
    """Return why the mechanisms are rigid bodies, with large rotations where a method that decides follows these."""
    if deciding and not any(FAMILIES.get(check.procedure) in FOLLOW_ROTATION for check in deciding):
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
        if check.procedure in FAMILIES:
            found.setdefault(FAMILIES[check.procedure], []).append(check.procedure)
    for family, procedures in found.items():
        methods = listing(map(procedure_title, dict.fromkeys(procedures)))
        yield Phrase(KINDS[family].english, {"methods": methods})


def program(results: Results) -> Iterator[tuple[Text, Text]]:
    """Yield name, version, licence and origin of the program, and the hashes of program and inputs."""
    made = results.program
    said = (
        (say("Program"), made.name),
        (say("Version"), made.version),
        (say("Licence"), made.licence),
        (say("Origin"), made.origin),
        (say("SHA-256 of the program"), made.sha256),
    )
    yield from ((label, Verbatim(text)) for label, text in said if text)
    if results.inputs:
        yield say("SHA-256 of the inputs"), inputs_text(results)
    if results.stamp:
        yield say("Stamp of the results"), Verbatim(results.stamp)


def inputs_text(results: Results) -> Text:
    """Return one hash over those of all files read, with their number."""
    joined = "".join(each.sha256 for each in results.inputs).encode("ascii", "replace")
    return say_count(
        "{hash} ({number} file)",
        "{hash} (of the hashes of {number} files)",
        len(results.inputs),
        hash=Verbatim(sha256(joined).hexdigest() if len(results.inputs) > 1 else results.inputs[0].sha256),
    )


def documents() -> Text:
    """Return what comes with the program."""
    return say(
        "Theory, field of use and examples that reproduce published cases, with their project files, come with the "
        "program. The same program and inputs give the same results, to the last digit, on one machine."
    )


def verification(results: Results) -> Iterator[Text]:
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


def _judgement() -> Iterator[Block]:
    words = say(
        "The designer judges whether the program is reliable and fit for this building, from its documentation and "
        "test cases, and whether the results are acceptable, also by comparison with simple calculations of their own."
    )
    yield Prose((words,))
    yield Writing(say("Engineer’s judgement of the program and of the acceptability of the results"), 32.0)
