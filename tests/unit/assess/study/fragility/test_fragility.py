"""Fragility through the whole chain: an oracle in closed form, invariances, and what is counted."""

from dataclasses import replace
from functools import cache
from math import exp, pi, tan
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import quad
from scipy.optimize import brentq, minimize
from scipy.stats import binom, norm

from assess.dynamics.history import Jobs, make_solver
from assess.errors import ProjectError
from assess.results.fragility import FragilityCurve, FragilityResults, HazardResult, MechanismFragility, RiskResult
from assess.results.json import dumps_fragility, loads_fragility
from assess.risk.estimates import EmpiricalCurve
from assess.study.fragility import run_fragility
from assess.study.fragility_runs import measure
from assess.study.study import FragilityQuestion, Stripe, Study
from records.record import Record, make_record
from tests.support.motions import noise
from tests.support.projects import ASCE7, NTC, published, study_of, tables_toml

P, UPLIFT = 1.2, 0.2
PLAIN = {"site": {"spectrum": ASCE7}, "records": {"synthetic": {"count": 1, "duration": 8}}}


def study_with(folder: Path, records: tuple[Record, ...], mechanism: dict | None = None, **question: object) -> Study:
    """A study of one block under these records."""
    block = mechanism or published(P, UPLIFT, restitution=0.5)
    study = study_of(folder, tables_toml(mechanisms={"block": block}, **PLAIN))
    return replace(study, records=records, artificial=None, fragility=FragilityQuestion(**question))


def curve(results: FragilityResults, key: str = "pga", state: str = "overturning") -> FragilityCurve:
    (found,) = (
        each for each in results.mechanisms[0].curves
        if each.measure.key == key and each.state.name == state and each.measure.at == "ground"
    )  # fmt: skip
    return found


def half_sine(duration: float, place: int, *, npts: int = 400) -> Record:
    """A half sine of 1 m/s2, followed by stillness."""
    t = np.linspace(0.0, 1.0, npts)
    return make_record(f"pulse {place}", np.r_[np.sin(pi * t), 0.0, 0.0], duration / (npts - 1))


def least_peak(duration: float) -> float:
    """The peak [m/s2] of the half sine that just overturns the linearised block.

    z = phi' + p phi - p phi_ov grows as exp(p t) once the pulse is over, from -p phi_ov as the block lifts off at t_0:
    it overturns where the integral of exp(-p (t - t_0)) a(t) exceeds lambda g / p.
    """

    def left(peak: float) -> float:
        start = duration / pi * np.arcsin(UPLIFT * g / peak)
        pushed = quad(lambda t: exp(-P * (t - start)) * peak * np.sin(pi * t / duration), start, duration)[0]
        return float(pushed - UPLIFT * g / P)

    return float(brentq(left, 1.001 * UPLIFT * g, 1e4 * g))


COUNT, SCATTER = 60, 0.4
DURATIONS = 0.12 * np.exp(SCATTER * norm.ppf((np.arange(COUNT) + 0.5) / COUNT))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("fragility")


@pytest.fixture(scope="module")
def pulses(folder: Path) -> FragilityResults:
    pulses = tuple(half_sine(duration, place) for place, duration in enumerate(DURATIONS))
    return run_fragility(study_with(folder, pulses, largest_factor=1000.0, draws=100), jobs=1)


def test_an_oracle_in_closed_form(pulses: FragilityResults) -> None:
    """Half sines of lognormal duration: the peak that overturns is known for each, and nearly lognormal."""
    exact = np.log([least_peak(duration) / g for duration in DURATIONS])
    found = curve(pulses)
    assert found.first is not None
    assert found.lognormal is not None
    for fitted in (found.first, found.lognormal):
        assert fitted.median == pytest.approx(exp(exact.mean()), rel=0.01)
        assert fitted.dispersion == pytest.approx(exact.std(), abs=0.015)
        assert fitted.median_interval is not None
        assert fitted.median_interval[0] < exp(exact.mean()) < fitted.median_interval[1]
    assert found.censored == 0
    shares = np.array([point.share for point in found.empirical])
    at = np.array([point.intensity for point in found.empirical])
    np.testing.assert_allclose(shares, [(exact < np.log(one)).mean() for one in at], atol=1.5 / COUNT)


