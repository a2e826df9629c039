"""4.3.5: the static force on an element against what its weight resists; one check for each level."""

from __future__ import annotations

from dataclasses import dataclass

from scipy.constants import g

from assess.codes.check import BranchName, Check, Outcome, Reason, Step, because
from assess.codes.context import Context
from assess.codes.en1998_1.clauses import (
    BEHAVIOUR,
    CAVEAT,
    EDITION,
    ELEMENTS,
    Options,
    amplification,
    element_period,
    force_over_weight,
    period_ratio,
    uplift_pga,
)
from assess.codes.family import foreign
from assess.codes.governing import governing
from assess.codes.worked import multiplier_worked
from assess.oscillator import Branch, Oscillator, resisted

NAME = "ec8-element"
CLAUSE, FORCE, TABLE = "EN 1998-1, 4.3.5.2 (4.25)", "EN 1998-1, 4.3.5.2 (4.24)", "EN 1998-1, 4.3.5.4, Table 4.4"


@dataclass(frozen=True)
class Demand:
    """T_a / T_1, S_a / (alpha S), q_a, gamma_a, F_a / W_a, all [-]."""

    ratio: float
    amplified: float
    q_a: float
    gamma_a: float
    force: float


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """4.3.5: F_a / W_a against the multiplier that the mechanism resists, on the worse branch."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        return _check(branch, name, context, options, level)

    return governing(oscillator, context.levels, one)


def demand_of(branch: Branch, context: Context, options: Options, level: float) -> Demand:
    """The force of the clause on one branch at PGA `level` [m/s2]."""
    ratio = period_ratio(branch, context)
    amplified = amplification(ratio, context)
    q_a = BEHAVIOUR[context.support] if options.behaviour_factor is None else options.behaviour_factor
    gamma_a = options.importance_factor
    force = force_over_weight(amplified, level, behaviour_factor=q_a, importance_factor=gamma_a)
    return Demand(ratio, amplified, q_a, gamma_a, force)


def _check(branch: Branch, name: BranchName, context: Context, options: Options, level: float) -> Check:
    found, resistance = demand_of(branch, context, options, level), resisted(branch)
    lifts, ratio = uplift_pga(branch, found.amplified), found.force / resistance
    verdict = Outcome.FAIL if ratio > 1.0 else Outcome.PASS
    return Check(
        procedure=NAME,
        edition=EDITION,
        branch=name,
        limit_state="element",
        level_pga_g=level / g,
        input_at="mechanism base" if context.above_ground else "ground",
        damping=None,
        quantity="force over weight",
        unit="-",
        demand=found.force,
        capacity=resistance,
        ratio=ratio,
        verdict=verdict,
        reason=because(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity="what the weight resists"),
        capacity_pga_g=level * resistance / found.force / g,
        uplift_pga_g=None if lifts is None else lifts / g,
        steps=_steps(branch, context, found, level=level),
        caveat=CAVEAT + foreign(NAME, context.spectrum.code),
    )


def _steps(branch: Branch, context: Context, found: Demand, *, level: float) -> tuple[Step, ...]:
    formula, numbers, resistance = multiplier_worked(branch)
    T_a, building = element_period(branch), context.building
    known = building is not None and context.above_ground
    ratio = context.support_height / building.height if building is not None and known else 0.0
    S_a = found.amplified * level / g
    worst = "worst, the building is not known" if found.ratio and building is None else f"T_a = {T_a:.4g} s"
    bracket = f"{level / g:.5g} · max(1, 3 (1 + {ratio:.4g}) / (1 + (1 − {found.ratio:.4g})²) − 0.5)"
    forced = f"{S_a:.5g} · {found.gamma_a:g} / {found.q_a:g}"
    return (
        Step("T_a/T_1", "period of the element over the building's", CLAUSE, "T_a / T_1", worst, found.ratio, "-"),
        Step("z/H", "height of the supports", CLAUSE, "z / H", f"z = {context.support_height:.4g} m", ratio, "-"),
        Step(
            "S_a",
            "seismic coefficient",
            CLAUSE,
            "α S max(1, 3 (1 + z/H) / (1 + (1 − T_a/T_1)²) − 0.5)",
            bracket,
            S_a,
            "-",
        ),
        Step("q_a", f"behaviour factor; {ELEMENTS[context.support]}", TABLE, "given", f"{found.q_a:g}", found.q_a, "-"),
        Step("γ_a", "importance factor", "EN 1998-1, 4.3.5.3", "given", f"{found.gamma_a:g}", found.gamma_a, "-"),
        Step("F_a/W_a", "force over weight", FORCE, "S_a γ_a / q_a", forced, found.force, "-"),
        Step("λ", "multiplier that the weight resists", "statics", formula, numbers, resistance, "-"),
        Step(
            "D/C",
            "ratio",
            FORCE,
            "demand / capacity",
            f"{found.force:.5g} / {resistance:.5g}",
            found.force / resistance,
            "-",
        ),
    )
