"""What changed between two runs, as before and after a retrofit.

Things are told apart by their names: mechanisms, records, files and keys by their own, checks by mechanism, procedure,
limit state and level. What one run alone has is a change too, with nothing on the other side. Curves and single
histories follow from what is compared and are left out; where they alone differ, their names are one change.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, fields, is_dataclass
from itertools import zip_longest
from math import isclose
from operator import attrgetter
from typing import Any, Literal, TypeVar, get_args

from assess.codes.check import Check, Outcome
from assess.results import (
    EnvelopeResult,
    MechanismResult,
    OscillatorResult,
    Results,
    SensitivityResult,
    SweepResult,
)
from assess.results.verdict_statements import stated_verdict

K = TypeVar("K")
V = TypeVar("V")
Kind = Literal[
    "verdict", "mechanism", "capacity", "ratio", "envelope", "history", "parameter", "sweep", "sensitivity", "other",
    "site", "project", "input", "warning", "program",
]  # fmt: skip
TOLERANCE = 1e-6  # relative: differences of rounding
ZERO = 1e-12  # numbers nearer to 0 are 0
ELSEWHERE = {"schema_version", "program", "inputs", "warnings", "project", "mechanisms", "stamp"}
KINDS: tuple[Kind, ...] = get_args(Kind)
SUITE = {
    "overturned": "records that overturn",
    "n": "records",
    "mean_ratio": "mean of max φ/φ_ov",
    "median_ratio": "median of max φ/φ_ov",
    "p84_ratio": "84 % of max φ/φ_ov",
    "max_ratio": "largest φ/φ_ov of those that stand",
}
SWEPT = {"demand_capacity": "", "capacity_pga_g": "g", "uplift_multiplier": "", "p_eq_per_s": "1/s", "restitution": ""}


@dataclass(frozen=True)
class Change:
    """One difference.

    kind : what it is of; where : the mechanism or file; what : the procedure, parameter or key
    before, after : as results.json has them, None where that run does not have it; unit : of numbers, empty for none
    """

    kind: Kind
    where: str
    what: str
    before: Any
    after: Any
    unit: str = ""

    @property
    def relative(self) -> float | None:
        """after / before - 1 of two numbers; None where there is none."""
        if not (is_number(self.before) and is_number(self.after)) or self.before == 0:
            return None
        return float(self.after / self.before - 1.0)


def changes(before: Results, after: Results, *, tolerance: float = TOLERANCE) -> tuple[Change, ...]:
    """Every difference of more than the relative `tolerance`, those that matter most first."""
    found = (change for compare in COMPARED for change in compare(before, after))
    different = [c for c in found if not same(c.before, c.after, tolerance=tolerance)]
    if not any(KINDS.index(change.kind) < KINDS.index("other") for change in different):
        different += others(before, after, tolerance=tolerance)
    return tuple(sorted(different, key=lambda change: KINDS.index(change.kind)))


def same(one: Any, other: Any, *, tolerance: float) -> bool:
    """Whether two values of a results file are one but for rounding; lists and tables item by item."""
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key], tolerance=tolerance) for key in one)
    if isinstance(one, list | tuple) and isinstance(other, list | tuple):
        pairs = zip(one, other, strict=False)
        return len(one) == len(other) and all(same(a, b, tolerance=tolerance) for a, b in pairs)
    if is_number(one) and is_number(other):
        return isclose(one, other, rel_tol=tolerance, abs_tol=ZERO)
    return type(one) is type(other) and bool(one == other)


def others(before: Results, after: Results, *, tolerance: float) -> Iterator[Change]:
    """The blocks of results.json that differ in what is not compared one by one, in one change; none where none do."""
    blocks = different_blocks(before, after, tolerance=tolerance)
    for one, other in shared(before, after):
        blocks += [f"{name} of {one.name}" for name in different_blocks(one, other, tolerance=tolerance)]
    if blocks:
        yield Change("other", "", "blocks that differ", None, ", ".join(blocks))


def different_blocks(one: Any, other: Any, *, tolerance: float) -> list[str]:
    """The fields of two dataclasses that differ, but for those that are compared elsewhere."""
    pairs = ((each.name, getattr(one, each.name), getattr(other, each.name)) for each in fields(one))
    return [
        name
        for name, *ends in pairs
        if name not in ELSEWHERE and ends[0] != ends[1] and not same(*map(plain, ends), tolerance=tolerance)
    ]


def plain(value: Any) -> Any:
    """A value with tables in place of dataclasses."""
    if is_dataclass(value) and not isinstance(value, type):
        return asdict(value)
    return [plain(each) for each in value] if isinstance(value, list | tuple) else value


def is_number(value: Any) -> bool:
    """Whether a value is a number; true and false are none."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def paired(before: Mapping[K, V], after: Mapping[K, V]) -> Iterator[tuple[K, V | None, V | None]]:
    """What two runs have of each key, in the order of the first, then what the second alone has."""
    for key in dict.fromkeys((*before, *after)):
        yield key, before.get(key), after.get(key)


