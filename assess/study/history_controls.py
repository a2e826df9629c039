"""Controls of the governing history, the worst record of the level nearest to the site's PGA: energy, convergence.

    kinetic + potential energy + loss at impacts so far = work of the ground's motion so far        at every sample

The work of the ground on the masses, the integral of -u_g'' B dphi, is integrated by parts with S = integral of B dphi,
which is continuous through impacts, where B is not. Between samples u_g'' is linear, and S the cubic with its values
and slopes at both ends. A mechanism that vibrates on its joints faster than its record is sampled is followed at more
instants, of the same motion. Where no history rocks, free rocking is balanced instead.

Three sources give the same four numbers over rotation: the masses and loads of a chain in its displaced place, without
any derivative of the height and without the table of the branch; the table, where joints deform or actions end; and
the linearised equation.

For convergence the largest rotation is found again from a table half as fine with steps less exact. If halving the
number of rotations in the table and allowing a hundred times the error in a step leaves the rotation as it is, both are
fine enough: the error of a spline falls with the fourth power of its spacing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from math import ceil, pi, sqrt

import numpy as np

from assess.amplification import base_motion
from assess.dynamics.history import (
    MOST_EVENTS,
    TOLERANCE,
    Events,
    Trace,
    free_rocking,
    peaks,
    product,
    trace_with_events,
)
from assess.dynamics.packing import Equation
from assess.dynamics.ties import memory_energy, tied_trace
from assess.loads.load import Force, PointMass, Tie, length_to_anchor, stretches
from assess.mechanisms.chain import Chain, PointPath, move, trace_point
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, note, whole_number
from assess.oscillator import Branch, Linearised, Memory, Oscillator
from assess.results import Control, HistoryResult
from assess.short_repr import ShortRepr
from assess.study.amplification import MechanismAmplification
from assess.study.controls import control_not_made, make_control
from assess.study.histories import fastest_vibration, history_severity, rocking_oscillators
from assess.study.level_peaks import TWIN_FACTORS, with_restitution_factor
from assess.study.study import ScaledRecord
from records.record import Record, make_record
from spectra.arrays import BoolArray, FloatArray
from spectra.gravity import g


@dataclass(frozen=True, repr=False)
class GoverningHistory(ShortRepr):
    """One history of a mechanism, with what it takes to run it again.

    history : as it is in the results; oscillator : with the restitution of that history
    motion : at the base of the mechanism; scale : on it, negative for the reversed polarity [-]
    """

    history: HistoryResult
    oscillator: Oscillator
    motion: Record
    scale: float
    equation: Equation


def governing_history(
    mechanism: Mechanism,
    histories: Sequence[HistoryResult],
    motions: Mapping[str, ScaledRecord],
    amplified: MechanismAmplification,
    *,
    equation: Equation,
    site_pga: float,
) -> GoverningHistory | None:
    """Return the worst history at the level nearest to the site's PGA; None if none rocks there.

    Parameters
    ----------
    mechanism : the mechanism, whose deciding oscillator rocks
    histories : all its histories
    motions : the records with their factors, by id
    amplified : how the ground's motion reaches its base
    equation : {"exact", "linearised"}
        The equation of its histories.
    site_pga : float
        [m/s2]
    """
    if not histories:
        return None
    level = min((history.level_pga_g for history in histories), key=lambda pga: abs(pga - site_pga / g))
    worst = max((history for history in histories if history.level_pga_g == level), key=history_severity)
    if worst.max_rotation_rad == 0.0:
        return None
    return GoverningHistory(
        worst,
        with_restitution_factor(rocking_oscillators(mechanism, equation)[worst.variant], worst.rebound),
        base_motion(amplified.amplification, motions[worst.record].record).record,
        worst.polarity * worst.scale_factor,
        equation,
    )


ENERGY_BALANCE = "energy balance"
RELEASE_SHARE = 0.5  # of the overturning rotation: where free rocking is released
PHASE = 0.25  # rad: of a vibration on joints, from one sample to the next
MOST_PARTS = 64  # of a step of the record
LONGEST_SWING = 20.0  # of the time at the velocity of the first impact: a body released there is back after 2.3 of them


@dataclass(frozen=True)
class EnergyBalance:
    """Energies of a history at its samples [n] [J].

    energy : kinetic and potential; lost : at impacts so far; work : of the ground's motion so far
    """

    energy: FloatArray
    lost: FloatArray
    work: FloatArray

    @property
    def worst(self) -> int:
        """The number of the sample where the balance is off most."""
        return int(np.argmax(np.abs(self.energy + self.lost - self.work)))


def energy_control(mechanism: Mechanism, governing: GoverningHistory | None, *, equation: Equation) -> Control:
    """Return the balance of energy of the governing history, or of free rocking.

    Parameters
    ----------
    mechanism : whose masses and heights give the energies
    governing : the history; None where none rocks
    equation : {"exact", "linearised"}
        The equation of free rocking.

    Returns
    -------
    At the sample where the balance is off most, relative to the largest energy of any sample.
    """
    if governing is None:
        return _free_rocking_control(mechanism, equation=equation)
    motion = sampled_finely(governing.motion, governing.oscillator)
    path, events, stored, at_rest = _history_with_memory(governing, motion)
    if governing.history.overturned:  # its last sample is where it overturned, between two samples of the record
        path = Trace(path.time[:-1], path.rotation[:-1], path.velocity[:-1])
    energies = energy_balance(
        path,
        events,
        governing.oscillator,
        branch_energies(mechanism, governing.oscillator, governing.equation),
        motion,
        scale=governing.scale,
    )
    energies = replace(energies, energy=energies.energy + stored[: energies.energy.size])
    worst, largest = energies.worst, float(energies.energy.max()) + at_rest
    if largest <= 0.0:
        return _free_rocking_control(mechanism, equation=equation)
    return make_control(
        "energy",
        mechanism.name,
        ENERGY_BALANCE,
        value=float(energies.energy[worst] + energies.lost[worst]),
        reference=float(energies.work[worst]),
        scale=largest,
        dimension="energy",
        note=_energy_note(mechanism, governing, impacts=int(events.impact.sum())),
    )


def _history_with_memory(governing: GoverningHistory, motion: Record) -> tuple[Trace, Events, FloatArray, float]:
    """Return a history, its events, and what ties and friction take up at its samples [n] and hold at rest [J]."""
    memory, scale = governing.oscillator.memory, governing.scale
    if memory is None:
        path, events = trace_with_events(governing.oscillator, motion, scale=scale, equation=governing.equation)
        return path, events, np.zeros(path.time.size), 0.0
    path, left, events = tied_trace(memory, motion, scale=scale, capacity=MOST_EVENTS)
    return path, events, memory_energy(memory, path, left), sum(tie.energy_at_rest for tie in memory.ties)


def branch_energies(mechanism: Mechanism, oscillator: Oscillator, equation: Equation) -> tuple[EnergiesAt, ...]:
    """Return the energies of each branch: of the masses of a rigid chain with all its actions, else of the table."""
    if equation == "linearised":
        return tuple(_energies_of_linearised(branch.linearised) for branch in oscillator.branches)
    if _is_rigid_chain_throughout(mechanism):
        return tuple(map(_energies_of_masses, mechanism.chains))
    return tuple(map(_energies_of_table, oscillator.bare.branches))


def sampled_finely(motion: Record, oscillator: Oscillator) -> Record:
    """Return the same motion at more samples, by the fastest vibration of the oscillator on its joints."""
    parts = min(ceil(2.0 * pi * fastest_vibration(oscillator) * motion.dt / PHASE), MOST_PARTS)
    if parts <= 1:
        return motion
    samples = np.arange((motion.npts - 1) * parts + 1) / parts
    return make_record(motion.id, np.interp(samples, np.arange(motion.npts), motion.acceleration), motion.dt / parts)


def energy_balance(
    path: Trace, events: Events, oscillator: Oscillator, sides: tuple[EnergiesAt, ...], motion: Record, *, scale: float
) -> EnergyBalance:
    """Return the energies of a history from rest.

    Parameters
    ----------
    path : the history at samples of the motion, the first ones
    events : its uplifts and impacts
    oscillator : whose restitution each impact has
    sides : energies of the positive and, if there is one, the negative branch, in its own sign
    motion : at the base
    scale : on the motion [-]
    """
    kinetic, potential, excitation_integral, excitation_rate = _at_samples(path, sides)
    within = events.time <= path.time[-1]
    times, impact, before = events.time[within], events.impact[within], events.velocity[within]
    on = events.side[within]
    partner = 1 - on if len(sides) == 2 else on
    at_rest = [energies_at(np.zeros(1)) for energies_at in sides]
    inertia, excitation = (
        np.array([getattr(energies_at, key)[0] for energies_at in at_rest]) for key in ("inertia", "excitation")
    )
    bounce = np.array([branch.restitution for branch in oscillator.branches])[on]
    after = np.where(_comes_to_rest(times, impact, path), 0.0, before * bounce * (1.0 if len(sides) == 2 else -1.0))
    lost = np.where(impact, 0.5 * (inertia[on] * before**2 - inertia[partner] * after**2), 0.0)
    time = np.concatenate([path.time, times])
    order = np.argsort(time, kind="stable")
    sampled = order < path.time.size
    none = np.zeros(times.size)
    S = np.concatenate([excitation_integral, none])[order]
    arriving = np.concatenate([excitation_rate, excitation[on] * before])[order]
    leaving = np.concatenate([excitation_rate, np.where(impact, excitation[partner] * after, 0.0)])[order]
    ground = scale * np.interp(time[order], motion.time, motion.acceleration)
    so_far = np.concatenate([np.zeros(path.time.size), lost])[order].cumsum()
    work = _work_of_ground(time[order], ground, S, arriving, leaving)
    return EnergyBalance(kinetic + potential, so_far[sampled], work[sampled])


@dataclass(frozen=True)
class Energies:
    """A branch at n rotations, in its own sign.

    inertia : twice the kinetic energy at a rate of one [kg m2]
    potential : energy of weights, forces and joints, from rest [J]
    excitation_integral : sum of mass times horizontal displacement [kg m]; excitation : its derivative [kg m]
    """

    inertia: FloatArray
    potential: FloatArray
    excitation_integral: FloatArray
    excitation: FloatArray


LOOSER_TOLERANCE = 100.0  # times the error allowed in a step
LARGEST_ROTATION = "largest rotation over that of overturning"
OVERTURNING_TIME = "time of overturning"
OVERTURNING_ROTATION = "overturning rotation"
TABLE_COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")


def convergence_control(mechanism: Mechanism, governing: GoverningHistory | None) -> Control:
    """Compare the governing history with itself on a coarser table, or the overturning rotation where none rocks.

    Parameters
    ----------
    mechanism : the mechanism
    governing : its history; None where none rocks

    Returns
    -------
    Relative to the value of the run.
    """
    if governing is None:
        return _overturning_control(mechanism)
    if governing.equation == "linearised":
        return control_not_made(
            "convergence", mechanism.name, LARGEST_ROTATION, dimension="ratio", why="control-without-table"
        )
    coarse = peaks(
        [_coarser_oscillator(governing.oscillator)],
        [governing.motion],
        product(1, 1, governing.scale),
        equation="exact",
        threads=1,
        tolerance=LOOSER_TOLERANCE * TOLERANCE,
    )
    history = governing.history
    quantity, dimension = LARGEST_ROTATION, "ratio"
    value, reference = history.max_rotation_ratio, float(coarse.max_ratio[0])
    if history.variant:  # its ratio is over the rotation that overturns the deciding oscillator
        side = 0 if history.branch == "positive" else -1
        own, deciding = (each.branches[side] for each in (governing.oscillator, mechanism.variants.deciding))
        reference *= own.overturning / deciding.overturning
    if history.overturned and coarse.overturned[0]:
        quantity, dimension = OVERTURNING_TIME, "time"
        value, reference = history.overturning_time_s, float(coarse.overturning_time[0])
    if value is None:  # it overturns here, and not with less exact steps
        value = 1.0
    made = make_control(
        "convergence",
        mechanism.name,
        quantity,
        value=value,
        reference=reference,
        scale=value,
        dimension=dimension,
        note=note(
            "control-coarser",
            mechanism.name,
            record=history.record,
            level=Quantity(history.level_pga_g, "ground acceleration", 3),
            factor=Quantity(LOOSER_TOLERANCE, "ratio", 3),
        ),
    )
    if made.met is False and _twins_part(governing, by=abs(float(coarse.max_ratio[0]) - _ratio_of_run(governing))):
        return control_not_made("convergence", mechanism.name, quantity, dimension=dimension, why="control-chaotic")
    return made


def _ratio_of_run(governing: GoverningHistory) -> float:
    """Return the largest ratio of the governing history, run again by itself."""
    return float(_ratios(governing, np.ones(1))[0])


def _twins_part(governing: GoverningHistory, *, by: float) -> bool:
    """Return whether the twins of the governing history lie farther apart than a ratio: a coarser table says no more.

    What they differ by counts in the verdict as its numerical spread.
    """
    return bool(np.ptp(_ratios(governing, TWIN_FACTORS)) >= by)


def _ratios(governing: GoverningHistory, factors: FloatArray) -> FloatArray:
    """Return the largest ratio of the governing history at factors on its motion [n]."""
    jobs = product(1, 1, governing.scale * factors)
    return peaks([governing.oscillator], [governing.motion], jobs, equation="exact", threads=1).max_ratio


def every_second(rotation: FloatArray) -> FloatArray:
    """Return the numbers of the nodes to keep [m]; jumps, of two nodes at one rotation, stay."""
    ends = np.concatenate([[0], np.flatnonzero(np.diff(rotation) == 0.0) + 1, [rotation.size]])
    pieces = [np.arange(first, last) for first, last in pairwise(ends.tolist())]
    return np.concatenate([np.union1d(piece[::2], piece[-1:]) for piece in pieces])


def _is_rigid_chain_throughout(mechanism: Mechanism) -> bool:
    """Return whether the histories are those of the rigid chain with every action that is there at rest."""
    bars = any(stretches(load) for load in mechanism.positive.loads)
    return not mechanism.flexible and not bars and mechanism.variants.deciding is mechanism.oscillator


def _work_of_ground(
    time: FloatArray, ground: FloatArray, excitation_integral: FloatArray, arriving: FloatArray, leaving: FloatArray
) -> FloatArray:
    """Return the work of a ground acceleration that is linear between instants, up to each of them [n] [J].

    Parameters
    ----------
    time, ground : instants, and the acceleration there [n] [s], [m/s2]
    excitation_integral : s, the sum of mass times horizontal displacement, 0 at first [n] [kg m]
    arriving, leaving : rate of S before and after each instant, which an impact changes [n] [kg m/s]
    """
    step = np.diff(time)
    area = (
        step * (excitation_integral[:-1] + excitation_integral[1:]) / 2.0
        + step**2 * (leaving[:-1] - arriving[1:]) / 12.0
    )
    rate = np.divide(np.diff(ground), step, out=np.zeros_like(step), where=step > 0.0)
    return np.asarray(np.concatenate([[0.0], np.cumsum(rate * area)]) - ground * excitation_integral)


def _at_samples(path: Trace, sides: tuple[EnergiesAt, ...]) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return kinetic and potential energy, S and its rate at the samples of a history [n]."""
    kinetic, potential, excitation_integral, excitation_rate = np.zeros((4, path.time.size))
    in_motion = (path.rotation != 0.0) | (path.velocity != 0.0)
    for sign, store in zip((1.0, -1.0), sides, strict=False):
        here = np.flatnonzero(in_motion & ((path.rotation < 0.0) == (sign < 0.0)))
        energies = store(sign * path.rotation[here])
        kinetic[here], potential[here] = 0.5 * energies.inertia * path.velocity[here] ** 2, energies.potential
        excitation_integral[here], excitation_rate[here] = (
            sign * energies.excitation_integral,
            energies.excitation * path.velocity[here],
        )
    return kinetic, potential, excitation_integral, excitation_rate


