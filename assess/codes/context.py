"""What a procedure may know besides the oscillator: the site, the building, where the mechanism sits, its histories."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.check import BranchName, InputAt
from assess.hinge_forces import HingeForces
from spectra.spectrum import Spectrum


@dataclass(frozen=True)
class Building:
    """The structure below a mechanism.

    height H [m] above `ground_elevation` [m]; storeys N; period T_1 [s] of the first mode; damping [-].
    """

    height: float
    storeys: int | None
    ground_elevation: float
    period: float
    damping: float


@dataclass(frozen=True)
class Suite:
    """Largest rocking responses of one branch pair to all records at one level, the worse polarity of each.

    pga : level, peak ground acceleration of the target [m/s2]
    ratio : largest |rotation| / rigid overturning rotation of each record, None where it overturned
    branch : where the largest of them happened
    """

    pga: float
    ratio: tuple[float | None, ...]
    branch: BranchName

    @property
    def overturned(self) -> int:
        """How many records overturned the mechanism."""
        return sum(1 for ratio in self.ratio if ratio is None)

    @property
    def mean(self) -> float | None:
        """Mean of the maxima; None where a record overturned (its maximum does not exist)."""
        standing = [ratio for ratio in self.ratio if ratio is not None]
        return sum(standing) / len(standing) if len(standing) == len(self.ratio) > 0 else None


@dataclass(frozen=True)
class Context:
    """Site, building and position of one mechanism, and what its time histories gave.

    spectrum : the site's elastic spectrum at its own PGA
    levels : PGA at which demands are compared [m/s2]
    vertical_ratio : S_aV / S_aH [-]
    elevation : of the hinges above the ground [m]
    building : None where the project gives none
    suites : time histories, one suite for each of `levels`, in that order; empty when none were run
    linearised : whether the histories solve the linearised equation, which lifts off at its own multiplier
    histories_at : where the motion of the time histories is given
    amplification : the largest, over the records, of peak acceleration at the mechanism's base over that at the ground
    hinges : what the hinges of both branches pass on when the mechanism starts to rock; none where that is not known
    incremental : further suites at rising PGA, for the curve and the PGA at collapse; empty when none were run
    """

    spectrum: Spectrum
    levels: tuple[float, ...]
    vertical_ratio: float
    elevation: float
    building: Building | None
    suites: tuple[Suite, ...] = ()
    incremental: tuple[Suite, ...] = ()
    linearised: bool = False
    histories_at: InputAt = "ground"
    amplification: float = 1.0
    hinges: tuple[HingeForces, ...] = ()
