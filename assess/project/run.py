"""From a study to its results: a pure function of the study, whatever the number of jobs."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version

from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.registry import procedure
from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.virtual_work import oscillator
from assess.oscillator import Oscillator
from assess.project.histories import Rocking, Shaken, governing_trace, rocking, suite_of
from assess.project.motions import Motion, motions_of
from assess.project.outcome import comparison, mechanism_result, record_result, spectrum_result
from assess.project.study import Study
from assess.results import SCHEMA_VERSION, MechanismResult, Notice, Program, Results
from spectra.spectrum import Spectrum

NAME = "rocking-assess"
HISTORY_PROCEDURE = "asce43-05-history"
Progress = Callable[[str, int, int], None]


def run(study: Study, *, jobs: int = 0, progress: Progress = lambda stage, done, total: None) -> Results:
    """The results of `study`; `jobs` threads, 0 for all cores. `progress` is told (stage, done, total)."""
    spectrum = required_spectrum(study)
    progress("ground motions", 0, 1)
    motions = motions_of(study, spectrum)
    shaken = [Shaken(m.name, oscillator(m), study.equations[m.name]) for m in study.mechanisms]
    rocked = rocking(
        shaken,
        motions,
        levels=study.levels,
        site_pga=spectrum.pga,
        scanned=HISTORY_PROCEDURE in study.procedures,
        threads=jobs,
        progress=progress,
    )
    mechanisms = tuple(
        assessed(study, spectrum, motions, mechanism, one, rocked[mechanism.name])
        for mechanism, one in zip(study.mechanisms, shaken, strict=True)
    )
    return Results(
        schema_version=SCHEMA_VERSION,
        program=Program(NAME, version(NAME)),
        inputs=study.inputs,
        warnings=(*study.notices, *suite_notices(motions)),
        project=study.resolved,
        spectrum=spectrum_result(spectrum),
        records=tuple(record_result(motion, spectrum) for motion in motions),
        mechanisms=mechanisms,
        critical=None,
        comparison=comparison(mechanisms),
    )


def parameters(study: Study) -> tuple[MechanismResult, ...]:
    """Every mechanism with its rocking parameters and capacity curve; no analysis."""
    return tuple(
        mechanism_result(
            mechanism,
            oscillator(mechanism),
            equation=study.equations[mechanism.name],
            scene=study.scenes.get(mechanism.name),
        )
        for mechanism in study.mechanisms
    )


def required_spectrum(study: Study) -> Spectrum:
    """The site's spectrum, or the one line that asks for it."""
    if study.spectrum is None:
        raise ProjectError("site.spectrum: missing; an analysis needs the site's spectrum: add a table [site.spectrum]")
    return study.spectrum


def assessed(
    study: Study, spectrum: Spectrum, motions: tuple[Motion, ...], mechanism: Mechanism, shaken: Shaken, rocked: Rocking
) -> MechanismResult:
    """One mechanism through every procedure, with its histories."""
    context = context_of(study, spectrum, mechanism, rocked)
    return mechanism_result(
        mechanism,
        shaken.oscillator,
        equation=shaken.equation,
        scene=study.scenes.get(mechanism.name),
        checks=checks_of(study, shaken.oscillator, context),
        histories=governing_trace(shaken, rocked.histories, motions),
    )


def context_of(study: Study, spectrum: Spectrum, mechanism: Mechanism, rocked: Rocking) -> Context:
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
        linearised=study.equations[mechanism.name] == "linearised",
        incremental=tuple(sorted((*rocked.scan, *suites), key=lambda suite: suite.pga)) if rocked.scan else (),
    )


def checks_of(study: Study, rocker: Oscillator, context: Context) -> tuple[Check, ...]:
    """The answers of every procedure of the study, in its order."""
    return tuple(check for name in study.procedures for check in procedure(name, study.options)(rocker, context))


def suite_notices(motions: tuple[Motion, ...]) -> tuple[Notice, ...]:
    """What the engineer should know of the records."""
    if not any(motion.record.path == "" for motion in motions):
        return ()
    text = "artificial records fit the spectrum at every period at once, as no earthquake does; real records are better"
    return (Notice("artificial-records", "records", text),)