def test_the_impulse_explains_short_pulses(pulses: FragilityResults) -> None:
    """Short pulses overturn by their impulse alone, at p PGV = g tan alpha but for p D (Housner 1963)."""
    by_impulse = {
        each.measure.key: each for each in pulses.mechanisms[0].comparison if each.state.name == "overturning"
    }
    assert by_impulse["pgv"].dispersion < 0.3 * by_impulse["pga"].dispersion
    assert curve(pulses, "p pgv/(g tan alpha)").first.median == pytest.approx(1.0, abs=0.12)


def test_dimensionless_measures_are_the_same_curves(pulses: FragilityResults) -> None:
    one = pulses.mechanisms[0]
    for plain, by, factor in (
        ("pga", "pga/(g tan alpha)", 1.0 / tan(one.slenderness_rad)),
        ("pgv", "p pgv/(g tan alpha)", one.p_eq_per_s / (g * tan(one.slenderness_rad))),
    ):
        first, second = curve(pulses, plain), curve(pulses, by)
        assert second.lognormal.median == pytest.approx(factor * first.lognormal.median, rel=1e-6)
        assert second.lognormal.dispersion == pytest.approx(first.lognormal.dispersion, rel=1e-6)


def test_a_block_rocks_at_its_uplift_acceleration(pulses: FragilityResults) -> None:
    """No scatter: no lognormal, and the reason; the share steps at lambda."""
    found = curve(pulses, state="rocking")
    assert found.lognormal is None
    assert [note.key for note in found.notes] == ["fragility-separated"]
    assert {point.share for point in found.empirical if point.intensity < UPLIFT} == {0.0}
    assert {point.share for point in found.empirical if point.intensity > UPLIFT} == {1.0}


NOISES = tuple(noise(seed, npts=700, bell=1.0) for seed in range(12))
ONE_SIDED = published(2.0, 0.15, sides="one", restitution=0.4)


class Epistemic(dict[str, float]):
    """Dispersions by name that a cache can tell apart."""

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(tuple(self.items()))


SMALL = Epistemic({"model": 0.01})


@cache
def noise_results(folder: Path, jobs: int = 1, factor: float = 1.0, mechanism: str = "two", **more: object):
    records = tuple(replace(each, acceleration=factor * each.acceleration) for each in NOISES)
    block = published(2.0, 0.15, restitution=0.9) if mechanism == "two" else ONE_SIDED
    question = {"samples": 30, "draws": 40, "largest_factor": 100.0} | more
    return run_fragility(study_with(folder, records, block, **question), jobs=jobs)


def test_results_do_not_depend_on_jobs(folder: Path) -> None:
    one, two = (dumps_fragility(noise_results(folder, jobs)) for jobs in (1, 2))
    assert one == two
    assert loads_fragility(one) == noise_results(folder)


def test_records_twice_as_strong_have_the_same_curves(folder: Path) -> None:
    """Intensities are those of the scaled motion, whatever it is scaled from."""
    once, twice = noise_results(folder), noise_results(folder, factor=2.0)
    for one, two in zip(once.mechanisms[0].curves, twice.mechanisms[0].curves, strict=True):
        assert [point.share for point in one.empirical] == [point.share for point in two.empirical]
        for first, second in ((one.lognormal, two.lognormal), (one.first, two.first)):
            assert (first is None) == (second is None)
            if first is not None:
                assert first.median == pytest.approx(second.median, rel=1e-6)
                assert first.dispersion == pytest.approx(second.dispersion, rel=1e-6)
    assert twice.mechanisms[0].runs[0].scale[0] == once.mechanisms[0].runs[0].scale[0] / 2


@pytest.mark.parametrize("mechanism", ["two", "one"])
def test_the_polarity_of_records_does_not_matter(folder: Path, mechanism: str) -> None:
    plain, reversed_ = (noise_results(folder, factor=sign, mechanism=mechanism) for sign in (1.0, -1.0))
    assert plain.mechanisms == reversed_.mechanisms


def test_stripes_are_runs_of_the_primary_measure(folder: Path) -> None:
    whole = noise_results(folder)
    found = noise_results(folder, method="stripes")
    assert {each.measure.key for each in found.mechanisms[0].curves} == {"pga"}
    assert curve(found).empirical == curve(whole).empirical


