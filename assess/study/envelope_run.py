"""A run of the overturning envelopes of a study alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from assess.amplification.floor_motion import pulse_factor
from assess.results import SCHEMA_VERSION, Results
from assess.results.program import describe_program
from assess.results.stamp import stamp
from assess.study.envelopes import DEFAULT_GRID, EnvelopeCase, critical_result, map_envelopes
from assess.study.motions import motions_of
from assess.study.parameters import parameters
from assess.study.primary_pulses import with_primary_pulses
from assess.study.progress import Progress, silent
from assess.study.site_results import record_result, spectrum_result
from assess.study.study import Study
from assess.study.study_messages import envelope_messages
from assess.study.sweep_cases import MechanismSweep
from assess.study.sweep_results import case_text


def envelope(study: Study, *, jobs: int = 0, progress: Progress = silent) -> Results:
    """Find the overturning envelopes of a study, without spectrum, records or checks.

    Mechanisms are those of the project file, without the cases of its sweeps.

    Parameters
    ----------
    study : Study
        The study; its own pulses are used, or the default ones.
    jobs : int
        Number of threads; 0 for all cores. The results do not depend on it.
    progress : Progress
        Called with the stage, the number of its parts done, and their total.

    Returns
    -------
    Results
        Parameters and envelope of each mechanism, and the critical mechanism at each frequency.
    """
    grid = study.pulses or DEFAULT_GRID
    envelopes = map_envelopes(envelope_cases(study, {}), grid, jobs=jobs, progress=progress)
    progress("primary pulses", 0, 1)
    recorded = tuple(record for record in study.records if not record.artificial)
    given = replace(study, artificial=None, records=recorded)
    motions = () if study.spectrum is None else motions_of(given, study.spectrum)
    records = () if study.spectrum is None else tuple(record_result(motion, study.spectrum) for motion in motions)
    program = describe_program()
    return Results(
        schema_version=SCHEMA_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=envelope_messages(study),
        project=study.resolved,
        spectrum=None if study.spectrum is None else spectrum_result(study.spectrum),
        records=with_primary_pulses(records, motions, grid),
        mechanisms=tuple(replace(each, envelope=envelopes.get(each.name)) for each in parameters(study)),
        critical=critical_result(envelopes),
        comparison=(),
        sweeps=(),
        stamp=stamp("envelope", program, study.inputs),
    )


def envelope_cases(study: Study, controlling: Mapping[str, MechanismSweep]) -> tuple[EnvelopeCase, ...]:
    """Return the mechanisms whose envelopes are sought, swept ones in their controlling case.

    Mechanisms that fall at rest without actions that are not shown to last are left out.
    """
    found = []
    for mechanism in study.mechanisms:
        sweep = controlling.get(mechanism.name)
        of = study if sweep is None else sweep.case.study
        case = "" if sweep is None else case_text(sweep.sweep, sweep.case, sweep.mechanism)
        used = next(each for each in of.mechanisms if each.name == mechanism.name)
        oscillator = used.variants.collapse
        if oscillator is None:
            continue
        factor = partial(pulse_factor, of.amplified[used.name].amplification)
        found.append(EnvelopeCase(used.name, oscillator, of.equations[used.name], factor, case))
    return tuple(found)
