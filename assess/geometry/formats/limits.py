"""Limits on what files may unpack to or multiply into, held against what they announce before any of it is made."""

from __future__ import annotations

import json
import struct
import zlib
from pathlib import Path
from typing import Any
from urllib.parse import unquote
from zipfile import BadZipFile, ZipFile, ZipInfo

MAX_RATIO = (
    100  # times its own size that an archive may unpack to; text of meshes packs to a tenth, at most a thirtieth
)
ALWAYS_ALLOWED = 100_000_000  # bytes that any archive may unpack to
MAX_UNPACKED = 4_000_000_000  # bytes that none may exceed
MAX_INSTANCES = 100_000  # of meshes in a scene
MAX_TRIANGLES = 100_000_000  # of a scene with all its instances
COMPRESSIONS = {
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}
WIDTHS = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}  # bytes of glTF's component types
NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
BLOCK = 1 << 18  # bytes unpacked at a time
PROLOGUE = 1 << 16  # bytes in which a document type stands, if there is one


def unpack_3mf(file: Path) -> dict[str, bytes]:
    """The model parts of a 3MF package by name; nothing is unpacked where all of it would be too large.

    Raises
    ------
    ValueError : it is no package, or unpacks to too much; a part declares entities
    """
    with ZipFile(file) as package:
        _refuse_large(sum(each.file_size for each in package.infolist()), packed=file.stat().st_size)
        models = [each for each in package.infolist() if each.filename.lower().endswith(".model")]
        found = {each.filename: _unpack(package, each) for each in models}
    for model in found.values():
        if b"<!DOCTYPE" in model[:PROLOGUE].replace(b"\0", b"").upper():
            raise ValueError("it declares a document type, which 3MF forbids")
    return found


def _unpack(package: ZipFile, member: ZipInfo) -> bytes:
    """A member, unpacked by blocks: then zipfile gives no more than it announces."""
    found = bytearray()
    try:
        with package.open(member) as content:
            while block := content.read(BLOCK):
                found += block
    except (BadZipFile, RuntimeError, NotImplementedError, zlib.error) as problem:
        raise ValueError(str(problem)) from None
    return bytes(found)


def _refuse_large(unpacked: int, *, packed: int) -> None:
    if unpacked > min(MAX_UNPACKED, max(ALWAYS_ALLOWED, MAX_RATIO * packed)):
        raise ValueError(f"its {packed / 1e6:.3g} MB would unpack to {unpacked / 1e6:.4g} MB, which no mesh does")


def gltf_header(file: Path) -> Any:
    """The JSON of a glTF file, binary or not.

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
        there = ALWAYS_ALLOWED if view is None else int(views[view]["byteLength"])
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
