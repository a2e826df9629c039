"""The bodies of a building and the masonry that they are made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from assess.geometry.planar import PlanarBody, planar_body, planar_body_from_values
from assess.geometry.solid import Solid


@dataclass(frozen=True, kw_only=True)
class Material:
    """A masonry; None where a property is not known.

    density [kg/m3]; young_modulus, compressive_strength, tensile_strength [Pa]; friction : coefficient [-]
    """

    name: str
    density: float
    young_modulus: float | None = None
    compressive_strength: float | None = None
    tensile_strength: float | None = None
    friction: float | None = None


@dataclass(frozen=True, kw_only=True)
class PointValues:
    """A body without geometry: mass [kg], centroid (x, z) [m], moment of inertia about it [kg m2]."""

    mass: float
    centroid: tuple[float, float]
    inertia: float


@dataclass(frozen=True, kw_only=True, repr=False)
class Body:
    """One body: a solid of a material, or values without geometry."""

    name: str
    solid: Solid | None = None
    material: Material | None = None
    values: PointValues | None = None

    def __repr__(self) -> str:
        masonry = "" if self.material is None else f", {self.material.name!r}, {self.material.density:.6g} kg/m3"
        return f"Body({self.name!r}, {self.mass:.6g} kg{masonry})"

    @property
    def mass(self) -> float:
        """The mass of its solid, or as given [kg]."""
        if self.solid is not None:
            return self.solid.mass
        assert self.values is not None
        return self.values.mass

    def in_plane(self, direction: Sequence[float]) -> PlanarBody:
        """Return the body seen in the vertical plane of a direction [3]."""
        if self.solid is not None:
            return planar_body(self.solid, direction=direction)
        assert self.values is not None
        given = self.values
        return planar_body_from_values(mass=given.mass, centroid=given.centroid, inertia=given.inertia, name=self.name)


Bodies = Mapping[str, Body]


def solids_of(bodies: Bodies) -> dict[str, Solid | None]:
    """Return the solid of each body, None of those without geometry."""
    return {name: body.solid for name, body in bodies.items()}
