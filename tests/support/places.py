"""Where the packages, the documents and real records are, in a checkout and where the wheel is what is tested."""

from __future__ import annotations

import csv
import os
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

import assess

SOURCES = Path(assess.__file__).resolve().parents[1]
"""The folder of the four packages: the checkout, or site-packages."""
ROOT = Path(__file__).resolve().parents[2]
"""The folder of tests, documents and pyproject.toml."""
PACKAGES = ("assess", "records", "reports", "spectra")
MANUAL = [page for page in sorted((ROOT / "docs").rglob("*.md")) if ROOT / "docs" / "made" not in page.parents]
"""The pages of the manual, but for those that are made when it is built."""

REAL_RECORDS = Path(os.environ.get("ASSESS_RECORDS") or ROOT.parent / "shared" / "records")
"""Accelerograms of others, with their INDEX.csv, which may not be passed on."""
PEER = REAL_RECORDS / "peer_at2"
NO_RECORDS = "real records are not here: ../shared/records, or the folder that ASSESS_RECORDS names"
needs_real_records = pytest.mark.skipif(not (REAL_RECORDS / "INDEX.csv").exists(), reason=NO_RECORDS)


def place_of(path: str) -> Path:
    """Return the place of a path as documents write it, `assess/cli/analysis.py` or `docs/records.md`."""
    return (SOURCES if path.split("/")[0] in PACKAGES else ROOT) / path


def text_of(path: str) -> str:
    """Return the text of a file by its path from the root, as documents write it."""
    return place_of(path).read_text(encoding="utf-8")


def fenced(text: str, kind: str) -> Iterator[tuple[int, str]]:
    """Yield the fenced blocks of one kind in a page, each with the line where it begins."""
    for match in re.finditer(rf"```{kind}\n(.*?)```", text, re.DOTALL):
        yield text.count("\n", 0, match.start()) + 2, match[1]


def defines(path: str, name: str) -> bool:
    """Return whether a module defines a function, a class or a value of this name, itself or in what it defines."""
    return bool(re.search(rf"^\s*(?:(?:def|class) {name}\b|{name}\s*(?::[^=\n]+)?=[^=])", text_of(path), re.MULTILINE))


def index_rows() -> list[dict[str, str]]:
    """Return the rows of the index of real records, which an independent parser made; none where they are not."""
    index = REAL_RECORDS / "INDEX.csv"
    return list(csv.DictReader(index.read_text(encoding="utf-8").splitlines())) if index.exists() else []


def folder_of_version(kept: Path, version: str) -> Path:
    """Return the folder of what tests keep for a version of the sources; of the others only the newest stays."""
    own = kept / version
    own.mkdir(parents=True, exist_ok=True)
    others = sorted((each for each in kept.iterdir() if each != own), key=lambda path: path.stat().st_mtime)
    for old in others[:-1]:
        shutil.rmtree(old, ignore_errors=True)
    return own
