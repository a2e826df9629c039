"""Whether a record's peak can be of ground in an earthquake, or its unit is another than was read."""

from __future__ import annotations

import re
from math import log

from scipy.constants import g

from records.candidates import Candidate
from records.record import Record
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

LARGEST = 3.0  # g; the strongest recorded so far have reached 2.7 g (horizontal) to 3.9 g (vertical, Iwate-Miyagi 2008)
LEAST = 1e-5  # g; far below what a body that rocks can feel
USUAL = 0.1  # g
READ_IN = re.compile(r"\bunit (\S+)")


def doubt_of(record: Record) -> str:
    """One line where the peak is above 3 g or below 1e-5 g, with the unit that is likely meant; else ""."""
    told = _doubt(record.pga)
    unit = next((found[1] for step in record.trail if (found := READ_IN.search(step))), "")
    return f"{record.id}: {told}{_likely(record.pga, unit)}" if told else ""


def doubt_of_candidate(one: Candidate) -> str:
    """The same for a record of a catalogue, which does not keep the unit it was read in."""
    told = _doubt(one.measures["pga"])
    return f"{one.path}: {told}" if told else ""


def _doubt(pga: float) -> str:
    if LEAST * g <= pga <= LARGEST * g:
        return ""
    bound = f"above {LARGEST:g} g, as hardly any earthquake reaches" if pga > LARGEST * g else f"below {LEAST:g} g"
    return f"its peak is {pga / g:.4g} g, {bound}; check the unit"


def _likely(pga: float, unit: str) -> str:
    """The unit in which the numbers of the file, read in `unit`, come nearest to a usual peak."""
    try:
        peak = pga / factor_of(unit.rstrip(";,"), known=ACCELERATION_UNITS)
    except ColumnError:
        return ""
    likely = min(ACCELERATION_UNITS, key=lambda one: abs(log(peak * ACCELERATION_UNITS[one] / (USUAL * g))))
    meant = peak * ACCELERATION_UNITS[likely]
    return "" if meant == pga else f" (read in {unit}; in {likely} it would be {meant / g:.3g} g)"
