"""A run of a study: from its plain data to its results, or to the verdict alone.

The results do not depend on the number of jobs. They hold automatic controls of every mechanism (NTC 2018, 10.2.1:
controls that the report lists). For the verdict alone, as of one of ten thousand walls, only what decides is computed:
the procedures that the basis of the verdict may ask, and the ground motions only where one of these or the base of a
mechanism depends on them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

from assess.codes.check import Check, Family
from assess.codes.procedures import FAMILIES, history_rules, uses_histories
from assess.codes.question import Question, methods_of
from assess.codes.verdict import Verdict
from assess.dynamics.packing import Equation
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, first_names, locate, message, note, warning
from assess.oscillator import Oscillator, elastic_frequency
from assess.results import SCHEMA_VERSION, Control, MechanismResult, Results
from assess.results.inputs import describe_program, stamp
from assess.short_repr import ShortRepr
from assess.study.checks import assess_mechanisms, checks_of, decide, mark_result
from assess.study.context import context_of
from assess.study.controls import control_warnings, equilibrium_controls, multiplier_control
from assess.study.envelopes import EnvelopeCase, critical_result, envelope_cases, map_envelopes
from assess.study.ground_motion import ground_motion, record_result, spectrum_result, with_primary_pulses
from assess.study.histories import (
    RockingCase,
    RockingHistories,
    mechanism_histories,
    rocking_case,
    rule_levels,
    run_levels,
)
from assess.study.history_controls import convergence_control, energy_control, governing_history
from assess.study.mechanism_results import comparison_rows
from assess.study.record_set import motions_of
from assess.study.sensitivity import sensitivities, survey_tolerances
from assess.study.study import (
    Progress,
    ScaledRecord,
    Study,
    may_follow_motion,
    report_nothing,
    require_spectrum,
)
from assess.study.suite_rules import suite_faults
from assess.study.sweeps import (
    MechanismSweep,
    case_messages,
    controlling_cases,
    motions_of_case,
    run_sweeps,
    sweep_results,
)
from assess.study.uncertainty import uncertainty
from assess.workers import available_cores
from spectra.spectrum import Spectrum


def run_study(study: Study, *, jobs: int = 0, progress: Progress = report_nothing) -> Results:
    """Assess a study.

    Each mechanism that sweeps change is represented by its controlling case.

    Parameters
    ----------
    study : Study
        Site, records, mechanisms and questions.
    jobs : int
        Number of threads; 0 for all cores. The results do not depend on it.
    progress : Progress
        Called with the stage, the number of its parts done, and their total.

    Returns
    -------
    Results
        The tree that results.json holds.

    Raises
    ------
    ProjectError
        If the study has no spectrum.
    AssessError
        If a record, mechanism or procedure cannot be evaluated.
    """
    spectrum = require_spectrum(study)
    progress("ground motions", 0, 1)
    motions = motions_of(study, spectrum, jobs=jobs)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    sweeps = run_sweeps(study, motions, jobs=jobs, progress=progress)
    controlling = controlling_cases(sweeps)
    unswept = replace(study, mechanisms=tuple(m for m in study.mechanisms if m.name not in controlling))
    own = {one.name: one for one in assess_mechanisms(unswept, spectrum, motions, jobs=jobs, progress=progress)}
    mechanisms = tuple(own.get(m.name) or controlling[m.name].worst for m in study.mechanisms)
    question = deciding_question(study, controlling)
    verdict = decide_with_tolerance(study, question, spectrum, mechanisms)
    mechanisms = tuple(mark_result(verdict, question, each) for each in mechanisms)
    cases = envelope_cases(study, controlling)
    envelopes = map_envelopes(cases, study.pulses, jobs=jobs, progress=progress)
    numbers = dict(study.fitting.nga)
    records = tuple(record_result(motion, spectrum, nga=numbers.get(motion.record.id)) for motion in motions)
    controls = controls_of(study, controlling, motions, mechanisms, jobs=jobs)
    program = describe_program()
    return Results(
        schema_version=SCHEMA_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=(
            *study_messages(study, controlling),
            *suite_messages(study, motions),
            *coarse_record_messages(cases, motions),
            *control_warnings(controls),
        ),
        project=study.resolved,
        spectrum=spectrum_result(spectrum),
        records=with_primary_pulses(records, motions, study.pulses),
        mechanisms=tuple(replace(each, envelope=envelopes.get(each.name)) for each in mechanisms),
        critical=critical_result(envelopes),
        comparison=comparison_rows(mechanisms),
        sweeps=sweep_results(sweeps, controlling),
        verdict=verdict,
        ground_motion=ground_motion(study, spectrum, motions),
        sensitivity=sensitivities(study, spectrum, motions, mechanisms, jobs=jobs, progress=progress),
        stamp=stamp("run", program, study.inputs),
        controls=controls,
        report=study.report,
        verification=study.annex,
        uncertainty=uncertainty(study, spectrum, motions, mechanisms, jobs=jobs, progress=progress),
    )


def deciding_question(study: Study, controlling: Mapping[str, MechanismSweep]) -> Question:
    """Return what decides in the controlling cases if they agree (a sweep may change the site), else in the study."""
    questions = [
        controlling[m.name].case.study.question if m.name in controlling else study.question for m in study.mechanisms
    ]
    return questions[0] if questions and all(each == questions[0] for each in questions) else study.question


def decide_with_tolerance(
    study: Study, question: Question, spectrum: Spectrum, mechanisms: Sequence[MechanismResult]
) -> Verdict:
    """Decide on the mechanisms, with the survey's tolerance on the index of those near their threshold.

    The tolerance applies at the site of the project file only, not at that of a sweep.
    """
    asked = replace(study, question=question)
    found = decide(asked, mechanisms)
    if question != study.question:
        return found
    near = survey_tolerances(study.survey, spectrum, question, found, mechanisms)
    return decide(asked, mechanisms, near) if near else found


OF_MOTION = (Family.HISTORY, Family.ENERGY)
NO_HISTORIES = RockingHistories((), ())


@dataclass(frozen=True)
class CheckedMechanism:
    """A mechanism by its name, with its checks."""

    name: str
    checks: tuple[Check, ...]


def find_verdict(study: Study, *, jobs: int = 1) -> Verdict:
    """Return the verdict of a study as `run` finds it.

    What is at the limit is told by the usual 5 % alone: the tolerance of the survey, which changes no outcome, is not
    tried. A study with sweeps is run whole, since its controlling cases decide.

    Parameters
    ----------
    study : Study
        Site, records, mechanisms and questions.
    jobs : int
        Number of threads; 0 for all cores.

    Raises
    ------
    ProjectError
        If the study has no spectrum.
    AssessError
        If a record, mechanism or procedure cannot be evaluated.
    """
    if study.sweeps:
        found = run_study(study, jobs=jobs).verdict
        assert found is not None
        return found
    spectrum = require_spectrum(study)
    methods = methods_of(study.question)
    study = replace(study, procedures=tuple(name for name in study.procedures if name in methods))
    motions: tuple[ScaledRecord, ...] = ()
    if _needs_motions(study):
        motions = motions_of(study, spectrum, jobs=jobs)
        study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    checked = [_check_what_decides(study, spectrum, motions, each, jobs=jobs) for each in study.mechanisms]
    return decide(study, checked)


def _needs_motions(study: Study) -> bool:
    """Return whether an answer of a study depends on its ground motions."""
    above = any(study.amplified[each.name].height is not None for each in study.mechanisms)
    return above or any(FAMILIES[name] in OF_MOTION for name in study.procedures)


def _check_what_decides(
    study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], mechanism: Mechanism, *, jobs: int
) -> CheckedMechanism:
    """Return the checks of a mechanism, with time histories where one of them asks for these."""
    case = rocking_case(study, mechanism, motions)
    rocked = _histories_that_decide(study, spectrum, motions, mechanism, case, jobs=jobs)
    context = context_of(study, spectrum, mechanism, rocked, case.base, motions)
    return CheckedMechanism(mechanism.name, checks_of(study, case.oscillator, context))


def _histories_that_decide(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanism: Mechanism,
    case: RockingCase,
    *,
    jobs: int,
) -> RockingHistories:
    """Run the time histories that decide; without a scan only those at the PGA that the rules of procedures ask for."""
    asking = set(filter(uses_histories, study.procedures))
    if not asking:
        return NO_HISTORIES
    if study.scan or not asking <= set(history_rules(study.options)):
        return mechanism_histories(study, spectrum, motions, mechanism, case, threads=jobs)
    wanted = rule_levels(study, spectrum, mechanism)
    return run_levels(case, motions, levels=(), besides=wanted, site_pga=spectrum.pga, threads=jobs)


@dataclass(frozen=True, repr=False)
class AssessedMechanism(ShortRepr):
    """One mechanism with the study that it was assessed in, the motions of that study, and what was found."""

    mechanism: Mechanism
    study: Study
    motions: tuple[ScaledRecord, ...]
    result: MechanismResult


def controls_of(
    study: Study,
    controlling: Mapping[str, MechanismSweep],
    motions: tuple[ScaledRecord, ...],
    results: Sequence[MechanismResult],
    *,
    jobs: int,
) -> tuple[Control, ...]:
    """Make every control of every mechanism, swept ones in their controlling case.

    Parameters
    ----------
    study : Study
        The study.
    controlling : mapping
        The sweep that represents each swept mechanism, by name.
    motions : tuple of ScaledRecord
        The motions of the study.
    results : sequence of MechanismResult
        What was found of its mechanisms.
    jobs : int
        Number of threads; 0 for all cores. The controls do not depend on it.

    Returns
    -------
    tuple of Control
        In the order of the mechanisms, of each in the order of equilibrium, energy, multiplier, convergence.
    """
    found = {each.name: each for each in results}
    cases = [
        _as_assessed(study, controlling.get(each.name), motions, found[each.name], jobs=jobs)
        for each in study.mechanisms
    ]
    with ThreadPoolExecutor(jobs or available_cores()) as pool:
        return tuple(control for made in pool.map(mechanism_controls, cases) for control in made)


def mechanism_controls(case: AssessedMechanism) -> tuple[Control, ...]:
    """Make every control of one mechanism."""
    mechanism, study = case.mechanism, case.study
    equation = study.equations[mechanism.name]
    assert study.spectrum is not None  # histories were scaled to it
    governing = governing_history(
        mechanism,
        case.result.histories,
        {motion.record.id: motion for motion in case.motions},
        study.amplified[mechanism.name],
        equation=equation,
        site_pga=study.spectrum.pga,
    )
    return (
        *equilibrium_controls(mechanism, mechanism.oscillator),
        energy_control(mechanism, governing, equation=equation),
        multiplier_control(mechanism, mechanism.oscillator),
        convergence_control(mechanism, governing),
    )


def _as_assessed(
    study: Study,
    sweep: MechanismSweep | None,
    motions: tuple[ScaledRecord, ...],
    result: MechanismResult,
    *,
    jobs: int,
) -> AssessedMechanism:
    """Return a mechanism as it was assessed: in the study, or in the controlling case of its sweep."""
    of = study if sweep is None else sweep.case.study
    moving = motions if sweep is None else motions_of_case(sweep.case, study, motions, jobs=jobs)
    return AssessedMechanism(next(each for each in of.mechanisms if each.name == result.name), of, moving, result)


def study_messages(study: Study, controlling: Mapping[str, MechanismSweep]) -> tuple[Message, ...]:
    """Return the messages of the study; those on a swept mechanism itself are of its controlling case."""
    swept = [mechanism for mechanism in study.mechanisms if mechanism.name in controlling]
    replaced = [each for one in swept for each in locate(one.warnings, f"mechanisms.{one.name}")]
    kept = [message for message in study.messages if message not in replaced]
    return (*kept, *(message for sweep in controlling.values() for message in case_messages(sweep)))


def suite_messages(study: Study, motions: tuple[ScaledRecord, ...]) -> tuple[Message, ...]:
    """Return the messages on artificial records; a note only if no method that follows the ground's motion decides."""
    if not any(motion.record.artificial for motion in motions):
        return ()
    return ((warning if may_follow_motion(study.question) else note)("artificial-records", "records"),)


