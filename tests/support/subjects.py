"""Mechanisms that every procedure is asked of, on the ground and in a building, for tests of calculation sheets."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from math import inf

import numpy as np
from scipy.constants import g

from assess.codes.asce41_13 import Asce41Options
from assess.codes.asce43_05 import Asce4305Options
from assess.codes.check import Check, branch_of
from assess.codes.context import Building, Context, FreePeriod, SiteHazard, StatedFirstMode
from assess.codes.histories import SuiteResponse
from assess.codes.ntc2018_clauses import FreeElement, free_period
from assess.codes.procedures import CodeOptions, with_options
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import PointMass
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Face, Mechanism
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.oscillator import Branch, LocalLimit, Oscillator
from assess.study.checks import SUPPORTS, wall_of
from spectra.asce7 import design_spectrum
from spectra.ec8 import elastic_spectrum as ec8_spectrum
from spectra.spectrum import Spectrum
from tests.support.answered import suite_of_runs
from tests.support.bodies import planar_box

LEVELS = tuple(level * g for level in (0.05, 0.2, 0.6))
RUNS = np.array([1.0, 1.4, 0.9, 1.2, 0.7, 1.0, 1.1, 1.0, 0.95])  # of each record, over the ratio of the first


def suite(level: float, *ratios: float | None) -> SuiteResponse:
    """Records with their twins, those of one that overturns overturn as well."""
    return suite_of_runs(level, RUNS[:, None] * np.array([inf if each is None else each for each in ratios]))


SUITES = tuple(
    suite(level, 0.01, 0.02, share, 0.2, 0.3, 0.1, 0.15) for level, share in zip(LEVELS, (0.1, 0.9, None), strict=True)
)
HOUSE = Building(height=8.0, storeys=2, period=0.24, damping=0.05)
SPECTRUM = design_spectrum(s_ds=0.5 * g, s_d1=0.25 * g, t_l=6.0)
VERTICAL, FRICTION, SLIDING, AMPLIFIED, S_X1 = 0.5, 0.3, 0.02, 1.5, 0.3
OPTIONS = CodeOptions(
    asce43_05=Asce4305Options(allowable_sliding=SLIDING), asce41_13=Asce41Options(masonry="coursed", s_x1=S_X1 * g)
)


@dataclass(frozen=True)
class Subject:
    """One answer, and all that it was made from."""

    mechanism: Mechanism
    context: Context
    rocker: Oscillator
    check: Check

    @property
    def branch(self) -> Branch:
        """That of the answer."""
        return branch_of(self.rocker, self.check.branch)


def mechanisms() -> Iterator[Mechanism]:
    """A wall between floors with a load on its top, a parapet, a slender one, and one that slides."""
    load = PointMass("roof", mass=900.0, at=(0.02, 6.0), block=1, bearing=True)
    yield two_block("spanning", planar_box(0.28, 2.0, base=2.0), planar_box(0.28, 2.0, base=4.0), loads=(load,))
    yield single_block("parapet", planar_box(0.3, 1.0, base=8.0))
    yield single_block("slender", planar_box(0.45, 4.0))
    beside = PointMass("beside", mass=400.0, at=(0.0, 0.5), bearing=False)
    yield single_block("squat", planar_box(0.8, 1.0), loads=(beside,))


def on_a_joint(base: float) -> Mechanism:
    """A wall on a flexible joint: it has no threshold, and a period before it rocks."""
    rigid = single_block("on a joint", planar_box(0.5, 3.0, base=base))
    joint = (Joint((-1.0, 0.0), rectangle(0.5, 1.0), JointLaw(1e9, inf), "flexible"),)
    return add_joints(rigid, joint, joint, restitution=(0.9, 0.9))


def special() -> Iterator[tuple[Mechanism, Context]]:
    """What few sheets have: joints, no building, no rebound, hazards, ends of actions, seats, given periods."""
    slender = facing(single_block("slender", planar_box(0.45, 4.0)))
    high = facing(single_block("high", planar_box(0.3, 4.0, base=4.0), restitution=(0.0, 0.0)))
    tall = facing(single_block("tall", planar_box(7.5, 200.0)))
    fallen = tuple(replace(each, ratio=(None,) * 7, twins=None) for each in SUITES)
    bare = replace(context_of(slender, None), building=None, suites=fallen, incremental=())
    yield slender, bare
    yield slender, replace(bare, elevation=0.2, hinges=tuple(replace(each, friction=None) for each in bare.hinges))
    for base in (0.0, 6.0):
        jointed = facing(on_a_joint(base))
        yield jointed, context_of(jointed, None)
    stated = {"SLV": StatedFirstMode(0.5, 0.08, "by a model"), "SLC": StatedFirstMode(0.55, 0.09, "by a model")}
    spectra = {state: replace(SPECTRUM, factor=share) for state, share in (("SLD", 0.4), ("SLV", 1.0), ("SLC", 1.3))}
    hazard = SiteHazard(spectra, (50.0, 475.0, 975.0), tuple(each.pga for each in spectra.values()))
    formed = free_period(FreeElement(length=4.0, thickness=0.3, young_modulus=7e8, density=1800.0))
    for period, first in ((0.45, 0.24), (3.0, 0.24), (0.9, 0.5)):
        soft = replace(HOUSE, period=first)
        yield high, replace(context_of(high, None), building=soft, free_period=FreePeriod(period))
    yield (
        high,
        replace(
            context_of(high, None),
            building=replace(HOUSE, limit_states=stated),
            hazard=hazard,
            limits=(LocalLimit("break", "tie 1", "positive", 0.03), LocalLimit("seat", "floor", "negative", 0.02)),
            breaking=ending(high.oscillator),
            free_period=formed,
        ),
    )
    far = ec8_spectrum(a_g=0.25 * g, ground_type="C", spectrum_type=1)
    yield tall, replace(context_of(tall, None), spectrum=far)


def ending(rocker: Oscillator) -> Oscillator:
    """The same with three times the moment up to a tie's end at 0.03 rad."""
    sides = []
    for side in rocker.branches:
        held = np.where(side.rotation <= 0.03, 3.0, 1.0) * side.restoring
        at = int(np.searchsorted(side.rotation, 0.03, side="right"))
        columns = {name: np.insert(getattr(side, name), at, getattr(side, name)[at - 1])
                   for name in ("rotation", "inertia", "excitation", "participation", "lift")}  # fmt: skip
        sides.append(replace(side, **columns, restoring=np.insert(held, at, side.restoring[at - 1])))
    return replace(rocker, positive=sides[0], negative=sides[1])


