"""The parametric studies of the report: sentence, table and figure of each, from the results."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from assess.messages.plural import count_noun
from assess.results import DirectionSweep, MechanismResult, SweepResult
from reports.chapters.check_tables import OVERTURNED, uplift_cell
from reports.document import Block, Cell, Column, Figure, Section, Table, Text
from reports.figures import directions as directions_figure
from reports.figures import sweep as sweep_figure
from reports.language.lettering import truncate
from reports.language.numerals import as_given, numeral

RULE = (
    "The controlling case has the worst deciding answer: failing cases rank before incomplete ones, and "
    "those before passing ones; among equals the case with the smallest margin over the site’s own action "
    "controls, then the one with the largest demand over capacity."
)
JOINTS = (
    " φₒᵥ is that of rigid joints; on joints it is measured from rest, about which small motions have the "
    "elastic frequency."
)


def studies(sweeps: Sequence[SweepResult], *, name: str) -> Section:
    """Return every sweep of one mechanism; `name` begins the names of its tables and figures."""
    blocks: list[Block] = [Text((RULE,))] if sweeps else []
    for place, sweep in enumerate(sweeps, start=1):
        stem = f"{name}-sweep-{place:02d}"
        caption = (
            f"Results over {swept_key(sweep)}; the ring marks the controlling case; a case that overturns has no ratio."
        )
        blocks += [Text((sentence(sweep),)), table(sweep, name=stem)]
        blocks.append(Figure(stem, caption, partial(sweep_figure.draw, sweep)))
    return Section("Parametric studies", 1, tuple(blocks))


def sentence(sweep: SweepResult) -> str:
    """State what was swept, which case controls, and whether it represents the mechanism."""
    standing = (
        "This case represents the mechanism in the rest of this report."
        if sweep.governs
        else "In the rest of this report the mechanism is represented by a case of another study."
    )
    values = count_noun(len(sweep.value), "value")
    return f"{swept_key(sweep)} takes {values}; {controlling_case(sweep)} controls. {standing}"


def swept_key(sweep: SweepResult) -> str:
    """Return the swept key for use in a sentence."""
    return truncate(sweep.key, 100)


def controlling_case(sweep: SweepResult) -> str:
    """Return the controlling case in words."""
    unit = "" if sweep.unit == "-" else f" {sweep.unit}"
    return f"{as_given(sweep.value[sweep.controlling])}{unit}"


def table(sweep: SweepResult, *, name: str) -> Table:
    """Tabulate a sweep, a line for each value in the user's order."""
    columns = (
        Column("Value", sweep.unit, "number"),
        Column("p", "1/s", "number"),
        Column("λ at uplift", "-", "number"),
        Column("φₒᵥ", "rad", "number"),
        *(column for column, _ in on_joints(sweep)),
        Column("Restitution η", "-", "number"),
        Column("Demand / capacity", "-", "number"),
        Column("PGA at capacity", "g", "number"),
        Column("Verdict", kind="verdict"),
        Column("Case"),
    )
    caption = (
        f"{swept_key(sweep)}: rocking parameters of the branch that uplifts first, and the answer that decides; where "
        f"none does, the worst of all checks of a code at all levels.{JOINTS if on_joints(sweep) else ''}"
    )
    return Table(name, caption, columns, tuple(_row(sweep, place) for place in range(len(sweep.value))))


def on_joints(sweep: SweepResult) -> list[tuple[Column, Sequence[float | None]]]:
    """Return the columns that deformable joints add to the table, with their values [n], where any are known."""
    columns: list[tuple[Column, Sequence[float | None]]] = [
        (Column("φₒᵥ on joints", "rad", "number"), sweep.overturning_flexible_rad),
        (Column("Elastic frequency", "Hz", "number"), sweep.elastic_frequency_hz),
    ]
    return [(column, values) for column, values in columns if any(value is not None for value in values)]


def _row(sweep: SweepResult, place: int) -> tuple[Cell, ...]:
    ratio: Cell = OVERTURNED if sweep.overturned[place] else sweep.demand_capacity[place]
    mark = "controls" if place == sweep.controlling else ""
    return (
        sweep.value[place],
        sweep.p_eq_per_s[place],
        uplift_cell(sweep.uplift_multiplier[place]),
        sweep.overturning_rad[place],
        *(values[place] for _, values in on_joints(sweep)),
        sweep.restitution[place],
        ratio,
        sweep.capacity_pga_g[place],
        sweep.outcome[place].value,
        mark,
    )


def controlling_cases(sweeps: Sequence[SweepResult], names: dict[str, str]) -> list[Block]:
    """State the cases that represent swept mechanisms in the comparison; `names`: mechanism -> title."""
    cases = [f"{names[s.mechanism]}, {swept_key(s)} = {controlling_case(s)}" for s in sweeps if s.governs]
    if not cases:
        return []
    return [
        Text(
            (
                (
                    "Mechanisms with parametric studies are represented here by their controlling case: "
                    f"{'; '.join(cases)}."
                ),
            )
        )
    ]


def weakest_direction(mechanism: MechanismResult, *, name: str) -> list[Block]:
    """Return sentence and figure on the weakest direction, where it was searched for."""
    found = mechanism.direction_sweep
    if found is None:
        return []
    caption = "Load multiplier λ that starts rotation towards each horizontal direction; the dot marks the weakest."
    figure = Figure(f"{name}-directions", caption, partial(directions_figure.draw, found))
    return [Text((direction_sentence(found),)), figure]


def direction_sentence(found: DirectionSweep) -> str:
    """State the direction chosen, and how flat the minimum is."""
    return (
        f"The direction is the weakest of {len(found.angle_deg)}: {as_given(round(found.weakest_deg, 3))}° "
        "from +x towards +y. The load multiplier is within 1 % of its minimum over "
        f"{as_given(found.flat_deg)}° of the circle; the minimum is "
        f"{numeral(100 * found.variation, digits=3)} % below the maximum."
    )
