"""The state before the works, from the results of its own run: read, and refused unless its hazard is the project's."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isclose
from pathlib import Path
from typing import Any

from assess.codes.bases import Basis, IndexKind
from assess.codes.question import SOURCES, Missing, Question, StateBefore, Works, find_limit_states, missing_input
from assess.codes.verdict import Decision, Verdict, index_of
from assess.codes.works import LOCAL
from assess.errors import ProjectError, ResultsError
from assess.messages.message import Message, Severity, message
from assess.project import sections
from assess.project.project_file import resolved_values
from assess.project.same_building import differences_since_before, same_building_conditions
from assess.results import CapacitiesResult, Results
from assess.results.before import state_of
from assess.results.json import open_results
from assess.study.ground_motion import spectrum_result
from records.reading import relative_path
from spectra.spectrum import Spectrum

KEY = "verdict.before"
SAME = 1e-6  # relative difference of numbers that are one
HAZARD = "site.spectrum.hazard"
TIES = "tie"  # kind of the loads that are ties


@dataclass(frozen=True)
class Before:
    """The state before the works.

    state : what the verdict compares with
    shown : what the report sets beside the state of the project
    has_new_ties : whether the project has a tie that is not in it
    """

    state: StateBefore
    shown: CapacitiesResult
    has_new_ties: bool


def read_before(content: sections.Content, question: Question, spectrum: Spectrum, folder: Path) -> Before | None:
    """Read the state before the works that a project names; None where it names none.

    Parameters
    ----------
    content : of the project
    question : what it asks of its basis
    spectrum : of its site
    folder : of the project file

    Raises
    ------
    ProjectError : the file holds no verdict, was changed since it was written, holds numbers that contradict one
        another, or is by another basis, limit state, hazard or soil; the text names the number that differs
    """
    file = content.verdict.before
    if file is None:
        return None
    path = relative_path(file, folder)
    told: list[Message] = []
    try:
        found = open_results(file, tell=told.append)
        with found.blame_changes():
            state = _checked(found.results, path, told, content, question, spectrum, folder)
            return replace(state, state=replace(state.state, is_as_written=found.as_written))
    except ResultsError as error:
        raise ProjectError(f"{KEY}: {error}") from None


def _checked(
    results: Results,
    path: str,
    told: Sequence[Message],
    content: sections.Content,
    question: Question,
    spectrum: Spectrum,
    folder: Path,
) -> Before:
    """Return the state that results are of, as `read_before` does; told: on reading them."""
    if any(each.key == "results-changed" for each in told):
        raise ProjectError(f"{KEY}: {path}: changed since it was written; run the project of the state before again")
    shown = state_of(results, path=path)
    if shown is None or results.verdict is None or results.spectrum is None:
        raise ProjectError(f"{KEY}: {path}: holds no verdict; run the project of the state before with `assess run`")
    resolved = resolved_values(content, folder)
    for what, there, here in _differences(results, results.verdict, question, spectrum, resolved):
        raise ProjectError(
            f"{KEY}: {path}: {what}: {_shown(there)} there and {_shown(here)} in this project; both states are "
            "compared by the same hazard, basis and limit state: run the state before by those of this project"
        )
    for what, there, here in _contradictions(results, results.verdict, question.basis):
        if not _is_same(there, here):
            raise ProjectError(
                f"{KEY}: {path}: {what}: {_shown(there)} in its verdict and {_shown(here)} by its checks; run the "
                "project of the state before again"
            )
    indices = {each.mechanism: None if each.index is None else each.index.value for each in shown.mechanisms}
    open_ones = {each.mechanism for each in results.verdict.mechanisms if _is_open(each.answers)}
    known = {name: None if name in open_ones else index for name, index in indices.items()}
    differences = differences_since_before(results.project, resolved, inputs=results.inputs, folder=folder)
    state = StateBefore(path, _larger_index(results.verdict, known), known, differences=differences)
    return Before(state, replace(shown, differences=differences), _has_new_ties(resolved, results))


def works_of(content: sections.Content, basis: Basis | None, before: Before | None) -> Works:
    """Return the kind of works: as the project says, else local where a state before is known and a tie is new.

    Of an index before that is measured nothing tells which ties were there, so that each counts as new.
    """
    named = content.verdict.works
    if named is not None or basis is None or basis.index != IndexKind.ZETA_E:
        return named or "none"
    if before is not None:
        return "local" if before.has_new_ties else "none"
    chains = [each for each in content.mechanisms.values() if isinstance(each, sections.ChainSection)]
    has_ties = any(load.kind == TIES for each in chains for load in each.loads)
    return "local" if content.verdict.index_before is not None and has_ties else "none"


def at_another_site(before: Before | None) -> Before | None:
    """Return the state before where a case of a sweep changes the site: its indices are of another hazard."""
    return None if before is None else replace(before, state=StateBefore(before.state.path, None, {}))


def missing_since_before(content: sections.Content, question: Question) -> Iterator[Missing]:
    """Yield the mechanisms of the state before that are not examined here, where the index before sets the target."""
    before = _compared_with(question)
    if before is None or content.report.source_of(KEY):
        return
    line = f'"{KEY}" = "measured: …"'
    if gone := _gone_since_before(content, before):
        why = message("gone-since-before", {"mechanisms": ", ".join(gone)})
        yield missing_input(SOURCES, why, line, enlarges=True)
    if not before.is_as_written:
        yield missing_input(SOURCES, message("before-unlisted", {"file": before.path}), line, enlarges=True)


def conditions_since_before(content: sections.Content, question: Question) -> Iterator[Message]:
    """Yield the conditions that the building is the same, and what of the state before a source alone vouches for."""
    before = _compared_with(question)
    if before is None:
        return
    yield from same_building_conditions(before.differences)
    if not content.report.source_of(KEY):
        return
    if gone := _gone_since_before(content, before):
        yield message("gone-by-source", {"mechanisms": ", ".join(gone)}, severity=Severity.WARNING)
    if not before.is_as_written:
        yield message("unlisted-by-source", {"file": before.path}, severity=Severity.WARNING)


def _compared_with(question: Question) -> StateBefore | None:
    """Return the state before where a pass depends on it; None where there is none, or the target is another."""
    return question.before if question.works in (*LOCAL, "improvement") else None


def _gone_since_before(content: sections.Content, before: StateBefore) -> list[str]:
    return [name for name in before.indices if name not in content.mechanisms]


Difference = tuple[str, Any, Any]


def _contradictions(results: Results, verdict: Verdict, basis: Basis | None) -> Iterator[Difference]:
    """Yield the numbers of the verdict beside those of the checks that decide: what it is, and either.

    The index of a check at the limit state of the site is its PGA at capacity over that of the action.
    """
    checks = {each.name: each.checks for each in results.mechanisms}
    for one in verdict.mechanisms:
        deciding = [each for each in checks.get(one.mechanism, ()) if each.role == "deciding"]
        for each in deciding:
            own = each.limit_state == verdict.action.limit_state and each.level_pga_g == verdict.action.pga_g
            if own and each.safety_index is not None and each.capacity_pga_g is not None:
                yield f"index of {one.mechanism}", each.safety_index, each.capacity_pga_g / each.level_pga_g
        for answer in one.answers:
            same = (each for each in deciding if each.procedure == answer.procedure)
            indices = [found.value for each in same if basis and (found := index_of(each, basis)) is not None]
            if answer.index is not None and indices:
                told = answer.index.value
                yield f"index of {one.mechanism}", told, min(indices, key=lambda index: abs(index - told))


def _differences(
    results: Results, verdict: Verdict, question: Question, spectrum: Spectrum, resolved: Mapping[str, Any]
) -> Iterator[Difference]:
    """Yield what differs of basis, action, spectrum and hazard: what it is, there and here."""
    before, here, action = results.spectrum, spectrum_result(spectrum), question.action
    assert before is not None
    states, _ = find_limit_states(question)
    pairs: list[Difference] = [
        ("basis", verdict.basis, "" if question.basis is None else question.basis.name),
        ("limit states that decide", ", ".join(verdict.limit_states), ", ".join(each.name for each in states)),
        ("limit state of the site", verdict.action.limit_state, action.limit_state),
        ("return period of the action [years]", verdict.action.return_period_years, action.return_period_years),
        ("code of the spectrum", before.code, here.code),
        *(
            (f"{key} of the spectrum", before.parameters.get(key), here.parameters.get(key))
            for key in dict.fromkeys((*before.parameters, *here.parameters))
        ),
        ("damping of the spectrum", before.damping, here.damping),
        ("PGA of the site [g]", verdict.action.pga_g, action.pga_g),
        *_hazard_pairs(results, resolved),
    ]
    yield from (each for each in pairs if not _is_same(each[1], each[2]))
    if before.period_s != here.period_s:
        yield "longest period of the spectrum [s]", before.period_s[-1], here.period_s[-1]
    for period, there, own in zip(before.period_s, before.acceleration_g, here.acceleration_g, strict=False):
        if not _is_same(there, own):
            yield f"spectrum at {period:.4g} s [g]", there, own


def _hazard_pairs(results: Results, resolved: Mapping[str, Any]) -> Iterator[Difference]:
    """Yield the numbers of the rows of the hazard over return periods, where either project has it."""
    there, here = (
        [] if key is None else key.value or [] for key in (results.project.get(HAZARD), resolved.get(HAZARD))
    )
    yield f"rows of {HAZARD}", len(there), len(here)
    for place, (one, other) in enumerate(zip(there, here, strict=False), start=1):
        for key in dict.fromkeys((*one, *other)):
            yield f"{HAZARD}[{place}].{key} in SI", one.get(key), other.get(key)


def _is_same(one: Any, other: Any) -> bool:
    if isinstance(one, int | float) and isinstance(other, int | float):
        return isclose(one, other, rel_tol=SAME, abs_tol=1e-12)
    return bool(one == other)


def _shown(value: Any) -> str:
    if value is None or value == "":
        return "none"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _is_open(answers: Any) -> bool:
    """Return whether an answer decides nothing, so that its index may be too low a one to compare with."""
    return any(each.outcome == Decision.INCOMPLETE for each in answers)


def _larger_index(verdict: Verdict, known: Mapping[str, float | None]) -> float | None:
    """Return the index of the building in the better of its two states, above which works raise it; None if unknown."""
    if not known or None in known.values():
        return None
    other = () if verdict.other_state is None else verdict.other_state.mechanisms
    better = [each.index.value for each in other if each.index is not None]
    own = min(index for index in known.values() if index is not None)
    return max(own, min(better)) if len(better) == len(known) else own


def _has_new_ties(resolved: Mapping[str, Any], before: Results) -> bool:
    """Return whether a tie of the project is in no mechanism of the same name before, with the same values."""
    old = {name: _ties_of(each.value) for name, each in before.project.items() if name.endswith(".loads")}
    return any(
        tie not in old.get(name, [])
        for name, each in resolved.items()
        if name.startswith("mechanisms.") and name.endswith(".loads")
        for tie in _ties_of(each.value)
    )


def _ties_of(loads: Any) -> list[Any]:
    return [load for load in loads or () if isinstance(load, Mapping) and load.get("kind") == TIES]
