"""Which entry of the list of churches a mechanism answers: by the place of its wall, open where not plain."""

from dataclasses import replace

import numpy as np
import pytest

from assess.geometry.boolean import subtract
from assess.geometry.solid import profile
from assess.model.candidates import Candidates, find_candidates
from assess.model.moving_parts import bends
from assess.model.structure import Part, Structure
from tests.support.buildings import STONE, block, part_of, touching
from tests.support.houses import bent_wall, prism

NAVE = (0.0, 20.0)  # m: along x, 10 m wide about y = 0


def end_wall(name: str, x: float, way: float, *, gabled: bool = True) -> Part:
    """Return an end wall of the nave, 0.6 m thick and 6 m high, with a gable of 2.5 m where it has one."""
    top = [(0.0, 8.5)] if gabled else []
    solid = profile([(-5.0, 0.0), (5.0, 0.0), (5.0, 6.0), *top, (-5.0, 6.0)], length=0.6, density=STONE, name=name)
    moved = solid.vertices[:, [1, 0, 2]] * (-1, 1, 1) + (x, 0.0, 0.0)
    centroid = np.array([x, 0.0, solid.centroid[2]])
    inertia = solid.inertia[np.ix_([1, 0, 2], [1, 0, 2])]
    placed = replace(solid, vertices=moved, centroid=centroid, inertia=inertia)
    return part_of(name, placed, normal=(way, 0.0), outward=True, eaves=6.0 if gabled else None)


def side_walls() -> tuple[Part, ...]:
    return tuple(
        part_of(name, block((0.3, 19.7), (y, y + 0.8), (0, 6)), normal=(0, way), outward=True)
        for name, y, way in (("North", 4.2, 1), ("South", -5.0, -1))
    )


def apse() -> Part:
    """Return a half ring east of the nave, its convex side towards +x."""
    solid = bent_wall(4.0, 0.8, height=5.0)
    vertices = solid.vertices[:, [1, 0, 2]] * (1, -1, 1) + (20.3, 0.0, 0.0)
    at = solid.centroid[[1, 0, 2]] * (1, -1, 1) + (20.3, 0.0, 0.0)
    moved = replace(solid, vertices=vertices, centroid=at, inertia=solid.inertia[np.ix_([1, 0, 2], [1, 0, 2])])
    return part_of("Apse", moved, normal=(1, 0), outward=True)


def arch(name: str, x: float, y: float, *, across: bool, radius: float = 3.0) -> Part:
    """Return a half ring over (x, y), which spans across the nave or along it."""
    turn = np.linspace(0.0, np.pi, 17)
    ring = [
        (r * float(np.cos(t)), r * float(np.sin(t)))
        for r, ts in ((radius + 0.5, turn), (radius, turn[::-1]))
        for t in ts
    ]
    solid = profile(ring, length=0.8, density=STONE, name=name)
    order, sign = ([1, 0, 2], (-1, 1, 1)) if across else ([0, 1, 2], (1, 1, 1))
    moved = replace(
        solid, vertices=solid.vertices[:, order] * sign + (x, y, 0.0),
        centroid=solid.centroid[order] * sign + (x, y, 0.0), inertia=solid.inertia[np.ix_(order, order)],
    )  # fmt: skip
    return part_of(name, moved, "arch", normal=(1, 0) if across else (0, 1))


def found_on(*parts: Part) -> Candidates:
    return find_candidates(Structure(parts=parts, contacts=touching(parts)))


def entries(found: Candidates, part: str) -> set[str | None]:
    return {each.examines.get("church") for each in found if each.parts[0] == part}


def test_the_facade_is_the_end_wall_opposite_the_apse() -> None:
    """A gabled rear wall over the apse, and the end of a transept, are no façades."""
    transept = part_of("Transept", block((12, 16), (9.4, 10), (0, 6)), normal=(0, 1), outward=True, eaves=5.0)
    found = found_on(end_wall("Front", 0, -1), end_wall("Rear", 20, 1), *side_walls(), apse(), transept)
    assert {"facade", "facade-top"} <= entries(found, "Front")
    assert not {"facade", "facade-top", "apse"} & entries(found, "Rear")
    assert "apse" in entries(found, "Apse")
    assert "transept-end" in entries(found, "Transept")
    assert "nave-transverse" in entries(found, "North")


