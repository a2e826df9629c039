"""What this report covers, the limits that matter for these results, codes and methods, and the works referred to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import isfinite

from assess.codes.check import Check, Family, Outcome, Reason
from assess.codes.procedures import PROCEDURES, family_of
from assess.codes.sliding import SLIDING
from assess.messages.message import Message
from assess.results import MechanismResult, Results
from reports.chapters import verdict
from reports.document import Block, BulletList, Column, Field, Prose, Section, Table, nonempty, tabulate
from reports.language.texts import Paragraph, Phrase, Term, Text, Verbatim, listing, quantity, say, say_count
from reports.mechanisms import deformable_joints, mechanism_list, mechanism_number, procedure_title
from reports.project_values import project_text

GROUND_AT_HEIGHT = "ground-motion"  # key of a remark


def sections(results: Results) -> list[Section]:
    """Return scope and limits, then methods with their editions, then references."""
    limits = tuple(applicable_limits(results))
    blocks: list[Block] = [
        Prose((_scope_text(results),)),
        *_notes(results),
        Prose((say("Limits that matter for these results:"),)),
        BulletList(limits),
    ]
    return [
        Section(say("Scope and limits"), 0, (*blocks, *_left_over(results))),
        Section(
            say("Codes and methods"),
            1,
            (*nonempty(methods_table(results)), *nonempty(_rules_table(results)), *_uncompared(results)),
        ),
        Section(say("References"), 1, (BulletList(cited_works(results)),)),
    ]


def applicable_limits(results: Results) -> Iterator[Text]:
    """Yield the limits that apply to these results."""
    yield say(
        "The bodies are rigid between their joints and move in one vertical plane: bending and torsion of the masonry "
        "and out-of-plane coupling are not modelled."
    )
    yield from _limits_of_histories(results)
    yield from _limits_of_joints(results)
    yield sliding(results)
    yield from _limits_of_input(results)
    yield from _limits_of_equation(results)
    if len({check.procedure for check in _answered(results)}) > 1:
        yield say(
            "The methods allow different rotations and take different equivalent periods: their ratios D/C measure "
            "different margins and are not to be compared number by number."
        )


def sliding(results: Results) -> Text:
    """Return where friction was checked, and where it is only assumed to be sufficient."""
    unchecked = [each.name for each in results.mechanisms if not _is_checked(each)]
    assumed = _assumed_friction(results, unchecked)
    while_rocking = say(
        "While a mechanism rocks, no sliding, no bouncing and no separation other than rocking are modelled."
    )
    if len(unchecked) == len(results.mechanisms):
        return Paragraph((assumed, while_rocking))
    checked = say("Sliding was checked by equilibrium up to the moment at which the mechanism starts to rock.")
    return Paragraph((checked, *((assumed,) if unchecked else ()), while_rocking))


def caveats_of(check: Check) -> tuple[Term | Message, ...]:
    """Return what could not be compared of a check; in results of older versions one text."""
    return check.caveats or ((Term(check.caveat),) if check.caveat else ())


COMPARED: Mapping[Family, Phrase] = {
    Family.DISPLACEMENT: say("displacement capacity with the spectral displacement at the secant period"),
    Family.LINEAR: say("acceleration that starts the motion with the spectrum reduced by q, not the rotation after it"),
    Family.ENERGY: say("rotation of an equivalent oscillator of equal work, damped by impacts, with the allowable one"),
    Family.PART: say("rotation capacity of the wall with the spectral rotation of a part at its floor"),
    Family.TABLE: say("ratio of height to thickness with the one allowed at the spectral ordinate at 1 s"),
    Family.ELEMENT: say("force that starts the motion with the force on a part at its floor, reduced by q_a"),
    Family.HISTORY: say("largest rotations under each record, impacts included, with the allowable ones"),
    Family.SLIDING: say("sliding displacement, without rocking, with the allowable one"),
    Family.FRICTION: say("friction needed until rocking starts with the friction there is"),
}
"""What the methods of each family compare."""


def methods_table(results: Results) -> Table:
    """Tabulate the methods, those that decide first."""
    found: dict[str, list[Check]] = {}
    for check in (check for mechanism in results.mechanisms for check in mechanism.checks):
        found.setdefault(check.procedure, []).append(check)
    fields: tuple[Field[list[Check]], ...] = (
        (Column(say("Method"), share=0.24), lambda checks: procedure_title(checks[0].procedure)),
        (Column(say("Edition"), share=0.22), lambda checks: Term(checks[0].edition)),
        (Column(say("Part in the verdict"), share=0.16), _part_in_verdict),
        (Column(say("Compares")), _compared),
    )

    def is_for_information(checks: list[Check]) -> bool:
        return not _decides(checks)

    caption = say("Methods of this report, with the editions used.")
    ordered = sorted(found.values(), key=is_for_information)
    return tabulate("methods", caption, fields, ordered, muted=is_for_information, small=True)


HOUSNER = Verbatim(
    "Housner, G. W. (1963). The behavior of inverted pendulum structures during earthquakes. Bulletin of the "
    "Seismological Society of America 53(2), 403–417."
)

THESIS = say(
    "{work}: cited as “Mehrotra”.",
    work=Verbatim(
        "Mehrotra, A. A. A computational tool for seismic collapse assessment of masonry structures. PhD thesis, "
        "University of Cambridge"
    ),
)

ZHANG_MAKRIS = Verbatim(
    "Zhang, J. and Makris, N. (2001). Rocking response of free-standing blocks under cycloidal pulses. Journal of "
    "Engineering Mechanics 127(5), 473–483."
)

SORRENTINO = Verbatim(
    "Sorrentino, L., AlShawa, O. and Decanini, L. D. (2011). The relevance of energy damping in unreinforced masonry "
    "rocking mechanisms. Experimental and analytic investigations. Bulletin of Earthquake Engineering 9(5), 1617–1642."
)

PROCEDURE_WORKS: Mapping[str, Verbatim] = {
    "asce43-05": Verbatim(
        "ASCE/SEI 43-05. Seismic design criteria for structures, systems, and components in nuclear facilities. "
        "American Society of Civil Engineers, 2005."
    ),
    "asce41-13": Verbatim(
        "ASCE/SEI 41-13. Seismic evaluation and retrofit of existing buildings. American Society of Civil Engineers, "
        "2014."
    ),
    "dmi2008": Verbatim(
        "D.M. 14 gennaio 2008, Norme tecniche per le costruzioni; Circolare 2 febbraio 2009 n. 617, C8A.4."
    ),
    "ntc2018": Verbatim(
        "D.M. 17 gennaio 2018, Norme tecniche per le costruzioni; Circolare 21 gennaio 2019 n. 7, C7.2.3, C8.7.1.2."
    ),
    "nzsee2017": Verbatim(
        "NZSEE, SESOC, NZGS, MBIE and EQC (2017). The seismic assessment of existing buildings, part C8: Unreinforced "
        "masonry buildings."
    ),
    "ec8": Verbatim("EN 1998-1:2004. Eurocode 8: Design of structures for earthquake resistance, part 1. CEN."),
}
"""Of procedures, by the key that each has of its work."""

SPECTRUM_WORKS: Mapping[str, Verbatim] = {
    "asce7-05": Verbatim("ASCE/SEI 7-05. Minimum design loads for buildings and other structures. 2005."),
    "ibc2009": Verbatim("ASCE/SEI 7-05. Minimum design loads for buildings and other structures. 2005."),
    "asce7-10": Verbatim("ASCE/SEI 7-10. Minimum design loads for buildings and other structures. 2010."),
    "asce7-16": Verbatim(
        "ASCE/SEI 7-16. Minimum design loads and associated criteria for buildings and other structures. 2016."
    ),
    "asce7-22": Verbatim(
        "ASCE/SEI 7-22. Minimum design loads and associated criteria for buildings and other structures. 2022."
    ),
    "ec8": PROCEDURE_WORKS["ec8"],
    "nzs1170.5": Verbatim("NZS 1170.5:2004. Structural design actions, part 5: Earthquake actions – New Zealand."),
    "ts1170.5": Verbatim("SNZ TS 1170.5:2025. Structural design actions, part 5: Earthquake actions – New Zealand."),
    "ntc2008": PROCEDURE_WORKS["dmi2008"],
    "ntc2018": PROCEDURE_WORKS["ntc2018"],
}
"""Of spectra, by the code of the site."""


def cited_works(results: Results) -> tuple[Text, ...]:
    """Return the references of these results, each once."""
    found: list[Text] = []
    for each in _works(results):
        if each not in found:
            found.append(each)
    return tuple(found)


def _notes(results: Results) -> list[Block]:
    """Return what the engineer notes on the project, which may restrict the results."""
    notes = project_text(results, "notes").strip()
    return [Prose((say("Notes: {notes}", notes=Verbatim(notes)),))] if notes else []


def _scope_text(results: Results) -> Text:
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


def _limits_of_histories(results: Results) -> Iterator[Text]:
    if not any(mechanism.histories for mechanism in results.mechanisms):
        return
    yield say(
        "One rocking history cannot be predicted: a small change of the motion or the geometry can turn a large "
        "rotation into collapse or into rest. Only the statistics of many records are meaningful."
    )
    yield say(
        "Coefficients of restitution from formulas assume impacts without bouncing, which dissipate the most and are "
        "slightly unconservative (Mehrotra 3.3). Tested values are better."
    )


def _limits_of_joints(results: Results) -> Iterator[Text]:
    soft = [each.name for each in results.mechanisms if deformable_joints(each)]
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
    unanswered = (Outcome.NOT_APPLICABLE, Outcome.NOT_ANSWERED)
    return any(check.procedure == SLIDING.name and check.verdict not in unanswered for check in mechanism.checks)


def _limits_of_input(results: Results) -> Iterator[Text]:
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


def _limits_of_equation(results: Results) -> Iterator[Text]:
    linear = [each.name for each in results.mechanisms if each.equation == "linearised" and each.histories]
    if linear:
        yield say(
            "The histories of {mechanisms} solve the linearised equation of motion, accurate for slender bodies only.",
            mechanisms=mechanism_list(results, linear),
        )


def _left_over(results: Results) -> Iterator[Block]:
    """Yield in full the lists of which page 1 shows only the first points."""
    found = results.verdict
    if found is None:
        return
    for each in verdict.page_lists(results, found):
        if each.is_shortened:
            yield from (Prose((each.full_title,)), BulletList(tuple(each.points)))


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
        yield BulletList(tuple(points))


def _answered(results: Results) -> list[Check]:
    every = (check for mechanism in results.mechanisms for check in mechanism.checks)
    return [check for check in every if check.verdict in (Outcome.PASS, Outcome.FAIL)]


def _decides(checks: list[Check]) -> bool:
    return any(check.role == "deciding" for check in checks)


def _part_in_verdict(checks: list[Check]) -> Text:
    """Return what the answers of a method do for the verdict."""
    if _decides(checks):
        return say("decides")
    if all(check.reading == "thesis" for check in checks):
        return say("never decides: reading by Mehrotra")
    if all(check.informs for check in checks):
        return say("for information")
    return say("for comparison")


def _compared(checks: list[Check]) -> Text | None:
    family = family_of(checks[0].procedure)
    return None if family is None else COMPARED[family]


def _rules_table(results: Results) -> Table:
    """Tabulate the rules of the deciding code with their clauses."""
    found = () if results.verdict is None or results.verdict.basis == "own" else results.verdict.clauses
    columns = (Column(say("Rule of the verdict")), Column(say("Clause"), share=0.3))
    rows = tuple((Term(rule), Term(clause)) for rule, clause in found)
    return Table("rules", say("The rules that decide, and where the code states them."), columns, rows, small=True)


def _works(results: Results) -> Iterator[Text]:
    if results.spectrum is not None and results.spectrum.code in SPECTRUM_WORKS:
        yield SPECTRUM_WORKS[results.spectrum.code]
    for procedure in (check.procedure for mechanism in results.mechanisms for check in mechanism.checks):
        if procedure in PROCEDURES and PROCEDURES[procedure].work:
            yield PROCEDURE_WORKS[PROCEDURES[procedure].work]
    yield HOUSNER
    yield THESIS
    if any("Sorrentino et al. 2011" in mechanism.restitution_source for mechanism in results.mechanisms):
        yield SORRENTINO
    if any(mechanism.envelope is not None for mechanism in results.mechanisms):
        yield ZHANG_MAKRIS
