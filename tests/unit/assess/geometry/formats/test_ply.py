"""PLY files of all three forms, against trimesh and against one another; triangle strips."""

import io
import struct
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from trimesh.creation import icosphere
from trimesh.exchange.ply import export_ply, load_ply

from assess.geometry.formats.mesh_file import ElementMesh
from assess.geometry.formats.ply import read_ply
from tests.support.files import write_file

BALL = icosphere(subdivisions=1, radius=3.0)
PLY = export_ply(BALL, vertex_normal=True)
BARE = export_ply(BALL, vertex_normal=False)
ASCII = export_ply(BALL, encoding="ascii")
STRUCT = {"<": "binary_little_endian", ">": "binary_big_endian", "": "ascii"}
SQUARE = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (1.0, 1.0, 0.0), (0.0, 2.0, 0.0), (1.0, 2.0, 0.0)]


def read(folder: Path, data: bytes) -> ElementMesh:
    (found,) = read_ply(write_file(folder / "mesh.ply", data)).meshes
    return found


def made(order: str, *, element: str, lists: list[list[int]], color: bool = False) -> bytes:
    """A file of the vertices of SQUARE and lists of their indices."""
    extra = "property uchar red\n" if color else ""
    head = (
        f"ply\nformat {STRUCT[order]} 1.0\nelement vertex {len(SQUARE)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element {element} {len(lists)}\nproperty list int int vertex_indices\n{extra}end_header\n"
    )
    if not order:
        rows = [" ".join(map(str, row)) for row in SQUARE]
        rows += [" ".join(map(str, [len(each), *each, *([7] if color else [])])) for each in lists]
        return (head + "\n".join(rows) + "\n").encode()
    content = b"".join(struct.pack(f"{order}3f", *row) for row in SQUARE)
    for each in lists:
        content += struct.pack(f"{order}{len(each) + 1}i", len(each), *each) + (b"\x07" if color else b"")
    return head.encode() + content


@pytest.mark.parametrize(
    "data",
    [
        PLY,
        BARE,
        ASCII,
        ASCII.replace(b"\n", b"\r\n"),
        BARE.replace(b"\nelement vertex", b"\r\ncomment made here\r\nobj_info by us\nelement vertex"),
        BARE.replace(b"vertex_indices", b"vertex_index"),
        BARE.replace(b"property list uchar int", b"property list uint8 uint32"),
    ],
)
def test_ply_as_trimesh_reads_it(data: bytes, tmp_path: Path) -> None:
    found, wanted = read(tmp_path, data), load_ply(io.BytesIO(data.replace(b"\r\n", b"\n")), skip_materials=True)
    np.testing.assert_allclose(found.vertices, wanted["vertices"], rtol=1e-7, atol=0.0)  # trimesh rounds text
    np.testing.assert_array_equal(found.triangles, wanted["faces"])


@pytest.mark.parametrize("order", ["<", ">", ""])
@pytest.mark.parametrize("color", [False, True])
@pytest.mark.parametrize("lists", [[[0, 1, 2], [1, 3, 2]], [[0, 1, 3, 2], [2, 3, 5], [2, 5, 4]], [[0, 1, 3, 2]]])
def test_faces_of_any_number_of_corners_in_all_forms(
    tmp_path: Path, order: str, color: bool, lists: list[list[int]]
) -> None:
    found = read(tmp_path, made(order, element="face", lists=lists, color=color))
    np.testing.assert_array_equal(found.vertices, SQUARE)
    wanted = {(face[0], *pair) for face in lists for pair in pairwise(face[1:])}
    assert set(map(tuple, found.triangles.tolist())) == wanted


@pytest.mark.parametrize("order", ["<", ">", ""])
@pytest.mark.parametrize(
    ("strips", "wanted"),
    [
        ([[0, 1, 2, 3, 4, 5]], [(0, 1, 2), (2, 1, 3), (2, 3, 4), (4, 3, 5)]),
        ([[0, 1, 2, 3, -1, 2, 3, 4, 5]], [(0, 1, 2), (2, 1, 3), (2, 3, 4), (4, 3, 5)]),
        ([[0, 1, 2, 3], [2, 3, 4, 5]], [(0, 1, 2), (2, 1, 3), (2, 3, 4), (4, 3, 5)]),
        ([[-1, 0, 1, 2, -1, -1, 1, 3, -1]], [(0, 1, 2)]),
    ],
)
def test_strips_of_triangles(
    tmp_path: Path, order: str, strips: list[list[int]], wanted: list[tuple[int, ...]]
) -> None:
    found = read(tmp_path, made(order, element="tristrips", lists=strips))
    assert list(map(tuple, found.triangles.tolist())) == wanted
    corners = np.array(SQUARE)[found.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    np.testing.assert_array_equal(normals, [[0.0, 0.0, 1.0]] * len(wanted))  # all of the same side


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"", "no header"),
        (b"ply\nformat ascii 1.0\n", "no header"),
        (BARE[: BARE.index(b"element face")] + b"end_header\n" + bytes(42 * 12), "it holds 42 points and no faces"),
        (BARE[:-1], 'it announces 80 of "face"'),
        (BARE + b"\1", "goes on behind"),
        (ASCII + b"3 0 1 2\n", "goes on behind"),
        (ASCII[:-20], 'it announces 80 of "face"'),
        (ASCII.replace(b"3.0", b"3,0"), "is no number"),
        (BARE.replace(b"vertex 42", b"vertex 99999999999999999999"), 'of "vertex" and ends'),
        (ASCII.replace(b"vertex 42", b"vertex 99999999999999999999"), 'of "vertex" and ends'),
        (BARE.replace(b"face 80", b"face 888888888888888"), 'of "face" and ends'),
        (BARE.replace(b"property float z", b"property float y"), "no x, y and z"),
        (BARE.replace(b"property float z", b"property other z"), "its header has the line"),
        (BARE.replace(b"binary_little", b"binary_middle"), "its header has the line"),
    ],
)
def test_what_does_not_add_up_is_refused(data: bytes, told: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=told):
        read(tmp_path, data)
