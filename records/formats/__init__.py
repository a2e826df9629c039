"""Readers of record files, one module for each format, and their registry."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from records.formats import csv, peer_at2
from records.record import Record


class Read(Protocol):
    """Reads every record of a file; `unit` is that of the accelerations where the file states none."""

    def __call__(self, path: Path, *, unit: str | None = None) -> tuple[Record, ...]:
        """The records of the file at `path`."""


@dataclass(frozen=True)
class Format:
    """One format: whether the first bytes of a file are of it, and how the whole is read."""

    looks_like: Callable[[bytes], bool]
    read: Read


FORMATS: Mapping[str, Format] = {
    peer_at2.NAME: Format(peer_at2.looks_like, peer_at2.read),
    csv.NAME: Format(csv.looks_like, csv.read),
}
