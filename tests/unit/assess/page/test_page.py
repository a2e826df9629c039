"""The page as a browser gets it: what is picked, dragged and typed, and names that look like a program."""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from math import radians

import numpy as np
import pytest

pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")

from assess.page import words
from assess.page.page import Page
from assess.page.scene import angle_of, quaternion
from assess.study.curves import CAPACITY, ENVELOPE, PGA
from tests.support.pages import by_hand, page_of
from tests.support.projects import NTC, block, project_toml, wall

PATIENCE = 60.0  # s
HOSTILE = "<img src=x onerror='window.ran=1'>[a](javascript:window.ran=1)"
DRIVER = shutil.which("chromedriver")


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Page]:
    """Two walls, one that is cut and one named as no wall is."""
    folder = tmp_path_factory.mktemp("page")
    mechanism = block(cut="1 m", direction=[1, 0, 0], sides="two", label=HOSTILE)
    text = project_toml(
        title=HOSTILE,
        site={"spectrum": NTC | {"a_g": "0.45 g"}, "limit_state": "SLV"},
        bodies={HOSTILE: wall(), "thick": wall(1.0, base=[5, 0, 0])},
        mechanisms={
            "thin": mechanism | {"blocks": [HOSTILE]},
            "thick": block("thick", direction=[1, 0, 0], sides="two"),
        },
    )
    with page_of(folder, text, patience=PATIENCE) as found:
        yield found


@pytest.fixture
def at_rest(page) -> Iterator[Page]:
    """The page with the wall that is cut, and nothing tried."""
    page.pick("thin")
    yield page
    page.fault.content = ""
    page._last_moved = (None, 0.0)
    while page.opened.edited.changes:
        page.opened.edited.undo()
    page.start()
    assert page.wait(PATIENCE)
    page.pick("thin")


def test_mechanisms_are_listed_with_multiplier_and_outcome(at_rest):
    first, second, *_ = at_rest.mechanisms.options
    assert first.startswith(f"M1 {HOSTILE} · 0.2000 · fail · zeta_E 0.")
    assert second.startswith("M2 thick · 0.2500 · ")
    assert "<b>FAIL</b>" in at_rest.building.content


def test_picking_one_shows_its_numbers_and_each_method(at_rest):
    by_hand(at_rest.mechanisms, at_rest.mechanisms.options[1])
    assert at_rest.picked == "thick"
    assert ">0.2500<" in at_rest.facts.content
    for method in at_rest.opened.methods:
        assert method in at_rest.facts.content


def test_what_was_found_is_shown_beside_those_of_the_file(at_rest):
    found = [text for text in at_rest.mechanisms.options if text.startswith("+ ")]
    assert len(found) == len(at_rest.opened.proposed) > 0
    by_hand(at_rest.mechanisms, found[0])
    assert at_rest.picked is at_rest.opened.proposed[0]
    assert "moves" in at_rest.facts.content
    assert at_rest.elevation.disabled


def test_a_crack_that_is_dragged_moves_the_numbers(at_rest):
    """As the handle of a browser tells it: a wall 0.6 m thick and 2 m high above its crack has 0.6 / 2."""
    drag(at_rest, (0.0, 0.0, 2.0), 0.0)
    assert ">0.3000<" in at_rest.facts.content
    assert "1 value tried, not written" in at_rest.building.content
    assert (at_rest.elevation.value, at_rest.angle.value) == (2.0, 0.0)
    drag(at_rest, (0.0, 0.0, 2.0), radians(20.0))
    assert at_rest.angle.value == pytest.approx(20.0)
    tilted = {("mechanisms", "thin", "cut"): {"point": [0, 0, 2], "angle": "20.00 deg"}}
    assert at_rest.opened.edited.changes == ({("mechanisms", "thin", "cut"): "2 m"}, tilted)


def drag(page: Page, point: tuple[float, float, float], angle: float) -> None:
    page._dragged(point, angle, False)
    page._dragged(point, angle, True)
    assert page.wait(PATIENCE)


