"""The bodies in space as they stand in the results, against trimesh and the boxes they were made from."""

from __future__ import annotations

import json
from math import cos, pi, sin
from pathlib import Path

import numpy as np
import pytest
import trimesh
from shapely import Polygon

from assess.geometry.cut import Scene
from assess.geometry.planar import planar_body
from assess.geometry.solid import box, polyhedron
from assess.mechanisms.single_block import single_block
from assess.project.build import build
from assess.project.project_file import load
from assess.study.drawing import VIEW_TRIANGLES, edges_in_space, view_in_space
from assess.study.mechanism_results import parameters
from tests.support.projects import block, project_toml, published, wall

PROJECT = project_toml(
    site=None,
    bodies={
        "wall": wall(base=[100.0, 50.0, 0.0]),
        "vault": 'material = "brick"\nprofile = PROFILE\nlength = 2.0',
        "numbers": {"mass": 1000.0, "centroid": [0.0, 2.0], "inertia": 2000.0},
    },
    mechanisms={
        "whole": block(),
        "upper": block(direction=[0, -1, 0], cut=1.5),
        "cracked": block(kind="two-block", crack=2.5),
        "arch": block("vault", kind="four-hinge", hinges="minimum")
        | {"joints": {"centre": [0, 0], "first": "160 deg", "last": "20 deg", "count": 9}},
        "numbers": block("numbers", hinges={"A": [0.3, 0.0]}, sides="one"),
        "published": published(),
    },
)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    path: Path = tmp_path_factory.mktemp("view") / "project.toml"
    path.write_text(PROJECT.replace("PROFILE", str([*ring(3.4), *ring(2.6)[::-1]])))
    return {each.name: each for each in parameters(build(load(path)))}


def ring(radius):
    return [[radius * cos(turn), radius * sin(turn)] for turn in np.linspace(0.0, pi, 61)]


@pytest.fixture(scope="module")
def views(results):
    return {name: each.view for name, each in results.items()}


def mesh(seen, *, block):
    triangles = np.array(seen.triangles)[np.array(seen.block_of) == block]
    return trimesh.Trimesh(np.array(seen.vertices), triangles, process=False)


def test_mechanisms_without_geometry_have_no_view(views):
    assert views["numbers"] is None
    assert views["published"] is None


def test_a_whole_body_moves_and_turns_about_the_edges_of_its_base(views):
    seen = views["whole"]
    assert set(seen.block_of) == {0}
    assert mesh(seen, block=0).volume == pytest.approx(0.6 * 3.0 * 4.0)
    assert seen.size == (0.6, 3.0, 4.0)
    ends = {axis.name: axis.ends for axis in seen.axes}
    assert ends["A"] == ((100.3, 48.5, 0.0), (100.3, 51.5, 0.0))
    assert ends["A'"] == ((99.7, 48.5, 0.0), (99.7, 51.5, 0.0))
    assert seen.sections == ()


def test_a_cut_body_moves_above_the_section(views):
    seen = views["upper"]
    moving, fixed = (mesh(seen, block=block) for block in (0, -1))
    assert moving.volume == pytest.approx(0.6 * 3.0 * 2.5)
    assert fixed.volume == pytest.approx(0.6 * 3.0 * 1.5)
    (ring,) = (np.array(section) for section in seen.sections)
    assert np.all(ring[:, 2] == 1.5)
    assert np.ptp(ring, axis=0) == pytest.approx((0.6, 3.0, 0.0))
    assert np.array_equal(ring[0], ring[-1])
    (first, second) = (np.array(axis.ends) for axis in seen.axes)
    assert first[:, 1] == pytest.approx(48.5)  # the edge towards -y
    assert second[:, 1] == pytest.approx(51.5)
    assert seen.direction == (0.0, -1.0, 0.0)


