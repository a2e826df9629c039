"""Records in two columns of text."""

from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from records.errors import RecordError
from records.formats.csv import looks_like
from records.reading import read_records
from tests.support.files import refused_in_one_line, write_file

NUMBERS = "0.00,0.1\n0.02,-0.3\n0.04,0.2\n"


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("time [s], acceleration [g]\n" + NUMBERS, g),
        ("t (s);a (m/s2)\n0;0,1\n0,02;-0,3\n0,04;0,2", 1.0),
        ("# quake\nTime [ms]\tAcc [cm/s^2]\r\n10\t0.1\r\n30\t-0.3\r\n50\t0.2\r\n", 0.01),
        ("time [s] acceleration [gal]\n0.00 0.1\n0.02 -0.3\n0.04 0.2\n", 0.01),
        ("\ufefftime (sec),acc (m/s²)\n" + NUMBERS, 1.0),
    ],
)
def test_units_stand_in_the_header(tmp_path: Path, text: str, unit: float) -> None:
    path = write_file(tmp_path / "quake.csv", text)
    (record,) = read_records(path, unit="mm/s2")
    assert (record.id, record.dt) == ("quake", 0.02)
    np.testing.assert_allclose(record.acceleration, np.array([0.1, -0.3, 0.2]) * unit, rtol=1e-12)


@pytest.mark.parametrize("header", ["", "time, acceleration\n", "time [s], acceleration\n"])
def test_where_the_file_states_no_unit_the_caller_must(tmp_path: Path, header: str) -> None:
    path = write_file(tmp_path / "quake.csv", header + NUMBERS)
    with pytest.raises(RecordError, match=r"does not state the unit of its accelerations.*give unit"):
        read_records(path)
    (record,) = read_records(path, unit="m/s^2")
    np.testing.assert_allclose(record.acceleration, [0.1, -0.3, 0.2], rtol=1e-12)
    assert "as given" in str(record.processing_history[0])


def test_rounded_times_are_uniform_enough(tmp_path: Path) -> None:
    path = tmp_path / "quake.csv"
    lines = [f"{i / 410:.4f},{np.sin(i):.4f}" for i in range(2000)]
    path.write_text("\n".join(["time [s], acceleration [g]", *lines]))
    assert read_records(path)[0].dt == pytest.approx(1 / 410, rel=1e-4)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"time [s], acceleration [g]\n", "no numbers below the header"),
        (b"time, acceleration [g]\n0,1\n1,2\n", "no unit for the time"),
        (b"time [h], acceleration [g]\n0,1\n1,2\n", 'unit "h" is not known'),
        (b"time [s], acceleration [furlong]\n0,1\n1,2\n", 'unit "furlong" is not known; choose one of m/s2, g'),
        (
            b"time [s], acceleration [g]\n0,1\n.01,2\n.02,3\n.04,1\n.05,2\n",
            "not uniform: step 3 is 0.02 s, others 0.01 s",
        ),
        (b"time [s], acceleration [g]\n0,1\n.01,2\n.01,3\n.02,1\n", "not uniform"),
        (b"time [s], acceleration [g]\n0,1\n", "1 times"),
        (b"time [s], acceleration [g]\n.02,1\n.01,2\n", "rising"),
        (b"time [s], acceleration [g]\n0,1\n0,2\n", "rising"),
        (b"time [s], acceleration [g]\n0,1\nnan,2\n.02,3\n", "time 2 is nan"),
        (b"time [s], acceleration [g]\n0,1\n.01,nan\n.02,3\n", "sample 2 is nan"),
        (b"time [s], acceleration [g]\n0,1\n.01,x\n.02,3\n", 'line 3: ".01,x" is not two numbers'),
        (b"time [s], acceleration [g]\n0,1\n.01,2,7\n.02,3\n.03,1\n.04,1\n", "a record format|3 columns"),
        (b"time [s], acceleration [g]\n0,0\n.01,0\n.02,0\n", "no motion"),
    ],
)
def test_a_damaged_file_gives_one_clear_line(tmp_path: Path, data: bytes, words: str) -> None:
    path = write_file(tmp_path / "damaged.csv", data)
    with refused_in_one_line(RecordError, path, words):
        read_records(path)


def test_an_unknown_unit_of_the_caller_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "quake.csv"
    path.write_text(NUMBERS)
    with pytest.raises(RecordError, match='unit "stone" is not known'):
        read_records(path, unit="stone")


@pytest.mark.parametrize(
    "head",
    [
        b"",
        b"\n\n",
        b"one line",
        b"1 2 3 4\n5 6 7 8\n",
        b"test-motion\n4684 0.0100\n2.42E-07\n1.46E-07\n",
        b"a,b\nc,d\n",
        b"\0\1,\2",
    ],
)
def test_other_text_is_not_taken_for_two_columns(head: bytes) -> None:
    assert not looks_like(head)
