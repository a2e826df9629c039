"""The catalogue of a folder: what is read again and what is not, hostile names, flatfiles, damage."""

import os
import sqlite3
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from records import candidates
from records import catalogue as catalogue_module
from records.candidates import PERIODS, Candidate, candidate_table
from records.catalogue import NAME, catalogue_candidates, index, open_catalogue, path_inside, store_flatfile
from records.errors import RecordError
from records.flatfile import match_flatfile, read_flatfile
from records.formats.header import HeaderOverrides
from records.reading import read_records
from records.response import measures, response_spectrum
from tests.support import record_files
from tests.support.files import write_file

FLATFILE = '''\
A search, with words above its table
"Record Sequence Number","Earthquake Name",YEAR,"Station Name","Earthquake Magnitude","ClstD (km)","EpiD (km)",\
"Vs30 (m/s) selected for analysis","File Name (Horizontal 1)","File Name (Horizontal 2)"
57,"San Fernando, ""main""",1971,Castaic,6.61,22.63,25.4,450.3,SFERN\\ORR021.AT2,SFERN\\ORR291.AT2
121,Friuli,1976,Barcis,6.50,-999,51.0,-999,FRIULI.A\\A-BCS000.AT2,TWICE.AT2
126,Gazli,1976,Karakyr,six,,,,GAZLI\\GAZ000.AT2,TWICE.AT2

Note,that,is,no,record
'''


def at2(path: Path, *, seed: int = 1, title: str = "San Fernando, 2/9/1971, Castaic, 21") -> Path:
    values = np.random.default_rng(seed).normal(0.0, 0.1, 300) * np.hanning(300)
    return write_file(path, record_files.at2(values, title=title))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    place = tmp_path / "records"
    for number in range(3):
        at2(place / f"RSN{57 + number}_X_{number}.AT2", seed=number)
    at2(place / "old" / "A-BCS000.AT2", seed=9, title="FRIULI 05/06/76 2000, BARCIS, 000")
    (place / "notes.txt").write_text("no motion here")
    return place


def test_a_record_comes_back_as_it_was_measured(folder: Path) -> None:
    with open_catalogue(folder / NAME) as catalogue:
        index(folder, catalogue)
        found = catalogue_candidates(catalogue)[0]
    (record,) = read_records(folder / "RSN57_X_0.AT2")
    assert (found.path, found.id, found.event, found.date) == ("RSN57_X_0.AT2", record.id, "San Fernando", "1971-02-09")
    assert (found.npts, found.dt, found.nga) == (300, 0.01, 57)
    np.testing.assert_array_equal(found.spectrum, response_spectrum(record, PERIODS))
    of = measures(record)
    assert found.measures == {name: getattr(of, name) for name in found.measures}


def test_a_catalogue_as_a_table_has_a_row_for_each_record(folder: Path) -> None:
    with open_catalogue(None) as catalogue:
        index(folder, catalogue)
        found = catalogue_candidates(catalogue)
    table = candidate_table(found)
    assert list(table["id"]) == [one.id for one in found]
    assert list(table["pga"]) == [one.measures["pga"] for one in found]
    assert table.set_index("path").loc["RSN57_X_0.AT2", "nga"] == 57
    assert candidate_table(()).empty


def test_pandas_is_loaded_only_to_read_a_flatfile() -> None:
    script = "import sys, records.flatfile, records.flatfile, records.catalogue, records.candidates, records.selection"
    subprocess.run([sys.executable, "-c", f"{script}; assert 'pandas' not in sys.modules"], check=True)


