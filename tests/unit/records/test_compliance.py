"""Requirements of codes on suites whose numbers are known in advance: multiples of the target, and steps in it."""

from dataclasses import replace
from functools import partial
from math import log10

import numpy as np
import pytest

from records.compliance import REQUIREMENTS, all_requirements, asce7_16, asce43_05, en1998_1, ntc2018, nzs1170_5
from records.compliance.suite import FINE, Requirement, RequirementKind, Suite, common_factor, suite_of
from records.record import make_record, scale
from records.response import response_spectrum
from spectra.asce7 import design_spectrum
from spectra.table import table_spectrum

TARGET = design_spectrum(s_ds=5.0, s_d1=2.0, t_l=6.0)
T_EQ = 1.0  # s, shortest and longest equivalent period


def suite(
    *multiples: float,
    dt: float = 0.01,
    duration: float = 30.0,
    made: bool = False,
    level: float = 15.0,
    usable: float = np.inf,
) -> Suite:
    """Records whose spectra are multiples of the target; made: artificial ones, `level` s of them stationary."""
    of, ordinates = np.array(multiples), TARGET.acceleration(FINE)
    return Suite(
        period=FINE,
        target=ordinates,
        spectra=of[:, np.newaxis] * ordinates,
        target_pga=TARGET.pga,
        pga=of * TARGET.pga,
        factor=of,
        dt=np.full(of.size, dt),
        duration=np.full(of.size, duration),
        artificial=np.full(of.size, made),
        stationary=np.full(of.size, level if made else 0.0),
        usable=np.full(of.size, usable),
    )


def dented(of: Suite, period: float, share: float, *, width: int = 1) -> Suite:
    """The suite with every spectrum times `share` at `width` points from `period` on."""
    spectra, first = of.spectra.copy(), int(np.argmin(np.abs(of.period - period)))
    spectra[:, first : first + width] *= share
    return replace(of, spectra=spectra)


def named(found: tuple[Requirement, ...], what: str) -> Requirement:
    (one,) = (each for each in found if each.what == what)
    return one


LEAST, MOST = "least ratio of mean spectrum to target", "largest ratio of mean spectrum to target"


@pytest.mark.parametrize("made", [False, True])
@pytest.mark.parametrize("code", list(REQUIREMENTS))
def test_every_code_is_content_with_a_perfect_suite_and_says_so_with_its_clause(code: str, made: bool) -> None:
    found = REQUIREMENTS[code](suite(*[1.0] * 11, made=made), shortest=T_EQ, longest=T_EQ)
    assert [one.verdict for one in found] == ["met"] * len(found)
    assert all(one.code == code and one.clause and "memory" in one.caveat for one in found)


@pytest.mark.parametrize(
    ("code", "least", "made"),
    [
        (asce7_16.CODE, 11, False),
        (en1998_1.CODE, 3, False),
        (nzs1170_5.CODE, 3, False),
        (asce43_05.CODE, 5, False),
        (asce43_05.CODE, 7, True),
        (ntc2018.CODE, 3, False),
        (ntc2018.CODE, 7, True),
    ],
)
def test_the_number_of_records(code: str, least: int, made: bool) -> None:
    for count, verdict in ((least - 1, "not met"), (least, "met")):
        found = REQUIREMENTS[code](suite(*[1.0] * count, made=made), shortest=T_EQ, longest=T_EQ)
        (one,) = (each for each in found if each.kind == RequirementKind.COUNT)
        assert (one.value, one.limit, one.verdict) == (count, least, verdict)


@pytest.mark.parametrize("requirements", [asce7_16.requirements, en1998_1.requirements, ntc2018.requirements])
def test_the_mean_may_fall_ten_percent_below_the_target(requirements: object) -> None:
    for share, verdict in ((0.901, "met"), (0.899, "not met")):
        found = named(requirements(suite(share - 0.3, share, share + 0.3), shortest=T_EQ, longest=T_EQ), LEAST)  # type: ignore[operator]
        assert found.value == pytest.approx(share, rel=1e-12)
        assert found.verdict == verdict
    assert "further factor of 1.001" in found.remark


