"""Wavefront OBJ files: positions and faces; normals, textures, materials, lines and curves are ignored."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from assess.geometry.formats.mesh_file import (
    POINT_CLOUD,
    Element,
    ElementMesh,
    MeshFile,
    fan_triangles,
    file_from_meshes,
)
from assess.geometry.formats.text_blocks import (
    TextBlock,
    join_lines,
    parse_numbers,
    read_blocks,
    rest_of_line,
    rows_by_length,
)
from spectra.arrays import BoolArray, FloatArray, IntArray

VERTEX, FACE, OBJECT, GROUP = b"vfog"
BLANK = 32
STRAY = b"0123456789.+-"
AFTER_SLASH = re.compile(rb"/[^\s]*")
LEAST = 3  # corners of a face
VERTICES = (3, 4, 6, 7)  # numbers of a vertex: x y z, with a weight, or a colour of three or four numbers
WEIGHTED = 4


@dataclass(frozen=True)
class Faces:
    """Triangles [m, 3] and which object and group are in force at each [m]."""

    triangles: IntArray
    object: NDArray[np.int32]
    group: NDArray[np.int32]


def read_obj(file: Path) -> MeshFile:
    """Read the objects of an OBJ file with their faces, or its groups where it has no objects."""
    vertices, faces = [np.empty((0, 3))], []
    objects, groups = [""], [""]
    known = 0
    for block in read_blocks(file):
        if any((block.first == sign).any() for sign in STRAY):
            raise ValueError(
                "a line of it begins with a number, where a keyword stands; it is damaged, export it again"
            )
        short = block.second <= BLANK
        at, face = (short & (block.first == letter) & (block.words > 1) for letter in (VERTEX, FACE))
        vertices.append(_positions(block, at))
        in_force = [
            _in_force(block, short & (block.first == c), names) for c, names in ((OBJECT, objects), (GROUP, groups))
        ]
        faces += _faces(block, face, known + np.cumsum(at), in_force)
        known += len(vertices[-1])
    return file_from_meshes(_named_meshes(np.concatenate(vertices), faces, objects, groups))


def _positions(block: TextBlock, chosen: BoolArray) -> FloatArray:
    """Return the vertices [n, 3] of a block; weights and colours are ignored."""
    sizes = block.words[chosen] - 1
    if not len(sizes):
        return np.empty((0, 3))
    if odd := set(sizes.tolist()) - set(VERTICES):
        raise ValueError(f"a vertex has {min(odd)} numbers; read are x y z, with a weight or a colour behind")
    values = parse_numbers(join_lines(block, chosen).replace(b"v", b" "), count=int(sizes.sum()))
    found = np.empty((len(sizes), 3))
    for places, rows in rows_by_length(values, sizes):
        found[places] = rows[:, :3]
        if rows.shape[1] == WEIGHTED and (rows[:, 3] != 1.0).any():
            raise ValueError("a vertex has a fourth number that is not 1, as a weight of a mesh is; is a decimal lost?")
    return found


def _in_force(block: TextBlock, chosen: BoolArray, names: list[str]) -> IntArray:
    """Return the index of the name in force at each line of a block [n]; new names are appended."""
    first = len(names) - 1
    names += [rest_of_line(block, int(line)) for line in np.flatnonzero(chosen)]
    return np.asarray(first + np.cumsum(chosen), dtype=np.int64)


def _faces(block: TextBlock, chosen: BoolArray, known: IntArray, in_force: Sequence[IntArray]) -> list[Faces]:
    """Return the triangles of a block; known: vertices up to each line [n], from which negative indices count back."""
    sizes = block.words[chosen] - 1
    if not len(sizes):
        return []
    text = join_lines(block, chosen).replace(b"f", b" ")
    if b"/" in text:
        text = AFTER_SLASH.sub(b"", text)
    values = parse_numbers(text, count=int(sizes.sum()))
    corners = values.astype(np.int64)
    if (corners != values).any() or not corners.all():
        raise ValueError("a corner of a face is no whole number from 1")
    corners = np.where(corners > 0, corners - 1, corners + np.repeat(known[chosen], sizes))
    found = []
    for places, rows in rows_by_length(corners, sizes):
        if rows.shape[1] >= LEAST:
            names = [np.tile(each[chosen][places], rows.shape[1] - 2).astype(np.int32) for each in in_force]
            found.append(Faces(fan_triangles(rows), *names))
    return found


def _named_meshes(
    vertices: FloatArray, faces: Sequence[Faces], objects: list[str], groups: list[str]
) -> list[ElementMesh]:
    """Make a mesh for each name that has faces, in file order."""
    if not faces and len(vertices):
        raise ValueError(POINT_CLOUD.format(count=len(vertices)))
    if not faces:
        return []
    if not len(vertices):
        raise ValueError("it has faces and no vertices")
    triangles = np.concatenate([each.triangles for each in faces])
    named = any(objects)
    names = objects if named else groups
    order = {name: k for k, name in enumerate(dict.fromkeys(names))}
    place = np.array([order[name] for name in names])
    owner = np.concatenate([place[each.object if named else each.group] for each in faces], dtype=np.int32)
    present = np.flatnonzero(np.bincount(owner, minlength=len(order))).tolist()
    if len(present) == 1:
        return [_element_mesh(list(order)[present[0]], vertices, triangles)]
    return [
        _drop_unused(_element_mesh(name, vertices, triangles[owner == k])) for name, k in order.items() if k in present
    ]


def _element_mesh(name: str, vertices: FloatArray, triangles: IntArray) -> ElementMesh:
    return ElementMesh(Element((name,) if name else ()), vertices, triangles)


def _drop_unused(mesh: ElementMesh) -> ElementMesh:
    """Drop the vertices that a mesh does not use; one with invalid indices is returned unchanged."""
    if mesh.triangles.min() < 0 or mesh.triangles.max() >= len(mesh.vertices):
        return mesh
    used = np.zeros(len(mesh.vertices), dtype=np.bool_)
    used[mesh.triangles] = True
    return ElementMesh(mesh.element, mesh.vertices[used], (np.cumsum(used) - 1)[mesh.triangles])
