"""The chapter on the site: its spectrum, the actions that are combined, the records."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import chain

from scipy.constants import g

from assess.messages.message import Quantity
from assess.results import Results, SpectrumResult
from reports.chapters import actions, suite
from reports.chapters.assumptions import stated_source
from reports.chapters.index_text import OWN
from reports.document import NOTHING, Block, Cell, Column, Figure, Prose, Row, Section, Table, nonempty
from reports.figures import spectrum as spectrum_figure
from reports.figures import suite as suite_figure
from reports.language.spectrum_parameters import NAMES, parameter_rows
from reports.language.texts import Paragraph, Term, Text, Verbatim, listing, quantity, say
from reports.project_text import project_text

SPECTRUM = "site.spectrum"
CALCULATED = say("calculated")
ABREAST = 3  # parameters in a row
ON_PAGE_1 = (NAMES["limit_state"][0], NAMES["use_coefficient"][0])


def sections(results: Results) -> list[Section]:
    """Return the chapter."""
    parts = [Section(say("Site and action"), 0, tuple(_hazard(results)), starts_page=True), actions.section(results)]
    if results.records:
        parts.append(Section(say("Records"), 1, tuple(_records(results))))
    return parts


def _hazard(results: Results) -> Iterator[Block]:
    if results.spectrum is None:
        yield Prose((say("The project gives no spectrum of the site."),))
        return
    yield Prose((_action(results),)) if results.verdict is not None else Prose((_no_action(),))
    yield parameters(results, results.spectrum)
    yield from nonempty(hazard(results))
    yield from nonempty(calculated_parameters(results, results.spectrum))
    figures = tuple(_figures(results, results.spectrum))
    yield Row(figures) if len(figures) > 1 else figures[0]


def _action(results: Results) -> Text:
    """Return the action of the verdict in one sentence."""
    assert results.verdict is not None
    action = results.verdict.action
    pga = quantity(action.pga_g, "ground acceleration", 3)
    if action.return_period_years is not None:
        return say(
            "The site’s own action has a peak ground acceleration of {pga} ({state}, return period {years}).",
            pga=pga,
            state=_state(results),
            years=quantity(action.return_period_years, "return period"),
        )
    return say(
        "The site’s own action has a peak ground acceleration of {pga} ({state}).", pga=pga, state=_state(results)
    )


def _state(results: Results) -> Text:
    assert results.verdict is not None
    stated, decide = results.verdict.action.limit_state, results.verdict.limit_states
    known = (stated,) if stated else tuple(state for state in decide if state != OWN)
    return listing(map(Verbatim, known)) if known else say("no limit state stated")


def _no_action() -> Text:
    return say("No action decides: the project has no verdict.")


def _figures(results: Results, target: SpectrumResult) -> Iterator[Figure]:
    caption = say("Elastic response spectrum of the site and of the records as scaled to it.")
    if not results.records:
        caption = say("Elastic response spectrum of the site.")
    yield Figure("spectrum", caption, partial(spectrum_figure.draw, target, results.records))
    if results.ground_motion is not None:
        caption = say("Records, their mean and the target, with the limits that the deciding code sets to the mean.")
        yield Figure("suite", caption, partial(suite_figure.draw, results))


def parameters(results: Results, spectrum: SpectrumResult) -> Table:
    """Tabulate the parameters of the spectrum that are given or defaults, with their sources."""
    told = [row for row in _parameters(results, spectrum) if row[2] != CALCULATED]
    columns = (Column(say("Parameter")), Column(say("Value")), Column(say("Source")))
    return Table("site", say("The elastic response spectrum of the site."), columns, tuple(_once(told)), small=True)


def hazard(results: Results) -> Table:
    """Tabulate the hazard over return periods; no rows where the project gives one spectrum."""
    found = results.project.get(f"{SPECTRUM}.hazard")
    given = found.value if found is not None and isinstance(found.value, list | tuple) else ()
    columns = (
        Column(say("Return period"), "return period"),
        Column(say("a_g on rock"), "ground acceleration"),
        Column(say("F_0"), "ratio"),
        Column(say("T_C*"), "time"),
    )
    rows = tuple((row["return_period"], row["a_g"] / g, row["f_0"], row["t_c_star"]) for row in given)
    return Table("hazard", say("Hazard of the site over return periods, as given."), columns, rows, small=True)


def calculated_parameters(results: Results, spectrum: SpectrumResult) -> Table:
    """Tabulate the parameters that follow from the others, several abreast; no rows where all are given."""
    found: list[tuple[Cell, ...]] = [
        (name, _short(value))
        for name, value, source in _parameters(results, spectrum)
        if source == CALCULATED and name not in ON_PAGE_1
    ]
    blank: tuple[Cell, ...] = (NOTHING, NOTHING)
    found += [blank] * (-len(found) % ABREAST)
    high = len(found) // ABREAST
    rows = tuple(tuple(chain.from_iterable(found[row::high])) for row in range(high))
    columns = (Column(say("Parameter")), Column(say("Value"), share=0.1)) * ABREAST
    return Table("calculated", say("Parameters calculated from these."), columns, rows, small=True)


def _short(value: Text) -> Text:
    return replace(value, figures=4) if isinstance(value, Quantity) else value


def _parameters(results: Results, spectrum: SpectrumResult) -> Iterator[tuple[Text, Text, Text]]:
    """Yield name, value and source of everything that makes the spectrum."""
    code = _origin(results, "code")
    yield say("Spectrum"), Term(spectrum.clause), say("given") if code == CALCULATED else code
    for key, (name, value) in zip(spectrum.parameters, parameter_rows(spectrum.parameters), strict=True):
        yield name, value, _origin(results, key)
    yield say("Damping ratio"), quantity(spectrum.damping), _origin(results, "damping")
    pga = quantity(spectrum.pga_g, "ground acceleration")
    yield say("Peak ground acceleration, Sₐ(0)"), pga, _origin(results, "pga")


def _once(rows: list[tuple[Text, Text, Text]]) -> Iterator[tuple[Cell, ...]]:
    """Yield the rows, with a source that is repeated said once."""
    before: Cell = None
    for name, value, source in rows:
        repeated = source == before and source not in (CALCULATED, say("given"), say("default"))
        yield name, value, say("as above") if repeated else source
        before = source


def _origin(results: Results, name: str) -> Text:
    """Return where a parameter comes from: the source that the project states, given without one, or a clause."""
    key = "site.pga" if name == "pga" else f"{SPECTRUM}.{name}"
    found = results.project.get(key)
    if found is None or not found.given or found.value is None:
        default = found is not None and found.value is not None
        return say("default") if default else CALCULATED
    for place in (key, SPECTRUM, "site"):
        stated = project_text(results, f"report.sources.{place}")
        if stated:
            return stated_source(stated)
    return say("given")


def _records(results: Results) -> Iterator[Block]:
    yield from nonempty(suite.records(results))
    told = tuple(suite.sentences(results))
    if told:
        yield Prose((Paragraph(told),))
    if not suite.complies(results):
        yield from nonempty(suite.requirements(results))
