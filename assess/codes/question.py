"""What the project asks of its basis: limit states, methods and target of the index, and the inputs it lacks."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from assess.codes.bases import Acceptance, Basis, LimitState, LimitStateRole, Method
from assess.codes.check import Check, Family, Outcome, Reason
from assess.codes.procedures import PROCEDURES
from assess.messages.message import Message, Value, distinct, message
from assess.short_repr import ShortRepr
from spectra.ntc import EXCEEDANCE

SOURCES = "report.sources"
"""The key of a missing source; a table whose own keys are keys of the file."""
Works = Literal["none", "local", "improvement", "upgrading", "repair"]


@dataclass(frozen=True, repr=False)
class Missing(ShortRepr):
    """An input without which there is no answer: its key in the project file, why, and a line of TOML to begin with.

    text : why, the English of `why`
    reasons : those whose texts are part of why
    enlarges : whether the demand may be larger with it than the numbers without it have
    """

    key: str
    text: str
    toml: str = ""
    reasons: tuple[Message, ...] = ()
    why: tuple[Message, ...] = ()
    enlarges: bool = False


@dataclass(frozen=True, repr=False)
class Action(ShortRepr):
    """The action of the site's own spectrum.

    pga_g : its peak ground acceleration [g]
    limit_state : that of a single spectrum, None where it is not declared
    over_periods : whether the site gives its hazard over return periods, so that each limit state has its own spectrum
    """

    pga_g: float
    limit_state: str | None
    return_period_years: float | None = None
    over_periods: bool = False


@dataclass(frozen=True)
class StateBefore:
    """The building before the works, by the results of its own run.

    path : of their file, as the project names it
    index : of the building, the larger of its two states'; None where a mechanism has no answer
    indices : of each mechanism, by name; None where that has no answer
    is_as_written : whether the list in the folder of that file shows it to be as the program wrote it
    differences : values of its project and of this one that differ, by their keys
    """

    path: str
    index: float | None
    indices: Mapping[str, float | None]
    is_as_written: bool = True
    differences: tuple[Message, ...] = ()


@dataclass(frozen=True)
class Question:
    """What the project asks of its basis.

    basis : None where none is named and the site has no default
    limit_state, procedures : as the project names them; None where it does not
    works, use_class, school, upgrading, index_before, before : of the targets of NTC 8.4
    target_nbs : share of the new building standard to be reached [%], of NZSEE 2017
    missing : what the whole project lacks, without which its numbers stand for no action
    provisional : what a provisional value stands for, with which its numbers are computed
    struck_out : mechanisms that the engineer leaves out, each with the reason
    """

    basis: Basis | None
    action: Action
    limit_state: str | None = None
    procedures: tuple[str, ...] | None = None
    works: Works = "none"
    use_class: str | None = None
    school: bool | None = None
    upgrading: str | None = None
    index_before: float | None = None
    before: StateBefore | None = None
    target_nbs: float | None = None
    missing: tuple[Missing, ...] = ()
    provisional: tuple[Missing, ...] = ()
    struck_out: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class MechanismChecks:
    """One mechanism as the verdict sees it.

    missing : what a pass needs and is not given; conditions : what a pass depends on
    tolerance : the relative change of the index when the survey's tolerance goes the bad way [-]
    provisional : what a provisional value stands for: with it neither a pass nor a failure is shown
    """

    name: str
    checks: tuple[Check, ...]
    missing: tuple[Missing, ...] = ()
    conditions: tuple[Message, ...] = ()
    tolerance: float = 0.0
    provisional: tuple[Missing, ...] = ()


VerdictFacts = tuple[tuple[Missing, ...], tuple[Message, ...]]
"""What the pass of a mechanism needs and is not given, and what it depends on."""


def missing_input(
    key: str, why: Message, toml: str = "", *, reasons: tuple[Message, ...] = (), enlarges: bool = False
) -> Missing:
    """Return an input that is missing.

    Parameters
    ----------
    key : of the project file
    why : it is needed
    toml : a line to begin with
    reasons : of the checks that need it
    enlarges : whether the demand may be larger with it than the numbers without it have
    """
    return Missing(key, why.text, toml, reasons, (why,), enlarges)


def merge_missing(missing: Sequence[Missing]) -> tuple[Missing, ...]:
    """Return each missing key once, with all its reasons."""
    groups: dict[str, list[Missing]] = {}
    for each in missing:
        groups.setdefault(each.key, []).append(each)
    return tuple(
        replace(
            group[0],
            text="; ".join(dict.fromkeys(each.text for each in group)),
            toml=_line_of(group),
            reasons=distinct(reason for each in group for reason in each.reasons),
            why=distinct(why for each in group for why in each.why),
            enlarges=any(each.enlarges for each in group),
        )
        for group in groups.values()
    )


Rank = tuple[Method, ...]


def find_limit_states(question: Question) -> tuple[tuple[LimitState, ...], tuple[Missing, ...]]:
    """Find the limit states that decide, and what is missing to know them.

    One is chosen for the building; others decide besides it in some classes of use. Where the class is not given, those
    others are checked too, and one that fails makes the verdict incomplete.
    """
    basis = question.basis
    if basis is None:
        return (), ()
    name = question.limit_state or basis.default or _declared(basis, question.action)
    chosen = tuple(state for state in basis.chosen if state.name == name)
    if not chosen:
        names = [state.name for state in basis.chosen]
        why = message("missing-limit-state", {"states": _join_with_or(names)})
        return (), (missing_input("verdict.limit_state", why, f'limit_state = "{names[0]}"'),)
    return (*chosen, *_additional_states(basis, question.use_class)), ()


def methods_of(question: Question) -> tuple[str, ...]:
    """Return the procedures that may decide any limit state, each once; none without a basis."""
    states, _ = find_limit_states(question)
    return tuple(dict.fromkeys(method for state in states for method in _requested_methods(state, question)))


def requested_ranks(state: LimitState, named: tuple[str, ...] | None) -> tuple[Rank, ...]:
    """Return the methods of each rank that the project requests; where it names none, those accepted without a name.

    A limit state that decides besides the chosen one keeps its own methods where the project names none of them.

    Parameters
    ----------
    state : of the basis
    named : procedures of `[verdict]`; None where it names none

    Returns
    -------
    tuple of ranks
    """
    every = [method for rank in state.ranks for method in rank]
    names = set(named or ()) & {method.procedure for method in every}
    if named is None or (not names and state.role == LimitStateRole.BESIDES):
        names = {method.procedure for method in every if method.acceptance == Acceptance.ACCEPTED}
    ranks = (tuple(m for m in rank if m.procedure in names and not names & set(m.yields_to)) for rank in state.ranks)
    return tuple(rank for rank in ranks if rank)


def missing_action(state: LimitState, action: Action) -> Missing | None:
    """Return what is missing where a single spectrum is not declared for a limit state, which then it cannot decide.

    A hazard over return periods has the spectra of the Italian limit states, and of no other code's.

    Parameters
    ----------
    state : of the basis
    action : of the site

    Returns
    -------
    Missing or None
    """
    if not state.actions or action.limit_state in state.actions:
        return None
    of_state: dict[str, Value] = {"state": state.name, "states": _join_with_or(state.actions)}
    if action.over_periods:
        if any(each in EXCEEDANCE for each in state.actions):
            return None
        return missing_input("site.spectrum", message("missing-spectrum-of-state", of_state))
    if action.limit_state is None:
        why = message("missing-state-of-spectrum", of_state)
    else:
        of_state["given"] = action.limit_state
        if state.role == LimitStateRole.BESIDES:  # two limit states decide: one spectrum cannot be that of both
            return missing_input("site.spectrum.hazard", message("missing-hazard", of_state))
        why = message("missing-action-of-state", of_state)
    return missing_input("site.limit_state", why, f'limit_state = "{state.actions[0]}"')


KeyLine = tuple[str, str]
"""A key, with the mechanism's name for {}, and a line of TOML."""
FILTER: KeyLine = ("mechanisms.{}.amplification", 'amplification = { method = "modal-filter" }')
HEIGHT: KeyLine = ("building.height", 'height = "9 m"')
STOREYS: KeyLine = ("building.storeys", "storeys = 2")
GROUND: KeyLine = ("building.ground_elevation", "ground_elevation = 0.0")
BASE: KeyLine = ("mechanisms.{}.base_elevation", "")
SEAT: KeyLine = ("mechanisms.{}.loads", '# in the load: seat = "0.12 m"')
RECORDS: KeyLine = ("records.files", 'files = ["records/*.AT2"]')
TABLE: KeyLine = ("site.spectrum.file", "")

