"""A bar that two mechanisms state is one in a sweep and in samples."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.loads.load import Tie
from assess.project.bars import bars_of, same_bar, with_bars
from assess.project.build import build
from assess.project.project_file import load
from assess.study.study import Study
from tests.unit.assess.project.test_retrofit import BAR, UPPER, facade

BOTH = ("[records]", f"{UPPER}[records]")
AREA = ("mechanisms", "facade", "loads", 0, "area")


def yields(study: Study) -> dict[str, float | None]:
    """The force at which the tie of each mechanism yields [N]."""
    return {
        mechanism.name: tie.yield_force
        for mechanism in study.mechanisms
        for tie in mechanism.positive.actions
        if isinstance(tie, Tie)
    }


def test_ends_tell_which_ties_are_one_bar(tmp_path: Path) -> None:
    content = load(facade(tmp_path, BOTH)).content
    (bar,) = bars_of(content)
    assert [tie.path for tie in bar] == [("mechanisms", name, "loads", 0) for name in ("facade", "upper")]
    assert [tie.mechanism for tie in bars_of(content, ("upper",))[0]] == ["upper", "facade"]
    upper = ("mechanisms", "upper", "loads", 0, "area")
    assert same_bar(AREA, content) == (upper,)
    assert with_bars({AREA: 2e-4}, content) == {AREA: 2e-4, upper: 2e-4}
    assert with_bars({AREA: 2e-4, upper: 3e-4}, content) == {AREA: 2e-4, upper: 3e-4}
    assert same_bar(("mechanisms", "facade", "sides"), content) == ()
    assert same_bar(("mechanisms", "facade", "loads", 7, "area"), content) == ()
    apart = load(facade(tmp_path / "apart", (BOTH[0], BOTH[1].replace("[-0.3, 0, 5.5]", "[-0.3, 0, 5.4]")))).content
    assert [len(each) for each in bars_of(apart)] == [1, 1]


def test_a_sweep_varies_it_in_both(tmp_path: Path) -> None:
    sweep = 'sweep = { key = "mechanisms.facade.loads[1].area", values = ["200 mm^2", "314 mm^2"] }'
    study = build(load(facade(tmp_path, (BOTH[0], f"{UPPER}[analysis]\n{sweep}\n[records]"))))
    (found,) = study.sweeps
    for case, area in zip(found.cases, (200e-6, 314e-6), strict=True):
        assert yields(case.study) == pytest.approx(dict.fromkeys(("facade", "upper"), area * 235e6))


def test_samples_draw_it_once_for_both(tmp_path: Path) -> None:
    scattered = BAR.replace('yield_stress = "235 MPa"', 'yield_stress = { mean = "235 MPa", cov = 0.08 }')
    uncertain = f"{UPPER.replace(BAR, scattered)}[analysis.uncertainty]\nsamples = 16\n[records]"
    study = build(load(facade(tmp_path, (BAR, scattered), (BOTH[0], uncertain))))
    assert study.sampling is not None
    (number,) = study.sampling.numbers
    assert number.mechanisms == ("facade", "upper")
    at = study.sampling.study_at([300e6])
    for name in ("facade", "upper"):
        assert yields(at(name))[name] == pytest.approx(314e-6 * 300e6)
