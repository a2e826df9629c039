"""A mechanism displaced, and rocking in true time as the page plays the record that governs."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
import pytest

pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")

from assess.page.page import Page
from tests.support.motions import write_record
from tests.support.pages import by_hand, page_of
from tests.support.projects import NTC, block, project_toml

PATIENCE = 60.0  # s


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Page]:
    """A wall under a record of 3 s that lets it rock."""
    folder = tmp_path_factory.mktemp("movement")
    at = np.arange(0.0, 3.0, 0.01)
    write_record(folder / "sway.csv", at, 6.0 * np.sin(2.0 * np.pi * at))
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        mechanisms={"thin": block(cut="1 m", direction=[1, 0, 0], sides="two")},
        records={"files": ["sway.csv"], "scale_to": "none"},
    )
    with page_of(folder, text, patience=PATIENCE) as found:
        yield found


@pytest.fixture
def at_rest(page) -> Iterator[Page]:
    """The page at rest, with nothing tried."""
    page.pick("thin")
    yield page
    page.movement.rest()
    while page.opened.edited.changes:
        page.opened.edited.undo()
    page.pick("thin")


def test_a_mechanism_is_displaced_as_its_drawing_is(at_rest):
    """By the corner of the drawing after its rotation, in the plane of motion."""
    by_hand(at_rest.movement.position, "displaced")
    (frame,) = at_rest.drawing._frames.values()
    drawing = at_rest.opened.outline("thin").result.drawing
    assert frame.wxyz[0] == pytest.approx(np.cos(drawing.displaced.rotation_rad / 2.0))
    for (x, z), (to_x, to_z) in zip(drawing.blocks[0], drawing.displaced.blocks[0], strict=True):
        turn = np.cos(drawing.displaced.rotation_rad), np.sin(drawing.displaced.rotation_rad)
        moved = frame.position + np.array([turn[0] * x + turn[1] * z, 0.0, turn[0] * z - turn[1] * x])
        assert moved == pytest.approx([to_x, 0.0, to_z], abs=1e-9)
    by_hand(at_rest.movement.drawn, "x 5")
    assert frame.wxyz[0] == pytest.approx(np.cos(5.0 * drawing.displaced.rotation_rad / 2.0))
    by_hand(at_rest.movement.drawn, "as it is")
    by_hand(at_rest.movement.position, "at rest")
    assert frame.wxyz.tolist() == [1.0, 0.0, 0.0, 0.0]
    assert frame.position.tolist() == [0.0, 0.0, 0.0]


def test_the_record_that_governs_plays_in_true_time(at_rest, monkeypatch):
    """Rotations at moments of the clock, and how it ends; no mesh is sent again."""
    motion = at_rest.opened.motion("thin")
    shown = []
    monkeypatch.setattr(at_rest.drawing, "place_blocks", lambda places: shown.append((time.monotonic(), places)))
    sent = at_rest.server.viser._websock_server._broadcast_buffer.message_from_id
    meshes = {key for key, each in sent.items() if "Mesh" in type(each).__name__}
    begun = time.monotonic()
    by_hand(at_rest.movement.position, "rocking")
    assert at_rest.movement.button.label == "Stop"
    at_rest.movement.wait(PATIENCE)
    assert motion.duration <= time.monotonic() - begun
    assert len(shown) > 5  # frames, of which a machine at work draws few
    first, last = shown[0][0], shown[-1][0]
    assert last - first == pytest.approx(motion.duration, abs=2.0)
    turned = [
        2.0 * np.arctan2(places[0].quaternion[2], places[0].quaternion[0]) if places else 0.0 for _, places in shown
    ]
    assert 0.0 < max(np.abs(turned)) <= max(np.abs(motion.trace.rotation_rad)) + 1e-9
    assert motion.history.record in at_rest.movement.said.content
    assert f"{motion.ending} {motion.duration:.1f} s" in at_rest.movement.said.content
    assert at_rest.movement.button.label == "Play"
    assert meshes == {key for key, each in sent.items() if "Mesh" in type(each).__name__}


def test_what_plays_ends_where_something_else_is_tried(at_rest):
    at_rest.movement.play()
    at_rest.opened.move_cut("thin", (0.0, 0.0, 2.0), 0.0)
    at_rest._ask(True)
    assert at_rest.wait(PATIENCE)
    assert at_rest.movement.position.value == "at rest"
    assert at_rest.movement.button.label == "Play"