AT_HEIGHT: Mapping[Family, tuple[KeyLine, ...]] = {
    Family.LINEAR: (HEIGHT, STOREYS),
    Family.DISPLACEMENT: (HEIGHT, STOREYS),
    Family.ELEMENT: (HEIGHT,),
    Family.PART: (HEIGHT,),
    Family.HISTORY: (FILTER,),
    Family.ENERGY: (FILTER,),
    Family.FRICTION: (FILTER,),
}

REMEDIES: Mapping[Reason, tuple[KeyLine, ...]] = {
    Reason.SCALAR_MOTION: (FILTER,),
    Reason.GROUND_UNKNOWN: (GROUND,),
    Reason.GROUND_CONTRADICTED: (BASE,),
    Reason.STOREY_UNKNOWN: (HEIGHT, STOREYS),
    Reason.ABOVE_BUILDING: (HEIGHT, GROUND),
    Reason.SEAT_UNKNOWN: (SEAT,),
    Reason.TOO_FEW_RECORDS: (RECORDS,),
    Reason.SPECTRUM_TOO_SHORT: (TABLE,),
}


def missing_keys(mechanism: str, checks: Sequence[Check]) -> tuple[Missing, ...]:
    """Return the keys that would answer these checks of a mechanism; its own table where no key is known.

    A reason that names its key has it in `where`.

    Parameters
    ----------
    mechanism : its name
    checks : those that are not answered

    Returns
    -------
    tuple of Missing
    """
    return tuple(missing for check in checks for missing in _missing_of_check(mechanism, check))


