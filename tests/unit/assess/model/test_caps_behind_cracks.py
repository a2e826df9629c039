"""What stands on the walls of a corner, or behind a façade, falls with the wedge, or is listed."""

from itertools import product
from math import cos, sin

import numpy as np
import pytest

from assess.geometry.solid import Solid, polyhedron
from assess.model.candidates import Candidates, find_candidates
from assess.model.structure import Structure
from tests.support.buildings import STONE, block, part_of, touching
from tests.support.houses import extrude

FRONT = part_of("Front", block((0, 8), (0, 0.5), (0, 5)), normal=(0, -1), outward=True)
SIDE = part_of("Side", block((0, 0.5), (0.5, 6.5), (0, 5)), normal=(-1, 0), outward=True)
CELL = 0.0125  # m


def gable(low: float, high: float, rise: float) -> Solid:
    """Return a gable over the side wall, between two y [m]."""
    drawn = extrude([(low, 0.0), (high, 0.0), ((low + high) / 2.0, rise)], 0.0, 0.5, 5.0)
    return polyhedron(drawn.vertices, drawn.triangles, density=STONE, name="gable")


GABLE = part_of("Gable", gable(0.5, 6.5, 2.5), "gable", normal=(-1, 0), outward=True)
PARAPET = part_of("Parapet", block((0, 0.3), (0.5, 6.5), (5, 6)), "parapet", normal=(-1, 0), outward=True)
CHIMNEY = part_of("Chimney", block((0, 0.5), (0.6, 1.2), (5, 6.5)), "chimney", normal=(-1, 0))


LOW = part_of("Low front", block((0, 1), (-1, 0.5), (0, 3)), normal=(0, -1), outward=True)
"""Of 1.5 m by 3 m it turns alone at 0.5; what rises high behind it makes it weaker."""


def found_on(*caps, front=FRONT) -> Candidates:
    parts = (front, SIDE, *caps)
    return find_candidates(Structure(parts=parts, contacts=touching(parts)))


def cells(low: float, high: float, z: tuple[float, float]) -> np.ndarray:
    """Return middles of cells over the side wall, (y, z) [m]."""
    sides = [np.arange(a + CELL / 2.0, b, CELL) for a, b in ((low, high), z)]
    return np.array(list(product(*sides)))


def side_of(at: np.ndarray, cap: str) -> np.ndarray:
    """Return the thickness of the side wall and what stands on it, at places (y, z) [m]."""
    y, z = at.T
    if cap == "Gable":
        return np.where(z < 5.0, 0.5, np.where(z - 5.0 < 2.5 * (1.0 - abs(y - 3.5) / 3.0), 0.5, 0.0))
    return np.where(z < 5.0, 0.5, 0.3)


@pytest.mark.parametrize(("cap", "top"), [(GABLE, 7.5), (PARAPET, 6.0)], ids=["gable", "parapet"])
def test_a_facade_takes_along_what_stands_on_the_wedge_of_its_side_wall(cap, top) -> None:
    """The crack goes on through it: sums over cells of 12.5 mm in front of the plane."""
    (one,) = (each for each in found_on(cap, front=LOW) if each.kind == "wedges")
    assert one.definition.wedges[0].walls == ("Side", cap.name)
    angle, foot = one.definition.wedges[0].angle, one.found.parameters["hinge"].value
    at = cells(0.5, 6.5, (foot, top))
    behind = (at[:, 0] - 0.5) * cos(angle) - (at[:, 1] - foot) * sin(angle)
    volume = np.where(behind < 0.0, side_of(at, cap.name), 0.0) * CELL**2
    front = 1.0 * 1.5 * 3.0
    held = front * 0.75 + float(volume @ (at[:, 0] + 1.0))
    driven = front * 1.5 + float(volume @ at[:, 1])
    assert one.multiplier == pytest.approx(held / driven, rel=2e-3)
    (bare,) = (each for each in found_on(front=LOW) if each.kind == "wedges")
    assert abs(one.multiplier / bare.multiplier - 1.0) > 3e-3  # what it weighs shows


def corner_of(found: Candidates):
    (one,) = (each for each in found if each.kind == "corner")
    return one


@pytest.mark.parametrize(("cap", "top"), [(GABLE, 7.5), (PARAPET, 6.0)], ids=["gable", "parapet"])
def test_a_corner_takes_along_what_stands_on_its_walls(cap, top) -> None:
    """By cells: the column, the wedge of the front, the wedge of the side with what stands on it."""
    one = corner_of(found_on(cap))
    assert set(one.definition.bodies) == {"Front", "Side", cap.name}
    wedge = {each.walls[0]: each.angle for each in one.definition.wedges}
    foot, way = one.found.parameters["hinge"].value, np.array(one.found.direction)[:2]
    at = cells(0.5, 6.5, (foot, top))
    behind = (at[:, 0] - 0.5) * cos(wedge["Side"]) - (at[:, 1] - foot) * sin(wedge["Side"])
    volume = np.where(behind < 0.0, side_of(at, cap.name), 0.0) * CELL**2
    x = np.where((at[:, 1] > 5.0) & (cap.name == "Parapet"), 0.15, 0.25)
    parts = [(volume, x, at[:, 0], at[:, 1])]
    front = cells(0.5, 8.0, (foot, 5.0))
    ahead = (front[:, 0] - 0.5) * cos(wedge["Front"]) < (front[:, 1] - foot) * sin(wedge["Front"])
    parts.append((ahead * 0.5 * CELL**2, front[:, 0], np.full(len(front), 0.25), front[:, 1]))
    parts.append((np.array([0.25 * (5.0 - foot)]), np.array([0.25]), np.array([0.25]), np.array([(5.0 + foot) / 2.0])))
    held = sum(float(v @ (-(x * way[0] + y * way[1]))) for v, x, y, _ in parts)
    driven = sum(float(v @ (z - foot)) for v, _, _, z in parts)
    assert one.multiplier == pytest.approx(held / driven, rel=3e-3)
    assert one.multiplier != pytest.approx(corner_of(found_on()).multiplier, rel=0.01)


@pytest.mark.parametrize("kind", ["corner", "wedges"])
def test_a_chimney_there_is_listed(kind) -> None:
    """It falls as a whole or stays, which neither search decides."""
    found = found_on(CHIMNEY)
    assert any(gap.kind == kind and "Chimney" in str(gap) for gap in found.gaps)
    assert not any("Chimney" in str(gap) for gap in found_on(PARAPET).gaps)