def test_a_cloud_runs_each_record_once(folder: Path) -> None:
    found = noise_results(folder, method="cloud", factor=0.6)
    assert {len(each.scale) for each in found.mechanisms[0].runs} == {1}
    overturned = sum(each.ratio == (None,) for each in found.mechanisms[0].runs)
    assert sum(point.reached for point in curve(found).empirical) == overturned
    assert sum(point.records for point in curve(found).empirical) == len(NOISES)
    assert curve(found).censored == len(NOISES) - overturned
    assert curve(found).first is None


def test_the_rate_of_a_cloud_is_that_of_its_lognormal(folder: Path) -> None:
    """Its few shares, held where no record is, would make frequent weak motions overturn the block."""
    plain = noise_results(folder, method="cloud", factor=0.8).mechanisms[0]
    fitted = next(each for each in plain.curves if each.state.name == "overturning" and each.lognormal is not None)
    at = np.geomspace(0.001, 30.0, 60)
    hazard = HazardResult(fitted.measure, "rows", tuple(at), tuple(1e-4 * at**-2.0))
    found = noise_results(folder, method="cloud", factor=0.8, hazard=hazard).mechanisms[0]
    (risk,) = (each for each in found.risks if each.state.name == "overturning")
    exact = 1e-4 * fitted.lognormal.median**-2.0 * exp(2.0 * fitted.lognormal.dispersion**2)
    assert (risk.curve, risk.annual_rate) == ("lognormal", pytest.approx(exact, rel=1e-3))


def test_records_that_stand_at_their_largest_scale_are_censored(folder: Path) -> None:
    """They stay among the records, and the first exceedance moves little where they are many."""
    few = noise_results(folder, factor=0.5, largest_factor=1.3)
    found, whole = curve(few), curve(noise_results(folder))
    assert 0 < found.censored < found.records == len(NOISES)
    standing = sum(each.ratio[-1] is not None for each in few.mechanisms[0].runs)
    assert found.censored == standing
    assert max(each.scale[-1] for each in few.mechanisms[0].runs) <= 1.3 * (1 + 1e-9)
    assert found.first.median == pytest.approx(whole.first.median, rel=0.15)


def test_a_record_too_weak_for_any_level_is_kept(folder: Path) -> None:
    weak = replace(NOISES[0], id="weak", acceleration=1e-4 * NOISES[0].acceleration)
    study = study_with(folder, (*NOISES, weak), published(2.0, 0.15), samples=20, draws=100)
    found = run_fragility(study, jobs=1)
    assert curve(found).records == len(NOISES) + 1
    assert curve(found).censored >= 1
    assert found.mechanisms[0].runs[-1].scale == (10.0,)
    assert max(point.intensity / curve(found, "pgv").empirical[0].intensity
               for point in curve(found, "pgv").empirical) < 100  # it does not stretch the axis  # fmt: skip


def test_scale_factors_above_four_are_counted(folder: Path) -> None:
    found = noise_results(folder, factor=0.125)
    counted = sum(scale > 4.0 for each in found.mechanisms[0].runs for scale in each.scale)
    assert curve(found).hollow == counted > 0
    assert sum(point.hollow for point in curve(found).empirical) == counted
    assert "fragility-hollow" in {note.key for note in found.mechanisms[0].notes}


def test_rows_of_hazard_give_rates(folder: Path) -> None:
    """A power law of hazard with the lognormal is Cornell's closed form."""
    k, k_0 = 2.5, 1e-4
    at = np.geomspace(1e-3, 50.0, 300)
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(k_0 * at**-k))
    found = noise_results(folder, hazard=hazard, target_rate=1e-4).mechanisms[0]
    fitted = curve(noise_results(folder)).lognormal
    risks = {each.curve: each for each in found.risks if each.state.name == "overturning"}
    exact = k_0 * fitted.median**-k * exp(0.5 * (k * fitted.dispersion) ** 2)
    assert risks["lognormal"].annual_rate == pytest.approx(exact, rel=1e-3)
    assert risks["lognormal"].probability_50_years == pytest.approx(1 - exp(-50 * exact), rel=1e-3)
    assert risks["empirical"].annual_rate <= risks["first"].annual_rate * 1.2
    for each in risks.values():
        assert sum(each.contribution) == pytest.approx(1.0)
        assert len(each.contribution) == 32
        assert np.ptp(np.diff(np.log(each.intensity))) == pytest.approx(0.0, abs=1e-9)
        assert each.target_rate == 1e-4