def test_a_crack_that_misses_is_said_and_the_next_one_shown(at_rest):
    drag(at_rest, (0.0, 0.0, 9.0), 0.0)
    assert "misses the body" in at_rest.fault.content
    assert "misses the body" in at_rest.facts.content
    assert "NOT KNOWN" in at_rest.building.content
    assert "misses the body" in at_rest.building.content
    assert not any(word in at_rest.building.content for word in ("FAIL", "PASS", "as in the file"))
    assert "finding" not in at_rest.status.content
    drag(at_rest, (0.0, 0.0, 2.0), 0.0)
    assert ">0.3000<" in at_rest.facts.content
    assert "ready" in at_rest.status.content
    assert not at_rest.fault.content


def test_a_crack_that_is_typed_is_that_dragged(at_rest):
    by_hand(at_rest.elevation, 2.0)
    assert at_rest.wait(PATIENCE)
    assert ">0.3000<" in at_rest.facts.content
    assert at_rest.drawing._plane.position[2] == 2.0


def test_a_value_that_slides_moves_the_numbers(at_rest):
    (slider,) = (each for each in at_rest._of_numbers if "thickness" in each.label and each.value == 0.6)
    by_hand(slider, 0.75)
    assert at_rest.wait(PATIENCE)
    assert ">0.2500<" in at_rest.facts.content


def test_what_is_typed_in_a_box_is_taken_to_the_last_digit(at_rest):
    """As a browser has it: the box lets decimals be typed, and has no ends at which it would change them."""
    (box,) = (each for each in at_rest._of_numbers if each.label.startswith("materials.brick.density"))
    assert (box.min, box.max) == (None, None)
    assert box.precision >= 4
    for typed in (1, 1.5, 16250.7):
        by_hand(box, typed)
    assert at_rest.opened.edited.changes == ({("materials", "brick", "density"): "16250.7 kg/m^3"},)
    by_hand(at_rest.angle, 85.0)
    assert "85 deg was not tried; give -80 to 80" in at_rest.fault.content
    assert len(at_rest.opened.edited.changes) == 1


def test_each_drag_and_each_value_is_a_step_of_undo(at_rest):
    """What is slid or typed on within a moment is one."""
    for elevation in (2.0, 2.5):
        drag(at_rest, (0.0, 0.0, elevation), 0.0)
    by_hand(at_rest.elevation, 2.2)
    by_hand(at_rest.elevation, 2.25)
    assert [each["mechanisms", "thin", "cut"] for each in at_rest.opened.edited.changes] == ["2 m", "2.5 m", "2.25 m"]
    assert at_rest.wait(PATIENCE)
    assert "1 value tried, not written" in at_rest.building.content
    assert not at_rest.undo.disabled
    assert not at_rest.write.disabled


def test_the_angle_alone_leaves_the_elevation(at_rest):
    at_rest.opened.move_cut("thin", (0.1234, 0.0, 1.23456), 0.2)
    by_hand(at_rest.angle, 30.0)
    assert at_rest.opened.edited.changes[-1]["mechanisms", "thin", "cut"] == {
        "point": [0.1234, 0.0, 1.2346], "angle": "30.00 deg",
    }  # fmt: skip


def test_nothing_to_undo_or_write_is_no_button(at_rest):
    assert at_rest.undo.disabled
    assert at_rest.write.disabled


def test_a_refusal_stays_until_something_else_is_done(at_rest):
    path = at_rest.opened.edited.project.path
    before = path.read_bytes()
    drag(at_rest, (0.0, 0.0, 2.0), 0.0)
    path.write_bytes(before + b"# by another")
    at_rest._change_file(at_rest.opened.write, None)
    assert at_rest.wait(PATIENCE)
    assert "press “Read again”" in at_rest.fault.content
    path.write_bytes(before)
    by_hand(at_rest.elevation, 2.1)
    assert at_rest.wait(PATIENCE)
    assert not at_rest.fault.content


