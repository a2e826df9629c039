"""Files of solids as other programs write them: the bytes of a surface, by its vertices [n, 3] and triangles [m, 3]."""

from __future__ import annotations

import io
import json
import struct
import zipfile
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
"""Corners of the unit cube."""
QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
"""Its faces by their corners, anticlockwise seen from outside."""


def obj(vertices: ArrayLike, triangles: ArrayLike, *, name: str = "body", before: int = 0) -> bytes:
    """Return Wavefront OBJ; before: vertices of the elements that stand before this one in the file."""
    places = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(vertices, dtype=float).tolist()]
    faces = ["f " + " ".join(map(str, face)) for face in (np.asarray(triangles) + 1 + before).tolist()]
    return "\n".join(["mtllib nowhere.mtl", f"o {name}", *places, "usemtl stone", *faces, ""]).encode()


def off(vertices: ArrayLike, triangles: ArrayLike) -> bytes:
    """Return OFF."""
    places, faces = np.asarray(vertices).tolist(), np.asarray(triangles).tolist()
    lines = ["OFF", f"{len(places)} {len(faces)} 0", *(f"{x!r} {y!r} {z!r}" for x, y, z in places)]
    return "\n".join([*lines, *(f"3 {a} {b} {c}" for a, b, c in faces), ""]).encode()


def stl_text(vertices: ArrayLike, triangles: ArrayLike) -> bytes:
    """Return STL as text."""
    corners = np.asarray(vertices, dtype=float)[np.asarray(triangles)]
    lines = ["solid body"]
    for triangle in corners.tolist():
        loop = "".join(f"      vertex {x!r} {y!r} {z!r}\n" for x, y, z in triangle)
        lines.append(f"  facet normal 0 0 0\n    outer loop\n{loop}    endloop\n  endfacet")
    return ("\n".join([*lines, "endsolid body"]) + "\n").encode()


def stl_binary(vertices: ArrayLike, triangles: ArrayLike) -> bytes:
    """Return STL in single precision."""
    corners = np.asarray(vertices, dtype="<f4")[np.asarray(triangles)]
    facets = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    facets["corners"] = corners
    return b"solid of someone's program".ljust(80) + struct.pack("<I", len(facets)) + facets.tobytes()


def ply_text(vertices: ArrayLike, triangles: ArrayLike) -> bytes:
    """Return PLY as text."""
    places = [f"{x!r} {y!r} {z!r}" for x, y, z in np.asarray(vertices, dtype=float).tolist()]
    faces = [f"3 {a} {b} {c}" for a, b, c in np.asarray(triangles).tolist()]
    return "\n".join([*_ply_head("ascii", len(places), len(faces)), *places, *faces, ""]).encode()


def ply_binary(vertices: ArrayLike, triangles: ArrayLike) -> bytes:
    """Return PLY in double precision."""
    places, faces = np.asarray(vertices, dtype="<f8"), np.asarray(triangles)
    rows = np.zeros(len(faces), dtype=[("n", "u1"), ("corners", "<i4", 3)])
    rows["n"], rows["corners"] = 3, faces
    head = [*_ply_head("binary_little_endian", len(places), len(faces)), ""]
    return "\n".join(head).encode() + places.tobytes() + rows.tobytes()


def _ply_head(form: str, vertices: int, faces: int) -> list[str]:
    """Return the lines above vertices of three doubles and faces of lists."""
    properties = [f"property double {axis}" for axis in "xyz"]
    lists = [f"element face {faces}", "property list uchar int vertex_indices", "end_header"]
    return ["ply", f"format {form} 1.0", f"element vertex {vertices}", *properties, *lists]


def glb(header: Mapping[str, Any], content: bytes = b"") -> bytes:
    """Return binary glTF of a header and the bytes of its buffer."""
    text = json.dumps({"asset": {"version": "2.0"}} | dict(header)).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(content), b"BIN\0") + content
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def gltf(
    vertices: ArrayLike, triangles: ArrayLike, nodes: list[dict], *, roots: list[int] | None = None
) -> tuple[dict, bytes]:
    """Return the header of glTF 2.0 and its buffer: one mesh, placed by nodes."""
    places, faces = np.asarray(vertices, dtype="<f4"), np.asarray(triangles, dtype="<u4")
    content = places.tobytes() + faces.tobytes()
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes))) if roots is None else roots}],
        "nodes": nodes,
        "meshes": [{"name": "shape", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(places), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5125, "count": faces.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": places.nbytes},
            {"buffer": 0, "byteOffset": places.nbytes, "byteLength": faces.nbytes},
        ],
        "buffers": [{"byteLength": len(content)}],
    }, content


def package(*parts: tuple[str, bytes | str]) -> bytes:
    """Return an archive of these files, as 3MF is one."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as content:
        for name, data in parts:
            content.writestr(name, data)
    return archive.getvalue()


def mf3(vertices: ArrayLike, triangles: ArrayLike, *, unit: str | None, items: str, resources: str = "") -> bytes:
    """Return 3MF, whose object 1 is the mesh and whose `items` are built."""
    corners = "".join(f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>' for x, y, z in np.asarray(vertices).tolist())
    faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in np.asarray(triangles).tolist())
    mesh = f"<mesh><vertices>{corners}</vertices><triangles>{faces}</triangles></mesh>"
    stated = f' unit="{unit}"' if unit else ""
    space = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    model = (
        f'<?xml version="1.0"?><model xmlns="{space}"{stated}><resources><object id="1" name="pier" type="model">{mesh}'
        f"</object>{resources}</resources><build>{items}</build></model>"
    )
    return package(("3D/3dmodel.model", model))
