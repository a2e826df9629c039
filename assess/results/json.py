"""Results to and from their text and their files: the fields of `assess.results` by name, in order, at full precision.

The same results give the same bytes. Results are validated by their types before they are written, so that a file that
was written can be read. What is read is completed where a run was interrupted, marked where it was changed since, and
checked beyond its types: finite numbers, columns of equal length, indices and names that exist; a file that was edited
could otherwise be drawn or summed wrongly.
"""

from __future__ import annotations

import json
import math
import re
import stat
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import cache
from hashlib import sha256
from itertools import chain
from math import isfinite
from pathlib import Path
from typing import Any, Generic, NoReturn, TypeVar

from pydantic import TypeAdapter, ValidationError

from assess import results as r
from assess.codes.check import PgaCurve
from assess.errors import AssessError, ResultsError
from assess.messages.message import Message, warning
from assess.outputs.manifest import ENVELOPES, FRAGILITY, RESULTS, is_changed
from assess.outputs.writing import recover_for_reading
from assess.results import SCHEMA_VERSION, GroundMotionResult, MechanismResult, RecordResult, Results, SpectrumResult
from assess.results.fragility import FRAGILITY_VERSION, CurveBand, FragilityResults, HazardResult, RecordRunsResult
from assess.results.verification import VERIFICATION_VERSION, VerificationResults

NAMES = (RESULTS, ENVELOPES)
"""Files of results, as `assess run` and `assess envelope` write them."""
LARGEST = 500_000_000
"""Bytes of a file of results; one of eight mechanisms and seven records has some three million."""
REMEDY = "give a results.json that `assess run` wrote"
AGAIN = "run the project again"
VERIFY_AGAIN = "run `assess verify` again"
T = TypeVar("T")
_adapter: Callable[[Any], TypeAdapter[Any]] = cache(TypeAdapter)
"""What validates values of a type, made once in a process, which takes a while."""
_NOT_FINITE = re.compile(r"(?<![A-Za-z0-9+/])[+-]?(?:NaN|Infinity)")  # letters within a picture in base64 are none


@dataclass(frozen=True)
class FoundResults:
    """Results read from a file.

    results : as read, with a warning where they were changed since they were written
    path : the file
    as_written : whether the folder's manifest shows them to be as they were written
    """

    results: Results
    path: Path
    as_written: bool

    @contextmanager
    def blame_changes(self) -> Iterator[None]:
        """Attribute errors in the block to the results, unless they are as the program wrote them."""
        try:
            yield
        except (AssessError, OSError):
            raise
        except Exception as error:
            if self.as_written:
                raise
            what = f"{type(error).__name__}: {error}"
            raise ResultsError(
                f"{self.path}: its parts do not fit together ({what[:200]}); run the project again"
            ) from error


def open_results(path: Path, *, tell: Callable[[Message], None]) -> FoundResults:
    """Read the results that a file or folder names, after completing what an interrupted command left there.

    Parameters
    ----------
    path : results.json, or a folder that contains it
    tell : called with each message on interrupted or changed files
    """
    for folder in (path, *sorted(path.glob("*-results"))) if path.is_dir() else (path.parent,):
        recover_for_reading(folder, tell=tell)
    file = _find_results(path)
    results, differs = read(file), is_changed(file)
    if differs:
        found = warning("results-changed", str(file))
        tell(found)
        results = replace(results, warnings=(replace(found, where=file.name), *results.warnings))
    return FoundResults(results, file, as_written=differs is False)


def open_fragility(path: Path, *, tell: Callable[[Message], None]) -> FragilityResults:
    """Read the results of `assess fragility`, as `open_results` does those of `assess run`.

    Parameters
    ----------
    path : fragility.json
    tell : called with each message on interrupted or changed files
    """
    recover_for_reading(path.parent, tell=tell)
    results = _read_fragility(path)
    if not is_changed(path):
        return results
    found = warning("results-changed", str(path))
    tell(found)
    return replace(results, warnings=(replace(found, where=path.name), *results.warnings))


