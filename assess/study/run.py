"""A run of a study: from its plain data to its results, to the verdict alone, or to its overturning envelopes alone.

The results do not depend on the number of jobs. They hold automatic controls of every mechanism (NTC 2018, 10.2.1:
controls that the report lists). For the verdict alone, as of one of ten thousand walls, only what decides is computed:
the procedures that the basis of the verdict may ask, and the ground motions only where one of these or the base of a
mechanism depends on them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial, reduce
from typing import TypeVar

from assess.codes.check import BuildingState, Check
from assess.codes.context import Context
from assess.codes.procedures import pga_rules, uses_histories
from assess.codes.question import Question, methods_of
from assess.codes.verdict import State, Verdict
from assess.errors import AssessError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, locate, note, warning
from assess.results import SCHEMA_VERSION, Control, MechanismResult, Results, SensitivityResult, SweepResult
from assess.results.provenance import describe_program, stamp
from assess.results.run import FallingMechanism, UncertainAnswer
from assess.short_repr import ShortRepr
from assess.study.amplification import MechanismAmplification
from assess.study.assessment import assess_mechanisms, building_states, check_mechanism, on_building, rules_of_histories
from assess.study.checks import decide, mark_result, with_return_periods
from assess.study.controls import control_warnings, equilibrium_controls, multiplier_control
from assess.study.drawing import edges_in_space
from assess.study.drawn_ties import held_by_state, left_out_beside, ties_in_space
from assess.study.envelopes import (
    coarse_record_messages,
    critical_result,
    envelope_cases,
    map_envelopes,
    study_and_mechanism,
)
from assess.study.ground_motion import ground_motion, record_result, spectrum_result, with_primary_pulses
from assess.study.histories import (
    RockingHistories,
    further_levels,
    mechanism_histories,
    rule_levels,
    run_levels,
    run_to_decide,
)
from assess.study.history_controls import convergence_control, energy_control, governing_history
from assess.study.level_peaks import RockingCase, Solved
from assess.study.mechanism_results import comparison_rows, parameters
from assess.study.states import (
    Overrides,
    alone,
    decides,
    find_overrides,
    merge_states,
    only,
    require_sources,
    with_worse,
    worse_in,
)
from assess.study.study import (
    Progress,
    ScaledRecord,
    Study,
    SweepCase,
    may_follow_motion,
    needs_motions,
    no_progress,
    require_spectrum,
)
from assess.study.suites import motions_of, suite_faults
from assess.study.uncertainty import uncertainty
from assess.study.variations import (
    MechanismSweep,
    case_messages,
    controlling_cases,
    in_case,
    mechanisms_beside_cases,
    motions_of_case,
    run_sweeps,
    sensitivities,
    survey_tolerances,
    sweep_results,
)
from assess.workers import available_cores
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

_OfMechanism = TypeVar("_OfMechanism", bound=SweepResult | SensitivityResult | Control | UncertainAnswer)


def run_study(study: Study, *, jobs: int = 0, progress: Progress = no_progress) -> Results:
    """Assess a study, in the worse of its two states (`assess.study.states`).

    Each mechanism that sweeps change is represented by its controlling case.

    Parameters
    ----------
    study : site, records, mechanisms and questions
    jobs : number of threads; 0 for all cores. The results do not depend on it.
    progress : called with the stage, the number of its parts done, and their total

    Returns
    -------
    The tree that results.json holds.

    Raises
    ------
    ProjectError : if the study has no spectrum
    AssessError : if a record, mechanism or procedure cannot be evaluated
    """
    spectrum = require_spectrum(study)
    progress("ground motions", 0, 1)
    motions = motions_of(study, spectrum, jobs=jobs)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    solved: Solved = {}  # the two states share most of their histories
    typed, _ = _run_state(study, spectrum, motions, jobs=jobs, progress=progress, solved=solved)
    assert typed.verdict is not None
    progress("values without a source", 0, 1)
    overrides = find_overrides(study, motions, jobs=jobs)
    replaced, overrides = _replaced(study, overrides)
    typed = replace(typed, verdict=require_sources(typed.verdict, overrides))
    assert typed.verdict is not None
    apart = _replaced_apart(study, overrides)
    other = None
    if replaced is not None:
        others = (_decide_state(state, jobs=jobs, solved=solved) for state in (replaced, *apart))
        other = reduce(with_worse, (require_sources(each.verdict, overrides) for each in others))
    if replaced is None or other is None or not decides(other, typed.verdict):
        return replace(typed, verdict=merge_states(typed.verdict, other, overrides.lines))

    def run_replaced(state: Study) -> Results:
        there = require_spectrum(state)
        motions = motions_of(state, there, jobs=jobs)
        state = replace(state, suite_faults=suite_faults(state, there, motions))
        found, _ = _run_state(state, there, motions, jobs=jobs, progress=progress, solved=solved)
        assert found.verdict is not None
        return replace(found, verdict=require_sources(found.verdict, overrides))

    found = reduce(partial(_with_worse, why="worst-of-range-apart"), map(run_replaced, (replaced, *apart)))
    assert found.verdict is not None
    verdict = merge_states(typed.verdict, found.verdict, overrides.lines)
    found = _with_worse(found, typed, why="worse-as-typed")
    absent = frozenset(each.name for each in typed.mechanisms) - {each.name for each in found.mechanisms}
    merged = _with_those_of(found, typed, absent, why="falls-replaced")
    return replace(
        merged,
        verdict=verdict,
        project=typed.project,
        inputs=typed.inputs,
        stamp=typed.stamp,
        ties=left_out_beside(merged.ties, typed.ties),
        falling=typed.falling,
    )


def _with_worse(found: Results, other: Results, *, why: str) -> Results:
    """Return results with the mechanisms of another state that come off worse there, and say why of each."""
    assert found.verdict is not None
    assert other.verdict is not None
    worse = worse_in(other.verdict, found.verdict)
    merged = _with_those_of(found, other, worse, why=why)
    return replace(merged, verdict=with_worse(found.verdict, other.verdict)) if worse else found


def _with_those_of(found: Results, other: Results, names: frozenset[str], *, why: str) -> Results:
    """Return results with some mechanisms as another state has them, without those that fall there, and say why."""
    there = [each for each in other.mechanisms if each.name in names]
    kept = {each.name: each for each in (*(each for each in found.mechanisms if each.name not in names), *there)}
    order = dict.fromkeys(each.name for each in (*other.mechanisms, *found.mechanisms))
    mechanisms = tuple(kept[name] for name in order if name in kept)
    places = {f"mechanisms.{name}" for name in names}
    sampled, there_too = found.uncertainty, () if other.uncertainty is None else other.uncertainty.answers
    answers = () if sampled is None else _of_worse(sampled.answers, there_too, names)
    return replace(
        found,
        mechanisms=mechanisms,
        critical=critical_result({each.name: each.envelope for each in mechanisms if each.envelope is not None}),
        comparison=comparison_rows(mechanisms),
        sweeps=_of_worse(found.sweeps, other.sweeps, names),
        sensitivity=_of_worse(found.sensitivity, other.sensitivity, names),
        controls=_of_worse(found.controls, other.controls, names),
        ties=held_by_state(found.ties, other.ties, names),
        uncertainty=None if sampled is None else replace(sampled, answers=answers),
        warnings=(
            *(each for each in found.warnings if each.where not in places),
            *(each for each in other.warnings if each.where in places),
            *(warning(why, f"mechanisms.{each.name}") for each in sorted(there, key=lambda each: each.name)),
        ),
    )


def _replaced_apart(study: Study, overrides: Overrides) -> tuple[Study, ...]:
    """Return the states of the mechanisms for which another value of a range is the worst."""
    if study.replaced is None:
        return ()
    return tuple(only(study.replaced(values), names) for values, names in overrides.apart)


def _of_worse(
    found: tuple[_OfMechanism, ...], typed: tuple[_OfMechanism, ...], worse: frozenset[str]
) -> tuple[_OfMechanism, ...]:
    return (
        *(each for each in found if each.mechanism not in worse),
        *(each for each in typed if each.mechanism in worse),
    )


def _replaced(study: Study, overrides: Overrides) -> tuple[Study | None, Overrides]:
    """Return the study in which no value stands that helps without a source, None where all may stand; and what helps.

    Where they cannot all be replaced at once, as two exclude each other, it is that without the one that helps most and
    all others that can be replaced with it; the rest need a source.
    """
    if not overrides.replaced or study.replaced is None:
        return None, overrides
    try:
        return study.replaced(overrides.replaced), overrides
    except (AssessError, SpectrumError):
        kept, left = list(overrides.replaced_alone), []
        for value in overrides.replaced:
            try:
                study.replaced((*kept, value))
            except (AssessError, SpectrumError):
                left += [] if value in kept else [(value, frozenset(value.mechanisms))]
            else:
                kept += [] if value in kept else [value]
        return study.replaced(kept), replace(overrides, unvouched=(*overrides.unvouched, *left))


def _run_state(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    *,
    jobs: int,
    progress: Progress,
    solved: Solved | None = None,
) -> tuple[Results, Mapping[str, MechanismSweep]]:
    """Assess one state of a study under its motions; with the sweep that represents each swept mechanism.

    solved : histories that the other state has found
    """
    sweeps = run_sweeps(study, motions, jobs=jobs, progress=progress)
    swept, without_typed = {each.mechanism for each in sweeps}, mechanisms_beside_cases(study.sweeps)
    as_typed = [each for each in study.mechanisms if each.name not in swept or each.name in without_typed]
    unswept = replace(study, mechanisms=tuple(as_typed))
    as_file_has_it = assess_mechanisms(unswept, spectrum, motions, jobs=jobs, progress=progress, solved=solved)
    besides = tuple(each for each in as_file_has_it if each.name in without_typed)
    controlling = controlling_cases(sweeps, {each.result.name: each for each in in_case(study, besides)})
    unswept_results = {each.name: each for each in as_file_has_it}
    results = tuple(
        controlling[mechanism.name].controlling_result
        if mechanism.name in controlling
        else unswept_results[mechanism.name]
        for mechanism in study.mechanisms
    )
    question = _deciding_question(study, controlling)
    verdict = _decide_with_tolerance(study, question, spectrum, results)
    hazard = study.fragility.hazard
    results = tuple(with_return_periods(mark_result(verdict, question, each), hazard) for each in results)
    cases = envelope_cases(study, controlling)
    envelopes = map_envelopes(cases, study.pulses, jobs=jobs, progress=progress)
    nga_numbers = dict(study.fitting.nga)
    records = tuple(record_result(motion, spectrum, nga=nga_numbers.get(motion.record.id)) for motion in motions)
    controls = _controls_of(study, controlling, motions, results, jobs=jobs)
    program = describe_program()
    beside = tuple(
        replace(edges_in_space(solid), kind="tie" if solid.name in study.drawn_ties else "") for solid in study.beside
    )
    ties = ties_in_space(
        study.resolved, _mechanisms_by_name(study, controlling), results, beside, pga_g=question.action.pga_g
    )
    found = Results(
        schema_version=SCHEMA_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=(
            *_study_messages(study, controlling),
            *_as_typed_messages(swept.difference(controlling)),
            *_suite_messages(study, motions),
            *coarse_record_messages(cases, motions),
            *control_warnings(controls),
        ),
        project=study.resolved,
        spectrum=spectrum_result(spectrum),
        records=with_primary_pulses(records, motions, study.pulses),
        mechanisms=tuple(replace(result, envelope=envelopes.get(result.name)) for result in results),
        critical=critical_result(envelopes),
        comparison=comparison_rows(results),
        sweeps=sweep_results(sweeps, controlling),
        verdict=verdict,
        falling=study.falling,
        beside=beside,
        before=study.before,
        ties=ties,
        ground_motion=ground_motion(study, spectrum, motions),
        sensitivity=sensitivities(study, spectrum, motions, results, jobs=jobs, progress=progress),
        stamp=stamp("run", program, study.inputs),
        controls=controls,
        report=study.report,
        verification=study.annex,
        uncertainty=uncertainty(study, spectrum, motions, results, jobs=jobs, progress=progress),
    )
    return found, controlling


def _mechanisms_by_name(study: Study, controlling: Mapping[str, MechanismSweep]) -> Mapping[str, Mechanism]:
    """Return each mechanism, a swept one as its controlling case has it."""
    swept = (each for sweep in controlling.values() for each in sweep.controlling_case.study.mechanisms)
    return {each.name: each for each in (*study.mechanisms, *swept)}


NO_HISTORIES = RockingHistories((), ())


@dataclass(frozen=True)
class CheckedMechanism:
    """A mechanism by its name, with its checks."""

    name: str
    checks: tuple[Check, ...]


@dataclass(frozen=True, repr=False)
class DecidedMechanism(ShortRepr):
    """A mechanism as it decides.

    study : of it alone, in the state that decides; case : that of a sweep that controls, None where none does
    checks : by the methods that may decide
    """

    study: Study
    checks: tuple[Check, ...]
    case: SweepCase | None = None


@dataclass(frozen=True, repr=False)
class Decided(ShortRepr):
    """A verdict, and what it was found of.

    of : its mechanisms by name; one that falls only where values are replaced is as typed, so that it can be drawn
    falling : those that fall at rest in the state in which they decide
    """

    verdict: Verdict
    of: Mapping[str, DecidedMechanism]
    falling: tuple[FallingMechanism, ...]

    @property
    def mechanisms(self) -> tuple[MechanismResult, ...]:
        """Each mechanism as it decides, with its checks marked; a swept one in its controlling case."""
        return tuple(
            mark_result(self.verdict, each.study.question, replace(found, checks=each.checks))
            for each in self.of.values()
            for found in parameters(each.study)
        )


def find_outcome(study: Study, *, jobs: int = 1) -> Verdict:
    """Return the verdict of a study but for how near its answers by histories are to their limits.

    Outcomes, PGA at capacity, demands over capacities and what is missing are those of `find_verdict`, in less time;
    what is at the limit, how far 16 % of the draws hold and the figures of an index are not. Errors are those of
    `find_verdict`.

    Parameters
    ----------
    study : site, records, mechanisms and questions
    jobs : number of threads; 0 for all cores
    """
    return find_verdict(study, jobs=jobs, run=_histories_of_outcome)


def find_decided_outcome(study: Study, *, jobs: int = 1, solved: Solved | None = None) -> Decided:
    """Return the verdict of `find_outcome`, with the mechanisms in the state in which each decides.

    What the verdict hangs on has the values with a source too, where no history decides.

    Parameters
    ----------
    study, jobs : as of `find_outcome`
    solved : histories that earlier calls have found, which are added to
    """
    by_histories = any(map(uses_histories, methods_of(study.question)))
    return _find_decided(study, jobs=jobs, run=_histories_of_outcome, with_sources=not by_histories, solved=solved)


def find_verdict(study: Study, *, jobs: int = 1, run: DecidingHistories | None = None) -> Verdict:
    """Return the verdict of a study as `run` finds it, in the worse of its two states.

    Parameters
    ----------
    study : site, records, mechanisms and questions
    jobs : number of threads; 0 for all cores
    run : runs the histories of a mechanism; all that the verdict holds if None

    Raises
    ------
    ProjectError : if the study has no spectrum
    AssessError : if a record, mechanism or procedure cannot be evaluated
    """
    return _find_decided(study, jobs=jobs, run=run).verdict


def _find_decided(
    study: Study,
    *,
    jobs: int,
    run: DecidingHistories | None,
    with_sources: bool = False,
    solved: Solved | None = None,
) -> Decided:
    solved = {} if solved is None else solved
    typed = _decide_state(study, jobs=jobs, run=run, solved=solved)
    methods = methods_of(study.question)
    study = replace(study, procedures=tuple(procedure for procedure in study.procedures if procedure in methods))
    motions: tuple[ScaledRecord, ...] = ()
    asked = study.question.struck_out or any(not each.source for each in study.replaceables)
    if asked and needs_motions(study):
        motions = motions_of(study, require_spectrum(study), jobs=jobs)
    overrides = find_overrides(study, motions, jobs=jobs, with_sources=with_sources)
    replaced, overrides = _replaced(study, overrides)

    def sourced(state: Decided) -> Decided:
        return replace(state, verdict=require_sources(state.verdict, overrides))

    typed = sourced(typed)
    if replaced is None:
        return replace(typed, verdict=merge_states(typed.verdict, None, overrides.lines))
    states = (replaced, *_replaced_apart(study, overrides))
    others = [sourced(_decide_state(state, jobs=jobs, run=run, solved=solved)) for state in states]
    other = reduce(_with_worse_decided, others)
    verdict = merge_states(typed.verdict, other.verdict, overrides.lines)
    if verdict.state != State.REPLACED:
        return replace(typed, verdict=verdict)
    found = _with_worse_decided(other, typed)
    return replace(found, verdict=verdict, of={**typed.of, **found.of})


def _with_worse_decided(found: Decided, other: Decided) -> Decided:
    """Return what was decided with the mechanisms of another state that come off worse there."""
    worse = worse_in(other.verdict, found.verdict)
    of = {name: each for name, each in found.of.items() if name not in worse}
    falling = [each for each in found.falling if each.name not in worse]
    return Decided(
        with_worse(found.verdict, other.verdict),
        of | {name: each for name, each in other.of.items() if name in worse},
        (*falling, *(each for each in other.falling if each.name in worse)),
    )


def find_state_verdict(
    study: Study, *, jobs: int = 1, run: DecidingHistories | None = None, solved: Solved | None = None
) -> Verdict:
    """Return the verdict of one state of a study.

    What is at the limit is found by the usual 5 % alone: the tolerance of the survey, which changes no outcome, is not
    tried. A study with sweeps is run in all its cases, as the controlling ones decide, without what cannot decide.
    Parameters and errors are those of `find_verdict`.
    """
    return _decide_state(study, jobs=jobs, run=run, solved=solved).verdict


def _decide_state(
    study: Study, *, jobs: int, run: DecidingHistories | None = None, solved: Solved | None = None
) -> Decided:
    if study.sweeps:
        found, controlling = _run_what_decides(study, jobs=jobs)
        assert found.verdict is not None
        cases = {name: swept.controlling_case for name, swept in controlling.items()}
        decided = {
            each.name: DecidedMechanism(
                alone(cases[each.name].study if each.name in cases else study, each.name),
                each.checks,
                cases.get(each.name),
            )
            for each in found.mechanisms
        }
        return Decided(found.verdict, decided, study.falling)
    spectrum = require_spectrum(study)
    methods = methods_of(study.question)
    study = replace(study, procedures=tuple(procedure for procedure in study.procedures if procedure in methods))
    motions: tuple[ScaledRecord, ...] = ()
    if needs_motions(study):
        motions = motions_of(study, spectrum, jobs=jobs)
        study = replace(study, suite_faults=suite_faults(study, spectrum, motions))
    run = run or _histories_of_verdict
    checked = [
        _check_what_decides(study, spectrum, motions, mechanism, run, jobs=jobs, solved=solved)
        for mechanism in study.mechanisms
    ]
    decided = {each.name: DecidedMechanism(alone(study, each.name), each.checks) for each in checked}
    return Decided(decide(study, checked), decided, study.falling)


def _run_what_decides(study: Study, *, jobs: int) -> tuple[Results, Mapping[str, MechanismSweep]]:
    """Run a study with sweeps without what cannot decide; whole where nothing decides on some mechanism.

    The case that controls is then the most severe by all methods.
    """
    for asked in (_without_what_cannot_decide(study), study):
        motions: tuple[ScaledRecord, ...] = ()
        if asked is study or needs_motions(asked):
            motions = motions_of(asked, require_spectrum(asked), jobs=jobs)
            asked = replace(asked, suite_faults=suite_faults(asked, require_spectrum(asked), motions))
        found, controlling = _run_state(asked, require_spectrum(asked), motions, jobs=jobs, progress=no_progress)
        if all(any(check.role == "deciding" for check in each.checks) for each in found.mechanisms):
            break
    return found, controlling


def _without_what_cannot_decide(study: Study) -> Study:
    """Return a study without histories that may not decide, nor envelopes and samples, which no verdict uses."""
    methods = methods_of(study.question)
    sweeps = (
        replace(each, cases=tuple(replace(c, study=_without_what_cannot_decide(c.study)) for c in each.cases))
        for each in study.sweeps
    )
    return replace(
        study,
        procedures=tuple(each for each in study.procedures if each in methods or not uses_histories(each)),
        sweeps=tuple(sweeps),
        pulses=None,
        variables=(),
        sampling=None,
    )


@dataclass(frozen=True, repr=False)
class AssessedMechanism(ShortRepr):
    """One mechanism with the study that it was assessed in, the motions of that study, and what was found."""

    mechanism: Mechanism
    study: Study
    motions: tuple[ScaledRecord, ...]
    result: MechanismResult


def _deciding_question(study: Study, controlling: Mapping[str, MechanismSweep]) -> Question:
    """Return what decides in the controlling cases if they agree (a sweep may change the site), else in the study."""
    questions = [
        controlling[mechanism.name].controlling_case.study.question if mechanism.name in controlling else study.question
        for mechanism in study.mechanisms
    ]
    return questions[0] if questions and all(question == questions[0] for question in questions) else study.question


def _decide_with_tolerance(
    study: Study, question: Question, spectrum: Spectrum, results: Sequence[MechanismResult]
) -> Verdict:
    """Decide on the mechanisms, with the survey's tolerance on the index of those near their threshold.

    The tolerance applies at the site of the project file only, not at that of a sweep.
    """
    with_question = replace(study, question=question)
    decided = decide(with_question, results)
    if question != study.question:
        return decided
    losses = survey_tolerances(study.survey, spectrum, question, decided, results)
    return decide(with_question, results, losses) if losses else decided


@dataclass(frozen=True, repr=False)
class MechanismCase(ShortRepr):
    """A mechanism whose histories are run in a study, in one state of the building, on so many threads."""

    study: Study
    spectrum: Spectrum
    motions: tuple[ScaledRecord, ...]
    mechanism: Mechanism
    case: RockingCase
    context: Context
    threads: int

    @property
    def asks_at_rules_alone(self) -> bool:
        """Whether its procedures by histories ask for suites at PGA of their own, and not at the levels."""
        return set(filter(uses_histories, self.study.procedures)) <= set(pga_rules(self.study.options))


DecidingHistories = Callable[[MechanismCase], RockingHistories]


def _check_what_decides(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanism: Mechanism,
    run: DecidingHistories,
    *,
    jobs: int,
    solved: Solved | None,
) -> CheckedMechanism:
    """Return the checks of a mechanism, with time histories where one of them asks for these."""

    def histories(there: Study, case: RockingCase, context: Context) -> RockingHistories:
        if not any(map(uses_histories, there.procedures)):
            return NO_HISTORIES
        return run(MechanismCase(there, spectrum, motions, mechanism, replace(case, solved=solved), context, jobs))

    found = check_mechanism(study, spectrum, mechanism, motions, histories)
    return CheckedMechanism(mechanism.name, found.checks)


def _histories_of_verdict(of: MechanismCase) -> RockingHistories:
    """Run the time histories that a verdict holds; without a scan only those at the PGA that procedures ask for."""
    if of.study.scan or not of.asks_at_rules_alone:
        return mechanism_histories(of.study, of.spectrum, of.motions, of.mechanism, of.case, threads=of.threads)
    levels = rule_levels(of.study, of.spectrum, of.mechanism)
    return run_levels(of.case, of.motions, levels=(), further=levels, site_pga=of.spectrum.pga, threads=of.threads)


def _histories_of_outcome(of: MechanismCase) -> RockingHistories:
    """Run the time histories that outcomes and PGA at capacity depend on."""
    study, case = of.study, of.case
    at_rules_alone = of.asks_at_rules_alone and not study.scan
    return run_to_decide(
        case,
        of.motions,
        rules_of_histories(study, case, of.context),
        levels=() if at_rules_alone else study.levels,
        further=(rule_levels if at_rules_alone else further_levels)(study, of.spectrum, of.mechanism),
        site_pga=of.spectrum.pga,
        with_scan=study.scan,
        threads=of.threads,
    )


def _controls_of(
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
    study : the study
    controlling : the sweep that represents each swept mechanism, by name
    motions : the motions of the study
    results : what was found of its mechanisms
    jobs : number of threads; 0 for all cores. The controls do not depend on it.

    Returns
    -------
    In the order of the mechanisms, of each in the order of equilibrium, energy, multiplier, convergence.
    """
    by_name = {mechanism.name: mechanism for mechanism in results}
    cases = [
        _as_assessed(study, controlling.get(mechanism.name), motions, by_name[mechanism.name], jobs=jobs)
        for mechanism in study.mechanisms
    ]
    with ThreadPoolExecutor(jobs or available_cores()) as pool:
        return tuple(control for of_mechanism in pool.map(_mechanism_controls, cases) for control in of_mechanism)


