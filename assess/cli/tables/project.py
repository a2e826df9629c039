"""What `assess check` and `assess parameters` print: the project as the program understood it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from math import atan2, degrees, inf
from textwrap import wrap
from typing import Any

from assess.cli.tables import TextField, messages_text, table_of, text_table
from assess.cli.tables.units import column, header, in_units, messages_in_units
from assess.mechanisms.chain import metres_text
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.messages.message import Message, escape_text, text_of
from assess.model.candidates import Candidate, texts_of
from assess.project.drawn_project import is_stated
from assess.project.found_mechanisms import FoundMechanisms
from assess.project.project_file import Project
from assess.project.sections import Content
from assess.project.sections.content import checklist
from assess.results import (
    DirectionCandidate,
    DirectionSweep,
    HingeForceResult,
    LinearisedResult,
    LoadResult,
    MechanismResult,
    NamedPoint,
    OscillatorResult,
    StretchingTie,
)
from assess.study.study import Sweep, UnvariedNumber, Variable
from assess.study.tie_results import LETS_GO
from reports.render.table_text import csv_lines

MOST_CANDIDATES = 8  # candidates on a line
LINE_WIDTH = 100  # characters of a line
BranchOf = tuple[str, str, OscillatorResult]
"""Names of a mechanism and of its branch, and the branch."""


MECHANISM_HEADER = ("mechanism", "multiplier", "in file", "at")


def mechanisms_text(
    found: FoundMechanisms,
    margins: Mapping[str, float] | None = None,
    overturning: Mapping[str, float | None] | None = None,
) -> str:
    """Write a line for each mechanism that the bodies of a project can have, and what has none.

    Parameters
    ----------
    found : on the bodies
    margins : PGA at capacity over the site's, by candidate, by which they are ranked then
    overturning : PGA at which the suite overturns half of its runs [g], by candidate, by which they are ranked then
    """
    ranked, values = list(found.candidates), margins if overturning is None else overturning
    if values is not None:
        ranked.sort(key=lambda each: inf if (value := values.get(each.name)) is None else value)
    rows = [
        (
            each.name,
            "none" if each.multiplier is None else f"{each.multiplier:.4g}",
            *(() if values is None else (_rank_cell(each, values, histories=overturning is not None),)),
            found.in_file.get(each.name, "no" if is_stated(each) else "by formula"),
            ", ".join(f"{name} {value}" for name, value in each.found.parameters.items()),
        )
        for each in ranked
    ]
    weakest = ", ".join(each.name for each in found.candidates.weakest)
    lines = [f"within 10 % of the least multiplier: {weakest}\n"] if weakest else []
    lines += [f"{each.name}: {escape_text(each.found.why_not)}\n" for each in found.candidates if each.found.why_not]
    for word, gaps in (("not looked for", found.candidates.gaps), ("ruled out", found.candidates.ruled_out)):
        lines += [f"{word}: {escape_text(text)}\n" for text in texts_of(gaps)]
    lines += [f"not examined: {entry}: {escape_text(why)}\n" for entry, why in found.not_examined.items()]
    lines += [f"without a mechanism: {escape_text(str(why))}\n" for why in found.candidates.without.values()]
    lines += [f"left out: {escape_text(text)}\n" for text in found.structure.left_out_texts]
    name, least, *others = MECHANISM_HEADER
    held = () if values is None else ("PGA held / site's",) if overturning is None else ("half overturn [g]",)
    return text_table((name, least, *held, *others), rows, widest=WIDEST_CELL) + "".join(lines)


WIDEST_CELL = 120  # characters: the parameters of a corner are read whole


def _rank_cell(candidate: Candidate, values: Mapping[str, float | None], *, histories: bool) -> str:
    """Write the value by which a mechanism is ranked; histories : whether it is of these."""
    value, definition = values.get(candidate.name), candidate.definition
    if value is not None:
        return f"{value:.3g}"
    return "no histories" if histories and definition and not MECHANISM_KINDS[definition.kind].rocks else "-"


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
    return "\n".join(lines) + "\n" + _branches_table(mechanisms) + messages_text(messages_in_units(notices))


def sensitivity_text(variables: Sequence[Variable | UnvariedNumber]) -> str:
    """Write a line for each mechanism with a sensitivity study: its variables with low and high values."""
    lines: dict[str, list[str]] = {}
    for each in variables:
        lines.setdefault(each.mechanism, []).append(
            _variable_text(each)
            if isinstance(each, Variable)
            else escape_text(f"{each.parameter} not varied, {each.why}".lstrip())
        )
    return "".join(f"sensitivity of {escape_text(name)}: {'; '.join(each)}\n" for name, each in lines.items())


def duration_text(load: LoadResult) -> str:
    """Describe how long a resisting load lasts, and how far it may move on its seat."""
    if load.bearing:
        return "; seat not given" if load.seat_m is None else f"; seat {_length(load.seat_m)}"
    end = "" if load.end_m is None else f"when its point has moved {_length(load.end_m)}, at {load.end_rad:.4g} rad"
    if load.lasting == "to collapse":
        return "; lasts to collapse" + (f", ends {end}" if end else "")
    if load.lasting == "to its end":
        return f"; ends {end}; ignored in displacements and histories"
    if load.lasting == "not shown":
        return (
            f"; not shown to last where it resists ({', '.join(load.missing)} missing): counts in the multiplier only"
        )
    return ""


def tie_text(tie: StretchingTie | None) -> str:
    """Describe a tie that stretches: its stiffness, where it yields, its anchorage, and what fails first."""
    if tie is None:
        return ""
    stiffness = in_units(f"{tie.stiffness_n_m / 1e6:.4g} MN/m", tie.stiffness_n_m, "spring stiffness")
    slack = f" after a slack of {_length(tie.slack_m)}" if tie.slack_m else ""
    if tie.fails == LETS_GO:
        return f"; stretches by {stiffness}{slack}; lets go at {_force(tie.yield_n)}, {_length(tie.gone_m or 0.0)}"
    begins = f"; stretches by {stiffness}{slack}, yields at {_force(tie.yield_n)}"
    if tie.anchorage_n is None:
        return f"{begins}; anchorage not answered"
    end = "" if tie.gone_m is None else f", gone when its ends have moved apart by {_length(tie.gone_m)}"
    kind = "ductile" if tie.ductile else "brittle"
    return f"{begins}; anchorage {_force(tie.anchorage_n)}: {kind}, {tie.fails} first{end}"


def checklist_lines(content: Content) -> list[str]:
    """Return the list by what became of its items, and an empty line; nothing without a type of building."""
    items = checklist(content.report, content.mechanisms)
    if not items:
        return []
    examined = [
        f"{each.key} by {escape_text(' and '.join(each.mechanisms))}" for each in items if each.outcome == "examined"
    ]
    return [
        f"possible mechanisms of a {content.report.building_type}",
        *_checklist_line("examined", examined),
        *_checklist_line("absent", [each.key for each in items if each.outcome == "absent"]),
        *_checklist_line(
            "not examined", [each.key for each in items if each.outcome == "not-examined" and each.spoken_for]
        ),
        *_checklist_line("not named", [each.key for each in items if not each.spoken_for]),
        "",
    ]


def parameters_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write the main parameters of each branch, the constants of its linearised equation, and the hinge forces."""
    return f"{_branches_table(mechanisms)}\n{_constants_table(mechanisms)}{hinge_forces_table(mechanisms)}"


