"""Which face is drawn first, and which edges."""

from __future__ import annotations

import numpy as np
import pytest

from reports.figures.projection import TriangleSurface, occluding_pairs, painting_order, unit_normals, visible_edges

CUBE = np.array([(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
CORNER = np.array([1.0, 1.0, 1.0]) / np.sqrt(3.0)
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = np.array([t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))])


def triangle(x: float, y: float, z: float, *, size: float = 1.0, rise: float = 0.0) -> list[list[float]]:
    return [[x, y, z], [x + size, y, z + rise], [x, y + size, z]]


def test_the_edges_of_a_cube_are_sharp_and_its_diagonals_are_not() -> None:
    drawn = visible_edges(TriangleSurface(CUBE, TRIANGLES), CORNER, 1.0)
    corners = CUBE[TRIANGLES]
    lengths = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ CORNER > 0.0
    assert np.array_equal(drawn[facing], lengths[facing] < 1.1)


def test_three_faces_of_a_cube_look_at_an_eye_in_its_corner_and_their_rim_is_drawn_however_blunt() -> None:
    drawn = visible_edges(TriangleSurface(CUBE, TRIANGLES), CORNER, 3.0)
    seen = unit_normals(CUBE[TRIANGLES]) @ CORNER > 0.0
    assert seen.sum() == 6
    assert drawn[seen].sum() == 6  # the hexagon that the eye sees as the border


def test_order_is_by_depth_where_faces_cover_one_another_not_by_their_middles() -> None:
    # a large face whose middle is nearer than that of a small one, which yet lies before it
    large = triangle(0.0, 0.0, 0.0, size=10.0, rise=30.0)
    small = triangle(1.0, 1.0, 5.0, size=0.5)
    assert np.mean(large, axis=0)[2] > np.mean(small, axis=0)[2]
    corners = np.array([small, large])
    assert painting_order(corners) == [1, 0]
    assert painting_order(corners[::-1]) == [0, 1]


def test_every_face_is_drawn_once_even_where_they_cover_one_another_in_a_ring() -> None:
    turns = np.linspace(0.0, 2.0 * np.pi, 4)[:3]
    blades = []
    for turn in turns:  # each rises over the next
        spin = np.array([[np.cos(turn), -np.sin(turn), 0.0], [np.sin(turn), np.cos(turn), 0.0], [0.0, 0.0, 1.0]])
        blades.append(np.array([[-2.0, 0.4, -1.0], [2.0, 0.4, 1.0], [-2.0, 0.9, -1.0]]) @ spin.T)
    assert sorted(painting_order(np.array(blades))) == [0, 1, 2]


@pytest.mark.parametrize("seed", range(5))
def test_random_faces_are_drawn_as_a_depth_buffer_would_show_them(seed: int) -> None:
    random = np.random.default_rng(seed)
    middle = random.uniform(0.0, 10.0, (60, 1, 3)) * [1.0, 1.0, 4.0]
    corners = middle + random.uniform(-1.2, 1.2, (60, 3, 3)) * [1.0, 1.0, 0.02]  # nearly level: none cross
    place = np.argsort(painting_order(corners))
    at = random.uniform(0.0, 10.0, (4000, 2))
    first, second = (corners[:, i, :2] for i in (0, 1))
    third = corners[:, 2, :2]
    area = np.cross(np.c_[second - first, np.zeros(60)], np.c_[third - first, np.zeros(60)])[:, 2]
    sides = []
    for p, q in ((first, second), (second, third), (third, first)):
        edge = q - p
        sides.append(edge[:, 0] * (at[:, 1, None] - p[:, 1]) - edge[:, 1] * (at[:, 0, None] - p[:, 0]))
    inside = np.all(np.array(sides) * np.sign(area) > 1e-6, axis=0)
    depth = np.where(inside, corners[:, :, 2].mean(axis=1), -99.0)
    painted = np.argmax(np.where(inside, place, -1), axis=1)
    clear = inside.any(axis=1) & (np.sort(depth, axis=1)[:, -1] - np.sort(depth, axis=1)[:, -2] > 0.1)
    assert clear.sum() > 500
    assert np.array_equal(painted[clear], np.argmax(depth, axis=1)[clear])


def test_neighbours_do_not_cover_one_another() -> None:
    lower = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    beside = np.array([[1.0, 0.0, 0.0], [1.0, 1.0, 9.0], [0.0, 1.0, 0.0]])
    above = lower + np.array([0.2, 0.2, 3.0])
    behind, before = occluding_pairs(np.array([lower, beside, above]))
    assert set(zip(behind.tolist(), before.tolist(), strict=True)) == {(0, 2), (1, 2)}
