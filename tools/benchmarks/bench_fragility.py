"""Speed and memory of `assess fragility` beside the targets set for it; run as a script.

100 records of 2,000 steps at 50 intensities in both polarities on ten walls, 100,000 histories, linearised and exact:
the histories alone, then with curves and bootstrap. Each equation runs in a process of its own, so that peak memory is
its own; processor time is that of all threads, for machines that have other work too. Walls rock unlike to either side,
as a symmetric one needs one polarity. Memory of a tenth of the records shows what grows with the number of runs.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.constants import g

from assess.study.fragility import question_with_measures, run_fragility, run_records
from assess.study.study import FragilityQuestion, Study
from assess.workers import available_cores
from tests.support.motions import noise
from tests.support.projects import project_toml, study_of, wall

RECORDS, LEVELS, WALLS, STEPS = 100, 50, 10, 2_000
TARGET = {"linearised": 15.0, "exact": 60.0}
"""Seconds on two cores."""


def walls(equation: str, records: int) -> Study:
    """Return ten walls of rising slenderness under noise of lognormal strength."""
    text = project_toml(
        bodies={f"wall {place}": wall(height=3.0 + 0.5 * place) for place in range(WALLS)},
        mechanisms={
            f"wall {place}": {"kind": "single-block", "blocks": [f"wall {place}"], "direction": [1, 0, 0],
                              "restitution": {"positive": 0.85, "negative": 0.9}}
            for place in range(WALLS)
        },
        records={"synthetic": {"count": 1, "duration": 8}},
        analysis={"equation": equation},
    )  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        study = study_of(Path(folder), text)
    peaks = g * np.exp(np.random.default_rng(1).normal(np.log(0.3), 0.6, records))
    motions = tuple(
        noise(seed, peak=float(peak), npts=STEPS, dt=0.01, smooth=25, bell=1.0) for seed, peak in enumerate(peaks)
    )
    asked = FragilityQuestion(samples=LEVELS, largest=1.5, largest_factor=1e6)
    return replace(study, records=motions, artificial=None, fragility=asked)


def measure(equation: str, records: int) -> None:
    """Print time and memory of one equation."""
    study = walls(equation, records)
    run_records(
        study, study.mechanisms[0], study.records[:1], question_with_measures(study), jobs=0
    )  # compiled, or read from the cache
    start, used = time.perf_counter(), time.process_time()
    for mechanism in study.mechanisms:
        run_records(study, mechanism, study.records, question_with_measures(study), jobs=0)
    ran, ran_used = time.perf_counter() - start, time.process_time() - used
    start, used = time.perf_counter(), time.process_time()
    run_fragility(study)
    whole, whole_used = time.perf_counter() - start, time.process_time() - used
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    cores = available_cores()
    aim = TARGET[equation] * records / RECORDS
    print(  # noqa: T201 - what a benchmark is for
        f"{equation:>10}, {records:3d} records: histories {ran:6.1f} s (processor {ran_used:6.1f} s, "
        f"{ran_used / cores:5.1f} s on {cores} cores; aim {aim:g} s), with curves {whole:6.1f} s "
        f"(processor {whole_used:6.1f} s), peak memory {memory:.0f} MB",
        flush=True,
    )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        measure(sys.argv[1], int(sys.argv[2]))
    else:
        for name in TARGET:
            for count in (RECORDS // 10, RECORDS):
                subprocess.run([sys.executable, "-m", "tools.benchmarks.bench_fragility", name, str(count)], check=True)
