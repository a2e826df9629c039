"""The bodies of a mechanism as a model to be turned."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assess.results import Results, View
from reports.figures.projection import viewing_frame
from reports.figures.sketch import model_of_view
from reports.figures.style import NEGATIVE, POSITIVE


@pytest.fixture
def view(results: Results) -> View:
    found = results.mechanisms[0].view
    assert found is not None
    return found


def test_every_face_is_kept_in_the_colour_of_its_block(view: View) -> None:
    model = model_of_view(view, positive=1)
    np.testing.assert_allclose(model.vertices, view.vertices, rtol=0, atol=5.1e-5)
    assert sorted(face for part in model.parts for face in part.triangles) == sorted(view.triangles)
    assert len({part.colour for part in model.parts}) == len(set(view.block_of)) == 2


@pytest.mark.parametrize("angle", [0.0, 1.0, 3.5])
def test_it_is_first_seen_as_the_figure_shows_it(view: View, angle: float) -> None:
    along = (float(np.cos(angle)), float(np.sin(angle)), 0.0)
    azimuth, elevation = model_of_view(replace(view, direction=along), positive=1).eye
    eye = [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    np.testing.assert_allclose(viewing_frame(np.array(along))[2], eye, rtol=0, atol=1e-12)


def test_axes_are_drawn_beyond_the_bodies_in_the_colours_of_their_branches(view: View) -> None:
    model = model_of_view(view, positive=1)
    named = {wire.name: wire for wire in model.wires if wire.name}
    assert (named["A"].colour, named["A"].dashed) == (POSITIVE, False)
    assert (named["A′"].colour, named["A′"].dashed) == (NEGATIVE, True)
    (start, end), axis = np.array(named["A"].points), np.array(view.axes[0].ends)
    np.testing.assert_allclose(np.cross(end - start, axis[1] - axis[0]), 0.0, rtol=0, atol=1e-3)
    assert np.linalg.norm(end - start) > np.linalg.norm(axis[1] - axis[0])
    assert [wire.arrow for wire in model.wires].count(True) == 1
    np.testing.assert_allclose(model.wires[0].points, view.sections[0], rtol=0, atol=5.1e-5)
