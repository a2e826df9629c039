"""Artificial records are made once for all processes of a version of the program: dozens of projects ask for a few."""

from __future__ import annotations

import os
import pickle
from functools import cache
from hashlib import sha256
from pathlib import Path

from records import synthetic
from records.record import Record
from tests.support.places import ROOT, SOURCES, folder_of_version

KEPT = ROOT / "build" / "artificial"
MAKERS = ("records", "spectra", "assess/messages")
"""Folders of sources: a record holds messages of its making."""
make_artificial = synthetic._make_artificial


@cache
def recall(recipe: synthetic._Recipe, index: int) -> Record:
    """Return record `index` of a recipe as one of the processes has made it."""
    file = _folder() / sha256(repr((recipe, index)).encode()).hexdigest()[:32]
    try:
        record: Record = pickle.loads(file.read_bytes())
    except FileNotFoundError:
        record = make_artificial(recipe, index)
        part = file.with_suffix(f".{os.getpid()}")  # whole or not at all: another process never reads a part of it
        part.write_bytes(pickle.dumps(record))
        part.replace(file)
    record.acceleration.flags.writeable = False
    return record


@cache
def _folder() -> Path:
    """Return the folder of the sources, and of the versions, that make the records and what a record holds."""
    digest = sha256((ROOT / "requirements.lock").read_bytes())
    for file in sorted(file for name in MAKERS for file in (SOURCES / name).rglob("*.py")):
        digest.update(file.read_bytes())
    return folder_of_version(KEPT, digest.hexdigest()[:16])
