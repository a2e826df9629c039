"""The two states of a project: as typed, and with every value replaced that helps and that no source vouches for.

What a value is worth is found with it alone replaced, by the methods that decide without histories; where histories
alone decide, by one suite at the site's action. Of a value that may help or not, the worst over its plausible range
counts, by all methods that decide where no source vouches for it, and once more beside what else is replaced: the
stated value may be the worst there. Where a mechanism passes as typed and no source vouches for the value, histories
rise in PGA until they fail, without twins. The state in which all are replaced at once is assessed as the project
itself is, and the worse of the two decides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial, reduce
from itertools import groupby
from typing import NamedTuple

from assess.codes.check import Check
from assess.codes.procedures import uses_histories
from assess.codes.question import Missing, merge_missing, methods_of, missing_input
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
from assess.messages.message import Severity, Value, message
from assess.study.assessment import checks_without_twins
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
    unvouched : those that nothing can stand for, as the case cannot be read without them, with the mechanisms that
        they bear on: a pass of these needs a source
    """

    lines: tuple[Override, ...] = ()
    replaced: tuple[Replaceable, ...] = ()
    replaced_alone: tuple[Replaceable, ...] = ()
    unvouched: tuple[tuple[Replaceable, frozenset[str]], ...] = ()

    @property
    def sources_needed(self) -> Mapping[str, tuple[Missing, ...]]:
        """The sources without which mechanisms may not pass, by the name of the mechanism."""
        found: dict[str, tuple[Missing, ...]] = {}
        for value, names in self.unvouched:
            words: dict[str, Value] = {"key": value.key, "value": value.value}
            why = message("source-needed", words, severity=Severity.WARNING)
            line = missing_input(f"report.sources.{value.key}", why)
            found |= {name: (*found.get(name, ()), line) for name in names}
        return found


def find_overrides(
    study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int, with_sources: bool = True
) -> Overrides:
    """Find the values that help, and which are to be replaced at once, as no source vouches for them.

    A value whose sense is known is replaced even where it makes no difference alone, as it may hide another.

    Parameters
    ----------
    study : the project as typed
    motions : its records
    jobs : number of threads; 0 for all cores
    with_sources : whether values with a source are tried too; what decides does not depend on them

    Returns
    -------
    A line for each value without which a mechanism comes off worse; and what is replaced.
    """
    tried = [
        each
        for each in study.replaceables
        if (with_sources or not each.source) and not _goes_with_another(each, study.replaceables)
    ]
    if not tried or study.question.basis is None:
        return Overrides()
    trials = _Trials(study, motions, jobs)
    overrides: list[Override] = []
    replaced: list[Replaceable] = []
    unvouched: list[tuple[Replaceable, frozenset[str]]] = []
    least: tuple[Replaceable, MechanismOutcome] | None = None
    for _, of_one_key in groupby(tried, key=lambda value: value.key):
        each_way = [(value, trials.without(value)) for value in _values_to_try(tuple(of_one_key))]
        typed = trials.as_typed(_depth_of(each_way[0][0]))
        first = each_way[0][0]
        unread = set(first.mechanisms) - {name for _, without in each_way for name in without}
        if unread and not first.source:
            unvouched.append((first, frozenset(unread)))
        known = [(value, without) for value, without in each_way if without]
        if not known or (unread and first.source):
            continue
        value, without = reduce(_worse_way, known)
        helps = _any_worse(without, than=typed, same=value.same)
        if not value.source and (helps or not value.either_way):
            replaced.append(value)
            for found in without.values():
                least = (value, found) if least is None or is_worse(found, than=least[1]) else least
        if helps:
            overrides.append(_override(value, without))
    either_way = [value for value in tried if value.either_way and not value.source]
    for key, of_one_key in groupby(either_way, key=lambda value: value.key):
        standing = next((value for value in replaced if value.key == key), None)
        others = [value for value in replaced if value.key != key]
        worst, found_there = trials.worst_beside(others, standing, tuple(of_one_key))
        replaced = replaced if worst is standing else [*others, *([] if worst is None else [worst])]
        if worst is not None and standing is None:
            overrides.append(_override(worst, found_there))
    return Overrides(tuple(overrides), tuple(replaced), () if least is None else (least[0],), tuple(unvouched))


