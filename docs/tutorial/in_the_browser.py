"""What the tutorial in the browser does, step by step, on the page's own objects: for its test and for its pictures."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

from assess.examples import copy_example
from assess.page.page import Page, open_page
from assess.project.drawn_project import write_project

PATIENCE = 600.0  # s
SITE = """\
[site.spectrum]
code = "ntc2018"
nominal_life = 50
use_class = "II"
soil = "B"
hazard = [
  { return_period = 50, a_g = "0.077 g", f_0 = 2.38, t_c_star = 0.28 },
  { return_period = 475, a_g = "0.188 g", f_0 = 2.36, t_c_star = 0.33 },
  { return_period = 975, a_g = "0.240 g", f_0 = 2.39, t_c_star = 0.34 },
]
[procedures.ntc2018]
knowledge_level = "LC1\""""
TIED = """\
"mechanisms.street-front-overturning-of-storeys.loads[1].tied" = "measured: survey of the tie-beams, 3 June 2024"
"mechanisms.back-wall-overturning-of-storeys.loads[1].tied" = "measured: survey of the tie-beams, 3 June 2024"
"mechanisms.back-wall-overturning.loads[1].tied" = "measured: survey of the tie-beams, 3 June 2024"
"mechanisms.street-front-overturning.loads[1].tied" = "measured: survey of the tie-beams, 3 June 2024\""""
SIGNED = {"author": "Giulia Ferri", "licence_number": "A 0000"}
WHOLE = ('disintegration = "excluded"', "measured: two openings of the plaster, 3 June 2024")


def follow_house(folder: Path) -> Iterator[tuple[str, Page]]:
    """Yield the headings of the steps with the house, each with the page after it.

    Parameters
    ----------
    folder : where the example is copied to; it does not exist
    """
    model = copy_example("house", folder).with_name("house.ifc")
    project = folder / "house-project"
    write_project([model], project)
    with open_page(project) as page:
        yield "Open the model", settled(page)
        complete(page, "site.spectrum", SITE)
        page._change_file(page.opened.write, None)
        yield "Say where the house stands", settled(page)
        complete(page, "report.sources", TIED)
        complete(settled(page), "materials.masonry.disintegration", *WHOLE)
        yield "Say who vouches for what helps", settled(page)
        page.pick("side-wall-right-gable")
        for z in (6.05, 6.15, 6.25):
            page._dragged((9.0, 3.5, z), 0.0, z == 6.25)
        yield "Drag a crack", settled(page)
        page._change_file(page.opened.edited.undo, None)
        for key, text in SIGNED.items():
            page.front[key].value = text
            page._state_front(key, page.front[key])
        page._change_file(settled(page).opened.write, None)
        settled(page)._start_run()
        assert page._run is not None
        page._run.wait(PATIENCE)
        yield "Write, run, report", page


def follow_spire(folder: Path) -> Iterator[tuple[str, Page]]:
    """Yield the headings of the steps with the spire, as `follow_house` does."""
    with open_page(copy_example("san_leonardo_spire", folder)) as page:
        yield "Open a spire", settled(page)
        page.pick("spire-whole")
        page._find_weakest()
        yield "Find the weakest crack", settled(page)


def complete(page: Page, key: str, lines: str, source: str = "") -> None:
    """Give lines, and their source, for an input that is missing."""
    missing = next(each for each in reversed(page.opened.missing) if each.key == key)
    page._add_lines(missing, SimpleNamespace(value=lines), SimpleNamespace(value=source), None)


def settled(page: Page) -> Page:
    """Return the page once it shows what was asked."""
    assert page.wait(PATIENCE)
    return page
