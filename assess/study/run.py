"""A run of a study: from its plain data to its results, whatever the number of jobs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from assess.codes.verdict import Question, Verdict
from assess.errors import ProjectError
from assess.results import SCHEMA_VERSION, MechanismResult, Results
from assess.results.program import describe_program
from assess.results.stamp import stamp
from assess.study.case_severity import controlling_cases
from assess.study.coarse_records import coarse_record_messages
from assess.study.controls.all_controls import controls_of
from assess.study.controls.outcome import warnings_of
from assess.study.envelope_run import envelope_cases
from assess.study.envelopes import critical_result, map_envelopes
from assess.study.ground_motion import ground_motion
from assess.study.mechanism_results import comparison_rows
from assess.study.mechanisms import assess_mechanisms
from assess.study.motions import motions_of
from assess.study.primary_pulses import with_primary_pulses
from assess.study.progress import Progress, silent
from assess.study.sensitivity import sensitivities
from assess.study.site_results import record_result, spectrum_result
from assess.study.study import Study
from assess.study.study_messages import study_messages, suite_messages
from assess.study.suite_faults import suite_faults
from assess.study.survey import tolerances
from assess.study.sweep_cases import MechanismSweep
from assess.study.sweep_results import sweep_results
from assess.study.sweeps import run_sweeps
from assess.study.uncertainty import uncertainty
from assess.study.verdict import decide, mark_result
from spectra.spectrum import Spectrum


def run(study: Study, *, jobs: int = 0, progress: Progress = silent) -> Results:
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
    question = question_of(study, controlling)
    verdict = verdict_of(study, question, spectrum, mechanisms)
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
            *warnings_of(controls),
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


def require_spectrum(study: Study) -> Spectrum:
    """Return the site's spectrum; raise ProjectError if the study has none."""
    if study.spectrum is None:
        raise ProjectError("site.spectrum: missing; an analysis needs the site's spectrum: add a table [site.spectrum]")
    return study.spectrum


def question_of(study: Study, controlling: Mapping[str, MechanismSweep]) -> Question:
    """Return what decides in the controlling cases if they agree (a sweep may change the site), else in the study."""
    questions = [
        controlling[m.name].case.study.question if m.name in controlling else study.question for m in study.mechanisms
    ]
    return questions[0] if questions and all(each == questions[0] for each in questions) else study.question


def verdict_of(study: Study, question: Question, spectrum: Spectrum, mechanisms: Sequence[MechanismResult]) -> Verdict:
    """Decide on the mechanisms, with the survey's tolerance on the index of those near their threshold.

    The tolerance applies at the site of the project file only, not at that of a sweep.
    """
    asked = replace(study, question=question)
    found = decide(asked, mechanisms)
    if question != study.question:
        return found
    near = tolerances(study.survey, spectrum, question, found, mechanisms)
    return decide(asked, mechanisms, near) if near else found
