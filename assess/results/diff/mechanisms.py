"""Differences of mechanisms: what they are, rocking parameters, envelopes and time histories."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from operator import attrgetter

from assess.results.diff.change import Change
from assess.results.diff.pairs import common_mechanisms, mechanisms_by_name, of_both, pairs
from assess.results.envelopes import EnvelopeResult
from assess.results.oscillator import OscillatorResult
from assess.results.run import Results

SUITE_STATISTICS = {
    "overturned": "records that overturn",
    "n": "records",
    "mean_ratio": "mean of max φ/φ_ov",
    "median_ratio": "median of max φ/φ_ov",
    "p84_ratio": "84 % of max φ/φ_ov",
    "max_ratio": "largest φ/φ_ov of those that stand",
}


def mechanisms(before: Results, after: Results) -> Iterator[Change]:
    """List the mechanisms that only one run has, and compare kind, sides, label and source of restitution."""
    for name, one, other in pairs(mechanisms_by_name(before), mechanisms_by_name(after)):
        for what in ("kind", "sides", "label", "restitution_source"):
            if what == "kind" or (one is not None and other is not None):
                yield Change("mechanism", name, what, *of_both(attrgetter(what), one, other))


def parameters(before: Results, after: Results) -> Iterator[Change]:
    """Compare the rocking parameters of both branches, under their names in results.json."""
    for one, other in common_mechanisms(before, after):
        for branch, key in (("positive", "oscillator"), ("negative", "oscillator_negative")):
            sides = [parameters_of(getattr(each, key)) for each in (one, other)]
            for what, first, second in pairs(*sides):
                yield Change("parameter", one.name, f"{what}, {branch}", first, second)


def parameters_of(oscillator: OscillatorResult | None) -> dict[str, float | None]:
    """Return the rocking parameters of one branch by name."""
    if oscillator is None:
        return {}
    return {each.name: getattr(oscillator, each.name) for each in fields(oscillator) if each.name != "linearised"}


def histories(before: Results, after: Results) -> Iterator[Change]:
    """Compare the statistics of the histories of each mechanism at each level."""
    for one, other in common_mechanisms(before, after):
        sides = [{f"{suite.level_pga_g:.6g} g": suite for suite in each.suites} for each in (one, other)]
        for level, first, second in pairs(*sides):
            for key, what in SUITE_STATISTICS.items():
                yield Change("history", one.name, f"{what} at {level}", *of_both(attrgetter(key), first, second))


def envelopes(before: Results, after: Results) -> Iterator[Change]:
    """Compare the least pulse that overturns each mechanism [g], and how many pulses of the grid do."""
    for one, other in common_mechanisms(before, after):
        ends = one.envelope, other.envelope
        yield Change(
            "envelope", one.name, "least pulse that overturns", *of_both(least_overturning_pulse, *ends), unit="g"
        )
        yield Change("envelope", one.name, "pulses that overturn", *of_both(count_overturning_pulses, *ends))


def least_overturning_pulse(envelope: EnvelopeResult) -> float | None:
    """Return the least amplitude of all frequencies that overturns [g]; None if no pulse does."""
    return min((amplitude for amplitude in envelope.lower_bound_g if amplitude is not None), default=None)


def count_overturning_pulses(envelope: EnvelopeResult) -> int:
    """Count the pulses of the grid that overturn."""
    return sum(sum(row) for row in envelope.overturned)
