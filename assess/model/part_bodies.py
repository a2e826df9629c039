"""The bodies of a model, one for each element of an IFC file and one for each closed shell of a mesh.

Shells are separated before anything is united, so that walls drawn over one another at their corners stay walls.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import Element, ElementMesh, MeshFile, Up, short_name
from assess.geometry.formats.readers import mesh_elements, read_mesh_file
from assess.geometry.mesh import SelectedMeshes, assemble_mesh, fault_of, solid_from_meshes
from assess.geometry.shells import separate_shells
from assess.geometry.solid import Solid
from assess.geometry.surface import Surface, connected_groups, find_edges, merge_vertices, neighbours, volume
from assess.mechanisms.mechanism import Vector
from assess.messages.message import Message, Quantity, note, whole_number
from assess.model.part_kinds import is_classed, may_be_wall, reason_by_class
from assess.model.structure import NAMELESS, LeftOut
from spectra.arrays import FloatArray

SPLINTER = 1e-3  # m3: smaller shells are nails and drawing errors


@dataclass(frozen=True)
class DrawnBody:
    """One body of a model.

    name : what the file calls it; empty where it has no name
    solid : of density 1 kg/m3
    element : of the file
    file : its name
    shell : its number among the shells of its element, from 1; None where it is the whole element
    """

    name: str
    solid: Solid
    element: Element
    file: str
    shell: int | None = None

    @property
    def source(self) -> str:
        """What it was read from: class and GlobalId, or the file and the shell."""
        return source_of(self.element, self.file, self.shell)


@dataclass(frozen=True)
class DrawnModel:
    """The bodies of a file, what of it has none, and its storeys by name and elevation [m]."""

    bodies: tuple[DrawnBody, ...]
    left_out: tuple[LeftOut, ...]
    storeys: tuple[tuple[str, float], ...]


def read_bodies(file: Path, *, unit: float | None = None, up: Up | None = None) -> DrawnModel:
    """Read the bodies of a model file.

    Parameters
    ----------
    file : of any known format
    unit : length of the file's unit [m]; the file's own if None, the metre where it has none
    up : the axis of the file that points up; the format's if None

    Raises
    ------
    GeometryError : the file as a whole cannot be read, or has no parts
    """
    content = read_mesh_file(file, where=str(file))
    if not content.elements:
        raise GeometryError(f"{file}: there are no meshes in it, and no solids or surfaces to mesh")
    meshes = mesh_elements(content, range(len(content.elements)), file=file, where=str(file))
    bodies: list[DrawnBody] = []
    left_out: list[LeftOut] = []
    for mesh in meshes:
        found = tuple(_bodies_of(mesh, content, file, unit=unit, up=up))
        bodies += [each for each in found if isinstance(each, DrawnBody)]
        left_out += [each for each in found if isinstance(each, LeftOut)]
    return DrawnModel(tuple(bodies), tuple(left_out), content.storeys)


def source_of(element: Element, file: str, shell: int | None = None) -> str:
    """Return what a body was read from: class and GlobalId, or the file and the shell."""
    if element.identifier:
        return " ".join(word for word in (*element.kinds[:1], element.identifier) if word)
    return file if shell is None else f"{file}, shell {shell}"


def leave_out(body: DrawnBody, reason: Message, *, told: bool = True) -> LeftOut:
    """Return a body as left out for a reason; told: whether that tells that it is no wall."""
    size, low = _box(body.solid.vertices)
    open_to_doubt = not told and may_be_wall(body.element, size, body.solid.mass)
    return LeftOut(body.name or NAMELESS, reason, size, body.solid.mass, body.source, low, open_to_doubt)


def _bodies_of(
    mesh: ElementMesh, content: MeshFile, file: Path, *, unit: float | None, up: Up | None
) -> Iterator[DrawnBody | LeftOut]:
    """Return the bodies of one element, and what of it is none."""
    element, name = mesh.element, file.name
    shown = short_name(element.names[0]) if element.names else ""
    source, no_masonry = source_of(element, name), reason_by_class(element)
    doubt = no_masonry is None and may_be_wall(element)
    if mesh.fault:
        without = note("left-out-without-body", why=mesh.fault)
        yield LeftOut(shown or element.shown, without, source=source, may_be_wall=doubt)
        return
    selected = SelectedMeshes(file, (mesh,), content.unit, content.up)
    try:
        surface = assemble_mesh(selected, selected.meshes, scale=unit, up=up, where="")
    except GeometryError as problem:
        without = note("left-out-without-body", why=fault_of(problem, name))
        yield LeftOut(shown or element.shown, without, source=source, may_be_wall=doubt)
        return
    if no_masonry is not None:
        box = _box(surface[0][np.unique(surface[1])])
        yield LeftOut(shown or element.shown, no_masonry, box[0], abs(volume(*surface)), source, box[1])
        return
    shells = [surface] if is_classed(element) else list(_shells(merge_vertices(*surface)))
    small = [shell for shell in shells if len(shells) > 1 and abs(volume(*shell)) < SPLINTER]
    real = [shell for shell in shells if not any(shell is each for each in small)]
    for number, shell in enumerate(real, start=1):
        k = number if len(real) > 1 else None
        upright = SelectedMeshes(file, (replace(mesh, vertices=shell[0], triangles=shell[1]),), 1.0, "z")
        try:
            solid = solid_from_meshes(upright, density=1.0, name="")
        except GeometryError as problem:
            why, (size, low) = (
                note("left-out-not-closed", why=fault_of(problem, name)),
                _box(shell[0][np.unique(shell[1])]),
            )
            doubt = may_be_wall(element, size)
            yield LeftOut(shown or element.shown, why, size, None, source_of(element, name, k), low, doubt)
            continue
        yield DrawnBody(shown, solid, element, name, k)
    if small:
        corners = np.concatenate([shell[0][np.unique(shell[1])] for shell in small])
        total = sum(abs(volume(*shell)) for shell in small)
        reason = note("left-out-splinters", number=whole_number(len(small)), volume=Quantity(total, "volume", 2))
        size, low = _box(corners)
        yield LeftOut(shown or element.shown, reason, size, total, source, low)


def _shells(surface: Surface) -> Iterator[Surface]:
    """Separate the shells of a surface; a cavity stays with the smallest shell around it, others face outwards."""
    edges = find_edges(surface[1])
    if edges.closed:
        shells = separate_shells(surface)
    else:
        group = connected_groups(neighbours(edges)[0], count=len(surface[1]))
        ends = np.cumsum(np.bincount(group))[:-1]
        order = np.argsort(group, kind="stable")
        shells = [(surface[0], part) for part in np.split(surface[1][order], ends)]
    sizes = [volume(*shell) for shell in shells]
    if sum(sizes) < 0.0:
        shells, sizes = [(v, t[:, ::-1]) for v, t in shells], [-size for size in sizes]
    boxes = [(shell[0][shell[1]].min(axis=(0, 1)), shell[0][shell[1]].max(axis=(0, 1))) for shell in shells]
    solid = sorted((k for k, size in enumerate(sizes) if size > 0.0), key=lambda k: sizes[k])
    joined: dict[int, list[Surface]] = {k: [shells[k]] for k in solid}
    for k, size in enumerate(sizes):
        if size > 0.0:
            continue
        around = [j for j in solid if (boxes[j][0] < boxes[k][0]).all() and (boxes[j][1] > boxes[k][1]).all()]
        if around:
            joined[around[0]].append(shells[k])
        else:
            joined[k] = [(shells[k][0], shells[k][1][:, ::-1])]
    for k in sorted(joined):
        yield shells[k][0], np.concatenate([triangles for _, triangles in joined[k]])


def _box(points: FloatArray) -> tuple[Vector, Vector]:
    """Return the sides of the box around points [n, 3], and its lowest corner [m]."""
    (x, y, z), (a, b, c) = np.ptp(points, axis=0).tolist(), points.min(axis=0).tolist()
    return (x, y, z), (a, b, c)
