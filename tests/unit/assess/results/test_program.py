"""What results say of the program: licence, origin, and a digest of its own sources, which the stamp ignores."""

from __future__ import annotations

import shutil
from dataclasses import replace
from email.message import Message
from importlib.metadata import metadata, version
from pathlib import Path

import pytest

from assess.results import Input
from assess.results.provenance import (
    PACKAGES,
    describe_program,
    licence_of,
    origin_of,
    package_folder,
    sources_digest,
    stamp,
    this_program,
)
from tests.support.places import ROOT, SOURCES


def about(**fields: str) -> Message:
    """Metadata of a package."""
    made = Message()
    for key, value in {"Name": "walls", "Summary": "walls that rock", **fields}.items():
        made[key.replace("_", "-")] = value
    return made


def test_the_program_is_this_one() -> None:
    found = describe_program()
    assert (found.name, found.version) == ("rocking-assess", version("rocking-assess"))
    assert found.licence == "MIT"
    assert (ROOT / "LICENSE").read_text().startswith(f"{found.licence} License")
    assert found.origin == origin_of(metadata("rocking-assess")) != ""
    assert package_folder() == SOURCES
    assert found.sha256 == sources_digest(SOURCES)


def test_the_origin_is_the_author_and_the_sources_or_else_the_project() -> None:
    sources = "Source, https://example.org/walls"
    assert origin_of(about(Author="A. Mason", Project_URL=sources)) == "A. Mason, https://example.org/walls"  # type: ignore[arg-type]
    assert origin_of(about(Author_email="a@example.org")) == "a@example.org"  # type: ignore[arg-type]
    assert origin_of(about()) == "walls: walls that rock"  # type: ignore[arg-type]
    assert licence_of(about(License="BSD")) == "BSD"  # type: ignore[arg-type]
    assert licence_of(about()) == ""  # type: ignore[arg-type]


def test_the_digest_changes_with_any_source_and_nothing_else(tmp_path: Path) -> None:
    for name in PACKAGES:
        (tmp_path / name / "inner").mkdir(parents=True)
        (tmp_path / name / "inner" / "a.py").write_text(f"A = '{name}'\n")
    (tmp_path / "assess/inner/case.toml").write_text("values = [1]")
    first = sources_digest(tmp_path)
    (tmp_path / "reports" / ".DS_Store").write_text("no source")
    (tmp_path / "reports/__pycache__").mkdir()
    (tmp_path / "reports/__pycache__/a.cpython-311.pyc").write_text("kept by Python")
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "a.py").write_text("")
    moved = tmp_path.with_name(f"{tmp_path.name}-moved")
    shutil.copytree(tmp_path, moved)
    assert first == sources_digest(tmp_path) == sources_digest(moved)
    (tmp_path / "reports/inner/a.py").rename(tmp_path / "reports/inner/b.py")
    renamed = sources_digest(tmp_path)
    (tmp_path / "reports/inner/b.py").write_text("A = 1\n")
    written = sources_digest(tmp_path)
    (tmp_path / "assess/inner/case.toml").write_text("values = [2]")
    assert len({first, renamed, written, sources_digest(tmp_path)}) == 4


@pytest.mark.parametrize("field", ["licence", "origin", "sha256"])
def test_the_stamp_is_that_of_name_and_version_alone(field: str) -> None:
    files = (Input("a.toml", "00"),)
    other = replace(describe_program(), **{field: "other"})
    assert stamp("run", other, files) == stamp("run", this_program(), files)
