"""How the answers of each mechanism change with numbers that are not well known, each varied alone.

A case is the mechanism alone with one number at its low or its high value. It goes through the procedures that decide,
at all levels, with its histories under all records as they are, but without the scan over rising PGA: procedures by
histories have no PGA at capacity and no numerical spread here. What is compared is demand over capacity, which is that
of the records as they are in a run, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assess.codes.check import Check
from assess.codes.families import uses_histories
from assess.errors import AssessError
from assess.results import MechanismResult, SensitivityResult
from assess.study.checks import checks_of
from assess.study.context import context_of
from assess.study.histories import run_levels
from assess.study.mechanisms import further_levels, rocking_case
from assess.study.motions import ScaledRecord
from assess.study.progress import Progress
from assess.study.rocking_case import RockingHistories
from assess.study.sensitivity_rows import CaseAnswers, by_answer, rows_of, unvaried_row
from assess.study.study import Study, Unvaried, Variable
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum


def sensitivities(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanisms: Sequence[MechanismResult],
    *,
    jobs: int,
    progress: Progress,
) -> tuple[SensitivityResult, ...]:
    """Assess every variable of the study at its low and its high value.

    Parameters
    ----------
    study : Study
        The study, with its variables.
    spectrum : Spectrum
        The site's elastic spectrum.
    motions : tuple of ScaledRecord
        The suite of records.
    mechanisms : sequence of MechanismResult
        The mechanisms as assessed with the base values.
    jobs : int
        Number of threads; 0 for all cores.
    progress : Progress
        Called as variables are done.

    Returns
    -------
    tuple of SensitivityResult
        The rows of each variable, in the order of the study.
    """
    assessed = {mechanism.name: mechanism for mechanism in mechanisms}
    rows: list[SensitivityResult] = []
    for done, variable in enumerate(study.variables):
        progress("sensitivity", done, len(study.variables))
        if isinstance(variable, Unvaried):
            rows.append(unvaried_row(variable))
            continue
        deciding = tuple(
            check for check in assessed[variable.mechanism].checks if check.reading == "letter" and not check.informs
        )
        procedures = tuple(dict.fromkeys(check.procedure for check in deciding))
        low, high = (
            case_of(variable, value, study, procedures, spectrum, motions, jobs=jobs)
            for value in (variable.low, variable.high)
        )
        rows += rows_of(variable, deciding, low, high, basis=study.question.basis)
    return tuple(rows)


def case_of(
    variable: Variable,
    value: float,
    whole: Study,
    procedures: tuple[str, ...],
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    *,
    jobs: int,
) -> CaseAnswers:
    """Assess the mechanism with one value of the variable, by the procedures, under the suite of the whole study."""
    try:
        study = replace(variable.study_at(value), procedures=procedures, suite_faults=whole.suite_faults)
        return CaseAnswers(by_answer(check_case(study, spectrum, motions, jobs=jobs)))
    except (AssessError, SpectrumError) as error:
        return CaseAnswers({}, str(error))


def check_case(study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], *, jobs: int) -> tuple[Check, ...]:
    """Return the checks of a study of one mechanism, without the scan over rising PGA.

    Parameters
    ----------
    study : Study
        A study of one mechanism.
    spectrum : Spectrum
        The site's elastic spectrum.
    motions : tuple of ScaledRecord
        The suite of records; run only where a procedure by histories is among those of the study.
    jobs : int
        Number of threads; 0 for all cores.

    Returns
    -------
    tuple of Check
        In the order of the procedures.
    """
    (mechanism,) = study.mechanisms
    case = rocking_case(study, mechanism, motions)
    levels = study.levels if any(map(uses_histories, study.procedures)) else ()
    rocked = RockingHistories((), ())
    if levels and motions:
        further = further_levels(study, spectrum, mechanism)
        rocked = run_levels(
            case,
            motions,
            levels=levels,
            besides=further,
            site_pga=spectrum.pga,
            threads=jobs,
            with_twins=False,
        )
    context = context_of(replace(study, levels=levels), spectrum, mechanism, rocked, case.base, motions)
    return checks_of(study, case.oscillator, replace(context, levels=study.levels))
