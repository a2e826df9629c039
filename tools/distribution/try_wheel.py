"""Use the wheel of a folder in an empty environment: `python -m tools.distribution.try_wheel dist`.

Dependencies have the versions and hashes of requirements-run.lock. Nothing of the checkout can be imported: commands
run in another folder, without PYTHONPATH, and nothing may be written into site-packages. The second run must find all
compiled kernels of the first.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
import venv
from collections.abc import Iterable, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROJECT, RESULTS = "casa", "casa/results"
JUDGED = (0, 1, 3)
"""Exit codes of a run that came to a verdict, whichever."""
FIRST = (
    ("new", PROJECT, "--example", "casa_grande"),
    ("run", PROJECT, "-o", RESULTS),
    ("verify", "--quick", "-o", "annex"),
)
AGAIN = (("run", PROJECT, "-o", "casa/again", "--no-report"),)
WRITTEN = ("report.pdf", "report.html", "results.json", "tables.xlsx")
PLACES = "import assess, records, reports, spectra; print(*(p.__file__ for p in (assess, records, reports, spectra)))"
KERNELS = "from records.compilation.kernel import code_folder; print(code_folder() or '')"


def install(wheel: Path, folder: Path) -> Path:
    """Make an environment with the wheel and what it needs, and return its folder of programs."""
    venv.create(folder, with_pip=True)
    programs = folder / ("Scripts" if os.name == "nt" else "bin")
    pip = (programs / "python", "-m", "pip", "--disable-pip-version-check")
    run([*pip, "install", "--quiet", "--require-hashes", "--requirement", ROOT / "requirements-run.lock"])
    run([*pip, "install", "--quiet", "--no-deps", wheel.resolve()])
    run([*pip, "check"])
    return programs


def run(command: Sequence[str | Path], *, cwd: Path = ROOT, codes: Iterable[int] = (0,)) -> str:
    """Run a command and return what it printed; end where its exit code is none of `codes`."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    words = [str(each) for each in command]
    done = subprocess.run(words, cwd=cwd, env=kept, capture_output=True, text=True)
    if done.returncode not in codes:
        sys.exit(f"{' '.join(words)} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def use(programs: Path, folder: Path) -> None:
    """Run the commands of a first day in `folder`."""
    packages = [Path(place).parents[1] for place in run([programs / "python", "-c", PLACES], cwd=folder).split()]
    if {place.name for place in packages} != {"site-packages"}:
        sys.exit(f"imported from {', '.join(map(str, packages))}")
    before = _close(packages[0])
    _commands(FIRST, programs, folder)
    lacking = [name for name in WRITTEN if not (folder / RESULTS / name).is_file()]
    kernels = run([programs / "python", "-c", KERNELS], cwd=folder).strip()
    compiled = _compiled(kernels)
    _commands(AGAIN, programs, folder)
    if lacking or not compiled or _compiled(kernels) != compiled:
        sys.exit(
            f"not written: {lacking}; compiled kernels in {kernels or 'no folder'}: {len(compiled)}; those after the "
            f"second run: {len(_compiled(kernels))}, not written again: {len(compiled & _compiled(kernels))}"
        )
    if _files(packages[0]) != before:
        sys.exit(f"something was written into {packages[0]}")


def _commands(commands: Iterable[Sequence[str]], programs: Path, folder: Path) -> None:
    for command in commands:
        start = time.perf_counter()
        run([programs / "assess", *command], cwd=folder, codes=JUDGED if command[0] == "run" else (0,))
        print(f"installed wheel: assess {' '.join(command)}: {time.perf_counter() - start:.1f} s", flush=True)


def _close(folder: Path) -> set[Path]:
    """Take the right to write away from a folder with all below it, and return its files."""
    for place in (folder, *folder.rglob("*")):
        if place.is_dir():
            place.chmod(0o555)
    return _files(folder)


def _compiled(folder: str) -> set[tuple[str, int]]:
    """Return name and time of change [ns] of each compiled kernel, which is another where it was compiled again."""
    return {(path.name, path.stat().st_mtime_ns) for path in Path(folder).glob("*.code")} if folder else set()


def _files(folder: Path) -> set[Path]:
    return set(folder.rglob("*"))


def main(dist: Path) -> None:
    """Install and use the one wheel of a folder."""
    (wheel,) = dist.glob("*.whl")
    with tempfile.TemporaryDirectory(prefix="wheel-") as name:
        start = time.perf_counter()
        programs = install(wheel, Path(name) / "env")
        print(
            f"installed wheel: {wheel.name} into an empty environment: {time.perf_counter() - start:.1f} s", flush=True
        )
        (Path(name) / "elsewhere").mkdir()
        use(programs, Path(name) / "elsewhere")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
