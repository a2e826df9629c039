"""Checks and questions made by hand, for tests of the verdict."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf
from typing import Any

import numpy as np
from scipy.constants import g

from assess.codes.bases import BASES
from assess.codes.check import Check, Outcome, Reason, reason_message
from assess.codes.context import Building, Context
from assess.codes.histories import RecordRuns, SuiteResponse
from assess.codes.procedures import PROCEDURES, CodeOptions, apply_procedure, with_options
from assess.codes.question import Action, MechanismChecks, Missing, Question
from assess.codes.verdict import Verdict, verdict
from assess.oscillator import HingeForces, Oscillator, Pressure
from spectra.spectrum import Spectrum

SITE = 0.2  # g
RATIOS = {Outcome.PASS: 0.5, Outcome.FAIL: 2.0}


def check(procedure: str, outcome: Outcome | None, *, state: str = "SLV", ratio: float | None = None, **more) -> Check:
    """A check at the site's own action; its index is 1 / ratio."""
    outcome = outcome or Outcome.NOT_ANSWERED
    ratio = RATIOS.get(outcome) if ratio is None else ratio
    index = None if ratio is None else 1.0 / ratio
    reason = {Outcome.PASS: Reason.WITHIN, Outcome.FAIL: Reason.BEYOND}.get(outcome, Reason.GROUND_UNKNOWN)
    values = {"capacity": "d"} if reason != Reason.GROUND_UNKNOWN else {"height": "8 m"}
    given = {
        "edition": "",
        "branch": "positive",
        "level_pga_g": SITE,
        "input_at": "ground",
        "damping": None,
        "quantity": "",
        "unit": "-",
        "safety_index": index,
        "score": {} if index is None else {"%NBS": 100.0 * index},
        "capacity_pga_g": None if index is None else index * SITE,
    }
    return Check(
        procedure=procedure,
        limit_state=state,
        verdict=outcome,
        ratio=ratio,
        reason=reason_message(reason, **values),
        **{**given, **more},
    )


def rotation_check(
    outcome: str = "pass",
    ratio: float | None = None,
    *,
    procedure: str = "asce43-05-spectrum",
    level: float = 0.1,
    rated: bool = False,
    **more,
) -> Check:
    """A check of ASCE 43-05 at a PGA [g]; where it is rated, its capacity is the level over the ratio."""
    reason = reason_message(Reason.BEYOND if outcome == "fail" else Reason.WITHIN, capacity="the allowable")
    given = {
        "edition": "", "branch": "positive", "limit_state": "no overturning", "input_at": "ground", "damping": None,
        "quantity": "rotation", "unit": "rad", "reason": reason,
        "capacity_pga_g": level / ratio if rated and ratio else None,
    }  # fmt: skip
    return Check(
        procedure=procedure, verdict=Outcome(outcome), ratio=ratio, level_pga_g=level, **{**given, **more}
    )  # fmt: skip


def suite_of_runs(pga: float, runs: np.ndarray) -> SuiteResponse:
    """A suite of runs [9, records] at a PGA [m/s2], the records as they are first, then their twins."""
    own = tuple(None if np.isinf(each) else float(each) for each in runs[0])
    return SuiteResponse(pga, own, "positive", twins=RecordRuns(runs, np.zeros(runs.shape, dtype=bool)))


HINGE = HingeForces(
    hinge="A", branch="positive", single=True, horizontal=-400.0, vertical=1000.0, face=(0.0, 1.0), found=True,
    starting=Pressure(1000.0, -400.0), resting=Pressure(1000.0, 0.0), acceleration=0.4 * g, friction=0.3,
    remedy="give materials.stone.friction", held=False,
)  # fmt: skip
"""A hinge that carries 1000 N and starts to rock at 0.4 g."""


def question(basis: str | None, *, state: str | None = "SLV", periods: bool = False, **more) -> Question:
    """The question of a basis at a site whose single spectrum is that of `state`."""
    return Question(None if basis is None else BASES[basis], Action(SITE, state, over_periods=periods), **more)


def decide(asked: Question, checks: Iterable[Check], *, missing: Iterable[Missing] = (), **more) -> Verdict:
    """The verdict on one mechanism."""
    return verdict(asked, [MechanismChecks("wall", tuple(checks), tuple(missing), **more)])


def step_values(check: Check) -> dict[str, float]:
    """The value of each line of a calculation sheet, by its symbol."""
    return {step.symbol: step.value for step in check.steps}


def context_at(
    spectrum: Spectrum, levels: tuple[float, ...], elevation: float = 0.0, building: Building | None = None, **more: Any
) -> Context:
    """Return a place [m] under a spectrum at levels of PGA [m/s2], without vertical motion."""
    return Context(spectrum, levels, 0.0, elevation, building, **more)


def checks_of(procedure: str, rocker: Oscillator, context: Context, options: Any = None) -> tuple[Check, ...]:
    """Return the checks of a procedure where it may be applied, with the options of its code or with none stated."""
    stated = CodeOptions() if options is None else CodeOptions(**{PROCEDURES[procedure].options: options})
    return apply_procedure(procedure, with_options(procedure, stated), rocker, context)


def ratio_of(check: Check) -> float:
    """Return demand over capacity, without end where there is none."""
    return inf if check.ratio is None else check.ratio
