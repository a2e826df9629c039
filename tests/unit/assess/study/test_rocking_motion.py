"""Where the blocks of a mechanism are as it moves: by its hinges, which stay where two blocks meet."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin
from pathlib import Path

import numpy as np
import pytest

from assess.dynamics.history import trace
from assess.errors import MechanismError
from assess.study.rocking_motion import BlockPlace, block_places, governing_motion
from assess.study.study import Study
from tests.support.motions import write_record
from tests.support.projects import NTC, block, project_toml, study_of

SKEW = np.array([0.6, 0.8, 0.0])
UP = np.array([0.0, 0.0, 1.0])


def rocking_study(folder: Path, **mechanism) -> Study:
    kind = mechanism.pop("kind", "single-block")
    site = {"spectrum": NTC, "limit_state": "SLV"}
    time = np.arange(0.0, 6.0, 0.01)
    write_record(folder / "sway.csv", time, mechanism.pop("shaken", 2.0) * np.sin(2.0 * pi * 0.8 * time))
    records = {"files": ["sway.csv"], "scale_to": "none"}
    mechanisms = {"wall": block(kind=kind, direction=[0.6, 0.8, 0], **mechanism)}
    return study_of(folder, project_toml(site=site, mechanisms=mechanisms, records=records))


def after(place: BlockPlace, point: np.ndarray) -> np.ndarray:
    return place.turn @ point + place.move


def by_quaternion(place: BlockPlace, point: np.ndarray) -> np.ndarray:
    """Rodrigues' formula: p + 2 w (q x p) + 2 q x (q x p)."""
    w, q = place.quaternion[0], np.array(place.quaternion[1:])
    return point + 2.0 * w * np.cross(q, point) + 2.0 * np.cross(q, np.cross(q, point)) + place.move


@pytest.mark.parametrize("rotation", [0.0, 1e-9, 0.1, -0.1, 0.7])
def test_a_block_turns_about_its_edge(tmp_path, rotation):
    """The corner above the hinge moves along a circle, outwards and down as it overturns."""
    (mechanism,) = rocking_study(tmp_path, sides="two").mechanisms
    chain = mechanism.positive if rotation >= 0.0 else mechanism.negative
    assert chain is not None
    sign = 1.0 if rotation >= 0.0 else -1.0
    hinge = sign * chain.hinges[0][0] * SKEW + chain.hinges[0][1] * UP + 0.3 * np.array([-0.8, 0.6, 0.0])
    (place,) = block_places(mechanism, rotation)
    assert after(place, hinge) == pytest.approx(hinge, abs=1e-12)
    top = hinge + 4.0 * UP
    assert after(place, top) == pytest.approx(hinge + 4.0 * (sin(rotation) * SKEW + cos(rotation) * UP), abs=1e-12)
    assert by_quaternion(place, top) == pytest.approx(after(place, top), abs=1e-12)


@pytest.mark.parametrize("rotation", [0.02, -0.02])
def test_two_blocks_stay_joined_and_their_top_on_the_upright(tmp_path, rotation):
    (mechanism,) = rocking_study(tmp_path, kind="two-block", sides="two", crack="2 m").mechanisms
    chain = mechanism.positive if rotation > 0.0 else mechanism.negative
    assert chain is not None
    sign = np.sign(rotation)
    hinges = [sign * x * SKEW + z * UP for x, z in chain.hinges]
    lower, upper = block_places(mechanism, rotation)
    assert after(lower, hinges[0]) == pytest.approx(hinges[0], abs=1e-12)
    assert after(lower, hinges[1]) == pytest.approx(after(upper, hinges[1]), abs=1e-12)
    moved = after(upper, hinges[2]) - hinges[2]
    assert moved[:2] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert (after(lower, hinges[1]) - hinges[1]) @ SKEW * sign > 0.0


def test_no_block_goes_beyond_its_side(tmp_path):
    (mechanism,) = rocking_study(tmp_path, sides="two").mechanisms
    (beyond,), (side,) = block_places(mechanism, 9.0), block_places(mechanism, pi / 2.0)
    assert np.array_equal(beyond.turn, side.turn)


def test_one_that_does_not_rock_back_has_no_place_there(tmp_path):
    (mechanism,) = rocking_study(tmp_path, sides="one").mechanisms
    with pytest.raises(MechanismError, match=r"no place at a rotation of -0\.1 rad"):
        block_places(mechanism, -0.1)


def test_what_governs_is_the_history_of_the_record_until_it_rests(tmp_path):
    """The same motion by the solver alone, of the record without what follows it."""
    study = rocking_study(tmp_path, sides="two", shaken=12.0)
    found = governing_motion(study)
    assert found is not None
    assert found.history.record == "sway"
    assert not found.history.overturned
    (mechanism,), (record,) = study.mechanisms, study.records
    scale = found.history.polarity * found.history.scale_factor
    alone = trace(mechanism.variants.of_histories[0], record, scale=scale, equation="exact")
    same = len(alone.time)
    assert found.trace.rotation_rad[:same] == pytest.approx(alone.rotation, abs=1e-12)
    assert found.record_end_s == pytest.approx(record.time[-1])
    peak = max(found.trace.rotation_rad, key=abs)
    assert abs(peak) / mechanism.oscillator.positive.overturning == pytest.approx(
        found.history.max_rotation_ratio, rel=0.02
    )  # at the samples
    assert found.rotation_at(found.duration) == 0.0
    assert record.time[-1] <= found.duration < record.time[-1] + 10.0
    assert found.ending == "at rest after"


def test_what_overturns_ends_there(tmp_path):
    found = governing_motion(rocking_study(tmp_path, sides="two", shaken=25.0))
    assert found is not None
    assert found.history.overturned
    assert found.duration == pytest.approx(found.trace.time_s[-1])
    assert abs(found.rotation_at(found.duration)) > 0.1
    assert found.ending == "overturned after"


def test_what_does_not_rock_is_said(tmp_path):
    found = governing_motion(rocking_study(tmp_path, sides="two", shaken=0.5))
    assert found is not None
    assert found.ending == "does not rock in"
    assert found.duration == found.record_end_s


def test_of_a_mechanism_without_histories_there_is_none(tmp_path):
    study = rocking_study(tmp_path, sides="two")
    (mechanism,) = study.mechanisms
    assert governing_motion(replace(study, mechanisms=(replace(mechanism, rocks=False),))) is None
