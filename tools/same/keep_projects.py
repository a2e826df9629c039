"""A pytest plugin that keeps a copy of every project that a test opens: `-p keep_projects --keep-projects DIR`."""

from __future__ import annotations

import hashlib
import shutil
import sys
from pathlib import Path
from typing import Any

import pytest

LARGEST = 20_000_000  # [bytes] of a project's folder


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--keep-projects", metavar="DIR", type=Path, help="Keep each project that a test opens in DIR.")


def pytest_configure(config: pytest.Config) -> None:
    target = config.getoption("--keep-projects")
    if target is not None:
        sys.addaudithook(Keeper(target.absolute()))


class Keeper:
    """Copies the folder of each project file that is opened for reading, once for each content of the folder."""

    def __init__(self, target: Path) -> None:
        self.target = target
        self.busy = False

    def __call__(self, event: str, args: tuple[Any, ...]) -> None:
        if event != "open" or self.busy or not str(args[0]).endswith(".toml") or "w" in str(args[1] or ""):
            return
        self.busy = True
        try:
            self.keep(Path(str(args[0])))
        except OSError:
            pass
        finally:
            self.busy = False

    def keep(self, file: Path) -> None:
        """Copy the folder of `file` to a folder named by the content of what it holds."""
        if not file.is_file() or (b"[bodies" not in (text := file.read_bytes()) and b"[mechanisms" not in text):
            return
        files = sorted(path for path in file.parent.rglob("*") if path.is_file() and "results" not in path.parts)
        if sum(path.stat().st_size for path in files) > LARGEST:
            return
        digest = hashlib.sha256(file.name.encode())
        for path in files:
            digest.update(path.relative_to(file.parent).as_posix().encode() + path.read_bytes())
        folder = self.target / digest.hexdigest()[:16]
        if not folder.exists():
            for path in files:
                (place := folder / path.relative_to(file.parent)).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, place)
            (folder / ".project").write_text(file.name)
