"""The tables of `records.lock.toml`: the records of a suite with their factors, and what they were locked for.

The file is written by `assess records select --lock` alone. Its seal, the SHA-256 of all that follows it, tells
whether it was changed since.
"""

from __future__ import annotations

import hashlib
import json
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, StrictBool, StrictInt, StrictStr, ValidationError

from assess.errors import ProjectError
from assess.project.file_digests import file_sha256
from assess.project.key_text import error_line, escape_text
from assess.project.section import Section
from records.compliance.making import CodeName

NAME = "records.lock.toml"
AGAIN = "run `assess records select PROJECT --lock` again"
HEAD = f"""\
# The suite of records of a project, locked: its files, their factors, and the target that these hold for.
# Written by `assess records select --lock`, which replaces it; [records] lock = "{NAME}" uses it.
"""
_SEAL = re.compile(r'(.*?)^seal = "([0-9a-f]*)"\n(.*)', re.DOTALL | re.MULTILINE)

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[Number, Field(gt=0)]
NotNegative = Annotated[Number, Field(ge=0)]
Sha256 = Annotated[StrictStr, Field(pattern="^[0-9a-f]{64}$")]
FilePath = Annotated[StrictStr, Field(min_length=1, pattern="^[^\\x00]*$")]


class LockedTarget(Section):
    """The target spectrum that the factors refer to."""

    code: StrictStr
    """code of the spectrum"""
    pga_g: Positive
    """peak ground acceleration [g]"""
    sha256: Sha256
    """of the 5 % ordinates over the peak ground acceleration"""


class LockedChoice(Section):
    """How the records were chosen and scaled."""

    how: Literal["selected", "all"]
    """"selected" out of many, or "all" that the project names"""
    scale_to: Literal["spectrum", "pga", "none"]
    """what each record is scaled to"""
    further_factor: Positive = 1.0
    """factor on every record, included in the scale factors"""
    periods_s: tuple[Positive, Positive]
    """range over which the records are compared with the target"""
    weights: tuple[tuple[Positive, NotNegative], ...] = ()
    """of periods, if they are not equal"""
    code: CodeName | None = Field(default=None, alias="for")
    """code whose rules the suite was made to meet"""
    fit: Literal["suite", "each"] | None = None
    """what fits best: the mean of the "suite", or "each" record"""
    components: Literal["single", "together"] | None = None
    """each component a "single" record, or those of a recording "together"; as in [records.select]"""
    one_per_event: StrictBool | None = None
    """whether no two are of one earthquake"""
    scale_limits: tuple[NotNegative, Positive] | None = None
    """least and largest scale factor"""
    misfit: NotNegative | None = None
    """of the mean spectrum to the target"""
    greedy_misfit: NotNegative | None = None
    """the same before records were exchanged"""
    remaining: tuple[tuple[StrictStr, StrictInt], ...] = ()
    """candidates left after each step"""


class LockedArtificial(Section):
    """The recipe of artificial records, which are made again and compared."""

    count: Annotated[StrictInt, Field(ge=1, le=1000)]
    """how many"""
    seed: Annotated[StrictInt, Field(ge=0)]
    """of the random numbers"""
    duration_s: Annotated[Positive, Field(le=600)]
    """length of each"""
    periods_s: tuple[Positive, Positive]
    """range that is fitted to the target"""
    scale_factor: Positive
    """on all of them"""
    sha256: tuple[Sha256, ...]
    """of the samples of each, rounded to 1e-4 m/s2"""


class LockedRecord(Section):
    """A record of a file."""

    id: StrictStr
    """name in the results"""
    file: FilePath
    """relative to the folder of the lock"""
    position: Annotated[StrictInt, Field(ge=1)]
    """place of the component in its file, from 1"""
    component: StrictStr
    """as the file says"""
    sha256: Sha256
    """of the file"""
    scale_factor: Positive
    """that brings it to the target"""
    event: StrictStr = ""
    """earthquake"""
    date: StrictStr = ""
    """of the earthquake"""
    station: StrictStr = ""
    """of the instrument"""
    magnitude: Number | None = None
    """of the earthquake"""
    distance_m: Number | None = None
    """from the source"""
    vs30_m_per_s: Number | None = None
    """of the ground"""
    nga: StrictInt | None = None
    """number in the PEER NGA database"""
    unit: StrictStr | None = None
    """of acceleration, given for a file that states none"""
    step_s: Positive | None = None
    """given for a file that states none"""
    response: FilePath | None = None
    """StationXML of the instrument, relative to the folder of the lock"""
    response_sha256: Sha256 | None = None
    """of that file"""


