"""The two tables of the page of a mechanism: its parameters, branch by branch, and its answers."""

from __future__ import annotations

from collections.abc import Callable

from assess.codes.check import Check, Outcome
from assess.codes.verdict import Answer
from assess.results import MechanismResult, OscillatorResult, Results
from reports import governing
from reports.chapters.cells import (
    ALLOWABLE,
    BRANCHES,
    CAPACITY_PGA,
    DEMAND,
    METHOD,
    NONE,
    OUTCOME,
    RATIO,
    ROLES,
    capacity_cell,
    capacity_pga_cell,
    demand_cell,
    demand_or_rest,
    outcome_cell,
    ratio_cell,
)
from reports.document import Cell, Column, Table
from reports.language.texts import Text, say
from reports.titles import check_title

Parameter = tuple[Column, Callable[[OscillatorResult], Cell]]


def _share_of_mass(mechanism: MechanismResult) -> float | None:
    """Return the fraction of participating mass e* of the kinematic analyses; None without one."""
    steps = (step for check in mechanism.checks for step in check.steps if step.symbol == "e*")
    return next((step.value for step in steps), None)


def _shown(results: Results, mechanism: MechanismResult) -> list[Parameter]:
    """Return the eight parameters that an engineer checks by hand."""
    joint = mechanism.oscillator.overturning_flexible_rad is not None
    return [
        (Column(say("Mass M"), "mass"), lambda of: of.mass_kg if _has_mass(results, mechanism) else None),
        (Column(say("Radius R"), "length"), lambda of: of.radius_m),
        (Column(say("Slenderness α"), "rotation"), lambda of: of.slenderness_rad),
        (Column(say("Frequency parameter p"), "angular frequency"), lambda of: of.p_eq_per_s),
        _on_joints() if joint else _at_uplift(),
        (Column(say("Overturning φₒᵥ"), "rotation"), lambda of: of.overturning_rad),
        (Column(say("Restitution η"), "ratio"), lambda of: of.restitution),
        *_last(results, mechanism),
    ]


def _has_mass(results: Results, mechanism: MechanismResult) -> bool:
    """Return whether the mass is known: that of an equivalent block is a unit mass unless the project gives it."""
    given = results.project.get(f"mechanisms.{mechanism.name}.mass")
    return mechanism.kind != "equivalent-block" or (given is not None and given.given)


def _at_uplift() -> Parameter:
    def multiplier(of: OscillatorResult) -> Cell:
        return NONE if of.uplift_multiplier is None else of.uplift_multiplier

    return Column(say("Multiplier at uplift λ"), "ratio"), multiplier


def _on_joints() -> Parameter:
    return Column(say("Overturning on its joints"), "rotation"), lambda of: of.overturning_flexible_rad


def _last(results: Results, mechanism: MechanismResult) -> list[Parameter]:
    """Return the fraction of participating mass, or the longest equivalent period where no analysis has that."""
    share, motion = _share_of_mass(mechanism), results.ground_motion
    if share is not None:
        return [(Column(say("Participating share e*"), "ratio"), lambda _: share)]
    periods = () if motion is None else motion.equivalent_periods
    longest = next((one.longest_s for one in periods if one.mechanism == mechanism.name), None)
    return [] if longest is None else [(Column(say("Equivalent period"), "time"), lambda _: longest)]


def parameters(results: Results, mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the parameters, a row for each branch; one row where both are alike."""
    shown = _shown(results, mechanism)
    rows: list[tuple[Cell, ...]] = []
    for title, branch in (("positive", mechanism.oscillator), ("negative", mechanism.oscillator_negative)):
        if branch is not None:
            rows.append((BRANCHES[title], *(value(branch) for _, value in shown)))
    if len(rows) == 2 and rows[0][1:] == rows[1][1:]:
        rows = [(say("both"), *rows[0][1:])]
    caption = say("Rocking parameters of each branch, that is, direction of rotation.")
    return Table(name, caption, (Column(say("Branch")), *(column for column, _ in shown)), tuple(rows), small=True)


def shown_checks(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    """Return the worst check of each method and limit state at the site's own action, those that decide first."""
    worst = governing.worst_per_procedure(governing.at_site(results, mechanism))
    applicable = (check for check in worst if check.verdict != Outcome.NOT_APPLICABLE)
    return tuple(sorted(applicable, key=lambda check: (check.reading == "thesis", check.role != "deciding")))


def answers(results: Results, mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the answers at the site's own action, a row for each method and limit state."""
    shown = shown_checks(results, mechanism)
    columns = (METHOD, Column(say("Role")), DEMAND, ALLOWABLE, RATIO, CAPACITY_PGA, OUTCOME)
    own = governing.verdict_of(results, mechanism)
    rows = tuple(_row(check, shown, () if own is None else own.answers) for check in shown)
    muted = frozenset(place for place, check in enumerate(shown) if check.reading == "thesis")
    return Table(name, _caption(results), columns, rows, muted, small=True)


def _caption(results: Results) -> Text:
    if governing.site_pga(results) is None:
        return say("The worst answer of each method; D/C: demand over capacity.")
    return say(
        "Answers at the site’s own action; D/C: demand over capacity. Only a method that decides counts in the verdict."
    )


def _row(check: Check, among: tuple[Check, ...], answers: tuple[Answer, ...]) -> tuple[Cell, ...]:
    return (
        check_title(check, among),
        ROLES[check.role],
        demand_or_rest(check, demand_cell(check)),
        capacity_cell(check),
        ratio_cell(check),
        capacity_pga_cell(check),
        outcome_cell(check, answers),
    )
