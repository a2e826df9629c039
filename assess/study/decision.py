"""The verdict of a study alone, for whoever needs no more of it than the answer: one of ten thousand walls.

Only what decides is computed: the procedures that the basis of the verdict may ask, and the ground motions only where
one of these or the base of a mechanism depends on them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from assess.codes.check import Check, Family
from assess.codes.families import FAMILIES, uses_histories
from assess.codes.registry import history_rules
from assess.codes.verdict import Verdict, methods_of
from assess.mechanisms.mechanism import Mechanism
from assess.study.checks import checks_of
from assess.study.context import context_of
from assess.study.histories import run_levels
from assess.study.mechanisms import mechanism_histories, rocking_case, rule_levels
from assess.study.motions import ScaledRecord, motions_of
from assess.study.rocking_case import RockingCase, RockingHistories
from assess.study.run import require_spectrum, run
from assess.study.study import Study
from assess.study.suite_faults import suite_faults
from assess.study.verdict import decide
from spectra.spectrum import Spectrum

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
        found = run(study, jobs=jobs).verdict
        assert found is not None
        return found
    spectrum = require_spectrum(study)
    methods = methods_of(study.question)
    study = replace(study, procedures=tuple(name for name in study.procedures if name in methods))
    motions: tuple[ScaledRecord, ...] = ()
    if _needs_motions(study):
        motions = motions_of(study, spectrum, jobs=jobs)
        study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    checked = [_checked(study, spectrum, motions, each, jobs=jobs) for each in study.mechanisms]
    return decide(study, checked)


def _needs_motions(study: Study) -> bool:
    """Return whether an answer of a study depends on its ground motions."""
    above = any(study.amplified[each.name].height is not None for each in study.mechanisms)
    return above or any(FAMILIES[name] in OF_MOTION for name in study.procedures)


def _checked(
    study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], mechanism: Mechanism, *, jobs: int
) -> CheckedMechanism:
    """Return the checks of a mechanism, with time histories where one of them asks for these."""
    case = rocking_case(study, mechanism, motions)
    rocked = _histories(study, spectrum, motions, mechanism, case, jobs=jobs)
    context = context_of(study, spectrum, mechanism, rocked, case.base, motions)
    return CheckedMechanism(mechanism.name, checks_of(study, case.oscillator, context))


def _histories(
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
