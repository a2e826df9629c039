"""glTF files, read with trimesh; the only door to it. Nothing is mended here.

The format readers are called directly, because trimesh's own objects merge and drop parts.
"""

from __future__ import annotations

import io
from collections import Counter
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from assess.geometry.formats.gltf_header import gltf_header
from assess.geometry.formats.limits import MAX_INSTANCES, MAX_TRIANGLES
from assess.geometry.formats.mesh_file import Element, MeshFile, Part, file_from_parts, join_parts, make_part, transform
from spectra.arrays import FloatArray

EXTENTS = 1e-4  # of the largest coordinate, by which the extents in the header may be rounded
SUFFIX = 7  # letters that trimesh adds to the name of a node for a primitive of its mesh


def read_glb(file: Path) -> MeshFile:
    """Read glTF 2.0 in one binary file: metres, y up, +z forward (glTF 2.0, 3.4)."""
    from trimesh.exchange.gltf import load_glb

    header = gltf_header(file)
    return file_from_parts(_node_parts(load_glb(_content(file), skip_materials=True), header), unit=1.0, up="y")


def read_gltf(file: Path) -> MeshFile:
    """Read glTF 2.0 as JSON, with the files it refers to in the same folder."""
    from trimesh.exchange.gltf import load_gltf
    from trimesh.resolvers import FilePathResolver

    header = gltf_header(file)
    loaded = load_gltf(_content(file), resolver=FilePathResolver(str(file)), skip_materials=True)
    return file_from_parts(_node_parts(loaded, header), unit=1.0, up="y")


def _content(file: Path) -> io.BytesIO:
    return io.BytesIO(file.read_bytes())


def _meshes(meshes: Mapping[str, Mapping[str, Any]]) -> dict[str, Part]:
    """Return the meshes that have faces, by name; points and lines have none."""
    return {
        name: make_part(Element((name,) if name else ()), each["vertices"], each["faces"])
        for name, each in meshes.items()
        if len(each.get("faces", ()))
    }


def _refuse_other_extents(meshes: Mapping[str, Part], header: Mapping[str, Any]) -> None:
    """Raise ValueError where vertices do not match the extents of their accessor (glTF 2.0, 3.6.2.5).

    The readers keep no link from a mesh to its accessor, so it must agree with one of them.
    """
    accessors = header.get("accessors", [])
    used = {each["attributes"].get("POSITION") for mesh in header.get("meshes", []) for each in mesh["primitives"]}
    said = [[accessors[i].get("min"), accessors[i].get("max")] for i in used if i is not None]
    if any(None in each for each in said):
        return
    announced = np.asarray(said, dtype=np.float64).reshape(-1, 2, 3)
    for name, mesh in meshes.items():
        found = np.array([mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)])
        wrong = np.abs(announced - found).max(axis=(1, 2)) > EXTENTS * np.abs(found).max()
        if wrong.all():
            low, high = (", ".join(f"{x:.4g}" for x in corner) for corner in found)
            raise ValueError(f'"{name:.30}" reaches from ({low}) to ({high}), and no accessor\'s min and max say so')


def _node_parts(loaded: Mapping[str, Any], header: Mapping[str, Any]) -> tuple[Part, ...]:
    """Place every node's mesh, joined from its primitives, under the name of the node and within its mesh."""
    meshes = _meshes(loaded["geometry"])
    _refuse_other_extents(meshes, header)
    own = Counter(str(node.get("name", place)) for place, node in enumerate(header.get("nodes", [])))
    edges = {edge["frame_to"]: edge for edge in loaded["graph"]}
    used = [meshes[name] for edge in edges.values() if (name := edge.get("geometry", "")) in meshes]
    if len(used) > MAX_INSTANCES or sum(len(each.triangles) for each in used) > MAX_TRIANGLES:
        raise ValueError(f"its scene has more than {MAX_INSTANCES} instances or {MAX_TRIANGLES} triangles")
    found: dict[str, list[Part]] = {}
    for node, edge in edges.items():
        mesh = meshes.get(edge.get("geometry", ""))
        if mesh is not None:
            placed = transform(mesh, _place(node, edges, base=loaded["base_frame"]))
            found.setdefault(str(node) if node in own else _owner(node, edge), []).append(placed)
    many = {name for name, count in own.items() if count > 1}
    return tuple(
        Part(_node_element(node, parts[0].element.names, many), *join_parts(parts)) for node, parts in found.items()
    )


def _node_element(node: str, mesh: tuple[str, ...], many: Collection[str]) -> Element:
    """Name a node, within its mesh.

    Of several nodes with one name, trimesh numbers all but the first; the plain name then means all of them.
    """
    if node in many:
        return Element((f"{node}_0",), within=(node, *mesh))
    name = node.rpartition("_")[0]
    return Element((node,), within=(name, *mesh) if name in many else mesh)


def _owner(node: str, edge: Mapping[str, Any]) -> str:
    """Return the file's node behind a node that trimesh made.

    For each of several primitives of a mesh trimesh makes a node with a random name.
    """
    owner = str(edge["frame_from"])
    return owner if len(node) == len(owner) + SUFFIX and node.startswith(f"{owner}_") else str(node)


def _place(node: str, edges: Mapping[str, Mapping[str, Any]], *, base: str) -> FloatArray:
    """Return the transformation [4, 4] from a node's own coordinates to the scene's."""
    steps: list[FloatArray] = [np.eye(4)]
    passed: tuple[str, ...] = ()
    while node != base:
        if node in passed or node not in edges:
            raise ValueError(f"its scene has no way to the node {node!r:.40}")
        passed = (*passed, node)
        steps.insert(0, np.asarray(edges[node]["matrix"], dtype=np.float64))
        node = edges[node]["frame_from"]
    place = steps[0]
    for step in steps[1:]:
        place = place @ step
    return place
