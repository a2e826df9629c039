"""Which tests reach a line, and how long each takes: measured once, and again for test files that have changed.

Three things are not seen by measuring. Compiled kernels leave no trace, so that the tests of a kernel are those of the
lines that name what other files import from it. What is run when a file is imported belongs to no test, so that the
tests of a table or a default are those of its whole file, or of the files that import it. What a test has cached is
not run again by the next, so that with a test go those of its file, and of the files that share a cache with it.
"""

from __future__ import annotations

import ast
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterable, Iterator
from functools import cached_property
from hashlib import sha256
from pathlib import Path

from coverage import CoverageData

from tools.mutate.site import ROOT, Site

SUITES = ("tests/unit", "tests/properties", "tests/validation", "tests/tools", "tests/languages")
SOURCES = ("assess", "spectra", "records")


class Covering:
    """The measurement in a folder; collected: the tests that there are where mutants are tried."""

    def __init__(self, folder: Path) -> None:
        self.collected = list[str]()
        self.folder, self.file = folder, folder / "coverage.db"
        self.seconds_file, self.hashes_file = folder / "seconds.json", folder / "hashes.json"

    # ------------------------------------------------------------------------------------------------------- measuring

    def measure(self) -> None:
        """Run the tests that have changed since the last time, all at the first, under coverage."""
        self.folder.mkdir(parents=True, exist_ok=True)
        known, now = self.hashes, hashes(each for suite in SUITES for each in (ROOT / suite).rglob("test_*.py"))
        changed = [path for path, digest in now.items() if known.get(path) != digest]
        if changed:
            options = ["-n", "2", "--dist", "worksteal", "-p", "tools.mutate.coverage_plugin", "-p", "no:cacheprovider"]
            cover = ["--cov", "--cov-append", "--cov-context=test", "--cov-report=", f"--cov-config={self._settings()}"]
            seconds = {"MUTATE_SECONDS": str(self.seconds_file), "PYTHONPATH": str(ROOT)}
            command = [sys.executable, "-m", "pytest", *options, *cover, *changed]
            code = subprocess.run(command, cwd=ROOT, env={**os.environ, **seconds}).returncode
            if code not in (0, 1, 5):
                raise SystemExit(f"the tests cannot be measured: pytest ends with {code}")
            self.hashes_file.write_text(json.dumps(known | now | self._sources()))

    def _settings(self) -> Path:
        path = self.folder / "coveragerc"
        path.write_text(f"[run]\nrelative_files = true\nsource = {','.join(SOURCES)}\ndata_file = {self.file}\n")
        return path

    def _sources(self) -> dict[str, str]:
        """Hashes of sources, kept at the first measurement only: later ones see a part of the tests."""
        known = {path: digest for path, digest in self.hashes.items() if not path.startswith("tests")}
        return known or hashes(path for each in SOURCES for path in (ROOT / each).rglob("*.py"))

    @property
    def hashes(self) -> dict[str, str]:
        """Of the files as they were measured."""
        return json.loads(self.hashes_file.read_text()) if self.hashes_file.exists() else {}

    # ----------------------------------------------------------------------------------------------------------- asking

    def leave_out(self, tests: Iterable[str]) -> None:
        """Let tests judge no mutant from now on: those that fail without one."""
        for test in tests:
            self.seconds.pop(test, None)

    @cached_property
    def seconds(self) -> dict[str, float]:
        """Of each test that passed and whose file exists."""
        known = json.loads(self.seconds_file.read_text())
        return {name: float(known[name]) for name in self.collected if name in known}

    def tests(self, site: Site) -> list[str]:
        """The tests that reach a place; then those with which they share caches.

        Those of the test file named like the source go first, then one of each file in turn, the short ones before.
        """
        reached = self._tests(site) & set(self.seconds)
        files = {shared for test in reached for shared in self._sharing(test.split("::")[0])}
        beside = {test for test in self.seconds if test.split("::")[0] in files} - reached
        by_time = self.seconds.__getitem__
        own = [test for test in reached if is_named_like(test, site.path)]
        turns = list[tuple[int, int, float, str]]()
        for file, tests in _by_file(reached - set(own)).items():
            near = -likeness(file, site.path)
            turns += [(turn, near, by_time(test), test) for turn, test in enumerate(sorted(tests, key=by_time))]
        return [*sorted(own, key=by_time), *(test for *_, test in sorted(turns)), *sorted(beside, key=by_time)]

    @cached_property
    def _caches(self) -> dict[str, set[str]]:
        """The test files that import each module of tests/support that caches what it makes."""
        kept = [path.stem for path in (ROOT / "tests/support").glob("*.py") if "@cache" in path.read_text()]
        texts = {test.split("::")[0]: "" for test in self.seconds}
        texts = {path: (ROOT / path).read_text(encoding="utf-8") for path in texts}
        return {name: {path for path, text in texts.items() if f"tests.support.{name} " in text} for name in kept}

    def _sharing(self, file: str) -> set[str]:
        return {file}.union(*(files for files in self._caches.values() if file in files))

    def _tests(self, site: Site) -> set[str]:
        if is_kernel(site.path):
            return self._of_kernel(site.path)
        lines = self._lines(site.path)
        if site.function and self._unchanged(site.path):
            found = {test for line in range(site.statement[0], site.statement[1] + 1) for test in lines.get(line, ())}
            if found:
                return found
        own = self._of_file(site.path)
        return own if own and site.function else own | self._of_importers(site.path)

    def _of_file(self, path: str) -> set[str]:
        return {test for tests in self._lines(path).values() for test in tests}

    def _of_importers(self, path: str) -> set[str]:
        """The tests of the files that import one without functions, directly or through others."""
        found, seen, now = set[str](), {path}, [path]
        while now:
            now = list(dict.fromkeys(each for one in now for each in importers(one) if each not in seen))
            seen |= set(now)
            found |= {test for each in now for test in self._of_file(each)}
        return found

    def _of_kernel(self, kernel: str) -> set[str]:
        found, folder = set[str](), f"{kernel.partition('kernel')[0]}kernel"
        for path in importers(folder):
            text = (ROOT / path).read_text(encoding="utf-8")
            words = imported(text, folder.replace("/", "."))
            for line, tests in self._lines(path).items():
                here = text.splitlines()[line - 1 : line]
                if any(re.search(rf"\b{word}\b", each) for each in here for word in words):
                    found |= tests
        return found

    @cached_property
    def _data(self) -> CoverageData:
        data = CoverageData(str(self.file))
        data.read()
        return data

    def _lines(self, path: str) -> dict[int, set[str]]:
        by_line = self._data.contexts_by_lineno(path)
        return {line: {each.split("|")[0] for each in contexts if each} for line, contexts in by_line.items()}

    def _unchanged(self, path: str) -> bool:
        return self.hashes.get(path) == hashes([ROOT / path])[path]


