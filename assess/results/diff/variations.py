"""Differences of parametric studies and of sensitivities."""

from __future__ import annotations

from collections.abc import Iterator

from assess.results.diff.change import Change
from assess.results.diff.pairs import of_both, pairs
from assess.results.run import Results
from assess.results.sensitivity import SensitivityResult
from assess.results.sweeps import SweepResult
from assess.results.uncertainty import QUANTILES, UncertaintyResult

SWEEP_COLUMNS = {
    "demand_capacity": "",
    "capacity_pga_g": "g",
    "uplift_multiplier": "",
    "p_eq_per_s": "1/s",
    "restitution": "",
}


def sweeps(before: Results, after: Results) -> Iterator[Change]:
    """Compare the answers of each case of a parametric study, and which case controls."""
    sides = [{(sweep.mechanism, sweep.key): sweep for sweep in results.sweeps} for results in (before, after)]
    for (where, key), one, other in pairs(*sides):
        controls = of_both(lambda sweep: sweep.value[sweep.controlling], one, other)
        unit = next(sweep.unit.strip("-") for sweep in (other, one) if sweep is not None)
        yield Change("sweep", where, f"{key} that controls", *controls, unit=unit)
        cases = ({} if sweep is None else cases_of(sweep) for sweep in (one, other))
        for (what, unit), first, second in pairs(*cases):
            yield Change("sweep", where, what, first, second, unit=unit)


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


def sensitivities(before: Results, after: Results) -> Iterator[Change]:
    """Compare the range of each number that is varied, and the answers at both ends."""
    for number in (range_of, answers_of):
        sides = [dict(entry for row in results.sensitivity for entry in number(row)) for results in (before, after)]
        for (where, what, unit), first, second in pairs(*sides):
            yield Change("sensitivity", where, what, first, second, unit=unit)


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
    at = "" if row.level_pga_g is None else f" at {row.level_pga_g:.6g} g"
    of = f"{row.procedure} {row.limit_state}".strip()
    what = f"{row.index or row.quantity}, {of}{at}, {row.key or row.parameter}"
    for side, found, verdict in (("low", row.at_low, row.verdict_low), ("high", row.at_high, row.verdict_high)):
        yield (row.mechanism, f"{what} {side}", unit), found
        yield (row.mechanism, f"verdict of {what} {side}", ""), verdict


def uncertainties(before: Results, after: Results) -> Iterator[Change]:
    """Compare the uncertain numbers, the probability of failing of each answer and its quantiles."""
    sides = [{} if each.uncertainty is None else uncertain_statements(each.uncertainty) for each in (before, after)]
    for (where, what, unit), first, second in pairs(*sides):
        yield Change("uncertainty", where, what, first, second, unit=unit)


def uncertain_statements(found: UncertaintyResult) -> dict[tuple[str, str, str], float | str | None]:
    """Return what is sampled and what the samples give, by mechanism, subject and unit."""
    said: dict[tuple[str, str, str], float | str | None] = {
        ("", "samples", ""): found.samples,
        ("", "seed", ""): found.seed,
    }
    for one in found.inputs:
        said["", f"{one.key}, mean", one.unit.replace("-", "")] = one.mean
        said["", f"{one.key}, cov", ""] = one.cov
        said["", f"{one.key}, distribution and group", ""] = f"{one.distribution}, {one.group}"
    for each in found.answers:
        at = "" if each.level_pga_g is None else f" at {each.level_pga_g:.6g} g"
        of = f"{each.procedure} {each.limit_state}".strip() + at
        said[each.mechanism, f"probability of failing, {of}", ""] = each.probability
        for percent, ratio in zip(QUANTILES, each.quantiles, strict=True):
            said[each.mechanism, f"demand_capacity, {percent} %, {of}", ""] = ratio
    return said
