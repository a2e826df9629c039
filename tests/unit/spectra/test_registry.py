"""Spectra by the name of their code: those of each code's function, and refusals that list what is known."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.constants import g

from spectra import asce7, asce7_22, ec8, ntc, nzs1170_5, ts1170_5
from spectra.asce7 import EDITIONS
from spectra.design_spectra import SPECTRA
from spectra.errors import SpectrumError
from spectra.registry import spectrum
from spectra.spectrum import Spectrum, scale_to_pga
from spectra.table import read_table, table_spectrum

T = np.geomspace(0.01, 4.0, 60)
DESIGN: dict[str, Any] = {"s_ds": 0.5 * g, "s_d1": 0.2 * g, "t_l": 6.0}
MAPPED: dict[str, Any] = {"s_s": 0.6 * g, "s_1": 0.15 * g, "site_class": "C", "t_l": 6.0}
EC8: dict[str, Any] = {"a_g": 0.25 * g, "ground_type": "C"}
NZS: dict[str, Any] = {"subsoil": "D", "z": 0.4}
REPLY = Path(asce7_22.__file__).parents[1] / "assess/verification/cases/asce7/usgs_reply.json"
TS: dict[str, Any] = {"s_as": 0.38 * g, "t_c": 0.52, "t_d": 2.8}
ROCK: dict[str, Any] = {"a_g": 0.15 * g, "f_0": 2.4, "t_c_star": 0.3}
ROWS: tuple[dict[str, float], ...] = (
    {"return_period": 30.0, "a_g": 0.05 * g, "f_0": 2.4, "t_c_star": 0.25},
    {"return_period": 2475.0, "a_g": 0.3 * g, "f_0": 2.5, "t_c_star": 0.4},
)
HAZARD: dict[str, Any] = {"hazard": ROWS, "nominal_life": 50.0, "use_class": "II", "soil": "B"}
POINTS: dict[str, Any] = {"period": (0.0, 0.2, 0.6, 4.0), "acceleration": (1.0, 2.5, 2.5, 0.2)}


def at_limit_state(code: str, state: str) -> Spectrum:
    rows = [ntc.Hazard(**row) for row in ROWS]
    at = ntc.limit_state_hazard(rows, limit_state=state, nominal_life=50.0, use_class="II")
    return ntc.elastic_spectrum(at, place=ntc.SoilAndTopography("B"), code=code)


CASES: list[tuple[str, dict[str, Any], Spectrum]] = [
    *((code, DESIGN, asce7.design_spectrum(**DESIGN, code=code)) for code in EDITIONS),
    *((code, MAPPED, asce7.mapped_spectrum(**MAPPED, code=code)) for code in EDITIONS),
    ("asce7-16", {**MAPPED, "hazard": "mce"}, asce7.mapped_spectrum(**MAPPED, hazard="mce")),
    ("asce7-22", {"file": REPLY}, asce7_22.multi_period_spectrum(REPLY)),
    ("ec8", EC8, ec8.elastic_spectrum(**EC8)),
    (
        "ec8",
        {**EC8, "type": 2, "importance_factor": 1.2},
        ec8.elastic_spectrum(**EC8, spectrum_type=2, importance_factor=1.2),
    ),
    ("nzs1170.5", {**NZS, "r": 1.3}, nzs1170_5.site_spectrum(**NZS, r=1.3)),
    (
        "nzs1170.5",
        {**NZS, "return_period": 1000.0, "near_fault_distance": 5e3},
        nzs1170_5.site_spectrum(**NZS, r=1.3, near_fault_distance=5e3),
    ),
    ("ts1170.5", {**TS, "pga_site": 0.18 * g}, ts1170_5.site_spectrum(**TS, pga=0.18 * g)),
    *(
        (
            code,
            {**ROCK, "soil": "C"},
            ntc.elastic_spectrum(ntc.Hazard(**ROCK), place=ntc.SoilAndTopography("C"), code=code),
        )
        for code in ntc.CLAUSES
    ),
    *((code, HAZARD, at_limit_state(code, "SLV")) for code in ntc.CLAUSES),
    ("ntc2018", {**HAZARD, "limit_state": "SLD"}, at_limit_state("ntc2018", "SLD")),
    ("table", POINTS, table_spectrum(**POINTS)),
]


@pytest.mark.parametrize(("code", "given", "expected"), CASES)
def test_a_spectrum_by_name_is_that_of_its_function(code: str, given: dict[str, Any], expected: Spectrum) -> None:
    found = spectrum(code, **given)
    assert (found.code, found.clause, found.damping_rule) == (code, expected.clause, expected.damping_rule)
    assert set(expected.parameters.items()) <= set(found.parameters.items())
    np.testing.assert_array_equal(found.acceleration(T), expected.acceleration(T))
    np.testing.assert_array_equal(found.displacement(T), expected.displacement(T))


@pytest.mark.parametrize(("code", "given", "expected"), CASES)
def test_damping_and_pga_act_as_in_a_project(code: str, given: dict[str, Any], expected: Spectrum) -> None:
    damped = expected if code == "table" else replace(expected, damping=0.1)
    wanted = scale_to_pga(damped, 2.0)
    found = spectrum(code, **given, damping=damped.damping, pga=2.0)
    np.testing.assert_array_equal(found.acceleration(T), wanted.acceleration(T))
    assert found.pga == pytest.approx(2.0, rel=1e-14)


def test_every_code_has_a_case() -> None:
    assert {code for code, _, _ in CASES} == set(SPECTRA)


def test_a_table_is_read_from_its_file(tmp_path: Path) -> None:
    file = tmp_path / "spectrum.csv"
    file.write_text("period [s], acceleration [g]\n0.1, 0.25\n0.5, 0.25\n4.0, 0.02\n")
    expected = scale_to_pga(read_table(file, damping=0.1, pga=1.0), 1.0)
    for name in (file, str(file)):
        found = spectrum("table", file=name, damping=0.1, pga=1.0)
        np.testing.assert_array_equal(found.acceleration(T), expected.acceleration(T))


@pytest.mark.parametrize(
    ("code", "given", "told"),
    [
        ("ec9", EC8, "choose one of asce7-05, .*, table"),
        (
            "ec8",
            {**EC8, "ag": 1.0},
            'ag = 1: unknown key; did you mean "a_g"',
        ),
        ("ec8", {"a_g": 1.0}, "ground_type: missing; ground type"),
        ("ec8", {**EC8, "a_g": "0.25 g"}, "a_g = '0.25 g': not a number; give one in SI units"),
        ("ec8", {**EC8, "a_g": -1.0}, "a_g = -1: must be greater than 0"),
        ("ec8", {**EC8, "pga": -1.0}, "pga = -1: must be greater than 0"),
        ("ec8", {**EC8, "damping": -0.1}, "damping = -0.1: must be greater than 0"),
        ("asce7-16", {**DESIGN, "s_s": 1.0}, "s_ds = 4.90332: follows from s_s, s_1 and site_class"),
        ("nzs1170.5", NZS, "give either r"),
        ("nzs1170.5", {**NZS, "r": 1.0, "return_period": 500.0}, "give either r"),
        (
            "ntc2018",
            {**HAZARD, "hazard": ({"years": 30.0},)},
            r"hazard\[1\].years = 30: unknown key; known here: return_period, a_g",
        ),
        ("ntc2018", {**ROCK, "soil": "C", "use_class": "II"}, "use_class = 'II': goes with hazard"),
        ("table", {}, "file: missing; CSV of period and acceleration"),
        ("table", {"period": (0.0, 1.0)}, "acceleration: missing"),
    ],
)
def test_what_is_not_known_is_refused_with_what_is(code: str, given: dict[str, Any], told: str) -> None:
    with pytest.raises(SpectrumError, match=told) as caught:
        spectrum(code, **given)
    assert "\n" not in str(caught.value)


def test_a_spectrum_shows_itself_on_one_line() -> None:
    assert repr(spectrum("ec8", **EC8)) == "Spectrum(code='ec8', pga=2.819 m/s2, damping=0.05)"
