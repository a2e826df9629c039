"""The curves of one mechanism as a screen draws them: points, and what the axes measure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.codes.check import Check
from assess.results import EnvelopeResult, MechanismResult
from spectra.arrays import FloatArray

CAPACITY, PGA, ENVELOPE = "Capacity curve", "PGA and rotation", "Overturning envelope"
COLOUR = "#0072b2"


@dataclass(frozen=True)
class Curve:
    """A curve to be drawn: what its axes measure with their units, and its points [n], rising along x."""

    across: str
    along: str
    x: FloatArray
    y: FloatArray

    @property
    def series(self) -> tuple[dict[str, object], ...]:
        """The axes as the library that draws wants them."""
        return {"label": self.across}, {"label": self.along, "stroke": COLOUR, "width": 2}

    @property
    def data(self) -> tuple[FloatArray, FloatArray]:
        """The points; two of nothing where there are none, as the library draws no empty curve."""
        return (self.x, self.y) if self.x.size else (np.zeros(2), np.full(2, np.nan))


def capacity(result: MechanismResult | None) -> Curve:
    """Return restoring moment over rotation of both branches, the negative one mirrored back."""
    points = [] if result is None else [(1.0, result.curve.positive), (-1.0, result.curve.negative)]
    known = [(sign, branch) for sign, branch in points if branch is not None]
    rotation = [sign * np.array(branch.rotation_rad) for sign, branch in known]
    moment = [sign * np.array(branch.restoring_n_m) / 1e3 for sign, branch in known]
    return _rising("rotation [rad]", "restoring moment [kN m]", rotation, moment)


def pga(checks: tuple[Check, ...]) -> Curve:
    """Return the peak ground acceleration that takes the mechanism to a rotation, by the first check that has it."""
    check = next((each for each in sorted(checks, key=_rank) if each.pga_curve.pga_g), None)
    points = ([], []) if check is None else (check.pga_curve.rotation_ratio, check.pga_curve.pga_g)
    by = "" if check is None else f", {check.procedure}"
    ratio, acceleration = ([np.array(each, dtype=np.float64)] for each in points)
    return _rising("rotation / overturning rotation [-]", f"PGA [g]{by}", ratio, acceleration)


def envelope(found: EnvelopeResult | None) -> Curve:
    """Return the least amplitude of a pulse that overturns, by its frequency."""
    frequency = [] if found is None else found.frequency_hz
    least = [] if found is None else [np.nan if each is None else each for each in found.lower_bound_g]
    shape = "" if found is None else f" of a {found.shape} pulse"
    return _rising(f"frequency{shape} [Hz]", "overturns from [g]", [np.array(frequency)], [np.array(least)])


def _rank(check: Check) -> bool:
    return check.role != "deciding"


def _rising(across: str, along: str, x: list[FloatArray], y: list[FloatArray]) -> Curve:
    joined = [np.concatenate([np.zeros(0), *each]).astype(np.float64) for each in (x, y)]
    order = np.argsort(joined[0], kind="stable")
    return Curve(across, along, joined[0][order], joined[1][order])
