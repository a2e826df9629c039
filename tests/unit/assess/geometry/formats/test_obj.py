"""OBJ and OFF text: objects, faces of any number of corners, numbers that count back, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from assess.geometry.formats import text_blocks
from assess.geometry.formats.obj import read_obj
from assess.geometry.formats.off import read_off
from tests.support.files import write_file

TWO = """# two triangles, each behind its own vertices
o north wall
v 0 0 0
v 1 0 0
v 0 1 0
f -3 -2 -1
o south
v 5 0 0 1.0
v 6 0 0 0.1 0.2 0.3
v 5 1 0
vn 0 0 1
vt 0.5 0.5
f -3/1/1 -2//1 -1/1
f 4 5 6 \\
  3
l 1 2
"""


@pytest.mark.parametrize("block", [1 << 22, 7, 30])
@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_objects_and_numbers_that_count_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, block: int, ending: str
) -> None:
    monkeypatch.setattr(text_blocks, "BLOCK", block)
    north, south = read_obj(write_file(tmp_path / "mesh", TWO.replace("\n", ending))).meshes
    assert (north.element.names, south.element.names) == (("north wall",), ("south",))
    np.testing.assert_array_equal(north.vertices[north.triangles], [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]])
    np.testing.assert_array_equal(
        south.vertices[south.triangles],
        [
            [[5, 0, 0], [6, 0, 0], [5, 1, 0]],
            [[5, 0, 0], [6, 0, 0], [5, 1, 0]],
            [[5, 0, 0], [5, 1, 0], [0, 1, 0]],
        ],
    )


def test_groups_are_the_parts_where_there_are_no_objects(tmp_path: Path) -> None:
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\ng b\nf 3 2 1\ng a\nf 2 3 1\n"
    one, two = read_obj(write_file(tmp_path / "mesh", text)).meshes
    assert (one.element.names, two.element.names) == (("a",), ("b",))
    assert (len(one.triangles), len(two.triangles)) == (2, 1)


def test_points_without_faces_are_told_as_such(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="it holds 2 points and no faces; make a closed surface of the points first"):
        read_obj(write_file(tmp_path / "mesh", "v 0 0 0\nv 1 0 0\n"))
    assert read_obj(write_file(tmp_path / "mesh", "# nothing\n")).meshes == ()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n", '"1,5" is no number; decimals take a point'),
        ("v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a vertex has 2 numbers; read are x y z"),
        ("v 0 0 0\nv 1 0 0 .5\nv 0 1 0\nf 1 2 3\n", "a fourth number that is not 1"),
        ("v 0 0 0\nv 1 .5 0 .5 1\nv 0 1 0\nf 1 2 3\n", "a vertex has 5 numbers"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "no whole number from 1"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2.5\n", "no whole number from 1"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 three\n", '"three" is no number'),
        ("f 1 2 3\n", "it has faces and no vertices"),
    ],
)
def test_text_that_is_not_so_is_refused(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        read_obj(write_file(tmp_path / "mesh", text))


SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


@pytest.mark.parametrize(
    "text",
    [
        "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
        "# made here\nOFF 4 2 5 # edges\n\n0 0 0\n1 0 0\n1 1 0 # third\n0 1 0\n# faces\n3 0 1 2 255 0 0\n3 0 2 3\n",
        "COFF\r\n4 1 0\r\n0 0 0 1 1 1 1\r\n1 0 0 1 1 1 1\r\n1 1 0 1 1 1 1\r\n0 1 0 1 1 1 1\r\n4 0 1 2 3\r\n",
        " OFF4 2\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n",
    ],
)
def test_off_with_comments_colours_and_faces_of_more_corners(tmp_path: Path, text: str) -> None:
    (found,) = read_off(write_file(tmp_path / "mesh", text)).meshes
    np.testing.assert_array_equal(found.vertices, SQUARE)
    assert sorted(found.triangles.tolist()) == [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
            "announces 4 vertices and 3 faces and has 6 lines",
        ),
        ("OFF\n999999999999 3 0\n0 0 0\n", "has 1 lines"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 0 1 2\n", "a face of 9 corners has 3 numbers"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0 .5\n0 1 0\n3 0 1 2\n", "some vertices have 3 numbers, others 4; is a decimal lost"),
        ("OFF BINARY\n", "does not begin"),
        ("", "does not begin"),
    ],
)
def test_off_that_does_not_add_up_is_refused(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        read_off(write_file(tmp_path / "mesh", text))


def test_what_is_held_is_a_few_times_the_numbers(tmp_path: Path) -> None:
    """Allocations of numpy at their highest, for 40 000 vertices in blocks that are small against the file."""
    import tracemalloc

    rng = np.random.default_rng(1)
    places, corners = rng.random((40_000, 3)), rng.integers(1, 40_000, (80_000, 3))
    text = [*(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in places), *(f"f {a} {b} {c}" for a, b, c in corners)]
    file = write_file(tmp_path / "mesh", "\n".join(text) + "\n")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(text_blocks, "BLOCK", 1 << 16)
        tracemalloc.start()
        (found,) = read_obj(file).meshes
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    np.testing.assert_allclose(found.vertices, places, rtol=0.0, atol=1e-6)
    np.testing.assert_array_equal(found.triangles, corners - 1)
    assert peak < 4 * (found.vertices.nbytes + found.triangles.nbytes)


def test_boxes_with_faces_counted_back_have_both_volumes(tmp_path: Path) -> None:
    """Numbers count back from where they stand, not from the end of the file."""
    from assess.geometry.mesh import load_solid

    cube = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    quads = [(1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]
    text = ""
    for at, size in ((0, 1), (5, 2)):
        text += "".join(f"v {x * size + at} {y * size} {z * size}\n" for x, y, z in cube)
        text += "".join("f " + " ".join(str(corner - 9) for corner in quad) + "\n" for quad in quads)
    (tmp_path / "boxes.obj").write_text(text)
    found = load_solid(tmp_path / "boxes.obj", density=1.0, name="boxes")
    assert (found.mass, found.history) == (pytest.approx(9.0, rel=1e-12), ())


@pytest.mark.parametrize("stray", [b"v 1 0 0\r.5\n", b"0.5 1 2\n", b"-1 0 0\n"])
def test_a_line_that_begins_with_a_number_is_refused(tmp_path: Path, stray: bytes) -> None:
    """A carriage return within a number makes a vertex of what stands before it and leaves the rest behind."""
    (tmp_path / "a.obj").write_bytes(b"v 0 0 0\n" + stray + b"v 0 1 0\nv 0 0 1\nf 1 2 3\n")
    with pytest.raises(ValueError, match="begins with a number"):
        read_obj(tmp_path / "a.obj")
