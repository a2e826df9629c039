"""The program as a report names it: name, version, licence, origin, and the digest of its own sources."""

from __future__ import annotations

import hashlib
from functools import cache
from importlib.metadata import PackageMetadata, metadata
from pathlib import Path

from assess.results.inputs import Program
from assess.results.stamp import NAME

PACKAGES = ("assess", "records", "reports", "spectra")


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
    folder : Path
        Holds the packages.
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


def _field(about: PackageMetadata, key: str) -> str:
    """Return a field of metadata; "" if it is missing."""
    return about[key] if key in about else ""  # noqa: SIM401 - metadata has no typed get
