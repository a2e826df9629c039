"""The checks of mechanisms by the procedures of codes, what these may know of a mechanism, and the verdict on them.

What they may know is the site, the motions, the building, the mechanism itself and the wall that it is part of, and
above the ground the floor spectrum, for the method that has no clause on floor spectra. If the suite is filtered by the
first mode, the latter is the envelope of the response spectra at the base, with peaks broadened by 15 % to both sides
for the uncertainty of the building's period. The mean would be lower; the clause that allows it could not be read, and
one record that is low at the building's period would reduce it, so the envelope is taken. Otherwise it is C7.2.5 of
Circolare 7/2019, if the building's height and storeys are known, its period varied by 15 % too. Neither is taken below
the spectrum of the ground: a suite is finite, and one mode neglects the others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import Protocol

import numpy as np

from assess.amplification import BaseMotion, FirstMode, ModalFilter
from assess.codes.asce43_05 import ASCE43_05_SPECTRUM, OF_CIRCOLARE
from assess.codes.calculation_sheet import Bound
from assess.codes.check import Check, Outcome, Reason, reason_message
from assess.codes.context import Building, Context, Gravity, Transfer, Wall, WallSupport
from assess.codes.procedures import apply_procedure, with_options
from assess.codes.question import MechanismChecks, Missing, Question, VerdictFacts, missing_input
from assess.codes.verdict import Verdict, add_falling_mechanisms, mark_deciding, verdict
from assess.geometry.planar import Outline
from assess.loads.load import Force, Load, Point, PointMass, upward
from assess.mechanisms.chain import Chain, virtual_work
from assess.mechanisms.hinge_forces import chain_at_start, hinge_forces, incipient_motion
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.mechanisms.mechanism import Mechanism, height_of_support, limits, multipliers_of_ties, open_seats
from assess.messages.message import Message, Quantity, Severity, Value, message
from assess.oscillator import BranchName, Oscillator
from assess.results import MechanismResult
from assess.results.fragility import HazardResult
from assess.risk.hazard import HazardCurve
from assess.study.amplification import NOT_AMPLIFIED, MechanismAmplification
from assess.study.histories import RockingHistories
from assess.study.mechanism_results import unsupported_messages
from assess.study.study import ScaledRecord, Study, may_follow_motion
from assess.study.tie_results import far_end_conditions
from records.record import Record, scale
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.floor import Mode, circolare2019_floor_spectrum, first_mode_factor
from spectra.gravity import g
from spectra.spectrum import Spectrum


def checks_of(study: Study, oscillator: Oscillator, context: Context) -> tuple[Check, ...]:
    """Return the checks of every procedure of the study, in its order.

    Checks of procedures that were only offered, not requested, are left out where they do not apply.
    """
    found: list[Check] = []
    for name in study.procedures:
        checks = apply_procedure(name, with_options(name, study.options), oscillator, context)
        found += (c for c in checks if name not in study.offered or c.verdict != Outcome.NOT_APPLICABLE)
    return tuple(found)


class WithChecks(Protocol):
    """A mechanism that has been checked, in results or alone."""

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def checks(self) -> tuple[Check, ...]:
        """The answers of every procedure."""


def decide(study: Study, mechanisms: Sequence[WithChecks], tolerance: Mapping[str, float] | None = None) -> Verdict:
    """Decide on the checks of the mechanisms.

    Parameters
    ----------
    study : that they are of
    mechanisms : with their checks
    tolerance : loss of index by the survey, by name
    """
    losses = tolerance or {}
    checked = [
        MechanismChecks(
            mechanism.name,
            mechanism.checks,
            *_facts_of(study, mechanism.name),
            losses.get(mechanism.name, 0.0),
            _provisional_of(study, mechanism.name),
        )
        for mechanism in mechanisms
    ]
    return add_falling_mechanisms(verdict(study.question, checked), study.falling)


CONTRADICTIONS: Mapping[str, str] = {
    "load-in-the-air": ".loads",
    "load-share-unsure": ".loads",
    "overburden-share-unsure": ".loads",
    "blocks-overlap": ".blocks",
    "blocks-apart": ".blocks",
    "blocks-beside": ".blocks",
    "gap": ".blocks",
}
"""Warnings that a drawing contradicts itself or can be read in two ways, each with the key that it concerns.

