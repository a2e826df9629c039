"""`assess run` by stages: seconds of the clock, of all processors, and shares, of the demo and of 40 mechanisms.

Run as a script. Each project runs twice in a process of its own, and the second run counts: what numba compiles is on
disk by then. The demo is to take less than 10 s on two cores, 40 mechanisms less than 40 s. The clock means something
on a machine that has nothing else to do; processors' seconds do on any. The stages are those of one process after the
other; the command itself is last.
"""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from assess.cli import MADE_BETWEEN_COLLECTIONS

EXAMPLE = "casa_grande"
MORE_CUTS = ("0.5 m", "1 m", "1.5 m", "2 m", "2.5 m")  # of six walls: 30 mechanisms more than the demo's ten
MECHANISM = """
[mechanisms.more-{wall}-{place}]
kind = "single-block"
blocks = ["wall-{wall}"]
cut = "{cut}"
"""


class Stopwatch:
    """Seconds since the last stage, of the clock and of the processors with those of processes that have ended."""

    def __init__(self) -> None:
        self.rows: list[tuple[str, float, float]] = []
        self._stage, self._last = "imports and reading", self._now()

    def begin(self, stage: str) -> None:
        """End the stage that runs, if `stage` is another."""
        if stage == self._stage:
            return
        now = self._now()
        self.rows.append((self._stage, now[0] - self._last[0], now[1] - self._last[1]))
        self._stage, self._last = stage, now

    @staticmethod
    def _now() -> tuple[float, float]:
        return time.perf_counter(), sum(os.times()[:4])


def watched(project: Path, folder: Path) -> Stopwatch:
    """What `assess run` does, with a stopwatch."""
    watch = Stopwatch()
    gc.set_threshold(MADE_BETWEEN_COLLECTIONS)
    from assess.project.project_file import load

    loaded = load(project)
    watch.begin("geometry and mechanisms")
    from assess.project.build import build
    from assess.results.json import dumps
    from assess.study.run import run_study

    study = build(loaded)
    results = run_study(
        study, progress=lambda stage, done, total: watch.begin(stage if done < total else f"after {stage}")
    )
    watch.begin("results.json")
    (folder / "results.json").write_text(dumps(results), encoding="utf-8")
    watch.begin("imports of the report")
    from reports.assessment import write_all

    watch.begin("document")
    write_all(results, folder, progress=watch.begin)
    watch.begin("end")
    return watch


def table(name: str, watch: Stopwatch) -> str:
    """The stages as text, with what the targets are about last."""
    wall, spent = (sum(row[column] for row in watch.rows) for column in (1, 2))
    lines = [f"{name:<34}{'clock':>8}{'processors':>12}{'share':>8}"]
    lines += [f"{stage:<34}{a:8.2f}{b:12.2f}{b / spent:8.0%}" for stage, a, b in watch.rows]
    return "\n".join([*lines, f"{'whole':<34}{wall:8.2f}{spent:12.2f}"])


def commanded(project: Path, folder: Path) -> tuple[float, float]:
    """Seconds of the clock and of all processors that the command takes, the faster of two runs."""
    command = [sys.executable, "-m", "assess", "run", str(project), "-o", str(folder / "out")]
    runs = []
    for _ in range(2):
        clock, spent = time.perf_counter(), sum(os.times()[2:4])
        subprocess.run(command, check=False, capture_output=True)
        runs.append((time.perf_counter() - clock, sum(os.times()[2:4]) - spent))
    return min(runs)


def with_more(project: Path) -> None:
    """Let the project have 40 mechanisms: the same walls cut elsewhere."""
    with project.open("a", encoding="utf-8") as stream:
        for wall in range(1, 7):
            stream.writelines(MECHANISM.format(wall=wall, place=k, cut=cut) for k, cut in enumerate(MORE_CUTS))


def measured(project: Path, name: str) -> str:
    """The table of a second run."""
    command = [sys.executable, __file__, str(project), name]
    return [subprocess.run(command, check=True, capture_output=True, text=True).stdout for _ in range(2)][-1]


def main(arguments: list[str]) -> None:
    """With a project and its name, run it once; without, make both projects and print their tables."""
    with tempfile.TemporaryDirectory() as folder:
        if arguments:
            print(table(arguments[1], watched(Path(arguments[0]), Path(folder))))  # noqa: T201
            return
        from assess.examples import copy_example

        for name, more in (("the demo", False), ("40 mechanisms", True)):
            project = copy_example(EXAMPLE, Path(folder) / name)
            if more:
                with_more(project)
            print(measured(project, name))  # noqa: T201
            clock, spent = commanded(project, project.parent)
            print(f"{'assess run':<34}{clock:8.2f}{spent:12.2f}\n")  # noqa: T201


if __name__ == "__main__":
    main(sys.argv[1:])
