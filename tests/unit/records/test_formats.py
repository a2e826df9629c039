"""Every format of text, in made-up files: what is read, what is refused, and that no damage passes or hangs.

Real files are in tests/validation/record_files; obspy's formats in test_by_obspy.py.
"""

import random
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.constants import g

from records.errors import RecordError
from records.formats import FORMATS, by_obspy
from records.reading import read_records
from records.record import Earthquake, Record, make_record
from tests.support import record_files
from tests.support.files import refused_in_one_line, write_file
from tests.support.record_files import columns, head, keyed

N = 40
VALUES = np.round(np.random.default_rng(7).normal(size=N) * 20.0, 2)  # in the unit of the file
PEAK = float(VALUES[np.argmax(np.abs(VALUES))])
AT = int(np.argmax(np.abs(VALUES)))  # the sample that it is
RMS = float(np.sqrt(np.mean(VALUES**2)))
SCALES = (1.0, -0.5, 0.25)  # of the components in one file


COUNTS = np.round(VALUES * 1000).astype(int) + 4321
DYNA = {
    "EVENT_NAME": "SOMEWHERE",
    "EVENT_DATE_YYYYMMDD": "20190728",
    "EVENT_TIME_HHMMSS": "160908",
    "EVENT_DEPTH_KM": "9.0",
    "MAGNITUDE_W": "",
    "MAGNITUDE_L": "4.6",
    "NETWORK": "XX",
    "STATION_CODE": "ABC",
    "VS30_M/S": "688",
    "EPICENTRAL_DISTANCE_KM": "12.5",
    "SAMPLING_INTERVAL_S": "0.005000",
    "NDATA": f"{N}",
    "STREAM": "HNE",
    "UNITS": "cm/s^2",
    "PGA_CM/S^2": f"{PEAK}",
    "DATA_TYPE": "ACCELERATION",
    "USER5": "",
}
ITACA = {
    "Event Date & Time": "2009-04-06 01:32:39",
    "Station Code / Name": "1 / Somewhere",
    "Orientation": "WE",
    "Time Increment (s)": "0.005",
}
AFAD = {
    "EARTHQUAKE DATE": "2017/07/20 22:31:09 (GMT)",
    "EPICENTER COORDINATES": "36.91980N-27.44350E",
    "EARTHQUAKE MAGNITUDE": "6.5 Mw",
    "STATION ID": "4819",
}
COSMOS = {
    2: "Record of Somewhere Earthquake of Fri Nov 30, 2018 17:29 UTC",
    3: "Hypocenter: 34.0580  -117.0110  H= 12km",
    4: "Origin: 06/16/2005, 20:53:26.1 UTC",
    5: "Statn No: 01-1  Code:XX-J1  Some School",
    9: "Sta Chan  1: 340 deg (Rcrdr Chan  1) Location:",
}
CSMIP_1 = {
    1: "Uncorrected Accelerogram Data",
    6: "Some School                               CGS",
    7: "Chan  1: 360 Deg",
    12: f"Units of uncor data are sec and g .        Max  =  {PEAK:.3f} g , at  {0.005 * AT:.3f} sec.",
    14: f" {N} Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)",
}
CSMIP_2 = {
    3: "SOMEWHERE EARTHQUAKE",
    4: "MAY 2, 1983 16:42 PDT                   (ORIGIN(BRK): 05/02/83, 23:42:38.5 UTC)",
    6: "STATION NO. 36456   35.908N, 120.458W     SMA-1  S/N 4384",
    7: "SOME SCHOOL",
}
V2A = {
    2: "Site ABCD      42 37 10S  173 03 13E     Cusp file:  made up",
    7: "5 km south-west of Somewhere",
    8: "2016 November 13         11:02:56 UT",
    9: "Epicentre  42 41 33S 173 01 19E  Bearing S18W  Dist    9km  Depth   15km Mw 7.82",
    10: f"Number of points  {N}    Duration   0.78 sec",
    11: "Instrument corrected data at 0.020 sec intervals",
}
SMC = {
    3: "XX",
    4: "     1989  10  18    0004 Somewhere, CA",
    5: "Moment Mag=      7.1 Ms=      7.1 Ml=      7.0",
    6: "station = Some School, F                 component=    360",
    7: f"epicentral dist =     89.0       pk     = {PEAK:8.1f}",
}
SMC_REALS = {2: 200.0, 6: 7.1, 17: 89.0} | dict(
    enumerate((0.005 * VALUES.argmax(), VALUES.max(), 0.005 * VALUES.argmin(), VALUES.min()), 29)
)


