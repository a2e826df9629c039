"""Planar bodies of tests, from blocks of a chain or boxes that face +x, walls made of them, and regions of contact."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from typing import Any

import numpy as np
import shapely

from assess.geometry.planar import PlanarBody, planar_body, planar_body_from_values
from assess.geometry.solid import box
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint, RigidBlock
from assess.mechanisms.mechanism import Mechanism, Sides
from assess.mechanisms.single_block import single_block
from assess.oscillator import Oscillator


def rectangle_block(
    x: float, z: float, width: float, height: float, *, length: float = 1.0, density: float = 1800.0
) -> RigidBlock:
    """Return a rectangular block by its lower left corner [m]; density [kg/m3]."""
    mass = density * width * height * length
    return RigidBlock(mass, (x + width / 2, z + height / 2), mass * (width**2 + height**2) / 12)


PORTAL_HINGES = ((0.8, 0.0), (0.0, 4.0), (3.8, 4.0), (4.6, 0.0)), ((0.0, 0.0), (0.8, 4.0), (4.6, 4.0), (3.8, 0.0))
"""Of the portal, as it moves towards +x and back."""
UNEVEN_HINGES = ((0.8, 0.0), (0.0, 4.0), (3.6, 4.6), (4.6, 1.2)), ((0.0, 0.0), (0.8, 4.0), (4.6, 4.6), (3.6, 1.2))
"""Of the portal whose columns have unlike heights, on bases at two levels."""


def portal_blocks(*, uneven: bool = False, density: float = 1800.0) -> tuple[RigidBlock, RigidBlock, RigidBlock]:
    """Return the column ahead, the beam and the other column of a portal 1 m long; density [kg/m3]."""
    column = rectangle_block(0.0, 0.0, 0.8, 4.0, density=density)
    if uneven:
        return column, RigidBlock(7000.0, (2.4, 4.9), 15000.0), rectangle_block(3.6, 1.2, 1.0, 3.4, density=density)
    beam = rectangle_block(0.0, 4.0, 4.6, 0.7, density=density)
    return column, beam, rectangle_block(3.8, 0.0, 0.8, 4.0, density=density)


def body_of_block(block: RigidBlock, *, name: str = "b") -> PlanarBody:
    """Return the planar body with the mass, the centroid and the inertia of a block."""
    return planar_body_from_values(mass=block.mass, centroid=block.centroid, inertia=block.inertia, name=name)


def planar_box(
    thickness: float,
    height: float,
    *,
    x: float = 0.0,
    base: float = 0.0,
    length: float = 1.0,
    density: float = 1800.0,
    name: str = "wall",
) -> PlanarBody:
    """Return the planar body of a box that turns towards +x.

    Parameters
    ----------
    thickness, height, length : sizes along x, z and y [m]; x : of the middle of the box [m]
    base : elevation of its foot [m]; density [kg/m3]
    """
    solid = box(thickness=thickness, length=length, height=height, base=(x, 0.0, base), density=density, name=name)
    return planar_body(solid, direction=(1, 0, 0))


def free_wall(thickness: float = 0.6, height: float = 6.0, *, base: float = 0.0) -> Oscillator:
    """Return a free-standing wall of 1800 kg/m3 and 1 m length [m] that rocks to both sides."""
    return single_block("wall", planar_box(thickness, height, base=base)).oscillator


def body_at(mass: float, x: float, z: float, *, name: str = "b") -> PlanarBody:
    """Return a body of a mass [kg] about (x, z), whose radius of gyration squared is 0.4 m2."""
    return planar_body_from_values(mass=mass, centroid=(x, z), inertia=0.4 * mass, name=name)


def pier(*loads: Force | PointMass | Tie, sides: Sides = "two") -> Mechanism:
    """Return a wall of 0.8 x 5 m, 2 m long and of 1900 kg/m3, under loads."""
    return single_block("w", planar_box(0.8, 5.0, length=2.0, density=1900.0), loads=loads, sides=sides)


def wall_on_joints(
    thickness: float,
    height: float,
    law: JointLaw,
    *,
    length: float,
    density: float = 1800.0,
    model: str = "flexible",
    loads: Sequence[Force] = (),
    sides: Sides = "two",
    rises: tuple[float, float] = (0.0, 0.0),
    restitution: tuple[float | str, float | str],
) -> Mechanism:
    """Return a wall [m] on a joint over its whole base, which rocks about its edges.

    Parameters
    ----------
    rises : elevation of the hinges ahead and behind, as on an inclined crack [m]; length : along the axis [m]
    """
    rigid = rigid_wall(
        thickness,
        height,
        length=length,
        density=density,
        loads=loads,
        sides=sides,
        rises=rises,
        restitution=restitution,
    )
    size, fall = hypot(thickness, rises[0] - rises[1]), rises[1] - rises[0]
    ahead, behind = (
        (Joint((-thickness / size, way * fall / size), rectangle(size, length), law, model),) for way in (1.0, -1.0)
    )
    return add_joints(rigid, ahead, behind, restitution=restitution)


def rigid_wall(
    thickness: float,
    height: float,
    *,
    length: float,
    density: float = 1800.0,
    loads: Sequence[Force] = (),
    sides: Sides = "two",
    rises: tuple[float, float] = (0.0, 0.0),
    restitution: tuple[Any, Any] = (None, None),
) -> Mechanism:
    """Return the same wall on a rigid base."""
    body = body_of_block(rectangle_block(-thickness / 2, 0.0, thickness, height, length=length, density=density))
    hinges = {"hinge": (thickness / 2, rises[0]), "hinge_negative": (-thickness / 2, rises[1])}
    if sides == "one":
        hinges["hinge_negative"] = None
    return single_block("w", body, **hinges, loads=loads, sides=sides, restitution=restitution)


def in_joint_frame(region: shapely.Geometry, direction: Sequence[float]) -> shapely.Geometry:
    """Return the region with the depth from its foremost point as x, the offset to the left of its centroid as y."""
    along = np.asarray(direction) / np.hypot(*direction)
    across = np.array([-along[1], along[0]])
    middle = shapely.get_coordinates(region.centroid)[0]
    ahead = (shapely.get_coordinates(region) @ along).max()
    return shapely.transform(region, lambda p: np.column_stack([ahead - p @ along, (p - middle) @ across]))
