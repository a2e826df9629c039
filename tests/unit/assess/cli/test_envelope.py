"""`assess envelope`: what it prints and writes, and that `run` and `report` carry the same."""

import csv
import io
import json
from pathlib import Path

import pytest
from scipy.constants import g

from tests.support.command import ended
from tests.support.projects import ASCE7, published, tables_toml, write_project

PROJECT = tables_toml(
    title="<b>&",
    site={"spectrum": ASCE7 | {"s_ds": 0.5, "s_d1": 0.2, "t_l": 6}},
    mechanisms={"=slow": published(restitution=0.9), "quick": published(3.36, 0.34, 0.62, restitution=0.8)},
    records={"synthetic": {"count": 2, "duration": 8}},
    analysis={
        "levels": ["0.1 g"],
        "procedures": ["asce43-05-spectrum"],
        "pulses": {
            "frequency": {"from": "0.4 Hz", "to": "4 Hz", "count": 7, "spacing": "log"},
            "amplitude": {"from": "0 g", "to": "4 g", "count": 9},
        },
    },
)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return write_project(tmp_path, PROJECT, name="walls.toml")


def test_json_is_the_envelope_of_results(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("envelope", project, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    slow, quick = found["mechanisms"]
    assert [each["name"] for each in (slow, quick)] == ["=slow", "quick"]
    one = slow["envelope"]
    assert one["shape"] == "sine"
    assert one["equation"] == "linearised"
    assert one["frequency_hz"] == pytest.approx([0.4 * 10 ** (k / 6) for k in range(7)])
    assert one["amplitude_g"] == pytest.approx([0.5 * k for k in range(9)])
    assert len(one["overturned"]) == 7
    assert {len(row) for row in one["overturned"]} == {9}
    for row, bound in zip(one["overturned"], one["lower_bound_g"], strict=True):
        falls = [a for a, down in zip(one["amplitude_g"], row, strict=True) if down]
        assert bound is None or min(falls, default=9.0) >= bound > one["uplift_g"][0]
        assert bound is not None or not falls
    critical = found["critical"]
    pairs = zip(slow["envelope"]["lower_bound_g"], quick["envelope"]["lower_bound_g"], strict=True)
    expected = ["=slow" if (a or 99.0) <= (b or 99.0) else "quick" for a, b in pairs]
    assert critical["mechanism"] == [
        who if bound else None for who, bound in zip(expected, critical["lower_bound_g"], strict=True)
    ]
    assert {"=slow", "quick"} <= set(critical["mechanism"])
    assert critical["bands"][0]["from_hz"] == pytest.approx(0.4)


def test_the_bound_is_where_the_outcome_changes(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Amplitudes a hair below and above the bound of one frequency, as a grid of their own."""
    ended("envelope", project, "--json")
    bound = json.loads(capsys.readouterr().out)["mechanisms"][1]["envelope"]["lower_bound_g"][0]
    grid = f'amplitude = {{ from = "{bound * (1 - 1e-9)!r} g", to = "{bound * (1 + 1e-9)!r} g", count = 2 }}'
    project.write_text(PROJECT.replace('amplitude = { from = "0 g", to = "4 g", count = 9 }', grid))
    ended("envelope", project, "--json")
    assert json.loads(capsys.readouterr().out)["mechanisms"][1]["envelope"]["overturned"][0] == [False, True]


def test_csv_is_safe_and_complete(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("envelope", project, "--csv") == 0
    rows = list(csv.reader(io.StringIO(capsys.readouterr().out)))
    assert rows[0] == ["frequency [Hz]", "critical", "least [g]", "'=slow [g]", "quick [g]"]
    assert len(rows) == 8
    assert rows[1][1] == "'=slow"
    assert float(rows[1][2]) == float(rows[1][3])


def test_files_are_written_and_the_report_is_made_again(project: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert ended("envelope", project, "-o", out) == 0
    assert (out / "envelopes.pdf").read_bytes().startswith(b"%PDF")
    assert {path.name for path in (out / "figures").iterdir()} == {
        "critical.svg", "01-slow-envelope.svg", "02-quick-envelope.svg",
    }  # fmt: skip
    results = json.loads((out / "envelopes.json").read_text())
    assert results["critical"]["frequency_hz"][0] == pytest.approx(0.4)
    again = tmp_path / "again"
    assert ended("report", out / "envelopes.json", "-o", again) == 0
    assert (again / "envelopes.pdf").exists()


def test_run_has_the_same_envelopes(project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ended("envelope", project, "--json")
    alone = json.loads(capsys.readouterr().out)
    assert ended("run", project, "-o", tmp_path / "run") == 3  # no basis
    results = json.loads((tmp_path / "run" / "results.json").read_text())
    assert results["critical"] == alone["critical"]
    assert [m["envelope"] for m in results["mechanisms"]] == [m["envelope"] for m in alone["mechanisms"]]
    pulses = results["records"][0]["primary_pulses"]
    assert pulses
    assert 0.0 < pulses[0]["energy_share"] < 1.0
    assert (tmp_path / "run" / "tables" / "envelopes.csv").exists()


def test_without_the_table_sines_up_to_10_hz(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project.write_text(PROJECT.split("[analysis.pulses]")[0])
    assert ended("envelope", project, "--json") == 0
    one = json.loads(capsys.readouterr().out)["mechanisms"][0]["envelope"]
    assert (one["frequency_hz"][0], one["frequency_hz"][-1], len(one["frequency_hz"])) == (0.2, 10.0, 100)
    assert (one["amplitude_g"][0], one["amplitude_g"][-1]) == (0.0, pytest.approx(3.0))


@pytest.mark.parametrize(
    ("change", "where"),
    [
        (('to = "4 Hz"', 'to = "0.1 Hz"'), "analysis.pulses.frequency.to"),
        (('to = "4 g"', 'to = "0 g"'), "analysis.pulses.amplitude.to"),
        (("count = 7", "count = 1"), "analysis.pulses.frequency.count"),
        (('from = "0.4 Hz"', 'from = "-1 Hz"'), "analysis.pulses.frequency.from"),
        (('from = "0.4 Hz"', 'from = "0.4 m"'), "analysis.pulses.frequency.from"),
        (("[analysis.pulses]", '[analysis.pulses]\nshape = "square"'), "analysis.pulses.shape"),
        (("[analysis.pulses]", "[analysis.pulses]\ngamma = 3"), "analysis.pulses.gamma"),
    ],
)
def test_bad_pulses_are_told_by_key(
    change: tuple[str, str], where: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project.write_text(PROJECT.replace(*change))
    assert ended("envelope", project) == 2
    said = capsys.readouterr().err
    assert where in said
    assert said.count("\n") == 1


def test_a_pulse_shape_with_parameters(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    longer = '[analysis.pulses]\nshape = "mavroeidis-papageorgiou"\ngamma = 3\nnu = "90 deg"'
    project.write_text(PROJECT.replace("[analysis.pulses]", longer))
    assert ended("envelope", project, "--json") == 0
    one = json.loads(capsys.readouterr().out)["mechanisms"][0]["envelope"]
    assert (one["shape"], one["gamma"]) == ("mavroeidis-papageorgiou", 3.0)
    assert one["nu_rad"] == pytest.approx(1.5707963)
    assert all(a > 0.14 * g / g for a in one["lower_bound_g"] if a is not None)
