"""Surfaces with fewer triangles, against trimesh's volumes."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from assess.geometry.surface import simplify


def finer(mesh: trimesh.Trimesh, times: int) -> tuple[np.ndarray, np.ndarray]:
    for _ in range(times):
        mesh = mesh.subdivide()
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


def test_a_small_surface_stays_as_it_is():
    vertices, triangles = finer(trimesh.creation.box((1.0, 2.0, 3.0)), 2)
    same = simplify(vertices, triangles, limit=len(triangles))
    assert same[0] is vertices
    assert same[1] is triangles


def test_a_refined_box_keeps_its_faces_and_corners():
    vertices, triangles = finer(trimesh.creation.box((1.0, 3.0, 4.0)), 5)
    points, faces = simplify(vertices, triangles, limit=1000)
    light = trimesh.Trimesh(points, faces, process=False)
    assert len(faces) <= 1000 < len(triangles)
    assert light.is_watertight
    assert light.volume == pytest.approx(12.0, rel=1e-9)
    assert light.bounds == pytest.approx(np.array([[-0.5, -1.5, -2.0], [0.5, 1.5, 2.0]]), abs=1e-9)


@pytest.mark.parametrize("limit", [4, 200, 4000])
def test_a_sphere_far_from_the_origin_keeps_its_shape(limit):
    sphere, away = trimesh.creation.icosphere(subdivisions=5), np.array([4e5, 5e6, 100.0])
    points, faces = simplify(np.asarray(sphere.vertices) + away, np.asarray(sphere.faces), limit=limit)
    assert len(faces) <= limit
    if limit >= 200:
        light = trimesh.Trimesh(points - away, faces, process=False)
        assert light.volume == pytest.approx(sphere.volume, rel=20.0 / limit)
        assert len(faces) > limit / 3
