"""The walls of the demo have the parameters of Mehrotra (2019), Table 8.2: to 1e-9, far below its rounding."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.constants import g

from assess.examples import copy_example
from assess.examples.casa_grande import TABLE, misfit, wall_0, walls
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import equivalent_block
from assess.project.build import build
from assess.project.project_file import load
from spectra.design_spectra import Asce7Spectrum

# Tables 8.2 and 8.3: p [1/s], lambda [rad], restitution, R0 [m], elevation [m]
PUBLISHED = {
    "W0a": (1.60, 0.14, 0.97, 2.84, 0.0),
    "W0b": (3.36, 0.54, 0.62, 0.62, 4.98),
    "W1": (2.15, 0.25, 0.90, 1.75, 3.11),
    "W2": (1.60, 0.23, 0.92, 2.88, 0.0),
    "W3": (1.62, 0.20, 0.94, 2.71, 0.0),
    "W4": (2.67, 0.34, 0.83, 1.04, 3.76),
    "W5": (1.63, 0.24, 0.92, 2.72, 0.0),
    "W6": (2.26, 0.21, 0.94, 1.46, 4.77),
}
RAISED = ("W0b", "W1", "W4", "W6")


@pytest.fixture(scope="module")
def project(tmp_path_factory) -> Path:
    return copy_example("casa_grande", tmp_path_factory.mktemp("demo") / "casa")


@pytest.fixture(scope="module")
def mechanisms(project) -> dict[str, Mechanism]:
    return {mechanism.name: mechanism for mechanism in build(load(project)).mechanisms}


@pytest.mark.parametrize("wall", PUBLISHED)
@pytest.mark.parametrize("side", ["positive", "negative"])
def test_a_wall_from_its_mesh_has_the_published_parameters(wall, side, mechanisms):
    p, slenderness, restitution, radius, elevation = PUBLISHED[wall]
    rocker = mechanisms[wall].oscillator
    branch = getattr(rocker, side)
    block = equivalent_block(branch, mass=rocker.mass)
    assert block.radius == pytest.approx(radius, rel=1e-9)
    assert block.slenderness == pytest.approx(slenderness, rel=1e-9)
    assert branch.linearised.p == pytest.approx(p, rel=1e-6)  # K by the spline of the table
    assert np.sqrt(rocker.mass * g * block.radius / block.inertia) == pytest.approx(p, rel=1e-9)
    assert branch.restitution == pytest.approx(
        restitution, abs=0.0065
    )  # not fitted; 0.0064 at W6: p, lambda, R0 rounded
    assert mechanisms[wall].elevation == pytest.approx(elevation, abs=1e-9)


@pytest.mark.parametrize("name", walls())
def test_a_mesh_is_a_closed_irregular_wall(name, project):
    mesh = trimesh.load_mesh(project.parent / "walls" / f"{name}.ply")
    assert mesh.is_watertight
    assert len(trimesh.graph.connected_components(mesh.face_adjacency)) == 1
    assert 2000 < len(mesh.faces) < 4000
    assert mesh.bounds[0, 2] == 0.0
    assert mesh.volume < 0.9 * np.prod(mesh.extents)  # no plain box
    assert 5.5 < mesh.extents[2] < 7.6  # Matero 1999: the outer walls are 7.6 m high


@pytest.mark.parametrize("wall", ["W2", "W3", "W5"])
def test_an_uncut_mesh_by_trimesh(wall, project):
    """Volume integrals by trimesh."""
    mesh = trimesh.load_mesh(project.parent / "walls" / f"wall_{wall[1]}.ply")
    p, slenderness, _, radius, _ = PUBLISHED[wall]
    foot = mesh.vertices[mesh.vertices[:, 2] == 0.0, 0].max() - mesh.center_mass[0]
    R = np.hypot(foot, mesh.center_mass[2])
    assert radius == pytest.approx(R, rel=1e-9)
    assert slenderness == pytest.approx(np.arctan2(foot, mesh.center_mass[2]), rel=1e-9)
    assert p == pytest.approx(np.sqrt(g * R / (mesh.moment_inertia[1, 1] / mesh.volume + R**2)), rel=1e-9)


@pytest.mark.parametrize("wall", RAISED)
def test_the_hinges_of_an_eroded_band_lie_inside_the_faces(wall, mechanisms, project):
    """Erosion "reduces the wall section by 33-50 %" (Mehrotra, section 8.3); here by 27-55 % of the widest."""
    half = PUBLISHED[wall][3] * np.sin(PUBLISHED[wall][1])
    ring = np.array(mechanisms[wall].outlines[0][0])
    hinge, other = mechanisms[wall].positive.hinges[0][0], -mechanisms[wall].negative.hinges[0][0]
    assert hinge - other == pytest.approx(2 * half, rel=1e-9)
    assert ring[:, 0].max() - hinge > 0.1
    assert other - ring[:, 0].min() > 0.1
    assert 0.27 < 1 - 2 * half / np.ptp(ring[:, 0]) < 0.55


def test_the_two_mechanisms_of_wall_0_are_one_mesh(project):
    sections = load(project).content.mechanisms
    whole, top = sections["W0a"], sections["W0b"]
    assert whole.kind == "single-block"
    assert top.kind == "single-block"
    assert whole.blocks == top.blocks
    assert (whole.cut, top.cut) == (None, 4.98)
    assert np.abs(misfit(wall_0(), (TABLE["W0a"], TABLE["W0b"]))).max() < 1e-12


def test_the_table_example_has_the_published_parameters(tmp_path):
    sections = load(copy_example("casa_grande_table", tmp_path / "table")).content.mechanisms
    assert list(sections) == list(PUBLISHED)
    for wall, section in sections.items():
        assert section.kind == "equivalent-block"
        p, slenderness, _, radius, elevation = PUBLISHED[wall]
        assert (section.p, section.uplift, section.radius, section.elevation) == (p, slenderness, radius, elevation)


@pytest.mark.parametrize(("name", "walls"), [("casa_grande", ("W0a", "W6")), ("casa_grande_flexible", PUBLISHED)])
def test_walls_on_flexible_joints_are_those_on_rigid_ones(name, walls, tmp_path):
    """Mehrotra, 8.4.1: strength 1.00 MPa, stiffness E / course = 6.89 GPa / 0.69 m, "approximately 10.0 GPa/m"."""
    content = load(copy_example(name, tmp_path / name)).content
    sections = content.mechanisms
    assert [key for key in sections if key.endswith("-flexible")] == [f"{wall}-flexible" for wall in walls]
    for wall in walls:
        rigid, flexible = sections[wall], sections[f"{wall}-flexible"]
        assert rigid.kind == "single-block"
        assert flexible.kind == "single-block"
        assert rigid.model_copy(update={"label": flexible.label, "interface": flexible.interface}) == flexible
        assert flexible.interface.model == "flexible"
        assert flexible.interface.stiffness == pytest.approx(6.89e9 / 0.69, rel=2e-3)
        assert flexible.interface.strength == 1.00e6


@pytest.mark.parametrize("name", ["casa_grande", "casa_grande_table", "casa_grande_flexible"])
def test_casa_grande_has_the_published_site(name, tmp_path):
    content = load(copy_example(name, tmp_path / name)).content
    assert content.site is not None
    spectrum = content.site.spectrum.plain
    assert isinstance(spectrum, Asce7Spectrum)
    assert spectrum.s_ds == pytest.approx(2 / 3 * 0.25 * g, abs=0.5e-4 * g)
    assert spectrum.s_d1 == pytest.approx(2 / 3 * 0.08 * g, abs=0.5e-4 * g)
    assert spectrum.t_l == 6.0
    assert content.analysis.levels == pytest.approx([0.1 * g, 0.2 * g, 0.3 * g])