def test_epistemic_dispersion_stays_apart(folder: Path) -> None:
    at = np.geomspace(1e-3, 50.0, 300)
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(1e-4 * at**-2.0))
    plain = noise_results(folder, hazard=hazard).mechanisms[0]
    study = study_with(folder, NOISES, published(2.0, 0.15, restitution=0.9), samples=30, draws=40,
                       largest_factor=100.0, hazard=hazard, epistemic={"model": 0.3, "masonry": 0.4})  # fmt: skip
    found = run_fragility(study, jobs=1).mechanisms[0]
    assert (found.epistemic, found.epistemic_sources) == (pytest.approx(0.5), {"model": 0.3, "masonry": 0.4})
    assert found.curves == plain.curves
    for one, other in zip(found.risks, plain.risks, strict=True):
        assert one.annual_rate == other.annual_rate
        assert one.with_epistemic == pytest.approx(one.annual_rate * exp(0.5 * (2.0 * 0.5) ** 2), rel=1e-3)
        assert other.with_epistemic is None


def overturning(found: MechanismFragility, curve: str = "empirical") -> RiskResult:
    """The rate of overturning by one curve."""
    (risk,) = (each for each in found.risks if (each.state.name, each.curve) == ("overturning", curve))
    return risk


POWER_LAW = np.geomspace(1e-3, 50.0, 300)


@pytest.mark.parametrize(("method", "factor", "name"), [("ida", 1.0, "empirical"), ("cloud", 0.8, "lognormal")])
def test_a_target_is_compared_with_the_rate_that_has_the_epistemic_dispersion(
    folder: Path, method: str, factor: float, name: str
) -> None:
    """On k_0 im^-2 the dispersion of 0.5 multiplies a rate by exp(0.5): a target between the two is not met."""
    at = POWER_LAW
    plain = noise_results(folder, method=method, factor=factor).mechanisms[0]
    used = next(each.measure for each in plain.curves if each.state.name == "overturning" and each.lognormal)
    hazard = HazardResult(used, "rows", tuple(at), tuple(1e-4 * at**-2.0))
    asked = {"method": method, "factor": factor, "hazard": hazard}
    known, open_ = Epistemic({"model": 0.5}), Epistemic()
    bare = overturning(noise_results(folder, **asked).mechanisms[0], name).annual_rate
    for target, epistemic, outcome, gap in (
        (1.3 * bare, known, "fail", "epistemic"),
        (1.3 * bare, open_, "incomplete", "epistemic"),
        (100.0 * bare, known, "pass", None),
        (100.0 * bare, open_, "incomplete", "epistemic"),
        (0.9 * bare, open_, "fail", None),
        (100.0 * bare, Epistemic({"model": 0.0}), "pass", None),
    ):
        found = noise_results(folder, target_rate=target, epistemic=epistemic, **asked)
        risk = overturning(found.mechanisms[0], name)
        assert risk.annual_rate == pytest.approx(bare)
        assert risk.outcome == outcome
        assert gap is None or risk.gap == gap
        told = {note.key for note in (*found.warnings, *risk.notes)}
        assert ("fragility-no-epistemic" in told) == (epistemic == {})
        assert ("fragility-epistemic-above" in told) == (outcome == "fail" and epistemic != {})


def test_the_widened_curve_has_its_own_bounds_of_what_was_not_run(folder: Path) -> None:
    """Nothing overturns up to 0.2 g: every stronger motion might, and by the factor some of the weaker ones too."""
    at = POWER_LAW
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(1e-6 * at**-2.0))
    rate = 1e-6 * 0.2**-2.0  # of motions stronger than any run
    asked = {"hazard": hazard, "largest": 0.2, "samples": 5, "epistemic": Epistemic({"model": 0.5})}
    for factor, gap in ((1.5, "runs"), (2.0, None)):
        risk = overturning(noise_results(folder, target_rate=factor * rate, **asked).mechanisms[0])
        assert (risk.annual_rate, risk.with_epistemic) == (0.0, 0.0)
        assert risk.above_runs == pytest.approx(rate, rel=1e-3)
        assert risk.above_runs_with_epistemic == pytest.approx(rate * exp(0.5 * (2.0 * 0.5) ** 2), rel=1e-3)
        assert risk.gap == gap


