"""What all tests share: cases drawn by hypothesis, kernels compiled before the tests are dealt out, garbage, Ctrl-C.

The command line is made of its functions once in a process, and each artificial record of its seed once for all.
A history has two twins, in place of eight.
"""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Generator
from functools import cache
from typing import TYPE_CHECKING

import pytest
import typer.main
from hypothesis import HealthCheck, settings

from tests.support.compile_kernels import compile_kernels
from tests.support.required import REQUIRED, fail_if_required, names_required

if TYPE_CHECKING:
    from pathlib import Path

    from assess.project.project_file import Project
    from spectra.arrays import FloatArray

MADE_BETWEEN_COLLECTIONS = 200_000  # objects; the command line has ten times as many
ANYWHERE = {"deadline": None, "database": None, "suppress_health_check": [HealthCheck.function_scoped_fixture]}
settings.register_profile("few", derandomize=True, max_examples=25, **ANYWHERE)
settings.register_profile("deep", derandomize=False, max_examples=1000, print_blob=True, **ANYWHERE)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "few"))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_setupnodes() -> None:
    """Two workers that meet an uncompiled kernel would both compile it."""
    compile_kernels()


def pytest_configure(config: pytest.Config) -> None:
    """Hear SIGINT though a shell has started this in the background, where it is ignored by all that are started."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    typer.main.get_command = cache(
        typer.main.get_command
    )  # made of all commands at each call: half of a short one's time
    config.stash[REQUIRED] = names_required(os.environ.get("ASSESS_REQUIRE", ""))


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Look for garbage neither while modules are imported, a third of the time, nor among them later: they all stay."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(MADE_BETWEEN_COLLECTIONS)  # of what the tests before have made
        gc.enable()


@pytest.fixture(scope="session", autouse=True)
def _artificial_records() -> None:
    from records import synthetic
    from tests.support.artificial import recall

    synthetic._make_artificial = recall


@pytest.fixture(scope="session", autouse=True)
def _eight_twins() -> Generator[FloatArray]:
    """Run histories of this process with two of their eight twins; what is about twins asks for `all_twins`."""
    from assess.study import level_peaks

    every = level_peaks.TWIN_FACTORS
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(level_peaks, "TWIN_FACTORS", every[: level_peaks.OUTER_TWINS.stop])
        yield every


@pytest.fixture(scope="module")
def all_twins(_eight_twins: FloatArray) -> Generator[None]:
    """Run histories with their eight twins, as the program does."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("assess.study.level_peaks.TWIN_FACTORS", _eight_twins)
        yield


@pytest.fixture
def one_build(monkeypatch: pytest.MonkeyPatch) -> None:
    """The commands of a test share what the first has built of a project."""
    from assess.project import build as module

    build = module.build
    built: dict[Path, object] = {}

    def build_once(project: Project, **_: object) -> object:
        if project.path not in built:
            built[project.path] = build(project)
        return built[project.path]

    monkeypatch.setattr(module, "build", build_once)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Fail a test that is skipped for want of what ASSESS_REQUIRE names."""
    report = yield
    fail_if_required(report, item.config.stash[REQUIRED])
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Fail a file of tests that is skipped for want of what ASSESS_REQUIRE names."""
    report = yield
    fail_if_required(report, collector.config.stash[REQUIRED])
    return report


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep the tests of every n-th file, from the k-th on, where ASSESS_SHARD is k/n; neighbours take as long."""
    part, parts = map(int, os.environ.get("ASSESS_SHARD", "1/1").split("/"))
    files = {path: place for place, path in enumerate(sorted({item.path for item in items}))}
    kept = [item for item in items if files[item.path] % parts == part - 1]
    config.hook.pytest_deselected(items=[item for item in items if files[item.path] % parts != part - 1])
    items[:] = kept