def hinge_forces_table(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write the forces at each hinge when rocking starts, and the friction they need; empty where not known."""
    forces = [(m.name, forces) for m in mechanisms for forces in m.hinge_forces]
    fields_of_hinge: tuple[TextField[tuple[str, HingeForceResult]], ...] = (
        ("mechanism", lambda of: of[0]),
        ("hinge", lambda of: of[1].hinge),
        (header("H", "force"), lambda of: column(of[1].horizontal_n, "force", ".5g")),
        (header("V", "force"), lambda of: column(of[1].vertical_n, "force", ".5g")),
        ("friction needed", lambda of: _number(of[1].needed_friction, ".4f", otherwise="lifts")),
        ("friction", lambda of: _number(of[1].friction, ".3f", otherwise="not given")),
        ("slides from [g]", lambda of: _sliding(of[1])),
    )
    return f"\n{table_of(fields_of_hinge, forces)}" if forces else ""


def directions_text(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write a line for each mechanism whose direction was searched for."""
    sought = [(m.name, m.direction_sweep) for m in mechanisms if m.direction_sweep is not None]
    return "".join(f"{escape_text(name)}: {_weakest_text(found)}\n" for name, found in sought)


def parameters_csv(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write all parameters of each branch at full precision, under their names of results.json."""
    names = [field.name for field in fields(OscillatorResult) if field.name != "linearised"]
    constants = [field.name for field in fields(LinearisedResult)]
    rows = [["name", "label", "kind", "sides", "branch", *names, *(f"linearised_{name}" for name in constants)]]
    for m in mechanisms:
        for branch, o in _branches(m):
            numbers = [getattr(o, name) for name in names] + [getattr(o.linearised, name) for name in constants]
            rows.append([m.name, m.label, m.kind, m.sides, branch, *numbers])
    return csv_lines(rows)


def _variable_text(variable: Variable) -> str:
    unit = "" if variable.unit == "-" else f" {variable.unit}"
    table, _, rest = variable.key.partition(".")
    of = f" of {escape_text(rest.rpartition('.')[0])}" if table == "materials" else ""
    return f"{variable.parameter}{of} {variable.low:.4g} to {variable.high:.4g}{unit}"


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
        f"  centroid    {_point_text(m.drawing.centroid)}",
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
        f"{found.method}, base {_length(found.height_m)} above the ground",
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
    stiffness, strength = "infinitely stiff", "no crushing"
    if not infinite:
        stiffness = in_units(f"{found['stiffness_pa_m'] / 1e9:.4g} GPa/m", found["stiffness_pa_m"], "stiffness")
    if found["strength_pa"] is not None:
        strength = in_units(f"{found['strength_pa'] / 1e6:.4g} MPa", found["strength_pa"], "stress")
    opens, crushes = (
        "never" if found[key] is None else f"at {found[key]:.3g} rad" for key in ("opening_rad", "crushing_rad")
    )
    area = in_units(f"{found['area_m2']:.4g} m2", found["area_m2"], "area")
    return (
        f"{found['model']}, {stiffness}, {strength}; {area}, "
        f"{_length(found['depth_m'])} deep, under {_force(found['normal_force_n'])} at rest; "
        f"by rotation of the joint itself it opens {opens}, crushes {crushes}"
    )


def _loads(loads: tuple[LoadResult, ...]) -> list[str]:
    lines = [
        f"{escape_text(load.name)} at {_point_text(load.at)}: {_size(load)}; "
        f"{escape_text(load.source)}{duration_text(load)}{tie_text(load.tie)}"
        for load in loads
    ]
    return [f"  {'loads' if i == 0 else '':<11} {line}" for i, line in enumerate(lines or ["none"])]


def _size(load: LoadResult) -> str:
    if load.mass_kg is not None:
        mass = in_units(f"{load.mass_kg:.6g} kg", load.mass_kg, "mass", 6)
        return f"{mass}, {'bearing' if load.bearing else 'horizontal inertia only'}"
    along, up = load.force_n or (0.0, 0.0)
    return f"{load.kind} {_force(along)} along the direction, {_force(up)} up"


def _force(newtons: float) -> str:
    return in_units(f"{newtons / 1e3:.4g} kN", newtons, "force")


def _length(metres: float) -> str:
    return in_units(f"{metres:.4g} m", metres, "length")


def _coordinate(metres: float) -> str:
    return in_units(f"{metres_text(metres)} m", metres, "length")


def _sweep(sweep: Sweep) -> str:
    names = ", ".join(escape_text(mechanism.name) for mechanism in sweep.cases[0].study.mechanisms)
    values = ", ".join(f"{case.value:.6g}" for case in sweep.cases)
    unit = "" if sweep.unit == "-" else f" {sweep.unit}"
    return f"sweep of {escape_text(sweep.key)}: {values}{unit}, of {names}"


def _direction(mechanism: MechanismResult) -> list[str]:
    if mechanism.direction_sweep is not None:
        return [f"  direction   {_weakest_text(mechanism.direction_sweep)}"]
    if mechanism.direction is None:
        return []
    along, across, _ = mechanism.direction
    lines = [f"  direction   towards {degrees(atan2(across, along)) % 360.0:.6g} deg from +x"]
    known = [each for each in mechanism.candidates if each.uplift_multiplier is not None]
    if known:
        more = " …" if len(known) > MOST_CANDIDATES else ""
        lines.append(f"  {'candidates':<11} {', '.join(map(_candidate, known[:MOST_CANDIDATES]))}{more}")
    return lines


def _candidate(candidate: DirectionCandidate) -> str:
    touched = f" (stopped by {', '.join(map(escape_text, candidate.touching))})" if candidate.touching else ""
    return f"{candidate.angle_deg:.6g} deg {candidate.uplift_multiplier:.4g}{touched}"


def _ground(m: MechanismResult) -> list[str]:
    """Describe how high the mechanism is above the ground, and where the ground level comes from."""
    if m.base_elevation_m is None or m.input_height_m is None:
        return []
    counts = "above the ground" if m.above_ground else "on the ground"
    base, held = _coordinate(m.base_elevation_m), _coordinate(m.input_height_m)
    heights = f"base {base} over the ground, held at {held}: {counts}"
    return [f"  ground      {heights}; {escape_text(m.ground_known_from)}"]


def _points(points: tuple[NamedPoint, ...]) -> str:
    return "; ".join(f"{escape_text(point.name)} at {_point_text(point.at)}" for point in points) or "none"


def _point_text(point: tuple[float, float]) -> str:
    return f"x = {_coordinate(point[0])}, z = {_coordinate(point[1])}"


def _checklist_line(what: str, words: Sequence[str]) -> list[str]:
    """Return the items of one outcome, wrapped; nothing where there are none."""
    indent = " " * 16
    return wrap(
        ", ".join(words),
        LINE_WIDTH,
        initial_indent=f"  {what}".ljust(16),
        subsequent_indent=indent,
        break_on_hyphens=False,
    )


def _branches_table(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write the main parameters of each branch, rounded, with phi_ov of flexible joints beside the rigid one."""
    pairs = [(mechanism.name, *pair) for mechanism in mechanisms for pair in _branches(mechanism)]
    on_joints: TextField[BranchOf] = (
        "on joints [rad]",
        lambda of: _number(of[2].overturning_flexible_rad, ".4f", otherwise="-"),
    )
    fields_of_branch: tuple[TextField[BranchOf], ...] = (
        ("mechanism", lambda of: of[0]),
        ("branch", lambda of: of[1]),
        ("p [1/s]", lambda of: f"{of[2].p_eq_per_s:.4f}"),
        ("lambda [-]", lambda of: _number(of[2].uplift_multiplier, ".4f", otherwise="none")),
        (header("R", "length"), lambda of: column(of[2].radius_m, "length", ".4f")),
        ("alpha [rad]", lambda of: f"{of[2].slenderness_rad:.4f}"),
        ("phi_ov [rad]", lambda of: f"{of[2].overturning_rad:.4f}"),
        *([on_joints] if any(o.overturning_flexible_rad is not None for _, _, o in pairs) else []),
        ("restitution", lambda of: f"{of[2].restitution:.3f}"),
        (header("mass", "mass"), lambda of: column(of[2].mass_kg, "mass", ".6g")),
    )
    return table_of(fields_of_branch, pairs)


def _constants_table(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Write I, K, B, M, phi_cr and phi_ov of each linearised branch (thesis 3.4-3.12), rounded."""
    rows = [
        [
            mechanism.name,
            branch,
            *(
                column(getattr(o.linearised, field.name), dimension, ".5g")
                for field, (_, dimension) in zip(fields(LinearisedResult), CONSTANTS, strict=True)
            ),
        ]
        for mechanism in mechanisms
        for branch, o in _branches(mechanism)
    ]
    return text_table(("linearised", "branch", *(header(*each) for each in CONSTANTS)), rows)


CONSTANTS = (
    ("I", "inertia"),
    ("K", "rotational stiffness"),
    ("B", "first moment"),
    ("M", "moment"),
    ("phi_cr", "rotation"),
    ("phi_ov", "rotation"),
    ("lambda", "ratio"),
)
"""The columns of the linearised equation, with their dimensions, in the order of its results."""


def _sliding(forces: HingeForceResult) -> str:
    return "-" if forces.friction is None else _number(forces.sliding_g, ".4f", otherwise="rocks first")


def _number(value: float | None, form: str, *, otherwise: str) -> str:
    return otherwise if value is None else f"{value:{form}}"


def _weakest_text(found: DirectionSweep) -> str:
    """Describe the weakest direction and how flat the minimum is."""
    return (
        f"weakest towards {found.weakest_deg:.6g} deg from +x, of {len(found.angle_deg)} directions; the multiplier is "
        f"within 1 % of the least over {found.flat_deg:.3g} deg, the least {found.variation:.2%} below the largest"
    )


def _branches(mechanism: MechanismResult) -> Iterator[tuple[str, OscillatorResult]]:
    yield "positive", mechanism.oscillator
    if mechanism.oscillator_negative is not None:
        yield "negative", mechanism.oscillator_negative
