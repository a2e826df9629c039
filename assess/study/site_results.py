"""The site's spectrum and the records in the results."""

from __future__ import annotations

import numpy as np
from scipy.constants import g

from assess.results import (
    RecordResult,
    RecordSpectrum,
    SpectrumResult,
)
from assess.study.motions import ScaledRecord
from assess.study.oscillator_results import floats
from records.candidates import sequence_number
from records.record import scale
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

SHORTEST_SHOWN = 0.01  # [s]
LONGEST_PERIOD = 10.0  # s, of the spectra in the results, where the spectrum reaches so far


ROUND = (0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5)  # [s]
SAME_PERIOD = 1e-9  # relative difference of periods that are one


def display_periods(spectrum: Spectrum) -> FloatArray:
    """Return the periods [s] at which spectra are shown: 0, even in the logarithm, round and corner periods."""
    longest = min(LONGEST_PERIOD, spectrum.longest_period)
    corners = [float(value) for key, value in spectrum.parameters.items() if key.startswith("t_") and value != "none"]
    extra = [period for period in (*ROUND, *corners) if SHORTEST_SHOWN < period < longest]
    even = np.geomspace(SHORTEST_SHOWN, longest, 160)
    apart = [period for period in extra if np.abs(even / period - 1.0).min() > SAME_PERIOD]
    return np.concatenate(([0.0], np.unique(np.concatenate([even, apart]))))


def spectrum_result(spectrum: Spectrum) -> SpectrumResult:
    """Return the site's spectrum at the periods shown."""
    period = display_periods(spectrum)
    scale = {} if spectrum.factor == 1.0 else {"scale": spectrum.factor}
    return SpectrumResult(
        code=spectrum.code,
        parameters={**spectrum.parameters, **scale},
        damping=spectrum.damping,
        damping_rule=spectrum.damping_rule,
        clause=spectrum.clause,
        pga_g=spectrum.pga / g,
        period_s=floats(period),
        acceleration_g=floats(spectrum.acceleration(period) / g),
    )


def record_result(motion: ScaledRecord, spectrum: Spectrum, *, nga: int | None = None) -> RecordResult:
    """Return a record as used.

    Parameters
    ----------
    motion : ScaledRecord
        The record with its factor.
    spectrum : Spectrum
        The site's spectrum, at whose periods that of the record is given.
    nga : int, optional
        Its number in the NGA database; by default the one in its file name.

    Returns
    -------
    RecordResult
        The record scaled to the site.
    """
    used = scale(motion.record, motion.scaling.factor)
    period = display_periods(spectrum)
    return RecordResult(
        id=used.id,
        path=used.path,
        event=used.event,
        station=used.station,
        component=used.component,
        dt_s=used.dt,
        npts=used.npts,
        pga_g=used.pga / g,
        scale_factor=motion.scaling.factor,
        mse=motion.scaling.mse,
        trail=tuple(map(str, used.processing_history)),
        processing=used.processing_history,
        spectrum=RecordSpectrum(floats(period), floats(response_spectrum(used, period) / g)),
        date=used.earthquake.time,
        magnitude=used.earthquake.magnitude,
        distance_km=None if used.distance is None else used.distance / 1000.0,
        vs30_m_per_s=used.site.vs30,
        nga=sequence_number(used.path) if nga is None else nga,
    )
