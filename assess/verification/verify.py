"""Solved cases run again, in processes, and compared with their sources."""

from __future__ import annotations

import hashlib
import math
import traceback
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import as_completed
from dataclasses import replace
from pathlib import Path, PurePosixPath
from posixpath import normpath
from typing import TYPE_CHECKING, Any

from assess.examples import EXAMPLES, source
from assess.results.provenance import Input, describe_program
from assess.results.verification import (
    VERIFICATION_VERSION,
    CaseResult,
    Coverage,
    QuantityResult,
    ValueResult,
    VerificationResults,
)
from assess.verification.case_files import LARGEST_NUMBER, CaseFile, ComparedQuantity, cases_for, read_cases
from assess.verification.solvers import SOLVERS
from assess.workers import process_pool

if TYPE_CHECKING:
    from assess.study.study import Progress


NAMES = ("name", "id", "procedure", "symbol", "record")
"""The keys by which an item of a list is found."""


def verify(cases: Sequence[CaseFile], *, quick: bool, jobs: int | None, progress: Progress) -> VerificationResults:
    """Run cases in processes and compare them; the results do not depend on their number.

    Parameters
    ----------
    cases : to run
    quick : only those that are quick
    jobs : processes, None for all cores
    progress : is called with (stage, done, total)
    """
    chosen = [each for each in cases if each.case.quick or not quick]
    found = {each.key: each for each in _results(chosen, jobs, progress)}
    return VerificationResults(
        VERIFICATION_VERSION, describe_program(), quick, tuple(found[each.key] for each in chosen)
    )


def coverage_of(uses: Sequence[str], cases: Iterable[CaseResult]) -> tuple[Coverage, ...]:
    """Return, for each thing that is used, the keys of the cases that exercise it; none where there is no case.

    Parameters
    ----------
    uses : in the words of `assess.results.verification`
    cases : that were run
    """
    every = tuple(cases)
    return tuple(Coverage(use, tuple(each.key for each in every if use in each.uses)) for use in uses)


def note_scope(results: VerificationResults, uses: Sequence[str]) -> VerificationResults:
    """Return results that say which of the program's cases are left out, and which cases are not the program's.

    Parameters
    ----------
    results : of the cases that were run
    uses : what the project uses, in the words of `assess.results.verification`; empty for no project
    """
    own = read_cases()
    run = {each.key for each in results.cases}
    left_out = tuple(each.key for each in (cases_for(own, uses) if uses else own) if each.key not in run)
    known = {each.key: each for each in own}
    foreign = tuple(each.key for each in results.cases if _is_foreign(each, known.get(each.key)))
    return replace(results, left_out=left_out, foreign=foreign)


def run_case(file: CaseFile) -> CaseResult:
    """Solve one case and compare it; an error of the program fails the case, and is its fault."""
    try:
        tree, fault = solve_case(file), ""
    except Exception as error:
        tree, fault = {}, "".join(traceback.format_exception_only(error)).strip()
    return compare_case(file, tree, fault=fault)


def solve_case(file: CaseFile) -> Mapping[str, Any]:
    """Return the tree of numbers that the program finds for a case."""
    return SOLVERS[file.case.solver](file.path.parent, file.case.given)


def compare_case(file: CaseFile, tree: Mapping[str, Any], *, fault: str = "") -> CaseResult:
    """Compare a case with what was found for it.

    Parameters
    ----------
    file : the case
    tree : of numbers, as its solver returns it
    fault : why it could not be solved, "" if it was
    """
    case = file.case
    quantities = tuple(_compare(each, tree) for each in case.quantities)
    inputs = (Input(f"{file.key}.toml", _sha256(file.path)), *_inputs(file, tree))
    return CaseResult(
        file.key, case.title, case.theory, case.field, case.source, case.uses, inputs, quantities, fault,
        case.departures,
    )  # fmt: skip


def _is_foreign(result: CaseResult, own: CaseFile | None) -> bool:
    """Whether a case is not the program's of that key, or has read a file that is not.

    An example is copied out of the program for each run, so what a case of the program reads of one is the program's.
    """
    if own is None:
        return True
    root, example = own.path.parents[own.key.count("/")], own.case.given.get("example")
    first, *others = result.inputs
    beside = others if example is None else [e for e in others if not e.path.startswith(f"{own.project_folder}/")]
    return any(not _is_file_of(root, each) for each in (first, *beside))


def _is_file_of(folder: Path, file: Input) -> bool:
    """Whether a folder has this file with this content."""
    own = folder / file.path
    return own.is_file() and _sha256(own) == file.sha256


def _results(cases: Sequence[CaseFile], jobs: int | None, progress: Progress) -> Iterable[CaseResult]:
    """Yield the results of cases as they come, the slow ones started first."""
    ordered = sorted(cases, key=lambda each: each.case.quick)
    with process_pool(jobs) as pool:
        if pool is None:
            for done, each in enumerate(ordered, 1):
                yield run_case(each)
                progress("cases", done, len(ordered))
            return
        for done, future in enumerate(as_completed([pool.submit(run_case, each) for each in ordered]), 1):
            yield future.result()
            progress("cases", done, len(ordered))


def _inputs(file: CaseFile, tree: Mapping[str, Any]) -> Iterable[Input]:
    """Yield what a case reads beside its own file: a project with all that it names, or single files."""
    if "inputs" in tree:
        folder = PurePosixPath(file.project_folder)
        yield from (Input(normpath(folder / each["path"]), each["sha256"]) for each in tree["inputs"])
        return
    yield from (Input(file.beside(name), _sha256(file.path.parent / name)) for name in file.names)
    if "example" in file.case.given:
        name = file.case.given["example"]
        project = EXAMPLES[name].file
        yield Input(f"{file.project_folder}/{project}", _sha256(source(name) / project))


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _compare(quantity: ComparedQuantity, tree: Mapping[str, Any]) -> QuantityResult:
    values = tuple(_value(quantity, row, expected, tree) for row, expected in quantity.values.items())
    return QuantityResult(quantity.name, quantity.unit, quantity.tolerance, values)


def _value(quantity: ComparedQuantity, row: str, expected: float, tree: Mapping[str, Any]) -> ValueResult:
    found, divisor = _find(tree, quantity.path, row), _find(tree, quantity.over, row) if quantity.over else 1.0
    scaled = None if found is None or not divisor else found / divisor * quantity.factor
    if scaled is not None and not abs(scaled) <= LARGEST_NUMBER:
        scaled = None
    misprint = quantity.misprints.get(row)
    reference = expected if misprint is None else misprint.reading
    agrees = scaled is not None and abs(scaled - reference) <= quantity.tolerance.around(reference)
    if misprint is None:
        return ValueResult(row, expected, scaled, "pass" if agrees else "fail")
    return ValueResult(row, expected, scaled, "misprint" if agrees else "fail", misprint.reading, misprint.reason)


def _find(tree: Any, path: str, row: str) -> float | None:
    """Return the finite number at the end of the path; None if there is none."""
    for step in path.split("."):
        tree = _item(tree, step.replace("{row}", row))
    return float(tree) if isinstance(tree, int | float) and math.isfinite(tree) else None


def _item(tree: Any, step: str) -> Any:
    if isinstance(tree, Mapping):
        return tree.get(step)
    if not isinstance(tree, Sequence) or isinstance(tree, str):
        return None
    named = (each for each in tree if isinstance(each, Mapping) and any(each.get(key) == step for key in NAMES))
    if step.isdecimal():
        return tree[int(step)] if int(step) < len(tree) else None
    return next(named, None)
