"""The project of docs/mechanisms.md is read, and does what the lines beside it say."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from assess.project.build import build
from assess.project.project_file import load
from assess.study.study import Study

PAGE = Path(__file__).resolve().parents[2] / "docs" / "mechanisms.md"
BLOCKS = re.findall(r"```toml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
(TEXT,) = (block for block in BLOCKS if "[bodies]" in block)


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    path = tmp_path_factory.mktemp("mechanisms") / "project.toml"
    path.write_text(TEXT)
    return build(load(path))


def test_every_mechanism_is_read_and_nothing_is_doubtful(study: Study) -> None:
    assert [mechanism.name for mechanism in study.mechanisms] == re.findall(
        r"^\[mechanisms\.(\w+)\]", TEXT, re.MULTILINE
    )
    told = [notice.text for notice in study.messages if notice.key not in ("not-amplified", "confidence-factor")]
    assert all(text.startswith(("crack at", "hinges of")) for text in told), told


def test_the_crack_slopes_down_towards_the_direction(study: Study) -> None:
    crack = next(each for each in study.mechanisms if each.name == "crack")
    assert crack.negative is not None
    assert crack.positive.hinges[0][1] < 8.0 < crack.negative.hinges[0][1]
    (sweep,) = study.sweeps
    assert [case.value for case in sweep.cases] == [0.0, 20.0, 40.0]


def test_an_eccentricity_counts_towards_the_direction(study: Study) -> None:
    assert next(each for each in study.mechanisms if each.name == "held").positive.loads[0].at == (-0.1, 4.0)


def test_angles_of_joints_begin_at_the_springing_behind(study: Study) -> None:
    x = [at[0] for at in next(each for each in study.mechanisms if each.name == "arch").positive.hinges]
    assert x == sorted(x)
    assert x[0] < 0.0 < x[-1]