def test_motions_weaker_than_the_weakest_record_of_a_cloud_are_told(folder: Path) -> None:
    """The share of the rate that rests on the tail of the curve below every record, of a hazard of weak motions."""
    plain = cloud_of(folder, 0.8)
    one = next(each for each in plain.curves if each.state.name == "overturning" and each.lognormal is not None)
    weakest = min(run.intensity[plain.measures.index(one.measure)] for run in plain.runs)
    assert one.least_run == pytest.approx(weakest)
    beta = one.lognormal.dispersion
    z = np.log(weakest / one.lognormal.median) / beta
    for k, start in ((1.0, 1e-6), (3.0, 1e-6), (1.0, 1.0)):
        at = np.geomspace(start * weakest, 1e6 * weakest, 200)
        hazard = HazardResult(one.measure, "rows", tuple(at), tuple(1e-4 * (at / weakest) ** -k))
        (risk,) = (each for each in cloud_of(folder, 0.8, hazard).risks if each.state.name == "overturning")
        share = norm.cdf(z + k * beta) - norm.cdf(z) * exp(-k * beta * (z + 0.5 * k * beta))  # by parts
        found = [note for note in risk.notes if note.key == "fragility-cloud-starts"]
        assert share > 0.05
        assert [each.values["share"].value for each in found] == (
            [] if start == 1.0 else [pytest.approx(share, rel=1e-3)]
        )


def test_the_ends_of_a_cloud_are_in_the_unit_of_each_measure(folder: Path) -> None:
    """PGA/(g tan alpha) is PGA by a factor: its curve is that of PGA, and so are its weakest and strongest record."""
    found = cloud_of(folder, 0.8)
    for each in found.curves:
        units = [run.intensity[found.measures.index(each.measure)] for run in found.runs]
        assert (each.least_run, each.largest_run) == (pytest.approx(min(units)), pytest.approx(max(units)))


def test_weak_motions_below_the_hazard_count_for_the_widened_curve(folder: Path) -> None:
    """The hazard begins where the counted curve is zero and the widened one is not: what it lacks is a bound."""
    plain = curve(noise_results(folder)).empirical
    first = next(point.intensity for point in plain if point.share > 0.0)
    at = np.geomspace(0.8 * first, 100.0 * first, 100)
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(1e-4 * (at / first) ** -2.0))
    asked = {"hazard": hazard, "epistemic": Epistemic({"model": 0.6})}
    risk = overturning(noise_results(folder, **asked).mechanisms[0])
    shares = EmpiricalCurve(np.array([each.intensity for each in plain]), np.array([each.share for each in plain]))
    below = quad(lambda u: float(shares.convolve(0.6).probability(first * np.exp(u))) * 2e-4 * np.exp(-2.0 * u),
                 np.log(0.8) - 20.0, np.log(0.8), epsrel=1e-10, limit=400)[0]  # fmt: skip
    assert risk.below_with_epistemic == pytest.approx(below, rel=1e-3)
    assert risk.below_with_epistemic > 10.0 * risk.below
    target = risk.with_epistemic + 0.5 * below
    risk = overturning(noise_results(folder, target_rate=target, **asked).mechanisms[0])
    assert (risk.outcome, risk.gap) == ("incomplete", "hazard")


def test_no_confidence_factor_enters(folder: Path) -> None:
    """Values are means: what a code divides by for lack of knowledge leaves fragility as it is."""
    found = []
    for level in ("LC1", "LC3"):
        text = tables_toml(
            site={"spectrum": NTC},
            materials={"brick": {"density": 1800, "compressive_strength": "2 MPa", "young_modulus": "1 GPa"}},
            bodies={"wall": {"material": "brick", "box": {"thickness": 0.6, "length": 3.0, "height": 4.0}}},
            mechanisms={"wall": {"kind": "single-block", "blocks": ["wall"],
                                 "interface": {"model": "rigid", "strength": "2 MPa"}}},
            procedures={"ntc2018": {"knowledge_level": level}},
            records={"synthetic": {"count": 1, "duration": 8}},
        )  # fmt: skip
        study = replace(study_of(folder, text), records=NOISES[:5], artificial=None)
        asked = FragilityQuestion(samples=10, draws=100)
        found.append(run_fragility(replace(study, fragility=asked), jobs=1))
    assert found[0].mechanisms == found[1].mechanisms
    assert "confidence-factor" not in {each.key for each in found[0].warnings}


