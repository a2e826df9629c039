"""Everything that a header states, by the published description of each format, arrives in its place and unit.

The files are written here, with all lines that the reader knows. What is expected is written beside them by hand, from
what stands in the header: an arc second is 1/3600 deg, Japan Standard Time is nine hours ahead, 1 km is 1000 m.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from records.errors import RecordError
from records.formats import FORMATS
from records.formats.header import NO_OVERRIDES
from records.record import Earthquake, Record, StationSite
from tests.support import record_files
from tests.support.files import write_file
from tests.support.record_files import columns

N, STEP = 400, 0.01
SHAPE = np.round(50.0 * np.sin(10 * np.pi * STEP * np.arange(N)) * np.hanning(N), 3)  # 5 Hz: within every filter below
PEAK, AT = float(np.abs(SHAPE).max()), float(STEP * np.argmax(np.abs(SHAPE)))
SPEED = STEP * np.concatenate([[0.0], np.cumsum((SHAPE[1:] + SHAPE[:-1]) / 2)])
LARGEST = float(SHAPE[np.argmax(np.abs(SHAPE))])
RMS = float(np.sqrt(np.mean(SHAPE**2)))
NOTHING: Mapping[int, float] = {}


@dataclass(frozen=True)
class Stated:
    """What a header says."""

    name: str  # of the file
    id: str
    event: str
    station: str
    component: str
    azimuth: float  # deg
    history: tuple[str, ...]
    earthquake: Earthquake
    site: StationSite
    distance: float | None = None  # m
    longest_period: float | None = None  # s
    start: str = ""


COUNTS = np.round(SHAPE * 1000.0).astype(int) + 7000
OFFSET = float(COUNTS.mean()) / 1000.0  # gal
KIK_NET = {
    "Origin Time": "2003/09/26 04:50:00",
    "Lat.": "41.780",
    "Long.": "144.078",
    "Depth. (km)": "42",
    "Mag.": "8.0",
    "Station Code": "TKCH08",
    "Station Lat.": "42.4839",
    "Station Long.": "143.1552",
    "Station Height(m)": "253",
    "Record Time": "2003/09/26 04:50:30",
    "Dir.": "2",
    "Scale Factor": "4(gal)/4000",
    "Last Correction": "2003/09/26 04:50:15",
}
"""NIED's ASCII format: 4(gal)/4000 is 0.001 gal a count; 2 is EW in the borehole."""
ITACA = {
    "Event Date & Time": "2009-04-06 01:32:39",
    "Station Code / Name": "AQV / L'Aquila",
    "Orientation": "NS",
    "Time Increment (s)": "0.01",
    "Filter Cut-off Frequency (Hz)": "0.10 - 40.00",
}
AFAD = {
    "EARTHQUAKE DATE": "1999/08/17 00:01:39 (HEADERS)",
    "EPICENTER COORDINATES": "40.76000N-29.97000E",
    "EARTHQUAKE DEPTH (km)": "18",
    "EARTHQUAKE MAGNITUDE": "7.4 Mw",
    "STATION ID": "5401",
    "STATION COORDINATES": "40.73707S-30.38006W",
    "STATION ALTITUDE (m)": "30",
    "RECORD TIME": "17/08/1999 00:01:30 (HEADERS)",
}
COSMOS = {
    2: "Record of Northridge Earthquake of Mon Jan 17, 1994  4:31 PST",
    3: "Hypocenter: 34.206  -118.554  H= 18km",
    4: "Origin: 01/17/1994, 12:30:55.4 UTC",
    5: "Statn No: 01-24087  Code:CE-24087  Arleta - Nordhoff Fire Sta",
    6: "Coords: 34.236  -118.439",
    9: "Sta Chan  1:  90 deg (Rcrdr Chan  1) Location:Ground",
}
COSMOS_REALS = {
    1: 34.236, 2: -118.439, 3: 272.0, 10: 34.206, 11: -118.554, 12: 17.5, 14: 6.8, 15: 6.4, 17: 11.25,
    62: 1000 * STEP, 63: N * STEP, 64: LARGEST, 65: AT,
}  # fmt: skip
"""1-3 place, 10-12 hypocentre, 13-15 Mw, Ms, ML, 17 distance, 62-65 step, length, peak and its time."""
CSMIP = {
    3: "Record of LOMA PRIETA EARTHQUAKE   OF OCT 17, 1989",
    4: "OCT 17, 1989 17:04 PDT   (ORIGIN(USGS): 10/17/89, 00:04:15.2 UTC)",
    5: "37.037N, 121.883W, H=18KM   ML=7.0",
    6: "STATION NO. 57007   37.046N, 121.803W   SMA-1  S/N 4384",
    7: "CORRALITOS - EUREKA CANYON RD      CDMG",
    8: "CHAN  3:  360 DEG",
    18: f"PEAK ACCELERATION =  {LARGEST:.3f}    CM/SEC/SEC  AT   {AT:.3f}   SEC.",
}
"""OSMS 85-03: the text of volume 2 in lines 1 to 25, its event in line 3, station in 7, channel in 8."""
V2A = {
    2: "Site KHZ       42 24 58S  173 32 20E     Cusp file:  made up",
    7: "15 km north-east of Culverden",
    8: "2016 November 13         11:02:56.3 UT",
    9: "Epicentre  42 41 33S 173 01 19E  Bearing N53E  Dist    54km  Depth   15km Mw 7.82",
    10: f"Number of points  {N}    Duration   {N * STEP:.2f} sec",
    11: "Instrument corrected data at 0.010 sec intervals",
    12: "Bandpass filter 0.10 - 40.00 Hz",
    13: "Component S33W  Longitudinal Accelerometer Axis",
    14: f"Acceleration:  peak  {LARGEST:.1f} mm/s/s at  {AT:.2f} sec     rms    {RMS:.1f} mm/s/s",
}
SMC = {
    3: "USGS",
    4: "     1979  10  15    2316 Imperial Valley",
    5: "Moment Mag=           Ms=      6.9 Ml=      6.6",
    6: "station = El Centro #9                   component=    230",
    7: f"epicentral dist =     29.5       pk     = {LARGEST:8.1f}",
}
SMC_REALS = {
    2: 100.0, 3: 32.614, 4: -115.318, 5: 12.1, 7: 6.9, 8: 6.6, 11: 32.829, 12: -115.504, 13: -15.0, 17: 29.5,
    29: STEP * np.argmax(SHAPE), 30: SHAPE.max(), 31: STEP * np.argmin(SHAPE), 32: SHAPE.min(),
}  # fmt: skip
"""OFR 92-296A: 2 rate, 3-5 hypocentre, 6-8 Mw, Ms, ML, 11-13 station, 17 distance, 29-32 peaks."""


