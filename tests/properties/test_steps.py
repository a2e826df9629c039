"""Every line of every calculation sheet comes to its value by its own formula, from the inputs printed with it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from formula import NoFormulaError, evaluate
from scipy.constants import g

from assess.codes.asce41_13.clauses import Options as Asce41Options
from assess.codes.asce43_05.clauses import Options as Asce43Options
from assess.codes.context import Building, Context, Suite
from assess.codes.registry import PROCEDURES, CodeOptions, procedure
from assess.codes.step import Step
from assess.geometry.planar import planar
from assess.geometry.solid import box
from assess.loads import PointMass
from assess.mechanisms.activation import hinge_forces
from assess.mechanisms.face import Face
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.oscillation import oscillator
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.project.wall_size import SUPPORTS, wall_of
from spectra.asce7 import design_spectrum
from spectra.spectrum import Spectrum

CLOSE = 1e-3  # relative: what is printed must come out
LEVELS = tuple(level * g for level in (0.05, 0.2, 0.6))
SUITES = tuple(
    Suite(level, (0.01, 0.02, share, 0.2, 0.3, 0.1, 0.15), "positive")
    for level, share in zip(LEVELS, (0.1, 0.9, None), strict=True)
)
HOUSE = Building(height=8.0, storeys=2, period=0.24, damping=0.05)
SPECTRUM = design_spectrum(s_ds=0.5 * g, s_d1=0.25 * g, t_l=6.0)


def part(base: float, height: float, thickness: float):
    body = box(thickness=thickness, length=1.0, height=height, base=(0, 0, base), density=1800.0, name="part")
    return planar(body, direction=(1, 0, 0))


def mechanisms() -> Iterator[Mechanism]:
    """A wall between floors with a load on its top, a parapet, and a slender one."""
    load = PointMass("roof", mass=900.0, at=(0.02, 6.0), block=1, bearing=True)
    yield two_block("spanning", part(2.0, 2.0, 0.28), part(4.0, 2.0, 0.28), loads=(load,))
    yield single_block("parapet", part(8.0, 1.0, 0.3))
    yield single_block("slender", part(0.0, 4.0, 0.45))


def contexts() -> Iterator[tuple[Mechanism, Context]]:
    """Each mechanism on the ground's motion, and in a building whose floor has a spectrum of its own."""
    floor = replace(SPECTRUM, factor=2.0, code="floor")
    for mechanism in mechanisms():
        count = len(mechanism.positive.hinges)
        stands = replace(mechanism, faces=((Face(friction=0.3),) * count,) * 2)
        for above in (None, floor):
            yield stands, context_of(stands, above)


def context_of(mechanism: Mechanism, floor: Spectrum | None) -> Context:
    return Context(
        SPECTRUM,
        LEVELS,
        0.5,
        mechanism.elevation,
        HOUSE,
        SUITES,
        SUITES,
        support=SUPPORTS[mechanism.kind],
        wall=wall_of(mechanism),
        rise=mechanism.rise,
        hinges=hinge_forces(mechanism),
        floor_spectrum=floor,
        amplification=1.5,
        crushing=True,  # with LC3 the Italian FC is 1, so that the suites of the levels serve
        knowledge={"dmi2008": "LC3", "ntc2018": "LC3"},
    )


def steps_of(name: str) -> Iterator[Step]:
    options = CodeOptions(
        asce43_05=Asce43Options(allowable_sliding=0.02), asce41_13=Asce41Options(masonry="coursed", s_x1=0.3)
    )
    for mechanism, context in contexts():
        for check in procedure(name, options)(oscillator(mechanism), context):
            yield from check.steps


def by_formula(step: Step) -> float:
    return evaluate(step.formula, {each.symbol: each.value for each in step.inputs})


@pytest.mark.parametrize("name", PROCEDURES)
def test_every_line_comes_to_its_value_by_its_formula(name: str) -> None:
    worked = [step for step in steps_of(name) if step.inputs and step.value is not None]
    assert worked
    for step in worked:
        assert by_formula(step) == pytest.approx(step.value, rel=CLOSE, abs=1e-12), (step.symbol, step.formula)


@pytest.mark.parametrize("name", PROCEDURES)
def test_the_numbers_printed_come_to_the_value_too(name: str) -> None:
    """Five figures of each number stand in the line; differences of two nearly equal ones lose some of them."""
    for step in steps_of(name):
        if step.inputs and step.value is not None:
            found = evaluate(step.substituted, {})
            assert found == pytest.approx(step.value, rel=2e-2, abs=1e-6), (step.symbol, step.substituted)


def test_most_lines_can_be_worked_out_from_what_is_printed() -> None:
    """The others read a curve, a spectrum or a table, count, or state what was given."""
    steps = [step for name in PROCEDURES for step in steps_of(name)]
    assert sum(bool(step.inputs) for step in steps) / len(steps) > 0.65


@pytest.mark.parametrize(
    ("formula", "value"),
    [
        ("a / b c", 2.0 / 3.0 * 5.0),
        ("2π √(a / b)", 2 * np.pi * np.sqrt(2.0 / 3.0)),
        ("√(4π² + a²) / 2π", np.sqrt(4 * np.pi**2 + 4.0) / (2 * np.pi)),
        ("max(0, a (1 − 0.4 b / g))", 2.0 * (1 - 1.2 / 9.80665)),
        ("−2 ln(min(a, 1))", 0.0),
        ("|−a| + b^2", 11.0),
        ("a k α / sin(2α)", 2.0 * 1.4 * 0.2 / np.sin(0.4)),
        ("−a · (b − c)", 4.0),
        ("a/b c", 7.0 * 5.0),
    ],
)
def test_the_notation(formula: str, value: float) -> None:
    symbols = {"a": 2.0, "b": 3.0, "c": 5.0, "k": 1.4, "α": 0.2}
    if formula.startswith("a/b"):
        symbols["a/b"] = 7.0  # a symbol with a stroke of its own
    assert evaluate(formula, symbols) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize("words", ["restoring moment = 0", "a b c d", "largest of all", "a +", "(a"])
def test_words_are_no_formula(words: str) -> None:
    with pytest.raises(NoFormulaError):
        evaluate(words, {"a": 1.0})
