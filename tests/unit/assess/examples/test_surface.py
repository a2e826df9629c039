"""Surfaces of the examples' bodies against closed forms, and against trimesh's own reading of the file."""

from __future__ import annotations

from math import pi, tan

import numpy as np
import pytest
import trimesh

from assess.examples.surfaces import ClosedSurface, ply, revolve, slab


def read(surface: ClosedSurface) -> trimesh.Trimesh:
    """The surface's file as trimesh reads it."""
    return trimesh.load_mesh(trimesh.util.wrap_as_stream(ply(surface)), file_type="ply")


Y, Z = np.meshgrid(np.linspace(-1.0, 1.0, 3), np.linspace(0.0, 3.0, 4))
SLAB = slab(*(np.stack([np.full_like(Y, x), Y, Z], -1) for x in (0.25, -0.25)))  # 0.5 m x 2 m x 3 m


def test_a_slab_is_a_closed_box():
    mesh = read(SLAB)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(3.0, rel=1e-12)
    np.testing.assert_allclose(mesh.center_mass, [0.0, 0.0, 1.5], rtol=0, atol=1e-12)
    assert mesh.area == pytest.approx(2 * (0.5 * 2 + 0.5 * 3 + 2 * 3), rel=1e-12)


@pytest.mark.parametrize(
    ("profile", "volume", "euler"),
    [
        ([(3.0, 0.0), (3.0, 5.0), (2.0, 5.0), (2.0, 0.0)], (9.0 - 4.0) * 5.0, 0),
        ([(3.0, 0.0), (0.0, 6.0), (0.0, 0.0)], 9.0 * 6.0 / 3.0, 2),
        ([(3.0, 0.0), (0.0, 6.0), (0.0, 4.0), (2.0, 0.0)], (9.0 * 6.0 - 4.0 * 4.0) / 3.0, 2),
    ],
    ids=["pipe", "cone", "hollow cone"],
)
def test_a_body_of_revolution(profile, volume, euler):
    faces = 12
    mesh = read(revolve(profile, faces=faces))
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(volume * faces * tan(pi / faces), rel=1e-12)
    np.testing.assert_allclose(mesh.bounds[:, 0], [-3.0, 3.0], rtol=1e-12)
    assert mesh.euler_number == euler  # of a ring, of a ball


def test_the_file_keeps_every_digit():
    surface = SLAB
    np.testing.assert_array_equal(np.unique(read(surface).vertices, axis=0), np.unique(surface.points, axis=0))
