"""STL files, binary and text, against trimesh."""

import io
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from trimesh.creation import icosphere
from trimesh.exchange.ply import export_ply
from trimesh.exchange.stl import export_stl, export_stl_ascii, load_stl

from assess.geometry.formats import stl
from tests.support.files import write_file

BALL = icosphere(subdivisions=1, radius=3.0)
STL = export_stl(BALL)
TEXT = export_stl_ascii(BALL).encode()


@pytest.mark.parametrize(
    "data",
    [
        STL,
        b"solid" + STL[5:],
        TEXT,
        TEXT.replace(b"\n", b"\r\n"),
        TEXT.upper(),
        TEXT.replace(b"vertex ", b" \tvertex\t  "),
    ],
)
def test_stl_as_trimesh_reads_it(data: bytes, tmp_path: Path) -> None:
    (found,) = stl.read_stl(write_file(tmp_path / "mesh", data)).meshes
    wanted = load_stl(io.BytesIO(data.lower() if data.isupper() else data))
    corners = wanted.get("geometry", {"": wanted}).popitem()[1]
    np.testing.assert_array_equal(found.vertices[found.triangles], corners["vertices"][corners["faces"]])
    assert found.vertices.dtype == np.float64


def test_the_solids_of_a_text_are_its_parts(tmp_path: Path) -> None:
    one = TEXT.replace(b"solid", b"solid north wall", 1)
    two = TEXT.replace(b"solid", b"solid south wall", 1)
    found = stl.read_stl(write_file(tmp_path / "mesh", one + b"\n" + two)).meshes
    assert [part.element.names for part in found] == [("north wall",), ("south wall",)]
    np.testing.assert_array_equal(found[0].vertices, found[1].vertices)


@pytest.mark.parametrize("data", [b"", STL[:-1], STL + b"\0", STL[:80] + bytes(4), b"solid text"])
def test_no_other_stl_is_plain(data: bytes) -> None:
    assert stl.parse_binary_stl(data) is None


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (STL[:-1], "it announces 80 facets of 50 bytes and has 4083 bytes"),
        (STL[:80] + b"\xff\xff\xff\xff" + STL[84:], "it announces 4294967295 facets"),
        (TEXT.replace(b"vertex", b"vertax", 1), "is no number"),
        (TEXT.replace(b"vertex -1.", b"vertex -1,", 1), "decimals take a point"),
        (b"solid nothing\nendsolid", "it has no facets"),
    ],
)
def test_what_does_not_add_up_is_refused(data: bytes, told: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=told):
        stl.read_stl(write_file(tmp_path / "mesh", data))


def test_plain_files_are_read_without_trimesh(tmp_path: Path) -> None:
    (tmp_path / "mesh.stl").write_bytes(STL)
    (tmp_path / "mesh.ply").write_bytes(export_ply(BALL))
    code = (
        "import sys; from pathlib import Path; from assess.geometry.formats.readers import read_mesh_file\n"
        f"[read_mesh_file(Path({str(tmp_path)!r}) / name, where='mesh').meshes for name in ('mesh.stl', 'mesh.ply')]\n"
        "sys.exit('trimesh' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
