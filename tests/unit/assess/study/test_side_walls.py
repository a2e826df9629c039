"""Side walls in a project: what counts by whom, with a source and without, and where the direction changes."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from assess.codes.check import Check
from assess.codes.verdict import Decision, State
from assess.dynamics.history import Jobs, make_solver
from assess.errors import ProjectError
from assess.project.build import build, build_to_decide
from assess.project.project_file import load
from assess.results import Results
from assess.study.histories import rocking_oscillators
from assess.study.run import run_study
from tests.support.motions import noise
from tests.support.projects import NTC, block, lines, project_toml, wall

TOOTHED = 'side_walls = { bond = "toothed", course = "0.25 m", overlap = "0.15 m", thickness = "0.5 m", count = 2 }'
SURVEY = {"mechanisms.wall.side_walls": "measured: joint opened at three heights"}
METHODS = ("ntc2018-linear", "ntc2018-nonlinear", "dmi2008-linear", "asce43-05-spectrum")


def results(
    folder: Path,
    side_walls: str = "",
    *,
    sources: dict[str, str] | None = None,
    direction=(1, 0, 0),
    length: float = 5.0,
    methods: Sequence[str] = METHODS,
    records: dict[str, object] | None = None,
    a_g: str = "0.13 g",
) -> Results:
    text = project_toml(
        site={"spectrum": {**NTC, "a_g": a_g}, "limit_state": "SLV"},
        building={"height": 6.0, "storeys": 2, "use_class": "II"},
        materials={"m": {"density": 1900, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey", **(sources or {})}},
        verdict={"basis": "ntc2018", "procedures": ["ntc2018-linear"]},
        analysis={"procedures": list(methods), "equation": "exact", "scan": False},
        records=records,
        bodies={"wall": wall(0.5, length, 6.0, material="m")},
        mechanisms={"wall": lines(block(direction=list(direction), sides="one"), side_walls)},
    )
    (folder / "project.toml").write_text(text, encoding="utf-8")
    return run_study(build(load(folder)), jobs=1)


def checks_of(found: Results) -> dict[str, Check]:
    return {check.procedure: check for check in found.mechanisms[0].checks}


def test_without_a_source_none_of_their_friction_counts(tmp_path: Path) -> None:
    bare, typed = results(tmp_path), results(tmp_path, TOOTHED)
    assert bare.verdict is not None
    assert typed.verdict is not None
    (line,) = typed.verdict.overrides
    assert (typed.verdict.state, line.key, line.source) == (State.REPLACED, "mechanisms.wall.side_walls", "")
    assert line.instead == "no friction of side walls"
    assert typed.verdict.mechanisms == bare.verdict.mechanisms
    assert bare.verdict.outcome == Decision.FAIL
    assert typed.verdict.other_state is not None
    assert typed.verdict.other_state.outcome == Decision.PASS


def test_with_a_source_the_procedures_of_ntc2018_alone_count_it(tmp_path: Path) -> None:
    """α0 rises from 0.0833 to 0.2227; d0*, d_SLV and other codes stay."""
    bare, found = checks_of(results(tmp_path)), results(tmp_path, TOOTHED, sources=SURVEY)
    held = checks_of(found)
    linear, other = held["ntc2018-linear"], bare["ntc2018-linear"]
    assert linear.capacity / other.capacity == pytest.approx(0.222684 / (0.5 / 6.0), rel=1e-5)
    assert held["ntc2018-nonlinear"].capacity == pytest.approx(bare["ntc2018-nonlinear"].capacity, rel=1e-9)
    assert held["ntc2018-nonlinear"].demand < bare["ntc2018-nonlinear"].demand
    for name in ("dmi2008-linear", "asce43-05-spectrum"):
        assert (held[name].capacity, held[name].demand) == (bare[name].capacity, bare[name].demand)
    assert [each.key for each in linear.conditions][-1] == "side-walls-hold"
    assert [each.key for each in linear.remarks] == ["side-walls-part"]
    assert "counts-at-rest" not in [each.key for each in linear.conditions]
    assert "side-walls-where-counted" in [each.key for each in found.warnings]
    assert found.verdict is not None
    (line,) = found.verdict.overrides
    assert (found.verdict.outcome, line.outcome_instead) == (Decision.PASS, Decision.FAIL)
    assert {"F", "α_h", "M_F"} <= {each.symbol for each in linear.steps}
    assert "M_F(φ(d_SLV))" in {each.symbol for each in held["ntc2018-nonlinear"].steps}


def test_histories_have_it_where_the_wall_opens_farther_than_ever(tmp_path: Path) -> None:
    """Largest rotations fall, energy is balanced with the work of friction, and a pass says on what it hangs."""
    suite = {"synthetic": {"count": 3, "duration": "12 s", "seed": 1}, "scale_to": "none"}
    bare = results(tmp_path, sources=SURVEY, methods=("ntc2018-history",), records=suite, a_g="0.3 g")
    held = results(tmp_path, TOOTHED, sources=SURVEY, methods=("ntc2018-history",), records=suite, a_g="0.3 g")
    most = [max(each.max_rotation_ratio for each in found.mechanisms[0].histories) for found in (bare, held)]
    assert 0.0 < most[1] < 0.8 * most[0]
    (energy,) = (each for each in held.controls if each.kind == "energy" and each.mechanism == "wall")
    assert energy.difference < 2e-4  # the motion stops and goes on between two samples
    assert energy.value > 0.0
    conditions = {each.key for check in held.mechanisms[0].checks for each in check.conditions}
    assert "side-walls-hold" in conditions
    assert "side-walls-hold" not in {each.key for check in bare.mechanisms[0].checks for each in check.conditions}


def test_a_source_for_one_of_their_keys_vouches_for_none_of_the_others(tmp_path: Path) -> None:
    one = {"mechanisms.wall.side_walls.friction": "measured: tests of two joints"}
    found = results(tmp_path, TOOTHED, sources=one).verdict
    assert found is not None
    assert found.state == State.REPLACED


def test_side_walls_do_not_turn_with_the_direction(tmp_path: Path) -> None:
    """Towards its length the wall is stated; the weakest direction has none of the side walls that stand there."""
    results(tmp_path, TOOTHED, sources=SURVEY, direction=(0, 1, 0), length=1.5)
    study = build_to_decide(load(tmp_path / "project.toml"))
    (direction,) = [each for each in study.replaceables if each.key == "mechanisms.wall.direction"]
    assert {path[-1] for path in direction.setting} == {"direction", "side_walls"}
    assert direction.study_at("wall").mechanisms[0].toothing is None


def test_what_they_lack_is_told_with_its_key(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"mechanisms.wall.side_walls.course: missing; a toothed joint needs it"):
        results(tmp_path, 'side_walls = { bond = "toothed", overlap = "0.1 m", thickness = "0.5 m" }')
    with pytest.raises(ProjectError, match=r'side_walls.bond: .*write "toothed" or "detached"'):
        results(tmp_path, 'side_walls = { bond = "keyed" }')


def test_friction_and_ties_that_stretch_go_together_in_histories(tmp_path: Path) -> None:
    """A tie cuts its own kinks into the curve; friction is that of the wall without it."""
    bar = (
        'loads = [{ kind = "tie", force = "5 kN", at = [0, 0, 5.0], anchor = [-9, 0, 5.0], area = "113 mm^2", '
        'young_modulus = "210 GPa", yield_stress = "235 MPa", length = "9 m", fracture_strain = 0.1, '
        'strength = "90 kN" }]'
    )
    suite = {"synthetic": {"count": 2, "duration": "10 s", "seed": 1}, "scale_to": "none"}
    sources = {**SURVEY, "mechanisms.wall.loads[1]": "measured: certificate"}
    found = results(
        tmp_path, f"{TOOTHED}\n{bar}", sources=sources, methods=("ntc2018-history",), records=suite, a_g="0.3 g"
    )
    assert all(each.max_rotation_ratio < 1.0 for each in found.mechanisms[0].histories)


def test_leaving_friction_out_of_histories_is_safe_for_a_suite_and_not_for_each_record(tmp_path: Path) -> None:
    """Joints that deform leave it out: of 600 runs many overturn only without it, and a few only with it."""
    results(tmp_path, TOOTHED, sources=SURVEY, methods=("ntc2018-linear",))
    mechanism = build(load(tmp_path)).mechanisms[0]
    (held,), (bare,) = rocking_oscillators(mechanism, "exact"), rocking_oscillators(mechanism, "linearised")
    assert held.memory is not None
    assert bare.memory is None
    motions = [noise(seed, peak=1.0, npts=1000, dt=0.01, smooth=25, bell=2.0) for seed in range(40)]
    scales = np.linspace(1.5, 6.0, 15)
    oscillator, motion, scale = (each.ravel() for each in np.meshgrid([0, 1], range(40), scales, indexing="ij"))
    jobs = Jobs(oscillator.astype(np.int64), motion.astype(np.int64), scale)
    with_friction, without = make_solver([held, bare], motions, equation="exact")(jobs).overturned.reshape(2, 40, 15)
    only_without, only_with = (without & ~with_friction).sum(), (with_friction & ~without).sum()
    assert only_without > 10 * only_with > 0