def _mechanism_controls(case: AssessedMechanism) -> tuple[Control, ...]:
    """Make every control of one mechanism."""
    mechanism, study = case.mechanism, case.study
    of_multiplier = multiplier_control(mechanism, mechanism.oscillator)
    if not mechanism.rocks:
        return (*equilibrium_controls(mechanism, mechanism.oscillator), of_multiplier)
    equation = study.equations[mechanism.name]
    assert study.spectrum is not None  # histories were scaled to it
    governing = governing_history(
        mechanism,
        case.result.histories,
        {motion.record.id: motion for motion in case.motions},
        _amplified_as_shown(study, case.result),
        equation=equation,
        site_pga=study.spectrum.pga,
    )
    return (
        *equilibrium_controls(mechanism, mechanism.oscillator),
        energy_control(mechanism, governing, equation=equation),
        of_multiplier,
        convergence_control(mechanism, governing),
    )


def _amplified_as_shown(study: Study, result: MechanismResult) -> MechanismAmplification:
    """Return how the motion reaches a mechanism in the state of the building whose histories are shown."""
    shown = result.amplification
    state = BuildingState(shown.building_period_ratio, shown.building_damping)
    states = building_states(study, result.name)
    return on_building(study, result.name, state, among=states).amplified[result.name]


def _as_assessed(
    study: Study,
    swept: MechanismSweep | None,
    motions: tuple[ScaledRecord, ...],
    result: MechanismResult,
    *,
    jobs: int,
) -> AssessedMechanism:
    """Return a mechanism as it was assessed: in the study, or in the controlling case of its sweep."""
    study_there, mechanism = study_and_mechanism(study, swept, result.name)
    motions_there = (
        motions if swept is None else motions_of_case(swept.controlling_case.study, study, motions, jobs=jobs)
    )
    return AssessedMechanism(mechanism, study_there, motions_there, result)


def _study_messages(study: Study, controlling: Mapping[str, MechanismSweep]) -> tuple[Message, ...]:
    """Return the messages of the study; those on a swept mechanism itself are of its controlling case."""
    swept = [mechanism for mechanism in study.mechanisms if mechanism.name in controlling]
    replaced = [warned for mechanism in swept for warned in locate(mechanism.warnings, f"mechanisms.{mechanism.name}")]
    kept = [message for message in study.messages if message not in replaced]
    return (*kept, *(message for sweep in controlling.values() for message in case_messages(sweep)))


def _as_typed_messages(names: Iterable[str]) -> Iterator[Message]:
    """Yield that a swept mechanism is represented as the file itself has it."""
    for name in sorted(names):
        yield warning("sweep-as-typed", f"mechanisms.{name}")


def _suite_messages(study: Study, motions: tuple[ScaledRecord, ...]) -> tuple[Message, ...]:
    """Return the messages on artificial records; a note only if no method that follows the ground's motion decides."""
    if not any(motion.record.artificial for motion in motions):
        return ()
    return ((warning if may_follow_motion(study.question) else note)("artificial-records", "records"),)
