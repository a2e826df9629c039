"""Overturning envelopes in the report."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from assess.results import CriticalResult, EnvelopeResult, MechanismResult, RecordResult, Results
from reports.document import Block, Cell, Column, Figure, Section, Table, Text
from reports.figures import envelope as figure
from reports.language.message_text import message_text
from reports.language.numerals import numeral
from reports.mechanism_title import mechanism_title

PULSES = {
    "sine": "one full sine",
    "cosine": "one full cosine",
    "half-sine": "half a sine",
    "ricker": "symmetric Ricker wavelets",
    "ricker-antisymmetric": "antisymmetric Ricker wavelets",
    "mavroeidis-papageorgiou": "pulses after Mavroeidis and Papageorgiou",
}
METHOD = (
    "Every pulse is run in both polarities and the worse counts. The least pulse that overturns is a "
    "lower bound: above it there can be safe islands, which the map shows, so surviving a stronger pulse "
    "proves nothing. The bound is searched in steps of one or two percent and then by bisection; a "
    "narrower band of overturning can be missed. A pulse is not a bound for a record that contains it: "
    "the time histories remain the check."
)


def critical_chapter(results: Results) -> list[Section]:
    """Return the chapter on the critical mechanism at each frequency; none without envelopes."""
    critical, mapped = results.critical, mechanisms_with_envelope(results)
    if critical is None or not mapped:
        return []
    caption = (
        "Least pulse that overturns each mechanism, by frequency, and below it the critical mechanism (as "
        "thesis Figs. 3.11, 8.5). Amplitudes are those of the ground and include amplification up the "
        "building."
    )
    names = [(mechanism_title(mechanism), one) for mechanism, one in mapped]
    called = {mechanism.name: mechanism_title(mechanism) for mechanism, _ in mapped}
    blocks: list[Block] = [
        Text((critical_sentence(critical, called), METHOD)),
        Figure("critical", caption, partial(figure.bounds, names, rename_mechanisms(critical, called))),
        bands_table(critical, called),
        *_primary_pulses(results.records),
    ]
    return [Section("Overturning envelopes and critical mechanisms", 0, tuple(blocks), starts_page=True)]


def rename_mechanisms(critical: CriticalResult, called: dict[str, str]) -> CriticalResult:
    """Return the critical result with the titles of mechanisms in place of their names."""
    bands = tuple(replace(band, mechanism=called.get(band.mechanism or "")) for band in critical.bands)
    return replace(critical, bands=bands)


def critical_sentence(critical: CriticalResult, called: dict[str, str]) -> str:
    """Return which mechanism is critical over which frequencies."""
    parts = [
        f"{called[band.mechanism]} from {numeral(band.from_hz, digits=3)} to {numeral(band.to_hz, digits=3)} Hz"
        for band in critical.bands
        if band.mechanism is not None
    ]
    if not parts:
        return "No pulse up to the highest amplitude overturns any mechanism."
    close = sum(len(near) > 1 for near in critical.near)
    doubt = (
        f" At {close} of {len(critical.near)} frequencies a second mechanism needs less than 5 % more: there the "
        "order is not certain."
        if close
        else ""
    )
    return f"The weakest pulse overturns {'; '.join(parts)}.{doubt}"


def bands_table(critical: CriticalResult, called: dict[str, str]) -> Table:
    """Tabulate the bands of frequency in which each mechanism is critical."""
    columns = (Column("Critical mechanism"), Column("From", "Hz", "number"), Column("To", "Hz", "number"))
    rows = tuple(
        (called.get(band.mechanism or "", "none overturns"), band.from_hz, band.to_hz) for band in critical.bands
    )
    caption = "Critical mechanism over the frequency of the pulse; where two bounds cross, by straight lines between."
    return Table("critical-bands", caption, columns, rows)


def _primary_pulses(records: Sequence[RecordResult]) -> list[Block]:
    rows: list[tuple[Cell, ...]] = [
        (record.id, place, p.frequency_hz, p.amplitude_g, p.polarity, p.start_s, p.energy_share)
        for record in records
        for place, p in enumerate(record.primary_pulses, start=1)
    ]
    if not rows:
        return []
    columns = (
        Column("Record"),
        Column("Rank", kind="number"),
        Column("Frequency", "Hz", "number"),
        Column("Amplitude", "g", "number"),
        Column("Polarity", kind="number"),
        Column("Start", "s", "number"),
        Column("Share of energy", "-", "number"),
    )
    caption = (
        "Primary pulses of the records as scaled to the site: best match of the pulse to the acceleration (matching "
        "index after Vassiliou and Makris 2011) and the next local optima; a longer, weaker pulse can be worse."
    )
    return [Table("primary-pulses", caption, columns, tuple(rows))]


def chapter(mechanism: MechanismResult, records: Sequence[RecordResult], name: str, *, level: int) -> list[Section]:
    """Return the section on the envelope of one mechanism; none without an envelope."""
    one = mechanism.envelope
    if one is None:
        return []
    title = f"Overturning envelope: {mechanism_title(mechanism)}" if level == 0 else "Overturning envelope"
    caption = (
        f"Outcome of {PULSES[one.shape]} by frequency and peak ground acceleration ({one.equation} equation): white at "
        "rest, grey rocking, red overturned; line: the least pulse that overturns; dots, if any: the best primary "
        "pulse of each record, scaled to the site, where it is within the axes. Where no pulse at higher frequencies "
        "overturns it, the axis ends early."
    )
    draw = partial(figure.draw, one, records)
    raised = mechanism.amplification
    amplification = (
        (f"Amplification ({raised.method}): {'; '.join(map(message_text, raised.said))}.",)
        if level == 0 and raised.said
        else ()
    )
    return [
        Section(
            title, level, (Text((describe_envelope(one), *amplification)), Figure(f"{name}-envelope", caption, draw))
        )
    ]


def describe_envelope(one: EnvelopeResult) -> str:
    """Describe an envelope in a sentence or two."""
    known = [(bound, f) for bound, f in zip(one.lower_bound_g, one.frequency_hz, strict=True) if bound is not None]
    if not known:
        return f"No pulse up to {numeral(one.amplitude_g[-1], digits=3)} g overturns it at any of the frequencies."
    least, at = min(known)
    text = f"The weakest pulse that overturns it has {numeral(least, digits=3)} g, at {numeral(at, digits=3)} Hz."
    none = len(one.lower_bound_g) - len(known)
    if none:
        text += (
            f" At {none} of {len(one.lower_bound_g)} frequencies no pulse up to {numeral(one.amplitude_g[-1])} g does."
        )
    if any(one.islands):
        text += " There are safe islands: some stronger pulses do not overturn it."
    if one.case:
        text += f" The envelope is that of the controlling case, {one.case}; another case can need less."
    return text + _amplification_sentence(one)


def _amplification_sentence(one: EnvelopeResult) -> str:
    """Return how much of the ground's motion reaches the mechanism; empty where it acts as it is."""
    least, most = min(one.factor), max(one.factor)
    if least == most == 1.0:
        return ""
    if least == most:
        return f" The motion at its base is {numeral(most, digits=3)} times that of the ground."
    text = (
        f" The motion at its base is {numeral(least, digits=3)} to {numeral(most, digits=3)} times that of the ground, "
        "depending on frequency."
    )
    return text if one.shape == "sine" else f"{text} These are the factors of a full sine of the same frequency."


