"""What the engineer should know of the records and runs that a fragility comes from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, note, warning, whole_number
from assess.messages.plural import first_names
from assess.results.fragility import LARGE_SCALE
from assess.study.coarse_records import MOST_NAMES, coarse_record_messages
from assess.study.envelope_run import envelope_cases
from assess.study.fragility.question import FragilityQuestion
from assess.study.fragility.risk import epistemic_messages, hazard_messages, measure_name
from assess.study.fragility.runs import Runs
from assess.study.motions import ScaledRecord
from assess.study.rocking_case import vibrates
from assess.study.study import Study
from assess.study.study_messages import envelope_messages
from records.record import Record
from records.scaling import Scaling

FEWEST = 10
"""Records below which a dispersion is hardly known."""


def study_warnings(study: Study, records: Sequence[Record], question: FragilityQuestion) -> tuple[Message, ...]:
    """Return the messages of a study and of its records.

    Parameters
    ----------
    study : Study
        With the messages on its file.
    records : sequence of Record
        That are run.
    question : FragilityQuestion
        Measures, method and hazard.
    """
    plain = tuple(ScaledRecord(record, Scaling(1.0, 0.0)) for record in records)
    return (
        *envelope_messages(study),
        *_of_records(records),
        *_of_measures(records, study, question),
        *hazard_messages(question.measures, question.hazard),
        *epistemic_messages(question),
        *coarse_record_messages(envelope_cases(study, {}), plain),
    )


def _of_records(records: Sequence[Record]) -> Iterator[Message]:
    artificial = sum(record.artificial for record in records)
    if len(records) < FEWEST:
        yield warning("fragility-few-records", "records", number=whole_number(len(records)), least=whole_number(FEWEST))
    if artificial:
        yield warning(
            "fragility-artificial", "records", number=whole_number(artificial), all=whole_number(len(records))
        )
    unnamed = sum(not (record.artificial or record.event or record.earthquake.time) for record in records)
    if unnamed:
        yield note("fragility-no-events", "records", number=whole_number(unnamed))


def _of_measures(records: Sequence[Record], study: Study, question: FragilityQuestion) -> Iterator[Message]:
    if question.method == "stripes" and len(study.fragility.measures) > 1:
        where = "analysis.fragility.measures"
        yield warning("fragility-stripes-one-measure", where, measure=measure_name(question.measures[0]))
    for measure in question.measures:
        longest = max(measure.periods_s, default=0.0)
        short = [each.id for each in records if each.longest_period is not None and each.longest_period < longest]
        if short:
            names = first_names(short, MOST_NAMES)
            yield warning(
                "fragility-long-periods",
                "analysis.fragility.measures",
                measure=measure.key,
                period=Quantity(longest, "time", 3),
                records=names,
            )


def mechanism_notes(study: Study, mechanism: Mechanism, runs: Runs, question: FragilityQuestion) -> tuple[Message, ...]:
    """Return what should be known of the curves of a mechanism.

    Parameters
    ----------
    study : Study
        Height above the ground, and amplification.
    mechanism : Mechanism
        What rocks.
    runs : Runs
        Of all records.
    question : FragilityQuestion
        States that are asked.
    """
    return tuple(_of_mechanism(study, mechanism, runs, question))


def _of_mechanism(study: Study, mechanism: Mechanism, runs: Runs, question: FragilityQuestion) -> Iterator[Message]:
    where = f"mechanisms.{mechanism.name}"
    if not base_motion_known(study, mechanism):
        alone = study.amplified[mechanism.name].method == "none"
        yield warning("fragility-ground-motion" if alone else "fragility-scalar-motion", where)
    if vibrates(mechanism.variants.deciding) and any(state.name == "rocking" for state in question.states):
        yield note("fragility-no-threshold", where)
    large = runs.scale[runs.run & (np.nan_to_num(runs.scale) > LARGE_SCALE)]
    if large.size:
        largest = Quantity(float(large.max()), "ratio", 3)
        yield warning("fragility-hollow", where, runs=whole_number(large.size), largest=largest)


def base_motion_known(study: Study, mechanism: Mechanism) -> bool:
    """Return whether the records reach the base of a mechanism as it moves: on the ground, or through the building."""
    return not study.grounded[mechanism.name].above or study.amplified[mechanism.name].method == "modal-filter"
