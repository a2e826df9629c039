"""The page in a real browser: Debian's chromium, without a window and without a network."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions import interaction
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.actions.pointer_input import PointerInput
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.common.print_page_options import PrintOptions
from selenium.webdriver.remote.webelement import WebElement
from selenium.webdriver.support.select import Select

from assess.portfolio.tasks import ProjectRow as Project
from reports.document import (
    NOTHING,
    Banner,
    BulletList,
    ColouredFaces,
    Column,
    Document,
    Facts,
    Figure,
    FigureRow,
    FileLines,
    OutcomeCell,
    Prose,
    Section,
    Signatures,
    SpatialModel,
    Table,
    Wire,
    WritingBox,
)
from reports.language.texts import Verbatim
from reports.portfolio import write_ranking
from tests.support.sample_document import HOSTILE, box, draw_sample, sample_document, write_page

DRIVER = shutil.which("chromedriver")
pytestmark = pytest.mark.skipif(DRIVER is None, reason="needs chromium and chromedriver: .venv/browser of the Makefile")

ALONE = (
    "headless",
    "disable-gpu",
    "disable-quic",
    "no-first-run",
    "disable-background-networking",
    "disable-component-update",
    "disable-sync",
    "window-size=1280,900",
)
SCRIPT = "const s = document.createElement('script'); s.text = 'window.ran = 1'; document.body.append(s)"
REDS = (
    "const c = document.querySelector('canvas'); let found = 0;"
    "const all = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
    "for (let k = 0; k < all.length; k += 4) if (all[k] > 200 && all[k + 1] < 60) found++;"
    "return found"
)
"""How many pixels of the canvas are red."""
RED, BLUE = (255, 0, 0), (0, 0, 255)
PHONE, DESK = 390, 1400  # width of the window [px]


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[webdriver.Chrome]:
    options = webdriver.ChromeOptions()
    root = ("no-sandbox",) if os.geteuid() == 0 else ()
    for option in (*ALONE, *root, f"user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(f"--{option}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(DRIVER))
    yield driver
    driver.quit()


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_page(sample_document(), tmp_path_factory.mktemp("html") / "report.html")


@contextmanager
def resized(driver: webdriver.Chrome, width: int) -> Iterator[None]:
    """The window at this width, that of a phone as one that is touched."""
    size = {"width": width, "height": 844, "deviceScaleFactor": 1, "mobile": width == PHONE}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    try:
        yield
    finally:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def laid_out(driver: webdriver.Chrome) -> None:
    """Have every section laid out, also those out of sight."""
    driver.execute_script(
        "document.querySelectorAll('main section').forEach((each) => (each.style.contentVisibility = 'visible'))"
    )
    two_frames(driver)


def two_frames(driver: webdriver.Chrome) -> None:
    driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")


@pytest.fixture(scope="module")
def ranked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a portfolio of more rows than are laid out at once: 300 fail, then 700 pass, then 200 are broken."""
    rows = [Project(f"{n}", "", "", "done", outcome="fail", margin=0.001 * (n + 1)) for n in range(300)]
    rows += [Project(f"{n}", "Mill Lane", "", "done", outcome="pass", margin=0.01 * n) for n in range(300, 1000)]
    rows += [Project(f"{n}", "", "", "broken", reason="no thickness") for n in range(1000, 1200)]
    return write_ranking(rows, tmp_path_factory.mktemp("ranked"))[2]


def seen_rows(driver: webdriver.Chrome) -> list[str]:
    """The projects of the rows in sight, from above."""
    script = "return [...document.querySelectorAll('tbody tr')].filter((row) => row.checkVisibility()).map((row) => row"
    return list(driver.execute_script(f"{script}.cells[1].textContent)"))


def test_ranked_rows_are_found_by_outcome_and_words(browser: webdriver.Chrome, ranked: Path) -> None:
    browser.get(ranked.as_uri())
    search, select, count = (first(browser, f".sifting {name}") for name in ("[type=search]", "select", "output"))
    assert [option.text for option in select.find_elements(By.TAG_NAME, "option")] == [
        "all",
        "fail (300)",
        "pass (700)",
        "broken (200)",
    ]
    assert len(seen_rows(browser)) == 1000
    assert count.text == "1200 / 1200"
    first(browser, ".sifting [type=checkbox]").click()
    assert len(seen_rows(browser)) == 1200
    Select(select).select_by_value("broken")
    assert (count.text, len(seen_rows(browser))) == ("200 / 1200", 200)
    Select(select).select_by_value("")
    search.send_keys("MILL 357")
    assert (count.text, seen_rows(browser)) == ("2 / 1200", ["356", "357"])  # the first by its rank


