"""Spectra given point by point, and the files that hold them."""

from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from spectra.columns import ColumnError, read_columns
from spectra.errors import SpectrumError
from spectra.table import read_table, table_spectrum
from tests.support.files import refused_in_one_line, write_file

T, S_A = [0.0, 0.1, 0.5, 2.0], [1.0, 2.5, 2.5, 0.6]


@pytest.mark.parametrize("row", ["٠.٥, 0.3", "0.5, ٣", "0.5, 1_0", "０.５, 0.3"])
def test_other_digits_than_0_to_9_are_no_numbers(tmp_path: Path, row: str) -> None:
    (tmp_path / "site.csv").write_text(f"period [s], acceleration [g]\n0, 0.2\n{row}\n", encoding="utf-8")
    with pytest.raises(ColumnError, match=r"line 3: .* is not two numbers"):
        read_columns(tmp_path / "site.csv")


def test_ordinates_are_linear_between_points_and_zero_period_is_the_pga() -> None:
    spectrum = table_spectrum(T, S_A)
    np.testing.assert_allclose(
        spectrum.acceleration([0.0, 0.05, 0.3, 1.25, 2.0]), [1.0, 1.75, 2.5, 1.55, 0.6], rtol=1e-12
    )
    assert spectrum.pga == 1.0


def test_a_table_without_zero_period_needs_its_pga() -> None:
    with pytest.raises(SpectrumError, match=r"starts at 0\.1 s.*give pga"):
        table_spectrum(T[1:], S_A[1:])
    np.testing.assert_array_equal(
        table_spectrum(T[1:], S_A[1:], pga=1.0).acceleration([0.0, 0.07, 1.1]),
        table_spectrum(T, S_A).acceleration([0.0, 0.07, 1.1]),
    )


def test_a_peak_acceleration_beside_an_entry_at_zero_period_changes_nothing() -> None:
    np.testing.assert_array_equal(table_spectrum(T, S_A, pga=1.2).acceleration(T), S_A)


@pytest.mark.parametrize("period", [2.001, -0.1, float("nan")])
def test_outside_the_table_nothing_is_guessed(period: float) -> None:
    with pytest.raises(SpectrumError, match="0 to 2 s"):
        table_spectrum(T, S_A).acceleration([1.0, period])


def test_damping_keeps_the_ground_and_scales_the_plateau_by_eta() -> None:
    spectrum = table_spectrum(T, S_A)
    eta = (10 / 25) ** 0.5
    np.testing.assert_allclose(
        spectrum.acceleration([0.0, 0.1, 2.0], damping=0.2), [1.0, 2.5 * eta, 0.6 * eta], rtol=1e-12
    )
    assert "3.6" in spectrum.damping_rule


def test_a_table_at_another_damping_goes_back_to_five_per_cent() -> None:
    eta = (10 / 7) ** 0.5
    two_per_cent = table_spectrum(T, [1.0, 2.5 * eta, 2.5 * eta, 0.6 * eta], damping=0.02)
    assert two_per_cent.acceleration([0.3])[0] == pytest.approx(2.5 * eta, rel=1e-12)
    np.testing.assert_allclose(two_per_cent.acceleration(T, damping=0.05), S_A, rtol=1e-12)


def test_a_table_that_only_falls_keeps_its_zero_period() -> None:
    spectrum = table_spectrum([0.0, 1.0, 2.0], [3.0, 2.0, 1.0])
    np.testing.assert_allclose(spectrum.acceleration([0.0, 2.0], damping=0.2), [3.0, 0.4**0.5], rtol=1e-12)