FEWEST_ELASTIC = 6.0
"""Samples in a period of the elastic vibration about rest."""

FEWEST_ROCKING = 10.0
"""Samples within 1 / p, in which a rocking rotation grows e-fold."""

MOST_RECORDS_NAMED = 3
"""Records that a message names."""


def coarse_record_messages(cases: Sequence[EnvelopeCase], motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    """Yield a warning for each mechanism for which some record is too coarse."""
    for case in cases:
        longest, why = longest_step(case.oscillator, equation=case.equation)
        coarse = [motion.record for motion in motions if motion.record.dt > longest]
        if coarse:
            names = first_names([f"{record.id} ({record.dt:.4g} s)" for record in coarse], MOST_RECORDS_NAMED)
            yield warning(
                "coarse-record",
                f"mechanisms.{case.name}",
                records=names,
                motion=why,
                longest=Quantity(longest, "time", 3),
            )


def longest_step(oscillator: Oscillator, *, equation: Equation) -> tuple[float, Message]:
    """Return the longest step of a record for an oscillator [s], and the motion that requires it.

    The linearised equation has no vibration about rest.
    """
    p = max(branch.linearised.p for branch in oscillator.branches)
    elastic = max((elastic_frequency(branch) or 0.0) for branch in oscillator.branches)
    if equation == "exact" and FEWEST_ELASTIC * elastic > FEWEST_ROCKING * p:
        return 1.0 / (FEWEST_ELASTIC * elastic), message(
            "motion-elastic", {"frequency": Quantity(elastic, "frequency", 3)}
        )
    return 1.0 / (FEWEST_ROCKING * p), message("motion-rocking", {"p": Quantity(p, "angular frequency", 3)})
