"""The fragility of the mechanisms of a study, and with the hazard of its site their risk."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import cycle
from math import hypot

import numpy as np

from assess.amplification.floor_motion import base_motion
from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.results.fragility import (
    FRAGILITY_VERSION,
    FragilityCurve,
    FragilityResults,
    MechanismFragility,
    RecordRuns,
    StateResult,
)
from assess.results.program import describe_program
from assess.results.stamp import stamp
from assess.short_repr import ShortRepr
from assess.study.fragility.comparison import Origins, compare, origins_of
from assess.study.fragility.curves import Intensities, fragility_curve
from assess.study.fragility.measures import Rocker, at_base, default_measures, intensities
from assess.study.fragility.messages import base_motion_known, mechanism_notes, study_warnings
from assess.study.fragility.proportional import convert, factor_between
from assess.study.fragility.question import FragilityQuestion
from assess.study.fragility.risk import risks
from assess.study.fragility.runs import Runs, run_levels, run_once
from assess.study.fragility.states import islands
from assess.study.motions import motions_of
from assess.study.progress import Progress, silent
from assess.study.rocking_case import RockingCase, vibrates
from assess.study.study import Study
from assess.workers import available_cores
from records.record import Record


@dataclass(frozen=True, repr=False)
class Shaken(ShortRepr):
    """A mechanism with its histories.

    by : every measure, the primary one first; at the ground, then at the base where the motion there differs
    """

    mechanism: Mechanism
    case: RockingCase
    rocker: Rocker
    by: tuple[Intensities, ...]
    runs: Runs


def run_fragility(study: Study, *, jobs: int = 0, progress: Progress = silent) -> FragilityResults:
    """Find the fragility of every mechanism of a study, and its risk where the hazard is known.

    Values are those of the project, the means of those that are uncertain; no confidence factor enters. Sweeps are
    left out. Records are taken as they are, whatever they are scaled to in histories.

    Parameters
    ----------
    study : Study
        The study; its question on fragility, or the default one.
    jobs : int
        Number of threads; 0 for all cores. The results do not depend on it.
    progress : Progress
        Called with the stage, the number of its parts done, and their total.

    Returns
    -------
    FragilityResults
        The tree that fragility.json holds.

    Raises
    ------
    ProjectError
        If the study has no records and no spectrum to make artificial ones for.
    """
    question = question_of(study)
    progress("ground motions", 0, 1)
    records = records_of(study, jobs=jobs)
    shaken = []
    for count, mechanism in enumerate(study.mechanisms):
        progress("rocking histories", count, len(study.mechanisms))
        if mechanism.variants.collapse is not None:
            shaken.append(shake(study, mechanism, records, question, jobs=jobs))
    origins = origins_of(records)
    with ThreadPoolExecutor(jobs or available_cores()) as pool:
        found = list(pool.map(lambda one: mechanism_fragility(study, one, records, origins, question), shaken))
    progress("fragility curves", len(found), len(found))
    program = describe_program()
    return FragilityResults(
        schema_version=FRAGILITY_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=study_warnings(study, records, question),
        title=str(study.resolved["title"].value) if "title" in study.resolved else "",
        method=question.method,
        seed=question.seed,
        draws=question.draws,
        mechanisms=tuple(found),
        hazard=() if question.hazard is None else (question.hazard,),
        stamp=stamp("fragility", program, study.inputs),
        report=study.report,
        project=study.resolved,
    )


def question_of(study: Study) -> FragilityQuestion:
    """Return what is asked of a study, with all measures that apply where none are named."""
    if study.fragility.measures:
        return study.fragility
    period = None if study.building is None else study.building.period
    return replace(study.fragility, measures=default_measures(period))


def records_of(study: Study, *, jobs: int) -> tuple[Record, ...]:
    """Return the records of a study as they are, artificial ones last."""
    if study.artificial is None:
        records: tuple[Record, ...] = study.records
    elif study.spectrum is None:
        raise ProjectError("records: none, and no [site.spectrum] to make artificial ones for; give files")
    else:
        records = tuple(motion.record for motion in motions_of(study, study.spectrum, jobs=jobs))
    if not records:
        raise ProjectError("records: none; give files of recorded motions")
    return records


def shake(
    study: Study, mechanism: Mechanism, records: Sequence[Record], question: FragilityQuestion, *, jobs: int
) -> Shaken:
    """Run all records on a mechanism.

    Parameters
    ----------
    study : Study
        Equation and amplification of the mechanism.
    mechanism : Mechanism
        What rocks.
    records : sequence of Record
        At the ground.
    question : FragilityQuestion
        Method, measures and levels.
    jobs : int
        Number of threads; 0 for all cores.

    Returns
    -------
    Shaken
    """
    amplification = study.amplified[mechanism.name].amplification
    base = tuple(base_motion(amplification, record) for record in records)
    oscillator = mechanism.variants.deciding
    case = RockingCase(mechanism.name, oscillator, study.equations[mechanism.name], base, mechanism.rebounds)
    rocker = Rocker(oscillator.slenderness, oscillator.p)
    above = any(one.record is not record for one, record in zip(base, records, strict=True))
    places = [(each, tuple(records)) for each in question.measures]
    places += [(each, tuple(one.record for one in base)) for each in at_base(question.measures) if above]
    units = [intensities(each, where, rocker) for each, where in places]
    by = tuple(
        Intensities(each, unit, primary=factor_between(units[0], unit) is not None)
        for (each, _), unit in zip(places, units, strict=True)
    )
    if question.method == "cloud":
        runs = run_once(case, study.record_factor, threads=jobs)
    else:
        runs = run_levels(case, by[0].unit, question, threads=jobs)
    return Shaken(mechanism, case, rocker, by, runs)


def mechanism_fragility(
    study: Study, shaken: Shaken, records: Sequence[Record], origins: Origins, question: FragilityQuestion
) -> MechanismFragility:
    """Return the curves, comparison and risk of a mechanism that has been run."""
    mechanism, runs = shaken.mechanism, shaken.runs
    by = shaken.by[:1] if question.method == "stripes" else shaken.by
    curves = [
        each
        for state in states_of(shaken.case, question)
        for each in curves_of_state(runs, by, state, origins.event, question)
    ]
    epistemic = hypot(*question.epistemic.values()) if question.epistemic else None
    return MechanismFragility(
        name=mechanism.name,
        label=mechanism.label,
        slenderness_rad=shaken.rocker.slenderness,
        p_eq_per_s=shaken.rocker.p,
        above_ground=study.grounded[mechanism.name].above,
        runs=tuple(record_runs(shaken, place, record, origins) for place, record in enumerate(records)),
        curves=tuple(curves),
        comparison=tuple(compare(runs, one, curve, origins) for one, curve in zip(cycle(by), curves, strict=False)),
        risks=tuple(risks(curves, question, epistemic=epistemic, motion_known=base_motion_known(study, mechanism))),
        epistemic=epistemic,
        epistemic_sources=dict(question.epistemic) or None,
        measures=tuple(one.measure for one in shaken.by),
        notes=mechanism_notes(study, mechanism, runs, question),
    )


def curves_of_state(
    runs: Runs, by: Sequence[Intensities], state: StateResult, events: Sequence[str], question: FragilityQuestion
) -> list[FragilityCurve]:
    """Return the curves of a mechanism in one state by every measure; proportional measures share theirs.

    Parameters
    ----------
    runs : Runs
        Of all records.
    by : sequence of Intensities
        The measures.
    state : StateResult
        To be reached.
    events : sequence of str
        Earthquake of each record.
    question : FragilityQuestion
        Method, seed and draws.
    """
    found: list[FragilityCurve] = []
    for place, one in enumerate(by):
        factors = ((at, factor_between(known.unit, one.unit)) for at, known in enumerate(by[:place]))
        same = next(((at, factor) for at, factor in factors if factor is not None), None)
        if same is None:
            found.append(fragility_curve(runs, one, state, events, question))
        else:
            found.append(convert(found[same[0]], one.measure, same[1]))
    return found


def states_of(case: RockingCase, question: FragilityQuestion) -> tuple[StateResult, ...]:
    """Return the states asked that a mechanism has: on joints that deform at once there is no uplift."""
    return tuple(state for state in question.states if state.name != "rocking" or not vibrates(case.oscillator))


def record_runs(shaken: Shaken, place: int, record: Record, origins: Origins) -> RecordRuns:
    """Return the runs of one record.

    Parameters
    ----------
    shaken : Shaken
        The mechanism with all runs.
    place : int
        Of the record among them.
    record : Record
        At the ground.
    origins : Origins
        The earthquake of each record.
    """
    run = shaken.runs.run[place]
    scale, ratio = shaken.runs.scale[place][run], shaken.runs.ratio[place][run]
    return RecordRuns(
        record=record.id,
        event=origins.event[place],
        magnitude=record.earthquake.magnitude,
        distance_km=None if record.distance is None else record.distance / 1000.0,
        intensity=tuple(float(one.unit[place]) for one in shaken.by),
        scale=tuple(scale.tolist()),
        ratio=tuple(None if np.isinf(each) else each for each in ratio.tolist()),
        islands=islands(scale, np.isinf(ratio)),
    )
