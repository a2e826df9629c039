"""The lock of a suite, `records.lock.toml`: its records with their factors, and the target that these hold for.

A lock of a table holds a suite for each target of its rows. The file is written by `assess records select --lock`
alone. Its seal, the SHA-256 of all that follows it, tells whether it was changed since.
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

import numpy as np
from pydantic import Field, StrictBool, StrictInt, StrictStr, ValidationError

from assess.errors import OutputError, ProjectError
from assess.messages.message import escape_text
from assess.outputs.writing import replace_file
from assess.project.keys import error_line
from assess.project.section import ProjectSection
from assess.results.provenance import file_sha256
from assess.study.study import Fitting, ScaledRecord
from records.candidates import Candidate
from records.compliance import CodeName
from records.formats.header import NO_OVERRIDES, HeaderOverrides
from records.reading import read_with_overrides, relative_path
from records.record import Record
from records.selection import ScaleTo, samples_sha256, target_mark
from records.synthetic import ArtificialRecords, seed_of_target
from spectra.gravity import g
from spectra.spectrum import Spectrum

LOCK_NAME = "records.lock.toml"
AGAIN = "run `assess records select PROJECT --lock` again"

HEAD = f"""\
# The suite of records of a project, locked: its files, their factors, and the target that these hold for.
# Written by `assess records select --lock`, which replaces it; [records] lock = "{LOCK_NAME}" uses it.
"""
_SEAL = re.compile(r'(.*?)^seal = "([0-9a-f]*)"\n(.*)', re.DOTALL | re.MULTILINE)
Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[Number, Field(gt=0)]
NotNegative = Annotated[Number, Field(ge=0)]
Sha256 = Annotated[StrictStr, Field(pattern="^[0-9a-f]{64}$")]
FilePath = Annotated[StrictStr, Field(min_length=1, pattern="^[^\\x00]*$")]


class LockedTarget(ProjectSection):
    """The target spectrum that the factors refer to."""

    code: StrictStr
    """code of the spectrum"""
    pga_g: Positive
    """peak ground acceleration [g]"""
    sha256: Sha256
    """of the 5 % ordinates over the peak ground acceleration"""


class LockedChoice(ProjectSection):
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


class LockedArtificial(ProjectSection):
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


class LockedRecord(ProjectSection):
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


class LockedSuite(ProjectSection):
    """A suite, and what it holds for."""

    target: LockedTarget
    """a table [target]"""
    chosen: LockedChoice
    """a table [chosen]"""
    artificial: LockedArtificial | None = None
    """a table [artificial]"""
    records: tuple[LockedRecord, ...] = ()
    """a table [[records]] for each record of a file"""


class SuiteLock(LockedSuite):
    """All that a lock says; of several suites it is the first."""

    format: Literal[1]
    """version of this format"""
    seal: StrictStr
    """SHA-256 of all that follows"""
    others: tuple[LockedSuite, ...] = ()
    """a table [[others]] for each further target"""

    @property
    def suites(self) -> tuple[LockedSuite, ...]:
        """All of them, each for another target."""
        return (self, *self.others)


def read_lock(path: Path) -> tuple[SuiteLock, bool]:
    """Return a lock, and whether it is as it was written.

    Raises
    ------
    ProjectError : there is no such file, or it is no lock
    """
    try:
        return _parse_lock(path, file_sha256(path))
    except FileNotFoundError:
        raise ProjectError(f"{path}: no such file; make it: run `assess records select PROJECT --lock`") from None
    except OSError as error:
        raise ProjectError(f"{path}: cannot be read ({error.strerror}); {AGAIN}") from None


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


DIGITS = 12  # after the point, of a peak ground acceleration in g
COMMAND = "records select --lock"


def suite_to_lock(
    motions: Sequence[ScaledRecord],
    spectrum: Spectrum,
    fitting: Fitting,
    *,
    place: Path,
    folder: Path,
    scale_to: ScaleTo,
    further_factor: float = 1.0,
    overrides: HeaderOverrides = NO_OVERRIDES,
    recipe: tuple[ArtificialRecords, tuple[float, float]] | None = None,
) -> LockedSuite:
    """Return a suite as its lock has it.

    Parameters
    ----------
    motions : the suite, as scaled to the spectrum
    spectrum : the target
    fitting : how the records were chosen and scaled
    place : folder of the lock
    folder : that the paths of the records are relative to
    scale_to, further_factor : as in [records]
    overrides : what files do not state themselves, where the records were not selected out of a catalogue
    recipe : of the artificial records, with the range of periods that they fit [s]
    """
    mark = target_mark(spectrum)
    recorded = [motion for motion in motions if not motion.record.artificial]
    chosen = () if fitting.selection is None else fitting.selection.choices
    candidates: Sequence[Candidate | None] = [one for choice in chosen for one in choice.components]
    numbers = dict(fitting.nga)
    records = [
        _locked_record(
            motion,
            folder / motion.record.path,
            place=place,
            overrides=overrides if candidate is None else candidate.overrides,
            nga=numbers.get(motion.record.id),
        )
        for motion, candidate in zip(recorded, candidates or [None] * len(recorded), strict=True)
    ]
    return LockedSuite(
        target=LockedTarget(code=mark.code, pga_g=round(mark.pga / g, DIGITS), sha256=mark.sha256),
        chosen=_locked_choice(fitting, scale_to, further_factor),
        artificial=None
        if recipe is None
        else _locked_artificial(*recipe, [m for m in motions if m.record.artificial], spectrum),
        records=tuple(records),
    )


def lock_text(suite: LockedSuite, *others: LockedSuite) -> str:
    """Return the text of a lock of suites, each for another target, with its seal.

    Parameters
    ----------
    suite : the first
    others : the further ones
    """
    body = "".join((_suite_text(suite), *(f"\n[[others]]\n{_suite_text(each, within='others.')}" for each in others)))
    return f'{HEAD}format = 1\nseal = "{_sha256(body)}"\n{body}'


def write_lock(path: Path, text: str) -> None:
    """Write a lock, whole or not at all; only a lock as it was written before is replaced.

    Raises
    ------
    OutputError : the file that is there is another, or a lock that was edited
    """
    if path.is_file() and not is_replaceable(path) and path.read_bytes() != text.encode():
        raise OutputError(f"{path}: {_why_not_replaceable(path)}; move it away, and a new one is written")
    with replace_file(path, command=COMMAND, is_replaceable=is_replaceable) as made:
        made.write_text(text, encoding="utf-8", newline="\n")


@lru_cache(maxsize=64)
def _parse_lock(path: Path, sha256: str) -> tuple[SuiteLock, bool]:
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


def _suite_text(suite: LockedSuite, *, within: str = "") -> str:
    """Return the tables of a suite; within : what their names begin with."""
    single = {"target": suite.target, "chosen": suite.chosen, "artificial": suite.artificial}
    tables: list[tuple[str, ProjectSection]] = [
        (f"[{within}{name}]", table) for name, table in single.items() if table is not None
    ]
    tables += [(f"[[{within}records]]", record) for record in suite.records]
    return "".join("\n".join(("", head, *_table_lines(table), "")) for head, table in tables)


def _sha256(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _table_lines(table: ProjectSection) -> Iterator[str]:
    """Yield the keys of a table that are not at their default."""
    defaults: Mapping[str, Any] = {key: field.default for key, field in table.table_keys().items()}
    for key, value in table.entries().items():
        if value != defaults[key]:
            yield f"{key} = {_toml_value(value)}"


def _toml_value(value: Any) -> str:
    """Return a value as TOML: a list of lists on lines of their own, numbers at full precision."""
    if isinstance(value, tuple):
        parts = [_toml_value(each) for each in value]
        nested = any(isinstance(each, tuple) for each in value) or len(", ".join(parts)) > 100
        return "[\n" + "".join(f"    {part},\n" for part in parts) + "]" if nested else f"[{', '.join(parts)}]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return str(value).lower() if isinstance(value, bool) else repr(value)


def _why_not_replaceable(path: Path) -> str:
    """Return what a file is that is not a lock as it was written."""
    start = path.read_bytes().startswith(HEAD.encode())
    return "the lock was edited since it was written" if start else "not written by `assess records select --lock`"


def _locked_record(
    motion: ScaledRecord, file: Path, *, place: Path, overrides: HeaderOverrides, nga: int | None
) -> LockedRecord:
    record, response = motion.record, overrides.response
    return LockedRecord(
        id=record.id,
        file=relative_path(file, place),
        position=_position_in_file(record, read_with_overrides(file, overrides)),
        component=record.component,
        sha256=file_sha256(file),
        scale_factor=motion.scaling.factor,
        event=record.event,
        date=record.earthquake.time,
        station=record.station,
        magnitude=record.earthquake.magnitude,
        distance_m=record.distance,
        vs30_m_per_s=record.site.vs30,
        nga=nga,
        unit=overrides.unit,
        step_s=overrides.step,
        response=None if response is None else relative_path(response, place),
        response_sha256=None if response is None else file_sha256(response),
    )


def _position_in_file(record: Record, found: Sequence[Record]) -> int:
    """Return the place of a record among those of its file, from 1."""
    return next(
        place
        for place, one in enumerate(found, start=1)
        if one.component == record.component and np.array_equal(one.acceleration, record.acceleration)
    )


def _locked_choice(fitting: Fitting, scale_to: ScaleTo, further_factor: float) -> LockedChoice:
    low, high = fitting.band.ends
    code = None if fitting.given_factors is None or not fitting.given_factors.code else fitting.given_factors.code
    found = fitting.selection
    if found is None:
        return LockedChoice(how="all", scale_to=scale_to, further_factor=further_factor, periods_s=(low, high))
    weight = fitting.band.weight
    pairs = zip(fitting.band.period.tolist(), weight.tolist(), strict=True)
    of = found.criteria
    return LockedChoice.model_validate(
        {
            "how": "selected",
            "scale_to": scale_to,
            "further_factor": further_factor,
            "periods_s": (low, high),
            "weights": () if np.all(weight == weight[0]) else tuple(pairs),
            "for": code,
            "fit": of.fit,
            "components": of.components,
            "one_per_event": of.one_per_event,
            "scale_limits": of.scale_limits,
            "misfit": found.misfit,
            "greedy_misfit": found.greedy,
            "remaining": found.counted,
        }
    )


def _locked_artificial(
    made: ArtificialRecords, band: tuple[float, float], motions: Sequence[ScaledRecord], spectrum: Spectrum
) -> LockedArtificial:
    return LockedArtificial(
        count=made.count,
        seed=seed_of_target(spectrum, duration=made.duration) if made.seed is None else made.seed,
        duration_s=made.duration,
        periods_s=band,
        scale_factor=motions[0].scaling.factor,
        sha256=tuple(samples_sha256(motion.record) for motion in motions),
    )