def test_the_weakest_crack_is_found_and_tried(at_rest):
    at_rest._find_weakest()
    assert "weakest crack: multiplier" in at_rest.status.content
    assert at_rest.opened.edited.changes
    assert not at_rest.opened.examine("thin").as_typed


def test_a_crack_that_is_weaker_and_holds_more_says_so():
    assert "1.10 x the action in place of 0.900 x: the crack of least multiplier is not" in words.rise(0.9, 1.1)
    assert words.rise(1.1, 0.9) == words.rise(None, 1.0) == ""


def test_writing_keeps_what_is_picked(at_rest):
    path = at_rest.opened.edited.project.path
    before = path.read_bytes()
    at_rest._is_picked_by_hand = False
    at_rest.pick("thick")
    at_rest.opened.edited.change({("materials", "brick", "density"): "1900 kg/m^3"})
    at_rest._change_file(at_rest.opened.write, None)
    assert at_rest.wait(PATIENCE)
    assert at_rest.picked == "thick"
    at_rest._change_file(at_rest.opened.edited.undo, None)
    assert at_rest.wait(PATIENCE)
    assert path.read_bytes() == before


@pytest.mark.parametrize("title", [CAPACITY, PGA, ENVELOPE])
def test_each_curve_is_drawn(at_rest, title):
    by_hand(at_rest.shown_curve, title)
    assert at_rest.wait(PATIENCE)
    across, along = at_rest.curve.data
    assert across.size > 5
    assert np.isfinite(along).sum() > 5
    by_hand(at_rest.shown_curve, CAPACITY)


def test_the_building_states_what_it_is_of(at_rest):
    said = at_rest.building.content
    assert "as in the file" in said
    assert "Possible, not examined: not stated" in said
    assert "found on the bodies and not in the file" in said
    drag(at_rest, (0.0, 0.0, 2.0), 0.0)
    assert "with what is tried: 1 value tried" in at_rest.building.content
    assert "As a run decides" in at_rest.facts.content


def test_undo_puts_the_crack_back(at_rest):
    drag(at_rest, (0.0, 0.0, 2.0), 0.0)
    at_rest._change_file(at_rest.opened.edited.undo, None)
    assert ">0.2000<" in at_rest.facts.content
    assert at_rest.elevation.value == 1.0
    assert "taken back" in at_rest.status.content


def test_names_of_users_are_texts(at_rest):
    """Nothing that the page writes as HTML has a name in it that is not escaped; nothing is Markdown."""
    handles = at_rest.server.viser.gui._gui_input_handle_from_uuid
    assert handles
    for content in (at_rest.status.content, at_rest.facts.content, at_rest.building.content, words.status(HOSTILE)):
        assert "<img" not in content
    kinds = {
        type(each).__name__ for each in at_rest.server.viser._websock_server._broadcast_buffer.message_from_id.values()
    }
    assert "GuiMarkdownMessage" not in kinds


def test_front_matter_that_is_typed_keeps_what_is_decided(at_rest):
    known = at_rest.opened.decision
    for text in ("A. R", "A. Rossi"):
        by_hand(at_rest.front["author"], text)
    by_hand(at_rest.front["date"], "2026-05-04")
    assert at_rest.wait(PATIENCE)
    assert not at_rest.fault.content
    assert at_rest.opened.is_decided
    assert at_rest.opened.decision is known
    assert at_rest.opened.edited.tried_project().content.report.author == "A. Rossi"
    assert len(at_rest.opened.edited.changes) == 2


@pytest.mark.parametrize("along", [(1.0, 0.0), (0.0, -1.0), (-0.6, 0.8)])
@pytest.mark.parametrize("angle", [-1.0, -0.2, 0.0, 0.3, 1.2])
def test_a_plane_falls_towards_the_direction_by_its_angle(along, angle):
    """By the matrix of the rotation: a point along the turned x axis lies below the first by the sine of the angle."""
    direction = np.array([*along, 0.0])
    w, x, y, z = quaternion(direction, angle)
    first = np.array([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)])
    assert first @ direction == pytest.approx(np.cos(angle))
    assert first[2] == pytest.approx(-np.sin(angle))
    assert angle_of(np.array([w, x, y, z]), direction) == pytest.approx(angle)
    assert angle_of(-np.array([w, x, y, z]), direction) == pytest.approx(angle)


