"""Paths of record files as a project file writes them."""

from __future__ import annotations

from pathlib import Path


def relative_path(path: Path, folder: Path) -> str:
    """Return a path as the project file in a folder would write it: relative to the folder if it lies inside.

    Parameters
    ----------
    path : of a file
    folder : of the project file

    Returns
    -------
    the path with slashes
    """
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else path.as_posix()
