"""One mutant in a copy of the tree: its file is replaced, the tests that reach it are run, and the file is put back."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from resource import RLIMIT_CPU, prlimit

from tests.support.places import REAL_RECORDS
from tools.mutate.covering import SUITES, Covering, is_kernel
from tools.mutate.mutant import Mutant
from tools.mutate.site import ROOT

FIRST, ALL = 12.0, 120.0  # s of tests, as they were measured: tried at first, and at most
START, COMPILE = 30.0, 200.0  # s of a processor that pytest may take to begin, and kernels to be compiled again
SLOWER = 4.0  # than measured, where a test is not in a loop without end
WAITING = 10.0  # times the limit, for a processor that others use, or for what never comes
KILLED, TIMEOUT, SURVIVED, UNREACHED, UNJUDGED = "killed", "timeout", "survived", "not reached", "not judged"
INTERRUPTED, NO_SUCH_TEST = 2, 4
"""How pytest ends where a file of tests cannot be imported, and where a test is not found."""


@dataclass(frozen=True)
class Trial:
    """What became of a mutant."""

    mutant: Mutant
    outcome: str
    by: str  # the test that failed, or how many passed
    seconds: float

    @property
    def killer(self) -> str:
        """The test that failed; "" where none did."""
        return failed_tests(self.by)[0] if self.outcome == KILLED and failed_tests(self.by) else ""


def copy_tree(to: Path) -> Path:
    """Copy what git knows of, with what is not yet committed, and compile it."""
    shutil.rmtree(to, ignore_errors=True)
    listed = subprocess.check_output(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, text=True)
    for name in filter(None, listed.splitlines()):
        if (ROOT / name).is_file():
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, to / name)
    (to / ".venv").symlink_to(ROOT / ".venv")
    subprocess.run([sys.executable, "-m", "compileall", "-q", "assess", "spectra", "records"], cwd=to, check=False)
    return to


def collect(tree: Path) -> list[str]:
    """List the tests that pytest finds in a copy: those of data outside the tree may be absent."""
    command = [
        sys.executable,
        "-m",
        "pytest",
        "--collect-only",
        "--continue-on-collection-errors",
        "-q",
        "-o",
        "addopts=--import-mode=importlib",
        *SUITES,
    ]
    given = {**os.environ, "PYTHONPATH": str(tree), "ASSESS_RECORDS": str(REAL_RECORDS)}
    listed = subprocess.run(command, cwd=tree, env=given, capture_output=True, text=True).stdout
    return [line for line in listed.splitlines() if "::" in line]


def try_mutant(mutant: Mutant, covering: Covering, tree: Path) -> Trial:
    """Run the tests in two parts, so that what is easily killed does not load them all."""
    tests, started = covering.tests(mutant.site), time.monotonic()
    if not tests:
        return Trial(mutant, UNREACHED, "no test reaches it", 0.0)
    first = _within(tests, covering, FIRST)
    rest = _within(tests[len(first) :], covering, ALL)
    outcome = by = ""
    with _Mutated(mutant, tree) as cache:
        for part in filter(None, (first, rest)):
            expected = sum(covering.seconds[test] for test in part)
            limit = START + SLOWER * expected + (COMPILE if is_kernel(mutant.site.path) else 0.0)
            outcome, by = run_tests(part, tree, limit=limit, cache=cache)
            if outcome != SURVIVED:
                break
    if outcome == SURVIVED:
        by = f"{len(first) + len(rest)} of {len(tests)} tests that reach it pass"
    return Trial(mutant, outcome, by, time.monotonic() - started)


def _within(tests: Sequence[str], covering: Covering, seconds: float) -> list[str]:
    """The first tests that take so long together, one at least."""
    taken, found = 0.0, list[str]()
    for test in tests:
        taken += covering.seconds[test]
        if found and taken > seconds:
            break
        found.append(test)
    return found


class _Mutated:
    """A mutant that stands in a tree, where no file of old code, Python's or the kernels', is in its place."""

    def __init__(self, mutant: Mutant, tree: Path) -> None:
        self.path, self.source, self.tree = tree / mutant.site.path, mutant.source, tree
        self.cache = tree / "kernels-of-mutant" if is_kernel(mutant.site.path) else tree / "kernels"

    def __enter__(self) -> Path:
        self.original = self.path.read_text(encoding="utf-8")
        self._write(self.source)
        return self.cache

    def __exit__(self, *_: object) -> None:
        self._write(self.original)
        shutil.rmtree(self.tree / "kernels-of-mutant", ignore_errors=True)

    def _write(self, source: str) -> None:
        self.path.write_text(source, encoding="utf-8")
        for old in (self.path.parent / "__pycache__").glob(f"{self.path.stem}.*.pyc"):
            old.unlink()


def run_tests(tests: Sequence[str], tree: Path, *, limit: float, cache: Path) -> tuple[str, str]:
    """Run tests until one fails; a process that runs or grows beyond its limits has been changed as well.

    A mutant may change the name of a test's parameters, so that pytest finds it no more: then its file is run.
    """
    code, output = _pytest(tests, tree, "-x", limit=limit, cache=cache)
    if code == NO_SUCH_TEST:
        code, output = _pytest(sorted({each.split("::")[0] for each in tests}), tree, "-x", limit=limit, cache=cache)
    if code in (None, -signal.SIGXCPU, -signal.SIGKILL):
        return TIMEOUT, f"more than {limit:.0f} s"
    if code == 0:
        return SURVIVED, ""
    failed = [line for line in output.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    said = failed[0] if failed else (output.strip().splitlines() or ["nothing"])[-1]
    noticed = code < 0 or (code in (1, INTERRUPTED) and failed)
    return (KILLED, said) if noticed else (UNJUDGED, f"pytest ends with {code}: {said}")


def failing(tests: Sequence[str], tree: Path) -> set[str]:
    """Return which tests fail in a tree without a mutant, so that they judge none."""
    if not tests:
        return set()
    _, output = _pytest(tests, tree, limit=START + COMPILE + SLOWER * ALL * len(tests), cache=tree / "kernels")
    return set(failed_tests(output)) & set(tests)


def failed_tests(output: str) -> list[str]:
    """Return the tests that the lines of pytest say to have failed."""
    lines = (line for line in output.splitlines() if line.startswith(("FAILED ", "ERROR ")))
    return [line.partition(" ")[2].partition(" - ")[0] for line in lines]


def _pytest(tests: Sequence[str], tree: Path, *options: str, limit: float, cache: Path) -> tuple[int | None, str]:
    """Run tests in a tree and return the exit code, None where it never ends, and what pytest prints."""
    listed = tree / "tests.txt"
    listed.write_text("\n".join(tests), encoding="utf-8")
    cache.mkdir(mode=0o700, exist_ok=True)
    given = {"PYTHONPATH": str(tree), "PYTHONDONTWRITEBYTECODE": "1", "NUMBA_CACHE_DIR": str(cache)}
    given["ASSESS_RECORDS"] = str(REAL_RECORDS)
    command = [
        sys.executable,
        "-m",
        "pytest",
        *options,
        "-q",
        "--tb=no",
        "-rfE",
        "-p",
        "no:cacheprovider",
        f"@{listed}",
    ]
    process = subprocess.Popen(
        command, cwd=tree, env={**os.environ, **given}, text=True, start_new_session=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    prlimit(process.pid, RLIMIT_CPU, (int(limit), int(limit)))  # however busy the machine is
    try:
        output, _ = process.communicate(timeout=WAITING * limit)
    except subprocess.TimeoutExpired:
        return None, ""
    finally:
        _end(process)
    return process.returncode, output


def _end(process: subprocess.Popen[str]) -> None:
    """End a process with those it started; all are in the group that is named by its number."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        return
    process.wait()