def _comes_to_rest(times: FloatArray, impact: BoolArray, path: Trace) -> BoolArray:
    """Return whether the body comes to rest at each event: until it lifts again, or at the next sample [events]."""
    following = np.minimum(np.searchsorted(path.time, times), path.time.size - 1)
    rests = (path.rotation[following] == 0.0) & (path.velocity[following] == 0.0)
    sooner = np.append(times[1:] <= path.time[following[:-1]], [False])  # another event comes before that sample
    return np.asarray(np.where(sooner, ~np.append(impact[1:], [True]), rests))


def _free_rocking_control(mechanism: Mechanism, *, equation: Equation) -> Control:
    """Compare the kinetic energy at the first impact of free rocking with the potential energy at its release."""
    oscillator = mechanism.variants.deciding.bare
    branch = oscillator.positive
    release = RELEASE_SHARE * (branch.linearised.overturning if equation == "linearised" else branch.unstable)
    energies = branch_energies(mechanism, oscillator, equation)[0](np.array([0.0, release]))
    potential, inertia = float(energies.potential[1] - energies.potential[0]), float(energies.inertia[0])
    missing = partial(
        control_not_made, "energy", mechanism.name, ENERGY_BALANCE, dimension="energy", why="control-no-impact"
    )
    if potential <= 0.0:
        return missing()
    swing = release / sqrt(2.0 * potential / inertia)
    swung = free_rocking(
        oscillator, rotation=release, duration=LONGEST_SWING * swing, equation=equation, tolerance=TOLERANCE
    )
    if not swung.impact_velocity.size:
        return missing()
    return make_control(
        "energy",
        mechanism.name,
        ENERGY_BALANCE,
        value=0.5 * inertia * float(swung.impact_velocity[0]) ** 2,
        reference=potential,
        scale=potential,
        dimension="energy",
        note=note("control-free-rocking", mechanism.name),
    )


