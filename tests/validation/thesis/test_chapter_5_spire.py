"""The parametric study of a spire, thesis 5.3 and Table 5.1: crack angle and height of a cone.

The table's own geometry stands only in a figure. What it says is compared: lambda falls as the crack grows steeper, is
nearly the same for every height of one angle, and p_eq falls as the part that moves grows. The numbers are compared
with an oblique pyramid: what lies above an inclined plane through a cone is its apex over a plane section, whose
corners are found here by hand and whose integrals trimesh takes.
"""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.constants import g

from assess.study.mechanism_results import case_parameters
from tests.support.projects import study_of

RADIUS, HEIGHT, SIDES = 2.0, 9.0, 32
ANGLES = 2.0 * np.pi * np.arange(SIDES) / SIDES
BASE = RADIUS * np.column_stack([np.cos(ANGLES), np.sin(ANGLES), np.zeros(SIDES)])
PROJECT = """
[materials.stone]
density = 1800
[bodies.spire]
material = "stone"
mesh = "spire.obj"
[mechanisms.spire]
kind = "single-block"
blocks = ["spire"]
sides = "one"
direction = [1, 0, 0]
cut = {{ point = [0, 0, {crack}], angle = "45 deg" }}
[analysis.sweep]
{sweep}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    points = np.concatenate([BASE, [[0.0, 0.0, HEIGHT]]])
    trimesh.convex.convex_hull(points).export(tmp_path / "spire.obj", digits=17)
    return tmp_path


def oblique(angle: float, *, crack: float) -> tuple[float, float]:
    """lambda [-] and p [1/s] of the apex over the section by a plane at `angle` [rad] through (0, 0, crack)."""
    apex = np.array([0.0, 0.0, HEIGHT])
    normal = np.array([np.sin(angle), 0.0, np.cos(angle)])
    edges = BASE - apex
    along = (np.array([0.0, 0.0, crack]) - apex) @ normal / (edges @ normal)
    section = apex + along[:, None] * edges
    assert section[:, 2].min() > 0.0  # the crack leaves the cone above its base
    part = trimesh.convex.convex_hull(np.concatenate([section, apex[None]]))
    hinge = section[np.argmax(section[:, 0])]
    behind, height = hinge[0] - part.center_mass[0], part.center_mass[2] - hinge[2]
    inertia = part.moment_inertia[1, 1] + part.volume * (behind**2 + height**2)
    return behind / height, float(np.sqrt(part.volume * g * np.hypot(behind, height) / inertia))


def test_lambda_falls_as_the_crack_grows_steeper(folder: Path) -> None:
    sweep = 'key = "mechanisms.spire.cut.angle"\nvalues = ["45 deg", "60 deg", "75 deg"]'
    found = case_parameters(study_of(folder, PROJECT.format(sweep=sweep, crack=7.6)))
    expected = [oblique(angle, crack=7.6) for angle in np.radians([45, 60, 75])]
    multiplier = [m.oscillator.uplift_multiplier or 0.0 for m in found]
    np.testing.assert_allclose(multiplier, [pair[0] for pair in expected], rtol=1e-8)
    np.testing.assert_allclose([m.oscillator.p_eq_per_s for m in found], [pair[1] for pair in expected], rtol=1e-8)
    assert multiplier[0] > multiplier[1] > multiplier[2]  # Table 5.1: 0.42, 0.34, 0.23
    assert found[0].oscillator.p_eq_per_s > found[1].oscillator.p_eq_per_s > found[2].oscillator.p_eq_per_s  # 3.17 …


def test_height_at_one_angle_is_scale(folder: Path) -> None:
    sweep = 'key = "mechanisms.spire.cut.point.2"\nvalues = [5.0, 6.0, 7.0]'
    found = case_parameters(study_of(folder, PROJECT.format(sweep=sweep, crack=5.0)))
    multiplier = [m.oscillator.uplift_multiplier for m in found]
    np.testing.assert_allclose(multiplier, multiplier[0], rtol=1e-9)  # Table 5.1: 0.40 to 0.43
    scaled = np.array([m.oscillator.p_eq_per_s for m in found]) ** 2 * (HEIGHT - np.array([5.0, 6.0, 7.0]))
    np.testing.assert_allclose(scaled, scaled[0], rtol=1e-9)  # the table: 3.17^2 / 2.73^2 = 1.35 for 4/3


def test_the_angle_is_the_normal_in_the_plane_of_motion(folder: Path) -> None:
    text = PROJECT.format(sweep="", crack=7.0).replace("[analysis.sweep]\n", "")
    turned = text.replace("direction = [1, 0, 0]", "direction = [0, -2, 0]")
    normal = turned.replace('angle = "45 deg"', "normal = [0, -1, 1]")
    results = []
    for content in (text, turned, normal):
        results.append(study_of(folder, content).mechanisms[0].positive)
    assert results[1].hinges[0] == pytest.approx(results[2].hinges[0], rel=1e-12)
    assert results[1].blocks[0].inertia == pytest.approx(results[2].blocks[0].inertia, rel=1e-12)
    assert results[0].blocks[0].inertia == pytest.approx(results[1].blocks[0].inertia, rel=1e-9)  # 32 sides: the same
