"""Times, azimuths and places of real GeoNet and COSMOS files against what is said of them elsewhere.

Stations and directions: GeoNet's metadata, https://github.com/GeoNet/delta, network/stations.csv and
install/recorders.csv (revision 2faad417). A recorder's azimuth is that of its second axis; the first is 90 degrees on.
Earthquakes: the origin times and epicentres that the files' own headers print as text, copied by eye. The files are not
part of the project.
"""

from dataclasses import dataclass
from math import degrees

import pytest

from records.reading import read_records
from tests.support.places import REAL_RECORDS, needs_real_records

pytestmark = needs_real_records


@dataclass(frozen=True)
class Published:
    """Origin and epicentre as printed; station [deg, north, east] and azimuth of each component [deg] as published."""

    origin: str
    epicentre: tuple[float, float]
    station: tuple[float, float] | None
    azimuths: tuple[float | None, ...]


PUBLISHED = {
    # recorder CUSP3C 10462 from 2016-10-11 to 2017-06-26: azimuth 242
    "geonet_v2a/20161113_110259_WTMC_20.V2A": Published(
        "2016-11-13T11:02:56Z", (-42.69250, 173.02194), (-42.619455, 173.053596), (332.0, 242.0, None)
    ),
    # recorder BASALT 2413 from 2014-11-28 on: azimuth 106
    "geonet_v2a/20180212_211557_WPWS_20.V2A": Published(
        "2018-02-12T21:15:54Z", (-40.05750, 176.54583), (-39.943862, 176.584322), (196.0, 106.0, None)
    ),
    "cosmos/us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c": Published(
        "2018-11-30T17:29:29Z", (61.3464, -149.9552), None, (None,)
    ),
    # a made-up header on data of this earthquake; its channel points to 340 degrees
    "cosmos/Cosmos12TimeSeriesTest.v1": Published("2005-06-16T20:53:26.1Z", (34.058, -117.011), None, (340.0,)),
}


@pytest.mark.parametrize("name", PUBLISHED)
def test_a_file_says_what_is_published_of_it(name: str) -> None:
    published = PUBLISHED[name]
    found = read_records(REAL_RECORDS / name)
    for record, azimuth in zip(found, published.azimuths, strict=True):
        assert record.earthquake.time == published.origin
        assert (record.earthquake.latitude, record.earthquake.longitude) == pytest.approx(published.epicentre, abs=2e-5)
        assert (None if record.azimuth is None else degrees(record.azimuth)) == pytest.approx(azimuth, abs=0.5)
        if published.station is not None:
            place = (record.site.latitude, record.site.longitude)
            assert place == pytest.approx(published.station, abs=1.0 / 3600.0)


def test_western_longitudes_are_negative() -> None:
    """The Alaska network's BMR, Bremner River: 60.9677 N, 144.6051 W by the file's text and its numbers alike."""
    (record,) = read_records(REAL_RECORDS / "cosmos" / "us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c")
    assert (record.site.latitude, record.site.longitude) == pytest.approx((60.9677, -144.6051), abs=1e-4)
    assert record.warnings == ()
