"""`assess fragility`: what it prints and writes, and what it refuses."""

import csv
import io
import json
from pathlib import Path

import pytest

from tests.support.command import ended
from tests.support.motions import write_noise
from tests.support.projects import published, tables_toml

HAZARD = [
    {"return_period": 30, "a_g": "0.05 g", "f_0": 2.4, "t_c_star": "0.28 s"},
    {"return_period": 475, "a_g": "0.15 g", "f_0": 2.4, "t_c_star": "0.32 s"},
    {"return_period": 2475, "a_g": "0.28 g", "f_0": 2.4, "t_c_star": "0.34 s"},
]
SITE = {"spectrum": {"code": "ntc2018", "soil": "A", "topography": "T1", "nominal_life": 50, "use_class": "II",
                     "hazard": HAZARD}}  # fmt: skip


def written(folder: Path, fragility: dict | None = None, risk: dict | None = None, **more: object) -> Path:
    """A project of two blocks and four records."""
    (folder / "records").mkdir(exist_ok=True)
    for seed in range(4):
        write_noise(folder / "records" / f"r{seed}.csv", duration=6.0, seed=seed, amplitude=2.0)
    asked = {"fragility": {"samples": 12, "draws": 100, "measures": ["pga", "pgv"]} | (fragility or {})}
    tables = {
        "title": "<b>&",
        "site": SITE,
        "mechanisms": {"=slow": published(2.0, 0.1), "quick": published(4.0, 0.2)},
        "records": {"files": ["records/*.csv"]},
        "analysis": asked | ({} if risk is None else {"risk": risk}),
    }
    path = folder / "walls.toml"
    path.write_text(tables_toml(**tables | more))
    return path


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("fragility"), risk={"target": 1e-4})