def dyna(**changed: str) -> str:
    keys = {
        "EVENT_NAME": "AMATRICE",
        "EVENT_ID": "IT-2016-0001",
        "EVENT_DATE_YYYYMMDD": "20160824",
        "EVENT_TIME_HHMMSS": "013632",
        "EVENT_LATITUDE_DEGREE": "42.6983",
        "EVENT_LONGITUDE_DEGREE": "13.2335",
        "EVENT_DEPTH_KM": "8.1",
        "MAGNITUDE_W": "6.0",
        "MAGNITUDE_L": "5.9",
        "NETWORK": "IT",
        "STATION_CODE": "NRC",
        "STATION_NAME": "NORCIA",
        "STATION_LATITUDE_DEGREE": "42.7925",
        "STATION_LONGITUDE_DEGREE": "13.0964",
        "STATION_ELEVATION_M": "610",
        "SENSOR_DEPTH_M": "12.5",
        "VS30_M/S": "498",
        "SITE_CLASSIFICATION_EC8": "B",
        "EPICENTRAL_DISTANCE_KM": "15.3",
        "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS": "20160824_013630.500",
        "SAMPLING_INTERVAL_S": "0.01",
        "NDATA": f"{N}",
        "DURATION_S": f"{N * STEP:.2f}",
        "STREAM": "HGN",
        "UNITS": "cm/s^2",
        "PGA_CM/S^2": f"{LARGEST}",
        "TIME_PGA_S": f"{AT:.2f}",
        "LOW_CUT_FREQUENCY_HZ": "0.04",
        "HIGH_CUT_FREQUENCY_HZ": "40",
        "DATA_TYPE": "ACCELERATION",
    }
    return "".join(f"{key}: {value}\n" for key, value in {**keys, **changed}.items()) + columns(SHAPE, 1, ".6f")


def cosmos(reals: Mapping[int, float] = NOTHING) -> str:
    return record_files.cosmos(SHAPE, COSMOS, azimuth=90, reals={**COSMOS_REALS, **reals})


