"""The mechanisms of a study through every procedure, with their histories."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

from assess.amplification.floor_motion import BaseMotion, ModalFilter, base_motion
from assess.codes.applicability import apply_procedure
from assess.codes.check import Check, Outcome, Reason, reason_message
from assess.codes.context import Context, LocalLimit, Transfer
from assess.codes.families import uses_histories
from assess.codes.italian.confidence import confidence_factors
from assess.codes.italian.history import required_pga
from assess.codes.registry import history_rules, procedure
from assess.loads.load import PointMass
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.lasting import height_of_support, limits, variants
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity
from assess.oscillator import Oscillator
from assess.results import MechanismResult
from assess.study.endurance import unheld_messages
from assess.study.floor_input import floor_spectrum
from assess.study.histories import RockingCase, RockingHistories, run_histories, vibrates, with_governing_trace
from assess.study.motions import ScaledRecord
from assess.study.outcome import amplification_result, mechanism_result
from assess.study.study import Amplified, Study
from assess.study.wall_size import SUPPORTS, carries_floors, wall_of
from spectra.spectrum import Spectrum

ASCE43 = "asce43-05"  # whose rules for suites hold for a floor spectrum made of one
SHORT_OF = 0.9  # of the height of the supports: motion carried less far is that of the ground
Progress = Callable[[str, int, int], None]


def assess_mechanisms(
    study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismResult, ...]:
    """Every mechanism of `study` under the `motions`, which fit the `spectrum`; `jobs` threads, 0 for all cores.

    Each thread takes a mechanism, the longest first; where there are fewer than threads, several share its histories.
    So the procedures of one, which hold the interpreter's lock, go on beside the histories of another, which do not.
    """
    shaken = {
        m.name: RockingCase(
            m.name,
            variants(m).deciding,
            study.equations[m.name],
            motions_at_base(study.amplified[m.name], motions),
            m.rebounds,
        )
        for m in study.mechanisms
    }
    scanned = any(map(uses_histories, study.procedures))
    workers = jobs or os.cpu_count() or 1
    each = max(1, workers // max(1, len(shaken)))

    def of(mechanism: Mechanism) -> MechanismResult:
        one, pga, wanted = shaken[mechanism.name], spectrum.pga, further_levels(study, spectrum, mechanism)
        rocked = run_histories(
            one, motions, levels=study.levels, besides=wanted, site_pga=pga, scanned=scanned, threads=each
        )
        return assess_mechanism(study, spectrum, motions, mechanism, one, rocked)

    longest = sorted(study.mechanisms, key=lambda m: not vibrates(shaken[m.name].oscillator))
    done: dict[str, MechanismResult] = {}
    progress("rocking histories", 0, len(longest))
    with ThreadPoolExecutor(workers) as pool:
        for found in pool.map(of, longest):
            done[found.name] = found
            progress("rocking histories", len(done), len(longest))
    return tuple(done[m.name] for m in study.mechanisms)


def further_levels(study: Study, spectrum: Spectrum, mechanism: Mechanism) -> tuple[float, ...]:
    """PGA [m/s2] at which procedures want suites besides those of the levels: limit states of their own, FC."""
    wanted: list[float] = []
    known = study.knowledge.get(mechanism.name, {})
    for name, (rule, options) in history_rules(study.options).items():
        if name in study.procedures:
            level = known.get(rule.edition.code)
            factors = [each.factor for each in confidence_factors(options, crushing=mechanism.crushing, level=level)]
            wanted += required_pga(study.levels, study.hazard, spectrum, rule=rule, options=options, factors=factors)
    return tuple(dict.fromkeys(wanted))


def motions_at_base(amplified: Amplified, motions: tuple[ScaledRecord, ...]) -> tuple[BaseMotion, ...]:
    """Every motion as it acts at the base of a mechanism."""
    return tuple(base_motion(amplified.amplification, motion.record) for motion in motions)


def assess_mechanism(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanism: Mechanism,
    shaken: RockingCase,
    rocked: RockingHistories,
) -> MechanismResult:
    """One mechanism through every procedure, with its histories."""
    context = context_of(study, spectrum, mechanism, rocked, shaken.base, motions)
    return mechanism_result(
        mechanism,
        variants(mechanism).starting,
        equation=shaken.equation,
        scene=study.scenes.get(mechanism.name),
        checks=checks_of(study, shaken.oscillator, context),
        histories=() if context.not_lasting else with_governing_trace(shaken, rocked.histories, motions),
        amplification=amplification_result(study.amplified[mechanism.name], motions, shaken.base),
        grounded=study.grounded[mechanism.name],
    )


def context_of(
    study: Study,
    spectrum: Spectrum,
    mechanism: Mechanism,
    rocked: RockingHistories,
    base: tuple[BaseMotion, ...],
    motions: tuple[ScaledRecord, ...],
) -> Context:
    """What the procedures may know of one mechanism."""
    context = _context_of(study, spectrum, mechanism, rocked, base)
    amplification = study.amplified[mechanism.name].amplification
    by_mode = context.transfer == "by a filter" and not context.suite_faults.get(ASCE43)
    floor = floor_spectrum(
        spectrum,
        height=context.support_height,
        filtered=amplification if by_mode and isinstance(amplification, ModalFilter) else None,
        base=base,
        motions=motions,
        building=study.building,
    )
    return replace(context, floor_spectrum=floor if context.above_ground else None)


def _context_of(
    study: Study, spectrum: Spectrum, mechanism: Mechanism, rocked: RockingHistories, base: tuple[BaseMotion, ...]
) -> Context:
    grounded, rise, ways = study.grounded[mechanism.name], height_of_support(mechanism), variants(mechanism)
    return Context(
        spectrum=spectrum,
        levels=study.levels,
        vertical_ratio=study.vertical_ratio,
        support=SUPPORTS[mechanism.kind],
        carries_floors=carries_floors(mechanism),
        actions=tuple(load.name for load in mechanism.positive.loads if not isinstance(load, PointMass)),
        wall=wall_of(mechanism),
        elevation=grounded.base,
        rise=rise,
        building=study.building,
        suites=rocked.suites,
        histories_at="ground" if study.amplified[mechanism.name].height is None else "mechanism base",
        transfer=transfer_to_support(study.amplified[mechanism.name], support=grounded.support),
        crushing=mechanism.crushing,
        starting=ways.starting,
        breaking=ways.breaking,
        limits=tuple(LocalLimit(each.kind, each.what, each.branch, each.rotation) for each in limits(mechanism)),
        seats_unknown=seats_unknown(mechanism),
        knowledge=study.knowledge.get(mechanism.name, {}),
        limit_state=study.limit_state if study.hazard is None else None,
        impossible=grounded.unknown,
        not_lasting=unheld_messages(mechanism),
        suite_faults=study.suite_faults,
        impossible_by_histories=reasons_against_histories(mechanism),
        amplification=max((each.factor for each in base), default=1.0),
        linearised=study.equations[mechanism.name] == "linearised",
        extra_suites=rocked.besides,
        hinges=hinge_forces(mechanism),
        incremental=tuple(sorted((*rocked.scan, *rocked.suites), key=lambda suite: suite.pga)) if rocked.scan else (),
        hazard=study.hazard,
        free_period=study.free_periods.get(mechanism.name),
    )


def seats_unknown(mechanism: Mechanism) -> tuple[str, ...]:
    """What rests on the mechanism and may lose a seat that nobody gave: floors, beams, bearing masses."""
    resting = [load for load in mechanism.positive.loads if isinstance(load, PointMass) and load.bearing]
    return tuple(load.name for load in resting if load.seat is None)


def reasons_against_histories(mechanism: Mechanism) -> tuple[Message, ...]:
    """Why no histories can be answered: the first impact would bring the mechanism to rest."""
    if mechanism.stopped is None:
        return ()
    return (reason_message(Reason.STOPS, restitution=Quantity(mechanism.stopped, figures=3)),)


def checks_of(study: Study, rocker: Oscillator, context: Context) -> tuple[Check, ...]:
    """The answers of every procedure of the study, in its order; of those nobody asked for, where they apply."""
    found: list[Check] = []
    for name in study.procedures:
        checks = apply_procedure(name, procedure(name, study.options), rocker, context)
        found += (c for c in checks if name not in study.offered or c.verdict != Outcome.NOT_APPLICABLE)
    return tuple(found)


def transfer_to_support(amplified: Amplified, *, support: float) -> Transfer:
    """How the motion of the histories gets to what holds the mechanism, `support` above the ground [m].

    Motion that is carried only a part of the way counts as that of the ground.
    """
    if amplified.height is None or amplified.height < SHORT_OF * support:
        return "not"
    return "by a filter" if isinstance(amplified.amplification, ModalFilter) else "by a factor"
