"""Solved cases as files: every TOML file under `cases` that has a key of a case; project files stand beside them.

They are written out again with all that they read, so that a user can run them.
"""

from __future__ import annotations

import json
import shutil
import tomllib
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any, ClassVar

from pydantic import TypeAdapter, ValidationError

from assess.errors import AssessError
from assess.examples import EXAMPLES, copy_example
from assess.outputs.manifest import stays_inside
from assess.results.verification import CASES, OF_A_CASE, USES, CaseResult, Source, Tolerance, keys_for
from assess.verification.solvers import SOLVERS

STRICT: Any = {"extra": "forbid", "strict": True, "allow_inf_nan": False}
"""How the tables of a case are read: no unknown key, no text for a number, no number that is not finite."""

LARGEST_NUMBER = 1e100
"""The largest number of a case, and one over the least that is not zero: differences and ratios stay finite."""


@dataclass(frozen=True)
class Misprint:
    """A printed value that is taken to be a misprint: its likeliest reading, and why."""

    __pydantic_config__: ClassVar = STRICT
    reading: float
    reason: str


@dataclass(frozen=True)
class ComparedQuantity:
    """What is compared: the expected values by their rows.

    path : place of the value in the tree that the solver returns, with dots; `{row}` stands for the row. Items of
        lists are found by their `name`, `id`, `procedure`, `symbol` or `record`, or by their number
    over : place of a value that the found one is divided by; none if empty
    values : expected, by row; one row named "" for a single value
    factor : what the found value is multiplied by to get the unit of the source
    misprints : by row
    """

    __pydantic_config__: ClassVar = STRICT
    name: str
    path: str
    tolerance: Tolerance
    values: dict[str, float]
    unit: str = ""
    over: str = ""
    factor: float = 1.0
    misprints: dict[str, Misprint] = field(default_factory=dict)


@dataclass(frozen=True)
class SolvedCase:
    """A solved case.

    title, theory, field, source : as in `CaseResult`
    uses : what it exercises, in the words of `assess.results.verification`
    solver : a key of `SOLVERS`
    given : what it solves; for "project" `file`, beside the case, or `example`
    quick : whether `assess verify --quick` runs it
    departures : as in `CaseResult`
    """

    __pydantic_config__: ClassVar = STRICT
    title: str
    theory: str
    field: str
    uses: tuple[str, ...]
    source: Source
    solver: str
    given: dict[str, Any]
    quantities: tuple[ComparedQuantity, ...]
    quick: bool = True
    departures: tuple[str, ...] = ()


@dataclass(frozen=True)
class CaseFile:
    """A case with its key, such as "housner_1963/free_rocking", and the path of its file."""

    key: str
    path: Path
    case: SolvedCase

    @property
    def names(self) -> tuple[str, ...]:
        """The files that it is given, relative to its own: `file`, and those of `files`."""
        one, several = self.case.given.get("file"), self.case.given.get("files", ())
        return (*(() if one is None else (str(one),)), *map(str, several))

    @property
    def paths(self) -> tuple[Path, ...]:
        """The file itself, and those that it is given."""
        return (self.path, *(self.path.parent / name for name in self.names))

    def beside(self, name: str) -> str:
        """Return the path of a file that stands beside the case, relative to the folder of cases."""
        return (PurePosixPath(self.key).parent / name).as_posix()

    @property
    def project_folder(self) -> str:
        """The folder of its project, relative to that of the cases; an example has one of its own."""
        example = self.case.given.get("example")
        return self.beside(str(PurePosixPath(self.names[0]).parent)) if example is None else f"examples/{example}"


FEWEST_WORDS = 3  # of a reason that says something


def read_cases(folder: Path = CASES) -> tuple[CaseFile, ...]:
    """Return the cases of a folder in the order of their keys.

    Raises
    ------
    AssessError : a case has an unknown key, a value of the wrong type, or says too little
    """
    return tuple(_case_files(folder))


def choose_cases(cases: Sequence[CaseFile], names: Sequence[str]) -> tuple[CaseFile, ...]:
    """Return the cases of some keys, or of the sources that stand before the slash of keys; all where none is named.

    Parameters
    ----------
    cases : all of them
    names : keys or sources

    Raises
    ------
    AssessError : there is no such case
    """
    known = {each.key: each for each in cases}
    for name in names:
        if not any(_matches(key, name) for key in known):
            near = get_close_matches(name, [*known, *{key.partition("/")[0] for key in known}], n=1)
            hint = f'did you mean "{near[0]}"?' if near else "list them with `assess verify --list`"
            raise AssessError(f'case "{name}" is not known; {hint}')
    return tuple(each for each in cases if not names or any(_matches(each.key, name) for name in names))


def cases_for(cases: Sequence[CaseFile], uses: Collection[str]) -> tuple[CaseFile, ...]:
    """Return the cases that concern a project, by the rule of `keys_for`.

    Parameters
    ----------
    cases : all of them
    uses : in the words of `assess.results.verification`
    """
    chosen = keys_for({each.key: each.case.uses for each in cases}, uses)
    return tuple(each for each in cases if each.key in chosen)


def write_cases(files: Sequence[CaseFile], results: Sequence[CaseResult], folder: Path) -> None:
    """Write the files of cases, with their projects and what these name, into a folder as they stand among the cases.

    Parameters
    ----------
    files : of the cases
    results : of the cases, which list what was read
    folder : to write into
    """
    found = {each.key: each for each in results}
    for file in (each for each in files if each.key in found):
        example = file.case.given.get("example")
        if example is not None:
            _write_example(str(example), folder / file.project_folder)
        root = file.path.parents[file.key.count("/")]
        for each in found[file.key].inputs:
            place = folder / each.path
            if not stays_inside(each.path):
                raise AssessError(f"case {file.key}: {each.path} leads out of the folder of cases; move the file there")
            if not place.exists():
                place.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(root / each.path, place)