def csmip_2() -> str:
    """Three channels, each of accelerations, velocities and displacements that are the same numbers."""
    text = ""
    for number, (direction, scale) in enumerate(zip(("90 DEG", "UP", "0 DEG"), SCALES, strict=True), 1):
        peak = f"PEAK ACCELERATION =  {PEAK * scale:.3f}    CM/SEC/SEC  AT   {0.02 * AT:.3f}   SEC."
        lines = {**CSMIP_2, 8: f"CHAN  {number}: {direction}", 18: peak}
        text += record_files.csmip_2(lines, *[VALUES * scale] * 3, number=number, step=0.02)
    return text


def v2a() -> str:
    """Three components, each of accelerations, velocities and displacements that are the same numbers."""
    text = ""
    for name, scale in zip(("N28W", "S62W", "Up"), SCALES, strict=True):
        peak = f"peak  {PEAK * scale:.1f} mm/s/s at  {0.02 * AT:.2f} sec     rms    {RMS * abs(scale):.1f} mm/s/s"
        lines = {**V2A, 13: f"Component {name}  Some Axis", 14: f"Acceleration:  {peak}"}
        text += record_files.v2a(lines, *[VALUES * scale] * 3)
    return text


CM, MM = 0.01, 0.001
# A file of three components needs its name in test_samples_step_and_unit.
MADE: dict[str, tuple[str, str, float, float]] = {  # text, format, m/s2 of a unit, step
    "k-net": (record_files.knet(COUNTS, {}), "K-NET/KiK-net", CM, 0.01),
    "dyna": (keyed(DYNA, "{}: {}") + columns(VALUES, 1, ".6f"), "ESM/ITACA DYNA", CM, 0.005),
    "itaca": (record_files.itaca(VALUES, ITACA), "ITACA cor.acc", 1.0, 0.005),
    "afad": (record_files.afad(np.outer(VALUES, SCALES), AFAD).replace("\n", "\r\n"), "AFAD", CM, 0.01),
    "cosmos": (
        record_files.cosmos(VALUES, COSMOS, azimuth=340, reals={13: 6.1, 62: 10.0, 64: PEAK}),
        "COSMOS",
        CM,
        0.01,
    ),
    "csmip-1": (
        head(14, CSMIP_1) + columns(VALUES, 8, "9.3f") + "/&  ----------  End of Data for Channel  1  ----------\n",
        "CSMIP",
        g,
        0.005,
    ),
    "csmip-2": (csmip_2(), "CSMIP", CM, 0.02),
    "v2a": (v2a(), "GeoNet V2A", MM, 0.02),
    "smc": (record_files.smc(VALUES, SMC, integers={16: 1}, reals=SMC_REALS), "SMC", CM, 0.005),
    "at2": (record_files.at2(VALUES), "PEER AT2", g, 0.01),
    "plain": (
        f"made up\nThe units are (g)\nNPTS= {N}, DT= .02 SEC\n" + columns(VALUES, 8, "10.3f"),
        "plain",
        g,
        0.02,
    ),
    "csv": (
        "time [s],acceleration [g]\n" + "".join(f"{i * 0.01:.2f},{a}\n" for i, a in enumerate(VALUES)),
        "CSV",
        g,
        0.01,
    ),
}


