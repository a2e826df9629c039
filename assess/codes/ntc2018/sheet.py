"""Lines of the calculation sheets that the linear and the non-linear check share: T0 and the motion of the floor."""

from __future__ import annotations

from assess.codes.check import Step
from assess.codes.italian.floor import floor_of
from assess.codes.italian.limit_state import Case
from assess.codes.ntc2018.clauses import floor_ordinate, mode_of
from spectra.damping import ec8_eta
from spectra.floor_spectrum import PLATEAU, circolare2019_peak, resonance_factor


def period_steps(case: Case, *, T0: float) -> tuple[Step, ...]:
    """T0 of an element that vibrates before it lifts off."""
    if T0 == 0.0:
        return ()
    given, symbol, words = case.context.free_period, "T0", "period before uplift"
    if given is not None:
        return (Step(symbol, words, "C8.7.1.7", given.formula, given.substituted, T0, "s"),)
    formula, numbers = "1 / frequency of small motions", f"1 / {1.0 / T0:.5g} Hz"
    return (Step(symbol, words, "C8.7.1.6", formula, numbers, T0, "s"),)


def floor_steps(case: Case) -> tuple[Step, ...]:
    """gamma psi, S_e(T1, xi1) and a_Z of the floor; none at the ground."""
    floor, mode, spectrum = floor_of(case.context), mode_of(case.context), case.context.spectrum
    if floor is None or mode is None:
        return ()
    scale, xi = case.pga / spectrum.pga, 100.0 * mode.damping
    ordinate = float(spectrum.acceleration(mode.period, damping=mode.damping)) * scale
    shape, at = f"{floor.gamma:.5g} · {floor.psi:.5g}", f"T1 = {mode.period:.5g} s, ξ1 = {xi:.4g} %"
    peak = circolare2019_peak(spectrum, modes=[mode]) * scale
    numbers, formula = f"{ordinate:.5g} · {mode.share:.5g} · √(1 + 0.0004 · {xi:.4g}²)", "S_e(T1) γ ψ √(1 + 0.0004 ξ1²)"
    first = "elastic spectrum at the first mode"
    return (
        Step("γ ψ", "share of the first mode at Z", "C7.2.10", "3 N / (2 N + 1) · Z/H", shape, mode.share, "-"),
        Step("S_e(T1, ξ1)", first, spectrum.clause, "S_e(T1, ξ1)", at, ordinate, "m/s2"),
        Step("a_Z", "peak acceleration of the floor, first mode", "C7.2.7, C7.2.8", formula, numbers, peak, "m/s2"),
    )


def ordinate_steps(case: Case, period: float, symbol: str, *, damping: float) -> tuple[Step, ...]:
    """A and the ordinate of the floor spectrum at a period [s] named `symbol`; none at the ground."""
    mode, spectrum = mode_of(case.context), case.context.spectrum
    if mode is None:
        return ()
    scale, factor = case.pga / spectrum.pga, resonance_factor(mode, damping)
    peak = circolare2019_peak(spectrum, modes=[mode]) * scale
    value = floor_ordinate(case.context, period, damping=damping) * scale
    formula, numbers = _shape(period, mode.period, factor, peak, symbol)
    ground = float(spectrum.acceleration(period, damping=damping)) * scale
    if period > mode.period:
        formula, numbers = f"max({formula}; S_e({symbol}))", f"max({numbers}; {ground:.5g})"
    resonance = f"1.1 / √{mode.damping:.4g} · {ec8_eta(damping):.5g}"
    said, name = f"floor spectrum at {100 * damping:.3g} %", f"S_eZ({symbol})"
    return (
        Step("A", "resonance, at least 1; ξ1 as ratio", "C7.2.6", "1.1 ξ1^-0.5 η(ξ)", resonance, factor, "-"),
        Step(name, said, "C7.2.5, C7.2.6", formula, numbers, value, "m/s2"),
    )


def _shape(period: float, first: float, factor: float, peak: float, symbol: str) -> tuple[str, str]:
    """Formula and numbers of C7.2.6 on the stretch where a period lies."""
    a, b = PLATEAU
    high = f"{factor:.5g} · {peak:.5g}"
    if period < a * first:
        numbers = f"{high} / (1 + {factor - 1:.5g} · (1 − {period:.5g} / {a * first:.5g})^1.6)"
        return f"A a_Z / (1 + (A − 1) (1 − {symbol} / (a T1))^1.6)", numbers
    if period < b * first:
        return "A a_Z", high
    numbers = f"{high} / (1 + {factor - 1:.5g} · ({period:.5g} / {b * first:.5g} − 1)^1.2)"
    return f"A a_Z / (1 + (A − 1) ({symbol} / (b T1) − 1)^1.2)", numbers