class _Depth(NamedTuple):
    """How a mechanism is tried: by all methods that decide or the least work; its histories at rising PGA or once."""

    by_all: bool
    rising: bool


def _depth_of(value: Replaceable) -> _Depth:
    """Return how a value is tried: by all methods where the worst of its range is not known beforehand."""
    return _Depth(value.of_range and not value.source, not value.source)


def _values_to_try(of_one_key: tuple[Replaceable, ...]) -> tuple[Replaceable, ...]:
    """Return what is tried in place of a value: beside one with a source, which stands, the first of its range."""
    return of_one_key[:1] if of_one_key[0].source else of_one_key


Outcomes = dict[str, MechanismOutcome]
"""The outcome of each mechanism by its name."""
_Way = tuple[Replaceable, Outcomes]


@dataclass(frozen=True)
class _Trials:
    """Outcomes of a study's mechanisms with other values, each tried as deeply as what it is compared with."""

    study: Study
    motions: tuple[ScaledRecord, ...]
    jobs: int

    @cached_property
    def as_typed(self) -> Callable[[_Depth], Outcomes]:
        """Return the outcome of each mechanism as typed, by the depth; those that are not built are left out."""
        return cache(self._as_typed)

    def _as_typed(self, depth: _Depth) -> Outcomes:
        build = partial(_alone, self.study)
        if not depth.rising:
            return self._all(self._names, build, depth)
        at_site = self.as_typed(depth._replace(rising=False))
        return at_site | self._all([name for name, found in at_site.items() if self._rises(found)], build, depth)

    def without(self, value: Replaceable) -> Outcomes:
        """Return the outcome without a value of each mechanism that it bears on and that can be built so."""
        return self._all(value.mechanisms, value.study_at, _depth_of(value))

    def worst_beside(
        self, others: Sequence[Replaceable], standing: Replaceable | None, each_way: tuple[Replaceable, ...]
    ) -> tuple[Replaceable | None, Outcomes]:
        """Return which value of a key is the worst where other keys are replaced, None for the one typed.

        A row of a table that helps makes no difference beside an ordinate that helps as much, and the reverse; and the
        worst stiffness of a strong joint is not that of a weak one.

        Parameters
        ----------
        others : what is replaced at other keys
        standing : what stands for this key there, None where it is as typed
        each_way : the values of the key that can

        Returns
        -------
        That value and the outcomes with it; `standing` where none is worse
        """
        depth, names = _depth_of(each_way[0]), each_way[0].mechanisms
        now = self._replaced(others, standing, names, depth) if others else {}
        if not now:
            return standing, {}
        worst, found = standing, now
        for value in (None, *each_way):
            if value is standing:
                continue
            there = self._replaced(others, value, names, depth)
            if there and (
                _any_worse(there, than=found, same=each_way[0].same)
                if worst is None
                else is_worse(_least(there), than=_least(found), same=each_way[0].same)
            ):
                worst, found = value, there
        return worst, found

    @property
    def _names(self) -> tuple[str, ...]:
        return tuple(each.name for each in self.study.mechanisms)

    def _replaced(
        self, others: Sequence[Replaceable], value: Replaceable | None, names: Sequence[str], depth: _Depth
    ) -> Outcomes:
        """Return the outcomes of some mechanisms with several values replaced; none where that cannot be read."""
        if self.study.replaced is None:
            return {}
        try:
            there = self.study.replaced((*others, *([] if value is None else [value])))
        except (AssessError, RecordError, SpectrumError):
            return {}
        standing = {each.name for each in there.mechanisms}
        found = self._all([name for name in names if name in standing], partial(_alone, there), depth)
        return found | {name: _falling(name) for name in names if name not in standing}

    def _all(self, names: Sequence[str], build: Callable[[str], Study], depth: _Depth) -> Outcomes:
        every = {name: self._one(name, build, depth) for name in names}
        return {name: found for name, found in every.items() if found is not None}

    def _one(self, name: str, build: Callable[[str], Study], depth: _Depth) -> MechanismOutcome | None:
        """Return the outcome of a mechanism; at rising PGA only where it passes as typed at the site's."""
        rising = depth.rising and self._rises(self.as_typed(depth._replace(rising=False)).get(name))
        return _outcome(
            name,
            build,
            whole=self.study,
            motions=self.motions,
            jobs=self.jobs,
            by_all=depth.by_all,
            rising=rising,
        )

    def _rises(self, typed: MechanismOutcome | None) -> bool:
        """Return whether histories of a mechanism rise in PGA, by its outcome as typed at the site's."""
        return self.study.scan and typed is not None and typed.outcome == Decision.PASS


