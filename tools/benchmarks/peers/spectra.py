"""Response spectra of records: the program beside pyrotd, eqsig and scipy."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from records.record import Record, make_record
from tools.benchmarks.bench_dynamics import violent
from tools.benchmarks.bench_records import COARSE, T, by_eqsig, by_pyrotd, exact, motions, ours
from tools.benchmarks.peers.installed import Peer
from tools.benchmarks.peers.measure import Program, Table, least, measure, order

REST = 40.0  # s
FINE = 2000.0  # points of the reference to a period
Spectrum = Callable[[Record], np.ndarray]


def programs_of(pyrotd: Peer, eqsig: Peer) -> dict[tuple[str, str], Spectrum]:
    """Return name and setting of each program that is installed -> its spectrum at 200 periods."""
    found: dict[tuple[str, str], Spectrum] = {("this program", "maxima between samples too"): ours}
    found["scipy, lfilter", "20 points to a period"] = partial(exact, per_period=COARSE)
    if eqsig.module is not None:
        found["eqsig", "pseudo_response_spectra"] = partial(by_eqsig, eqsig.module)
    if pyrotd.module is not None:
        found["pyrotd", "calc_oscillator_resp"] = partial(by_pyrotd, pyrotd.module)
        found["pyrotd", f"the same, {REST:g} s of zeros added"] = partial(_with_rest, pyrotd)
    return found


def _with_rest(pyrotd: Peer, record: Record) -> np.ndarray:
    """Return pyrotd's spectrum of a record that is followed by rest, in which long periods die away."""
    longer = np.append(record.acceleration, np.zeros(round(REST / record.dt)))
    return by_pyrotd(pyrotd.module, make_record(record.id, longer, record.dt))  # type: ignore[arg-type]


def table(pyrotd: Peer, eqsig: Peer, *, rounds: int, seconds: float) -> Table:
    """Compare on two real records, or one artificial one where they are absent."""
    records = motions()[:2]
    reference = [exact(record, FINE) for record in records]

    def errors(found: object) -> tuple[float, ...]:
        off = [np.abs(own / of - 1.0) for own, of in zip(found, reference, strict=True)]  # type: ignore[call-overload]
        long = [each[record.dt * COARSE <= T].max() for each, record in zip(off, records, strict=True)]
        short = [each[record.dt * COARSE > T].max() for each, record in zip(off, records, strict=True)]
        return max(long), max(short)

    spectra = programs_of(pyrotd, eqsig)
    programs = [Program(*name, partial(_all, spectrum, records)) for name, spectrum in spectra.items()]
    named = " and ".join(f"{record.id} ({record.npts:,} samples of {1e3 * record.dt:g} ms)" for record in records)
    return Table(
        "Response spectra",
        f"Pseudo-acceleration at {T.size} periods from 0.01 to 10 s, 5 % damping, of {named}. Reference: the exact "
        "solution for a motion that is linear between samples, by scipy at 2,000 points to a period, some 0.001 % low. "
        "pyrotd takes the motion as band-limited between samples and as periodic, which is another motion to "
        "short and to long periods; eqsig has maxima at the samples only.",
        ("largest error, periods of 20 samples or more", "shorter"),
        measure(programs, errors, rounds=rounds, seconds=seconds),
        (_growth(spectra),),
    )


def _all(spectrum: Spectrum, records: list[Record]) -> list[np.ndarray]:
    """Return the spectra of all records."""
    return [spectrum(record) for record in records]


def _growth(spectra: dict[tuple[str, str], Spectrum]) -> str:
    """Return how the time grows with the length of a record."""
    sizes = [4000.0, 32_000.0]
    motion = violent(32_000).acceleration
    parts = [make_record("part", motion[: int(size)], 0.005) for size in sizes]
    powers = {
        name: order(sizes, [least(partial(spectrum, record), rounds=2) for record in parts])
        for (name, setting), spectrum in spectra.items()
        if not setting.startswith("the same")
    }  # fmt: skip
    return (
        "With the length of the record time grows to the power "
        + ", ".join(f"{power:.2f} ({name})" for name, power in powers.items())
        + "; with the number of records in proportion."
    )