def test_json_is_the_tree(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("fragility", project, "--json", "--jobs", 1) == 0
    found = json.loads(capsys.readouterr().out)
    assert [each["name"] for each in found["mechanisms"]] == ["=slow", "quick"]
    assert found["method"] == "ida"
    one = found["mechanisms"][0]
    assert [(each["measure"]["key"], each["state"]["name"]) for each in one["curves"]] == [
        (key, state) for state in ("rocking", "rotation", "overturning") for key in ("pga", "pgv")
    ]
    assert {len(each["scale"]) for each in one["runs"]} == {12}
    assert found["hazard"][0]["source"] == "site.spectrum.hazard"
    assert found["hazard"][0]["annual_rate"] == pytest.approx([1 / 30, 1 / 475, 1 / 2475])
    assert {each["measure"]["key"] for each in one["risks"]} == {"pga"}
    assert {each["target_rate"] for each in one["risks"]} == {1e-4}


def test_table_and_csv_agree(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("fragility", project, "--jobs", 1) == 0
    table = capsys.readouterr().out
    assert ended("fragility", project, "--csv", "--jobs", 1) == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert len(rows) == 12
    assert {row["mechanism"] for row in rows} == {"'=slow", "quick"}
    fitted = [row for row in rows if row["median"]]
    assert fitted
    for row in fitted:
        assert f"{float(row['median']):.3g}" in table
    assert "records: 4, fewer than 10" in table
    assert all(row["rate [1/year]"] for row in rows if row["measure"] == "pga")


def test_files_and_exports(project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    assert ended("fragility", project, "-o", out, "--export", "nrml,pelicun,csv", "--jobs", 1) == 0
    names = {path.name for path in out.iterdir()}
    assert {"fragility.json", "fragility.pdf", "fragility.html", "fragility_continuous.xml", "fragility_discrete.xml",
            "fragility_pelicun.csv", "fragility_curves.csv", "tables"} <= names  # fmt: skip
    assert "<b>&" not in (out / "fragility.html").read_text()
    first = (out / "fragility.json").read_bytes()
    again = tmp_path / "again"
    assert ended("report", out / "fragility.json", "-o", again) == 0
    assert (again / "fragility.pdf").read_bytes() == (out / "fragility.pdf").read_bytes()
    assert ended("fragility", project, "-o", out, "--jobs", 2) == 0
    assert (out / "fragility.json").read_bytes() == first
    assert not (out / "fragility_pelicun.csv").exists()  # of this set, and not asked again
    capsys.readouterr()


@pytest.mark.parametrize(
    ("fragility", "risk", "line"),
    [
        ({"measures": ["pgx"]}, None, "analysis.fragility.measures"),
        ({"measures": ["sa"]}, None, 'not a measure of intensity; write one of "pga"'),
        ({"measures": ["sa(0.5)"]}, None, "no unit"),
        ({"measures": ["sa(0.5 s, 1 s)"]}, None, "sa has one period"),
        ({"measures": ["pga", "pga"]}, None, "the same measure stands there twice"),
        ({"states": ["collapse"]}, None, 'not a state; write one of "rocking", "overturning"'),
        ({"states": [1.5]}, None, "not a state"),
        ({"method": "cloud"}, None, "samples: 12: a cloud runs every record once"),
        ({"largest": "1 m/s"}, None, "analysis.fragility.largest"),
        ({"draws": 3}, None, "analysis.fragility.draws"),
        (None, {"site": {"longitude": 1, "latitude": 2}}, "analysis.risk.site: "),
        (None, {"curve": "records/r0.csv", "site": [12.9, 42.1]}, "analysis.risk.site: "),
        (None, {"hazard": [{"pga": "0.1 g", "rate": 0.01}, {"pga": "0.05 g", "rate": 0.001}]}, "rows rise in pga"),
        (None, {"hazard": [{"pga": "0.1 g"}, {"pga": "0.2 g", "rate": 0.001}]}, "either return_period or rate"),
        (None, {"curve": "records/r0.csv"}, "analysis.risk.curve"),
        (
            None,
            {"curve": "records/r0.csv", "site": {"longitude": 10, "latitude": 200}},
            "analysis.risk.site.latitude: 200: must be 90 or less",
        ),
    ],
)
def test_bad_input_is_one_clear_line(
    fragility: dict | None, risk: dict | None, line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert ended("fragility", written(tmp_path, fragility, risk)) == 2
    said = capsys.readouterr().err.strip()
    assert line in said
    assert len(said.splitlines()) == 1


@pytest.mark.parametrize("options", [("--export", "xml"), ("--export", "nrml"), ("--json", "--csv")])
def test_wrong_options(options: tuple[str, ...], project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("fragility", project, *options) == 2
    assert "Traceback" not in capsys.readouterr().err


def test_hazard_rows_of_the_project(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = [{"pga": "0.05 g", "rate": 0.02}, {"pga": "0.4 g", "return_period": 1000}]
    assert ended("fragility", written(tmp_path, risk={"hazard": rows}), "--json", "--jobs", 1) == 0
    (hazard,) = json.loads(capsys.readouterr().out)["hazard"]
    assert hazard["source"] == "analysis.risk.hazard"
    assert hazard["intensity"] == pytest.approx([0.05, 0.4])
    assert hazard["annual_rate"] == pytest.approx([0.02, 0.001])


def test_openquake_hazard_is_an_input(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    header = "#,,,,,\"generated_by='OpenQuake engine 3.20', investigation_time=50.0, imt='PGA'\""
    curve = (
        f"{header}\nlon,lat,depth,poe-0.05,poe-0.2,poe-0.8\n12.0,42.0,0.0,0.6,0.1,0.01\n13.0,42.0,0.0,0.3,0.05,0.001\n"
    )
    (tmp_path / "hazard_curve-mean-PGA_1.csv").write_text(curve)
    path = written(
        tmp_path, risk={"curve": "hazard_curve-mean-PGA_1.csv", "site": {"longitude": 12.9, "latitude": 42.1}}
    )
    assert ended("fragility", path, "--json", "--jobs", 1) == 0
    found = json.loads(capsys.readouterr().out)
    (hazard,) = found["hazard"]
    assert hazard["intensity"] == [0.05, 0.2, 0.8]
    assert hazard["annual_rate"] == pytest.approx([0.00713350, 0.00102587, 2.00100e-05], rel=1e-5)  # -ln(1 - poe) / 50
    assert "hazard_curve-mean-PGA_1.csv" in {each["path"] for each in found["inputs"]}
    assert hazard["distance_km"] == pytest.approx(13.9, abs=0.1)
    assert "fragility-hazard-far" in {each["key"] for each in found["warnings"]}


def test_reasons_are_printed_once_for_all_measures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project = written(tmp_path)
    text = project.read_text().replace("samples = 12\n", "")
    project.write_text(text.replace("[analysis.fragility]\n", '[analysis.fragility]\nmethod = "cloud"\n'))
    assert ended("fragility", project, "--jobs", 1) == 0
    said = [line for line in capsys.readouterr().out.splitlines() if "no lognormal curve" in line]
    assert said
    assert len(said) == len({line.split(" by ")[0] + line.split(": ", 2)[2] for line in said})
    assert any(" by pga, pgv: " in line for line in said)