def read(path: Path) -> Results:
    """Read results from a file; raise ResultsError for a file that is missing, not regular, or too large."""
    return loads(_text(path), source=str(path))


def read_verification(path: Path) -> VerificationResults:
    """Read the results of `assess verify`, as `read` does those of `assess run`."""
    return _loads_verification(_text(path, VERIFY_AGAIN), source=str(path))


def dumps(results: Results) -> str:
    """Return the text of results.json: one line for each field of `results`, in their order.

    Raises ValueError for a number that is not finite or a value that is not of the type of its field.
    """
    return _lines(_normal(results, Results))


def dumps_fragility(results: FragilityResults) -> str:
    """Return the text of fragility.json, as `dumps` does that of results.json."""
    return _lines(_normal(results, FragilityResults))


def dumps_verification(results: VerificationResults) -> str:
    """Return the text of verification.json with its seal, as `dumps` does that of results.json."""
    plain = _normal(replace(results, seal=""), VerificationResults)
    return _lines({**plain, "seal": sha256(_lines(plain).encode()).hexdigest()})


def dumps_mechanisms(mechanisms: tuple[MechanismResult, ...]) -> str:
    """Return the `mechanisms` of results.json alone."""
    return _json(_normal(mechanisms, tuple[MechanismResult, ...])) + "\n"


def dumps_spectrum(spectrum: SpectrumResult) -> str:
    """Return the `spectrum` of results.json alone."""
    return _json(_normal(spectrum, SpectrumResult)) + "\n"


def dumps_suite(records: tuple[RecordResult, ...], motion: GroundMotionResult) -> str:
    """Return the `records` and the `ground_motion` of results.json alone.

    Parameters
    ----------
    records : the records of the suite
    motion : the suite compared with its target

    Returns
    -------
    JSON, ending with a line break.
    """
    plain = {
        "records": _normal(records, tuple[RecordResult, ...]),
        "ground_motion": _normal(motion, GroundMotionResult),
    }
    return _json(plain) + "\n"


def dumps_envelopes(results: Results) -> str:
    """Return the envelopes of results.json alone: `mechanisms`, each with name, label and envelope, and `critical`."""
    plain = _normal(results, Results)
    kept = [{key: each[key] for key in ("name", "label", "envelope")} for each in plain["mechanisms"]]
    return _json({"mechanisms": kept, "critical": plain["critical"]}) + "\n"


def loads(text: str, *, source: str = "results") -> Results:
    """Return results from the text of results.json; raise ResultsError, which names `source` and the first fault."""
    return _loads(text, source, RESULTS_TREE)


def loads_fragility(text: str, *, source: str = "results") -> FragilityResults:
    """Return results from the text of fragility.json, as `loads` does from that of results.json.

    Parameters
    ----------
    text : of the file
    source : its name, for errors
    """
    return _loads(text, source, FRAGILITY_TREE)


@dataclass(frozen=True)
class Tree(Generic[T]):
    """A tree of results: its type, its version, and what to do about a file that holds none, or another version."""

    kind: type[T]
    version: int
    remedy: str
    again: str


