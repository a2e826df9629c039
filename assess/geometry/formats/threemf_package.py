"""A 3MF package unpacked within limits: what it announces is checked before any of it is made."""

from __future__ import annotations

import zlib
from pathlib import Path
from zipfile import BadZipFile, ZipFile, ZipInfo

MAX_RATIO = 100  # times its own size that an archive may unpack to; mesh text packs to a tenth, at most a thirtieth
ALWAYS_ALLOWED = 100_000_000  # bytes that any archive may unpack to
MAX_UNPACKED = 4_000_000_000  # bytes that none may exceed
BLOCK = 1 << 18  # bytes unpacked at a time
PROLOGUE = 1 << 16  # bytes that hold the document type, if there is one


def unpack_3mf(file: Path) -> dict[str, bytes]:
    """Unpack the model parts of a 3MF package by name; nothing where all of it would be too large.

    Raises
    ------
    ValueError : it is no package, or unpacks to too much; a part declares entities
    """
    with ZipFile(file) as package:
        _refuse_large(sum(each.file_size for each in package.infolist()), packed=file.stat().st_size)
        models = [each for each in package.infolist() if each.filename.lower().endswith(".model")]
        found = {each.filename: _unpack(package, each) for each in models}
    for model in found.values():
        if b"<!DOCTYPE" in model[:PROLOGUE].replace(b"\0", b"").upper():
            raise ValueError("it declares a document type, which 3MF forbids")
    return found


def _unpack(package: ZipFile, member: ZipInfo) -> bytes:
    """Unpack a member in blocks, so that zipfile gives no more than it announces."""
    found = bytearray()
    try:
        with package.open(member) as content:
            while block := content.read(BLOCK):
                found += block
    except (BadZipFile, RuntimeError, NotImplementedError, zlib.error) as problem:
        raise ValueError(str(problem)) from None
    return bytes(found)


def _refuse_large(unpacked: int, *, packed: int) -> None:
    if unpacked > min(MAX_UNPACKED, max(ALWAYS_ALLOWED, MAX_RATIO * packed)):
        raise ValueError(f"its {packed / 1e6:.3g} MB would unpack to {unpacked / 1e6:.4g} MB, which no mesh does")
