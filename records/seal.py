"""The seal of a row: a hash by which a value is known that was changed since it was written."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from math import isfinite, isnan
from typing import Any


def with_seal(row: Sequence[Any]) -> tuple[Any, ...]:
    """Return the row with its seal."""
    return (*row, seal(row))


def seal(row: Sequence[Any]) -> str:
    """Return a hash of the values of a row, the same before and after SQLite has kept them."""
    digest = hashlib.sha256()
    for value in row:
        plain = _plain(value)
        digest.update(f"{len(plain)} ".encode() + plain)
    return digest.hexdigest()[:32]


def _plain(value: Any) -> bytes:
    """Return a value as bytes that tell its kind; SQLite may give 1.0 back as 1, and gives nan back as None."""
    if isinstance(value, bytes):
        return b"b" + value
    if isinstance(value, str):
        return b"s" + value.encode("utf-8", "surrogateescape")
    if value is None or (isinstance(value, float) and isnan(value)):
        return b"n"
    if isinstance(value, float) and isfinite(value) and value.is_integer():
        value = int(value)
    return f"{value:d}".encode() if isinstance(value, int) else repr(float(value)).encode()
