"""5 % spectra that PEER published for four components of NGA-West2, five printed digits."""

import gzip
import json

import numpy as np
import pytest
from scipy.constants import g
from scipy.signal import cont2discrete, lfilter, ss2tf

from records.processing import rotd_spectrum
from records.reading import read_records
from records.response import response_spectrum
from tests.support.places import REAL_RECORDS, needs_real_records

FILE = REAL_RECORDS / "reference_spectra" / "pyrotd_peer_nga_west2.json.gz"

pytestmark = needs_real_records


@pytest.mark.parametrize("station", [0, 1])
@pytest.mark.parametrize(("component", "key"), [(0, "h1"), (1, "h2")])
def test_ordinates_are_the_printed_ones_and_what_samples_miss(station: int, component: int, key: str) -> None:
    """PEER takes maxima at samples: there ours agree to the printed digits, and between them they are larger.

    Where a period has twenty samples or more, by at most 1 - cos(pi / 20) = 1.2 %. Below 0.1 s PEER resampled by a rule
    of its own.
    """
    with gzip.open(FILE, "rt", encoding="utf-8") as file:
        entry = json.load(file)[station]
    (published,) = (spectrum[key] for spectrum in entry["spectra"] if key in spectrum)
    (record,) = read_records(REAL_RECORDS / "peer_at2" / entry["fnames"][component])
    period, printed = np.array(entry["period"]), np.array(published)
    between = (period >= 0.1) & (period <= 5.0)
    a = np.append(record.acceleration, np.zeros(int(period[between].max() / record.dt)))  # rest after the end
    sampled = []  # by scipy's first-order hold
    for w in 2 * np.pi / period[between]:
        system = [np.array(part) for part in ([[0, 1], [-(w**2), -0.1 * w]], [[0.0], [-1]], [[w**2, 0]], [[0.0]])]
        numerator, denominator = ss2tf(*cont2discrete(system, record.dt, method="foh")[:4])
        sampled.append(np.abs(lfilter(numerator[0], denominator, a)).max() / g)
    np.testing.assert_allclose(sampled, printed[between], rtol=5e-6)
    ratio = response_spectrum(record, period) / g / printed
    assert np.all((ratio[between] >= 1 - 5e-6) & (ratio[between] <= 1 / np.cos(np.pi / 20)))
    np.testing.assert_allclose(ratio[~between], 1.0, rtol=2e-2)


@pytest.mark.parametrize("station", [0, 1])
def test_rotd50_is_the_printed_one_and_what_samples_miss(station: int) -> None:
    """Of the 5 % spectra, at some of the periods: 180 directions take their time."""
    with gzip.open(FILE, "rt", encoding="utf-8") as file:
        entry = json.load(file)[station]
    published = next(spectrum["rotd50"] for spectrum in entry["spectra"] if "rotd50" in spectrum and "h1" in spectrum)
    first, second = (read_records(REAL_RECORDS / "peer_at2" / name)[0] for name in entry["fnames"])
    period = np.array(entry["period"])
    some = np.flatnonzero((period >= 0.1) & (period <= 5.0))[::6]
    ratio = rotd_spectrum(first, second, period[some], percentile=50) / g / np.array(published)[some]
    assert np.all((ratio >= 1 - 5e-5) & (ratio <= 1 / np.cos(np.pi / 20)))  # half a unit of the fifth digit
    slow = period[some] >= 0.5  # a hundred samples and more: 1 - cos(pi / 100)
    np.testing.assert_allclose(ratio[slow], 1.0, rtol=5e-4 + 5e-5)