def both(of: Callable[[V], Any], one: V | None, other: V | None) -> tuple[Any, Any]:
    """What `of` finds in either, None where there is nothing to look at."""
    return (None if one is None else of(one), None if other is None else of(other))


def shared(before: Results, after: Results) -> Iterator[tuple[MechanismResult, MechanismResult]]:
    """The mechanisms that both runs have."""
    for _, one, other in paired(by_name(before), by_name(after)):
        if one is not None and other is not None:
            yield one, other


def by_name(results: Results) -> dict[str, MechanismResult]:
    """The mechanisms of a run."""
    return {mechanism.name: mechanism for mechanism in results.mechanisms}


def mechanisms(before: Results, after: Results) -> Iterator[Change]:
    """Mechanisms that one run alone has, and what they are."""
    for name, one, other in paired(by_name(before), by_name(after)):
        for what in ("kind", "sides", "label", "restitution_source"):
            if what == "kind" or (one is not None and other is not None):
                yield Change("mechanism", name, what, *both(attrgetter(what), one, other))


def verdicts(before: Results, after: Results) -> Iterator[Change]:
    """The verdict of the building, of each mechanism, then the outcome of each of its checks."""
    sides = [stated_verdict(results.verdict) for results in (before, after)]
    for (where, what), first, second in paired(*sides):
        yield Change("verdict", where, what, first, second)
    for one, other in shared(before, after):
        for name, first_check, second_check in paired(checks(one, one, other), checks(other, one, other)):
            yield Change("verdict", one.name, name, *both(attrgetter("verdict"), first_check, second_check))


def checks(mechanism: MechanismResult, *runs: MechanismResult) -> dict[str, Check]:
    """The checks of a mechanism by what they are of, told apart from all those of it in both `runs`."""
    return {f"{named(check, *runs)} at {check.level_pga_g:.6g} g": check for check in mechanism.checks}


def named(check: Check, *runs: MechanismResult) -> str:
    """The procedure of a check, with its limit state where either run has others of the same procedure."""
    states = {other.limit_state for run in runs for other in run.checks if other.procedure == check.procedure}
    return f"{check.procedure} {check.limit_state}" if len(states) > 1 else check.procedure


def capacities(before: Results, after: Results) -> Iterator[Change]:
    """PGA at uplift and at capacity of each procedure, which are one for all levels [g]."""
    for one, other in shared(before, after):
        sides = [{named(check, one, other): check for check in each.checks} for each in (one, other)]
        for what, first, second in paired(*sides):
            for word in ("capacity", "uplift"):
                ends = both(attrgetter(f"{word}_pga_g"), first, second)
                yield Change("capacity", one.name, f"{word}, {what}", *ends, unit="g")


def ratios(before: Results, after: Results) -> Iterator[Change]:
    """Demand over capacity of each check."""
    for one, other in shared(before, after):
        for what, first, second in paired(checks(one, one, other), checks(other, one, other)):
            yield Change("ratio", one.name, what, *both(ratio, first, second))


def ratio(check: Check) -> float | str | None:
    """Demand over capacity, or why there is none; None where the check does not apply."""
    return None if check.verdict == Outcome.NOT_APPLICABLE else check.unbounded or check.ratio


