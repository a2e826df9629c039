"""One figure of the report by its name, as a matplotlib figure."""

from __future__ import annotations

from typing import TYPE_CHECKING

from assess.errors import AssessError
from assess.results import Results
from reports.assessment import assessment
from reports.document import Document
from reports.titles import file_stem

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def report_figure(name: str, results: Results, *, mechanism: str | None = None) -> Figure:
    """Return a figure of the report, in its language and units.

    Parameters
    ----------
    name : of a mechanism "sketch", "place", "view", "capacity", "pga-rotation", "history", "envelope", "moment",
        "contact", "directions", "amplification", "sensitivity", "sweep-01", "uncertainty-01-distribution",
        "uncertainty-01-influences"; of the whole run "key-plan", "spectrum", "suite", "capacities", "curves",
        "comparison", "critical". Results without histories have no figure of one, and so on.
    results : of a run
    mechanism : name of the mechanism; it may be left out for figures of the whole run, and where there is only one

    Returns
    -------
    matplotlib.figure.Figure
        a new figure at each call

    Raises
    ------
    AssessError
        for a name that these results have no figure of, and for an unknown mechanism; the known ones are listed
    """
    document = assessment(results, detail="full")
    names = figure_names(document, results, mechanism)
    if name not in names:
        of = "of the run" if mechanism is None else f'of mechanism "{mechanism}"'
        more = "; figures of a mechanism need its name" if mechanism is None else ""
        raise AssessError(f'there is no figure "{name}" {of}; known are {", ".join(names)}{more}')
    figure = next(each for each in document.figures if each.name == names[name])
    return figure.draw(document.writer)


def figure_names(document: Document, results: Results, mechanism: str | None) -> dict[str, str]:
    """Return the names of the figures of the run, or of one mechanism, each with its name in the document.

    Raises AssessError for an unknown mechanism.
    """
    stems = {each.name: f"{file_stem(each.name, place)}-" for place, each in enumerate(results.mechanisms, start=1)}
    if mechanism is not None and mechanism not in tuple(stems):
        raise AssessError(f'there is no mechanism "{mechanism}"; known are {", ".join(stems)}')
    if mechanism is None and len(stems) > 1:
        return {each.name: each.name for each in document.figures if not each.name.startswith(tuple(stems.values()))}
    wanted = tuple(stems.values()) if mechanism is None else (stems[mechanism],)
    own = [each.name for each in document.figures if each.name.startswith(wanted)]
    found = {name.removeprefix(next(stem for stem in wanted if name.startswith(stem))): name for name in own}
    if mechanism is None:
        found |= {each.name: each.name for each in document.figures if each.name not in own}
    return found
