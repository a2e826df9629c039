"""Mechanisms that differ by their interface alone, compared (thesis Table 8.7)."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.check import Check
from assess.results import MechanismResult, Results
from reports import governing, joints
from reports.document import Block, Cell, Column, Table, Text
from reports.language.lettering import truncate
from reports.mechanism_title import mechanism_title

OWN = ("label", "interface", "interfaces")  # keys in which variants may differ
SHORT = 50  # characters of a name in a sentence


@dataclass(frozen=True)
class Variants:
    """Mechanisms alike but for their interfaces, each under what those are; named by the first."""

    members: dict[str, MechanismResult]

    @property
    def name(self) -> str:
        """The title of the first, for all of them."""
        return mechanism_title(next(iter(self.members.values())))


def find_variants(results: Results) -> tuple[Variants, ...]:
    """Return every group with two interfaces or more, the rigid one first, then in the order of the project."""
    groups = (_distinct(group) for group in _groups(results))
    return tuple(Variants(_by_interface(group)) for group in groups if len(group) > 1)


def earlier_variants(results: Results) -> dict[str, str]:
    """Return, for each mechanism whose bodies an earlier one has, the name of the first of these."""
    return {other.name: first.name for first, *others in _groups(results) for other in others}


def _groups(results: Results) -> list[list[MechanismResult]]:
    found: dict[frozenset[tuple[str, str]], list[MechanismResult]] = {}
    for mechanism in results.mechanisms:
        found.setdefault(definition(results, mechanism), []).append(mechanism)
    return [group for group in found.values() if len(group) > 1]


def _distinct(group: list[MechanismResult]) -> list[MechanismResult]:
    """Return the first mechanism of each interface; others with the same interface are identical."""
    found: list[MechanismResult] = []
    for mechanism in group:
        if all(mechanism.interfaces != other.interfaces for other in found):
            found.append(mechanism)
    return found


def definition(results: Results, mechanism: MechanismResult) -> frozenset[tuple[str, str]]:
    """Return what the project says of a mechanism, except its interface and label: {(key, value)}."""
    start = f"mechanisms.{mechanism.name}."
    found = ((key[len(start) :], each.value) for key, each in results.project.items() if key.startswith(start))
    same = frozenset((key, repr(value)) for key, value in found if key.partition(".")[0] not in OWN)
    return same or frozenset({("name", mechanism.name)})


def _by_interface(group: list[MechanismResult]) -> dict[str, MechanismResult]:
    members: dict[str, MechanismResult] = {}
    for mechanism in sorted(group, key=lambda each: bool(joints.deformable_joints(each))):
        model, place = joints.model_name(mechanism), 1
        while (model if place == 1 else f"{model} {place}") in members:
            place += 1
        members[model if place == 1 else f"{model} {place}"] = mechanism
    return members


def blocks(results: Results, *, name: str) -> list[Block]:
    """Return sentence and table; none where no two mechanisms differ by their interface alone."""
    groups = find_variants(results)
    if not groups:
        return []
    each = "; ".join(_sentence(group) for group in groups)
    return [Text((f"These differ by their interface alone: {each}.",)), table(groups, name=name)]


def _sentence(group: Variants) -> str:
    members = (f"{truncate(mechanism_title(mechanism), SHORT)} ({model})" for model, mechanism in group.members.items())
    return " and ".join(members)


def table(groups: tuple[Variants, ...], *, name: str) -> Table:
    """Tabulate the PGA at capacity of each procedure and mechanism, a column for each kind of interface."""
    models = tuple(dict.fromkeys(model for group in groups for model in group.members))
    every = [check for group in groups for mechanism in group.members.values() for check in mechanism.checks]
    roles = {(check.procedure, check.limit_state): check for check in every}
    columns = (Column("Procedure"), Column("Mechanism"), *(Column(model, "g", "number") for model in models))
    rows = [(check, group) for check in roles.values() for group in groups]
    caption = (
        "Peak ground acceleration at capacity, mechanism by mechanism, for each kind of interface (as thesis Table "
        "8.7). Readings of the thesis are grey."
    )
    cells = tuple(_row(check, group, models, every) for check, group in rows)
    muted = frozenset(place for place, (check, _) in enumerate(rows) if check.reading == "thesis")
    return Table(name, caption, columns, cells, muted)


def _row(check: Check, group: Variants, models: tuple[str, ...], every: list[Check]) -> tuple[Cell, ...]:
    found = (_capacity(group.members.get(model), check) for model in models)
    return (governing.procedure_label(check, tuple(every)), group.name, *found)


def _capacity(mechanism: MechanismResult | None, like: Check) -> float | None:
    """Return the least peak ground acceleration at capacity of one procedure [g]; it does not depend on the level."""
    known = () if mechanism is None else mechanism.checks
    same = [c for c in known if (c.procedure, c.limit_state) == (like.procedure, like.limit_state)]
    return min((c.capacity_pga_g for c in same if c.capacity_pga_g is not None), default=None)
