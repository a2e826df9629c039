"""The assessment of mechanisms by all procedures of a study, by histories in every state of the building.

A filter by the first mode of the elastic building alone misses what an earthquake does to it: a masonry building
softens, and its motion meets the slow sway of a rocking body later. A procedure says through which states its histories
run; a first mode that the project states for a limit state stands for them there. Each state has its own histories and
checks, at one time step; of the checks of one limit state and level the worst stands.

A wall of 0.4 x 2.4 m upstairs under 40 records: 19 overturn it on the elastic building, 27 at 1.75 T_1 and 10 %.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from math import inf

from assess.amplification import ModalFilter
from assess.codes.calculation_sheet import Given, step
from assess.codes.check import ELASTIC, BuildingState, Check, Outcome
from assess.codes.context import Context
from assess.codes.histories import SuiteRule
from assess.codes.procedures import PROCEDURES, history_rules, uses_histories
from assess.codes.question import methods_of
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Quantity, note, whole_number
from assess.results.mechanism import MechanismResult
from assess.study.amplification import MechanismAmplification
from assess.study.checks import checks_of, context_of, with_histories
from assess.study.histories import (
    RockingHistories,
    further_levels,
    mechanism_histories,
    rocking_case,
    run_levels,
    run_to_decide,
    vibrates,
    with_governing_trace,
    without_runs,
)
from assess.study.level_peaks import RockingCase, Solved
from assess.study.mechanism_results import amplification_result, mechanism_result
from assess.study.study import Progress, ScaledRecord, Study
from assess.workers import available_cores
from spectra.spectrum import Spectrum

RunHistories = Callable[[Study, RockingCase, Context], RockingHistories]


@dataclass(frozen=True)
class MechanismCheck:
    """The checks of a mechanism, and what they follow from in the state of the building where it comes off worst.

    amplified : how the motion reaches its base in that state
    """

    checks: tuple[Check, ...]
    case: RockingCase
    histories: RockingHistories
    amplified: MechanismAmplification


def assess_mechanisms(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    *,
    jobs: int,
    progress: Progress,
    solved: Solved | None = None,
) -> tuple[MechanismResult, ...]:
    """Assess every mechanism of a study.

    Each thread takes a mechanism, the longest work first; if there are fewer mechanisms than threads, several threads
    share the histories of each. So the procedures of one, which hold the interpreter's lock, run beside the histories
    of another, which do not.

    Parameters
    ----------
    study : the study
    spectrum : the site's elastic spectrum, to which the motions are scaled
    motions : the suite of records
    jobs : number of threads; 0 for all cores
    progress : called as mechanisms are done
    solved : histories that another state of the study has found, and where those of this one are kept

    Returns
    -------
    In the order of the study.
    """
    workers = jobs or available_cores()
    threads = max(1, workers // max(1, len(study.mechanisms)))

    def assess(mechanism: Mechanism) -> MechanismResult:
        def run(there: Study, case: RockingCase, context: Context) -> RockingHistories:
            shared = replace(case, solved=solved)
            return mechanism_histories(there, spectrum, motions, mechanism, shared, threads=threads)

        found = check_mechanism(study, spectrum, mechanism, motions, run)
        histories = () if mechanism.variants.depends_on else found.histories.histories
        return mechanism_result(
            mechanism,
            mechanism.variants.starting,
            equation=found.case.equation,
            scene=study.scenes.get(mechanism.name),
            checks=found.checks,
            histories=with_governing_trace(found.case, histories, motions) if histories else (),
            amplification=amplification_result(found.amplified, motions, found.case.base),
            height=study.heights[mechanism.name],
        )

    longest = sorted(study.mechanisms, key=lambda mechanism: not vibrates(mechanism.variants.deciding))
    done: dict[str, MechanismResult] = {}
    progress("rocking histories", 0, len(longest))
    with ThreadPoolExecutor(workers) as pool:
        for result in pool.map(assess, longest):
            done[result.name] = result
            progress("rocking histories", len(done), len(longest))
    return tuple(done[mechanism.name] for mechanism in study.mechanisms)


def checks_without_twins(
    study: Study, spectrum: Spectrum, motions: tuple[ScaledRecord, ...], *, jobs: int, with_scan: bool = False
) -> tuple[Check, ...]:
    """Return the checks of a study of one mechanism by its records as they are.

    Parameters
    ----------
    study : a study of one mechanism
    spectrum : the site's elastic spectrum
    motions : the suite of records; run only where a procedure by histories is among those of the study
    jobs : number of threads; 0 for all cores
    with_scan : whether PGA rises until each rule of the procedures has failed; without it a PGA at capacity is not
        known

    Returns
    -------
    In the order of the procedures.
    """
    (mechanism,) = study.mechanisms

    def run(there: Study, case: RockingCase, context: Context) -> RockingHistories:
        if not motions or not any(map(uses_histories, there.procedures)):
            return RockingHistories((), ())
        further = further_levels(there, spectrum, mechanism)
        if not with_scan:
            return run_levels(
                case,
                motions,
                levels=there.levels,
                further=further,
                site_pga=spectrum.pga,
                threads=jobs,
                with_twins=False,
            )
        return run_to_decide(
            case,
            motions,
            rules_of_histories(there, case, context),
            levels=there.levels,
            further=further,
            site_pga=spectrum.pga,
            with_scan=True,
            threads=jobs,
            with_twins=False,
        )

    return check_mechanism(study, spectrum, mechanism, motions, run).checks


def rules_of_histories(study: Study, case: RockingCase, context: Context) -> tuple[SuiteRule, ...]:
    """Return the rules on suites of the procedures of a study."""
    return tuple(
        rule for name in study.procedures for rule in history_rules(name, study.options, case.oscillator, context)
    )


def check_mechanism(
    study: Study, spectrum: Spectrum, mechanism: Mechanism, motions: tuple[ScaledRecord, ...], run: RunHistories
) -> MechanismCheck:
    """Check a mechanism by every procedure of the study, by histories in each state of the building.

    Parameters
    ----------
    study : the study that the mechanism is part of
    spectrum : the site's elastic spectrum
    mechanism : the mechanism to be assessed
    motions : the suite of records
    run : runs the histories of a case in a study, in the context of its procedures

    Returns
    -------
    Checks in the order of the procedures.
    """
    states = building_states(study, mechanism.name)
    found = [_in_state(study, spectrum, mechanism, motions, run, state, states) for state in states]
    if len(found) == 1:
        return found[0]
    checks: list[Check] = []
    worst_of: list[tuple[bool, Check, BuildingState]] = []
    for procedure in study.procedures:
        each_state = [tuple(check for check in one.checks if check.procedure == procedure) for one in found]
        if not uses_histories(procedure):
            checks += each_state[states.index(ELASTIC)]
            continue
        every = dict(zip(states, each_state, strict=True))
        for place, elastic in enumerate(every[ELASTIC] or next(filter(None, each_state), ())):
            used = _states_of(study, procedure, elastic.limit_state)
            check, state = max(((every[state][place], state) for state in used), key=lambda pair: _badness(pair[0]))
            checks.append(_with_state(study, mechanism.name, check, state) if len(used) > 1 else check)
            worst_of.append((procedure in methods_of(study.question), check, state))
    decided = [each for each in worst_of if each[0]] or worst_of
    _, _, worst = max(decided, key=lambda each: _badness(each[1]), default=(False, None, ELASTIC))
    return replace(found[states.index(worst)], checks=tuple(checks))


def building_states(study: Study, name: str) -> tuple[BuildingState, ...]:
    """Return the states of the building that the histories of a mechanism are run through, the elastic one first.

    It alone where the motion does not pass the first mode in time, or no procedure of the study uses histories.
    """
    if not isinstance(study.amplified[name].amplification, ModalFilter):
        return (ELASTIC,)
    used = (
        state
        for procedure in filter(uses_histories, study.procedures)
        for limit_state in (None, *_stated(study))
        for state in _states_of(study, procedure, limit_state)
    )
    return tuple(dict.fromkeys((ELASTIC, *used)))


def on_building(study: Study, name: str, state: BuildingState, *, among: Sequence[BuildingState]) -> Study:
    """Return the study in which the motion reaches a mechanism through a state of the building.

    Parameters
    ----------
    study, name : the study, and the mechanism's name in it
    state : of the building
    among : all states that are run, which have the time step of the fastest
    """
    amplified = study.amplified[name]
    if len(among) == 1 or not isinstance(amplified.amplification, ModalFilter):
        return study
    filtered = amplified.amplification
    mode = replace(filtered.mode, frequency=filtered.mode.frequency / state.period_ratio)
    mode = mode if state.damping is None else replace(mode, damping=state.damping)
    fastest = max(filtered.mode.frequency / each.period_ratio for each in among)
    through = replace(filtered, mode=mode, fastest=fastest)
    words = note(
        "on-softened-building",
        f"mechanisms.{name}.amplification",
        states=whole_number(len(among)),
        ratio=Quantity(state.period_ratio, figures=3),
        period=Quantity(1.0 / mode.frequency, "time", 3),
        damping=Quantity(mode.damping, "ratio", 3),
    )
    there = replace(amplified, amplification=through, description=(*amplified.description, words), state=state)
    return replace(study, amplified={**study.amplified, name: there})


def _in_state(
    study: Study,
    spectrum: Spectrum,
    mechanism: Mechanism,
    motions: tuple[ScaledRecord, ...],
    run: RunHistories,
    state: BuildingState,
    among: Sequence[BuildingState],
) -> MechanismCheck:
    """Check a mechanism in one state of the building; in all but the elastic one by what runs through it."""
    there = on_building(study, mechanism.name, state, among=among)
    if state != ELASTIC:
        asked = (each for each in study.procedures if uses_histories(each) and _asks_for(study, each, state))
        there = replace(there, procedures=tuple(asked))
    case = rocking_case(there, mechanism, motions)
    context = context_of(there, spectrum, mechanism, case.base, motions)
    histories = run(there, case, context) if mechanism.rocks else without_runs(there, spectrum, mechanism)
    checks = checks_of(there, case.oscillator, with_histories(context, histories))
    return MechanismCheck(checks, case, histories, there.amplified[mechanism.name])


def _asks_for(study: Study, procedure: str, state: BuildingState) -> bool:
    return any(state in _states_of(study, procedure, limit_state) for limit_state in (None, *_stated(study)))


def _states_of(study: Study, procedure: str, limit_state: str | None) -> tuple[BuildingState, ...]:
    """Return the states of a procedure, or the one that the project states for the limit state."""
    stated, buildings = _stated(study), PROCEDURES[procedure].buildings
    return (stated[limit_state],) if limit_state in stated and len(buildings) > 1 else buildings


def _stated(study: Study) -> dict[str | None, BuildingState]:
    """Return the first modes of the building that the project states for limit states, by their names."""
    building = study.building
    if building is None:
        return {}
    return {
        name: BuildingState(mode.period / building.period, mode.damping) for name, mode in building.limit_states.items()
    }


def _badness(check: Check) -> tuple[int, float, float]:
    """Return what orders the checks of one limit state: outcome, then capacity, then demand over capacity."""
    failed = check.verdict == Outcome.FAIL
    outcome = 2 if failed else 0 if check.verdict == Outcome.PASS else 1
    unknown = 0.0 if failed else inf
    capacity = unknown if check.capacity_pga_g is None else check.capacity_pga_g
    overturned = inf if failed else 0.0
    return outcome, -capacity, overturned if check.ratio is None else check.ratio


def _with_state(study: Study, name: str, check: Check, state: BuildingState) -> Check:
    """Return a check whose sheet says in which state of the building it is the worst."""
    filtered = study.amplified[name].amplification
    assert isinstance(filtered, ModalFilter)
    elastic = 1.0 / filtered.mode.frequency
    damping = filtered.mode.damping if state.damping is None else state.damping
    given: Given = {"T_1": (elastic, "s"), "r": state.period_ratio}
    words = "first period of the building, in the worst of its states"
    clause = PROCEDURES[check.procedure].building_clause
    steps = (
        step("T_1'", words, clause, "r · T_1", state.period_ratio * elastic, "s", given=given),
        step("ξ_1", "damping of its first mode in that state", clause, "of the state", damping),
    )
    return replace(check, steps=(*steps, *check.steps))
