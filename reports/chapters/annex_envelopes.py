"""Annex C: overturning envelopes, and the critical mechanism at each frequency."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from assess.results import CriticalResult, EnvelopeResult, MechanismResult, RecordResult, Results
from reports.chapters.cells import MECHANISM
from reports.document import Block, Cell, Column, Figure, Prose, Section, Table, nonempty
from reports.figures import rocking as figure
from reports.language.texts import Listing, Paragraph, Text, Verbatim, quantity, say, say_count
from reports.mechanisms import file_stem, mechanism_number, mechanism_title, numbered_title

MARK = "C"
PULSES = {
    "sine": say("one full sine"),
    "cosine": say("one full cosine"),
    "half-sine": say("half a sine"),
    "ricker": say("symmetric Ricker wavelets"),
    "ricker-antisymmetric": say("antisymmetric Ricker wavelets"),
    "mavroeidis-papageorgiou": say("pulses after Mavroeidis and Papageorgiou"),
}
METHOD = say(
    "Every pulse is run in both polarities and the worse counts. The least pulse that overturns is a lower bound: "
    "above it there can be safe islands, which the map shows, so surviving a stronger pulse proves nothing. The bound "
    "is searched in steps of one or two percent and then by bisection; a narrower band of overturning can be missed. "
    "A pulse is not a bound for a record that contains it: the time histories remain the check."
)


def sections(results: Results) -> list[Section]:
    """Return the annex, a part for each envelope; none without envelopes. The critical ones are in the comparison."""
    return _envelope_sections(results, [])


def report_sections(results: Results) -> list[Section]:
    """Return the chapter of a report on envelopes alone: the critical mechanisms, then a part for each envelope."""
    return _envelope_sections(results, critical_blocks(results))


def critical_blocks(results: Results) -> list[Block]:
    """Return sentence and figure on the critical mechanisms; none where they were not compared."""
    critical = results.critical
    if critical is None:
        return []
    caption = say(
        "Least pulse that overturns each mechanism, by frequency, and below it the critical mechanism (as Mehrotra "
        "Figs. 3.11 and 8.5). Amplitudes are those of the ground and include amplification up the building."
    )
    return [
        Prose((_critical_sentence(results, critical),)),
        Figure("critical", caption, partial(figure.draw_envelope_bounds, results)),
    ]


def primary_pulses_table(records: Sequence[RecordResult]) -> Table:
    """Tabulate the pulses within the records."""
    columns = (
        Column(say("Record"), share=0.3),
        Column(say("Rank")),
        Column(say("Frequency"), "frequency"),
        Column(say("Amplitude"), "ground acceleration"),
        Column(say("Polarity")),
        Column(say("Start"), "time"),
        Column(say("Share of energy"), "ratio"),
    )
    rows = tuple(
        (Verbatim(record.id), place, p.frequency_hz, p.amplitude_g, p.polarity, p.start_s, p.energy_share)
        for record in records
        for place, p in enumerate(record.primary_pulses, start=1)
    )
    caption = say(
        "Primary pulses of the records as scaled to the site: best match of the pulse to the acceleration (matching "
        "index after Vassiliou and Makris 2011) and the next local optima; a longer, weaker pulse can be worse."
    )
    return Table("primary-pulses", caption, columns, rows, small=True)


def describe_envelope(one: EnvelopeResult) -> Text:
    """Describe an envelope in a sentence or two."""
    most = quantity(one.amplitude_g[-1], "ground acceleration", 3)
    known = [(bound, f) for bound, f in zip(one.lower_bound_g, one.frequency_hz, strict=True) if bound is not None]
    if not known:
        return say("No pulse up to {most} overturns it at any of the frequencies.", most=most)
    least, at = min(known)
    sentences: list[Text] = [
        say(
            "The weakest pulse that overturns it has {least}, at {frequency}.",
            least=quantity(least, "ground acceleration", 3),
            frequency=quantity(at, "frequency", 3),
        )
    ]
    none = len(one.lower_bound_g) - len(known)
    if none:
        sentences.append(
            say_count(
                "At {number} of {all} frequencies no pulse up to {most} does.",
                "At {number} of {all} frequencies no pulse up to {most} does.",
                none,
                all=quantity(len(one.lower_bound_g), figures=9),
                most=most,
            )
        )
    if any(one.islands):
        sentences.append(say("There are safe islands: some stronger pulses do not overturn it."))
    if one.case:
        sentences.append(
            say(
                "The envelope is that of the controlling case, {case}; another case can need less.",
                case=Verbatim(one.case),
            )
        )
    return Paragraph((*sentences, *_amplification(one)))


def data_tables(results: Results) -> list[Table]:
    """Tabulate every bound at every frequency, for the spreadsheet and the CSV files."""
    mapped = _mechanisms_with_envelope(results)
    columns = (
        MECHANISM,
        Column(say("Frequency"), "frequency"),
        Column(say("Least pulse"), "ground acceleration"),
        Column(say("Polarity")),
        Column(say("Uplift"), "ground acceleration"),
        Column(say("Amplification"), "ratio"),
        Column(Verbatim("ω/p"), "ratio"),
        Column(Verbatim("a/(gλ)"), "ratio"),
        Column(say("Critical")),
    )
    critical = results.critical.mechanism if results.critical is not None else ()
    rows: tuple[tuple[Cell, ...], ...] = tuple(
        (numbered_title(results, mechanism.name), f, bound, sign, up, factor, omega, ratio, name == mechanism.name)
        for mechanism, one in mapped
        for f, bound, sign, up, factor, omega, ratio, name in zip(
            one.frequency_hz, one.lower_bound_g, one.polarity, one.uplift_g, one.factor, one.omega,
            one.lower_bound_ratio, critical, strict=True,
        )
    )  # fmt: skip
    caption = say(
        "Least pulse that overturns each mechanism at each frequency; a/(gλ) over ω/p is the dimensionless plot."
    )
    return [Table("envelopes", caption, columns, rows)] if rows else []


def _envelope_sections(results: Results, first: list[Block]) -> list[Section]:
    mapped = _mechanisms_with_envelope(results)
    if not mapped:
        return []
    blocks: list[Block] = [*first, Prose((METHOD,))]
    blocks += nonempty(_bands_table(results)) + nonempty(primary_pulses_table(results.records))
    head = Section(say("Overturning envelopes"), 0, tuple(blocks), starts_page=True, mark=MARK)
    return [head, *(_envelope_section(results, mechanism, one) for mechanism, one in mapped)]


def _critical_sentence(results: Results, critical: CriticalResult) -> Text:
    """Return which mechanism is critical over which frequencies."""
    bands = tuple(
        say(
            "{mechanism} from {low} to {high}",
            mechanism=numbered_title(results, band.mechanism),
            low=quantity(band.from_hz, "frequency", 3),
            high=quantity(band.to_hz, "frequency", 3),
        )
        for band in critical.bands
        if band.mechanism is not None
    )
    if not bands:
        return say("No pulse up to the highest amplitude overturns any mechanism.")
    close = sum(len(near) > 1 for near in critical.near)
    found = say("The weakest pulse overturns {bands}.", bands=Listing(bands))
    if not close:
        return found
    doubt = say_count(
        "At {number} of {all} frequencies a second mechanism needs less than 5 % more: there the order is not certain.",
        "At {number} of {all} frequencies a second mechanism needs less than 5 % more: there the order is not certain.",
        close,
        all=quantity(len(critical.near), figures=9),
    )
    return Paragraph((found, doubt))


def _bands_table(results: Results) -> Table:
    """Tabulate the bands of frequency in which each mechanism is critical."""
    columns = (Column(say("Critical mechanism")), Column(say("From"), "frequency"), Column(say("To"), "frequency"))
    bands = () if results.critical is None else results.critical.bands
    rows = tuple((_critical_mechanism(results, band.mechanism), band.from_hz, band.to_hz) for band in bands)
    caption = say(
        "Critical mechanism over the frequency of the pulse; where two bounds cross, by straight lines between."
    )
    return Table("critical-bands", caption, columns, rows, small=True)


def _critical_mechanism(results: Results, mechanism: str | None) -> Text:
    return say("none overturns") if mechanism is None else numbered_title(results, mechanism)


def _envelope_section(results: Results, mechanism: MechanismResult, one: EnvelopeResult) -> Section:
    """Return the part on the envelope of one mechanism."""
    place = next(place for place, each in enumerate(results.mechanisms, start=1) if each is mechanism)
    caption = say(
        "Outcome of {pulses} by frequency and peak ground acceleration ({equation} equation): white at rest, grey "
        "rocking, red overturned; line: the least pulse that overturns; dots, if any: the best primary pulse of each "
        "record, scaled to the site. Where no pulse at higher frequencies overturns it, the axis ends early.",
        pulses=PULSES[one.shape],
        equation=say("exact") if one.equation == "exact" else say("linearised"),
    )
    draw = partial(figure.draw_envelope, one, results.records)
    blocks = (
        Prose((describe_envelope(one),)),
        Figure(f"{file_stem(mechanism.name, place)}-envelope", caption, draw),
    )
    return Section(Verbatim(mechanism_title(mechanism)), 1, blocks, mark=mechanism_number(results, mechanism.name))


def _amplification(one: EnvelopeResult) -> tuple[Text, ...]:
    """Return how much of the ground's motion reaches the mechanism; none where it acts as it is."""
    least, most = (quantity(value, figures=3) for value in (min(one.factor), max(one.factor)))
    if least.value == most.value == 1.0:
        return ()
    if least.value == most.value:
        return (say("The motion at its base is {most} times that of the ground.", most=most),)
    text = say(
        "The motion at its base is {least} to {most} times that of the ground, depending on frequency.",
        least=least,
        most=most,
    )
    of_sine = say("These are the factors of a full sine of the same frequency.")
    return (text,) if one.shape == "sine" else (text, of_sine)


def _mechanisms_with_envelope(results: Results) -> list[tuple[MechanismResult, EnvelopeResult]]:
    """Return the mechanisms that have an envelope, each with it."""
    return [(mechanism, mechanism.envelope) for mechanism in results.mechanisms if mechanism.envelope is not None]
