"""The rocking parameters of a project's mechanisms, as `assess parameters` prints them: no site, no records."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def solve_parameters(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return `mechanisms` of a project file, as in results.json, before any check.

    Parameters
    ----------
    folder : of the case
    given : `file`, a project file beside the case
    """
    from assess.project.build import build
    from assess.project.schema import load
    from assess.results.json import dumps_mechanisms
    from assess.study.parameters import parameters

    return {"mechanisms": json.loads(dumps_mechanisms(parameters(build(load(folder / given["file"])))))}
