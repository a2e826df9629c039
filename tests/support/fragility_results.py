"""Results of `assess fragility` made by formulas: records whose capacities are drawn, counted, fitted and convolved."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from scipy.stats import norm

from assess.messages.message import Message, Severity
from assess.results.fragility import (
    FRAGILITY_VERSION,
    CurveBand,
    EmpiricalPoint,
    FragilityCurve,
    FragilityResults,
    HazardResult,
    LognormalResult,
    MeasureComparison,
    MeasureResult,
    MechanismFragility,
    RecordRunsResult,
    RiskResult,
    StateResult,
    Trend,
)
from assess.results.provenance import Input, Program, ResolvedValue
from spectra.arrays import FloatArray

PGA = MeasureResult("pga", "ground acceleration", "ground")
PGV = MeasureResult("pgv", "velocity", "ground")
SA = MeasureResult("sa", "ground acceleration", "base", (0.5,))
AVERAGE = MeasureResult("sa-average", "ground acceleration", "ground", (0.2, 0.5, 1.0, 1.5))
SCALED_PGA = MeasureResult("pga/(g tan alpha)", "ratio", "ground")
SCALED_PGV = MeasureResult("p pgv/(g tan alpha)", "ratio", "ground")
MEASURES = (PGA, PGV, SA, AVERAGE, SCALED_PGA, SCALED_PGV)
ROCKING, HALF, OVERTURNING = StateResult("rocking"), StateResult("rotation", 0.5), StateResult("overturning")
SHARES = {ROCKING: 0.25, HALF: 0.7, OVERTURNING: 1.0}
"""Of the intensity that overturns, at which a record of this sample reaches each state."""
SCALES = np.geomspace(0.3, 8.0, 18)
LARGE = 4.0
EPISTEMIC = 0.25
INTENSITY = np.geomspace(0.02, 3.0, 25)


def wilson(reached: int, n: int, z: float = 1.96) -> tuple[float, float]:
    p = reached / n
    middle, half = p + z * z / (2 * n), z * np.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return tuple(float(min(1.0, max(0.0, (middle + s * half) / (1 + z * z / n)))) for s in (-1, 1))  # type: ignore[return-value]


def lognormal(median: float, dispersion: float, n: int) -> LognormalResult:
    """A curve with the intervals of a sample of n capacities."""
    error = dispersion / np.sqrt(n)
    x = median * np.exp(np.linspace(-3.0, 3.0, 31) * dispersion)
    low, high = (norm.cdf(np.log(x / median) / dispersion - s * 1.96 / np.sqrt(n)) for s in (1, -1))
    five = median * np.exp(norm.ppf(0.05) * dispersion)
    return LognormalResult(
        median,
        dispersion,
        tuple(float(median * np.exp(s * 1.96 * error)) for s in (-1, 1)),  # type: ignore[arg-type]
        tuple(float(dispersion * (1 + s * 1.4 / np.sqrt(n))) for s in (-1, 1)),  # type: ignore[arg-type]
        tuple(float(five * np.exp(s * 2.6 * error)) for s in (-1, 1)),  # type: ignore[arg-type]
        CurveBand(*(tuple(map(float, values)) for values in (x, low, high))),
    )


def runs_of(capacity: float, place: int, pga: float) -> RecordRunsResult:
    """A record that overturns from its capacity on, but for an island of every fourth one."""
    at = SCALES * pga
    fallen = at >= capacity
    islands: tuple[tuple[float, float], ...] = ()
    first = int(np.argmax(fallen)) if fallen.any() else len(SCALES)
    if place % 4 == 1 and first + 4 < len(SCALES):
        fallen[first + 1 : first + 3] = False
        islands = ((float(SCALES[first + 1]), float(SCALES[first + 2])),)
    ratio = np.where(at < 0.2 * capacity, 0.0, np.minimum(0.95, 0.8 * at / capacity) ** 2)
    scaled = (1.0, 0.12 / 0.2, 2.1, 1.4, 1 / 0.18, 1.7)
    return RecordRunsResult(
        f"record {place:02d}",
        f"Event {place // 3}",
        5.5 + 0.1 * (place // 3),
        None if place == 0 else 8.0 + 2.5 * place,
        tuple(float(pga * factor) for factor in scaled),
        tuple(map(float, SCALES)),
        tuple(None if down else float(value) for down, value in zip(fallen, ratio, strict=True)),
        islands,
    )


def curve_of(
    runs: tuple[RecordRunsResult, ...], measure: MeasureResult, state: StateResult, median: float, dispersion: float
) -> FragilityCurve:
    which = MEASURES.index(measure)
    limit = {"rocking": 0.0, "rotation": 0.5, "overturning": np.inf}[state.name]
    stripes = np.geomspace(0.25, 2.6, 12) * median
    points = []
    for stripe in stripes.tolist():
        factors = [stripe / run.intensity[which] for run in runs]
        kept = [(run, f) for run, f in zip(runs, factors, strict=True) if SCALES[0] <= f <= SCALES[-1]]
        if kept:
            reached = sum(_reaches(run, f, limit) for run, f in kept)
            n = len(kept)
            points.append(
                EmpiricalPoint(stripe, n, reached, reached / n, *wilson(reached, n), sum(f > LARGE for _, f in kept))
            )
    standing = sum(not any(_reaches(run, float(f), limit) for f in SCALES) for run in runs)
    return FragilityCurve(
        measure,
        state,
        "ida",
        len(runs),
        len({run.event for run in runs}),
        standing,
        sum(point.hollow for point in points),
        tuple(points),
        lognormal(median, dispersion, len(runs)),
        lognormal(0.93 * median, dispersion, len(runs)),
    )


def _reaches(run: RecordRunsResult, scale: float, limit: float) -> bool:
    ratio = run.ratio[int(np.argmin(np.abs(np.log(SCALES / scale))))]
    return ratio is None or ratio > limit


def hazard() -> HazardResult:
    rate = 4e-5 * INTENSITY**-2.2
    return HazardResult(PGA, "site.hazard", tuple(map(float, INTENSITY)), tuple(map(float, rate)))


def risk_of(median: float, dispersion: float, state: StateResult, *, target: float | None) -> RiskResult:
    """The rate by the lognormal between rows of a power law."""
    rate = np.array(hazard().annual_rate)
    parts, wide = (parts_of(median, float(beta)) for beta in (dispersion, np.hypot(dispersion, EPISTEMIC)))
    total = float(parts.sum())
    return RiskResult(
        PGA,
        state,
        "empirical",
        total,
        float(-np.expm1(-50.0 * total)),
        tuple(map(float, INTENSITY)),
        tuple(map(float, parts / total)),
        float(rate[-1]),
        target,
        with_epistemic=float(wide.sum()),
    )


def parts_of(median: float, dispersion: float) -> FloatArray:
    """The rates between rows of the hazard."""
    share: FloatArray = norm.cdf(np.log(INTENSITY / median) / dispersion)
    return np.array([0.5 * (a + b) for a, b in pairwise(share)]) * -np.diff(hazard().annual_rate)


def mechanism(
    name: str, label: str, median: float, *, records: int = 24, seed: int = 1, target: float | None = 1e-4
) -> MechanismFragility:
    """A mechanism that overturns at a median PGA [g]."""
    random = np.random.default_rng(seed)
    pga = random.uniform(0.1, 0.35, records)
    capacity = median * np.exp(0.42 * random.standard_normal(records))
    runs = tuple(runs_of(float(c), place, float(a)) for place, (c, a) in enumerate(zip(capacity, pga, strict=True)))
    scaled = (1.0, 0.12 / 0.2, 2.1, 1.4, 1 / 0.18, 1.7)
    spread = (0.45, 0.36, 0.41, 0.33, 0.45, 0.31)
    curves = tuple(
        curve_of(runs, measure, state, median * factor * share, beta)
        for measure, factor, beta in zip(MEASURES, scaled, spread, strict=True)
        for state, share in SHARES.items()
    )
    trends = (Trend("magnitude", -0.31, 0.012, records), Trend("distance", 0.04, 0.61, records - 1))
    comparison = tuple(
        MeasureComparison(measure, OVERTURNING, beta, (*trends, Trend("scale", -0.2 * beta, 0.3 * beta, records)))
        for measure, beta in zip(MEASURES, spread, strict=True)
    )
    risks = tuple(
        risk_of(median * share, 0.45, state, target=target if state == OVERTURNING else None)
        for state, share in SHARES.items()
    )
    return MechanismFragility(
        name, label, 0.18, 1.9, name == "parapet", runs, curves, comparison, risks,
        EPISTEMIC, {"materials.stone.friction": 0.15, "mechanisms.front.thickness": 0.2},
    )  # fmt: skip


def fragility_results(*, language: str = "en", units: str = "SI", paper: str = "A4") -> FragilityResults:
    """Two mechanisms by six measures in three states, with a hazard."""
    warning = Message("made", Severity.WARNING, "records", "a warning that no catalogue knows")
    given = {"report.language": language, "report.units": units, "report.paper": paper, "engineer": "A. Builder"}
    return FragilityResults(
        FRAGILITY_VERSION,
        Program("assess", "0.1.0"),
        (Input("project.toml", "3f" * 32),),
        (warning,),
        "Great House",
        "ida",
        7,
        1000,
        (mechanism("front", "Front wall", 0.42), mechanism("parapet", "Parapet", 0.23, seed=2)),
        (hazard(),),
        "1a2b-3c4d-5e6f-7a8b",
        project={key: ResolvedValue(value, True) for key, value in given.items()},
    )


def without_risk(results: FragilityResults) -> FragilityResults:
    """The same without a hazard, and without what is not known of the mechanisms."""
    bare = tuple(replace(each, risks=(), epistemic=None, epistemic_sources=None) for each in results.mechanisms)
    return replace(results, mechanisms=bare, hazard=(), warnings=())
