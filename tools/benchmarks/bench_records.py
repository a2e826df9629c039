"""Response spectra, RotD50, catalogue and selection: speed with its targets, beside scipy, pyrotd and eqsig; a script.

One core, best of several. A cost in ms is for all motions together: real records of ../shared/records where they are
there, else artificial ones, all with a sample of zero at both ends. The reference is the exact solution for ground
acceleration that is linear between samples, by scipy's first-order hold, at 500 points to a period; errors are those
of the largest ordinate that is off, apart for periods below and above 20 steps. What they come from:

ours     maxima of the exact solution, between samples too: the reference is up to 1 - cos(pi/500) = 0.002 % low
eqsig    the same recurrence (Nigam and Jennings), maxima at the samples only: with two samples to a period it may miss
         most of a swing. Its 2 pi has eight digits. No free vibration after the end
pyrotd   in the frequency domain: its ground motion is band-limited between samples, not linear, which is another motion
         to oscillators of a few steps a period; ten points to a period or more, 5 % low at most. It adds no zeros: what
         is left of the vibration at the end comes back at the beginning, and long periods are off by half in short
         records. 40 s of zeros after the end lessen that as exp(-0.05 omega 40 s) does, 0.28 at 10 s

pyrotd and eqsig are not needed by the program: `pip install --group peers` (pip 25.1), or by name as in pyproject.toml.
"""

from __future__ import annotations

import os
import tempfile
import time
import warnings
from collections.abc import Callable
from functools import partial
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from types import ModuleType

import numpy as np
from scipy.constants import g
from scipy.signal import cont2discrete, lfilter

from records.candidates import PERIODS, Candidate
from records.catalogue import NAME, catalogue_candidates, index, open_catalogue
from records.processing import at2_text, rotd_spectrum
from records.reading import read_records
from records.record import Record, make_record
from records.response import _peak_displacements, response_spectrum
from records.scaling import band
from records.selection import SuiteCriteria, select
from spectra.asce7 import design_spectrum
from tools.benchmarks.bench_dynamics import Row, best, violent

REAL = Path(__file__).resolve().parents[3] / "shared" / "records" / "peer_at2"
NAMES = ("IELC180", "RSN70_SFERN_L01111", "RSN808_LOMAP_TRI000", "RSN1616_DUZCE_362-N", "RSN1633_MANJIL_ABBAR--L")
T = np.geomspace(0.01, 10.0, 200)
DENSE, COARSE = 500.0, 20.0  # points to a period
Spectrum = Callable[[Record], np.ndarray]


def motions() -> list[Record]:
    """With a sample of zero put at both ends, so that no program has to choose what comes before and after."""
    files = [REAL / f"{name}.AT2" for name in NAMES]
    found = [read_records(file)[0] for file in files] if all(file.is_file() for file in files) else [violent()]
    return [make_record(record.id, np.pad(record.acceleration, 1), record.dt) for record in found]


def exact(record: Record, per_period: float) -> np.ndarray:
    """Pseudo-acceleration [m/s2] at T by scipy, `per_period` points to a period or more, a period of rest after."""
    found = []
    for period in T.tolist():
        omega, parts = 2.0 * np.pi / period, max(1, int(np.ceil(record.dt * per_period / period - 1e-9)))
        h = record.dt / parts
        steps = np.arange((record.npts - 1) * parts + 1) / parts
        ground = np.append(np.interp(steps, np.arange(record.npts), record.acceleration), np.zeros(int(period / h) + 1))
        top, bottom, _ = cont2discrete(([-1.0], [1.0, 0.1 * omega, omega**2]), h, method="foh")
        found.append(omega**2 * np.abs(lfilter(top[0], bottom, ground)).max())
    return np.array(found)


def ours(record: Record) -> np.ndarray:
    """By the program, without the spectra that it keeps of earlier calls."""
    _peak_displacements.cache_clear()
    return response_spectrum(record, T)


def by_pyrotd(pyrotd: ModuleType, record: Record) -> np.ndarray:
    """As its `calc_spec_accels`, in this process."""
    amplitude = np.fft.rfft(record.acceleration)
    frequency = np.linspace(0.0, 0.5 / record.dt, amplitude.size)
    of = partial(pyrotd.calc_oscillator_resp, frequency, amplitude, 0.05, peak_resp_only=True)
    return np.array([of(1.0 / period) for period in T])


def by_eqsig(eqsig: ModuleType, record: Record) -> np.ndarray:
    """Its Nigam and Jennings."""
    return np.asarray(eqsig.pseudo_response_spectra(record.acceleration, record.dt, T, 0.05)[2])


def module(name: str) -> ModuleType | None:
    """A program to compare with, None where it is not installed; their own warnings are not ours."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return import_module(name)
        except ImportError as error:
            print(f"{name} is left out: {error}; see the group `peers` of pyproject.toml")  # noqa: T201
            return None


def milliseconds(work: Callable[[], object], times: int) -> float:
    """Of one core's time."""
    return 1e3 * best(work, times=times, clock=time.process_time)


def targets() -> list[Row]:
    """10,000 points at 200 periods."""
    rows, noise = [], np.random.default_rng(2).standard_normal(10_000)
    for dt in (0.0025, 0.005, 0.01, 0.02):
        cost = milliseconds(partial(ours, make_record("noise", noise, dt)), 20)
        rows.append(Row(f"10,000 points of {dt} s at 200 periods from 0.01 to 10 s", cost, "ms", "<= 10"))
    return rows