def _energy_note(mechanism: Mechanism, governing: GoverningHistory, *, impacts: int) -> Message:
    exact_masses = governing.equation == "exact" and _is_rigid_chain_throughout(mechanism)
    return note(
        "control-energy-of-masses" if exact_masses else "control-energy-of-table",
        mechanism.name,
        record=governing.history.record,
        level=Quantity(governing.history.level_pga_g, "ground acceleration", 3),
        impacts=whole_number(impacts),
    )


EnergiesAt = Callable[[FloatArray], Energies]


def _energies_of_masses(chain: Chain) -> EnergiesAt:
    """Return the energies of a rigid chain over its rotation, whose forces and ties act throughout."""

    def energies_at(rotation: FloatArray) -> Energies:
        motion = move(chain, np.concatenate([[0.0], rotation]))  # rest first: heights count from it
        inertia, potential, excitation_integral, excitation = np.zeros((4, rotation.size + 1))
        for rate, block in zip(motion.rate, chain.blocks, strict=True):
            inertia += block.inertia * rate**2
        masses = [(block.mass, block.centroid, True, number) for number, block in enumerate(chain.blocks)]
        masses += [
            (load.mass, load.at, load.bearing, load.block) for load in chain.loads if isinstance(load, PointMass)
        ]
        for mass, place, bearing, number in masses:
            moved = trace_point(motion, block=number, at=place)
            inertia += mass * (moved.dx**2 + bearing * moved.dz**2)
            potential += mass * g * bearing * (moved.z - moved.z[0])
            excitation_integral += mass * (moved.x - moved.x[0])
            excitation += mass * moved.dx
        for load in chain.loads:
            if not isinstance(load, PointMass):
                potential -= _work_of_load(load, trace_point(motion, block=load.block, at=load.at))
        return Energies(inertia[1:], potential[1:], excitation_integral[1:], excitation[1:])

    return energies_at


