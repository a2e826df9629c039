"""Differences between two runs, as before and after a retrofit.

Mechanisms, records, files and keys are matched by name; checks by mechanism, procedure, limit state and level. What
only one run has is a difference too, with None on the other side. Curves and single histories follow from what is
compared and are left out; if only they differ, one difference names them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, fields, is_dataclass
from itertools import zip_longest
from math import isclose
from operator import attrgetter
from typing import Any, Literal, TypeVar, get_args

from assess.codes.check import Check, Outcome
from assess.codes.verdict import MechanismVerdict, Verdict, outcome_text
from assess.results.mechanism import EnvelopeResult, MechanismResult, OscillatorResult
from assess.results.run import (
    QUANTILES,
    RecordResult,
    Results,
    SensitivityResult,
    SweepResult,
    UncertainAnswer,
    UncertaintyResult,
)
from spectra.arrays import is_number

DifferenceKind = Literal[
    "verdict", "mechanism", "capacity", "ratio", "envelope", "history", "parameter", "sweep", "sensitivity",
    "uncertainty", "other", "suite", "site", "project", "input", "warning", "program",
]  # fmt: skip
KINDS: tuple[DifferenceKind, ...] = get_args(DifferenceKind)
TOLERANCE = 1e-6  # relative: differences of rounding
ZERO = 1e-12  # numbers nearer to 0 are 0


@dataclass(frozen=True)
class Difference:
    """One difference.

    kind : subject; where : the mechanism or file; what : the procedure, parameter or key
    before, after : values as in results.json, None where a run has none; unit : of numbers, empty if dimensionless
    """

    kind: DifferenceKind
    where: str
    what: str
    before: Any
    after: Any
    unit: str = ""

    @property
    def relative(self) -> float | None:
        """after / before - 1 of two numbers; None if either is not a number or `before` is 0."""
        if not (is_number(self.before) and is_number(self.after)) or self.before == 0:
            return None
        return float(self.after / self.before - 1.0)


def differences(before: Results, after: Results, *, tolerance: float = TOLERANCE) -> tuple[Difference, ...]:
    """Return every difference between two runs, the most important kinds first.

    Parameters
    ----------
    before, after : the two runs
    tolerance : relative difference up to which two numbers count as equal [-]

    Returns
    -------
    Sorted by kind, in the order of `KINDS`.
    """
    compared = (each for compare in COMPARED for each in compare(before, after))
    found = [each for each in compared if not same(each.before, each.after, tolerance=tolerance)]
    if not any(KINDS.index(each.kind) < KINDS.index("other") for each in found):
        found += _compare_other_blocks(before, after, tolerance=tolerance)
    return tuple(sorted(found, key=lambda each: KINDS.index(each.kind)))


__all__ = ["COMPARED", "KINDS", "Difference", "DifferenceKind", "differences", "same"]


def _compare_verdicts(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the verdict of the building and of each mechanism, then the outcome of each check."""
    sides = [_verdict_statements(results.verdict) for results in (before, after)]
    for (where, what), earlier, later in pairs(*sides):
        yield Difference("verdict", where, what, earlier, later)
    for one, other in _common_mechanisms(before, after):
        for name, first_check, second_check in pairs(
            _checks_by_name(one, one, other), _checks_by_name(other, one, other)
        ):
            yield Difference("verdict", one.name, name, *_of_both(attrgetter("verdict"), first_check, second_check))


