"""The closed shells of a surface; overlap against linear programming, united volumes against closed forms."""

import numpy as np
import pytest
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from assess.geometry.shells import separate_shells, unify_shells
from assess.geometry.surface import Surface, merge_vertices, volume
from tests.support.solids import solid_box

CUBE = solid_box(base=(0.0, 0.0, -0.5))


def pair(one: np.ndarray, other: np.ndarray) -> Surface:
    return merge_vertices(np.vstack([one, other]), np.vstack([CUBE.triangles, CUBE.triangles + 8]))


def placed(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A box of random size anywhere, and its half-spaces A x <= b."""
    sizes, middle = rng.uniform(0.3, 2.0, 3), rng.uniform(-0.9, 0.9, 3)
    turn = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
    return (
        (CUBE.vertices * sizes) @ turn.T + middle,
        np.vstack([turn.T, -turn.T]),
        np.concatenate([sizes / 2.0 + turn.T @ middle, sizes / 2.0 - turn.T @ middle]),
    )


def test_boxes_anywhere_overlap_when_linear_programming_finds_a_common_ball() -> None:
    rng = np.random.default_rng(8)
    overlapping = 0
    for _ in range(80):
        (one, A, b), (other, C, d) = placed(rng), placed(rng)
        ball = linprog(  # the largest in A x <= b, whose rows are of unit length: its centre and its radius
            [0.0, 0.0, 0.0, -1.0], A_ub=np.column_stack([np.vstack([A, C]), np.ones(len(A) + len(C))]),
            b_ub=np.concatenate([b, d]), bounds=[(None, None)] * 4,
        )  # fmt: skip
        wanted = bool(ball.x[3] > 0.0)
        overlapping += wanted
        surface, told = unify_shells(pair(one, other), where="pair")
        assert bool(told) == wanted
        alone = volume(one, CUBE.triangles) + volume(other, CUBE.triangles)
        assert (volume(*surface) < alone * (1.0 - 1e-9)) == wanted
    assert 20 < overlapping < 70


@pytest.mark.parametrize("gap", [1e-3, 1e-7, 0.0, -1e-7, -1e-4])
def test_shells_may_touch_within_rounding(gap: float) -> None:
    other = CUBE.vertices * [0.5, 0.7, 1.0] + [0.1, 0.05, 1.0 + gap]
    surface = pair(CUBE.vertices, other)
    found, told = unify_shells(surface, where="pair")
    assert (found is surface) == (told == ()) == (gap > -1e-6)


def test_boxes_that_touch_along_an_edge_or_share_corners_are_two_shells() -> None:
    for shift in ([1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]):
        assert [len(triangles) for _, triangles in separate_shells(pair(CUBE.vertices, CUBE.vertices + shift))] == [
            12,
            12,
        ]


def test_a_body_in_a_cavity_of_a_body_stays() -> None:
    """Three shells one in another, and a fourth that cuts the outermost: the larger are laid down first."""
    scaled = [CUBE.vertices * size for size in (4.0, 2.0, 1.0)]
    beam = CUBE.vertices * [4.0, 0.5, 0.5] + [2.0, 0.0, 1.5]  # from the wall's inside out: 2 m of 4 m stand out
    faces = [CUBE.triangles, CUBE.triangles[:, ::-1] + 8, CUBE.triangles + 16, CUBE.triangles + 24]
    surface, told = unify_shells(merge_vertices(np.vstack([*scaled, beam]), np.vstack(faces)), where="nest")
    assert volume(*surface) == pytest.approx(64.0 - 8.0 + 1.0 + 2.0 * 0.25, rel=1e-12)
    assert "4 closed shells" in str(told[0])


def test_uniting_does_not_depend_on_where_the_body_stands() -> None:
    near, _ = unify_shells(pair(CUBE.vertices, CUBE.vertices * 0.5 + 0.4), where="pair")
    there = np.array([5e5, 4e6, 100.0])
    far, _ = unify_shells(pair(CUBE.vertices + there, CUBE.vertices * 0.5 + 0.4 + there), where="pair")
    assert volume(*far) == pytest.approx(volume(*near), rel=1e-8)
