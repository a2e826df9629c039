"""`python -m tools.benchmarks.peers`: measure this program beside others; into docs/speed.md with `--write`."""

from __future__ import annotations

import argparse
import os
import sys
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")  # before numpy: every program has one core

from tools.benchmarks.peers import blocks, histories, models, page, picture, spectra  # noqa: E402
from tools.benchmarks.peers.installed import find  # noqa: E402

PACKAGES = {
    "pyrotd": "pyrotd", "eqsig": "eqsig.sdof", "trimesh": "trimesh", "openseespy": "openseespy.opensees",
    "mujoco": "mujoco", "pybullet": "pybullet",
}  # fmt: skip
"""Package -> the module of it that is used."""


def main() -> None:
    """Measure, print the tables, and write them if so asked."""
    asked = parser().parse_args()
    rounds, seconds = (1, 0.0) if asked.quick else (asked.rounds, asked.seconds)
    npts, triangles = (500, 25_000) if asked.quick else (2000, 500_000)
    peers = {package: find(package, module) for package, module in PACKAGES.items()}
    start = time.perf_counter()
    tables = []
    for question in (
        lambda: histories.table("linearised", rounds=rounds, seconds=seconds, npts=npts),
        lambda: histories.table("exact", rounds=rounds, seconds=seconds, npts=npts),
        lambda: blocks.table(peers, rounds=rounds, seconds=seconds),
        lambda: spectra.table(peers["pyrotd"], peers["eqsig"], rounds=rounds, seconds=seconds),
        lambda: models.table(peers["trimesh"], rounds=rounds, seconds=seconds, triangles=triangles),
    ):
        tables.append(question())
        print(f"{time.perf_counter() - start:5.0f} s  {tables[-1].title}", file=sys.stderr, flush=True)  # noqa: T201
    command = " ".join(["python -m tools.benchmarks.peers", *sys.argv[1:]])
    text = page.measured(tables, list(peers.values()), seconds=time.perf_counter() - start, command=command)
    print(text)  # noqa: T201
    if asked.write:
        page.write(text)
        picture.draw(tables)


def parser() -> argparse.ArgumentParser:
    """Return the options."""
    made = argparse.ArgumentParser(prog="python -m tools.benchmarks.peers", description=__doc__)
    made.add_argument("--rounds", type=int, default=7, help="how often each program is measured, at most")
    made.add_argument("--seconds", type=float, default=3.0, help="a program that had so many is not measured again")
    made.add_argument("--quick", action="store_true", help="small, once each: to try the command, not to quote")
    made.add_argument("--write", action="store_true", help="write docs/speed.md and docs/images/speed.svg")
    return made


if __name__ == "__main__":
    main()
