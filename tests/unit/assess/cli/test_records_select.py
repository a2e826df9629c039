"""`assess records index|spectra|select|scale`: what they print, write and refuse."""

import csv
import io
import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.constants import g

import assess
from assess.errors import AssessError
from records import candidates
from records.catalogue import NAME
from records.processing import at2_text
from records.reading import read_records
from records.record import make_record
from spectra.table import read_table
from tests.support.command import ended
from tests.support.projects import project_toml

TARGET = "period [s], acceleration [g]\n0, 0.2\n0.1, 0.5\n0.5, 0.5\n1, 0.25\n4, 0.0625\n"
FLATFILE = """Record Sequence Number,Earthquake Name,YEAR,Earthquake Magnitude,ClstD (km),Vs30 (m/s)
101,=cmd,1980,6.5,20,400
102,Quake 2,1981,7.0,40,300
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    place = tmp_path / "motions"
    place.mkdir()
    rng = np.random.default_rng(7)
    for number in range(5):
        wide = np.hanning(11 + 8 * number)
        shake = np.convolve(rng.normal(0.0, 1.0, 1500) * np.hanning(1500), wide, mode="same")
        record = make_record("x", shake / wide.sum(), 0.02, event=f"Quake {number}", station="S", component="000")
        (place / f"RSN{100 + number}_Q.AT2").write_text(at2_text(record))
    (place / "a\x1b[31m.txt").write_text("no record")
    (tmp_path / "target.csv").write_text(TARGET)
    (tmp_path / "flat.csv").write_text(FLATFILE)
    return place


def select(folder: Path, *more: str | Path | float) -> int:
    limits = ("--scale-limits", 0.001, 1000)
    return ended("records", "select", folder, "--target", folder.parent / "target.csv", *limits, *more)


def test_index_tells_what_was_read_and_what_could_not_be(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("records", "index", folder, "--flatfile", folder.parent / "flat.csv", "--jobs", 1) == 0
    out = capsys.readouterr().out
    assert out.startswith("6 files read, 0 unchanged, 0 gone; 5 records, 2 of known magnitude; 1 files not readable\n")
    assert "\x1b" not in out
    assert out.splitlines()[-1] == str(folder / NAME)
    assert ended("records", "index", folder, "--json") == 0
    again = json.loads(capsys.readouterr().out)
    assert (again["read"], again["unchanged"], again["with_magnitude"]) == (0, 6, 2)
    assert again["problems"][0]["path"] == "a\x1b[31m.txt"


def test_a_catalogue_may_lie_elsewhere(folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    elsewhere = tmp_path / "kept.sqlite"
    assert ended("records", "index", folder, "--catalogue", elsewhere, "--jobs", 1) == 0
    assert select(folder, "--count", 2, "--catalogue", elsewhere) == 0
    assert ended("records", "spectra", folder, "--catalogue", elsewhere) == 0
    assert not (folder / NAME).exists()
    assert capsys.readouterr().err == ""


def test_select_prints_records_and_requirements(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert select(folder, "--count", 3) == 0
    out = capsys.readouterr().out
    assert out.splitlines()[0].split() == ["record", "event", "NGA", "M", "comp.", "misfit", "factor", "PGA", "[g]"]
    assert len(out.split("\n\n")[0].splitlines()) == 4
    assert "NZS 1170.5:2004" in out
    assert "5 of different earthquakes" in out


def test_python_selects_as_the_command_line_does(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    limits = {"scale_limits": (0.001, 1000.0), "count": 3}
    assert select(folder, "--count", 3, "--pga", 0.0, 100.0, "--json") == 0
    printed = json.loads(capsys.readouterr().out)["records"]
    target, known = read_table(folder.parent / "target.csv"), assess.catalogue(folder)
    found = assess.select_records(target, known, pga=(0.0, 100.0 * g), **limits)
    assert [(each.record.id, each.scaling.factor) for each in found.motions] == [
        (each["id"], each["scale_factor"]) for each in printed
    ]
    for scaled, each in zip(found.records, found.motions, strict=True):
        np.testing.assert_allclose(scaled.acceleration, each.scaling.factor * each.record.acceleration, rtol=1e-15)
    assert len(known.table()) == 5
    assert known.problems[0][0].endswith(".txt")
    assert assess.select_records(target, folder, **limits).records[0].id == found.records[0].id


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"fit": "best"}, 'fit "best": not known; choose one of suite, each'),
        ({"code": "ntc"}, 'code "ntc": not known'),
        ({"pga": (2.0, 1.0)}, "pga 2 1: the first is larger"),
        ({"count": 0}, "count = 0: give a whole number"),
    ],
)
def test_python_refuses_an_argument_that_cannot_be_followed(folder: Path, given: dict[str, Any], said: str) -> None:
    with pytest.raises(AssessError, match=said):
        assess.select_records(read_table(folder.parent / "target.csv"), folder, **given)


def test_select_as_json_and_csv_agree_and_each_fits_best(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert select(folder, "--count", 2, "--fit", "each", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert select(folder, "--count", 2, "--fit", "each", "--csv") == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [row["id"] for row in rows] == [record["id"] for record in found["records"]]
    assert [float(row["mse"]) for row in rows] == [record["mse"] for record in found["records"]]
    assert found["ground_motion"]["selection"]["fit"] == "each"
    assert (
        ended("records", "scale", *sorted(folder.glob("*.AT2")), "--target", folder.parent / "target.csv", "--csv") == 0
    )
    scaled = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    best = sorted(scaled, key=lambda row: float(row["mse"]))[:2]  # by the same least squares, over other points
    assert {row["id"] for row in best} == {row["id"] for row in rows}


def test_filters_and_hostile_names(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    flat = ("--flatfile", folder.parent / "flat.csv")
    assert select(folder, "--count", 1, "--magnitude", 6, 6.6, "--distance", 10, 30, *flat, "--csv") == 0
    (row,) = csv.DictReader(io.StringIO(capsys.readouterr().out))
    assert (row["event"], row["magnitude"], row["distance_km"], row["nga"]) == ("'=cmd", "6.5", "20.0", "101")
    assert select(folder, "--count", 1, "--event", "quake 3", "--csv") == 0
    (row,) = csv.DictReader(io.StringIO(capsys.readouterr().out))
    assert row["event"] == "Quake 3"


@pytest.mark.parametrize("ending", ["svg", "png", "pdf"])
def test_figures(folder: Path, ending: str) -> None:
    assert select(folder, "--count", 2, "-o", folder.parent / f"suite.{ending}") == 0
    assert ended("records", "spectra", folder, "-o", folder.parent / f"spectra.{ending}") == 0
    for name in ("suite", "spectra"):
        assert (folder.parent / f"{name}.{ending}").stat().st_size > 5000


def test_spectra_of_files_and_of_their_folder_agree(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("records", "spectra", folder, "--csv") == 0
    of_folder = capsys.readouterr().out
    assert ended("records", "spectra", *sorted(folder.glob("*.AT2")), "--csv") == 0
    assert capsys.readouterr().out == of_folder
    header, first, *rest = csv.reader(io.StringIO(of_folder))
    assert header[:2] == ["period [s]", "RSN100_Q [m/s2]"]
    assert float(first[1]) == read_records(folder / "RSN100_Q.AT2")[0].pga
    assert len(rest) == 121


def test_scaled_records_meet_the_ordinate_and_the_peak(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files, target = sorted(folder.glob("*.AT2")), folder.parent / "target.csv"
    assert ended("records", "scale", *files, "--target", target, "--to", "pga", "--csv") == 0
    for row in csv.DictReader(io.StringIO(capsys.readouterr().out)):
        assert float(row["pga_g"]) == pytest.approx(0.2, rel=1e-12)
    assert ended("records", "scale", *files, "--target", target, "--at", 1.0, "-o", folder.parent / "scaled") == 0
    written = sorted((folder.parent / "scaled").glob("*.csv"))
    assert len(written) == 5
    from records.response import response_spectrum

    for path in written:
        (record,) = read_records(path)
        assert response_spectrum(record, 1.0) == pytest.approx(0.25 * g, rel=1e-9)
    assert read_table(target).pga == pytest.approx(0.2 * g)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("select", "{folder}"), "without project.toml"),
        (("select", "{folder}", "--count", "3"), "--count needs --target"),
        (("select", "{folder}", "--target", "{none}"), "none"),
        (("select", "{none}", "--target", "{target}"), "none"),
        (("select", "{folder}", "--target", "{target}", "--fit", "best"), 'fit "best": not known; choose one of suite'),
        (("select", "{folder}", "--target", "{target}", "--scale-to", "x"), "choose one of spectrum, pga, none"),
        (("select", "{folder}", "--target", "{target}", "--periods", "2", "1"), "they must rise"),
        (("select", "{folder}", "--target", "{target}", "--periods", "5", "9"), "the spectrum ends at 4 s"),
        (("select", "{folder}", "--target", "{target}", "--pga", "2", "1"), "--pga 2 1"),
        (("select", "{folder}", "--target", "{target}", "--count", "99"), "99 records wanted; there are 5 components"),
        (("select", "{folder}", "--target", "{target}", "-o", "x.gif"), "a figure is written as"),
        (("select", "{folder}", "--target", "{target}", "--flatfile", "{target}"), "Record Sequence Number"),
        (("select", "{folder}", "--target", "{target}", "--json", "--csv"), "exclude"),
        (("index", "{none}"), "no such folder"),
        (("index", "{target}"), "target.csv: is a file; give the folder that holds it"),
        (("index", "{folder}", "--unit", "stone"), 'unit "stone" is not known'),
        (("index", "{folder}", "--step", "nan"), "time step nan s"),
        (("index", "{folder}", "--response", "{none}"), "none: no such file; give the StationXML"),
        (("scale", "{folder}", "--target", "{target}"), "motions: is a folder; give the files in it"),
        (("select", "{folder}", "--target", "{target}", "--pga", "nan", "1"), "--pga nan 1: not a number"),
        (("select", "{folder}", "--target", "{folder}/RSN100_Q.AT2"), "RSN100_Q.AT2: a target is a project"),
        (("select", "{folder}", "--target", "{target}", "-o", "{none}/f.svg"), "none does not exist; create it first"),
        (("spectra", "{folder}", "-o", "{none}/f.svg"), "none does not exist; create it first"),
        (("index", "{folder}", "--catalogue", "{target}"), "target.csv: the catalogue cannot be used"),
        (("spectra", "{folder}", "--damping", "0.1"), "holds spectra of 5 % damping"),
        (("spectra", "{folder}/RSN100_Q.AT2", "--damping", "7"), "damping"),
        (("scale", "{folder}/RSN100_Q.AT2"), "--target"),
        (("scale", "{folder}/RSN100_Q.AT2", "--target", "{target}", "--to", "x"), "choose one of"),
        (("scale", "{folder}/RSN100_Q.AT2", "--target", "{target}", "--at", "-1"), "--at -1: records"),
        (("scale", "{folder}/RSN100_Q.AT2", "--target", "{target}", "--at", "50"), "from 0.01 s to 10 s"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(
    folder: Path, arguments: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    places = {"folder": folder, "target": folder.parent / "target.csv", "none": folder / "none"}
    assert ended("records", *(each.format(**places) for each in arguments)) == 2
    captured = capsys.readouterr()
    assert captured.err.count("\n") == 1
    assert said in captured.err
    assert captured.out == ""
    assert not (folder / "none").exists()


BARE = "time [s],acceleration\n" + "".join(f"{i / 100},{(i % 7) - 3}\n" for i in range(300))


def test_what_an_index_was_told_is_kept(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "bare.csv").write_text(BARE)
    (folder / "column.txt").write_text("".join(f"{(i % 5) - 2}\n" for i in range(300)))
    assert ended("records", "index", folder) == 0
    assert "bare.csv: the file does not state the unit of its accelerations; write it" in capsys.readouterr().out
    assert ended("records", "index", folder, "--unit", "m/s2", "--step", 0.01) == 0
    assert "8 files read, 0 unchanged, 0 gone; 7 records" in capsys.readouterr().out
    for more in ((), ("--unit", "m/s2")):
        assert ended("records", "index", folder, *more) == 0
        assert "0 files read, 8 unchanged, 0 gone; 7 records" in capsys.readouterr().out
    assert ended("records", "spectra", folder) == 0
    assert "\nbare " in capsys.readouterr().out
    assert select(folder, "--count", 7, "--several-per-event", "--json") == 0
    chosen = json.loads(capsys.readouterr().out)["records"]
    assert {"bare", "column"} < {one["id"] for one in chosen}
    (one,) = (each for each in chosen if each["id"] == "bare")
    assert one["pga_g"] == pytest.approx(3.0 * one["scale_factor"] / g, rel=1e-9)
    assert ended("records", "index", folder, "--unit", "g") == 0  # given anew it goes before what was kept
    assert "8 files read" in capsys.readouterr().out


def test_a_misspelt_header_of_a_flatfile_is_told(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    flat = folder.parent / "flat.csv"
    flat.write_text(FLATFILE.replace("Magnitude", "MagnittD", 1))
    assert "Magnitude" in FLATFILE
    assert ended("records", "index", folder, "--flatfile", flat, "--json") == 0
    told = json.loads(capsys.readouterr().out)["flatfile"]["warning"]
    assert told.startswith("the flatfile has no column of magnitude under a name that is known")
    assert "mw" in told


def test_an_index_tells_what_became_of_a_flatfile(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    flat = folder.parent / "flat.csv"
    flat.write_text(FLATFILE + '103,Q,1982,67,"12,5",n/a\nlast,Q,1982,6,1,300\n\n999,None,2000,7.0,40,300\n')
    assert ended("records", "index", folder, "--flatfile", flat) == 0
    out = capsys.readouterr().out
    assert "flatfile: 3 rows matched, 1 unmatched, 3 bad cells; 3 records described\n" in out
    assert 'flatfile, row 4, ClstD (km): "12,5": impossible value; ignored\n' in out
    assert ended("records", "index", folder, "--flatfile", flat, "--json") == 0
    told = json.loads(capsys.readouterr().out)["flatfile"]
    assert (told["matched"], told["unmatched"], told["records"]) == (3, 1, 3)
    assert told["warning"].startswith("of 5 records 2 have no row in the flatfile, like rsn100_q.at2;")
    assert [(cell["row"], cell["column"], cell["value"]) for cell in told["bad_cells"]] == [
        (4, "Earthquake Magnitude", "67"),
        (4, "ClstD (km)", "12,5"),
        (5, "Record Sequence Number", "last"),
    ]
    assert select(folder, "--count", 2, "--flatfile", flat) == 0
    out = capsys.readouterr().out
    assert "warning: records.flatfile: row 4," in out
    assert "warning: records.flatfile: of 5 records 2 have no row" in out
    flat.write_text(FLATFILE + "".join(f"{number},Q,1982,6,20,400\n" for number in (100, 103, 104)))
    assert ended("records", "index", folder, "--flatfile", flat, "--json") == 0
    assert json.loads(capsys.readouterr().out)["flatfile"]["warning"] is None


@pytest.mark.parametrize(
    ("rows", "renamed", "reason"),
    [
        ("9001,Q,2010,7,20,400\n", False, "the files have NGA numbers 100 to 104, the table 9001 to 9001"),
        ("101,Q,2010,7,20,400\n", True, "q0.at2 has neither; keep the names that files had when downloaded"),
    ],
)
def test_a_flatfile_that_fits_nothing_is_warned_of(
    folder: Path, rows: str, renamed: bool, reason: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if renamed:
        for number in range(5):
            (folder / f"RSN{100 + number}_Q.AT2").rename(folder / f"q{number}.at2")
    flat = folder.parent / "flat.csv"
    flat.write_text(FLATFILE.splitlines()[0] + "\n" + rows)
    assert ended("records", "index", folder, "--flatfile", flat, "--json") == 0
    captured = capsys.readouterr()
    assert reason in captured.err
    assert reason in json.loads(captured.out)["flatfile"]["warning"]


def test_records_of_unknown_magnitude_are_counted(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert select(folder, "--magnitude", 5, 8, "--flatfile", folder.parent / "flat.csv", "--count", 2) == 0
    assert "2 of known magnitude; 2 that pass the filters" in capsys.readouterr().out
    assert select(folder, "--magnitude", 5, 8, "--vs30", 1, 9, "--count", 2) == 2
    said = capsys.readouterr().err
    assert "0 of known magnitude, 0 of known vs30" in said
    assert "or a flatfile that knows more of them" in said


def test_many_files_are_read_by_processes(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = []

    class Executor(ThreadPoolExecutor):
        def map(self, *arguments, **options):  # type: ignore[no-untyped-def]
            asked.append(self._max_workers)
            return super().map(*arguments, **options)

    monkeypatch.setattr("assess.workers.SpawnedPool", Executor)
    monkeypatch.setattr("assess.workers.available_cores", lambda: 8)
    monkeypatch.setattr(candidates, "FEW", 1)
    (folder.parent / "project.toml").write_text(
        project_toml(
            site={"spectrum": {"code": "table", "file": "target.csv"}},
            analysis={"levels": ["0.1 g"]},
            records={
                "files": ["motions"],
                "select": {"count": 2, "scale_limits": [0.001, 1000], "periods": [0.1, 2]},
            },
        )
    )
    assert ended("run", folder.parent, "--no-report", "--jobs", 3) == 3  # no basis
    assert asked == [3]
    for command in (("select", folder.parent), ("spectra", folder)):
        (folder / NAME).unlink()
        assert ended("records", *command, "--jobs", 2) == 0
    assert asked == [3, 2, 2]
    (folder / NAME).unlink()
    assert ended("records", "index", folder, "--jobs", 1) == 0
    assert asked == [3, 2, 2]
