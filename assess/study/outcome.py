"""From the field's objects to the results tree: plain numbers, units in the names."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

import numpy as np
from scipy.constants import g

from assess.amplification.floor_motion import BaseMotion, ModalFilter
from assess.codes.check import Check
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
    CarriedMotion,
    ComparisonRow,
    DirectionCandidate,
    DirectionSweep,
    Factor,
    HingeForceResult,
    HistoryResult,
    MechanismResult,
    RecordResult,
    RecordSpectrum,
    SpectrumResult,
    SuiteResult,
)
from assess.study.drawing import draw
from assess.study.endurance import load_results
from assess.study.grounding import Grounded
from assess.study.joint_results import interface_curves, interface_results
from assess.study.motions import ScaledRecord
from assess.study.oscillator_results import curve_of, floats, oscillator_result, overturning_rotations, rigid_branches
from assess.study.study import Amplified, Equation
from assess.study.view import view
from records.candidates import sequence_number
from records.record import Record, scale
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

UNAMPLIFIED = AmplificationResult("none", ())
SHORTEST_PERIOD, LONGEST_DRAWN = 0.05, 4.0  # s, of the spectra of a filtered motion
ROUND = (0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5)  # [s]
SHORTEST_SHOWN = 0.01  # [s]
SAME_PERIOD = 1e-9  # relative difference of periods that are one
LONGEST_PERIOD = 10.0  # s, of the spectra in the results, where the spectrum reaches so far


def display_periods(spectrum: Spectrum) -> FloatArray:
    """Periods [s] at which spectra are shown: 0, evenly in the logarithm, round ones, and the corners of the code."""
    longest = min(LONGEST_PERIOD, spectrum.longest_period)
    corners = [float(value) for key, value in spectrum.parameters.items() if key.startswith("t_") and value != "none"]
    extra = [period for period in (*ROUND, *corners) if SHORTEST_SHOWN < period < longest]
    even = np.geomspace(SHORTEST_SHOWN, longest, 160)
    apart = [period for period in extra if np.abs(even / period - 1.0).min() > SAME_PERIOD]
    return np.concatenate(([0.0], np.unique(np.concatenate([even, apart]))))


def spectrum_result(spectrum: Spectrum) -> SpectrumResult:
    """The site's spectrum, ordinate by ordinate."""
    period = display_periods(spectrum)
    scale = {} if spectrum.factor == 1.0 else {"scale": spectrum.factor}
    return SpectrumResult(
        code=spectrum.code,
        parameters={**spectrum.parameters, **scale},
        damping=spectrum.damping,
        damping_rule=spectrum.damping_rule,
        clause=spectrum.clause,
        pga_g=spectrum.pga / g,
        period_s=floats(period),
        acceleration_g=floats(spectrum.acceleration(period) / g),
    )


def record_result(motion: ScaledRecord, spectrum: Spectrum, *, nga: int | None = None) -> RecordResult:
    """A record as used: scaled to the site's target; nga: its number in the NGA database."""
    used = scale(motion.record, motion.scaling.factor)
    period = display_periods(spectrum)
    return RecordResult(
        id=used.id,
        path=used.path,
        event=used.event,
        station=used.station,
        component=used.component,
        dt_s=used.dt,
        npts=used.npts,
        pga_g=used.pga / g,
        scale_factor=motion.scaling.factor,
        mse=motion.scaling.mse,
        trail=used.processing_history,
        spectrum=RecordSpectrum(floats(period), floats(response_spectrum(used, period) / g)),
        date=used.earthquake.time,
        magnitude=used.earthquake.magnitude,
        distance_km=None if used.distance is None else used.distance / 1000.0,
        vs30_m_per_s=used.site.vs30,
        nga=sequence_number(used.path) if nga is None else nga,
    )


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
    """One mechanism with its checks and its histories [level][record]; `scene` has its bodies in space."""
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
        direction_sweep=None if mechanism.directions is None else direction_sweep(mechanism.directions),
        drawing=drawn,
        view=None if scene is None else view(mechanism, scene),
        oscillator=oscillator_result(positive, mass=mass, rigid=rigid[0], equilibrium=oscillator.equilibrium),
        oscillator_negative=None
        if negative is None
        else oscillator_result(negative, mass=mass, rigid=rigid[-1], equilibrium=oscillator.equilibrium_negative),
        curve=curve_of(oscillator),
        interfaces=interface_results(mechanism, oscillator, [hinge.name for hinge in drawn.hinges]),
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


def amplification_result(
    amplified: Amplified, motions: Sequence[ScaledRecord] = (), base: Sequence[BaseMotion] = ()
) -> AmplificationResult:
    """How the motions reached the base of a mechanism; `base` as they act there."""
    filtered = isinstance(amplified.amplification, ModalFilter) and len(base) > 0
    most = max(range(len(base)), key=lambda place: base[place].factor) if filtered else 0
    return AmplificationResult(
        method=amplified.method,
        factors=tuple(Factor(each.record.id, each.factor) for each in base),
        height_m=amplified.height,
        said=(*amplified.said, *amplified.assumed),
        motion=carried_motion_result(motions[most], base[most].record) if filtered else None,
    )


def carried_motion_result(motion: ScaledRecord, base: Record) -> CarriedMotion:
    """A motion scaled to the target, at the ground and at the base of a mechanism, on the steps of the latter."""
    ground, scale = motion.record, motion.scaling.factor
    period = np.geomspace(SHORTEST_PERIOD, LONGEST_DRAWN, 120)
    return CarriedMotion(
        record=ground.id,
        time_s=floats(base.time),
        ground_acceleration_g=floats(scale / g * np.interp(base.time, ground.time, ground.acceleration, right=0.0)),
        base_acceleration_g=floats(scale / g * base.acceleration),
        period_s=floats(period),
        ground_spectrum_g=floats(scale / g * response_spectrum(ground, period)),
        base_spectrum_g=floats(scale / g * response_spectrum(base, period)),
    )


def hinge_force_result(forces: HingeForces) -> HingeForceResult:
    """What one hinge passes on when the mechanism starts to rock."""
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
    """The search for the weakest direction."""
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
    """All records at one level."""
    standing = [history.max_rotation_ratio for history in histories if history.max_rotation_ratio is not None]
    overturned = len(histories) - len(standing)
    ranked = [*sorted(standing), *[None] * overturned]
    return SuiteResult(
        level_pga_g=histories[0].level_pga_g,
        n=len(histories),
        overturned=overturned,
        mean_ratio=None if overturned else float(np.mean(standing)),
        max_ratio=max(standing, default=None),
        median_ratio=ranked[ceil(0.5 * len(ranked)) - 1],
        p84_ratio=ranked[ceil(0.84 * len(ranked)) - 1],
    )


def comparison_rows(mechanisms: Sequence[MechanismResult]) -> tuple[ComparisonRow, ...]:
    """Every check of every mechanism on one line."""
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