_FREE = {int, bool, str, type(None)}  # of faults
_SCALARS = {float, *_FREE}
Groups = tuple[tuple[str, ...], ...]
OF_ONE_LENGTH: Mapping[type, Groups] = {
    PgaCurve: (("rotation_ratio", "pga_g"),),
    r.SpectrumResult: (("period_s", "acceleration_g"),),
    r.RecordSpectrum: (("period_s", "acceleration_g"),),
    r.GroundMotionResult: (("period_s", "target_g", "mean_g", "geometric_mean_g"),),
    r.DisplacedDrawing: (("blocks", "block_of"),),
    r.Drawing: (("blocks", "block_of"),),
    r.View: (("triangles", "block_of"),),
    r.BranchCurve: (tuple(field.name for field in fields(r.BranchCurve)),),
    r.CarriedMotion: (
        ("time_s", "ground_acceleration_g", "base_acceleration_g"),
        ("period_s", "ground_spectrum_g", "base_spectrum_g"),
    ),
    r.HistoryTrace: (("time_s", "rotation_rad", "ground_acceleration_g", "base_acceleration_g"),),
    r.DirectionSweep: (("angle_deg", "uplift_multiplier", "p_eq_per_s", "overturning_rad"),),
    r.BranchMoment: (("rotation_rad", "restoring_n_m"),),
    r.EnvelopeResult: (
        ("frequency_hz", "overturned", "lower_bound_g", "polarity", "islands", "uplift_g", "factor", "omega",
         "lower_bound_ratio"),
    ),
    r.CriticalResult: (("frequency_hz", "mechanism", "lower_bound_g", "runner_up", "margin", "near"),),
    r.SweepResult: (
        ("value", "p_eq_per_s", "uplift_multiplier", "overturning_rad", "overturning_flexible_rad",
         "elastic_frequency_hz", "restitution", "demand_capacity", "overturned", "capacity_pga_g", "outcome"),
    ),
    RecordRunsResult: (("scale", "ratio"),),
    CurveBand: (("intensity", "low", "high"),),
    HazardResult: (("intensity", "annual_rate"),),
}  # fmt: skip
"""Fields of each type that are columns of one table; a field that is None is ignored."""


def faults(value: Any, where: str = "") -> Iterator[str]:
    """Yield what is wrong with results or a part of them, with its place, one by one."""
    if isinstance(value, float):
        if not isfinite(value):
            yield f"{where}: {value} is not a finite number"
    elif is_dataclass(value):
        yield from _field_faults(value, where)
    elif isinstance(value, Mapping):
        for key, each in value.items():
            yield from faults(each, f"{where}.{key}".lstrip("."))
    elif isinstance(value, tuple | list):
        yield from _item_faults(value, where)


def _read_fragility(path: Path) -> FragilityResults:
    """Read the results of `assess fragility`, as `read` does those of `assess run`."""
    return loads_fragility(_text(path), source=str(path))


def _text(path: Path, remedy: str = REMEDY) -> str:
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise ResultsError(f"{path}: {'is a directory' if path.is_dir() else 'not a regular file'}; {remedy}")
        if status.st_size > LARGEST:
            size = f"{status.st_size / 1e6:.0f} MB are more than the {LARGEST / 1e6:.0f} MB"
            raise ResultsError(f"{path}: {size} that results may have; {remedy}")
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ResultsError(f"{path}: not a text file; {remedy}") from None
    except OSError as error:
        raise ResultsError(f"{path}: {error.strerror or 'cannot be read'}; {remedy}") from None


def _find_results(path: Path) -> Path:
    """Find the results file that `path` names: itself, or the one in the folder, or in its only NAME-results folder.

    Raises ResultsError if there is none, or more than one, or if it is that of `assess fragility`.
    """
    if path.name == FRAGILITY:
        raise ResultsError(
            f"{path}: of `assess fragility`, whose curves are not compared; compare its tables, or two results.json"
        )
    if not path.is_dir():
        return path
    here = [file for name in NAMES if (file := path / name).is_file()]
    below = sorted(path.glob(f"*-results/{NAMES[0]}"))
    if here or len(below) == 1:
        return (here or below)[0]
    found = "none of " + " or ".join(NAMES) if not below else f"{len(below)} folders of results"
    raise ResultsError(f"{path}: a folder with {found}; {REMEDY}")


