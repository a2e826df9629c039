"""The shipped examples: built once in a process, and run once for all processes of a version of the program."""

from __future__ import annotations

import re
import shutil
import time
from dataclasses import dataclass, replace
from functools import cache, cached_property
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from tests.support.command import ended
from tests.support.places import ROOT, folder_of_version

if TYPE_CHECKING:
    from assess.results import Results
    from assess.study.study import Study

RUNS = ROOT / "build" / "examples"
WITH_REPORT = ("casa_grande",)
BY_SIGNAL = 128  # plus its number: the exit code of a run that a signal has stopped
FINISHED = (0, 1, 3)  # exit codes of a run with results
SHORTENED = (
    "casa_grande",
    "casa_grande_flexible",
    "casa_grande_table",
    "chiesa",
    "house",
    "nepal_monuments",
    "san_leonardo_church",
    "san_leonardo_spire",
    "san_leonardo_tower",
    "street",
)
"""Run at one level of their study, with few pulses, the ends of their sweeps and no scan, which decide nothing.

The one with a report keeps its levels, which its report compares.
"""


@dataclass(frozen=True)
class ExampleRun:
    """A run of an example by the command line: its folder, and the exit code."""

    name: str
    folder: Path

    @property
    def project(self) -> Path:
        """The project file."""
        from assess.examples import EXAMPLES

        return self.folder / "project" / ("short.toml" if self.name in SHORTENED else EXAMPLES[self.name].file)

    @property
    def outputs(self) -> Path:
        """What the run has written; to be read only."""
        return self.folder / "out"

    @cached_property
    def code(self) -> int:
        """The exit code."""
        return int((self.folder / "code").read_text())


@cache
def example_study(name: str, *, swept: bool = True) -> Study:
    """Return the study of a shipped example, also without its sweeps; its folder is gone, so it is not to be run."""
    from assess.examples import copy_example
    from assess.project.build import build
    from assess.project.project_file import load

    with TemporaryDirectory() as folder:
        project = load(copy_example(name, Path(folder) / name))
        return build(project if swept else replace(project, sweeps=()))


@cache
def example_run(name: str) -> ExampleRun:
    """Return the run of a shipped example, made by the process that asks first, kept by a digest of all sources."""
    from assess.outputs.lock import HeldError, hold_lock

    version = folder_of_version(RUNS, _sources())
    run = ExampleRun(name, version / name)
    while not (run.folder / "code").exists():
        try:
            with hold_lock(version, command="tests", name=f"{name}.lock"):
                if not (run.folder / "code").exists():
                    _make(run)
        except HeldError:
            time.sleep(0.2)
    return run


@cache
def example_results(name: str) -> Results:
    """Return the results of the run of a shipped example."""
    from assess.results.json import loads

    return loads((example_run(name).outputs / "results.json").read_text(encoding="utf-8"))


def _make(run: ExampleRun) -> None:
    """Copy and run an example as a user would; what an interrupted process has left is made again."""
    from assess.examples import copy_example

    shutil.rmtree(run.folder, ignore_errors=True)
    file = copy_example(run.name, run.folder / "project")
    if run.name in SHORTENED:
        short = _shortened(file.read_text(encoding="utf-8"), levels=run.name in WITH_REPORT)
        run.project.write_text(short, encoding="utf-8")
    more = () if run.name in WITH_REPORT else ("--no-report",)
    code = ended("run", "--quiet", run.project, "-o", run.outputs, *more)
    if code > BY_SIGNAL:  # what stopped the command is to stop the tests
        raise KeyboardInterrupt(f"the run of the example {run.name} ended with {code}")
    assert code in FINISHED
    (run.folder / "code").write_text(str(code))


def _shortened(text: str, *, levels: bool) -> str:
    """Return the text of a project made short, with all its levels or the first."""
    text = text.replace("count = 41", "count = 4").replace("sensitivity = true", "")
    if "scan = " not in text:
        text = text.replace("[analysis]", "[analysis]\nscan = false")
    if not levels:
        text = re.sub(r'levels = \[("[^"]+").*\]', r"levels = [\1]", text)
    return re.sub(r'"50 deg".*"75 deg"', '"75 deg"', text)


def _sources() -> str:
    """A digest of the program's sources, its examples among them, of what it imports, and of how many twins it runs."""
    from assess.results.provenance import package_folder, sources_digest
    from assess.study.level_peaks import TWIN_FACTORS

    pins = (ROOT / "requirements.lock").read_bytes()
    return sha256(sources_digest(package_folder()).encode() + pins + TWIN_FACTORS.tobytes()).hexdigest()[:16]
