"""The list of the files that the program wrote into a folder, by command, with the SHA-256 of each.

Files that are not listed are the user's; files that are listed with another SHA-256 were changed since they were
written. Neither are ever replaced or removed.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

MANIFEST = ".assess-manifest.json"
RESULTS, ENVELOPES, FRAGILITY = "results.json", "envelopes.json", "fragility.json"
VERIFICATION = "verification.json"

RECORDS, PORTFOLIO, RETROFIT = "records", "portfolio", "retrofit"
"""The sets of files, named after their results: each command replaces and removes files of its own set only."""

REPORT = ("report.pdf", "report.html", "tables.xlsx")
"""Files of a report besides its tables and figures."""
_EARLIER = {".assess-outputs": RESULTS, ".assess-envelopes": ENVELOPES}  # lists of names alone
_SLACK = 60.0  # s by which an output may be younger than such a list


@dataclass(frozen=True)
class Manifest:
    """The files of each set, with their SHA-256; None for a file of an earlier list, whose SHA-256 is not known.

    earlier : lists of versions that kept no manifest, which this one replaces
    """

    sets: Mapping[str, Mapping[str, str | None]] = field(default_factory=dict)
    earlier: tuple[str, ...] = ()

    def files_of(self, owner: str) -> Mapping[str, str | None]:
        """Return the files of one set."""
        return self.sets.get(owner, {})

    def with_present_digests(self, folder: Path) -> Manifest:
        """Return the manifest with the present SHA-256 of files of an earlier list."""
        return Manifest(
            {
                owner: {name: digest(folder / name) if old is None else old for name, old in files.items()}
                for owner, files in self.sets.items()
            }
        )

    def text(self) -> str:
        """Return the text of the manifest file."""
        sets = {owner: dict(sorted(self.sets[owner].items())) for owner in sorted(self.sets) if self.sets[owner]}
        return json.dumps({"format": 1, "sets": sets}, indent=1, ensure_ascii=False) + "\n"


def read(folder: Path) -> Manifest:
    """Return the manifest of a folder, without names that lead out of it; empty if there is none that can be read."""
    try:
        content = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
        listed = {str(owner): dict(files) for owner, files in content["sets"].items()}
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return _manifest_of_earlier_lists(folder)
    return Manifest(
        {owner: _names_inside({name: s or "" for name, s in files.items()}) for owner, files in listed.items()}
    )


def state(path: Path, sha256: str | None) -> str:
    """Return the state of a listed file: "absent", "unchanged" or "changed"."""
    now = digest(path)
    if now is None:
        return "absent"
    return "unchanged" if sha256 is None or now == sha256 else "changed"


def is_changed(path: Path) -> bool | None:
    """Return whether a file was changed since the program wrote it; None if no manifest lists it."""
    written = [files.get(path.name) for files in read(path.parent).sets.values() if path.name in files]
    return None if not written or written[0] is None else state(path, written[0]) == "changed"


def stays_inside(name: str) -> bool:
    """Return whether a name cannot lead out of its folder, on any system."""
    paths = (PurePosixPath(name), PureWindowsPath(name))
    return bool(name) and "\0" not in name and not any(path.anchor or ".." in path.parts for path in paths)


def link_above(path: Path, folder: Path) -> Path | None:
    """Return the link that leads out of `folder` on the way to `path` in it; None if there is none."""
    above = path.relative_to(folder).parents
    return next((found for each in above if (found := folder / each) != folder and found.is_symlink()), None)


def digest(path: Path) -> str | None:
    """Return the SHA-256 of a file; None if there is no such file, "" if it is not a regular file or cannot be read."""
    try:
        with path.open("rb") as opened:
            return hashlib.file_digest(opened, "sha256").hexdigest()
    except FileNotFoundError:
        return "" if path.is_symlink() else None
    except OSError:
        return ""


def _manifest_of_earlier_lists(folder: Path) -> Manifest:
    """Return the manifest by lists of earlier versions; a file well younger than its list was changed since."""
    sets: dict[str, dict[str, str | None]] = {}
    for name, owner in _EARLIER.items():
        try:
            names = (folder / name).read_text(encoding="utf-8").splitlines()
            written = (folder / name).stat().st_mtime
        except (OSError, UnicodeDecodeError):
            continue
        sets[owner] = _names_inside(
            {each: "" if _is_younger(folder / each, written) else None for each in names if each}
        )
    return Manifest(sets, tuple(name for name in _EARLIER if (folder / name).is_file()))


def _is_younger(path: Path, written: float) -> bool:
    try:
        return path.stat().st_mtime > written + _SLACK
    except OSError:
        return False


def _names_inside(files: Mapping[str, Any]) -> dict[str, str | None]:
    return {name: None if sha256 is None else str(sha256) for name, sha256 in files.items() if stays_inside(name)}
