"""From a study to its results: a pure function of the study, whatever the number of jobs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from assess.amplification.floor_motion import pulse_factor
from assess.codes.verdict import Question
from assess.errors import ProjectError, locate_errors
from assess.messages.message import Message, note, warning
from assess.results import SCHEMA_VERSION, MechanismResult, Results
from assess.results.stamp import stamp, this_program
from assess.study.envelopes import DEFAULT_GRID, EnvelopeCase, critical_result, map_envelopes
from assess.study.ground_motion import ground_motion
from assess.study.mechanisms import assess_mechanisms
from assess.study.motions import ScaledRecord, motions_of
from assess.study.outcome import amplification_result, comparison_rows, mechanism_result, record_result, spectrum_result
from assess.study.primary_pulses import with_primary_pulses
from assess.study.progress import Progress, silent
from assess.study.sampling import coarse_record_messages
from assess.study.sensitivity import sensitivities
from assess.study.study import Study
from assess.study.suite_faults import suite_faults
from assess.study.survey import tolerances
from assess.study.sweeps import MechanismSweep, case_messages, case_text, controlling_cases, run_sweeps, sweep_results
from assess.study.verdict import by_motion, decide, mark_result
from spectra.spectrum import Spectrum


def run(study: Study, *, jobs: int = 0, progress: Progress = silent) -> Results:
    """The results of `study`; `jobs` threads, 0 for all cores. `progress` is told (stage, done, total).

    The controlling case of a mechanism that is swept stands for it.
    """
    spectrum = require_spectrum(study)
    progress("ground motions", 0, 1)
    motions = motions_of(study, spectrum, jobs=jobs)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    sweeps = run_sweeps(study, motions, jobs=jobs, progress=progress)
    standing = controlling_cases(sweeps)
    alone = replace(study, mechanisms=tuple(m for m in study.mechanisms if m.name not in standing))
    own = {one.name: one for one in assess_mechanisms(alone, spectrum, motions, jobs=jobs, progress=progress)}
    mechanisms = tuple(own.get(m.name) or standing[m.name].worst for m in study.mechanisms)
    asked = replace(study, question=question_of(study, standing))
    found = decide(asked, mechanisms)
    at_home = asked.question == study.question  # the survey's tolerance is worked out at the site of the file
    near = tolerances(study.survey, spectrum, asked.question, found, mechanisms) if at_home else {}
    found = decide(asked, mechanisms, near) if near else found
    mechanisms = tuple(mark_result(found, asked.question, each) for each in mechanisms)
    rockers = envelope_cases(study, standing)
    mapped = map_envelopes(rockers, study.pulses, jobs=jobs, progress=progress)
    numbers = dict(study.fitting.nga)
    records = tuple(record_result(motion, spectrum, nga=numbers.get(motion.record.id)) for motion in motions)
    program = this_program()
    return Results(
        schema_version=SCHEMA_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=(
            *study_messages(study, standing),
            *suite_messages(study, motions),
            *coarse_record_messages(rockers, motions),
        ),
        project=study.resolved,
        spectrum=spectrum_result(spectrum),
        records=with_primary_pulses(records, motions, study.pulses),
        mechanisms=tuple(replace(each, envelope=mapped.get(each.name)) for each in mechanisms),
        critical=critical_result(mapped),
        comparison=comparison_rows(mechanisms),
        sweeps=sweep_results(sweeps, standing),
        verdict=found,
        ground_motion=ground_motion(study, spectrum, motions),
        sensitivity=sensitivities(study, spectrum, motions, mechanisms, jobs=jobs, progress=progress),
        stamp=stamp("run", program, study.inputs),
    )


def question_of(study: Study, standing: Mapping[str, MechanismSweep]) -> Question:
    """What decides: of the case that stands for every mechanism, where a sweep changes the site, else of the study."""
    questions = [
        standing[m.name].case.study.question if m.name in standing else study.question for m in study.mechanisms
    ]
    return questions[0] if questions and all(each == questions[0] for each in questions) else study.question


def envelope(study: Study, *, jobs: int = 0, progress: Progress = silent) -> Results:
    """The overturning envelopes of `study` alone, on its pulses or the default ones; no spectrum or record is needed.

    Mechanisms stand as the project has them, without the cases of its sweeps.
    """
    grid = study.pulses or DEFAULT_GRID
    rockers = envelope_cases(study, {})
    mapped = map_envelopes(rockers, grid, jobs=jobs, progress=progress)
    progress("primary pulses", 0, 1)
    motions = () if study.spectrum is None else motions_of(replace(study, artificial=None), study.spectrum)
    records = () if study.spectrum is None else tuple(record_result(motion, study.spectrum) for motion in motions)
    program = this_program()
    return Results(
        schema_version=SCHEMA_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=envelope_messages(study),
        project=study.resolved,
        spectrum=None if study.spectrum is None else spectrum_result(study.spectrum),
        records=with_primary_pulses(records, motions, grid),
        mechanisms=tuple(replace(each, envelope=mapped.get(each.name)) for each in parameters(study)),
        critical=critical_result(mapped),
        comparison=(),
        sweeps=(),
        stamp=stamp("envelope", program, study.inputs),
    )


def _case_of(swept: MechanismSweep) -> str:
    return case_text(swept.sweep, swept.case, swept.mechanism)


def envelope_messages(study: Study) -> tuple[Message, ...]:
    """What the engineer should know of envelopes: no procedure of a code is asked."""
    kept = tuple(notice for notice in study.notices if notice.key != "confidence-factor")
    if not study.sweeps:
        return kept
    keys = ", ".join(sweep.key for sweep in study.sweeps)
    return (*kept, warning("sweep-left-out", "analysis.sweep", keys=keys))


def envelope_cases(study: Study, standing: Mapping[str, MechanismSweep]) -> tuple[EnvelopeCase, ...]:
    """Every mechanism as envelopes see it, but for those that fall without what is not shown to last.

    A swept one in its controlling case.
    """
    found = []
    for mechanism in study.mechanisms:
        swept = standing.get(mechanism.name)
        of, case = (study, "") if swept is None else (swept.case.study, _case_of(swept))
        used = next(each for each in of.mechanisms if each.name == mechanism.name)
        rocker = used.variants.collapse
        if rocker is None:
            continue
        factor = partial(pulse_factor, of.amplified[used.name].amplification)
        found.append(EnvelopeCase(used.name, rocker, of.equations[used.name], factor, case))
    return tuple(found)


def parameters(study: Study) -> tuple[MechanismResult, ...]:
    """Every mechanism with its rocking parameters and capacity curve; no analysis."""
    return tuple(
        mechanism_result(
            mechanism,
            mechanism.variants.starting,
            equation=study.equations[mechanism.name],
            scene=study.scenes.get(mechanism.name),
            amplification=amplification_result(study.amplified[mechanism.name]),
            grounded=study.grounded[mechanism.name],
        )
        for mechanism in study.mechanisms
    )


def case_parameters(study: Study) -> tuple[MechanismResult, ...]:
    """The same for every case of every sweep, named with the case."""
    found = []
    for sweep in study.sweeps:
        for case in sweep.cases:
            with locate_errors(case.name):
                each = parameters(case.study)
            found += [replace(one, name=f"{one.name}, {case_text(sweep, case, one.name)}") for one in each]
    return tuple(found)


def require_spectrum(study: Study) -> Spectrum:
    """The site's spectrum, or the one line that asks for it."""
    if study.spectrum is None:
        raise ProjectError("site.spectrum: missing; an analysis needs the site's spectrum: add a table [site.spectrum]")
    return study.spectrum


def study_messages(study: Study, standing: Mapping[str, MechanismSweep]) -> tuple[Message, ...]:
    """The notices of the study, where what a swept mechanism says of itself is what its controlling case says."""
    replaced = {("mechanism", f"mechanisms.{name}") for name in standing}
    kept = [notice for notice in study.notices if (notice.key, notice.where) not in replaced]
    return (*kept, *(notice for swept in standing.values() for notice in case_messages(swept)))


def suite_messages(study: Study, motions: tuple[ScaledRecord, ...]) -> tuple[Message, ...]:
    """What the engineer should know of the records; a note where no method by the ground's motion decides."""
    if not any(motion.record.artificial for motion in motions):
        return ()
    return ((warning if by_motion(study.question) else note)("artificial-records", "records"),)
