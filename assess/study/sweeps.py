"""The sweeps of a study: every mechanism that a sweep changes, assessed in all its cases."""

from __future__ import annotations

from dataclasses import replace

from assess.errors import locate_errors
from assess.study.case_severity import controlling_index
from assess.study.mechanisms import assess_mechanisms
from assess.study.motions import ScaledRecord, motions_of
from assess.study.progress import Progress, silent
from assess.study.study import Case, Study
from assess.study.suite_faults import suite_faults
from assess.study.sweep_cases import CaseResult, MechanismSweep
from assess.study.verdict import decide, mark_result


def run_sweeps(
    study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismSweep, ...]:
    """Assess every mechanism that a sweep changes in all its cases, one sweep after the other."""
    total = sum(len(sweep.cases) for sweep in study.sweeps)
    found: list[MechanismSweep] = []
    done = 0
    for sweep in study.sweeps:
        cases = []
        for case in sweep.cases:
            progress("cases of sweeps", done, total)
            with locate_errors(case.name):
                cases.append(assess_case(case, study, motions, jobs=jobs))
            done += 1
        each = zip(*cases, strict=True)  # mechanism by mechanism
        found += [MechanismSweep(sweep, judged, controlling_index(judged)) for judged in each]
    return tuple(found)


def assess_case(case: Case, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int) -> tuple[CaseResult, ...]:
    """Assess the mechanisms of one case, under the motions of the study unless the case changes them."""
    spectrum = case.study.spectrum
    assert spectrum is not None  # no number takes the site away
    moving = motions_of_case(case, study, motions, jobs=jobs)
    faults = study.suite_faults if moving is motions else suite_faults(case.study, spectrum, moving)
    judged = replace(case.study, suite_faults=faults)
    done = assess_mechanisms(judged, spectrum, moving, jobs=jobs, progress=silent)
    found = decide(judged, done)
    each = zip(done, found.mechanisms, strict=True)
    return tuple(CaseResult(mark_result(found, judged.question, result), one) for result, one in each)


def motions_of_case(
    case: Case, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int
) -> tuple[ScaledRecord, ...]:
    """Return the motions of the study itself, or those of a case that changes them or the site."""
    of = case.study
    assert of.spectrum is not None  # no number takes the site away
    same = all(getattr(of, key) == getattr(study, key) for key in ("artificial", "scale_to", "record_factor"))
    if same and of.spectrum is study.spectrum and of.records is study.records:
        return motions
    return motions_of(of, of.spectrum, jobs=jobs)
