"""Which format a file has: exactly one, or an error that says which."""

from pathlib import Path

import numpy as np
import pytest

import records.reading
from records.errors import RecordError
from records.formats import FORMATS, Format
from records.reading import read_record, read_records
from records.record import Record
from tests.support.files import refused_in_one_line, write_file
from tests.support.record_files import afad


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "the file is empty"),
        (b" \r\n\n", "the file is empty"),
        (bytes(range(256)) * 100, r"not a record format known here \(PEER AT2, K-NET/KiK-net, .*, CSV, plain\)"),
        (b"Dear Sir,\nplease find enclosed\n", "not a record format known here"),
        (b"\x1f\x8b\x08\x00" + b"\xff" * 5000, "not a record format known here"),
    ],
)
def test_a_file_of_no_known_format_lists_those_there_are(tmp_path: Path, data: bytes, words: str) -> None:
    path = write_file(tmp_path / "file.AT2", data)
    with refused_in_one_line(RecordError, path, words):
        read_records(path)


def test_two_formats_that_match_are_both_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    both = {**FORMATS, "Twin": Format(lambda head: True, FORMATS["CSV"].read)}
    monkeypatch.setattr(records.reading, "FORMATS", both)
    path = tmp_path / "quake.csv"
    path.write_text("time [s], acceleration [g]\n0,0\n1,1\n")
    with pytest.raises(RecordError, match="could be CSV or Twin"):
        read_records(path)


def test_a_missing_file_and_a_folder_are_record_errors(tmp_path: Path) -> None:
    with pytest.raises(RecordError, match="cannot be read"):
        read_records(tmp_path / "absent.AT2")
    with pytest.raises(RecordError, match="is a folder; give the files in it"):
        read_records(tmp_path)


def test_one_record_comes_alone_and_several_as_a_list(tmp_path: Path) -> None:
    path = tmp_path / "quake.csv"
    path.write_text("time [s], acceleration\n0,0\n0.01,1\n0.02,-3\n")
    found = read_record(str(path), unit="m/s2")
    assert isinstance(found, Record)
    assert found.pga == 3.0
    assert isinstance(read_records(str(path), unit="m/s2"), tuple)
    assert [each.id for each in read_records(str(path), unit="m/s2")] == [found.id]
    with pytest.raises(RecordError, match="3 is no path"):
        read_records(3)
    three = read_record(write_file(tmp_path / "three.txt", afad(np.arange(15.0).reshape(5, 3), {})))
    assert isinstance(three, list)
    assert [one.component for one in three] == ["N-S", "E-W", "U-D"]
    with pytest.raises(RecordError, match="cannot be read"):
        read_record(tmp_path / "absent.AT2")


def test_a_record_shows_itself_on_one_line(tmp_path: Path) -> None:
    path = tmp_path / "quake.csv"
    path.write_text("time [s], acceleration [m/s2]\n0,0\n0.01,1\n0.02,-3\n")
    assert repr(read_record(path)) == "Record(id='quake', npts=3, dt=0.01 s, pga=3 m/s2)"