def written(folder: Path, name: str) -> Path:
    return write_file(folder / f"{name}.dat", MADE[name][0], encoding="latin-1")


@pytest.mark.parametrize("name", MADE)
def test_one_format_alone_looks_like_it(name: str) -> None:
    data = MADE[name][0].encode("latin-1")
    assert [known for known, each in FORMATS.items() if each.looks_like(data)] == [MADE[name][1]]


def test_every_format_of_text_has_a_file_here() -> None:
    made = {of for _, of, _, _ in MADE.values()} | {by_obspy.MINISEED, by_obspy.SAC}
    assert set(FORMATS) - made == set(), "add a small file of it to MADE"


@pytest.mark.parametrize("name", MADE)
def test_samples_step_and_unit(tmp_path: Path, name: str) -> None:
    _, _, factor, dt = MADE[name]
    found = read_records(written(tmp_path, name), unit="mm/s2", step=7.0)  # what the file says itself goes before
    expected = VALUES - VALUES.mean() if name == "k-net" else VALUES
    for record, scale in zip(found, SCALES, strict=False):
        assert record.dt == dt
        np.testing.assert_allclose(record.acceleration, factor * scale * expected, rtol=0, atol=6e-3 * factor)
    assert len(found) == (3 if name in ("afad", "csmip-2", "v2a") else 1)
    assert len({record.id for record in found}) == len(found)


def first(folder: Path, name: str) -> Record:
    return read_records(written(folder, name))[0]


@pytest.mark.parametrize(
    ("name", "event", "station", "component", "azimuth"),
    [
        ("k-net", "2018-01-24 10:51, M6.2, 41.00N 142.50E", "XYZ001", "E-W", 90),  # 19:51 Japan Standard Time
        ("dyna", "SOMEWHERE", "XX.ABC", "HNE", 90),
        ("itaca", "2009-04-06T01:32:39Z", "1 / Somewhere", "WE", 90),
        ("afad", "2017-07-20 22:31, M6.5, 36.92N 27.44E", "4819", "N-S", 0),
        ("cosmos", "Somewhere Earthquake", "XX-J1 Some School", "340 deg", 340),
        ("csmip-1", "text", "Some School", "360 Deg", 0),
        ("csmip-2", "SOMEWHERE EARTHQUAKE", "36456 SOME SCHOOL", "90 DEG", 90),
        ("v2a", "5 km south-west of Somewhere", "ABCD", "N28W", 332),
        ("smc", "Somewhere, CA", "Some School, F", "360", 0),
        ("at2", "Somewhere", "Some School", "21", 21),
    ],
)
def test_event_station_and_component(
    tmp_path: Path, name: str, event: str, station: str, component: str, azimuth: float
) -> None:
    record = first(tmp_path, name)
    assert (record.event, record.station, record.component) == (event, station, component)
    assert record.azimuth == pytest.approx(np.radians(azimuth), abs=1e-12)


def test_csmip_volume_1_with_its_points_as_in_volume_2(tmp_path: Path) -> None:
    """So the files of the 1990s have it."""
    lines = MADE["csmip-1"][0].replace(" 200 pts/sec", "").splitlines()
    at = next(i for i, line in enumerate(lines) if "Accelerogram points" in line)
    lines[at] = f"{N} POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)"
    (tmp_path / "X.RAW").write_text("\n".join(lines) + "\n")
    (found,), (same,) = read_records(tmp_path / "X.RAW"), read_records(written(tmp_path, "csmip-1"))
    assert (found.dt, found.station, found.component) == (0.005, "Some School", "360 Deg")
    assert "uncorrected" in map(str, found.processing_history)
    np.testing.assert_array_equal(found.acceleration, same.acceleration)