@pytest.mark.skipif(DRIVER is None, reason="needs chromium and chromedriver: .venv/browser of the Makefile")
def test_in_a_browser(at_rest, tmp_path):
    """It is shown, picked from and typed into; it asks no other host, and no name in it runs."""
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

    with browser(tmp_path) as driver:
        driver.get(at_rest.server.address)
        shown = awaited(driver, lambda text: "Verdict: FAIL" in text and HOSTILE in text)
        assert "ntc2018-nonlinear" in shown
        assert driver.execute_script("return window.ran") is None
        assert "token" not in driver.current_url
        lists = "return [...document.querySelectorAll('input[aria-haspopup=listbox]')]"
        listed = f"{lists}.find((each) => each.value.includes(arguments[0]))"
        wait_for(lambda: driver.execute_script(listed, HOSTILE) is not None)
        pick = driver.execute_script(listed, HOSTILE)
        options = "return [...document.querySelectorAll('[role=option]')].filter((o) => o.checkVisibility()).length"
        pick.send_keys(Keys.ARROW_DOWN)
        wait_for(lambda: driver.execute_script(options) > 1)
        chosen = "return document.querySelector('[role=option][data-combobox-selected]')?.textContent ?? ''"
        while "M2 thick" not in driver.execute_script(chosen):
            pick.send_keys(Keys.ARROW_DOWN)
        pick.send_keys(Keys.ENTER)
        wait_for(lambda: at_rest.picked == "thick")
        awaited(driver, lambda text: "0.2500" in text)
        at_rest.pick("thin")
        awaited(driver, lambda text: "Verdict: FAIL" in text)
        label = next(each for each in driver.find_elements(By.TAG_NAME, "label") if each.text == "Elevation [m]")
        field = driver.find_element(By.ID, label.get_attribute("for"))
        field.send_keys(Keys.CONTROL, "a")
        field.send_keys("2", Keys.ENTER)
        wait_for(lambda: bool(at_rest.opened.edited.changes))
        awaited(driver, lambda text: "value tried, not written" in text)
        assert at_rest.wait(PATIENCE)
        assert ">0.3000<" in at_rest.facts.content
        logs = [json.loads(each["message"])["message"] for each in driver.get_log("performance")]
        asked = {each["params"]["request"]["url"] for each in logs if each["method"] == "Network.requestWillBeSent"}
        sockets = {each["params"]["url"] for each in logs if each["method"] == "Network.webSocketCreated"}
        own = (f"http://127.0.0.1:{at_rest.server.port}/", "data:", "blob:", "chrome:")
        assert [
            url for url in asked | sockets if not url.startswith((*own, f"ws://127.0.0.1:{at_rest.server.port}"))
        ] == []


