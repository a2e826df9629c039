"""glTF files, read with trimesh; the only door to it. Nothing is mended here.

The header is checked against the size of the file before any mesh is read. The format readers are called directly,
because trimesh's own objects merge and drop parts.
"""

from __future__ import annotations

import io
import json
import struct
from collections import Counter
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from assess.geometry.formats.mesh_file import (
    MAX_INSTANCES,
    MAX_TRIANGLES,
    Element,
    ElementMesh,
    MeshFile,
    file_from_meshes,
    join_meshes,
    make_element_mesh,
    transform,
)
from spectra.arrays import FloatArray

EXTENT_TOLERANCE = 1e-4  # of the largest coordinate, by which the extents in the header may be rounded
SUFFIX = 7  # letters that trimesh adds to the name of a node for a primitive of its mesh


def read_glb(file: Path) -> MeshFile:
    """Read glTF 2.0 in one binary file: metres, y up, +z forward (glTF 2.0, 3.4)."""
    from trimesh.exchange.gltf import load_glb

    header = gltf_header(file)
    return file_from_meshes(_node_meshes(load_glb(_content(file), skip_materials=True), header), unit=1.0, up="y")


def read_gltf(file: Path) -> MeshFile:
    """Read glTF 2.0 as JSON, with the files it refers to in the same folder."""
    from trimesh.exchange.gltf import load_gltf
    from trimesh.resolvers import FilePathResolver

    header = gltf_header(file)
    loaded = load_gltf(_content(file), resolver=FilePathResolver(str(file)), skip_materials=True)
    return file_from_meshes(_node_meshes(loaded, header), unit=1.0, up="y")


def companions(file: Path) -> tuple[Path, ...]:
    """Return the files that a glTF file takes its meshes from; none if it cannot be read, which its reader tells."""
    try:
        buffers = _json_of(file).get("buffers", [])
        named = (_file_named(buffer) for buffer in buffers)
        return tuple(dict.fromkeys(file.parent / uri for uri in named if uri and uri.isprintable()))  # else no path
    except (OSError, ValueError, TypeError, AttributeError, RecursionError):
        return ()


def _file_named(buffer: Mapping[str, Any]) -> str:
    """Return the path of the file that holds a buffer; empty if the buffer is in the file itself."""
    uri = unquote(str(buffer.get("uri", "data:")))
    return "" if uri.startswith("data:") else uri


def _content(file: Path) -> io.BytesIO:
    return io.BytesIO(file.read_bytes())


def _meshes(meshes: Mapping[str, Mapping[str, Any]]) -> dict[str, ElementMesh]:
    """Return the meshes that have faces, by name; points and lines have none."""
    return {
        name: make_element_mesh(Element((name,) if name else ()), each["vertices"], each["faces"])
        for name, each in meshes.items()
        if len(each.get("faces", ()))
    }


def _refuse_other_extents(meshes: Mapping[str, ElementMesh], header: Mapping[str, Any]) -> None:
    """Raise ValueError where vertices do not match the extents of their accessor (glTF 2.0, 3.6.2.5).

    The readers keep no link from a mesh to its accessor, so it must agree with one of them.
    """
    accessors = header.get("accessors", [])
    used = {each["attributes"].get("POSITION") for mesh in header.get("meshes", []) for each in mesh["primitives"]}
    stated = [[accessors[i].get("min"), accessors[i].get("max")] for i in used if i is not None]
    if any(None in each for each in stated):
        return
    announced = np.asarray(stated, dtype=np.float64).reshape(-1, 2, 3)
    for name, mesh in meshes.items():
        found = np.array([mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)])
        wrong = np.abs(announced - found).max(axis=(1, 2)) > EXTENT_TOLERANCE * np.abs(found).max()
        if wrong.all():
            low, high = (", ".join(f"{x:.4g}" for x in corner) for corner in found)
            raise ValueError(f'"{name:.30}" reaches from ({low}) to ({high}), and no accessor\'s min and max say so')


def _node_meshes(loaded: Mapping[str, Any], header: Mapping[str, Any]) -> tuple[ElementMesh, ...]:
    """Place every node's mesh, joined from its primitives, under the name of the node and within its mesh."""
    meshes = _meshes(loaded["geometry"])
    _refuse_other_extents(meshes, header)
    own = Counter(str(node.get("name", place)) for place, node in enumerate(header.get("nodes", [])))
    edges = {edge["frame_to"]: edge for edge in loaded["graph"]}
    used = [meshes[name] for edge in edges.values() if (name := edge.get("geometry", "")) in meshes]
    if len(used) > MAX_INSTANCES or sum(len(each.triangles) for each in used) > MAX_TRIANGLES:
        raise ValueError(f"its scene has more than {MAX_INSTANCES} instances or {MAX_TRIANGLES} triangles")
    found: dict[str, list[ElementMesh]] = {}
    for node, edge in edges.items():
        mesh = meshes.get(edge.get("geometry", ""))
        if mesh is not None:
            placed = transform(mesh, _node_transformation(node, edges, base=loaded["base_frame"]))
            found.setdefault(str(node) if node in own else _owner(node, edge), []).append(placed)
    many = {name for name, count in own.items() if count > 1}
    return tuple(
        ElementMesh(_node_element(node, meshes_of_node[0].element.names, many), *join_meshes(meshes_of_node))
        for node, meshes_of_node in found.items()
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


def _node_transformation(node: str, edges: Mapping[str, Mapping[str, Any]], *, base: str) -> FloatArray:
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


COMPRESSIONS = {
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}
WIDTHS = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}  # bytes of glTF's component types
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
LARGEST_VIRTUAL = 100_000_000  # bytes of an accessor without data of its own, which is all zeros


def gltf_header(file: Path) -> Any:
    """Return the JSON of a glTF file, binary or not.

    Raises
    ------
    ValueError : its meshes are packed, or announce more than the file can hold
    """
    header = _json_of(file)
    for extension, name in COMPRESSIONS.items():
        if extension in header.get("extensionsUsed", ()):
            raise ValueError(f"its meshes are packed by {name}; export it without compression")
    for buffer in header.get("buffers", []):
        beside = _file_named(buffer)
        if beside and not (file.parent / beside).is_file():
            raise ValueError(f'the file "{beside[:40]}" that it names is not beside it')
    views = header.get("bufferViews", [])
    for accessor in header.get("accessors", []):
        if "sparse" in accessor:
            raise ValueError("its meshes are said by differences (sparse accessors); export it without them")
        needed = int(accessor["count"]) * WIDTHS[accessor["componentType"]] * COMPONENTS[accessor["type"]]
        view = accessor.get("bufferView")
        there = LARGEST_VIRTUAL if view is None else int(views[view]["byteLength"])
        if not 0 <= needed <= there:
            raise ValueError(f"it announces {accessor['count']} values where there are {there} bytes")
    return header


def _json_of(file: Path) -> Any:
    with file.open("rb") as content:
        start = content.read(20)
        if start[:4] != b"glTF":
            return json.loads(file.read_bytes())
        if len(start) < 20:
            raise ValueError("it ends within its header")
        return json.loads(content.read(struct.unpack("<I", start[12:16])[0]))
