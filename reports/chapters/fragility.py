"""The report of `assess fragility`: all mechanisms in one table, the pages of each, method, records and sources."""

from __future__ import annotations

from collections.abc import Iterator

from assess.messages.message import Severity
from assess.results.fragility import FragilityResults, MeasureResult
from reports.chapters import fragility_page, fragility_tables, references
from reports.chapters import fragility_words as words
from reports.document import Block, Items, Prose, Section, nonempty
from reports.language.texts import Paragraph, Text, Verbatim, count, listing, say
from reports.measures import main_curve, measures_of

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
        _summary(results),
        *(fragility_page.section(results, each) for each in results.mechanisms),
        _method(results),
        Section(say("Sources"), 0, (Items(tuple(_sources(results))),)),
    ]


def _summary(results: FragilityResults) -> Section:
    told = tuple(
        say(
            "{mechanism}: {sentences}",
            mechanism=fragility_tables.numbered_name(results, each),
            sentences=Paragraph(said),
        )
        for each in results.mechanisms
        if (said := tuple(words.summary(each, results.hazard)))
    )
    blocks: list[Block] = [Items(told)] if told else []
    blocks += [*nonempty(fragility_tables.overview(results)), Prose(tuple(_reading(results)))]
    warned = tuple(each for each in results.warnings if each.severity is not Severity.NOTE)
    if warned:
        blocks += [Prose((say("Warnings:"),)), Items(warned)]
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


def _method(results: FragilityResults) -> Section:
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
    blocks = (Prose(tuple(said)), *nonempty(fragility_tables.records(results)))
    return Section(say("Method and records"), 0, blocks, starts_page=True)


def _sources(results: FragilityResults) -> Iterator[Text]:
    yield from WORKS
    if any(_is_dimensionless(each) for mechanism in results.mechanisms for each in measures_of(mechanism)):
        yield DIMENSIONLESS
    yield references.HOUSNER


def _is_dimensionless(measure: MeasureResult) -> bool:
    return measure.dimension == "ratio"
