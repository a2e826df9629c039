"""The two states of a project: as typed, and with every value replaced that helps and that no source vouches for.

What a value is worth is found with it alone replaced, by the methods that decide without histories; where histories
alone decide, by one suite at the site's action. Of a value that may help or not, the worst over its plausible range
counts, by all methods that decide where no source vouches for it, and once more beside what else is replaced: the
stated value may be the worst there. Where the worst of one mechanism is not that of another, each counts by its own.
Where a mechanism passes as typed and no source vouches for the value, histories rise in PGA until they fail, without
twins. The state in which all are replaced at once is assessed as the project itself is, and of each mechanism the worse
of the two decides.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
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
    with_mechanisms,
    worst_outcome,
)
from assess.errors import AssessError, FallingError
from assess.messages.message import Severity, Value, message
from assess.study.assessment import checks_without_twins
from assess.study.checks import decide
from assess.study.study import Replaceable, ScaledRecord, Study, needs_motions, require_spectrum
from assess.study.suites import suite_faults
from assess.study.variations import mechanisms_beside_cases, motions_of_case
from records.errors import RecordError
from spectra.errors import SpectrumError

STRUCK_OUT = ("report", "struck_out")  # where the project says which mechanisms are left out


@dataclass(frozen=True)
class Overrides:
    """The values that help.

    lines : the outcome without each; replaced : those that no source vouches for
    replaced_alone : that of them without which a mechanism comes off worst
    unvouched : those that nothing can stand for, as the case cannot be read without them, with the mechanisms that
        they bear on: a pass of these needs a source
    apart : what is replaced for mechanisms for which another value of a range is the worst, with their names
    """

    lines: tuple[Override, ...] = ()
    replaced: tuple[Replaceable, ...] = ()
    replaced_alone: tuple[Replaceable, ...] = ()
    unvouched: tuple[tuple[Replaceable, frozenset[str]], ...] = ()
    apart: tuple[tuple[tuple[Replaceable, ...], frozenset[str]], ...] = ()

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
    with_sources : whether all values with a source are tried too, beside what is struck out; what decides does not
        depend on them

    Returns
    -------
    A line for each value without which a mechanism comes off worse; and what is replaced.
    """
    tried = [
        each
        for each in study.replaceables
        if (with_sources or not each.source or each.place[:2] == STRUCK_OUT)
        and not _goes_with_another(each, study.replaceables)
    ]
    if not tried or study.question.basis is None:
        return Overrides()
    trials = _Trials(study, motions, jobs)
    overrides: list[Override] = []
    replaced: list[Replaceable] = []
    unvouched: list[tuple[Replaceable, frozenset[str]]] = []
    least: tuple[Replaceable, MechanismOutcome] | None = None
    seen = _WorstSeen()
    for _, of_one_key in groupby(tried, key=lambda value: value.key):
        each_way = [(value, trials.without(value)) for value in _values_to_try(tuple(of_one_key))]
        typed = trials.as_typed(_depth_of(each_way[0][0]))
        first = each_way[0][0]
        unread = set(first.mechanisms) - {name for _, without in each_way for name in without}
        if unread and not first.source:
            unvouched.append((first, frozenset(unread)))
        known = [(value, without) for value, without in each_way if without]
        for value, without in known if first.either_way and not first.source else ():
            seen.add(without, (value,))
        if not known and first.place[:2] == STRUCK_OUT:
            overrides.append(_override(first, {name: _unknown(name) for name in first.mechanisms}))
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
    decided: Outcomes = {}  # in the state in which all are replaced
    for key, of_one_key in groupby(either_way, key=lambda value: value.key):
        of_range = tuple(of_one_key)
        standing = next((value for value in replaced if value.key == key), None)
        others = [value for value in replaced if value.key != key]
        ways = trials.beside(others, standing, of_range)
        worst, found_there = ways.worst()
        replaced = replaced if worst is standing else [*others, *([] if worst is None else [worst])]
        if worst is not None and standing is None:
            overrides.append(_override(worst, found_there))
        if others and not any(there for _, there in ways.outcomes):  # they exclude each other
            unvouched.append((of_range[0], frozenset(of_range[0].mechanisms)))
        for tried_way, there in ways.outcomes:
            seen.add(there, (*others, *([] if tried_way is None else [tried_way])))
        decided |= found_there
    return Overrides(
        tuple(overrides),
        tuple(replaced),
        () if least is None else (least[0],),
        tuple(unvouched),
        tuple(seen.worse(than=decided)),
    )


