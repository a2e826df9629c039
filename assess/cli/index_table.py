"""What an index of a folder did, for the terminal and as JSON."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

from assess.project.messages import printable
from records.indexing import Indexed


def table_text(found: Indexed, place: Path, *, described: int) -> str:
    """Counts, each file that could not be read with the reason, and the path of the catalogue."""
    counts = f"{found.read} files read, {found.unchanged} unchanged, {found.gone} gone"
    lines = [
        f"{counts}; {found.records} records, {described} of known magnitude; {len(found.problems)} files not readable",
        *(f"{path}: {why}" for path, why in found.problems),
        str(place),
    ]
    return "".join(f"{printable(line)}\n" for line in lines)


def json_text(found: Indexed, place: Path, *, described: int) -> str:
    """The same as JSON."""
    problems = [{"path": path, "reason": why} for path, why in found.problems]
    told = {**asdict(found), "problems": problems, "with_magnitude": described, "catalogue": str(place)}
    return json.dumps(told, ensure_ascii=False, indent=1) + "\n"
