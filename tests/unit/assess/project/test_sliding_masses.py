"""Sliding of a block beside masses that do not bear, from the project file, against hand calculation."""

from __future__ import annotations

from math import pi

import pytest
from scipy.constants import g

from assess.study.run import run_study
from tests.support.projects import block, lines, project_toml, study_of, wall

BLOCK = 2000 * 2 * 1 * 2
TABLE = "period [s],acceleration [g]\n0,0.4\n0.1,1\n0.5,1\n4,0.125\n"
ETA = (10.0 / 15.0) ** 0.5  # of tables, for 10 % damping: EN 1998-1, 3.2.2.2


def checks(folder, loads="", vertical=0.0):
    (folder / "s.csv").write_text(TABLE)
    text = project_toml(
        site={"limit_state": "SLV", "vertical_ratio": vertical, "spectrum": {"code": "table", "file": "s.csv"}},
        materials={"m": {"density": 2000, "friction": 0.3}},
        bodies={"w": wall(2, 1, 2, material="m")},
        mechanisms={"m": lines(block("w", direction=[1, 0, 0]), f"loads = [{loads}]")},
        analysis={"procedures": ["sliding", "asce43-05-sliding"]},
        records={"synthetic": {"count": 1, "duration": "8 s"}},
        procedures={"asce43-05": {"allowable_sliding": "0.5 m"}},
    )
    (result,) = run_study(study_of(folder, text)).mechanisms
    return {check.procedure: check for check in result.checks}


def distance(friction: float) -> float:
    """A-2 and A-3 on the falling line of the table, from 1 g at 0.5 s to 0.125 g at 4 s."""
    period = 0.5 + (1.0 - 2 * friction / ETA) / (1.0 - 0.125) * 3.5
    return 2 * friction * g * (period / (2 * pi)) ** 2


@pytest.mark.parametrize("vertical", [0.0, 0.5])
@pytest.mark.parametrize("share", [0.0, 0.05, 0.4])
def test_masses_that_do_not_bear_slide_with_the_block_and_do_not_press(tmp_path, share, vertical):
    """M = (1 + share) M_b slides, M_b g presses: mu N / (M g) = 0.3 / (1 + share), less 0.4 A_v / g for A-1."""
    beside = f'{{ kind = "mass", mass = {share * BLOCK}, at = [0, 1], bearing = false }}' if share else ""
    found, mu = checks(tmp_path, beside, vertical), 0.3 / (1 + share)
    assert found["asce43-05-sliding"].demand == pytest.approx(distance(mu * (1 - 0.4 * vertical * 0.4)), rel=1e-9)
    assert found["sliding"].capacity_pga_g == pytest.approx(mu, rel=1e-9)  # mu N = M a


def test_masses_that_bear_press_as_they_slide(tmp_path):
    on_top = f'{{ kind = "mass", mass = {0.4 * BLOCK}, at = [0, 2], bearing = true }}'
    found = checks(tmp_path, on_top)
    assert found["asce43-05-sliding"].demand == pytest.approx(distance(0.3), rel=1e-9)
    assert found["sliding"].capacity_pga_g == pytest.approx(0.3, rel=1e-9)


@pytest.mark.parametrize(
    ("load", "name", "slides"),
    [
        ('kind = "force", force = ["0 N", "-20 kN"], at = [0, 2]', "force 1", 0.3 * (1 + 20e3 / (BLOCK * g))),
        ('kind = "force", force = ["-9 kN", "0 N"], at = [0, 0.1]', "force 1", 0.3 - 9e3 / (BLOCK * g)),
        ('kind = "tie", force = "10 kN", at = [0, 0.1], direction = [-1, 0]', "tie 1", 0.3),
    ],
)
def test_forces_and_ties_are_not_for_a_1_and_sliding_counts_them(tmp_path, load, name, slides):
    """The tie is slack the one way, where the block slides as without it."""
    found = checks(tmp_path, f"{{ {load} }}")
    clause = found["asce43-05-sliding"]
    assert (clause.verdict, clause.demand, clause.capacity_pga_g) == ("not-applicable", None, None)
    assert clause.reason.key == "weight-only"
    assert f"loaded by its weight alone, but {name} also acts on this one" in clause.reason.text
    assert found["sliding"].capacity_pga_g == pytest.approx(slides, rel=1e-9)