def envelopes(before: Results, after: Results) -> Iterator[Change]:
    """The least pulse that overturns each mechanism [g], and how many of its grid do."""
    for one, other in shared(before, after):
        ends = one.envelope, other.envelope
        yield Change("envelope", one.name, "least pulse that overturns", *both(least_pulse, *ends), unit="g")
        yield Change("envelope", one.name, "pulses that overturn", *both(overturning_pulses, *ends))


def least_pulse(envelope: EnvelopeResult) -> float | None:
    """The amplitude of the least pulse of all frequencies that overturns [g]; None where none does."""
    return min((amplitude for amplitude in envelope.lower_bound_g if amplitude is not None), default=None)


def overturning_pulses(envelope: EnvelopeResult) -> int:
    """How many pulses of the grid overturn."""
    return sum(sum(row) for row in envelope.overturned)


def histories(before: Results, after: Results) -> Iterator[Change]:
    """Statistics of the histories of each mechanism at each level."""
    for one, other in shared(before, after):
        sides = [{f"{suite.level_pga_g:.6g} g": suite for suite in each.suites} for each in (one, other)]
        for level, first, second in paired(*sides):
            for key, what in SUITE.items():
                yield Change("history", one.name, f"{what} at {level}", *both(attrgetter(key), first, second))


def parameters(before: Results, after: Results) -> Iterator[Change]:
    """The rocking parameters of both branches, under their names of results.json."""
    for one, other in shared(before, after):
        for branch, key in (("positive", "oscillator"), ("negative", "oscillator_negative")):
            sides = [numbers(getattr(each, key)) for each in (one, other)]
            for what, first, second in paired(*sides):
                yield Change("parameter", one.name, f"{what}, {branch}", first, second)


def numbers(oscillator: OscillatorResult | None) -> dict[str, float | None]:
    """The parameters of one branch."""
    if oscillator is None:
        return {}
    return {each.name: getattr(oscillator, each.name) for each in fields(oscillator) if each.name != "linearised"}


def sweeps(before: Results, after: Results) -> Iterator[Change]:
    """What each case of a parametric study comes to, and which case controls."""
    sides = [{(sweep.mechanism, sweep.key): sweep for sweep in results.sweeps} for results in (before, after)]
    for (where, key), one, other in paired(*sides):
        controls = both(lambda sweep: sweep.value[sweep.controlling], one, other)
        unit = next(sweep.unit.strip("-") for sweep in (other, one) if sweep is not None)
        yield Change("sweep", where, f"{key} that controls", *controls, unit=unit)
        cases = ({} if sweep is None else cases_of(sweep) for sweep in (one, other))
        for (what, unit), first, second in paired(*cases):
            yield Change("sweep", where, what, first, second, unit=unit)


def cases_of(sweep: SweepResult) -> dict[tuple[str, str], float | str | None]:
    """The answers of a parametric study, by what they are of and their unit."""
    unit = sweep.unit.replace("-", "")
    found: dict[tuple[str, str], float | str | None] = {}
    for place, value in enumerate(sweep.value):
        case = f"{sweep.key} = {value:.6g} {unit}".rstrip()
        found[f"verdict, {case}", ""] = sweep.outcome[place].value
        found |= {(f"{name}, {case}", unit): getattr(sweep, name)[place] for name, unit in SWEPT.items()}
        if sweep.overturned[place]:
            found[f"demand_capacity, {case}", ""] = "overturned"
    return found


def sensitivities(before: Results, after: Results) -> Iterator[Change]:
    """The range of each number that is varied, and what each answer comes to at its ends."""
    for number in (ranges_of, answers_of):
        sides = [dict(pair for row in results.sensitivity for pair in number(row)) for results in (before, after)]
        for (where, what, unit), first, second in paired(*sides):
            yield Change("sensitivity", where, what, first, second, unit=unit)


