"""PEER AT2 in every dress of its header, and what is not AT2. Real files are in tests/validation/peer."""

from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from records.errors import RecordError
from records.formats.peer_at2 import looks_like, parse_title
from records.reading import read_records
from tests.support.files import refused_in_one_line, write_file
from tests.support.record_files import at2

VALUES = [-0.25e-2, 0.1234e-1, 0.0, 0.5, -0.75, 0.125e-6, 0.3]
DATA = "  -.2500000E-02   .1234000E-01   .0000000E+00   .5000000E+00  -.7500000E+00\n   .1250000E-06   .3000000E+00\n"


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize(
    ("step", "dt"),
    [
        ("NPTS=     7, DT= .01000 SEC", 0.01),
        ("NPTS=      7, dt=  .02000", 0.02),
        ("NPTS=      7, dt=   .0100 SEC", 0.01),
        ("NPTS=      7, DT=   .0050 SEC,                                             ", 0.005),
        ("NPTS=      7, DT=   .0100 SEC,   0 POLE @    13.90000 HZ,  -5 POLE @      .10000", 0.01),
        ("NPTS=      7, DT=   .0100 SEC,  -5 POLE @      .03000 HZ,   0 POLE @      .00000", 0.01),
        ("7    0.0100    NPTS, DT", 0.01),
        ("NPTS=  7, DT=    0.05 SEC", 0.05),
        ("NPTS=  7, DT=   5.0E-3 SEC", 0.005),
    ],
)
def test_every_dress_of_line_four(tmp_path: Path, step: str, dt: float, end: str) -> None:
    (record,) = read_records(write_file(tmp_path / "a.AT2", at2(DATA, line=step).replace("\n", end)))
    assert record.dt == dt
    np.testing.assert_allclose(record.acceleration, np.array(VALUES) * g, rtol=1e-12)
    assert (record.id, record.event, record.station, record.component) == ("a", "Somewhere", "Some School", "21")
    assert [str(step) for step in record.processing_history] == ["read from PEER AT2, unit g, event of 7/21/1952"]


@pytest.mark.parametrize(
    ("line", "title"),
    [
        ("Kern County, 7/21/1952, Taft Lincoln School, 21", ("Kern County", "7/21/1952", "Taft Lincoln School", "21")),
        (
            "BIG BEAR 06/28/92 0805, SAN BERNARDINO - E & HOSPITALITY, 180 (CDMG STATION 23542)",
            ("BIG BEAR", "06/28/92", "SAN BERNARDINO - E & HOSPITALITY", "180"),
        ),
        (
            "CHALFANT VALLEY 07/21/86 14:42, ZACK BROTHERS RANCH, 360 (CDMG STATION 54428)",
            ("CHALFANT VALLEY", "07/21/86", "ZACK BROTHERS RANCH", "360"),
        ),
        ("CHI-CHI 09/20/99, TCU052, N (CWB)", ("CHI-CHI", "09/20/99", "TCU052", "N")),
        (
            "BORAH PEAK EQ, 10/28/83, 14:06, ANL-767 REACTOR PLANT (BASEMENT), 196",
            ("BORAH PEAK", "10/28/83", "ANL-767 REACTOR PLANT (BASEMENT)", "196"),
        ),
        ("Santa Barbara, CA, 8/13/1978, 1234, 48", ("Santa Barbara, CA", "8/13/1978", "1234", "48")),
        ("Somewhere, Station, UP", ("Somewhere", "", "Station", "UP")),
        ("", ("", "", "", "")),
    ],
)
def test_titles_old_and_new(line: str, title: tuple[str, ...]) -> None:
    found = parse_title(line)
    assert (found.event, found.date, found.station, found.component) == title


def test_numbers_that_touch_are_told_apart(tmp_path: Path) -> None:
    data = "-.1000000E-02-.2000000E+00 .3000000E+00\n"
    path = write_file(tmp_path / "a.AT2", at2(data, line="NPTS= 3, DT= .01 SEC"))
    np.testing.assert_allclose(read_records(path)[0].acceleration / g, [-0.001, -0.2, 0.3], rtol=1e-12)