def test_the_motion_at_the_base_is_a_measure_of_its_own(folder: Path) -> None:
    raised = published(2.0, 0.15, amplification={
        "method": "srss", "natural_frequency": "2.5 Hz", "effective_height": "6 m", "height": "6 m"})  # fmt: skip
    found = run_fragility(study_with(folder, NOISES, raised, samples=20, draws=100, largest_factor=50.0), jobs=1)
    one = found.mechanisms[0]
    assert [(each.key, each.at) for each in one.measures][:1] == [("pga", "ground")]
    assert {each.at for each in one.measures} == {"ground", "base"}
    place = [(each.key, each.at) for each in one.measures].index(("pga", "base"))
    assert all(each.intensity[place] > each.intensity[0] for each in one.runs)


def test_states_are_shares_of_the_rotation_that_overturns_on_the_joints_in_use(folder: Path) -> None:
    text = tables_toml(
        materials={"brick": {"density": 1800}},
        bodies={"wall": {"material": "brick", "box": {"thickness": 0.6, "length": 3.0, "height": 4.0}}},
        mechanisms={"wall": {"kind": "single-block", "blocks": ["wall"], "direction": [1, 0, 0], "interface": {
            "model": "flexible", "stiffness": "0.1 GPa/m", "strength": "0.5 MPa", "shape": "outline"}}},
        **PLAIN,
    )  # fmt: skip
    asked = FragilityQuestion(samples=10, draws=100, largest_factor=100.0)
    study = replace(study_of(folder, text), records=NOISES[:4], artificial=None, fragility=asked)
    (mechanism,) = run_fragility(study, jobs=1).mechanisms
    oscillator = study.mechanisms[0].variants.deciding
    branch, solve = oscillator.positive, make_solver([oscillator], NOISES[:4], equation="exact")
    assert branch.overturning_flexible < 0.9 * branch.overturning
    for place, each in enumerate(mechanism.runs):
        count = len(each.scale)
        found = solve(Jobs(np.zeros(count, dtype=int), np.full(count, place), np.array(each.scale)))
        shares = [None if over else abs(rotation) / branch.overturning_flexible
                  for rotation, over in zip(found.max_rotation, found.overturned, strict=True)]  # fmt: skip
        assert [one is None for one in each.ratio] == [one is None for one in shares]
        known = [pair for pair in zip(each.ratio, shares, strict=True) if pair[0] is not None]
        np.testing.assert_allclose(*zip(*known, strict=True), rtol=1e-9)


def test_few_and_artificial_records_are_told(folder: Path) -> None:
    text = tables_toml(mechanisms={"block": published(2.0, 0.15)}, **PLAIN)
    study = replace(study_of(folder, text), fragility=FragilityQuestion(samples=5, draws=100))
    assert {"fragility-few-records", "fragility-artificial"} <= {each.key for each in run_fragility(study).warnings}


def test_without_records_there_is_one_clear_line(folder: Path) -> None:
    with pytest.raises(ProjectError, match="records: none; give files"):
        run_fragility(study_with(folder, ()))


def test_a_target_is_met_only_with_what_the_hazard_leaves_out(folder: Path) -> None:
    """The hazard ends at 1e-4 a year: a rate below the target of 5e-5 within its rows shows nothing."""
    at = np.geomspace(1e-3, 0.1, 50)
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(1e-6 * at**-2.0))
    for target, outcome in ((5e-5, "incomplete"), (2e-3, "pass"), (1e-30, "fail"), (None, None)):
        (risk,) = (
            each
            for each in noise_results(folder, hazard=hazard, target_rate=target, epistemic=SMALL).mechanisms[0].risks
            if (each.state.name, each.curve) == ("overturning", "lognormal")
        )  # fmt: skip
        assert risk.beyond == pytest.approx(1e-4)
        assert risk.outcome == outcome


