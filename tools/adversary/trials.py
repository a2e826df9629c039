"""What is typed at each key of each failing project, and whether an outcome that improves says why.

Keys and values come from the declarations: every choice, both truth values, and of each number its bounds, the decades
within them and what stands there less and more. A trial that the reader refuses proves nothing and is not counted.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from random import Random
from typing import Any, Literal, get_args

from assess.codes.verdict import Decision, Verdict
from assess.declaration import BOUNDS
from assess.errors import AssessError
from assess.project.build import build_to_decide
from assess.project.evidence import Key, every_key
from assess.project.key_errors import KeyPath, key_text
from assess.project.project_file import load_tree
from assess.study.run import find_verdict
from records.errors import RecordError
from spectra.errors import SpectrumError
from tools.adversary.projects import ADDED_BODIES, ADDED_BOX, ADDED_LOADS, DRAWN, HISTORIES, PROJECTS, Tables

RANKS = (Decision.FAIL, Decision.INCOMPLETE, Decision.PASS)
BETTER = 1.01
"""A margin that rises by no more than 1 % has not improved."""
OF_EVERY_PASS = ("premise-", "not-scanned", "dbe-by-asce7", "return-period-unstated", "top-held")
"""How the keys of conditions begin that every pass of one of the projects has, whatever is typed: they tell nothing.

By their action, by their kind, and of histories without a scan.
"""
DECADES = tuple(10.0**power for power in range(-4, 10))
SHARES = (0.5, 0.8, 1.25, 2.0)
STEPS = (-3.0, -0.3, 0.3, 3.0)
"""By which the numbers of a place or direction are moved, one at a time."""
BESIDE = ("KEY", "format", "analysis.sweep", "analysis.uncertainty", "analysis.fragility", "analysis.risk")
"""Keys of what stands beside the verdict, or is tried at its own key."""
OF_HISTORIES = (
    "records.",
    "analysis.equation",
    "mechanisms.wall.restitution",
    "mechanisms.wall.amplification",
    "building.",
)
"""How the keys begin that bear on histories alone, or differently on them."""
OF_IMPACTS = ("restitution", "interface")
"""What is typed at these keys of a mechanism as one value or as a table."""
WORDS = {
    "site.limit_state": ("SLO", "SLD", "SLV", "SLC", "DBE", "ULS", "NCR", "BSE-1E", "BSE-2E", "LS", "CP"),
    "verdict.limit_state": ("SLD", "SLV", "SLC", "DBE", "ULS", "LS", "CP"),
}
"""What is typed at keys that take a name from a list of the program's."""


@dataclass(frozen=True)
class Trial:
    """A value typed at a key of a project, or at two keys at once."""

    project: str
    path: KeyPath
    value: Any
    kind: str
    other: Trial | None = None

    def __str__(self) -> str:
        typed = f"{key_text(self.path)} = {self.value!r}"
        return f"{self.project}: {typed} ({self.kind})" + (f" and {self.other}" if self.other else "")

    @property
    def paths(self) -> tuple[KeyPath, ...]:
        """The keys at which it types."""
        return (self.path,) if self.other is None else (self.path, *self.other.paths)


@dataclass(frozen=True)
class Answer:
    """What the program says of a project: outcome, margin, and the keys that it says this hangs on."""

    outcome: Decision
    margin: float | None
    named: frozenset[str]

    def __str__(self) -> str:
        return f"{self.outcome} {'?' if self.margin is None else format(self.margin, '.3g')}"

    def improves(self, other: Answer) -> bool:
        """Return whether the outcome is better than another, or a pass has a margin higher by more than 1 %."""
        if self.outcome != other.outcome:
            return RANKS.index(self.outcome) > RANKS.index(other.outcome)
        known = self.margin is not None and other.margin is not None
        return self.outcome == Decision.PASS and known and self.margin > BETTER * other.margin  # type: ignore[operator]