def smc(reals: Mapping[int, float] = NOTHING) -> str:
    integers = {2: 1979, 13: 90, 14: 230, 16: 0}
    return record_files.smc(SHAPE, SMC, integers=integers, reals={**SMC_REALS, **reals})


V2A_TEXT = record_files.v2a(V2A, SHAPE, SPEED, SPEED)
CSMIP_TEXT = record_files.csmip_2(CSMIP, SHAPE, number=3, step=STEP)
HEADERS = {
    "kik-net": (
        record_files.knet(COUNTS, KIK_NET),
        "K-NET/KiK-net",
        Stated(
            "TKCH080309260450.EW1",
            "TKCH080309260450.EW1",
            "2003-09-25 19:50, M8, 41.78N 144.08E",  # the evening before, in UTC
            "TKCH08",
            "EW1",
            90.0,
            ("read from K-NET/KiK-net, unit gal", f"mean of {OFFSET:.6g} gal taken off"),
            Earthquake("2003-09-25T19:50:00Z", 8.0, "MJMA", 41.78, 144.078, 42e3),
            StationSite(42.4839, 143.1552, 253.0, place="borehole"),
        ),
    ),
    "dyna": (
        dyna(),
        "ESM/ITACA DYNA",
        Stated(
            "a.asc",
            "a",
            "AMATRICE",
            "IT.NRC NORCIA",
            "HGN",
            0.0,
            ("read from ESM/ITACA DYNA, unit cm/s^2", "filtered by the source: 0.04 Hz to 40 Hz"),
            Earthquake("2016-08-24T01:36:32Z", 6.0, "Mw", 42.6983, 13.2335, 8.1e3),
            StationSite(42.7925, 13.0964, 610.0, 498.0, "EC8 B", "12.5 m deep"),
            distance=15.3e3,
            longest_period=20.0,  # 1 / (1.25 · 0.04 Hz)
            start="2016-08-24T01:36:30.5Z",
        ),
    ),
    "itaca": (
        record_files.itaca(SHAPE, ITACA),
        "ITACA cor.acc",
        Stated(
            "a.acc",
            "a",
            "2009-04-06T01:32:39Z",
            "AQV / L'Aquila",
            "NS",
            0.0,
            ("read from ITACA cor.acc, unit m/s/s", "filtered by the source: 0.10 - 40.00 Hz"),
            Earthquake("2009-04-06T01:32:39Z"),
            StationSite(),
            longest_period=8.0,  # 1 / (1.25 · 0.10 Hz)
        ),
    ),
    "afad": (
        record_files.afad(np.column_stack([SHAPE] * 3), AFAD),
        "AFAD",
        Stated(
            "a.txt",
            "a N-S",
            "1999-08-17 00:01, M7.4, 40.76N 29.97E",
            "5401",
            "N-S",
            0.0,
            ("read from AFAD, unit gal",),
            Earthquake("1999-08-17T00:01:39Z", 7.4, "Mw", 40.76, 29.97, 18e3),
            StationSite(-40.73707, -30.38006, 30.0),
            start="1999-08-17T00:01:30Z",
        ),
    ),
    "cosmos": (
        cosmos(),
        "COSMOS",
        Stated(
            "a.v2",
            "a 90 deg",
            "Northridge Earthquake",
            "CE-24087 Arleta - Nordhoff Fire Sta",
            "90 deg",
            90.0,
            ("read from COSMOS, unit cm/sec2", "Corrected acceleration"),
            Earthquake("1994-01-17T12:30:55.4Z", 6.4, "ML", 34.206, -118.554, 17.5e3),  # ML before Ms
            StationSite(34.236, -118.439, 272.0),
            distance=11.25e3,
        ),
    ),
    "csmip": (
        CSMIP_TEXT,
        "CSMIP",
        Stated(
            "a.v2",
            "a chan 3",
            "LOMA PRIETA EARTHQUAKE",
            "57007 CORRALITOS - EUREKA CANYON RD",
            "360 DEG",
            0.0,
            ("read from CSMIP volume 2, unit CM/SEC/SEC",),
            Earthquake("1989-10-17T00:04:15.2Z", 7.0, "ML", 37.037, -121.883, 18e3),
            StationSite(37.046, -121.803),
        ),
    ),
    "v2a": (
        V2A_TEXT,
        "GeoNet V2A",
        Stated(
            "a.V2A",
            "a S33W",
            "15 km north-east of Culverden",
            "KHZ",
            "S33W",
            213.0,
            ("read from GeoNet V2A, unit mm/s/s", "Bandpass filter 0.10 - 40.00 Hz"),
            Earthquake(
                "2016-11-13T11:02:56.3Z", 7.82, "Mw", -(42 + 41 / 60 + 33 / 3600), 173 + 1 / 60 + 19 / 3600, 15e3
            ),
            StationSite(-(42 + 24 / 60 + 58 / 3600), 173 + 32 / 60 + 20 / 3600),
            distance=54e3,
        ),
    ),
    "smc": (
        smc(),
        "SMC",
        Stated(
            "a.smc",
            "a",
            "Imperial Valley",
            "El Centro #9",
            "230",
            230.0,
            ("read from SMC, unit cm/s2 by the format", "corrected accelerogram"),
            Earthquake("1979-10-15T23:16:00Z", 6.6, "ML", 32.614, -115.318, 12.1e3),  # ML before Ms
            StationSite(32.829, -115.504, -15.0),
            distance=29.5e3,
        ),
    ),
    "at2": (
        record_files.at2(
            SHAPE / 1000,
            title="LOMA PRIETA EQ 10/18/89 0005, CORRALITOS, 090 (CDMG STATION 57007)",
            units="ACCELERATION TIME HISTORY IN UNITS OF G",
            line=f"{N}   0.0100  NPTS, DT",
        ),
        "PEER AT2",
        Stated(
            "a.AT2",
            "a",
            "LOMA PRIETA",
            "CORRALITOS",
            "090",
            90.0,
            ("read from PEER AT2, unit g, event of 10/18/89",),
            Earthquake("1989-10-18"),
            StationSite(),
        ),
    ),
}
"""By format: the text of a file, the reader's name, and what stands in the file."""