def toml_lines(missing: Sequence[Missing], given: Collection[str]) -> tuple[str, ...]:
    """Return the missing keys as TOML to paste, table by table.

    Parameters
    ----------
    missing : the missing inputs
    given : keys that the project file gives, written with dots; a table that is already there is marked

    Returns
    -------
    tuple of str
    """
    tables: dict[str, list[str]] = {}
    for each in missing:
        if each.toml:
            tables.setdefault(table_of(each.key), []).append(each.toml)
    lines: list[str] = []
    for table, keys in tables.items():
        lines += [
            _table_heading(table) + _heading_remark(table, given),
            *(line for key in keys for line in key.splitlines()),
        ]
    return tuple(lines)


def table_of(key: str) -> str:
    """Return the table that a missing key belongs to; for a line of the sources that is the key itself."""
    return key if key == SOURCES else key.rpartition(".")[0]


def _join_with_or(names: Sequence[str]) -> Message | str:
    """Return names with "or" between them."""
    first, *others = names
    return first if not others else message("either", {"first": first, "second": _join_with_or(others)})


def _line_of(group: Sequence[Missing]) -> str:
    """Return the line of a key; of the sources, which are many under one key, the lines of all."""
    lines = list(dict.fromkeys(each.toml for each in group))
    return "\n".join(lines) if group[0].key == SOURCES else lines[0]


def _declared(basis: Basis, action: Action) -> str:
    """Return the limit state that the site's own action belongs to; empty where none is declared."""
    return next((state.name for state in basis.chosen if action.limit_state in state.actions), "")


def _additional_states(basis: Basis, use_class: str | None) -> tuple[LimitState, ...]:
    every = (state for state in basis.states if state.role == LimitStateRole.BESIDES)
    return tuple(state for state in every if use_class is None or use_class in state.classes)


def _requested_methods(state: LimitState, question: Question) -> tuple[str, ...]:
    """Return the procedures that may decide a limit state, in order of refinement."""
    return tuple(method.procedure for rank in requested_ranks(state, question.procedures) for method in rank)


def _missing_of_check(mechanism: str, check: Check) -> tuple[Missing, ...]:
    return tuple(missing for reason in _reasons_unanswered(check) for missing in _by_reason(mechanism, check, reason))


def _by_reason(mechanism: str, check: Check, reason: Message) -> tuple[Missing, ...]:
    why = message("missing-of-mechanism", {"mechanism": mechanism, "procedure": check.procedure, "reason": reason})
    if reason.where:  # of the whole project, as a suite of records is, listed once for all mechanisms
        own = reason.where.startswith("mechanisms.")
        line = str(reason.values.get("toml", ""))
        return (missing_input(reason.where, why if own else reason, line, reasons=(reason,)),)
    lines = _lines_of_reason(check, reason)
    if not lines:
        return (missing_input(f"mechanisms.{mechanism}", why, reasons=(reason,)),)
    return tuple(missing_input(key.format(mechanism), why, toml, reasons=(reason,)) for key, toml in lines)


def _reasons_unanswered(check: Check) -> tuple[Message, ...]:
    """Return why a check is not answered, or why one that fails cannot pass at a lower target; nothing of one that is.

    Further reasons whose key is known are among the remarks.
    """
    if check.verdict == Outcome.NOT_ANSWERED:
        return (check.reason, *(each for each in check.remarks if each.where or _has_remedy(each)))
    low = (each for each in check.remarks if _has_remedy(each))
    return tuple(low)[:1]


def _has_remedy(reason: Message) -> bool:
    return reason.key == Reason.GROUND_MOTION or reason.key in REMEDIES


def _lines_of_reason(check: Check, reason: Message) -> tuple[KeyLine, ...]:
    if reason.key == Reason.GROUND_MOTION:
        return AT_HEIGHT.get(PROCEDURES[check.procedure].family, ())
    return next((lines for key, lines in REMEDIES.items() if key == reason.key), ())


def _heading_remark(table: str, given: Collection[str]) -> str:
    """Return a remark for the heading of a table that the file has, or may have."""
    within = [key.removeprefix(f"{table}.") for key in given if key.startswith(f"{table}.")]
    own = bool(within) if table == SOURCES else any("." not in key for key in within)
    if own:
        return "  # in your file already: add below it"
    return "  # where this heading is in your file already, add below it" if within else ""


def _table_heading(table: str) -> str:
    """Return the heading of a table of the project file, a name given by the user quoted where TOML needs it."""
    first, _, name = table.partition(".")
    plain = first not in TABLES_OF_NAMES or _BARE.fullmatch(name)
    return f"[{table}]" if plain else f"[{first}.{json.dumps(name, ensure_ascii=False)}]"


TABLES_OF_NAMES = ("materials", "mechanisms", "bodies")  # tables whose entries the user names
_BARE = re.compile(r"[A-Za-z0-9_-]+")
