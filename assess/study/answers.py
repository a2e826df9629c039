"""What code procedures say of one mechanism on one spectrum, by the same rules as in a run of a project."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite

import numpy as np
from scipy.constants import g

from assess.amplification.floor_motion import Unamplified
from assess.codes.check import Check
from assess.codes.context import Building
from assess.codes.families import ITALIAN, uses_histories
from assess.codes.italian.confidence import LEVELS
from assess.codes.registry import PROCEDURES, CodeOptions
from assess.codes.suite import Suite
from assess.codes.verdict import Action, Question
from assess.errors import ProcedureError
from assess.mechanisms.mechanism import Mechanism
from assess.study.checks import checks_of
from assess.study.context import context_of
from assess.study.grounding import Ground, Grounded, stand_on
from assess.study.mechanisms import further_levels, mechanism_histories, rocking_case
from assess.study.motions import ScaledRecord, motions_of
from assess.study.response import check_record
from assess.study.rocking_case import RockingCase, RockingHistories
from assess.study.study import Amplified, Fitting, Study
from assess.study.suite_faults import suite_faults
from records.band import Band
from records.errors import RecordError
from records.orientation import is_vertical
from records.record import Record
from records.scaling import SCALING_PERIODS
from spectra.arrays import is_number
from spectra.spectrum import Spectrum

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
    procedures : names of `assess.codes.registry.PROCEDURES`
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
    grounded = _grounded(mechanism, base_elevation, lowest, building)
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
        amplified={mechanism.name: Amplified("none", None, Unamplified(), ())},
        scenes={},
        inputs=(),
        resolved={},
        messages=(),
        sweeps=(),
        pulses=None,
        hazard=None,
        free_periods={},
        knowledge={mechanism.name: dict.fromkeys(set(ITALIAN.values()), knowledge_level) if knowledge_level else {}},
        limit_state=None,
        question=Question(None, Action(spectrum.pga / g, None)),
        facts={},
        grounded={mechanism.name: grounded},
    )
    return _checks(study, mechanism, spectrum, threads=threads)


def _grounded(
    mechanism: Mechanism, base_elevation: float | None, lowest: float | None, building: Building | None
) -> Grounded:
    """Return where a mechanism stands: at the height given, else as drawn over the lowest body or elevation 0."""
    height = 0.0 if building is None else building.height
    if base_elevation is not None:
        return stand_on(Ground(None, lowest, height), mechanism, base_elevation=base_elevation)
    return stand_on(Ground(0.0 if lowest is None else lowest, lowest, height), mechanism)


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
    if knowledge_level is not None and knowledge_level not in LEVELS:
        raise ProcedureError(f'knowledge_level "{knowledge_level}" is not known; known are: {", ".join(LEVELS)}')
    for record in records:
        check_record(record)
        if is_vertical(record.component):
            raise ProcedureError(f'record "{record.id}" is a vertical one: give horizontal ground motions')


def _checks(study: Study, mechanism: Mechanism, spectrum: Spectrum, *, threads: int) -> tuple[Check, ...]:
    """Return the checks of the study's only mechanism."""
    motions = motions_of(study, spectrum)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    case = rocking_case(study, mechanism, motions)
    histories = _histories(study, spectrum, mechanism, case, motions, threads=threads)
    return checks_of(study, case.oscillator, context_of(study, spectrum, mechanism, histories, case.base, motions))


def _histories(
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
    empty = [Suite(level, (), "positive") for level in (*levels, *further)]
    return RockingHistories((), tuple(empty[: len(levels)]), tuple(empty[len(levels) :]))
