"""results.json of version 0.1.0 is read, with what was added since at its defaults, and its report is made.

`older/results_0_1_0.json.gz` was written by that version, of a tower given by its numbers under one record.
"""

from __future__ import annotations

import gzip
import json
from dataclasses import replace
from pathlib import Path

import pytest
from pypdf import PdfReader

from assess.errors import ResultsError
from assess.results.json import dumps, loads
from tests.support.command import ended
from tests.support.document_numbers import strange_numbers

OLDER = Path(__file__).parent / "older/results_0_1_0.json.gz"


@pytest.fixture
def text() -> str:
    return gzip.decompress(OLDER.read_bytes()).decode()


def test_what_was_added_since_has_its_defaults(text: str) -> None:
    found = loads(text)
    assert "controls" not in json.loads(text)
    assert found.controls == ()
    assert (found.program.version, found.program.licence, found.program.origin, found.program.sha256) == (
        "0.1.0", "", "", "",
    )  # fmt: skip
    assert found.report == type(found.report)()


def test_every_value_of_an_older_file_is_kept(text: str) -> None:
    """Written again it holds what it held; only keys with defaults come in."""
    before, after = json.loads(text), json.loads(dumps(loads(text)))

    def kept(one: object, other: object) -> bool:
        if isinstance(one, dict) and isinstance(other, dict):
            return all(name in other and kept(value, other[name]) for name, value in one.items())
        if isinstance(one, list) and isinstance(other, list):
            return len(one) == len(other) and all(map(kept, one, other))
        return one == other

    assert kept(before, after)


@pytest.mark.parametrize(("language", "title"), [("en", "Verdict"), ("it", "Esito")])
def test_its_report_is_made(text: str, tmp_path: Path, language: str, title: str) -> None:
    (tmp_path / "results.json").write_text(text)
    words = ("-o", tmp_path / "out", "--language", language, "--detail", "full")
    assert ended("report", tmp_path / "results.json", *words) == 0
    pages = [page.extract_text() for page in PdfReader(tmp_path / "out/report.pdf").pages]
    assert f"1 {title}" in pages[0]
    assert strange_numbers(loads(text)) == set()


def test_a_control_of_no_mechanism_is_refused(text: str) -> None:
    found = loads(text)
    data = json.loads(dumps(found))
    note = {"key": "control-moments", "severity": "note", "where": "", "text": "by moments", "values": {}}
    control = {
        "kind": "energy", "mechanism": "tower", "quantity": "energy balance", "value": 1.0, "reference": 1.0,
        "dimension": "energy", "difference": 0.0, "tolerance": 0.001, "met": True, "note": note,
    }  # fmt: skip
    data["controls"] = [control]
    assert loads(json.dumps(data)) == replace(found, controls=loads(json.dumps(data)).controls)
    data["controls"] = [control | {"mechanism": "spire"}]
    with pytest.raises(ResultsError, match=r'controls\[0\]\.mechanism: "spire" is none of the mechanisms'):
        loads(json.dumps(data))
