"""One answer as its lines are read, from the table of its branch, the spectrum and the suites."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache

import numpy as np
from numpy.typing import ArrayLike
from scipy.constants import g
from scipy.interpolate import PPoly
from scipy.optimize import brentq

from assess.codes.calculation_sheet import Step
from assess.codes.context import Building
from assess.oscillator import Branch, HingeForces, interpolant
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum
from tests.support.subjects import Subject


@dataclass(frozen=True, eq=False)
class Same:
    """A branch as the key of what is made of it: equal where it is the very same."""

    branch: Branch

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and other.branch is self.branch

    def __hash__(self) -> int:
        return id(self.branch)


@cache
def spline_of(whose: Same, column: str) -> PPoly:
    """A column of a branch over rotation, made once: sheets read it for each of their lines."""
    return interpolant(whose.branch.rotation, getattr(whose.branch, column))


@dataclass
class Sheet:
    """One answer as its lines are read, with what those before have come to."""

    subject: Subject
    known: dict[str, float | None] = field(default_factory=dict)
    step: Step | None = None

    @property
    def level(self) -> float:
        """PGA [m/s2]."""
        return self.subject.check.level_pga_g * g

    @property
    def spectrum(self) -> Spectrum:
        """The site's, or that of the limit state where the site gives its hazard."""
        context = self.subject.context
        own = None if context.hazard is None else context.hazard.spectra.get(self.subject.check.limit_state)
        italian = self.subject.check.procedure.startswith(("dmi", "ntc"))
        return own if own is not None and italian else context.spectrum

    @property
    def pga(self) -> float:
        """Of the limit state at the level [m/s2]."""
        return self.known.get(f"PGA_{self.subject.check.limit_state}") or self.level

    @property
    def scale(self) -> float:
        """The PGA over the spectrum's own."""
        return self.pga / self.spectrum.pga

    @property
    def house(self) -> Building:
        """What stands below the mechanism."""
        assert self.subject.context.building is not None
        return self.subject.context.building

    @property
    def mass(self) -> float:
        return self.subject.rocker.mass

    def rest(self, column: str) -> float:
        """A column of the branch at rest."""
        return float(getattr(self.subject.branch, column)[0])

    def spline(self, column: str) -> PPoly:
        """A column of the branch over rotation, between its kinks."""
        return spline_of(Same(self.subject.branch), column)

    def instability(self) -> float:
        """Where the restoring moment falls to zero [rad]."""
        branch = self.subject.branch
        last = int(np.flatnonzero(branch.restoring > 0.0)[-1])
        return float(brentq(self.spline("restoring"), branch.rotation[last], branch.rotation[last + 1], xtol=1e-15))

    def moved(self, rotation: float) -> float:
        """The integral of B up to a rotation [kg m]."""
        return float(self.spline("excitation").integrate(0.0, rotation))

    def rotation_of(self, moved: float) -> float:
        """Where d* is so large [rad]."""
        top = self.subject.branch.rotation[-1]
        return float(brentq(lambda phi: self.moved(phi) / self.mass / self.e - moved, 0.0, top, xtol=1e-14))

    @property
    def e(self) -> float:
        """e* [-]."""
        return self.rest("excitation") ** 2 / self.rest("participation") / self.mass

    def multiplier(self, rotation: float) -> float:
        return float(self.spline("restoring")(rotation) / self.spline("excitation")(rotation) / g)

    def mode_damping(self, symbol: str) -> float:
        """Of the building's first mode: elastic 5 %, softened 10 % or as stated [-]."""
        if symbol == "T1" or self.subject.check.procedure.endswith("-linear"):
            return 0.05
        stated = self.house.limit_states.get(self.subject.check.limit_state)
        return 0.10 if stated is None else stated.damping

    def ordinate(self, period: float, damping: float = 0.05) -> float:
        """Of the site's spectrum at the level [m/s2]."""
        return float(self.ordinates(period, damping))

    def ordinates(self, period: ArrayLike, damping: float) -> FloatArray:
        """Those of the site's spectrum at the level, at several periods [n] [m/s2]."""
        return np.asarray(self.spectrum.acceleration(period, damping=damping) * self.scale)

    def over_pga(self, period: float, damping: float) -> float:
        """The ordinate of the motion at the base over the PGA of the ground."""
        floor = self.subject.context.floor_spectrum if self.subject.context.above_ground else None
        own = self.subject.check.procedure == "asce43-05-spectrum" and floor is not None
        spectrum = self.subject.context.spectrum
        return float((floor if own else spectrum).acceleration(period, damping=damping)) / spectrum.pga

    def curve(self, rotation: float) -> float:
        """PGA over rotation of the answer [g]."""
        curve = self.subject.check.pga_curve
        over = rotation / self.subject.branch.overturning
        return float(np.interp(over, curve.rotation_ratio, curve.pga_g))

    @property
    def suite(self) -> tuple[float | None, ...]:
        """Largest rotations over the overturning rotation at the level."""
        suites = self.subject.context.suites
        return min(suites, key=lambda suite: abs(suite.pga - self.pga)).ratio

    def hinge(self) -> HingeForces:
        """That whose letter the line bears, else that whose V the sheet has."""
        names = {each.hinge: each for each in self.subject.context.hinges}
        own = self.step.symbol.partition("_")[2]
        main = next(each.symbol[2:] for each in self.subject.check.steps if each.symbol.startswith("V_"))
        return names.get(own) or names[main]
