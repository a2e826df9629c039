"""A mechanism in the results, with its checks and its histories."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

import numpy as np
from scipy.constants import g

from assess.codes.check import Check
from assess.codes.standing_figures import FIGURES, standing_figures
from assess.geometry.scene import Scene
from assess.hinge_forces import HingeForces
from assess.mechanisms.directions import Directions
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import (
    Oscillator,
)
from assess.results import (
    AmplificationResult,
    ComparisonRow,
    DirectionCandidate,
    DirectionSweep,
    HingeForceResult,
    HistoryResult,
    MechanismResult,
    SuiteResult,
)
from assess.study.amplification_results import UNAMPLIFIED
from assess.study.drawing import draw
from assess.study.endurance import load_results
from assess.study.grounding import Grounded
from assess.study.joint_results import interface_curves, interface_results, sheets_of_joints
from assess.study.oscillator_results import curve_of, oscillator_result, overturning_rotations, rigid_branches
from assess.study.study import Equation
from assess.study.view import view


def mechanism_result(
    mechanism: Mechanism,
    oscillator: Oscillator,
    *,
    equation: Equation,
    scene: Scene | None = None,
    checks: Sequence[Check] = (),
    histories: Sequence[Sequence[HistoryResult]] = (),
    amplification: AmplificationResult = UNAMPLIFIED,
    grounded: Grounded | None = None,
) -> MechanismResult:
    """Return one mechanism as results.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism.
    oscillator : Oscillator
        Its branches with every action that is there at rest.
    equation : {"exact", "linearised"}
        The equation of motion of its histories.
    scene : Scene, optional
        Its bodies in space.
    checks : sequence of Check
        The answers of the procedures.
    histories : sequence of sequence of HistoryResult
        By level and record.
    amplification : AmplificationResult
        The motion at its base.
    grounded : Grounded, optional
        Where it is above the ground.

    Returns
    -------
    MechanismResult
        Without envelope.
    """
    positive, negative, mass = oscillator.positive, oscillator.negative, oscillator.mass
    deciding = mechanism.variants.deciding
    same = deciding is oscillator
    drawn = draw(mechanism, oscillator, scene)
    rigid = rigid_branches(mechanism, oscillator)
    return MechanismResult(
        name=mechanism.name,
        label=mechanism.label,
        kind=mechanism.kind,
        sides=mechanism.sides,
        equation=equation,
        restitution_source=mechanism.restitution_source,
        restitution_said=mechanism.restitution_said,
        direction_sweep=None if mechanism.directions is None else direction_sweep(mechanism.directions),
        drawing=drawn,
        view=None if scene is None else view(mechanism, scene),
        oscillator=oscillator_result(positive, mass=mass, rigid=rigid[0], equilibrium=oscillator.equilibrium),
        oscillator_negative=None
        if negative is None
        else oscillator_result(negative, mass=mass, rigid=rigid[-1], equilibrium=oscillator.equilibrium_negative),
        curve=curve_of(oscillator),
        interfaces=interface_results(mechanism, oscillator, [hinge.name for hinge in drawn.hinges]),
        contact_sheets=tuple(sheets_of_joints(mechanism, oscillator, [hinge.name for hinge in drawn.hinges])),
        interface_curves=interface_curves(mechanism, rigid) if mechanism.flexible else None,
        amplification=amplification,
        checks=tuple(checks),
        histories=tuple(history for level in histories for history in level),
        suites=tuple(suite_statistics(level) for level in histories),
        envelope=None,
        loads=load_results(mechanism),
        hinge_forces=tuple(hinge_force_result(each) for each in hinge_forces(mechanism)),
        deciding_curve=None if same else curve_of(deciding),
        deciding_overturning_rad=None if same else overturning_rotations(deciding),
        direction=mechanism.direction,
        candidates=tuple(
            DirectionCandidate(each.angle, each.multiplier, each.displacement, each.touching)
            for each in mechanism.candidates
        ),
        base_elevation_m=None if grounded is None else grounded.base,
        input_height_m=None if grounded is None else grounded.support,
        above_ground=None if grounded is None else grounded.above,
        ground_known_from="" if grounded is None else grounded.source,
    )


def hinge_force_result(forces: HingeForces) -> HingeForceResult:
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


def direction_sweep(found: Directions) -> DirectionSweep:
    """Return the search for the weakest direction as results."""
    return DirectionSweep(
        angle_deg=found.angle,
        uplift_multiplier=found.multiplier,
        p_eq_per_s=found.p,
        overturning_rad=found.overturning,
        weakest_deg=found.weakest,
        variation=found.variation,
        flat_deg=found.flat,
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


def _statistics(ratios: Sequence[float | None]) -> tuple[float | None, float | None, float | None, float | None]:
    """Return mean, largest of those standing, median and 84 % of ratios; None, an overturned record, is the largest."""
    standing = [ratio for ratio in ratios if ratio is not None]
    ranked = [*sorted(standing), *[None] * (len(ratios) - len(standing))]
    mean = float(np.mean(standing)) if len(standing) == len(ratios) else None
    return mean, max(standing, default=None), ranked[ceil(0.5 * len(ranked)) - 1], ranked[ceil(0.84 * len(ranked)) - 1]


def comparison_rows(mechanisms: Sequence[MechanismResult]) -> tuple[ComparisonRow, ...]:
    """Return one row for every check of every mechanism."""
    return tuple(
        ComparisonRow(
            mechanism=mechanism.name,
            level_pga_g=check.level_pga_g,
            procedure=check.procedure,
            rotation_ratio=check.rotation_ratio,
            allowable_ratio=check.capacity_rotation_ratio,
            demand_capacity=check.ratio,
        )
        for mechanism in mechanisms
        for check in mechanism.checks
    )
