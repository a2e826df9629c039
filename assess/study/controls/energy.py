"""The balance of energy of one history, and of free rocking where no history rocks.

    kinetic + potential energy + loss at impacts so far = work of the ground's motion so far        at every sample

The work of the ground on the masses, the integral of -u_g'' B dphi, is integrated by parts with S = integral of B dphi,
which is continuous through impacts, where B is not. Between samples u_g'' is linear, and S the cubic with its values
and slopes at both ends. A mechanism that vibrates on its joints faster than its record is sampled is followed at more
instants, of the same motion.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import ceil, pi, sqrt

import numpy as np

from assess.dynamics.history import TOLERANCE, Events, Trace, free_rocking, trace_with_events
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, note, whole_number
from assess.oscillator import Oscillator, elastic_frequency
from assess.results import Control
from assess.study.controls.governing import GoverningHistory
from assess.study.controls.outcome import made, not_made
from assess.study.controls.stores import StoresAt, of_line, of_masses, of_table
from assess.study.study import Equation
from records.record import Record, make_record
from spectra.arrays import BoolArray, FloatArray

QUANTITY = "energy balance"
HALF = 0.5  # of the overturning rotation: where free rocking is released
PHASE = 0.25  # rad: of a vibration on joints, from one sample to the next
MOST_PARTS = 64  # of a step of the record
LONG = 20.0  # of the time at the velocity of the first impact: a body released at HALF is back after 2.3 of them


@dataclass(frozen=True)
class Balance:
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
    mechanism : Mechanism
        Whose masses and heights give the energies.
    governing : GoverningHistory, optional
        The history; None where none rocks.
    equation : {"exact", "linearised"}
        The equation of free rocking.

    Returns
    -------
    Control
        At the sample where the balance is off most, relative to the largest energy of any sample.
    """
    if governing is None:
        return _free_control(mechanism, equation=equation)
    motion = sampled_finely(governing.motion, governing.oscillator)
    path, events = trace_with_events(governing.oscillator, motion, scale=governing.scale, equation=governing.equation)
    if governing.found.overturned:  # its last sample is where it overturned, between two samples of the record
        path = Trace(path.time[:-1], path.rotation[:-1], path.velocity[:-1])
    found = balance(
        path,
        events,
        governing.oscillator,
        stores_of(mechanism, governing.oscillator, governing.equation),
        motion,
        scale=governing.scale,
    )
    worst, largest = found.worst, float(found.energy.max())
    if largest <= 0.0:
        return _free_control(mechanism, equation=equation)
    return made(
        "energy",
        mechanism.name,
        QUANTITY,
        value=float(found.energy[worst] + found.lost[worst]),
        reference=float(found.work[worst]),
        scale=largest,
        dimension="energy",
        note=_said(mechanism, governing, impacts=int(events.impact.sum())),
    )


def stores_of(mechanism: Mechanism, oscillator: Oscillator, equation: Equation) -> tuple[StoresAt, ...]:
    """Return the energies of each branch: of the masses of a rigid chain with all its actions, else of the table."""
    if equation == "linearised":
        return tuple(of_line(branch.linearised) for branch in oscillator.branches)
    if by_masses(mechanism):
        return tuple(of_masses(chain) for chain in (mechanism.positive, mechanism.negative) if chain is not None)
    return tuple(map(of_table, oscillator.branches))


def by_masses(mechanism: Mechanism) -> bool:
    """Return whether the histories are those of the rigid chain with every action that is there at rest."""
    return not mechanism.flexible and mechanism.variants.deciding is mechanism.oscillator


def sampled_finely(motion: Record, oscillator: Oscillator) -> Record:
    """Return the same motion at more samples, by the fastest vibration of the oscillator on its joints."""
    fastest = max((elastic_frequency(branch) or 0.0) for branch in oscillator.branches)
    parts = min(ceil(2.0 * pi * fastest * motion.dt / PHASE), MOST_PARTS)
    if parts <= 1:
        return motion
    samples = np.arange((motion.npts - 1) * parts + 1) / parts
    return make_record(motion.id, np.interp(samples, np.arange(motion.npts), motion.acceleration), motion.dt / parts)


