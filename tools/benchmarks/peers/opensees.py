"""The block in OpenSees, by two of its public elements.

A `zeroLengthSection` of two fibres without tension under a stiff corotational column, time steps of HHT, and damping
of the contact in proportion to its present stiffness, so that only a fibre in compression is damped. The section takes
small rotations: its hinges are right to the first order.

`RockingBC` of Avgenakis and Psycharis (2020, EESD 49, 1072-1094), set as in the example that comes with OpenSees, with
its defaults for the rate of the axial force, and a step shortened at impacts as that example does. It is a member that
deforms, of 25 GPa here; its foot tilts before it lifts, so it swings further. With a hundred times that, the first
swing is 1.3 % too large in place of 5.7 %, at several times the cost.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from types import ModuleType

from scipy.constants import g

from records.record import Record
from tools.benchmarks.peers.body import HEIGHT, INERTIA, LENGTH, MASS, WIDTH, Ran, swings

STIFFNESS, DAMPING, ALPHA_HHT = 1e11, 1.0, 0.9  # N/m of both fibres, of critical [-], [-]
RIGID = 1e12
STRAIN = 5e-6  # of the block's foot under its own weight, in the example of RockingBC
FRICTION = 0.0  # no sliding, in that example
POINTS, CRITICAL = 15, 0.05  # of the interface, of critical damping, in that example
SHORTEST = 1e-8  # s
RATES = (0.1, 10.0)  # defaults of RockingBC: changes of the axial force in a step, over the weight


def by_fibres(opensees: ModuleType, record: Record, step: float) -> Ran:
    """Rock a column on two fibres."""
    opensees.wipe()
    opensees.model("basic", "-ndm", 2, "-ndf", 3)
    for tag, height in ((1, 0.0), (2, 0.0), (3, HEIGHT / 2)):
        opensees.node(tag, 0.0, height)
    opensees.fix(1, 1, 1, 1)
    opensees.fix(2, 1, 0, 0)
    opensees.uniaxialMaterial("ENT", 1, STIFFNESS)
    opensees.section("Fiber", 1)
    for place in (-WIDTH / 2, WIDTH / 2):
        opensees.fiber(place, 0.0, 0.5, 1)
    opensees.element("zeroLengthSection", 1, 1, 2, 1, "-orient", 0, 1, 0, -1, 0, 0, "-doRayleigh", 1)
    opensees.region(1, "-ele", 1, "-rayleigh", 0.0, 2 * DAMPING / math.sqrt(STIFFNESS / MASS), 0.0, 0.0)
    opensees.geomTransf("Corotational", 1)
    opensees.element("elasticBeamColumn", 2, 2, 3, 1.0, RIGID, 1.0, 1)
    _load(opensees, 3)
    _analysis(opensees, ("NormDispIncr", 1e-10, 50), ("LoadControl", 0.1), "Static")
    opensees.analyze(10)
    _shake(opensees, record)
    _analysis(opensees, ("NormDispIncr", 1e-10, 50), ("HHT", ALPHA_HHT), "Transient")
    return _shortened(opensees, 3, step, calm=lambda: True)


def by_rocking_bc(opensees: ModuleType, record: Record, step: float) -> Ran:
    """Rock a member on the element made for it; `step` is the longest."""
    weight = MASS * g / WIDTH  # Pa, on the foot
    opensees.wipe()
    opensees.model("basic", "-ndm", 2, "-ndf", 3)
    for tag, height in ((1, 0.0), (2, HEIGHT / 2), (3, HEIGHT)):
        opensees.node(tag, 0.0, height)
    opensees.element(
        "RockingBC", 1, 2, 1, POINTS, weight / STRAIN, 0.0, -weight / 5e-3, WIDTH, 1.0, FRICTION, "-convlim", 1e-14,
        "-NlimN", RATES[0], "-NlimT", RATES[1], "-Dtlim", SHORTEST, "-errorifNexceeds", 1,
    )  # fmt: skip
    opensees.geomTransf("Corotational", 1)
    opensees.element("elasticBeamColumn", 2, 2, 3, WIDTH, weight / STRAIN, WIDTH**3 / 12, 1)
    opensees.fix(1, 1, 1, 1)
    _load(opensees, 2)
    _analysis(opensees, ("EnergyIncr", 1e-10, 100), ("LoadControl", 0.1), "Static")
    opensees.analyze(10)
    opensees.rayleigh(0.0, 2 * CRITICAL / math.sqrt(opensees.eigen("-fullGenLapack", 1)[0]), 0.0, 0.0)
    _shake(opensees, record)
    _analysis(opensees, ("RelativeNormUnbalance", 1e-10, 100), ("Newmark", 0.5, 0.25), "Transient")
    names = ("forceratioNmax", "forceratioTmax")
    return _shortened(
        opensees,
        2,
        step,
        calm=lambda: all(
            opensees.eleResponse(1, name)[0] < 0.9 * most for name, most in zip(names, RATES, strict=True)
        ),
    )


def _shortened(opensees: ModuleType, node: int, longest: float, *, calm: Callable[[], bool]) -> Ran:
    """Step through the motion: half the step where one fails, half as much again after ten that do not."""
    rotation, step, good = [0.0], longest, 0
    while opensees.getTime() < LENGTH:
        if opensees.analyze(1, step) != 0:
            if step <= SHORTEST:
                return Ran((), len(rotation))
            step, good = max(SHORTEST, 0.5 * step), 0
            continue
        rotation.append(opensees.nodeDisp(node, 3))
        good += 1
        if good >= 10 and calm():
            step = min(longest, 1.5 * step)
    return Ran(swings(rotation), len(rotation))


def _load(opensees: ModuleType, tag: int) -> None:
    """Give the mass and the weight to the centroid."""
    opensees.mass(tag, MASS, MASS, INERTIA)
    opensees.timeSeries("Linear", 1)
    opensees.pattern("Plain", 1, 1)
    opensees.load(tag, 0.0, -MASS * g, 0.0)


def _analysis(
    opensees: ModuleType, test: tuple[str, float, int], integrator: tuple[str, *tuple[float, ...]], kind: str
) -> None:
    """Set how each step is solved."""
    opensees.wipeAnalysis()
    opensees.constraints("Transformation")
    opensees.numberer("RCM")
    opensees.system("UmfPack")
    opensees.test(*test)
    opensees.algorithm("Newton")
    opensees.integrator(*integrator)
    opensees.analysis(kind)


def _shake(opensees: ModuleType, record: Record) -> None:
    """Hold the weight, and move the ground."""
    opensees.loadConst("-time", 0.0)
    opensees.timeSeries("Path", 2, "-dt", record.dt, "-values", *record.acceleration.tolist())
    opensees.pattern("UniformExcitation", 2, 1, "-accel", 2)
