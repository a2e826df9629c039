"""The shipped examples load, and say what their sources say."""

from math import pi
from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.constants import g

from assess.errors import ProjectError
from assess.examples import EXAMPLES, copy_example, source
from assess.examples.tapered_wall import WALL_0A, ascii_stl, tapered_wall
from assess.project.schema import load
from assess.project.sections import Asce7Spectrum, EquivalentBlock, MeshBody

# Mehrotra (2019), Tables 8.2 and 8.3: p [1/s], lambda [rad], restitution, R0 [m], elevation [m]
TABLE = {
    "W0a": (1.60, 0.14, 0.97, 2.84, 0.0),
    "W0b": (3.36, 0.54, 0.62, 0.62, 4.98),
    "W1": (2.15, 0.25, 0.90, 1.75, 3.11),
    "W2": (1.60, 0.23, 0.92, 2.88, 0.0),
    "W3": (1.62, 0.20, 0.94, 2.71, 0.0),
    "W4": (2.67, 0.34, 0.83, 1.04, 3.76),
    "W5": (1.63, 0.24, 0.92, 2.72, 0.0),
    "W6": (2.26, 0.21, 0.94, 1.46, 4.77),
}


@pytest.mark.parametrize("name", EXAMPLES)
def test_example_is_copied_and_loads(name: str, tmp_path: Path) -> None:
    file = copy_example(name, tmp_path / "deep" / "new")
    assert load(file).content.mechanisms
    assert sorted(p.name for p in (tmp_path / "deep").iterdir()) == ["new"]


def test_every_folder_of_examples_is_listed() -> None:
    folders = {path.parent.name for path in source("x").parent.glob("*/project.toml")}
    assert folders == set(EXAMPLES)


def test_empty_folder_is_filled_and_others_are_refused(tmp_path: Path) -> None:
    copy_example("single_wall", tmp_path)
    with pytest.raises(ProjectError, match="is not empty"):
        copy_example("casa_grande", tmp_path)
    with pytest.raises(ProjectError, match="is a file"):
        copy_example("casa_grande", tmp_path / "project.toml")
    with pytest.raises(ProjectError, match='did you mean "casa_grande"'):
        copy_example("casa_grand", tmp_path / "x")
    assert [p.name for p in tmp_path.iterdir()] == ["project.toml"]


@pytest.mark.parametrize("wall", TABLE)
def test_casa_grande_has_the_published_parameters(wall: str) -> None:
    mechanism = load(source("casa_grande")).content.mechanisms[wall]
    assert isinstance(mechanism, EquivalentBlock)
    p, slenderness, _, radius, elevation = TABLE[wall]
    assert (mechanism.p, mechanism.uplift, mechanism.radius, mechanism.elevation) == (p, slenderness, radius, elevation)


def test_casa_grande_has_the_published_site() -> None:
    content = load(source("casa_grande")).content
    assert content.site is not None
    spectrum = content.site.spectrum
    assert isinstance(spectrum, Asce7Spectrum)
    assert spectrum.s_ds == pytest.approx(2 / 3 * 0.25 * g, abs=0.5e-4 * g)
    assert spectrum.s_d1 == pytest.approx(2 / 3 * 0.08 * g, abs=0.5e-4 * g)
    assert spectrum.t_l == 6.0
    assert content.analysis.levels == pytest.approx([0.1 * g, 0.2 * g, 0.3 * g])


def mesh_of_wall_0a() -> trimesh.Trimesh:
    content = load(source("casa_grande")).content
    body = content.bodies["wall-0a"]
    assert isinstance(body, MeshBody)
    assert body.mesh_unit == 1.0
    return trimesh.load_mesh(body.mesh)


def test_mesh_of_wall_0a_has_the_published_parameters() -> None:
    """Volume integrals by trimesh: R0 and slenderness within 1e-6 of Table 8.2, and p as well."""
    mesh = mesh_of_wall_0a()
    assert mesh.is_watertight
    half_base, z_c = mesh.extents[0] / 2, mesh.center_mass[2]
    radius = np.hypot(half_base, z_c)
    inertia = mesh.moment_inertia[1, 1] / mesh.volume + radius**2
    assert mesh.bounds[0, 2] == 0.0
    assert radius == pytest.approx(2.84, rel=1e-6)
    assert np.arctan2(half_base, z_c) == pytest.approx(0.14, rel=1e-6)
    assert np.sqrt(g * radius / inertia) == pytest.approx(1.60, rel=1e-6)


def test_shipped_mesh_is_what_the_function_makes() -> None:
    made = trimesh.load_mesh(trimesh.util.wrap_as_stream(ascii_stl(WALL_0A, name="wall_0a")), file_type="stl_ascii")
    np.testing.assert_allclose(made.triangles, mesh_of_wall_0a().triangles, rtol=0, atol=1e-12)


def test_without_taper_the_wall_is_a_rectangle() -> None:
    """p^2 = 3 g / 4 R (Housner 1963) is a rectangle's."""
    wall = tapered_wall(p=float(np.sqrt(3 * g / (4 * 2.0))) * (1 - 1e-12), slenderness=pi / 12, radius=2.0, length=1.0)
    assert wall.top == pytest.approx(wall.base, rel=1e-6)
    assert wall.height == pytest.approx(4.0 * np.cos(pi / 12), rel=1e-6)


def test_taper_beyond_a_triangle_is_refused() -> None:
    with pytest.raises(ValueError, match="different signs"):
        tapered_wall(p=1.0, slenderness=0.14, radius=2.84, length=3.0)
