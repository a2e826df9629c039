"""Fragility curves from counts, and annual rates from curves and hazards."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any


def solve_risk(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return lognormal fits and annual rates.

    Parameters
    ----------
    folder : of the case, not read
    given : `counts`, by name `intensity` of stripes, how many records `reached` a state there, of how many `records`;
        `curves`, by name a `median` and `dispersion`, or `intensity` and `share` of an empirical curve; `hazards`, of
        the same names, the rows `intensity` and `rate` [1/year]; `epistemic`, a dispersion that widens the curves

    Returns
    -------
    Mapping
        By name of counts `median` and `dispersion`, `low` and `high` of Wilson's interval of the first stripe; by name
        of curves `rate` and `widened` [1/year], and `in_50_years`, the probability.
    """
    counts = {name: _fit(each) for name, each in given.get("counts", {}).items()}
    curves = given.get("curves", {})
    rates = {name: _rates(each, given["hazards"][name], given["epistemic"]) for name, each in curves.items()}
    return {**counts, **rates}


def _fit(given: Mapping[str, Any]) -> Mapping[str, float]:
    from assess.risk.lognormal import fit_lognormal
    from assess.risk.wilson import wilson

    low, high = wilson(given["reached"], given["records"])
    found = fit_lognormal(given["intensity"], given["reached"], given["records"])
    interval = {"low": float(low[0]), "high": float(high[0])}
    return interval if found is None else {"median": found.median, "dispersion": found.dispersion, **interval}


def _rates(curve: Mapping[str, Any], hazard: Mapping[str, Any], epistemic: float) -> Mapping[str, float]:
    import numpy as np

    from assess.risk.empirical import Empirical
    from assess.risk.hazard import HazardCurve, probability_of, rate
    from assess.risk.lognormal import Lognormal

    kinks = np.array(curve.get("intensity", ()), dtype=float)
    drawn = (
        Empirical(kinks, np.array(curve["share"])) if kinks.size else Lognormal(curve["median"], curve["dispersion"])
    )
    rows = HazardCurve(np.array(hazard["intensity"]), np.array(hazard["rate"]))
    found = rate(drawn.probability, rows, breaks=kinks).annual_rate
    widened = rate(drawn.convolve(epistemic).probability, rows, breaks=kinks).annual_rate
    return {"rate": found, "widened": widened, "in_50_years": probability_of(found)}
