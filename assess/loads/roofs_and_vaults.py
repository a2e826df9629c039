"""Roofs and vaults of a project as arches of three hinges: their weight, and their thrust on a block."""

from __future__ import annotations

from dataclasses import dataclass

from assess.geometry.roof_shape import extent, height, mean_lever_arm, slope, underside
from assess.geometry.solid import Solid
from assess.loads.definitions import BodyLoad
from assess.loads.thrust import CONSTRUCTIONS, arch_thrust, uniform_lever_arm
from assess.messages.message import Message, Quantity, Term, Value, message
from spectra.arrays import FloatArray

SINGLE = 0.5  # one-sidedness above which a roof has a single slope
SQUARE = 0.02  # cosine: a covering that spans within a degree of square to the motion has no thrust along it


@dataclass(frozen=True)
class Arch:
    """A roof or vault as an arch of three hinges, with the source of its measures.

    axis : horizontal unit vector along which it thrusts, to the side of the motion [3]; span, rise : [m]
    lever : mean distance of its weight from the nearer springing [m]
    """

    axis: FloatArray
    span: float
    rise: float
    lever: float
    source: list[Term | Message]


@dataclass(frozen=True)
class Thrust:
    """The thrust along the motion [N], positive with it, and how it was found; 0, and why there is none."""

    size: float
    source: list[Term | Message]


def arch_of(load: BodyLoad, body: Solid, *, along: FloatArray) -> Arch | None:
    """Return a roof or vault as an arch; None if it is flat or slopes one way only: a beam, without thrust.

    A barrel vault or gable roof thrusts along its slope, a quadripartite vault or hipped roof along any motion.

    along : unit vector of the motion [3]
    """
    falls = slope(body)
    if falls.axis is None:
        return None
    every_way = falls.both_ways if load.vault is None else load.vault == "quadripartite"
    if not every_way and falls.one_sided > SINGLE:
        return None
    axis = along if every_way else falls.axis if falls.axis @ along >= 0.0 else -falls.axis
    low, high = extent(body, axis=axis)
    span, rise = load.span or high - low, load.rise or height(body)
    own = uniform_lever_arm(span) if load.role == "roof" else _vault_lever(load, body, axis=axis, span=span)
    measures = (("L", span, load.span), ("f", rise, load.rise))
    source: list[Term | Message] = [
        message("load-measure-given" if given else "load-measure", {"symbol": sign, "size": Quantity(size, "length")})
        for sign, size, given in measures
    ]
    return Arch(axis, span, rise, own, source)


def weight(load: BodyLoad, body: Solid | None, *, mass: float) -> tuple[float, Term | Message]:
    """Return the mass of the whole body [kg] and its source; mass: by its volume or as given for the body [kg]."""
    if load.mass is not None:
        values: dict[str, Value] = {"mass": Quantity(load.mass, "mass"), "table": Quantity(mass, "mass")}
        return load.mass, message("load-mass-given", values)
    if body is None:
        return mass, message("load-mass-direct", {"mass": Quantity(mass, "mass")})
    shell, fill = _vault_masses(load, body)
    area, plan = underside(body)
    own: Term | Message = Term("its volume")
    if load.construction is not None:
        built = CONSTRUCTIONS[load.construction]
        shelled: dict[str, Value] = {
            "case": str(load.construction),
            "name": Term(built.name),
            "thickness": Quantity(built.thickness, "length", 6),
            "density": Quantity(built.density, "density", 6),
            "area": Quantity(area, "area"),
        }
        own = message("load-ungewitter", shelled)
    if load.fill is not None:
        filled = {"fill": Quantity(load.fill, "area density", 6), "plan": Quantity(plan, "area")}
        own = message("load-with-fill", {"own": own, **filled})
    return shell + fill, message("load-mass", {"mass": Quantity(shell + fill, "mass"), "own": own})


def thrust_of(load: BodyLoad, arch: Arch | None, *, along: FloatArray, V: float) -> Thrust:
    """Return the thrust along the motion of a roof or vault whose vertical reaction on the block is V [N]."""
    if load.thrust is not None:
        return Thrust(load.thrust, [Term("thrust (given)")])
    if load.tied:
        return Thrust(0.0, [Term("no thrust: tied (given)")])
    if arch is None:
        return Thrust(0.0, [Term("no thrust: it is flat or slopes one way only, like a beam")])
    cosine = float(arch.axis @ along)
    if cosine < SQUARE:
        return Thrust(0.0, [Term("no thrust along the motion: its ridge runs that way, it spans across")])
    H = arch_thrust(V, lever=arch.lever, rise=arch.rise)
    values: dict[str, Value] = {
        "V": Quantity(V, "force"),
        "x": Quantity(arch.lever, "length"),
        "f": Quantity(arch.rise, "length"),
        "H": Quantity(H, "force"),
    }
    said = [message("load-thrust", values), *arch.source, _spread(load, arch, V=V)]
    along_motion = message("load-along-motion", {"force": Quantity(H * cosine, "force")})
    return Thrust(H * cosine, said if cosine > 0.9999 else [*said, along_motion])


def _spread(load: BodyLoad, arch: Arch, *, V: float) -> Term | Message:
    """Say how the weight is spread over the span, and the thrust if it were uniform in plan."""
    if load.role == "roof":
        return Term("rafters: x = L / 4")
    even = arch_thrust(V, lever=uniform_lever_arm(arch.span), rise=arch.rise)
    return message("load-lever-of-vault", {"even": Quantity(even, "force")})


def _vault_lever(load: BodyLoad, body: Solid, *, axis: FloatArray, span: float) -> float:
    """Return the lever arm of half a vault's weight about its springing [m]: of the mesh, and of uniform fill."""
    low, high = extent(body, axis=axis)
    own = mean_lever_arm(body, axis=axis) * span / (high - low)
    shell, fill = _vault_masses(load, body)
    return (shell * own + fill * uniform_lever_arm(span)) / (shell + fill)


def _vault_masses(load: BodyLoad, body: Solid) -> tuple[float, float]:
    """Return the mass of a vault itself, and of what lies on it [kg]."""
    area, plan = underside(body)
    shell = body.mass if load.construction is None else area * CONSTRUCTIONS[load.construction].mass_per_area
    return shell, plan * (load.fill or 0.0)
