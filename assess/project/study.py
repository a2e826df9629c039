"""A project in the terms of the field: what `run` needs, with no trace of the file's schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.context import Building
from assess.codes.registry import CodeOptions
from assess.geometry.scene import Scene
from assess.mechanisms.mechanism import Mechanism
from assess.results import Input, Notice, Resolved
from records.record import Record
from spectra.spectrum import Spectrum

Equation = Literal["exact", "linearised"]
ScaleTo = Literal["spectrum", "pga", "none"]


@dataclass(frozen=True)
class Artificial:
    """Artificial records to be made: how many, the seed, and their duration [s]."""

    count: int
    seed: int
    duration: float


@dataclass(frozen=True)
class Study:
    """Site, motions, mechanisms and questions of one assessment.

    spectrum : the site's elastic spectrum at its own PGA; None where the project has no site
    levels : PGA at which demands are compared, rising [m/s2]
    equations : the equation of motion of each mechanism's histories, by name
    scenes : the bodies in space of each mechanism that has geometry, by name
    """

    spectrum: Spectrum | None
    vertical_ratio: float
    building: Building | None
    records: tuple[Record, ...]
    artificial: Artificial | None
    scale_to: ScaleTo
    levels: tuple[float, ...]
    procedures: tuple[str, ...]
    options: CodeOptions
    mechanisms: tuple[Mechanism, ...]
    equations: dict[str, Equation]
    scenes: dict[str, Scene]
    inputs: tuple[Input, ...]
    resolved: dict[str, Resolved]
    notices: tuple[Notice, ...]
