"""What is exported: fragility curves as plain data, and what a format has no place for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from assess.risk.lognormal import Lognormal
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray

Unit = Literal["g", "m/s", "-"]
Reason = Literal["no-name-of-measure", "state-without-curve", "state-left-out", "curves-cross"]


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

    reason : "no-name-of-measure" and "state-without-curve", of its severest state: it is not in the file;
        "state-left-out": a milder state that it does not have is in no curve of the file; "curves-cross": it is in
        the file, but a severer state is somewhere more likely than a milder one, which programs that take differences
        cannot use
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


def common_states(curves: Sequence[ExportedCurve], *, fitted: bool) -> tuple[list[ExportedCurve], list[LeftOut]]:
    """Return curves with the states that all of them have, and what is left out.

    A curve without its severest state is left out whole. A milder state that one curve lacks is left out of all,
    as rocking by PGA, which a rigid block begins at one PGA without scatter.

    Parameters
    ----------
    curves : of one file, whose limit states are those of each of them
    fitted : whether a state needs a lognormal
    """

    def names_of(curve: ExportedCurve) -> list[str]:
        return [each.name for each in curve.states if each.lognormal is not None or not fitted]

    whole = [each for each in curves if each.states[-1].name in names_of(each)]
    known = dict.fromkeys(state.name for each in whole for state in each.states)
    common = [name for name in known if all(name in names_of(each) for each in whole)]
    left_out = [
        LeftOut(each.name, each.measure, each.period, "state-without-curve", each.states[-1].name)
        for each in curves
        if not any(each is one for one in whole)
    ]
    left_out += [
        LeftOut(each.name, each.measure, each.period, "state-left-out", name)
        for name in known
        for each in whole
        if name not in names_of(each)
    ]
    kept = [replace(each, states=tuple(one for one in each.states if one.name in common)) for each in whole]
    return kept, left_out
