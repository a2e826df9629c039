"""`assess records list` and `convert`."""

import csv
import io
import json
import re
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from records.processing import at2_text, csv_text
from records.reading import read_records
from records.record import Earthquake, StationSite, make_record
from tests.support.command import ended
from tests.support.projects import ASCE7, published, tables_toml, write_project

DT = 0.01
TIME = DT * np.arange(2000)
SAMPLES = np.sin(np.pi * TIME / 20.0) ** 2 * np.sin(2 * np.pi * 2.0 * TIME)  # m/s2
HOSTILE = "=cmd|'/c calc'!A1\n<b>&\x1b[31m, Some School"


@pytest.fixture
def pair(tmp_path: Path) -> tuple[Path, Path]:
    """North and east of a motion along 30 degrees, as AT2 files."""
    paths = tmp_path / "n.AT2", tmp_path / "e.at2"
    for path, azimuth in zip(paths, (0.0, 90.0), strict=True):
        samples = SAMPLES * np.cos(np.radians(30.0 - azimuth))
        quake = Earthquake(time="1989-10-18T00:04:00Z")
        made = make_record("x", samples, DT, event="Q", station="S, T", component=f"{azimuth:g}", earthquake=quake)
        path.write_text(at2_text(made))
    return paths


def test_json_has_the_records_of_results_and_the_measures(
    pair: tuple[Path, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    assert ended("records", "list", *pair, "--json") == 0
    north, east = json.loads(capsys.readouterr().out)
    assert (north["id"], east["id"]) == ("n", "e")
    assert (north["event"], north["station"], north["component"]) == ("Q", "S, T", "0")
    assert (north["npts"], north["dt_s"], north["scale_factor"], north["mse"]) == (2000, DT, 1.0, None)
    assert north["pga_g"] == pytest.approx(np.cos(np.radians(30)) * np.abs(SAMPLES).max() / g, rel=1e-6)
    assert east["azimuth_deg"] == pytest.approx(90.0)
    assert north["earthquake"]["origin_time"] == "1989-10-18"
    assert north["measures"]["arias_m_per_s"] == pytest.approx(3 * east["measures"]["arias_m_per_s"], rel=1e-5)
    assert north["spectrum"]["acceleration_g"][0] == north["pga_g"]
    assert len(north["spectrum"]["period_s"]) == len(north["spectrum"]["acceleration_g"])


def test_csv_has_a_row_for_each_record(pair: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("records", "list", *pair, "--csv") == 0
    north, _ = csv.DictReader(io.StringIO(capsys.readouterr().out))
    assert (north["npts"], north["station"], north["vertical"]) == ("2000", "S, T", "False")
    assert float(north["d5_95_s"]) > float(north["d5_75_s"]) > 0.0


def test_the_table_is_for_reading(pair: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("records", "list", *pair) == 0
    header, north, east = capsys.readouterr().out.splitlines()
    assert header.startswith("record")
    assert (north.split()[0], east.split()[0]) == ("n", "e")


@pytest.mark.parametrize("ending", ["csv", "CSV", "at2", "AT2"])
def test_what_is_written_is_read_again(tmp_path: Path, pair: tuple[Path, Path], ending: str) -> None:
    out = tmp_path / f"out.{ending}"
    assert ended("records", "convert", pair[0], "-o", out) == 0
    (before,), (after,) = read_records(pair[0]), read_records(out)
    np.testing.assert_allclose(after.acceleration, before.acceleration, rtol=1e-7, atol=1e-12)
    assert (after.dt, after.event, after.station, after.component) == (before.dt, "Q", "S, T", "0")
    assert after.earthquake.time == "1989-10-18"
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["n.AT2", "e.at2", out.name])


@pytest.mark.parametrize("options", [("--azimuth", 30), ("--rotd", 100)])
def test_two_components_are_turned(tmp_path: Path, pair: tuple[Path, Path], options: tuple[str, int]) -> None:
    assert ended("records", "convert", *pair, *options, "-o", tmp_path / "out.csv") == 0
    np.testing.assert_allclose(read_records(tmp_path / "out.csv")[0].acceleration, SAMPLES, rtol=0, atol=1e-6)


def test_processing_in_its_order(tmp_path: Path, pair: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out.csv"
    corrected = ["--baseline", "1", "--low-cut", "0.1", "--high-cut", "20"]
    cut = ["--trim", "0.001", "0.999", "--resample", "0.005", "--scale", "2"]
    assert ended("records", "convert", pair[0], *corrected, *cut, "-o", out) == 0
    said = capsys.readouterr().out
    steps = ["baseline of degree 1", "acausal Butterworth", "trimmed to", "resampled from", "scaled by 2"]
    assert [said.index(step) for step in steps] == sorted(said.index(step) for step in steps)
    (record,) = read_records(out)
    assert record.dt == 0.005
    assert record.pga == pytest.approx(2.0 * np.cos(np.radians(30)), rel=0.02)


def test_hostile_names_are_text_on_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = make_record("x", SAMPLES, DT, event=HOSTILE, station=HOSTILE, component=HOSTILE)
    for name, text in (("a.csv", csv_text(made)), ("a.at2", at2_text(made))):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        (record,) = read_records(path)
        np.testing.assert_allclose(record.acceleration, SAMPLES, rtol=1e-6, atol=1e-9)
        assert ended("records", "list", path) == 0
        assert len(capsys.readouterr().out.splitlines()) == 2


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["list", "absent.at2"], "absent.at2: the file cannot be read"),
        (["list", "."], ".: is a folder; give the files in it"),
        (["convert", ".", "-o", "out.csv"], ".: is a folder; give the files in it"),
        (["list", "bare.txt", "--step", "1"], "give unit (--unit g on the command line"),
        (["list", "bare.txt", "--unit", "g"], "give step, in seconds (--step 0.01 on the command line"),
        (
            ["convert", "n.AT2", "--high-cut", "60", "-o", "out.csv"],
            '"n": high corner 60 Hz; a corner must lie above 0',
        ),
        (["convert", "n.AT2", "--to-unit", "ft", "-o", "out.csv"], '--to-unit: unit "ft" is not known; choose one of'),
        (["convert", "n.AT2", "--to-unit", "m/s2", "-o", "out.at2"], "PEER AT2 is in g by its format"),
        (["list"], "Missing argument"),
        (["list", "n.AT2", "--json", "--csv"], "exclude each other"),
        (["list", "bare.txt"], "does not state the unit"),
        (["list", "bare.txt", "--unit", "stone", "--step", "0.1"], 'unit "stone" is not known'),
        (["list", "bare.txt", "--unit", "g", "--step", "-1"], "time step -1"),
        (["list", "bare.txt", "--unit", "g", "--step", "nan"], "time step nan"),
        (["convert", "n.AT2"], "Missing option"),
        (["convert", "n.AT2", "-o", "out.txt"], "choose one of .csv, .at2"),
        (["convert", "n.AT2", "-o", "n.AT2"], "an input file"),
        (["convert", "n.AT2", "-o", "absent/out.csv"], "no folder absent"),
        (["convert", "n.AT2", "e.at2", "-o", "out.csv"], 'choose with --component: "0" of n, "90" of e'),
        (["convert", "n.AT2", "--azimuth", "30", "-o", "out.csv"], "two horizontal components are turned"),
        (["convert", "n.AT2", "e.at2", "--azimuth", "nan", "-o", "out.csv"], "azimuth"),
        (["convert", "n.AT2", "e.at2", "--azimuth", "1", "--rotd", "50", "-o", "out.csv"], "exclude each other"),
        (["convert", "n.AT2", "--low-cut", "99", "-o", "out.csv"], "low corner 99 Hz; a corner must lie above 0"),
        (["convert", "n.AT2", "--trim", "0.9", "0.1", "-o", "out.csv"], "0 <= from < to <= 1"),
        (["convert", "n.AT2", "--scale", "inf", "-o", "out.csv"], "--scale inf"),
        (["convert", "n.AT2", "--resample", "0", "-o", "out.csv"], "it must be positive"),
        (["unheard-of"], "unheard-of"),
    ],
)
def test_wrong_input_is_one_line_and_exit_2(
    tmp_path: Path,
    pair: tuple[Path, Path],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    words: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bare.txt").write_text("0.1\n-0.2\n0.3\n")
    before = sorted(path.name for path in tmp_path.iterdir())
    assert ended("records", *arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert words in captured.err
    assert len(captured.err.splitlines()) == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == before


def test_without_a_command_the_help_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    assert (
        ended(
            "records",
        )
        == 2
    )
    assert "convert" in capsys.readouterr().out


PROJECT = tables_toml(
    site={"spectrum": ASCE7 | {"s_ds": 0.5, "s_d1": 0.2, "t_l": 6}},
    mechanisms={"a": published(restitution=0.9)},
    analysis={"levels": ["0.1 g"]},
    records={"files": ["bare.txt"]},
)


def test_a_project_states_unit_and_step_of_files_that_do_not(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "bare.txt").write_text("\n".join(f"{a:.6f}" for a in SAMPLES))

    assert ended("check", write_project(tmp_path, PROJECT, 'unit = "m/s^2"')) == 2
    assert "does not state its time step" in capsys.readouterr().err
    assert ended("check", write_project(tmp_path, PROJECT, 'unit = "m/s^2"\nstep = "0.01 s"')) == 0
    assert ended("check", write_project(tmp_path, PROJECT, 'unit = "m/s^2"\nstep = "-1 s"')) == 2
    assert "records.step" in capsys.readouterr().err
    assert ended("check", write_project(tmp_path, PROJECT, 'response = "absent.xml"')) == 2
    assert "absent.xml" in capsys.readouterr().err


QUAKE = Earthquake("1989-10-18T00:04:15Z", 6.93, "Mw", 37.04, -121.883, 17_480.0)
SITE = StationSite(37.046, -121.803, 97.5, 462.24, "NEHRP C", "crest of a dam")
WORDS = {"event": "Loma Prieta", "station": "Corralitos, 1 Road", "component": "N30E"}
MORE = {"azimuth": np.radians(30.0), "distance": 7_170.0, "earthquake": QUAKE, "site": SITE}
WHOLE_RECORD = make_record("x", SAMPLES, DT, processing_history=("read", "filtered"), **WORDS, **MORE)
"""A record of which everything is known."""


@pytest.mark.parametrize("unit", ["m/s2", "g", "cm/s2", "gal", "mm/s2"])
def test_a_round_trip_keeps_all_that_is_known(tmp_path: Path, unit: str) -> None:
    before = WHOLE_RECORD
    (tmp_path / "a.csv").write_text(csv_text(before), encoding="utf-8")
    assert ended("records", "convert", tmp_path / "a.csv", "--to-unit", unit, "-o", tmp_path / "b.csv") == 0
    (after,) = read_records(tmp_path / "b.csv")
    kept = ("event", "station", "component", "earthquake", "site", "distance")
    assert [getattr(after, name) for name in kept] == [getattr(before, name) for name in kept]
    assert after.azimuth == pytest.approx(before.azimuth, rel=1e-12)
    np.testing.assert_allclose(after.acceleration, before.acceleration, rtol=1e-14, atol=1e-17)
    assert f"acceleration [{unit}]" in (tmp_path / "b.csv").read_text(encoding="utf-8")
    assert "read; filtered" in str(after.processing_history[-1])


def test_a_file_of_ours_that_was_cut_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    whole = csv_text(WHOLE_RECORD)
    for share in (0.5, 0.9, 0.999):
        (tmp_path / "a.csv").write_text(whole[: int(share * len(whole))].rpartition("\n")[0], encoding="utf-8")
        assert ended("records", "list", tmp_path / "a.csv") == 2
        assert re.search(r"a\.csv: \d+ rows, and 2000 by its comment `# samples`", capsys.readouterr().err)


def test_spoilt_comments_are_text_or_not_known(tmp_path: Path) -> None:
    head = [
        "magnitude: six",
        "vs30 [m/s]: inf",
        "azimuth [deg]: nan",
        "distance [km]:",
        "event: [b]\x1b",
        "trail: " + "x" * 4000,
    ]
    text = csv_text(make_record("x", SAMPLES, DT)).replace(
        "time [s]", "".join(f"# {line}\n" for line in head) + "time [s]"
    )
    (tmp_path / "a.csv").write_text(text.replace("\x1b", ""), encoding="utf-8")
    (record,) = read_records(tmp_path / "a.csv")
    assert (record.earthquake.magnitude, record.site.vs30, record.azimuth, record.distance) == (None, None, None, None)
    assert record.event == "[b]"
    assert len(str(record.processing_history[-1])) < 2100


def test_a_component_is_found_whatever_its_capitals(tmp_path: Path) -> None:
    for name, component in (("a", "Up"), ("b", "90 Deg")):
        (tmp_path / f"{name}.csv").write_text(csv_text(make_record("x", SAMPLES, DT, component=component)))
    files = tmp_path / "a.csv", tmp_path / "b.csv"
    assert ended("records", "convert", *files, "--component", "90 deg", "-o", tmp_path / "out.csv") == 0
    assert read_records(tmp_path / "out.csv")[0].component == "90 Deg"


@pytest.mark.parametrize(
    ("factor", "unit", "words"),
    [
        (
            6.8,
            "g",
            "its peak is 6.8 g, above 3 g, as hardly any earthquake reaches; check the unit (read in g; in m/s2",
        ),
        (200.0, "m/s2", "its peak is 20.39 g, above 3 g"),
        (0.05, "mm/s2", "below 1e-05 g; check the unit (read in mm/s2; in g it would be 0.05 g)"),
    ],
)
def test_a_peak_that_cannot_be_is_warned_of(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], factor: float, unit: str, words: str
) -> None:
    path = tmp_path / "bare.csv"
    path.write_text("".join(f"{i * DT:.2f},{factor * a / np.abs(SAMPLES).max():.9g}\n" for i, a in enumerate(SAMPLES)))
    for form in ((), ("--json",)):
        assert ended("records", "list", path, "--unit", unit, *form) == 0
        captured = capsys.readouterr()
        assert captured.err.startswith("assess: warning: bare: ")
        assert words in captured.err


def test_a_usual_peak_is_not_warned_of(pair: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("records", "list", *pair) == 0
    assert capsys.readouterr().err == ""
