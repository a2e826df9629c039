"""Every number of a project file, however large or small, ends in a result or in one line that names it."""

from __future__ import annotations

import tomllib
import warnings
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from assess.errors import AssessError
from assess.project.build import build
from assess.project.keys import keyed_values, with_value
from assess.project.project_file import load
from assess.study.mechanism_results import parameters
from assess.study.run import run_study
from spectra.spectrum import SpectrumError
from tests.support.projects import study_of, tables_toml, write_project

SITE = """
[site]
limit_state = "SLV"
pga = 1.5
vertical_ratio = 0.5
[site.spectrum]
code = "asce7-16"
s_ds = 4.9
s_d1 = 2.0
t_l = 6
damping = 0.05
[building]
height = 9
storeys = 3
ground_elevation = 0
natural_frequency = 3
effective_height = 6
damping = 0.05
period = 0.3
[materials.m]
density = 2000
young_modulus = 6.89e9
compressive_strength = 1e6
tensile_strength = 1e4
friction = 0.5
[bodies.wall]
material = "m"
box = { thickness = 0.5, length = 3, height = 4, base = [0, 0, 0] }
[records]
factor = 1
synthetic = { count = 1, seed = 1, duration = 20 }
[procedures]
dmi2008 = { confidence_factor = 1.35 }
asce43-05 = { allowable_sliding = 0.05 }
nzsee2017 = { usable = 0.5, risk_factor = 1.0, c_0 = 1.5 }
ec8 = { behaviour_factor = 1.5, importance_factor = 1.0, alpha_s = 1.0 }
asce41-13 = { s_x1 = 1.0 }
[analysis]
levels = [1.0]
[analysis.pulses]
shape = "ricker"
frequency = { from = 0.5, to = 3, count = 3 }
amplitude = { from = 0, to = 10, count = 3 }
"""
JOINT = 'interface = { model = "flexible", stiffness = 1e9, strength = 1e6 }\n'
WALL = 'blocks = ["wall"]\ndirection = [1, 0, 0]\n'
MASS = '{ kind = "mass", mass = 500, at = [0, 3], bearing = true, seat = 0.1 }'
FORCE = '{ kind = "force", force = [100, -200], at = [0, 3], until = 0.1 }'
TIE = (
    '{ kind = "tie", force = 1000, at = [0, 3], direction = [-1, 0], until = 0.1, strength = 2000, length = 2, '
    "fracture_strain = 0.02 }"
)
SRSS = 'amplification = { method = "srss", natural_frequency = 3, effective_height = 6, height = 4 }\n'
MECHANISMS = {
    "site": 'kind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.84\n',
    "equivalent": 'kind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.84\nmass = 1\nrestitution = 0.9\n'
    "elevation = 0\n",
    "loaded": f'kind = "single-block"\n{WALL}cut = 1\nrestitution = 0.9\nbase_elevation = 0\n{SRSS}'
    f"loads = [{MASS}, {FORCE}, {TIE}]\n",
    "inclined": f'kind = "single-block"\n{WALL}cut = {{ point = [0, 0, 1], normal = [0.2, 0, 1] }}\n'
    "hinges = { A = [0.25, 1] }\nhinges_negative = { A = [-0.25, 1] }\n",
    "on a joint": f'kind = "single-block"\n{WALL}{JOINT}',
    "on a course": f'kind = "single-block"\n{WALL}interface = {{ model = "semi-flexible", course_thickness = 0.3, '
    "strength = 1e6, shape = { rectangle = [0.5, 3] } }\n",
    "spanning": f'kind = "two-block"\n{WALL}crack = 2.2\n'
    'loads = [{ kind = "overburden", force = 20000, eccentricity = 0.05 }]\n',
    "under a floor": f'kind = "two-block"\n{WALL}crack = 2.2\n'
    'loads = [{ kind = "body", body = "floor", tolerance = 0.01, share = 0.5, mass = 900, seat = 0.1 }]\n'
    '[bodies.floor]\nmaterial = "m"\nbox = { thickness = 0.5, length = 3, height = 0.3, base = [0, 0, 4] }\n',
    "portal": 'kind = "four-hinge"\nblocks = ["d", "e", "f"]\nsides = "one"\n'
    "hinges = { A = [0.4, 0], B = [-0.4, 3], C = [4.4, 3], D = [4.4, 0] }\n"
    "[bodies]\nd = { mass = 1000, centroid = [0, 1.5], inertia = 800 }\n"
    "e = { mass = 1000, centroid = [2, 3.2], inertia = 800 }\n"
    "f = { mass = 1000, centroid = [4, 1.5], inertia = 800 }\n",
}
BODIES = 'wall = { material = "m", box = { thickness = 0.5, length = 3, height = 4 } }\n'
NUMBERS = (0.0, 1e-300, 1e-8, 1e5, 2e12)
COUNTS = (0, -1, 10**9, 10**30)
EVERY = pytest.param(1, marks=pytest.mark.study)
SECOND = pytest.param(2)
"""Every number at every key, or every second one, in turn: of two neighbouring keys one gets it."""


