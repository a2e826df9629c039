"""Take the pictures of the tutorial in the browser: its steps, as Debian's chromium shows them.

Usage: python docs/images/page.py    (chromium and chromedriver, of Debian's chromium-driver)
"""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
PICTURES = {
    "Open the model": ("page-house.png", "Building:"),
    "Say where the house stands": ("page-missing.png", "To complete it"),
    "Drag a crack": ("page-crack.png", "Mechanism"),
    "Write, run, report": ("page-report.png", "Project file"),
    "Find the weakest crack": ("page-spire.png", "weakest crack:"),
}
"""The picture of a step, and how what is in it at the top of the panel begins."""
SIZE = {"width": 1280, "height": 800, "deviceScaleFactor": 1, "mobile": False}  # px
COLOURS = 256
PATIENCE = 60.0  # s
FRAMES = 8.0  # s in which the drawing settles
SHOWN = "return document.body.innerText.includes(arguments[0])"
PLACE = """
document.querySelector("[class*=Notification] button")?.click()
const holds = (each) => each.innerText?.startsWith(arguments[0])
const found = [...document.querySelectorAll("*")].filter(holds).pop()
found.scrollIntoView({block: "start"})
"""


def main() -> None:
    """Follow the tutorial and take its pictures."""
    from docs.tutorial.in_the_browser import follow_house, follow_spire

    for number, follow in enumerate((follow_house, follow_spire)):
        with TemporaryDirectory() as folder, chromium(Path(folder) / "profile") as driver:
            here = ""
            for heading, page in follow(Path(folder) / str(number)):
                if heading not in PICTURES:
                    continue
                if here != page.server.address:
                    here = page.server.address
                    driver.get(here)
                name, top = PICTURES[heading]
                end = time.monotonic() + PATIENCE
                while not driver.execute_script(SHOWN, top) and time.monotonic() < end:
                    time.sleep(0.5)
                for _ in range(2):  # what is above it may still grow
                    driver.execute_script(PLACE, top)
                    time.sleep(FRAMES / 2.0)
                take(driver, ROOT / "docs" / "images" / name)
                print(name)


def take(driver: Any, path: Path) -> None:
    """Write what a browser shows, in few colours."""
    shown = Image.open(BytesIO(driver.get_screenshot_as_png())).convert("RGB")
    shown.quantize(COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(path, optimize=True)


@contextmanager
def chromium(profile: Path) -> Iterator[Any]:
    """Open Debian's browser without a screen, drawing by software."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    drawn = ("headless=new", "use-gl=angle", "use-angle=swiftshader", "enable-unsafe-swiftshader", "hide-scrollbars")
    root = ("no-sandbox",) if os.geteuid() == 0 else ()
    for each in (*drawn, *root, "no-first-run", "disable-background-networking", f"user-data-dir={profile}"):
        options.add_argument(f"--{each}")
    driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
    try:
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", SIZE)
        yield driver
    finally:
        driver.quit()


if __name__ == "__main__":
    main()
