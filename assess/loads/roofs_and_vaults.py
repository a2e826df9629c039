"""Roofs and vaults as arches of three hinges: what they are built of, their weight, and their thrust (thesis 3.2.2).

A pair of rafters, or the two halves of a vault, lean on each other at the ridge or crown and stand on springings: an
arch with three hinges. At the crown of a symmetric one only a horizontal force H acts between the halves, which each
springing returns as the thrust; V, half the weight W, is the springing's vertical reaction. Moments of one half about
its springing, its weight at the distance x from there, the crown at the rise f above:

              crown
            H -->o<-- H                      V x = H f
            .    |    .
          .   V  |      .                    weight even over the plan of span L:  x = L / 4,  H = W L / (8 f)
       H o--x-->         o H
         V <--- L ---> V

So the thrust follows the vertical reaction of the springing: a wall that carries a part of it takes that part of H.
For the bay of a quadripartite vault the same equilibrium holds for half the bay, cut along its ridge: the thrust is
that of both its corners together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from assess.errors import GeometryError
from assess.geometry.cut import split_upright
from assess.geometry.solid import Solid
from assess.geometry.surface import areas_and_normals
from assess.loads.load import BodyLoad
from assess.messages.message import Message, Quantity, Term, Value, message
from spectra.arrays import FloatArray

SINGLE_SLOPE = 0.5  # one-sidedness above which a roof has a single slope
SPANS_ACROSS = 0.02  # cosine: a roof or vault that spans within a degree of square to the motion has no thrust along it


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
    falls = roof_slope(body)
    if falls.axis is None:
        return None
    every_way = falls.both_ways if load.vault is None else load.vault == "quadripartite"
    if not every_way and falls.one_sided > SINGLE_SLOPE:
        return None
    axis = along if every_way else falls.axis if falls.axis @ along >= 0.0 else -falls.axis
    low, high = extent_along(body, axis=axis)
    span, rise = load.span or high - low, load.rise or overall_height(body)
    own = uniform_lever_arm(span) if load.role == "roof" else _vault_lever(load, body, axis=axis, span=span)
    measures = (("L", span, load.span), ("f", rise, load.rise))
    source: list[Term | Message] = [
        message("load-measure-given" if given else "load-measure", {"symbol": sign, "size": Quantity(size, "length")})
        for sign, size, given in measures
    ]
    return Arch(axis, span, rise, own, source)


def leans_one_way(load: BodyLoad, body: Solid, *, direction: Sequence[float] | None) -> bool:
    """Return whether a roof slopes one way only, along a motion: it pushes where nothing holds its upper end.

    Parameters
    ----------
    load, body : the load that it is, and its solid
    direction : of the motion, horizontal [3]; None where it is not stated, and any counts
    """
    falls = roof_slope(body)
    if load.role != "roof" or falls.axis is None or falls.both_ways or falls.one_sided <= SINGLE_SLOPE:
        return False
    along = None if direction is None else np.array(direction) / np.linalg.norm(direction)
    return along is None or abs(float(falls.axis @ along)) >= SPANS_ACROSS


def body_mass(load: BodyLoad, body: Solid | None, *, mass: float) -> tuple[float, Term | Message]:
    """Return the mass of the whole body [kg] and its source; mass: by its volume or as given for the body [kg]."""
    if load.mass is not None:
        values: dict[str, Value] = {"mass": Quantity(load.mass, "mass"), "table": Quantity(mass, "mass")}
        return load.mass, message("load-mass-given", values)
    if body is None:
        return mass, message("load-mass-direct", {"mass": Quantity(mass, "mass")})
    shell, fill = _vault_masses(load, body)
    area, plan = intrados_area(body)
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
    if cosine < SPANS_ACROSS:
        return Thrust(0.0, [Term("no thrust along the motion: its ridge runs that way, it spans across")])
    H = arch_thrust(V, lever=arch.lever, rise=arch.rise)
    values: dict[str, Value] = {
        "V": Quantity(V, "force"),
        "x": Quantity(arch.lever, "length"),
        "f": Quantity(arch.rise, "length"),
        "H": Quantity(H, "force"),
    }
    source = [message("load-thrust", values), *arch.source, _lever_source(load, arch, V=V)]
    along_motion = message("load-along-motion", {"force": Quantity(H * cosine, "force")})
    return Thrust(H * cosine, source if cosine > 0.9999 else [*source, along_motion])


@dataclass(frozen=True)
class Construction:
    """What a vault is built of: name, thickness [m], density [kg/m3]."""

    name: str
    thickness: float
    density: float

    @property
    def mass_per_area(self) -> float:
        """The mass of the vault per area of its surface [kg/m2]."""
        return self.thickness * self.density


LIGHT_BRICK, STRONG_BRICK, SANDSTONE, RUBBLE = 1300.0, 1800.0, 2250.0, 2200.0  # kg/m3

CONSTRUCTIONS: Mapping[int, Construction] = {
    1: Construction("1/2 lightweight brick", 0.125, LIGHT_BRICK),
    2: Construction("1/2 strong brick, or 3/4 lightweight brick", 0.125, STRONG_BRICK),
    3: Construction("3/4 strong brick, or 1 lightweight brick", 0.190, STRONG_BRICK),
    4: Construction("1 strong brick, or 200 mm sandstone", 0.250, STRONG_BRICK),
    5: Construction("300 mm rubble", 0.300, RUBBLE),
}
"""The five cases of Ungewitter and Mohrmann (1901) with their thicknesses, as thesis 3.2.2 lists them.

