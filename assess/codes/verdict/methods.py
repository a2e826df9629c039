"""Which limit states decide, and by which methods, as the project asks its basis."""

from __future__ import annotations

from assess.codes.basis import Acceptance, Basis, LimitState, Method, Role
from assess.codes.verdict.question import Action, Missing, Question, either, missing_input
from assess.messages.message import Value, message
from spectra.ntc import EXCEEDANCE

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
        why = message("missing-limit-state", {"states": either(names)})
        return (), (missing_input("verdict.limit_state", why, f'limit_state = "{names[0]}"'),)
    return (*chosen, *_besides(basis, question.use_class)), ()


def _declared(basis: Basis, action: Action) -> str:
    """Return the limit state that the site's own action belongs to; empty where none is declared."""
    return next((state.name for state in basis.chosen if action.limit_state in state.actions), "")


def _besides(basis: Basis, use_class: str | None) -> tuple[LimitState, ...]:
    every = (state for state in basis.states if state.role == Role.BESIDES)
    return tuple(state for state in every if use_class is None or use_class in state.classes)


def requested_methods(state: LimitState, question: Question) -> tuple[str, ...]:
    """Return the procedures that may decide a limit state, in order of refinement."""
    return tuple(method.procedure for rank in requested_ranks(state, question.procedures) for method in rank)


def methods_of(question: Question) -> tuple[str, ...]:
    """Return the procedures that may decide any limit state, each once; none without a basis."""
    states, _ = find_limit_states(question)
    return tuple(dict.fromkeys(method for state in states for method in requested_methods(state, question)))


def requested_ranks(state: LimitState, named: tuple[str, ...] | None) -> tuple[Rank, ...]:
    """Return the methods of each rank that the project asks for; where it names none, those accepted without a name.

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
    if named is None or (not names and state.role == Role.BESIDES):
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
    of_state: dict[str, Value] = {"state": state.name, "states": either(state.actions)}
    if action.over_periods:
        if any(each in EXCEEDANCE for each in state.actions):
            return None
        return missing_input("site.spectrum", message("missing-spectrum-of-state", of_state))
    if action.limit_state is None:
        why = message("missing-state-of-spectrum", of_state)
    else:
        of_state["given"] = action.limit_state
        if state.role == Role.BESIDES:  # two limit states decide: one spectrum cannot be that of both
            return missing_input("site.spectrum.hazard", message("missing-hazard", of_state))
        why = message("missing-action-of-state", of_state)
    return missing_input("site.limit_state", why, f'limit_state = "{state.actions[0]}"')
