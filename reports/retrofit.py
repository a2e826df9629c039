"""The report of `assess retrofit`: the least works, what others reach, and how the least was proved."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import isinf
from typing import cast

from assess.results.provenance import describe_program
from assess.results.retrofit import Layout, Reached, RetrofitResults, Trial
from reports.chapters.cells import OUTCOMES
from reports.document import (
    BulletList,
    Cell,
    Column,
    Document,
    Facts,
    Field,
    Figure,
    Prose,
    Section,
    Table,
    tabulate,
)
from reports.figures.retrofit import MEASURES, STEEL, cost_heading, draw_front
from reports.language.locale import Locale, System
from reports.language.texts import Text, Verbatim, count, names, quantity, say, say_count

FILES = ("retrofit.pdf", "retrofit.html", "tables.xlsx")
METHOD = (
    say(
        "Layouts are searched on one part of the records and proved on the rest, of other earthquakes, each with eight "
        "twins that differ by less than any instrument resolves. Both are repeated with area, length, height and yield "
        "stress of the ties a tenth more and less, in all combinations and each alone."
    ),
    say(
        "What works reach need not rise with them: soft ties can overturn a wall that stands free, and a thicker bar "
        "may tear its anchor where a thinner one yields. So nothing is inferred between the layouts that were examined."
    ),
    say(
        "A share of records is taken at the upper end of its one-sided interval of 84 % (Clopper and Pearson 1934): 0 "
        "of 50 records is 0.036, 1 of 50 is 0.064. A record overturns if it or one of its twins does. Where n layouts "
        "may be put to the proof on the same records, each counts at a confidence of 1 - 0.16/n (Bonferroni), so that "
        "the one that is chosen has its share at 84 %."
    ),
    say(
        "Refused, whatever they reach: pretension above half of what yields the bar, and anchors farther apart than "
        "allowed. Steel is 7850 kg/m³ times area times length of all ties of the mechanisms that the works change."
    ),
)


def retrofit_report(results: RetrofitResults) -> Document:
    """Return the report of a search for the least works.

    Parameters
    ----------
    results : of the search
    """
    program = describe_program()
    system: System = "US" if results.units == "US" else "SI"
    title = Verbatim(results.title) if results.title else say("Least works")
    return Document(
        title=title,
        subject=say("Least works on masonry by rocking dynamics"),
        author="",
        program=f"{program.name} {program.version}",
        paper="A4",
        facts=(),
        sections=(
            Section(say("Least works"), 0, tuple(_first_page(results))),
            Section(say("Proof"), 0, tuple(_proof(results))),
            Section(say("Method"), 0, (Prose(METHOD),)),
        ),
        data=(_table("layouts", say("Every layout"), results, results.layouts),),
        locale=Locale(results.language, system),
    )


def _first_page(results: RetrofitResults) -> Iterator[Prose | Facts | BulletList | Table | Figure]:
    """Yield what came of it, facts, warnings, the front as figure and table."""
    proved = results.best is not None
    reached = say("These works reach the target; run the project with them for its verdict.")
    headline = reached if proved else say("No layout was proved to reach the target.")
    yield Prose((headline,))
    yield Facts(tuple(_facts(results)))
    if results.warnings:
        yield BulletList(results.warnings)
    caption = say(
        "What each layout reaches, over what it takes; the line joins those for which none that takes less reaches as "
        "much."
    )
    yield Figure("front", caption, partial(draw_front, results))
    yield _table(
        "front", say("Layouts for which none that takes less reaches as much (Pareto front)"), results, results.front
    )


def _facts(results: RetrofitResults) -> Iterator[tuple[Text, Text]]:
    """Yield what was asked, examined and found."""
    sign = "≥" if results.target.rising else "≤"
    yield (
        say("Target"),
        say(
            "{measure} {sign} {reach}",
            measure=MEASURES[results.target.kind],
            sign=Verbatim(sign),
            reach=quantity(results.target.reach),
        ),
    )
    if results.index:
        yield say("Measure"), Verbatim(results.index)
    if results.limit_state:
        yield say("Limit state"), Verbatim(results.limit_state)
    if results.pga_g is not None:
        yield say("PGA"), quantity(results.pga_g, "ground acceleration")
    yield say("Mechanisms that are to reach the target"), names(results.mechanisms)
    yield say("Layouts examined"), count(len([each for each in results.layouts if each.reached is not None]))
    yield say("Layouts refused"), count(len([each for each in results.layouts if each.refused is not None]))
    yield say("Reached the target in the search"), count(results.candidates)
    yield say("Put to the proof"), count(results.tried)
    if results.search_records:
        yield (
            say("Records"),
            say(
                "{seen} in the search, {left} in the proof",
                seen=count(len(results.search_records)),
                left=count(len(results.proof_records)),
            ),
        )
    if results.verdict:
        yield say("Verdict with these works"), OUTCOMES[results.verdict]
    if results.building_index is not None:
        yield say("Index of the building, the worst of all mechanisms"), quantity(results.building_index, figures=4)
    shown = results.best or results.nearest
    if shown is not None:
        yield (say("Least") if results.best else say("Nearest")), _amount(results, shown)
        for varied, value in zip(results.varied, shown.values, strict=True):
            yield Verbatim(varied.key), Verbatim(f"{value:.6g} {varied.unit}".rstrip())


def _amount(results: RetrofitResults, layout: Layout) -> Text:
    steel = quantity(layout.steel, "mass", 3)
    if not results.priced:
        return say("{steel} of steel", steel=steel)
    cost = Verbatim(f"{layout.objective:.6g} {results.currency}") if results.currency else None
    return say("cost {cost}, {steel} of steel", cost=cost or quantity(layout.objective, figures=6), steel=steel)


def _proof(results: RetrofitResults) -> Iterator[Prose | Table]:
    """Yield how many layouts were tried, how each fell short, and what the least reaches with every tolerance."""
    sentence = say_count(
        "{number} layout was put to the proof.", "{number} layouts were put to the proof.", number=results.tried
    )
    yield Prose((sentence,) if results.confidence is None else (sentence, _confidence(results, results.confidence)))
    if results.trials:
        keys = (say("Area"), say("Length"), say("Height"), say("Yield stress"))
        fields: list[Field[Trial]] = [
            (Column(heading, figures=6), cast(Callable[[Trial], Cell], partial(_tried, place)))
            for place, heading in enumerate(_headings(results))
        ]
        fields.append((Column(say("Outcome")), _holds))
        for key, name in zip(keys, ("area", "length", "height", "yield_stress"), strict=True):
            fields.append((Column(key, "ratio", 3), cast(Callable[[Trial], Cell], partial(_factor, name))))
        fields.append(
            (Column(MEASURES[results.target.kind], "ratio", 3), lambda trial: _value(trial.proof.reached.value))
        )
        if results.proof_records:
            fields.append((Column(say("Records that overturn")), lambda trial: trial.proof.reached.overturned))
        if any(trial.proof.refused for trial in results.trials):
            fields.append((Column(say("Refused")), lambda trial: trial.proof.refused))
        caption = say(
            "Layouts that reached the target in the search, by factors on their ties: those with which one first fell "
            "short, and all of the one that did not"
        )
        yield tabulate("proof", caption, fields, results.trials)


def _confidence(results: RetrofitResults, confidence: float) -> Text:
    return say(
        "Up to {number} might be: each share counts there at a confidence of {confidence}, and that of the one that is "
        "chosen at 0.84.",
        number=count(results.most),
        confidence=quantity(confidence, figures=4),
    )


def _tried(place: int, trial: Trial) -> Cell:
    return trial.layout.values[place]


def _holds(trial: Trial) -> Cell:
    return say("holds") if trial.proof.holds else say("falls short")


def _factor(name: str, trial: Trial) -> Cell:
    return float(getattr(trial.proof.tolerance, name))


def _headings(results: RetrofitResults) -> list[Verbatim]:
    """Return what was varied with its unit; without the name of the mechanism where that is one."""
    common = f"mechanisms.{results.mechanisms[0]}."
    shared = all(varied.key.startswith(common) for varied in results.varied)
    keys = [varied.key.removeprefix(common) if shared else varied.key for varied in results.varied]
    return [
        Verbatim(f"{key} [{varied.unit}]" if varied.unit else key)
        for key, varied in zip(keys, results.varied, strict=True)
    ]


def _table(name: str, caption: Text, results: RetrofitResults, layouts: tuple[Layout, ...]) -> Table:
    """Return the table of layouts."""
    fields: list[Field[Layout]] = []
    for place, heading in enumerate(_headings(results)):
        fields.append((Column(heading, figures=6), cast(Callable[[Layout], Cell], partial(_typed, place))))
    fields.append((Column(STEEL, "mass", 4), lambda layout: _value(layout.steel)))
    if results.priced:
        fields.append((Column(cost_heading(results), figures=6), lambda layout: _value(layout.objective)))
    fields.append((Column(MEASURES[results.target.kind], "ratio", 4), lambda layout: _value(_reached(layout).value)))
    if results.search_records:
        fields.append((Column(say("Records that overturn")), lambda layout: _reached(layout).overturned))
    if results.trials:
        fields.append((Column(say("Proof")), partial(_outcome, results)))
    if any(layout.refused for layout in layouts):
        fields.append((Column(say("Refused")), lambda layout: layout.refused))
    return tabulate(name, caption, fields, layouts)


def _outcome(results: RetrofitResults, layout: Layout) -> Cell:
    """Say how the proof of a layout ended; None of one that was not put to it."""
    return say("falls short") if results.fell_short(layout) else say("holds") if layout == results.best else None


def _typed(place: int, layout: Layout) -> Cell:
    return layout.values[place]


def _reached(layout: Layout) -> Reached:
    return layout.reached or Reached(None)


def _value(number: float | None) -> Cell:
    """Return a number; a dash for one that is not known, words for a record that overturns."""
    if number is None or number != number:
        return None
    return say("overturns") if isinf(number) else number