The densities are assumptions: usual ones for which the two constructions of a case weigh nearly the same (case 2:
225 and 247 kg/m2, case 3: 342 and 325, case 4: 450 and 450); the strong brick stands for the case.
"""


def arch_thrust(reaction: float, *, lever: float, rise: float) -> float:
    """Return the thrust H = V x / f of half an arch of three hinges on its springing.

    Parameters
    ----------
    reaction : vertical reaction V of the springing [N]
    lever : distance x of the weight of the half from its springing [m]
    rise : f of the crown above the springing [m]

    Returns
    -------
    Horizontal thrust, outwards [N]

    Raises
    ------
    GeometryError : the crown is not above the springing
    """
    if not rise > 0.0:
        raise GeometryError(f"arch: rise = {rise:g} m: the crown must be above the springing")
    return reaction * lever / rise


def uniform_lever_arm(span: float) -> float:
    """x = L / 4 [m] for a weight spread evenly over the plan: rafters, a flat vault, one filled up to the crown."""
    return span / 4.0


UPRIGHT = 0.05  # vertical part of a unit normal: steeper faces are gables and ends, not the roof itself
LEVEL_SLOPE = 0.02  # root mean square slope: below this a roof or vault is flat
BOTH_WAYS = 0.5  # ratio of the slopes across and along: above it a roof or vault slopes both ways, like a hipped roof
UNDERSIDE = -1e-3  # vertical part of a unit normal: faces below this look down
SPRINGING = 1e-3  # of the body's size: faces this near its lowest level are what it stands on


@dataclass(frozen=True)
class RoofSlope:
    """The slope of a roof or vault.

    axis : horizontal unit vector along which it falls most [3], either way; None where it is flat
    both_ways : whether it falls across that as well, as a hipped roof or a groined vault does
    one_sided : 0 for a gable, whose slopes face both ways, 1 for a roof of a single slope [-]
    """

    axis: FloatArray | None
    both_ways: bool
    one_sided: float


def roof_slope(solid: Solid) -> RoofSlope:
    """Find how a roof or vault slopes, from its faces weighted by area.

    The horizontal parts n of their unit normals have a largest and a least mean square, over directions square to
    each other: a gable roof and a barrel vault have none along the ridge, a square groined vault has two alike.
    """
    area, normals = areas_and_normals(solid.vertices[solid.triangles])
    facing = np.abs(normals[:, 2]) > UPRIGHT
    A, n = area[facing], normals[facing, :2] * np.sign(normals[facing, 2:])
    least, most = np.linalg.eigh((A * n.T) @ n / (A.sum() or 1.0))[0]
    if least + most < LEVEL_SLOPE**2:
        return RoofSlope(None, False, 0.0)
    axis = np.linalg.eigh((A * n.T) @ n)[1][:, 1]
    falls = n @ axis
    one_sided = float(abs(A @ falls) / (A @ np.abs(falls)))
    return RoofSlope(np.array([*axis, 0.0]), bool(least > BOTH_WAYS * most), one_sided)


def extent_along(solid: Solid, *, axis: FloatArray) -> tuple[float, float]:
    """Return where a body begins and ends along a horizontal axis, from the origin [m].

    Parameters
    ----------
    solid : the body
    axis : horizontal unit vector [3]
    """
    x = solid.vertices @ axis
    return float(x.min()), float(x.max())


def overall_height(solid: Solid) -> float:
    """Return the height from the lowest to the highest point [m]."""
    return float(np.ptp(solid.vertices[:, 2]))


def mean_lever_arm(solid: Solid, *, axis: FloatArray) -> float:
    """Return the mean distance of the mass of a roof or vault from the nearer end of its span [m].

    A quarter of the span where the mass is spread evenly over the plan; less where it is steeper towards its feet.

    Parameters
    ----------
    solid : the roof or vault
    axis : of the span, a horizontal unit vector [3]
    """
    low, high = extent_along(solid, axis=axis)
    middle = (low + high) / 2.0
    parts = split_upright(solid, point=middle * axis, normal=axis)
    off = sum(part.mass * abs(float(part.centroid @ axis) - middle) for part in parts)
    return (high - low) / 2.0 - off / sum(part.mass for part in parts)


def intrados_area(solid: Solid) -> tuple[float, float]:
    """Return the area of a vault's intrados and its area in plan [m2]: faces that look down, without its bearings."""
    area, normals = areas_and_normals(solid.vertices[solid.triangles])
    z = solid.vertices[solid.triangles][:, :, 2]
    size = float(np.ptp(solid.vertices, axis=0).max())
    standing = np.all(z <= z.min() + SPRINGING * size, axis=1)
    down = (normals[:, 2] < UNDERSIDE) & ~standing
    return float(area[down].sum()), float(-area[down] @ normals[down, 2])


def _lever_source(load: BodyLoad, arch: Arch, *, V: float) -> Term | Message:
    """Say how the weight is spread over the span, and the thrust if it were uniform in plan."""
    if load.role == "roof":
        return Term("rafters: x = L / 4")
    even = arch_thrust(V, lever=uniform_lever_arm(arch.span), rise=arch.rise)
    return message("load-lever-of-vault", {"even": Quantity(even, "force")})


def _vault_lever(load: BodyLoad, body: Solid, *, axis: FloatArray, span: float) -> float:
    """Return the lever arm of half a vault's weight about its springing [m]: of the mesh, and of uniform fill."""
    low, high = extent_along(body, axis=axis)
    own = mean_lever_arm(body, axis=axis) * span / (high - low)
    shell, fill = _vault_masses(load, body)
    return (shell * own + fill * uniform_lever_arm(span)) / (shell + fill)


def _vault_masses(load: BodyLoad, body: Solid) -> tuple[float, float]:
    """Return the mass of a vault itself, and of what lies on it [kg]."""
    area, plan = intrados_area(body)
    shell = body.mass if load.construction is None else area * CONSTRUCTIONS[load.construction].mass_per_area
    return shell, plan * (load.fill or 0.0)
