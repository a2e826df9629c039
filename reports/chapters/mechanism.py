"""The chapter of one mechanism: its shape, its answers, its histories and its calculation sheets."""

from __future__ import annotations

from functools import partial

from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import (
    calculation_sheets,
    check_tables,
    descriptions,
    envelopes,
    histories,
    interfaces,
    parameters,
    sweeps,
)
from reports.document import Block, Figure, Section, Text, nonempty
from reports.figures import amplification, capacity, history, pga_rotation, sketch, view
from reports.figures.model import model_of_view
from reports.language.numerals import numeral
from reports.mechanism_title import mechanism_title
from reports.references import reference


def chapter(results: Results, mechanism: MechanismResult, name: str, *, twin: str) -> list[Section]:
    """Return the chapter of one mechanism and its sections.

    name : beginning of the names of its figures and tables
    twin : that of an earlier mechanism with the same bodies, empty for none
    """
    own = [sweep for sweep in results.sweeps if sweep.mechanism == mechanism.name]
    chapters = [
        _shape(mechanism, name, twin=twin),
        sweeps.studies(own, name=name),
        _answer(results, mechanism, name),
        _histories(mechanism, name),
        *envelopes.chapter(mechanism, results.records, name, level=1),
        _sheets(results, mechanism, name),
    ]
    return [chapter for chapter in chapters if chapter.blocks]


def _shape(mechanism: MechanismResult, name: str, *, twin: str) -> Section:
    blocks = (
        Text((descriptions.description(mechanism),)),
        *sweeps.weakest_direction(mechanism, name=name),
        Figure(f"{name}-sketch", descriptions.sketch_caption(mechanism), partial(sketch.draw, mechanism)),
        *_view(mechanism, name, twin=twin),
        *nonempty(parameters.loads(mechanism, name=f"{name}-loads")),
        parameters.parameters(mechanism, name=f"{name}-parameters"),
        Figure(f"{name}-capacity", descriptions.capacity_caption(mechanism), partial(capacity.draw, mechanism)),
        *interfaces.blocks(mechanism, name=name),
        *nonempty(parameters.hinge_forces(mechanism, name=f"{name}-hinge-forces")),
    )
    return Section(f"Mechanism: {mechanism_title(mechanism)}", 0, blocks, starts_page=True)


def _view(mechanism: MechanismResult, name: str, *, twin: str) -> list[Block]:
    """Return the bodies in space, once for mechanisms that differ by their interface alone.

    twin : file stem of an earlier mechanism with the same bodies, empty for none
    """
    seen = mechanism.view
    if seen is None:
        return []
    if twin:
        return [Text((f"For its bodies in space see {reference('Figure', f'{twin}-view')}.",))]
    positive = len(mechanism.drawing.displaced.hinges)
    model = model_of_view(seen, positive=positive)
    return [Figure(f"{name}-view", descriptions.view_caption(seen), partial(view.draw, seen, positive), model)]


def _answer(results: Results, mechanism: MechanismResult, name: str) -> Section:
    caption = (
        "Largest rotation over peak ground acceleration by every procedure (as thesis Figs. 8.6, 8.7). Solid lines are "
        "code procedures, dashed lines readings of the thesis; large markers the allowable of each; dots and crosses "
        "single records."
    )
    blocks: list[Block] = []
    if mechanism.checks:
        blocks.append(Figure(f"{name}-pga-rotation", caption, partial(pga_rotation.draw, mechanism)))
    unlike = descriptions.input_locations(mechanism)
    blocks += [Text((unlike,))] if unlike else []
    blocks += nonempty(check_tables.demands(mechanism, name=f"{name}-demand-capacity"))
    blocks += nonempty(check_tables.answers(mechanism, governing.site_pga(results), name=f"{name}-remarks"))
    return Section("Demand and capacity", 1, tuple(blocks))


def _histories(mechanism: MechanismResult, name: str) -> Section:
    blocks: list[Block] = [
        *_amplification(mechanism, name),
        *nonempty(histories.suites(mechanism, name=f"{name}-suites")),
    ]
    found = governing.history(mechanism)
    if found is not None:
        one, trace = found
        draw = partial(history.draw, mechanism, one, trace, governing.allowable(mechanism, one.level_pga_g))
        end = "it overturns" if one.overturned else f"largest φ/φₒᵥ {numeral(abs(one.max_rotation_ratio or 0.0))}"
        caption = (
            f"The governing history: {one.record}, polarity {one.polarity:+d}, at PGA {one.level_pga_g:.3g} g; {end}; "
            f"{one.impacts} impacts. Above the acceleration, below the rotation."
        )
        blocks.append(Figure(f"{name}-history", caption, draw))
    blocks += nonempty(histories.histories(mechanism, name=f"{name}-histories"))
    return Section("Time histories", 1, tuple(blocks))


def _amplification(mechanism: MechanismResult, name: str) -> list[Block]:
    """Return how the motion reaches a mechanism above the ground, where the histories amplify it."""
    found = mechanism.amplification
    if found.height_m is None:
        return []
    explanation = Text(descriptions.amplification(mechanism))
    if found.motion is None:
        return [explanation]
    draw = partial(amplification.draw, found.motion)
    return [explanation, Figure(f"{name}-amplification", descriptions.amplification_caption(mechanism), draw)]


def _sheets(results: Results, mechanism: MechanismResult, name: str) -> Section:
    label = mechanism_title(mechanism)
    made = [
        calculation_sheets.calculation_sheet(check, name=f"{name}-sheet-{place:02d}", mechanism=label)
        for place, check in enumerate(governing.worst_per_procedure(governing.at_site(results, mechanism)), start=1)
        if check.steps
    ]
    note = "One sheet for each procedure, at the site’s own action; the steps of other levels are in results.json."
    return Section("Calculation sheets", 1, (Text((note,)), *made) if made else ())
