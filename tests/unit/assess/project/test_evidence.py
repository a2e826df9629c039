"""Every key of a project file says who vouches for it, in its table, in the list of keys and in the schema."""

import json
from collections.abc import Iterator
from dataclasses import asdict
from math import pi
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from assess.declaration import Safe
from assess.project.evidence import every_key
from assess.project.project_file import json_schema
from assess.project.section import EVIDENCE

KEYS = {str(key): key for key in every_key()}


def test_every_key_says_who_vouches_for_it() -> None:
    assert [name for name, key in KEYS.items() if key.evidence is None] == []


def test_what_changes_no_outcome_helps_no_wall_and_needs_nothing_instead() -> None:
    for name, key in KEYS.items():
        if key.evidence is not None and key.evidence.kind == "free":
            assert (key.evidence.helps, key.evidence.instead) == ("none", "nothing"), name


def test_a_key_that_helps_no_wall_is_free_or_says_why() -> None:
    for name, key in KEYS.items():
        if key.evidence is not None and key.evidence.helps == "none":
            assert key.evidence.kind == "free" or key.evidence.judged, name


def test_a_choice_that_can_help_a_wall_has_its_values_in_order() -> None:
    """Of a choice "more" means nothing: it helps by one of its values against another."""
    for name, key in KEYS.items():
        choices = _choices(key.field.annotation)
        if key.evidence is not None and choices is not None:
            order = key.evidence.helps
            if isinstance(order, str):
                assert order in ("either", "none"), f"{name}: list its values from the one that helps least"
            else:
                assert sorted(map(str, order)) == sorted(map(str, choices)), name


def test_what_is_measured_and_helps_either_way_has_a_range_or_something_in_its_place() -> None:
    """No stiffness, period or restitution stands as typed where no source vouches for it."""
    stated = {
        name
        for name, key in KEYS.items()
        if key.evidence is not None
        and (key.evidence.kind, key.evidence.helps, key.evidence.safe) == ("measured", "either", Safe.STATED)
    }
    assert stated == {"procedures.ntc2018.free_periods.NAME.young_modulus"}  # its table is left out


CASE = "it is the case itself, which somebody else states: the drawing, or the hazard of the site"
HELD = "it is held against something else, and a pass is incomplete, or has a condition, where it does not fit"
TARGET = "it sets what is compared with the index, which page 1 prints beside it"
PUBLISHED = "nothing is drawn that gives another, and a pass without a source has that as condition"
TABLE = "its whole table is left out: the outline of the mesh counts in place of the shape"
TOOTHING = "its whole table is left out: no friction of side walls counts"
PLATE = (
    *("width", "height", "diameter", "thickness", "yield_stress", "nut", "thread_area", "tensile_strength"),
    *(
        "shear_strength",
        "friction",
        "normal_stress",
        "bearing_strength",
        "leaf",
        "between",
        "far_strength",
        "course",
        "overlap",
    ),
    *("hole", "embedment", "bond_strength"),
)
REASON = "the reason stands there, or the file is refused, and a pass has it as condition"
SHARED_FATE = "alone it vouches for nothing: what it is the reason or source of is replaced with it"
RISK = "it bears on fragility and risk, of which no verdict asks"
MAY_STAND = {
    CASE: (
        *("site.spectrum.damping (table)", "site.spectrum.s_ds (asce7)", "site.spectrum.s_d1 (asce7)"),
        *("site.spectrum.t_l (asce7, mapped)", "site.spectrum.s_s (mapped)", "site.spectrum.s_1 (mapped)"),
        *("site.spectrum.hazard[].return_period", "site.spectrum.hazard[].a_g", "site.spectrum.hazard[].t_c_star"),
        *("site.spectrum.a_g (ec8, national ec8, ntc)", "site.spectrum.z (nzs1170.5)", "site.spectrum.t_c_star (ntc)"),
        *("site.spectrum.topography (ntc, hazard, grid)", "building.storeys", "bodies.NAME.box.thickness"),
        *("site.spectrum.pga_site (ts1170.5)", "site.spectrum.s_as (ts1170.5)"),
        *("site.spectrum.t_c (ts1170.5)", "site.spectrum.t_d (ts1170.5)", "bodies.NAME.box.height"),
    ),
    HELD: (
        *("site.spectrum.return_period (nzs1170.5)", "site.spectrum.nominal_life (hazard, grid)", "site.return_period"),
        *(
            "site.spectrum.phase (hazard, grid)",
            "site.spectrum.use_class (hazard, grid)",
            "site.pga",
            "building.use_class",
        ),
        *(
            "building.importance_level",
            "verdict.rule",
            "analysis.scan",
            "site.spectrum.return_period (table of ts1170.5)",
            "procedures.asce43-05.floor_spectrum",
        ),
        *("materials.NAME.disintegration", "bodies.NAME.disintegration (direct)"),
        *("mechanisms.NAME.disintegration (equivalent-block)", "records.select.count", "records.synthetic.count"),
    ),
    TARGET: ("verdict.works", "verdict.upgrading", "verdict.target_nbs"),
    PUBLISHED: tuple(f"mechanisms.NAME.{key} (equivalent-block)" for key in ("p", "uplift", "radius", "elevation")),
    TABLE: tuple(
        f"mechanisms.NAME.{joint}.shape.{form}"
        for joint in ("interface", "interfaces.NAME")
        for form in ("rectangle", "hollow_rectangle", "circle", "annulus", "polygon")
    ),
    TOOTHING: tuple(
        f"mechanisms.NAME.side_walls.{key}"
        for key in ("bond", "course", "overlap", "thickness", "friction", "density", "count")
    ),
    REASON: ("report.struck_out.NAME",),
    SHARED_FATE: ("building.limit_states.NAME.reason", "report.sources.NAME"),
    RISK: (
        *("analysis.fragility.epistemic.NAME", "analysis.risk.target"),
        *(f"analysis.risk.hazard[].{key}" for key in ("pga", "return_period", "rate")),
    ),
    "the plate is left out whole where no source vouches for it": tuple(
        f"mechanisms.NAME.loads[].plate.{key}" for key in PLATE
    ),
    "without a source the tie counts in the multiplier alone, where a slack one has no part": (
        "mechanisms.NAME.loads[].slack (tie)",
    ),
    "only what is at the limit hangs on it, no outcome": ("verdict.survey_tolerance",),
    "a factor up the building may let histories fail, and never pass": (
        "mechanisms.NAME.amplification.soil_factor (printed)",
    ),
    "no less than 1 is read, its default, which more of it makes worse": ("procedures.ec8.importance_factor",),
}
"""Why a key stands as typed though it may help a wall and nobody vouches for it."""