def test_only_what_changed_is_read_again(folder: Path) -> None:
    with open_catalogue(folder / NAME) as catalogue:
        first = index(folder, catalogue)
        assert (first.read, first.unchanged, first.records) == (5, 0, 4)
        assert [path for path, _ in first.problems] == ["notes.txt"]
        again = index(folder, catalogue)
        assert (again.read, again.unchanged) == (0, 5)
        before = catalogue_candidates(catalogue)[0].spectrum
        os.utime(folder / "RSN57_X_0.AT2", ns=(1, 1))  # another time, the same content
        at2(folder / "RSN58_X_1.AT2", seed=99)
        (folder / "old" / "A-BCS000.AT2").unlink()
        third = index(folder, catalogue)
        assert (third.read, third.unchanged, third.gone, third.records) == (2, 2, 1, 3)
        np.testing.assert_array_equal(catalogue_candidates(catalogue)[0].spectrum, before)
        assert catalogue_candidates(catalogue)[1].measures["pga"] == pytest.approx(
            read_records(folder / "RSN58_X_1.AT2")[0].pga, rel=1e-15
        )
        assert index(folder, catalogue).read == 0


def test_the_same_content_is_hashed_but_not_read(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with open_catalogue(None) as catalogue:
        index(folder, catalogue)
        os.utime(folder / "RSN57_X_0.AT2", ns=(1, 1))
        monkeypatch.setattr(catalogue_module, "read_with_overrides", lambda *_, **__: pytest.fail("read again"))
        index(folder, catalogue)


def test_a_stated_unit_is_asked_anew(folder: Path) -> None:
    (folder / "plain.csv").write_text("time [s],acceleration\n" + "".join(f"{i / 100},{i % 7}\n" for i in range(60)))
    with open_catalogue(None) as catalogue:
        assert "plain.csv" in [path for path, _ in index(folder, catalogue).problems]
        for unit, size in (("m/s2", 1.0), ("cm/s2", 0.01)):
            index(folder, catalogue, overrides=HeaderOverrides(unit=unit))
            (one,) = (each for each in catalogue_candidates(catalogue) if each.path == "plain.csv")
            assert one.measures["pga"] == pytest.approx(6.0 * size, rel=1e-12)


def test_what_was_interrupted_goes_on_where_it_ended(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogue_module, "BATCH", 2)

    def interrupt(done: int, total: int) -> None:
        if done == 4:
            raise KeyboardInterrupt

    with open_catalogue(folder / NAME) as catalogue, pytest.raises(KeyboardInterrupt):
        index(folder, catalogue, progress=interrupt)
    with open_catalogue(folder / NAME) as catalogue:
        assert index(folder, catalogue).read == 3
        assert len(catalogue_candidates(catalogue)) == 4


def test_a_process_that_is_killed_loses_its_last_batch_at_most(folder: Path) -> None:
    script = (
        "import os, sys; from pathlib import Path; from records import catalogue as module\n"
        "from records.catalogue import open_catalogue\n"
        "module.BATCH = 1; folder = Path(sys.argv[1])\n"
        "with open_catalogue(folder / '.assess-records.sqlite') as catalogue:\n"
        "    module.index(folder, catalogue, progress=lambda done, _: os.kill(os.getpid(), 9) if done == 3 else None)"
    )
    ended = subprocess.run([sys.executable, "-c", script, str(folder)], check=False)
    assert ended.returncode == -9
    with open_catalogue(folder / NAME) as catalogue:
        assert index(folder, catalogue).read == 3
        assert len(catalogue_candidates(catalogue)) == 4


def test_processes_find_what_one_finds(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(candidates, "FEW", 1)
    with open_catalogue(None) as alone, open_catalogue(None) as shared:
        index(folder, alone)
        with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as executor:
            index(folder, shared, executor=executor)
        for one, other in zip(catalogue_candidates(alone), catalogue_candidates(shared), strict=True):
            np.testing.assert_array_equal(one.spectrum, other.spectrum)
            assert replace(one, spectrum=PERIODS) == replace(other, spectrum=PERIODS)


def test_a_flatfile_goes_before_what_files_say(folder: Path, tmp_path: Path) -> None:
    table = tmp_path / "flat.csv"
    table.write_text(FLATFILE)
    at2(folder / "TWICE.AT2", seed=5)
    with open_catalogue(None) as catalogue:
        index(folder, catalogue)
        store_flatfile(catalogue, read_flatfile(table).recordings)
        found = {one.path: one for one in catalogue_candidates(catalogue)}
        of = found["RSN57_X_0.AT2"]
        assert (of.event, of.station, of.magnitude, of.vs30) == ('San Fernando, "main"', "Castaic", 6.61, 450.3)
        assert of.distance == pytest.approx(22630.0)
        by_name = found["old/A-BCS000.AT2"]  # Friuli: no distance to the rupture, so that to the epicentre
        assert (by_name.nga, by_name.magnitude, by_name.distance, by_name.vs30) == (121, 6.5, 51000.0, None)
        assert found["TWICE.AT2"].nga is None  # two recordings name it
        assert found["RSN58_X_1.AT2"].magnitude is None
        at2(folder / "RSN57_X_0.AT2", seed=77)
        index(folder, catalogue)
        assert catalogue_candidates(catalogue)[0].magnitude == 6.61  # also of a file read anew


@pytest.mark.parametrize(
    "text", ["", "a,b\n1,2\n", "Record Sequence Number\nnone\n", "RSN\x00,b\n1,2\n", "RSN\n" + "x" * 200_000]
)
def test_a_table_that_is_no_flatfile_is_refused_in_one_line(tmp_path: Path, text: str) -> None:
    table = tmp_path / "flat.csv"
    table.write_text(text)
    with pytest.raises(RecordError, match=r"flat\.csv") as caught:
        read_flatfile(table)
    assert "\n" not in str(caught.value)


def test_a_quote_that_is_never_closed_swallows_no_recordings(tmp_path: Path) -> None:
    table = tmp_path / "flat.csv"
    table.write_text('RSN,Earthquake Name\n100,"Quake\nA"\n101,"Quake B\n102,Quake C\n')
    with pytest.raises(RecordError, match=r"flat\.csv: line 4: not a table in CSV .*close each quote"):
        read_flatfile(table)
    table.write_text('RSN,Earthquake Name\n100,"Quake\nA"\n101,Quake B\n١٠٢,Quake C\n')
    found = read_flatfile(table)
    assert [one.nga for one in found.recordings] == [100, 101]
    assert [(bad.row, bad.value) for bad in found.bad] == [(5, "١٠٢")]


@pytest.mark.parametrize(
    ("row", "told"),
    [
        ("101,Quake B,1981,There,7,0,40,300,b.AT2", "9 of 8"),  # decimal commas: the distance would be 0 km
        ("101,Quake B,1981,There,7.040,300,b.AT2", "7 of 8"),  # a comma lost: magnitude 7.04, distance 300 km
        ("101,Quake B,1981,There,7.0,40,300,b.AT2,,", ""),
    ],
)
def test_a_row_of_another_width_than_the_header_is_passed_over_and_told(tmp_path: Path, row: str, told: str) -> None:
    table = tmp_path / "flat.csv"
    header = "RSN,Earthquake Name,YEAR,Station Name,Magnitude,ClstD (km),Vs30 (m/s),File Name (Horizontal 1)"
    table.write_text(f"{header}\n{row}\n100,Quake A,1980,Here,6.5,20,400,a.AT2\n")
    found = read_flatfile(table)
    assert [one.nga for one in found.recordings] == ([100] if told else [101, 100])
    assert [(bad.row, bad.column, bad.value) for bad in found.bad] == ([(2, "columns", told)] if told else [])


def test_columns_that_a_flatfile_lacks_are_listed(tmp_path: Path, folder: Path) -> None:
    table = tmp_path / "flat.csv"
    table.write_text("RSN,Earthquake Name,Station Name,File Name (Horizontal 1)\n100,Quake A,Here,a.AT2\n")
    at2(folder / "a.AT2")
    with open_catalogue(folder / NAME) as catalogue:
        index(folder, catalogue)
        found = match_flatfile(tuple(catalogue_candidates(catalogue)), read_flatfile(table))
    assert found.warning is not None
    assert found.warning.values["keys"] == "magnitude, distance, vs30"


def test_hostile_names_are_names(folder: Path) -> None:
    name = "'); DROP TABLE records; --.AT2"
    at2(folder / name, title='\'; DELETE FROM files; --, 1/1/1990, "st", %s ? :x')
    (folder / os.fsdecode(b"bad\xff.AT2")).write_bytes(b"x")
    with open_catalogue(folder / NAME) as catalogue:
        found = index(folder, catalogue)
        assert name in {one.path for one in catalogue_candidates(catalogue)}
        assert ("bad?.AT2", "its name is not UTF-8; rename it") in found.problems
        assert index(folder, catalogue).records == 5


def test_no_path_leaves_the_folder(folder: Path, tmp_path: Path) -> None:
    outside = at2(tmp_path / "outside" / "secret.AT2")
    (folder / "link.AT2").symlink_to(outside)
    (folder / "loop.AT2").symlink_to(folder / "loop.AT2")
    (folder / "away").symlink_to(outside.parent)
    os.mkfifo(folder / "pipe.AT2")
    with open_catalogue(folder / NAME) as catalogue:
        found = dict(index(folder, catalogue).problems)
        assert "leads out" in found["link.AT2"]
        assert "broken link" in found["loop.AT2"]
        assert found["pipe.AT2"] == "not a regular file"
        assert not any("secret" in one.path or "link" in one.path for one in catalogue_candidates(catalogue))
    for path in ("../outside/secret.AT2", str(outside), "link.AT2", "away/secret.AT2"):
        with pytest.raises(RecordError, match="leads out"):
            path_inside(folder, path)
    assert path_inside(folder, "old/A-BCS000.AT2").is_file()


def test_what_is_not_a_catalogue_is_left_alone(tmp_path: Path) -> None:
    theirs = tmp_path / "theirs.sqlite"
    with sqlite3.connect(theirs) as connection:
        connection.execute("CREATE TABLE precious (x)")
    connection.close()
    with pytest.raises(RecordError, match="not a catalogue"), open_catalogue(theirs):
        pass
    text = tmp_path / "text.sqlite"
    text.write_text("not a database at all " * 100)
    with pytest.raises(RecordError, match="delete it"), open_catalogue(text):
        pass
    assert text.read_text().startswith("not a database")
    (tmp_path / "link.sqlite").symlink_to(theirs)
    with pytest.raises(RecordError, match="is a link"), open_catalogue(tmp_path / "link.sqlite"):
        pass
    with pytest.raises(RecordError, match="another place"), open_catalogue(tmp_path / "none" / "x.sqlite"):
        pass


def brought_up(folder: Path) -> tuple[Candidate, ...]:
    with open_catalogue(folder / NAME) as catalogue:
        index(folder, catalogue)
        return catalogue_candidates(catalogue)


def test_a_damaged_catalogue_is_told(folder: Path) -> None:
    with open_catalogue(folder / NAME) as catalogue:
        index(folder, catalogue)
    data = bytearray((folder / NAME).read_bytes())
    data[4096:] = os.urandom(len(data) - 4096)
    (folder / NAME).write_bytes(data)
    with pytest.raises(RecordError, match="index again"):
        brought_up(folder)


def test_tables_whose_names_are_no_text_are_told(folder: Path) -> None:
    with open_catalogue(folder / NAME) as catalogue:
        index(folder, catalogue)
    data = (folder / NAME).read_bytes()
    (folder / NAME).write_bytes(data.replace(b"CREATE TABLE files", b"CREATE\xff\xff\xff\xffE files"))
    with pytest.raises(RecordError, match=r"the catalogue is damaged: .* no text; delete it and index again"):
        brought_up(folder)


def test_an_older_version_is_read_again_and_keeps_what_it_was_told(folder: Path) -> None:
    table = folder.parent / "flat.csv"
    table.write_text(FLATFILE, encoding="utf-8")
    with open_catalogue(folder / NAME) as catalogue:
        store_flatfile(catalogue, read_flatfile(table).recordings)
        index(folder, catalogue, overrides=HeaderOverrides("g", None, None))
        before = catalogue_candidates(catalogue)
        catalogue.execute("PRAGMA user_version = 2")
    with open_catalogue(folder / NAME) as catalogue:
        found = index(folder, catalogue)
        assert (found.read, found.older) == (5, True)
        assert [each.magnitude for each in catalogue_candidates(catalogue)] == [each.magnitude for each in before]
        assert catalogue_candidates(catalogue)[0].overrides == HeaderOverrides("g", None, None)
    with open_catalogue(folder / NAME) as catalogue:
        assert not index(folder, catalogue).older


def test_a_newer_version_is_refused_and_left_alone(folder: Path) -> None:
    with open_catalogue(folder / NAME) as catalogue:
        index(folder, catalogue)
        catalogue.execute("PRAGMA user_version = 999")
    before = (folder / NAME).read_bytes()
    words = f"{folder / NAME}: a catalogue of version 999, made by a newer program.*use the newer program"
    with pytest.raises(RecordError, match=words):
        brought_up(folder)
    assert (folder / NAME).read_bytes() == before


CHANGES = {
    "number": "UPDATE records SET pga = pga * 1.0000001 WHERE path LIKE 'RSN57%'",
    "sign": "UPDATE records SET pgv = -pgv WHERE path LIKE 'RSN57%'",
    "kind": "UPDATE records SET pga = 'x' WHERE path LIKE 'RSN57%'",
    "null": "UPDATE records SET dt = NULL WHERE path LIKE 'RSN57%'",
    "ordinates": "UPDATE records SET spectrum = zeroblob(968) WHERE path LIKE 'RSN57%'",
    "ordinates of another kind": "UPDATE records SET spectrum = 'x' WHERE path LIKE 'RSN57%'",
    "not UTF-8": "UPDATE records SET event = CAST(x'ff41' AS TEXT) WHERE path LIKE 'RSN57%'",
    "path of a record": "UPDATE records SET path = 'RSN58_X_1.AT2', position = 7 WHERE path LIKE 'RSN57%'",
    "lost record": "DELETE FROM records WHERE path LIKE 'RSN57%'",
    "lost file": "DELETE FROM files WHERE path LIKE 'RSN57%'",
    "hash of a file": "UPDATE files SET sha256 = 'x' WHERE path LIKE 'RSN57%'",
    "path of a file": "UPDATE files SET path = CAST(x'ff' AS TEXT) WHERE path LIKE 'RSN57%'",
    "seal": "UPDATE records SET seal = NULL WHERE path LIKE 'RSN57%'",
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_row_that_was_changed_is_not_believed(folder: Path, change: str) -> None:
    before = brought_up(folder)
    with sqlite3.connect(folder / NAME) as raw:
        raw.execute(CHANGES[change])
    raw.close()
    with open_catalogue(folder / NAME) as catalogue:
        found = index(folder, catalogue)
        after = catalogue_candidates(catalogue)
    assert found.read >= 1
    if "path" not in change and "lost file" not in change:
        assert found.damaged == ("RSN57_X_0.AT2",)
    assert [replace(each, spectrum=PERIODS) for each in after] == [replace(each, spectrum=PERIODS) for each in before]
    assert all((one.spectrum == other.spectrum).all() for one, other in zip(after, before, strict=True))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("INSERT INTO stated VALUES ('g', 1.0, NULL, 'x')", "what was stated of its files .*delete it and index again"),
        ("INSERT INTO stated VALUES (7, 'x', x'00', NULL)", "what was stated of its files .*delete it and index again"),
        ("INSERT INTO recordings VALUES (57, 'a', 'b', 'c', 'd', 1, 2, NULL, 'x')", "recording 57 of the flatfile"),
    ],
)
def test_what_cannot_be_read_again_is_refused(folder: Path, change: str, words: str) -> None:
    brought_up(folder)
    with sqlite3.connect(folder / NAME) as raw:
        raw.execute("DELETE FROM stated")
        raw.execute(change)
    raw.close()
    with pytest.raises(RecordError, match=words):
        brought_up(folder)


def test_flipped_bits_are_mended_or_refused_and_never_believed(folder: Path) -> None:
    before = {each.path: each for each in brought_up(folder)}
    whole = (folder / NAME).read_bytes()
    generator, refused = np.random.default_rng(7), 0
    for place in generator.integers(0, len(whole), 60):
        data = bytearray(whole)
        data[place] ^= 1 << int(generator.integers(8))
        (folder / NAME).write_bytes(data)
        try:
            after = {each.path: each for each in brought_up(folder)}
        except RecordError:
            refused += 1
            continue
        assert after.keys() == before.keys()
        assert all(after[path].measures == before[path].measures for path in before)
        assert all((after[path].spectrum == before[path].spectrum).all() for path in before)
    assert 0 < refused < 60


@pytest.mark.parametrize("beside", ["-journal", "-wal", "-shm"])
def test_junk_beside_a_catalogue_does_no_harm(folder: Path, beside: str) -> None:
    before = [each.measures for each in brought_up(folder)]
    (folder / f"{NAME}{beside}").write_bytes(os.urandom(5000))
    assert [each.measures for each in brought_up(folder)] == before


def test_an_empty_file_is_a_new_catalogue_and_a_folder_is_none(folder: Path) -> None:
    (folder / NAME).write_bytes(b"")
    assert len(brought_up(folder)) == 4
    (folder / NAME).unlink()
    (folder / NAME).mkdir()
    with pytest.raises(RecordError, match="is a folder; a catalogue must be a file of its own"):
        brought_up(folder)


def test_a_fault_of_a_reader_stops_one_file_only(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def faulty(file: Path, _: object) -> object:
        if file.name.startswith("RSN57"):
            raise ZeroDivisionError("oh")
        return read_records(file)

    monkeypatch.setattr(catalogue_module, "read_with_overrides", faulty)
    with open_catalogue(None) as catalogue:
        found = index(folder, catalogue)
    assert ("RSN57_X_0.AT2", "its reader failed: ZeroDivisionError: oh") in found.problems
    assert found.records == 3


def test_a_folder_that_is_none_is_refused(tmp_path: Path) -> None:
    with open_catalogue(None) as catalogue, pytest.raises(RecordError, match="no such folder"):
        index(tmp_path / "nothing", catalogue)


def test_peaks_are_in_si(folder: Path) -> None:
    with open_catalogue(None) as catalogue:
        index(folder, catalogue)
        assert 0.1 * g < catalogue_candidates(catalogue)[0].measures["pga"] < 0.5 * g


def test_a_row_of_another_number_than_the_file_s_name_does_not_describe_it(folder: Path, tmp_path: Path) -> None:
    table = tmp_path / "flat.csv"
    rows = "157,Quake,1971,6.6,RSN57_X_0.AT2\n58,Other,1972,5.5,RSN58_X_1.AT2\n"
    table.write_text(f"RSN,Earthquake Name,YEAR,Magnitude,File Name (Horizontal 1)\n{rows}")
    with open_catalogue(None) as catalogue:
        index(folder, catalogue)
        store_flatfile(catalogue, read_flatfile(table).recordings)
        found = {one.path: one for one in catalogue_candidates(catalogue)}
    assert (found["RSN57_X_0.AT2"].nga, found["RSN57_X_0.AT2"].magnitude) == (57, None)
    assert (found["RSN58_X_1.AT2"].nga, found["RSN58_X_1.AT2"].magnitude) == (58, 5.5)