def mechanisms_with_envelope(results: Results) -> list[tuple[MechanismResult, EnvelopeResult]]:
    """Return the mechanisms that have an envelope, each with it."""
    return [(mechanism, mechanism.envelope) for mechanism in results.mechanisms if mechanism.envelope is not None]


def data(results: Results) -> tuple[Table, ...]:
    """Tabulate every bound at every frequency, for the spreadsheet and the CSV files."""
    mapped = mechanisms_with_envelope(results)
    if not mapped:
        return ()
    columns = (
        Column("Mechanism"),
        Column("Frequency", "Hz", "number"),
        Column("Least pulse", "g", "number"),
        Column("Polarity", kind="number"),
        Column("Uplift", "g", "number"),
        Column("Amplification", "-", "number"),
        Column("ω/p", "-", "number"),
        Column("a/(gλ)", "-", "number"),
        Column("Critical"),
    )
    critical = results.critical.mechanism if results.critical is not None else ()
    rows = tuple(
        (mechanism.name, f, bound, sign, up, factor, omega, ratio, "critical" if name == mechanism.name else "")
        for mechanism, one in mapped
        for f, bound, sign, up, factor, omega, ratio, name in zip(
            one.frequency_hz, one.lower_bound_g, one.polarity, one.uplift_g, one.factor, one.omega,
            one.lower_bound_ratio, critical, strict=True,
        )
    )  # fmt: skip
    caption = "Least pulse that overturns each mechanism at each frequency; a/(gλ) over ω/p is the dimensionless plot."
    return (Table("envelopes", caption, columns, rows),)
