"""Small files that would become huge are refused before they do, in little memory and time."""

import io
import json
import struct
import tracemalloc
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from assess.errors import GeometryError
from assess.geometry.formats.readers import read_mesh_file
from tests.support.mesh_files import glb, package

SPACE = 'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"'
CORNERS = '<vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>'
MESH = f'<mesh><vertices>{CORNERS}</vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>'


def model(resources: str, *, before: str = "", item: str = "1") -> bytes:
    build = f'<build><item objectid="{item}"/></build>'
    return f'<?xml version="1.0"?>{before}<model {SPACE}><resources>{resources}</resources>{build}</model>'.encode()


def nested(levels: int) -> str:
    """An object of ten of the level below, and so on."""
    text = f'<object id="0">{MESH}</object>'
    for level in range(1, levels + 1):
        parts = f'<component objectid="{level - 1}"/>' * 10
        text += f'<object id="{level}"><components>{parts}</components></object>'
    return text


def understated(data: bytes, size: int) -> bytes:
    """The package with another unpacked size announced, in both places."""
    real = struct.pack("<I", zipfile.ZipFile(io.BytesIO(data)).infolist()[0].file_size)
    return data.replace(real, struct.pack("<I", size))


def scene(**accessor: object) -> dict[str, object]:
    first = {"componentType": 5126, "type": "VEC3", "count": 3} | accessor
    return {
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [first],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36}],
    }


LAUGHS = "<!DOCTYPE m [" + '<!ENTITY a0 "ha">' + "".join(
    f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 12)
) + "]>"  # fmt: skip


@pytest.mark.parametrize(
    ("name", "data", "told"),
    [
        ("a.3mf", lambda: package(("3D/3dmodel.model", model(" " * 150_000_000))), "would unpack to 150 MB"),
        (
            "a.3mf",
            lambda: package(("3D/3dmodel.model", model(MESH)), ("Metadata/thumbnail.png", bytes(150_000_000))),
            "would unpack to 150 MB",
        ),
        ("a.3mf", lambda: understated(package(("3D/3dmodel.model", model(" " * 90_000_000))), 1000), "CRC|bad|Bad"),
        ("a.3mf", package(("3D/3dmodel.model", model("&a11;", before=LAUGHS))), "declares a document type"),
        ("a.3mf", package(("3D/3dmodel.model", model("", before=LAUGHS).decode().encode("utf-16"))), "document type"),
        ("a.3mf", package(("3D/3dmodel.model", model(nested(9), item="9"))), "more than 100000 instances"),
        (
            "a.3mf",
            package(
                (
                    "3D/3dmodel.model",
                    model('<object id="1"><components><component objectid="1"/></components></object>'),
                )
            ),
            "is a component of itself",
        ),
        ("a.glb", glb(scene(count=10**12, bufferView=0), bytes(36)), "announces 1000000000000 values"),
        ("a.glb", glb(scene(count=10**12), bytes(36)), "announces 1000000000000 values"),
        ("a.glb", glb(scene(count=-3, bufferView=0), bytes(36)), "announces -3 values"),
        ("a.glb", glb(scene(bufferView=0) | {"extensionsUsed": ["KHR_draco_mesh_compression"]}), "packed by Draco"),
        ("a.glb", glb(scene(bufferView=0) | {"extensionsUsed": ["EXT_meshopt_compression"]}), "packed by meshopt"),
        ("a.glb", glb(scene(bufferView=0, sparse={"count": 1}), bytes(36)), "sparse accessors"),
        (
            "a.gltf",
            json.dumps(scene(bufferView=0) | {"buffers": [{"byteLength": 36, "uri": "my%20wall.bin"}]}).encode(),
            'the file "my wall.bin" that it names is not beside it',
        ),
        ("a.stl", bytes(80) + b"\xff\xff\xff\x7f" + bytes(50), "announces 2147483647 facets"),
        (
            "a.ply",
            b"ply\nformat binary_big_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n",
            "announces",
        ),
        ("a.off", b"OFF\n4000000000 1 0\n0 0 0\n", "announces 4000000000 vertices"),
    ],
)
def test_what_would_be_huge_is_refused_without_memory_for_it(
    tmp_path: Path, name: str, data: bytes | Callable[[], bytes], told: str
) -> None:
    (tmp_path / name).write_bytes(data() if callable(data) else data)
    import trimesh.exchange.gltf
    import trimesh.exchange.threemf  # noqa: F401 - their import is not what is measured

    tracemalloc.start()
    with pytest.raises(GeometryError, match=told):
        read_mesh_file(tmp_path / name, where="mesh")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 20_000_000


def test_components_and_repeated_parts_are_read(tmp_path: Path) -> None:
    (tmp_path / "a.3mf").write_bytes(package(("3D/3dmodel.model", model(nested(2), item="2"))))
    assert len(read_mesh_file(tmp_path / "a.3mf", where="mesh").meshes) == 100
