"""The report of `assess fragility`: all mechanisms in one table, the pages of each, method, records and sources."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from assess.messages.message import Severity, distinct
from assess.results.fragility import (
    FragilityCurve,
    FragilityMethod,
    FragilityResults,
    HazardResult,
    MeasureResult,
    MechanismFragility,
    RateGap,
    RecordRunsResult,
    RiskResult,
)
from reports.chapters import fragility_tables, scope
from reports.document import Block, BulletList, Figure, FigureRow, Prose, Section, nonempty
from reports.figures import fragility as figures
from reports.figures.style import HALF, WIDTH
from reports.intensity_measures import (
    FIGURES,
    PERCENT,
    RATE_CURVES,
    RATE_FIGURES,
    curves_by,
    first_measure,
    hazard_of,
    intensity,
    last_state,
    main_curve,
    main_risk,
    measure_text,
    measures_of,
    percent,
    state_text,
    unit_intensity,
    value_with_interval,
)
from reports.language.texts import Paragraph, Phrase, Text, Verbatim, count, listing, quantity, say, say_count
from reports.language.value_names import key_words
from reports.mechanisms import file_stem

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
        *(_mechanism_section(results, each) for each in results.mechanisms),
        _method_section(results),
        Section(say("Sources"), 0, (BulletList(tuple(_cited_works(results))),)),
    ]


METHODS: Mapping[FragilityMethod, Phrase] = {
    "ida": say(
        "Each record is scaled step by step up to the largest scale and run at every step, in both polarities; the "
        "worse counts."
    ),
    "stripes": say(
        "At each intensity the records are scaled to it and run in both polarities; the worse counts."
    ),
    "cloud": say(
        "Each record is run as it is, in both polarities; the worse counts. A point is the share of some ten records "
        "of similar intensity; the lognormal is the one equivalent to the regression of the rotations on the intensity."
    ),
}  # fmt: skip

GAPS: Mapping[RateGap, Phrase] = {
    "motion": say(
        "the mechanism is above the ground and is not shaken by the motion there; give its amplification by the "
        "modal filter"
    ),
    "runs": say(
        "the hazard has stronger motions than those that were run; run to a larger intensity, or give stronger records"
    ),
    "hazard": say(
        "stronger or more frequent motions than the hazard lists may add to it; give a hazard of more return periods"
    ),
    "epistemic": say(
        "what is not known of the mechanism itself is not in the rate; give its dispersion in [analysis.fragility] "
        "epistemic"
    ),
}


def mechanism_summary(mechanism: MechanismFragility, hazards: Sequence[HazardResult] = ()) -> Iterator[Text]:
    """Yield what an owner should know of a mechanism: the intensities that overturn it, then its annual rate.

    Parameters
    ----------
    mechanism : with its curves and rates
    hazards : of the site, to say why there is no rate though one is given
    """
    curve, risk = main_curve(mechanism), main_risk(mechanism)
    if curve is not None:
        yield _intensity_sentence(curve)
        yield from _extrapolated(curve)
    if risk is not None:
        yield rate_sentence(risk)
        if risk.target_rate is not None:
            yield _target_sentence(risk)
    elif hazards:
        yield _no_rate_sentence(mechanism, hazards)


def rate_sentence(risk: RiskResult) -> Text:
    """Say the annual rate of a state at the site, and its probability in 50 years."""
    return say(
        "With the hazard of the site, the annual rate of {state} is {rate}, a probability of {probability} in 50 "
        "years.",
        state=state_text(risk.state),
        rate=quantity(risk.annual_rate, "annual rate", RATE_FIGURES),
        probability=quantity(PERCENT * risk.probability_50_years, "percent", RATE_FIGURES),
    )


def _first_page(results: FragilityResults) -> Section:
    points: tuple[Text, ...] = tuple(
        say(
            "{mechanism}: {sentences}",
            mechanism=fragility_tables.numbered_name(results, each),
            sentences=Paragraph(sentences),
        )
        for each in results.mechanisms
        if (sentences := tuple(mechanism_summary(each, results.hazard)))
    )
    points += tuple(_union_points(results))
    blocks: list[Block] = [BulletList(points)] if points else []
    blocks += [*nonempty(fragility_tables.overview_table(results)), Prose(tuple(_reading(results)))]
    warned = tuple(each for each in results.warnings if each.severity is not Severity.NOTE)
    if warned:
        blocks += [Prose((say("Warnings:"),)), BulletList(warned)]
    return Section(say("Fragility and risk"), 0, tuple(blocks))


def _union_points(results: FragilityResults) -> Iterator[Text]:
    """Yield how often at least one of several mechanisms overturns, and which of them do not count in that."""
    union = results.union
    if union is None:
        return
    named = {each.name: fragility_tables.numbered_name(results, each) for each in results.mechanisms}
    yield say(
        "At least one of {mechanisms}, under the same records: {sentence}",
        mechanisms=listing(named[name] for name in union.mechanisms),
        sentence=_intensity_sentence(union.curve),
    )
    if union.left_out:
        yield say(
            "Not counted there, as each shares a body with one that overturns more often: {mechanisms}.",
            mechanisms=listing(named[name] for name in union.left_out),
        )


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
    paragraphs = [METHODS[results.method], *(CLOUD if results.method == "cloud" else COUNTS), MEANS]
    paragraphs.append(
        say(
            "Bands and intervals of the lognormals: bootstrap by earthquake, {draws} draws, seed {seed}.",
            draws=count(results.draws),
            seed=count(results.seed),
        )
    )
    if results.hazard:
        sources = listing(dict.fromkeys(Verbatim(each.source) for each in results.hazard))
        paragraphs.append(
            say("Hazard of the site: {sources}. Rates are its convolution with the curve.", sources=sources)
        )
    if any(risk.target_rate is not None for each in results.mechanisms for risk in each.risks):
        paragraphs.append(WIDENED)
    blocks = (Prose(tuple(paragraphs)), *nonempty(fragility_tables.fragility_records_table(results)))
    return Section(say("Method and records"), 0, blocks, starts_page=True)


def _cited_works(results: FragilityResults) -> Iterator[Text]:
    yield from WORKS
    if any(each.dimension == "ratio" for mechanism in results.mechanisms for each in measures_of(mechanism)):
        yield DIMENSIONLESS
    yield scope.HOUSNER


def _mechanism_section(results: FragilityResults, mechanism: MechanismFragility) -> Section:
    """Return the pages of a mechanism: what it means, the curves, the runs behind them, the measures, the rates."""
    stem = file_stem(mechanism.name, [each.name for each in results.mechanisms].index(mechanism.name) + 1)
    blocks: list[Block] = [
        *_prose(mechanism_summary(mechanism, results.hazard)),
        *_curve_blocks(mechanism, stem),
        *nonempty(fragility_tables.curves_table(mechanism, f"{stem}-curves")),
        *_run_blocks(mechanism, stem),
        Prose((_islands_sentence(mechanism),)),
        *nonempty(fragility_tables.islands_table(mechanism, f"{stem}-islands", most=fragility_tables.MAX_ISLANDS)),
        *nonempty(fragility_tables.measures_table(mechanism, f"{stem}-measures")),
        *_rate_blocks(results, mechanism, stem),
        *_prose(_epistemic_sentences(mechanism)),
        *_remarks(mechanism),
    ]
    title = Verbatim(mechanism.label or mechanism.name)
    return Section(title, 0, tuple(blocks), starts_page=True, mark=fragility_tables.number_of(results, mechanism))


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
        yield Figure(f"{stem}-fragility", caption, partial(figures.draw_fragility, curve))
        yield from _prose(_describe_counts(curve))


def _run_blocks(mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    """Yield the figure of the runs, beside that of all states where there are several."""
    measure = first_measure(mechanism)
    curves = curves_by(mechanism, measure)
    pairs = _with_units(mechanism, measure)
    found = []
    if pairs and curves and measure is not None:
        draw = partial(
            figures.draw_record_runs,
            tuple(run for run, _ in pairs),
            tuple(unit for _, unit in pairs),
            measure,
            reach=max(map(figures.intensity_reach, curves)),
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
    return Figure(f"{stem}-states", caption, partial(figures.draw_states, curves))


def _rate_blocks(results: FragilityResults, mechanism: MechanismFragility, stem: str) -> Iterator[Block]:
    risk = main_risk(mechanism)
    if risk is not None:
        caption = say(
            "Which ground motions make up the annual rate of {state} ({curve}): above, how often the site exceeds each "
            "intensity; below, the share of the rate from each range of intensities.",
            state=state_text(risk.state),
            curve=RATE_CURVES[risk.curve],
        )
        draw = partial(figures.draw_risk, risk, hazard_of(risk, results.hazard))
        yield Figure(f"{stem}-contributions", caption, draw)
    yield from nonempty(fragility_tables.rates_table(mechanism, f"{stem}-rates"))


def _remarks(mechanism: MechanismFragility) -> Iterator[Block]:
    """Yield notes on the mechanism, and on curves and rates by its first measure; the tables have those on others."""
    first = first_measure(mechanism)
    of_states = [(curve.state, note) for curve in curves_by(mechanism, first) for note in curve.notes]
    of_states += [(risk.state, note) for risk in mechanism.risks if risk.measure == first for note in risk.notes]
    remarks = [say("{state}: {note}", state=state_text(state), note=note) for state, note in dict.fromkeys(of_states)]
    if mechanism.notes or remarks:
        yield Prose((say("Remarks on this mechanism:"),))
        yield BulletList((*distinct(mechanism.notes), *remarks))


def _no_rate_sentence(mechanism: MechanismFragility, hazards: Sequence[HazardResult]) -> Text:
    """Say why a mechanism has no annual rate although the hazard of the site is given."""
    state, measures = last_state(mechanism), [hazard.measure for hazard in hazards]
    found = [each for each in mechanism.curves if each.state == state and each.measure in measures]
    if found:
        return say(
            "How likely it is each year is not answered: the rate of a cloud is that of its lognormal, and there is "
            "none by {measure}: {why}.",
            measure=measure_text(found[0].measure),
            why=found[0].notes[0] if found[0].notes else say("the records do not bound one"),
        )
    return say(
        "How likely it is each year is not answered: there is no curve by {measures}, the measure of the hazard.",
        measures=listing(map(measure_text, measures)),
    )


def _intensity_sentence(curve: FragilityCurve) -> Text:
    """Say at which intensity 5 % and 50 % of the records reach the state of a curve."""
    fitted = curve.lognormal
    if fitted is None:
        return _counted_sentence(curve)
    low, half = (
        value_with_interval(value, ends, curve.measure)
        for value, ends in (
            (fitted.five_percent, fitted.five_percent_interval),
            (fitted.median, fitted.median_interval),
        )
    )
    words = {"measure": measure_text(curve.measure), "low": low, "half": half}
    if curve.state.name == "overturning":
        return say(
            "Ground motions with {measure} of {low} overturn it in 5 cases of 100, those with {half} in 50 of 100.",
            **words,
        )
    return say(
        "Ground motions with {measure} of {low} bring it to {state} in 5 cases of 100, those with {half} in 50 of 100.",
        state=state_text(curve.state),
        **words,
    )


def _extrapolated(curve: FragilityCurve) -> Iterator[Text]:
    """Say where the median of a curve lies beyond the runs."""
    if curve.lognormal is None or not curve.empirical:
        return
    last = curve.empirical[-1]
    if curve.method == "cloud" and curve.lognormal.median > curve.end:
        yield say(
            "The strongest record has {most}: what is said of 50 of 100 is extrapolated.",
            most=intensity(curve.end, curve.measure),
        )
    elif curve.lognormal.median > curve.end:
        yield say(
            "The runs end at {most}, where {share} of the records reach it: what is said of 50 of 100 is extrapolated.",
            most=intensity(last.intensity, curve.measure),
            share=percent(last.share),
        )


def _counted_sentence(curve: FragilityCurve) -> Text:
    """Say what was counted where the records do not bound a curve."""
    if not curve.empirical:
        return say("There is no run by {measure} to count.", measure=measure_text(curve.measure))
    last = curve.empirical[-1]
    values: dict[str, Text] = {
        "measure": measure_text(curve.measure),
        "most": intensity(last.intensity, curve.measure),
        "state": state_text(curve.state),
    }
    if not any(point.reached for point in curve.empirical):
        return say("No record brings it to {state} up to {measure} of {most}, the highest examined.", **values)
    return say_count(
        "At {measure} of {most}, {number} record of {all} brings it to {state}; these runs do not bound a lognormal.",
        "At {measure} of {most}, {number} records of {all} bring it to {state}; these runs do not bound a lognormal.",
        last.reached,
        all=count(last.records),
        **values,
    )


def _target_sentence(risk: RiskResult) -> Text:
    """Say whether the rate is within the target that the project sets."""
    target = quantity(risk.target_rate or 0.0, "annual rate", FIGURES)
    wide = quantity(risk.with_epistemic or 0.0, "annual rate", RATE_FIGURES)
    if risk.outcome == "fail" and risk.gap == "epistemic":
        return say(
            "With the epistemic dispersion it is {rate}, more than the target of {target}; only without that "
            "dispersion is it within.",
            rate=wide,
            target=target,
        )
    if risk.outcome == "fail":
        return say("This is more than the target of {target}.", target=target)
    if risk.gap is None:
        return say(
            "With the epistemic dispersion it is {rate}, within the target of {target}.", rate=wide, target=target
        )
    return say("Whether this is within the target of {target} is not known: {why}.", target=target, why=GAPS[risk.gap])


def _describe_counts(curve: FragilityCurve) -> Iterator[Text]:
    """Yield how many records make a curve, and what of them asks for care."""
    yield say_count(
        "{number} record of {events} makes this curve.",
        "{number} records of {events} make this curve.",
        curve.records,
        events=say_count("{number} earthquake", "{number} earthquakes", curve.events),
    )
    if curve.censored:
        yield say_count(
            "{number} of them does not reach the state at its largest scale and is counted as such.",
            "{number} of them do not reach the state at their largest scale and are counted as such.",
            curve.censored,
        )
    if curve.hollow:
        yield say_count(
            "{number} run behind it is of a record scaled by more than 4, which may not be like a real one of that "
            "strength.",
            "{number} runs behind it are of records scaled by more than 4, which may not be like real ones of that "
            "strength.",
            curve.hollow,
        )
    if curve.first is not None:
        yield say(
            "The dashed line is a bound and no fragility: rocking is not monotone, and a record may leave the "
            "mechanism standing above an intensity at which it reached the state."
        )


def _islands_sentence(mechanism: MechanismFragility) -> Text:
    """Say how many records have islands."""
    number = sum(bool(run.islands) for run in mechanism.runs)
    if not number:
        return say("No record has an island: none leaves the mechanism standing above a scale that overturns it.")
    return say_count(
        "{number} record of {all} leaves the mechanism standing above a scale that overturns it (islands).",
        "{number} records of {all} leave the mechanism standing above a scale that overturns it (islands).",
        number,
        all=count(len(mechanism.runs)),
    )


def _epistemic_sentences(mechanism: MechanismFragility) -> Iterator[Text]:
    """Yield the dispersion of what is not known of the mechanism, apart from that of records."""
    if mechanism.epistemic is None:
        yield say(
            "What is not known of the mechanism itself is not in these curves: its geometry, loads and materials are "
            "taken at their values in the project."
        )
        return
    parts = tuple(
        say("{key} {share}", key=key_words(key), share=quantity(share, figures=2))
        for key, share in (mechanism.epistemic_sources or {}).items()
    )
    total = quantity(mechanism.epistemic, figures=2)
    if parts:
        yield say(
            "Epistemic dispersion, of what is not known of the mechanism: {total} ({parts}). It is stated apart and is "
            "not in the curves; a target is compared with the rate that has it.",
            total=total,
            parts=listing(parts),
        )
    else:
        yield say(
            "Epistemic dispersion, of what is not known of the mechanism: {total}. It is stated apart and is not in "
            "the curves; a target is compared with the rate that has it.",
            total=total,
        )
