"""Suites that meet the rules of a code: selection proposes, the code judges.

What may be changed in between are the factor on the records, their number, and records that break a rule by themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import log

import numpy as np

from records.candidates import PERIODS, Candidate
from records.compliance import SelectionRules, linear_weights
from records.compliance.suite import Requirement, RequirementKind, check_limit, suite_of
from records.errors import RecordError
from records.record import Record
from records.scaling import Band, band
from records.selection import ScaledRecording, Selection, SuiteCriteria, misfit_of_mean, select
from spectra.spectrum import Spectrum

MOST_MORE = 8  # records more than wanted, up to which suites are tried
ABOVE = 1e-9  # by which factors are raised, so that rounding does not miss a limit
HELP = "add records, or widen the filters or scale_limits"


@dataclass(frozen=True)
class SuiteTarget:
    """What a suite is judged by.

    spectrum : that records are selected and scaled for
    rules : spectrum that the code compares the suite with; of another limit state its PGA may be another
    shortest, longest : periods of the mechanisms, used as T_1 [s]
    """

    spectrum: Spectrum
    rules: Spectrum
    shortest: float
    longest: float

    @property
    def periods(self) -> dict[str, float]:
        """The periods of the mechanisms by name [s]."""
        return {"shortest": self.shortest, "longest": self.longest}


@dataclass(frozen=True)
class _Trial:
    selection: Selection
    found: tuple[Requirement, ...]

    @property
    def missed(self) -> tuple[Requirement, ...]:
        return tuple(one for one in self.found if one.verdict == "not met")

    @property
    def gap(self) -> float:
        """How far the rules are missed: the sum of the logarithms of value over limit."""
        return sum(abs(log(max(one.value or 0.0, 1e-9) / one.limit)) for one in self.missed)


def band_for(making: SelectionRules, target: SuiteTarget) -> Band:
    """Return the periods over which the records are fitted, as far as the target is known, with the code's weights.

    Parameters
    ----------
    making : of the code
    target : with the periods of the mechanisms
    """
    low, high = making.interest(**target.periods)
    ends = max(low, float(PERIODS[0])), min(high, target.spectrum.longest_period, float(PERIODS[-1]))
    even = band(*ends)
    return band(*ends, weights=linear_weights(even.period.tolist())) if making.own_factors else even


def select_for(
    candidates: Sequence[Candidate],
    making: SelectionRules,
    target: SuiteTarget,
    criteria: SuiteCriteria,
    *,
    read: Callable[[Candidate], Record],
) -> Selection:
    """Select a suite that meets the rules of a code which can be answered; its choices have the factors to be used.

    The number wanted is tried first, or the least of the code if that is more; then more, then fewer.

    Parameters
    ----------
    candidates : records of catalogues and files
    making : of the code
    target : spectrum and periods
    criteria : what is wanted
    read : reads the record of a candidate

    Raises
    ------
    RecordError : no suite does; says how many candidates are left after each step, and the nearest miss
    """
    if making.own_factors and (criteria.components != "single" or criteria.scale_to != "spectrum"):
        raise RecordError(
            f'{making.code} finds the factor of each record; leave components "single", scale_to "spectrum"'
        )
    narrowed = _narrow(criteria, making)
    known: dict[tuple[str, int], Record] = {}

    def record_of(one: Candidate) -> Record:
        key = (one.path, one.position)
        if key not in known:
            known[key] = read(one)
        return known[key]

    trials: list[_Trial] = []
    few: RecordError | None = None
    for count in _counts(criteria.count, making.least):
        try:
            trial = _try(candidates, making, target, replace(narrowed, count=count), record_of)
        except RecordError as error:
            few = few or error
            continue
        if not trial.missed:
            return trial.selection
        trials.append(trial)
    if not trials:
        raise RecordError(f"no suite meets {making.code}: {few}")
    raise RecordError(_nearest(min(trials, key=lambda each: (len(each.missed), each.gap)), making))


def _narrow(criteria: SuiteCriteria, making: SelectionRules) -> SuiteCriteria:
    """Return the criteria within the limits that the code sets to each record."""
    (low, high), (least, most) = criteria.scale_limits, making.record_factors
    return replace(criteria, scale_limits=(max(low, least), min(high, most)), largest_misfit=making.record_misfit)


def _counts(wanted: int, least: int) -> Iterator[int]:
    first = max(wanted, least)
    yield from range(first, first + MOST_MORE + 1)
    yield from range(first - 1, least - 1, -1)


def _try(
    candidates: Sequence[Candidate],
    making: SelectionRules,
    target: SuiteTarget,
    criteria: SuiteCriteria,
    record_of: Callable[[Candidate], Record],
) -> _Trial:
    """Select, replace records that break a rule by themselves, and find the factors that the code asks for."""
    left, share = list(candidates), target.rules.pga / target.spectrum.pga
    while True:
        found = select(left, target.spectrum, criteria)
        parts = [(choice, one) for choice in found.choices for one in choice.components]
        factors = np.array([choice.factor for choice, _ in parts])
        suite = suite_of([record_of(one) for _, one in parts], (factors * share).tolist(), target.rules)
        unfit = making.unfit(suite, **target.periods)
        if not unfit.any():
            break
        gone = {id(one) for (_, one), bad in zip(parts, unfit, strict=True) if bad}
        left = [one for one in left if id(one) not in gone]
    asked = making.factors(suite, **target.periods)
    further = np.ones(factors.size) if asked is None else asked / suite.factor
    further = np.where(further == 1.0, 1.0, further * (1.0 + ABOVE))
    scaled = replace(
        suite, factor=suite.factor * further, spectra=suite.spectra * further[:, np.newaxis], pga=suite.pga * further
    )
    raised = {id(choice): float(f) for (choice, _), f in zip(parts, further, strict=True)}
    choices = tuple(replace(choice, factor=choice.factor * raised[id(choice)]) for choice in found.choices)
    misfit = misfit_of_mean(choices, target.spectrum, criteria.band)
    limits = _scale_limits(making, choices, criteria)
    return _Trial(replace(found, choices=choices, misfit=misfit), (*making.found(scaled, **target.periods), *limits))


def _scale_limits(
    making: SelectionRules, choices: Sequence[ScaledRecording], criteria: SuiteCriteria
) -> tuple[Requirement, ...]:
    """Return that factors stay within the limits of the selection; a code with limits of its own has checked them."""
    if making.own_factors:
        return ()
    factors, (low, high) = [choice.factor for choice in choices], criteria.scale_limits
    return (
        check_limit(making.code, "scale_limits", RequirementKind.FACTOR, "least scale factor", min(factors), ">=", low),
        check_limit(
            making.code, "scale_limits", RequirementKind.FACTOR, "largest scale factor", max(factors), "<=", high
        ),
    )


def _nearest(trial: _Trial, making: SelectionRules) -> str:
    """Return why no suite meets a code: what the nearest one misses, and what was there to choose from."""
    misses = "; ".join(map(_miss, trial.missed))
    steps = ", ".join(f"{number} {step}" for step, number in trial.selection.counted)
    number = sum(len(choice.components) for choice in trial.selection.choices)
    return f"no suite meets {making.code}; the nearest, of {number} records, misses {misses}; there are {steps}: {HELP}"


def _miss(one: Requirement) -> str:
    over = "" if one.periods is None else f" over {one.periods[0]:.3g} s to {one.periods[1]:.3g} s"
    return f"{one.clause}, {one.what}{over}: {one.value:.4g}, limit {one.sense} {one.limit:.4g}"
