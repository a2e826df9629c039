"""The shipped examples, built once for all tests of a process."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from assess.examples import copy_example
from assess.project.build import build
from assess.project.project_file import load
from assess.study.study import Study


@cache
def example_study(name: str) -> Study:
    """Return the study of a shipped example; its folder is gone by then, so it is not to be run."""
    with TemporaryDirectory() as folder:
        return build(load(copy_example(name, Path(folder) / name)))
