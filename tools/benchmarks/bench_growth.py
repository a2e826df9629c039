"""What must not take long whatever is asked: seconds at a size, and how they grow when it is four times that.

Run as a module. A ratio near 4 is in proportion to the size; one near 16 is a loop over pairs. The last lines set the
command's help beside the import of its parser alone, and the key of the compiled kernels beside nothing.
"""

from __future__ import annotations

import math
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from assess.geometry.contact import find_contact
from assess.geometry.planar import planar_body
from assess.geometry.solid import box
from assess.mechanisms.single_block import single_block
from assess.project.project_file import load
from records.candidates import PERIODS, Candidate
from records.compilation import sources_key
from records.pulses import primary_pulses
from records.record import make_record
from records.scaling import band
from records.selection import SuiteCriteria, event_groups, select
from reports.render.pdf_blocks import formula
from spectra.asce7 import design_spectrum
from tests.support.projects import published, tables_toml
from tests.support.solids import refine_mesh

TARGET = design_spectrum(s_ds=5.0, s_d1=2.0, t_l=6.0)
HELP = "from assess.cli import main; main()"


def candidates(count: int) -> list[Candidate]:
    """Records of as many earthquakes, with smooth spectra about the target's."""
    made = []
    for number in range(count):
        rng = np.random.default_rng(number)
        smooth = np.interp(np.arange(PERIODS.size), np.linspace(0, PERIODS.size - 1, 9), rng.normal(0.0, 0.5, 9))
        spectrum = TARGET.acceleration(PERIODS) * np.exp(rng.normal(0.0, 1.0) + smooth)
        made.append(
            Candidate(
                path=f"{number}.AT2",
                position=0,
                id=str(number),
                event=f"event {number}",
                station="",
                component="000",
                date="",
                place="",
                magnitude=6.0,
                distance=1e4,
                vs30=None,
                nga=None,
                dt=0.01,
                npts=2000,
                measures={"pga": float(spectrum[0]), "d5_95": 10.0},
                spectrum=spectrum,
            )
        )
    return made


def group_events(count: int) -> Callable[[], object]:
    """Recordings of one earthquake among many, a fiftieth of them twice."""
    one = [(each,) for each in candidates(count)]
    return partial(event_groups, [*one, *one[: count // 50]], one_per_event=False)


def select_records(count: int) -> Callable[[], object]:
    """Seven of a catalogue."""
    return partial(select, candidates(count), TARGET, SuiteCriteria(7, band(0.2, 2.0)))


def find_pulses(count: int) -> Callable[[], object]:
    """The primary pulse of a record."""
    record = make_record("long", np.random.default_rng(1).normal(size=count), 0.005)
    return partial(primary_pulses, record)


def analyse_mesh(times: int) -> Callable[[], object]:
    """A solid of 12 triangles in four, as often as that, and its oscillator."""
    solid = refine_mesh(box(thickness=0.6, length=4.0, height=4.0, base=(0, 0, 0), density=1000.0, name="wall"), times)
    return lambda: single_block("wall", planar_body(solid, direction=(1.0, 0.0, 0.0))).oscillator


def touch_meshes(times: int) -> Callable[[], object]:
    """A wall and a floor against it."""
    wall = box(thickness=0.6, length=4.0, height=4.0, base=(0, 0, 0), density=1000.0, name="wall")
    floor = box(thickness=4.7, length=2.0, height=0.2, base=(2.65, 0, 2), density=1000.0, name="floor")
    return partial(find_contact, refine_mesh(wall, times), refine_mesh(floor, times - 1))


def read_project(count: int, *, folder: Path) -> Callable[[], object]:
    """A project file of as many mechanisms."""
    mechanisms = {f"w{i}": published(f"{1 + 0.01 * i:.2f} 1/s", "0.1", "3 m") for i in range(count)}
    (path := folder / f"{count}.toml").write_text(tables_toml(mechanisms=mechanisms))
    return partial(load, path)


def set_hostile(count: int) -> Callable[[], object]:
    """A text that almost is a formula with indices and powers, on a page."""
    return partial(formula, "a_(^{<&" * count)


def best(work: Callable[[], object], *, times: int = 3) -> float:
    """Seconds, the best of some times."""
    found = math.inf
    for _ in range(times):
        start = time.perf_counter()
        work()
        found = min(found, time.perf_counter() - start)
    return found


def command(program: str, *arguments: str) -> Callable[[], object]:
    """Python with a program."""
    return partial(subprocess.run, [sys.executable, "-c", program, *arguments], check=True, capture_output=True)


def main() -> None:
    """The table."""
    print(f"{'what':<44}{'size':>8}{'seconds':>12}{'at 4 times':>12}{'ratio':>8}")  # noqa: T201
    with tempfile.TemporaryDirectory() as folder:
        for what, make, size, larger in (
            ("recordings grouped by earthquake", group_events, 1250, 5000),
            ("seven records of a catalogue", select_records, 2500, 10_000),
            ("primary pulse, samples", find_pulses, 2500, 10_000),
            ("mesh to oscillator, cut in four n times", analyse_mesh, 6, 7),
            ("contact of two meshes, cut in four n times", touch_meshes, 5, 6),
            ("project file, mechanisms", partial(read_project, folder=Path(folder)), 25, 100),
            ("hostile text, set as a formula", set_hostile, 7500, 30_000),
        ):
            few, many = best(make(size)), best(make(larger))
            print(f"{what:<44}{size:>8}{few:>12.4f}{many:>12.4f}{many / few:>8.1f}")  # noqa: T201
    helped, typer = best(command(HELP, "--help")), best(command("import typer"))
    print(f"{'assess --help, over importing typer alone':<52}{helped:>12.3f}{typer:>12.3f}{helped / typer:>8.2f}")  # noqa: T201
    print(f"{'key of the compiled kernels':<52}{best(partial(sources_key, ()), times=20):>12.5f}")  # noqa: T201


if __name__ == "__main__":
    main()
