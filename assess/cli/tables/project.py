"""What `assess check` prints: the project as the program understood it."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, degrees
from typing import Any

from assess.cli.tables.checklist import checklist_lines
from assess.cli.tables.messages import messages_text
from assess.cli.tables.parameters import table_text, weakest_text
from assess.mechanisms.chain import format_metres
from assess.messages.message import Message, text_of
from assess.project.key_text import escape_text
from assess.project.schema import Project
from assess.results import DirectionCandidate, LoadResult, MechanismResult, NamedPoint
from assess.study.study import Sweep, Unvaried, Variable

MOST = 8  # candidates on a line


def description(
    project: Project, mechanisms: tuple[MechanismResult, ...], sweeps: tuple[Sweep, ...], notices: tuple[Message, ...]
) -> str:
    """Describe the site, each mechanism with its geometry, loads and interfaces, sweeps, parameters and warnings."""
    title = escape_text(project.content.title) or "no title"
    lines = [f"{project.path}: {title}", _site(project), _motions(project), ""]
    for mechanism in mechanisms:
        lines += [*_mechanism(mechanism), ""]
    lines += [*map(_sweep, sweeps), *[""] * bool(sweeps)]
    lines += checklist_lines(project.content)
    return "\n".join(lines) + "\n" + table_text(mechanisms) + messages_text(notices)


def sensitivity_text(variables: Sequence[Variable | Unvaried]) -> str:
    """Write a line for each mechanism with a sensitivity study: its variables with low and high values."""
    lines: dict[str, list[str]] = {}
    for each in variables:
        lines.setdefault(each.mechanism, []).append(
            _variable_text(each) if isinstance(each, Variable) else _unvaried_text(each)
        )
    return "".join(f"sensitivity of {escape_text(name)}: {'; '.join(each)}\n" for name, each in lines.items())


def _variable_text(variable: Variable) -> str:
    unit = "" if variable.unit == "-" else f" {variable.unit}"
    table, _, rest = variable.key.partition(".")
    of = f" of {escape_text(rest.rpartition('.')[0])}" if table == "materials" else ""
    return f"{variable.parameter}{of} {variable.low:.4g} to {variable.high:.4g}{unit}"


def _unvaried_text(number: Unvaried) -> str:
    return escape_text(f"{number.parameter} not varied, {number.why}".lstrip())


def _site(project: Project) -> str:
    site = project.content.site
    return "site: none; `assess run` needs one" if site is None else f"site: spectrum {site.spectrum.code}"


def _motions(project: Project) -> str:
    records = project.content.records
    if records.lock is not None:
        return f"records: those of {escape_text(records.lock.name)}"
    artificial = 0 if records.synthetic is None else records.synthetic.count
    if records.select is not None:
        of = f"{records.select.count} selected out of {len(records.files)} files or folders"
        return f"records: {of}, {artificial} artificial"
    return f"records: {len(records.files)} from files, {artificial} artificial"


def _mechanism(m: MechanismResult) -> list[str]:
    label = f" ({escape_text(m.label)})" if m.label and m.label != m.name else ""
    sides = "two-sided" if m.sides == "two" else "one-sided"
    return [
        f"{escape_text(m.name)}{label}: {m.kind}, {sides}, {m.equation} equation",
        *_direction(m),
        *_ground(m),
        f"  hinges      {_points(m.drawing.hinges)}",
        f"  centroid    {_at(m.drawing.centroid)}",
        *_loads(m.loads),
        *_interfaces(m),
        f"  impacts     {escape_text(m.restitution_source)}",
        *_amplification(m),
    ]


def _amplification(m: MechanismResult) -> list[str]:
    found = m.amplification
    if found.height_m is None:
        return []
    lines = [
        f"{found.method}, base {found.height_m:.4g} m above the ground",
        *map(escape_text, map(text_of, found.said)),
    ]
    return [f"  {'motion' if i == 0 else '':<11} {line}" for i, line in enumerate(lines)]


def _interfaces(m: MechanismResult) -> list[str]:
    yielding = [interface for interface in m.interfaces if interface["curve"] is not None]
    if not yielding:
        return ["  interface   rigid"]
    alike: dict[str, list[str]] = {}
    for each in yielding:
        alike.setdefault(_interface(each), []).append(escape_text(each["hinge"]))
    sentences = [f"{', '.join(hinges)}: {text}" for text, hinges in alike.items()]
    lines = [f"  {'interfaces' if i == 0 else '':<11} {sentence}" for i, sentence in enumerate(sentences)]
    rest = m.oscillator
    if rest.elastic_frequency_hz is not None:
        lines.append(
            f"  rest        at {rest.equilibrium_rad:.4g} rad; small motions at {rest.elastic_frequency_hz:.4g} Hz"
        )
    return lines


def _interface(found: dict[str, Any]) -> str:
    infinite = found["stiffness_pa_m"] is None
    stiffness = "infinitely stiff" if infinite else f"{found['stiffness_pa_m'] / 1e9:.4g} GPa/m"
    strength = "no crushing" if found["strength_pa"] is None else f"{found['strength_pa'] / 1e6:.4g} MPa"
    opens, crushes = (
        "never" if found[key] is None else f"at {found[key]:.3g} rad" for key in ("opening_rad", "crushing_rad")
    )
    force = f"{found['normal_force_n'] / 1e3:.4g} kN"
    return (
        f"{found['model']}, {stiffness}, {strength}; {found['area_m2']:.4g} m2, "
        f"{found['depth_m']:.4g} m deep, under {force} at rest; "
        f"by rotation of the joint itself it opens {opens}, crushes {crushes}"
    )


def _loads(loads: tuple[LoadResult, ...]) -> list[str]:
    lines = [
        f"{escape_text(load.name)} at {_at(load.at)}: {_size(load)}; {escape_text(load.source)}{duration_text(load)}"
        for load in loads
    ]
    return [f"  {'loads' if i == 0 else '':<11} {line}" for i, line in enumerate(lines or ["none"])]


def _size(load: LoadResult) -> str:
    if load.mass_kg is not None:
        return f"{load.mass_kg:.6g} kg, {'bearing' if load.bearing else 'horizontal inertia only'}"
    along, up = load.force_n or (0.0, 0.0)
    return f"{load.kind} {along / 1e3:.4g} kN along the direction, {up / 1e3:.4g} kN up"


def duration_text(load: LoadResult) -> str:
    """Describe how long a resisting load lasts, and how far it may move on its seat."""
    if load.bearing:
        return "; seat not given" if load.seat_m is None else f"; seat {load.seat_m:.4g} m"
    end = "" if load.end_m is None else f"when its point has moved {load.end_m:.4g} m, at {load.end_rad:.4g} rad"
    if load.lasting == "to collapse":
        return "; lasts to collapse" + (f", ends {end}" if end else "")
    if load.lasting == "to its end":
        return f"; ends {end}; ignored in displacements and histories"
    if load.lasting == "not shown":
        return (
            f"; not shown to last where it resists ({', '.join(load.missing)} missing): counts in the multiplier only"
        )
    return ""


def _sweep(sweep: Sweep) -> str:
    names = ", ".join(escape_text(mechanism.name) for mechanism in sweep.cases[0].study.mechanisms)
    values = ", ".join(f"{case.value:.6g}" for case in sweep.cases)
    unit = "" if sweep.unit == "-" else f" {sweep.unit}"
    return f"sweep of {escape_text(sweep.key)}: {values}{unit}, of {names}"


def _direction(mechanism: MechanismResult) -> list[str]:
    if mechanism.direction_sweep is not None:
        return [f"  direction   {weakest_text(mechanism.direction_sweep)}"]
    if mechanism.direction is None:
        return []
    along, across, _ = mechanism.direction
    lines = [f"  direction   towards {degrees(atan2(across, along)) % 360.0:.6g} deg from +x"]
    known = [each for each in mechanism.candidates if each.uplift_multiplier is not None]
    if known:
        lines.append(
            f"  {'candidates':<11} {', '.join(map(_candidate, known[:MOST]))}{' …' if len(known) > MOST else ''}"
        )
    return lines


def _candidate(candidate: DirectionCandidate) -> str:
    touched = f" (stopped by {', '.join(map(escape_text, candidate.touching))})" if candidate.touching else ""
    return f"{candidate.angle_deg:.6g} deg {candidate.uplift_multiplier:.4g}{touched}"


def _ground(m: MechanismResult) -> list[str]:
    """Describe how high the mechanism is above the ground, and where the ground level comes from."""
    if m.base_elevation_m is None or m.input_height_m is None:
        return []
    counts = "above the ground" if m.above_ground else "on the ground"
    base, held = format_metres(m.base_elevation_m), format_metres(m.input_height_m)
    heights = f"base {base} m over the ground, held at {held} m: {counts}"
    return [f"  ground      {heights}; {escape_text(m.ground_known_from)}"]


def _points(points: tuple[NamedPoint, ...]) -> str:
    return "; ".join(f"{escape_text(point.name)} at {_at(point.at)}" for point in points) or "none"


def _at(point: tuple[float, float]) -> str:
    return f"x = {format_metres(point[0])} m, z = {format_metres(point[1])} m"