def _matches(key: str, name: str) -> bool:
    return key == name or key.startswith(name.rstrip("/") + "/")


def _case_files(folder: Path) -> Iterator[CaseFile]:
    for path in sorted(folder.rglob("*.toml")):
        try:
            content = tomllib.loads(path.read_text(encoding="utf-8"))
        except UnicodeDecodeError:
            raise AssessError(f"{path}: not UTF-8; save it as UTF-8") from None
        except OSError as error:
            raise AssessError(f"{path}: {error.strerror or 'cannot be read'}; a case is a file") from None
        except RecursionError:
            raise AssessError(f"{path}: nested too deeply; a case has few levels") from None
        except tomllib.TOMLDecodeError as error:
            raise AssessError(f"{path}: {error}") from None
        if OF_A_CASE & content.keys():
            key = path.relative_to(folder).with_suffix("").as_posix()
            yield CaseFile(key, path, _parse_case(path, content))


def _parse_case(path: Path, content: dict[str, Any]) -> SolvedCase:
    try:
        case = _case_type().validate_json(json.dumps(content, default=str))
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        raise AssessError(f"{path}: {'.'.join(str(each) for each in first['loc'])}: {first['msg']}") from None
    if fault := next(_case_faults(case, path.parent), None):
        raise AssessError(f"{path}: {fault}")
    return case


def _case_faults(case: SolvedCase, folder: Path) -> Iterator[str]:
    """Yield what is wrong with a case beyond the types of its values."""
    for key in ("title", "theory", "field"):
        if not getattr(case, key).strip():
            yield f"{key}: empty; write a sentence"
    if any(len(each.split()) < FEWEST_WORDS for each in case.departures):
        yield "departures: say in a sentence what the source prints and what the program gives"
    if case.source.standing in ("published", "indicative") and "read" not in case.source.place.split():
        yield 'source.place: a published value was read somewhere; say where: "Table 8.2, read in the thesis"'
    for word in case.uses:
        if word not in USES:
            near = get_close_matches(word, USES, n=1)
            yield f'uses: "{word}" is not in `assess.results.verification`' + (
                f'; did you mean "{near[0]}"?' if near else ""
            )
    if not case.uses or len(set(case.uses)) < len(case.uses):
        yield "uses: give each word once, and one at least"
    if case.solver not in SOLVERS:
        yield f'solver: "{case.solver}" is not known; known: {", ".join(SOLVERS)}'
    if case.solver in ("project", "parameters") and len(case.given.keys() & {"file", "example"}) != 1:
        yield "given: a project is a `file` beside the case, or an `example`"
    yield from _given_faults(case, folder)
    names = [each.name for each in case.quantities]
    if not names or len(set(names)) < len(names):
        yield "quantities: give each name once, and one at least"
    for each in case.quantities:
        yield from (f'quantities "{each.name}": {fault}' for fault in _quantity_faults(each))


def _given_faults(case: SolvedCase, folder: Path) -> Iterator[str]:
    """Yield what is wrong with the example and the files that a case is given."""
    if (example := case.given.get("example")) is not None and example not in list(EXAMPLES):
        near = get_close_matches(str(example), EXAMPLES, n=1)
        yield f'given.example: "{example}" is not known; ' + (
            f'did you mean "{near[0]}"?' if near else f"known: {', '.join(EXAMPLES)}"
        )
    several = case.given.get("files", [])
    if not isinstance(several, list) or not all(isinstance(each, str) for each in several):
        yield f'given.files: {several} is no list of names; write files = ["wall.csv"]'
        return
    if not isinstance(case.given.get("file", ""), str):
        yield f'given.file: {case.given["file"]} is no name; write file = "wall.toml"'
        return
    for name in CaseFile("", folder, case).names:
        if "\0" in name or not (folder / name).is_file():
            yield f"given: there is no file {name} beside the case"


def _quantity_faults(quantity: ComparedQuantity) -> Iterator[str]:
    tolerance = quantity.tolerance
    if len(tolerance.reason.split()) < FEWEST_WORDS:
        yield "tolerance.reason: say in a sentence why the values may differ so much"
    if min(tolerance.absolute, tolerance.relative) < 0.0:
        yield "tolerance: negative"
    if not quantity.values:
        yield "values: none"
    readings = (each.reading for each in quantity.misprints.values())
    for number in (*quantity.values.values(), *readings, quantity.factor, tolerance.absolute, tolerance.relative):
        if number and not 1.0 / LARGEST_NUMBER <= abs(number) <= LARGEST_NUMBER:
            yield f"{number:g} is too large or too small; take a unit in which it is between 1e-100 and 1e100"
    if len(quantity.values) > 1 and "{row}" not in quantity.path:
        yield "path: several rows need {row} in it"
    for row, misprint in quantity.misprints.items():
        if row not in quantity.values:
            yield f'misprints: "{row}" is none of its values'
        if len(misprint.reason.split()) < FEWEST_WORDS:
            yield f'misprints."{row}".reason: say in a sentence why it is taken to be a misprint'


@cache
def _case_type() -> TypeAdapter[SolvedCase]:
    return TypeAdapter(SolvedCase)


def _write_example(name: str, folder: Path) -> None:
    if not folder.exists():
        copy_example(name, folder)
