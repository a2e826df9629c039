"""Results to and from results.json: the fields of `assess.results` by name, in order, at full precision.

The same results give the same bytes. What is written has been read back through the types first, so a file that
was written can be read.
"""

from __future__ import annotations

import json
import math
import stat
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

from pydantic import TypeAdapter, ValidationError

from assess.errors import ResultsError
from assess.results import (
    SCHEMA_VERSION,
    GroundMotionResult,
    MechanismResult,
    RecordResult,
    Results,
    SpectrumResult,
)
from assess.results.shape import faults

NAMES = ("results.json", "envelopes.json")
"""Files of results, as `assess run` and `assess envelope` write them."""

LARGEST = 500_000_000
"""Bytes of a file of results; one of eight mechanisms and seven records has some three million."""

_REMEDY = "give a results.json that `assess run` wrote"


def dumps(results: Results) -> str:
    """The text of results.json: one line for each field of `results`, in their order.

    Raises ValueError where a number is not finite or a value has not the type of its field: results hold neither.
    """
    plain = _normal(results, _results_type())
    return "{\n" + ",\n".join(_json({key: value})[1:-1] for key, value in plain.items()) + "\n}\n"


def dumps_mechanisms(mechanisms: tuple[MechanismResult, ...]) -> str:
    """The `mechanisms` of results.json alone."""
    return _json(_normal(mechanisms, _mechanisms_type())) + "\n"


def dumps_spectrum(spectrum: SpectrumResult) -> str:
    """The `spectrum` of results.json alone."""
    return _json(_normal(spectrum, _spectrum_type())) + "\n"


def dumps_suite(records: tuple[RecordResult, ...], motion: GroundMotionResult) -> str:
    """The `records` and the `ground_motion` of results.json alone."""
    return (
        _json({"records": _normal(records, _records_type()), "ground_motion": _normal(motion, _motion_type())}) + "\n"
    )


def dumps_envelopes(results: Results) -> str:
    """The envelopes of results.json alone: `mechanisms`, each with name, label and envelope, and `critical`."""
    plain = _normal(results, _results_type())
    kept = [{key: each[key] for key in ("name", "label", "envelope")} for each in plain["mechanisms"]]
    return _json({"mechanisms": kept, "critical": plain["critical"]}) + "\n"


def loads(text: str, *, source: str = "results") -> Results:
    """Results from the text of results.json. Raises ResultsError that names the `source` and the first thing wrong."""
    found = _at_once(text) or _step_by_step(text, source)
    if wrong := next(faults(found), None):
        raise ResultsError(f"{source}: {wrong}; {_REMEDY}")
    return found


def _at_once(text: str) -> Results | None:
    """The results, in a third of the time; None where something may be wrong, to be told by going step by step."""
    if "NaN" in text or "Infinity" in text:  # in words, or as numbers, which are not JSON but would be read
        return None
    try:
        found = _results_type().validate_json(text)
    except ValidationError:
        return None
    return found if found.schema_version == SCHEMA_VERSION else None


def _step_by_step(text: str, source: str) -> Results:
    data = _parse(text, source)
    version = data.get("schema_version") if isinstance(data, dict) else None
    if version is None:
        raise ResultsError(f"{source}: not a results file of assess (no schema_version); {_REMEDY}")
    if version != SCHEMA_VERSION:
        found = json.dumps(version)[:40]
        raise ResultsError(
            f"{source}: schema_version: {found}: this program reads {SCHEMA_VERSION}; run the project again"
        )
    try:
        return _results_type().validate_python(data)
    except RecursionError:
        raise ResultsError(f"{source}: nested too deeply; {_REMEDY}") from None
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        where = ".".join(str(step) for step in first["loc"])
        raise ResultsError(f"{source}: {where}: {first['msg'][:1].lower()}{first['msg'][1:]}; {_REMEDY}") from None


def read(path: Path) -> Results:
    """Results from the file `path`. Raises ResultsError for a file that is missing, is none, or cannot be so large."""
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise ResultsError(f"{path}: {'is a directory' if path.is_dir() else 'not a regular file'}; {_REMEDY}")
        if status.st_size > LARGEST:
            size = f"{status.st_size / 1e6:.0f} MB are more than the {LARGEST / 1e6:.0f} MB"
            raise ResultsError(f"{path}: {size} that results may have; {_REMEDY}")
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ResultsError(f"{path}: not a text file; {_REMEDY}") from None
    except OSError as error:
        raise ResultsError(f"{path}: {error.strerror or 'cannot be read'}; {_REMEDY}") from None
    return loads(text, source=str(path))


def find_results(path: Path) -> Path:
    """The results file that `path` names: itself, or that of the folder, or of the one NAME-results below a project's.

    Raises ResultsError where there is none, or more than one.
    """
    if not path.is_dir():
        return path
    here = [file for name in NAMES if (file := path / name).is_file()]
    below = sorted(path.glob(f"*-results/{NAMES[0]}"))
    if here or len(below) == 1:
        return (here or below)[0]
    found = "none of " + " or ".join(NAMES) if not below else f"{len(below)} folders of results"
    raise ResultsError(f"{path}: a folder with {found}; {_REMEDY}")


@cache
def _results_type() -> TypeAdapter[Results]:
    return TypeAdapter(Results)


@cache
def _mechanisms_type() -> TypeAdapter[tuple[MechanismResult, ...]]:
    return TypeAdapter(tuple[MechanismResult, ...])


@cache
def _spectrum_type() -> TypeAdapter[SpectrumResult]:
    return TypeAdapter(SpectrumResult)


@cache
def _records_type() -> TypeAdapter[tuple[RecordResult, ...]]:
    return TypeAdapter(tuple[RecordResult, ...])


@cache
def _motion_type() -> TypeAdapter[GroundMotionResult]:
    return TypeAdapter(GroundMotionResult)


def _normal(value: Any, adapter: TypeAdapter[Any]) -> Any:
    """`value` as dicts and tuples, each number of the type its field has."""
    return adapter.dump_python(adapter.validate_python(adapter.dump_python(value, warnings=False)))


def _json(value: Any) -> str:
    try:
        return json.dumps(value, ensure_ascii=False, allow_nan=False)
    except ValueError:
        where, number = next(_infinite("", value))
        raise ValueError(f"{where} is {number}; results hold finite numbers only") from None


def _infinite(where: str, value: Any) -> Iterator[tuple[str, float]]:
    """Where the numbers are that are not finite."""
    if isinstance(value, float) and not math.isfinite(value):
        yield where or "a value", value
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from _infinite(f"{where}.{key}".lstrip("."), item)
    elif isinstance(value, list | tuple):
        for index, item in enumerate(value):
            yield from _infinite(f"{where}[{index}]", item)


def _parse(text: str, source: str) -> Any:
    def refuse(constant: str) -> NoReturn:
        raise ResultsError(f"{source}: holds {constant}, which is not JSON; {_REMEDY}")

    try:
        return json.loads(text, parse_constant=refuse)
    except json.JSONDecodeError as error:
        raise ResultsError(f"{source}: line {error.lineno}: not JSON ({error.msg.lower()}); {_REMEDY}") from None
    except ResultsError:
        raise
    except ValueError as error:  # a number of thousands of digits
        raise ResultsError(f"{source}: {str(error).partition(';')[0].lower()}; {_REMEDY}") from None
    except RecursionError:
        raise ResultsError(f"{source}: nested too deeply; {_REMEDY}") from None
