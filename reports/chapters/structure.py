"""The chapter on the structure: its materials, its bodies, and all mechanisms side by side."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from assess.results import MechanismResult, Resolved, Results
from reports import joints
from reports.chapters import check_tables
from reports.document import Block, Cell, Column, Figure, Section, Table, nonempty
from reports.figures import overview
from reports.language.measures import as_typed, unit_word
from reports.language.numerals import as_cell
from reports.mechanism_title import mechanism_title

_MATERIAL = (
    ("density", "Density", "kg/m³"),
    ("young_modulus", "Young’s modulus, E", "Pa"),
    ("compressive_strength", "Compressive strength, f_m", "Pa"),
    ("tensile_strength", "Tensile strength, f_mt", "Pa"),
    ("friction", "Friction, μ", "-"),
)
_GEOMETRY = {"mesh": "", "box": "m", "profile": "m", "mass": "kg"}  # with their units
Tables = dict[str, dict[str, Resolved]]


def section(results: Results) -> list[Section]:
    """Return the chapter; none where there is nothing to show."""
    blocks: list[Block] = [
        *nonempty(materials(results)),
        *nonempty(bodies(results)),
        *overviews(results.mechanisms),
        *nonempty(mechanisms(results)),
    ]
    return [Section("Structure and materials", 0, tuple(blocks), starts_page=True)] if blocks else []


def overviews(mechanisms: tuple[MechanismResult, ...]) -> list[Figure]:
    """Return figures of all mechanisms at rest to one scale, as many to a figure as a page holds."""
    pages = [mechanisms[at : at + overview.MOST] for at in range(0, len(mechanisms), overview.MOST)]
    caption = (
        "The mechanisms at rest in their planes of motion, all to one scale, with the hinges of the positive branch. "
        "Grey masonry does not move."
    )
    return [
        Figure(f"overview-{place}" if len(pages) > 1 else "overview", caption, partial(overview.draw, page))
        for place, page in enumerate(pages, start=1)
    ]


def materials(results: Results) -> Table:
    """Tabulate the materials with their properties."""
    rows = tuple(
        (name, *(_value(found, key) for key, _, _ in _MATERIAL))
        for name, found in tables_of(results, "materials").items()
    )
    columns = (Column("Material"), *(Column(label, unit, "given") for _, label, unit in _MATERIAL))
    return Table("materials", "Materials. Their sources are listed under Assumptions.", columns, rows)


def bodies(results: Results) -> Table:
    """Tabulate the bodies and the source of their geometry."""
    rows = tuple(
        (name, _value(found, "material"), _geometry(found)) for name, found in tables_of(results, "bodies").items()
    )
    return Table("bodies", "Bodies.", (Column("Body"), Column("Material"), Column("Geometry")), rows)


def tables_of(results: Results, table: str) -> Tables:
    """Return the tables [table.NAME] of the project by name: key -> value."""
    found: Tables = {}
    for key, value in results.project.items():
        start, _, rest = key.partition(".")
        name, _, last = rest.partition(".")
        if start == table and last:
            found.setdefault(name, {})[last] = value
    return found


def _value(found: Mapping[str, Resolved], key: str) -> Cell:
    return as_cell(found[key].value) if key in found else None


def _geometry(found: Mapping[str, Resolved]) -> str:
    for key, unit in _GEOMETRY.items():
        inside = {name: each.value for name, each in found.items() if name == key or name.startswith(f"{key}.")}
        given = {name: value for name, value in inside.items() if value is not None}
        if given:
            return "; ".join(f"{name.replace('.', ' ')} {_sized(value, unit)}" for name, value in given.items())
    return ""


def _sized(value: object, unit: str) -> Cell:
    return f"{as_typed(value, unit)} {unit_word(unit)}" if unit else as_cell(value)


def mechanisms(results: Results) -> Table:
    """Tabulate every mechanism by its rocking parameters (as thesis Table 8.2)."""
    columns = (
        Column("Mechanism"),
        Column("Kind"),
        Column("Sides"),
        Column("Interface"),
        Column("Mass", "kg", "number"),
        Column("R", "m", "number"),
        Column("α", "rad", "number"),
        Column("p", "1/s", "number"),
        Column("λ", "-", "number"),
        Column("φₒᵥ", "rad", "number"),
        Column("η", "-", "number"),
    )
    caption = (
        "The mechanisms by their rocking parameters, of the positive branch (as thesis Table 8.2): radius and "
        "slenderness of the equivalent block, frequency parameter, load multiplier at uplift, overturning rotation, "
        "restitution."
    )
    return Table("mechanisms", caption, columns, tuple(_row(mechanism) for mechanism in results.mechanisms))


def _row(mechanism: MechanismResult) -> tuple[Cell, ...]:
    of = mechanism.oscillator
    numbers = (
        of.radius_m,
        of.slenderness_rad,
        of.p_eq_per_s,
        check_tables.uplift_cell(of.uplift_multiplier),
        of.overturning_rad,
    )
    kind = (mechanism_title(mechanism), mechanism.kind, mechanism.sides, joints.model_name(mechanism))
    return (*kind, of.mass_kg, *numbers, of.restitution)
