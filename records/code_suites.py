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

MOST_MORE = 8  # records beyond the number requested, up to which suites are tried
ABOVE = 1e-9  # by which factors are raised, so that rounding does not miss a limit
HELP = "add records, or widen the filters or scale_limits"


@dataclass(frozen=True)
class SuiteTarget:
    """What a suite is selected for and judged by.

    spectrum : that records are selected and scaled for
    code_spectrum : that the code compares the suite with; of another limit state its PGA may be another
    shortest, longest : periods of the mechanisms, used as T_1 [s]
    """

    spectrum: Spectrum
    code_spectrum: Spectrum
    shortest: float
    longest: float

    @property
    def periods(self) -> dict[str, float]:
        """The periods of the mechanisms by name [s]."""
        return {"shortest": self.shortest, "longest": self.longest}


@dataclass(frozen=True)
class _Trial:
    """A selection with the requirements of the code on it."""

    selection: Selection
    requirements: tuple[Requirement, ...]

    @property
    def missed(self) -> tuple[Requirement, ...]:
        """The requirements that are not met."""
        return tuple(each for each in self.requirements if each.verdict == "not met")

    @property
    def gap(self) -> float:
        """How far the rules are missed: the sum of the logarithms of value over limit."""
        return sum(abs(log(max(each.value or 0.0, 1e-9) / each.limit)) for each in self.missed)


def band_for(rules: SelectionRules, target: SuiteTarget) -> Band:
    """Return the periods over which the records are fitted, as far as the target is known, with the code's weights.

    Parameters
    ----------
    rules : of the code
    target : with the periods of the mechanisms
    """
    low, high = rules.periods_of_interest(**target.periods)
    ends = max(low, float(PERIODS[0])), min(high, target.spectrum.longest_period, float(PERIODS[-1]))
    even = band(*ends)
    return band(*ends, weights=linear_weights(even.period.tolist())) if rules.own_factors else even


def select_for(
    candidates: Sequence[Candidate],
    rules: SelectionRules,
    target: SuiteTarget,
    criteria: SuiteCriteria,
    *,
    read: Callable[[Candidate], Record],
) -> Selection:
    """Select a suite that meets the rules of a code which can be answered; its choices have the factors to be used.

    The number requested is tried first, or the least of the code if that is more; then more, then fewer.

    Parameters
    ----------
    candidates : records of catalogues and files
    rules : of the code
    target : spectrum and periods
    criteria : of the selection
    read : reads the record of a candidate

    Raises
    ------
    RecordError : no suite does; says how many candidates are left after each step, and the nearest miss
    """
    if rules.own_factors and (criteria.components != "single" or criteria.scale_to != "spectrum"):
        raise RecordError(
            f'{rules.code} finds the factor of each record; leave components "single", scale_to "spectrum"'
        )
    narrowed = _narrow(criteria, rules)
    records: dict[tuple[str, int], Record] = {}

    def record_of(candidate: Candidate) -> Record:
        key = (candidate.path, candidate.position)
        if key not in records:
            records[key] = read(candidate)
        return records[key]

    trials: list[_Trial] = []
    too_few: RecordError | None = None
    for count in _counts(criteria.count, rules.least):
        try:
            trial = _try(candidates, rules, target, replace(narrowed, count=count), record_of)
        except RecordError as error:
            too_few = too_few or error
            continue
        if not trial.missed:
            return trial.selection
        trials.append(trial)
    if not trials:
        raise RecordError(f"no suite meets {rules.code}: {too_few}")
    raise RecordError(_nearest(min(trials, key=lambda each: (len(each.missed), each.gap)), rules))


def _narrow(criteria: SuiteCriteria, rules: SelectionRules) -> SuiteCriteria:
    """Return the criteria within the limits that the code sets to each record."""
    (low, high), (least, most) = criteria.scale_limits, rules.record_factors
    return replace(criteria, scale_limits=(max(low, least), min(high, most)), largest_misfit=rules.record_misfit)


def _counts(requested: int, least: int) -> Iterator[int]:
    """Yield the numbers of records to try, in order."""
    first = max(requested, least)
    yield from range(first, first + MOST_MORE + 1)
    yield from range(first - 1, least - 1, -1)


def _try(
    candidates: Sequence[Candidate],
    rules: SelectionRules,
    target: SuiteTarget,
    criteria: SuiteCriteria,
    record_of: Callable[[Candidate], Record],
) -> _Trial:
    """Select, replace records that break a rule by themselves, and find the factors that the code asks for."""
    remaining, pga_ratio = list(candidates), target.code_spectrum.pga / target.spectrum.pga
    while True:
        selection = select(remaining, target.spectrum, criteria)
        components = [(choice, candidate) for choice in selection.choices for candidate in choice.components]
        factors = np.array([choice.factor for choice, _ in components])
        records = [record_of(candidate) for _, candidate in components]
        suite = suite_of(records, (factors * pga_ratio).tolist(), target.code_spectrum)
        unfit = rules.unfit_records(suite, **target.periods)
        if not unfit.any():
            break
        dropped = {id(candidate) for (_, candidate), bad in zip(components, unfit, strict=True) if bad}
        remaining = [candidate for candidate in remaining if id(candidate) not in dropped]
    code_factors = rules.factors(suite, **target.periods)
    further = np.ones(factors.size) if code_factors is None else code_factors / suite.factor
    further = np.where(further == 1.0, 1.0, further * (1.0 + ABOVE))
    scaled = replace(
        suite, factor=suite.factor * further, spectra=suite.spectra * further[:, np.newaxis], pga=suite.pga * further
    )
    further_of = {id(choice): float(f) for (choice, _), f in zip(components, further, strict=True)}
    choices = tuple(replace(choice, factor=choice.factor * further_of[id(choice)]) for choice in selection.choices)
    misfit = misfit_of_mean(choices, target.spectrum, criteria.band)
    limits = _scale_limits(rules, choices, criteria)
    requirements = (*rules.requirements(scaled, **target.periods), *limits)
    return _Trial(replace(selection, choices=choices, misfit=misfit), requirements)


def _scale_limits(
    rules: SelectionRules, choices: Sequence[ScaledRecording], criteria: SuiteCriteria
) -> tuple[Requirement, ...]:
    """Require that factors stay within the limits of the selection; a code with limits of its own has checked them."""
    if rules.own_factors:
        return ()
    factors, (low, high) = [choice.factor for choice in choices], criteria.scale_limits
    return (
        check_limit(rules.code, "scale_limits", RequirementKind.FACTOR, "least scale factor", min(factors), ">=", low),
        check_limit(
            rules.code, "scale_limits", RequirementKind.FACTOR, "largest scale factor", max(factors), "<=", high
        ),
    )


def _nearest(trial: _Trial, rules: SelectionRules) -> str:
    """Return why no suite meets a code: what the nearest one misses, and what was there to choose from."""
    misses = "; ".join(map(_miss, trial.missed))
    steps = ", ".join(f"{number} {step}" for step, number in trial.selection.counted)
    number = sum(len(choice.components) for choice in trial.selection.choices)
    return f"no suite meets {rules.code}; the nearest, of {number} records, misses {misses}; there are {steps}: {HELP}"


def _miss(requirement: Requirement) -> str:
    over = (
        "" if requirement.periods is None else f" over {requirement.periods[0]:.3g} s to {requirement.periods[1]:.3g} s"
    )
    limit = f"limit {requirement.sense} {requirement.limit:.4g}"
    return f"{requirement.clause}, {requirement.what}{over}: {requirement.value:.4g}, {limit}"