def _any_worse(outcomes: Outcomes, *, than: Outcomes, same: float) -> bool:
    """Return whether some mechanism comes off worse."""
    return any(is_worse(found, than=than[name], same=same) for name, found in outcomes.items() if name in than)


def _worse_way(one: _Way, other: _Way) -> _Way:
    """Return that of two values in place of one of which some mechanism comes off worst."""
    return other if is_worse(_least(other[1]), than=_least(one[1]), same=0.0) else one


def _least(outcomes: Outcomes) -> MechanismOutcome:
    """Return the worst of some outcomes."""
    return reduce(_worse_outcome, outcomes.values())


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


def require_sources(found: Verdict, overrides: Overrides) -> Verdict:
    """Return a verdict in which nothing passes by a value without a source that nothing can stand for."""
    needed = overrides.sources_needed
    mechanisms = tuple(
        replace(
            one,
            outcome=Decision.INCOMPLETE,
            at_the_limit=False,
            provisional=None,
            missing=merge_missing((*one.missing, *needed[one.mechanism])),
        )
        if one.outcome == Decision.PASS and one.mechanism in needed
        else one
        for one in found.mechanisms
    )
    if mechanisms == found.mechanisms:
        return found
    outcome = worst_outcome(one.outcome for one in mechanisms)
    missing = merge_missing((*found.missing, *(each for one in mechanisms for each in one.missing)))
    at_the_limit = found.at_the_limit and outcome == found.outcome
    return replace(
        found, mechanisms=mechanisms, outcome=outcome, missing=missing, at_the_limit=at_the_limit, provisional=None
    )


def decides(replaced: Verdict, typed: Verdict) -> bool:
    """Return whether the state in which values are replaced decides, as it is worse than the project as typed."""
    if replaced.outcome != typed.outcome:
        return RANKS.index(replaced.outcome) > RANKS.index(typed.outcome)
    before = {each.mechanism: outcome_of(each) for each in typed.mechanisms}
    return any(is_worse(outcome_of(one), than=before[one.mechanism]) for one in replaced.mechanisms)


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
    rising: bool,
) -> MechanismOutcome | None:
    """Return the outcome of a mechanism in a study of it alone; one that falls fails. None if not built.

    Parameters
    ----------
    name, build : of the mechanism; builds the study by that
    whole, motions : the study that it varies, and the motions of that
    jobs : number of threads
    by_all : whether by all methods that decide; else by those without histories, where there are any
    rising : whether histories rise in PGA until they fail; else they are run at the site's action alone
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
        checks = checks_without_twins(asked, require_spectrum(study), there, jobs=jobs, with_scan=rising)
    except FallingError:
        return _falling(name)
    except (AssessError, RecordError, SpectrumError):
        return MechanismOutcome(name, Decision.INCOMPLETE, None)
    (found,) = decide(asked, [_CheckedMechanism(name, checks)]).mechanisms
    return outcome_of(found)


def _goes_with_another(value: Replaceable, others: Sequence[Replaceable]) -> bool:
    """Return whether the table of a value, such as a tie, is left out whole by another that has the same source.

    Of several keys whose lack leaves out one table, the first stands for all.
    """
    first = next(each.key for each in others if each.place == value.place and each.source == value.source)
    return first != value.key or any(
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
        is_value=value.is_value,
        of_range=value.of_range,
        outcome_instead=worst_outcome(each.outcome for each in outcomes.values()),
        source=value.source,
        margin_instead=None if None in margins else min(each for each in margins if each is not None),
        index_instead=reduce(_worse_outcome, outcomes.values()).index,
    )


def _other_state(found: Verdict) -> OtherState:
    return OtherState(found.outcome, tuple(map(outcome_of, found.mechanisms)))
