"""The JSON header of a glTF file, checked against the size of the file before any mesh is read."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any
from urllib.parse import unquote

COMPRESSIONS = {
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}
WIDTHS = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}  # bytes of glTF's component types
NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
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
        beside = unquote(str(buffer.get("uri", "data:")))
        if not beside.startswith("data:") and not (file.parent / beside).is_file():
            raise ValueError(f'the file "{beside[:40]}" that it names is not beside it')
    views = header.get("bufferViews", [])
    for accessor in header.get("accessors", []):
        if "sparse" in accessor:
            raise ValueError("its meshes are said by differences (sparse accessors); export it without them")
        needed = int(accessor["count"]) * WIDTHS[accessor["componentType"]] * NUMBERS[accessor["type"]]
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