@pytest.mark.skipif(DRIVER is None, reason="needs chromium and chromedriver: .venv/browser of the Makefile")
def test_the_handle_of_the_crack_is_dragged_in_a_browser(at_rest, tmp_path, monkeypatch):
    """With the mouse: viser had releases whose handle said nothing."""
    from selenium.webdriver.common.action_chains import ActionChains

    told, dragged = [], at_rest.drawing._moved
    monkeypatch.setattr(at_rest.drawing, "_moved", lambda *moved: (told.append(moved), dragged(*moved)))
    with browser(tmp_path) as driver:
        driver.get(at_rest.server.address)
        awaited(driver, lambda text: "Verdict: FAIL" in text)
        wait_for(lambda: has_camera(at_rest))
        (client,) = at_rest.server.viser.get_clients().values()
        handle = at_rest.drawing._plane
        for reach in (0.5, 0.7, 0.3, 0.6, 0.9):  # of its size: an arrow or a ring lies there, as the camera has it
            rect = "const r = document.querySelector('canvas').getBoundingClientRect()"
            box = driver.execute_script(f"{rect}; return [r.x, r.y, r.width, r.height]")
            x, y, z = handle.position
            ends = [on_screen(client.camera, box, (x, y, z + reach * handle.scale + up)) for up in (0, 0.7)]
            driven = ActionChains(driver, duration=300)
            mouse = driven.w3c_actions.pointer_action
            mouse.move_to_location(*ends[0]).pause(0.5).pointer_down().pause(0.3)
            for share in (0.25, 0.5, 0.75, 1.0):
                mouse.move_to_location(*(int(a + share * (b - a)) for a, b in zip(*ends, strict=True))).pause(0.3)
            mouse.release()
            driven.perform()
            if told:
                break
        wait_for(lambda: bool(told) and told[-1][2])
        assert not told[0][2]
        assert at_rest.wait(PATIENCE)
        (setting,) = at_rest.opened.edited.changes
        assert list(setting) == [("mechanisms", "thin", "cut")]
        awaited(driver, lambda text: "1 value tried, not written" in text)


def has_camera(page: Page) -> bool:
    """Return whether a browser has said from where it looks."""
    clients = page.server.viser.get_clients().values()
    return bool(clients) and all(each.camera._state.update_timestamp > 0.0 for each in clients)


def on_screen(camera, box, place) -> tuple[int, int]:
    """Return where a place lies on the screen [px], by the pinhole of the camera: x to the right, y down, z ahead."""
    w, x, y, z = camera.wxyz
    turned = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    right, down, ahead = turned.T @ (np.asarray(place) - camera.position)
    focal = box[3] / 2 / np.tan(camera.fov / 2)
    return int(box[0] + box[2] / 2 + focal * right / ahead), int(box[1] + box[3] / 2 + focal * down / ahead)


@contextmanager
def browser(folder):
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    drawn = (
        "headless=new",
        "use-gl=angle",
        "use-angle=swiftshader",
        "enable-unsafe-swiftshader",
        "window-size=700,500",
    )
    alone = ("no-first-run", "disable-background-networking", "disable-component-update", "disable-sync")
    root = ("no-sandbox",) if os.geteuid() == 0 else ()
    for each in (*drawn, *alone, *root, f"user-data-dir={folder / 'profile'}"):
        options.add_argument(f"--{each}")
    options.set_capability("goog:loggingPrefs", {"performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(DRIVER))
    try:
        yield driver
    finally:
        driver.quit()


def awaited(driver, seen) -> str:
    """Wait until the page's text is as it should be, and return it."""
    found = ""

    def is_seen() -> bool:
        nonlocal found
        script = "return document.body.innerText + [...document.querySelectorAll('input')].map((i) => i.value).join()"
        found = driver.execute_script(script)
        return seen(found)

    wait_for(is_seen, lambda: found)
    return found


def wait_for(condition, told=lambda: "") -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, told()
        time.sleep(0.2)


def test_a_mechanism_is_struck_out_with_a_reason_alone(at_rest):
    """What it fails by no longer counts, and the verdict depends on the reason."""
    at_rest.pick("thin")
    at_rest._strike_out()
    assert "no reason" in at_rest.fault.content
    at_rest.reason.value = "measured: <b>taken down</b>"
    at_rest._strike_out()
    assert at_rest.wait(PATIENCE)
    assert at_rest.fault.content == ""
    assert "struck out: measured: &lt;b&gt;taken down" in at_rest.facts.content
    assert "<b>taken down" not in at_rest.building.content
    assert "thin (struck out)" in at_rest.building.content
    assert at_rest.opened.heading("thick") == "M1 thick"
    assert at_rest.opened.heading("thin").endswith("(struck out)")
    assert any(each.startswith("M1 thick") for each in at_rest.mechanisms.options)