def _loads_verification(text: str, *, source: str = "results") -> VerificationResults:
    """Return results from the text of verification.json, as `loads` does from that of results.json.

    Parameters
    ----------
    text : of the file
    source : its name, for errors

    Raises
    ------
    ResultsError : as there, or the text is not what `dumps_verification` wrote
    """
    found = _loads(text, source, VERIFICATION_TREE)
    if dumps_verification(found) != text:
        raise ResultsError(f"{source}: was changed since it was written: its seal does not fit; {VERIFY_AGAIN}")
    return found


RESULTS_TREE = Tree(Results, SCHEMA_VERSION, REMEDY, AGAIN)
VERIFICATION_TREE = Tree(VerificationResults, VERIFICATION_VERSION, VERIFY_AGAIN, VERIFY_AGAIN)
FRAGILITY_TREE = Tree(FragilityResults, FRAGILITY_VERSION, "give a fragility.json that `assess fragility` wrote", AGAIN)


def _loads(text: str, source: str, tree: Tree[T]) -> T:
    found = _validate_at_once(text, tree) or _validate_step_by_step(text, source, tree)
    if wrong := next(faults(found), None):
        raise ResultsError(f"{source}: {wrong}; {tree.remedy}")
    return found


def _validate_at_once(text: str, tree: Tree[T]) -> T | None:
    """Return the results in a third of the time; None if something may be wrong, which going step by step finds."""
    if ("NaN" in text or "Infinity" in text) and _NOT_FINITE.search(text):  # words, or numbers that are not JSON
        return None
    try:
        found: T = _adapter(tree.kind).validate_json(text)
    except ValidationError:
        return None
    return found if getattr(found, "schema_version", None) == tree.version else None


def _validate_step_by_step(text: str, source: str, tree: Tree[T]) -> T:
    data = _parse(text, source, tree.remedy)
    version = data.get("schema_version") if isinstance(data, dict) else None
    if version is None:
        raise ResultsError(f"{source}: not a results file of assess (no schema_version); {tree.remedy}")
    if version != tree.version:
        written = json.dumps(version)[:40]
        raise ResultsError(f"{source}: schema_version: {written}: this program reads {tree.version}; {tree.again}")
    try:
        found: T = _adapter(tree.kind).validate_python(data)
        return found
    except RecursionError:
        raise ResultsError(f"{source}: nested too deeply; {tree.remedy}") from None
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        where = ".".join(str(step) for step in first["loc"])
        raise ResultsError(f"{source}: {where}: {first['msg'][:1].lower()}{first['msg'][1:]}; {tree.remedy}") from None


def _normal(value: Any, kind: Any) -> Any:
    """Return `value` as dicts and tuples, each number of the type of its field."""
    adapter = _adapter(kind)
    return adapter.dump_python(adapter.validate_python(adapter.dump_python(value, warnings=False)))


def _lines(plain: Mapping[str, Any]) -> str:
    return "{\n" + ",\n".join(_json({key: value})[1:-1] for key, value in plain.items()) + "\n}\n"


def _json(value: Any) -> str:
    try:
        return json.dumps(value, ensure_ascii=False, allow_nan=False)
    except ValueError:
        where, number = next(_non_finite("", value))
        raise ValueError(f"{where} is {number}; results hold finite numbers only") from None


def _non_finite(where: str, value: Any) -> Iterator[tuple[str, float]]:
    """Yield the numbers that are not finite, with their places."""
    if isinstance(value, float) and not math.isfinite(value):
        yield where or "a value", value
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from _non_finite(f"{where}.{key}".lstrip("."), item)
    elif isinstance(value, list | tuple):
        for index, item in enumerate(value):
            yield from _non_finite(f"{where}[{index}]", item)


def _parse(text: str, source: str, remedy: str = REMEDY) -> Any:
    def refuse(constant: str) -> NoReturn:
        raise ResultsError(f"{source}: holds {constant}, which is not JSON; {remedy}")

    try:
        return json.loads(text, parse_constant=refuse)
    except json.JSONDecodeError as error:
        raise ResultsError(f"{source}: line {error.lineno}: not JSON ({error.msg.lower()}); {remedy}") from None
    except ResultsError:
        raise
    except ValueError as error:  # a number of thousands of digits
        raise ResultsError(f"{source}: {str(error).partition(';')[0].lower()}; {remedy}") from None
    except RecursionError:
        raise ResultsError(f"{source}: nested too deeply; {remedy}") from None