@dataclass
class _WorstSeen:
    """The worst outcome of each mechanism that was found, and what was replaced there; none where that is nothing."""

    worst: dict[str, tuple[MechanismOutcome, tuple[Replaceable, ...]]] = field(default_factory=dict)

    def add(self, outcomes: Outcomes, values: tuple[Replaceable, ...]) -> None:
        """Add what was found with some values replaced."""
        for name, found in outcomes.items():
            if values and (name not in self.worst or is_worse(found, than=self.worst[name][0], same=0.0)):
                self.worst[name] = found, values

    def worse(self, *, than: Outcomes) -> Iterator[tuple[tuple[Replaceable, ...], frozenset[str]]]:
        """Yield what was replaced where mechanisms came off worse, with their names."""
        alike: dict[tuple[int, ...], list[str]] = {}
        for name, (found, values) in self.worst.items():
            if name in than and is_worse(found, than=than[name]):
                alike.setdefault(tuple(map(id, values)), []).append(name)
        for names in alike.values():
            yield self.worst[names[0]][1], frozenset(names)


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
    _without: dict[int, Outcomes] = field(default_factory=dict)

    @cached_property
    def as_typed(self) -> Callable[[_Depth], Outcomes]:
        """Return the outcome of each mechanism as typed, by the depth; those that are not built are left out."""
        return cache(self._as_typed)

    def _as_typed(self, depth: _Depth) -> Outcomes:
        build = partial(alone, self.study)
        if not depth.rising:
            struck = {name: MechanismOutcome(name, Decision.PASS, None) for name, _ in self.study.question.struck_out}
            return struck | self._all(self._names, build, depth)
        at_site = self.as_typed(depth._replace(rising=False))
        return at_site | self._all([name for name in self._names if self._rises(at_site.get(name))], build, depth)

    def without(self, value: Replaceable) -> Outcomes:
        """Return the outcome without a value of each mechanism that it bears on and that can be built so."""
        if id(value) not in self._without:
            self._without[id(value)] = self._all(value.mechanisms, value.study_at, _depth_of(value))
        return self._without[id(value)]

    def beside(
        self, others: Sequence[Replaceable], standing: Replaceable | None, each_way: tuple[Replaceable, ...]
    ) -> _Ways:
        """Return the outcomes with each value of a key, and with that typed, where other keys are replaced.

        A row of a table that helps makes no difference beside an ordinate that helps as much, and the reverse; and the
        worst stiffness of a strong joint is not that of a weak one.

        Parameters
        ----------
        others : what is replaced at other keys
        standing : what stands for this key, None where it is as typed
        each_way : the values of the key that can
        """
        depth, names = _depth_of(each_way[0]), each_way[0].mechanisms

        def outcomes(value: Replaceable | None) -> Outcomes:
            if others:
                return self._replaced(others, value, names, depth)
            if value is not None:
                return self.without(value)
            return {name: found for name, found in self.as_typed(depth).items() if name in names}

        return _Ways(standing, tuple((value, outcomes(value)) for value in (None, *each_way)), each_way[0].same)

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
        found = self._all([name for name in names if name in standing], partial(alone, there), depth)
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


@dataclass(frozen=True)
class _Ways:
    """The outcomes with each value of one key, None for the one typed.

    standing : that stands for it; outcomes : with each; same : share by which a margin may fall without being worse
    """

    standing: Replaceable | None
    outcomes: tuple[tuple[Replaceable | None, Outcomes], ...]
    same: float

    def worst(self) -> tuple[Replaceable | None, Outcomes]:
        """Return the worst value and the outcomes with it; the one that stands where none is worse."""
        worst = self.standing
        found = now = next((there for value, there in self.outcomes if value is worst), {})
        for value, there in self.outcomes:
            if not now or not there or value is self.standing:
                continue
            if (
                _any_worse(there, than=found, same=self.same)
                if worst is None
                else is_worse(_least(there), than=_least(found), same=self.same)
            ):
                worst, found = value, there
        return worst, found


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

    What is replaced may help one mechanism and harm another, as a period does: each counts by the worse of the two.

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
    as_typed = {each.mechanism: each for each in typed.mechanisms}
    worse = worse_in(typed, replaced)
    other = [each if each.mechanism in worse else as_typed[each.mechanism] for each in replaced.mechanisms]
    return replace(
        with_worse(replaced, typed),
        state=State.REPLACED,
        other_state=OtherState(worst_outcome(each.outcome for each in other), tuple(map(outcome_of, other))),
        overrides=overrides,
    )