def read(folder: Path, form: str, name: str, text: str) -> Record:
    return FORMATS[form].read(write_file(folder / name, text, encoding="latin-1"), NO_OVERRIDES)[0]


@pytest.mark.parametrize("name", HEADERS)
def test_a_whole_header(tmp_path: Path, name: str) -> None:
    text, form, stated = HEADERS[name]
    found = read(tmp_path, form, stated.name, text)
    assert (found.id, found.event, found.station, found.component) == (
        stated.id, stated.event, stated.station, stated.component,
    )  # fmt: skip
    assert found.path == str(tmp_path / stated.name)
    assert found.azimuth == pytest.approx(radians(stated.azimuth), abs=1e-12)
    assert tuple(map(str, found.processing_history)) == stated.history
    assert same(found.earthquake, stated.earthquake)
    assert same(found.site, stated.site)
    assert found.distance == near(stated.distance)
    assert found.longest_period == near(stated.longest_period)
    assert found.start == stated.start
    assert found.warnings == ()
    assert found.dt == STEP


def same(one: Earthquake | StationSite, other: Earthquake | StationSite) -> bool:
    """Whether all that is known is the same."""
    return vars(one) == {key: near(value) for key, value in vars(other).items()}


def near(value: Any) -> Any:
    """The value, or if it is a number what is equal to it within rounding."""
    return pytest.approx(value, rel=1e-12) if isinstance(value, float) else value


# ------------------------------------------------------------------------------------------------- which of several


@pytest.mark.parametrize(("stated", "magnitude", "scale"), [
    ({}, 6.0, "Mw"), ({"MAGNITUDE_W": ""}, 5.9, "ML"), ({"MAGNITUDE_W": "", "MAGNITUDE_L": ""}, None, ""),
])  # fmt: skip
def test_the_moment_magnitude_goes_first_in_dyna(
    tmp_path: Path, stated: dict[str, str], magnitude: float | None, scale: str
) -> None:
    quake = read(tmp_path, "ESM/ITACA DYNA", "a.asc", dyna(**stated)).earthquake
    assert (quake.magnitude, quake.scale) == (magnitude, scale)


@pytest.mark.parametrize(("stated", "magnitude", "scale"), [
    ({13: 6.7}, 6.7, "Mw"), ({15: -999.0}, 6.8, "Ms"), ({14: -999.0, 15: -999.0}, None, ""),
])  # fmt: skip
def test_the_moment_magnitude_goes_first_in_cosmos(
    tmp_path: Path, stated: dict[int, float], magnitude: float | None, scale: str
) -> None:
    quake = read(tmp_path, "COSMOS", "a.v2", cosmos(stated)).earthquake
    assert (quake.magnitude, quake.scale) == (magnitude, scale)


