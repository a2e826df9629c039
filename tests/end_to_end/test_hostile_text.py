"""Hostile text in every free field of a project appears as text in every output."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from lxml import html
from openpyxl import load_workbook
from PIL import Image
from pypdf import PdfReader

from reports.figures.style import printable
from reports.language.locale import visible
from reports.render.table_text import csv_field
from tests.support.command import ended
from tests.support.files import write_file
from tests.support.motions import write_noise
from tests.support.projects import block, published, tables_toml, wall

FIELDS = ("title", "engineer", "checker", "reference", "client", "date", "notes", "masonry_quality")
NAMES = ("stone", "wall", "floor", "topple", "label", "source")
LONG = "long " + "x" * 10_000
MATTER = ("address", "author", "office", "licence_number", "status", "coordinates", "seismic_zone", "national_annex")
PICTURE = "=cmd <b>&amp; $x$.png"


def hostile(tag: str) -> str:
    return f"=cmd|'/c calc'!A0 {tag}# <b>&amp;</p> <script>alert(1)</script> ]]> $x$ ../../etc \u202e \x07"


def printable_hostile(tag: str) -> str:
    """Hostile text of what [report] takes: one line, each character of which can be printed."""
    return hostile(tag).removesuffix(" \u202e \x07")


REVISION = dict.fromkeys(("number", "date", "description", "author"), printable_hostile("revision"))
PROJECT = {
    **{name: hostile(name) for name in FIELDS},
    "site": {"spectrum": {"code": "table", "file": "@sum <i>.csv"}},
    "materials": {hostile("stone"): {"density": 2000}},
    "bodies": {
        hostile("wall"): wall(0.6, 4, 3, material=hostile("stone")),
        hostile("floor"): wall(5, 4, 0.1, base=[2.7, 0, 3], material=hostile("stone")),
    },
    "mechanisms": {
        hostile("topple"): {"label": hostile("label")}
        | block(hostile("wall"), loads=[{"kind": "body", "body": hostile("floor"), "role": "floor"}]),
        LONG: published(),
    },
    "records": {"files": ["=cmd*.csv"]},
    "analysis": {"levels": ["0.1 g"], "procedures": ["asce43-05-spectrum", "dmi2008-linear"]},
    "report": {
        "detail": "full",
        **{key: printable_hostile(key) for key in MATTER},
        "revisions": [REVISION],
        "logo": PICTURE,
        "figures": [{"file": PICTURE, "caption": printable_hostile("caption")}],
        "building_type": "house",
        "not_examined": {"corner": printable_hostile("reason")},
        "sources": {"title": f"measured: {hostile('source')}"},
    },
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A project with text of an attacker wherever text may stand, and what `assess run` makes of it."""
    folder = tmp_path_factory.mktemp("hostile")
    write_noise(folder / "=cmd <b>&amp; $x$.csv", duration=8.0, amplitude=0.1)
    (folder / "@sum <i>.csv").write_text("period [s],acceleration [g]\n0,0.1\n0.1,0.25\n0.4,0.25\n4,0.02\n")
    Image.new("RGB", (8, 6), "red").save(folder / PICTURE)
    write_file(folder / "project.toml", tables_toml(**PROJECT))
    assert ended("run", folder, "-o", folder / "out") in (0, 1, 3)
    return folder


def test_in_results_the_report_s_matter_is_as_it_was_written(folder):
    matter = json.loads((folder / "out/results.json").read_text(encoding="utf-8"))["report"]
    assert [matter[name] for name in MATTER] == [printable_hostile(name) for name in MATTER]
    assert set(matter["revisions"][0].values()) == {printable_hostile("revision")}
    assert (matter["figures"][0]["name"], matter["figures"][0]["caption"]) == (PICTURE, printable_hostile("caption"))
    listed = {each["key"]: each for each in matter["checklist"]}
    assert listed["corner"]["reason"] == printable_hostile("reason")
    assert listed["simple-overturning"]["mechanisms"] == [hostile("topple")]


def test_in_results_it_is_as_it_was_written(folder):
    results = json.loads((folder / "out/results.json").read_text(encoding="utf-8"))
    for name in FIELDS:
        assert results["project"][name]["value"] == hostile(name)
    assert [(one["name"], one["label"]) for one in results["mechanisms"]] == [
        (hostile("topple"), hostile("label")),
        (LONG, LONG),
    ]


def test_files_have_plain_names(folder):
    made = [path.relative_to(folder / "out") for path in (folder / "out").rglob("*") if path.is_file()]
    assert len(made) > 20
    for path in made:
        assert re.fullmatch(r"(tables/|figures/)?\.?[a-z0-9-]{1,80}\.?[a-z]*", str(path))


def test_in_the_page(folder):
    tree = html.document_fromstring((folder / "out/report.html").read_text(encoding="utf-8"))
    text = tree.text_content()
    for name in (*FIELDS, *NAMES):
        assert visible(hostile(name)) in text
    assert LONG in text
    assert not tree.xpath("//main//td//b | //main//p//b | //main//dd//*")
    assert {each.get("type") for each in tree.iter("script")} == {"application/json", "module"}
    assert not [key for each in tree.iter() for key in each.attrib if key.startswith("on")]


def test_in_the_pdf(folder):
    reader = PdfReader(folder / "out/report.pdf")
    text = "".join("".join(page.extract_text().split()) for page in reader.pages)
    for name in (*FIELDS, *NAMES):
        assert "".join(printable(hostile(name)).split()) in text
    assert len(reader.pages) < 60  # a name of 10,000 letters among them
    assert reader.metadata is not None
    assert reader.metadata.title == printable(hostile("title"))


def test_in_the_workbook(folder):
    book = load_workbook(folder / "out/tables.xlsx")
    cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row if cell.value is not None]
    assert {cell.data_type for cell in cells} <= {"s", "n", "b"}  # "f" would be a formula
    texts = " ".join(cell.value for cell in cells if cell.data_type == "s")
    for name in (*FIELDS, *NAMES):
        assert visible(hostile(name)) in texts
    assert LONG in texts
    assert book.properties.title == visible(hostile("title"))
    targets = [cell.hyperlink.location or cell.hyperlink.target for cell in cells if cell.hyperlink]
    assert all(re.fullmatch(r"#?'[A-Za-z0-9 ~-]{1,31}'!A\d+", target) for target in targets)


def test_in_csv_files(folder):
    cells = []
    for path in (folder / "out/tables").glob("*.csv"):
        with path.open(encoding="utf-8", newline="") as stream:
            cells += [cell for row in csv.reader(stream) for cell in row]
    assert not [cell for cell in cells if cell[:1] in "=@+\t\r" and cell]
    for name in ("label", "title", "notes"):
        assert any(csv_field(hostile(name)) in cell for cell in cells)


def test_in_figures(folder):
    labels = []
    for path in (folder / "out/figures").glob("*.svg"):
        root = ElementTree.parse(path).getroot()
        labels += [each.get("aria-label", "") for each in root.iter()]
        assert {each.tag.split("}")[1] for each in root.iter()} <= {
            *("svg", "desc", "defs", "path", "clipPath", "rect", "g", "use")
        }
    assert any("label#" in label for label in labels)
