"""The two states of a project: as typed, and with every value replaced that helps and that no source vouches for.

What a value is worth is found with it alone replaced, by the methods that decide without histories; where histories
alone decide, by one suite at the site's action, without the scan. Of a value that may help or not, the worst over its
plausible range counts, by all methods that decide where no source vouches for it. The state in which all are replaced
at once is assessed as the project itself is, and the worse of the two decides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial, reduce
from itertools import groupby
from typing import Protocol

from assess.codes.check import Check
from assess.codes.procedures import uses_histories
from assess.codes.question import methods_of
from assess.codes.verdict import (
    RANKS,
    Decision,
    MechanismOutcome,
    OtherState,
    Override,
    State,
    Verdict,
    is_worse,
    outcome_of,
    worst_outcome,
)
from assess.errors import AssessError, FallingError
from assess.study.assessment import checks_without_scan
from assess.study.checks import decide
from assess.study.study import Replaceable, ScaledRecord, Study, needs_motions, require_spectrum
from assess.study.suites import suite_faults
from assess.study.variations import motions_of_case
from records.errors import RecordError
from spectra.errors import SpectrumError


@dataclass(frozen=True)
class Overrides:
    """The values that help.

    lines : the outcome without each; replaced : those that no source vouches for
    replaced_alone : that of them without which a mechanism comes off worst
    """

    lines: tuple[Override, ...] = ()
    replaced: tuple[Replaceable, ...] = ()
    replaced_alone: tuple[Replaceable, ...] = ()


def find_overrides(
    study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int, with_sources: bool = True
) -> Overrides:
    """Find the values that help, and which are to be replaced at once, as no source vouches for them.

    A value whose sense is known is replaced even where it makes no difference alone, as it may hide another.

    Parameters
    ----------
    study : Study
        The project as typed.
    motions : tuple of ScaledRecord
        Its records.
    jobs : int
        Number of threads; 0 for all cores.
    with_sources : bool
        Whether values with a source are tried too; what decides does not depend on them.

    Returns
    -------
    Overrides
        A line for each value without which a mechanism comes off worse; and what is replaced.
    """
    tried = [
        each
        for each in study.replaceables
        if (with_sources or not each.source) and not _goes_with_its_table(each, study.replaceables)
    ]
    if not tried or study.question.basis is None:
        return Overrides()
    outcome = partial(_outcome, whole=study, motions=motions, jobs=jobs)
    as_typed = cache(partial(_outcomes_as_typed, study, motions, jobs))
    overrides: list[Override] = []
    replaced: list[Replaceable] = []
    least: tuple[Replaceable, MechanismOutcome] | None = None
    for _, of_one_key in groupby(tried, key=lambda value: value.key):
        each_way = [(value, _outcomes(value, outcome)) for value in _values_to_try(tuple(of_one_key))]
        typed = as_typed(_by_all_methods(each_way[0][0]))
        known = [(value, without) for value, without in each_way if without]
        if not known:
            continue  # the project cannot be read without it: it says what the case is
        value, without = reduce(_worse_way, known)
        helps = any(
            is_worse(found, than=typed[name], same=value.same) for name, found in without.items() if name in typed
        )
        if not value.source and (helps or not value.either_way):
            replaced.append(value)
            for found in without.values():
                least = (value, found) if least is None or is_worse(found, than=least[1]) else least
        if helps:
            overrides.append(_override(value, without))
    for value, without in _hidden(study, tried, replaced, outcome):
        replaced.append(value)
        overrides.append(_override(value, without))
    return Overrides(tuple(overrides), tuple(replaced), () if least is None else (least[0],))


def _hidden(
    study: Study,
    tried: Sequence[Replaceable],
    replaced: Sequence[Replaceable],
    outcome: OutcomeOf,
) -> Iterator[_Way]:
    """Yield the values that help either way, only where what is replaced does not stand: each hides the other.

    A row of a table that helps makes no difference beside an ordinate that helps as much, and the reverse.
    """
    places = {value.key for value in replaced}
    left = [value for value in tried if value.either_way and not value.source and value.key not in places]
    if not replaced or not left or study.replaced is None:
        return
    replace_all, everything = study.replaced, tuple(each.name for each in study.mechanisms)

    def outcomes(values: Sequence[Replaceable], *, mechanisms: Sequence[str], by_all: bool) -> Outcomes:
        try:
            there = replace_all(values)
        except (AssessError, RecordError, SpectrumError):
            return {}
        standing = {each.name for each in there.mechanisms}
        every = {
            name: outcome(name, partial(_alone, there), by_all=by_all) if name in standing else _falling(name)
            for name in mechanisms
        }
        return {name: found for name, found in every.items() if found is not None}

    def outcomes_of_others(by_all: bool) -> Outcomes:
        return outcomes(replaced, mechanisms=everything, by_all=by_all)

    without_others = cache(outcomes_of_others)
    for key, of_one_key in groupby(left, key=lambda value: value.key):
        for value in of_one_key:
            by_all = _by_all_methods(value)
            without = outcomes((*replaced, value), mechanisms=value.mechanisms, by_all=by_all)
            worse = any(
                is_worse(found, than=without_others(by_all)[name], same=value.same)
                for name, found in without.items()
                if name in without_others(by_all)
            )
            if worse and key not in places:
                places.add(key)
                yield value, without


def _by_all_methods(value: Replaceable) -> bool:
    """Return whether a value is tried by all methods that decide, as the worst of its range is not known beforehand."""
    return value.of_range and not value.source


def _values_to_try(of_one_key: tuple[Replaceable, ...]) -> tuple[Replaceable, ...]:
    """Return what is tried in place of a value: beside one with a source, which stands, the first of its range."""
    return of_one_key[:1] if of_one_key[0].source else of_one_key


def _outcomes_as_typed(study: Study, motions: tuple[ScaledRecord, ...], jobs: int, by_all: bool) -> Outcomes:
    """Return the outcome of each mechanism as typed, those that are not built left out."""
    every = {
        each.name: _outcome(each.name, partial(_alone, study), whole=study, motions=motions, jobs=jobs, by_all=by_all)
        for each in study.mechanisms
    }
    return {name: found for name, found in every.items() if found is not None}


def _outcomes(value: Replaceable, outcome: OutcomeOf) -> Outcomes:
    """Return the outcome without a value of each mechanism that it bears on; empty where one cannot be built so."""
    by_all = _by_all_methods(value)
    every = {name: outcome(name, value.study_at, by_all=by_all) for name in value.mechanisms}
    without = {name: found for name, found in every.items() if found is not None}
    return without if len(without) == len(every) else {}


Outcomes = dict[str, MechanismOutcome]
"""The outcome of each mechanism by its name."""
_Way = tuple[Replaceable, Outcomes]


def _worse_way(one: _Way, other: _Way) -> _Way:
    """Return that of two values in place of one of which some mechanism comes off worst."""
    least, least_other = (reduce(_worse_outcome, way[1].values()) for way in (one, other))
    return other if is_worse(least_other, than=least, same=0.0) else one


def _worse_outcome(one: MechanismOutcome, other: MechanismOutcome) -> MechanismOutcome:
    return other if is_worse(other, than=one, same=0.0) else one


def merge_states(typed: Verdict, replaced: Verdict | None, overrides: tuple[Override, ...]) -> Verdict:
    """Return the verdict of the worse state, with the outcome of the other and the values that the verdict hangs on.

    Parameters
    ----------
    typed : of the project as typed
    replaced : of the state in which what no source vouches for is replaced; None where nothing is
    overrides : with the outcome without each
    """
    if replaced is None:
        return replace(typed, overrides=overrides)
    if not decides(replaced, typed):
        return replace(typed, other_state=_other_state(replaced), overrides=overrides)
    return replace(replaced, state=State.REPLACED, other_state=_other_state(typed), overrides=overrides)


def decides(replaced: Verdict, typed: Verdict) -> bool:
    """Return whether the state in which values are replaced decides, as it is worse than the project as typed."""
    if replaced.outcome != typed.outcome:
        return RANKS.index(replaced.outcome) > RANKS.index(typed.outcome)
    before = {each.mechanism: outcome_of(each) for each in typed.mechanisms}
    return any(is_worse(outcome_of(one), than=before[one.mechanism]) for one in replaced.mechanisms)


class OutcomeOf(Protocol):
    """Finds the outcome of a mechanism in a study of it alone, which is built by its name; None if it cannot be."""

    def __call__(self, name: str, build: Callable[[str], Study], *, by_all: bool) -> MechanismOutcome | None:
        """Find it, by all methods that decide or by the least work."""


@dataclass(frozen=True)
class _CheckedMechanism:
    name: str
    checks: tuple[Check, ...]


def _alone(study: Study, name: str) -> Study:
    return replace(study, mechanisms=tuple(each for each in study.mechanisms if each.name == name), falling=())


def _falling(name: str) -> MechanismOutcome:
    return MechanismOutcome(name, Decision.FAIL, 0.0)


def _outcome(
    name: str,
    build: Callable[[str], Study],
    *,
    whole: Study,
    motions: tuple[ScaledRecord, ...],
    jobs: int,
    by_all: bool,
) -> MechanismOutcome | None:
    """Return the outcome of a mechanism in a study of it alone; one that falls fails. None if not built.

    Parameters
    ----------
    name, build : of the mechanism; builds the study by that
    whole, motions : the study that it varies, and the motions of that
    jobs : number of threads
    by_all : whether by all methods that decide; else by those without histories, where there are any
    """
    try:
        study = build(name)
    except FallingError:
        return _falling(name)
    except (AssessError, RecordError, SpectrumError):
        return None
    try:
        methods = methods_of(study.question)
        without_histories = tuple(each for each in methods if not uses_histories(each))
        asked = replace(
            study, procedures=methods if by_all else without_histories or methods, suite_faults=whole.suite_faults
        )
        there: tuple[ScaledRecord, ...] = ()
        if needs_motions(asked):
            there = motions_of_case(study, whole, motions, jobs=jobs)
            if there is not motions:
                asked = replace(asked, suite_faults=suite_faults(study, require_spectrum(study), there))
        checks = checks_without_scan(asked, require_spectrum(study), there, jobs=jobs)
    except FallingError:
        return _falling(name)
    except (AssessError, RecordError, SpectrumError):
        return MechanismOutcome(name, Decision.INCOMPLETE, None)
    (found,) = decide(asked, [_CheckedMechanism(name, checks)]).mechanisms
    return outcome_of(found)


def _goes_with_its_table(value: Replaceable, others: Sequence[Replaceable]) -> bool:
    """Return whether the table of a value, such as a tie, is left out whole by another that has the same source."""
    return any(
        each.source == value.source
        and len(each.place) < len(value.place)
        and value.place[: len(each.place)] == each.place
        for each in others
    )


def _override(value: Replaceable, outcomes: Outcomes) -> Override:
    """Return the line of a value, with the outcomes without it of the mechanisms that it bears on."""
    margins = [each.margin for each in outcomes.values()]
    return Override(
        key=value.key,
        value=value.value,
        instead=value.instead,
        of_range=value.of_range,
        outcome_instead=worst_outcome(each.outcome for each in outcomes.values()),
        source=value.source,
        margin_instead=None if None in margins else min(each for each in margins if each is not None),
        index_instead=reduce(_worse_outcome, outcomes.values()).index,
    )


def _other_state(found: Verdict) -> OtherState:
    return OtherState(found.outcome, tuple(map(outcome_of, found.mechanisms)))
