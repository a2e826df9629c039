"""Annex B: the time histories of each mechanism, the motion at its base, and studies over one of its values."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from math import radians

from assess.codes.histories import FIGURES, standing_figures
from assess.codes.verdict import Decision
from assess.messages.message import Message, Quantity
from assess.results import HistoryResult, MechanismResult, Results, SuiteResult, SweepResult
from reports import governing
from reports.chapters.cells import (
    CONFIDENCE_FACTOR,
    LEVEL,
    OUTCOMES,
    OVERTURNED,
    rocking_cell,
    standing_cell,
    swept_value,
    uplift_cell,
)
from reports.document import Block, Cell, Column, Field, Figure, OutcomeCell, Prose, Section, Table, nonempty, tabulate
from reports.figures import rocking, sensitivity
from reports.language.texts import Paragraph, Term, Text, Verbatim, count, quantity, say, say_count
from reports.mechanisms import file_stem, mechanism_number, mechanism_title

MARK = "B"


def sections(results: Results) -> list[Section]:
    """Return the annex: a part for each mechanism that has histories or studies; none where no mechanism has."""
    parts = [_histories_section(results, each, place) for place, each in enumerate(results.mechanisms, start=1)]
    shown = [part for part in parts if part.blocks]
    if not shown:
        return []
    introduction = say(
        "Each record is run in both polarities and the worse counts. A single rocking history is not predictable: a "
        "small change of the motion or the geometry can turn a large rotation into collapse or into rest. Judge by "
        "the suite, not by one history."
    )
    blocks = (Prose((introduction, *_numerical_spread(results))),)
    return [Section(say("Time histories"), 0, blocks, starts_page=True, mark=MARK), *shown]


SUITE_FIELDS: tuple[Field[SuiteResult], ...] = (
    (LEVEL, lambda suite: suite.level_pga_g),
    (Column(say("Records")), lambda suite: suite.n),
    (Column(say("Overturned")), lambda suite: suite.overturned),
    (Column(say("Mean φ/φₒᵥ"), "ratio"), lambda suite: _statistic_cell(suite, suite.mean_ratio)),
    (Column(say("Median"), "ratio"), lambda suite: _statistic_cell(suite, suite.median_ratio)),
    (Column(say("84 % of records"), "ratio"), lambda suite: _statistic_cell(suite, suite.p84_ratio)),
    (
        Column(say("Largest without overturning"), "ratio"),
        lambda suite: standing_cell(suite.max_ratio, suite.figures, 4),
    ),
)


def suites_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the statistics of the suite of records at each level."""
    caption = say(
        "The suite of records at each level. Half of the records do not exceed the median, and 84 % do not exceed the "
        "next column; a record that overturns counts as the largest."
    )
    if any(step.symbol == CONFIDENCE_FACTOR and step.value != 1.0 for each in mechanism.checks for step in each.steps):
        factored = say(
            "Codes with a confidence factor FC run the records at FC times these levels, where more of them overturn: "
            "their sheets count those."
        )
        return tabulate(name, Paragraph((caption, factored)), SUITE_FIELDS, mechanism.suites, small=True)
    return tabulate(name, caption, SUITE_FIELDS, mechanism.suites, small=True)


def _figures_of(history: HistoryResult) -> int:
    """Return to how many figures, one at least, the largest rotation of a history stands in its nine runs."""
    if history.max_rotation_ratio is None or not history.twin_ratios:
        return FIGURES
    return max(1, standing_figures(history.max_rotation_ratio, history.twin_ratios))


def _impacts(history: HistoryResult) -> int | None:
    """Return the number of impacts; None where the nine runs do not agree on it."""
    return history.impacts if len(set(history.twin_impacts)) < 2 else None