@pytest.mark.parametrize(
    ("requirements", "low", "high"),
    [(asce7_16.requirements, 0.2, 2.0), (en1998_1.requirements, 0.2, 2.0), (ntc2018.requirements, 0.2, 1.2)],
)
def test_a_dip_counts_within_the_range_of_periods_only(requirements: object, low: float, high: float) -> None:
    for period, verdict in ((low / 1.1, "met"), (low * 1.1, "not met"), (high / 1.1, "not met"), (high * 1.1, "met")):
        found = requirements(dented(suite(1.0, 1.0, 1.0), period, 0.5), shortest=T_EQ, longest=T_EQ)  # type: ignore[operator]
        assert named(found, LEAST).verdict == verdict


def test_the_range_goes_from_the_shortest_to_the_longest_equivalent_period() -> None:
    found = asce7_16.requirements(suite(1.0), shortest=0.5, longest=3.0)
    assert named(found, LEAST).periods == pytest.approx((0.1, 6.0))


def test_ntc_allows_natural_records_thirty_percent_above_the_target() -> None:
    for share, verdict in ((1.299, "met"), (1.301, "not met")):
        found = ntc2018.requirements(suite(*[share] * 3), shortest=T_EQ, longest=T_EQ)
        assert named(found, MOST).verdict == verdict


def test_ntc_looks_at_artificial_records_up_to_two_seconds_or_twice_the_period_and_has_no_bound_above() -> None:
    found = ntc2018.requirements(suite(*[1.5] * 7, made=True), shortest=0.1, longest=0.4)
    assert {one.verdict for one in found} == {"met"}
    assert MOST not in {one.what for one in found}
    assert named(found, LEAST).periods == pytest.approx((0.15, 2.0))
    longer = ntc2018.requirements(suite(*[1.0] * 7, made=True), shortest=1.0, longest=1.5)
    assert named(longer, LEAST).periods == pytest.approx((0.15, 3.0))


@pytest.mark.parametrize(
    ("rule", "change", "limit"),
    [(RequirementKind.DURATION, {"duration": 24.9}, 25.0), (RequirementKind.STATIONARY, {"level": 9.9}, 10.0)],
)
def test_ntc_asks_for_25_s_of_artificial_records_10_s_of_them_stationary(
    rule: RequirementKind, change: dict[str, float], limit: float
) -> None:
    for given, verdict in ((change, "not met"), (dict.fromkeys(change, limit), "met")):
        found = ntc2018.requirements(suite(*[1.0] * 7, made=True, **given), shortest=T_EQ, longest=T_EQ)
        (one,) = (each for each in found if each.kind == rule)
        assert (one.limit, one.verdict) == (limit, verdict)
    natural = ntc2018.requirements(suite(*[1.0] * 7, duration=5.0), shortest=T_EQ, longest=T_EQ)
    assert rule not in {one.kind for one in natural}


def test_a_suite_of_natural_and_artificial_records_meets_what_is_asked_of_either() -> None:
    both = suite(*[1.4] * 7, made=True, duration=20.0)
    mixed = replace(both, artificial=np.array([True] + [False] * 6), duration=np.array([20.0] + [5.0] * 6))
    found = ntc2018.requirements(mixed, shortest=T_EQ, longest=T_EQ)
    assert {one.kind for one in found if one.verdict == "not met"} == {
        RequirementKind.DURATION,
        RequirementKind.MEAN_HIGH,
    }
    (duration,) = (one for one in found if one.kind == RequirementKind.DURATION)
    assert duration.value == 20.0


@pytest.mark.parametrize("code", [asce43_05.CODE, ntc2018.CODE])
def test_records_must_be_usable_up_to_the_longest_period_where_their_source_says_how_far_they_are(code: str) -> None:
    for usable, verdicts in ((0.9, ["not met"]), (1.1, ["met"]), (np.inf, [])):
        found = REQUIREMENTS[code](suite(*[1.0] * 7, usable=usable), shortest=0.5, longest=1.0)
        assert [one.verdict for one in found if one.kind == RequirementKind.USABLE] == verdicts


