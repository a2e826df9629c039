"""The front matter in the project file: its keys, and what their texts may hold."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from assess.errors import ProjectError
from assess.project.project_file import json_schema
from assess.project.report import report_matter_of
from assess.results import ReportMatter, Revision
from tests.support.projects import load_project

SPIRE = '[mechanisms.spire]\nkind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.8\n'
MARKUP = "=cmd|'/c calc'!A0 <b>&amp;</p> <script>alert(1)</script> ]]> $x$ ../../etc {pga} %s"


def matter(folder: Path, text: str) -> ReportMatter:
    project = load_project(folder, text)
    return report_matter_of(project.content, project.folder)


def test_every_key_arrives(tmp_path):
    text = """
engineer = "E. Rossi"
client = "Parish"
[report]
client = "Parish"
address = "1, Church Lane\\nTown"
coordinates = [42, -13.5]
author = "A. Bianchi"
office = "Studio"
licence_number = 1234
checker = "C. Verdi"
date = 2024-05-31
status = "for approval"
reference = "J-7"
revisions = [{ number = 0, date = 2024-05-01, description = "first issue", author = "A. B." },
             { number = "A", date = "May" }]
seismic_zone = 2
national_annex = "UNI EN 1998-1"
"""
    assert matter(tmp_path, text.replace("[report]", SPIRE + "[report]")) == ReportMatter(
        client="Parish",
        address="1, Church Lane\nTown",
        coordinates=(42.0, -13.5),
        author="A. Bianchi",
        office="Studio",
        licence_number="1234",
        checker="C. Verdi",
        date="2024-05-31",
        status="for approval",
        engineer="E. Rossi",
        reference="J-7",
        revisions=(Revision("0", "2024-05-01", "first issue", "A. B."), Revision("A", "May", "", "")),
        seismic_zone="2",
        national_annex="UNI EN 1998-1",
    )


@pytest.mark.parametrize("key", ["client", "checker", "date", "reference"])
def test_what_stands_at_the_top_counts_and_must_agree_with_the_table(tmp_path, key):
    top = f'{key} = "one"\n' + SPIRE
    assert getattr(matter(tmp_path, top), key) == "one"
    assert getattr(matter(tmp_path, f'{top}[report]\n{key} = "one"\n'), key) == "one"
    with pytest.raises(
        ProjectError, match=rf'report\.{key}: "two": beside {key} = "one" at the top of the file; give one'
    ):
        matter(tmp_path, f'{top}[report]\n{key} = "two"\n')


@pytest.mark.parametrize("key", ["client", "address", "author", "office", "licence_number", "status", "coordinates"])
def test_hostile_text_stays_text(tmp_path, key):
    assert getattr(matter(tmp_path, f"{SPIRE}[report]\n{key} = {json.dumps(MARKUP)}\n"), key) == MARKUP


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (f'client = "{"x" * 201}"', "report.client: "),
        (f'client = "{"x" * 201}"', "201 characters; write at most 200"),
        (f'address = "{"x" * 1001}"', "1001 characters; write at most 1000"),
        (r'office = "a\u0007b"', "character 2 is U+0007, which cannot be printed; remove it"),
        (r'address = "a\rb"', "character 2 is U+000D"),
        (r'status = "a\u202eb"', "character 2 is U+202E"),
        (r'author = "a\nb"', "a line break; write it on one line"),
        ("author = 1", "report.author: 1: not a text; write it in quotes"),
        ("coordinates = [91, 0]", "[91, 0]: 91 is no latitude; write one within -90 and 90 degrees"),
        ("coordinates = [0, -181]", "-181 is no longitude"),
        ("coordinates = [nan, 0]", "not a place; write [latitude, longitude] in degrees"),
        ("coordinates = [true, 0]", "not a place"),
        ("coordinates = [1, 2, 3]", "not a place"),
        ("licence_number = true", "report.licence_number: true: not a text"),
        ("revisions = [{ number = 1, date = 2024-01-01 }, { number = 1, date = 2024-01-02 }]", "revisions[2].number:"),
        ("revisions = [{ number = 1 }]", "report.revisions[1].date: missing"),
        ('revision = "1"', 'report.revision: "1": unknown key; did you mean "revisions"?'),
        ('detail = "short"', 'report.detail: "short": not allowed; write "main" or "full"'),
        ('logo = "none.png"', 'report.logo: "none.png": no such file'),
        ('figures = [{ caption = "x" }]', "report.figures[1].file: missing"),
    ],
)  # fmt: skip
def test_wrong_values_are_one_line_with_key_value_and_remedy(tmp_path, line, said):
    with pytest.raises(ProjectError) as found:
        matter(tmp_path, f"{SPIRE}[report]\n{line}\n")
    assert said in str(found.value)
    assert str(found.value).isprintable()


def test_front_matter_is_not_swept(tmp_path):
    text = (
        f'{SPIRE}[report]\ncoordinates = [42, 13]\n[[analysis.sweep]]\nkey = "report.coordinates.0"\nvalues = [1, 2]\n'
    )
    with pytest.raises(ProjectError, match="unknown key"):
        matter(tmp_path, text)


def test_the_schema_describes_every_key():
    report = json_schema()["$defs"]["Report"]["properties"]
    assert all(each.get("description") for each in report.values())
    assert {"revisions", "figures", "building_type", "not_examined", "national_annex"} <= set(report)