def test_motions_stronger_than_any_run_keep_a_target_open(folder: Path) -> None:
    """Run up to where nothing overturns, a rate of zero says nothing of the stronger motions of the hazard."""
    at = np.geomspace(1e-3, 50.0, 300)
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(1e-6 * at**-2.0))
    for factor, outcome, gap in ((0.5, "incomplete", "runs"), (2.0, "pass", None)):
        target = factor * 1e-6 * 0.2**-2.0  # of the rate with which the largest intensity run is exceeded
        found = noise_results(
            folder, hazard=hazard, target_rate=target, largest=0.2, samples=5, epistemic=SMALL
        ).mechanisms[0]
        (risk,) = (each for each in found.risks if (each.state.name, each.curve) == ("overturning", "empirical"))
        assert risk.annual_rate == 0.0
        assert risk.above_runs == pytest.approx(1e-6 * (0.2**-2.0 - 50.0**-2.0), rel=1e-5)
        assert (risk.outcome, risk.gap) == (outcome, gap)
        assert "fragility-runs-end" in {note.key for note in risk.notes}


@pytest.mark.parametrize(
    ("amplification", "told"),
    [
        ({"method": "none"}, "fragility-ground-motion"),
        ({"method": "srss", "natural_frequency": "2.5 Hz", "effective_height": "6 m", "height": "6 m"},
         "fragility-scalar-motion"),
        ({"method": "modal-filter", "natural_frequency": "2.5 Hz", "effective_height": "6 m", "height": "6 m"}, None),
    ],
)  # fmt: skip
def test_the_motion_of_the_ground_meets_no_target_upstairs(folder: Path, amplification: dict, told: str | None) -> None:
    text = tables_toml(
        site={"spectrum": NTC}, building={"height": "9 m", "storeys": 3},
        materials={"brick": {"density": 1800}},
        bodies={"wall": {"material": "brick",
                         "box": {"thickness": 0.6, "length": 3.0, "height": 4.0, "base": [0, 0, 5]}}},
        mechanisms={"wall": {"kind": "single-block", "blocks": ["wall"], "amplification": amplification}},
        records={"synthetic": {"count": 1, "duration": 8}},
    )  # fmt: skip
    at = np.geomspace(1e-3, 50.0, 300)
    hazard = HazardResult(measure("pga"), "rows", tuple(at), tuple(1e-6 * at**-2.0))
    asked = FragilityQuestion(samples=5, draws=100, hazard=hazard, target_rate=0.5, largest_factor=100.0,
                              epistemic=SMALL)  # fmt: skip
    study = replace(study_of(folder, text), records=NOISES, artificial=None, fragility=asked)
    found = run_fragility(study, jobs=1).mechanisms[0]
    (risk,) = (each for each in found.risks if (each.state.name, each.curve) == ("overturning", "empirical"))
    assert (risk.outcome, risk.gap) == (("pass", None) if told is None else ("incomplete", "motion"))
    assert {each.key for each in found.notes} & {"fragility-ground-motion", "fragility-scalar-motion"} == (
        set() if told is None else {told}
    )


def cloud_of(folder: Path, factor: float, hazard: HazardResult | None = None, target: float | None = None):
    return noise_results(folder, method="cloud", factor=factor, hazard=hazard, target_rate=target).mechanisms[0]


def test_a_curve_without_an_interval_says_why(folder: Path) -> None:
    """Twelve records as they are: of many draws the records part at one intensity."""
    told = set()
    for factor in (0.5, 0.6, 0.7, 0.8, 0.9, 1.0):
        found = cloud_of(folder, factor)
        for each in found.curves:
            if each.lognormal is None:
                assert each.notes
            elif each.lognormal.median_interval is None:
                told |= {note.key for note in each.notes}
            else:
                assert not each.notes
    assert told == {"fragility-interval-draws"}


def test_stripes_with_records_of_their_own_are_the_probit_of_their_counts(folder: Path) -> None:
    """Of each half sine the peak that overturns is known, and a search finds the largest likelihood of the counts."""
    pulses = tuple(half_sine(duration, place) for place, duration in enumerate(DURATIONS))
    exact = np.array([least_peak(duration) / g for duration in DURATIONS])
    levels = tuple(np.quantile(exact, [0.15, 0.4, 0.62, 0.85]).tolist())
    stripes = tuple(Stripe(im, tuple(each.id for each in pulses[k::4])) for k, im in enumerate(levels))
    study = study_with(
        folder, pulses, method="stripes", stripes=stripes, measures=(measure("pga"),), largest_factor=1e3, draws=100
    )
    found = curve(run_fragility(study, jobs=1))
    reached = [int((exact[k::4] < im).sum()) for k, im in enumerate(levels)]
    assert 0 < reached[0] < reached[-1] < 15
    assert [(each.intensity, each.records, each.reached) for each in found.empirical] == [
        (im, 15, number) for im, number in zip(levels, reached, strict=True)
    ]
    best = minimize(
        lambda at: -binom.logpmf(reached, 15, norm.cdf((np.log(levels) - at[0]) / np.exp(at[1]))).sum(),
        [0.0, -1.0], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-13},
    ).x  # fmt: skip
    np.testing.assert_allclose([found.lognormal.median, found.lognormal.dispersion], np.exp(best), rtol=1e-6)
    assert (found.first, found.censored) == (None, 0)
    assert found.lognormal.median_interval is not None


