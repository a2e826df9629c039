"""The resultant of the stresses on a contact and its lever arm, as lines of a calculation sheet, strip by strip."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isclose

from assess.codes.calculation_step import Given, Step, step
from assess.interfaces.kernel.moments import BEGIN, W0, W1
from assess.interfaces.section import Section
from assess.interfaces.stress_integrals import stress_integrals
from assess.study.section_steps import BALANCE, MOST_STRIPS, rectangle_width

STRIP_FORCE = "force of a strip, ∫ σ w dx"
STRIP_PLACE = "its place, ∫ σ w x dx over that force"
NONE = 1e-12
"""Fraction of the largest stress: less is none, but for rounding."""

Named = tuple[str, float]
"""A symbol with its value, in SI."""


@dataclass(frozen=True)
class Zone:
    """A stretch of the contact in which the stress is linear.

    start : depth at which it begins [m]; length : [m]; stress : at its start and at its end [Pa]
    """

    start: Named
    length: Named
    stress: tuple[Named, Named]


@dataclass(frozen=True)
class Strip:
    """A zone or a part of one. width : at its start and end [m]; None where it is not linear between them."""

    zone: Zone
    width: tuple[Named, Named] | None


@dataclass(frozen=True)
class State:
    """A contact whose stresses are known.

    mark : behind each symbol; zones : from the compressed edge on; normal_force : [N]
    """

    section: Section
    mark: str
    zones: tuple[Zone, ...]
    normal_force: Named


def resultant_steps(state: State) -> tuple[tuple[Step, ...], Step]:
    """Write the two integrals of the stress, strip by strip: the resultant, which is the normal force, and its place.

    Parameters
    ----------
    state : of the contact

    Returns
    -------
    steps : its lines
    arm : the line for the distance of the resultant from the compressed edge, which the caller names
    """
    strips = _strips(state.section, state.zones)
    ends = [state.mark] if len(strips) == 1 else [f"{state.mark}{number}" for number in range(1, len(strips) + 1)]
    pairs = [_strip_steps(state.section, strip, end) for strip, end in zip(strips, ends, strict=True)]
    if len(pairs) == 1:
        ((force, place),) = pairs
        return (force, _balance_step(force.symbol, force.value or 0.0, state.normal_force)), place
    lines = [line for pair in pairs for line in pair]
    known: Given = {line.symbol: (line.value or 0.0, line.unit) for line in lines}
    parts: Given = {force.symbol: known[force.symbol] for force, _ in pairs}
    name, total = f"R_{state.mark}", sum(force.value or 0.0 for force, _ in pairs)
    lines.append(step(name, "resultant of the stresses", BALANCE, " + ".join(parts), total, "N", given=parts))
    lines.append(_balance_step(name, total, state.normal_force))
    moment = " + ".join(f"{force.symbol} {place.symbol}" for force, place in pairs)
    arm = sum((force.value or 0.0) * (place.value or 0.0) for force, place in pairs) / total
    whole: Given = {**known, name: (total, "N")}
    return tuple(lines), step("x", STRIP_PLACE, BALANCE, f"({moment}) / {name}", arm, "m", given=whole)


def _balance_step(name: str, total: float, normal_force: Named) -> Step:
    symbol, force = normal_force
    given: Given = {name: (total, "N"), symbol: (force, "N")}
    formula = f"{name} / {symbol}"
    return step(formula, "check of equilibrium: R over N", BALANCE, formula, total / force,
                given=given)  # fmt: skip


def _strips(section: Section, zones: tuple[Zone, ...]) -> list[Strip]:
    """Return the zones, divided where the width is no longer linear; not where that makes too many."""
    width = rectangle_width(section)
    if width is not None:
        return [Strip(zone, (("l", width), ("l", width))) for zone in zones]
    cut = [strip for zone in zones for strip in _cut(section, zone)] if section.pieces.size else []
    return cut if 0 < len(cut) <= MOST_STRIPS else [Strip(zone, None) for zone in zones]


def _cut(section: Section, zone: Zone) -> Iterator[Strip]:
    """Yield the parts of a zone over which the width is linear."""
    (_, start), (_, length), ((first, before), (_, after)) = zone.start, zone.length, zone.stress
    spans = [
        (piece, max(start, piece[BEGIN]), min(start + length, following[BEGIN]))
        for piece, following in zip(section.pieces[:-1], section.pieces[1:], strict=True)
    ]
    spans = [span for span in spans if span[2] - span[1] > 1e-9 * length]
    for piece, low, high in spans:
        here, there = (float(piece[W0] + piece[W1] * (x - piece[BEGIN])) for x in (low, high))
        ends = ("w", "w") if isclose(here, there, rel_tol=NONE) else ("w", "v")
        part = zone
        if len(spans) > 1:
            stress = [before + (after - before) * (x - start) / length for x in (low, high)]
            stress = [each if each > NONE * before else 0.0 for each in stress]
            names = (first, first) if before == after else ("σ", "τ")
            part = Zone(("p", float(low)), ("L", float(high - low)), ((names[0], stress[0]), (names[1], stress[1])))
        yield Strip(part, ((ends[0], here), (ends[1], max(there, 0.0))))


def _strip_steps(section: Section, strip: Strip, end: str) -> tuple[Step, Step]:
    """Write force and place of the stress on a strip."""
    if strip.width is None:
        return _integral_steps(section, strip.zone, end)
    (p, start), (L, length) = strip.zone.start, strip.zone.length
    ((s, first), (t, last)), ((w, here), (v, there)) = strip.zone.stress, strip.width
    N = length * (2.0 * (first * here + last * there) + first * there + last * here) / 6.0
    moment = length**2 * (first * here + first * there + last * here + 3.0 * last * there) / 12.0
    force, place = _force_formula(strip.zone, (w, v)), _place_formula(strip.zone, (w, v), f"R_{end}")
    known: Given = {p: (start, "m"), L: (length, "m"), w: (here, "m"), v: (there, "m"), s: (first, "Pa"),
                    t: (last, "Pa"), f"R_{end}": (N, "N")}  # fmt: skip
    return (
        step(f"R_{end}", STRIP_FORCE, BALANCE, force, N, "N", given=_used(force, known)),
        step(f"x_{end}", STRIP_PLACE, BALANCE, place, start + moment / N, "m", given=_used(place, known)),
    )


def _used(formula: str, given: Given) -> Given:
    """Return what stands in a formula."""
    words = formula.translate(str.maketrans("()²", "   ")).split()
    return {symbol: value for symbol, value in given.items() if symbol in words}


def _force_formula(zone: Zone, width: tuple[str, str]) -> str:
    """Return the integral of stress times width over a strip, both linear."""
    (L, _), ((s, first), (t, last)), (w, v) = zone.length, zone.stress, width
    if w == v:
        return f"{w} {L} {s}" if first == last else f"{w} {L} ({s} + {t}) / 2" if last else f"{w} {L} {s} / 2"
    if first == last:
        return f"{s} {L} ({w} + {v}) / 2"
    return f"{L} (2 {s} {w} + 2 {t} {v} + {s} {v} + {t} {w}) / 6" if last else f"{L} {s} (2 {w} + {v}) / 6"


def _place_formula(zone: Zone, width: tuple[str, str], force: str) -> str:
    """Return the integral of stress times width times depth over a strip, divided by its force."""
    (p, start), (L, _), ((s, first), (t, last)), (w, v) = zone.start, zone.length, zone.stress, width
    if w == v:
        inside = f"{L} / 2" if first == last else f"{L} ({s} + 2 {t}) / (3 ({s} + {t}))" if last else f"{L} / 3"
    elif first == last:
        inside = f"{L} ({w} + 2 {v}) / (3 ({w} + {v}))"
    elif last:
        inside = f"{L}² ({s} {w} + {s} {v} + {t} {w} + 3 {t} {v}) / (12 {force})"
    else:
        inside = f"{L} ({w} + {v}) / (2 (2 {w} + {v}))"
    return f"{p} + {inside}" if start else inside


def _integral_steps(section: Section, zone: Zone, end: str) -> tuple[Step, Step]:
    """Write force and place of the stress on a zone whose width is no line, by quadrature."""
    (p, start), (L, length), ((s, first), (t, last)) = zone.start, zone.length, zone.stress
    force, moment = stress_integrals(section, start=start, end=start + length, stress=(first, last))
    at: Given = {**({p: (start, "m")} if start else {}), L: (length, "m"), s: (first, "Pa"), t: (last, "Pa")}
    return (
        step(f"R_{end}", STRIP_FORCE, BALANCE, "∫ σ w dx", force, "N", at=at),
        step(f"x_{end}", STRIP_PLACE, BALANCE,
             "∫ σ w x dx / ∫ σ w dx", moment / force, "m", at=at),
    )  # fmt: skip
