"""The ground motions of a study: read or made, and scaled to its target."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from assess.project.study import ScaleTo, Study
from records.record import Record
from records.scaling import Scaling, misfit, scale_to_pga, scale_to_spectrum
from records.synthetic import artificial
from spectra.spectrum import Spectrum


@dataclass(frozen=True)
class Motion:
    """A record as read, the factor that brings it to the target, and the misfit left (mean squared log)."""

    record: Record
    scaling: Scaling


def motions_of(study: Study, spectrum: Spectrum) -> tuple[Motion, ...]:
    """Every record of the study, files first, each with its scaling."""
    made = study.artificial
    artificials = () if made is None else artificial(spectrum, count=made.count, seed=made.seed, duration=made.duration)
    scale = SCALINGS[study.scale_to]
    return tuple(Motion(record, scale(record, spectrum)) for record in (*study.records, *artificials))


def to_pga(record: Record, spectrum: Spectrum) -> Scaling:
    """The record brought to the spectrum's PGA."""
    factor = scale_to_pga(record, spectrum.pga)
    return Scaling(factor, misfit(record, spectrum, factor=factor))


def as_it_is(record: Record, spectrum: Spectrum) -> Scaling:
    """The record as it is."""
    return Scaling(1.0, misfit(record, spectrum))


SCALINGS: dict[ScaleTo, Callable[[Record, Spectrum], Scaling]] = {
    "spectrum": scale_to_spectrum,
    "pga": to_pga,
    "none": as_it_is,
}
