"""What is asked of mechanisms made of plain data: the answers of codes, by the rules of a project, and fragility."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite

from assess.codes.asce43_05 import VERTICAL_RATIO
from assess.codes.bases import BASES, BY_SITE, Acceptance
from assess.codes.check import Check
from assess.codes.context import Building, Context
from assess.codes.italian_limit_states import FACTORS_BY_LEVEL
from assess.codes.procedures import KNOWLEDGE_CODES, PROCEDURES, uses_histories
from assess.codes.question import Action, Question
from assess.dynamics.packing import Equation
from assess.errors import MechanismError, ProcedureError
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.single_block import EquivalentBlock
from assess.study.amplification import NOT_AMPLIFIED, GroundLevel, HeightAboveGround, find_height
from assess.study.assessment import check_mechanism
from assess.study.block import Block
from assess.study.histories import RockingHistories, mechanism_histories, without_runs
from assess.study.level_peaks import RockingCase
from assess.study.response import check_record
from assess.study.study import Fitting, FragilityQuestion, Study
from assess.study.suites import ALL_PERIODS, motions_of, suite_faults
from records.errors import RecordError
from records.record import Record, is_vertical
from records.synthetic import ArtificialRecords
from spectra.arrays import is_number
from spectra.gravity import g
from spectra.spectrum import Spectrum


def answers(
    mechanism: Mechanism,
    spectrum: Spectrum,
    *,
    procedures: Sequence[str] | None = None,
    knowledge_level: str | None = None,
    records: Record | Sequence[Record] = (),
    base_elevation: float | None = None,
    lowest: float | None = None,
    building: Building | None = None,
    threads: int = 0,
) -> tuple[Check, ...]:
    """Return what the procedures say of a mechanism at the spectrum's peak ground acceleration.

    The rules are those of a project: a check that lacks an input is not answered, and its reason names the remedy.

    Parameters
    ----------
    mechanism : the collapse mechanism
    spectrum : elastic spectrum of the site, at its own peak ground acceleration
    procedures : names of `assess.codes.procedures.PROCEDURES`; None: those of the basis of the spectrum's code
    knowledge_level : "LC1", "LC2" or "LC3", which the Italian codes ask for where crushing is modelled; None: not given
    records : horizontal ground motions, taken unscaled as those of the spectrum; without any, procedures by time
        histories are not answered
    base_elevation : height of the base of the mechanism above the ground [m]; None: as it is drawn over `lowest`
    lowest : elevation of the lowest body [m], which stands on the ground; None: the ground is at elevation 0
    building : the structure below the mechanism; None: not known
    threads : that share the time histories; 0 for all cores

    Returns
    -------
    In the order of `procedures`, the controlling branch of each limit state.

    Raises
    ------
    ProcedureError : where a procedure or the level of knowledge is not known, no procedure is named, or a record is
        vertical
    """
    suite = (records,) if isinstance(records, Record) else records
    if not isinstance(suite, Sequence) or isinstance(suite, str):
        raise RecordError(f"records = {records!r:.60}: give one record, or a list of them")
    suite = tuple(suite)
    if procedures is None:
        procedures = _default_procedures(spectrum, suite)
    _check_inputs(procedures, knowledge_level, suite, base_elevation)
    height = _height_above_ground(mechanism, base_elevation, lowest, building)
    knowledge = {mechanism.name: dict.fromkeys(KNOWLEDGE_CODES, knowledge_level) if knowledge_level else {}}
    study = replace(
        _plain_study(((mechanism, height),), suite, spectrum),
        building=building,
        procedures=tuple(dict.fromkeys(procedures)),
        knowledge=knowledge,
    )
    return _checks_of_block(study, mechanism, spectrum, threads=threads)


def fragility_study(
    blocks: Sequence[Block], records: Sequence[Record], question: FragilityQuestion, *, spectrum: Spectrum | None
) -> Study:
    """Return the study that `run_fragility` takes, of mechanisms on the ground or as high above it as they are drawn.

    Parameters
    ----------
    blocks : the mechanisms
    records : horizontal ground motions, unscaled
    question : what is asked
    spectrum : that artificial records are made for where there are no others

    Raises
    ------
    MechanismError : no history of a mechanism is answered, or two have one name
    RecordError : something is no horizontal record of finite samples, or there is none
    """
    if not records and spectrum is None:
        raise RecordError("records: none; give recorded motions, as read_records returns them, or a spectrum")
    for record in records:
        check_record(record)
        if is_vertical(record.component):
            raise RecordError(f'record "{record.id}" is vertical; give a horizontal ground motion')
    names = [block.name for block in blocks]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise MechanismError(f"several mechanisms are called {', '.join(twice)}; give each its name")
    for block in blocks:
        _ = block.rocking  # raises where no history of it is answered
    placed = [(block.mechanism, _height_above_ground(block.mechanism, None, block.lowest, None)) for block in blocks]
    artificial = None if records else ArtificialRecords()
    moving = {  # a session may call two bodies by one name
        block.name: tuple(f"{name} {id(block.bodies[name])}" for name in block.definition.bodies)
        for block in blocks
        if not isinstance(block.definition, EquivalentBlock)
    }
    study = _plain_study(placed, tuple(records), spectrum)
    return replace(study, fragility=question, artificial=artificial, moving=moving)


def _default_procedures(spectrum: Spectrum, records: Sequence[Record]) -> tuple[str, ...]:
    """Return the procedures that the basis of a spectrum's code accepts, those by histories only with records.

    Raises ProcedureError where the code has no basis of its own; the text lists the procedures.
    """
    if spectrum.code not in BY_SITE:
        raise ProcedureError(
            f"procedures: none given, and a spectrum of {spectrum.code} has no default; known are: "
            f"{', '.join(PROCEDURES)}"
        )
    states = BASES[BY_SITE[spectrum.code]].states
    accepted = {
        method.procedure
        for state in states
        for rank in state.ranks
        for method in rank
        if method.acceptance == Acceptance.ACCEPTED
    }
    return tuple(name for name in PROCEDURES if name in accepted and (records or not uses_histories(name)))


def _plain_study(
    placed: Sequence[tuple[Mechanism, HeightAboveGround]], records: tuple[Record, ...], spectrum: Spectrum | None
) -> Study:
    """Return a study of mechanisms that says nothing but where they stand, the motions and the spectrum."""
    pga = 0.0 if spectrum is None else spectrum.pga
    equations: dict[str, Equation] = {
        each.name: "linearised" if each.kind == "equivalent-block" else "exact" for each, _ in placed
    }
    return Study(
        spectrum=spectrum,
        vertical_ratio=VERTICAL_RATIO,
        records=records,
        fitting=Fitting(ALL_PERIODS),
        levels=(pga,),
        mechanisms=tuple(mechanism for mechanism, _ in placed),
        equations=equations,
        amplified=dict.fromkeys(equations, NOT_AMPLIFIED),
        question=Question(None, Action(pga / g, None)),
        heights={mechanism.name: height for mechanism, height in placed},
    )


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


def _checks_of_block(study: Study, mechanism: Mechanism, spectrum: Spectrum, *, threads: int) -> tuple[Check, ...]:
    """Return the checks of the study's only mechanism."""
    motions = motions_of(study, spectrum)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))

    def run(there: Study, case: RockingCase, context: Context) -> RockingHistories:
        if not any(map(uses_histories, there.procedures)):
            return RockingHistories((), ())
        if not motions:
            return without_runs(there, spectrum, mechanism)
        return mechanism_histories(there, spectrum, motions, mechanism, case, threads=threads)

    return check_mechanism(study, spectrum, mechanism, motions, run).checks