def _energies_of_table(branch: Branch) -> EnergiesAt:
    """Return the energies of a branch over its rotation, integrated from its table."""
    return lambda rotation: Energies(
        np.asarray(branch.inertia_spline(rotation)),
        np.asarray(branch.energy_spline(rotation)),
        np.asarray(branch.excitation_integral(rotation)),
        np.asarray(branch.excitation_spline(rotation)),
    )


def _energies_of_linearised(line: Linearised) -> EnergiesAt:
    """Return the energies of the linearised equation: a constant inertia, and a moment that falls evenly."""
    inertia, K, B, end = line.inertia, line.stiffness, line.excitation, line.overturning
    return lambda rotation: Energies(
        np.full_like(rotation, inertia),
        K * rotation * (end - 0.5 * rotation),
        B * rotation,
        np.full_like(rotation, B),
    )


def _work_of_load(load: Force | Tie, moved: PointPath) -> FloatArray:
    """Return the work of a force or tie of constant size from rest [n] [J]; none of a tie that shortens."""
    if isinstance(load, Force):
        return np.asarray(load.force[0] * (moved.x - moved.x[0]) + load.force[1] * (moved.z - moved.z[0]))
    if load.anchor is None:
        along, up = load.direction or (0.0, 0.0)
        work = load.tension * (along * (moved.x - moved.x[0]) + up * (moved.z - moved.z[0]))
        starting = along * moved.dx[0] + up * moved.dz[0]
    else:
        to_x, to_z = load.anchor[0] - moved.x, load.anchor[1] - moved.z
        length = length_to_anchor(load, to_x, to_z)
        work = load.tension * (length[0] - length)
        starting = to_x[0] * moved.dx[0] + to_z[0] * moved.dz[0]
    return np.zeros_like(work) if starting > 0.0 and not load.both else np.asarray(work)