def test_ranked_rows_are_sorted_among_those_found(browser: webdriver.Chrome, ranked: Path) -> None:
    browser.get(ranked.as_uri())
    assert seen_rows(browser)[:2] == ["0", "1"]
    heads = browser.find_elements(By.CSS_SELECTOR, "th button")
    margin = next(head for head in heads if head.text.startswith("Margin"))
    margin.click()
    margin.click()
    assert seen_rows(browser)[:2] == ["999", "998"]
    assert first(browser, "th[aria-sort]").get_dom_attribute("aria-sort") == "descending"
    Select(first(browser, ".sifting select")).select_by_value("fail")
    assert seen_rows(browser)[:2] == ["299", "298"]
    assert all(entry["level"] != "SEVERE" for entry in browser.get_log("browser"))


@pytest.fixture
def opened(browser: webdriver.Chrome, page: Path) -> webdriver.Chrome:
    browser.get(page.as_uri())
    return browser


def first(driver: webdriver.Chrome, selector: str) -> WebElement:
    return driver.find_element(By.CSS_SELECTOR, selector)


def painted(driver: webdriver.Chrome) -> str:
    """The pixels of the canvas, once the browser has drawn what it was asked to."""
    two_frames(driver)
    return str(driver.execute_script("return document.querySelector('canvas').toDataURL()"))


def seen_box(driver: webdriver.Chrome) -> list[float]:
    """The viewBox of the figure in the viewer."""
    return [float(side) for side in (first(driver, ".stage svg").get_dom_attribute("viewBox") or "").split()]


def turning(driver: webdriver.Chrome) -> WebElement:
    buttons = driver.find_elements(By.CSS_SELECTOR, "figure:has(script) .tools button")
    buttons[1].click()
    return first(driver, ".stage")


def test_no_error_and_no_request(browser: webdriver.Chrome, page: Path) -> None:
    for log in ("browser", "performance"):
        browser.get_log(log)
    browser.get(page.as_uri())
    turning(browser)
    painted(browser)
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    sent = {each["params"]["request"]["url"] for each in events if each["method"] == "Network.requestWillBeSent"}
    own = ("data:", "chrome:")  # the page's empty icon, and the browser's first page
    assert {url for url in sent if not url.startswith(own)} == {page.as_uri()}
    assert browser.get_log("browser") == []


def test_the_policy_refuses_what_is_not_of_the_page(opened: webdriver.Chrome) -> None:
    opened.get_log("browser")
    opened.execute_script("document.body.append(Object.assign(new Image(), {src: 'file:///x.png'}))")
    opened.execute_script(SCRIPT)
    assert opened.execute_script("return window.ran") is None
    assert sum("Content Security Policy" in entry["message"] for entry in opened.get_log("browser")) >= 2


def test_a_figure_enlarges_on_click_and_zooms_about_the_pointer(opened: webdriver.Chrome) -> None:
    small = first(opened, "figure .picture svg").size["width"]
    first(opened, "figure .picture").click()
    stage = first(opened, ".stage")
    assert first(opened, "dialog").get_attribute("open") is not None
    assert first(opened, ".stage svg").size["width"] > 1.1 * small
    before = seen_box(opened)
    ActionChains(opened).scroll_from_origin(ScrollOrigin.from_element(stage), 0, -200).perform()
    after = seen_box(opened)
    assert after[2] < 0.9 * before[2]
    middle = [[box[k] + box[k + 2] / 2 for k in (0, 1)] for box in (before, after)]
    np.testing.assert_allclose(*middle, rtol=0, atol=0.01 * before[2])
    ActionChains(opened).drag_and_drop_by_offset(stage, 50, 0).perform()
    assert seen_box(opened)[0] < after[0]
    assert seen_box(opened)[2] == pytest.approx(after[2])
    ActionChains(opened).double_click(stage).perform()
    assert seen_box(opened) == before


def test_a_figure_obeys_the_keyboard(opened: webdriver.Chrome) -> None:
    first(opened, "figure .tools button").send_keys(Keys.ENTER)
    before = seen_box(opened)
    stage = opened.switch_to.active_element
    stage.send_keys("+", Keys.ARROW_RIGHT)
    assert seen_box(opened)[2] < before[2]
    stage.send_keys("0")
    assert seen_box(opened) == before
    stage.send_keys(Keys.ESCAPE)
    assert first(opened, "dialog").get_attribute("open") is None