def _compare_capacities(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the PGA at uplift and at capacity of each procedure [g]; they do not depend on the level."""
    for one, other in _common_mechanisms(before, after):
        sides = [{_check_name(check, one, other): check for check in each.checks} for each in (one, other)]
        for what, first, second in pairs(*sides):
            for word in ("capacity", "uplift"):
                ends = _of_both(attrgetter(f"{word}_pga_g"), first, second)
                yield Difference("capacity", one.name, f"{word}, {what}", *ends, unit="g")


def _compare_ratios(before: Results, after: Results) -> Iterator[Difference]:
    """Compare demand over capacity of each check."""
    for one, other in _common_mechanisms(before, after):
        for what, first, second in pairs(_checks_by_name(one, one, other), _checks_by_name(other, one, other)):
            yield Difference("ratio", one.name, what, *_of_both(demand_capacity, first, second))


def _compare_mechanisms(before: Results, after: Results) -> Iterator[Difference]:
    """List the mechanisms that only one run has, and compare kind, sides, label and source of restitution."""
    for name, one, other in pairs(_mechanisms_by_name(before), _mechanisms_by_name(after)):
        for what in ("kind", "sides", "label", "restitution_source"):
            if what == "kind" or (one is not None and other is not None):
                yield Difference("mechanism", name, what, *_of_both(attrgetter(what), one, other))


def _compare_parameters(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the rocking parameters of both branches, under their names in results.json."""
    for one, other in _common_mechanisms(before, after):
        for branch, key in (("positive", "oscillator"), ("negative", "oscillator_negative")):
            sides = [parameters_of(getattr(each, key)) for each in (one, other)]
            for what, first, second in pairs(*sides):
                yield Difference("parameter", one.name, f"{what}, {branch}", first, second)


def _compare_histories(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the statistics of the histories of each mechanism at each level."""
    for one, other in _common_mechanisms(before, after):
        sides = [{f"{suite.level_pga_g:.6g} g": suite for suite in each.suites} for each in (one, other)]
        for level, first, second in pairs(*sides):
            for key, what in SUITE_STATISTICS.items():
                yield Difference("history", one.name, f"{what} at {level}", *_of_both(attrgetter(key), first, second))


SUITE_STATISTICS = {
    "overturned": "records that overturn",
    "n": "records",
    "mean_ratio": "mean of max φ/φ_ov",
    "median_ratio": "median of max φ/φ_ov",
    "p84_ratio": "84 % of max φ/φ_ov",
    "max_ratio": "largest φ/φ_ov of those that stand",
}


def _compare_envelopes(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the least pulse that overturns each mechanism [g], and how many pulses of the grid do."""
    for one, other in _common_mechanisms(before, after):
        ends = one.envelope, other.envelope
        yield Difference(
            "envelope", one.name, "least pulse that overturns", *_of_both(_least_overturning_pulse, *ends), unit="g"
        )
        yield Difference("envelope", one.name, "pulses that overturn", *_of_both(_count_overturning_pulses, *ends))


def _compare_sweeps(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the answers of each case of a parametric study, and which case controls."""
    sides = [{(sweep.mechanism, sweep.key): sweep for sweep in results.sweeps} for results in (before, after)]
    for (where, key), one, other in pairs(*sides):
        controls = _of_both(lambda sweep: sweep.value[sweep.controlling], one, other)
        unit = next(sweep.unit.strip("-") for sweep in (other, one) if sweep is not None)
        yield Difference("sweep", where, f"{key} that controls", *controls, unit=unit)
        cases = ({} if sweep is None else cases_of(sweep) for sweep in (one, other))
        for (what, unit), first, second in pairs(*cases):
            yield Difference("sweep", where, what, first, second, unit=unit)


def _compare_sensitivities(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the range of each number that is varied, and the answers at both ends."""
    for number in (range_of, answers_of):
        sides = [dict(entry for row in results.sensitivity for entry in number(row)) for results in (before, after)]
        for (where, what, unit), first, second in pairs(*sides):
            yield Difference("sensitivity", where, what, first, second, unit=unit)


def _compare_uncertainties(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the uncertain numbers, the probability of failing of each answer and its quantiles."""
    sides = [{} if each.uncertainty is None else _uncertain_statements(each.uncertainty) for each in (before, after)]
    for (where, what, unit), first, second in pairs(*sides):
        yield Difference("uncertainty", where, what, first, second, unit=unit)


def _compare_suites(before: Results, after: Results) -> Iterator[Difference]:
    """Compare which records the suites have, then file, SHA-256 and scale factor of each record."""
    yield Difference("suite", "", "lock", _lock_file(before), _lock_file(after))
    sides = [{record.id: record for record in results.records} for results in (before, after)]
    if set(sides[0]) != set(sides[1]):
        yield Difference("suite", "", "records", *_of_both(lambda side: ", ".join(side) or None, *sides))
    hashes = [_sha256_by_path(results) for results in (before, after)]
    for id, one, other in pairs(*sides):
        where = f"record {id}"
        if one is not None and other is not None:
            yield Difference("suite", where, "file", one.path or None, other.path or None)
            yield Difference("suite", where, "sha256", hashes[0].get(one.path), hashes[1].get(other.path))
            yield Difference("suite", where, "made as", _making_of_record(one), _making_of_record(other))
        yield Difference("suite", where, "scale factor", *_of_both(lambda each: each.scale_factor, one, other))


def _compare_spectra(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the spectrum."""
    sides: list[dict[str, float | str]] = []
    for results in (before, after):
        one = results.spectrum
        known = {} if one is None else {"code": one.code, "pga_g": one.pga_g, "damping": one.damping, **one.parameters}
        sides.append(known)
    for what, first, second in pairs(*sides):
        yield Difference("site", "spectrum", what, first, second)


def _compare_project_values(before: Results, after: Results) -> Iterator[Difference]:
    """Compare every value of the project as used, in SI; tables and lists of tables entry by entry.

    A default is no change where the other run has no such key: an older version did not write the keys added since.
    """
    for key, one, other in pairs(before.project, after.project):
        if (one is None or other is None) and not any(each.given for each in (one, other) if each is not None):
            continue
        for entry, first, second in entries(key, *_of_both(attrgetter("value"), one, other)):
            yield Difference("project", "", entry, first, second)


def _compare_files(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the files read, by their SHA-256."""
    for path, one, other in pairs(_sha256_by_path(before), _sha256_by_path(after)):
        yield Difference("input", path, "sha256", one, other)


def _compare_warnings(before: Results, after: Results) -> Iterator[Difference]:
    """List the warnings that only one run has; one of the same words under another key is the same."""
    sides = [{(each.where, each.text): each.key for each in results.warnings} for results in (before, after)]
    for (where, text), one, other in pairs(*sides):
        yield Difference("warning", where, one or other or "", text if one else None, text if other else None)


def _compare_programs(before: Results, after: Results) -> Iterator[Difference]:
    """Compare the versions of the program."""
    yield Difference("program", before.program.name, "version", before.program.version, after.program.version)


COMPARED: tuple[Callable[[Results, Results], Iterator[Difference]], ...] = (
    _compare_verdicts,
    _compare_mechanisms,
    _compare_capacities,
    _compare_ratios,
    _compare_envelopes,
    _compare_histories,
    _compare_parameters,
    _compare_sweeps,
    _compare_sensitivities,
    _compare_uncertainties,
    _compare_suites,
    _compare_spectra,
    _compare_project_values,
    _compare_files,
    _compare_warnings,
    _compare_programs,
)


def same(one: Any, other: Any, *, tolerance: float) -> bool:
    """Return whether two values of a results file are equal but for rounding; lists and tables item by item.

    Parameters
    ----------
    one, other : the values
    tolerance : relative difference of numbers [-]
    """
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key], tolerance=tolerance) for key in one)
    if isinstance(one, list | tuple) and isinstance(other, list | tuple):
        items = zip(one, other, strict=False)
        return len(one) == len(other) and all(same(a, b, tolerance=tolerance) for a, b in items)
    if is_number(one) and is_number(other):
        return isclose(one, other, rel_tol=tolerance, abs_tol=ZERO)
    return type(one) is type(other) and bool(one == other)


def demand_capacity(check: Check) -> float | str | None:
    """Return demand over capacity, or why it is unbounded; None where the check does not apply."""
    return None if check.verdict == Outcome.NOT_APPLICABLE else check.unbounded or check.ratio


def parameters_of(oscillator: OscillatorResult | None) -> dict[str, float | None]:
    """Return the rocking parameters of one branch by name."""
    if oscillator is None:
        return {}
    return {each.name: getattr(oscillator, each.name) for each in fields(oscillator) if each.name != "linearised"}


SWEEP_COLUMNS = {
    "demand_capacity": "",
    "capacity_pga_g": "g",
    "uplift_multiplier": "",
    "p_eq_per_s": "1/s",
    "restitution": "",
}


def cases_of(sweep: SweepResult) -> dict[tuple[str, str], float | str | None]:
    """Return the answers of a parametric study, by what they answer and their unit."""
    unit = sweep.unit.replace("-", "")
    found: dict[tuple[str, str], float | str | None] = {}
    for place, value in enumerate(sweep.value):
        case = f"{sweep.key} = {value:.6g} {unit}".rstrip()
        found[f"verdict, {case}", ""] = sweep.outcome[place].value
        found |= {(f"{name}, {case}", unit): getattr(sweep, name)[place] for name, unit in SWEEP_COLUMNS.items()}
        if sweep.overturned[place]:
            found[f"demand_capacity, {case}", ""] = "overturned"
    return found


def range_of(row: SensitivityResult) -> Iterator[tuple[tuple[str, str, str], float | str | None]]:
    """Yield the low and the high value of a varied number, and the remark on it."""
    number, unit = row.key or row.parameter, row.unit.replace("-", "")
    yield (row.mechanism, f"{number}, low", unit), row.low
    yield (row.mechanism, f"{number}, high", unit), row.high
    yield (row.mechanism, f"{number}, remark", ""), row.remark or None


def answers_of(row: SensitivityResult) -> Iterator[tuple[tuple[str, str, str], float | str | None]]:
    """Yield an answer and its verdict at the low and the high value of a varied number."""
    if not row.quantity:
        return
    unit = "g" if row.quantity == "capacity_pga_g" else ""
    what = f"{row.index or row.quantity}, {answer_name(row)}, {row.key or row.parameter}"
    for side, found, verdict in (("low", row.at_low, row.verdict_low), ("high", row.at_high, row.verdict_high)):
        yield (row.mechanism, f"{what} {side}", unit), found
        yield (row.mechanism, f"verdict of {what} {side}", ""), verdict


def answer_name(answer: SensitivityResult | UncertainAnswer) -> str:
    """Return procedure, limit state and level of an answer, as far as it has them."""
    at = "" if answer.level_pga_g is None else f" at {answer.level_pga_g:.6g} g"
    return f"{answer.procedure} {answer.limit_state}".strip() + at


def entries(key: str, one: Any, other: Any) -> Iterator[tuple[str, Any, Any]]:
    """Yield two values entry by entry, with their keys, as long as both are tables or lists of tables."""
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        for name, first, second in pairs(one, other):
            yield from entries(f"{key}.{name}", first, second)
    elif _is_list_of_tables(one) and _is_list_of_tables(other):
        for place, (first, second) in enumerate(zip_longest(one, other), start=1):  # as sweeps count
            yield from entries(f"{key}[{place}]", first, second)
    else:
        yield key, _without_absent_keys(one), _without_absent_keys(other)


K = TypeVar("K")
V = TypeVar("V")


def pairs(before: Mapping[K, V], after: Mapping[K, V]) -> Iterator[tuple[K, V | None, V | None]]:
    """Yield each key with its value in either run, None where absent; keys of the first run come first."""
    for key in dict.fromkeys((*before, *after)):
        yield key, before.get(key), after.get(key)


COMPARED_IN_DETAIL = {"schema_version", "program", "inputs", "warnings", "project", "mechanisms", "stamp"}


def _compare_other_blocks(before: Results, after: Results, *, tolerance: float) -> Iterator[Difference]:
    """Yield one difference that names the blocks of results.json not compared in detail that differ, if any do."""
    blocks = _different_blocks(before, after, tolerance=tolerance)
    for one, other in _common_mechanisms(before, after):
        blocks += [f"{name} of {one.name}" for name in _different_blocks(one, other, tolerance=tolerance)]
    if blocks:
        yield Difference("other", "", "blocks that differ", None, ", ".join(blocks))


def _different_blocks(one: Any, other: Any, *, tolerance: float) -> list[str]:
    """Return the names of the fields that differ, except those compared in detail."""
    columns = ((each.name, getattr(one, each.name), getattr(other, each.name)) for each in fields(one))
    return [
        name
        for name, *ends in columns
        if name not in COMPARED_IN_DETAIL
        and ends[0] != ends[1]
        and not same(*map(_as_plain_data, ends), tolerance=tolerance)
    ]


def _as_plain_data(value: Any) -> Any:
    """Return the value with dicts in place of dataclasses."""
    if is_dataclass(value) and not isinstance(value, type):
        return asdict(value)
    return [_as_plain_data(each) for each in value] if isinstance(value, list | tuple) else value


def _checks_by_name(mechanism: MechanismResult, *runs: MechanismResult) -> dict[str, Check]:
    """Return the checks of a mechanism by procedure and level, under names that are unique within both `runs`."""
    return {f"{_check_name(check, *runs)} at {check.level_pga_g:.6g} g": check for check in mechanism.checks}


def _check_name(check: Check, *runs: MechanismResult) -> str:
    """Return the procedure of a check, with its limit state if the procedure has several in either run."""
    states = {other.limit_state for run in runs for other in run.checks if other.procedure == check.procedure}
    return f"{check.procedure} {check.limit_state}" if len(states) > 1 else check.procedure


Statements = dict[tuple[str, str], float | str | None]
"""Statements by mechanism ("" for the building) and by subject."""


def _verdict_statements(found: Verdict | None) -> Statements:
    """Return the statements of a verdict on the building and on each mechanism; empty without a verdict."""
    if found is None:
        return {}
    statements: Statements = {
        ("", "verdict"): outcome_text(found.outcome, near=found.at_the_limit),
        ("", "basis"): found.basis or None,
        ("", "limit states"): ", ".join(found.limit_states) or None,
        ("", "methods"): ", ".join(found.methods) or None,
        ("", "action, PGA"): found.action.pga_g,
        ("", "target"): found.target,
        ("", "index"): None if found.index is None else found.index.value,
        ("", "state"): found.state.value,
        ("", "rests on"): "; ".join(each.message.text for each in found.overrides) or None,
        ("", "conditions"): "; ".join(each.text for each in found.conditions) or None,
        ("", "missing"): ", ".join(each.key for each in found.missing) or None,
    }
    for one in found.mechanisms:
        statements |= _mechanism_statements(one)
    return statements


def _mechanism_statements(one: MechanismVerdict) -> Statements:
    """Return outcome and margin of one mechanism, and procedure, index and outcome of each limit state."""
    statements: Statements = {
        (one.mechanism, "verdict"): outcome_text(one.outcome, near=one.at_the_limit),
        (one.mechanism, "holds up to, over the site's PGA"): one.margin,
    }
    for answer in one.answers:
        state = f", {answer.limit_state}" if answer.limit_state else ""
        statements[one.mechanism, f"decided by{state}"] = answer.procedure or None
        statements[one.mechanism, f"index{state}"] = None if answer.index is None else answer.index.value
        statements[one.mechanism, f"answer{state}"] = outcome_text(answer.outcome, near=answer.at_the_limit)
    return statements


def _least_overturning_pulse(envelope: EnvelopeResult) -> float | None:
    """Return the least amplitude of all frequencies that overturns [g]; None if no pulse does."""
    return min((amplitude for amplitude in envelope.lower_bound_g if amplitude is not None), default=None)


def _count_overturning_pulses(envelope: EnvelopeResult) -> int:
    """Count the pulses of the grid that overturn."""
    return sum(sum(row) for row in envelope.overturned)


def _uncertain_statements(found: UncertaintyResult) -> dict[tuple[str, str, str], float | str | None]:
    """Return what is sampled and what the samples give, by mechanism, subject and unit."""
    statements: dict[tuple[str, str, str], float | str | None] = {
        ("", "samples", ""): found.samples,
        ("", "seed", ""): found.seed,
    }
    for one in found.inputs:
        statements["", f"{one.key}, mean", one.unit.replace("-", "")] = one.mean
        statements["", f"{one.key}, cov", ""] = one.cov
        statements["", f"{one.key}, distribution and group", ""] = f"{one.distribution}, {one.group}"
    for each in found.answers:
        name = answer_name(each)
        statements[each.mechanism, f"probability of failing, {name}", ""] = each.probability
        for percent, ratio in zip(QUANTILES, each.quantiles, strict=True):
            statements[each.mechanism, f"demand_capacity, {percent} %, {name}", ""] = ratio
    return statements


def _sha256_by_path(results: Results) -> dict[str, str]:
    return {each.path: each.sha256 for each in results.inputs}


def _lock_file(results: Results) -> str | None:
    motion = results.ground_motion
    return None if motion is None else motion.lock or None


def _making_of_record(record: RecordResult) -> str | None:
    """Return how an artificial record was made; None of recorded ones."""
    return None if record.path or not record.trail else record.trail[0]


def _is_list_of_tables(value: Any) -> bool:
    """Return whether a value is a list of tables only."""
    return isinstance(value, list | tuple) and all(isinstance(each, Mapping) for each in value)


def _without_absent_keys(value: Any) -> Any:
    """Return the value; a table without the keys whose value is None."""
    return {key: each for key, each in value.items() if each is not None} if isinstance(value, Mapping) else value


def _of_both(value_of: Callable[[V], Any], one: V | None, other: V | None) -> tuple[Any, Any]:
    """Return `value_of` each side, None for a side that is missing."""
    return (None if one is None else value_of(one), None if other is None else value_of(other))


def _common_mechanisms(before: Results, after: Results) -> Iterator[tuple[MechanismResult, MechanismResult]]:
    """Yield the mechanisms that both runs have, as pairs."""
    for _, one, other in pairs(_mechanisms_by_name(before), _mechanisms_by_name(after)):
        if one is not None and other is not None:
            yield one, other


def _mechanisms_by_name(results: Results) -> dict[str, MechanismResult]:
    """Return the mechanisms of a run by name."""
    return {mechanism.name: mechanism for mechanism in results.mechanisms}