def test_what_else_is_known(tmp_path: Path) -> None:
    knet_record, dyna_record = first(tmp_path, "k-net"), first(tmp_path, "dyna")
    assert knet_record.earthquake == Earthquake("2018-01-24T10:51:00Z", 6.2, "MJMA", 41.0, 142.5, 30e3)
    assert dyna_record.earthquake == Earthquake("2019-07-28T16:09:08Z", 4.6, "ML", depth=9e3)
    assert (dyna_record.site.vs30, dyna_record.distance) == (688.0, 12.5e3)
    assert first(tmp_path, "csmip-2").earthquake.time == "1983-05-02T23:42:38.5Z"
    assert first(tmp_path, "csmip-2").site.longitude == -120.458
    assert first(tmp_path, "v2a").earthquake.latitude == pytest.approx(-(42 + 41 / 60 + 33 / 3600), rel=1e-12)
    assert first(tmp_path, "smc").earthquake.magnitude == 7.1
    assert first(tmp_path, "smc").site.elevation is None
    assert first(tmp_path, "at2").earthquake.time == "1952-07-21"


@pytest.mark.parametrize(
    ("printed", "place"),
    [
        # CTZ, Chatham Island: -43.73549, -176.61719 by GeoNet (https://github.com/GeoNet/delta, network/stations.csv)
        ("43 44 08S  176 37 02W", (-43.73549, -176.61719)),
        # its mirror image
        ("43 44 08N  176 37 02E", (43.73549, 176.61719)),
    ],
)
def test_south_and_west_of_geonet_are_negative(tmp_path: Path, printed: str, place: tuple[float, float]) -> None:
    path = write_file(tmp_path / "a.V2A", v2a().replace("42 37 10S  173 03 13E", printed))
    site = read_records(path)[0].site
    assert (site.latitude, site.longitude) == pytest.approx(place, abs=0.5 / 3600.0)


