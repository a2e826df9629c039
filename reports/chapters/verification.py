"""The annex of `assess verify`: what NTC 2018 10.2 asks of a program, shown by solved cases that a reader reruns."""

from __future__ import annotations

from collections.abc import Iterator

from assess.codes.families import THESIS_READINGS
from assess.results.uses import USES
from assess.results.verification import CaseResult, VerificationResults
from reports.chapters import verification_case, verification_words
from reports.chapters.cells import OUTCOMES
from reports.chapters.verification_figures import figures
from reports.document import Banner, Block, Code, Column, Facts, Graded, Items, Prose, Section, Table, Writing
from reports.figures.verification import STANDINGS
from reports.language.texts import Text, Verbatim, count, listing, quantity, say, say_count


def sections(results: VerificationResults) -> list[Section]:
    """Return the chapters: outcome, program, theory and field of use, differences, cases, what is not covered."""
    return [
        Section(say("Outcome"), 0, tuple(_outcome(results))),
        Section(say("Program and how to run the cases again"), 0, tuple(_program(results))),
        Section(say("Theory and field of use"), 0, tuple(verification_words.theory(results))),
        Section(say("Differences"), 0, tuple(figures(results))),
        Section(say("Solved cases"), 0, (Prose(verification_words.READING),)),
        *(verification_case.section(each, place) for place, each in enumerate(results.cases, start=1)),
        Section(say("What is not covered"), 0, tuple(_uncovered(results))),
        Section(say("Judgement"), 0, tuple(_judgement())),
    ]


def _outcome(results: VerificationResults) -> Iterator[Block]:
    deciding = {each.use for each in results.coverage} - set(THESIS_READINGS)
    bare = not deciding <= results.passed_uses
    partial = results.quick or results.left_out or results.foreign or bare or not results.evidence
    yield Banner("fail" if results.failures else "incomplete" if partial else "pass", _headline(results))
    yield Prose(tuple(_totals(results)))
    yield overview(results)


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


def overview(results: VerificationResults) -> Table:
    """Tabulate the cases: source, standing, number of values, largest difference, outcome."""
    columns = (
        Column(say("Case"), share=0.36),
        Column(say("Source")),
        Column(say("Standing"), share=0.12),
        Column(say("Values"), "ratio"),
        Column(say("Largest difference over tolerance"), "ratio", 2, share=0.13),
        Column(say("Outcome")),
    )
    rows = tuple(
        (
            Verbatim(each.title),
            Verbatim(verification_words.short(each.source.citation)),
            STANDINGS[each.source.standing],
            len(each.values),
            max(each.shares, default=None),
            _graded(each),
        )
        for each in results.cases
    )
    return Table("cases", say("Solved cases, in the order of their pages."), columns, rows, small=True)


def _graded(case: CaseResult) -> Graded:
    """Return the outcome of a case; one that agrees and is no evidence is not coloured as one that is."""
    quiet = case.is_indicative and case.outcome == "pass"
    return Graded("comparison" if quiet else case.outcome, OUTCOMES[case.outcome])


def _program(results: VerificationResults) -> Iterator[Block]:
    made = results.program
    said = (
        (say("Program"), made.name),
        (say("Version"), made.version),
        (say("Licence"), made.licence),
        (say("Origin"), made.origin),
        (say("SHA-256 of the program"), made.sha256),
        *((say("Project file"), f"{each.path}, SHA-256 {each.sha256}") for each in results.inputs),
    )
    yield Facts(tuple((label, Verbatim(text)) for label, text in said if text))
    yield Prose(verification_words.RELIABILITY)
    yield Prose(verification_words.AGAIN)
    yield Code(("assess verify", "assess verify --cases cases", *_examples(results)))


def _examples(results: VerificationResults) -> Iterator[str]:
    """Yield commands that run one case again, and a project as any other."""
    yield from (f"assess verify {each.key}" for each in results.cases[:1])
    projects = [each.path for case in results.cases for each in case.inputs[1:2] if each.path.endswith(".toml")]
    yield from (f"assess run cases/{path}" for path in projects[:1])


def _uncovered(results: VerificationResults) -> Iterator[Block]:
    covered = results.passed_uses
    if results.coverage:
        yield _coverage(results)
        bare = [each.use for each in results.coverage if each.use not in covered]
        words = say(
            "The project uses these, and no solved case that passes and is more than indicative exercises them: "
            "{uses}.",
            uses=_words(bare),
        )
        yield Prose((words if bare else say("A solved case that passes exercises each thing that the project uses."),))
    else:
        bare = [use for use in USES if use not in covered]
        if bare:
            yield Prose(
                (
                    say(
                        "The program can do these, and no solved case of this annex that passes and is more than "
                        "indicative exercises them:"
                    ),
                )
            )
            yield Items(tuple(_named(use) for use in bare))
    yield Prose(verification_words.LIMITS)


def _coverage(results: VerificationResults) -> Table:
    columns = (Column(say("Used by the project"), share=0.45), Column(say("Cases that exercise it")))
    known = {each.key: each for each in results.cases}
    rows = tuple(
        (_named(each.use), listing([_marked(known[key]) for key in each.cases], "") if each.cases else say("no case"))
        for each in results.coverage
    )
    return Table("coverage", say("What the project uses, and the solved cases."), columns, rows, small=True)


def _marked(case: CaseResult) -> Text:
    """Return the key of a case, with what keeps it from covering anything."""
    if case.outcome == "fail":
        return say("{case} (fails)", case=Verbatim(case.key))
    return say("{case} (indicative)", case=Verbatim(case.key)) if case.is_indicative else Verbatim(case.key)


def _words(uses: list[str]) -> Text:
    return listing([_named(use) for use in uses])


def _named(use: str) -> Text:
    return say("{word}: {meaning}", word=Verbatim(use), meaning=USES[use]) if use in USES else Verbatim(use)


def _judgement() -> Iterator[Block]:
    yield Prose((verification_words.JUDGEMENT,))
    yield Writing(say("Engineer’s judgement of the program and of these cases"), 32.0)
