"""Which format a file has: exactly one, or an error that says which."""

from pathlib import Path

import pytest

import records.reading
from records.errors import RecordError
from records.formats import FORMATS, Format
from records.reading import read_record, read_records
from records.record import Record


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
    path = tmp_path / "file.AT2"
    path.write_bytes(data)
    with pytest.raises(RecordError, match=words) as caught:
        read_records(path)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


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


def afad(path: Path) -> Path:
    """Three components of five samples."""
    path.write_text(
        "STRONG GROUND MOTION RECORDS OF TURKIYE\nNUMBER OF DATA : 5\nSAMPLING INTERVAL (sec) : 0.01\n"
        "RAW PGA VALUES (gal) : (N-S) 4.0 (E-W) 5.0 (U-D) 6.0\n\n N-S E-W U-D\n"
        + "".join(f" {i}.0 {i + 1}.0 {i + 2}.0\n" for i in range(5))
    )
    return path


def test_one_record_comes_alone_and_several_as_a_list(tmp_path: Path) -> None:
    path = tmp_path / "quake.csv"
    path.write_text("time [s], acceleration\n0,0\n0.01,1\n0.02,-3\n")
    found = read_record(str(path), unit="m/s2")
    assert isinstance(found, Record)
    assert found.pga == 3.0
    three = read_record(afad(tmp_path / "three.txt"))
    assert isinstance(three, list)
    assert [one.component for one in three] == ["N-S", "E-W", "U-D"]
    with pytest.raises(RecordError, match="cannot be read"):
        read_record(tmp_path / "absent.AT2")


def test_a_record_shows_itself_on_one_line(tmp_path: Path) -> None:
    path = tmp_path / "quake.csv"
    path.write_text("time [s], acceleration [m/s2]\n0,0\n0.01,1\n0.02,-3\n")
    assert repr(read_record(path)) == "Record(id='quake', npts=3, dt=0.01 s, pga=3 m/s2)"
