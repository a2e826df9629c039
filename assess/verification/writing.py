"""The input files of cases, written out so that a user runs them again."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

from assess.errors import AssessError
from assess.outputs.manifest import stays_inside
from assess.results.verification import CaseResult
from assess.verification.case import CaseFile


def write_cases(files: Sequence[CaseFile], results: Sequence[CaseResult], folder: Path) -> None:
    """Write the files of cases, with their projects and what these name, into a folder as they stand among the cases.

    Parameters
    ----------
    files : of the cases
    results : of the cases, which list what was read
    folder : to write into
    """
    found = {each.key: each for each in results}
    for file in (each for each in files if each.key in found):
        example = file.case.given.get("example")
        if example is not None:
            _write_example(str(example), folder / file.project_folder)
        root = file.path.parents[file.key.count("/")]
        for each in found[file.key].inputs:
            place = folder / each.path
            if not stays_inside(each.path):
                raise AssessError(f"case {file.key}: {each.path} leads out of the folder of cases; move the file there")
            if not place.exists():
                place.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(root / each.path, place)


def _write_example(name: str, folder: Path) -> None:
    from assess.examples import copy_example

    if not folder.exists():
        copy_example(name, folder)