@pytest.mark.parametrize(
    ("last", "more", "said"),
    [
        (("pulse 9",), {}, '"pulse 9" is no record'),
        (("pulse 1",), {}, 'record "pulse 2" is in none'),
        (("pulse [12]",), {"largest_factor": 2.0}, "would be scaled by .*give a stronger record"),
    ],
)
def test_stripes_that_leave_records_open_are_refused(
    folder: Path, last: tuple[str, ...], more: dict[str, float], said: str
) -> None:
    pulses = tuple(half_sine(0.2, place) for place in range(3))
    stripes = Stripe(0.2, ("pulse 0", "pulse 1")), Stripe(0.4, last)
    study = study_with(folder, pulses, method="stripes", stripes=stripes, measures=(measure("pga"),), **more)
    with pytest.raises(ProjectError, match=said):
        run_fragility(study, jobs=1)


def test_records_of_two_earthquakes_say_why_there_is_no_interval(folder: Path) -> None:
    records = tuple(replace(each, event="ab"[place % 2]) for place, each in enumerate(NOISES))
    study = study_with(folder, records, published(2.0, 0.15, restitution=0.9), samples=20, draws=100)
    found = curve(run_fragility(study, jobs=1))
    assert found.lognormal.median_interval is None
    assert [note.key for note in found.notes] == ["fragility-interval-events"]


def test_a_cloud_that_one_intensity_parts_does_not_speak_of_levels(folder: Path) -> None:
    found = cloud_of(folder, 0.8)
    rocking = next(each for each in found.curves if each.state.name == "rocking" and each.measure.key == "pga")
    assert rocking.lognormal is None
    (told,) = rocking.notes
    assert told.key in {"fragility-cloud-separated", "fragility-all-reach"}
    assert "two intensities" not in told.text


def test_motions_stronger_than_the_strongest_record_of_a_cloud_keep_a_target_open(folder: Path) -> None:
    """The curve is extrapolated there: the rate of these is named, and what they may add is a bound."""
    plain = cloud_of(folder, 0.8)
    one = next(each for each in plain.curves if each.state.name == "overturning" and each.lognormal is not None)
    strongest = max(run.intensity[plain.measures.index(one.measure)] for run in plain.runs)
    assert (one.largest_run, one.end) == (pytest.approx(strongest), pytest.approx(strongest))
    at = np.geomspace(1e-3, 50.0 * strongest, 200)
    hazard = HazardResult(one.measure, "rows", tuple(at), tuple(1e-6 * at**-2.0))
    above = 1e-6 * (strongest**-2.0 - at[-1] ** -2.0)  # of all motions stronger than any record
    found = cloud_of(folder, 0.8, hazard, 1.0)
    (risk,) = (each for each in found.risks if each.state.name == "overturning")
    assert 0.0 < risk.above_runs < above
    fitted = one.lognormal
    lower = quad(
        lambda u: norm.sf((np.log(fitted.median) - u) / fitted.dispersion) * 2e-6 * np.exp(-2.0 * u),
        np.log(1e-3), np.log(strongest), epsrel=1e-8, limit=200,
    )[0]  # fmt: skip
    assert risk.annual_rate + risk.above_runs == pytest.approx(lower + above, rel=1e-4)
    assert "fragility-cloud-ends" in {note.key for note in risk.notes}
    between = risk.annual_rate + 0.5 * risk.above_runs
    found = cloud_of(folder, 0.8, hazard, between)
    (risk,) = (each for each in found.risks if each.state.name == "overturning")
    assert (risk.outcome, risk.gap) == ("incomplete", "runs")