def test_bodies_turn_on_drag_keys_and_touch(opened: webdriver.Chrome) -> None:
    stage = turning(opened)
    start = painted(opened)
    ActionChains(opened).drag_and_drop_by_offset(stage, 120, 40).perform()
    dragged = painted(opened)
    assert dragged != start
    stage.send_keys(Keys.ARROW_LEFT)
    keyed = painted(opened)
    assert keyed not in (start, dragged)
    drag(opened, stage, (0, 70))
    touched = painted(opened)
    assert touched not in (start, dragged, keyed)
    drag(opened, stage, (-30, -90), (30, 90))
    assert painted(opened) not in (start, dragged, keyed, touched)
    first(opened, "[data-action='0']").click()
    assert painted(opened) == start


def drag(driver: webdriver.Chrome, element: WebElement, *ways: tuple[int, int]) -> None:
    """Fingers on an element, each from a place beside its middle to another [px]."""
    actions = ActionBuilder(driver, mouse=PointerInput(interaction.POINTER_TOUCH, "0"))
    for number in range(1, len(ways)):
        actions.add_pointer_input(interaction.POINTER_TOUCH, str(number))
    for finger, (start, end) in zip(actions.pointer_inputs, ways, strict=True):
        finger.create_pointer_move(origin=element, x=start, y=0)
        finger.create_pointer_down(button=0)
        finger.create_pointer_move(origin=element, x=end, y=0, duration=50)
        finger.create_pointer_up(0)
    actions.perform()


def shown(model: SpatialModel, folder: Path) -> Path:
    """A page of one figure with this model."""
    figure = Figure("f", NOTHING, partial(draw_sample, "f"), model)
    document = Document(NOTHING, NOTHING, "", "p", "A4", (), (Section(Verbatim("s"), 0, (figure,)),))
    return write_page(document, folder / "page.html")


def test_what_is_nearer_hides_what_is_behind_and_is_lit_as_it_faces(browser: webdriver.Chrome, tmp_path: Path) -> None:
    """A small red box before a large blue one, in the order that a painter would get wrong; then seen from behind."""
    near, red = box((1.0, -1.0, -1.0), (2.0, 1.0, 1.0))
    far, blue = box((-2.0, -3.0, -3.0), (0.0, 3.0, 3.0))
    behind = tuple((a + 8, b + 8, c + 8) for a, b, c in blue)
    parts = (ColouredFaces("#ff0000", red), ColouredFaces("#0000ff", behind))
    model = SpatialModel(
        (*near, *far), parts, (Wire(((0, 0, 0), (0, 0, 5)), "#000000", "A"),), "#6f6350", 0.6, (0.0, 0.0)
    )
    browser.get(shown(model, tmp_path).as_uri())
    turning(browser)
    painted(browser)
    light = 0.55 / np.linalg.norm([0.35, 0.75, 0.55])  # the face looks to the eye
    bright = 0.62 + 0.38 * light
    assert pixel(browser, 0.0, -0.15) == pytest.approx([round(part * bright) for part in RED], abs=1)
    assert pixel(browser, 0.2, -0.2) == pytest.approx([round(part * bright) for part in BLUE], abs=1)
    stage = first(browser, ".stage")
    for _ in range(10):  # 10 x 40 px x 0.008 rad: about pi
        stage.send_keys(Keys.ARROW_LEFT)
    painted(browser)
    assert pixel(browser, 0.1, -0.1)[0] == 0


def pixel(driver: webdriver.Chrome, right: float, up: float) -> list[int]:
    """Red, green and blue at a place off the middle of the canvas, in shares of its shorter side."""
    return list(
        driver.execute_script(
            "const c = document.querySelector('canvas'), s = Math.min(c.width, c.height), [x, y] = arguments;"
            "const at = [c.width / 2 + s * x, c.height / 2 - s * y];"
            "return [...c.getContext('2d').getImageData(...at, 1, 1).data].slice(0, 3)",
            right,
            up,
        )
    )