class SuiteLock(Section):
    """All that a lock says."""

    format: Literal[1]
    """version of this format"""
    seal: StrictStr
    """SHA-256 of all that follows"""
    target: LockedTarget
    """a table [target]"""
    chosen: LockedChoice
    """a table [chosen]"""
    artificial: LockedArtificial | None = None
    """a table [artificial]"""
    records: tuple[LockedRecord, ...] = ()
    """a table [[records]] for each record of a file"""


def read_lock(path: Path) -> tuple[SuiteLock, bool]:
    """Return a lock, and whether it is as it was written.

    Raises
    ------
    ProjectError : there is no such file, or it is no lock
    """
    try:
        return _lock(path, file_sha256(path))
    except FileNotFoundError:
        raise ProjectError(f"{path}: no such file; make it: run `assess records select PROJECT --lock`") from None
    except OSError as error:
        raise ProjectError(f"{path}: cannot be read ({error.strerror}); {AGAIN}") from None


@lru_cache(maxsize=64)
def _lock(path: Path, sha256: str) -> tuple[SuiteLock, bool]:
    """Read the lock whose file has this SHA-256."""
    try:
        text = path.read_bytes().decode("utf-8")
        raw = tomllib.loads(text)
        return SuiteLock.model_validate(raw), is_sealed(text)
    except ValidationError as error:
        raise ProjectError(f"{path}: {error_line(error, raw=raw)}; {AGAIN}") from None
    except (ValueError, RecursionError) as error:
        raise ProjectError(
            f"{path}: no suite lock, for it is not valid TOML: {escape_text(str(error))}; {AGAIN}"
        ) from None


def is_sealed(text: str) -> bool:
    """Return whether a text is that of a lock as it was written."""
    found = _SEAL.fullmatch(text)
    return found is not None and found[1] == HEAD + "format = 1\n" and found[2] == _sha256(found[3])


def is_replaceable(path: Path) -> bool:
    """Return whether a file is a lock that nobody has changed since it was written."""
    try:
        return is_sealed(path.read_bytes().decode("utf-8"))
    except (OSError, UnicodeDecodeError):
        return False


def lock_text(
    target: LockedTarget,
    chosen: LockedChoice,
    *,
    artificial: LockedArtificial | None,
    records: Sequence[LockedRecord],
) -> str:
    """Return the text of a lock, with its seal."""
    single = {"target": target, "chosen": chosen, "artificial": artificial}
    tables: list[tuple[str, Section]] = [
        ("[" + name + "]", table) for name, table in single.items() if table is not None
    ]
    tables += [("[[records]]", record) for record in records]
    body = "".join("\n".join(("", head, *_lines(table), "")) for head, table in tables)
    return f'{HEAD}format = 1\nseal = "{_sha256(body)}"\n{body}'


def _sha256(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _lines(table: Section) -> Iterator[str]:
    """Yield the keys of a table that are not at their default."""
    defaults: Mapping[str, Any] = {key: field.default for key, field in table.table_keys().items()}
    for key, value in table.entries().items():
        if value != defaults[key]:
            yield f"{key} = {_value(value)}"


def _value(value: Any) -> str:
    """Return a value as TOML: a list of lists on lines of their own, numbers at full precision."""
    if isinstance(value, tuple):
        parts = [_value(each) for each in value]
        nested = any(isinstance(each, tuple) for each in value) or len(", ".join(parts)) > 100
        return "[\n" + "".join(f"    {part},\n" for part in parts) + "]" if nested else f"[{', '.join(parts)}]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return str(value).lower() if isinstance(value, bool) else repr(value)
