"""Compile every entry point of the kernels into the user's cache: `python -m tests.support.compile_kernels`.

Two processes that meet an uncompiled kernel would both compile it, so this runs before the tests are dealt out to
them; once for a version of the kernels, which a file beside the machine code says.
"""

from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from hashlib import sha256
from multiprocessing import get_context
from pathlib import Path

import numpy as np


def compile_linearised() -> None:
    """Histories, pulses and envelopes by the linearised equation, and sines in closed form."""
    _compile_dynamics("linearised", shapes=("sine", "ricker"))


def compile_exact() -> None:
    """Histories, pulses and envelopes by the exact equation."""
    _compile_dynamics("exact", shapes=("sine",))


def compile_joints_and_records() -> None:
    """Contact of joints; response spectra and motions of floors."""
    from assess.amplification import floor_motion
    from assess.interfaces.contact import JointLaw, contact, thresholds
    from assess.interfaces.section import rectangle
    from records.response import response_spectrum
    from records.synthetic import artificial_records
    from spectra.asce7 import design_spectrum
    from tests.support.motions import noise

    section, law = rectangle(1.0, 2.0), JointLaw(2e8, 1.5e6)
    contact(section, law, normal_force=2e5, rotation=[0.0, 1e-3])
    thresholds(section, law, normal_force=2e5)
    response_spectrum(noise(npts=50), [0.0, 0.5])
    floor_motion(noise(npts=50), frequency=2.5, shape=1.2)
    artificial_records(design_spectrum(s_ds=5.0, s_d1=2.0, t_l=6.0), count=1, seed=1, duration=10.0)


def _compile_dynamics(equation: str, *, shapes: tuple[str, ...]) -> None:
    from assess.dynamics.history import peaks, product
    from assess.dynamics.pulses import PulseJobs, envelope, pulse_outcomes
    from assess.oscillator import Oscillator
    from records.pulses import PULSE_SHAPES
    from tests.support.blocks import block
    from tests.support.motions import noise

    body: Oscillator = block()
    peaks([body], [noise(npts=50)], product(1, 1, 1.0), equation=equation, threads=1)
    first, frequency = np.zeros(1, dtype=np.int64), np.array([1.0, 2.0])
    for name in shapes:
        jobs = PulseJobs(first, first, np.array([3.0]))
        pulse_outcomes([body], PULSE_SHAPES[name], frequency, jobs, equation=equation, threads=1)
        envelope(body, PULSE_SHAPES[name], frequency, np.array([1.0, 3.0]), equation=equation, threads=1)


def compile_kernels(processes: int = 2) -> None:
    """Compile all of them, shared between `processes`, unless that is done."""
    from records.compilation.kernel import code_folder

    folder, calls = code_folder(), sha256(Path(__file__).read_bytes()).hexdigest()[:32]
    done = None if folder is None else folder / f"compiled-{calls}"
    if done is not None and done.exists():
        return
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        for work in [pool.submit(each) for each in (compile_exact, compile_linearised, compile_joints_and_records)]:
            work.result()
    if done is not None:
        with suppress(OSError):  # a full disk costs time alone
            done.touch()


if __name__ == "__main__":
    compile_kernels(int(sys.argv[1]) if len(sys.argv) > 1 else 2)
