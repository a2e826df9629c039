"""A whole set of results made by hand: two mechanisms, levels, procedures, histories, curves; and changes of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from scipy.constants import g

from assess.codes.bases import BASES
from assess.codes.calculation_sheet import Step
from assess.codes.check import Check, Outcome, PgaCurve, Reason, reason_message
from assess.codes.question import Action, MechanismChecks, Question
from assess.codes.verdict import Decision, mark_deciding, verdict
from assess.messages.message import Message, Severity, whole_number
from assess.results import (
    SCHEMA_VERSION,
    AmplificationFactor,
    AmplificationResult,
    BranchCurve,
    CapacityCurve,
    ComparisonRow,
    DirectionSweep,
    DisplacedDrawing,
    Drawing,
    DrawnLoad,
    HingeAxis,
    HingeForceResult,
    HistoryResult,
    HistoryTrace,
    Input,
    LinearisedResult,
    LoadResult,
    MechanismResult,
    NamedPoint,
    OscillatorResult,
    Point,
    Program,
    RecordResult,
    RecordSpectrum,
    ResolvedValue,
    Results,
    SpectrumResult,
    SuiteResult,
    SweepResult,
    View,
)

_LEVELS = (0.067, 0.2, 0.45)
_PERIODS = tuple(float(period) for period in np.concatenate([[0.0], np.linspace(0.05, 4.0, 80)]))


def _asce_shape(period: float, s_ds: float = 0.167, s_d1: float = 0.053) -> float:
    """Return the ordinate of the design spectrum at a period [g]."""
    corner = s_d1 / s_ds
    if period < 0.2 * corner:
        return s_ds * (0.4 + 0.6 * period / (0.2 * corner))
    return s_ds if period < corner else s_d1 / period


def _block_curve(mass: float, radius: float, alpha: float, p: float) -> BranchCurve:
    """Return the curve of a rectangular block."""
    phi = np.linspace(0.0, 1.5 * alpha, 61)
    inertia, excitation = mass * g * radius / p**2, mass * radius * np.cos(alpha - phi)
    restoring, lift = mass * g * radius * np.sin(alpha - phi), radius * (np.sin(alpha) - np.sin(alpha - phi))
    columns = (phi, np.full_like(phi, inertia), restoring, excitation, np.full_like(phi, mass), lift)
    return BranchCurve(*(tuple(map(float, column)) for column in columns))


def _oscillator(mass: float, radius: float, alpha: float, p: float, *, flexible: float | None) -> OscillatorResult:
    """Return the numbers of a rectangular block; flexible : its overturning on joints [rad]."""
    inertia, tangent, kept = mass * g * radius / p**2, float(np.tan(alpha)), 1 - 1.5 * float(np.sin(alpha)) ** 2
    linear = LinearisedResult(inertia, p**2 * inertia, mass * radius, 0.0, alpha, alpha, alpha)
    frequency = None if flexible is None else 2.0
    return OscillatorResult(
        mass, inertia, radius, alpha, p, tangent, alpha, flexible, alpha, 0.0, frequency, kept, linear
    )


_STEPS = (
    ("h", "height of the centroid above the hinge", "ASCE 43-05 A.1", "h = B_0 / M", "52 400 / 18 700", 2.802, "m"),
    ("f_1", "factor of the weight", "ASCE 43-05 eq. A-1", "f_1 = cos θ + (b/h) sin θ", "cos 0.07 + 0.141 sin 0.07",
     1.0074, "-"),
    ("β_e", "equivalent damping; not checked against the printed standard", "ASCE 43-05 eq. A-8",
     "β_e = γ / √(4 π^2 + γ^2)", "0.062 / √(39.5 + 0.004)", 0.0099, "-"),
    ("S_{a,CAP}", "spectral acceleration capacity", "ASCE 43-05 eq. A-5", "S_a,CAP = 2 E / (g B_0 φ F_V)",
     "2 × 1 230 / (9.80665 × 52 400 × 0.07 × 1.0)", 0.0684, "g"),
)  # fmt: skip
"""The lines of a calculation sheet before the ratio."""


def _check(
    procedure: str, level: float, alpha: float, verdict: str, ratio: float | None, demand: float | None
) -> Check:
    """Return an answer of a procedure at a level [g]."""
    if verdict == "not-answered":
        counts = {"n": whole_number(4), "fallen": whole_number(0), "least": whole_number(5)}
        reason = reason_message(Reason.TOO_FEW_RECORDS, **counts, clause="ASCE 43-05")
    elif verdict == "fail" and ratio is None:
        reason = reason_message(Reason.OVERTURNS)
    else:
        key = Reason.WITHIN if verdict == "pass" else Reason.BEYOND
        reason = reason_message(key, capacity="the allowable")
    last = ("r", "demand over capacity", "", "r = θ / θ_lim", "0.031 / 0.070", 9.99 if ratio is None else ratio, "-")
    x = np.linspace(0.0, 0.7, 15)
    strength = {"dmi2008-linear": 0.28}.get(procedure, 0.10 + 0.012 * len(procedure))
    curve = PgaCurve(tuple(map(float, x)), tuple(float(strength * (1 + 4 * v - 2.6 * v**2)) for v in x))
    linear = procedure == "dmi2008-linear"
    informative = procedure.endswith("thesis")
    capacity = None if verdict == "not-answered" else 0.14 if linear else 0.5 * alpha
    return Check(
        procedure=procedure,
        edition="ASCE/SEI 43-05 (2005), Appendix A" if "asce" in procedure else "DMI 2008 with Circolare 617/2009",
        reading="thesis" if informative else "letter",
        branch="negative" if level > 0.3 else "positive",
        limit_state="SLV" if "dmi" in procedure else "no overturning",
        level_pga_g=level,
        input_at="ground" if "spectrum" in procedure else "mechanism base",
        damping=0.05 if informative else 0.0123,
        damping_rule="ASCE 7-16 Table 17.5-1, B factor",
        quantity="acceleration" if linear else "rotation",
        unit="g" if linear else "rad",
        demand=demand,
        capacity=capacity,
        ratio=ratio,
        verdict=Outcome(verdict),
        reason=reason,
        capacity_pga_g=None if linear else float(np.interp(0.5, x, curve.pga_g)),
        uplift_pga_g=strength,
        capacity_rotation_ratio=None if linear else 0.5,
        rotation_ratio=None if demand is None or linear else demand / alpha,
        pga_curve=PgaCurve((), ()) if linear else curve,
        steps=() if verdict == "not-answered" else tuple(Step(*each) for each in (*_STEPS, last)),
        caveat="clauses not checked against the printed standard" if "dmi" in procedure else "",
    )


def _checks(alpha: float, weak: bool) -> tuple[Check, ...]:
    """Return the answers of five procedures at every level."""
    made = []
    for place, level in enumerate(_LEVELS):
        r = (0.0, 0.37, 1.31 if weak else 0.84)[place]
        outcome, turned = "pass" if r <= 1 else "fail", 0.5 * r * alpha
        history = ("fail", None, None) if place == 2 else ("pass", r, turned)
        answers = {
            "asce43-05-spectrum": (outcome, r, turned),
            "asce43-05-spectrum-thesis": ("pass", 0.8 * r, 0.4 * r * alpha),
            "dmi2008-linear": ("pass" if level < 0.3 else "fail", level / 0.28, level / 2),
            "dmi2008-nonlinear": (outcome, 1.1 * r if r <= 0.9 else 3.4, turned),
            "asce43-05-history": history if weak else ("not-answered", None, None),
        }
        made += [_check(name, level, alpha, *answer) for name, answer in answers.items()]
    return tuple(made)


def _trace(alpha: float, *, sides: str) -> HistoryTrace:
    """Return what a history recorded: the ground, and a block that swells and dies or overturns."""
    t = np.arange(0.0, 20.0, 0.01)
    shape = (t / 4) ** 2 * np.exp(2 * (1 - t / 4))
    ground = 0.45 * shape * np.sin(2 * np.pi * 2.3 * t + 3 * np.sin(t)) * np.cos(0.7 * t)
    turned = -0.383 * alpha * shape * np.sin(2 * np.pi * 0.55 * t)
    if sides == "one":
        turned = np.abs(2 * turned) + np.where(t > 5.0, alpha * np.expm1(1.2 * (t - 5.0).clip(0.0, 1.0)), 0.0)
        t, turned, ground = (column[t < 5.9] for column in (t, turned, ground))
    return HistoryTrace(*(tuple(map(float, column)) for column in (t, turned, ground)))


def _histories(
    alpha: float, records: tuple[RecordResult, ...], *, sides: str, falls: bool
) -> tuple[HistoryResult, ...]:
    """Return a history of each record at each level; of the one that falls the second record overturns."""
    made = []
    for place, record in enumerate(records):
        for level in _LEVELS:
            fell = falls and level > 0.3 and place == 1
            turned = 0.0 if level < 0.1 else alpha * level * (0.7 + 0.15 * place)
            made.append(
                HistoryResult(
                    record.id,
                    1 if place % 2 else -1,
                    level,
                    level / 0.067,
                    1.25 if falls else 1.0,
                    None if fell else -turned,
                    None if fell else turned / alpha,
                    None if fell else 4.37,
                    0 if turned == 0 else 7,
                    fell,
                    5.61 if fell else None,
                    _trace(alpha, sides=sides) if level > 0.3 and place == 1 else None,
                    "positive",
                )
            )
    return tuple(made)


def _suites(history: tuple[HistoryResult, ...]) -> tuple[SuiteResult, ...]:
    """Return what the histories at each level come to."""
    made = []
    for level in _LEVELS:
        ratios = [h.max_rotation_ratio for h in history if h.level_pga_g == level]
        standing = [ratio for ratio in ratios if ratio is not None]
        fell = len(ratios) - len(standing)
        made.append(SuiteResult(level, len(ratios), fell, None if fell else float(np.mean(standing)), max(standing)))
    return tuple(made)


def _record(number: int) -> RecordResult:
    """Return an artificial record by its number."""
    wobble = [1 + 0.25 * np.sin(5 * period + number) * np.cos(2.1 * number * period) for period in _PERIODS]
    spectrum = RecordSpectrum(_PERIODS, tuple(float(_asce_shape(p) * w) for p, w in zip(_PERIODS, wobble, strict=True)))
    return RecordResult(
        f"artificial-{number}",
        "",
        "",
        "",
        "",
        0.01,
        2000,
        spectrum.acceleration_g[0],
        1.0 + 0.01 * number,
        0.0041 + 0.001 * number,
        (f"non-stationary noise, seed {number}", "iterated to the target, misfit 4.1 %", "baseline corrected"),
        spectrum,
    )


def _turned(points: tuple[Point, ...], about: float, base: float, angle: float) -> tuple[Point, ...]:
    """The points after a rotation by `angle` towards +x about (about, base)."""
    s, c = np.sin(angle), np.cos(angle)
    return tuple(
        (float(about + (x - about) * c + (z - base) * s), float(base - (x - about) * s + (z - base) * c))
        for x, z in points
    )


def _rectangle(thickness: float, height: float, base: float, *, two: bool) -> Drawing:
    """Return the drawing of a wall, at rest and displaced."""
    t = thickness / 2
    outline = ((-t, base), (t, base), (t, base + height), (-t, base + height))
    centre = (0.0, base + height / 2)
    hinges = (NamedPoint("A", (t, base)), NamedPoint("A′", (-t, base)))[: 2 if two else 1]
    loads = () if two else (DrawnLoad("floor beam", (t, 0.9 * height), "mass", (0.0, -1.0)),)
    sides = [
        DisplacedDrawing(
            0.07,
            (_turned(outline, hinge.at[0], base, angle),),
            (0,),
            (hinge,),
            tuple(replace(load, at=_turned((load.at,), hinge.at[0], base, angle)[0]) for load in loads),
            _turned((centre,), hinge.at[0], base, angle),
        )
        for hinge, angle in zip(hinges, (0.07, -0.07), strict=False)
    ]
    return Drawing((outline,), hinges, loads, centre, (0,), (centre,), sides[0], sides[1] if two else None, ())


def _box_view(thickness: float, height: float) -> View:
    """A box on a base: eight corners each, the upper one moves."""
    x, y = thickness / 2, 1.5
    corners = [(i, j) for i in (-x, x) for j in (-y, y)]
    vertices = [(i, j, z) for z in (0.0, 4.77, 4.77, 4.77 + height) for i, j in corners]
    box = [(0, 1, 3), (0, 3, 2), (4, 7, 5), (4, 6, 7), (0, 5, 1), (0, 4, 5)]
    box += [(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    triangles = [(a + start, b + start, c + start) for start in (0, 8) for a, b, c in box]
    axes = (HingeAxis("A", ((x, -y, 4.77), (x, y, 4.77))), HingeAxis("A′", ((-x, -y, 4.77), (-x, y, 4.77))))
    section = tuple((i, j, 4.77) for i, j in (corners[0], corners[1], corners[3], corners[2], corners[0]))
    size = (thickness, 3.0, 4.77 + height)
    owner = (-1,) * 12 + (0,) * 12
    return View(tuple(vertices), tuple(triangles), owner, axes, (section,), (1.0, 0.0, 0.0), size, 24)


_FOUND = 'share 0.5 (statics; the rest on "<b>rear & $x$"); bears on 0.8 m2'
_LOADS = (
    LoadResult("floor <beam>", "mass", 0, (0.2, 6.1), 1160.0, True, None, _FOUND),
    LoadResult("=cmd()", "force", 0, (0.2, 6.4), None, None, (8250.5, -120.0), "given"),
)


def _mechanism(
    name: str, label: str, kind: str, *, sides: str, records: tuple[RecordResult, ...], weak: bool
) -> MechanismResult:
    """Return a mechanism with all that the report may show of it."""
    mass, radius, alpha, p = (18_730.0, 2.84, 0.14, 1.60) if not weak else (1.0, 4.31, 0.11, 1.29)
    two = sides == "two"
    curve, parameters = (
        _block_curve(mass, radius, alpha, p),
        _oscillator(mass, radius, alpha, p, flexible=None if two else 0.92 * alpha),
    )
    thickness, height = 2 * radius * float(np.sin(alpha)), 2 * radius * float(np.cos(alpha))
    drawing = _rectangle(thickness, height, 4.77 if two else 0.0, two=two)
    history = _histories(alpha, records, sides=sides, falls=weak)
    return MechanismResult(
        name,
        label,
        kind,
        sides,  # type: ignore[arg-type]
        "exact" if two else "linearised",
        drawing,
        _box_view(thickness, height) if two else None,
        parameters,
        parameters if two else None,
        CapacityCurve(curve, curve if two else None),
        (),
        AmplificationResult(
            "srss" if weak else "none", tuple(AmplificationFactor(r.id, 1.25) for r in records) if weak else ()
        ),
        _checks(alpha, weak),
        history,
        _suites(history),
        None,
        "Housner 1963, Mehrotra eq. 3.44" if two else "given",
        () if two else _LOADS,
        _ROUND_TOWER if two else None,
        hinge_forces=_HINGE_FORCES if two else (),
    )


LEVEL, DOWN = (0.0, 1.0), (0.0, -1.0)
_HINGE_FORCES = (
    HingeForceResult("A", "positive", -4310.0, 5000.0, 0.862, 0.6, 5000.0, -4310.0, LEVEL, True, 0.4, 0.278, False),
    HingeForceResult("B", "positive", 310.0, 2500.0, 0.124, 0.6, 2500.0, 310.0, LEVEL, False, 0.4, None, False),
    HingeForceResult("A'", "negative", -410.0, -20.0, None, 0.6, -20.0, -410.0, LEVEL, True, 0.3, 0.0, False),
    HingeForceResult("C", "positive", -910.0, -700.0, 1.3, None, 700.0, 910.0, DOWN, True, 0.4, None, True),
)
"""A hinge that slides first, one that rocks first, one that lifts, and the top of a wall."""
_MULTIPLIERS = tuple(float(0.141 * (1 + 0.004 * k % 7)) for k in range(72))
_ROUND_TOWER = DirectionSweep(
    tuple(5.0 * k for k in range(72)), _MULTIPLIERS, (1.6,) * 72, (0.14,) * 72, 0.0, 0.027, 131.25
)


def question_at(pga_g: float = _LEVELS[0]) -> Question:
    """ASCE 43-05 at a site of this PGA; the approximate method is named too."""
    methods = ("asce43-05-history", "asce43-05-spectrum")
    return Question(BASES["asce43-05"], Action(pga_g, "DBE"), procedures=methods)


def with_decision(results: Results, question: Question | None = None) -> Results:
    """The results with their verdict, and with the checks that decide marked."""
    question = question or question_at()
    found = verdict(question, [MechanismChecks(each.name, each.checks) for each in results.mechanisms])
    mechanisms = tuple(
        replace(each, checks=mark_deciding(each.checks, one, question.basis, question.action))
        for each, one in zip(results.mechanisms, found.mechanisms, strict=True)
    )
    return replace(results, mechanisms=mechanisms, verdict=found)


def sample_results() -> Results:
    """Return all of it."""
    records = tuple(_record(number) for number in range(1, 6))
    mechanisms = (
        _mechanism("wall-6", "Wall 6, eroded base", "single-block", sides="two", records=records, weak=False),
        _mechanism("parapet", "", "equivalent-block", sides="one", records=records, weak=True),
    )
    comparison = tuple(
        ComparisonRow(m.name, c.level_pga_g, c.procedure, c.rotation_ratio, c.capacity_rotation_ratio, c.ratio)
        for m in mechanisms
        for c in m.checks
    )
    project = {
        "title": ResolvedValue("Great House", True),
        "engineer": ResolvedValue("A. Builder, CEng", True),
        "checker": ResolvedValue(None, False),
        "client": ResolvedValue("The Trustees", True),
        "reference": ResolvedValue("GH-07", True),
        "notes": ResolvedValue("Survey of May; north face not reached.", True),
        "site.vertical_ratio": ResolvedValue(0.0, False),
        "materials.caliche.density": ResolvedValue(2240.0, True),
        "mechanisms.wall-6.direction": ResolvedValue([1, 0, 0], False),
        "mechanisms.wall-6.cut": ResolvedValue(4.77, True),
        "mechanisms.wall-6.hinges.A": ResolvedValue({"x": 0.396, "z": 4.77}, True),
        "analysis.levels": ResolvedValue(list(_LEVELS), True),
        "procedures.dmi2008.confidence_factor": ResolvedValue(1.0, False),
        "report.paper": ResolvedValue("A4", False),
    }
    spectrum = SpectrumResult(
        "asce7-16",
        {"s_ds": 1.6377, "s_d1": 0.51975, "t_l": 6.0},
        0.05,
        "ASCE 7-16 Table 17.5-1, B factor",
        "ASCE 7-16 11.4.6",
        0.067,
        _PERIODS,
        tuple(_asce_shape(p) for p in _PERIODS),
    )
    made = Results(
        SCHEMA_VERSION,
        Program("assess", "0.1.0"),
        (Input("project.toml", "3f" * 32), Input("wall.stl", "a7" * 32)),
        (
            Message(
                "knowledge-level",
                Severity.WARNING,
                "procedures.dmi2008",
                "the confidence factor is 1.0 by default; knowledge level LC1 means 1.35",
            ),
        ),
        project,
        spectrum,
        records,
        mechanisms,
        None,
        comparison,
        (
            SweepResult(
                mechanism="parapet",
                key="mechanisms.parapet.uplift",
                unit="-",
                value=(0.09, 0.13, 0.17),
                p_eq_per_s=(1.61, 1.62, 1.63),
                uplift_multiplier=(0.0901, 0.1302, 0.1703),
                overturning_rad=(0.0904, 0.1305, 0.1706),
                overturning_flexible_rad=(None, None, None),
                elastic_frequency_hz=(None, None, None),
                restitution=(0.951, 0.952, 0.953),
                demand_capacity=(None, 1.31, 0.87),
                overturned=(True, False, False),
                capacity_pga_g=(None, 0.231, 0.292),
                outcome=(Decision.FAIL, Decision.FAIL, Decision.PASS),
                controlling=0,
                governs=True,
            ),
        ),
    )
    return with_decision(made)


def with_verdict(results: Results, **changes: Any) -> Results:
    """Return the results with these fields of their verdict."""
    assert results.verdict is not None
    return replace(results, verdict=replace(results.verdict, **changes))


def with_mechanisms(results: Results, **changes: Any) -> Results:
    """Return the results with these fields of every mechanism."""
    return replace(results, mechanisms=tuple(replace(each, **changes) for each in results.mechanisms))


def with_project(results: Results, *, instead: bool = False, **values: ResolvedValue) -> Results:
    """Return the results with these values of the project, beside or `instead` of its own; `__` is a dot of a key."""
    project = {key.replace("__", "."): value for key, value in values.items()}
    return replace(results, project=project if instead else {**results.project, **project})
