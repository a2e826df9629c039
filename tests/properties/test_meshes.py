"""What must hold for the oscillator of any mesh: it depends on the body, not on how the mesh stands or is divided."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
import pytest
from scipy.constants import g
from scipy.spatial.transform import Rotation

from assess.geometry.cut import divide, level_plane
from assess.geometry.planar import PlanarBody, join_planar, planar_body
from assess.geometry.repair import repair
from assess.geometry.solid import Solid, box, polyhedron, profile
from assess.geometry.surface import merge_vertices
from assess.mechanisms.single_block import single_block
from assess.oscillator import Branch, Oscillator
from tests.support.solids import convex_hull, refine_mesh

DENSITY = 2100.0
X = (1.0, 0.0, 0.0)


ARCHED = [
    [-2.0, 0.0],
    [-0.8, 0.0],
    [-0.8, 1.5],
    [0.0, 2.3],
    [0.8, 1.5],
    [0.8, 0.0],
    [2.0, 0.0],
    [2.0, 4.5],
    [-2.0, 5.0],
]
POINTS = np.random.default_rng(3).normal(size=(60, 3)) * [0.8, 1.5, 3.0] + [0.0, 0.0, 4.0]
FOOT = np.array([[-0.9, -1.0, 0.0], [0.8, -1.2, 0.0], [1.1, 1.0, 0.0], [-0.7, 1.3, 0.0]])
"""Of a convex body without symmetry, which stands on a level face."""
BODIES = {
    "wall": box(thickness=0.6, length=4.0, height=4.5, base=(0.0, 0.0, 0.0), density=DENSITY, name="wall"),
    "leaning pier": profile([[-0.5, 0], [0.5, 0], [0.7, 3], [0.1, 3]], length=1.0, density=DENSITY, name="pier"),
    "pierced wall": profile(ARCHED, length=0.6, density=DENSITY, name="pierced"),
    "boulder": convex_hull(np.vstack([POINTS[POINTS[:, 2] > 0.5], FOOT]), density=DENSITY, name="boulder"),
}
EVERY = pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)


def rocking(*bodies: Solid, direction: tuple[float, float, float] = X) -> Oscillator:
    """The bodies as one block on the ground."""
    seen = [planar_body(each, direction=direction) for each in bodies]
    return single_block("m", seen[0] if len(seen) == 1 else join_planar(seen, name="block")).oscillator


def loose(solid: Solid) -> tuple[np.ndarray, np.ndarray]:
    """Triangles that share no corner."""
    return solid.vertices[solid.triangles].reshape(-1, 3), np.arange(solid.triangles.size).reshape(-1, 3)


def meshed(vertices: np.ndarray, triangles: np.ndarray) -> Solid:
    """A body by the way of a mesh file."""
    surface, told = repair(merge_vertices(vertices, triangles), where="mesh")
    assert told == ()
    return polyhedron(*surface, density=DENSITY, name="mesh")


def alike(found: Oscillator, wanted: Oscillator, *, rtol: float = 1e-9) -> None:
    """Every column of both branches."""
    assert found.mass == pytest.approx(wanted.mass, rel=rtol)
    for one, other in ((found.positive, wanted.positive), (found.negative, wanted.negative)):
        assert isinstance(one, Branch)
        assert isinstance(other, Branch)
        assert one.overturning_flexible == other.overturning_flexible  # rigid: None
        for name, column in ((each.name, getattr(other, each.name)) for each in fields(other)):
            if name == "overturning_flexible":
                continue
            size = float(np.max(np.abs(column)))
            np.testing.assert_allclose(getattr(one, name), column, rtol=0.0, atol=rtol * size, err_msg=name)


@EVERY
def test_a_finer_mesh_changes_nothing(body: Solid) -> None:
    alike(rocking(meshed(*loose(refine_mesh(body, 3)))), rocking(body))


@EVERY
@pytest.mark.parametrize("angle", [0.3, 1.1, 2.0, -2.7])
def test_a_mesh_turned_with_its_direction_and_moved_changes_nothing(body: Solid, angle: float) -> None:
    turn = Rotation.from_euler("z", angle).as_matrix()
    there = meshed(body.vertices @ turn.T + [35.0, -20.0, 12.0], body.triangles)
    alike(rocking(there, direction=tuple((turn @ X).tolist())), rocking(body))


@EVERY
@pytest.mark.parametrize("s", [0.25, 3.0])
def test_lengths_times_s_divide_p_squared_by_s_and_leave_lambda(body: Solid, s: float) -> None:
    small, large = rocking(body), rocking(meshed(body.vertices * s, body.triangles))
    for one, other in ((large.positive, small.positive), (large.negative, small.negative)):
        assert one is not None
        assert other is not None
        np.testing.assert_allclose(one.rotation, other.rotation, rtol=0.0, atol=1e-9)
        ours, theirs = (each.restoring / (g * each.excitation) for each in (one, other))  # lambda at every node
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=1e-9 * float(np.max(np.abs(theirs))))
        squares = one.restoring / one.inertia * s, other.restoring / other.inertia
        np.testing.assert_allclose(squares[0], squares[1], rtol=0.0, atol=1e-9 * float(np.max(np.abs(squares[1]))))


@EVERY
def test_a_block_split_into_welded_bodies_changes_nothing(body: Solid) -> None:
    """Cut at a level by manifold3d; the parts joined again."""
    parts = divide([body], level_plane(0.4 * float(body.vertices[:, 2].max())), where="split")
    alike(rocking(*parts.below, *parts.above), rocking(body))


def test_a_mesh_of_twenty_thousand_triangles_rocks_as_its_body() -> None:
    """The whole way from triangles to the oscillator; a million are in the benchmarks."""
    vertices, triangles = loose(refine_mesh(BODIES["boulder"], 5))
    assert len(triangles) > 20_000
    found = rocking(meshed(vertices, triangles))
    alike(found, rocking(BODIES["boulder"]))


def test_planar_bodies_know_their_outline() -> None:
    """The mesh's outline is that of the body, whatever its triangles."""
    body = BODIES["boulder"]
    coarse, fine = (planar_body(each, direction=X) for each in (body, meshed(*loose(refine_mesh(body, 2)))))
    assert isinstance(coarse, PlanarBody)
    assert len(coarse.outline) == len(fine.outline) == 1
    np.testing.assert_allclose(fine.outline[0], coarse.outline[0], rtol=0.0, atol=1e-9)
