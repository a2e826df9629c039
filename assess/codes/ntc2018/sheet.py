"""Lines of the calculation sheets that the linear and the non-linear check share: T0 and the motion of the floor."""

from __future__ import annotations

import numpy as np

from assess.codes.calculation_step import Given
from assess.codes.check import Step, step
from assess.codes.italian.limit_state import Case
from assess.codes.ntc2018.building import FirstModes, ordinate, peak_acceleration
from spectra.circolare2019 import PLATEAU
from spectra.damping import ec8_eta


def period_steps(case: Case, *, T0: float) -> tuple[Step, ...]:
    """Write T0 of an element that vibrates before it lifts off."""
    if T0 == 0.0:
        return ()
    given, words = case.context.free_period, "period before uplift"
    if given is not None:
        return (step("T0", words, "C8.7.1.7", given.formula, T0, "s", given=given.inputs, remark=given.remark),)
    return (step("T0", words, "C8.7.1.6", "1 / f", T0, "s", given={"f": (1.0 / T0, "Hz")}),)


def share_steps(case: Case, modes: FirstModes | None) -> tuple[Step, ...]:
    """Write gamma psi of the floor and the elastic first mode; nothing at the ground."""
    building = case.context.building
    if modes is None or building is None:
        return ()
    Z, H = (modes.floor.psi * building.height, "m"), (building.height, "m")
    given: Given = {"N": float(building.storeys or 0), "Z": Z, "H": H}
    words = "share of the first mode at Z, N storeys"
    mode = "first mode of the building, elastic"
    return (
        step("γψ", words, "C7.2.10", "3 · N · Z / ((2 · N + 1) · H)", modes.share, given=given),
        step("T1", mode, "C7.2.3", "[building] period", modes.floor.T1, "s", remark="given, or 0.05 H^0.75"),
    )


def first_mode_steps(modes: FirstModes, first: float, symbol: str, T: tuple[str, float], why: str) -> tuple[Step, ...]:
    """Write the most demanding T_1' [s], named `symbol`, for a mechanism of period T, (symbol, value) [s]."""
    if modes.reason:
        stated = "first mode at this limit state"
        return (step(symbol, stated, "C8.7.1.2.1.4", "as stated", first, "s", subject=modes.reason),)
    if modes.shortest == modes.longest:
        return ()
    name, value = T
    for letter, factor in zip("ab", PLATEAU, strict=True):
        if np.isclose(first, value / factor, rtol=1e-12, atol=0.0):
            peak: Given = {name: (value, "s"), letter: factor}
            return (step(symbol, why, "C8.7.1.2.1.4", f"{name} / {letter}", first, "s", given=peak),)
    k: Given = {"k": first / modes.floor.T1, "T1": (modes.floor.T1, "s")}
    return (step(symbol, why, "C8.7.1.2.1.4", "k · T1", first, "s", given=k),)


def peak_steps(case: Case, modes: FirstModes, first: float, symbol: str) -> tuple[Step, ...]:
    """Write S_e(T1, xi1) and a_Z of the floor under the first mode of period `first` [s], named `symbol`."""
    spectrum = case.context.spectrum
    scale, xi = case.pga / spectrum.pga, modes.damping
    spectral = float(spectrum.acceleration(first, damping=xi)) * scale
    peak, name = peak_acceleration(case.context, modes, first) * scale, f"S_e({symbol})"
    at: Given = {symbol: (first, "s"), "ξ1": xi, "PGA": (case.pga, "m/s2")}
    given: Given = {name: (spectral, "m/s2"), "γψ": modes.share, "ξ1": xi}
    words = "peak acceleration of the floor, first mode; ξ1 as ratio"
    return (
        step(name, "elastic spectrum at the first mode", spectrum.clause, "S_e(T, ξ1)", spectral, "m/s2", at=at),
        step(
            peak_symbol(symbol), words, "C7.2.7, C7.2.8", f"{name} · γψ · √(1 + (2 · ξ1)²)", peak, "m/s2", given=given
        ),
    )


def peak_symbol(first: str) -> str:
    """Return the symbol of a_Z under the first mode named `first`."""
    return f"a_Z({first})"


def ordinate_steps(
    case: Case, modes: FirstModes, first: tuple[str, float], T: tuple[str, float], *, damping: float
) -> tuple[Step, ...]:
    """Write A and the ordinate of the floor spectrum at T under T_1', both (symbol, value) [s]."""
    spectrum, (symbol, period), (name, building) = case.context.spectrum, T, first
    scale, eta = case.pga / spectrum.pga, ec8_eta(damping)
    peak = peak_acceleration(case.context, modes, building) * scale
    A = max(1.1 / np.sqrt(modes.damping) * eta, 1.0)
    value = ordinate(case.context, modes, building, period, damping=damping) * scale
    formula, given = _stretch(symbol, period, name, building)
    given = {"A": A, peak_symbol(name): (peak, "m/s2"), **given}
    if period > building:
        ground = float(spectrum.acceleration(period, damping=damping)) * scale
        formula, given = f"max({formula}, S_e({symbol}))", {**given, f"S_e({symbol})": (ground, "m/s2")}
    words, of_A = "floor spectrum, damped as the mechanism", {"η": eta, "ξ1": modes.damping}
    return (
        step("A", "resonance; ξ1 as ratio", "C7.2.6", "max(1.1 · η / √(ξ1), 1)", float(A), given=of_A),
        step(f"S_eZ({symbol})", words, "C7.2.5, C7.2.6", formula, value, "m/s2", given=given),
    )


def _stretch(symbol: str, period: float, name: str, first: float) -> tuple[str, dict[str, float | tuple[float, str]]]:
    """Return the formula of C7.2.6 on the stretch where a period lies, and its inputs besides A and a_Z."""
    (a, b), peak = PLATEAU, peak_symbol(name)
    given: dict[str, float | tuple[float, str]] = {symbol: (period, "s"), name: (first, "s")}
    if period < a * first:
        return f"A · {peak} / (1 + (A − 1) · (1 − {symbol} / (a · {name}))^1.6)", {**given, "a": a}
    if period <= b * first * (1.0 + 1e-12):
        return f"A · {peak}", {}
    return f"A · {peak} / (1 + (A − 1) · ({symbol} / (b · {name}) − 1)^1.2)", {**given, "b": b}
