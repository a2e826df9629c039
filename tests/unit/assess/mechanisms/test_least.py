"""The least of functions of one to four parameters: several valleys, a valley askew, ends, and none at all."""

from math import cos, inf

import pytest

from assess.mechanisms.least import find_least


def test_the_lowest_of_several_valleys_is_found_and_the_others_are_kept() -> None:
    found = find_least(lambda at: cos(3.0 * at[0]) + 0.1 * at[0], bounds=((0.0, 6.0),), stations=(19,))
    assert found.at[0] == pytest.approx(1.036, abs=2e-3)
    assert len(found.others) >= 1
    assert found.others[0][0] > found.value


def test_a_valley_that_runs_askew_is_followed() -> None:
    found = find_least(
        lambda at: (at[0] - at[1]) ** 2 * 100.0 + (at[0] + at[1] - 1.3) ** 2,
        bounds=((0.0, 1.0), (0.0, 1.0)),
        stations=(4, 4),
    )
    assert found.at == pytest.approx((0.65, 0.65), abs=2e-3)


def test_the_least_may_lie_at_an_end_and_a_parameter_may_be_fixed() -> None:
    found = find_least(lambda at: at[0] + at[1], bounds=((0.2, 1.0), (3.0, 3.0)), stations=(5, 5))
    assert found.at == (0.2, 3.0)
    assert found.evaluations < 20


def test_where_there_is_no_mechanism_the_least_is_infinite() -> None:
    assert find_least(lambda at: inf, bounds=((0.0, 1.0),), stations=(5,)).value == inf
    half = find_least(lambda at: at[0] if at[0] > 0.5 else inf, bounds=((0.0, 1.0),), stations=(5,))
    assert half.value == pytest.approx(0.5, abs=2e-3)
