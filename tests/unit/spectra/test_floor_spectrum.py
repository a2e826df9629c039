"""Floor spectra against the clauses worked by hand; accelerations in g unless said."""

import numpy as np
import pytest
from scipy.constants import g

from spectra.ec8 import elastic_spectrum
from spectra.errors import SpectrumError
from spectra.floor import (
    Mode,
    circolare2019_floor_spectrum,
    circolare2019_frame,
    circolare2019_modal,
    circolare2019_peak_acceleration,
    ec8_floor_spectrum,
    first_mode_factor,
    nzs1170_5_floor_spectrum,
    part_action,
    part_amplification,
    part_response_factor,
    part_shape,
)
from spectra.nzs1170_5 import site_spectrum
from spectra.table import table_spectrum

FLAT = table_spectrum([0.0, 0.1, 100.0], [0.2 * g, 0.5 * g, 0.5 * g])
TOP = Mode(0.3, 0.05, 9 / 7)  # three storeys: gamma = 9/7, at the top


def test_en_1998_1_eq_4_25():
    """alpha = 0.25, S = 1.2, H = 10 m, T_1 = 0.4 s: S_a = alpha S [3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5]."""
    building = {"ground": 0.3 * g, "building_height": 10.0, "building_period": 0.4}
    assert ec8_floor_spectrum([0.0, 0.4], height=10.0, **building) / g == pytest.approx([0.750, 1.650], rel=1e-12)
    assert ec8_floor_spectrum(0.2, height=5.0, **building) / g == pytest.approx(0.930, rel=1e-12)
    assert ec8_floor_spectrum([0.0, 9.0], height=0.0, **building) / g == pytest.approx([0.300, 0.300], rel=1e-12)


def test_nzs_parts():
    """Class C, Z = 0.4: C(0) = 0.532; h_i = 6 m of 15 m: C_Hi = 2; C_i(0.5) = 2, C_i(1.0) = 1.5."""
    ground = site_spectrum(subsoil="C", z=0.4, r=1.0).pga
    found = nzs1170_5_floor_spectrum([0.0, 0.5, 1.0, 3.0], ground=ground, height=6.0, building_height=15.0) / g
    assert found == pytest.approx([2.128, 2.128, 1.596, 0.532], rel=1e-12)


@pytest.mark.parametrize(("period", "shape"), [(0.0, 2.0), (0.75, 2.0), (1.0, 1.5), (1.25, 1.0), (1.5, 0.5), (9, 0.5)])
def test_nzs_part_shape(period, shape):
    assert part_shape(period) == pytest.approx(shape, rel=1e-12)


@pytest.mark.parametrize(
    ("ductility", "factor"), [(1.0, 1.0), (1.125, 0.925), (1.25, 0.85), (2.0, 0.55), (2.5, 0.5), (6.0, 0.45)]
)
def test_nzs_part_response_factor(ductility, factor):
    assert part_response_factor(ductility) == pytest.approx(factor, rel=1e-12)


def test_nzs_part_action_ends_at_3_6():
    assert part_action([2.0 * g, 5.0 * g], ductility=1.25, risk_factor=0.9) / g == pytest.approx([1.53, 3.6], rel=1e-12)


def test_circolare_2019_one_mode():
    """a_Z = 0.5 x 9/7 x sqrt(1.01) = 0.6461; A = 1.1 / sqrt(0.05) = 4.919; tolerance: its last digit."""
    assert circolare2019_peak_acceleration(FLAT, modes=[TOP]) / g == pytest.approx(0.6461, abs=5e-5)
    found = circolare2019_floor_spectrum([0.0, 0.15, 0.3], spectrum=FLAT, modes=[TOP]) / g
    assert found == pytest.approx([0.6461, 1.7501, 3.1782], abs=1e-4)
    weak = table_spectrum([0.0, 0.29, 0.3, 0.31, 100.0], [0.05 * g, 0.05 * g, 0.5 * g, 0.05 * g, 0.05 * g])
    found = circolare2019_floor_spectrum([0.66, 1.0], spectrum=weak, modes=[TOP]) / g
    assert found == pytest.approx([0.6461, 0.3126], abs=6e-5)


def test_circolare_2019_begins_at_the_floor_s_peak_and_ends_at_the_ground_s_spectrum():
    modes = [TOP, Mode(0.1, 0.05, 0.4)]
    at_zero, far = circolare2019_floor_spectrum([0.0, 60.0], spectrum=FLAT, modes=modes)
    assert at_zero == pytest.approx(circolare2019_peak_acceleration(FLAT, modes=modes), rel=1e-12)
    assert far == pytest.approx(0.5 * g, rel=1e-12)


def test_circolare_2019_combines_by_squares():
    first, second = Mode(0.3, 0.05, 0.9), Mode(0.1, 0.05, 0.4)
    T = np.linspace(0.0, 0.3, 40)
    alone = [circolare2019_floor_spectrum(T, spectrum=FLAT, modes=[mode])[:14] for mode in (first, second)]
    both = circolare2019_floor_spectrum(T, spectrum=FLAT, modes=[first, second])
    np.testing.assert_allclose(both[:13], np.hypot(alone[0], alone[1])[:13], rtol=1e-12)


def test_circolare_2019_takes_the_damping_of_the_part_in_eta():
    """At T_k: A = 1.1 / sqrt(0.05) x sqrt(10/13) for 8 %."""
    found = circolare2019_floor_spectrum(0.3, spectrum=FLAT, modes=[TOP], damping=0.08) / g
    assert found == pytest.approx(0.6461 * 1.1 / 0.05**0.5 * (10 / 13) ** 0.5, rel=1e-4)


