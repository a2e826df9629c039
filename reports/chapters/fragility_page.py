"""The pages of one mechanism in a report on fragility."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from assess.messages.message import distinct
from assess.results.fragility import FragilityCurve, FragilityResults, MeasureResult, MechanismFragility, RecordRuns
from reports.chapters import fragility_tables as tables
from reports.chapters import fragility_words as words
from reports.document import Block, Figure, Items, Prose, Row, Section, nonempty
from reports.figures import fragility as figure
from reports.figures import fragility_risk, fragility_runs
from reports.figures.style import HALF, WIDTH
from reports.language.texts import Paragraph, Text, Verbatim, say
from reports.measures import (
    curves_by,
    first_measure,
    hazard_of,
    main_curve,
    main_risk,
    measure_text,
    state_text,
    unit_intensity,
)
from reports.titles import file_stem


def section(results: FragilityResults, mechanism: MechanismFragility) -> Section:
    """Return the pages of a mechanism: what it means, the curves, the runs behind them, the measures, the rates."""
    stem = file_stem(mechanism.name, [each.name for each in results.mechanisms].index(mechanism.name) + 1)
    blocks: list[Block] = [
        *_prose(words.summary(mechanism, results.hazard)),
        *_curve(mechanism, stem),
        *nonempty(tables.curves(mechanism, f"{stem}-curves")),
        *_runs(mechanism, stem),
        Prose((words.islands(mechanism),)),
        *nonempty(tables.islands(mechanism, f"{stem}-islands", most=tables.MOST)),
        *nonempty(tables.comparison(mechanism, f"{stem}-measures")),
        *_risk(results, mechanism, stem),
        *_prose(words.epistemic(mechanism)),
        *_remarks(mechanism),
    ]
    title = Verbatim(mechanism.label or mechanism.name)
    return Section(title, 0, tuple(blocks), starts_page=True, mark=tables.number_of(results, mechanism))


def _prose(sentences: Iterator[Text]) -> list[Block]:
    said = tuple(sentences)
    return [Prose((Paragraph(said),))] if said else []


def _curve(mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    curve = main_curve(mechanism)
    if curve is not None:
        caption = say(
            "Share of the records that bring it to {state}, over {measure}. Points: counted, each with its Wilson "
            "interval, hollow where most records are scaled by more than 4; line: lognormal with its bootstrap band; "
            "dashed, if any: a bound, from the first intensity that reaches the state.",
            state=state_text(curve.state),
            measure=measure_text(curve.measure),
        )
        yield Figure(f"{stem}-fragility", caption, partial(figure.draw, curve))
        yield from _prose(words.describe_counts(curve))


def _runs(mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    """Yield the figure of the runs, beside that of all states where there are several."""
    measure = first_measure(mechanism)
    curves = curves_by(mechanism, measure)
    pairs = _with_units(mechanism, measure)
    found = []
    if pairs and curves and measure is not None:
        draw = partial(
            fragility_runs.draw,
            tuple(run for run, _ in pairs),
            tuple(unit for _, unit in pairs),
            measure,
            reach=max(map(figure.reach, curves)),
            width=HALF if len(curves) > 1 else WIDTH,
        )
        caption = say(
            "Largest rotation over that which overturns, at rising intensity; a line for each record. Diamonds, if "
            "any: islands."
        )
        found.append(Figure(f"{stem}-runs", caption, draw))
    if len(curves) > 1:
        found.append(_states(curves, stem))
    yield from [Row(tuple(found))] if len(found) > 1 else found


def _with_units(mechanism: MechanismFragility, measure: MeasureResult | None) -> list[tuple[RecordRuns, float]]:
    """Return the runs of each record whose intensity is known, with its intensity at scale 1."""
    if measure is None:
        return []
    units = ((run, unit_intensity(mechanism, measure, run)) for run in mechanism.runs)
    return [(run, unit) for run, unit in units if unit is not None]


def _states(curves: tuple[FragilityCurve, ...], stem: str) -> Figure:
    caption = say(
        "Share of the records that reach each state: counted (hollow: most scaled by more than 4), lognormal."
    )
    return Figure(f"{stem}-states", caption, partial(figure.draw_states, curves))


def _risk(results: FragilityResults, mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    risk = main_risk(mechanism)
    if risk is not None:
        caption = say(
            "Which ground motions make up the annual rate of {state} ({curve}): above, how often the site exceeds each "
            "intensity; below, the share of the rate from each range of intensities.",
            state=state_text(risk.state),
            curve=words.RATES[risk.curve],
        )
        draw = partial(fragility_risk.draw, risk, hazard_of(risk, results.hazard))
        yield Figure(f"{stem}-contributions", caption, draw)
    yield from nonempty(tables.risks(mechanism, f"{stem}-rates"))


def _remarks(mechanism: MechanismFragility) -> Iterator[Block]:
    """Yield notes on the mechanism, and on curves and rates by its first measure; the tables have those on others."""
    first = first_measure(mechanism)
    of_states = [(curve.state, note) for curve in curves_by(mechanism, first) for note in curve.notes]
    of_states += [(risk.state, note) for risk in mechanism.risks if risk.measure == first for note in risk.notes]
    said = [say("{state}: {note}", state=state_text(state), note=note) for state, note in dict.fromkeys(of_states)]
    if mechanism.notes or said:
        yield Prose((say("Remarks on this mechanism:"),))
        yield Items((*distinct(mechanism.notes), *said))