@pytest.mark.parametrize(
    ("name", "old", "new", "words"),
    [
        ("k-net", "2000(gal)/2000000", "2000(stone)/2000000", 'line 14: unit "stone" is not known'),
        ("k-net", "2000(gal)/2000000", "2000(gal)/0", "Scale Factor = .0.; it must be a number above zero"),
        ("k-net", "2000(gal)/2000000", "2000", "scale factor .2000.; it must be like"),
        ("k-net", "2000(gal)/2000000", "4000(gal)/2000000", "states a peak of .* gal, the samples have"),
        ("k-net", "2000(gal)/2000000", "2000(g)/2000000", "states a peak of .* gal, the samples have"),
        ("k-net", "100Hz", "nan", "line 11: Sampling Freq"),
        ("k-net", "Duration Time(s)  0.4", "Duration Time(s)  300", "cut short"),
        ("dyna", "UNITS: cm/s^2", "UNITS: counts", 'line 14: unit "counts" is not known'),
        ("dyna", "UNITS: cm/s^2", "UNITS: g", "header states a peak"),
        ("dyna", "UNITS: cm/s^2", "UNITS: ", "has no UNITS"),
        ("dyna", "DATA_TYPE: ACCELERATION", "DATA_TYPE: VELOCITY", 'DATA_TYPE "VELOCITY"; give the file of the acc'),
        ("dyna", f"NDATA: {N}", f"NDATA: {'9' * 5000}", "cut short"),
        ("dyna", f"NDATA: {N}", "NDATA: 7", "the header or the data are wrong"),
        ("dyna", "INTERVAL_S: 0.005000", "INTERVAL_S: -1", "above zero"),
        ("itaca", "series in m/s/s", "series in furlong", 'line 7: unit "furlong" is not known'),
        ("itaca", "series in m/s/s", "series in g", "header states a peak"),
        ("itaca", "Number of Data", "Number of Dates", "has no Number of Data"),
        ("afad", "RAW PGA VALUES (gal)", "RAW PGA VALUES", "has no PGA VALUES with their unit"),
        ("afad", f"NUMBER OF DATA          : {N}", "NUMBER OF DATA          : 9", "says 9 samples"),
        ("cosmos", "units=cm/sec2(04)", "units=counts(50)", 'raw data in "counts" .volume 0.*give the volume 1 or 2'),
        ("cosmos", f"{N} acceleration pts", f"{N} raw accel. pts", "raw data .* give the volume 1 or 2"),
        (
            "cosmos",
            f"{N} acceleration pts, approx",
            f"{N} time-acceleration pairs,",
            "uneven steps .* give the volume 2",
        ),
        ("cosmos", f"{N} acceleration pts", f"{N} accel. raw pts", "raw data .* give the volume 1 or 2"),
        ("cosmos", f"{N} acceleration pts", "9 acceleration pts", "says 9 samples"),
        ("cosmos", f"{N} acceleration pts", f"{N} velocity pts", "no acceleration in the file"),
        ("cosmos", "approx    0 secs", "approx   99 secs", "the file says 99 s"),
        ("cosmos", "17 lines, Format", "9999 lines, Format", "is not a number"),
        ("csmip-2", "(UNITS: CM/SEC/SEC)", "(UNITS: G/10)", 'unit "G/10" is not known'),
        ("csmip-2", "CHAN  1: 90 DEG", "", "no line of its channel"),
        ("csmip-1", "in units of g", "in units of cm/sec2", "header states a peak"),
        ("csmip-1", "200 pts/sec", "0 pts/sec", "above zero"),
        ("csmip-1", " at 200 pts/sec", ", time and acceleration", "pairs of time and .* give the volume 2 file"),
        ("v2a", "mm/s/s at", "g at", "unit|peak"),
        ("v2a", "at 0.020 sec", "at nan sec", "above zero"),
        (
            "v2a",
            "Instrument corrected data at",
            "Raw readings in units of 1.00 mm/s/s at",
            "uncorrected readings .V1A.* give the V2A",
        ),
        ("v2a", f"Number of points  {N}", "Number of points  999999999", "cut short"),
        ("v2a", f"Number of points  {N}", "Number of points  -5", "a count of samples"),
        ("v2a", "Component S62W", "text", "line .*: .text .* where GeoNet V2A has"),
        ("smc", "2 CORRECTED ACCELEROGRAM", "3 VELOCITY", "give the file of the acceleration"),
        ("smc", f"{N:10d}", f"{N + 1:10d}", "cut short"),
        ("smc", "2.0000000E+02", "0.0000000E+00", "rate of 0"),
        ("smc", f"{1.7e38:15.7E}", "            nan", "nan"),
        ("plain", f"NPTS= {N}", "NPTS= 39", "the header or the data are wrong"),
        ("plain", "DT= .02", "DT= 0", "above zero"),
        ("plain", "units are (g)", "units are (stone)", 'unit "stone"'),
    ],
)
def test_damage_is_one_line_with_file_and_value(tmp_path: Path, name: str, old: str, new: str, words: str) -> None:
    path = written(tmp_path, name)
    text = path.read_text(encoding="latin-1")
    assert old in text
    path.write_text(text.replace(old, new), encoding="latin-1")
    if (name, new.strip()) == ("smc", "nan"):  # what is unknown may be nan as well
        assert read_records(path)[0].npts == N
        return
    with refused_in_one_line(RecordError, path, words):
        read_records(path)


def test_a_direction_of_geonet_with_a_blank_is_one(tmp_path: Path) -> None:
    path = written(tmp_path, "v2a")
    path.write_text(v2a().replace("Component S62W", "Component S 6W"))
    azimuth = read_records(path)[1].azimuth
    assert azimuth == pytest.approx(np.radians(186.0), rel=1e-12)  # S alone would be 180


@pytest.mark.parametrize("lost", [0, 1, 2])
def test_a_channel_of_csmip_whose_points_are_not_found_is_refused(tmp_path: Path, lost: int) -> None:
    path = written(tmp_path, "csmip-2")
    lines = path.read_text().split("\n")
    at = [i for i, line in enumerate(lines) if "points of accel" in line.lower()][lost]
    path.write_text("\n".join(lines[:at] + lines[at + 1 :]))
    with pytest.raises(RecordError, match=r"channel|no line of"):
        read_records(path)


