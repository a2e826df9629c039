"""The fragility of the mechanisms of a study, and with the hazard of its site their risk.

Fragility is how likely a mechanism is to rock and to overturn, given the strength of the ground motion. Exports in the
formats of other programs hold the curves of the motion of the ground; formats with one dispersion get that of the
records alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from functools import partial
from itertools import cycle
from math import hypot

import numpy as np

from assess.amplification import base_motion
from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, Term, first_names, note, warning, whole_number
from assess.results.fragility import (
    FRAGILITY_VERSION,
    LARGE_SCALE,
    FragilityCurve,
    FragilityResults,
    MechanismFragility,
    RecordRunsResult,
    StateResult,
)
from assess.results.provenance import describe_program, stamp
from assess.risk.estimates import Lognormal
from assess.risk.exports import (
    Export,
    ExportedCurve,
    ExportedState,
    LeftOut,
    MeasureUnit,
    OmissionReason,
    csv_text,
    nrml_text,
    pelicun_text,
)
from assess.short_repr import ShortRepr
from assess.study.envelopes import MOST_RECORDS_NAMED, coarse_record_messages, envelope_cases, envelope_messages
from assess.study.fragility_curves import (
    Origins,
    compare_measure,
    convert_curve,
    correct_trends,
    epistemic_messages,
    factor_between,
    fragility_curve,
    hazard_messages,
    measure_key_text,
    origins_of,
    risks,
)
from assess.study.fragility_runs import (
    Cases,
    FragilityRuns,
    Intensities,
    Rocker,
    default_measures,
    intensities,
    islands,
    measures_at_base,
    run_intensities,
    run_once,
)
from assess.study.fragility_union import NamedRuns, find_union
from assess.study.histories import rocking_oscillators, vibrates
from assess.study.level_peaks import RockingCase
from assess.study.study import FragilityQuestion, Progress, ScaledRecord, Study, no_progress
from assess.study.suites import motions_of
from assess.study.uncertainty import sobol_points, values_at_point
from assess.workers import available_cores
from records.record import Record
from records.scaling import Scaling
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class MechanismRuns(ShortRepr):
    """A mechanism with its histories.

    all_intensities : by every measure, the primary one first; at the ground, then at the base where the motion there
        differs
    """

    mechanism: Mechanism
    case: RockingCase
    rocker: Rocker
    all_intensities: tuple[Intensities, ...]
    runs: FragilityRuns


def run_fragility(study: Study, *, jobs: int = 0, progress: Progress = no_progress) -> FragilityResults:
    """Find the fragility of every mechanism of a study, and its risk where the hazard is known.

    Values are those of the project, the means of those that are uncertain; no confidence factor enters. Sweeps are
    left out. Records are taken as they are, whatever they are scaled to in histories.

    Parameters
    ----------
    study : the study; its question on fragility, or the default one
    jobs : number of threads; 0 for all cores. The results do not depend on it.
    progress : called with the stage, the number of its parts done, and their total

    Returns
    -------
    The tree that fragility.json holds.

    Raises
    ------
    ProjectError : if the study has no records and no spectrum to make artificial ones for
    """
    question = question_with_measures(study)
    progress("ground motions", 0, 1)
    records, stripe = _records_in_stripes(_unscaled_records(study, jobs=jobs), question)
    with_runs = []
    for count, mechanism in enumerate(study.mechanisms):
        progress("rocking histories", count, len(study.mechanisms))
        if mechanism.rocks and mechanism.variants.collapse is not None:
            with_runs.append(run_records(study, mechanism, records, question, stripe=stripe, jobs=jobs))
    origins = origins_of(records)
    with ThreadPoolExecutor(jobs or available_cores()) as pool:
        found = list(pool.map(lambda runs: _mechanism_fragility(study, runs, records, origins, question), with_runs))
    progress("fragility curves", len(found), len(found))
    program = describe_program()
    return FragilityResults(
        schema_version=FRAGILITY_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=_study_warnings(study, records, question),
        title=str(study.resolved["title"].value) if "title" in study.resolved else "",
        method=question.method,
        seed=question.seed,
        draws=question.draws,
        mechanisms=tuple(found),
        hazard=() if question.hazard is None else (question.hazard,),
        stamp=stamp("fragility", program, study.inputs),
        report=study.report,
        project=study.resolved,
        union=find_union(
            [NamedRuns(each.mechanism.name, each.runs, each.all_intensities) for each in with_runs],
            study.moving,
            origins.event,
            question,
        ),
    )


def question_with_measures(study: Study) -> FragilityQuestion:
    """Return the question on fragility of a study, with all measures that apply where none are named."""
    if study.fragility.measures:
        return study.fragility
    period = None if study.building is None else study.building.period
    return replace(study.fragility, measures=default_measures(period))


def run_records(
    study: Study,
    mechanism: Mechanism,
    records: Sequence[Record],
    question: FragilityQuestion,
    *,
    stripe: FloatArray | None = None,
    jobs: int,
) -> MechanismRuns:
    """Run all records on a mechanism.

    Parameters
    ----------
    study : equation and amplification of the mechanism
    mechanism : what rocks
    records : at the ground
    question : method, measures and levels
    stripe : intensity of the stripe of each record, where each stripe has records of its own
    jobs : number of threads; 0 for all cores

    Returns
    -------
    MechanismRuns
    """
    amplification = study.amplified[mechanism.name].amplification
    base = tuple(base_motion(amplification, record) for record in records)
    oscillator, *others = rocking_oscillators(mechanism, study.equations[mechanism.name])
    case = RockingCase(
        mechanism.name, oscillator, study.equations[mechanism.name], base, mechanism.rebounds, tuple(others)
    )
    cases: Cases = _sampled_cases(study, mechanism.name, records) if question.uncertain else (case,)
    rocker = Rocker(oscillator.slenderness, oscillator.p)
    above = any(at_base.record is not record for at_base, record in zip(base, records, strict=True))
    places = [(each, tuple(records)) for each in question.measures]
    places += [
        (each, tuple(at_base.record for at_base in base)) for each in measures_at_base(question.measures) if above
    ]
    units = [intensities(each, where, rocker) for each, where in places]
    all_intensities = tuple(
        Intensities(each, unit, primary=factor_between(units[0], unit) is not None)
        for (each, _), unit in zip(places, units, strict=True)
    )
    if question.method == "cloud":
        runs = run_once(cases, np.full(len(records), study.record_factor), threads=jobs)
    elif stripe is not None:
        factor = stripe / all_intensities[0].unit
        most = int(np.argmax(factor))
        if factor[most] > question.largest_factor:
            raise ProjectError(
                f'analysis.fragility.stripes: record "{records[most].id}" would be scaled by {factor[most]:.3g}, and '
                f"largest_factor is {question.largest_factor:g}; give a stronger record"
            )
        runs = run_once(cases, factor, threads=jobs, stripe=stripe)
    else:
        runs = run_intensities(cases, all_intensities[0].unit, question, threads=jobs)
    return MechanismRuns(mechanism, case, rocker, all_intensities, runs)


def _sampled_cases(study: Study, name: str, records: Sequence[Record]) -> Cases:
    """Return a mechanism with sampled values of its uncertain numbers for each record, at the base of it.

    Raises
    ------
    ProjectError : the project samples no number, or a sampled wall has no history
    """
    sampling = study.sampling
    if sampling is None:
        raise ProjectError(
            "analysis.fragility.uncertain: none is sampled; add [analysis.uncertainty], and numbers as { mean, cov }"
        )
    cases: list[RockingCase | None] = []
    for record, point in zip(records, sobol_points(sampling, len(records)), strict=True):
        values = values_at_point(sampling, point)
        sampled = sampling.study_at(values)(name)
        if sampled.falling:
            cases.append(None)
            continue
        (mechanism,) = sampled.mechanisms
        if not mechanism.rocks or mechanism.variants.collapse is None:
            numbers = ", ".join(f"{n.input.key} = {v:.4g}" for n, v in zip(sampling.numbers, values, strict=True))
            raise ProjectError(f"mechanisms.{name}: no history is answered with sampled values: {numbers}")
        oscillator, *others = rocking_oscillators(mechanism, sampled.equations[name])
        base = (base_motion(sampled.amplified[name].amplification, record),)
        rebounds = mechanism.rebounds
        cases.append(RockingCase(name, oscillator, sampled.equations[name], base, rebounds, tuple(others)))
    return cases


Write = Callable[[Sequence[ExportedCurve]], Export]

EXPORT_FORMATS: Mapping[str, Mapping[str, Write]] = {
    "nrml": {
        "fragility_continuous.xml": partial(nrml_text, format="continuous"),
        "fragility_discrete.xml": partial(nrml_text, format="discrete"),
    },
    "pelicun": {"fragility_pelicun.csv": pelicun_text},
    "csv": {"fragility_curves.csv": csv_text},
}
"""The files of each format."""
EXPORT_UNITS: Mapping[str, MeasureUnit] = {"ground acceleration": "g", "velocity": "m/s", "ratio": "-"}

LEFT_OUT_REASONS: Mapping[OmissionReason, Term] = {
    "no-name-of-measure": Term("the format has no name for this measure"),
    "state-without-curve": Term("its severest state has no curve"),
    "state-left-out": Term("a state that it has no curve for is left out of the file"),
    "curves-cross": Term("curves of two states cross, which some programs cannot use; it is in the file"),
}


def export_curves(results: FragilityResults, formats: Sequence[str]) -> tuple[dict[str, str], tuple[Message, ...]]:
    """Return the files of some formats, by name, and notes on what they leave out.

    Parameters
    ----------
    results : of `assess fragility`
    formats : of `EXPORT_FORMATS`
    """
    curves = [each for mechanism in results.mechanisms for each in _exported_curves(mechanism)]
    files = {name: write(curves) for format in formats for name, write in EXPORT_FORMATS[format].items()}
    notes = [_left_out_note(name, one) for name, file in files.items() for one in file.left_out]
    return {name: file.text for name, file in files.items()}, tuple(dict.fromkeys(notes))


def _unscaled_records(study: Study, *, jobs: int) -> tuple[Record, ...]:
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


def _records_in_stripes(
    records: Sequence[Record], question: FragilityQuestion
) -> tuple[tuple[Record, ...], FloatArray | None]:
    """Return the records with the intensity of the stripe of each; as they are, and None, without such stripes.

    Raises
    ------
    ProjectError : a pattern fits no record, or a record is in no stripe
    """
    if not question.stripes:
        return tuple(records), None
    rows: list[tuple[int, float]] = []
    for stripe in question.stripes:
        for pattern in stripe.records:
            found = [place for place, each in enumerate(records) if pattern in (each.id, each.path)]
            found = found or [
                place
                for place, each in enumerate(records)
                if any(fnmatchcase(name, pattern) for name in (each.id, each.path))
            ]
            if not found:
                raise ProjectError(f'analysis.fragility.stripes: "{pattern}" is no record; mend its name or pattern')
            rows += [(place, stripe.intensity) for place in found if (place, stripe.intensity) not in rows]
    if left := sorted(set(range(len(records))) - {place for place, _ in rows}):
        record = records[left[0]].id
        raise ProjectError(f'analysis.fragility.stripes: record "{record}" is in none; add it, or take it away')
    return tuple(records[place] for place, _ in rows), np.array([intensity for _, intensity in rows])


def _mechanism_fragility(
    study: Study,
    mechanism_runs: MechanismRuns,
    records: Sequence[Record],
    origins: Origins,
    question: FragilityQuestion,
) -> MechanismFragility:
    """Return the curves, comparison and risk of a mechanism that has been run."""
    mechanism, runs = mechanism_runs.mechanism, mechanism_runs.runs
    compared = mechanism_runs.all_intensities[:1] if question.method == "stripes" else mechanism_runs.all_intensities
    curves = [
        each
        for state in _applicable_states(mechanism_runs.case, question)
        for each in _curves_of_state(runs, compared, state, origins.event, question)
    ]
    epistemic = hypot(*question.epistemic.values()) if question.epistemic else None
    return MechanismFragility(
        name=mechanism.name,
        label=mechanism.label,
        slenderness_rad=mechanism_runs.rocker.slenderness,
        p_eq_per_s=mechanism_runs.rocker.p,
        above_ground=study.heights[mechanism.name].above,
        runs=tuple(_record_runs(mechanism_runs, place, record, origins) for place, record in enumerate(records)),
        curves=tuple(curves),
        comparison=correct_trends(
            [
                compare_measure(runs, intensities, curve, origins)
                for intensities, curve in zip(cycle(compared), curves, strict=False)
            ]
        ),
        risks=tuple(risks(curves, question, epistemic=epistemic, motion_known=_base_motion_known(study, mechanism))),
        epistemic=epistemic,
        epistemic_sources=dict(question.epistemic) or None,
        measures=tuple(intensities.measure for intensities in mechanism_runs.all_intensities),
        notes=tuple(_mechanism_notes(study, mechanism, runs, question)),
    )


def _curves_of_state(
    runs: FragilityRuns,
    all_intensities: Sequence[Intensities],
    state: StateResult,
    events: Sequence[str],
    question: FragilityQuestion,
) -> list[FragilityCurve]:
    """Return the curves of a mechanism in one state by every measure; proportional measures share theirs.

    Parameters
    ----------
    runs : of all records
    all_intensities : the measures
    state : to be reached
    events : earthquake of each record
    question : method, seed and draws
    """
    found: list[FragilityCurve] = []
    for place, one in enumerate(all_intensities):
        factors = ((at, factor_between(earlier.unit, one.unit)) for at, earlier in enumerate(all_intensities[:place]))
        same = next(((at, factor) for at, factor in factors if factor is not None), None)
        if same is None:
            found.append(fragility_curve(runs, one, state, events, question))
        else:
            found.append(convert_curve(found[same[0]], one.measure, same[1]))
    return found


def _applicable_states(case: RockingCase, question: FragilityQuestion) -> tuple[StateResult, ...]:
    """Return the requested states that a mechanism has: on joints that deform at once there is no uplift."""
    return tuple(state for state in question.states if state.name != "rocking" or not vibrates(case.oscillator))


def _record_runs(mechanism_runs: MechanismRuns, place: int, record: Record, origins: Origins) -> RecordRunsResult:
    """Return the runs of one record.

    Parameters
    ----------
    mechanism_runs : the mechanism with all runs
    place : of the record among them
    record : at the ground
    origins : the earthquake of each record
    """
    run = mechanism_runs.runs.run[place]
    scale, ratio = mechanism_runs.runs.scale[place][run], mechanism_runs.runs.ratio[place][run]
    return RecordRunsResult(
        record=record.id,
        event=origins.event[place],
        magnitude=record.earthquake.magnitude,
        distance_km=None if record.distance is None else record.distance / 1000.0,
        intensity=tuple(float(intensities.unit[place]) for intensities in mechanism_runs.all_intensities),
        scale=tuple(scale.tolist()),
        ratio=tuple(None if np.isinf(each) else each for each in ratio.tolist()),
        islands=islands(scale, np.isinf(ratio)),
    )


FEWEST_RECORDS = 10
"""Records below which a dispersion is hardly known."""


def _study_warnings(study: Study, records: Sequence[Record], question: FragilityQuestion) -> tuple[Message, ...]:
    """Return the messages of a study and of its records.

    Parameters
    ----------
    study : with the messages on its file
    records : that are run
    question : measures, method and hazard
    """
    plain = tuple(ScaledRecord(record, Scaling(1.0, 0.0)) for record in records)
    return (
        *envelope_messages(study),
        *_record_messages(records),
        *_measure_messages(records, study, question),
        *hazard_messages(question.measures, question.hazard),
        *epistemic_messages(question),
        *coarse_record_messages(envelope_cases(study, {}), plain),
    )


def _record_messages(records: Sequence[Record]) -> Iterator[Message]:
    artificial = sum(record.artificial for record in records)
    if len(records) < FEWEST_RECORDS:
        yield warning(
            "fragility-few-records", "records", number=whole_number(len(records)), least=whole_number(FEWEST_RECORDS)
        )
    if artificial:
        yield warning(
            "fragility-artificial", "records", number=whole_number(artificial), all=whole_number(len(records))
        )
    unnamed = sum(not (record.artificial or record.event or record.earthquake.time) for record in records)
    if unnamed:
        yield note("fragility-no-events", "records", number=whole_number(unnamed))


def _measure_messages(records: Sequence[Record], study: Study, question: FragilityQuestion) -> Iterator[Message]:
    if question.method == "stripes" and len(study.fragility.measures) > 1:
        where = "analysis.fragility.measures"
        yield warning("fragility-stripes-one-measure", where, measure=measure_key_text(question.measures[0]))
    for measure in question.measures:
        longest = max(measure.periods_s, default=0.0)
        short = [each.id for each in records if each.longest_period is not None and each.longest_period < longest]
        if short:
            names = first_names(short, MOST_RECORDS_NAMED)
            yield warning(
                "fragility-long-periods",
                "analysis.fragility.measures",
                measure=measure.key,
                period=Quantity(longest, "time", 3),
                records=names,
            )


def _mechanism_notes(
    study: Study, mechanism: Mechanism, runs: FragilityRuns, question: FragilityQuestion
) -> Iterator[Message]:
    """Yield what should be known of the curves of a mechanism.

    Parameters
    ----------
    study : height above the ground, and amplification
    mechanism : what rocks
    runs : of all records
    question : states that are requested
    """
    where = f"mechanisms.{mechanism.name}"
    if not _base_motion_known(study, mechanism):
        unamplified = study.amplified[mechanism.name].method == "none"
        yield warning("fragility-ground-motion" if unamplified else "fragility-scalar-motion", where)
    if vibrates(mechanism.variants.deciding) and any(state.name == "rocking" for state in question.states):
        yield note("fragility-no-threshold", where)
    if question.uncertain and study.sampling is not None:
        own = [each.input.key for each in study.sampling.numbers if mechanism.name in each.mechanisms]
        if keys := ", ".join(key for key in own if not key.startswith("site.")):  # the motion is what curves are over
            yield note("fragility-uncertain", where, keys=keys)
    large = runs.scale[runs.run & (np.nan_to_num(runs.scale) > LARGE_SCALE)]
    if large.size:
        largest = Quantity(float(large.max()), "ratio", 3)
        yield warning("fragility-hollow", where, runs=whole_number(large.size), largest=largest)


def _base_motion_known(study: Study, mechanism: Mechanism) -> bool:
    """Return whether the records reach the base of a mechanism as it moves: on the ground, or through the building."""
    return not study.heights[mechanism.name].above or study.amplified[mechanism.name].method == "modal-filter"


def _left_out_note(file: str, one: LeftOut) -> Message:
    """Return the note on what a file leaves out."""
    why = LEFT_OUT_REASONS[one.reason]
    if one.state:
        return note("fragility-state-left-out", file, mechanism=one.name, measure=one.measure, state=one.state, why=why)
    return note("fragility-left-out", file, mechanism=one.name, measure=one.measure, why=why)


def _exported_curves(mechanism: MechanismFragility) -> list[ExportedCurve]:
    """Return the curves of a mechanism by each measure of the motion of the ground, the mildest state first."""
    exported = []
    for measure in (each for each in mechanism.measures if each.at == "ground"):
        curves = sorted((each for each in mechanism.curves if each.measure == measure), key=_state_severity)
        if curves:
            period = measure.periods_s[0] if measure.key == "sa" else None
            states = tuple(map(_exported_state, curves))
            exported.append(ExportedCurve(mechanism.name, measure.key, period, EXPORT_UNITS[measure.dimension], states))
    return exported


def _state_severity(curve: FragilityCurve) -> float:
    return {"rocking": 0.0, "overturning": 1.0}.get(curve.state.name, curve.state.share or 0.0)


def _exported_state(curve: FragilityCurve) -> ExportedState:
    share, fitted = curve.state.share, curve.lognormal
    points = curve.empirical
    return ExportedState(
        name=curve.state.name if share is None else f"{curve.state.name}-{share:g}",
        lognormal=None if fitted is None else Lognormal(fitted.median, fitted.dispersion),
        intensity=np.array([each.intensity for each in points]),
        records=np.array([each.records for each in points], dtype=np.int64),
        reached=np.array([each.reached for each in points], dtype=np.int64),
        low=np.array([each.low for each in points]),
        high=np.array([each.high for each in points]),
    )
