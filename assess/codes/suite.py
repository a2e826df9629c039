"""The largest responses of one mechanism to a suite of records at one level, each record with its twins.

A history is chaotic where impacts amplify a difference of the motion: with the PGA times (1 + 1e-9) a maximum can move
by 20 %. So each record is also run with twins that differ by too little to be another earthquake, and the nine runs
together say what the records give.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import inf

import numpy as np

from assess.codes.check import BranchName
from assess.short_repr import ShortRepr
from spectra.arrays import BoolArray, FloatArray


@dataclass(frozen=True, eq=False, repr=False)
class Runs(ShortRepr):
    """The runs of each record at one level: the record as it is in the first row, then its twins.

    ratio : largest |rotation| / rigid overturning rotation, inf where it overturned [runs, records] [-]
    negative : whether the largest happened on the negative branch [runs, records]
    """

    ratio: FloatArray
    negative: BoolArray


@dataclass(frozen=True)
class Suite:
    """The largest responses of one mechanism to all records at one level, the worse polarity of each.

    pga : level, peak ground acceleration of the target [m/s2]
    ratio : largest |rotation| / rigid overturning rotation of each record, None where it overturned
    branch : where the largest of them happened
    branches : where the largest of each record happened; empty: all on `branch`
    twins : the records with their twins; None where they were run without
    """

    pga: float
    ratio: tuple[float | None, ...]
    branch: BranchName
    branches: tuple[BranchName, ...] = ()
    twins: Runs | None = field(default=None, compare=False)

    @property
    def overturned(self) -> int:
        """Number of records that overturned the mechanism."""
        return sum(1 for ratio in self.ratio if ratio is None)

    @property
    def mean(self) -> float | None:
        """Mean of the maxima; None where a record overturned, as it has no maximum."""
        standing = [ratio for ratio in self.ratio if ratio is not None]
        return sum(standing) / len(standing) if len(standing) == len(self.ratio) > 0 else None

    @property
    def runs(self) -> Runs:
        """The runs of each record: with its twins, or the record alone."""
        if self.twins is not None:
            return self.twins
        names = self.branches or (self.branch,) * len(self.ratio)
        ratio = [inf if each is None else each for each in self.ratio]
        return Runs(np.array([ratio], dtype=np.float64), np.array([[name == "negative" for name in names]], dtype=bool))
