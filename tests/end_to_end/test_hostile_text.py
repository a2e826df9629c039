"""Hostile text in every free field of a project appears as text in every output."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from lxml import html
from openpyxl import load_workbook
from PIL import Image
from pypdf import PdfReader

from reports.figures.style import printable
from reports.language.lettering import visible
from reports.render.csv import csv_field
from tests.support.command import ended

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


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A project with text of an attacker wherever text may stand, and what `assess run` makes of it."""
    folder = tmp_path_factory.mktemp("hostile")
    time = np.arange(0.0, 8.0, 0.01)
    motion = 0.5 * np.sin(2 * np.pi * time) * np.exp(-((time - 4) ** 2))
    lines = [f"{t:.2f},{a:.6f}" for t, a in zip(time, motion, strict=True)]
    (folder / "=cmd <b>&amp; $x$.csv").write_text("\n".join(["time [s],acceleration [m/s^2]", *lines]))
    (folder / "@sum <i>.csv").write_text("period [s],acceleration [g]\n0,0.1\n0.1,0.25\n0.4,0.25\n4,0.02\n")
    Image.new("RGB", (8, 6), "red").save(folder / PICTURE)
    (folder / "project.toml").write_text(project(), encoding="utf-8")
    assert ended("run", folder, "-o", folder / "out") in (0, 1, 3)
    return folder


def project() -> str:
    quoted = {name: json.dumps(hostile(name)) for name in (*FIELDS, *NAMES)}
    mechanism, body = quoted["topple"], quoted["wall"]
    return "\n".join(
        [
            *(f"{key} = {quoted[key]}" for key in FIELDS),
            '[site.spectrum]\ncode = "table"\nfile = "@sum <i>.csv"',
            f"[materials.{quoted['stone']}]\ndensity = 2000",
            f"[bodies.{body}]\nmaterial = {quoted['stone']}\nbox = {{ thickness = 0.6, length = 4, height = 3 }}",
            f"[bodies.{quoted['floor']}]\nmaterial = {quoted['stone']}",
            "box = { thickness = 5, length = 4, height = 0.1, base = [2.7, 0, 3] }",
            f'[mechanisms.{mechanism}]\nlabel = {quoted["label"]}\nkind = "single-block"\nblocks = [{body}]',
            f'loads = [{{ kind = "body", body = {quoted["floor"]}, role = "floor" }}]',
            f'[mechanisms.{json.dumps(LONG)}]\nkind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.8',
            '[records]\nfiles = ["=cmd*.csv"]',
            '[analysis]\nlevels = ["0.1 g"]\nprocedures = ["asce43-05-spectrum", "dmi2008-linear"]',
            report(),
            f'[report.sources]\n"title" = {json.dumps("measured: " + hostile("source"))}',
        ]
    )


def report() -> str:
    """The front matter, a picture, and the list of possible mechanisms, in hostile words."""
    said = {name: json.dumps(printable_hostile(name)) for name in (*MATTER, "revision", "caption", "reason")}
    revision = ", ".join(f"{key} = {said['revision']}" for key in ("number", "date", "description", "author"))
    return "\n".join(
        [
            '[report]\ndetail = "full"',
            *(f"{key} = {said[key]}" for key in MATTER),
            f"revisions = [{{ {revision} }}]",
            f'logo = "{PICTURE}"',
            f'figures = [{{ file = "{PICTURE}", caption = {said["caption"]} }}]',
            'building_type = "house"',
            f"not_examined = {{ corner = {said['reason']} }}",
        ]
    )


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
    assert all(re.fullmatch(r"#?'[a-z0-9 ~-]{1,31}'!A\d+", target) for target in targets)


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