def _field_faults(value: Any, where: str) -> Iterator[str]:
    for names in OF_ONE_LENGTH.get(type(value), ()):
        lengths = {name: len(column) for name in names if (column := getattr(value, name)) is not None}
        if len(set(lengths.values())) > 1:
            counted = ", ".join(f"{number} of {name}" for name, number in lengths.items())
            yield f"{where}: columns of unequal length: {counted}"
    if type(value) in _WITH_INDICES:
        yield from _index_faults(value, where)
    kind: Any = type(value)
    for name in _field_names(kind):
        each = getattr(value, name)
        if type(each) not in _FREE:
            yield from faults(each, f"{where}.{name}".lstrip("."))


@cache
def _field_names(kind: Any) -> tuple[str, ...]:
    return tuple(field.name for field in fields(kind))


_WITH_INDICES = (r.View, r.EnvelopeResult, r.Results, r.SweepResult)


def _item_faults(items: tuple[Any, ...] | list[Any], where: str) -> Iterator[str]:
    if _all_finite(items) or (set(map(type, items)) <= {tuple, list} and _all_finite([*chain.from_iterable(items)])):
        return  # most of them, checked at once
    for place, each in enumerate(items):
        yield from faults(each, f"{where}[{place}]")


def _all_finite(items: Sequence[Any]) -> bool:
    """Return whether all items are plain values, those that are numbers finite."""
    kinds = set(map(type, items))
    if kinds == {float}:
        return all(map(isfinite, items))
    return kinds <= _SCALARS and all(isfinite(each) for each in items if type(each) is float)


def _index_faults(value: Any, where: str) -> Iterator[str]:
    """Yield indices that are out of range."""
    if isinstance(value, r.View):
        corners = [*chain.from_iterable(value.triangles)]
        if corners and not 0 <= min(corners) <= max(corners) < len(value.vertices):
            yield f"{where}.triangles: a corner that is none of the vertices"
    elif isinstance(value, r.EnvelopeResult):
        if any(len(row) != len(value.amplitude_g) for row in value.overturned):
            yield f"{where}.overturned: a row that has not one value for each amplitude_g"
    elif isinstance(value, r.Results):
        yield from _name_faults(value)
    elif isinstance(value, r.SweepResult) and not 0 <= value.controlling < len(value.value):
        yield f"{where}.controlling: {value.controlling} is none of the {len(value.value)} cases"


def _name_faults(results: r.Results) -> Iterator[str]:
    """Yield names of mechanisms that are repeated, and names elsewhere that are not among them."""
    names = [*(each.name for each in results.mechanisms), *(each.name for each in results.falling)]
    for place, name in enumerate(names):
        if name in names[:place]:
            yield f"mechanisms[{place}].name: {json.dumps(name)} a second time"
    used_in = {
        "comparison": [row.mechanism for row in results.comparison],
        "verdict.mechanisms": [] if results.verdict is None else [row.mechanism for row in results.verdict.mechanisms],
        "sweeps": [row.mechanism for row in results.sweeps],
        "sensitivity": [row.mechanism for row in results.sensitivity],
        "report.checklist": [name for item in results.report.checklist for name in item.mechanisms],
        "controls": [row.mechanism for row in results.controls],
        "uncertainty.answers": []
        if results.uncertainty is None
        else [row.mechanism for row in results.uncertainty.answers],
    }
    for where, used in used_in.items():
        for place, name in enumerate(used):
            if name not in names:
                yield f"{where}[{place}].mechanism: {json.dumps(name)} is none of the mechanisms"
