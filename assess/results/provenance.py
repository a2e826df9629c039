"""What all files of results share: the program, the files read, the resolved values, front matter, and the stamp."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from importlib.metadata import PackageMetadata, metadata, version
from pathlib import Path
from typing import Any, Literal

from assess.codes.checklists import BuildingType
from assess.short_repr import ShortRepr

NAME = "rocking-assess"
PACKAGES = ("assess", "records", "reports", "spectra")  # whose files the digest of the sources covers
GROUPS, DIGITS = 4, 4  # of a stamp, in groups: no spreadsheet takes it for a number or a date
OF_MECHANISM = 2  # steps of the key of a mechanism, of which no one source knows all
Floats = tuple[float, ...]
Point = tuple[float, float]
Place = tuple[float, float, float]
Ring = tuple[Point, ...]


@dataclass(frozen=True, repr=False)
class Program(ShortRepr):
    """The program that made the results.

    licence : of the package, such as "MIT"; "" in results of older versions, like the next two
    origin : who publishes it, with the address of its sources if the package names one
    sha256 : of its own files: of two runs with the same, the same code made both
    """

    name: str
    version: str
    licence: str = ""
    origin: str = ""
    sha256: str = ""


@dataclass(frozen=True, repr=False)
class Input(ShortRepr):
    """A file that was read: its path relative to the project file, and its SHA-256."""

    path: str
    sha256: str


@dataclass(frozen=True, repr=False)
class ResolvedValue(ShortRepr):
    """A value of the project as used, in SI; given: whether by the user, or by default.

    dimensions : what its numbers measure, by the way to them from the key: "" for the value itself, "2.mass" for a key
    of the third of several tables; keys without a dimension are left out
    cov : coefficient of variation of those of its numbers that are means, by the same way; empty where all are certain
    """

    value: Any
    given: bool
    dimensions: dict[str, str] = field(default_factory=dict)
    cov: dict[str, float] = field(default_factory=dict)


MediaType = Literal["image/png", "image/jpeg"]
ChecklistOutcome = Literal["examined", "absent", "not-examined"]


@dataclass(frozen=True, repr=False)
class ReportMatter(ShortRepr):
    """Front matter and checklist of a report; texts are the user's, "" where not given.

    coordinates: latitude and longitude [deg], or the user's text; building_type, checklist: "" and empty if the project
    file does not say what the building is; struck_out: names of mechanisms that are left out, each with the reason.
    """

    client: str = ""
    address: str = ""
    coordinates: Point | str = ""
    author: str = ""
    office: str = ""
    licence_number: str = ""
    checker: str = ""
    date: str = ""
    status: str = ""
    engineer: str = ""
    reference: str = ""
    revisions: tuple[Revision, ...] = ()
    seismic_zone: str = ""
    national_annex: str = ""
    building_type: BuildingType | Literal[""] = ""
    logo: Picture | None = None
    figures: tuple[Picture, ...] = ()
    checklist: tuple[ChecklistItem, ...] = ()
    struck_out: tuple[tuple[str, str], ...] = ()

    @property
    def not_examined(self) -> tuple[ChecklistItem, ...]:
        """Items that are possible and were not examined: they make the building's index an upper bound."""
        return tuple(item for item in self.checklist if item.outcome == "not-examined")

    @property
    def number_left_out(self) -> int:
        """How many mechanisms were not examined: items of the list, and those that are struck out."""
        return len(self.not_examined) + len(self.struck_out)


NO_MATTER = ReportMatter()
"""Of results whose project file has no [report]."""


@dataclass(frozen=True, repr=False)
class Revision(ShortRepr):
    """An issue of the report; date: as the user wrote it."""

    number: str
    date: str
    description: str
    author: str


@dataclass(frozen=True, repr=False)
class ChecklistItem(ShortRepr):
    """A mechanism that buildings of this type can have, and what became of it here.

    number: in the Italian form for churches, None for houses; mechanisms: names of those that examine it; reason: why
    it is not examined, in the user's words; spoken_for: False if the project file does not mention it, which counts as
    possible and not examined.
    """

    key: str
    number: int | None
    outcome: ChecklistOutcome
    mechanisms: tuple[str, ...] = ()
    reason: str = ""
    spoken_for: bool = True


@dataclass(frozen=True, repr=False)
class Picture(ShortRepr):
    """A logo or photograph as the report shows it; name: of its file; data: its bytes in base64.

    The bytes are re-encoded by this program from the file's pixels: upright, and without the file's metadata.
    """

    name: str
    caption: str
    media_type: MediaType
    width_px: int
    height_px: int
    data: str


def stamp(command: str, program: Program, inputs: Sequence[Input]) -> str:
    """Return a short hash of the command with its options, the program, and every file read.

    Clock, number of jobs, and place of the output are ignored.

    Parameters
    ----------
    command : the command with its options
    program : the program that made the results
    inputs : the files that were read

    Returns
    -------
    Sixteen hexadecimal digits in groups of four.
    """
    files = [[each.path, each.sha256] for each in inputs]
    text = json.dumps([command, program.name, program.version, files], ensure_ascii=True)
    digest = hashlib.sha256(text.encode()).hexdigest()
    return "-".join(digest[DIGITS * place : DIGITS * (place + 1)] for place in range(GROUPS))