@pytest.mark.parametrize(("stated", "magnitude", "scale"), [
    ({6: 6.5}, 6.5, "Mw"), ({8: 1.7e38}, 6.9, "Ms"), ({7: 1.7e38, 8: 1.7e38}, None, ""),
])  # fmt: skip
def test_the_moment_magnitude_goes_first_in_smc(
    tmp_path: Path, stated: dict[int, float], magnitude: float | None, scale: str
) -> None:
    quake = read(tmp_path, "SMC", "a.smc", smc(stated)).earthquake
    assert (quake.magnitude, quake.scale) == (magnitude, scale)


@pytest.mark.parametrize(("low", "high", "history"), [
    ("0.04", "", ["filtered by the source: from 0.04 Hz"]),
    ("", "40", ["filtered by the source: 0 Hz to 40 Hz"]),
    ("", "", []),
])  # fmt: skip
def test_a_filter_of_dyna_with_one_corner(tmp_path: Path, low: str, high: str, history: list[str]) -> None:
    found = read(tmp_path, "ESM/ITACA DYNA", "a.asc", dyna(LOW_CUT_FREQUENCY_HZ=low, HIGH_CUT_FREQUENCY_HZ=high))
    assert list(map(str, found.processing_history[1:])) == history
    assert found.longest_period == (pytest.approx(20.0) if low else None)


def test_a_channel_of_cosmos_is_named_by_its_scnl(tmp_path: Path) -> None:
    """Station, channel, network, location, as the comment of v1.20 gives them."""
    found = read(tmp_path, "COSMOS", "a.v2", cosmos().replace("| made up", "|<SCNL>24087.HNE.CE.01"))
    assert (found.station, found.component) == ("CE.24087", "HNE")


def test_unknown_numbers_of_a_header_are_none(tmp_path: Path) -> None:
    """-999 of COSMOS and 1.7e38 of SMC are no depth and no distance."""
    one = read(tmp_path, "COSMOS", "a.v2", cosmos({12: -999.0, 17: -999.0}))
    other = read(tmp_path, "SMC", "a.smc", smc({5: 1.7e38, 17: 1.7e38}))
    assert [(each.earthquake.depth, each.distance) for each in (one, other)] == [(None, None)] * 2


# -------------------------------------------------------------------------------------------- what a header says twice


@pytest.mark.parametrize(("name", "old", "new", "words"), [
    ("cosmos", "Coords: 34.236", "Coords: 34.246", "latitude"),
    ("cosmos", "Coords: 34.236  -118.439", "Coords: 34.236  118.439", "longitude"),
    ("cosmos", "Hypocenter: 34.206", "Hypocenter: 35.206", "epicentre's latitude"),
    ("cosmos", "34.206  -118.554", "34.206  -119.554", "epicentre's longitude"),
    ("smc", "     1979  10", "     1978  10", "year"),
    ("smc", "epicentral dist =     29.5", "epicentral dist =     92.5", "distance"),
    ("smc", f"pk     = {LARGEST:8.1f}", f"pk     = {-LARGEST:8.1f}", "peak"),
    ("v2a", "rms    ", "rms   1", "stated rms"),
])  # fmt: skip
def test_a_header_that_disagrees_with_its_own_numbers_is_doubted(
    tmp_path: Path, name: str, old: str, new: str, words: str
) -> None:
    text, form, _ = HEADERS[name]
    assert old in text
    assert [words in str(each) for each in read(tmp_path, form, "a.dat", text.replace(old, new)).warnings] == [True]


@pytest.mark.parametrize(("name", "doubted"), [("IT.NRC.00.HGN.D.asc", False), ("IT.NRC.00.HGE.D.asc", True)])
def test_a_dyna_file_named_for_another_stream_is_doubted(tmp_path: Path, name: str, doubted: bool) -> None:
    assert bool(read(tmp_path, "ESM/ITACA DYNA", name, dyna()).warnings) == doubted


def test_a_count_of_csmip_that_is_wrong_is_named_with_its_line(tmp_path: Path) -> None:
    """25 lines of text stand above the line of points."""
    with pytest.raises(RecordError, match=f"{tmp_path}/a.v2: line 26 says {N + 8} samples, the file holds {N}"):
        read(tmp_path, "CSMIP", "a.v2", CSMIP_TEXT.replace(f"{N} POINTS", f"{N + 8} POINTS"))
