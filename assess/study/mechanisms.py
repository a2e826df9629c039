"""The mechanisms of a study through every procedure, with their time histories."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from math import isclose

from assess.amplification.floor_motion import BaseMotion, base_motion
from assess.codes.families import uses_histories
from assess.codes.italian.confidence import confidence_factors
from assess.codes.italian.history import required_pga
from assess.codes.registry import history_rules
from assess.mechanisms.mechanism import Mechanism
from assess.results import MechanismResult
from assess.study.amplification_results import amplification_result
from assess.study.checks import checks_of
from assess.study.context import context_of
from assess.study.histories import run_histories, with_governing_trace
from assess.study.mechanism_results import mechanism_result
from assess.study.motions import ScaledRecord
from assess.study.progress import Progress
from assess.study.rocking_case import RockingCase, RockingHistories, vibrates
from assess.study.study import Amplified, Study
from assess.workers import available_cores
from spectra.spectrum import Spectrum


def assess_mechanisms(
    study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismResult, ...]:
    """Assess every mechanism of a study.

    Each thread takes a mechanism, the longest work first; if there are fewer mechanisms than threads, several threads
    share the histories of each. So the procedures of one, which hold the interpreter's lock, run beside the histories
    of another, which do not.

    Parameters
    ----------
    study : Study
        The study.
    spectrum : Spectrum
        The site's elastic spectrum, to which the motions are scaled.
    motions : tuple of ScaledRecord
        The suite of records.
    jobs : int
        Number of threads; 0 for all cores.
    progress : Progress
        Called as mechanisms are done.

    Returns
    -------
    tuple of MechanismResult
        In the order of the study.
    """
    cases = {m.name: rocking_case(study, m, motions) for m in study.mechanisms}
    workers = jobs or available_cores()
    threads = max(1, workers // max(1, len(cases)))

    def assess(mechanism: Mechanism) -> MechanismResult:
        case = cases[mechanism.name]
        rocked = mechanism_histories(study, spectrum, motions, mechanism, case, threads=threads)
        return assess_mechanism(study, spectrum, motions, mechanism, case, rocked)

    longest = sorted(study.mechanisms, key=lambda m: not vibrates(cases[m.name].oscillator))
    done: dict[str, MechanismResult] = {}
    progress("rocking histories", 0, len(longest))
    with ThreadPoolExecutor(workers) as pool:
        for found in pool.map(assess, longest):
            done[found.name] = found
            progress("rocking histories", len(done), len(longest))
    return tuple(done[m.name] for m in study.mechanisms)


def mechanism_histories(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanism: Mechanism,
    case: RockingCase,
    *,
    threads: int,
) -> RockingHistories:
    """Run the time histories of a mechanism at all levels of the study, with the scan where a procedure uses it."""
    return run_histories(
        case,
        motions,
        levels=study.levels,
        besides=further_levels(study, spectrum, mechanism),
        site_pga=spectrum.pga,
        with_scan=study.scan and any(map(uses_histories, study.procedures)),
        threads=threads,
    )


def rocking_case(study: Study, mechanism: Mechanism, motions: tuple[ScaledRecord, ...]) -> RockingCase:
    """Return what the histories of a mechanism are run for."""
    base, name = motions_at_base(study.amplified[mechanism.name], motions), mechanism.name
    return RockingCase(name, mechanism.variants.deciding, study.equations[name], base, mechanism.rebounds)


def further_levels(study: Study, spectrum: Spectrum, mechanism: Mechanism) -> tuple[float, ...]:
    """Return the PGA [m/s2] of suites needed besides the levels of the study: limit states of their own, FC."""
    wanted = rule_levels(study, spectrum, mechanism)
    return tuple(pga for pga in wanted if not any(isclose(pga, level, rel_tol=1e-9) for level in study.levels))


def rule_levels(study: Study, spectrum: Spectrum, mechanism: Mechanism) -> tuple[float, ...]:
    """Return the PGA [m/s2] at which procedures with a rule of their own need suites, each once."""
    wanted: list[float] = []
    known = study.knowledge.get(mechanism.name, {})
    for name, (rule, options) in history_rules(study.options).items():
        if name in study.procedures:
            level = known.get(rule.edition.code)
            factors = [each.factor for each in confidence_factors(options, crushing=mechanism.crushing, level=level)]
            wanted += required_pga(study.levels, study.hazard, spectrum, rule=rule, options=options, factors=factors)
    return tuple(dict.fromkeys(wanted))


def motions_at_base(amplified: Amplified, motions: tuple[ScaledRecord, ...]) -> tuple[BaseMotion, ...]:
    """Return every motion as it acts at the base of a mechanism."""
    return tuple(base_motion(amplified.amplification, motion.record) for motion in motions)


def assess_mechanism(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanism: Mechanism,
    case: RockingCase,
    rocked: RockingHistories,
) -> MechanismResult:
    """Return one mechanism with the checks of every procedure and its histories."""
    context = context_of(study, spectrum, mechanism, rocked, case.base, motions)
    return mechanism_result(
        mechanism,
        mechanism.variants.starting,
        equation=case.equation,
        scene=study.scenes.get(mechanism.name),
        checks=checks_of(study, case.oscillator, context),
        histories=() if context.not_lasting else with_governing_trace(case, rocked.histories, motions),
        amplification=amplification_result(study.amplified[mechanism.name], motions, case.base),
        grounded=study.grounded[mechanism.name],
    )
