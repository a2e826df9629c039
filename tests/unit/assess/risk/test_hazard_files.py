"""Hazard curves of OpenQuake, as several of its versions write them, and plain columns."""

from __future__ import annotations

import numpy as np
import pytest

from assess.errors import HazardError
from assess.risk.hazard import read_hazard
from tests.support.files import write_file

NEW = """\
#,,,,"generated_by='OpenQuake engine 3.18.0', start_date='2023-10-03T06:09:08', checksum=2107362341, kind='mean', \
investigation_time=50.0, imt='PGA'"
lon,lat,depth,poe-0.0050000,poe-0.1000000,poe-0.4000000,poe-0.6000000
13.40000,42.35000,0.00000,1.000000E+00,4.553860E-01,5.754042E-02,6.354511E-03
16.10000,39.30000,0.00000,1.000000E+00,1.522632E-01,1.000000E-02,0.000000E+00
"""
OLD = """\
# source_model_tree_path=('b1',), gsim_tree_path=('b1',), investigation_time=1.0,imt="PGA"
lon,lat,depth,poe-0.1,poe-0.4,poe-0.6
0.00000,0.00000,-0.10000,4.528811E-01,5.589804E-02,5.585141E-03
"""
TYPED = """\
#,,,"generated_by='OpenQuake engine 3.6.0', investigation_time=50.0"
lon:float32,lat:float32,depth:float32,poe-1.00000E-02:float32,poe-1.00000E+01:float32
13.4,42.35,0.0,4.553860E-01,5.754042E-02
"""
PGA = "hazard_curve-mean-PGA_23.csv"


def test_nearest_site_of_a_new_version(tmp_path):
    found = read_hazard(write_file(tmp_path / PGA, NEW), longitude=13.5, latitude=42.3)
    np.testing.assert_allclose(found.curve.intensity, [0.1, 0.4, 0.6])
    np.testing.assert_allclose(found.curve.annual_rate, -np.log(1 - np.array([0.455386, 0.05754042, 0.006354511])) / 50)
    assert (found.measure, found.period) == ("pga", None)
    assert found.distance == pytest.approx(np.hypot(5.56, 111.19 * 0.1 * np.cos(np.radians(42.3))), rel=1e-3)


def test_other_site_loses_what_never_happens(tmp_path):
    found = read_hazard(write_file(tmp_path / PGA, NEW), longitude=16.0, latitude=39.0)
    np.testing.assert_allclose(found.curve.intensity, [0.1, 0.4])


def test_a_site_far_from_all_of_the_file_is_refused(tmp_path):
    with pytest.raises(HazardError, match=r"nearest site is 3\d\d km from longitude 9\.2, latitude 45\.5"):
        read_hazard(write_file(tmp_path / PGA, NEW.replace("16.10000,39.3", "12.5,42.9")), longitude=9.2, latitude=45.5)


def test_only_site_needs_no_place(tmp_path):
    found = read_hazard(write_file(tmp_path / PGA, OLD))
    np.testing.assert_allclose(found.curve.annual_rate, -np.log(1 - np.array([0.4528811, 0.05589804, 0.005585141])))
    assert found.distance is None


def test_measure_is_taken_from_the_name_where_the_comment_has_none(tmp_path):
    speed = read_hazard(write_file(tmp_path / "hazard_curve-mean-PGV_1.csv", TYPED))
    np.testing.assert_allclose(speed.curve.intensity, [1e-4, 0.1])  # cm/s in the file, m/s here
    assert speed.measure == "pgv"
    spectral = read_hazard(write_file(tmp_path / "quantile_curve-0.15-SA(0.5)_1.csv", TYPED))
    assert (spectral.measure, spectral.period) == ("sa", 0.5)


@pytest.mark.parametrize("quoted", ["imt='SA(0.3)'", 'imt=""SA(0.3)""', 'imt=\\"SA(0.3)\\"', "imt=SA(0.3)"])
def test_quotes_of_the_comment(tmp_path, quoted):
    found = read_hazard(write_file(tmp_path / PGA, OLD.replace('imt="PGA"', quoted)))
    assert (found.measure, found.period) == ("sa", 0.3)


