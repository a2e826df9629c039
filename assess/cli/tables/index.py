"""What an index of a folder did, for the terminal and as JSON."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

from assess.project.key_text import escape_text
from assess.study.record_set import cell_message
from records.flatfile_match import FlatfileMatch
from records.indexing import IndexSummary

MAX_CELLS = 20  # bad cells of a flatfile


def table_text(found: IndexSummary, place: Path, *, described: int, merged: FlatfileMatch | None) -> str:
    """Write the counts, the use of a flatfile, each unreadable file with the reason, and the catalogue's path."""
    counts = f"{found.read} files read, {found.unchanged} unchanged, {found.gone} gone"
    lines = [
        f"{counts}; {found.records} records, {described} of known magnitude; {len(found.problems)} files not readable",
        *(["the catalogue had an older format: every file was read again"] if found.older else []),
        *(f"{path}: its rows in the catalogue were damaged: the file was read again" for path in found.damaged),
        *([] if merged is None else _flatfile(merged)),
        *(f"{path}: {why}" for path, why in found.problems),
        str(place),
    ]
    return "".join(f"{escape_text(line)}\n" for line in lines)


def json_text(found: IndexSummary, place: Path, *, described: int, merged: FlatfileMatch | None) -> str:
    """Write the counts, the use of a flatfile and the unreadable files as JSON."""
    problems = [{"path": path, "reason": why} for path, why in found.problems]
    told = {**asdict(found), "problems": problems, "with_magnitude": described, "catalogue": str(place)}
    return json.dumps({**told, "flatfile": _as_json(merged)}, ensure_ascii=False, indent=1) + "\n"


def _flatfile(merged: FlatfileMatch) -> list[str]:
    counts = f"{merged.matched} rows matched, {merged.unmatched} unmatched, {len(merged.bad)} bad cells"
    bad = [f"flatfile, {cell_message(cell)}" for cell in merged.bad[:MAX_CELLS]]
    more = (
        [f"flatfile: {len(merged.bad) - MAX_CELLS} more bad cells; --json lists all"]
        if len(merged.bad) > MAX_CELLS
        else []
    )
    return [f"flatfile: {counts}; {merged.records} records described", *bad, *more]


def _as_json(merged: FlatfileMatch | None) -> dict[str, object] | None:
    if merged is None:
        return None
    bad = [asdict(cell) for cell in merged.bad]
    counts = {"matched": merged.matched, "unmatched": merged.unmatched, "records": merged.records}
    return {**counts, "bad_cells": bad, "warning": None if merged.warning is None else merged.warning.text}
