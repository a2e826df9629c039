"""One history and one envelope asked for by plain data: the numbers of a run of a project."""

from __future__ import annotations

from math import isnan
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.oscillator import Oscillator, RockingBlock, plain_branch
from assess.study.envelopes import find_envelope
from assess.study.level_peaks import with_restitution_factor
from assess.study.response import respond, respond_at_worst_rebound
from assess.study.run import run_study
from assess.study.suites import motions_of
from records.errors import RecordError
from records.record import make_record
from tests.support.projects import EC8, block, project_toml, study_of, wall

PROJECT = project_toml(
    site={"spectrum": EC8},
    materials={"stone": {"density": 2000, "disintegration": "excluded"}},
    bodies={"wall": wall(length=4.0, height=4.5, material="stone")},
    mechanisms={"wall": block(sides="one", direction=[1, 0, 0])},
    records={"synthetic": {"count": 2, "duration": 12}},
    analysis={
        "levels": ["0.2 g", "0.4 g", "1.2 g"],
        "procedures": ["asce43-05-history"],
        "pulses": {
            "shape": "sine",
            "frequency": {"from": "1 Hz", "to": "4 Hz", "count": 3},
            "amplitude": {"from": "0 g", "to": "2 g", "count": 4},
        },
    },
)
BRANCH = plain_branch(RockingBlock(1.0, 2.0, 0.2, 16.0 / 3.0), restitution=0.9)
BLOCK = Oscillator(BRANCH, BRANCH, 1.0)


def test_the_same_numbers_as_from_a_run(tmp_path: Path) -> None:
    study = study_of(tmp_path, PROJECT)
    (found,) = run_study(study, jobs=1).mechanisms
    assert study.spectrum is not None
    records = {each.record.id: each.record for each in motions_of(study, study.spectrum)}
    oscillator = study.mechanisms[0].variants.deciding
    assert {one.overturned for one in found.histories} == {True, False}
    for one in found.histories:
        body, scale = with_restitution_factor(oscillator, one.rebound), one.polarity * one.scale_factor
        motion = respond(body, records[one.record], scale=scale)
        assert (motion.overturned, motion.overturning_time) == (one.overturned, one.overturning_time_s)
        assert (motion.max_rotation, motion.time_of_max) == (one.max_rotation_rad, one.time_of_max_s)
        assert isnan(motion.max_ratio) if one.overturned else motion.max_ratio == one.max_rotation_ratio
        assert motion.impacts == one.impacts
        if one.trace is not None:
            assert tuple(motion.time) == one.trace.time_s
            assert tuple(motion.rotation) == one.trace.rotation_rad
    pulses = found.envelope
    assert pulses is not None
    amplitude = np.linspace(0.0, 2.0 * g, 4)
    made = find_envelope(oscillator, "sine", frequency=pulses.frequency_hz, amplitude=amplitude, threads=1)
    assert tuple(map(tuple, made.overturned.tolist())) == pulses.overturned
    assert tuple(None if np.isnan(b) else b for b in (made.lower_bound / g).tolist()) == pulses.lower_bound_g


def test_a_negative_scale_reverses_the_record() -> None:
    record = make_record("pulse", 2.4 * np.sin(np.linspace(0.0, 2.0 * np.pi, 101)), 0.01)
    one, other = respond(BLOCK, record), respond(BLOCK, record, scale=-1.0)
    assert one.max_rotation == pytest.approx(-(other.max_rotation or 0.0), rel=1e-12)
    assert one.max_ratio == other.max_ratio
    assert not one.time.flags.writeable


def test_a_motion_that_overturns_has_no_largest_rotation() -> None:
    record = make_record("pulse", 20.0 * np.sin(np.linspace(0.0, 2.0 * np.pi, 101)), 0.01)
    motion = respond(BLOCK, record)
    assert motion.overturned
    assert isnan(motion.max_ratio)
    assert (motion.max_rotation, motion.time_of_max) == (None, None)
    assert motion.overturning_time is not None
    assert motion.time.size == motion.rotation.size <= record.npts
    assert len(repr(motion)) < 200
    assert "\n" not in repr(motion)


def test_an_unknown_pulse_is_an_error_that_lists_the_known_ones() -> None:
    with pytest.raises(RecordError, match=r"'sin': no such shape; known are sine, cosine"):
        find_envelope(BLOCK, "sin", frequency=[1.0], amplitude=[1.0])


def test_of_several_rebounds_the_one_that_overturns_counts() -> None:
    record = make_record("four waves", 4.0 * np.sin(np.linspace(0.0, 8.0 * np.pi, 401)), 0.01)
    bodies = [with_restitution_factor(BLOCK, factor) for factor in (0.2, 1.0)]
    assert [respond(body, record).overturned for body in bodies] == [False, True]
    for order in ((0.2, 1.0), (1.0, 0.2)):
        worst = respond_at_worst_rebound(BLOCK, record, rebounds=order, scale=1.0, equation="exact")
        assert (worst.overturned, worst.rebound) == (True, 1.0)
