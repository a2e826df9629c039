"""What the procedures of codes may know of one mechanism: site, motions, building, and the mechanism itself."""

from __future__ import annotations

from dataclasses import replace

from assess.amplification.floor_motion import BaseMotion, ModalFilter
from assess.codes.check import Reason, reason_message
from assess.codes.context import Context, LocalLimit, OpenSeat, Transfer
from assess.loads.load import PointMass
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.limits import height_of_support, limits, open_seats
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity
from assess.study.endurance import unsupported_messages
from assess.study.floor_input import floor_spectrum
from assess.study.motions import ScaledRecord
from assess.study.rocking_case import RockingHistories
from assess.study.study import Amplified, Study
from assess.study.wall_size import SUPPORTS, carries_floors, wall_of
from spectra.spectrum import Spectrum

ASCE43 = "asce43-05"  # whose rules for suites apply to a floor spectrum made of one
NEARLY = 0.9  # of the height of the supports: motion amplified only below it counts as that of the ground


def context_of(
    study: Study,
    spectrum: Spectrum,
    mechanism: Mechanism,
    rocked: RockingHistories,
    base: tuple[BaseMotion, ...],
    motions: tuple[ScaledRecord, ...],
) -> Context:
    """Return what the procedures may know of one mechanism.

    Parameters
    ----------
    study : Study
        The study that the mechanism is part of.
    spectrum : Spectrum
        The site's elastic spectrum.
    mechanism : Mechanism
        The mechanism to be assessed.
    rocked : RockingHistories
        Its time histories; empty where no procedure needs them.
    base : tuple of BaseMotion
        Every motion as it acts at the base of the mechanism.
    motions : tuple of ScaledRecord
        The same motions at the ground, with their factors.

    Returns
    -------
    Context
        With a floor spectrum where the mechanism is above the ground.
    """
    context = _without_floor_spectrum(study, spectrum, mechanism, rocked, base)
    if not context.above_ground:
        return context
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
    return replace(context, floor_spectrum=floor)


def _without_floor_spectrum(
    study: Study, spectrum: Spectrum, mechanism: Mechanism, rocked: RockingHistories, base: tuple[BaseMotion, ...]
) -> Context:
    grounded, rise, ways = study.grounded[mechanism.name], height_of_support(mechanism), mechanism.variants
    amplified = study.amplified[mechanism.name]
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
        histories_at="ground" if amplified.height is None else "mechanism base",
        transfer=transfer_to_support(amplified, support=grounded.support),
        crushing=mechanism.crushing,
        starting=ways.starting,
        breaking=ways.breaking,
        limits=tuple(LocalLimit(each.kind, each.what, each.branch, each.rotation) for each in limits(mechanism)),
        open_seats=tuple(OpenSeat(**vars(each)) for each in open_seats(mechanism)),
        knowledge=study.knowledge.get(mechanism.name, {}),
        limit_state=study.limit_state if study.hazard is None else None,
        impossible=grounded.unknown,
        not_lasting=unsupported_messages(mechanism),
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


def transfer_to_support(amplified: Amplified, *, support: float) -> Transfer:
    """Return how the motion of the histories is amplified up to the `support` of a mechanism [m above the ground].

    Motion that is amplified only part of the way counts as that of the ground.
    """
    if amplified.height is None or amplified.height < NEARLY * support:
        return "not"
    return "by a filter" if isinstance(amplified.amplification, ModalFilter) else "by a factor"


def reasons_against_histories(mechanism: Mechanism) -> tuple[Message, ...]:
    """Return why histories cannot assess the mechanism: the first impact would bring it to rest."""
    if mechanism.stopped is None:
        return ()
    return (reason_message(Reason.STOPS, restitution=Quantity(mechanism.stopped, figures=3)),)