@pytest.mark.parametrize(
    ("period", "acceleration", "words"),
    [
        ([0.0, 0.2, 0.1], [1.0, 2.0, 2.0], r"point 3: period 0\.1 s .* sort"),
        ([0.0, 0.2, 0.2], [1.0, 2.0, 2.0], "each period once"),
        ([0.0, 0.2], [1.0, float("nan")], "point 2: acceleration nan"),
        ([0.0, float("inf")], [1.0, 1.0], "point 2: period inf"),
        ([-0.1, 0.2], [1.0, 2.0], r"period -0\.1 s"),
        ([0.0, 0.2], [1.0, -2.0], "point 2: acceleration -2"),
        ([0.0, 0.2], [0.0, 2.0], "point 1: acceleration 0"),
        ([0.0], [1.0], "one point"),
        ([], [], "0 periods"),
        (["a", 1.0], [1.0, 2.0], "as rows of numbers"),
        ([None, {}], [1.0, 2.0], "as rows of numbers"),
        ([0.0, 1.0], [1.0], "2 periods and 1 accelerations"),
    ],
)
def test_points_that_make_no_spectrum_are_refused(period: list[float], acceleration: list[float], words: str) -> None:
    with pytest.raises(SpectrumError, match=words):
        table_spectrum(period, acceleration)


@pytest.mark.parametrize("pga", [0.0, -1.0, float("nan")])
def test_a_peak_acceleration_that_is_none_is_refused(pga: float) -> None:
    with pytest.raises(SpectrumError, match="pga"):
        table_spectrum([0.1, 0.2], [1.0, 1.0], pga=pga)


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("period [s], acceleration [g]\n0, 0.1\n0.5, 0.2\n", g),
        ("T (s);Sa (m/s2)\n0;0,1\n0,5;0,2\n", 1.0),
        ("# from a site study\n\nT [ms]\tSa [cm/s^2]\n0\t0.1\n500\t0.2\n", 0.01),
        ("T [s]   Sa [gal]\r\n0    0.1\r\n0.5  2E-1\r\n", 0.01),
        ("\ufeffPeriod (sec),Sa (m/s²)\n0,0.1\n.5,0.2", 1.0),
    ],
)
def test_files_in_the_usual_dresses_are_read(tmp_path: Path, text: str, unit: float) -> None:
    path = tmp_path / "spectrum.csv"
    path.write_text(text, encoding="utf-8", newline="")
    np.testing.assert_allclose(
        read_table(path).acceleration([0.0, 0.25, 0.5]), np.array([0.1, 0.15, 0.2]) * unit, rtol=1e-12
    )


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "the file is empty"),
        (b"\n  \n# nothing\n", "the file is empty"),
        (b"period [s], acceleration [g]\n", "no numbers below the header"),
        (b"period, acceleration [g]\n0,1\n1,1\n", "no unit for the period"),
        (b"period [s], acceleration\n0,1\n1,1\n", "no unit for the acceleration"),
        (b"0,1\n1,1\n", "no unit for the period"),
        (b"period [h], acceleration [g]\n0,1\n1,1\n", 'unit "h" is not known; choose one of s, ms'),
        (b"period [s], acceleration [ft/s2]\n0,1\n1,1\n", 'unit "ft/s2" is not known'),
        (b"period [s], acceleration [g]\n0,1\n1,abc\n", 'line 3: "1,abc" is not two numbers'),
        (b"period [s], acceleration [g]\n0,1\n1,\n", "line 3"),
        (b"period [s], acceleration [g]\n0,1\n1,2,3\n", "line 3: .* has 3 columns"),
        (b"period [s], acceleration [g], damping\n0,1,2\n", "3 columns in the header"),
        (b"period [s], acceleration [g]\n0,1\n1,nan\n", "point 2: acceleration nan"),
        (b"period [s], acceleration [g]\n0,1\n1,1\n1,1\n", "point 3: period 1 s"),
        (bytes(range(256)) * 8, "not a text file"),
        (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR", "not a text file"),
    ],
)
def test_files_that_cannot_be_read_give_one_clear_line(tmp_path: Path, data: bytes, words: str) -> None:
    path = write_file(tmp_path / "junk.csv", data)
    with refused_in_one_line(SpectrumError, path, words):
        read_table(path)
