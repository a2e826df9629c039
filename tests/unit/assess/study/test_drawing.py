"""Mechanisms drawn at rest and displaced, against shapely's rotations and the lengths of the links."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import degrees, dist

import numpy as np
import pytest
from shapely import Point, Polygon
from shapely.affinity import rotate

from assess.geometry.planar import planar_body
from assess.geometry.solid import box
from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain
from assess.mechanisms.four_hinge import FOUR_HINGE
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.single_block import single_block
from assess.oscillator import Branch, Oscillator
from assess.study.drawing import LARGEST_MOVE, draw

WALL = planar_body(
    box(thickness=1.0, length=3.0, height=6.0, base=(2.0, 0.0, 0.5), density=2000.0, name="wall"), direction=(1, 0, 0)
)


def rectangle(left, low, right, high):
    return ((left, low), (right, low), (right, high), (left, high), (left, low))


def portal(loads=()) -> Mechanism:
    """Two piers 1 m thick and a beam over them; hinges at opposite faces."""
    rings = [rectangle(0, 0, 1, 5), rectangle(0, 5, 6, 6), rectangle(5, 0, 6, 5)]
    blocks = tuple(
        RigidBlock(2000.0 * Polygon(ring).area, tuple(Polygon(ring).centroid.coords[0]), 5000.0) for ring in rings
    )
    hinges = ((1.0, 0.0), (0.0, 5.0), (5.0, 5.0), (6.0, 0.0))
    back = tuple((6.0 - x, z) for x, z in (hinges[3], hinges[2], hinges[1], hinges[0]))
    negative = mirror_chain(blocks, back, loads)
    return Mechanism(
        "portal", "", "four-hinge", "two", Chain(blocks, hinges, loads), negative, (0.8, 0.8), (), 0.0,
        tuple((ring,) for ring in rings), FOUR_HINGE.impacts,
    )  # fmt: skip


def rocker(overturning: float) -> Oscillator:
    """What a drawing needs of an oscillator: where it overturns."""
    flat = np.linspace(0.0, 1.0, 5)
    branch = Branch(flat, flat, flat, flat, flat, flat, restitution=0.8, overturning=overturning, critical=overturning)
    return Oscillator(branch, branch, 1.0)


def drawn(mechanism):
    return draw(mechanism, rocker(0.3))


def test_a_single_block_is_turned_about_its_hinges():
    picture = drawn(single_block("w", WALL))
    for displaced, sense in ((picture.displaced, -1.0), (picture.displaced_negative, 1.0)):
        about = displaced.hinges[0].at
        turned = rotate(Polygon(picture.blocks[0]), sense * degrees(displaced.rotation_rad), origin=about)
        assert np.array(displaced.blocks[0]) == pytest.approx(np.array(turned.exterior.coords), abs=1e-12)
    assert picture.displaced.hinges[0].at == pytest.approx((2.5, 0.5))
    assert picture.displaced_negative.hinges[0].at == pytest.approx((1.5, 0.5))


def test_it_is_turned_far_enough_to_be_seen_and_no_farther_than_overturning():
    slender = planar_body(
        box(thickness=0.2, length=1.0, height=6.0, base=(0, 0, 0), density=1.0, name="w"), direction=(1, 0, 0)
    )
    for body, reaches in ((WALL, False), (slender, True)):
        mechanism = single_block("w", body)
        rocker = mechanism.oscillator
        displaced = draw(mechanism, rocker).displaced
        moved = max(dist(a, b) for a, b in zip(body.outline[0], displaced.blocks[0], strict=True))
        assert displaced.rotation_rad <= rocker.positive.overturning
        assert moved <= LARGEST_MOVE * 6.0
        assert (displaced.rotation_rad > 0.9 * rocker.positive.overturning) == reaches
        assert reaches or moved > 0.8 * LARGEST_MOVE * 6.0
        assert float(f"{displaced.rotation_rad:.2g}") == displaced.rotation_rad


def test_the_links_of_a_portal_keep_their_lengths_and_its_feet_their_places():
    picture = drawn(portal())
    rest = [hinge.at for hinge in picture.hinges]
    for place, displaced in enumerate((picture.displaced, picture.displaced_negative)):
        links = rest[4 * place : 4 * place + 4]
        moved = [hinge.at for hinge in displaced.hinges]
        assert moved[0] == pytest.approx(links[0], abs=1e-12)
        assert moved[3] == pytest.approx(links[3], abs=1e-12)
        for (a, b), (c, d) in zip(pairwise(links), pairwise(moved), strict=True):
            assert dist(a, b) == pytest.approx(dist(c, d), rel=1e-12)
        assert dist(links[1], moved[1]) > 0.3
    assert [hinge.name for hinge in picture.hinges] == ["A", "B", "C", "D", "A'", "B'", "C'", "D'"]
    assert picture.block_of == (0, 1, 2)


def test_the_weights_of_a_drawing_are_those_of_its_blocks():
    assert drawn(single_block("w", WALL)).masses_kg == pytest.approx((1.0 * 3.0 * 6.0 * 2000.0,), rel=1e-12)
    assert drawn(replace(single_block("w", WALL), kind="equivalent-block")).masses_kg == ()  # a unit mass


def test_the_blocks_of_a_portal_stay_joined_and_whole():
    displaced = drawn(portal()).displaced
    for number, ring in enumerate(displaced.blocks):
        for hinge in displaced.hinges[number : number + 2]:
            assert Polygon(ring).exterior.distance(Point(hinge.at)) == pytest.approx(0.0, abs=1e-12)
        assert Polygon(ring).area == pytest.approx((5.0, 6.0, 5.0)[number], rel=1e-12)
        assert displaced.centroids[number] == pytest.approx(Polygon(ring).centroid.coords[0], abs=1e-12)


def test_a_symmetric_portal_displaced_back_is_its_mirror_image():
    picture = drawn(portal())
    there, back = (Polygon(side.blocks[1]) for side in (picture.displaced, picture.displaced_negative))
    mirrored = Polygon([(6.0 - x, z) for x, z in there.exterior.coords])
    assert mirrored.symmetric_difference(back).area == pytest.approx(0.0, abs=1e-9)


def test_loads_move_with_their_blocks_and_point_where_they_act():
    loads = (
        PointMass("floor", 500.0, (3.0, 6.0), True, block=1),
        PointMass("wall beside", 500.0, (0.0, 3.0), False, block=0),
        Force("thrust", (300.0, -400.0), (3.0, 6.0), block=1),
        Tie("rod", 200.0, (3.0, 6.0), anchor=(3.0, 2.0), block=1),
    )
    picture = drawn(portal(loads))
    assert [load.kind for load in picture.loads] == ["mass", "mass", "force", "tie"]
    assert [load.towards for load in picture.loads] == [(0.0, -1.0), None, (0.6, -0.8), (0.0, -1.0)]
    floor, _, thrust, rod = picture.displaced.loads
    assert floor.at == thrust.at == rod.at
    assert thrust.towards == (0.6, -0.8)
    assert rod.towards == pytest.approx(np.array([3.0 - rod.at[0], 2.0 - rod.at[1]]) / dist(rod.at, (3.0, 2.0)))
    assert picture.displaced_negative.loads[2].towards == pytest.approx((0.6, -0.8))
    top = np.mean([picture.displaced.blocks[1][2], picture.displaced.blocks[1][3]], axis=0)
    assert floor.at == pytest.approx(top, abs=1e-12)