@pytest.mark.parametrize("name", MADE)
def test_lines_that_end_with_carriage_returns_are_read_or_refused(tmp_path: Path, name: str) -> None:
    path = written(tmp_path, name)
    whole = read_records(path)
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r"))
    try:
        found = read_records(path)
    except RecordError:
        assert name not in ("v2a", "at2", "smc")
        return
    for one, other in zip(found, whole, strict=True):
        np.testing.assert_array_equal(one.acceleration, other.acceleration)


@pytest.mark.parametrize("name", sorted(MADE.keys() - {"csmip-2", "v2a"}))  # whose last numbers are displacements
@pytest.mark.parametrize("junk", ["nan", "inf", "********", "1e999", "\x00", "999.9.9"])
def test_no_value_that_is_no_number_passes(tmp_path: Path, name: str, junk: str) -> None:
    path = written(tmp_path, name)
    lines = path.read_text(encoding="latin-1").split("\n")
    at = max(i for i, line in enumerate(lines) if line.strip() and not line.startswith(("/&", "End")))
    fields = lines[at].replace(",", " , ").split()
    lines[at] = " ".join([*fields[:-1], junk]).replace(" , ", ",")
    path.write_text("\n".join(lines), encoding="latin-1")
    with pytest.raises(RecordError) as caught:
        read_records(path)
    assert str(path) in str(caught.value)


UNCOUNTED = {"csv"}
"""Formats that state neither count nor duration: one that ends at the end of a line cannot be told from a whole one."""


@pytest.mark.parametrize("name", MADE)
def test_a_file_cut_anywhere_is_refused_or_whole(tmp_path: Path, name: str) -> None:
    """But for UNCOUNTED and bare numbers, and for what stands behind the last acceleration."""
    path = written(tmp_path, name)
    whole, data = read_records(path), path.read_bytes()
    ends = {at + beside for at, byte in enumerate(data) if byte == ord("\n") for beside in (0, 1)}
    for cut in sorted({*range(0, len(data), 37), *ends}):
        path.write_bytes(data[:cut])
        try:
            found = read_records(path)
        except RecordError:
            continue
        if name in UNCOUNTED:
            continue
        for record, other in zip(found, whole, strict=False):
            assert record.npts == N, (
                f"the first {cut} bytes were read as {record.npts} samples of {N}: compare what the header says "
                "(check_count, check_duration), or add the format to UNCOUNTED if it says nothing"
            )
            np.testing.assert_allclose(record.acceleration, other.acceleration, rtol=0, atol=1.0)


