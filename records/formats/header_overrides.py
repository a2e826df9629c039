"""What the caller gives for the header of a file: unit, time step and the instrument's response."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from records.errors import RecordError
from spectra.arrays import is_number
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

GIVE_UNIT = 'give unit (--unit g on the command line, unit = "g" under [records] of a project)'
GIVE_STEP = "give step, in seconds (--step 0.01 on the command line, step = 0.01 under [records] of a project)"


@dataclass(frozen=True)
class HeaderOverrides:
    """Values for what a header leaves out; where the file states a value itself, the file's value is used.

    Attributes
    ----------
    unit : of the accelerations (g, m/s2, cm/s2, gal, mm/s2)
    step : time step [s]
    response : file of the instrument's response (StationXML, dataless SEED, RESP, SAC poles and zeros)
    """

    unit: str | None = None
    step: float | None = None
    response: Path | None = None

    @property
    def key(self) -> str:
        """Text that a catalogue keeps with each file, to read it again when another value is given; never reworded."""
        return f"Stated(unit={self.unit!r}, step={self.step!r}, response={self.response!r})"

    def over(self, earlier: HeaderOverrides) -> HeaderOverrides:
        """Return these values, with those of `earlier` where one is not given here."""
        return HeaderOverrides(
            earlier.unit if self.unit is None else self.unit,
            earlier.step if self.step is None else self.step,
            earlier.response if self.response is None else self.response.absolute(),
        )


NO_OVERRIDES = HeaderOverrides()


def check_overrides(overrides: HeaderOverrides) -> None:
    """Raise RecordError for an unknown unit, a step that is not positive, or a response file that does not exist."""
    if overrides.unit is not None:
        if not isinstance(overrides.unit, str):
            raise RecordError(f'unit = {overrides.unit!r}, for files that state none; write it as text, like "g"')
        try:
            factor_of(overrides.unit, known=ACCELERATION_UNITS)
        except ColumnError as error:
            raise RecordError(f"for files that state none, {error}") from None
    if overrides.step is not None and not (
        is_number(overrides.step) and isfinite(overrides.step) and overrides.step > 0.0
    ):
        raise RecordError(f"for files that state none, time step {overrides.step} s; it must be positive")
    if overrides.response is not None and not overrides.response.is_file():
        raise RecordError(f"{overrides.response}: no such file; give the StationXML of the instrument")
