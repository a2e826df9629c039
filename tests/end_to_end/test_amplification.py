"""A wall at height from the command line to the report: by a first mode given, by Rayleigh's method, by a code."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from pypdf import PdfReader

from assess.results import json as results_io
from records.reading import read_records
from records.response import response_spectrum
from tests.support.command import ended
from tests.support.projects import block, project_toml, published, wall

HIGH = {"kind": "single-block", "blocks": ["w"], "cut": "4.77 m"}
SRSS = {"method": "srss", "natural_frequency": "2.5 Hz", "effective_height": "6.01 m"}
PROJECT = project_toml(
    title="Way up",
    building={"height": "9 m", "storeys": 3},
    materials={"m": {"density": "2000 kg/m^3", "young_modulus": "3 GPa"}},
    bodies={"w": wall("0.6 m", "4 m", "8 m", material="m")},
    mechanisms={
        "ground": block("w"),
        "srss": HIGH | {"amplification": SRSS},
        "filter": {"label": "<b>filter</b> & co"} | HIGH | {"amplification": {"method": "modal-filter"}},
        "code": published(2.26, 0.21, 1.46, elevation="4.77 m", amplification={"method": "nzs1170.5"}),
    },
    records={"files": ["motion.csv"]},
    analysis={"levels": ["0.2 g"]},
    report={"detail": "full"},
)


@pytest.fixture(scope="module")
def outputs(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("up")
    t = np.arange(0.0, 8.0, 0.01)
    noise = np.convolve(np.random.default_rng(3).normal(size=t.size), np.hanning(15), mode="same")
    rows = "\n".join(f"{x:.2f},{y:.6f}" for x, y in zip(t, noise * np.sin(np.pi * t / 8.0), strict=True))
    (folder / "motion.csv").write_text(f"time [s],acceleration [m/s2]\n{rows}\n")
    (folder / "project.toml").write_text(PROJECT)
    assert ended("run", folder, "-o", folder / "out") in (0, 1, 3)
    return folder / "out"


@pytest.fixture(scope="module")
def found(outputs) -> dict:
    results = json.loads((outputs / "results.json").read_text())
    return {mechanism["name"]: mechanism for mechanism in results["mechanisms"]}


@pytest.fixture(scope="module")
def report(outputs) -> str:
    text = " ".join(page.extract_text() for page in PdfReader(outputs / "report.pdf").pages)
    return " ".join(text.split())


def test_the_factors_are_those_of_the_formulas(outputs, found):
    (record,) = read_records(outputs.parent / "motion.csv", unit=None)
    by_3_48 = np.hypot(float(response_spectrum(record, 0.4)) / record.pga * 4.77 / 6.01, 1.0)
    for name, method, factor in (("ground", "none", 1.0), ("srss", "srss", by_3_48), ("code", "nzs1170.5", 1.795)):
        amplification = found[name]["amplification"]
        assert amplification["method"] == method
        assert amplification["factors"] == [{"record": "motion", "factor": pytest.approx(factor, rel=1e-9)}]
        assert [h["amplification"] for h in found[name]["histories"]] == pytest.approx([factor], rel=1e-9)
    assert found["ground"]["amplification"]["height_m"] is None
    assert [found[name]["amplification"]["height_m"] for name in ("srss", "filter", "code")] == [4.77] * 3


def test_the_filtered_motion_stands_beside_the_original(outputs, found):
    motion = found["filter"]["amplification"]["motion"]
    factor = found["filter"]["amplification"]["factors"][0]["factor"]
    ground, base = (np.abs(motion[key]).max() for key in ("ground_acceleration_g", "base_acceleration_g"))
    assert base == pytest.approx(factor * ground, rel=1e-9)
    period, at_base = np.array(motion["period_s"]), np.array(motion["base_spectrum_g"])
    texts = [each["text"] for each in found["filter"]["amplification"]["said"] if isinstance(each, dict)]
    (sentence,) = [text for text in texts if text.startswith("first mode at")]
    frequency = float(sentence.split()[3])
    assert 0.7 < period[np.argmax(at_base)] * frequency < 1.4  # the floor's spectrum peaks at the building's period
    assert len(list((outputs / "figures").glob("*-amplification.svg"))) == 1
    assert found["srss"]["amplification"]["motion"] is None


def test_histories_and_clauses_say_where_their_input_acts(found):
    for name, at in (("ground", "ground"), ("srss", "mechanism base"), ("filter", "mechanism base")):
        inputs = {check["procedure"]: check["input_at"] for check in found[name]["checks"]}
        assert inputs["asce43-05-history"] == at
        assert inputs["asce43-05-spectrum"] == at  # carried up by a floor spectrum of the first mode


def test_the_report_says_so(found, report):
    assert report.count("Its base is 4.77 m above the ground.") == 3
    for method in ("Mehrotra eq. 3.48", "filtered by the first mode", "NZS 1170.5, 8.3"):
        assert f"In the time histories the ground motion is amplified up to it ({method})." in report
    assert "The time histories of M2, M3 and M4 have the motion at the base of the mechanism" in report
    assert "G = 0.4 E" in report
    assert "motion, scaled to the site’s spectrum, at the ground and at the base of the mechanism" in report
    factor = found["srss"]["amplification"]["factors"][0]["factor"]
    assert f"The peak acceleration there is {factor:.3g} times that of the ground." in report


def test_results_are_read_back_whole(outputs):
    """So a report that is made again is the same; test_casa_grande.py makes one."""
    text = (outputs / "results.json").read_text()
    assert results_io.dumps(results_io.loads(text)) == text


def test_check_prints_the_way_up(outputs, capsys):
    assert ended("check", outputs.parent) == 0
    out = capsys.readouterr().out
    assert "motion      srss, base 4.77 m above the ground" in out
    assert "first mode at 2.5 Hz (given), h_e = 6.01 m (given)" in out


def test_what_is_missing_ends_with_one_line(outputs, tmp_path, capsys):
    (tmp_path / "motion.csv").write_text((outputs.parent / "motion.csv").read_text())
    (tmp_path / "project.toml").write_text(PROJECT.replace('young_modulus = "3 GPa"\n', ""))
    assert ended("check", tmp_path) == 2
    error = capsys.readouterr().err.strip()
    assert "mechanisms.filter.amplification: natural_frequency" in error
    assert "materials.m has no young_modulus" in error
    assert "\n" not in error
