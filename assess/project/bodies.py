"""The tables [bodies.NAME] and [materials.NAME] as bodies; model files are read once."""

from __future__ import annotations

from collections.abc import Mapping

from assess.geometry import mesh
from assess.geometry.models import Models, read_models
from assess.geometry.solid import Solid, box, profile
from assess.model.body import Bodies, Body, Material, PointValues
from assess.project import sections


def models_of(bodies: Mapping[str, sections.Body], *, known: Models) -> Models:
    """Read what the bodies take from model files, each file once; `known` has been read already."""
    asked = {name: (body.mesh, body.element) for name, body in bodies.items() if isinstance(body, sections.MeshBody)}
    return {**known, **read_models({name: one for name, one in asked.items() if one not in known})}


def solid_of(
    name: str, body: sections.Body, materials: Mapping[str, sections.Material], models: Models
) -> Solid | None:
    """Return the solid of a body; None if it has direct values."""
    if isinstance(body, sections.DirectBody):
        return None
    density = materials[body.material].density
    if isinstance(body, sections.MeshBody):
        model = models[body.mesh, body.element]
        return mesh.solid_of(model, density=density, name=name, scale=body.mesh_unit, up=body.mesh_up)
    if isinstance(body, sections.BoxBody):
        return box(**body.box.model_dump(), density=density, name=name)
    return profile(body.profile, length=body.length, density=density, name=name)


def bodies_of(content: sections.Content, solids: Mapping[str, Solid | None]) -> Bodies:
    """Return the bodies of a project, each with its solid and its material."""
    return {name: _body(name, body, content, solids[name]) for name, body in content.bodies.items()}


def _body(name: str, body: sections.Body, content: sections.Content, solid: Solid | None) -> Body:
    if isinstance(body, sections.DirectBody):
        values = PointValues(mass=body.mass, centroid=body.centroid, inertia=body.inertia)
        return Body(name=name, solid=solid, values=values)
    return Body(name=name, solid=solid, material=material_of(body.material, content))


def material_of(name: str, content: sections.Content) -> Material:
    """Return one of the materials of a project."""
    given = content.materials[name]
    return Material(
        name=name,
        density=given.density,
        young_modulus=given.young_modulus,
        compressive_strength=given.compressive_strength,
        tensile_strength=given.tensile_strength,
        friction=given.friction,
    )
