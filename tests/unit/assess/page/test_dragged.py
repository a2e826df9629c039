"""Ties, level cracks and cracks by a normal that are dragged on the page; what is wrong with them is said."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")

from assess.page.page import Page
from tests.support.pages import page_of
from tests.support.projects import NTC, block, project_toml, wall
from tests.unit.assess.page.test_page import DRIVER, PATIENCE, awaited, browser, has_camera, on_screen, wait_for

TIE = {"kind": "tie", "at": [0, 0, 3], "anchor": [-2, 0, 3], "force": "10 kN"}
END = ("mechanisms", "tied", "loads", 0)


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Page]:
    """A wall with a tie, one that parts in two, and one whose crack is given by its normal."""
    folder = tmp_path_factory.mktemp("dragged")
    plain = {"direction": [1, 0, 0], "sides": "two"}
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        bodies={"tied": wall(), "parted": wall(base=[2, 0, 0]), "cracked": wall(base=[4, 0, 0])},
        mechanisms={
            "tied": block("tied", loads=[TIE], **plain),
            "parted": block("parted", kind="two-block", crack="2 m", **plain),
            "cracked": block("cracked", cut={"point": [4, 0, 1], "normal": [0.1, 0, 1]}, **plain),
        },
    )
    with page_of(folder, text, patience=PATIENCE) as found:
        yield found


@pytest.fixture
def untried(page) -> Iterator[Page]:
    """The page with nothing tried."""
    yield page
    while page.opened.edited.changes:
        page.opened.edited.undo()


def settle(page: Page) -> None:
    assert page.wait(PATIENCE)


def test_a_tie_has_handles_at_its_ends_and_a_line_between_them(untried):
    untried.pick("tied")
    handles = untried.drawing._ends
    assert {key[-1]: tuple(each.position) for key, each in handles.items()} == {"at": (0, 0, 3), "anchor": (-2, 0, 3)}
    (line,) = untried.drawing._ties
    assert line.points.tolist() == [[[0, 0, 3], [-2, 0, 3]]]
    untried.pick("parted")
    assert not untried.drawing._ends
    assert not untried.drawing._ties


def test_a_tie_that_is_dragged_moves_the_numbers_in_one_step(untried):
    """A level tie of F at a height h: alpha = (W b + F h) / (W h_G), of a wall 0.6 x 3 x 4 m of 1800 kg/m3."""
    untried.pick("tied")
    weight = 1800 * 9.80665 * 0.6 * 3 * 4
    for height in (2.8, 2.4, 2.0):
        untried._dragged_end((*END, "at"), [0.0, 0.0, height], height == 2.0)
        settle(untried)
    untried._dragged_end((*END, "anchor"), [-2.0, 0.0, 2.0], True)
    settle(untried)
    assert untried.opened.edited.changes == (
        {(*END, "at"): [0.0, 0.0, 2.0]},
        {(*END, "anchor"): [-2.0, 0.0, 2.0]},
    )
    result = untried.opened.examine("tied").result
    assert result.oscillator.uplift_multiplier == pytest.approx((weight * 0.3 + 1e4 * 2.0) / (weight * 2.0))


def test_a_tie_in_the_air_is_said(untried):
    untried.pick("tied")
    untried._dragged_end((*END, "at"), [2.0, 0.0, 3.0], True)
    settle(untried)
    assert "is in the air" in untried.facts.content
    untried._dragged_end((*END, "at"), [0.0, 7.0, 3.0], True)
    settle(untried)
    assert "beside the block that it holds" in untried.facts.content


def test_an_anchor_on_what_moves_is_said(untried):
    untried.pick("tied")
    untried._dragged_end((*END, "anchor"), [-0.2, 0.0, 2.0], True)
    settle(untried)
    assert "which moves too" in untried.facts.content


def test_the_crack_of_a_wall_that_parts_goes_up_and_down(untried):
    untried.pick("parted")
    assert untried.elevation.value == 2.0
    assert untried.angle.disabled
    assert not untried.elevation.disabled
    assert untried.drawing._plane.disable_rotations
    untried._dragged((2.0, 0.0, 2.5), 0.0, True)
    settle(untried)
    assert untried.opened.edited.changes == ({("mechanisms", "parted", "crack"): "2.5 m"},)
    (hinge,) = (each.at[1] for each in untried.opened.examine("parted").result.drawing.hinges if each.name == "B")
    assert hinge == pytest.approx(2.5)


def test_a_crack_by_its_normal_is_dragged(untried):
    untried.pick("cracked")
    assert untried.elevation.value == 1.0
    assert untried.angle.value == pytest.approx(np.degrees(np.arctan(0.1)), abs=0.005)  # as the box shows it
    untried._dragged((4.0, 0.0, 1.0), 0.2, True)
    settle(untried)
    (setting,) = untried.opened.edited.changes
    assert setting[("mechanisms", "cracked", "cut")]["normal"] == pytest.approx([np.sin(0.2), 0, np.cos(0.2)], abs=1e-4)


@pytest.mark.skipif(DRIVER is None, reason="needs chromium and chromedriver: .venv/browser of the Makefile")
def test_in_a_browser(untried, tmp_path):
    """The mouse takes the upright arrow of an anchor, and moves the tie that it is of; Play plays."""
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By

    untried.pick("tied")
    with browser(tmp_path) as driver:
        driver.set_window_size(1300, 1000)  # what it says of drawing in software covers a corner
        driver.get(untried.server.address)
        awaited(driver, lambda text: "Verdict" in text)
        wait_for(lambda: has_camera(untried))
        (client,) = untried.server.viser.get_clients().values()
        handle = untried.drawing._ends[*END, "anchor"]
        for reach in (0.5, 0.7, 0.3, 0.6, 0.9):
            rect = "const r = document.querySelector('canvas').getBoundingClientRect()"
            box = driver.execute_script(f"{rect}; return [r.x, r.y, r.width, r.height]")
            x, y, z = handle.position
            start, end = (on_screen(client.camera, box, (x, y, z + reach * handle.scale + up)) for up in (0, 1.0))
            mouse = (driven := ActionChains(driver, duration=300)).w3c_actions.pointer_action
            mouse.move_to_location(*start).pause(0.5).pointer_down().pause(0.3)
            for share in (0.25, 0.5, 0.75, 1.0):
                mouse.move_to_location(*(int(a + share * (b - a)) for a, b in zip(start, end, strict=True))).pause(0.3)
            mouse.release()
            driven.perform()
            if untried.opened.edited.changes:
                break
        wait_for(lambda: bool(untried.opened.edited.changes))
        settle(untried)
        (setting,) = untried.opened.edited.changes
        assert list(setting) == [(*END, "anchor")]
        button = next(each for each in driver.find_elements(By.TAG_NAME, "button") if each.text == "Play")
        driver.execute_script("arguments[0].click()", button)
        awaited(driver, lambda text: "PGA 0.15 g" in text)
        wait_for(lambda: untried.movement.button.label == "Stop")
        untried.movement.rest()