def test_circolare_2019_stays_positive_under_great_damping():
    damped = Mode(0.3, 0.9, 1.0)
    assert np.all(
        circolare2019_floor_spectrum(np.linspace(0.0, 50.0, 200), spectrum=FLAT, modes=[damped], damping=0.5) > 0.0
    )


def test_circolare_2019_modal_at_and_above_resonance():
    """S_ij = 0.5 x 9/7 = 0.642857 g; R(1) = 1 / (2 x 0.05) = 10 and 10^0.8; R(2) = (0.04 + 9)^-1/2 for xi_a = 5 %."""
    at = {"spectrum": FLAT, "modes": [TOP]}
    assert circolare2019_modal([0.3, 0.6], **at) / g == pytest.approx([6.42857, 0.642857 / 9.04**0.5], rel=1e-6)
    assert circolare2019_modal(0.3, **at, beta=0.4) / g == pytest.approx(0.642857 * 10**0.8, rel=1e-6)
    assert part_amplification(1.0, 0.1, beta=0.5) == pytest.approx(5.0, rel=1e-12)


def test_the_ground_is_the_least_beyond_the_longest_mode_and_not_at_it():
    hardly = [Mode(0.3, 0.05, 0.01), Mode(0.1, 0.05, 0.01)]
    at, beyond = circolare2019_floor_spectrum([0.3, 0.3001], spectrum=FLAT, modes=hardly) / g
    assert at < 0.1
    assert beyond == pytest.approx(0.5, rel=1e-12)


def test_circolare_2019_modal_of_a_rigid_part_is_the_floor():
    """T_a -> 0: R = 1, so the squares of 0.5 x 0.9 and 0.5 x 0.4 remain; a soft part feels nothing."""
    modes = [Mode(0.3, 0.05, -0.9), Mode(0.1, 0.05, 0.4)]
    rigid, nearly, soft = circolare2019_modal([0.0, 1e-4, 300.0], spectrum=FLAT, modes=modes) / g
    assert rigid == pytest.approx(0.5 * np.hypot(0.9, 0.4), rel=1e-12)
    assert nearly == pytest.approx(rigid, rel=1e-5)
    assert soft < 1e-5


@pytest.mark.parametrize(("storeys", "factor"), [(1, 1.0), (2, 1.2), (3, 1.2857), (5, 1.3636)])
def test_first_mode_factor(storeys, factor):
    assert first_mode_factor(storeys) == pytest.approx(factor, abs=5e-5)


@pytest.mark.parametrize(
    ("t_1", "period", "ordinate"),
    [
        (0.3, 0.0, 0.600),
        (0.3, 0.096, 1.2295),  # 0.6 below the plateau: 0.3 * 2 * 5 / (1 + 4 * 0.36)
        (0.3, 0.3, 3.000),
        (0.3, 0.63, 1.5),  # 0.5 above it: 0.3 * 2 * 5 / (1 + 4 * 0.25)
        (0.3, 1.0, 0.348),
        (0.7, 0.5, 2.4),
        (0.7, 0.0, 0.6),
        (1.5, 1.0, 1.5),
        (1.5, 90.0, 0.3),
    ],
)
def test_circolare_2019_of_frames(t_1, period, ordinate):
    """alpha = 0.25, S = 1.2, z = H; a_p = 5, 4, 2.5; never below alpha S."""
    found = circolare2019_frame(period, ground=0.3 * g, height=9.0, building_height=9.0, building_period=t_1) / g
    assert found == pytest.approx(ordinate, abs=5e-4)


BUILDING = {"ground": 1.0, "height": 3.0, "building_height": 9.0}
REFUSED = {
    "ec8 height": (lambda: ec8_floor_spectrum(0.1, **{**BUILDING, "height": 10.0}, building_period=0.3), "height 10 m"),
    "ec8 period": (lambda: ec8_floor_spectrum(0.1, **BUILDING, building_period=0.0), "period of the building 0.0 s"),
    "frame period": (lambda: circolare2019_frame(0.1, **BUILDING, building_period=-1.0), "period of the building"),
    "negative period": (lambda: nzs1170_5_floor_spectrum(-0.1, **BUILDING), "periods from 0 up"),
    "ductility": (lambda: part_response_factor(0.9), r"Table 8\.2 begins at 1"),
    "beta": (lambda: circolare2019_modal(0.1, spectrum=FLAT, modes=[TOP], beta=0.6), r"beta = 0\.6"),
    "no mode": (lambda: circolare2019_modal(0.1, spectrum=FLAT, modes=[]), "at least one mode"),
    "no modes": (lambda: circolare2019_floor_spectrum(0.1, spectrum=FLAT, modes=[]), "at least one mode"),
    "undamped mode": (
        lambda: circolare2019_peak_acceleration(FLAT, modes=[Mode(0.3, 0.0, 1.0)]),
        "needs both positive",
    ),
    "no storeys": (lambda: first_mode_factor(0), "0 storeys"),
}


@pytest.mark.parametrize(("call", "words"), list(REFUSED.values()), ids=list(REFUSED))
def test_what_lies_outside_the_clauses_is_refused(call, words):
    with pytest.raises(SpectrumError, match=words):
        call()


def test_a_floor_on_a_code_s_own_spectrum():
    """S_e(T_k) of type 1, ground B, is 0.75 g on its level branch."""
    spectrum = elastic_spectrum(a_g=0.25 * g, ground_type="B")
    assert circolare2019_peak_acceleration(spectrum, modes=[TOP]) / g == pytest.approx(
        0.75 * 9 / 7 * 1.01**0.5, rel=1e-12
    )