def ranges_of(row: SensitivityResult) -> Iterator[tuple[tuple[str, str, str], float | str | None]]:
    """The low and the high value of a number, and what is said of it."""
    number, unit = row.key or row.parameter, row.unit.replace("-", "")
    yield (row.mechanism, f"{number}, low", unit), row.low
    yield (row.mechanism, f"{number}, high", unit), row.high
    yield (row.mechanism, f"{number}, remark", ""), row.remark or None


def answers_of(row: SensitivityResult) -> Iterator[tuple[tuple[str, str, str], float | str | None]]:
    """An answer and its verdict at the low and the high value of a number."""
    if not row.quantity:
        return
    unit = "g" if row.quantity == "capacity_pga_g" else ""
    at = "" if row.level_pga_g is None else f" at {row.level_pga_g:.6g} g"
    of = f"{row.procedure} {row.limit_state}".strip()
    what = f"{row.index or row.quantity}, {of}{at}, {row.key or row.parameter}"
    for side, found, verdict in (("low", row.at_low, row.verdict_low), ("high", row.at_high, row.verdict_high)):
        yield (row.mechanism, f"{what} {side}", unit), found
        yield (row.mechanism, f"verdict of {what} {side}", ""), verdict


def site(before: Results, after: Results) -> Iterator[Change]:
    """The spectrum, and which records with which scale factors."""
    sides: list[dict[str, float | str]] = []
    for results in (before, after):
        one = results.spectrum
        known = {} if one is None else {"code": one.code, "pga_g": one.pga_g, "damping": one.damping, **one.parameters}
        sides.append(known)
    for what, first, second in paired(*sides):
        yield Change("site", "spectrum", what, first, second)
    scales = [{record.id: record.scale_factor for record in results.records} for results in (before, after)]
    for id, factor, other in paired(*scales):
        yield Change("site", f"record {id}", "scale factor", factor, other)


def project(before: Results, after: Results) -> Iterator[Change]:
    """Every value of the project as it was used, in SI; of tables and lists of tables each entry."""
    for key, one, other in paired(before.project, after.project):
        for entry, first, second in opened(key, *both(attrgetter("value"), one, other)):
            yield Change("project", "", entry, first, second)


def opened(key: str, one: Any, other: Any) -> Iterator[tuple[str, Any, Any]]:
    """Two values entry by entry, with their keys, as far as both are tables or lists of tables."""
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        for name, first, second in paired(one, other):
            yield from opened(f"{key}.{name}", first, second)
    elif is_list_of_tables(one) and is_list_of_tables(other):
        for place, (first, second) in enumerate(zip_longest(one, other), start=1):  # as sweeps count
            yield from opened(f"{key}[{place}]", first, second)
    else:
        yield key, stated(one), stated(other)


def is_list_of_tables(value: Any) -> bool:
    """Whether a value is a list with nothing but tables in it."""
    return isinstance(value, list | tuple) and all(isinstance(each, Mapping) for each in value)


def stated(value: Any) -> Any:
    """A value; of a table what it states, without the keys that are absent."""
    return {key: each for key, each in value.items() if each is not None} if isinstance(value, Mapping) else value


def inputs(before: Results, after: Results) -> Iterator[Change]:
    """The files that were read, by their SHA-256."""
    sides = [{each.path: each.sha256 for each in results.inputs} for results in (before, after)]
    for path, one, other in paired(*sides):
        yield Change("input", path, "sha256", one, other)


def warnings(before: Results, after: Results) -> Iterator[Change]:
    """Warnings that one run alone has."""
    sides = [{(each.key, each.where, each.text): each.text for each in results.warnings} for results in (before, after)]
    for (code, where, _), one, other in paired(*sides):
        yield Change("warning", where, code, one, other)


def program(before: Results, after: Results) -> Iterator[Change]:
    """The program that made them."""
    yield Change("program", before.program.name, "version", before.program.version, after.program.version)


COMPARED: tuple[Callable[[Results, Results], Iterator[Change]], ...] = (
    verdicts,
    mechanisms,
    capacities,
    ratios,
    envelopes,
    histories,
    parameters,
    sweeps,
    sensitivities,
    site,
    project,
    inputs,
    warnings,
    program,
)
