"""Whether what is drawn below a wall bears it from face to face, as the base reaction of NZSEE 2017 asks."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from assess.project.build import build_to_decide
from assess.project.project_file import load_tree
from tests.support.honest_projects import HONEST


def box(thickness: float, height: float, foot: float, *, x: float = 0.0, material: str = "stone") -> dict[str, Any]:
    size = {"thickness": thickness, "length": 4.0, "height": height, "base": [x, 0.0, foot]}
    return {"material": material, "box": size}


GROUND = box(0.8, 0.5, -3.5)  # of the whole building, the storey below it
UPSTAIRS = {"ground": GROUND}


@pytest.mark.parametrize(
    ("others", "bears"),
    [
        ({}, False),
        ({"footing": box(0.6, 0.5, -0.5)}, True),
        ({"footing": box(0.4, 0.5, -0.5)}, True),  # as thick as the wall
        ({"footing": box(0.6, 0.5, -0.5, material="concrete")}, True),  # a foundation, on the ground
        ({"footing": box(0.3, 0.5, -0.5)}, False),  # thinner
        ({"footing": box(0.4, 0.5, -0.5, x=0.1)}, False),  # a face in the air
        ({"footing": box(0.6, 0.5, -1.0)}, False),  # half a metre below
        ({"storey": box(0.5, 3.0, -3.0), **UPSTAIRS}, True),  # masonry on masonry
        ({"slab": box(0.6, 0.2, -0.2, material="concrete"), **UPSTAIRS}, False),
        ({"half": box(0.2, 3.0, -3.0, x=-0.1), "other": box(0.2, 3.0, -3.0, x=0.1), **UPSTAIRS}, True),
        ({"beside": box(0.6, 3.0, 0.0, x=0.5), **UPSTAIRS}, False),
    ],
)
def test_what_bears_a_wall_of_0_4_m_from_face_to_face(others: dict[str, Any], bears: bool) -> None:
    project = deepcopy(HONEST["NZ two blocks"])
    project["bodies"] = {"wall": project["bodies"]["wall"], **others}
    project["materials"]["concrete"] = {"density": 2400}
    study = build_to_decide(load_tree(project, Path("project.toml"), sha256=""))
    assert study.on_masonry == {"wall": bears}
