"""Annex B: the time histories of each mechanism, the motion at its base, and studies over one of its values."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from assess.messages.message import Message
from assess.results import HistoryResult, MechanismResult, Results, SuiteResult
from reports import governing
from reports.chapters import sweep_tables
from reports.chapters.cells import LEVEL, OVERTURNED, rocking_cell
from reports.document import Block, Cell, Column, Figure, Prose, Section, Table, nonempty
from reports.figures import amplification, history
from reports.language.texts import Paragraph, Term, Text, Verbatim, count, quantity, say, say_count
from reports.titles import file_stem, mechanism_number, mechanism_title

MARK = "B"


def sections(results: Results) -> list[Section]:
    """Return the annex: a part for each mechanism that has histories or studies; none where no mechanism has."""
    parts = [_part(results, each, place) for place, each in enumerate(results.mechanisms, start=1)]
    shown = [part for part in parts if part.blocks]
    if not shown:
        return []
    introduction = say(
        "Each record is run in both polarities and the worse counts. A single rocking history is not predictable: a "
        "small change of the motion or the geometry can turn a large rotation into collapse or into rest. Judge by "
        "the suite, not by one history."
    )
    return [Section(say("Time histories"), 0, (Prose((introduction,)),), starts_page=True, mark=MARK), *shown]


def _part(results: Results, mechanism: MechanismResult, place: int) -> Section:
    stem = file_stem(mechanism.name, place)
    blocks: list[Block] = [
        *_amplification(mechanism, stem),
        *nonempty(suites(mechanism, name=f"{stem}-suites")),
        *_governing(mechanism, stem),
        *_responses(mechanism, stem),
        *sweep_tables.blocks(results, mechanism, stem),
    ]
    return Section(
        Verbatim(mechanism_title(mechanism)), 1, tuple(blocks), mark=mechanism_number(results, mechanism.name)
    )


def _amplification(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return how the motion reaches a mechanism above the ground, where the histories amplify it."""
    found = mechanism.amplification
    if found.height_m is None:
        return []
    blocks: list[Block] = [Prose((Paragraph((*_sentences(found.said), *_factors(mechanism))),))]
    if found.motion is not None:
        caption = say(
            "{record}, scaled to the site’s spectrum, at the ground and at the base of the mechanism: acceleration "
            "over time and response spectra of 5 % damping. Of all records its peak is amplified most.",
            record=Verbatim(found.motion.record),
        )
        blocks.append(Figure(f"{stem}-amplification", caption, partial(amplification.draw, found.motion)))
    return blocks


def _sentences(said: tuple[Message | Term | str, ...]) -> list[Text]:
    texts = (Term(each) if isinstance(each, str) else each for each in said)
    return [say("Motion at its base: {text}.", text=each) for each in texts]


def _factors(mechanism: MechanismResult) -> list[Text]:
    """Return by how much the records are amplified."""
    factors = [one.factor for one in mechanism.amplification.factors]
    if not factors:
        return []
    if len(set(factors)) == 1:
        factor = quantity(factors[0], figures=3)
        return [say("The peak acceleration there is {factor} times that of the ground.", factor=factor)]
    return [
        say(
            "Peak accelerations there are {least} to {most} times those of the ground.",
            least=quantity(min(factors), figures=3),
            most=quantity(max(factors), figures=3),
        )
    ]


def suites(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the statistics of the suite of records at each level."""
    columns = (
        LEVEL,
        Column(say("Records")),
        Column(say("Overturned")),
        Column(say("Mean φ/φₒᵥ"), "ratio"),
        Column(say("Median"), "ratio"),
        Column(say("84 % of records"), "ratio"),
        Column(say("Largest without overturning"), "ratio"),
    )
    caption = say(
        "The suite of records at each level. Half of the records do not exceed the median, and 84 % do not exceed the "
        "next column; a record that overturns counts as the largest."
    )
    return Table(name, caption, columns, tuple(_statistics(suite) for suite in mechanism.suites), small=True)


def _statistics(suite: SuiteResult) -> tuple[Cell, ...]:
    ratios = (suite.mean_ratio, suite.median_ratio, suite.p84_ratio)
    fell = tuple(OVERTURNED if ratio is None and suite.overturned else ratio for ratio in ratios)
    return (suite.level_pga_g, suite.n, suite.overturned, *fell, suite.max_ratio)


def _governing(mechanism: MechanismResult, stem: str) -> list[Figure]:
    """Return the figure of the governing history."""
    found = governing.history(mechanism)
    if found is None or not _moves(found[0]):
        return []
    one, trace = found
    caption = say(
        "The governing history: {record}, polarity {polarity}, at PGA {pga}; {end}; {impacts}. Above the acceleration, "
        "below the rotation.",
        record=Verbatim(one.record),
        polarity=Verbatim(f"{one.polarity:+d}".replace("-", "−")),
        pga=quantity(one.level_pga_g, "ground acceleration"),
        end=_end(one),
        impacts=say_count("{number} impact", "{number} impacts", one.impacts),
    )
    draw = partial(history.draw, mechanism, one, trace, governing.allowable(mechanism, one.level_pga_g))
    return [Figure(f"{stem}-history", caption, draw)]


def _end(one: HistoryResult) -> Text:
    if one.overturned:
        return say("it overturns")
    return say("largest φ/φₒᵥ {ratio}", ratio=quantity(abs(one.max_rotation_ratio or 0.0)))


def _moves(history: HistoryResult) -> bool:
    return history.overturned or history.max_rotation_rad != 0.0


def _responses(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return the largest responses to the records that move a mechanism, and how many do not."""
    moving = [history for history in mechanism.histories if _moves(history)]
    still = len(mechanism.histories) - len(moving)
    blocks: list[Block] = []
    if moving:
        blocks.append(histories(replace(mechanism, histories=tuple(moving)), name=f"{stem}-responses"))
    if still:
        blocks.append(
            Prose(
                (
                    say_count(
                        "{number} history of {all} does not move the mechanism.",
                        "{number} histories of {all} do not move the mechanism.",
                        still,
                        all=count(len(mechanism.histories)),
                    ),
                )
            )
        )
    return blocks


def histories(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the largest response to each record at each level."""
    columns = (
        Column(say("Record"), share=0.2),
        LEVEL,
        Column(say("Polarity")),
        Column(say("Scale factor"), "ratio"),
        Column(say("Amplification"), "ratio"),
        Column(say("Largest φ"), "rotation"),
        Column(say("Largest φ/φₒᵥ"), "ratio"),
        Column(say("At"), "time"),
        Column(say("Impacts")),
        Column(say("Overturns at"), "time"),
    )
    caption = say("The largest response to each record, in the worse polarity.")
    return Table(name, caption, columns, tuple(map(_history, mechanism.histories)), small=True)


def _history(history: HistoryResult) -> tuple[Cell, ...]:
    fell = history.overturned
    rotation = OVERTURNED if fell else rocking_cell(history.max_rotation_rad)
    ratio = OVERTURNED if fell else rocking_cell(history.max_rotation_ratio)
    scaling = (history.scale_factor, history.amplification)
    times = (history.time_of_max_s, history.impacts, history.overturning_time_s)
    return (Verbatim(history.record), history.level_pga_g, history.polarity, *scaling, rotation, ratio, *times)
