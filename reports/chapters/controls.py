"""The automatic controls of a run: their differences side by side, and what the program says of those not met."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assess.messages.message import Message
from assess.results import Control, ControlKind, Results
from reports.chapters.mechanism_list import mechanism_list
from reports.document import Block, Cell, Column, Graded, Items, Prose, Table, nonempty
from reports.language.texts import Phrase, Term, Text, quantity, say, say_count
from reports.titles import numbered_title

TITLES: Mapping[ControlKind, Phrase] = {
    "equilibrium": say("Equilibrium of reactions"),
    "energy": say("Energy balance"),
    "hand-multiplier": say("Multiplier by hand"),
    "convergence": say("Convergence"),
}
EXACT = 1e-12  # relative difference below which a control is within rounding


def blocks(results: Results) -> list[Block]:
    """Return what was controlled, the table, and the notes on what was not made or not met."""
    if not results.controls:
        return [Prose((say("These results hold no automatic controls."),))]
    return [Prose((summary(results.controls), explanation())), *nonempty(table(results)), *_notes(results)]


def summary(controls: tuple[Control, ...]) -> Text:
    """Return how many controls are met."""
    failed = sum(each.met is False for each in controls)
    made = sum(each.met is not None for each in controls)
    if failed:
        return say_count(
            "{number} automatic control of {made} is not met: the results of its mechanism are not to be used before "
            "the cause is known.",
            "{number} automatic controls of {made} are not met: the results of their mechanisms are not to be used "
            "before the cause is known.",
            failed,
            made=quantity(made, figures=12),
        )
    if not made:
        return say("No automatic control could be made.")
    return say_count(
        "The one automatic control that could be made is met.", "All {number} automatic controls made are met.", made
    )


def explanation() -> Text:
    """Return what the controls compare."""
    return say(
        "Equilibrium compares the reactions at the hinges with weights, loads and forces of inertia as the motion "
        "starts; the energy balance compares work done and energy lost along a motion; the multiplier that starts the "
        "motion is worked out again by moments about the hinges; convergence repeats an analysis with a coarser table "
        "and coarser steps."
    )


def table(results: Results) -> Table:
    """Tabulate mechanism by control: relative differences, and both multipliers."""
    columns = (
        Column(say("Mechanism"), share=0.26),
        *(Column(_heading(results, kind)) for kind in ("equilibrium", "energy")),
        Column(say("Multiplier of the program"), "ratio", 5),
        Column(say("Multiplier by hand"), "ratio", 5),
        *(Column(_heading(results, kind)) for kind in ("hand-multiplier", "convergence")),
    )
    rows = tuple(_row(results, each.name) for each in results.mechanisms)
    caption = say("Relative differences of the automatic controls. A dash stands for a control that was not made.")
    return Table("controls", caption, columns, rows if results.controls else (), small=True)


def _heading(results: Results, kind: ControlKind) -> Text:
    """Return the title of a kind of control with its tolerance."""
    found = [each.tolerance for each in results.controls if each.kind == kind and each.tolerance > 0.0]
    if not found:
        return TITLES[kind]
    return say("{control}, at most {tolerance}", control=TITLES[kind], tolerance=quantity(max(found), figures=2))


def _row(results: Results, name: str) -> tuple[Cell, ...]:
    of = {kind: [each for each in results.controls if each.mechanism == name and each.kind == kind] for kind in TITLES}
    by_hand = next(iter(of["hand-multiplier"]), None)
    return (
        numbered_title(results, name),
        _worst(of["equilibrium"]),
        _worst(of["energy"]),
        None if by_hand is None else by_hand.value,
        None if by_hand is None else by_hand.reference,
        _worst(of["hand-multiplier"]),
        _worst(of["convergence"]),
    )


def _worst(controls: list[Control]) -> Cell:
    """Return the largest difference of some controls in the colour of their outcome; None where none was made."""
    made = [each for each in controls if each.difference is not None]
    if not made:
        return None
    worst = max(made, key=lambda each: (each.met is False, each.difference or 0.0))
    text = _difference(worst.difference or 0.0)
    if worst.met is None:
        return Graded("comparison", text)
    return Graded("pass" if worst.met else "fail", text)


def _difference(value: float) -> Text:
    return say("below {least}", least=quantity(EXACT, figures=1)) if value < EXACT else quantity(value, figures=2)


def _notes(results: Results) -> Iterator[Block]:
    """Yield what the program says of controls that were not made, not met, or need not agree, each sentence once."""
    found: dict[str, tuple[Control, Message, list[str]]] = {}
    for each in results.controls:
        if each.met is not True:
            found.setdefault(f"{each.kind} {each.note.text}", (each, each.note, []))[2].append(each.mechanism)
    if found:
        yield Items(
            tuple(
                say(
                    "{control}, {mechanisms}: {note}",
                    control=TITLES[control.kind],
                    mechanisms=mechanism_list(results, owners),
                    note=note,
                )
                for control, note, owners in found.values()
            )
        )


def control_rows(results: Results) -> Table:
    """Tabulate every control with its numbers, for the spreadsheet and the CSV files."""
    columns = (
        *(Column(label) for label in (say("Mechanism"), say("Control"), say("Quantity"))),
        Column(say("Value")),
        Column(say("Reference")),
        Column(say("Relative difference"), "ratio", 3),
        Column(say("Tolerance"), "ratio", 3),
        Column(say("Met")),
        Column(say("Note")),
    )
    rows = tuple(
        (
            numbered_title(results, each.mechanism),
            TITLES[each.kind],
            Term(each.quantity),
            None if each.value is None else quantity(each.value, each.dimension, 6),
            None if each.reference is None else quantity(each.reference, each.dimension, 6),
            each.difference,
            each.tolerance,
            each.met,
            each.note,
        )
        for each in results.controls
    )
    return Table("controls-in-full", say("Every automatic control with its numbers."), columns, rows)
