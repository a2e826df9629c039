"""Records whose step is too coarse for a mechanism are told by name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assess.oscillator import elastic_frequency
from assess.study.envelopes import EnvelopeCase, coarse_record_messages, longest_step
from assess.study.study import ScaledRecord
from records.record import make_record
from records.scaling import Scaling
from tests.support.blocks import tabulated_block
from tests.support.motions import write_record
from tests.support.projects import ASCE7, block, project_toml, results_of, wall

PROJECT = project_toml(
    site={"spectrum": ASCE7 | {"s_ds": "0.3 g", "s_d1": "0.1 g"}},
    materials={"m": {"density": 2000}},
    bodies={"w": wall(0.6, 4.0, 4.5, material="m")},
    mechanisms={
        "on joints": block("w", interface={"model": "flexible", "stiffness": "10 GPa/m", "strength": "2 MPa"}),
        "rigid": block("w"),
    },
    records={"files": ["motion.csv"], "scale_to": "none"},
    analysis={"procedures": ["asce43-05-spectrum"]},
)


def notices(p: float, *steps: float) -> list[str]:
    rocker = EnvelopeCase("tower", tabulated_block(p), "exact", np.ones_like)
    motions = [ScaledRecord(make_record(f"r{k}", [0, 1, 0], dt), Scaling(1.0, 0.0)) for k, dt in enumerate(steps)]
    return [f"{n.key} {n.where} {n.text}" for n in coarse_record_messages([rocker], motions)]


def test_ten_samples_within_1_over_p() -> None:
    assert longest_step(tabulated_block(2.5), equation="exact")[0] == pytest.approx(0.04, rel=1e-6)
    assert notices(2.0, 0.005, 0.02, 0.0499) == []
    (text,) = notices(2.0, 0.005, 0.06, 0.02)
    assert text.startswith("coarse-record mechanisms.tower ")
    for words in ("r1 (0.06 s)", "p = 2 1/s", "0.05 s or less"):
        assert words in text
    assert "r0" not in text
    assert "r2" not in text


def test_many_are_counted() -> None:
    (text,) = notices(2.0, *[0.1] * 9)
    assert "r0 (0.1 s), r1 (0.1 s), r2 (0.1 s), … is too coarse" in text


@pytest.mark.parametrize(("dt", "coarse"), [(0.025, True), (0.005, False)])
def test_a_run_tells_which_mechanism_record_and_step(tmp_path: Path, dt: float, coarse: bool) -> None:
    """Six samples in a period of the wall on its joints, which the rigid wall does not need; or thirty."""
    time = np.arange(0.0, 6.0, dt)
    write_record(tmp_path / "motion.csv", time, np.sin(4.0 * time))
    told = [notice for notice in results_of(tmp_path, PROJECT).warnings if notice.key == "coarse-record"]
    assert [notice.where for notice in told] == ["mechanisms.on joints"] * coarse
    assert all("motion (0.025 s)" in notice.text and "elastic vibration" in notice.text for notice in told)


def test_a_plain_block_does_not_vibrate() -> None:
    assert elastic_frequency(tabulated_block(2.0).positive) is None