def test_byte_order_mark_and_windows_lines(tmp_path):
    path = tmp_path / "hazard.csv"
    path.write_bytes(b"\xef\xbb\xbf" + OLD.replace("\n", "\r\n").encode())
    assert read_hazard(path).measure == "pga"


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("imt='PGA'", "imt='AvgSA'"), 'intensity measure "AvgSA" cannot be used'),
        (("imt='PGA'", "imt='SA'"), 'intensity measure "SA" cannot be used'),
        (("investigation_time=50.0", "kind=1"), "gives no investigation_time"),
        (("1.522632E-01", "abc"), '"abc" in "poe-0.1000000" is not a number'),
        (("1.522632E-01", "1.5"), "not between 0 and 1"),
        (("1.522632E-01", "0.0001"), "the annual rate rises"),
        (("1.522632E-01,1.000000E-02", "1.0,1.0"), "fewer than two"),
        ((",1.000000E-02,0.000000E+00", ""), "site 2 has another number of columns"),
        (("1.522632E-01", "١.٥E-٠١"), '"١.٥E-٠١" in "poe-0.1000000" is not a number'),
        (("1.522632E-01", '"1.522632E-01'), "line 4: not a table in CSV (unexpected end of data); close each quote"),
        (("poe-0.1000000", "mm-0.1000000"), 'column "mm-0.1000000" is none of lon, lat'),
        (("lon,lat", "x,y"), "2 sites and no columns lon and lat"),
    ],
)
def test_what_cannot_be_read_is_one_line_with_the_file(tmp_path, change, words):
    path = write_file(tmp_path / PGA, NEW.replace(*change))
    with pytest.raises(HazardError) as caught:
        read_hazard(path, longitude=16.0, latitude=39.0)
    assert str(caught.value).startswith(str(path))
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_several_sites_ask_for_a_place(tmp_path):
    with pytest.raises(HazardError, match="2 sites; give longitude and latitude"):
        read_hazard(write_file(tmp_path / PGA, NEW))


def test_nothing_tells_the_measure(tmp_path):
    with pytest.raises(HazardError, match="keep the name that OpenQuake gave it"):
        read_hazard(write_file(tmp_path / "mine.csv", TYPED))


@pytest.mark.parametrize(
    ("text", "intensity", "rates", "measure"),
    [
        ("pga [g], annual_rate [1/year]\n0.1, 1e-2\n0.3, 1e-3\n", [0.1, 0.3], [1e-2, 1e-3], "pga"),
        ("PGA (m/s2);T_R (years)\n2,943;1000\n0,980665;100\n", [0.1, 2.943 / 9.80665], [1e-2, 1e-3], "pga"),
        ("pgv [cm/s]\trate\n5\t1e-2\n50\t1e-3\n", [0.05, 0.5], [1e-2, 1e-3], "pgv"),
    ],
)
def test_plain_columns(tmp_path, text, intensity, rates, measure):
    found = read_hazard(write_file(tmp_path / "site.csv", text))
    np.testing.assert_allclose(found.curve.intensity, intensity, rtol=1e-12)
    np.testing.assert_allclose(found.curve.annual_rate, rates, rtol=1e-12)
    assert found.measure == measure


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("0.1, 1e-2\n0.3, 1e-3\n", "gives no unit for the intensity"),
        ("pga [kg], rate\n0.1, 1e-2\n0.3, 1e-3\n", 'unit "kg" is not known'),
        ("pga [m/s], rate\n0.1, 1e-2\n0.3, 1e-3\n", 'unit "m/s" is not known'),
        ("Sa [g], rate\n0.1, 1e-2\n0.3, 1e-3\n", "neither pga nor pgv"),
        ("im [-], rate\n0.5, 1e-2\n2, 1e-3\n", "neither pga nor pgv"),
        ("pga [g], rate [1/s]\n0.1, 1e-2\n0.3, 1e-3\n", 'unit "1/s" of the second column'),
        ("pga [g], rate\n0.1, 1e-2\n", "at least two rows"),
        ("pga [g], T_R [years]\n0.1, 0\n0.3, 100\n", "annual rate inf"),
        ("pga [g], rate\n٠.١, 1e-2\n0.3, 1e-3\n", "is not two numbers"),
        ("", "the file is empty"),
    ],
)
def test_plain_columns_that_cannot_be_read(tmp_path, text, words):
    path = write_file(tmp_path / "site.csv", text)
    with pytest.raises(HazardError) as caught:
        read_hazard(path)
    assert str(caught.value).startswith(str(path))
    assert words in str(caught.value)


def test_missing_file_is_one_line(tmp_path):
    with pytest.raises(HazardError, match="the file cannot be read"):
        read_hazard(tmp_path / "none.csv")