def test_what_may_help_a_wall_has_something_in_its_place_or_a_reason_to_stand() -> None:
    stated = [
        name
        for name, key in KEYS.items()
        if key.evidence is not None
        and key.evidence.helps not in ("either", "none")
        and key.evidence.safe is Safe.STATED
    ]
    assert sorted(stated) == sorted(name for names in MAY_STAND.values() for name in names)


def test_only_a_choice_in_order_has_a_first_value() -> None:
    for name, key in KEYS.items():
        if key.evidence is not None and key.evidence.safe is Safe.FIRST:
            assert not isinstance(key.evidence.helps, str), name


def _choices(annotation: Any) -> tuple[Any, ...] | None:
    """Return the values of a choice; None for what may be anything else too."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Literal:
        return parts
    if annotation is bool:
        return (False, True)
    if origin is Annotated:
        return _choices(parts[0])
    held = [part for part in parts if part is not NoneType]
    return _choices(held[0]) if origin in (Union, UnionType) and len(held) == 1 else None


def test_a_key_is_listed_with_its_place_form_dimension_bounds_and_default() -> None:
    thickness = KEYS["bodies.NAME.box.thickness"]
    assert (thickness.dimension, thickness.bounds, thickness.required) == ("length", {"above": 0.0}, True)
    pull, push = KEYS["mechanisms.NAME.loads[].force (tie)"], KEYS["mechanisms.NAME.loads[].force (force)"]
    assert pull.evidence is not None
    assert push.evidence is not None
    assert (pull.evidence.kind, push.evidence.kind) == ("measured", "loads")
    crack = KEYS["mechanisms.NAME.cut.angle (cut angle)"]
    assert crack.bounds == {"above": -pi / 2, "below": pi / 2}
    assert KEYS["building.damping"].default == 0.05
    assert KEYS["procedures.asce41-13.seismicity"].default == "high"
    assert {"procedures.ntc2018.free_periods.NAME", "procedures.ntc2018.free_periods.NAME.length"} < KEYS.keys()
    assert "records.select.for" in KEYS
    assert "KEY.cov" in KEYS


def test_the_schema_has_the_evidence_of_each_key_and_no_other() -> None:
    schema = json_schema()
    listed = {_written_text(asdict(key.evidence)) for key in KEYS.values() if key.evidence is not None}
    assert {_written_text(each) for each in _found(schema)} == listed
    density = schema["$defs"]["MaterialSection"]["properties"]["density"]
    assert density.pop(EVIDENCE)["kind"] == "defines"
    assert EVIDENCE not in str(density)
    assert "judged" not in schema["properties"]["title"][EVIDENCE]


def test_the_keys_listed_are_those_of_the_schema_that_hold_a_value() -> None:
    schema = json_schema()
    listed = {key.path for key in KEYS.values() if not key.path.startswith("KEY.")}
    assert set(_values_of(schema, "", schema["$defs"])) == listed


def _values_of(node: dict[str, Any], path: str, definitions: dict[str, Any]) -> Iterator[str]:
    """Yield the places at which a schema takes a value that is no table; a list of values is one."""
    if "$ref" in node:
        name = node["$ref"].removeprefix("#/$defs/")
        if not name.startswith("UncertainNumber"):
            yield from _values_of(definitions[name], path, definitions)
    forms = (node[word] for word in ("then", "else") if word in node)
    for each in (*node.get("anyOf", ()), *node.get("oneOf", ()), *forms):
        yield from _values_of(each, path, definitions)
    for key, each in node.get("properties", {}).items():
        yield from _values_of(each, f"{path}.{key}".lstrip("."), definitions)
    if isinstance(each := node.get("additionalProperties"), dict):
        yield from _values_of(each, f"{path}.NAME", definitions)
    for each in (*node.get("prefixItems", ()), *([node["items"]] if "items" in node else [])):
        yield from _values_of(each, f"{path}[]", definitions)
    if node.get("type") not in (None, "object", "array") or "enum" in node or "const" in node:
        yield path.rstrip("[]")


def _found(node: Any) -> Iterator[dict[str, str]]:
    if isinstance(node, dict):
        for key, each in node.items():
            if key == EVIDENCE:
                yield each
            else:
                yield from _found(each)
    elif isinstance(node, list):
        for each in node:
            yield from _found(each)


def _written_text(evidence: dict[str, Any]) -> str:
    return json.dumps({name: text for name, text in evidence.items() if text and name != "safe"}, sort_keys=True)