def test_without_an_apse_both_ends_have_to_have_the_mechanism() -> None:
    """Of two gabled ends one may be the façade: the entry stays open as long as one of them is not examined."""
    prop = part_of("Annex", block((20.3, 26), (-3, -2), (0, 6)), normal=(0, 1))
    free = found_on(end_wall("Front", 0, -1), end_wall("Rear", 20, 1), *side_walls(), arch("Arch", 10, 0, across=True))
    assert "facade" in entries(free, "Front") & entries(free, "Rear")
    stated = {each.name for each in free if each.definition is not None}
    assert "facade" not in free.open_entries("church", stated=stated)
    rear = {each.name for each in free if each.parts[0] == "Rear"}
    assert "facade" in free.open_entries("church", stated=stated - rear)
    held = found_on(
        end_wall("Front", 0, -1), end_wall("Rear", 20, 1), *side_walls(), arch("A", 10, 0, across=True), prop
    )
    opened = held.open_entries("church", stated={each.name for each in held if each.definition is not None})
    assert {gap.kind for gap in opened["facade"].gaps} == {"overturning", "wedges"}
    assert all("Annex would stop it" in str(gap) for gap in opened["facade"].gaps)


def test_a_level_end_may_be_the_facade_of_a_gabled_church() -> None:
    found = found_on(
        end_wall("Front", 0, -1), end_wall("Rear", 20, 1, gabled=False), *side_walls(), arch("Arch", 10, 0, across=True)
    )
    assert "facade" in entries(found, "Rear")
    opened = found.open_entries("church", stated={each.name for each in found if each.definition is not None})
    assert [str(gap) for gap in opened["facade-top"].gaps] == [
        "Rear: overturning of a gable: it may be the façade, and nothing is found that turns above its foot"
    ]


@pytest.mark.parametrize(("across", "x", "answers"), [(True, 19.0, True), (False, 10.0, False)])
def test_only_the_arch_before_the_apse_is_the_triumphal_arch(across: bool, x: float, answers: bool) -> None:
    found = found_on(end_wall("Front", 0, -1), *side_walls(), apse(), arch("Arch", x, 0.0, across=across))
    assert ("triumphal-arch" in entries(found, "Arch")) == answers
    gaps = [gap for gap in found.gaps if gap.examines.get("church") == "triumphal-arch"]
    assert len(gaps) == (0 if answers else 1)
    aside = found_on(end_wall("Front", 0, -1), *side_walls(), apse(), arch("Door", 19.0, 9.0, across=True, radius=1.0))
    assert "triumphal-arch" not in entries(aside, "Door")


@pytest.mark.parametrize(("x", "answers"), [(-4.0, True), (8.0, False)])
def test_a_portal_is_a_porch_in_front_of_the_facade_alone(x: float, answers: bool) -> None:
    piers = [part_of(f"Pier {y}", block((x, x + 0.6), (y, y + 0.8), (0, 3)), "pier") for y in (-2.0, 1.2)]
    lintel = part_of("Lintel", block((x, x + 0.6), (-2.0, 2.0), (3, 3.5)), "spandrel")
    found = found_on(end_wall("Front", 0, -1), *side_walls(), apse(), *piers, lintel)
    (portal,) = [each for each in found if each.kind == "portal"]
    assert (portal.examines.get("church") == "porch") == answers


def test_a_wall_with_buttresses_does_not_bend() -> None:
    """It has 1.2 times the volume of its panel, and no oblique face; half a ring has little else."""
    recesses = [prism((-1.0, low, 0.0, high), -1.0, 8.0) for low, high in ((0.8, 4.6), (5.4, 9.2))]
    solid = subtract(prism((-0.5, 0.0, 0.6, 10.0), 0.0, 6.0), recesses)
    assert solid is not None
    assert not bends(part_of("Wall", solid, normal=(1, 0), outward=True))
    assert bends(apse())


def test_a_bell_cell_on_four_piers_and_the_corners_of_a_shaft_are_listed() -> None:
    tower = part_of("Tower", block((0, 4), (0, 4), (0, 14)), "tower")
    piers = [
        part_of(f"Pier {x} {y}", block((x, x + 0.8), (y, y + 0.8), (14, 17)), "pier")
        for x in (0.0, 3.2)
        for y in (0.0, 3.2)
    ]
    found = found_on(tower, *piers)
    opened = found.open_entries("church", stated={each.name for each in found if each.definition is not None})
    assert "4 piers stand on it" in str(opened["bell-cell"].gaps[0])
    assert "the corners of its shaft are not looked for" in str(opened["bell-tower"].gaps[0])
