"""Real files of every format against an index made by an independent parser. The files are not part of the project."""

from itertools import groupby

import numpy as np
import pytest
from scipy.constants import g

from records.reading import read_records
from records.record import Record
from tests.support.places import REAL_RECORDS, index_rows, needs_real_records

pytestmark = needs_real_records

FILES = [(name, list(rows)) for name, rows in groupby(index_rows(), key=lambda row: row["file"])]
IN_G = ("SortedEQFile", "ARL360")  # of the plain files, whose unit is not in the file; the others are in m/s2


def read_listed(name: str) -> tuple[Record, ...]:
    """The records of a file; unit and step are given where the file states neither."""
    if not name.startswith("plain/"):
        return read_records(REAL_RECORDS / name)
    unit = "g" if any(word in name for word in IN_G) else "m/s2"
    return read_records(REAL_RECORDS / name, unit=unit, step=0.02 if "ARL360" in name else None)


def test_the_index_lists_131_components_in_121_files() -> None:
    assert (len(FILES), sum(len(rows) for _, rows in FILES)) == (121, 131)


@pytest.mark.parametrize(("name", "rows"), FILES, ids=lambda value: value if isinstance(value, str) else "")
def test_a_file_is_as_the_index_says(name: str, rows: list[dict[str, str]]) -> None:
    found = read_listed(name)
    assert len(found) == len(rows)
    for record, row in zip(found, rows, strict=True):
        assert record.npts == int(row["npts"])
        assert record.dt == pytest.approx(float(row["dt_s"]), rel=1e-12)
        assert record.pga / g == pytest.approx(float(row["pga_g"]), rel=6e-6)  # six printed digits


@pytest.mark.parametrize(("name", "rows"), FILES, ids=lambda value: value if isinstance(value, str) else "")
def test_the_year_and_magnitude_of_a_header_are_those_of_the_index(name: str, rows: list[dict[str, str]]) -> None:
    for record, row in zip(read_listed(name), rows, strict=True):
        quake = record.earthquake
        if quake.time:
            assert quake.time[:4] == row["year"]
        if quake.magnitude is not None and row["magnitude"]:
            scales = {"Mw": 0.11, "ML": 0.25, "MJMA": 0.11, "M": 0.01}  # the index has moment magnitudes for some
            assert quake.magnitude == pytest.approx(float(row["magnitude"]), abs=scales[quake.scale])


def test_el_centro_in_three_files_of_plain_numbers_is_one_motion() -> None:
    first, second = (read_records(REAL_RECORDS / "plain" / name)[0] for name in ("elCentro.AT2", "elCentro.at2"))
    (bare,) = read_records(REAL_RECORDS / "plain" / "ARL360.g3", unit="g", step=0.02)
    for other in (second, bare):
        assert (first.npts, first.dt) == (other.npts, other.dt)
        np.testing.assert_allclose(first.acceleration, other.acceleration, rtol=0, atol=1e-12)


def test_two_columns_without_units_hold_the_same_motion_as_the_at2_file() -> None:
    (plain,) = read_records(REAL_RECORDS / "plain" / "SortedEQFile_(121321).txt", unit="g")
    (record,) = read_records(REAL_RECORDS / "peer_at2" / "RIO270.AT2")
    assert plain.dt == record.dt
    np.testing.assert_allclose(plain.acceleration[1:], record.acceleration, rtol=6e-6)  # six decimals of 0.1…


def test_components_of_one_station_lie_level_at_right_angles_or_upright() -> None:
    azimuths = [record.azimuth for record in read_records(REAL_RECORDS / "geonet_v2a" / "20161113_110259_WTMC_20.V2A")]
    assert azimuths[0] is not None
    assert azimuths[1] is not None
    assert np.degrees(azimuths[:2]) == pytest.approx([332.0, 242.0])
    assert azimuths[2] is None


@pytest.mark.parametrize(
    ("name", "event"),
    [
        ("knet/AOM0041801241951.EW", "2018-01-24 10:51, M6.2, 41.00N 142.50E"),
        ("kiknet/ISKH012401011610.EW2", "2024-01-01 07:10, M7.6, 37.49N 137.27E"),
        ("geonet_v2a/20161113_110259_WTMC_20.V2A", "5 km south-west of Waiau"),
        ("esm/20101114230825_3104_ap_RawAcc_E.asc", "2010-11-14 23:08, M5.1, 36.61N 35.99E"),
        ("esm/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", "GREECE"),
        ("itaca_cor_acc/16839_H1.cor.acc", "2009-04-06T01:32:39Z"),  # its header has no more
        ("csmip/CE89146.V1", "Mon Feb 13, 2012 13:06:45.0 PST"),
    ],
)
def test_an_earthquake_is_called_by_what_the_header_has(name: str, event: str) -> None:
    assert read_records(REAL_RECORDS / name)[0].event == event
