"""A mechanism in the results: its rocking parameters and capacity curves, loads, hinge forces, histories and checks.

Loads are listed with how long each lasts, and there are messages on those that are not shown to last.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import ceil, inf
from typing import Literal

import numpy as np

from assess.amplification import BaseMotion, ModalFilter
from assess.codes.check import Check
from assess.codes.histories import FIGURES, standing_figures
from assess.dynamics.packing import Equation
from assess.errors import locate_errors
from assess.geometry.cut import Scene
from assess.loads.load import Force, Load, PointMass, Tie, pull_at_rest, source_phrase, stretches
from assess.mechanisms.branch_table import load_displacement, rigid_branch
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, Severity, Term, Value, message
from assess.oscillator import (
    Branch,
    HingeForces,
    Linearised,
    Oscillator,
    displacement,
    elastic_frequency,
    equivalent_block,
    participating_mass,
    threshold,
)
from assess.results import (
    AmplificationFactor,
    AmplificationResult,
    BranchCurve,
    CapacityCurve,
    CarriedMotion,
    ComparisonRow,
    HingeForceResult,
    HistoryResult,
    Lasting,
    LinearisedResult,
    LoadResult,
    MechanismResult,
    OscillatorResult,
    SuiteResult,
)
from assess.study.amplification import HeightAboveGround, MechanismAmplification
from assess.study.drawing import draw, view_in_space
from assess.study.joint_results import interface_curves, interface_results, sheets_of_joints
from assess.study.study import ScaledRecord, Study, case_text
from assess.study.tie_results import tie_messages, tie_result
from records.record import Record
from records.response import response_spectrum
from spectra.gravity import g


def parameters(study: Study) -> tuple[MechanismResult, ...]:
    """Return every mechanism with its rocking parameters and capacity curve."""
    return tuple(
        mechanism_result(
            mechanism,
            mechanism.variants.starting,
            equation=study.equations[mechanism.name],
            scene=study.scenes.get(mechanism.name),
            amplification=amplification_result(study.amplified[mechanism.name]),
            height=study.heights[mechanism.name],
        )
        for mechanism in study.mechanisms
    )


def case_parameters(study: Study) -> tuple[MechanismResult, ...]:
    """Return the `parameters` of every case of every sweep; each mechanism is named with its case."""
    named = []
    for sweep in study.sweeps:
        for case in sweep.cases:
            with locate_errors(case.name):
                results = parameters(case.study)
            named += [
                replace(result, name=f"{result.name}, {case_text(sweep, case, result.name)}") for result in results
            ]
    return tuple(named)


UNAMPLIFIED_RESULT = AmplificationResult("none", ())


def mechanism_result(
    mechanism: Mechanism,
    oscillator: Oscillator,
    *,
    equation: Equation,
    scene: Scene | None = None,
    checks: Sequence[Check] = (),
    histories: Sequence[Sequence[HistoryResult]] = (),
    amplification: AmplificationResult = UNAMPLIFIED_RESULT,
    height: HeightAboveGround | None = None,
) -> MechanismResult:
    """Return one mechanism as results.

    Parameters
    ----------
    mechanism : the mechanism
    oscillator : its branches with every action that is there at rest
    equation : {"exact", "linearised"}
        The equation of motion of its histories.
    scene : its bodies in space
    checks : the answers of the procedures
    histories : by level and record
    amplification : the motion at its base
    height : where it is above the ground

    Returns
    -------
    Without envelope.
    """
    positive, negative, mass = oscillator.positive, oscillator.negative, oscillator.mass
    deciding = mechanism.variants.deciding
    same = deciding is oscillator
    drawing = draw(mechanism, oscillator, scene)
    rigid = rigid_branches(mechanism, oscillator)
    return MechanismResult(
        name=mechanism.name,
        label=mechanism.label,
        kind=mechanism.kind,
        sides=mechanism.sides,
        equation=equation,
        restitution_source=mechanism.restitution_source,
        restitution_said=mechanism.restitution_source_parts,
        direction_sweep=mechanism.directions,
        drawing=drawing,
        view=None if scene is None else view_in_space(mechanism, scene),
        oscillator=oscillator_result(positive, mass=mass, rigid=rigid[0], equilibrium=oscillator.equilibrium),
        oscillator_negative=None
        if negative is None
        else oscillator_result(negative, mass=mass, rigid=rigid[-1], equilibrium=oscillator.equilibrium_negative),
        curve=curve_of(oscillator),
        interfaces=interface_results(mechanism, oscillator, [hinge.name for hinge in drawing.hinges]),
        contact_sheets=tuple(sheets_of_joints(mechanism, oscillator, [hinge.name for hinge in drawing.hinges])),
        interface_curves=interface_curves(mechanism, rigid) if mechanism.flexible else None,
        amplification=amplification,
        checks=tuple(checks),
        histories=tuple(history for level in histories for history in level),
        suites=tuple(suite_statistics(level) for level in histories),
        envelope=None,
        loads=_load_results(mechanism),
        hinge_forces=tuple(_hinge_force_result(each) for each in hinge_forces(mechanism)),
        deciding_curve=None if same else curve_of(deciding),
        deciding_overturning_rad=None if same else overturning_rotations(deciding),
        direction=mechanism.direction,
        candidates=mechanism.candidates,
        base_elevation_m=None if height is None else height.base,
        input_height_m=None if height is None else height.support,
        above_ground=None if height is None else height.above,
        ground_known_from="" if height is None else height.source,
    )


def suite_statistics(histories: Sequence[HistoryResult]) -> SuiteResult:
    """Return the statistics of all records at one level."""
    own = _statistics([history.max_rotation_ratio for history in histories])
    twins = [_statistics(run) for run in zip(*(history.twin_ratios for history in histories), strict=True)]
    stand = [
        standing_figures(value, [run[place] for run in twins]) for place, value in enumerate(own) if value is not None
    ]
    mean, largest, median, p84 = own
    return SuiteResult(
        level_pga_g=histories[0].level_pga_g,
        n=len(histories),
        overturned=sum(1 for history in histories if history.overturned),
        mean_ratio=mean,
        max_ratio=largest,
        median_ratio=median,
        p84_ratio=p84,
        figures=max(1, min(stand, default=FIGURES)),
    )


def comparison_rows(results: Sequence[MechanismResult]) -> tuple[ComparisonRow, ...]:
    """Return one row for every check of every mechanism."""
    return tuple(
        ComparisonRow(
            mechanism=result.name,
            level_pga_g=check.level_pga_g,
            procedure=check.procedure,
            rotation_ratio=check.rotation_ratio,
            allowable_ratio=check.capacity_rotation_ratio,
            demand_capacity=check.ratio,
        )
        for result in results
        for check in result.checks
    )


def oscillator_result(branch: Branch, *, mass: float, rigid: Branch, equilibrium: float) -> OscillatorResult:
    """Return the rocking parameters of one branch.

    Parameters
    ----------
    branch : the branch
    mass : total mass [kg]
    rigid : the branch with rigid interfaces
    equilibrium : rotation at rest phi_e, in the sign of the branch [rad]

    Returns
    -------
    The parameters, some of the equivalent block of the rigid branch.
    """
    block, linear = equivalent_block(rigid, mass=mass), branch.linearised
    return OscillatorResult(
        mass_kg=mass,
        inertia_kg_m2=block.inertia,
        radius_m=block.radius,
        slenderness_rad=block.slenderness,
        p_eq_per_s=linear.p,
        uplift_multiplier=threshold(branch),
        overturning_rad=branch.overturning,
        overturning_flexible_rad=branch.overturning_flexible,
        critical_rad=branch.critical,
        equilibrium_rad=equilibrium + 0.0,
        elastic_frequency_hz=elastic_frequency(branch),
        restitution=branch.restitution,
        linearised=_linearised_result(linear),
    )


def curve_of(oscillator: Oscillator) -> CapacityCurve:
    """Return the capacity curves of both branches."""
    positive, negative, mass = oscillator.positive, oscillator.negative, oscillator.mass
    return CapacityCurve(
        _branch_curve(positive, mass=mass), None if negative is None else _branch_curve(negative, mass=mass)
    )


def overturning_rotations(oscillator: Oscillator) -> tuple[float, float | None]:
    """Return the overturning rotations of both branches with rigid joints [rad]."""
    return oscillator.positive.overturning, None if oscillator.negative is None else oscillator.negative.overturning


def rigid_branches(mechanism: Mechanism, oscillator: Oscillator) -> tuple[Branch, ...]:
    """Return the branches of the mechanism with rigid interfaces."""
    if not mechanism.flexible:
        return oscillator.branches
    return tuple(
        rigid_branch(replace(chain, joints=()), restitution=1.0, name=mechanism.name) for chain in mechanism.chains
    )


def load_messages(mechanism: Mechanism) -> Iterator[Message]:
    """Yield a warning for each tie or force that resists but is not shown to last, and if all depends on them.

    A tie with a pretension above its strength gets one, too, and so does a seat wider than walls are thick.

    A force that drives one way and resists the other is a thrust and gets no warning.
    """
    where = f"mechanisms.{mechanism.name}"
    ties = {each.name: each for each in mechanism.positive.loads if stretches(each)}
    for mass in mechanism.positive.loads:
        if isinstance(mass, PointMass) and mass.seat is not None and mass.seat > WIDEST_SEAT:
            seat = Quantity(mass.seat, "length")
            yield message("seat-wide", {"load": mass.name, "seat": seat}, severity=Severity.WARNING, where=where)
    for tie in mechanism.positive.loads:
        if isinstance(tie, Tie) and tie.tension < tie.pull:
            forces = {"force": Quantity(tie.pull, "force"), "strength": Quantity(tie.tension, "force")}
            yield message(
                "pretension-above-strength", {"load": tie.name, **forces}, severity=Severity.WARNING, where=where
            )
    if not mechanism.positive.actions:
        return
    thrusts = {each.name for one in mechanism.actions for each in one.thrusts}
    for load in _load_results(mechanism):
        if load.lasting == "not shown" and load.name not in thrusts:
            values: dict[str, Value] = {"load": load.name, "missing": ", ".join(load.missing)}
            key = "not-lasting"
            if load.name in ties:
                key, values = "tie-not-lasting", {**values, "force": Quantity(ties[load.name].tension, "force")}
            yield message(key, values, severity=Severity.WARNING, where=where)
    yield from tie_messages(mechanism)
    yield from unsupported_messages(mechanism, where=where)


def unsupported_messages(mechanism: Mechanism, *, where: str = "") -> tuple[Message, ...]:
    """Return why no displacement can be assessed: the mechanism stands only by loads that are not shown to last."""
    loads = mechanism.variants.depends_on
    if not loads:
        return ()
    return (message("unheld", {"loads": ", ".join(loads)}, severity=Severity.WARNING, where=where),)


SHORTEST_PERIOD, LONGEST_SHOWN = 0.05, 4.0  # s, of the spectra of a filtered motion


def amplification_result(
    amplified: MechanismAmplification, motions: Sequence[ScaledRecord] = (), base: Sequence[BaseMotion] = ()
) -> AmplificationResult:
    """Return how the ground motions reach the base of a mechanism; `base`: the motions as they act there."""
    filtered = isinstance(amplified.amplification, ModalFilter) and len(base) > 0
    most = max(range(len(base)), key=lambda place: base[place].factor) if filtered else 0
    return AmplificationResult(
        method=amplified.method,
        factors=tuple(AmplificationFactor(each.record.id, each.factor) for each in base),
        height_m=amplified.height,
        said=(*amplified.description, *amplified.assumptions),
        motion=_base_motion_result(motions[most], base[most].record) if filtered else None,
        building_period_ratio=amplified.state.period_ratio,
        building_damping=amplified.state.damping,
    )


def _hinge_force_result(forces: HingeForces) -> HingeForceResult:
    """Return the forces of one hinge when rocking starts, as results."""
    return HingeForceResult(
        hinge=forces.hinge,
        branch=forces.branch,
        horizontal_n=forces.horizontal,
        vertical_n=forces.vertical,
        needed_friction=forces.required_friction,
        friction=forces.friction,
        normal_n=forces.starting.normal,
        shear_n=forces.starting.shear,
        face=forces.face,
        face_found=forces.found,
        activation_g=forces.acceleration / g,
        sliding_g=None if forces.sliding_acceleration is None else forces.sliding_acceleration / g,
        held=forces.held,
    )


def _statistics(ratios: Sequence[float | None]) -> tuple[float | None, float | None, float | None, float | None]:
    """Return mean, largest of those standing, median and 84 % of ratios; None, an overturned record, is the largest."""
    standing = [ratio for ratio in ratios if ratio is not None]
    ranked = [*sorted(standing), *[None] * (len(ratios) - len(standing))]
    mean = float(np.mean(standing)) if len(standing) == len(ratios) else None
    return mean, max(standing, default=None), ranked[ceil(0.5 * len(ranked)) - 1], ranked[ceil(0.84 * len(ranked)) - 1]


def _linearised_result(linear: Linearised) -> LinearisedResult:
    """Return the kinematic constants of the linearised branch."""
    rounding = 1e-9 * linear.stiffness * linear.critical  # of the table at phi_cr, where without forces M = 0
    return LinearisedResult(
        inertia_kg_m2=linear.inertia,
        stiffness_n_m_per_rad=linear.stiffness,
        excitation_kg_m=linear.excitation,
        moment_n_m=0.0 if abs(linear.moment) <= rounding else linear.moment,
        critical_rad=linear.critical,
        overturning_rad=linear.overturning,
        uplift_multiplier=linear.multiplier,
    )


def _branch_curve(branch: Branch, *, mass: float) -> BranchCurve:
    """Return the capacity curve of one branch."""
    return BranchCurve(
        rotation_rad=tuple(branch.rotation.tolist()),
        inertia_kg_m2=tuple(branch.inertia.tolist()),
        restoring_n_m=tuple(branch.restoring.tolist()),
        excitation_kg_m=tuple(branch.excitation.tolist()),
        participating_mass_kg=tuple(participating_mass(branch).tolist()),
        displacement_m=tuple(displacement(branch, branch.rotation, mass=mass).tolist()),
    )


WIDEST_SEAT = 2.0  # m: floors and roofs rest on less


def _load_results(mechanism: Mechanism) -> tuple[LoadResult, ...]:
    """Return every load as used, with its source."""
    number, found = 0, []
    for load in mechanism.positive.loads:
        result = _load_result(load)
        if not isinstance(load, PointMass):
            result = _with_duration(mechanism, number, result)
            number += 1
        found.append(result)
    return tuple(found)


def _load_result(load: Load) -> LoadResult:
    """Return a load as used, with its source."""
    found = load.source_parts or (Term("given"),)
    source = source_phrase(found)
    if isinstance(load, PointMass):
        seat, mass = load.seat if load.bearing else None, load.mass
        result = LoadResult(load.name, "mass", load.block, load.at, mass, load.bearing, None, source, seat_m=seat)
        return replace(result, found=found)
    at, missing, tie = load.at, load.missing, tie_result(load) if isinstance(load, Tie) else None
    kind: Literal["force", "tie"] = "force" if isinstance(load, Force) else "tie"
    force = load.force if isinstance(load, Force) else pull_at_rest(load)
    result = LoadResult(load.name, kind, load.block, at, None, None, force, source, missing=missing, tie=tie)
    return replace(result, found=found)


def _with_duration(mechanism: Mechanism, number: int, load: LoadResult) -> LoadResult:
    """Return a force or tie, by its number, with how long it lasts on the branch where it ends first."""
    sides = list(zip(mechanism.actions, mechanism.variants.ends, strict=True))
    resisting = [(actions, kept[number]) for actions, kept in sides if actions.ever_resists(number)]
    if not resisting:
        return replace(load, missing=())
    first = min((actions for actions, _ in resisting), key=lambda actions: actions.ends[number])
    end, lasts = first.ends[number], all(kept > 0.0 for _, kept in resisting)
    broken = 0.0 < end < inf
    return replace(
        load,
        lasting=_duration_kind(lasts, broken),
        missing=load.missing if end == 0.0 else (),
        end_rad=end if broken else None,
        end_m=load_displacement(first.chain, first.actions[number], end) if broken else None,
    )


def _duration_kind(lasts: bool, broken: bool) -> Lasting:
    if lasts:
        return "to collapse"
    return "to its end" if broken else "not shown"


def _base_motion_result(motion: ScaledRecord, base: Record) -> CarriedMotion:
    """Return a motion scaled to the target, at the ground and at the base, sampled as the latter."""
    ground, scale = motion.record, motion.scaling.factor
    period = np.geomspace(SHORTEST_PERIOD, LONGEST_SHOWN, 120)
    return CarriedMotion(
        record=ground.id,
        time_s=tuple(base.time.tolist()),
        ground_acceleration_g=tuple(
            (scale / g * np.interp(base.time, ground.time, ground.acceleration, right=0.0)).tolist()
        ),
        base_acceleration_g=tuple((scale / g * base.acceleration).tolist()),
        period_s=tuple(period.tolist()),
        ground_spectrum_g=tuple((scale / g * response_spectrum(ground, period)).tolist()),
        base_spectrum_g=tuple((scale / g * response_spectrum(base, period)).tolist()),
    )