def test_the_factor_that_does_lifts_what_is_low_and_lowers_what_is_high_or_does_not_exist() -> None:
    suites = [suite(level, level, level) for level in (1.0, 0.8, 1.5)]
    suites += [dented(suite(1.2, 1.2, 1.2), 0.5, share) for share in (0.7, 0.6)]
    found = [common_factor(ntc2018.requirements(each, shortest=T_EQ, longest=T_EQ)) for each in suites]
    assert found[0] == 1.0
    assert found[1:4] == pytest.approx([0.9 / 0.8, 1.3 / 1.5, 0.9 / 0.84])
    assert found[4] is None


def test_ec8_asks_for_the_mean_peak() -> None:
    found = named(
        en1998_1.requirements(suite(0.8, 1.1), shortest=T_EQ, longest=T_EQ), "mean zero-period ordinate over a_g S"
    )
    assert (found.value, found.verdict) == (pytest.approx(0.95), "not met")
    assert found.factor == pytest.approx(1.0 / 0.95)


def off(*powers: float, factor: float = 1.0) -> tuple[Requirement, ...]:
    """NZS of records that are 10 ^ (n T) off the target, in use with one factor; T_1 = 1 s."""
    of = suite(*[1.0] * len(powers))
    spectra = of.target * 10.0 ** (np.array(powers)[:, np.newaxis] * FINE)
    return nzs1170_5.requirements(
        replace(of, spectra=factor * spectra, factor=np.full(len(powers), factor)), shortest=T_EQ, longest=T_EQ
    )


def test_nzs_finds_k_1_and_the_log_misfit_over_the_period_itself_not_its_logarithm() -> None:
    """Of log10 ratios n T over a to b the mean is n (a + b) / 2 and the deviation n (b - a) / sqrt(12)."""
    a, b = (FINE[(FINE >= 0.4) & (FINE <= 1.3)][i] for i in (0, -1))
    for factor in (1.0, 2.5):
        found = off(0.4, 0.1, factor=factor)
        assert named(found, "least record scale factor k_1").value == pytest.approx(10 ** (-0.2 * (a + b)), rel=1e-3)
        assert named(found, "largest record scale factor k_1").value == pytest.approx(10 ** (-0.05 * (a + b)), rel=1e-3)
        fit = named(found, "largest misfit D_1 of a record")
        assert fit.value == pytest.approx(0.4 * (b - a) / np.sqrt(12), rel=1e-3)
        assert fit.limit == pytest.approx(log10(1.5), rel=1e-12)
    steep = named(off(0.8), "largest misfit D_1 of a record")
    assert (steep.verdict, steep.value) == ("not met", pytest.approx(0.8 * (b - a) / np.sqrt(12), rel=1e-3))


def test_nzs_asks_for_a_family_factor_where_no_record_reaches_the_target_and_for_factors_in_use_with_it() -> None:
    a, b = (FINE[(FINE >= 0.4) & (FINE <= 1.3)][i] for i in (0, -1))
    assert named(off(0.3, -0.3), "family scale factor k_2").value == pytest.approx(1.0, abs=2e-3)
    found = off(0.3, 0.3, 0.3, factor=2.0)
    k_2 = 10 ** (0.3 * (b - a) / 2)
    family = named(found, "family scale factor k_2")
    assert (family.value, family.verdict) == (pytest.approx(k_2, rel=1e-3), "not met")
    used = named(found, nzs1170_5.IN_USE)
    assert used.value == pytest.approx(2.0 / (10 ** (-0.15 * (a + b)) * k_2), rel=1e-3)
    low = nzs1170_5.requirements(replace(suite(0.25, 0.5, 0.7), factor=np.ones(3)), shortest=T_EQ, longest=T_EQ)
    assert named(low, "largest record scale factor k_1").value == pytest.approx(4.0, rel=1e-12)
    assert named(low, "largest record scale factor k_1").verdict == "not met"
    assert named(low, nzs1170_5.IN_USE).factor == pytest.approx(4.0, rel=1e-12)


