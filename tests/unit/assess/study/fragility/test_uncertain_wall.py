"""Each record with a wall of its own: rocking starts at b / h of the wall that the record meets."""

from __future__ import annotations

from dataclasses import replace
from math import log, sqrt
from pathlib import Path
from typing import Any

import pytest
from scipy.stats import lognorm

from assess.errors import ProjectError
from assess.results.fragility import MechanismFragility
from assess.study.fragility import run_fragility
from assess.study.fragility_runs import measure
from assess.study.study import FragilityQuestion, Stripe
from assess.study.uncertainty import sobol_points
from tests.support.motions import noise
from tests.support.projects import ASCE7, block, project_toml, study_of, wall

COV, HEIGHT, MEAN = 0.2, 3.0, 0.5
RECORDS = tuple(noise(seed, peak=3.0, npts=200) for seed in range(40))
UNCERTAIN = {"analysis": {"uncertainty": {"samples": 16}}}


def found(folder: Path, thickness: Any, tables: dict[str, Any], **question: Any) -> tuple[Any, MechanismFragility]:
    study = study_of(
        folder,
        project_toml(
            site={"spectrum": ASCE7},
            bodies={"wall": wall(thickness, height=HEIGHT)},
            mechanisms={"wall": block(direction=[1, 0, 0])},
            records={"synthetic": {"count": 1, "duration": 8}},
            **tables,
        ),
    )
    asked = FragilityQuestion(measures=(measure("pga"),), draws=100, **question)
    study = replace(study, records=RECORDS, artificial=None, fragility=asked)
    (one,) = run_fragility(study, jobs=1).mechanisms
    return study, one


def test_the_rocking_of_a_lognormal_thickness_is_lognormal(tmp_path: Path) -> None:
    study, one = found(tmp_path, {"mean": MEAN, "cov": COV}, UNCERTAIN, uncertain=True, samples=40)
    b = sqrt(log(1.0 + COV**2))
    probability = sobol_points(study.sampling, len(RECORDS))[:, 0]
    uplift = lognorm(b, scale=MEAN / sqrt(1.0 + COV**2)).ppf(probability) / HEIGHT
    rocking = next(each for each in one.curves if each.state.name == "rocking")
    for point in rocking.empirical:
        assert (point.records, point.reached) == (40, int((uplift < point.intensity).sum()))
    assert rocking.lognormal is not None
    assert rocking.lognormal.median == pytest.approx(MEAN / sqrt(1.0 + COV**2) / HEIGHT, rel=0.02)
    assert rocking.lognormal.dispersion == pytest.approx(b, rel=0.06)
    overturning = next(each for each in one.curves if each.state.name == "overturning")
    _, plain = found(tmp_path, MEAN, {}, samples=40)
    at_the_mean = next(each for each in plain.curves if each.state.name == "overturning")
    assert overturning.lognormal.dispersion > at_the_mean.lognormal.dispersion
    (told,) = (note for note in one.notes if note.key == "fragility-uncertain")
    assert str(told.values["keys"]) == "bodies.wall.box.thickness"
    assert "fragility-uncertain" not in {note.key for note in plain.notes}


def test_each_record_of_a_stripe_meets_its_wall(tmp_path: Path) -> None:
    stripes = tuple(Stripe(im, tuple(r.id for r in RECORDS[k::2])) for k, im in enumerate((0.14, 0.18)))
    study, one = found(
        tmp_path, {"mean": MEAN, "cov": COV}, UNCERTAIN, uncertain=True, method="stripes", stripes=stripes
    )
    probability = sobol_points(study.sampling, len(RECORDS))[:, 0]  # in the order of the stripes
    uplift = lognorm(sqrt(log(1.0 + COV**2)), scale=MEAN / sqrt(1.0 + COV**2)).ppf(probability) / HEIGHT
    rocking = next(each for each in one.curves if each.state.name == "rocking")
    assert [p.reached for p in rocking.empirical] == [
        int((uplift[:20] < 0.14).sum()),
        int((uplift[20:] < 0.18).sum()),
    ]


def test_without_a_number_that_is_sampled_there_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"uncertain: none is sampled; add \[analysis.uncertainty\]"):
        found(tmp_path, MEAN, {}, uncertain=True)
