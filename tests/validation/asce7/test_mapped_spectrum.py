"""Site coefficients of ASCE 7 and what follows from them, worked by hand from the tables; accelerations in g."""

import pytest
from scipy.constants import g

from spectra.asce7 import mapped_spectrum
from spectra.errors import SpectrumError


def made(code: str = "asce7-16", **given):
    values = {"s_s": 1.5, "s_1": 0.6, "site_class": "D", "t_l": 8.0, **given}
    values.update(s_s=values["s_s"] * g, s_1=values["s_1"] * g)
    return mapped_spectrum(code=code, **values)


def test_a_high_hazard_on_class_d_by_7_16():
    """F_a = 1.0, F_v = 1.7, so S_MS = 1.5, S_M1 = 1.02, S_DS = 1.0, S_D1 = 0.68, T_0 = 0.136 s, T_S = 0.68 s."""
    spectrum = made()
    found = {
        name: spectrum.parameters[name] / (g if name[0] == "s" else 1.0)
        for name in ("f_a", "f_v", "s_ms", "s_m1", "s_ds", "s_d1")
    }
    assert found == pytest.approx({"f_a": 1, "f_v": 1.7, "s_ms": 1.5, "s_m1": 1.02, "s_ds": 1, "s_d1": 0.68}, rel=1e-12)
    assert spectrum.parameters["t_0"] == pytest.approx(0.136, rel=1e-12)
    ordinates = spectrum.acceleration([0.0, 0.068, 0.136, 0.4, 0.68, 1.0, 8.0, 10.0]) / g
    assert ordinates == pytest.approx([0.4, 0.7, 1.0, 1.0, 1.0, 0.68, 0.085, 0.0544], rel=1e-12)
    assert made(hazard="mce").pga / g == pytest.approx(0.4 * 1.5, rel=1e-12)


@pytest.mark.parametrize("code", ["asce7-05", "ibc2009", "asce7-10"])
def test_casa_grande_from_the_map(code):
    """Thesis Table 8.4, IBC 2009: S_S = 0.25, S_1 = 0.08, class B: F_a = F_v = 1, S_DS = 0.167, S_D1 = 0.053."""
    spectrum = made(code, s_s=0.25, s_1=0.08, site_class="B", t_l=6.0)
    assert spectrum.acceleration([0.0, 0.2, 2.0]) / g == pytest.approx([0.2 / 3, 0.5 / 3, 0.08 / 3], rel=1e-12)
    assert spectrum.warnings == ()


@pytest.mark.parametrize(
    ("code", "site_class", "given", "name", "value"),
    [
        ("asce7-16", "D", {"s_s": 0.1}, "f_a", 1.6),
        ("asce7-16", "D", {"s_s": 3.0}, "f_a", 1.0),
        ("asce7-16", "D-default", {"s_s": 1.3}, "f_a", 1.2),
        ("asce7-16", "B-unmeasured", {"s_s": 1.0}, "f_a", 1.0),
        ("asce7-10", "C", {"s_s": 0.875}, "f_a", 1.05),
        ("asce7-10", "E", {"s_s": 0.375}, "f_a", 2.1),
        ("asce7-05", "D", {"s_s": 1.125}, "f_a", 1.05),
        ("ibc2009", "A", {"s_s": 0.7}, "f_a", 0.8),
        ("asce7-16", "D", {"s_1": 0.15}, "f_v", 2.3),
        ("asce7-16", "B", {"s_1": 0.6}, "f_v", 0.8),
        ("asce7-10", "D", {"s_1": 0.45}, "f_v", 1.55),
        ("asce7-05", "E", {"s_1": 0.9}, "f_v", 2.4),
        ("ibc2009", "C", {"s_1": 0.05}, "f_v", 1.7),
    ],
)
def test_coefficients_between_the_columns_and_beyond_them(code, site_class, given, name, value):
    at = {"s_1": 0.1, **given} if name == "f_a" else given
    assert made(code, site_class=site_class, **at).parameters[name] == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("code", "given", "told"),
    [
        ("asce7-16", {"site_class": "D", "s_1": 0.2}, 1),
        ("asce7-16", {"site_class": "D", "s_1": 0.19}, 0),
        ("asce7-16", {"site_class": "E", "s_s": 1.0, "s_1": 0.3}, 2),
        ("asce7-16", {"site_class": "E", "s_s": 0.9, "s_1": 0.1}, 0),
        ("asce7-16", {"site_class": "C", "s_1": 0.9}, 0),
        ("asce7-10", {"site_class": "E"}, 0),
    ],
)
def test_cases_that_need_a_study_of_the_site_cite_the_clause(code, given, told):
    warnings = made(code, **given).warnings
    assert len(warnings) == told
    assert all("11.4.8" in each.text for each in warnings)


@pytest.mark.parametrize(
    ("code", "clause"),
    [("asce7-05", "11.4.7"), ("ibc2009", "11.4.7"), ("asce7-10", "11.4.7"), ("asce7-16", "11.4.8")],
)
def test_class_f_is_refused(code, clause):
    with pytest.raises(SpectrumError, match=rf"site_class = F: .*{clause}"):
        made(code, site_class="F")


def test_classes_of_7_16_alone_are_unknown_before():
    with pytest.raises(SpectrumError, match=r"ASCE 7-10 Table 11\.4-1 has A, B, C, D, E"):
        made("asce7-10", site_class="D-default")