def test_names_of_wires_are_drawn_apart_at_their_ends(browser: webdriver.Chrome, tmp_path: Path) -> None:
    """Two red names at one place make about twice the red of one: the second is lowered, not drawn over the first."""
    corners, faces = box((0.0, -1.0, 0.0), (1.0, 1.0, 1.0))
    counts = []
    for number, names in enumerate((("M1",), ("M1", "M8"))):
        wires = tuple(Wire(((2.0, 0.0, 1.0), (2.0, 0.0, 1.01)), "#ff0000", name) for name in names)
        model = SpatialModel(corners, (ColouredFaces("#dddddd", faces),), wires, "#6f6350", 0.6, (0.0, 0.0))
        (tmp_path / str(number)).mkdir()
        browser.get(shown(model, tmp_path / str(number)).as_uri())
        turning(browser)
        painted(browser)
        counts.append(int(browser.execute_script(REDS)))
    assert counts[0] > 30
    assert counts[1] > 1.5 * counts[0]


@pytest.mark.parametrize("width", [PHONE, DESK])
def test_hostile_text_is_text(browser: webdriver.Chrome, page: Path, width: int) -> None:
    with resized(browser, width):
        browser.get_log("browser")
        browser.get(page.as_uri())
        turning(browser)
        painted(browser)
        text = str(browser.execute_script("return document.body.textContent"))
        written = HOSTILE.replace("\u202e", "⟨U+202E⟩").replace("\x07", "⟨U+0007⟩")
        for tag in ("title", "client", "reference", "headline", "basis", "point", "mechanism", "listed", "name"):
            assert f"{written} {tag}#" in text
        for tag in ("caption-row-1", "photograph", "table", "head", "cell", "graded", "engineer", "sheet", "running"):
            assert f"{written} {tag}#" in text
        assert (
            browser.find_elements(By.CSS_SELECTOR, "main td b, main p b, main dd b, main li b, main :not(b) > i") == []
        )
        scripts = browser.execute_script("return [...document.scripts].map((each) => each.type)")
        assert set(scripts) == {"application/json", "module"}
        assert browser.get_log("browser") == []


def wide(driver: webdriver.Chrome) -> int:
    """How far the page is wider than the window [px]."""
    return int(driver.execute_script("const e = document.documentElement; return e.scrollWidth - e.clientWidth"))


@pytest.mark.parametrize("width", [PHONE, DESK])
def test_the_page_is_no_wider_than_the_window(browser: webdriver.Chrome, page: Path, width: int) -> None:
    with resized(browser, width):
        browser.get(page.as_uri())
        assert browser.execute_script("return innerWidth") == width
        laid_out(browser)
        assert wide(browser) <= 0
        turning(browser)
        assert wide(browser) <= 0
        buttons = browser.find_elements(By.CSS_SELECTOR, "dialog button")
        assert all(button.rect["x"] + button.rect["width"] <= width for button in buttons)


@pytest.mark.parametrize("width", [PHONE, DESK])
def test_a_word_without_end_does_not_widen_the_page(browser: webdriver.Chrome, tmp_path: Path, width: int) -> None:
    word = Verbatim("x" * 3_000)
    table = Table("t", word, (Column(word), Column(word)), ((word, OutcomeCell("fail", word)),))
    figure = Figure("f", word, partial(draw_sample, "f"))
    blocks = (
        Banner("fail", word),
        Facts(((word, word),)),
        Prose((word,)),
        BulletList((word,)),
        table,
        FigureRow((figure, figure)),
    )
    more = (FileLines((word.text,)), WritingBox(word), Signatures(((word, word),)))
    section = Section(word, 0, (*blocks, *more), mark="1")
    document = Document(word, word, "", "p", "A4", ((word, word),), (section, section), running=(word,))
    with resized(browser, width):
        browser.get(write_page(document, tmp_path / "page.html").as_uri())
        laid_out(browser)
        assert wide(browser) <= 0


@pytest.mark.parametrize("width", [PHONE, DESK])
def test_the_verdict_comes_before_the_contents(browser: webdriver.Chrome, page: Path, width: int) -> None:
    """In the order of reading at any width; folded below it on a phone, open beside it where there is room."""
    with resized(browser, width):
        browser.get(page.as_uri())
        follows = "return document.querySelector('.banner').compareDocumentPosition(document.querySelector('nav'))"
        assert browser.execute_script(follows) == 4  # Node.DOCUMENT_POSITION_FOLLOWING
        banner, contents = first(browser, ".banner").rect, first(browser, "nav").rect
        link = first(browser, "nav a")
        assert link.is_displayed() is (width == DESK)
        if width == PHONE:
            assert contents["y"] > banner["y"] + banner["height"]
            first(browser, "summary").click()
            assert link.is_displayed()
            link.click()
            assert not link.is_displayed()
        else:
            assert contents["x"] + contents["width"] < banner["x"]


