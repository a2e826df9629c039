"""A gate against creep: what each stage costs over work that does not change, beside the last release.

    python -m tools.benchmarks.bench_ratios            measures, and writes the table of docs/speed.md
    python -m tools.benchmarks.bench_ratios --keep     keeps the figures too, as those of the last release

Seconds of all processors, of the stage and of a loop that is never changed, in turns; the figure is the median of their
ratio over the rounds, so that another machine, or other work beside this, moves it little. A kernel is compared with a
loop of numba, all else with a loop of numpy. A stage that costs CREEP times its last figure is named. Kept are figures
of a release; nothing in continuous integration depends on them.
"""

from __future__ import annotations

import csv
import os
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

import numba
import numpy as np

from assess.dynamics.history import peaks, product
from assess.dynamics.packing import Equation
from assess.dynamics.pulses import envelope
from assess.examples import copy_example
from assess.oscillator import Oscillator
from assess.project.build import build
from assess.project.project_file import load
from assess.study.run import run_study
from records.pulses import PULSE_SHAPES
from records.record import Record, make_record
from reports.assessment import write_all
from tools.benchmarks.bench_dynamics import block, frame, violent, wall

Work = Callable[[], object]
CREEP, ROUNDS = 1.15, 5
PAGE, LAST = Path(__file__).parents[2] / "docs/speed.md", Path(__file__).with_name("last_ratios.csv")
BEGIN, END = "<!-- ratios: written by `make bench` -->", "<!-- end of the ratios -->"


@numba.njit  # type: ignore[untyped-decorator]
def chain(steps: int) -> float:
    """Multiply in a chain, each product waiting for the last: a logistic map."""
    x = 0.5
    for _ in range(steps):
        x = 3.7 * x * (1.0 - x)
    return x


def numba_loop() -> None:
    """The yardstick of kernels, some 0.1 s."""
    chain(20_000_000)


def numpy_loop() -> None:
    """The yardstick of all else, some 0.1 s: calls on few numbers, as long ones cost by the processor's vectors."""
    values = np.linspace(0.0, 1.0, 16)
    for _ in range(50_000):
        values = np.cumsum(values)[::-1] % 1.0


def in_a_process(code: str) -> None:
    """Run a line of Python in a new process."""
    subprocess.run([sys.executable, "-c", code], check=True)


def histories(body: Oscillator, record: Record, equation: Equation, count: int) -> None:
    """Equal jobs, as many as take some 0.1 s."""
    peaks([body], [record], product(1, 1, np.ones(count)), equation=equation, threads=1)


def lower_bounds(body: Oscillator) -> None:
    """Of five frequencies, without a map."""
    envelope(body, PULSE_SHAPES["sine"], np.linspace(0.5, 2.5, 5), np.array([30.0]), equation="exact")


def stages(folder: Path) -> dict[str, tuple[Work, Work]]:
    """Return each stage with its yardstick."""
    record = violent()
    weaker = make_record("weaker", 0.6 * record.acceleration, record.dt)
    project = copy_example("casa_grande_flexible", folder / "project")
    study = build(load(project))
    results = run_study(study, jobs=1)
    (folder / "out").mkdir()
    return {
        "a history, linearised": (partial(histories, block(), record, "linearised", 2000), numba_loop),
        "a history, rigid table": (partial(histories, frame(), weaker, "exact", 800), numba_loop),
        "a history, joints of 1 GPa/m": (partial(histories, wall(1e9), weaker, "exact", 200), numba_loop),
        "a history, joints of 10 GPa/m": (partial(histories, wall(1e10), weaker, "exact", 100), numba_loop),
        "lower bounds on joints of 1 GPa/m": (partial(lower_bounds, wall(1e9)), numba_loop),
        "imports of a run": (partial(in_a_process, "import assess.study.run"), numpy_loop),
        "casa_grande_flexible: file and geometry": (lambda: build(load(project)), numpy_loop),
        "casa_grande_flexible: assessment": (partial(run_study, study, jobs=1), numpy_loop),
        "casa_grande_flexible: report": (partial(write_all, results, folder / "out"), numpy_loop),
    }


def seconds(work: Work) -> float:
    """Of all processors, those of processes started included."""
    own, others = time.process_time(), sum(os.times()[2:4])
    work()
    return time.process_time() - own + sum(os.times()[2:4]) - others


def measure(work: Work, yardstick: Work) -> float:
    """Return the median ratio; each round begins and ends with the yardstick, and all is called once before."""
    work(), yardstick()
    ratios = []
    for _ in range(ROUNDS):
        loop, cost, again = seconds(yardstick), seconds(work), seconds(yardstick)
        ratios.append(2.0 * cost / (loop + again))
    return median(ratios)


def table(found: dict[str, float], last: dict[str, float]) -> str:
    """Return the page's part: each stage beside its last figure, and those that cost CREEP times as much."""
    lines = ["| stage | over the loop | last release | change |", "|---|---:|---:|---:|"]
    for stage, ratio in found.items():
        before = last.get(stage)
        beside = f"{before:.3g} | {ratio / before:.2f}" if before else "- | -"
        lines.append(f"| {stage} | {ratio:.3g} | {beside} |")
    slower = [stage for stage, ratio in found.items() if ratio > CREEP * last.get(stage, np.inf)]
    if slower:
        said = f"{CREEP} times its last figure or more: {', '.join(slower)}."
    else:
        said = "No stage has become slower." if last else "No figures of a release are kept yet."
    return "\n".join([*lines, "", said])


def read_last(path: Path = LAST) -> dict[str, float]:
    """Return the figures of the last release by stage."""
    with path.open(encoding="utf-8", newline="") as file:
        return {stage: float(ratio) for stage, ratio in csv.reader(file)}


def write_page(text: str, page: Path = PAGE) -> None:
    """Put the table into the page, in place of the old one."""
    before, rest = page.read_text(encoding="utf-8").split(BEGIN)
    page.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{rest.split(END)[1]}", encoding="utf-8")


def main(arguments: list[str]) -> None:
    """Measure, write the page, and keep the figures if asked."""
    with TemporaryDirectory() as folder:
        found = {stage: measure(*pair) for stage, pair in stages(Path(folder)).items()}
    text = table(found, read_last())
    print(text)  # noqa: T201
    write_page(text)
    if arguments == ["--keep"]:
        with LAST.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows((stage, f"{ratio:.4g}") for stage, ratio in found.items())


if __name__ == "__main__":
    main(sys.argv[1:])