HISTORY_FIELDS: tuple[Field[HistoryResult], ...] = (
    (Column(say("Record"), share=0.2), lambda history: Verbatim(history.record)),
    (LEVEL, lambda history: history.level_pga_g),
    (Column(say("Polarity")), lambda history: history.polarity),
    (Column(say("Scale factor"), "ratio"), lambda history: history.scale_factor),
    (Column(say("Amplification"), "ratio"), lambda history: history.amplification),
    (
        Column(say("Largest φ"), "rotation"),
        lambda history: _maximum_cell(history, history.max_rotation_rad, "rotation"),
    ),
    (
        Column(say("Largest φ/φₒᵥ"), "ratio"),
        lambda history: _maximum_cell(history, history.max_rotation_ratio, "ratio"),
    ),
    (Column(say("At"), "time"), lambda history: _time_cell(history, history.time_of_max_s)),
    (Column(say("Impacts")), lambda history: _impacts(history)),
    (Column(say("Overturns in")), lambda history: _overturning_cell(history)),
)


def histories_table(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the largest response to each record at each level."""
    caption = say(
        "The largest response to each record, in the worse polarity, to the digits that stand in its runs. The last "
        "column says in how many of them the mechanism overturns, or when it does if in all."
    )
    return tabulate(name, caption, HISTORY_FIELDS, mechanism.histories, small=True)


def _numerical_spread(results: Results) -> list[Text]:
    """Return what the runs of each record are for, and what they are not; nothing where records were run alone."""
    if not any(history.twin_ratios for mechanism in results.mechanisms for history in mechanism.histories):
        return []
    return [
        say(
            "So each record is run nine times, as it is and with its PGA times 1 ± 10⁻ᵘ, u = 3, 4, 5, 6: less than "
            "any instrument resolves. How far the nine runs differ is the numerical spread. Maxima are printed to the "
            "digits that stand in all nine, at least one; the number of impacts only where all nine agree. An "
            "answer passes only if the rule holds in 84 % of random draws of one run for each record. The scatter "
            "from record to record is something else: it belongs to the suite, and the median and the 84 % column "
            "show it."
        )
    ]


def _histories_section(results: Results, mechanism: MechanismResult, place: int) -> Section:
    stem = file_stem(mechanism.name, place)
    blocks: list[Block] = [
        *_amplification(mechanism, stem),
        *nonempty(suites_table(mechanism, name=f"{stem}-suites")),
        *_governing_figure(mechanism, stem),
        *_responses(mechanism, stem),
        *_sweep_blocks(results, mechanism, stem),
    ]
    return Section(
        Verbatim(mechanism_title(mechanism)), 1, tuple(blocks), mark=mechanism_number(results, mechanism.name)
    )


def _amplification(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return how the motion reaches a mechanism above the ground, where the histories amplify it."""
    found = mechanism.amplification
    if found.height_m is None:
        return []
    blocks: list[Block] = [Prose((Paragraph((*_motion_sentences(found.said), *_factors(mechanism))),))]
    if found.motion is not None:
        caption = say(
            "{record}, scaled to the site’s spectrum, at the ground and at the base of the mechanism: acceleration "
            "over time and response spectra of 5 % damping. Of all records its peak is amplified most.",
            record=Verbatim(found.motion.record),
        )
        blocks.append(Figure(f"{stem}-amplification", caption, partial(rocking.draw_amplification, found.motion)))
    return blocks


def _motion_sentences(messages: tuple[Message | Term | str, ...]) -> list[Text]:
    texts = (Term(each) if isinstance(each, str) else each for each in messages)
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


def _statistic_cell(suite: SuiteResult, ratio: float | None) -> Cell:
    if ratio is None and suite.overturned:
        return OVERTURNED
    return standing_cell(ratio, suite.figures, 4)


def _governing_figure(mechanism: MechanismResult, stem: str) -> list[Figure]:
    """Return the figure of the governing history."""
    found = governing.governing_history(mechanism)
    if found is None or not _moves(found[0]):
        return []
    one, trace = found
    history_of, pga = Verbatim(one.record), quantity(one.level_pga_g, "ground acceleration")
    polarity = Verbatim(f"{one.polarity:+d}".replace("-", "−"))
    if _impacts(one) is None:
        caption = say(
            "The governing history: {record}, polarity {polarity}, at PGA {pga}; {end}. Above the acceleration, below "
            "the rotation.",
            record=history_of,
            polarity=polarity,
            pga=pga,
            end=_end(one),
        )
    else:
        caption = say(
            "The governing history: {record}, polarity {polarity}, at PGA {pga}; {end}; {impacts}. Above the "
            "acceleration, below the rotation.",
            record=history_of,
            polarity=polarity,
            pga=pga,
            end=_end(one),
            impacts=say_count("{number} impact", "{number} impacts", one.impacts),
        )
    draw = partial(
        rocking.draw_history, mechanism, one, trace, governing.allowable_rotation(mechanism, one.level_pga_g)
    )
    return [Figure(f"{stem}-history", caption, draw)]


def _end(one: HistoryResult) -> Text:
    if one.overturned:
        return say("it overturns")
    return say("largest φ/φₒᵥ {ratio}", ratio=quantity(abs(one.max_rotation_ratio or 0.0), figures=_figures_of(one)))


def _moves(history: HistoryResult) -> bool:
    return history.overturned or history.max_rotation_rad != 0.0


def _responses(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return the largest responses to the records that move a mechanism, and how many do not."""
    moved = [history for history in mechanism.histories if _moves(history)]
    not_moved = len(mechanism.histories) - len(moved)
    moving = replace(mechanism, histories=tuple(moved))
    blocks: list[Block] = [histories_table(moving, name=f"{stem}-responses")] if moved else []
    if not_moved:
        words = say_count(
            "{number} history of {all} does not move the mechanism.",
            "{number} histories of {all} do not move the mechanism.",
            not_moved,
            all=count(len(mechanism.histories)),
        )
        blocks.append(Prose((words,)))
    return blocks


def _maximum_cell(history: HistoryResult, value: float | None, dimension: str) -> Cell:
    """Return the maximum of a history to the figures that stand; words where the body overturns or does not rock."""
    if history.overturned:
        return OVERTURNED
    figures = _figures_of(history)
    return rocking_cell(value) if not value or figures >= FIGURES else Quantity(value, dimension, figures)


def _time_cell(history: HistoryResult, value: float | None) -> Cell:
    """Return the time of the maximum to the figures that stand; None where not even one does."""
    if value is None or not history.twin_times_s:
        return value
    figures = standing_figures(value, history.twin_times_s)
    return None if figures == 0 else value if figures >= FIGURES else Quantity(value, "time", figures)


def _overturning_cell(history: HistoryResult) -> Cell:
    """Return in how many of its runs a history overturns; the time where all do."""
    fallen, runs = sum(1 for each in history.twin_ratios if each is None), len(history.twin_ratios)
    if fallen == runs:
        end = history.overturning_time_s
        return None if end is None else quantity(end, "time", max(1, FIGURES - 1))
    return say("{fallen} of {runs} runs", fallen=count(fallen), runs=count(runs)) if fallen else None


CONTROLLING_CASE = say(
    "The controlling case has the worst deciding answer: failing cases rank before incomplete ones, and those before "
    "passing ones; among equals the case with the smallest margin over the site’s own action controls, then the one "
    "with the largest demand over capacity."
)
REPRESENTS = say("This case represents the mechanism in the rest of this report.")
REPRESENTED = say("In the rest of this report the mechanism is represented by a case of another study.")
AS_TYPED = say("In the rest of this report the mechanism is as the project file has it: no case is more critical.")


def _sweep_blocks(results: Results, mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return the weakest direction, where it was sought, and every sweep of a mechanism."""
    made: list[Block] = [*_weakest_direction(mechanism, stem)]
    own = [each for each in results.sweeps if each.mechanism == mechanism.name]
    made += [Prose((CONTROLLING_CASE,))] if own else []
    otherwise = REPRESENTED if any(each.governs for each in own) else AS_TYPED
    for place, each in enumerate(own, start=1):
        name = f"{stem}-sweep-{place:02d}"
        caption = say(
            "Results over {key}; the ring marks the controlling case; a case that overturns has no ratio.",
            key=Verbatim(each.key),
        )
        made += [
            Prose((_sweep_sentence(each, otherwise=otherwise),)),
            _sweep_table(each, name=name),
            Figure(name, caption, partial(sensitivity.draw_sweep, each)),
        ]
    return made


def _sweep_sentence(found: SweepResult, *, otherwise: Text) -> Text:
    """State what was swept, which case controls, and whether it represents the mechanism; otherwise : what does."""
    taken = say_count(
        "{key} takes {number} value;", "{key} takes {number} values;", len(found.value), key=Verbatim(found.key)
    )
    case = swept_value(found.value[found.controlling], found.unit)
    controls = say("{case} controls.", case=case)
    return Paragraph((taken, controls, REPRESENTS if found.governs else otherwise))


def _sweep_table(found: SweepResult, *, name: str) -> Table:
    """Tabulate a sweep, a line for each value in the user's order."""
    on_joints: tuple[Field[int], ...] = (
        (Column(say("φₒᵥ on joints"), "rotation"), lambda place: found.overturning_flexible_rad[place]),
        (Column(say("Elastic frequency"), "frequency"), lambda place: found.elastic_frequency_hz[place]),
    )
    has_joints = any(value is not None for value in found.overturning_flexible_rad)
    fields: tuple[Field[int], ...] = (
        (Column(say("Value")), lambda place: swept_value(found.value[place], found.unit)),
        (Column(Verbatim("p"), "angular frequency"), lambda place: found.p_eq_per_s[place]),
        (Column(say("λ at uplift"), "ratio"), lambda place: uplift_cell(found.uplift_multiplier[place])),
        (Column(Verbatim("φₒᵥ"), "rotation"), lambda place: found.overturning_rad[place]),
        *(on_joints if has_joints else ()),
        (Column(say("Restitution η"), "ratio"), lambda place: found.restitution[place]),
        (
            Column(say("Demand / capacity"), "ratio"),
            lambda place: OVERTURNED if found.overturned[place] else found.demand_capacity[place],
        ),
        (Column(say("PGA at capacity"), "ground acceleration"), lambda place: found.capacity_pga_g[place]),
        (Column(say("Verdict")), lambda place: _decision_cell(found.outcome[place])),
        (Column(say("Case")), lambda place: say("controls") if place == found.controlling else None),
    )
    caption = say(
        "{key}: rocking parameters of the branch that uplifts first, and the answer that decides; where none does, the "
        "worst of all checks of a code at all levels.",
        key=Verbatim(found.key),
    )
    return tabulate(name, caption, fields, range(len(found.value)), small=True)


def _decision_cell(decision: Decision) -> OutcomeCell:
    return OutcomeCell(decision.value, OUTCOMES[decision.value])


def _weakest_direction(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return sentence and figure on the weakest direction, where it was searched for."""
    found = mechanism.direction_sweep
    if found is None:
        return []
    caption = say(
        "Load multiplier λ that starts rotation towards each horizontal direction; the dot marks the weakest."
    )
    said = say(
        "The direction is the weakest of {number}: {angle} from +x towards +y. The load multiplier is within 1 % of "
        "its minimum over {flat} of the circle; the minimum is {variation} below the maximum.",
        number=quantity(len(found.angle_deg), figures=9),
        angle=quantity(radians(found.weakest_deg), "angle", 4),
        flat=quantity(radians(found.flat_deg), "angle", 3),
        variation=quantity(100.0 * found.variation, "percent", 3),
    )
    return [Prose((said,)), Figure(f"{stem}-directions", caption, partial(sensitivity.draw_directions, found))]
