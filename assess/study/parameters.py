"""The rocking parameters of a study's mechanisms, without analysis."""

from __future__ import annotations

from dataclasses import replace

from assess.errors import locate_errors
from assess.results import MechanismResult
from assess.study.amplification_results import amplification_result
from assess.study.mechanism_results import mechanism_result
from assess.study.study import Study
from assess.study.sweep_results import case_text


def parameters(study: Study) -> tuple[MechanismResult, ...]:
    """Return every mechanism with its rocking parameters and capacity curve."""
    return tuple(
        mechanism_result(
            mechanism,
            mechanism.variants.starting,
            equation=study.equations[mechanism.name],
            scene=study.scenes.get(mechanism.name),
            amplification=amplification_result(study.amplified[mechanism.name]),
            grounded=study.grounded[mechanism.name],
        )
        for mechanism in study.mechanisms
    )


def case_parameters(study: Study) -> tuple[MechanismResult, ...]:
    """Return the parameters of every case of every sweep; each mechanism is named with its case."""
    found = []
    for sweep in study.sweeps:
        for case in sweep.cases:
            with locate_errors(case.name):
                each = parameters(case.study)
            found += [replace(one, name=f"{one.name}, {case_text(sweep, case, one.name)}") for one in each]
    return tuple(found)
