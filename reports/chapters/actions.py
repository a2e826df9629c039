"""The actions that are combined: the seismic one, the weights and the loads of the project, the directions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assess.results import LoadResult, Results
from reports.document import Block, Cell, Column, Prose, Section, Table, nonempty
from reports.language.texts import Paragraph, Phrase, Text, Verbatim, names, quantity, say
from reports.titles import mechanism_number

_AS_GIVEN = say(
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
AS_THEY_ARE = say("The seismic action is combined with the loads of the project; no load factors are applied.")


def section(results: Results) -> Section:
    """Return what acts on the mechanisms, in which combination and directions."""
    basis = "" if results.verdict is None else results.verdict.basis
    blocks: tuple[Block, ...] = (
        Prose(
            (
                Paragraph((COMBINATIONS.get(basis, AS_THEY_ARE), *_weights(results))),
                Paragraph(tuple(_directions(results))),
            )
        ),
        *nonempty(loads(results)),
    )
    return Section(say("Combination of actions"), 1, blocks)


def _weights(results: Results) -> Iterator[Text]:
    yield say("The weight of the moving masonry acts in every mechanism, as a permanent load and as a mass.")
    given = [mechanism for mechanism in results.mechanisms if mechanism.kind == "equivalent-block"]
    if given:
        yield say("Loads on equivalent blocks are part of their rocking parameters, as the project gives them.")
    if any(mechanism.loads for mechanism in results.mechanisms):
        yield _AS_GIVEN
    elif len(given) < len(results.mechanisms):
        yield say("The project gives no other loads: no floor, roof, tie or force.")


def _directions(results: Results) -> Iterator[Text]:
    yield say(
        "Each mechanism moves in one vertical plane, and the horizontal ground motion acts in that plane, in both "
        "polarities. The horizontal component at right angles to it is not combined with it."
    )
    given = results.project.get("site.vertical_ratio")
    ratio = 0.0 if given is None or given.value is None else float(given.value)
    if ratio > 0.0:
        yield say(
            "A vertical ground motion of {ratio} times the horizontal one enters the approximate method of ASCE 43-05 "
            "by its factor F_V; the other methods and the time histories have none.",
            ratio=quantity(ratio),
        )
    else:
        yield say("No vertical ground motion is applied.")


def loads(results: Results) -> Table:
    """Tabulate the loads that act, a row for loads that are alike in several mechanisms."""
    groups: dict[tuple[object, ...], tuple[LoadResult, list[str]]] = {}
    for mechanism in results.mechanisms:
        for load in mechanism.loads:
            alike = (load.name, load.kind, load.bearing, load.mass_kg, load.force_n)
            groups.setdefault(alike, (load, []))[1].append(mechanism_number(results, mechanism.name))
    rows = tuple(_row(load, of) for load, of in groups.values())
    columns = (
        Column(say("Load")),
        Column(say("Mechanisms")),
        Column(say("Acts as")),
        Column(say("Mass"), "mass"),
        Column(say("Force along"), "force"),
        Column(say("Force up"), "force"),
    )
    caption = say("Loads besides the weight of the masonry, as given; forces along the direction of motion and up.")
    return Table("actions", caption, columns, rows, small=True)


def _row(load: LoadResult, of: list[str]) -> tuple[Cell, ...]:
    along, up = load.force_n or (None, None)
    return (Verbatim(load.name), names(of), acts_as(load), load.mass_kg, along, up)


def acts_as(load: LoadResult) -> Text:
    """Return what a load does in the combination."""
    if load.kind == "mass":
        return say("weight and mass") if load.bearing else say("horizontal mass only")
    return say("tie force") if load.kind == "tie" else say("force")
