"""The view in space."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure

from reports.figures.projection import Appearance, Hatching, TriangleSurface, fit_camera, paint_bodies
from reports.figures.sketch import AXIS_NAME_BOX, VIEW_SIZE, avoid_names


def test_a_name_is_lowered_until_both_can_be_read() -> None:
    first, second = np.array([50.0, 80.0]), np.array([53.0, 78.0])
    found = avoid_names(second, [first])
    assert found[0] == 53.0
    assert AXIS_NAME_BOX[1] <= first[1] - found[1] < AXIS_NAME_BOX[1] + 1.0
    for clear in (np.array([50.0, 80.0 + 2 * AXIS_NAME_BOX[1]]), np.array([50.0 + 2 * AXIS_NAME_BOX[0], 80.0])):
        np.testing.assert_array_equal(avoid_names(clear, [first]), clear)


def test_a_face_is_followed_by_its_hatching_and_its_drawn_edges() -> None:
    surface = TriangleSurface(np.array([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 0.0, 2.0]]), np.array([[0, 1, 2]]))
    camera = fit_camera(np.array([1.0, 0.0, 0.0]), surface.vertices, VIEW_SIZE)
    axes = Figure().subplots()
    look = Appearance({0: "#804020"}, {0: Hatching(20.0, 0.0, "#000000")}, 1.0)
    paint_bodies(axes, surface, np.zeros(1, dtype=np.int64), camera, look)
    (painted,) = axes.collections
    face, *lines = [path.vertices[:3] for path in painted.get_paths()]
    corners = camera.project(surface.corners[0])[:, :2]
    np.testing.assert_allclose(face, corners)
    assert len(lines) > 6
    assert all(line[0, 1] == pytest.approx(line[1, 1]) for line in lines[:-3])
    passed = {frozenset(map(tuple, np.round(line[:2], 6).tolist())) for line in lines[-3:]}
    ends = [tuple(corner) for corner in np.round(corners, 6).tolist()]
    assert passed == {frozenset({ends[k], ends[(k + 1) % 3]}) for k in range(3)}
