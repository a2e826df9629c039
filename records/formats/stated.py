"""What the caller states of a file that the file does not say itself."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


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