@pytest.mark.parametrize("width", [PHONE, DESK])
def test_a_table_says_that_it_scrolls_exactly_while_there_is_more_to_see(
    browser: webdriver.Chrome, page: Path, width: int
) -> None:
    with resized(browser, width):
        browser.get(page.as_uri())
        laid_out(browser)
        said = []
        for region in browser.find_elements(By.CSS_SELECTOR, ".wide"):
            hint = browser.execute_script("return arguments[0].previousElementSibling", region)
            wider = browser.execute_script("return arguments[0].scrollWidth > arguments[0].clientWidth", region)
            assert hint.is_displayed() is wider
            assert ("Scroll sideways" in (region.get_attribute("aria-label") or "")) is wider
            assert (region.get_attribute("tabindex") == "0") is wider
            said.append(wider)
            if wider:
                browser.execute_script("arguments[0].scrollLeft = 1e6", region)
                two_frames(browser)
                assert not hint.is_displayed()
        assert True in said
        assert False in said


def test_the_hint_is_there_when_the_table_comes_into_sight(browser: webdriver.Chrome, page: Path) -> None:
    """Sections out of sight are not laid out, so how wide their tables are is not known before."""
    with resized(browser, PHONE):
        browser.get(page.as_uri())
        sheet = first(browser, ".sheet")
        browser.execute_script("arguments[0].scrollIntoView()", sheet)
        two_frames(browser)
        assert browser.execute_script("return arguments[0].parentElement.previousElementSibling", sheet).is_displayed()


def test_on_a_phone_nothing_to_read_is_smaller_than_15_px(browser: webdriver.Chrome, page: Path) -> None:
    script = (
        "const walker = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT), small = [];"
        "while (walker.nextNode()) { const e = walker.currentNode.parentElement;"
        "if (walker.currentNode.data.trim() && !e.closest('sub, sup, script')"
        " && parseFloat(getComputedStyle(e).fontSize) < 15) small.push(walker.currentNode.data); } return small"
    )
    with resized(browser, PHONE):
        browser.get(page.as_uri())
        assert browser.execute_script(script) == []


@pytest.mark.parametrize(("width", "columns"), [(PHONE, 1), (DESK, 2)])
def test_figures_of_a_row_stand_side_by_side_where_there_is_room(
    browser: webdriver.Chrome, page: Path, width: int, columns: int
) -> None:
    with resized(browser, width):
        browser.get(page.as_uri())
        laid_out(browser)
        figures = [figure.rect for figure in browser.find_elements(By.CSS_SELECTOR, ".row figure")]
        assert len({figure["x"] for figure in figures}) == columns
        assert all(figure["x"] + figure["width"] <= width for figure in figures)


def test_tables_are_sorted_by_their_numbers(opened: webdriver.Chrome) -> None:
    script = (
        "return [...document.querySelectorAll('table.sortable')].find((t) => t.querySelector('td[data-value]')"
        " && t.tBodies[0].rows.length > 3)"
    )
    table = opened.execute_script(script)
    column = opened.execute_script(
        "return [...arguments[0].tBodies[0].rows[0].cells].findIndex((cell) => cell.dataset.value)", table
    )

    def values() -> list[str | None]:
        cells = table.find_elements(By.CSS_SELECTOR, f"tbody td:nth-child({column + 1})")
        return [cell.get_attribute("data-value") for cell in cells]

    given = values()
    button = table.find_elements(By.CSS_SELECTOR, "thead button")[column]
    for sign in (1, -1):
        button.send_keys(Keys.ENTER)
        numbers = [float(value) for value in values() if value is not None]
        assert numbers == sorted(numbers, key=lambda number, sign=sign: sign * number)
        assert sorted(map(str, values())) == sorted(map(str, given))
    button.send_keys(Keys.ENTER)
    assert values() == given


def test_printed_it_has_no_tools(opened: webdriver.Chrome) -> None:
    assert first(opened, "nav").is_displayed()
    opened.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    assert not first(opened, "nav").is_displayed()
    assert not first(opened, ".tools").is_displayed()
    opened.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert len(opened.print_page(PrintOptions())) > 10_000


def test_a_model_is_printed_as_its_drawing(opened: webdriver.Chrome) -> None:
    opened.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    opened.execute_script("document.getElementById('viewer').showModal()")
    assert not first(opened, "dialog").is_displayed()
    assert first(opened, "figure:has(script) .picture svg").is_displayed()
    opened.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
