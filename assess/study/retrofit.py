"""The least works that make a building reach a target, found on a part of the records and proved on the rest.

A layout is proved where it reaches the target on records that the search did not see, each with its twins, and again
with area, length, height and yield stress of its ties 10 % more and less, together and alone. The share of records that
overturn is known no better than their number allows, so what counts is the upper end of its one-sided interval of 84 %
(Clopper and Pearson 1934): 0 of 50 records is 0.036, 1 of 50 is 0.064. A record overturns if it or one of its twins
does. Ratios are those of the largest rotation to the one that overturns the mechanism without its ties.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from math import inf
from typing import Protocol

import numpy as np

from assess.amplification import Amplification, BaseMotion, base_motion
from assess.codes.bases import IndexKind
from assess.codes.procedures import uses_histories
from assess.dynamics.history import Jobs, make_solver
from assess.dynamics.packing import Equation
from assess.errors import AssessError, ProjectError
from assess.messages.message import message
from assess.oscillator import Memory, Oscillator, TieLaw
from assess.results.retrofit import CONFIDENCE, Layout, Place, Proof, Reached, Target, Tolerance, Trial
from assess.study import level_peaks
from assess.study.assessment import building_states, on_building
from assess.study.histories import rocking_case
from assess.study.level_peaks import (
    RockingCase,
    rotation_of_ratio_one,
    run_variants,
    with_restitution_factor,
)
from assess.study.retrofit_search import FULL, merit, search_grid
from assess.study.run import find_state_verdict
from assess.study.study import Progress, ScaledRecord, Study, no_progress
from records.record import Record
from spectra.arrays import FloatArray

TENTH = 0.10
MOST_TRIES = 50
MOST_PROOFS = 10  # of a share, on the same records
TOGETHER = 4  # tolerances that are run in one call
BATCH = 50  # layouts whose histories are packed together


AS_DRAWN = Tolerance()


def tolerances() -> tuple[Tolerance, ...]:
    """Return the ties as drawn, then all corners of the tolerances, both extremes first, then each alone."""
    ends = (1.0 - TENTH, 1.0 + TENTH)
    corners = [Tolerance(*each) for each in product(ends, repeat=4)]
    alone = [replace(AS_DRAWN, **{key: end}) for key in ("area", "length", "height", "yield_stress") for end in ends]
    return (AS_DRAWN, corners[0], corners[-1], *corners[1:-1], *alone)


class Design(Protocol):
    """A layout of works on a project.

    layout : not examined yet, or refused; has_ties : whether tolerances of ties change anything
    """

    @property
    def layout(self) -> Layout: ...

    @property
    def has_ties(self) -> bool: ...

    def study(self, tolerance: Tolerance) -> Study:
        """Return the study of the mechanisms that the works change."""


class Designs(Protocol):
    """Layouts of works on a project.

    sizes : number of values on each axis
    """

    @property
    def sizes(self) -> tuple[int, ...]: ...

    def design(self, place: Place) -> Design:
        """Return the layout at a place of the grid."""


Measure = Callable[[Sequence[Study]], Sequence[Reached]]


@dataclass(frozen=True)
class Measures:
    """What measures studies.

    search : on the records of the search
    proof : on all others, as they are and with twins, for a number of layouts that may be put to the proof; None where
        the target has no records, and what is found in the search stands
    most : how many of a number of candidates may be
    spread : whether these are taken from as many parts of the candidates, the least of each: few that are alike would
        fall short under the same records
    """

    search: Measure
    proof: Callable[[int], tuple[Measure, Measure]] | None = None
    most: Callable[[int], int] = lambda candidates: min(candidates, MOST_TRIES)
    spread: bool = False


@dataclass(frozen=True)
class Found:
    """What a search found.

    layouts : that were examined or refused, in the order of the grid
    best : the least that is proved; None where none is
    nearest : the best of those examined; proofs : of `best`, else of the last that was tried, up to its failure
    tried : how many were put to the proof, of `most` that might be
    candidates : how many reached the target on the records of the search
    failed : those that fell short, in the proof or with a tolerance before it, each with the tolerance that showed it
    """

    layouts: tuple[Layout, ...]
    best: Layout | None
    nearest: Layout | None
    proofs: tuple[Proof, ...]
    tried: int
    most: int
    candidates: int
    failed: tuple[Trial, ...] = ()


def find_least(
    designs: Designs, target: Target, measures: Measures, *, progress: Progress = no_progress, full: int = FULL
) -> Found:
    """Return the least layout that reaches a target and is proved.

    A layout is put to the proof only where it holds with all tolerances on the records of the search, which may choose
    among layouts as they like; those of the proof choose among few.

    Parameters
    ----------
    designs : the layouts
    target : to be reached
    measures : of studies, on the records of the search and of the proof
    progress : called as layouts are examined
    full : layouts up to which the whole grid is examined
    """

    def examine(places: Sequence[Place]) -> list[Layout]:
        return _examined(places, designs, measures.search, progress)

    known = search_grid(designs.sizes, examine, target, full=full)
    ranked = sorted(known.values(), key=lambda each: merit(each, target))
    candidates = [each for each in ranked if each.reached is not None and target.may_hold(each.reached)]
    most = measures.most(len(candidates))
    looks: list[tuple[Measure, Callable[[Reached], bool]]] = [(measures.search, target.may_hold)]
    if measures.proof is not None:
        looks += [(measure, target.holds) for measure in measures.proof(most)]
    order, tried = list(tolerances()), 0
    best: Layout | None = None
    proofs: tuple[Proof, ...] = ()
    failed: list[Trial] = []
    parts_done = 0
    for place, layout in enumerate(candidates):
        part = place * most // len(candidates)
        if measures.spread and part < parts_done:
            continue
        if len(failed) == MOST_TRIES:
            break
        progress("proof", len(failed), min(len(candidates), MOST_TRIES))
        design = designs.design(layout.place)
        build = cache(design.study)
        for number, (measure, holds) in enumerate(looks):
            if number == min(1, len(looks) - 1):
                tried, parts_done = tried + 1, part + 1
            proofs = prove(build, order if design.has_ties else [AS_DRAWN], measure, holds)
            if not proofs[-1].holds:
                break
        if proofs[-1].holds:
            best = layout
            break
        failed.append(Trial(layout, proofs[-1]))
        order.sort(key=lambda each: each != proofs[-1].tolerance)  # it may well be the one that fails the next
        if tried == most:
            break
    nearest = best or next((each for each in ranked if each.reached is not None), None)
    every = tolerances()
    proofs = tuple(sorted(proofs, key=lambda proof: every.index(proof.tolerance)))
    return Found(_in_order(known), best, nearest, proofs, tried, most, len(candidates), tuple(failed))


def prove(
    build: Callable[[Tolerance], Study], order: Sequence[Tolerance], measure: Measure, holds: Callable[[Reached], bool]
) -> tuple[Proof, ...]:
    """Return what a layout reaches with every tolerance, up to the first with which it does not reach the target.

    Parameters
    ----------
    build : returns the study of the layout with a tolerance
    order : the tolerances, those that may fail it first
    measure : of studies
    holds : whether what is reached will do
    """
    found: list[Proof] = []
    for first in range(0, len(order), TOGETHER):
        studies: dict[Tolerance, Study] = {}
        refused: Proof | None = None
        for each in order[first : first + TOGETHER]:
            try:
                studies[each] = build(each)
            except AssessError as error:
                why = message("retrofit-not-built", {"error": str(error)})
                refused = Proof(each, Reached(None), False, why)
                break
        for each, reached in zip(studies, measure(list(studies.values())) if studies else (), strict=True):
            found.append(Proof(each, reached, holds(reached)))
            if not found[-1].holds:
                return tuple(found)
        if refused is not None:
            return (*found, refused)
    return tuple(found)


def most_proofs(records: int, reach: float, candidates: int) -> int:
    """Return how many layouts may be put to the proof on the same records.

    Each then counts at a confidence of 1 - 0.16 / n (Bonferroni), so that the one that is chosen has its share at 84 %
    whatever led to it; with more, not even records of which none overturns could show that share.

    Parameters
    ----------
    records : of the proof
    reach : the share to be shown [-]
    candidates : that reach the target in the search
    """
    shown = (1.0 - CONFIDENCE) / (1.0 - reach) ** records
    return max(1, int(min(MOST_PROOFS, candidates, shown + 1e-9)))


def upper_share(overturned: int, number: int, *, confidence: float = CONFIDENCE) -> float:
    """Return the upper end of the one-sided interval of a share (Clopper and Pearson, Biometrika 26, 1934) [-].

    Parameters
    ----------
    overturned : how many of a number, all alike and independent
    number : of records
    confidence : of the interval [-]
    """
    if overturned >= number:
        return 1.0
    from scipy.special import betaincinv

    return float(betaincinv(overturned + 1.0, number - overturned, confidence))


def measure_index(studies: Sequence[Study]) -> list[Reached]:
    """Return the index by which the basis decides, the worst of the mechanisms of each study."""
    return [Reached(_index_of(study)) for study in studies]


def measure_histories(
    target: Target,
    motions: Sequence[ScaledRecord],
    *,
    pga: float,
    site_pga: float,
    twins: bool,
    threads: int,
    confidence: float = CONFIDENCE,
) -> Measure:
    """Return what measures studies by histories: the largest ratio, or the upper end of the share that overturns.

    Parameters
    ----------
    target : "ratio" or "probability"
    motions : records with their factors
    pga : of the action [m/s2]; site_pga : that the factors refer to [m/s2]
    twins : whether each record is run with its twins
    threads : 0 for all cores
    confidence : of the interval of a share [-]
    """

    def measure(studies: Sequence[Study]) -> list[Reached]:
        ratios = record_ratios(studies, motions, share=pga / site_pga, twins=twins, threads=threads)
        found = []
        for each in ratios.max(axis=2, initial=0.0):
            overturned = int(np.isinf(each).sum())
            share = target.kind == "probability"
            value = upper_share(overturned, each.size, confidence=confidence) if share else float(each.max())
            found.append(Reached(value, overturned))
        return found

    return measure


def record_ratios(
    studies: Sequence[Study], motions: Sequence[ScaledRecord], *, share: float, twins: bool, threads: int
) -> FloatArray:
    """Return the largest rotation over the one that overturns, inf where it does [studies, records, runs] [-].

    Of several mechanisms, states of the building, rebounds, polarities and actions not shown to last the worst counts.
    The histories of all studies are packed into one call of the solver, by equation, and a ground motion is carried up
    the building once for all that stand on it alike.

    Parameters
    ----------
    studies : with the mechanisms that rock
    motions : records with their factors
    share : of the PGA that these refer to [-]
    twins : whether each record is run with its twins
    threads : 0 for all cores
    """
    runs = level_peaks.TWIN_FACTORS if twins else np.ones(1)
    worst = np.zeros((len(studies), len(motions), runs.size))
    scales = share * np.array([motion.scaling.factor for motion in motions])[:, None] * runs
    packs: dict[tuple[Equation, bool], _Pack] = {}
    known: dict[tuple[Amplification, int], BaseMotion] = {}

    def at_base(amplification: Amplification, record: Record) -> BaseMotion:
        key = (amplification, id(record))
        return known.get(key) or known.setdefault(key, base_motion(amplification, record))

    for number, study in enumerate(studies):
        for case in _cases_of(study, motions, at_base):
            held = any(each.memory is not None for each in (case.oscillator, *case.others))
            packs.setdefault((case.equation, held), _Pack()).add(number, case)
    for (equation, _), pack in packs.items():
        pack.solve(worst, scales, equation=equation, threads=threads)
    return worst


class _Pack:
    """Oscillators and ground motions of one call of the solver, and the jobs of each."""

    def __init__(self) -> None:
        self.oscillators: list[Oscillator] = []
        self.ratio_one: list[tuple[float, float]] = []
        self.records: dict[int, tuple[int, Record]] = {}
        self.variants: list[tuple[int, int, float, tuple[int, ...]]] = []

    def add(self, study: int, case: RockingCase) -> None:
        """Add the oscillators of a case, and a row for each variant: study, oscillator, polarity, ground motions."""
        ground = tuple(
            self.records.setdefault(id(each.record), (len(self.records), each.record))[0] for each in case.base
        )
        polarity, numbers = run_variants(case)
        first, every = len(self.oscillators), (case.oscillator, *case.others)
        self.variants += [
            (study, first + int(number), float(sign), ground) for sign, number in zip(polarity, numbers, strict=True)
        ]
        ends = [
            [rotation_of_ratio_one(branch, case.equation) for branch in (each.branches[0], each.branches[-1])]
            for each in every
        ]
        for each, own in zip(every, ends, strict=True):
            factors = (own[0] / ends[0][0], own[1] / ends[0][1])
            self.oscillators += [_merged(with_restitution_factor(each, rebound)) for rebound in case.rebounds]
            self.ratio_one += [factors] * len(case.rebounds)

    def solve(self, worst: FloatArray, scales: FloatArray, *, equation: Equation, threads: int) -> None:
        """Raise `worst` [studies, records, runs] by the histories of all variants; scales : [records, runs]."""
        study, oscillator, sign = (np.array(column) for column in list(zip(*self.variants, strict=True))[:3])
        ground = np.array([variant[3] for variant in self.variants])
        shape = (study.size, *scales.shape)
        jobs = Jobs(
            np.broadcast_to(oscillator[:, None, None], shape).ravel(),
            np.broadcast_to(ground[:, :, None], shape).ravel(),
            (sign[:, None, None] * scales).ravel(),
        )
        records = [record for _, record in self.records.values()]
        peaks = make_solver(self.oscillators, records, equation=equation, threads=threads)(jobs)
        factor = np.array(self.ratio_one)[jobs.oscillator, (peaks.max_rotation < 0.0).astype(np.int64)]
        ratio = np.where(peaks.overturned, inf, peaks.max_ratio * factor)
        np.maximum.at(worst, study, ratio.reshape(shape))


def _cases_of(
    study: Study, motions: Sequence[ScaledRecord], at_base: Callable[[Amplification, Record], BaseMotion]
) -> Iterator[RockingCase]:
    """Yield what the histories of each mechanism are run for, in every state of the building."""
    basis = study.question.basis
    methods = () if basis is None else basis.methods
    asked = replace(study, procedures=tuple(name for name in methods if uses_histories(name)))
    for mechanism in study.mechanisms:
        states = building_states(asked, mechanism.name)
        for state in states:
            there = on_building(asked, mechanism.name, state, among=states)
            yield rocking_case(there, mechanism, tuple(motions), at_base=at_base)


def _merged(oscillator: Oscillator) -> Oscillator:
    """Return an oscillator on which ties that are always pulled alike are one, which takes less time and pulls as much.

    Those are ties at one height and angle, with one strain at yield and at rupture.
    """
    memory = oscillator.memory
    if memory is None or len(memory.ties) < 2:
        return oscillator
    kept: list[TieLaw] = []
    for tie in memory.ties:
        place = next((number for number, other in enumerate(kept) if _alike(tie, other)), None)
        if place is None:
            kept.append(tie)
        else:
            one = kept[place]
            kept[place] = replace(one, stiffness=one.stiffness + tie.stiffness, strength=one.strength + tie.strength)
    return replace(oscillator, memory=Memory(memory.bare, tuple(kept), memory.friction))


def _alike(one: TieLaw, other: TieLaw) -> bool:
    first, second = ((each.strength / each.stiffness, each.gone) for each in (one, other))
    if not np.allclose(first, second, rtol=1e-12, atol=0.0):
        return False
    sides = zip((*one.elongation, *one.rate), (*other.elongation, *other.rate), strict=True)
    return all(np.allclose(a, b, rtol=1e-9, atol=1e-12) for a, b in sides)


def split_by_event(motions: Sequence[ScaledRecord], number: int | None = None) -> tuple[list[int], list[int]]:
    """Return which records the search sees, and which prove what it finds: every second event, or a number of records.

    Records of one event are on one side.

    Parameters
    ----------
    motions : the suite; a record without an event is one of its own
    number : of records for the search, about; every second event where None

    Raises
    ------
    ProjectError : there are fewer than two events, or none would be left on one side
    """
    events: dict[str, list[int]] = {}
    for place, motion in enumerate(motions):
        events.setdefault(motion.record.event.casefold() or f"\0{place}", []).append(place)
    groups = list(events.values())
    chosen = range(0, len(groups), 2)
    if number is not None:
        wanted = min(max(1, round(number * len(groups) / max(1, len(motions)))), len(groups))
        chosen = np.unique(np.linspace(0, len(groups) - 1, wanted).round().astype(int)).tolist()
    seen = sorted(place for group in chosen for place in groups[group]) if groups else []
    left = [place for place in range(len(motions)) if place not in set(seen)]
    if not seen or not left:
        raise ProjectError(
            f"records: {len(motions)} of {len(groups)} events: a part of them is to find a layout, and the rest to "
            "prove it; give records of more events, or another number of records for the search"
        )
    return seen, left


def _index_of(study: Study) -> float | None:
    """Return the worst index of the mechanisms of a study; None where one is not known."""
    indices = [answer.index for each in find_state_verdict(study).mechanisms for answer in each.answers]
    known = [index for index in indices if index is not None]
    if not known or len(known) < len(indices):
        return None
    least = known[0].name != IndexKind.DEMAND_CAPACITY
    return min(each.value for each in known) if least else max(each.value for each in known)


def _examined(places: Sequence[Place], designs: Designs, measure: Measure, progress: Progress) -> list[Layout]:
    """Return layouts with what they reach; one that cannot be built is refused.

    Histories of a batch run while the next is built: the solver does not hold the interpreter's lock.
    """
    found: dict[Place, Layout] = {}
    with ThreadPoolExecutor(1) as pool:
        running: list[tuple[list[Place], Future[Sequence[Reached]]]] = []
        try:
            for first in range(0, len(places), BATCH):
                progress("layouts", first, len(places))
                studies: dict[Place, Study] = {}
                for place in places[first : first + BATCH]:
                    design = designs.design(place)
                    found[place] = design.layout
                    if design.layout.refused is None:
                        try:
                            studies[place] = design.study(AS_DRAWN)
                        except AssessError as error:
                            refused = message("retrofit-not-built", {"error": str(error)})
                            found[place] = replace(design.layout, refused=refused)
                running.append((list(studies), pool.submit(measure, list(studies.values()))))
            for batch, answer in running:
                for place, reached in zip(batch, answer.result(), strict=True):
                    found[place] = replace(found[place], reached=reached)
        finally:
            pool.shutdown(cancel_futures=True)
    return [found[place] for place in places]


def _in_order(known: dict[Place, Layout]) -> tuple[Layout, ...]:
    return tuple(known[place] for place in sorted(known))
