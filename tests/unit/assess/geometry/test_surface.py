"""Closed surfaces and their shells; overlap against linear programming."""

import numpy as np
import pytest
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from assess.errors import GeometryError
from assess.geometry.solid import box
from assess.geometry.surface import check_closed, check_shells, merged

CUBE = box(thickness=1.0, length=1.0, height=1.0, base=[0.0, 0.0, -0.5], density=1.0, name="cube")


def test_merging_finds_the_corners_of_loose_triangles() -> None:
    loose = CUBE.vertices[CUBE.triangles].reshape(-1, 3)
    vertices, triangles = merged(loose, np.arange(36).reshape(-1, 3))
    assert vertices.shape == (8, 3)
    np.testing.assert_array_equal(vertices[triangles].reshape(-1, 3), loose)
    check_closed(vertices, triangles, where="cube")


def test_merging_takes_both_zeros_for_one() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.0, -0.0, 0.0], [0.0, -0.0, 1.0]])
    vertices, triangles = merged(corners, np.array([[0, 1, 2], [3, 1, 4]]))
    assert (len(vertices), len(set(triangles.ravel().tolist()))) == (4, 4)


def test_merging_moves_nothing() -> None:
    near = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1e-12, 0.0, 0.0]])
    assert len(merged(near, np.array([[0, 1, 2], [3, 2, 1]]))[0]) == 4


def test_the_first_boundary_edge_is_named() -> None:
    with pytest.raises(GeometryError) as caught:
        check_closed(
            np.array([[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 0.0, 7.0]]), np.array([[0, 1, 2]]), where="sheet"
        )
    assert str(caught.value) == (
        "sheet: it is open: 3 boundary edges; close the surface (the first runs from (5, 0, 0) to (6, 0, 0) m)"
    )


def placed(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A box of random size anywhere, and its half-spaces A x <= b."""
    sizes, middle = rng.uniform(0.3, 2.0, 3), rng.uniform(-0.9, 0.9, 3)
    turn = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
    return (
        (CUBE.vertices * sizes) @ turn.T + middle,
        np.vstack([turn.T, -turn.T]),
        np.concatenate([sizes / 2.0 + turn.T @ middle, sizes / 2.0 - turn.T @ middle]),
    )


def depth(A: np.ndarray, b: np.ndarray) -> float:
    """Radius of the largest ball in A x <= b (rows of A of unit length), negative where there is none."""
    found = linprog(
        [0.0, 0.0, 0.0, -1.0], A_ub=np.column_stack([A, np.ones(len(A))]), b_ub=b, bounds=[(None, None)] * 4
    )
    return float(found.x[3])


def test_boxes_anywhere_overlap_when_linear_programming_finds_a_common_ball() -> None:
    rng = np.random.default_rng(8)
    overlapping = 0
    for _ in range(80):
        (one, A, b), (other, C, d) = placed(rng), placed(rng)
        vertices, triangles = np.vstack([one, other]), np.vstack([CUBE.triangles, CUBE.triangles + 8])
        wanted = depth(np.vstack([A, C]), np.concatenate([b, d])) > 0.0
        overlapping += wanted
        try:
            check_shells(vertices, triangles, where="pair")
            found = False
        except GeometryError:
            found = True
        assert found == wanted
    assert 20 < overlapping < 70


@pytest.mark.parametrize("gap", [1e-3, 1e-7, 0.0, -1e-7, -1e-4])
def test_shells_may_touch_within_rounding(gap: float) -> None:
    other = CUBE.vertices * [0.5, 0.7, 1.0] + [0.1, 0.05, 1.0 + gap]
    vertices, triangles = np.vstack([CUBE.vertices, other]), np.vstack([CUBE.triangles, CUBE.triangles + 8])
    if gap < -1e-6:
        with pytest.raises(GeometryError, match="2 closed shells overlap, near"):
            check_shells(vertices, triangles, where="pair")
    else:
        check_shells(vertices, triangles, where="pair")