def worse_in(other: Verdict, found: Verdict) -> frozenset[str]:
    """Return the mechanisms of another state that come off worse there than was found."""
    there = {each.mechanism: outcome_of(each) for each in found.mechanisms}
    return frozenset(
        each.mechanism for each in other.mechanisms if is_worse(outcome_of(each), than=there[each.mechanism])
    )


def with_worse(found: Verdict, other: Verdict) -> Verdict:
    """Return a verdict with the mechanisms of another state that come off worse there."""
    worse = {each.mechanism: each for each in other.mechanisms if each.mechanism in worse_in(other, found)}
    mechanisms = [worse.get(each.mechanism, each) for each in found.mechanisms]
    return with_mechanisms(found, mechanisms) if worse else found


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
    """Return whether some mechanism, or the building, comes off worse where values are replaced than as typed."""
    before = {each.mechanism: outcome_of(each) for each in typed.mechanisms}
    return RANKS.index(replaced.outcome) > RANKS.index(typed.outcome) or any(
        is_worse(outcome_of(one), than=before[one.mechanism]) for one in replaced.mechanisms
    )


@dataclass(frozen=True)
class _CheckedMechanism:
    name: str
    checks: tuple[Check, ...]


def only(study: Study, names: Collection[str]) -> Study:
    """Return a study of some of its mechanisms, in every case of its sweeps too, without samples."""
    sweeps = (
        replace(sweep, cases=tuple(replace(case, study=only(case.study, names)) for case in sweep.cases))
        for sweep in study.sweeps
    )
    return replace(
        study,
        mechanisms=tuple(each for each in study.mechanisms if each.name in names),
        falling=tuple(each for each in study.falling if each.name in names),
        variables=tuple(each for each in study.variables if each.mechanism in names),
        sweeps=tuple(sweep for sweep in sweeps if sweep.cases[0].study.mechanisms),
        sampling=None,
    )


def alone(study: Study, name: str) -> Study:
    """Return a study of one of its mechanisms that stands.

    Parameters
    ----------
    study : of several
    name : of the mechanism
    """
    return replace(only(study, {name}), falling=())


def _as_swept(study: Study) -> Iterator[Study]:
    """Yield a study of one mechanism in each case of its sweeps, and as it is unless one of these is so."""
    if not study.sweeps or mechanisms_beside_cases(study.sweeps):
        yield replace(study, sweeps=())
    yield from (case.study for sweep in study.sweeps for case in sweep.cases)


def _unknown(name: str) -> MechanismOutcome:
    return MechanismOutcome(name, Decision.INCOMPLETE, None)


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

    A swept one comes off as the worst of its cases.

    Parameters
    ----------
    name, build : of the mechanism; builds the study by that
    whole, motions : the study that it varies, and the motions of that
    jobs : number of threads
    by_all : whether by all methods that decide; else by those without histories, where there are any
    rising : whether histories rise in PGA until they fail; else they are run at the site's action alone
    """
    try:
        cases = tuple(_as_swept(build(name)))
    except FallingError:
        return _falling(name)
    except (AssessError, RecordError, SpectrumError):
        return None
    find = partial(_outcome_of_case, name, whole=whole, motions=motions, jobs=jobs, by_all=by_all, rising=rising)
    return reduce(_worse_outcome, map(find, cases))


def _outcome_of_case(
    name: str,
    study: Study,
    *,
    whole: Study,
    motions: tuple[ScaledRecord, ...],
    jobs: int,
    by_all: bool,
    rising: bool,
) -> MechanismOutcome:
    """Return the outcome of a mechanism in a study of it alone; see `_outcome`."""
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
