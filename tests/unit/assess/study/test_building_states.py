"""Histories upstairs run through the building as it softens: the motions by scipy, and the worst of the checks."""

from __future__ import annotations

import copy
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.signal import lsim

from assess.amplification import FirstMode, ModalFilter, base_motion
from assess.codes.check import ELASTIC, BuildingState, Check, Outcome
from assess.codes.context import Context, StatedFirstMode
from assess.codes.procedures import PROCEDURES
from assess.project.build import build_to_decide
from assess.project.project_file import load_tree
from assess.study.assessment import MechanismCheck, building_states, check_mechanism, on_building
from assess.study.histories import RockingHistories, run_levels
from assess.study.histories import further_levels as levels_of_rules
from assess.study.level_peaks import RockingCase
from assess.study.study import ScaledRecord, Study, require_spectrum
from assess.study.suites import motions_of, suite_faults
from tools.adversary.projects import HISTORIES

FREQUENCY, EFFECTIVE_HEIGHT = 4.2, 5.3  # Hz, m: of the project


@cache
def _upstairs() -> tuple[Study, tuple[ScaledRecord, ...]]:
    tables = copy.deepcopy(HISTORIES["own-histories-upstairs"])
    study = build_to_decide(load_tree(tables, Path("project.toml"), sha256=""))
    motions = motions_of(study, require_spectrum(study))
    faults = suite_faults(study, require_spectrum(study), motions)
    return replace(study, suite_faults=faults, procedures=("ntc2018-history",)), motions


def _checked(study: Study) -> MechanismCheck:
    (mechanism,), spectrum, motions = study.mechanisms, require_spectrum(study), _upstairs()[1]

    def run(there: Study, case: RockingCase, context: Context) -> RockingHistories:
        further = levels_of_rules(there, spectrum, mechanism)
        return run_levels(
            case, motions, levels=there.levels, further=further, site_pga=spectrum.pga, threads=1, with_twins=False
        )

    return check_mechanism(study, spectrum, mechanism, motions, run)


def test_the_building_softens_to_twice_its_period() -> None:
    states = building_states(_upstairs()[0], "wall")
    assert [state.period_ratio for state in states] == [1.0, 1.25, 1.5, 1.75, 2.0]
    assert [state.damping for state in states] == [None, 0.10, 0.10, 0.10, 0.10]


@pytest.mark.parametrize("place", range(5))
def test_the_motion_of_each_state_against_scipy(place: int) -> None:
    """u'' + 2 xi w u' + w^2 u = -a_g by scipy's linear simulation, and a_g + u'' h / h_e at the height."""
    study, motions = _upstairs()
    states = building_states(study, "wall")
    state = states[place]
    there = on_building(study, "wall", state, among=states).amplified["wall"].amplification
    assert isinstance(there, ModalFilter)
    found = base_motion(there, motions[0].record).record
    w, xi = 2.0 * np.pi * FREQUENCY / state.period_ratio, state.damping or 0.05
    time = found.dt * np.arange(found.npts)
    ground = np.interp(time, motions[0].record.time, motions[0].record.acceleration, right=0.0)
    system = ([[0.0, 1.0], [-w * w, -2.0 * xi * w]], [[0.0], [-1.0]], [[-w * w, -2.0 * xi * w]], [[-1.0]])
    _, relative, _ = lsim(system, ground, time)
    expected = ground + there.height / EFFECTIVE_HEIGHT * relative
    inside = time <= motions[0].record.time[-1]
    assert found.acceleration[inside] == pytest.approx(expected[inside], abs=1e-6 * np.abs(expected).max())
    elastic = on_building(study, "wall", ELASTIC, among=states).amplified["wall"].amplification
    assert found.dt == base_motion(elastic, motions[0].record).record.dt


def test_of_the_states_the_worst_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    study, _ = _upstairs()
    merged = _checked(study)
    amplified = study.amplified["wall"]
    assert isinstance(amplified.amplification, ModalFilter)
    alone: list[tuple[Check, ...]] = []
    states = building_states(study, "wall")
    monkeypatch.setitem(PROCEDURES, "ntc2018-history", replace(PROCEDURES["ntc2018-history"], buildings=(ELASTIC,)))
    for state in states:
        mode = FirstMode(FREQUENCY / state.period_ratio, EFFECTIVE_HEIGHT, state.damping or 0.05)
        there = replace(amplified, amplification=ModalFilter(mode, amplified.amplification.height, FREQUENCY))
        alone.append(_checked(replace(study, amplified={**study.amplified, "wall": there})).checks)
    for check, *each in zip(merged.checks, *alone, strict=True):
        outcomes = [one.verdict for one in each]
        assert check.verdict == (Outcome.FAIL if Outcome.FAIL in outcomes else outcomes[0])
        ratios = [np.inf if one.ratio is None else one.ratio for one in each]
        assert (np.inf if check.ratio is None else check.ratio) == pytest.approx(max(ratios), rel=1e-9)
        assert [step.symbol for step in check.steps[:2]] == ["T_1'", "ξ_1"]


def test_a_period_stated_for_a_limit_state_stands_for_the_range() -> None:
    study, _ = _upstairs()
    assert study.building is not None
    stated = StatedFirstMode(period=1.6 * study.building.period, damping=0.12, reason="push-over of the building")
    states = building_states(replace(study, building=replace(study.building, limit_states={"SLV": stated})), "wall")
    assert states[-1] == BuildingState(pytest.approx(1.6), 0.12)  # type: ignore[arg-type]
    assert ELASTIC in states
