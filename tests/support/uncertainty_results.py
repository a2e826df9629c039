"""Samples of uncertain inputs made by formulas: a ratio that falls with the thickness and knows nothing of density."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.stats import spearmanr

from assess.results import Results
from assess.results.run import Influence, UncertainAnswer, UncertainInput, UncertaintyResult
from tests.support.fragility_results import wilson

SAMPLES = 128
KEYS = ("bodies.wall.thickness", "materials.stone.density", "mechanisms.wall-6.loads[0].force")
QUANTILES = (0.05, 0.16, 0.5, 0.84, 0.95)


def answer(results: Results, place: int, base: float) -> UncertainAnswer:
    """The answer of a mechanism by its first deciding procedure, at a ratio [-] with the means."""
    mechanism = results.mechanisms[place]
    check = next((each for each in mechanism.checks if each.role == "deciding"), mechanism.checks[0])
    random = np.random.default_rng(place)
    thickness, force = random.standard_normal((2, SAMPLES))
    ratio = base * np.exp(-0.15 * thickness + 0.05 * force)
    ratio[ratio > 1.2] = np.inf  # overturned
    failed = int(np.count_nonzero(ratio > 1.0))
    shares = [float(spearmanr(each, ratio).statistic) for each in (thickness, force)]
    finite = [float(each) if np.isfinite(each) else None for each in ratio]
    ends = [float(each) for each in np.quantile(np.minimum(ratio, 1e9), QUANTILES)]
    return UncertainAnswer(
        mechanism.name,
        check.procedure,
        check.limit_state,
        check.level_pga_g,
        "deciding",
        SAMPLES,
        failed,
        failed / SAMPLES,
        wilson(failed, SAMPLES),
        base,
        tuple(end if end < 1e3 else None for end in ends),
        tuple(finite),
        (
            Influence("thickness", KEYS[:1], shares[0], shares[0] ** 2),
            Influence("density", KEYS[1:2], None, None),
            Influence("force", KEYS[2:], shares[1], shares[1] ** 2),
        ),
    )


def with_uncertainty(results: Results) -> Results:
    """The results of a run with samples of its first two mechanisms."""
    inputs = (
        UncertainInput(KEYS[0], "m", 0.6, 0.05, "normal", "thickness"),
        UncertainInput(KEYS[1], "kg/m^3", 2100.0, 0.1, "lognormal", "density"),
        UncertainInput(KEYS[2], "N", 12000.0, 0.2, "uniform", "force"),
    )
    answers = (answer(results, 0, 0.72), answer(results, 1, 0.97))
    return replace(results, uncertainty=UncertaintyResult(SAMPLES, 11, inputs, answers))
