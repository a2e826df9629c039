"""The report of `assess fragility`: all mechanisms in one table, the pages of each, method, records and sources."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from assess.messages.message import Severity, distinct
from assess.results.fragility import (
    FragilityCurve,
    FragilityResults,
    MeasureResult,
    MechanismFragility,
    RecordRunsResult,
)
from reports.chapters import fragility_tables, scope
from reports.chapters import fragility_tables as tables
from reports.chapters import fragility_words as words
from reports.document import Block, BulletList, Figure, FigureRow, Prose, Section, nonempty
from reports.figures import fragility
from reports.figures import fragility as figure
from reports.figures.style import HALF, WIDTH
from reports.intensity_measures import (
    curves_by,
    first_measure,
    hazard_of,
    main_curve,
    main_risk,
    measure_text,
    measures_of,
    state_text,
    unit_intensity,
)
from reports.language.texts import Paragraph, Text, Verbatim, count, listing, say
from reports.titles import file_stem

COUNTS = (
    say(
        "The share of the records that reach a state is counted at each intensity, with Wilson’s interval. The "
        "lognormal is the one that makes these counts most likely (binomial maximum likelihood)."
    ),
    say(
        "Rocking is not monotone: a stronger motion can leave standing what a weaker one overturns. Rates are "
        "therefore computed from the share that reaches the state at each intensity. The distribution of the first "
        "intensity that reaches it counts a record as overturned from there on, and is a bound."
    ),
)
CLOUD = (say("Rates are computed from the lognormal: a cloud has too few points to integrate."),)

WIDENED = say(
    "A target is compared with the rate of the curve widened by the epistemic dispersion: its mean over a lognormal "
    "factor of median 1 and that dispersion on the intensity, which leaves the median of a lognormal and adds the two "
    "dispersions by the root of the sum of squares. Without that dispersion no rate is called within its target."
)

MEANS = say(
    "Masses, strengths and dimensions are those of the project, which should be means, and the confidence factor "
    "is 1; cautious values and safety factors would count twice what the dispersion holds."
)

DIMENSIONLESS = Verbatim(
    "Dimitrakopoulos, E. G. and Paraskeva, T. S. (2015). Dimensionless fragility curves for rocking response to "
    "near-fault excitations. Earthquake Engineering and Structural Dynamics 44(12), 2015–2033."
)

WORKS = (
    Verbatim(
        "Baker, J. W. (2015). Efficient analytical fragility function fitting using dynamic structural analysis. "
        "Earthquake Spectra 31(1), 579–599."
    ),
    Verbatim(
        "Vamvatsikos, D. and Cornell, C. A. (2002). Incremental dynamic analysis. Earthquake Engineering and "
        "Structural Dynamics 31(3), 491–514."
    ),
    Verbatim(
        "Wilson, E. B. (1927). Probable inference, the law of succession, and statistical inference. Journal of the "
        "American Statistical Association 22(158), 209–212."
    ),
    Verbatim(
        "Luco, N. and Cornell, C. A. (2007). Structure-specific scalar intensity measures for near-source and ordinary "
        "earthquake ground motions. Earthquake Spectra 23(2), 357–392."
    ),
    Verbatim(
        "Cornell, C. A. (1968). Engineering seismic risk analysis. Bulletin of the Seismological Society of America "
        "58(5), 1583–1606."
    ),
)


def sections(results: FragilityResults) -> list[Section]:
    """Return the chapters: the first page, a part for each mechanism, method and records, sources."""
    return [
        _first_page(results),
        *(mechanism_section(results, each) for each in results.mechanisms),
        _method_section(results),
        Section(say("Sources"), 0, (BulletList(tuple(_cited_works(results))),)),
    ]


def _first_page(results: FragilityResults) -> Section:
    told = tuple(
        say(
            "{mechanism}: {sentences}",
            mechanism=fragility_tables.numbered_name(results, each),
            sentences=Paragraph(said),
        )
        for each in results.mechanisms
        if (said := tuple(words.mechanism_summary(each, results.hazard)))
    )
    blocks: list[Block] = [BulletList(told)] if told else []
    blocks += [*nonempty(fragility_tables.overview_table(results)), Prose(tuple(_reading(results)))]
    warned = tuple(each for each in results.warnings if each.severity is not Severity.NOTE)
    if warned:
        blocks += [Prose((say("Warnings:"),)), BulletList(warned)]
    return Section(say("Fragility and risk"), 0, tuple(blocks))


def _reading(results: FragilityResults) -> Iterator[Text]:
    """Yield how to read the first page."""
    fitted = [curve.lognormal for each in results.mechanisms if (curve := main_curve(each)) is not None]
    if any(one is not None and one.median_interval is not None for one in fitted):
        yield say(
            "The intervals (95 %) are what the limited number of records leaves open. They do not hold what is unknown "
            "of the building, and the answer is for the mechanisms examined alone."
        )
    if not results.hazard:
        yield say("How likely it is each year is not answered: give the hazard of the site in [analysis.risk].")


def _method_section(results: FragilityResults) -> Section:
    said = [words.METHODS[results.method], *(CLOUD if results.method == "cloud" else COUNTS), MEANS]
    said.append(
        say(
            "Bands and intervals of the lognormals: bootstrap by earthquake, {draws} draws, seed {seed}.",
            draws=count(results.draws),
            seed=count(results.seed),
        )
    )
    if results.hazard:
        sources = listing(dict.fromkeys(Verbatim(each.source) for each in results.hazard))
        said.append(say("Hazard of the site: {sources}. Rates are its convolution with the curve.", sources=sources))
    if any(risk.target_rate is not None for each in results.mechanisms for risk in each.risks):
        said.append(WIDENED)
    blocks = (Prose(tuple(said)), *nonempty(fragility_tables.records_table(results)))
    return Section(say("Method and records"), 0, blocks, starts_page=True)


def _cited_works(results: FragilityResults) -> Iterator[Text]:
    yield from WORKS
    if any(_is_dimensionless(each) for mechanism in results.mechanisms for each in measures_of(mechanism)):
        yield DIMENSIONLESS
    yield scope.HOUSNER


def _is_dimensionless(measure: MeasureResult) -> bool:
    return measure.dimension == "ratio"


def mechanism_section(results: FragilityResults, mechanism: MechanismFragility) -> Section:
    """Return the pages of a mechanism: what it means, the curves, the runs behind them, the measures, the rates."""
    stem = file_stem(mechanism.name, [each.name for each in results.mechanisms].index(mechanism.name) + 1)
    blocks: list[Block] = [
        *_prose(words.mechanism_summary(mechanism, results.hazard)),
        *_curve_blocks(mechanism, stem),
        *nonempty(tables.curves_table(mechanism, f"{stem}-curves")),
        *_run_blocks(mechanism, stem),
        Prose((words.islands_sentence(mechanism),)),
        *nonempty(tables.islands_table(mechanism, f"{stem}-islands", most=tables.MAX_ISLANDS)),
        *nonempty(tables.measures_table(mechanism, f"{stem}-measures")),
        *_rate_blocks(results, mechanism, stem),
        *_prose(words.epistemic_sentences(mechanism)),
        *_remarks(mechanism),
    ]
    title = Verbatim(mechanism.label or mechanism.name)
    return Section(title, 0, tuple(blocks), starts_page=True, mark=tables.number_of(results, mechanism))


def _prose(sentences: Iterator[Text]) -> list[Block]:
    said = tuple(sentences)
    return [Prose((Paragraph(said),))] if said else []


def _curve_blocks(mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    curve = main_curve(mechanism)
    if curve is not None:
        caption = say(
            "Share of the records that bring it to {state}, over {measure}. Points: counted, each with its Wilson "
            "interval, hollow where most records are scaled by more than 4; line: lognormal with its bootstrap band; "
            "dashed, if any: a bound, from the first intensity that reaches the state.",
            state=state_text(curve.state),
            measure=measure_text(curve.measure),
        )
        yield Figure(f"{stem}-fragility", caption, partial(figure.draw_fragility, curve))
        yield from _prose(words.describe_counts(curve))


def _run_blocks(mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    """Yield the figure of the runs, beside that of all states where there are several."""
    measure = first_measure(mechanism)
    curves = curves_by(mechanism, measure)
    pairs = _with_units(mechanism, measure)
    found = []
    if pairs and curves and measure is not None:
        draw = partial(
            fragility.draw_record_runs,
            tuple(run for run, _ in pairs),
            tuple(unit for _, unit in pairs),
            measure,
            reach=max(map(figure.intensity_reach, curves)),
            width=HALF if len(curves) > 1 else WIDTH,
        )
        caption = say(
            "Largest rotation over that which overturns, at rising intensity; a line for each record. Diamonds, if "
            "any: islands."
        )
        found.append(Figure(f"{stem}-runs", caption, draw))
    if len(curves) > 1:
        found.append(_states_figure(curves, stem))
    yield from [FigureRow(tuple(found))] if len(found) > 1 else found


def _with_units(mechanism: MechanismFragility, measure: MeasureResult | None) -> list[tuple[RecordRunsResult, float]]:
    """Return the runs of each record whose intensity is known, with its intensity at scale 1."""
    if measure is None:
        return []
    units = ((run, unit_intensity(mechanism, measure, run)) for run in mechanism.runs)
    return [(run, unit) for run, unit in units if unit is not None]


def _states_figure(curves: tuple[FragilityCurve, ...], stem: str) -> Figure:
    caption = say(
        "Share of the records that reach each state: counted (hollow: most scaled by more than 4), lognormal."
    )
    return Figure(f"{stem}-states", caption, partial(figure.draw_states, curves))


def _rate_blocks(results: FragilityResults, mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    risk = main_risk(mechanism)
    if risk is not None:
        caption = say(
            "Which ground motions make up the annual rate of {state} ({curve}): above, how often the site exceeds each "
            "intensity; below, the share of the rate from each range of intensities.",
            state=state_text(risk.state),
            curve=words.RATE_CURVES[risk.curve],
        )
        draw = partial(fragility.draw_risk, risk, hazard_of(risk, results.hazard))
        yield Figure(f"{stem}-contributions", caption, draw)
    yield from nonempty(tables.rates_table(mechanism, f"{stem}-rates"))


def _remarks(mechanism: MechanismFragility) -> Iterator[Block]:
    """Yield notes on the mechanism, and on curves and rates by its first measure; the tables have those on others."""
    first = first_measure(mechanism)
    of_states = [(curve.state, note) for curve in curves_by(mechanism, first) for note in curve.notes]
    of_states += [(risk.state, note) for risk in mechanism.risks if risk.measure == first for note in risk.notes]
    said = [say("{state}: {note}", state=state_text(state), note=note) for state, note in dict.fromkeys(of_states)]
    if mechanism.notes or said:
        yield Prose((say("Remarks on this mechanism:"),))
        yield BulletList((*distinct(mechanism.notes), *said))
