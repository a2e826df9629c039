"""Mechanisms found on a church made of sizes of Mehrotra 2019, chapter 5: façade, apse, corners, belfry, spire."""

import numpy as np
import pytest

import assess
from assess.examples import copy_example
from assess.geometry.boolean import subtract
from assess.geometry.solid import polyhedron
from assess.project.build import build
from assess.project.drawn_project import write_project
from assess.project.project_file import load
from tests.support.houses import Planted, bent_wall, extrude, prism, turned, write_groups, write_merged


def church(spire):
    """Return its bodies; the spire's tip is at 22.25 m, the bell cell stands on two walls of 0.454 by 2.13 m."""
    apse = bent_wall(4.6, 0.8, height=6.0)
    east = np.column_stack([apse.vertices[:, 1] + 15.6, -apse.vertices[:, 0], apse.vertices[:, 2]])

    def shaft(base, height):
        inside = prism((19.0, -11.0, 21.0, -9.0), base - 1.0, height + 2.0)
        return subtract(prism((18.5, -11.5, 21.5, -8.5), base, height), [inside])

    return {
        "front": extrude([(-5, 0), (5, 0), (5, 9.7), (0, 11.0), (-5, 9.7)], 0, 0.6, 0),
        "north": prism((0.6, 4.1, 15.6, 5.0), 0, 5.4),
        "south": prism((0.6, -5.0, 15.6, -4.1), 0, 5.4),
        "apse": polyhedron(east, apse.triangles, density=1.0, name="apse"),
        "tower": shaft(0, 13.0),
        "left": prism((18.5, -11.5, 18.954, -8.5), 13.0, 2.13),
        "right": prism((21.046, -11.5, 21.5, -8.5), 13.0, 2.13),
        "upper": shaft(15.13, 3.12),
        "spire": polyhedron(spire.vertices + np.array([20.0, -10.0, 0.0]), spire.triangles, density=1.0, name="spire"),
    }


@pytest.mark.parametrize("write", [write_groups, write_merged])
def test_each_part_of_a_church_has_its_mechanism(tmp_path, write) -> None:
    copy_example("san_leonardo_spire", tmp_path / "spire")
    spire = assess.read_building(tmp_path / "spire" / "spire.ply").parts[0].solid
    parts = turned([Planted(name, "", 0.0, solid) for name, solid in church(spire).items()], angle=0.3)
    structure = assess.read_building(write(tmp_path / "church.obj", parts))
    assert not structure.left_out
    found = structure.mechanisms()
    assert not found.without
    entries = {each.examines.get("church") for each in found}
    assert {"facade", "facade-top", "apse", "nave-transverse", "bell-tower", "bell-cell", "projections"} <= entries
    weakest = {row.kind: row for row in reversed(found.ranked)}
    assert weakest["belfry"].multiplier == pytest.approx(0.454 / 2.13, rel=1e-6)  # of piers under what both carry
    assert weakest["spire"].multiplier == pytest.approx(0.233, abs=0.005)  # Table 5.1, 75 degrees: 0.23
    assert weakest["apse"].multiplier < 0.25  # Table 5.2, of another apse: 0.16 from the base at 75 degrees
    assert weakest["spire"].found.evaluations <= 60
    (walls,) = {each.parts for each in found if each.examines.get("church") == "facade" and each.kind == "overturning"}
    assert structure.part(walls[0]).eaves == pytest.approx(9.7)
    corners = [each for each in found if each.kind == "corner"]
    assert any(each.examines.get("church") == "bell-cell" for each in corners)
    assert not any(each.kind == "gable" and each.multiplier > 1.0 for each in found)  # an apse has none


def test_no_mechanism_is_weaker_in_another_direction_than_the_one_proposed(tmp_path) -> None:
    """The directions of `assess check` are those of the search: an apse falls askew, where a face of it looks."""
    copy_example("san_leonardo_spire", tmp_path / "spire")
    spire = assess.read_building(tmp_path / "spire" / "spire.ply").parts[0].solid
    parts = [Planted(name, "", 0.0, solid) for name, solid in church(spire).items()]
    _, candidates = write_project([write_groups(tmp_path / "church.obj", parts)], tmp_path / "new")
    study = build(load(tmp_path / "new"))
    assert {"apse-apse", "spire-spire", "tower-tower"} <= {each.name for each in study.mechanisms}
    assert not [each.name for each in study.mechanisms if each.weaker is not None]
    assert not [each for each in study.messages if each.key == "direction-weaker"]
    (apse,) = (each for each in candidates if each.kind == "apse")
    assert all(each.multiplier >= apse.multiplier for each in apse.found.others)
