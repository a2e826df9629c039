"""Studies over one value of a mechanism: sentence, table and figure of each."""

from __future__ import annotations

from functools import partial
from math import radians

from assess.results import MechanismResult, Results, SweepResult
from reports.chapters.cells import OUTCOMES, OVERTURNED, uplift_cell
from reports.chapters.mechanism_words import swept_value
from reports.document import Block, Cell, Column, Figure, Graded, Prose, Table
from reports.figures import directions, sweep
from reports.language.texts import Paragraph, Text, Verbatim, quantity, say, say_count

RULE = say(
    "The controlling case has the worst deciding answer: failing cases rank before incomplete ones, and those before "
    "passing ones; among equals the case with the smallest margin over the site’s own action controls, then the one "
    "with the largest demand over capacity."
)
REPRESENTS = say("This case represents the mechanism in the rest of this report.")
REPRESENTED = say("In the rest of this report the mechanism is represented by a case of another study.")


def blocks(results: Results, mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return the weakest direction, where it was sought, and every sweep of a mechanism."""
    made: list[Block] = [*_weakest_direction(mechanism, stem)]
    own = [each for each in results.sweeps if each.mechanism == mechanism.name]
    made += [Prose((RULE,))] if own else []
    for place, each in enumerate(own, start=1):
        name = f"{stem}-sweep-{place:02d}"
        caption = say(
            "Results over {key}; the ring marks the controlling case; a case that overturns has no ratio.",
            key=Verbatim(each.key),
        )
        made += [Prose((sentence(each),)), table(each, name=name), Figure(name, caption, partial(sweep.draw, each))]
    return made


def sentence(found: SweepResult) -> Text:
    """State what was swept, which case controls, and whether it represents the mechanism."""
    taken = say_count(
        "{key} takes {number} value;", "{key} takes {number} values;", len(found.value), key=Verbatim(found.key)
    )
    case = swept_value(found.value[found.controlling], found.unit)
    controls = say("{case} controls.", case=case)
    return Paragraph((taken, controls, REPRESENTS if found.governs else REPRESENTED))


def table(found: SweepResult, *, name: str) -> Table:
    """Tabulate a sweep, a line for each value in the user's order."""
    on_joints = any(value is not None for value in found.overturning_flexible_rad)
    extra = (Column(say("φₒᵥ on joints"), "rotation"), Column(say("Elastic frequency"), "frequency"))
    columns = (
        Column(say("Value")),
        Column(Verbatim("p"), "angular frequency"),
        Column(say("λ at uplift"), "ratio"),
        Column(Verbatim("φₒᵥ"), "rotation"),
        *(extra if on_joints else ()),
        Column(say("Restitution η"), "ratio"),
        Column(say("Demand / capacity"), "ratio"),
        Column(say("PGA at capacity"), "ground acceleration"),
        Column(say("Verdict")),
        Column(say("Case")),
    )
    caption = say(
        "{key}: rocking parameters of the branch that uplifts first, and the answer that decides; where none does, the "
        "worst of all checks of a code at all levels.",
        key=Verbatim(found.key),
    )
    rows = tuple(_row(found, place, on_joints=on_joints) for place in range(len(found.value)))
    return Table(name, caption, columns, rows, small=True)


def _row(found: SweepResult, place: int, *, on_joints: bool) -> tuple[Cell, ...]:
    joints: tuple[Cell, ...] = (found.overturning_flexible_rad[place], found.elastic_frequency_hz[place])
    outcome = found.outcome[place]
    return (
        swept_value(found.value[place], found.unit),
        found.p_eq_per_s[place],
        uplift_cell(found.uplift_multiplier[place]),
        found.overturning_rad[place],
        *(joints if on_joints else ()),
        found.restitution[place],
        OVERTURNED if found.overturned[place] else found.demand_capacity[place],
        found.capacity_pga_g[place],
        Graded(outcome.value, OUTCOMES[outcome.value]),
        say("controls") if place == found.controlling else None,
    )


def _weakest_direction(mechanism: MechanismResult, stem: str) -> list[Block]:
    """Return sentence and figure on the weakest direction, where it was searched for."""
    found = mechanism.direction_sweep
    if found is None:
        return []
    caption = say(
        "Load multiplier λ that starts rotation towards each horizontal direction; the dot marks the weakest."
    )
    said = say(
        "The direction is the weakest of {number}: {angle} from +x towards +y. The load multiplier is within 1 % of "
        "its minimum over {flat} of the circle; the minimum is {variation} below the maximum.",
        number=quantity(len(found.angle_deg), figures=9),
        angle=quantity(radians(found.weakest_deg), "angle", 4),
        flat=quantity(radians(found.flat_deg), "angle", 3),
        variation=quantity(100.0 * found.variation, "percent", 3),
    )
    return [Prose((said,)), Figure(f"{stem}-directions", caption, partial(directions.draw, found))]
