"""What is exported: fragility curves as plain data, and what a format has no place for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.risk.lognormal import Lognormal
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray

Unit = Literal["g", "m/s", "-"]
Reason = Literal["no-name-of-measure", "state-without-curve", "curves-cross"]


@dataclass(frozen=True, repr=False)
class ExportedState(ShortRepr):
    """A state and its curve.

    name : like "rocking", "rotation-0.5", "overturning"
    lognormal : None where the data do not bound one
    intensity, records, reached, low, high [k] : the empirical curve at rising intensity, with its Wilson interval
    """

    name: str
    lognormal: Lognormal | None
    intensity: FloatArray
    records: IntArray
    reached: IntArray
    low: FloatArray
    high: FloatArray

    @property
    def share(self) -> FloatArray:
        """Share of records that reach the state at each intensity [k] [-]."""
        return self.reached / self.records


@dataclass(frozen=True, repr=False)
class ExportedCurve(ShortRepr):
    """The curves of one mechanism by one measure.

    name : of the mechanism; text of the user
    measure : "pga", "pgv", "sa", "sa-average", "pga/(g tan alpha)", "p pgv/(g tan alpha)"
    period : of "sa" [s], else None
    unit : of intensities
    states : the mildest first
    """

    name: str
    measure: str
    period: float | None
    unit: Unit
    states: tuple[ExportedState, ...]


@dataclass(frozen=True, repr=False)
class LeftOut(ShortRepr):
    """A curve that a format has no place for, or that is not as a format wants it.

    reason : "no-name-of-measure" and "state-without-curve": it is not in the file; "curves-cross": it is, but a severer
        state is somewhere more likely than a milder one, which programs that take differences cannot use
    """

    name: str
    measure: str
    period: float | None
    reason: Reason
    state: str = ""


@dataclass(frozen=True, repr=False)
class Export(ShortRepr):
    """The text of a file, and what it leaves out."""

    text: str
    left_out: tuple[LeftOut, ...]
