"""Expected values of cases that are derived: each is made again, without the program, from its source's formulas."""

from __future__ import annotations

import tomllib
from decimal import Decimal
from math import pi

import numpy as np
import pytest
from scipy.constants import g

from assess.verification.case_files import CASES, read_cases
from tests.validation.derive import arches, chains, codes, hand, housner, loaded_walls, motions, pulses, yim
from tests.validation.derive.rocking import rocked

DERIVED = {
    **housner.VALUES, **pulses.VALUES, **chains.VALUES, **codes.VALUES, **arches.VALUES, **yim.VALUES,
    **loaded_walls.VALUES, **motions.VALUES, **hand.VALUES,
}  # fmt: skip
SLOW = {"zhang_makris_2001/with_impact", "zhang_makris_2001/exact_block"}
"""Bisections of integrated motions; below, both sides of each value are integrated instead."""


def printed(key: str) -> dict[str, dict[str, Decimal]]:
    """Expected values of a case as its file writes them, with their digits."""
    content = tomllib.loads((CASES / f"{key}.toml").read_text(encoding="utf-8"), parse_float=Decimal)
    return {each["name"]: each["values"] for each in content["quantities"]}


@pytest.mark.parametrize(
    "key", [pytest.param(key, marks=[pytest.mark.study] if key in SLOW else []) for key in sorted(DERIVED)]
)
def test_values_of_a_case_come_out_of_its_source_s_formulas(key: str) -> None:
    """To half a unit of the last digit."""
    expected, found = printed(key), DERIVED[key]()
    assert expected.keys() == found.keys()
    for name, rows in expected.items():
        assert rows.keys() == found[name].keys()
        for row, value in rows.items():
            half = 0.501 * 10.0 ** int(value.as_tuple().exponent)
            assert found[name][row] == pytest.approx(float(value), rel=0, abs=half), (name, row)


@pytest.mark.parametrize(
    ("key", "name", "alpha", "linearised"),
    [
        ("zhang_makris_2001/with_impact", "A at which the band begins, by Ω", 0.2, True),
        ("zhang_makris_2001/with_impact", "A at which the band ends, by Ω", 0.2, True),
        ("zhang_makris_2001/exact_block", "least A, by Ω", 0.2, False),
    ],
)
def test_outcomes_change_at_the_value(key: str, name: str, alpha: float, linearised: bool) -> None:
    for row, value in printed(key)[name].items():
        sides = [
            pulses.falls(float(value) * (1 + step), float(row), alpha=alpha, linearised=linearised)
            for step in (-5e-7, 5e-7)
        ]
        assert sides[0] != sides[1], row


def test_every_derived_case_of_the_literature_is_made_again() -> None:
    """The thesis has goldens of its own."""
    derived = {each.key for each in read_cases() if each.case.source.standing == "derived"}
    assert {key for key in derived if not key.startswith("mehrotra")} <= DERIVED.keys()


def test_the_chain_of_bars_is_the_closed_form_of_an_equal_portal() -> None:
    """Two ways to the derived values themselves."""
    closed = chains.portal()
    for row, share in chains.GAMMAS.items():
        length = chains.SPAN + chains.WIDTH
        density = share * 2 * 2400.0 * chains.WIDTH * chains.HEIGHT / (length * chains.DEPTH)
        column = (chains.WIDTH, chains.HEIGHT)
        found = chains.portal_of(column, column, chains.SPAN, chains.DEPTH, density).parameters(0.6)
        for name in ("p", "φ_ov", "uplift multiplier"):
            assert found[name] == pytest.approx(closed[name][row], rel=1e-8)


def test_the_integrator_finds_the_closed_forms() -> None:
    """DOP853 and the formulas without impact: both kinds of expected values agree."""
    for row, A in pulses.one_sine()["A, by Ω"].items():
        if float(row) >= 3.0:
            sides = [pulses.falls(A * (1 + step), float(row), alpha=0.2, linearised=True) for step in (-1e-8, 1e-8)]
            assert sides == [False, True]
    row, A = "2", pulses.half_sine()["A, by Ω"]["2"]
    w = float(row) * pulses.P
    for step, falls in ((-1e-8, False), (1e-8, True)):
        peak = A * (1 + step) * g * 0.2
        found = rocked(
            lambda t, peak=peak: peak * np.sin(w * t), np.array([0.0, pi / w]), p=pulses.P, alpha=0.2, restitution=0.9,
            linearised=True,
        )  # fmt: skip
        assert found[2] is falls


def test_a_case_of_a_stocky_block_is_beyond_small_angles() -> None:
    """The exact fall differs from the linearised one by more than its tolerance, so that it tells them apart."""
    exact, linear = housner.exact_fall(), housner.free_rocking()["p T, by θ0/α"]
    found = exact["p t to the first impact, by θ0/α"]
    assert all(abs(found[row] / (linear[row] / 4) - 1) > 1e-4 for row in found)