def trials(projects: Mapping[str, Tables] = PROJECTS) -> Iterator[Trial]:
    """Yield every trial of a single key, project by project."""
    for name, tables in projects.items():
        for key in every_key():
            if (
                key.evidence is None
                or key.evidence.kind == "defines"
                or key.path.startswith(("KEY", "report.", "format"))
            ):
                continue
            for path in _paths(key.path.split("."), tables, ()):
                for value in _values(key, _at(tables, path)):
                    yield Trial(name, path, value, key.evidence.kind)


def pairs(singles: Sequence[Trial], count: int, *, seed: int) -> list[Trial]:
    """Return so many pairs of trials at two keys of one table of a project, drawn by a seed: what one check reads."""
    tables: dict[tuple[str, KeyPath], list[Trial]] = {}
    for trial in singles:
        tables.setdefault((trial.project, trial.path[:-1]), []).append(trial)
    of_two_keys = [each for each in tables.values() if len({trial.path for trial in each}) > 1]
    draw, found = Random(seed), []
    while len(found) < count:
        one, other = draw.sample(draw.choice(of_two_keys), 2)
        if one.path != other.path:
            found.append(replace(one, other=other))
    return found


def geometry() -> Iterator[Trial]:
    """Yield what is drawn in other places, or added, in each project with geometry; and its joints and impacts."""
    for name, tables in PROJECTS.items():
        for mechanism, section in tables["mechanisms"].items():
            if "blocks" not in section:
                continue
            for key, values in DRAWN.items():
                yield from (Trial(name, ("mechanisms", mechanism, key), value, "drawn") for value in values)
            loads = section.get("loads", [])
            for load in ADDED_LOADS:
                yield Trial(name, ("mechanisms", mechanism, "loads"), [*loads, load], "loads")
            height = float(tables["bodies"]["wall"]["box"].get("base", [0.0])[-1])
            for base in ADDED_BODIES:
                box = {**ADDED_BOX, "base": [*base[:2], base[2] + height]}
                body = Trial(name, ("bodies", "added"), {"material": "stone", "box": box}, "drawn")
                blocks = Trial(name, ("mechanisms", mechanism, "blocks"), ["wall", "added"], "drawn")
                yield replace(blocks, other=body)


def sample(chosen: Sequence[Trial], count: int, *, seed: int) -> list[Trial]:
    """Return so many of the trials, drawn by a seed."""
    return Random(seed).sample(chosen, count)


def histories() -> Iterator[Trial]:
    """Yield the trials of keys that bear on histories alone, and of joints and impacts."""
    yield from (trial for trial in trials(HISTORIES) if key_text(trial.path).startswith(OF_HISTORIES))
    for name, tables in HISTORIES.items():
        for mechanism in tables["mechanisms"]:
            for key in OF_IMPACTS:
                yield from (Trial(name, ("mechanisms", mechanism, key), value, "measured") for value in DRAWN[key])


EVERY = {**PROJECTS, **HISTORIES}
REFUSED, SAME, TOLD, SILENT = "refused", "same", "told", "SILENT"


def outcome_of(trial: Trial) -> tuple[str, str]:
    """Return what becomes of a trial, and how the outcome changes where it improves."""
    before = _answer_as_it_is(trial.project)
    after = answer(with_trial(EVERY[trial.project], trial))
    if after is None:
        return REFUSED, ""
    if not after.improves(before):
        return SAME, ""
    return TOLD if is_told(trial, before, after) else SILENT, f"{before} -> {after}"


@cache
def _answer_as_it_is(name: str) -> Answer:
    found = answer(EVERY[name])
    assert found is not None
    return found


def answer(tables: Tables) -> Answer | None:
    """Return what the program says of a project; None where it refuses the project."""
    try:
        study = build_to_decide(load_tree(copy.deepcopy(tables), Path("project.toml"), sha256=""))
        found = find_verdict(study, jobs=1)
    except (AssessError, RecordError, SpectrumError):
        return None
    margins = [each.margin for each in found.mechanisms]
    known = [margin for margin in margins if margin is not None]
    return Answer(found.outcome, min(known) if len(known) == len(margins) and known else None, _named(found))