def _coarser_oscillator(oscillator: Oscillator) -> Oscillator:
    """Return the oscillator with every second rotation of its tables."""
    positive, negative = oscillator.positive, oscillator.negative
    first = _coarser_branch(positive)
    other = first if negative is positive else None if negative is None else _coarser_branch(negative)
    memory = None if oscillator.memory is None else _coarser_memory(oscillator.memory)
    return replace(oscillator, positive=first, negative=other, memory=memory)


def _coarser_memory(memory: Memory) -> Memory:
    """Return the memory with every second rotation of its tables."""
    kept = [every_second(branch.rotation) for branch in memory.bare.branches]
    ties = tuple(
        replace(
            tie,
            elongation=tuple(each[at] for each, at in zip(tie.elongation, kept, strict=True)),
            rate=tuple(each[at] for each, at in zip(tie.rate, kept, strict=True)),
        )
        for tie in memory.ties
    )
    friction = tuple(each[at] for each, at in zip(memory.friction, kept, strict=False))
    return replace(memory, bare=_coarser_oscillator(memory.bare), ties=ties, friction=friction)


def _coarser_branch(branch: Branch) -> Branch:
    """Return the branch with every second rotation of its table, and both ends of each smooth piece of it."""
    kept = every_second(branch.rotation)
    return replace(branch, **{key: getattr(branch, key)[kept] for key in TABLE_COLUMNS})


def _overturning_control(mechanism: Mechanism) -> Control:
    """Compare the overturning rotation with that at which a table half as fine falls to zero."""
    branch = mechanism.variants.deciding.bare.positive
    roots = _coarser_branch(branch).restoring_spline.roots(extrapolate=False)
    finite = roots[np.isfinite(roots)]  # an interval of no width has none
    near = finite[np.argmin(np.abs(finite - branch.unstable))] if finite.size else 0.0
    return make_control(
        "convergence",
        mechanism.name,
        OVERTURNING_ROTATION,
        value=branch.unstable,
        reference=float(near),
        scale=branch.unstable,
        dimension="rotation",
        note=note("control-coarser-table", mechanism.name),
    )
