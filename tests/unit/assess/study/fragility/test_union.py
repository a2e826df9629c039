"""Several mechanisms under the same records, against enumeration and what must hold."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assess.results.fragility import FragilityResults
from assess.results.json import dumps_fragility, loads_fragility
from assess.study.fragility import run_fragility
from assess.study.fragility_runs import measure
from assess.study.study import FragilityQuestion, Stripe
from tests.support.motions import noise
from tests.support.projects import ASCE7, published, study_of, tables_toml

RECORDS = tuple(noise(seed, peak=4.0, npts=400) for seed in range(24))
SLENDER, STOCKY, OTHER = (
    published(p, uplift, restitution=0.9) for p, uplift in ((2.2, 0.12), (1.6, 0.17), (2.8, 0.15))
)
PGA = (measure("pga"),)


def results(folder: Path, mechanisms: dict[str, Any], moving: dict[str, tuple[str, ...]], **question: Any) -> Any:
    plain = {"site": {"spectrum": ASCE7}, "records": {"synthetic": {"count": 1, "duration": 8}}}
    study = study_of(folder, tables_toml(mechanisms=mechanisms, **plain))
    asked = FragilityQuestion(measures=PGA, draws=100, **question)
    return run_fragility(replace(study, records=RECORDS, artificial=None, moving=moving, fragility=asked), jobs=1)


def overturning(found: FragilityResults, name: str):
    (one,) = (each for each in found.mechanisms if each.name == name)
    return one, next(each for each in one.curves if each.state.name == "overturning")


def test_of_stripes_the_union_is_the_enumeration(tmp_path: Path) -> None:
    levels = (0.3, 0.45, 0.6, 0.8)
    stripes = tuple(Stripe(im, tuple(each.id for each in RECORDS[k::4])) for k, im in enumerate(levels))
    mechanisms = {"a": SLENDER, "b": STOCKY, "c": OTHER}
    found = results(tmp_path, mechanisms, {}, method="stripes", stripes=stripes)
    falls = {
        each.name: {run.record: run.ratio[0] is None for run in each.runs} for each in found.mechanisms
    }  # fmt: skip
    union = found.union
    assert union is not None
    assert (union.mechanisms, union.left_out) == (("a", "b", "c"), ())
    for k, (point, independent) in enumerate(zip(union.curve.empirical, union.if_independent, strict=True)):
        own = [each.id for each in RECORDS[k::4]]
        assert point.intensity == levels[k]
        assert (point.records, point.reached) == (6, sum(any(falls[name][each] for name in falls) for each in own))
        alone = [np.mean([falls[name][each] for each in own]) for name in falls]
        assert independent == pytest.approx(1.0 - np.prod(1.0 - np.array(alone)), rel=1e-12)
        assert max(alone) <= point.share <= sum(alone)
    assert loads_fragility(dumps_fragility(found)) == found


def test_a_mechanism_beside_itself_is_itself(tmp_path: Path) -> None:
    """The same histories: nothing is added, though independent ones would add."""
    found = results(tmp_path, {"a": SLENDER, "b": SLENDER}, {}, samples=15)
    _, alone = overturning(found, "a")
    assert found.union.curve == alone
    for point, independent in zip(alone.empirical, found.union.if_independent, strict=True):
        assert independent == pytest.approx(1.0 - (1.0 - point.share) ** 2, abs=1e-12)


def test_at_rising_scales_the_union_lies_between_the_most_likely_and_the_sum(tmp_path: Path) -> None:
    found = results(tmp_path, {"a": SLENDER, "b": STOCKY, "c": OTHER}, {}, samples=40)
    union = found.union
    (_, a), (_, b), (_, c) = (overturning(found, name) for name in "abc")
    medians = [each.lognormal.median for each in (a, b, c)]
    assert union.curve.lognormal.median < 1.02 * min(medians)
    assert union.curve.censored <= min(each.censored for each in (a, b, c))
    shares = np.array([point.share for point in union.curve.empirical])
    at = np.log([point.intensity for point in union.curve.empirical])
    for each in (a, b, c):
        own = np.interp(at, np.log([p.intensity for p in each.empirical]), [p.share for p in each.empirical])
        assert (shares >= own - 2.0 / len(RECORDS)).all()  # a record turns within a step of the intensities


def test_of_mechanisms_that_share_a_body_the_one_that_overturns_most_counts(tmp_path: Path) -> None:
    moving = {"a": ("front", "gable"), "b": ("front",), "c": ("side",)}
    found = results(tmp_path, {"a": STOCKY, "b": SLENDER, "c": OTHER}, moving, samples=15)
    assert (found.union.mechanisms, found.union.left_out) == (("b", "c"), ("a",))
    alone = results(tmp_path, {"a": STOCKY, "b": SLENDER}, moving, samples=15)
    assert alone.union is None


def test_a_cloud_has_a_union_too(tmp_path: Path) -> None:
    found = results(tmp_path, {"a": SLENDER, "b": STOCKY}, {}, method="cloud")
    (a, _), (b, _) = overturning(found, "a"), overturning(found, "b")
    either = sum(None in (one.ratio[0], other.ratio[0]) for one, other in zip(a.runs, b.runs, strict=True))
    assert sum(point.reached for point in found.union.curve.empirical) == either
