"""The notebook of docs is what its cells print today."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import nbformat
import pytest

PAGE = Path(__file__).parents[2] / "docs/notebook/first_wall.ipynb"


def texts(page):
    """What each cell prints: its stream, or the text of what it shows."""
    shown = ((cell.source, cell.get("outputs", ())) for cell in page.cells)
    return [
        (source, "".join(each.get("text") or each.get("data", {}).get("text/plain", "") for each in outputs))
        for source, outputs in shown
    ]


@pytest.mark.filterwarnings("ignore")  # of the packages that run notebooks
def test_notebook_prints_what_it_says():
    spec = importlib.util.spec_from_file_location("write_notebook", PAGE.with_name("write.py"))
    write = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(write)
    stored = nbformat.read(PAGE, as_version=4)
    assert texts(write.execute(write.notebook())) == texts(stored)
    assert any("image/png" in each.get("data", {}) for cell in stored.cells for each in cell.get("outputs", ()))
