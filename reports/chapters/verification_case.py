"""A solved case on its page: source, theory, input files, each value beside the program's, tolerances, misprints."""

from __future__ import annotations

from collections.abc import Iterator

from assess.results.verification import CaseResult, QuantityResult, Tolerance, ValueResult
from reports.document import Block, Cell, Column, Facts, Graded, Items, Prose, Section, Table
from reports.figures.verification import STANDINGS
from reports.language.texts import Text, Verbatim, listing, quantity, say
from reports.titles import file_stem

FIGURES = 6  # of a value
ROUGH = 2  # figures of a difference
PERCENT = 100.0


def section(case: CaseResult, place: int) -> Section:
    """Return the part of one case. place: among the cases, from 1 on."""
    return Section(Verbatim(case.title), 1, tuple(_blocks(case, place)))


def _blocks(case: CaseResult, place: int) -> Iterator[Block]:
    yield Facts(
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
        yield Prose((say("The case could not be run: {fault}", fault=Verbatim(case.fault)),))
    yield values(case, place)
    yield Items((*_departures(case), *_reasons(case)))


def values(case: CaseResult, place: int) -> Table:
    """Tabulate every value of a case beside that of the program. place: among the cases, from 1 on."""
    columns = (
        Column(say("Quantity"), share=0.26),
        Column(say("Row"), share=0.15),
        Column(say("Unit")),
        Column(say("Expected")),
        Column(say("Program")),
        Column(say("Difference")),
        Column(say("Tolerance")),
        Column(say("Outcome")),
    )
    rows = tuple(_row(each, value) for each in case.quantities for value in each.values)
    caption = say("{title}: values of the source and of the program.", title=Verbatim(case.title))
    return Table(f"case-{file_stem(case.key, place)}", caption, columns, rows, small=True)


def _row(each: QuantityResult, value: ValueResult) -> tuple[Cell, ...]:
    return (
        Verbatim(each.name),
        Verbatim(value.row),
        Verbatim(each.unit or "–"),
        quantity(value.expected, figures=FIGURES),
        None if value.found is None else quantity(value.found, figures=FIGURES),
        None if value.difference is None else quantity(value.difference, figures=ROUGH),
        quantity(each.tolerance.around(value.reference), figures=ROUGH),
        _outcome(value),
    )


def _outcome(value: ValueResult) -> Graded:
    if value.outcome == "misprint":
        return Graded("comparison", say("misprint"))
    return Graded("pass", say("pass")) if value.outcome == "pass" else Graded("fail", say("fail"))


def _departures(case: CaseResult) -> Iterator[Text]:
    """Yield what the source prints and the program does not give."""
    for each in case.departures:
        yield say("Printed and not reproduced: {departure}.", departure=Verbatim(_sentence(each)))


def _reasons(case: CaseResult) -> Iterator[Text]:
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
