"""One block under one sine pulse: the program beside programs that simulate contact."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from assess.dynamics.history import trace
from assess.oscillator import Oscillator, RockingBlock, plain_branch
from records.record import Record
from tools.benchmarks.bench_dynamics import ALPHA, P, g, swings_by_scipy
from tools.benchmarks.peers import engines, opensees
from tools.benchmarks.peers.body import HEIGHT, LENGTH, RESTITUTION, WIDTH, Ran, pulse, swings
from tools.benchmarks.peers.installed import Peer
from tools.benchmarks.peers.measure import Program, Table, measure, silence

Contact = Callable[..., Ran]
SETTINGS: tuple[tuple[str, str, str, Contact, tuple[float, ...]], ...] = (
    ("mujoco", "MuJoCo", "", engines.by_mujoco, (2e-3, 2e-4)),
    ("pybullet", "Bullet", "", engines.by_bullet, (1 / 240, 2e-4)),
    ("openseespy", "OpenSees, fibres without tension", "up to ", opensees.by_fibres, (1e-3, 1e-4)),
    ("openseespy", "OpenSees, RockingBC, 25 GPa", "up to ", opensees.by_rocking_bc, (1e-3,)),
)
"""Package, name, how the step is said, the function, and the steps tried [s]."""


def by_us(record: Record) -> Ran:
    """Solve the exact equation with Housner's restitution; peaks are those at samples, and the largest is exact."""
    side = plain_branch(RockingBlock(1.0, 1.0, ALPHA, g / P**2), restitution=RESTITUTION)
    found = trace(Oscillator(side, side, 1.0), record, scale=1.0, equation="exact")
    return Ran(swings(found.rotation), record.npts - 1)


def table(peers: dict[str, Peer], *, rounds: int, seconds: float) -> Table:
    """Compare the first three swings with those of DOP853 with Housner's restitution."""
    record = pulse()
    reference = swings_by_scipy("exact", record, 3e-14, restitution=RESTITUTION)[:3]
    programs = [Program("this program", "1e-10", partial(by_us, record))]
    programs.append(Program("solve_ivp, DOP853", "1e-08", partial(_by_scipy, record)))
    for package, name, said, contact, steps in SETTINGS:
        module = peers[package].module
        if module is not None:
            programs += [
                Program(name, f"{said}{1e3 * step:.2g} ms", partial(contact, module, record, step)) for step in steps
            ]

    def errors(found: object) -> tuple[float, ...]:
        peaks = found.swings[:3]  # type: ignore[attr-defined]
        return tuple(own / abs(of) - 1.0 for own, of in zip(peaks, reference, strict=False))

    with silence():
        rows = measure(programs, errors, rounds=rounds, seconds=seconds)
    each = ", ".join(
        f"{1e6 * row.least / row.answer.steps:,.2f} µs ({row.program.name})"  # type: ignore[attr-defined]
        for row in {row.program.name: row for row in rows}.values()
    )
    return Table(
        "A block that rocks in contact",
        f"A block of {WIDTH:.2f} x {HEIGHT:.2f} m under one cycle of a sine, three times what starts it, and rest, "
        f"{LENGTH:g} s in all; building the model is included. Swings: the first before any impact, the second the "
        f"largest, the third after two impacts. Reference: DOP853 at 3e-14 with Housner's restitution, "
        f"{RESTITUTION:.3f}, which the programs of contact are not told; what they lose at an impact is their own, so "
        "a difference of the third swing is one of models too. "
        "The member of RockingBC deforms: part of its difference is the elasticity of its foot.",
        ("error of the first swing", "second", "third"),
        rows,
        (f"A step costs {each}; time grows in proportion to the steps and to the number of histories.",),
    )  # fmt: skip


def _by_scipy(record: Record) -> Ran:
    """Solve by DOP853 at a looser tolerance than the reference."""
    found = swings_by_scipy("exact", record, 1e-8, restitution=RESTITUTION)
    return Ran(tuple(map(abs, found)), record.npts - 1)