def test_nzs_takes_no_period_below_0_4_s() -> None:
    found = nzs1170_5.requirements(suite(1.0), shortest=0.1, longest=0.2)
    assert named(found, "family scale factor k_2").periods == pytest.approx((0.16, 0.52))


def test_asce_43_counts_points_side_by_side_steps_and_durations_of_artificial_records() -> None:
    requirements = partial(asce43_05.requirements, shortest=T_EQ, longest=T_EQ)
    what, perfect = "points side by side below the target", suite(*[1.0] * 7, made=True)
    for width, verdict in ((9, "met"), (10, "not met")):
        found = requirements(dented(perfect, 1.0, 0.95, width=width))
        assert (named(found, what).value, named(found, what).verdict) == (width, verdict)
    assert common_factor(requirements(dented(perfect, 1.0, 0.95, width=10))) == pytest.approx(1.0 / 0.95)
    coarse = requirements(suite(*[1.0] * 7, made=True, dt=0.02, duration=19.0))
    assert named(coarse, "largest time step").verdict == "not met"
    assert named(coarse, "shortest duration").verdict == "not met"


def test_asce_43_asks_of_recorded_motions_their_mean_over_the_periods_of_the_mechanisms() -> None:
    high = suite(*[1.6] * 5, dt=0.02, duration=12.0)
    assert {one.verdict for one in asce43_05.requirements(high, shortest=T_EQ, longest=T_EQ)} == {"met"}
    found = asce43_05.requirements(suite(*[0.8] * 5), shortest=0.5, longest=2.0)
    assert named(found, LEAST).verdict == "not met"
    assert named(found, LEAST).periods == pytest.approx((0.1, 2.4))


def test_the_band_of_asce_43_reaches_the_slowest_mechanism() -> None:
    for longest, end in ((2.3, 5.0), (7.3, 7.3)):
        found = asce43_05.requirements(suite(*[1.0] * 7, made=True), shortest=1.0, longest=longest)
        assert named(found, LEAST).periods == pytest.approx((0.04, end))


def test_what_the_target_does_not_reach_is_not_answered() -> None:
    short = table_spectrum(np.array([0.0, 0.5, 1.0]), np.array([1.0, 1.0, 0.5]))
    record = make_record("r", np.random.default_rng(1).normal(0.0, 1.0, 500), 0.01)
    found = all_requirements(suite_of([record], [1.0], short), shortest=1.0, longest=1.0)
    late = [one for one in found if one.periods is not None]
    assert {one.verdict for one in late} == {"not answered"}
    assert all(one.value is None and "to 1 s" in one.remark for one in late)


def test_a_suite_is_what_its_records_scaled_are() -> None:
    record = make_record("r", np.random.default_rng(1).normal(0.0, 1.0, 500), 0.01)
    of = suite_of([record, record], [2.0, 0.5], TARGET)
    np.testing.assert_allclose(of.spectra[0], response_spectrum(scale(record, 2.0), FINE), rtol=1e-12)
    np.testing.assert_allclose(of.pga, [2.0 * record.pga, 0.5 * record.pga], rtol=1e-12)
    assert of.duration[0] == pytest.approx(4.99)
    assert not of.artificial.any()
    made = suite_of([replace(record, stationary=12.5), replace(record, longest_period=8.0)], [1.0, 1.0], TARGET)
    assert made.artificial.tolist() == [True, False]
    assert made.stationary.tolist() == [12.5, 0.0]
    assert made.usable.tolist() == [np.inf, 8.0]


def test_a_code_may_have_periods_of_its_own() -> None:
    found = all_requirements(suite(*[1.0] * 11), shortest=1.0, longest=1.0, own={ntc2018.CODE: (0.5, 2.0)})
    by_code = {one.code: one.periods for one in found if one.what == LEAST}
    assert by_code[ntc2018.CODE] == pytest.approx((0.1, 2.4))
    assert by_code[asce7_16.CODE] == pytest.approx((0.2, 2.0))