@cache
def raw_of(name: str) -> dict[str, Any]:
    """What the file of one mechanism says."""
    text = f"{SITE}[mechanisms.k]\n{MECHANISMS[name]}"
    if name == "portal":
        box = 'material = "m"\nbox = { thickness = 0.5, length = 3, height = 4, base = [0, 0, 0] }\n'
        text = text.replace(f"[bodies.wall]\n{box}", "").replace("[bodies]\n", f"[bodies]\n{BODIES}")
    return tomllib.loads(text)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("step", [SECOND, EVERY])
@pytest.mark.parametrize("name", MECHANISMS)
def test_extreme_numbers_end_in_a_result_or_in_one_line(tmp_path: Path, name: str, step: int) -> None:
    raw = raw_of(name)
    content = load(write_project(tmp_path, tables_toml(**raw))).content
    read = refused = tried = 0
    beside = {"site": "", "loaded": "bodies", "portal": "bodies.d"}.get(name, "mechanisms")
    for key, place in keyed_values(content).items():
        # the numbers of a mechanism that it has not from others, and for one of them those of all other tables
        own = "mechanisms" not in key if name == "site" else "direction" not in key
        if not (place.is_number and own and key.startswith(("mechanisms", beside)) and key != "format"):
            continue
        whole = isinstance(place.value, int) and not isinstance(place.value, bool)
        tried += 1
        for number in (COUNTS if whole else NUMBERS)[tried % step :: step]:
            file = write_project(tmp_path, tables_toml(**with_value(raw, place.path, number, content)))
            try:
                parameters(build(load(file)))
                read += 1
            except (AssessError, SpectrumError) as error:
                assert "\n" not in str(error), (place.path, number)  # noqa: PT017
                refused += 1
    assert read > 0 < refused


@pytest.mark.parametrize(
    ("line", "refusal"),
    [
        ("p = 2e12", "mechanisms.k.p: 2000000000000.0: 2e+12 1/s is outside 0.001 to 1000 1/s"),
        ("p = 500", "mechanisms.k.p: 500: with a radius of 2.84 m the inertia about the hinge is 1.38e-05 M R^2"),
        ("p = 0.002", "give 0.0186 to 186 1/s (a slender block has sqrt(3 g / (4 R)) = 1.61 1/s), or another radius"),
    ],
)
def test_an_equivalent_block_of_no_body_is_refused_with_the_range(tmp_path: Path, line: str, refusal: str) -> None:
    text = f"{SITE}[mechanisms.k]\n{MECHANISMS['equivalent']}".replace("p = 1.6", line)
    (tmp_path / "project.toml").write_text(text)
    with pytest.raises(AssessError) as refused:
        load(tmp_path)
    assert refusal in str(refused.value)
    assert "\n" not in str(refused.value)


def test_equivalent_blocks_of_published_tables_are_in_range(tmp_path: Path) -> None:
    """Walls of 0.5 to 20 m, and one that spans, whose inertia ratio is 0.54."""
    for p, radius in ((3.84, 0.5), (0.61, 20.0), (4.0557, 1.1141)):
        text = f"{SITE}[mechanisms.k]\n{MECHANISMS['equivalent']}".replace("p = 1.6", f"p = {p}")
        (tmp_path / "project.toml").write_text(text.replace("radius = 2.84", f"radius = {radius}"))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            assert build(load(tmp_path)).mechanisms


def test_what_stands_only_by_a_tie_that_ends_is_not_answered(tmp_path: Path) -> None:
    """The wall is so thin that it falls when the tie ends, long before the displacement asked for."""
    loaded = MECHANISMS["loaded"].replace("cut = 1\n", "").replace(SRSS, "")
    text = f"{SITE}[mechanisms.k]\n{loaded}".replace("thickness = 0.5", "thickness = 0.001")
    text = text.replace("levels = [1.0]", 'levels = [1.0]\nprocedures = ["dmi2008-nonlinear", "ntc2018-nonlinear"]')
    (result,) = run_study(study_of(tmp_path, text)).mechanisms
    assert {check.verdict for check in result.checks} == {"not-answered"}
    assert all(check.demand is None and check.capacity is None for check in result.checks)


def test_a_plate_that_hums_on_its_joint_is_refused_before_its_histories(tmp_path: Path) -> None:
    text = f"{SITE}[mechanisms.k]\n{MECHANISMS['on a joint']}".replace("height = 4", "height = 1e-9")
    (tmp_path / "project.toml").write_text(text)
    with pytest.raises(AssessError, match=r"moves on its joints at .* Hz, beyond the 1e\+05 Hz histories can follow"):
        run_study(build(load(tmp_path)))
