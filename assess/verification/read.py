"""The files of cases: every TOML file under `cases` that has the table of a case, `source`."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from assess.errors import AssessError
from assess.verification.case import Case, CaseFile

CASES = Path(__file__).parent / "cases"


def read_cases(folder: Path = CASES) -> tuple[CaseFile, ...]:
    """Return the cases of a folder in the order of their keys; project files that stand beside them are none.

    Raises
    ------
    AssessError : a case has an unknown key, or a value of the wrong type
    """
    files = sorted(folder.rglob("*.toml"))
    found = ((path, tomllib.loads(path.read_text(encoding="utf-8"))) for path in files)
    return tuple(
        CaseFile(path.relative_to(folder).with_suffix("").as_posix(), path, _case(path, content))
        for path, content in found
        if "source" in content and "solver" in content
    )


def _case(path: Path, content: dict[str, object]) -> Case:
    try:
        return _case_type().validate_python(content)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        raise AssessError(f"{path}: {'.'.join(str(each) for each in first['loc'])}: {first['msg']}") from None


@cache
def _case_type() -> TypeAdapter[Case]:
    return TypeAdapter(Case)
