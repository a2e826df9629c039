"""Check what is in the wheel and the source distribution of a folder: `python -m tools.distribution.contents dist`.

The wheel has every file of the four packages and nothing else; the source distribution makes the same wheel, byte for
byte, in an environment that has the build's requirements, and no network.
"""

from __future__ import annotations

import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("assess", "records", "reports", "spectra")
KINDS = (".py", ".typed", ".toml", ".csv", ".md", ".po", ".html", ".css", ".js")
"""Endings of files that a wheel may hold; whatever else lies in a folder of the packages is rubbish."""
INPUTS = ("assess/verification/cases/", (".AT2", ".ply", ".json"))
"""The folder in which records, meshes and replies of services lie too, and their endings: inputs of solved cases."""
NO_PART = (".venv", "__pycache__", ".pyc", "_cache/", ".hypothesis", "build/", "dist/")
MEGABYTE = 1e6


def faults_of_wheel(wheel: Path, root: Path = ROOT) -> list[str]:
    """List what the wheel lacks, and what has no place in it."""
    found = {name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name}
    wanted = {
        path.relative_to(root).as_posix()
        for package in PACKAGES
        for path in (root / package).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    strange = {name for name in found | wanted if not (name.endswith(KINDS) or _is_input(name))}
    return [
        *(f"{wheel.name} lacks {name}" for name in sorted(wanted - found)),
        *(f"{wheel.name} should not hold {name}" for name in sorted((found - wanted) | strange)),
    ]


def _is_input(name: str) -> bool:
    folder, kinds = INPUTS
    return name.startswith(folder) and name.endswith(kinds)


def faults_of_sdist(sdist: Path, wheel: Path) -> list[str]:
    """List rubbish in the source distribution, and that it makes another wheel."""
    with tarfile.open(sdist) as archive:
        names = archive.getnames()
    rubbish = [f"{sdist.name} should not hold {name}" for name in names if any(part in name for part in NO_PART)]
    return rubbish if _wheel_of(sdist) == wheel.read_bytes() else [*rubbish, f"{sdist.name} makes another wheel"]


def _wheel_of(sdist: Path) -> bytes:
    """Return the wheel that pip builds from a source distribution."""
    with tempfile.TemporaryDirectory() as folder:
        options = ("--no-deps", "--no-build-isolation", "--no-index", "--disable-pip-version-check", "--quiet")
        subprocess.run([sys.executable, "-m", "pip", "wheel", *options, "--wheel-dir", folder, str(sdist)], check=True)
        (made,) = Path(folder).glob("*.whl")
        return made.read_bytes()


def main(folder: Path) -> int:
    """Print sizes, or the faults; return the exit code."""
    (wheel,), (sdist,) = folder.glob("*.whl"), folder.glob("*.tar.gz")
    faults = [*faults_of_wheel(wheel), *faults_of_sdist(sdist, wheel)]
    for each in faults or [f"{path} {path.stat().st_size / MEGABYTE:.2f} MB" for path in (wheel, sdist)]:
        print(each)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
