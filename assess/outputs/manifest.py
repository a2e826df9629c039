"""The list of what the program wrote into a folder, by which command, with the SHA-256 of each file.

What is not listed is the user's; what is listed and has another SHA-256 now was changed since it was written. Neither
is ever replaced or removed.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

from assess.outputs.digest import digest

MANIFEST = ".assess-manifest.json"
RESULTS, ENVELOPES, RECORDS = "results.json", "envelopes.json", "records"
"""The sets of files: each command replaces and removes those of its own set only, called after its results."""
_EARLIER = {".assess-outputs": RESULTS, ".assess-envelopes": ENVELOPES}  # lists of names alone
_SLACK = 60.0  # s that an output may be younger than such a list


@dataclass(frozen=True)
class Manifest:
    """The files of each set, with their SHA-256; None for one of an earlier list, which is not known.

    earlier : the lists of versions that kept no manifest, which it takes the place of
    """

    sets: Mapping[str, Mapping[str, str | None]] = field(default_factory=dict)
    earlier: tuple[str, ...] = ()

    def of(self, owner: str) -> Mapping[str, str | None]:
        """The files of one set."""
        return self.sets.get(owner, {})

    def known(self, folder: Path) -> Manifest:
        """The same, with the SHA-256 that files of an earlier list have now."""
        return Manifest(
            {
                owner: {name: digest(folder / name) if old is None else old for name, old in files.items()}
                for owner, files in self.sets.items()
            }
        )

    def text(self) -> str:
        """The manifest as it is written."""
        sets = {owner: dict(sorted(self.sets[owner].items())) for owner in sorted(self.sets) if self.sets[owner]}
        return json.dumps({"format": 1, "sets": sets}, indent=1, ensure_ascii=False) + "\n"


def read(folder: Path) -> Manifest:
    """The manifest of a folder, empty where there is none that can be read; names that lead out of it are left out."""
    try:
        content = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
        listed = {str(owner): dict(files) for owner, files in content["sets"].items()}
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return _earlier(folder)
    return Manifest({owner: _inside({name: s or "" for name, s in files.items()}) for owner, files in listed.items()})


def state(path: Path, sha256: str | None) -> str:
    """What became of a file that was listed: "absent", "unchanged" or "changed"."""
    now = digest(path)
    if now is None:
        return "absent"
    return "unchanged" if sha256 is None or now == sha256 else "changed"


def is_changed(path: Path) -> bool | None:
    """Whether a file is another than the program wrote there; None where no manifest tells."""
    written = [files.get(path.name) for files in read(path.parent).sets.values() if path.name in files]
    return None if not written or written[0] is None else state(path, written[0]) == "changed"


def _earlier(folder: Path) -> Manifest:
    """What lists of earlier versions say; a file well younger than its list was changed since."""
    sets: dict[str, dict[str, str | None]] = {}
    for name, owner in _EARLIER.items():
        try:
            names = (folder / name).read_text(encoding="utf-8").splitlines()
            written = (folder / name).stat().st_mtime
        except (OSError, UnicodeDecodeError):
            continue
        sets[owner] = _inside({each: "" if _younger(folder / each, written) else None for each in names if each})
    return Manifest(sets, tuple(name for name in _EARLIER if (folder / name).is_file()))


def _younger(path: Path, written: float) -> bool:
    try:
        return path.stat().st_mtime > written + _SLACK
    except OSError:
        return False


def stays_inside(name: str) -> bool:
    """Whether a name cannot lead out of its folder, on any system."""
    paths = (PurePosixPath(name), PureWindowsPath(name))
    return bool(name) and "\0" not in name and not any(path.anchor or ".." in path.parts for path in paths)


def link_above(path: Path, folder: Path) -> Path | None:
    """The link, if any, that leads out of `folder` on the way to `path` in it."""
    above = path.relative_to(folder).parents
    return next((found for each in above if (found := folder / each) != folder and found.is_symlink()), None)


def _inside(files: Mapping[str, Any]) -> dict[str, str | None]:
    return {name: None if sha256 is None else str(sha256) for name, sha256 in files.items() if stays_inside(name)}