def balance(
    path: Trace, events: Events, oscillator: Oscillator, sides: tuple[StoresAt, ...], motion: Record, *, scale: float
) -> Balance:
    """Return the energies of a history from rest.

    Parameters
    ----------
    path : Trace
        The history at samples of the motion, the first ones.
    events : Events
        Its uplifts and impacts.
    oscillator : Oscillator
        Whose restitution each impact has.
    sides : tuple of StoresAt
        Energies of the positive and, if there is one, the negative branch, in its own sign.
    motion : Record
        At the base.
    scale : float
        On the motion [-].
    """
    kinetic, stored, push, slope = _at_samples(path, sides)
    within = events.time <= path.time[-1]
    times, impact, before = events.time[within], events.impact[within], events.velocity[within]
    on = events.side[within]
    partner = 1 - on if len(sides) == 2 else on
    at_rest = [each(np.zeros(1)) for each in sides]
    inertia, leap = (np.array([getattr(each, key)[0] for each in at_rest]) for key in ("inertia", "slope"))
    bounce = np.array([branch.restitution for branch in oscillator.branches])[on]
    after = np.where(_stays(times, impact, path), 0.0, before * bounce * (1.0 if len(sides) == 2 else -1.0))
    lost = np.where(impact, 0.5 * (inertia[on] * before**2 - inertia[partner] * after**2), 0.0)
    time = np.concatenate([path.time, times])
    order = np.argsort(time, kind="stable")
    sampled = order < path.time.size
    none = np.zeros(times.size)
    S = np.concatenate([push, none])[order]
    arriving = np.concatenate([slope, leap[on] * before])[order]
    leaving = np.concatenate([slope, np.where(impact, leap[partner] * after, 0.0)])[order]
    ground = scale * np.interp(time[order], motion.time, motion.acceleration)
    so_far = np.concatenate([np.zeros(path.time.size), lost])[order].cumsum()
    work = work_of_ground(time[order], ground, S, arriving, leaving)
    return Balance(kinetic + stored, so_far[sampled], work[sampled])


def work_of_ground(
    time: FloatArray, ground: FloatArray, push: FloatArray, arriving: FloatArray, leaving: FloatArray
) -> FloatArray:
    """Return the work of a ground acceleration that is linear between instants, up to each of them [n] [J].

    Parameters
    ----------
    time, ground : array
        Instants, and the acceleration there [n] [s], [m/s2].
    push : array
        S, the sum of mass times horizontal displacement, 0 at first [n] [kg m].
    arriving, leaving : array
        Rate of S before and after each instant, which an impact changes [n] [kg m/s].
    """
    step = np.diff(time)
    area = step * (push[:-1] + push[1:]) / 2.0 + step**2 * (leaving[:-1] - arriving[1:]) / 12.0
    rate = np.divide(np.diff(ground), step, out=np.zeros_like(step), where=step > 0.0)
    return np.asarray(np.concatenate([[0.0], np.cumsum(rate * area)]) - ground * push)


def _at_samples(path: Trace, sides: tuple[StoresAt, ...]) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return kinetic and potential energy, S and its rate at the samples of a history [n]."""
    kinetic, stored, push, slope = np.zeros((4, path.time.size))
    moving = (path.rotation != 0.0) | (path.velocity != 0.0)
    for sign, store in zip((1.0, -1.0), sides, strict=False):
        here = np.flatnonzero(moving & ((path.rotation < 0.0) == (sign < 0.0)))
        at = store(sign * path.rotation[here])
        kinetic[here], stored[here] = 0.5 * at.inertia * path.velocity[here] ** 2, at.stored
        push[here], slope[here] = sign * at.push, at.slope * path.velocity[here]
    return kinetic, stored, push, slope


def _stays(times: FloatArray, impact: BoolArray, path: Trace) -> BoolArray:
    """Return whether the body comes to rest at each event: until it lifts again, or at the next sample [events]."""
    following = np.minimum(np.searchsorted(path.time, times), path.time.size - 1)
    still = (path.rotation[following] == 0.0) & (path.velocity[following] == 0.0)
    sooner = np.append(times[1:] <= path.time[following[:-1]], [False])  # another event comes before that sample
    return np.asarray(np.where(sooner, ~np.append(impact[1:], [True]), still))


def _free_control(mechanism: Mechanism, *, equation: Equation) -> Control:
    """Compare the kinetic energy at the first impact of free rocking with the potential energy at its release."""
    oscillator = mechanism.variants.deciding
    branch = oscillator.positive
    release = HALF * (branch.linearised.overturning if equation == "linearised" else branch.unstable)
    at = stores_of(mechanism, oscillator, equation)[0](np.array([0.0, release]))
    potential, inertia = float(at.stored[1] - at.stored[0]), float(at.inertia[0])
    missing = partial(not_made, "energy", mechanism.name, QUANTITY, dimension="energy", why="control-no-impact")
    if potential <= 0.0:
        return missing()
    swing = release / sqrt(2.0 * potential / inertia)
    swung = free_rocking(oscillator, rotation=release, duration=LONG * swing, equation=equation, tolerance=TOLERANCE)
    if not swung.impact_velocity.size:
        return missing()
    return made(
        "energy",
        mechanism.name,
        QUANTITY,
        value=0.5 * inertia * float(swung.impact_velocity[0]) ** 2,
        reference=potential,
        scale=potential,
        dimension="energy",
        note=note("control-free-rocking", mechanism.name),
    )


def _said(mechanism: Mechanism, governing: GoverningHistory, *, impacts: int) -> Message:
    exact_masses = governing.equation == "exact" and by_masses(mechanism)
    return note(
        "control-energy-of-masses" if exact_masses else "control-energy-of-table",
        mechanism.name,
        record=governing.found.record,
        level=Quantity(governing.found.level_pga_g, "ground acceleration", 3),
        impacts=whole_number(impacts),
    )
