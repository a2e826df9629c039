"""Consistency of results beyond their types: finite numbers, columns of equal length, indices and names that exist.

Results are written so; a file that was edited since may not be, and would be drawn or summed wrongly.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from math import isfinite
from typing import Any

from assess import results as r
from assess.codes.check import PgaCurve
from assess.results.fragility import CurveBand, HazardResult, RecordRuns

_PLAIN = {float, int, bool, str, type(None)}

Groups = tuple[tuple[str, ...], ...]
OF_ONE_LENGTH: Mapping[type, Groups] = {
    PgaCurve: (("rotation_ratio", "pga_g"),),
    r.SpectrumResult: (("period_s", "acceleration_g"),),
    r.RecordSpectrum: (("period_s", "acceleration_g"),),
    r.GroundMotionResult: (("period_s", "target_g", "mean_g", "geometric_mean_g"),),
    r.Displaced: (("blocks", "block_of"),),
    r.Drawing: (("blocks", "block_of"),),
    r.View: (("triangles", "block_of"),),
    r.BranchCurve: (tuple(field.name for field in fields(r.BranchCurve)),),
    r.CarriedMotion: (
        ("time_s", "ground_acceleration_g", "base_acceleration_g"),
        ("period_s", "ground_spectrum_g", "base_spectrum_g"),
    ),
    r.Trace: (("time_s", "rotation_rad", "ground_acceleration_g", "base_acceleration_g"),),
    r.DirectionSweep: (("angle_deg", "uplift_multiplier", "p_eq_per_s", "overturning_rad"),),
    r.BranchMoment: (("rotation_rad", "restoring_n_m"),),
    r.EnvelopeResult: (
        ("frequency_hz", "overturned", "lower_bound_g", "polarity", "islands", "uplift_g", "factor", "omega",
         "lower_bound_ratio"),
    ),
    r.CriticalResult: (("frequency_hz", "mechanism", "lower_bound_g", "runner_up", "margin", "near"),),
    r.SweepResult: (
        ("value", "p_eq_per_s", "uplift_multiplier", "overturning_rad", "overturning_flexible_rad",
         "elastic_frequency_hz", "restitution", "demand_capacity", "overturned", "capacity_pga_g", "outcome"),
    ),
    RecordRuns: (("scale", "ratio"),),
    CurveBand: (("intensity", "low", "high"),),
    HazardResult: (("intensity", "annual_rate"),),
}  # fmt: skip
"""Fields of each type that are columns of one table; a field that is None is ignored."""


def faults(value: Any, where: str = "") -> Iterator[str]:
    """Yield what is wrong with results or a part of them, with its place, one by one."""
    if isinstance(value, float):
        if not isfinite(value):
            yield f"{where}: {value} is not a finite number"
    elif is_dataclass(value):
        yield from _field_faults(value, where)
    elif isinstance(value, Mapping):
        for key, each in value.items():
            yield from faults(each, f"{where}.{key}".lstrip("."))
    elif isinstance(value, tuple | list):
        yield from _item_faults(value, where)


def _field_faults(value: Any, where: str) -> Iterator[str]:
    for names in OF_ONE_LENGTH.get(type(value), ()):
        lengths = {name: len(column) for name in names if (column := getattr(value, name)) is not None}
        if len(set(lengths.values())) > 1:
            counted = ", ".join(f"{number} of {name}" for name, number in lengths.items())
            yield f"{where}: columns of unequal length: {counted}"
    yield from _index_faults(value, where)
    for field in fields(value):
        yield from faults(getattr(value, field.name), f"{where}.{field.name}".lstrip("."))


def _item_faults(items: tuple[Any, ...] | list[Any], where: str) -> Iterator[str]:
    kinds = set(map(type, items))
    if kinds <= _PLAIN and (float not in kinds or all(isfinite(each) for each in items if type(each) is float)):
        return  # most of them, checked at once
    for place, each in enumerate(items):
        yield from faults(each, f"{where}[{place}]")


def _index_faults(value: Any, where: str) -> Iterator[str]:
    """Yield indices that are out of range."""
    if isinstance(value, r.View):
        if any(not 0 <= corner < len(value.vertices) for triangle in value.triangles for corner in triangle):
            yield f"{where}.triangles: a corner that is none of the vertices"
    elif isinstance(value, r.EnvelopeResult):
        if any(len(row) != len(value.amplitude_g) for row in value.overturned):
            yield f"{where}.overturned: a row that has not one value for each amplitude_g"
    elif isinstance(value, r.Results):
        yield from _name_faults(value)
    elif isinstance(value, r.SweepResult) and not 0 <= value.controlling < len(value.value):
        yield f"{where}.controlling: {value.controlling} is none of the {len(value.value)} cases"


def _name_faults(results: r.Results) -> Iterator[str]:
    """Yield names of mechanisms that are repeated, and names elsewhere that are not among them."""
    names = [each.name for each in results.mechanisms]
    for place, name in enumerate(names):
        if name in names[:place]:
            yield f"mechanisms[{place}].name: {json.dumps(name)} a second time"
    used_in = {
        "comparison": [row.mechanism for row in results.comparison],
        "verdict.mechanisms": [] if results.verdict is None else [row.mechanism for row in results.verdict.mechanisms],
        "sweeps": [row.mechanism for row in results.sweeps],
        "sensitivity": [row.mechanism for row in results.sensitivity],
        "report.checklist": [name for item in results.report.checklist for name in item.mechanisms],
        "controls": [row.mechanism for row in results.controls],
        "uncertainty.answers": []
        if results.uncertainty is None
        else [row.mechanism for row in results.uncertainty.answers],
    }
    for where, used in used_in.items():
        for place, name in enumerate(used):
            if name not in names:
                yield f"{where}[{place}].mechanism: {json.dumps(name)} is none of the mechanisms"