def is_kernel(path: str) -> bool:
    """Whether a file is compiled."""
    return path.endswith("/kernel.py") or "/kernel/" in path


def imported(text: str, package: str) -> set[str]:
    """The names that a source imports from a package or module, or from what is in it, under those it gives them."""
    froms = (node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom))
    here = (node for node in froms if node.module and f"{node.module}.".startswith(f"{package}."))
    return {each.asname or each.name for node in here for each in node.names}


def importers(path: str) -> Iterator[str]:
    """The files that import a file, or anything of a folder, but kernels."""
    parent, _, name = path.removesuffix(".py").removesuffix("/__init__").replace("/", ".").rpartition(".")
    whole = rf"(from|import) {re.escape(parent)}\.{name}\b"
    pattern = re.compile(rf"^\s*({whole}|from {re.escape(parent)} import (\([^)]*|.*)\b{name}\b)", re.MULTILINE)
    for source in (each for folder in SOURCES for each in sorted((ROOT / folder).rglob("*.py"))):
        name = source.relative_to(ROOT).as_posix()
        if not is_kernel(name) and pattern.search(source.read_text(encoding="utf-8")):
            yield name


def likeness(file: str, path: str) -> int:
    """How many parts of the path of a file of tests are in that of a source."""
    return len(set(path.removesuffix(".py").split("/")) & set(Path(file).parts))


def is_named_like(test: str, path: str) -> bool:
    """Whether the file of a test has the name of a source."""
    return Path(test.split("::")[0]).stem == f"test_{Path(path).stem.strip('_')}"


def _by_file(tests: Iterable[str]) -> dict[str, list[str]]:
    found = dict[str, list[str]]()
    for test in tests:
        found.setdefault(test.split("::")[0], []).append(test)
    return found


def hashes(paths: Iterable[Path]) -> dict[str, str]:
    """Of the contents of files, by path from the root."""
    return {path.relative_to(ROOT).as_posix(): sha256(path.read_bytes()).hexdigest()[:16] for path in paths}
