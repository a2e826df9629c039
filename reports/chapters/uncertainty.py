"""The chapter on uncertainty: how the deciding answers spread, how often they fail, and what they hang on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from operator import attrgetter

from assess.messages.message import distinct
from assess.results import Results
from assess.results.run import Influence, UncertainAnswer, UncertainInput, UncertaintyResult
from reports.chapters.cells import (
    FIGURES,
    LEVEL,
    LIMIT_STATE,
    MECHANISM,
    METHOD,
    ROLE,
    ROLES,
    UNIT,
    state_text,
    value_cell,
    value_name,
)
from reports.document import (
    Block,
    BulletList,
    Column,
    Field,
    Figure,
    FigureRow,
    Prose,
    Section,
    Table,
    nonempty,
    tabulate,
    tabulate_parts,
)
from reports.figures import sensitivity as figure
from reports.intensity_measures import PERCENT
from reports.language.texts import Paragraph, Phrase, Text, Verbatim, count, listing, quantity, say, say_count
from reports.mechanisms import file_stem, numbered_title, procedure_title

MOST = 4
"""Rows of the table of the main part."""
DENSITY = ".density"
MEDIAN = 2
"""Place of the quantile at 50 %."""
DISTRIBUTIONS: Mapping[str, Phrase] = {
    "normal": say("normal"),
    "lognormal": say("lognormal"),
    "uniform": say("uniform"),
}
KEY: Field[UncertainInput] = (Column(say("Key"), share=0.4), lambda each: Verbatim(each.key))
SPREAD: tuple[Field[UncertainInput], ...] = (
    (Column(say("Coefficient of variation"), "ratio", FIGURES), lambda each: each.cov),
    (Column(say("Distribution")), lambda each: DISTRIBUTIONS[each.distribution]),
    (Column(say("Group")), lambda each: Verbatim(each.group)),
)


def sections(results: Results) -> list[Section]:
    """Return the chapter, of half a page; none where nothing was sampled."""
    found = results.uncertainty
    if found is None or not found.answers:
        return []
    shown = shown_answers(found)
    blocks: list[Block] = [
        Prose((Paragraph(tuple(_findings(results, found))),)),
        *nonempty(_table(results, shown[:MOST], "uncertainty-main")),
        *(figures(results, each) for each in _spread_out(shown)[:1]),
    ]
    return [Section(say("Uncertainty"), 0, tuple(blocks))]


def annex_sections(results: Results) -> list[Section]:
    """Return for the annex the inputs, the answers that the chapter has no room for, and what was noted."""
    found = results.uncertainty
    if found is None or not found.answers:
        return []
    shown = shown_answers(found)
    blocks: list[Block] = [*nonempty(inputs_table(found)), *nonempty(_table(results, shown, "uncertainty-answers"))]
    blocks += [figures(results, each) for each in _spread_out(shown)[1:]]
    notes = (*distinct(found.notes), *dict.fromkeys(_remarks(results, shown)))
    blocks += [BulletList(notes)] if notes else []
    return [Section(say("Uncertainty of all answers"), 1, tuple(blocks))]


def shown_answers(found: UncertaintyResult) -> list[UncertainAnswer]:
    """Return the deciding answers, those that fail most often first; all of them where none decides."""
    deciding = [each for each in found.answers if each.role == "deciding"] or list(found.answers)
    return sorted(deciding, key=lambda each: (-(each.probability or 0.0), -(each.at_mean or 0.0)))


def densities_without_effect(results: Results, found: UncertaintyResult) -> Iterator[Text]:
    """Yield that densities change no answer of a mechanism, for those of which that is so."""
    mechanisms: dict[tuple[str, ...], list[str]] = {}
    for name in dict.fromkeys(answer.mechanism for answer in found.answers):
        known = [each for answer in found.answers if answer.mechanism == name for each in answer.influences]
        changing = {key for each in known if each.rank_correlation is not None for key in each.keys}
        keys = tuple(dict.fromkeys(key for each in known for key in each.keys if key.endswith(DENSITY)))
        unchanging = tuple(key for key in keys if key not in changing)
        if unchanging:
            mechanisms.setdefault(unchanging, []).append(name)
    for unchanging, named in mechanisms.items():
        yield say_count(
            "For {mechanisms}, {keys} changes nothing: the weight that holds a free wall and the inertia that "
            "overturns it grow alike.",
            "For {mechanisms}, {keys} change nothing: the weight that holds a free wall and the inertia that "
            "overturns it grow alike.",
            len(unchanging),
            mechanisms=listing(numbered_title(results, name) for name in named),
            keys=listing(value_name(results, key) for key in unchanging),
        )


def figures(results: Results, answer: UncertainAnswer) -> FigureRow:
    """Return the distribution of an answer beside its influences."""
    found = results.uncertainty
    place = 0 if found is None else found.answers.index(answer) + 1
    stem = f"{_stem(results, answer.mechanism)}-uncertainty-{place:02d}"
    caption = say(
        "{mechanism}, {method}: samples by demand over capacity; red: the limit, dotted: at the means. Samples that "
        "overturn have no finite ratio.",
        mechanism=numbered_title(results, answer.mechanism),
        method=procedure_title(answer.procedure),
    )
    spread = Figure(f"{stem}-distribution", caption, partial(figure.draw_distribution, answer))
    caption = say("What this answer hangs on: to the right, a larger value makes it worse.")
    return FigureRow((spread, Figure(f"{stem}-influences", caption, partial(figure.draw_influences, answer))))


def inputs_table(found: UncertaintyResult) -> Table:
    """Tabulate the uncertain inputs, each mean with its unit."""
    mean: Field[UncertainInput] = (
        Column(say("Mean")),
        lambda each: value_cell(each.mean, each.unit.replace("^", "")),
    )
    caption = say("Uncertain values; those of one group vary together.")
    return tabulate("uncertainty-inputs", caption, (KEY, mean, *SPREAD), found.inputs, small=True)


def data_tables(results: Results) -> Iterator[Table]:
    """Yield every number, for the spreadsheet and the CSV files."""
    found = results.uncertainty
    if found is None:
        return
    yield _means(found)
    yield _statistics(results, found)
    yield _influences(results, found)
    yield _samples(results, found)


def _remarks(results: Results, shown: list[UncertainAnswer]) -> Iterator[Text]:
    for answer in shown:
        lead = {"mechanism": numbered_title(results, answer.mechanism), "method": procedure_title(answer.procedure)}
        yield from (say("{mechanism}, {method}: {note}", **lead, note=note) for note in answer.notes)


def _findings(results: Results, found: UncertaintyResult) -> Iterator[Text]:
    yield say_count(
        "{number} uncertain value of the project varies in {samples} samples (Sobol sequence, seed {seed}), and every "
        "mechanism is assessed in each.",
        "{number} uncertain values of the project vary together in {samples} samples (Sobol sequence, seed {seed}), "
        "and every mechanism is assessed in each.",
        len(found.inputs),
        samples=count(found.samples),
        seed=count(found.seed),
    )
    yield say("The probability of failing is the share of samples that fail: of these values alone, not of records.")
    yield from densities_without_effect(results, found)


def _spread_out(answers: list[UncertainAnswer]) -> list[UncertainAnswer]:
    """Return the answers that any value changes, which alone have something to draw."""
    return [each for each in answers if figure.rank_influences(each)]


def _stem(results: Results, name: str) -> str:
    return file_stem(name, [each.name for each in results.mechanisms].index(name) + 1)


def _table(results: Results, answers: list[UncertainAnswer], name: str) -> Table:
    fields: tuple[Field[UncertainAnswer], ...] = (
        *_lead(results)[:3],
        (Column(say("D/C at the means"), "ratio", FIGURES), lambda each: each.at_mean),
        (Column(say("Median D/C"), "ratio", FIGURES), lambda each: each.quantiles[MEDIAN]),
        (Column(say("Fails"), "percent", FIGURES), lambda each: each.probability and PERCENT * each.probability),
        (Column(say("95 % interval")), _interval),
        (Column(say("Hangs most on")), _strongest_group),
    )
    caption = say("Deciding answers over all samples: share of samples that fail, with its interval.")
    return tabulate(name, caption, fields, answers, small=True)


def _strongest_group(each: UncertainAnswer) -> Text:
    strongest = figure.rank_influences(each)[:1]
    return figure.input_group_name(strongest[0]) if strongest else say("none of the values")


def _interval(each: UncertainAnswer) -> Text | None:
    if each.interval is None:
        return None
    low, high = (quantity(PERCENT * end, "percent", FIGURES) for end in each.interval)
    return say("{low} to {high}", low=low, high=high)


def _means(found: UncertaintyResult) -> Table:
    """Tabulate the uncertain inputs in SI."""
    fields: tuple[Field[UncertainInput], ...] = (
        KEY,
        (Column(say("Mean"), "ratio"), lambda each: each.mean),
        (UNIT, lambda each: Verbatim(each.unit)),
        *SPREAD,
    )
    return tabulate("uncertainty-means", say("Uncertain values, in SI."), fields, found.inputs)


def _lead(results: Results) -> tuple[Field[UncertainAnswer], ...]:
    """Return the columns that say which answer a row is of."""
    return (
        (MECHANISM, lambda each: numbered_title(results, each.mechanism)),
        (METHOD, lambda each: procedure_title(each.procedure)),
        (LIMIT_STATE, lambda each: state_text(each.limit_state)),
        (LEVEL, lambda each: each.level_pga_g),
    )


def _statistics(results: Results, found: UncertaintyResult) -> Table:
    quantiles = (say("5 %"), say("16 %"), say("50 %"), say("84 %"), say("95 %"))
    fields: tuple[Field[UncertainAnswer], ...] = (
        *_lead(results),
        (ROLE, lambda each: ROLES[each.role]),
        (Column(say("Samples answered")), lambda each: each.answered),
        (Column(say("Samples that fail")), lambda each: each.failed),
        (Column(say("Probability of failing"), "ratio"), lambda each: each.probability),
        (Column(say("from"), "ratio"), lambda each: each.interval and each.interval[0]),
        (Column(say("to"), "ratio"), lambda each: each.interval and each.interval[1]),
        (Column(say("D/C at the means"), "ratio"), lambda each: each.at_mean),
        *((Column(label, "ratio"), partial(_quantile, place)) for place, label in enumerate(quantiles)),
    )
    caption = say("Every answer over all samples; quantiles of demand over capacity.")
    return tabulate("uncertainty", caption, fields, found.answers)


def _quantile(place: int, each: UncertainAnswer) -> float | None:
    return each.quantiles[place]


INFLUENCE_FIELDS: tuple[Field[Influence], ...] = (
    (Column(say("Group")), lambda one: Verbatim(one.group)),
    (Column(say("Rank correlation"), "ratio"), lambda one: one.rank_correlation),
    (Column(say("Share of the variance of ranks"), "ratio"), lambda one: one.share),
    (Column(say("Total with interactions"), "ratio"), lambda one: one.total),
)
SAMPLE_FIELDS: tuple[Field[tuple[int, float | None]], ...] = (
    (Column(say("Sample")), lambda sample: sample[0]),
    (Column(say("Demand / capacity"), "ratio"), lambda sample: sample[1]),
)


def _influences(results: Results, found: UncertaintyResult) -> Table:
    answers, influences = (_lead(results), found.answers), (INFLUENCE_FIELDS, attrgetter("influences"))
    return tabulate_parts("uncertainty-influences", say("What each answer hangs on."), answers, influences)


def _samples(results: Results, found: UncertaintyResult) -> Table:
    caption = say("Demand over capacity in every sample.")
    answers, samples = (_lead(results), found.answers), (SAMPLE_FIELDS, lambda each: enumerate(each.ratios, start=1))
    return tabulate_parts("uncertainty-samples", caption, answers, samples)