def test_a_cracked_wall_is_two_blocks_and_nothing_stays(views):
    seen = views["cracked"]
    assert mesh(seen, block=0).volume == pytest.approx(0.6 * 3.0 * 2.5)
    assert mesh(seen, block=1).volume == pytest.approx(0.6 * 3.0 * 1.5)
    assert set(seen.block_of) == {0, 1}
    assert [axis.name for axis in seen.axes] == ["A", "B", "C", "A'", "B'", "C'"]
    (ring,) = (np.array(section) for section in seen.sections)
    assert np.all(ring[:, 2] == 2.5)


def test_an_arch_is_three_blocks_on_what_stays_and_whole(views):
    seen = views["arch"]
    assert set(seen.block_of) == {-1, 0, 1, 2}
    total = sum(mesh(seen, block=block).volume for block in (-1, 0, 1, 2))
    section = Polygon([*ring(3.4), *ring(2.6)[::-1]]).area
    assert total == pytest.approx(2.0 * section, rel=1e-4)  # coordinates are rounded


def test_each_direction_of_an_arch_turns_its_own_voussoirs(results):
    drawing = results["arch"].drawing
    back = drawing.displaced_negative
    assert drawing.block_of == drawing.displaced.block_of
    assert len(drawing.blocks) == 9
    assert sorted(set(back.block_of) - {-1}) == [0, 1, 2]
    assert back.block_of == drawing.block_of[::-1]  # a symmetric arch; A' is at the far springing
    for side in (drawing.displaced, back):
        for ring_then, ring_now, owner in zip(drawing.blocks, side.blocks, side.block_of, strict=True):
            assert Polygon(ring_now).area == pytest.approx(Polygon(ring_then).area, rel=1e-9)
            assert (ring_now == ring_then) == (owner == -1)


def test_a_scan_is_simplified_for_the_results_only():
    sphere = trimesh.creation.icosphere(subdivisions=6)
    solid = polyhedron(sphere.vertices, sphere.faces, density=2000.0, name="boulder")
    beside = box(thickness=1.0, length=1.0, height=1.0, base=(0.0, 0.0, -3.0), density=2000.0, name="plinth")
    mechanism = single_block("w", planar_body(beside, direction=(1, 0, 0)))
    seen = view_in_space(mechanism, Scene(((solid,),), (beside,), (), np.array([1.0, 0.0, 0.0])))
    assert seen.given == len(sphere.faces) + 12
    assert len(seen.triangles) <= VIEW_TRIANGLES
    assert mesh(seen, block=0).volume == pytest.approx(sphere.volume, rel=0.02)
    assert mesh(seen, block=-1).volume == pytest.approx(1.0, rel=1e-3)
    assert len(json.dumps([seen.vertices, seen.triangles])) < 200_000


def test_the_edges_of_a_body_of_no_mechanism_are_those_of_its_solid():
    """A slab has twelve, no diagonals, whatever its faces are made of; an ICO sphere of fine faces has none."""
    slab = box(thickness=4.0, length=3.0, height=0.2, base=(1.0, 2.0, 3.0), density=1000.0, name="slab")
    found = edges_in_space(slab)
    lengths = sorted(float(np.ptp(np.array(edge), axis=0).sum()) for edge in found.edges)
    assert (found.name, lengths) == ("slab", pytest.approx([0.2] * 4 + [3.0] * 4 + [4.0] * 4))
    fine = trimesh.creation.box((4.0, 3.0, 0.2)).subdivide().subdivide()
    whole = edges_in_space(polyhedron(fine.vertices, fine.faces, density=1000.0, name="fine"))
    assert sum(float(np.ptp(np.array(edge), axis=0).sum()) for edge in whole.edges) == pytest.approx(28.8)
    sphere = trimesh.creation.icosphere(subdivisions=3)
    assert edges_in_space(polyhedron(sphere.vertices, sphere.faces, density=1.0, name="ball")).edges == ()


def test_what_no_mechanism_moves_stands_beside_them(tmp_path):
    bodies = {"wall": wall(), "slab": wall(0.2, 3.0, 0.3, base=[2.0, 0.0, 4.0])}
    path = tmp_path / "project.toml"
    path.write_text(project_toml(site=None, bodies=bodies, mechanisms={"whole": block()}))
    assert [each.name for each in build(load(path)).beside] == ["slab"]