@settings(max_examples=150, deadline=2000, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(name=st.sampled_from(sorted(MADE)), seed=st.integers(0, 2**32))
def test_shuffled_and_spoilt_files_are_records_or_record_errors(tmp_path: Path, name: str, seed: int) -> None:
    """And a record is one of the step, and in the unit, of the whole: its peak is not larger than ten of the file's."""
    source, _, factor, dt = MADE[name]
    chance = random.Random(seed)
    data = bytearray(source.encode("latin-1"))
    lines = bytes(data).split(b"\n")
    kind = chance.randrange(4)
    if kind == 0:
        chance.shuffle(lines)
        data = bytearray(b"\n".join(lines))
    elif kind == 1:
        del lines[chance.randrange(len(lines))]
        data = bytearray(b"\n".join(lines))
    elif kind == 2:
        at = chance.randrange(len(lines))
        lines.insert(at, chance.choice(lines))
        data = bytearray(b"\n".join(lines))
    else:
        for _ in range(chance.randrange(1, 5)):
            data[chance.randrange(len(data))] = chance.randrange(256)
    path = tmp_path / "spoilt.dat"
    path.write_bytes(bytes(data))
    try:
        found = read_records(path)
    except RecordError as error:
        assert str(error).startswith(str(path))  # noqa: PT017
        assert "\n" not in str(error)  # noqa: PT017
        return
    if kind < 3:  # a byte may change a digit of the step, which nothing else states
        for record in found:
            assert record.dt == pytest.approx(dt, rel=1e-9)
            assert record.pga <= 1.3 * factor * abs(PEAK)


def test_a_table_of_three_columns_with_time_is_not_taken_for_one_motion(tmp_path: Path) -> None:
    path = tmp_path / "table.txt"
    path.write_text("".join(f"{i * 0.01:.2f} {a} {-a}\n" for i, a in enumerate(VALUES)))
    with pytest.raises(RecordError, match="first of 3 columns rises evenly, as time does"):
        read_records(path, unit="g", step=0.01)


def test_three_full_columns_are_not_taken_for_one_motion(tmp_path: Path) -> None:
    path = tmp_path / "table.txt"
    path.write_text("".join(f"{a} {b} {c}\n" for a, b, c in np.outer(VALUES, SCALES)))
    with pytest.raises(RecordError, match="3 numbers in every line may be 3 records side by side"):
        read_records(path, unit="g", step=0.01)


def test_bare_numbers_need_unit_and_step(tmp_path: Path) -> None:
    path = write_file(tmp_path / "bare.txt", columns(VALUES, 8, "10.3f"))
    with pytest.raises(RecordError, match=r"does not state the unit of its accelerations; give unit \(--unit"):
        read_records(path, step=0.02)
    with pytest.raises(RecordError, match=r"does not state its time step; give step, in seconds \(--step"):
        read_records(path, unit="g")
    (record,) = read_records(path, unit="g", step=0.02)
    np.testing.assert_allclose(record.acceleration, g * VALUES, rtol=0, atol=6e-3 * g)
    assert "as given" in str(record.processing_history[0])


def test_a_title_then_count_and_step_then_one_column(tmp_path: Path) -> None:
    path = write_file(tmp_path / "one.txt", f"made up\n{N} 0.0100\n" + columns(VALUES, 1, ".4f"))
    (record,) = read_records(path, unit="cm/s2")
    assert (record.npts, record.dt) == (N, 0.01)


@pytest.mark.parametrize(
    ("name", "number", "event"),
    [
        ("201011142308", "EMSC-20101114_0000001", "EMSC-20101114_0000001"),
        ("201011142308", "3336", "2018-01-24 10:51, M6.8, 38.00N 22.00E"),
        ("", "", "2018-01-24 10:51, M6.8, 38.00N 22.00E"),
    ],
)
def test_a_time_stamp_is_no_name_of_an_event(tmp_path: Path, name: str, number: str, event: str) -> None:
    lines = [line for line in MADE["dyna"][0].splitlines() if not line.startswith(("EVENT_", "MAGNITUDE_"))]
    quake = ["EVENT_DATE_YYYYMMDD: 20180124", "EVENT_TIME_HHMMSS: 105100", "MAGNITUDE_W: 6.8"]
    place = ["EVENT_LATITUDE_DEGREE: 38.0", "EVENT_LONGITUDE_DEGREE: 22.0"]
    path = tmp_path / "d.asc"
    path.write_text("\n".join([f"EVENT_NAME: {name}", f"EVENT_ID: {number}", *quake, *place, *lines]) + "\n")
    assert read_records(path)[0].event == event


def test_an_epicentre_south_and_west_is_called_so() -> None:
    quake = Earthquake(time="2010-02-27", latitude=-36.122, longitude=-72.898)
    assert make_record("x", [0.0, 1.0], 0.01, earthquake=quake).event == "2010-02-27, 36.12S 72.90W"
    assert make_record("x", [0.0, 1.0], 0.01, earthquake=Earthquake(time="2010-02-27")).event == "2010-02-27"