def stamp_of_files(command: str, files: Sequence[Path], *options: object) -> str:
    """Return the stamp of what a command makes of files.

    Parameters
    ----------
    command : the command
    files : the files that it reads
    *options
        Its options.

    Returns
    -------
    The stamp.
    """
    read = [Input(file.name, hashlib.sha256(file.read_bytes()).hexdigest()) for file in files]
    return stamp(f"{command} {options!r}", this_program(), read)


def origin(command: str, shown: str) -> str:
    """Return the origin of a single figure: the program, and a stamp of its content.

    Parameters
    ----------
    command : the command that draws it
    shown : the numbers it shows, as text

    Returns
    -------
    Name and version of the program, and the stamp.
    """
    program = this_program()
    return f"{program.name} {program.version}, stamp {stamp(f'{command} {shown}', program, ())}"


def count_from_0(key: str) -> str:
    """Write a key with dots and items counted from 0; errors print them in brackets, counted from 1."""
    return re.sub(r"\[([1-9][0-9]{0,3})\]", lambda found: f".{int(found[1]) - 1}", key)


def count_from_1(key: str) -> str:
    """Write a key with dots and items counted from 0 as errors print it: items in brackets, counted from 1."""
    return re.sub(r"\.(\d+)(?=\.|$)", lambda found: f"[{int(found[1]) + 1}]", key)


def source_line(key: str, sources: Mapping[str, str]) -> str:
    """Return the line of [report.sources] for a key, else that of the innermost table that holds it; empty without one.

    A load is a table, and so is a joint. A mechanism, the building or the list of all loads is too much for one source.

    Parameters
    ----------
    key : with dots, items of lists counted from 0
    sources : lines by the keys that they are for, items of lists counted either way
    """
    stated = {count_from_0(place): text for place, text in sources.items()}
    return next((stated[each] for each in (key, *tables_that_hold(key)) if each in stated), "")


def this_program() -> Program:
    """Return the program that runs."""
    return Program(NAME, version(NAME))


@cache
def describe_program() -> Program:
    """Return the program that runs, with its licence, origin and sources; read once in a process."""
    about = metadata(NAME)
    return Program(NAME, about["Version"], licence_of(about), origin_of(about), sources_digest(package_folder()))


def licence_of(about: PackageMetadata) -> str:
    """Return the licence that a package declares, such as "MIT"; "" if it declares none."""
    return _field(about, "License-Expression") or _field(about, "License")


def origin_of(about: PackageMetadata) -> str:
    """Return who publishes a package and where its sources are, as far as it says so; else its name and summary."""
    author = _field(about, "Author") or _field(about, "Author-email") or _field(about, "Maintainer")
    urls = [entry.partition(",")[2].strip() for entry in about.get_all("Project-URL") or []]
    named = [text for text in (author, *urls[:1]) if text]
    return ", ".join(named) or f"{about['Name']}: {about['Summary']}"


def package_folder() -> Path:
    """Return the folder that holds the packages of the program."""
    return Path(__file__).parents[2]


def sources_digest(folder: Path) -> str:
    """Return the SHA-256 of the files of the program: paths relative to `folder`, in order, and contents.

    Solved cases and examples are among them; what Python and numba keep for themselves is not.

    Parameters
    ----------
    folder : holds the packages
    """
    digest = hashlib.sha256()
    files = sorted(
        (path.relative_to(folder).as_posix(), path)
        for name in PACKAGES
        for path in (folder / name).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and not path.name.startswith(".")
    )
    for name, path in files:
        content = path.read_bytes()
        digest.update(f"{name}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()


def file_sha256(path: Path) -> str:
    """Return the SHA-256 of a file.

    Raises
    ------
    OSError : there is no such file, or it cannot be read
    """
    return _sha256(path.absolute(), file_state(path))


FileState = tuple[int, int, int, int]
"""Size of a file, its times of change [ns] and its number on the disk: another content has another one."""


def file_state(path: Path) -> FileState:
    """Return the state of a file.

    Raises
    ------
    OSError : there is no such file, or it cannot be read
    """
    status = path.stat()
    return (status.st_size, status.st_mtime_ns, status.st_ctime_ns, status.st_ino)


def tables_that_hold(key: str) -> Iterator[str]:
    """Yield the tables that one source may know: the innermost, and all within a mechanism but its loads."""
    steps = key.split(".")
    for count in range(len(steps) - 1, 0, -1):
        if steps[0] == "mechanisms":
            holds = count > OF_MECHANISM and steps[count - 1] != "loads"
        else:
            rows = steps[count].isdigit()  # of a table that is written as a list, such as a hazard
            holds = (count == len(steps) - 1 or rows) and steps[0] != "building"
        if holds:
            yield ".".join(steps[:count])


def _field(about: PackageMetadata, key: str) -> str:
    """Return a field of metadata; "" if it is missing."""
    return about[key] if key in about else ""  # noqa: SIM401 - metadata has no typed get


@lru_cache(maxsize=4096)
def _sha256(path: Path, state: FileState) -> str:
    """Return the SHA-256 of a file in this state."""
    with path.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()