def spectra(programs: dict[str, tuple[Spectrum, int]]) -> list[Row]:
    """Every program on every motion: name -> (its spectrum at T, how often it is timed); ours is the first."""
    records = motions()
    reference = [exact(record, DENSE) for record in records]
    costs, rows = [], []
    for name, (spectrum, times) in programs.items():
        costs.append(milliseconds(lambda run=spectrum: [run(record) for record in records], times))  # type: ignore[misc]
        found = [spectrum(record) for record in records]
        rows.append(Row(f"{name}, {len(records)} motions", costs[-1], "ms"))
        rows.append(Row("  times as long as ours", costs[-1] / costs[0], "x"))
        if name == "ours":
            rows.pop()
        rows += errors(records, [own / of - 1.0 for own, of in zip(found, reference, strict=True)])
    return rows


def errors(records: list[Record], ratio: list[np.ndarray]) -> list[Row]:
    """Largest, and median of the size, below and above 20 steps of the record to a period."""
    rows = []
    for where, short in (("below", True), ("above", False)):
        off = np.concatenate([of[(record.dt * COARSE > T) == short] for of, record in zip(ratio, records, strict=True)])
        rows.append(Row(f"  largest error {where} 20 steps", 100.0 * off[np.abs(off).argmax()], "%"))
        rows.append(Row(f"  median |error| {where} 20 steps", 100.0 * float(np.median(np.abs(off))), "%"))
    return rows


def rotd50(pyrotd: ModuleType | None) -> list[Row]:
    """Of two motions, 180 directions."""
    first, second = (make_record(str(n), np.roll(violent().acceleration, n), 0.005) for n in (0, 700))
    ours = rotd_spectrum(first, second, T, percentile=50)
    cost = milliseconds(partial(rotd_spectrum, first, second, T, percentile=50), 2)
    rows = [Row(f"RotD50, {first.npts:,} points at 200 periods", cost, "ms")]
    if pyrotd is not None:
        work = partial(
            pyrotd.calc_rotated_spec_accels, first.dt, first.acceleration, second.acceleration, 1 / T, 0.05, [50]
        )
        theirs = milliseconds(work, 2)
        above = first.dt * COARSE <= T
        off = np.abs(work().spec_accel / ours - 1.0)[above].max()
        rows += [
            Row("  pyrotd", theirs, "ms", "", f"{off:.1e}"),
            Row("  times as long as ours", theirs / cost, "x"),
        ]
    return rows


def catalogue(count: int = 1000, npts: int = 4000) -> list[Row]:
    """AT2 files of artificial noise, read by one process."""
    rng = np.random.default_rng(6)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for number in range(count):
            record = make_record(str(number), g * 0.1 * rng.standard_normal(npts), 0.005, event="noise", component="0")
            (folder / f"{number}.AT2").write_text(at2_text(record), encoding="utf-8")
        with open_catalogue(folder / NAME) as connection:
            marks = [time.perf_counter()]
            for _ in range(2):
                index(folder, connection)
                marks.append(time.perf_counter())
            known = len(catalogue_candidates(connection))
    once, again = (after - before for before, after in pairwise(marks))
    return [
        Row(f"indexing {known:,} files of {npts:,} points, one process", once, "s", "<= 60"),
        Row("  again, unchanged", again, "s", "<= 1"),
    ]


def selection(count: int = 10_000) -> list[Row]:
    """7 of so many whose spectra waver about the target's shape."""
    rng, target = np.random.default_rng(8), design_spectrum(s_ds=5.0, s_d1=2.0, t_l=6.0)
    shape, knots = target.acceleration(PERIODS), np.linspace(0, PERIODS.size - 1, 9)
    rows = []
    for number in range(count):
        waver = np.interp(np.arange(PERIODS.size), knots, rng.normal(0.0, 0.5, 9)) + rng.normal()
        said = (f"{number}.AT2", 0, str(number), f"event {number // 3}", f"station {number}", "0", "", 6.0, 1e4, None)
        spectrum = shape * np.exp(waver)
        rows.append(Candidate(*said, "", None, 0.01, 2000, {"pga": float(spectrum[0])}, spectrum))
    work = partial(select, rows, target, SuiteCriteria(7, band(0.1, 2.0)))
    return [Row(f"selecting 7 of {count:,}", best(work, times=3), "s", "<= 1")]


def main() -> None:
    """The table."""
    print(f"{'what':<72}{'cost':>10} {'':<8}{'target':>12}{'error':>12}    {os.cpu_count()} cores")  # noqa: T201
    pyrotd, eqsig = module("pyrotd"), module("eqsig.sdof")
    programs: dict[str, tuple[Spectrum, int]] = {"ours": (ours, 20)}
    programs["scipy, at 20 points to a period"] = (partial(exact, per_period=COARSE), 2)
    if pyrotd is not None:
        programs["pyrotd"] = (partial(by_pyrotd, pyrotd), 2)
    if eqsig is not None:
        programs["eqsig"] = (partial(by_eqsig, eqsig), 2)
    for part in (targets, partial(spectra, programs), partial(rotd50, pyrotd), catalogue, selection):
        for row in part():
            print(row, flush=True)  # noqa: T201


if __name__ == "__main__":
    main()
