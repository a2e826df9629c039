"""A case that is the mechanisms of a project, without analysis: what `assess parameters` gives."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from assess.verification.solvers.project import project_file


def solve_parameters(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the mechanisms of a project, and of every case of its sweeps, as they stand in results.json.

    Parameters
    ----------
    folder : of the case
    given : `file` or `example` as for a project; `rotations` [rad], at which moments are wanted

    Returns
    -------
    Mapping
        `inputs`, the files read; `mechanisms` by name; `moments`, restoring moments [N m] of positive rotation by
        mechanism and rotation, and their `largest`.
    """
    import numpy as np

    from assess.oscillator import restoring_moment
    from assess.project.build import build
    from assess.project.schema import load
    from assess.results.json import dumps_mechanisms
    from assess.study.parameters import case_parameters, parameters

    with project_file(folder, given) as file:
        study = build(load(file))
    rotations = np.array(given.get("rotations", []), dtype=float)
    moments = {}
    for mechanism in study.mechanisms:
        branch = mechanism.oscillator.positive
        found = zip(rotations, restoring_moment(branch, rotations), strict=True)
        moments[mechanism.name] = {f"{at:g}": float(moment) for at, moment in found}
        moments[mechanism.name]["largest"] = float(branch.restoring.max())
    mechanisms = json.loads(dumps_mechanisms((*parameters(study), *case_parameters(study))))
    inputs = [{"path": each.path, "sha256": each.sha256} for each in study.inputs]
    return {"inputs": inputs, "mechanisms": mechanisms, "moments": moments}
