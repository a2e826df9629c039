"""What the project asks of its basis, and what it states about the site's action and about each mechanism."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from assess.codes.basis import Basis
from assess.codes.check import Check
from assess.messages.message import Message, message
from assess.short_repr import ShortRepr

SOURCES = "report.sources"
"""The key of a missing source; a table whose own keys are keys of the file."""
Works = Literal["none", "repair", "improvement", "upgrading"]


@dataclass(frozen=True, repr=False)
class Missing(ShortRepr):
    """An input without which there is no answer: its key in the project file, why, and a line of TOML to begin with.

    text : why, the English of `why`
    reasons : those whose texts are part of why
    """

    key: str
    text: str
    toml: str = ""
    reasons: tuple[Message, ...] = ()
    why: tuple[Message, ...] = ()


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
class Question:
    """What the project asks of its basis.

    basis : None where none is named and the site has no default
    limit_state, procedures : as the project names them; None where it does not
    works, use_class, school, upgrading, index_before : of the targets of NTC 8.4
    target_nbs : share of the new building standard to be reached [%], of NZSEE 2017
    missing : what the whole project lacks, without which its numbers stand for no action
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
    target_nbs: float | None = None
    missing: tuple[Missing, ...] = ()


@dataclass(frozen=True)
class MechanismChecks:
    """One mechanism as the verdict sees it.

    missing : what a pass needs and is not given; conditions : what a pass depends on
    tolerance : the relative change of the index when the survey's tolerance goes the bad way [-]
    """

    name: str
    checks: tuple[Check, ...]
    missing: tuple[Missing, ...] = ()
    conditions: tuple[Message, ...] = ()
    tolerance: float = 0.0


def missing_input(key: str, why: Message, toml: str = "", *, reasons: tuple[Message, ...] = ()) -> Missing:
    """Return an input that is missing.

    Parameters
    ----------
    key : of the project file
    why : it is needed
    toml : a line to begin with
    reasons : of the checks that need it
    """
    return Missing(key, why.text, toml, reasons, (why,))


def either(names: Sequence[str]) -> Message | str:
    """Return names with "or" between them."""
    first, *others = names
    return first if not others else message("either", {"first": first, "second": either(others)})


def once(missing: Sequence[Missing]) -> tuple[Missing, ...]:
    """Return each missing key once, with all its reasons."""
    groups: dict[str, list[Missing]] = {}
    for each in missing:
        groups.setdefault(each.key, []).append(each)
    return tuple(
        replace(
            group[0],
            text="; ".join(dict.fromkeys(each.text for each in group)),
            toml=_line_of(group),
            reasons=_once(reason for each in group for reason in each.reasons),
            why=_once(why for each in group for why in each.why),
        )
        for group in groups.values()
    )


def _once(reasons: Iterable[Message]) -> tuple[Message, ...]:
    return tuple({reason.text: reason for reason in reasons}.values())


def _line_of(group: Sequence[Missing]) -> str:
    """Return the line of a key; of the sources, which are many under one key, the lines of all."""
    lines = list(dict.fromkeys(each.toml for each in group))
    return "\n".join(lines) if group[0].key == SOURCES else lines[0]
