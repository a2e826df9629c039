"""What the caller states of a file that the file does not say itself."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from records.errors import RecordError
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

GIVE_UNIT = 'give unit (--unit g on the command line, unit = "g" under [records] of a project)'
GIVE_STEP = "give step, in seconds (--step 0.01 on the command line, step = 0.01 under [records] of a project)"


@dataclass(frozen=True)
class Stated:
    """Used only where a file is silent: what it says itself goes before.

    unit : of the accelerations (g, m/s2, cm/s2, gal, mm/s2)
    step : of time [s]
    response : a file of the instrument's response (StationXML, dataless SEED, RESP, SAC poles and zeros)
    """

    unit: str | None = None
    step: float | None = None
    response: Path | None = None

    def beside(self, kept: Stated) -> Stated:
        """This, with what was `kept` from before where this says nothing."""
        return Stated(
            kept.unit if self.unit is None else self.unit,
            kept.step if self.step is None else self.step,
            kept.response if self.response is None else self.response.absolute(),
        )


def check(stated: Stated) -> None:
    """Refuse, before it is kept for many files, a unit that is not known, a step or a response that is none."""
    if stated.unit is not None:
        try:
            factor_of(stated.unit, known=ACCELERATION_UNITS)
        except ColumnError as error:
            raise RecordError(f"of files that do not say theirs: {error}") from None
    if stated.step is not None and not (isfinite(stated.step) and stated.step > 0.0):
        raise RecordError(f"of files that do not say theirs: time step {stated.step} s; it must be positive")
    if stated.response is not None and not stated.response.is_file():
        raise RecordError(f"{stated.response}: no such file; give the StationXML of the instrument")
