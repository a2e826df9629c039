"""Time per wall of a table: what decides alone, from 40 walls up to 10,000.

    python -m tools.benchmarks.bench_portfolio              500 walls in two processes, and what 10,000 would take
    python -m tools.benchmarks.bench_portfolio 10000        that many

The walls are those of the example `street` over again, each with another thickness, so that no two rows are alike.
With the methods that are accepted without a name, and by histories under seven records from files and under seven
artificial ones, which each process makes once for a soil; without the scan for their PGA at capacity.
"""

from __future__ import annotations

import csv
import sys
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time

from assess.examples import copy_example
from assess.portfolio.projects import Task, find_tasks, project_tree
from assess.project.build import build, build_to_decide
from assess.project.project_file import load, load_tree
from assess.study.run import find_outcome
from assess.study.study import require_spectrum
from assess.study.suites import motions_of

PROCESSES, WALLS, ALL = 2, 500, 10_000
ARTIFICIAL = 'synthetic = { count = 7, duration = "25 s" }'
FROM_FILES = 'files = ["records/*.csv"]'
NAMED = 'limit_state = "SLV"\nprocedures = ["ntc2018-history"]'


def written_table(folder: Path, count: int) -> tuple[Path, Path]:
    """Return a table of so many walls, and its template."""
    template = copy_example("street", folder / "street")
    with (template.parent / "street.csv").open(encoding="utf-8", newline="") as file:
        header, *rows = csv.reader(file)
    walls, at = template.parent / "walls.csv", header.index("bodies.facade.box.thickness [m]")
    with walls.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for number in range(count):
            row = rows[number % len(rows)]
            thicker = f"{float(row[at]) + 1e-5 * (number // len(rows)):.5f}"
            writer.writerow([f"{number}", *row[1:at], thicker, *row[at + 1 :]])
    return walls, template


def with_histories(template: Path) -> None:
    """Let the history method decide, by the artificial records of the template."""
    _replace(template, "[analysis]\n", "[analysis]\nscan = false\n")
    _replace(template, 'limit_state = "SLV"', NAMED)


def with_files(template: Path) -> None:
    """Let the history method decide, by seven records written into files beside the template."""
    study = build(load(template))
    (template.parent / "records").mkdir()
    for place, motion in enumerate(motions_of(study, require_spectrum(study))):
        rows = zip(motion.record.time, 1.1 * motion.scaling.factor * motion.record.acceleration, strict=True)
        lines = ["time [s],acceleration [m/s^2]", *(f"{time:.4f},{value:.8e}" for time, value in rows)]
        (template.parent / "records" / f"{place}.csv").write_text("\n".join(lines))
    with_histories(template)
    _replace(template, ARTIFICIAL, FROM_FILES)


def _replace(template: Path, old: str, new: str) -> None:
    """Replace a line of the template, which must be there: else another thing would be measured."""
    text = template.read_text(encoding="utf-8")
    if old not in text:
        raise ValueError(f"{template} has no {old!r}")
    template.write_text(text.replace(old, new), encoding="utf-8")


def wall_of(task: Task) -> tuple[str, float]:
    """Return the outcome of a wall, and the time of the processor that it took [s]."""
    start = process_time()
    found = find_outcome(build_to_decide(load_tree(project_tree(task), task.path, sha256=task.sha256)))
    return found.outcome.value, process_time() - start


def measured(prepare: Callable[[Path], None], count: int) -> str:
    """Return what so many walls took."""
    with TemporaryDirectory() as folder, ProcessPoolExecutor(PROCESSES) as pool:
        table, template = written_table(Path(folder), count)
        prepare(template)
        start = perf_counter()
        tasks = find_tasks(table, template)
        reading = perf_counter() - start
        list(pool.map(wall_of, tasks[: 2 * PROCESSES]))  # compiles
        start = perf_counter()
        outcomes, seconds = zip(*pool.map(wall_of, tasks, chunksize=8), strict=True)
        took = perf_counter() - start
    outcome = ", ".join(f"{number} {name}" for name, number in sorted(Counter(outcomes).items()))
    each = sum(seconds) / count
    whole = each * ALL / PROCESSES / 60
    return (
        f"{count} walls: {1e3 * each:.0f} ms of a core each, {took:.0f} s in {PROCESSES} processes; {ALL} in "
        f"{whole:.1f} min of {PROCESSES} free cores; table read in {1e3 * reading / count:.2f} ms a row; {outcome}"
    )


def main() -> None:
    """Print the measurements."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else WALLS
    sys.stdout.write(f"accepted methods:   {measured(lambda template: None, count)}\n")
    sys.stdout.write(f"histories, 7 files: {measured(with_files, count)}\n")
    sys.stdout.write(f"histories, 7 made:  {measured(with_histories, count)}\n")


if __name__ == "__main__":
    main()
