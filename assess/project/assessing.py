"""The mechanisms of a study through every procedure, with their histories."""

from __future__ import annotations

from collections.abc import Callable

from assess.amplification import Carried, carried
from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.registry import procedure
from assess.mechanisms.activation import hinge_forces
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.oscillation import oscillator
from assess.oscillator import Oscillator
from assess.project.histories import Rocking, Shaken, governing_trace, rocking, suite_of
from assess.project.motions import Motion
from assess.project.outcome import amplification_result, mechanism_result
from assess.project.study import Amplified, Study
from assess.results import MechanismResult
from spectra.spectrum import Spectrum

HISTORY_PROCEDURE = "asce43-05-history"
Progress = Callable[[str, int, int], None]


def mechanisms_assessed(
    study: Study, spectrum: Spectrum, motions: tuple[Motion, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismResult, ...]:
    """Every mechanism of `study` under the `motions`, which fit the `spectrum`; `jobs` threads."""
    shaken = [
        Shaken(m.name, oscillator(m), study.equations[m.name], at_base(study.amplified[m.name], motions))
        for m in study.mechanisms
    ]
    rocked = rocking(
        shaken,
        motions,
        levels=study.levels,
        site_pga=spectrum.pga,
        scanned=HISTORY_PROCEDURE in study.procedures,
        threads=jobs,
        progress=progress,
    )
    return tuple(
        assessed(study, spectrum, motions, mechanism, one, rocked[mechanism.name])
        for mechanism, one in zip(study.mechanisms, shaken, strict=True)
    )


def at_base(amplified: Amplified, motions: tuple[Motion, ...]) -> tuple[Carried, ...]:
    """Every motion as it acts at the base of a mechanism."""
    return tuple(carried(amplified.amplification, motion.record) for motion in motions)


def assessed(
    study: Study, spectrum: Spectrum, motions: tuple[Motion, ...], mechanism: Mechanism, shaken: Shaken, rocked: Rocking
) -> MechanismResult:
    """One mechanism through every procedure, with its histories."""
    context = context_of(study, spectrum, mechanism, rocked, shaken.base)
    return mechanism_result(
        mechanism,
        shaken.oscillator,
        equation=shaken.equation,
        scene=study.scenes.get(mechanism.name),
        checks=checks_of(study, shaken.oscillator, context),
        histories=governing_trace(shaken, rocked.histories, motions),
        amplification=amplification_result(study.amplified[mechanism.name], motions, shaken.base),
    )


def context_of(
    study: Study, spectrum: Spectrum, mechanism: Mechanism, rocked: Rocking, base: tuple[Carried, ...]
) -> Context:
    """What the procedures may know of one mechanism."""
    ground = study.building.ground_elevation if study.building is not None else 0.0
    suites = tuple(
        suite_of(histories, pga=level) for level, histories in zip(study.levels, rocked.histories, strict=True)
    )
    return Context(
        spectrum=spectrum,
        levels=study.levels,
        vertical_ratio=study.vertical_ratio,
        elevation=mechanism.elevation - ground,
        building=study.building,
        suites=suites,
        histories_at="ground" if study.amplified[mechanism.name].height is None else "mechanism base",
        amplification=max((each.factor for each in base), default=1.0),
        linearised=study.equations[mechanism.name] == "linearised",
        hinges=hinge_forces(mechanism),
        incremental=tuple(sorted((*rocked.scan, *suites), key=lambda suite: suite.pga)) if rocked.scan else (),
    )


def checks_of(study: Study, rocker: Oscillator, context: Context) -> tuple[Check, ...]:
    """The answers of every procedure of the study, in its order."""
    return tuple(check for name in study.procedures for check in procedure(name, study.options)(rocker, context))
