"""Draw the pictures of the guide by the program's own figures: one project, run once, and its fragility.

    make figures        SVG in docs/images, beside this file

Usage: python docs/images/guide.py [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path

import assess
from assess.results.fragility import FragilityResults
from reports.assessment import report_figure
from reports.figures import fragility
from reports.language.locale import Locale
from reports.render.vector import write_figure

PROJECT = Path(__file__).parent / "guide.toml"
FIGURES: dict[str, tuple[str, str | None]] = {
    "spectrum": ("spectrum", None),
    "suite": ("suite", None),
    "comparison": ("comparison", None),
    "sketch-single-block": ("sketch", "facade"),
    "sketch-two-block": ("sketch", "storey"),
    "sketch-four-hinge": ("sketch", "portal"),
    "moment": ("moment", "facade"),
    "contact": ("contact", "facade"),
    "key-plan": ("key-plan", None),
    "history": ("history", "facade"),
    "envelope": ("envelope", "facade"),
    "sensitivity": ("sensitivity", "facade"),
    "uncertainty": ("uncertainty-05-distribution", "facade"),
    "amplification": ("amplification", "storey"),
}
"""Each picture: the figure of the report, and the mechanism that it is of."""


def main(folder: Path) -> None:
    """Draw every picture into a folder and print its path."""
    project = assess.load(PROJECT)
    run = assess.run(project)
    for picture, (name, mechanism) in FIGURES.items():
        figure = report_figure(name, run.results, mechanism=mechanism)
        print(write_figure(figure, folder / f"{picture}.svg", creator="assess"))
    _draw_fragility(assess.fragility(project), folder / "fragility.svg")


def _draw_fragility(results: FragilityResults, path: Path) -> None:
    """Draw the curve of overturning of the façade."""
    facade = next(each for each in results.mechanisms if each.name == "facade")
    curve = next(each for each in facade.curves if each.state.name == "overturning")
    print(write_figure(fragility.draw_fragility(curve, Locale()), path, creator="assess"))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
