"""What must hold of whole projects: a better building, or a weaker earthquake, never has a worse verdict."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from assess.codes.verdict import Decision
from assess.study.run import run_study
from tests.support.projects import NTC, block, lines, project_toml, study_of, wall

SURVEY = {"materials.m.disintegration": "measured: survey"}
PULL_OUT = {"mechanisms.wall.loads[1]": "measured: pull-out tests"}
RANK = {Decision.FAIL: 0, Decision.INCOMPLETE: 1, Decision.PASS: 2}
HEIGHTS = pytest.mark.parametrize("base", [0.0, 6.0])


def tie(force: float, base: float, *, more: str = "") -> str:
    at = f"at = [-0.2, {base + 2.8}], anchor = [-6.0, {base + 2.8}]"
    return f'{{ kind = "tie", {at}, force = "{force} kN"{more} }}'


PROOF = ', until = "collapse", length = "6 m", fracture_strain = 0.2, strength = "90 kN"'
THRUST = '{{ kind = "force", force = ["3 kN", "0 N"], at = [0.0, {}] }}'


def judged(tmp_path: Path, *, pga=0.25, thickness=0.5, base=0.0, loads=()):
    text = project_toml(
        site={"limit_state": "SLV", "pga": f"{pga} g", "spectrum": NTC},
        verdict={"survey_tolerance": 0.0},
        building={"height": "9 m", "storeys": 3, "ground_elevation": 0.0, "use_class": "II"},
        analysis={"procedures": ["ntc2018-nonlinear"]},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": SURVEY | PULL_OUT if loads else SURVEY},
        bodies={"wall": wall(thickness, 3.0, 3.0, material="m", base=[0.0, 0.0, base])},
        mechanisms={"wall": lines(block(direction=[1, 0, 0]), f"loads = [{', '.join(loads)}]")},
        records={"synthetic": {"count": 1, "seed": 1, "duration": "25 s"}},
    )
    found = run_study(study_of(tmp_path, text), jobs=1).verdict
    return RANK[found.outcome], found.index.value


def rises(found) -> bool:
    """Whether neither outcome nor index falls from one to the next, but for rounding."""
    return all(b[0] >= a[0] and b[1] >= a[1] * (1.0 - 1e-9) for a, b in pairwise(found))


@HEIGHTS
def test_a_wider_base_never_worsens_the_verdict(tmp_path, base):
    assert rises([judged(tmp_path, thickness=each, base=base) for each in (0.4, 0.5, 0.6, 0.8)])


@HEIGHTS
def test_a_weaker_action_never_worsens_the_verdict(tmp_path, base):
    assert rises([judged(tmp_path, pga=each, base=base) for each in (0.4, 0.3, 0.2, 0.1)])


@pytest.mark.parametrize("more", ["", PROOF])
@HEIGHTS
def test_more_ties_never_worsen_the_verdict(tmp_path, base, more):
    thrust = THRUST.format(base + 3.0)
    forces = [(), (2.0,), (2.0, 3.0), (2.0, 3.0, 8.0)]
    assert rises([judged(tmp_path, base=base, loads=(thrust, *(tie(f, base, more=more) for f in fs))) for fs in forces])


def test_a_tie_not_shown_to_last_never_makes_a_wall_pass(tmp_path):
    """Three per cent of the weight as a tie held a wall for ever; now it leaves d0* where it was."""
    bare = judged(tmp_path, pga=0.8)
    tied = judged(tmp_path, pga=0.8, loads=(tie(2.4, 0.0),))
    assert (bare[0], tied[0]) == (0, 0)
    assert tied[1] == pytest.approx(bare[1], rel=1e-9)
