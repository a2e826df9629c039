"""The annex of `assess verify`: what NTC 2018 10.2 asks of a program, shown by solved cases that a reader reruns."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial

from assess.codes.procedures import THESIS_READINGS
from assess.results import Results
from assess.results.verification import (
    USES,
    CaseResult,
    QuantityResult,
    SolvedCase,
    Tolerance,
    ValueResult,
    VerificationResults,
)
from reports import document as doc
from reports.chapters.cells import OUTCOME, OUTCOMES, UNIT
from reports.chapters.declaration import annex_texts
from reports.chapters.kinds import THEORY
from reports.figures import verification as drawing
from reports.figures.verification import STANDINGS
from reports.intensity_measures import PERCENT
from reports.language.texts import Text, Verbatim, count, listing, quantity, say, say_count
from reports.mechanisms import file_stem

MARK = "F"


def sections(results: VerificationResults) -> list[doc.Section]:
    """Return the chapters: outcome, program, theory and field of use, differences, cases, what is not covered."""
    return [
        doc.Section(say("Outcome"), 0, tuple(_outcome_blocks(results))),
        doc.Section(say("Program and how to run the cases again"), 0, tuple(_program_blocks(results))),
        doc.Section(say("Theory and field of use"), 0, tuple(_theory_blocks(results))),
        doc.Section(say("Differences"), 0, tuple(_difference_figures(results))),
        doc.Section(say("Solved cases"), 0, (doc.Prose(READING),)),
        *(_case_section(each, place) for place, each in enumerate(results.cases, start=1)),
        doc.Section(say("What is not covered"), 0, tuple(_uncovered_blocks(results))),
        doc.Section(say("Judgement"), 0, tuple(_judgement_blocks())),
    ]


def annex_sections(results: Results) -> list[doc.Section]:
    """Return the page of the solved cases in the report of a run: that of the annex which the run names."""
    annex = results.verification
    if annex is None or not annex.solved:
        return []
    said = say(
        "Cases solved again with this program, those that concern what the project uses; every value stands in {file}.",
        file=Verbatim(annex.path.replace(".json", ".pdf")),
    )
    blocks = (doc.Prose((said, *annex_texts(results))), _cases_table(annex.solved))
    return [doc.Section(say("Verification of the program by solved cases"), 0, blocks, starts_page=True, mark=MARK)]


ComparedValue = tuple[QuantityResult, ValueResult]


def values_table(case: CaseResult, place: int) -> doc.Table:
    """Tabulate every value of a case beside that of the program. place: among the cases, from 1 on."""
    fields: tuple[doc.Field[ComparedValue], ...] = (
        (doc.Column(say("Quantity"), share=0.26), lambda pair: Verbatim(pair[0].name)),
        (doc.Column(say("Row"), share=0.15), lambda pair: Verbatim(pair[1].row)),
        (UNIT, lambda pair: Verbatim(pair[0].unit or "–")),
        (doc.Column(say("Expected")), lambda pair: _number(pair[1].expected, FIGURES)),
        (doc.Column(say("Program")), lambda pair: _number(pair[1].found, FIGURES)),
        (doc.Column(say("Difference")), lambda pair: _number(pair[1].difference, DIFFERENCE_FIGURES)),
        (
            doc.Column(say("Tolerance")),
            lambda pair: _number(pair[0].tolerance.around(pair[1].reference), DIFFERENCE_FIGURES),
        ),
        (OUTCOME, lambda pair: _value_outcome(pair[1])),
    )
    caption = say("{title}: values of the source and of the program.", title=Verbatim(case.title))
    pairs = [(each, value) for each in case.quantities for value in each.values]
    return doc.tabulate(f"case-{file_stem(case.key, place)}", caption, fields, pairs, small=True)


def _outcome_blocks(results: VerificationResults) -> Iterator[doc.Block]:
    deciding = {each.use for each in results.coverage} - set(THESIS_READINGS)
    bare = not deciding <= results.passed_uses
    partial = results.quick or results.left_out or results.foreign or bare or not results.evidence
    yield doc.Banner("fail" if results.failures else "incomplete" if partial else "pass", _headline(results))
    yield doc.Prose(tuple(_totals(results)))
    yield _cases_table([each.line for each in results.cases])


def _headline(results: VerificationResults) -> Text:
    """Return what the cases come to; those that are indicative are not counted among the evidence."""
    evidence, indicative = len(results.evidence), len(results.cases) - len(results.evidence)
    if results.failures:
        return say_count(
            "{number} solved case does not agree with its source.",
            "{number} solved cases do not agree with their sources.",
            len(results.failures),
        )
    if not evidence:
        return say_count(
            "The {number} solved case is indicative only: it is no evidence.",
            "All {number} solved cases are indicative only: they are no evidence.",
            indicative,
        )
    if not indicative:
        return say_count(
            "The {number} solved case agrees with what is compared of its source.",
            "All {number} solved cases agree with what is compared of their sources.",
            evidence,
        )
    return say_count(
        "The {number} solved case that is evidence agrees with what is compared of its source; {others}.",
        "The {number} solved cases that are evidence agree with what is compared of their sources; {others}.",
        evidence,
        others=say_count("{number} more is indicative", "{number} more are indicative", indicative),
    )


def _totals(results: VerificationResults) -> Iterator[Text]:
    values = [value for each in results.quantities for value in each.values]
    yield say(
        "Computed again and compared: {values} of {quantities} in {cases}.",
        values=say_count("{number} value", "{number} values", len(values)),
        quantities=say_count("{number} quantity", "{number} quantities", len(results.quantities)),
        cases=say_count("{number} case", "{number} cases", len(results.cases)),
    )
    misprints = sum(each.misprints for each in results.cases)
    if misprints:
        yield say_count(
            "{number} printed value is taken to be a misprint and compared with its likeliest reading.",
            "{number} printed values are taken to be misprints and compared with their likeliest reading.",
            misprints,
        )
    standings = [each.source.standing for each in results.cases]
    yield say(
        "Standing of the expected values, by number of cases: published {published}, derived from the formulas of a "
        "source {derived}, own arithmetic {own}, indicative, which is no evidence, {indicative}.",
        published=count(standings.count("published")),
        derived=count(standings.count("derived")),
        own=count(standings.count("own arithmetic")),
        indicative=count(standings.count("indicative")),
    )
    departing = [each for each in results.cases if each.departures]
    if departing:
        yield say_count(
            "Other values that the source prints are not reproduced in {number} case: {cases}.",
            "Other values that the sources print are not reproduced in {number} cases: {cases}.",
            len(departing),
            cases=listing([Verbatim(each.title) for each in departing]),
        )
    share, relative = results.shares, results.relative
    if share.median is not None and share.worst is not None:
        yield say(
            "Difference over tolerance, of the cases that are evidence: median {median}, largest {worst}.",
            median=quantity(share.median, figures=2),
            worst=quantity(share.worst, figures=2),
        )
    if relative.median is not None and relative.worst is not None:
        yield say(
            "The same for the difference over the largest value of its quantity: median {median}, largest {worst} "
            "({where}).",
            median=quantity(relative.median, figures=2),
            worst=quantity(relative.worst, figures=2),
            where=Verbatim(", ".join(results.farthest)),
        )
    if results.quick:
        yield say("Only the quick cases were run; the others are left out.")
    if results.left_out:
        yield say(
            "Cases of the program that are left out here: {cases}.", cases=listing(map(Verbatim, results.left_out), "")
        )
    if results.foreign:
        yield say(
            "Cases that are not as they come with the program: {cases}.",
            cases=listing(map(Verbatim, results.foreign), ""),
        )


def _cases_table(cases: Sequence[SolvedCase]) -> doc.Table:
    """Tabulate cases: source, standing, number of values, largest difference, outcome."""
    fields: tuple[doc.Field[SolvedCase], ...] = (
        (doc.Column(say("Case"), share=0.36), lambda case: Verbatim(case.title)),
        (doc.Column(say("Source")), lambda case: Verbatim(_author_and_year(case.citation))),
        (doc.Column(say("Standing"), share=0.12), lambda case: STANDINGS[case.standing]),
        (doc.Column(say("Values"), "ratio"), lambda case: case.values),
        (
            doc.Column(say("Largest difference over tolerance"), "ratio", 2, share=0.13),
            lambda case: case.worst,
        ),
        (OUTCOME, _outcome_cell),
    )
    return doc.tabulate("cases", say("Solved cases, in the order of their pages."), fields, cases, small=True)


def _outcome_cell(case: SolvedCase) -> doc.OutcomeCell:
    """Return the outcome of a case; one that agrees and is no evidence is not coloured as one that is."""
    quiet = case.standing == "indicative" and case.outcome == "pass"
    return doc.OutcomeCell("comparison" if quiet else case.outcome, OUTCOMES[case.outcome])


def _program_blocks(results: VerificationResults) -> Iterator[doc.Block]:
    made = results.program
    said = (
        (say("Program"), made.name),
        (say("Version"), made.version),
        (say("Licence"), made.licence),
        (say("Origin"), made.origin),
        (say("SHA-256 of the program"), made.sha256),
        *((say("Project file"), f"{each.path}, SHA-256 {each.sha256}") for each in results.inputs),
    )
    yield doc.Facts(tuple((label, Verbatim(text)) for label, text in said if text))
    yield doc.Prose(RELIABILITY)
    yield doc.Prose(RERUN)
    yield doc.FileLines(("assess verify", "assess verify --cases cases", *_examples(results)))


def _examples(results: VerificationResults) -> Iterator[str]:
    """Yield commands that run one case again, and a project as any other."""
    yield from (f"assess verify {each.key}" for each in results.cases[:1])
    projects = [each.path for case in results.cases for each in case.inputs[1:2] if each.path.endswith(".toml")]
    yield from (f"assess run cases/{path}" for path in projects[:1])


def _uncovered_blocks(results: VerificationResults) -> Iterator[doc.Block]:
    covered = results.passed_uses
    if results.coverage:
        yield _coverage_table(results)
        bare = [each.use for each in results.coverage if each.use not in covered]
        words = say("A solved case that passes exercises each thing that the project uses.")
        if bare:
            words = say(
                "The project uses these, and no solved case that passes and is more than indicative exercises them: "
                "{uses}.",
                uses=listing([_use_text(use) for use in bare]),
            )
        yield doc.Prose((words,))
    elif bare := [use for use in USES if use not in covered]:
        words = say(
            "The program can do these, and no solved case of this annex that passes and is more than indicative "
            "exercises them:"
        )
        yield doc.Prose((words,))
        yield doc.BulletList(tuple(_use_text(use) for use in bare))
    yield doc.Prose(LIMITS)


def _coverage_table(results: VerificationResults) -> doc.Table:
    columns = (doc.Column(say("Used by the project"), share=0.45), doc.Column(say("Cases that exercise it")))
    known = {each.key: each for each in results.cases}
    rows = tuple(
        (
            _use_text(each.use),
            listing([_case_with_mark(known[key]) for key in each.cases], "") if each.cases else say("no case"),
        )
        for each in results.coverage
    )
    return doc.Table("coverage", say("What the project uses, and the solved cases."), columns, rows, small=True)


def _case_with_mark(case: CaseResult) -> Text:
    """Return the key of a case, with what keeps it from covering anything."""
    if case.outcome == "fail":
        return say("{case} (fails)", case=Verbatim(case.key))
    return say("{case} (indicative)", case=Verbatim(case.key)) if case.is_indicative else Verbatim(case.key)


def _use_text(use: str) -> Text:
    return say("{word}: {meaning}", word=Verbatim(use), meaning=USES[use]) if use in USES else Verbatim(use)


def _judgement_blocks() -> Iterator[doc.Block]:
    yield doc.Prose((JUDGEMENT,))
    yield doc.WritingBox(say("Engineer’s judgement of the program and of these cases"), 32.0)


def _difference_figures(results: VerificationResults) -> Iterator[doc.Prose | doc.Figure]:
    """Yield how to read them, differences over tolerance by source, and values of the program over those expected."""
    words = say(
        "Each point is one value. Left of the line at 1 the difference is within the tolerance, whose reason stands "
        "with the case; values that agree to more digits than are drawn stand at the left edge."
    )
    yield doc.Prose((words,))
    shares = tuple(
        (case.key.partition("/")[0], case.source.standing, share) for case in results.cases for share in case.shares
    )
    if shares:
        caption = say("Difference of every value over its tolerance, by source.")
        yield doc.Figure("differences", caption, partial(drawing.draw_differences, shares))
    pairs = tuple(
        (value.reference, value.found)
        for each in results.quantities
        for value in each.values
        if value.found is not None
    )
    caption = say("Value of the program against the expected one, without signs; zeros are left out.")
    yield doc.Figure("agreement", caption, partial(drawing.draw_agreement, pairs))


FIGURES = 6  # of a value
DIFFERENCE_FIGURES = 2  # figures of a difference


def _case_section(case: CaseResult, place: int) -> doc.Section:
    """Return the part of one case. place: among the cases, from 1 on."""
    return doc.Section(Verbatim(case.title), 1, tuple(_case_blocks(case, place)))


def _case_blocks(case: CaseResult, place: int) -> Iterator[doc.Block]:
    yield doc.Facts(
        (
            (say("Case"), Verbatim(case.key)),
            (say("Source"), Verbatim(case.source.citation)),
            (say("Standing"), STANDINGS[case.source.standing]),
            (say("Place"), Verbatim(case.source.place)),
            (say("Theory"), Verbatim(case.theory)),
            (say("Field of use"), Verbatim(case.field)),
            (say("Exercises"), listing(map(Verbatim, case.uses), "")),
            (
                say("Input files"),
                listing((Verbatim(f"{each.path} (SHA-256 {each.sha256})") for each in case.inputs), ""),
            ),
        )
    )
    if case.fault:
        yield doc.Prose((say("The case could not be run: {fault}", fault=Verbatim(case.fault)),))
    yield values_table(case, place)
    yield doc.BulletList((*_departures(case), *_tolerances_and_misprints(case)))


def _number(value: float | None, figures: int) -> Text | None:
    return None if value is None else quantity(value, figures=figures)


def _value_outcome(value: ValueResult) -> doc.OutcomeCell:
    if value.outcome == "misprint":
        return doc.OutcomeCell("comparison", say("misprint"))
    return doc.OutcomeCell("pass", say("pass")) if value.outcome == "pass" else doc.OutcomeCell("fail", say("fail"))


def _departures(case: CaseResult) -> Iterator[Text]:
    """Yield what the source prints and the program does not give."""
    for each in case.departures:
        yield say("Printed and not reproduced: {departure}.", departure=Verbatim(_sentence(each)))


def _tolerances_and_misprints(case: CaseResult) -> Iterator[Text]:
    """Yield each tolerance with its reason, then each misprint with its reading."""
    shared: dict[Tolerance, list[QuantityResult]] = {}
    for each in case.quantities:
        shared.setdefault(each.tolerance, []).append(each)
    for tolerance, quantities in shared.items():
        of = say("all quantities") if len(shared) == 1 else listing(Verbatim(each.name) for each in quantities)
        yield say(
            "Tolerance of {quantities}: {tolerance}. {reason}.",
            quantities=of,
            tolerance=_tolerance(tolerance, quantities[0].unit),
            reason=Verbatim(_sentence(tolerance.reason)),
        )
    for each in case.quantities:
        for value in each.values:
            if value.reading is not None:
                yield say(
                    "Misprint: {quantity}, {row}: {printed} is printed and read as {reading}. {reason}.",
                    quantity=Verbatim(each.name),
                    row=Verbatim(value.row or "–"),
                    printed=quantity(value.expected, figures=FIGURES),
                    reading=quantity(value.reading, figures=FIGURES),
                    reason=Verbatim(_sentence(value.misprint)),
                )


def _tolerance(tolerance: Tolerance, unit: str) -> Text:
    absolute = (
        say("{value} {unit}", value=quantity(tolerance.absolute, figures=3), unit=Verbatim(unit))
        if unit
        else quantity(tolerance.absolute, figures=3)
    )
    relative = say("{share} of the value", share=quantity(PERCENT * tolerance.relative, "percent", 3))
    if tolerance.absolute and tolerance.relative:
        return say("{absolute} or {relative}, the larger", absolute=absolute, relative=relative)
    return absolute if tolerance.absolute else relative if tolerance.relative else say("none, the values are equal")


def _sentence(text: str) -> str:
    """Return a text with a capital in front and without a full stop."""
    bare = text.strip().rstrip(".")
    return bare[:1].upper() + bare[1:]


READING = (
    say(
        "Each case has its source, the equations that it shows and where they hold, the files to run it again, and "
        "every value beside that of the program. Titles, theory and reasons are quoted from the files of the cases."
    ),
    say(
        "Published: the value was read where the case says. Derived: no source prints the value. The authors of the "
        "program computed it from formulas by another computation than the program’s; the formulas are those of the "
        "source, and where the source itself could not be read, the case says so. Own arithmetic: the value was "
        "computed by hand or by independent code, and no source prints it."
    ),
    say(
        "Indicative: the value was read in the source, but sizes of the body, or the reading of a procedure, were "
        "chosen here to suit such values. The case shows that the program gives values of that size; it is no evidence "
        "that the program is right, and nothing counts as covered by it."
    ),
    say(
        "“Printed and not reproduced” names values beside those of a case that the source prints and the program does "
        "not give. They are in no table."
    ),
)

RELIABILITY = (
    say(
        "Reliability: each case goes through the functions that an assessment calls. The expected values and their "
        "tolerances stand in files of data that no computation of the program writes."
    ),
)

RERUN = (
    say(
        "The folder cases beside this annex has every input file. These commands run all cases of the program, all "
        "cases of that folder, one case, and a project of a case as any other project:"
    ),
)

LIMITS = (
    say(
        "A case that passes shows that the program solves the equations of its source. It does not show that these "
        "equations suit a building: survey, geometry, materials, restraints and the choice of mechanisms are the "
        "engineer’s."
    ),
    say(
        "Not verified by solved cases: three-dimensional rocking, sliding and rocking at once, masonry that falls "
        "apart, and interaction with the soil; the program does not model them."
    ),
)

JUDGEMENT = say(
    "NTC 2018, 10.2, asks the designer to examine the documentation of the program and to judge beforehand whether it "
    "is reliable and suits the case at hand. The designer does so here, having run the cases again or examined them."
)


def _theory_blocks(results: VerificationResults) -> Iterator[doc.Block]:
    """Yield the theory that all mechanisms share, then a table by mechanism with the cases that show it."""
    equation = say(
        "Every mechanism has one degree of freedom, the rotation φ of its leading block, and obeys I(φ) φ'' + ½ I'(φ) "
        "φ'² + restoring(φ) = −B(φ) ü − C(φ) ẅ, where ü and ẅ are the horizontal and the vertical acceleration of the "
        "ground. Virtual work over the chain of blocks gives the inertia I, the restoring moment, the excitation B and "
        "the lift C. The equation is integrated from event to event, with a loss of velocity at each impact."
    )
    procedures = say(
        "Procedures of codes read the same tables: the multiplier that starts the motion, the capacity curve, and the "
        "rotation that overturns. Spectra, scaling and the motion at height follow their clauses."
    )
    yield doc.Prose((equation, procedures))
    yield from doc.nonempty(_theory_table(results))


def _theory_table(results: VerificationResults) -> doc.Table:
    described = (doc.Column(say("Theory")), doc.Column(say("Field of use")))
    columns = (doc.Column(say("Mechanism"), share=0.13), *described, doc.Column(say("Number of cases"), "ratio"))
    rows = tuple(
        (Verbatim(word), equations, suits, number)
        for word, (equations, suits) in THEORY.items()
        if (number := sum(word in each.uses for each in results.cases))
    )
    caption = say("Theory and field of use by mechanism; the page of each case says which it exercises.")
    return doc.Table("theory", caption, columns, rows, small=True)


def _author_and_year(citation: str) -> str:
    """Return author and year of a citation, as far as the year in brackets; the citation if it has none."""
    found = re.match(r".*?\((?:19|20)\d\d[a-z]?\)", citation)
    return found[0] if found else citation