def test_another_unit_in_the_header_counts_and_the_callers_does_not(tmp_path: Path) -> None:
    text = at2(DATA, line="NPTS= 7, DT= .01", units="ACCELERATION TIME HISTORY IN UNITS OF CM/S/S")
    path = write_file(tmp_path / "a.AT2", text)
    np.testing.assert_allclose(read_records(path, unit="g")[0].acceleration, np.array(VALUES) * 0.01, rtol=1e-12)


@pytest.mark.parametrize(
    ("step", "data", "words"),
    [
        ("NPTS= 8, DT= .01 SEC", DATA, "NPTS says 8 samples, the file holds 7; the file is cut short"),
        ("NPTS= 6, DT= .01 SEC", DATA, "NPTS says 6 samples, the file holds 7; the header or the data are wrong"),
        ("NPTS= 00010, DT= .01 SEC", DATA, "NPTS says 00010 .* cut short"),
        ("NPTS= 6, DT= .01 SEC", DATA + DATA, "NPTS says 6 .* wrong"),
        (f"NPTS= {'9' * 6000}, DT= .01 SEC", DATA, "cut short"),
        ("NPTS= 7, DT= .01 SEC", "", "the file holds 0"),
        ("NPTS= 0, DT= .01 SEC", "", "0 samples of acceleration"),
        ("NPTS= -7, DT= .01 SEC", DATA, 'NPTS = "-7"'),
        ("NPTS= seven, DT= .01 SEC", DATA, 'NPTS = "seven"'),
        ("NPTS= 7, DT= 0.0 SEC", DATA, 'DT = "0.0"'),
        ("NPTS= 7, DT= -.01 SEC", DATA, 'DT = "-.01"'),
        ("NPTS= 7, DT= nan SEC", DATA, 'DT = "nan"'),
        ("NPTS= 7, DT= 1e999 SEC", DATA, 'DT = "1e999"'),
        ("NPTS= 7", DATA, "line 4: .* does not state NPTS and DT"),
        ("", DATA, "line 4"),
        ("NPTS= 7, DT= .01 SEC", DATA.replace(".5000000E+00", "************"), r'line 5: "\*+" is not a number'),
        ("NPTS= 7, DT= .01 SEC", DATA.replace(".3000000E+00", "abc"), 'line 6: "abc" is not a number'),
        ("NPTS= 7, DT= .01 SEC", DATA.replace(".5000000E+00", "NaN"), "sample 4 is nan"),
        ("NPTS= 7, DT= .01 SEC", DATA.replace(".5000000E+00", ".5000000E+999"), "sample 4 is inf|line 5"),
        ("NPTS= 7, DT= .01 SEC", DATA.replace(".5000000E+00", "1E+999"), 'line 5: "1E\\+999" is not printed like'),
        ("NPTS= 7, DT= .01 SEC", "0.0 " * 7, "no motion"),
        ("NPTS= 1, DT= .01 SEC", "0.5", "at least two"),
    ],
)
def test_a_damaged_file_gives_one_clear_line(tmp_path: Path, step: str, data: str, words: str) -> None:
    path = write_file(tmp_path / "damaged.AT2", at2(data, line=step))
    with refused_in_one_line(RecordError, path, words, longest=300):
        read_records(path)


def test_a_header_that_ends_early_is_said_so(tmp_path: Path) -> None:
    path = write_file(tmp_path / "short.AT2", at2("", line="").rstrip())
    with pytest.raises(RecordError, match="header is cut short"):
        read_records(path)


def test_only_accelerations_look_like_at2() -> None:
    assert looks_like(at2("", line="NPTS= 7, DT= .01").encode())
    assert not looks_like(at2("", line="NPTS= 7, DT= .01", units="VELOCITY TIME SERIES IN UNITS OF CM/S").encode())
    assert not looks_like(b"Data\n1559 points at equal spacing\nThe units are (g)\nNPTS=  1559, DT= .02000 SEC\n")
    assert not looks_like(bytes(range(256)))
