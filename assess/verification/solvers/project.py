"""A case that is a project: its results.json as a tree."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any


def solve_project(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Run a project, and return what stands in its results.json.

    Parameters
    ----------
    folder : of the case
    given : `file`, a project file beside the case, or `example`, the name of a shipped example
    """
    from assess.project.build import build
    from assess.project.schema import load
    from assess.results.json import dumps
    from assess.study.run import run

    with project_file(folder, given) as file:
        tree: dict[str, Any] = json.loads(dumps(run(build(load(file)), jobs=1)))
    return tree


@contextmanager
def project_file(folder: Path, given: Mapping[str, Any]) -> Iterator[Path]:
    """Yield the project file of a case; an example is copied for as long as it is needed."""
    if "example" not in given:
        yield folder / given["file"]
        return
    from assess.examples import copy_example

    with TemporaryDirectory() as temporary:
        yield copy_example(given["example"], Path(temporary) / given["example"])
