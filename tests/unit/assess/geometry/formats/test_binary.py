"""Plain binary files against trimesh, which reads them too; what is not plain is left to it."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from trimesh.creation import icosphere
from trimesh.exchange.ply import export_ply
from trimesh.exchange.stl import export_stl

from assess.geometry.formats import binary, by_trimesh
from assess.geometry.formats.parts import MeshFile

BALL = icosphere(subdivisions=1, radius=3.0)
STL = export_stl(BALL)
PLY = export_ply(BALL, vertex_normal=True)
BARE = export_ply(BALL, vertex_normal=False)


def same(found: MeshFile | None, wanted: MeshFile) -> None:
    assert found is not None
    (one,), (other,) = found.parts, wanted.parts
    assert (found.unit, found.up, one.element) == (wanted.unit, wanted.up, other.element)
    np.testing.assert_array_equal(one.vertices, other.vertices)
    np.testing.assert_array_equal(one.triangles, other.triangles)
    assert one.vertices.dtype == other.vertices.dtype == np.float64


def kept(folder: Path, data: bytes) -> Path:
    (folder / "mesh").write_bytes(data)
    return folder / "mesh"


def test_stl_as_trimesh_reads_it(tmp_path: Path) -> None:
    same(binary.stl(STL), by_trimesh.read_stl(kept(tmp_path, STL)))


@pytest.mark.parametrize(
    "data",
    [
        PLY,
        BARE,
        BARE.replace(b"\nelement vertex", b"\r\ncomment made here\r\nobj_info by us\nelement vertex"),
        BARE.replace(b"vertex_indices", b"vertex_index"),
        BARE.replace(b"property list uchar int", b"property list uint8 uint32"),
    ],
)
def test_ply_as_trimesh_reads_it(data: bytes, tmp_path: Path) -> None:
    same(binary.ply(data), by_trimesh.read_ply(kept(tmp_path, data)))


@pytest.mark.parametrize(
    "data",
    [
        b"",
        BARE[:-1],
        BARE + b"\0",
        BARE.replace(b"little", b"big"),
        BARE.replace(b"property list uchar int", b"property list uchar float"),
        BARE.replace(b"property float z", b"property float y"),
        BARE.replace(b"property float z", b"property other z"),
        BARE.replace(b"element face 80", b"element face 0"),
        export_ply(BALL, encoding="ascii"),
    ],
)
def test_no_other_ply_is_plain(data: bytes) -> None:
    assert binary.ply(data) is None


def test_faces_of_more_corners_are_not_plain(tmp_path: Path) -> None:
    start = BARE.index(b"end_header\n") + len(b"end_header\n")
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype="<f4").tobytes()
    faces = b"\x04" + np.arange(4, dtype="<i4").tobytes()
    header = BARE[:start].replace(b"vertex 42", b"vertex 4").replace(b"face 80", b"face 1")
    assert binary.ply(header + square + faces) is None
    assert len(binary.read_ply(kept(tmp_path, header + square + faces)).parts[0].triangles) == 2


@pytest.mark.parametrize("data", [b"", STL[:-1], STL + b"\0", STL[:80] + bytes(4), b"solid text"])
def test_no_other_stl_is_plain(data: bytes) -> None:
    assert binary.stl(data) is None


def test_plain_files_are_read_without_trimesh(tmp_path: Path) -> None:
    files = kept(tmp_path, STL), tmp_path / "mesh.ply"
    files[1].write_bytes(PLY)
    code = (
        "import sys; from pathlib import Path; from assess.geometry.formats import binary\n"
        f"binary.read_stl(Path({str(files[0])!r})), binary.read_ply(Path({str(files[1])!r}))\n"
        "sys.exit('trimesh' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
