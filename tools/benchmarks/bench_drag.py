"""What a drag of a crack takes: 500 places and angles of that of the spire, its mesh in 1,152 triangles and 50,000.

    python -m tools.benchmarks.bench_drag [DRAGS]

Milliseconds of each stage from the values of the file to the answers, median and 95 % of all drags and the median of
processor time, which other work on the machine moves little; and of the outcome by histories of seven records, which is
asked for where the crack is let go. Wanted of 50,000 triangles at the 95 %:
multiplier and drawing in 60, all static answers in 150, the outcome by histories in 300.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from math import radians, sin
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from assess.codes.procedures import uses_histories
from assess.examples import copy_example
from assess.geometry.cut import divide
from assess.geometry.solid import Solid
from assess.mechanisms.single_block import SingleBlock
from assess.model.bodies import cut_of
from assess.project.build import BuiltProject, build_with_cases
from assess.project.keys import Setting, read_content, with_values
from assess.project.project_file import load
from assess.project.site_and_structure import definitions_of
from assess.study.assessment import checks_without_twins
from assess.study.mechanism_results import parameters
from assess.study.run import find_outcome
from assess.study.study import Study

NAME, BODY = "spire-half", "spire"
STAGES = ("values read", "cut", "mechanism", "curve and drawing", "checks by spectra")
EVERY = 25  # drags between two releases


def refine(solid: Solid, parts: int) -> tuple[np.ndarray, np.ndarray]:
    """Return a surface with each edge in so many parts and each triangle in their square."""
    rows = [(i, j) for i in range(parts + 1) for j in range(parts + 1 - i)]
    number = {place: k for k, place in enumerate(rows)}
    weights = np.array([(parts - i - j, i, j) for i, j in rows]) / parts
    up = [(number[i, j], number[i + 1, j], number[i, j + 1]) for i, j in rows if i + j < parts]
    down = [(number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]) for i, j in rows if i + j < parts - 1]
    points = (weights @ solid.vertices[solid.triangles]).reshape(-1, 3)
    _, first, index = np.unique(points.round(9), axis=0, return_index=True, return_inverse=True)
    faces = np.array(up + down) + len(rows) * np.arange(len(solid.triangles))[:, None, None]
    return points[first], index.reshape(-1)[faces.reshape(-1, 3)]


def write_off(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> None:
    """Write a mesh in double precision."""
    with path.open("w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        np.savetxt(file, vertices, fmt="%.17g")
        np.savetxt(file, np.column_stack([np.full(len(triangles), 3), triangles]), fmt="%d")


def opened(folder: Path, parts: int) -> BuiltProject:
    """Return the spire, judged by histories, with the edges of its mesh in so many parts."""
    file = copy_example("san_leonardo_spire", folder)
    text = file.read_text(encoding="utf-8").replace(
        'basis = "ntc2018"', 'basis = "ntc2018"\nprocedures = ["ntc2018-history"]'
    )
    file.write_text(text, encoding="utf-8")
    solid = build_with_cases(load(file)).solids[BODY]
    assert solid is not None
    write_off(folder / "spire.off", *refine(solid, parts))
    file.write_text(text.replace("spire.ply", "spire.off"), encoding="utf-8")
    return build_with_cases(load(file))


def settings(count: int) -> Iterator[Setting]:
    """Yield places and angles of the crack, none twice: its right end lies on the face of the spire."""
    for k in range(count):
        z, angle = 20.25 + 0.8 * sin(0.05 * k), radians(50.0 + 14.0 * sin(0.031 * k))
        yield {("mechanisms", NAME, "cut"): {"point": [0.19 * (22.25 - z), 0.0, z], "angle": f"{angle:.9g} rad"}}


def statics(built: BuiltProject, setting: Setting) -> tuple[np.ndarray, Study]:
    """Return the seconds of each stage, by the clock and of processors, and the study."""
    project, times = built.project, [clocks()]
    content = read_content(with_values(project.raw, setting, project.content), project.folder)
    times.append(clocks())
    definition, solid = definitions_of(content)[NAME], built.solids[BODY]
    assert isinstance(definition, SingleBlock)
    assert solid is not None
    where = f'mechanism "{NAME}": cut'
    plane = cut_of(definition, where=where)
    assert plane is not None
    divide((solid,), plane, where=where)  # which is kept for the mechanism
    times.append(clocks())
    study = built.study_at(content, (NAME,))
    times.append(clocks())
    parameters(study)
    times.append(clocks())
    assert study.spectrum is not None
    asked = tuple(each for each in study.procedures if not uses_histories(each))
    checks_without_twins(replace(study, procedures=asked), study.spectrum, (), jobs=1)
    times.append(clocks())
    return np.diff(times, axis=0), study


def clocks() -> tuple[float, float]:
    """Return the time now and that of processors [s]."""
    return time.perf_counter(), time.process_time()


def row(name: str, seconds: np.ndarray) -> str:
    """One line of the table, in milliseconds, of times [n, 2] [s]."""
    passed, worked = 1e3 * seconds.T
    return f"{name:<28}{np.median(passed):>10.1f}{np.percentile(passed, 95.0):>10.1f}{np.median(worked):>12.1f}"


def main(count: int) -> None:
    """The table."""
    for parts in (1, 7):
        with TemporaryDirectory() as folder:
            built = opened(Path(folder) / "project", parts)
            solid = built.solids[BODY]
            assert solid is not None
            every, released = [], []
            for k, setting in enumerate(settings(count + EVERY)):  # of which the first are not counted
                seconds, study = statics(built, setting)
                if k >= EVERY:
                    every.append(seconds)
                if k % EVERY == 0:
                    start = clocks()
                    find_outcome(study, jobs=0)
                    released.append(np.subtract(clocks(), start))
        stages = np.array(every)
        load = os.getloadavg()[0]
        print(f"{len(solid.triangles):,} triangles, {len(every)} drags, load {load:.1f}, milliseconds")  # noqa: T201
        print(f"{'':<28}{'median':>10}{'95 %':>10}{'processor':>12}")  # noqa: T201
        for stage, seconds in zip(STAGES, stages.swapaxes(0, 1), strict=True):
            print(row(stage, seconds))  # noqa: T201
        print(row("multiplier and drawing", stages[:, :4].sum(axis=1)))  # noqa: T201
        print(row("all static answers", stages.sum(axis=1)))  # noqa: T201
        print(row("outcome by histories", np.array(released[1:])))  # noqa: T201


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 500)
