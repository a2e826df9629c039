"""The automatic controls of every mechanism of a run (NTC 2018, 10.2.1: controls that the report lists)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from assess.mechanisms.mechanism import Mechanism
from assess.results import Control, MechanismResult
from assess.short_repr import ShortRepr
from assess.study.controls.convergence import convergence_control
from assess.study.controls.energy import energy_control
from assess.study.controls.equilibrium import equilibrium_controls
from assess.study.controls.governing import governing_history
from assess.study.controls.hand_multiplier import multiplier_control
from assess.study.motions import ScaledRecord
from assess.study.study import Study
from assess.study.sweep_cases import MechanismSweep
from assess.study.sweeps import motions_of_case
from assess.workers import available_cores


@dataclass(frozen=True, repr=False)
class Controlled(ShortRepr):
    """One mechanism with the study that it was assessed in, the motions of that study, and what was found."""

    mechanism: Mechanism
    study: Study
    motions: tuple[ScaledRecord, ...]
    result: MechanismResult


def controls_of(
    study: Study,
    controlling: Mapping[str, MechanismSweep],
    motions: tuple[ScaledRecord, ...],
    results: Sequence[MechanismResult],
    *,
    jobs: int,
) -> tuple[Control, ...]:
    """Make every control of every mechanism, swept ones in their controlling case.

    Parameters
    ----------
    study : Study
        The study.
    controlling : mapping
        The sweep that represents each swept mechanism, by name.
    motions : tuple of ScaledRecord
        The motions of the study.
    results : sequence of MechanismResult
        What was found of its mechanisms.
    jobs : int
        Number of threads; 0 for all cores. The controls do not depend on it.

    Returns
    -------
    tuple of Control
        In the order of the mechanisms, of each in the order of equilibrium, energy, multiplier, convergence.
    """
    found = {each.name: each for each in results}
    cases = [
        _controlled(study, controlling.get(each.name), motions, found[each.name], jobs=jobs)
        for each in study.mechanisms
    ]
    with ThreadPoolExecutor(jobs or available_cores()) as pool:
        return tuple(control for made in pool.map(mechanism_controls, cases) for control in made)


def mechanism_controls(case: Controlled) -> tuple[Control, ...]:
    """Make every control of one mechanism."""
    mechanism, study = case.mechanism, case.study
    equation = study.equations[mechanism.name]
    assert study.spectrum is not None  # histories were scaled to it
    governing = governing_history(
        mechanism,
        case.result.histories,
        {motion.record.id: motion for motion in case.motions},
        study.amplified[mechanism.name],
        equation=equation,
        site_pga=study.spectrum.pga,
    )
    return (
        *equilibrium_controls(mechanism, mechanism.oscillator),
        energy_control(mechanism, governing, equation=equation),
        multiplier_control(mechanism, mechanism.oscillator),
        convergence_control(mechanism, governing),
    )


def _controlled(
    study: Study,
    sweep: MechanismSweep | None,
    motions: tuple[ScaledRecord, ...],
    result: MechanismResult,
    *,
    jobs: int,
) -> Controlled:
    """Return a mechanism as it was assessed: in the study, or in the controlling case of its sweep."""
    of = study if sweep is None else sweep.case.study
    moving = motions if sweep is None else motions_of_case(sweep.case, study, motions, jobs=jobs)
    return Controlled(next(each for each in of.mechanisms if each.name == result.name), of, moving, result)
