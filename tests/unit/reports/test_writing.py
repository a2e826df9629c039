"""The whole set of files, written twice."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest
from pypdf import PdfReader

from assess.results import Results
from reports.assessment import assessment, write_all


def digest(folder: Path) -> dict[str, str]:
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


@pytest.fixture(scope="module")
def written(results: Results, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("all")
    assert write_all(results, folder) == folder / "report.pdf"
    return folder


@pytest.mark.parametrize("jobs", [1, 2])
def test_same_results_give_the_same_bytes_by_any_number_of_processes(
    results: Results, written: Path, tmp_path: Path, jobs: int
) -> None:
    said: list[str] = []
    write_all(results, tmp_path, jobs=jobs, progress=said.append)
    assert digest(tmp_path) == digest(written)
    assert said == ["figures", "report", "tables"]


def test_every_kind_of_file_is_there(written: Path) -> None:
    names = set(digest(written))
    assert {"report.pdf", "report.html", "tables.xlsx", "tables/verdict.csv", "figures/key-plan.svg"} <= names
    for what in ("sketch", "capacity", "pga-rotation"):
        assert {f"figures/01-wall-6-{what}.svg", f"figures/02-parapet-{what}.svg"} <= names


def test_language_and_detail_are_those_asked_for(results: Results, written: Path, tmp_path: Path) -> None:
    write_all(results, tmp_path, language="it", detail="full")
    text, main = (
        "".join(page.extract_text() for page in PdfReader(folder / "report.pdf").pages)
        for folder in (tmp_path, written)
    )
    assert "pagina 1 di" in text
    assert "page 1 of" in main
    assert set(digest(tmp_path)) > set(digest(written))
    assert (tmp_path / "figures" / "01-wall-6-history.svg").exists()


def test_figures_are_whole_svg_without_dates(written: Path) -> None:
    for path in (written / "figures").iterdir():
        assert ElementTree.parse(path).getroot().tag == "{http://www.w3.org/2000/svg}svg"
        assert "<dc:date>" not in path.read_text(encoding="utf-8")


def test_figures_are_pictures_too_where_that_is_asked(one_mechanism: Results, tmp_path: Path) -> None:
    write_all(one_mechanism, tmp_path, figures=("png",))
    made = sorted((tmp_path / "figures").iterdir())
    assert [path.stem for path in made] == sorted(figure.name for figure in assessment(one_mechanism).figures)
    for content in (path.read_bytes() for path in made):
        assert content.startswith(b"\x89PNG")
        assert int.from_bytes(content[content.index(b"pHYs") + 4 :][:4], "big") == round(200 / 0.0254)


def test_report_is_small(written: Path) -> None:
    assert (written / "report.pdf").stat().st_size < 500_000


@pytest.mark.parametrize("bare", ["no spectrum, records, checks or histories", "no mechanisms"])
def test_bare_results_can_be_written(results: Results, tmp_path: Path, bare: str) -> None:
    empty = tuple(replace(m, checks=(), histories=(), suites=()) for m in results.mechanisms)
    mechanisms = () if bare == "no mechanisms" else empty
    thin = replace(results, mechanisms=mechanisms, comparison=(), records=(), spectrum=None, warnings=(), inputs=())
    thin = replace(thin, verdict=None) if bare == "no mechanisms" else thin
    assert write_all(thin, tmp_path).stat().st_size > 1000