Nothing can be said of the mechanism until it is mended.
"""


def _facts_of(study: Study, name: str) -> VerdictFacts:
    """Return what a pass of a mechanism needs, where its drawing contradicts itself too, and its conditions."""
    missing, conditions = study.facts.get(name, ((), ()))
    mechanism = next((each for each in study.mechanisms if each.name == name), None)
    if mechanism is None:
        return missing, conditions
    wrong = (
        missing_input(f"mechanisms.{name}{CONTRADICTIONS[each.key]}", each, enlarges=True)
        for each in mechanism.warnings
        if each.key in CONTRADICTIONS
    )
    unheld, held = _support_at_top(study, mechanism)
    return (*missing, *wrong, *unheld), (*conditions, *held, *far_end_conditions(mechanism))


AT_TOP = 0.05  # of the height of a wall: a load or tie no farther below its top acts there


def _support_at_top(study: Study, mechanism: Mechanism) -> VerdictFacts:
    """Return whether something is missing to hold the top of a wall of two blocks, and else what its supports take.

    A floor of the building can hold it, or what acts on it there: a floor, a roof, a tie. Its foot is held by what it
    stands on, by friction or a floor there: nothing that is drawn tells.
    """
    if SUPPORTS[mechanism.kind] != "spanning" or mechanism.name not in study.heights:
        return (), ()
    top = study.heights[mechanism.name].base + mechanism.rise
    level = mechanism.positive.hinges[-1][1] - AT_TOP * mechanism.rise
    within_building = study.building is not None and top <= study.building.height * (1.0 + 1e-9)
    if not within_building and not any(load.at[1] >= level for load in mechanism.positive.loads):
        key = "building.height" if study.building is None else f"mechanisms.{mechanism.name}.loads"
        where: dict[str, Value] = {"mechanism": mechanism.name, "height": Quantity(top, "length", 3)}
        why = message("top-unheld", where, severity=Severity.WARNING)
        return (missing_input(key, why, 'height = "9 m"' if study.building is None else ""),), ()
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    starts = [incipient_motion(chain_at_start(chain, name=mechanism.name)) for chain in chains]
    force, foot = (max(abs(float(start.forces[end][0])) for start in starts) for end in (-1, 0))
    values: dict[str, Value] = {"mechanism": mechanism.name, "force": Quantity(force, "force", 3)}
    values |= {"foot": Quantity(foot, "force", 3)}
    return (), (message("top-held", values, severity=Severity.WARNING),)


def _provisional_of(study: Study, name: str) -> tuple[Missing, ...]:
    """Return what a provisional value stands for at the base of a mechanism, where its motion may decide."""
    found = study.amplified.get(name, NOT_AMPLIFIED)
    return found.missing if found.height and may_follow_motion(study.question) else ()


def mark_result(decided: Verdict, question: Question, result: MechanismResult) -> MechanismResult:
    """Return the mechanism with the checks that decide marked as such."""
    mechanism_verdict = next(each for each in decided.mechanisms if each.mechanism == result.name)
    return replace(result, checks=mark_deciding(result.checks, mechanism_verdict, question.basis, question.action))


OWN_HAZARD = "site.spectrum.hazard"  # key of that of an Italian site


def with_return_periods(result: MechanismResult, hazard: HazardResult | None) -> MechanismResult:
    """Return a mechanism with the return period of each capacity that the hazard of the site gives in PGA.

    That of an Italian site over return periods is with its checks already. Beyond the rows it is a bound.

    Parameters
    ----------
    result : the mechanism
    hazard : of the site; None where it is not known
    """
    if hazard is None or (hazard.measure.key, hazard.measure.at) != ("pga", "ground") or hazard.source == OWN_HAZARD:
        return result
    curve = HazardCurve(np.array(hazard.intensity), np.array(hazard.annual_rate))

    def dated(check: Check) -> Check:
        pga = check.capacity_pga_g
        if pga is None or pga <= 0.0 or check.return_period_years is not None:
            return check
        bound: Bound = "<=" if pga < hazard.intensity[0] else ">=" if pga > hazard.intensity[-1] else ""
        return replace(check, return_period_years=1.0 / float(curve.rate_at(pga)), return_period_bound=bound)

    return replace(result, checks=tuple(map(dated, result.checks)))


NEAR_SUPPORT = 0.9  # of the height of the supports: motion amplified only below it counts as that of the ground


def context_of(
    study: Study,
    spectrum: Spectrum,
    mechanism: Mechanism,
    base: tuple[BaseMotion, ...],
    motions: tuple[ScaledRecord, ...],
) -> Context:
    """Return what the procedures may know of one mechanism but for its time histories.

    Parameters
    ----------
    study : the study that the mechanism is part of
    spectrum : the site's elastic spectrum
    mechanism : the mechanism to be assessed
    base : every motion as it acts at the base of the mechanism
    motions : the same motions at the ground, with their factors

    Returns
    -------
    With a floor spectrum where the mechanism is above the ground.
    """
    context = _context_without_floor_spectrum(study, spectrum, mechanism, base)
    if not context.above_ground:
        return context
    amplification = study.amplified[mechanism.name].amplification
    by_mode = context.transfer == "by a filter" and not context.suite_faults.get(ASCE43_05_SPECTRUM.floor_suite_rules)
    floor = floor_spectrum(
        spectrum,
        height=context.support_height,
        filtered=amplification if by_mode and isinstance(amplification, ModalFilter) else None,
        base=base,
        motions=motions,
        building=study.building,
    )
    return replace(context, floor_spectrum=floor)


def with_histories(context: Context, histories: RockingHistories) -> Context:
    """Return the context of a mechanism with what its time histories gave.

    Parameters
    ----------
    context : without them
    histories : empty where no procedure needs them
    """
    rising = sorted((*histories.scan, *histories.suites), key=lambda suite: suite.pga) if histories.scan else ()
    return replace(context, suites=histories.suites, extra_suites=histories.further_suites, incremental=tuple(rising))


SUPPORTS: Mapping[str, WallSupport] = {name: kind.support for name, kind in MECHANISM_KINDS.items()}
JUST_ABOVE = 1e-3  # of the height: where the thickness of a wall that rocks to one side is measured


def wall_of(mechanism: Mechanism, *, on_masonry: bool = False) -> Wall | None:
    """Return the wall across its plane; None for mechanisms that are not walls, or without geometry.

    on_masonry : whether what is drawn below bears it from face to face

    The height is from the base hinge to the hinge at the top, or to the top of a free-standing wall. The thickness is
    the distance along the direction between the hinges of both branches, at the base, or the less of base and crack; of
    a wall that rocks to one side only, the width of its outline just above.
    """
    hinges, support = mechanism.positive.hinges, SUPPORTS[mechanism.kind]
    if support == "spanning":
        height = hinges[-1][1] - hinges[0][1]
        sizes = [_wall_across(mechanism, height=height, at=at) for at in (0, 1)]
        known = [size for size in sizes if size is not None]
        if not known:
            return None
        size = min(known, key=lambda each: each.thickness)
        return replace(size, gravity=gravity_of(mechanism, on_masonry=on_masonry))
    by_parameters = mechanism.kind == "equivalent-block"  # its outline only illustrates them
    if support != "free" or by_parameters or not mechanism.outlines[0]:
        return None
    top = max(z for ring in mechanism.outlines[0] for _, z in ring)
    return _wall_across(mechanism, height=top - hinges[0][1], at=0)


def carries_floors(mechanism: Mechanism) -> bool:
    """Return whether a floor, roof or vault presses on a mechanism or moves with it, bearing or not."""
    chain = mechanism.positive
    return any(isinstance(load, PointMass) or (upward(load) < 0.0 and not chain.level) for load in chain.loads)


def gravity_of(mechanism: Mechanism, *, on_masonry: bool = False) -> Mapping[BranchName, Gravity]:
    """Return the gravity moments of a wall and of the loads that press on it, by branch.

    on_masonry : whether what is drawn below bears it from face to face; else its base reaction is at mid-thickness
    """
    oscillator, middle = mechanism.variants.deciding, _middle_of_base(mechanism)
    gravity: dict[BranchName, Gravity] = {
        "positive": _seated_gravity(mechanism.positive, oscillator.positive.unstable, middle, on_masonry=on_masonry)
    }
    if mechanism.negative is not None and oscillator.negative is not None:
        mirrored = None if middle is None else -middle
        gravity["negative"] = _seated_gravity(
            mechanism.negative, oscillator.negative.unstable, mirrored, on_masonry=on_masonry
        )
    return gravity


LEAST_RECORDS = 5  # of the response-history method of the same standard
BROADENING = 0.15  # of the period, to both sides

SHORTEST_PERIOD, LONGEST_PERIOD = 0.02, 15.0  # s: between which the response to the motions is sampled
PERIOD_RATIO = 1.03  # of two periods at which it is
NEAR_MODE = np.linspace(0.85, 1.15, 61)  # of the building's period, where the peak is
PERIOD_VARIATION = np.linspace(1.0 - BROADENING, 1.0 + BROADENING, 7)  # of the building, over its own
MOST_DAMPING = 0.99  # of an oscillator that still swings
OF_SUITE = "envelope of the response spectra of the suite at the mechanism's base, peaks widened by 15 %"
DAMPING_OF_SUITE = "response of the motions themselves at that damping"
DAMPING_OF_CIRCOLARE = "Circolare 7/2019, C7.2.6, with the rule for damping of the spectrum of the ground"


def floor_spectrum(
    ground: Spectrum,
    *,
    height: float,
    filtered: ModalFilter | None,
    base: Sequence[BaseMotion],
    motions: Sequence[ScaledRecord],
    building: Building | None,
) -> Spectrum | None:
    """Return the floor spectrum at a height, at the PGA of the ground's spectrum.

    Parameters
    ----------
    ground : the spectrum of the ground
    height : height above the ground [m]
    filtered : the filter through which the motions reached the base, if they did and the suite meets the rules
    base, motions : the motions at the base, and their factors
    building : the building, with its height and storeys

    Returns
    -------
    None if neither the suite nor the building gives one.
    """
    if filtered is not None and len(motions) >= LEAST_RECORDS:
        records = [
            scale(base_motion.record, motion.scaling.factor) for base_motion, motion in zip(base, motions, strict=True)
        ]
        return _suite_spectrum(ground, records, mode=filtered.mode)
    if building is not None and building.storeys is not None and height <= building.height:
        return _circolare_spectrum(ground, height=height, building=building, storeys=building.storeys)
    return None


def broaden(period: FloatArray, acceleration: FloatArray) -> FloatArray:
    """Return the largest ordinate within 15 % of each period, to both sides [n]."""
    low = np.searchsorted(period, period * (1.0 - BROADENING), side="left")
    high = np.searchsorted(period, period / (1.0 - BROADENING), side="right")
    return np.array([acceleration[a:b].max() for a, b in zip(low, high, strict=True)])


def _context_without_floor_spectrum(
    study: Study, spectrum: Spectrum, mechanism: Mechanism, base: tuple[BaseMotion, ...]
) -> Context:
    height, rise, variants = study.heights[mechanism.name], height_of_support(mechanism), mechanism.variants
    amplified = study.amplified[mechanism.name]
    return Context(
        spectrum=spectrum,
        levels=study.levels,
        vertical_ratio=study.vertical_ratio,
        support=SUPPORTS[mechanism.kind],
        held=multipliers_of_ties(mechanism) if SUPPORTS[mechanism.kind] == "free" else {},
        carries_floors=carries_floors(mechanism),
        actions=tuple(load.name for load in mechanism.positive.loads if not isinstance(load, PointMass)),
        wall=wall_of(mechanism, on_masonry=study.on_masonry.get(mechanism.name, False)),
        elevation=height.base,
        rise=rise,
        building=study.building,
        histories_at="ground" if amplified.height is None else "mechanism base",
        transfer=_transfer_to_support(amplified, support=height.support),
        crushing=mechanism.crushing,
        starting=variants.starting,
        breaking=variants.breaking,
        limits=limits(mechanism),
        toothing=mechanism.toothing,
        open_seats=open_seats(mechanism),
        knowledge=study.knowledge.get(mechanism.name, {}),
        limit_state=study.limit_state if study.hazard is None else None,
        impossible=height.unknown,
        not_lasting=unsupported_messages(mechanism),
        suite_faults=study.suite_faults,
        impossible_by_histories=_reasons_against_histories(mechanism),
        rocks=mechanism.rocks,
        amplification=max((each.factor for each in base), default=1.0),
        linearised=study.equations[mechanism.name] == "linearised",
        hinges=hinge_forces(mechanism),
        hazard=study.hazard,
        free_period=study.free_periods.get(mechanism.name),
    )


def _transfer_to_support(amplified: MechanismAmplification, *, support: float) -> Transfer:
    """Return how the motion of the histories is amplified up to the `support` of a mechanism [m above the ground].

    Motion that is amplified only part of the way counts as that of the ground.
    """
    if amplified.height is None or amplified.height < NEAR_SUPPORT * support:
        return "not"
    return "by a filter" if isinstance(amplified.amplification, ModalFilter) else "by a factor"


def _reasons_against_histories(mechanism: Mechanism) -> tuple[Message, ...]:
    """Return why histories cannot assess the mechanism: the first impact would bring it to rest."""
    if mechanism.stopped is None:
        return ()
    return (reason_message(Reason.STOPS, restitution=Quantity(mechanism.stopped, figures=3)),)


def _middle_of_base(mechanism: Mechanism) -> float | None:
    """Return the place of mid-thickness at the base along the direction [m]; None without geometry."""
    outline = mechanism.outlines[0]
    base = mechanism.positive.hinges[0][1]
    height = max((z for ring in outline for _, z in ring), default=base) - base
    edges = [
        x for ring in outline for a, b in pairwise(ring) for x in _crossing_of_edge(a, b, base + JUST_ABOVE * height)
    ]
    return (min(edges) + max(edges)) / 2.0 if edges else None


def _seated_gravity(chain: Chain, instability: float, middle: float | None, *, on_masonry: bool) -> Gravity:
    """Return the gravity moments of one branch with its base reaction where the drawing bears it."""
    edge = _gravity_of_branch(chain, instability)
    (x, z), *others = chain.hinges
    if middle is None:
        return edge
    if on_masonry or x <= middle:
        return replace(edge, base_eccentricity=max(x - middle, 0.0))
    within = _gravity_of_branch(replace(chain, hinges=((middle, z), *others)), instability)
    return replace(
        within,
        edge_moment=edge.own_moment + edge.moment - within.own_moment - within.moment,
        edge_inertia=edge.own_inertia + edge.inertia - within.own_inertia - within.inertia,
    )


def _gravity_of_branch(chain: Chain, instability: float) -> Gravity:
    """Return the gravity moments of one branch, whose restoring moment falls to zero at `instability` [rad].

    Bearing masses and the vertical part of applied forces press; ties and horizontal forces are ignored.
    """
    pressing = tuple(pressed for load in chain.loads if (pressed := _pressing_part(load)) is not None)
    at = np.array([0.0, instability])
    own = virtual_work(replace(chain, loads=(), joints=()), at)
    both = virtual_work(replace(chain, loads=pressing, joints=()), at)
    weight = g * sum(block.mass for block in chain.blocks)
    return Gravity(
        overburden_ratio=sum(-upward(load) for load in pressing) / weight,
        own_moment=float(own.restoring[0]),
        moment=float(both.restoring[0] - own.restoring[0]),
        own_slope=float(own.restoring[0] - own.restoring[1]) / instability,
        own_inertia=float(own.inertia[0]),
        inertia=float(both.inertia[0] - own.inertia[0]),
        own_excitation=float(own.excitation[0]),
    )


def _pressing_part(load: Load) -> Load | None:
    """Return the part of a load that presses on the wall; None if there is none."""
    if upward(load) >= 0.0 or not isinstance(load, PointMass | Force):
        return None
    return load if isinstance(load, PointMass) else replace(load, force=(0.0, load.force[1]))


def _wall_across(mechanism: Mechanism, *, height: float, at: int) -> Wall | None:
    hinge = mechanism.positive.hinges[at]
    if mechanism.negative is not None:
        thickness = abs(hinge[0] + mechanism.negative.hinges[at][0])  # the negative chain is mirrored
    else:
        thickness = _width_at(mechanism.outlines[at], hinge[1] + JUST_ABOVE * height)
    return Wall(height, thickness) if height > 0.0 and thickness > 0.0 else None


def _width_at(rings: Outline, level: float) -> float:
    """Return the extent along x of closed rings at an elevation [m]; 0 if they do not reach it."""
    crossed = [x for ring in rings for a, b in pairwise(ring) for x in _crossing_of_edge(a, b, level)]
    return max(crossed) - min(crossed) if crossed else 0.0


def _crossing_of_edge(a: Point, b: Point, level: float) -> list[float]:
    if (a[1] - level) * (b[1] - level) > 0.0 or a[1] == b[1]:
        return []
    return [a[0] + (b[0] - a[0]) * (level - a[1]) / (b[1] - a[1])]


def _suite_spectrum(ground: Spectrum, records: Sequence[Record], *, mode: FirstMode) -> Spectrum:
    """Return the envelope of the response spectra at the base, with its peaks broadened.

    The response is computed once for each damping that a procedure uses.
    """
    periods = np.unique(np.concatenate(([0.0], _sample_periods(), NEAR_MODE / mode.frequency)))

    @lru_cache(maxsize=8)
    def broadened(damping: float) -> FloatArray:
        used_damping = min(damping, MOST_DAMPING)
        return broaden(
            periods, np.max([response_spectrum(record, periods, damping=used_damping) for record in records], axis=0)
        )

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T = np.asarray(period, dtype=np.float64)
        return np.maximum(np.interp(T, periods, broadened(damping)), ground.acceleration(T, damping=damping))

    parameters = {"records": float(len(records)), "first mode": 1.0 / mode.frequency}
    return Spectrum(
        "floor", parameters, ground.damping, DAMPING_OF_SUITE, ordinates, OF_SUITE, longest_period=ground.longest_period
    )


def _circolare_spectrum(ground: Spectrum, *, height: float, building: Building, storeys: int) -> Spectrum:
    """Return the spectrum of C7.2.5 at a height [m]: first mode linear over the height, envelope within 15 % of T_1."""
    share = first_mode_factor(storeys) * height / building.height
    modes = [Mode(building.period * factor, building.damping, share) for factor in PERIOD_VARIATION]

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T = np.asarray(period, dtype=np.float64)
        above = [circolare2019_floor_spectrum(T, spectrum=ground, modes=(mode,), damping=damping) for mode in modes]
        largest: FloatArray = np.maximum(np.max(above, axis=0), ground.acceleration(T, damping=damping))
        return largest

    parameters = {"T_1": building.period, "share of the mode": share}
    return Spectrum(
        "floor",
        parameters,
        ground.damping,
        DAMPING_OF_CIRCOLARE,
        ordinates,
        OF_CIRCOLARE,
        longest_period=ground.longest_period,
    )


def _sample_periods() -> FloatArray:
    count = int(np.ceil(np.log(LONGEST_PERIOD / SHORTEST_PERIOD) / np.log(PERIOD_RATIO))) + 1
    return np.geomspace(SHORTEST_PERIOD, LONGEST_PERIOD, count)
