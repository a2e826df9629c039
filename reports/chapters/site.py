"""The chapter on the site: its spectrum, the actions that are combined, the records."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from itertools import chain

from assess.results import LoadResult, Results, SpectrumResult
from reports import document as doc
from reports.chapters import suite
from reports.chapters.assumptions import stated_source
from reports.chapters.cells import OWN_BASIS
from reports.figures import spectrum as spectrum_figure
from reports.figures import spectrum as suite_figure
from reports.language.texts import Paragraph, Phrase, Term, Text, Verbatim, listing, names, quantity, say, with_figures
from reports.language.value_names import PARAMETER_NAMES, parameter_rows
from reports.mechanisms import mechanism_number
from reports.project_values import project_text
from spectra.gravity import g

SPECTRUM = "site.spectrum"
CALCULATED = say("calculated")
WITH_VERTICAL = ("asce43-05-spectrum", "asce43-05-sliding")
PAIRS_IN_ROW = 3  # parameters in a row
ON_PAGE_1 = (PARAMETER_NAMES["limit_state"][0], PARAMETER_NAMES["use_coefficient"][0])


def sections(results: Results) -> list[doc.Section]:
    """Return the chapter."""
    parts = [
        doc.Section(say("Site and action"), 0, tuple(_action_blocks(results)), starts_page=True),
        _combination_section(results),
    ]
    if results.records:
        parts.append(doc.Section(say("Records"), 1, tuple(_record_blocks(results))))
    return parts


def parameters_table(results: Results, spectrum: SpectrumResult) -> doc.Table:
    """Tabulate the parameters of the spectrum that are given or defaults, with their sources."""
    stated = [row for row in _parameters(results, spectrum) if row[2] != CALCULATED]
    columns = (doc.Column(say("Parameter")), doc.Column(say("Value")), doc.Column(say("Source")))
    return doc.Table(
        "site",
        say("The elastic response spectrum of the site."),
        columns,
        tuple(_without_repeated_sources(stated)),
        small=True,
    )


def hazard_table(results: Results) -> doc.Table:
    """Tabulate the hazard over return periods; no rows where the project gives one spectrum."""
    found = results.project.get(f"{SPECTRUM}.hazard")
    given = found.value if found is not None and isinstance(found.value, list | tuple) else ()
    columns = (
        doc.Column(say("Return period"), "return period"),
        doc.Column(say("a_g on rock"), "ground acceleration"),
        doc.Column(say("F_0"), "ratio"),
        doc.Column(say("T_C*"), "time"),
    )
    rows = tuple((row["return_period"], row["a_g"] / g, row["f_0"], row["t_c_star"]) for row in given)
    return doc.Table("hazard", say("Hazard of the site over return periods, as given."), columns, rows, small=True)


def calculated_parameters_table(results: Results, spectrum: SpectrumResult) -> doc.Table:
    """Tabulate the parameters that follow from the others, several abreast; no rows where all are given."""
    found: list[tuple[doc.Cell, ...]] = [
        (name, with_figures(value, 4))
        for name, value, source in _parameters(results, spectrum)
        if source == CALCULATED and name not in ON_PAGE_1
    ]
    blank: tuple[doc.Cell, ...] = (doc.NOTHING, doc.NOTHING)
    found += [blank] * (-len(found) % PAIRS_IN_ROW)
    high = len(found) // PAIRS_IN_ROW
    rows = tuple(tuple(chain.from_iterable(found[row::high])) for row in range(high))
    columns = (doc.Column(say("Parameter")), doc.Column(say("Value"), share=0.1)) * PAIRS_IN_ROW
    return doc.Table("calculated", say("Parameters calculated from these."), columns, rows, small=True)


def loads_table(results: Results) -> doc.Table:
    """Tabulate the loads that act, a row for loads that are alike in several mechanisms."""
    groups: dict[tuple[object, ...], tuple[LoadResult, list[str]]] = {}
    for mechanism in results.mechanisms:
        for load in mechanism.loads:
            alike = (load.name, load.kind, load.bearing, load.mass_kg, load.force_n)
            groups.setdefault(alike, (load, []))[1].append(mechanism_number(results, mechanism.name))
    fields: tuple[doc.Field[tuple[LoadResult, list[str]]], ...] = (
        (doc.Column(say("Load")), lambda group: Verbatim(group[0].name)),
        (doc.Column(say("Mechanisms")), lambda group: names(group[1])),
        (doc.Column(say("Acts as")), lambda group: _acts_as(group[0])),
        (doc.Column(say("Mass"), "mass"), lambda group: group[0].mass_kg),
        (doc.Column(say("Force along"), "force"), lambda group: group[0].force_n and group[0].force_n[0]),
        (doc.Column(say("Force up"), "force"), lambda group: group[0].force_n and group[0].force_n[1]),
    )
    caption = say("Loads besides the weight of the masonry, as given; forces along the direction of motion and up.")
    return doc.tabulate("actions", caption, fields, groups.values(), small=True)


def _action_blocks(results: Results) -> Iterator[doc.Block]:
    if results.spectrum is None:
        yield doc.Prose((say("The project gives no spectrum of the site."),))
        return
    yield (
        doc.Prose((_action(results),))
        if results.verdict is not None
        else doc.Prose((say("No action decides: the project has no verdict."),))
    )
    yield parameters_table(results, results.spectrum)
    yield from doc.nonempty(hazard_table(results))
    yield from doc.nonempty(calculated_parameters_table(results, results.spectrum))
    figures = tuple(_figures(results, results.spectrum))
    yield doc.FigureRow(figures) if len(figures) > 1 else figures[0]


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
    known = (stated,) if stated else tuple(state for state in decide if state != OWN_BASIS)
    return listing(map(Verbatim, known)) if known else say("no limit state stated")


def _figures(results: Results, target: SpectrumResult) -> Iterator[doc.Figure]:
    caption = say("Elastic response spectrum of the site and of the records as scaled to it.")
    if not results.records:
        caption = say("Elastic response spectrum of the site.")
    yield doc.Figure("spectrum", caption, partial(spectrum_figure.draw_scaled_spectra, target, results.records))
    if results.ground_motion is not None:
        caption = say("Records, their mean and the target, with the limits that the deciding code sets to the mean.")
        yield doc.Figure("suite", caption, partial(suite_figure.draw_suite, results))


def _parameters(results: Results, spectrum: SpectrumResult) -> Iterator[tuple[Text, Text, Text]]:
    """Yield name, value and source of everything that makes the spectrum."""
    code = _origin(results, "code")
    yield say("Spectrum"), Term(spectrum.clause), say("given") if code == CALCULATED else code
    for key, (name, value) in zip(spectrum.parameters, parameter_rows(spectrum.parameters), strict=True):
        yield name, value, _origin(results, key)
    yield say("Damping ratio"), quantity(spectrum.damping), _origin(results, "damping")
    pga = quantity(spectrum.pga_g, "ground acceleration")
    yield say("Peak ground acceleration, Sₐ(0)"), pga, _origin(results, "pga")


def _without_repeated_sources(rows: list[tuple[Text, Text, Text]]) -> Iterator[tuple[doc.Cell, ...]]:
    """Yield the rows, with a source that is repeated said once."""
    before: doc.Cell = None
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


def _record_blocks(results: Results) -> Iterator[doc.Block]:
    yield from doc.nonempty(suite.suite_records_table(results))
    sentences = tuple(suite.suite_sentences(results))
    if sentences:
        yield doc.Prose((Paragraph(sentences),))
    if not suite.meets_requirements(results):
        yield from doc.nonempty(suite.basis_requirements_table(results))


_LOADS_AS_GIVEN = say(
    "The loads of the project are used as given, without coefficients of the program: their values must already be "
    "those of this combination."
)

COMBINATIONS: Mapping[str, Phrase] = {
    "ntc2018": say(
        "Combination: E + G₁ + G₂ + P + Σ ψ₂ Q, with the masses of G₁ + G₂ + Σ ψ₂ Q (NTC 2018, eq. 2.5.5 and 2.5.7)."
    ),
    "dmi2008": say("Combination: E + G₁ + G₂ + P + Σ ψ₂ Q, with the masses of G₁ + G₂ + Σ ψ₂ Q (NTC 2008, 2.5.3)."),
    "ec8": say("Combination: G + P + A_Ed + Σ ψ₂ Q (EN 1990, 6.4.3.4)."),
    "nzsee2017": say("Combination: G + E_u + ψ_E Q (AS/NZS 1170.0, 4.2.2)."),
}
"""The seismic combination of the basis of the verdict."""
NO_LOAD_FACTORS = say("The seismic action is combined with the loads of the project; no load factors are applied.")


def _combination_section(results: Results) -> doc.Section:
    """Return what acts on the mechanisms, in which combination and directions."""
    basis = "" if results.verdict is None else results.verdict.basis
    blocks: tuple[doc.Block, ...] = (
        doc.Prose(
            (
                Paragraph((COMBINATIONS.get(basis, NO_LOAD_FACTORS), *_weights(results))),
                Paragraph(tuple(_directions(results))),
            )
        ),
        *doc.nonempty(loads_table(results)),
    )
    return doc.Section(say("Combination of actions"), 1, blocks)


def _weights(results: Results) -> Iterator[Text]:
    yield say("The weight of the moving masonry acts in every mechanism, as a permanent load and as a mass.")
    given = [mechanism for mechanism in results.mechanisms if mechanism.kind == "equivalent-block"]
    if given:
        yield say("Loads on equivalent blocks are part of their rocking parameters, as the project gives them.")
    if any(mechanism.loads for mechanism in results.mechanisms):
        yield _LOADS_AS_GIVEN
    elif len(given) < len(results.mechanisms):
        yield say("The project gives no other loads: no floor, roof, tie or force.")


def _directions(results: Results) -> Iterator[Text]:
    yield say(
        "Each mechanism moves in one vertical plane, and the horizontal ground motion acts in that plane, in both "
        "polarities. The horizontal component at right angles to it is not combined with it."
    )
    given = results.project.get("site.vertical_ratio")
    ratio = 0.0 if given is None or given.value is None else float(given.value)
    shaken = any(check.procedure in WITH_VERTICAL for each in results.mechanisms for check in each.checks)
    if ratio > 0.0 and shaken:
        yield say(
            "A vertical ground motion of {ratio} times the horizontal one enters the approximate method of ASCE 43-05 "
            "by its factor F_V; the other methods and the time histories have none.",
            ratio=quantity(ratio),
        )
    else:
        yield say("No vertical ground motion is applied.")


def _acts_as(load: LoadResult) -> Text:
    """Return what a load does in the combination."""
    if load.kind == "mass":
        return say("weight and mass") if load.bearing else say("horizontal mass only")
    return say("tie force") if load.kind == "tie" else say("force")
