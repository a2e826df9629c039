"""How the answers of each mechanism move with numbers that are not well known, each varied alone.

A case is the mechanism alone with one number at its low or its high value: through the procedures that decide, at all
levels, with its histories under all records; without the scan over rising PGA, so procedures by histories have no PGA
at capacity here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from assess.codes.basis import Basis
from assess.codes.check import Check
from assess.codes.families import uses_histories
from assess.codes.verdict.answer import index_of
from assess.errors import AssessError
from assess.mechanisms.lasting import variants
from assess.results import MechanismResult, SensitivityResult
from assess.study.checks import Progress, checks_of, context_of, further_levels, motions_at_base
from assess.study.histories import RockingCase, RockingHistories, run_levels
from assess.study.motions import ScaledRecord
from assess.study.study import Study, Unvaried, Variable
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

Answer = tuple[str, str, float]
"""What tells a check from the others of a mechanism: procedure, limit state, level [g]."""


@dataclass(frozen=True)
class Case:
    """The checks of one case, by what they answer; or why it could not be assessed."""

    checks: dict[Answer, Check]
    error: str = ""


def sensitivities(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanisms: Sequence[MechanismResult],
    *,
    jobs: int,
    progress: Progress,
) -> tuple[SensitivityResult, ...]:
    """Every variable of the study at its low and its high value, beside the `mechanisms` as assessed."""
    known = {mechanism.name: mechanism for mechanism in mechanisms}
    rows: list[SensitivityResult] = []
    for done, variable in enumerate(study.variables):
        progress("sensitivity", done, len(study.variables))
        if isinstance(variable, Unvaried):
            rows.append(unvaried_row(variable))
            continue
        deciding = tuple(
            check for check in known[variable.mechanism].checks if check.reading == "letter" and not check.informs
        )
        procedures = tuple(dict.fromkeys(check.procedure for check in deciding))
        low, high = (
            case_of(variable, value, study, procedures, spectrum, motions, jobs=jobs)
            for value in (variable.low, variable.high)
        )
        rows += rows_of(variable, deciding, low, high, basis=study.question.basis)
    return tuple(rows)


def case_of(
    variable: Variable,
    value: float,
    whole: Study,
    procedures: tuple[str, ...],
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    *,
    jobs: int,
) -> Case:
    """The mechanism with one value of the variable, through the procedures, under the suite of the whole study."""
    try:
        study = replace(variable.study_at(value), procedures=procedures, suite_faults=whole.suite_faults)
        return Case(by_answer(check_case(study, spectrum, motions, jobs=jobs)))
    except (AssessError, SpectrumError) as error:
        return Case({}, str(error))


def check_case(study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], *, jobs: int) -> tuple[Check, ...]:
    """The checks of the one mechanism of a case."""
    (mechanism,) = study.mechanisms
    base = motions_at_base(study.amplified[mechanism.name], motions)
    shaken = RockingCase(
        mechanism.name, variants(mechanism).deciding, study.equations[mechanism.name], base, mechanism.rebounds
    )
    shakes = any(map(uses_histories, study.procedures))
    levels = study.levels if shakes else ()
    rocked = RockingHistories((), ())
    if levels and motions:
        wanted = further_levels(study, spectrum, mechanism)
        rocked = run_levels(shaken, motions, levels=levels, besides=wanted, site_pga=spectrum.pga, threads=jobs)
    known = context_of(replace(study, levels=levels), spectrum, mechanism, rocked, base, motions)
    return checks_of(study, shaken.oscillator, replace(known, levels=study.levels))


def by_answer(checks: Sequence[Check]) -> dict[Answer, Check]:
    """Checks by what they answer, the first of several."""
    found: dict[Answer, Check] = {}
    for check in checks:
        found.setdefault((check.procedure, check.limit_state, check.level_pga_g), check)
    return found


def rows_of(
    variable: Variable, deciding: Sequence[Check], low: Case, high: Case, *, basis: Basis | None
) -> Iterator[SensitivityResult]:
    """The index of what decides, demand over capacity of each check, and the PGA at capacity of each limit state."""
    row = SensitivityResult(
        mechanism=variable.mechanism,
        parameter=variable.parameter,
        key=variable.key,
        unit=variable.unit,
        base=variable.base,
        low=variable.low,
        high=variable.high,
        remark=remark_of(variable, low, high),
    )
    told: set[tuple[str, str]] = set()
    for key, check in by_answer(deciding).items():
        row = replace(row, procedure=check.procedure, limit_state=check.limit_state, role=check.role)
        sides = low.checks.get(key), high.checks.get(key)
        if check.role == "deciding" and basis is not None:
            yield with_index(row, basis, check, *sides)
        if key[:2] not in told and not uses_histories(check.procedure):
            told.add(key[:2])
            yield with_capacity(row, check, *sides)
        yield with_ratio(row, check, *sides)


def with_index(
    row: SensitivityResult, basis: Basis, check: Check, low: Check | None, high: Check | None
) -> SensitivityResult:
    """The row of what the basis counts a deciding check in."""
    base, *ends = (None if each is None else index_of(each, basis) for each in (check, low, high))
    at_low, at_high = (None if end is None else end.value for end in ends)
    return replace(
        with_ratio(row, check, low, high),
        quantity="index",
        index=basis.index.value,
        at_base=None if base is None else base.value,
        at_low=at_low,
        at_high=at_high,
    )


def with_capacity(row: SensitivityResult, check: Check, low: Check | None, high: Check | None) -> SensitivityResult:
    """The row of the PGA at capacity, which is one for all levels [g]."""
    return replace(
        row,
        quantity="capacity_pga_g",
        level_pga_g=None,
        at_base=check.capacity_pga_g,
        at_low=None if low is None else low.capacity_pga_g,
        at_high=None if high is None else high.capacity_pga_g,
    )


def with_ratio(row: SensitivityResult, check: Check, low: Check | None, high: Check | None) -> SensitivityResult:
    """The row of demand over capacity at the level of a check; a body that overturns has none, and fails."""
    return replace(
        row,
        quantity="demand_capacity",
        level_pga_g=check.level_pga_g,
        at_base=check.ratio,
        at_low=None if low is None else low.ratio,
        at_high=None if high is None else high.ratio,
        verdict_base=check.verdict,
        verdict_low=None if low is None else low.verdict,
        verdict_high=None if high is None else high.verdict,
    )


def remark_of(variable: Variable, low: Case, high: Case) -> str:
    """What is to be said of a variable, and why a case of it could not be assessed."""
    failed = (("low", variable.low, low.error), ("high", variable.high, high.error))
    whys = (f"not assessed at the {side} value, {value:.6g}: {why}" for side, value, why in failed if why)
    return "; ".join(text for text in (variable.remark, *whys) if text)


def unvaried_row(unvaried: Unvaried) -> SensitivityResult:
    """The row of a number that is left as it is."""
    return SensitivityResult(
        mechanism=unvaried.mechanism, parameter=unvaried.parameter, remark=f"not varied: {unvaried.why}"
    )
