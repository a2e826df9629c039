"""Runnable projects shipped with the program, one folder each."""

from __future__ import annotations

import shutil
import tempfile
from difflib import get_close_matches
from pathlib import Path

from assess.errors import ProjectError

EXAMPLES: dict[str, str] = {
    "casa_grande": "Great House of the Casa Grande Ruins, Arizona: eight earthen walls, seven artificial records",
    "single_wall": "one free-standing wall, as small as a project can be",
}


def copy_example(name: str, folder: Path) -> Path:
    """Copy the example `name` into `folder`, whole or not at all; the path of its project file.

    Raises ProjectError for an unknown name, and for a folder that exists and is not empty.
    """
    if name not in EXAMPLES:
        near = get_close_matches(name, EXAMPLES, n=1)
        hint = f'did you mean "{near[0]}"?' if near else f"known: {', '.join(EXAMPLES)}"
        raise ProjectError(f'example "{name}" is not known; {hint}')
    if folder.exists() and not folder.is_dir():
        raise ProjectError(f"{folder}: is a file; give the name of a new folder")
    if folder.is_dir() and any(folder.iterdir()):
        raise ProjectError(f"{folder}: is not empty; give the name of a new folder")
    _copy(source(name), folder)
    return folder / "project.toml"


def source(name: str) -> Path:
    """Where the example lies in the program."""
    return Path(__file__).parent / name


def _copy(example: Path, folder: Path) -> None:
    folder = folder.absolute()
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".assess-partial-", dir=folder.parent) as stage:
        made = Path(stage) / "made"
        shutil.copytree(example, made, ignore=shutil.ignore_patterns("__pycache__"))
        folder.mkdir(exist_ok=True)
        for child in made.iterdir():
            child.rename(folder / child.name)
