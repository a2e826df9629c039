"""The checks of mechanisms by the procedures of codes, and the verdict on them.

Mechanisms are those of a study, or one alone on one spectrum as a Python session has it, by the same rules.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from math import isfinite
from typing import Protocol

import numpy as np
from scipy.constants import g

from assess.amplification import Unamplified
from assess.codes.check import Check, Outcome
from assess.codes.context import Building, Context
from assess.codes.histories import SuiteResponse
from assess.codes.italian_limit_states import FACTORS_BY_LEVEL
from assess.codes.procedures import KNOWLEDGE_CODES, PROCEDURES, CodeOptions, apply_procedure, procedure, uses_histories
from assess.codes.question import Action, MechanismChecks, Question
from assess.codes.verdict import Verdict, mark_deciding, verdict
from assess.errors import ProcedureError
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Oscillator
from assess.results import MechanismResult
from assess.study.amplification import GroundLevel, HeightAboveGround, MechanismAmplification, find_height
from assess.study.context import context_of
from assess.study.histories import (
    RockingCase,
    RockingHistories,
    check_record,
    further_levels,
    mechanism_histories,
    rocking_case,
    run_levels,
    vibrates,
    with_governing_trace,
)
from assess.study.mechanism_results import amplification_result, mechanism_result
from assess.study.record_set import motions_of
from assess.study.study import Fitting, Progress, ScaledRecord, Study
from assess.study.suite_rules import suite_faults
from assess.workers import available_cores
from records.errors import RecordError
from records.record import Record, is_vertical
from records.scaling import SCALING_PERIODS, Band
from spectra.arrays import is_number
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


def checks_of(study: Study, oscillator: Oscillator, context: Context) -> tuple[Check, ...]:
    """Return the checks of every procedure of the study, in its order.

    Checks of procedures that were only offered, not requested, are left out where they do not apply.
    """
    found: list[Check] = []
    for name in study.procedures:
        checks = apply_procedure(name, procedure(name, study.options), oscillator, context)
        found += (c for c in checks if name not in study.offered or c.verdict != Outcome.NOT_APPLICABLE)
    return tuple(found)


def checks_without_scan(
    study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], *, jobs: int
) -> tuple[Check, ...]:
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


class WithChecks(Protocol):
    """A mechanism that has been checked, in results or alone."""

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def checks(self) -> tuple[Check, ...]:
        """The answers of every procedure."""


def decide(study: Study, mechanisms: Sequence[WithChecks], tolerance: Mapping[str, float] | None = None) -> Verdict:
    """Decide on the checks of the mechanisms; tolerance: loss of index by the survey, by name."""
    near = tolerance or {}
    judged = [
        MechanismChecks(m.name, m.checks, *study.facts.get(m.name, ((), ())), near.get(m.name, 0.0)) for m in mechanisms
    ]
    return verdict(study.question, judged)


def mark_result(found: Verdict, question: Question, mechanism: MechanismResult) -> MechanismResult:
    """Return the mechanism with the checks that decide marked as such."""
    one = next(each for each in found.mechanisms if each.mechanism == mechanism.name)
    return replace(mechanism, checks=mark_deciding(mechanism.checks, one, question.basis, question.action))


EVERY_PERIOD = Band(np.array(SCALING_PERIODS), np.ones(len(SCALING_PERIODS)), np.array(SCALING_PERIODS))


def answers(
    mechanism: Mechanism,
    spectrum: Spectrum,
    *,
    procedures: Sequence[str],
    knowledge_level: str | None = None,
    records: Record | Sequence[Record] = (),
    base_elevation: float | None = None,
    lowest: float | None = None,
    building: Building | None = None,
    options: CodeOptions | None = None,
    threads: int = 0,
) -> tuple[Check, ...]:
    """Return what the procedures say of a mechanism at the spectrum's peak ground acceleration.

    The rules are those of a project: a check that lacks an input is not answered, and its reason names the remedy.

    Parameters
    ----------
    mechanism : the collapse mechanism
    spectrum : elastic spectrum of the site, at its own peak ground acceleration
    procedures : names of `assess.codes.procedures.PROCEDURES`
    knowledge_level : "LC1", "LC2" or "LC3", which the Italian codes ask for where crushing is modelled; None: not given
    records : horizontal ground motions, taken unscaled as those of the spectrum; without any, procedures by time
        histories are not answered
    base_elevation : height of the base of the mechanism above the ground [m]; None: as it is drawn over `lowest`
    lowest : elevation of the lowest body [m], which stands on the ground; None: the ground is at elevation 0
    building : the structure below the mechanism; None: not known
    options : of the codes; None for their defaults
    threads : that share the time histories; 0 for all cores

    Returns
    -------
    tuple of Check
        In the order of `procedures`, the controlling branch of each limit state.

    Raises
    ------
    ProcedureError
        Where a procedure or the level of knowledge is not known, no procedure is named, or a record is vertical.
    """
    suite = (records,) if isinstance(records, Record) else records
    if not isinstance(suite, Sequence) or isinstance(suite, str):
        raise RecordError(f"records = {records!r:.60}: give one record, or a list of them")
    suite = tuple(suite)
    _check_inputs(procedures, knowledge_level, suite, base_elevation)
    grounded = _height_above_ground(mechanism, base_elevation, lowest, building)
    study = Study(
        spectrum=spectrum,
        vertical_ratio=0.0,
        building=building,
        records=suite,
        fitting=Fitting(EVERY_PERIOD),
        artificial=None,
        scale_to="none",
        levels=(spectrum.pga,),
        procedures=tuple(dict.fromkeys(procedures)),
        offered=(),
        options=options or CodeOptions(),
        mechanisms=(mechanism,),
        equations={mechanism.name: "linearised" if mechanism.kind == "equivalent-block" else "exact"},
        amplified={mechanism.name: MechanismAmplification("none", None, Unamplified(), ())},
        scenes={},
        inputs=(),
        resolved={},
        messages=(),
        sweeps=(),
        pulses=None,
        hazard=None,
        free_periods={},
        knowledge={
            mechanism.name: dict.fromkeys(set(KNOWLEDGE_CODES.values()), knowledge_level) if knowledge_level else {}
        },
        limit_state=None,
        question=Question(None, Action(spectrum.pga / g, None)),
        facts={},
        grounded={mechanism.name: grounded},
    )
    return _checks_of_one(study, mechanism, spectrum, threads=threads)


def _height_above_ground(
    mechanism: Mechanism, base_elevation: float | None, lowest: float | None, building: Building | None
) -> HeightAboveGround:
    """Return where a mechanism stands: at the height given, else as drawn over the lowest body or elevation 0."""
    height = 0.0 if building is None else building.height
    if base_elevation is not None:
        return find_height(GroundLevel(None, lowest, height), mechanism, base_elevation=base_elevation)
    return find_height(GroundLevel(0.0 if lowest is None else lowest, lowest, height), mechanism)


def _check_inputs(
    procedures: Sequence[str],
    knowledge_level: str | None,
    records: Sequence[Record],
    base_elevation: float | None,
) -> None:
    """Raise ProcedureError for an unknown name, a vertical record or a height that is not finite."""
    if isinstance(procedures, str):
        raise ProcedureError(f'procedures: "{procedures}" given; give a list of names, ["{procedures}"]')
    if base_elevation is not None and not (is_number(base_elevation) and isfinite(base_elevation)):
        raise ProcedureError(f"base_elevation = {base_elevation}: give a finite height above the ground [m]")
    if not isinstance(procedures, Sequence):
        raise ProcedureError(
            f"procedures = {procedures!r:.60}: give a list of names; known are: {', '.join(PROCEDURES)}"
        )
    if not procedures:
        raise ProcedureError(f"procedures: name one at least; known are: {', '.join(PROCEDURES)}")
    for name in procedures:
        if name not in tuple(PROCEDURES):
            raise ProcedureError(f'procedure "{name}" is not known; known are: {", ".join(PROCEDURES)}')
    if knowledge_level is not None and knowledge_level not in FACTORS_BY_LEVEL:
        raise ProcedureError(
            f'knowledge_level "{knowledge_level}" is not known; known are: {", ".join(FACTORS_BY_LEVEL)}'
        )
    for record in records:
        check_record(record)
        if is_vertical(record.component):
            raise ProcedureError(f'record "{record.id}" is a vertical one: give horizontal ground motions')


def _checks_of_one(study: Study, mechanism: Mechanism, spectrum: Spectrum, *, threads: int) -> tuple[Check, ...]:
    """Return the checks of the study's only mechanism."""
    motions = motions_of(study, spectrum)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    case = rocking_case(study, mechanism, motions)
    histories = _histories_of_one(study, spectrum, mechanism, case, motions, threads=threads)
    return checks_of(study, case.oscillator, context_of(study, spectrum, mechanism, histories, case.base, motions))


def _histories_of_one(
    study: Study,
    spectrum: Spectrum,
    mechanism: Mechanism,
    case: RockingCase,
    motions: tuple[ScaledRecord, ...],
    *,
    threads: int,
) -> RockingHistories:
    """Return the time histories that the procedures ask for; suites without records where there are none."""
    if not any(map(uses_histories, study.procedures)):
        return RockingHistories((), ())
    if motions:
        return mechanism_histories(study, spectrum, motions, mechanism, case, threads=threads)
    levels, further = study.levels, further_levels(study, spectrum, mechanism)
    empty = [SuiteResponse(level, (), "positive") for level in (*levels, *further)]
    return RockingHistories((), tuple(empty[: len(levels)]), tuple(empty[len(levels) :]))
