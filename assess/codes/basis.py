"""The basis of a verdict: which limit states and methods of one code decide, as data. The rules are in `verdict`."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Acceptance(StrEnum):
    """Whether a method decides of itself, or only where the project names it in `[verdict] procedures`."""

    ACCEPTED = "accepted"
    IF_NAMED = "if-named"


class Role(StrEnum):
    """When a limit state decides: as the one chosen for the building, or besides it in some classes of use."""

    CHOSEN = "chosen"
    BESIDES = "besides"


class Premise(StrEnum):
    """What a pass depends on besides its numbers."""

    SOUND_MASONRY = "sound-masonry"
    ANCHORAGE = "anchorage"
    COLLAR_JOINTS = "collar-joints"
    NO_FLOORS = "no-floors"


class IndexKind(StrEnum):
    """The measure in which a code gives its answer."""

    ZETA_E = "zeta_E"
    NBS = "%NBS"
    DEMAND_CAPACITY = "D/C"


@dataclass(frozen=True)
class Method:
    """One procedure that may decide a limit state.

    procedure : its name
    acceptance : whether it must be named
    yields_to : procedures that are never stood in for: where one of them is asked, this one is not
    """

    procedure: str
    acceptance: Acceptance = Acceptance.ACCEPTED
    yields_to: tuple[str, ...] = ()


@dataclass(frozen=True)
class LimitState:
    """One limit state of a basis.

    name : as `[verdict] limit_state` writes it
    checked_as : the limit state of the checks of its methods
    actions : what `[site] limit_state` may call the action that belongs to it
    ranks : methods in order of refinement, the most refined first; those of one rank must all pass
    role : whether it is one that may be chosen
    classes : classes of use in which it decides besides the chosen one
    """

    name: str
    checked_as: str
    actions: tuple[str, ...]
    ranks: tuple[tuple[Method, ...], ...]
    role: Role = Role.CHOSEN
    classes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Basis:
    """The rules of one code for a verdict.

    edition : how it is cited; index : the measure of the answer; states : its limit states, the default one first
    default : the limit state where none is chosen; empty where the site's own action decides it
    premises : what a pass depends on; clauses : (rule, clause) pairs for the report
    uncompared : what could not be compared with any text of the standard
    """

    name: str
    edition: str
    index: IndexKind
    states: tuple[LimitState, ...]
    default: str
    premises: tuple[Premise, ...]
    clauses: tuple[tuple[str, str], ...]
    uncompared: tuple[str, ...] = ()

    @property
    def chosen(self) -> tuple[LimitState, ...]:
        """The limit states of which one is chosen."""
        return tuple(state for state in self.states if state.role == Role.CHOSEN)

    @property
    def methods(self) -> tuple[str, ...]:
        """Every procedure that the basis accepts, in order of refinement."""
        return tuple(
            dict.fromkeys(method.procedure for state in self.states for rank in state.ranks for method in rank)
        )
