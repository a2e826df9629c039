"""The rocking parameters of mechanisms as a table for the terminal, and as CSV."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from assess.cli.tables.text_table import text_table
from assess.project.key_text import escape_text
from assess.results import DirectionSweep, HingeForceResult, LinearisedResult, MechanismResult, OscillatorResult
from reports.render.csv import csv_lines

_SHORT = (
    "mechanism",
    "branch",
    "p [1/s]",
    "lambda [-]",
    "R [m]",
    "alpha [rad]",
    "phi_ov [rad]",
    "restitution",
    "mass [kg]",
)
_ON_JOINTS = "on joints [rad]"
_HINGES = ("mechanism", "hinge", "H [N]", "V [N]", "friction needed", "friction", "slides from [g]")
_CONSTANTS = (
    "linearised",
    "branch",
    "I [kg m2]",
    "K [N m/rad]",
    "B [kg m]",
    "M [N m]",
    "phi_cr [rad]",
    "phi_ov [rad]",
    "lambda [-]",
)


def parameters_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write the main parameters of each branch, the constants of its linearised equation, and the hinge forces."""
    return f"{table_text(mechanisms)}\n{constants_text(mechanisms)}{hinge_forces_text(mechanisms)}"


def table_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write the main parameters of each branch, rounded, with phi_ov of flexible joints beside the rigid one."""
    pairs = [(mechanism.name, *pair) for mechanism in mechanisms for pair in _branches(mechanism)]
    if all(o.overturning_flexible_rad is None for _, _, o in pairs):
        return text_table(_SHORT, [_short(*each) for each in pairs])
    place = _SHORT.index("phi_ov [rad]") + 1
    rows = [[*(short := _short(*each))[:place], _on_joints(each[-1]), *short[place:]] for each in pairs]
    return text_table((*_SHORT[:place], _ON_JOINTS, *_SHORT[place:]), rows)


def constants_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write I, K, B, M, phi_cr and phi_ov of each linearised branch (thesis 3.4-3.12), rounded."""
    rows = [
        [mechanism.name, branch, *(f"{getattr(o.linearised, field.name):.5g}" for field in fields(LinearisedResult))]
        for mechanism in mechanisms
        for branch, o in _branches(mechanism)
    ]
    return text_table(_CONSTANTS, rows)


def hinge_forces_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write the forces at each hinge when rocking starts, and the friction they need; empty where not known."""
    rows = [[m.name, *_hinge(forces)] for m in mechanisms for forces in m.hinge_forces]
    return f"\n{text_table(_HINGES, rows)}" if rows else ""


def _hinge(f: HingeForceResult) -> list[str]:
    needed = "lifts" if f.needed_friction is None else f"{f.needed_friction:.4f}"
    friction = "not given" if f.friction is None else f"{f.friction:.3f}"
    slides = "rocks first" if f.sliding_g is None else f"{f.sliding_g:.4f}"
    return [
        f.hinge,
        f"{f.horizontal_n:.5g}",
        f"{f.vertical_n:.5g}",
        needed,
        friction,
        "-" if f.friction is None else slides,
    ]


def directions_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write a line for each mechanism whose direction was searched for."""
    sought = [(m.name, m.direction_sweep) for m in mechanisms if m.direction_sweep is not None]
    return "".join(f"{escape_text(name)}: {weakest_text(found)}\n" for name, found in sought)


def weakest_text(found: DirectionSweep) -> str:
    """Describe the weakest direction and how flat the minimum is."""
    return (
        f"weakest towards {found.weakest_deg:.6g} deg from +x, of {len(found.angle_deg)} directions; the multiplier is "
        f"within 1 % of the least over {found.flat_deg:.3g} deg, the least {found.variation:.2%} below the largest"
    )


def csv_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write all parameters of each branch at full precision, under their names of results.json."""
    names = [field.name for field in fields(OscillatorResult) if field.name != "linearised"]
    constants = [field.name for field in fields(LinearisedResult)]
    rows = [["name", "label", "kind", "sides", "branch", *names, *(f"linearised_{name}" for name in constants)]]
    for m in mechanisms:
        for branch, o in _branches(m):
            numbers = [getattr(o, name) for name in names] + [getattr(o.linearised, name) for name in constants]
            rows.append([m.name, m.label, m.kind, m.sides, branch, *numbers])
    return csv_lines(rows)


def _branches(mechanism: MechanismResult) -> Iterator[tuple[str, OscillatorResult]]:
    yield "positive", mechanism.oscillator
    if mechanism.oscillator_negative is not None:
        yield "negative", mechanism.oscillator_negative


def _short(name: str, branch: str, o: OscillatorResult) -> list[str]:
    uplift = "none" if o.uplift_multiplier is None else f"{o.uplift_multiplier:.4f}"
    numbers = (f"{o.slenderness_rad:.4f}", f"{o.overturning_rad:.4f}", f"{o.restitution:.3f}", f"{o.mass_kg:.6g}")
    return [name, branch, f"{o.p_eq_per_s:.4f}", uplift, f"{o.radius_m:.4f}", *numbers]


def _on_joints(o: OscillatorResult) -> str:
    return "-" if o.overturning_flexible_rad is None else f"{o.overturning_flexible_rad:.4f}"