def facing(mechanism: Mechanism) -> Mechanism:
    """With friction at all its hinges."""
    count = len(mechanism.positive.hinges)
    return replace(mechanism, faces=((Face(friction=FRICTION),) * count,) * 2)


def contexts() -> Iterator[tuple[Mechanism, Context]]:
    """Each mechanism on the ground's motion, and in a building whose floor has a spectrum of its own."""
    floor = replace(SPECTRUM, factor=2.0, code="floor")
    for mechanism in mechanisms():
        stands = facing(mechanism)
        for above in (None, floor):
            yield stands, context_of(stands, above)


def context_of(mechanism: Mechanism, floor: Spectrum | None) -> Context:
    return Context(
        SPECTRUM,
        LEVELS,
        VERTICAL,
        mechanism.elevation,
        HOUSE,
        SUITES,
        SUITES,
        support=SUPPORTS[mechanism.kind],
        wall=wall_of(mechanism),
        rise=mechanism.rise,
        hinges=hinge_forces(mechanism),
        floor_spectrum=floor,
        amplification=AMPLIFIED,
        crushing=True,  # with LC3 the Italian FC is 1, so that the suites of the levels serve
        knowledge={"dmi2008": "LC3", "ntc2018": "LC3"},
    )


@cache
def subjects(name: str) -> tuple[Subject, ...]:
    """The answers of a procedure; the thesis' readings put a plain block in the place of what is on joints."""
    every = listed(contexts) + (listed(special) if not name.endswith("-thesis") else ())
    return tuple(
        Subject(mechanism, context, mechanism.oscillator, check)
        for mechanism, context in every
        for check in with_options(name, OPTIONS)(mechanism.oscillator, context)
    )


@cache
def listed(of: Callable[[], Iterator[tuple[Mechanism, Context]]]) -> tuple[tuple[Mechanism, Context], ...]:
    """Mechanisms with their contexts, made once."""
    return tuple(of())