def with_trial(tables: Tables, trial: Trial) -> Tables:
    """Return a project with what a trial types, and without a source for that."""
    changed = copy.deepcopy(tables) if trial.other is None else with_trial(tables, trial.other)
    sources, typed = changed["report"]["sources"], key_text(trial.path)
    changed["report"]["sources"] = {key: text for key, text in sources.items() if not f"{typed}.".startswith(f"{key}.")}
    node: Any = changed
    for step in trial.path[:-1]:
        node = node.setdefault(step, {}) if isinstance(node, dict) else node[step]
    node[trial.path[-1]] = copy.deepcopy(trial.value)
    return changed


def is_told(trial: Trial, before: Answer, after: Answer) -> bool:
    """Return whether an answer says that it hangs on what was typed: by its key, or by one more condition."""
    typed = [key_text(path) for path in trial.paths]
    keys = [each for each in after.named if not each.startswith(("condition ", "reason "))]
    return bool(after.named - before.named) or any(
        key.startswith(each) or each.startswith(key) for key in typed for each in keys
    )


def _named(found: Verdict) -> frozenset[str]:
    conditions = (*found.conditions, *(each for one in found.mechanisms for each in one.conditions))
    reasons = (each.reason for one in found.mechanisms for each in one.answers if one.outcome == Decision.INCOMPLETE)
    return frozenset(
        (
            *(f"reason {each.key}" for each in reasons),
            *(each.key for each in found.overrides),
            *(each.key for each in found.missing),
            *(f"condition {each.key}" for each in conditions if not each.key.startswith(OF_EVERY_PASS)),
        )
    )


def _paths(pattern: list[str], node: Any, above: KeyPath) -> Iterator[KeyPath]:
    """Yield the places of a key in a project, NAME and [] filled in; it may lack the last table."""
    step, *rest = pattern
    names: list[KeyPath] = [(step,)]
    if step == "NAME":
        names = [(name,) for name in node] if isinstance(node, dict) else []
    elif step.endswith("[]"):
        step = step.removesuffix("[]")
        listed = node.get(step) if isinstance(node, dict) else None
        names = [(step, place) for place in range(len(listed))] if isinstance(listed, list) else []
    for found in names:
        below = _at(node, found)
        if below is not None and rest and not isinstance(below, dict | list):
            continue
        if rest:
            yield from _paths(rest, below, (*above, *found))
        else:
            yield (*above, *found)


def _at(node: Any, path: KeyPath) -> Any:
    for step in path:
        try:
            node = node[step]
        except (KeyError, IndexError, TypeError):
            return None
    return node


def _values(key: Key, given: Any) -> Iterator[Any]:
    """Yield what is typed at a key in place of what stands there."""
    kinds = set(_kinds_of(key.field.annotation))
    choices = [each for each in kinds if isinstance(each, str)]
    yield from (each for each in sorted(choices) if each != given)
    yield from WORDS.get(key.path, ())
    if bool in kinds:
        yield from (True, False)
    if int in kinds and float not in kinds:
        yield from range(6)
        yield from (10, 100, 1000)
    if float in kinds:
        sizes = {*key.bounds.values(), *DECADES, *(-each for each in DECADES), 0.0}
        if isinstance(given, int | float):
            sizes |= {share * given for share in SHARES}
        yield from sorted(size for size in sizes if _is_within(key, size))
    if isinstance(given, list) and given and all(isinstance(each, int | float) for each in given):
        for place, each in enumerate(given):
            yield from ([*given[:place], each + step, *given[place + 1 :]] for step in STEPS)


def _is_within(key: Key, size: float) -> bool:
    return all(BOUNDS[name][0](size, bound) for name, bound in key.bounds.items())


def _kinds_of(annotation: Any) -> Iterator[Any]:
    """Yield the choices of an annotation, and bool, int, float where it takes one."""
    if hasattr(annotation, "__metadata__"):
        yield from _kinds_of(annotation.__origin__)
        return
    parts = get_args(annotation)
    if getattr(annotation, "__origin__", None) is Literal:
        yield from parts
    elif parts and getattr(annotation, "__origin__", None) in (tuple, dict):
        return
    elif parts:
        for part in parts:
            yield from _kinds_of(part)
    elif annotation in (bool, int, float):
        yield annotation
