"""Cost of a branch: the sums of virtual work of each kind of chain at 500 rotations, and its whole table.

Run as a script. What is asked for is less than 5 ms for 500 points; `table` also searches the overturning rotation.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np

from assess.loads import Force, PointMass, Tie
from assess.mechanisms.chain import Block, Chain
from assess.mechanisms.table import branch
from assess.mechanisms.virtual_work import virtual_work

POINTS = 500
LOWER, UPPER = Block(2000.0, (0.0, 1.3), 1200.0), Block(1600.0, (0.0, 3.4), 600.0)
LEFT, BEAM, RIGHT = (
    Block(6400.0, (0.4, 2.0), 8900.0),
    Block(7000.0, (2.4, 4.9), 15000.0),
    Block(6800.0, (4.1, 2.9), 7100.0),
)
LOADS = (
    PointMass("floor", 900.0, (0.2, 2.5), True),
    PointMass("roof", 400.0, (-0.1, 4.1), False),
    Force("thrust", (900.0, 0.0), (-0.2, 3.0)),
    Tie("tie", 1000.0, (0.2, 3.9), anchor=(-4.0, 4.0)),
)
CHAINS = {
    "single-block": Chain((LOWER,), ((0.4, 0.0),)),
    "single-block with four loads": Chain((LOWER,), ((0.4, 0.0),), LOADS),
    "two-block": Chain((LOWER, UPPER), ((0.25, 0.0), (-0.25, 2.6), (0.25, 4.2))),
    "four-hinge": Chain((LEFT, BEAM, RIGHT), ((0.8, 0.0), (0.0, 4.0), (3.6, 4.6), (4.6, 1.2))),
    "four-hinge with four loads": Chain(
        (LEFT, BEAM, RIGHT), ((0.8, 0.0), (0.0, 4.0), (3.6, 4.6), (4.6, 1.2)), LOADS
    ),
}  # fmt: skip


def milliseconds(work: Callable[[], object]) -> float:
    """The best of twenty."""
    best = math.inf
    for _ in range(20):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return 1e3 * best


def main() -> None:
    """The table."""
    print(f"{'branch':<32}{POINTS} points ms{'table ms':>12}")  # noqa: T201
    phi = np.linspace(0.0, 0.2, POINTS)
    for name, chain in CHAINS.items():
        sums = milliseconds(lambda chain=chain: virtual_work(chain, phi))
        table = milliseconds(lambda chain=chain: branch(chain, restitution=0.9, name="bench"))
        print(f"{name:<32}{sums:>13.2f}{table:>12.2f}")  # noqa: T201


if __name__ == "__main__":
    main()
