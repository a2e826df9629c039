"""Cost of a branch: the sums of virtual work of each kind of chain at 500 rotations, and its whole table.

Run as a script. The target is below 5 ms for 500 points; `branch_from_rest` also finds the overturning rotation.
On flexible joints the whole table of a block is to take less than 5 ms, and a history not much more for each step than
on rigid ones: both rock through one violent record at the same scales, on one core.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from bench_dynamics import violent
from scipy.constants import g

from assess.dynamics.history import peaks, product
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.branch_table import rigid_branch, single_stage
from assess.mechanisms.chain import Chain, Joint, RigidBlock, virtual_work
from assess.mechanisms.flexible_oscillator import branch_from_rest, make_flexible_side
from assess.oscillator import Branch, Oscillator
from records.record import Record

POINTS = 500
LOWER, UPPER = RigidBlock(2000.0, (0.0, 1.3), 1200.0), RigidBlock(1600.0, (0.0, 3.4), 600.0)
LEFT, BEAM, RIGHT = (
    RigidBlock(6400.0, (0.4, 2.0), 8900.0),
    RigidBlock(7000.0, (2.4, 4.9), 15000.0),
    RigidBlock(6800.0, (4.1, 2.9), 7100.0),
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


OVER = Force("overburden", (0.0, -30000.0), (0.25, 4.2), 1)
WAYS = {
    "single-block": ((-1,), 0.8, ()),
    "two-block": ((-1, 1, -1), 0.5, (OVER,)),
    "four-hinge": ((-1, 1, 1, -1), 0.8, ()),
}
STIFFNESS, STRENGTH = (0.2e9, 1e9, 10e9), 2e6  # [Pa/m], [Pa]
SCALES = np.linspace(0.3, 1.0, 20)


def jointed(kind: str, stiffness: float) -> Chain:
    """The chain of a kind, a metre long, on flexible joints."""
    chain, (ways, depth, loads) = CHAINS[kind], WAYS[kind]
    law = JointLaw(stiffness, STRENGTH)
    joints = tuple(Joint((float(way), 0.0), rectangle(depth, 1.0), law, "flexible") for way in ways)
    return Chain(chain.blocks, chain.hinges, loads, joints=joints)


def flexible_branch(chain: Chain) -> Branch:
    """The whole table on flexible joints."""
    return branch_from_rest(make_flexible_side(single_stage(chain), name="bench", restitution=0.9), None)


def nanoseconds(side: Branch, record: Record) -> float:
    """Of each step of a history."""
    bodies, jobs = [Oscillator(side, side, 1.0)], product(1, 1, SCALES)

    def work() -> object:
        return peaks(bodies, [record], jobs, equation="exact", threads=1)

    return 1e6 * milliseconds(work, times=5) / (SCALES.size * record.npts)


def milliseconds(work: Callable[[], object], *, times: int = 20) -> float:
    """The best of some times."""
    best = math.inf
    for _ in range(times):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return 1e3 * best


def flexible() -> None:
    """The table of flexible joints."""
    names = f"{'on flexible joints':<32}{'GPa/m':>7}{'nodes':>8}"
    print(f"\n{names}{'table ms':>12}{'history ns/step':>18}{'over rigid':>12}")  # noqa: T201
    record = violent()
    for kind in WAYS:
        rigid = rigid_branch(
            Chain(CHAINS[kind].blocks, CHAINS[kind].hinges, WAYS[kind][2]), restitution=0.9, name="bench"
        )
        lifts = rigid.restoring[0] / rigid.excitation[0]
        motion = replace(record, acceleration=record.acceleration / g * 4.0 * lifts)  # the same violence for all
        base = nanoseconds(rigid, motion)
        print(f"{kind:<32}{'rigid':>7}{rigid.rotation.size:>8}{'':>12}{base:>18.0f}{1.0:>12.2f}")  # noqa: T201
        for stiffness in STIFFNESS:
            chain = jointed(kind, stiffness)
            side, step = flexible_branch(chain), nanoseconds(flexible_branch(chain), motion)
            cost = milliseconds(lambda chain=chain: flexible_branch(chain))
            print(f"{'':<32}{stiffness / 1e9:>7g}{side.rotation.size:>8}{cost:>12.2f}{step:>18.0f}{step / base:>12.2f}")  # noqa: T201


def main() -> None:
    """The tables."""
    print(f"{'branch':<32}{POINTS} points ms{'table ms':>12}")  # noqa: T201
    phi = np.linspace(0.0, 0.2, POINTS)
    for name, chain in CHAINS.items():
        sums = milliseconds(lambda chain=chain: virtual_work(chain, phi))
        whole = milliseconds(lambda chain=chain: rigid_branch(chain, restitution=0.9, name="bench"))
        print(f"{name:<32}{sums:>13.2f}{whole:>12.2f}")  # noqa: T201
    flexible()


if __name__ == "__main__":
    main()
