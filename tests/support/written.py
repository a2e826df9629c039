"""Small sets of files in place of what a command writes, for tests of how outputs are written."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from assess.outputs.lock import LOCK
from assess.outputs.manifest import MANIFEST, RESULTS
from assess.outputs.writing import Tell, output_folder


def content(folder: Path) -> dict[str, str]:
    """The text of every file below `folder` but what the program keeps there for itself."""
    own = (LOCK, MANIFEST)
    return {
        p.relative_to(folder).as_posix(): p.read_text() for p in folder.rglob("*") if p.is_file() and p.name not in own
    }


def write(folder: Path, files: Mapping[str, str]) -> None:
    """Write the files below `folder`."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def run(folder: Path, files: Mapping[str, str], *, owner: str = RESULTS, tell: Tell = lambda _: None) -> None:
    """Write the files into `folder` as a command does that is known to write them all."""
    with output_folder(folder, command="a test", owner=owner, expected=[*files], tell=tell) as stage:
        write(stage, files)


def made_file(path: Path, content: str | bytes) -> Path:
    """Return a file that is made with this content."""
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path


def names(folder: Path) -> list[str]:
    """What a folder holds, by name."""
    return sorted(path.name for path in folder.iterdir())
