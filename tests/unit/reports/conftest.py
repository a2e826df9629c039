"""The results that reports are made of in these tests, and what the report makes of them, made once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from assess.results import Results
from tests.support.sample_results import question_at, sample_results, with_decision, with_verdict

if TYPE_CHECKING:
    from reports.document import Document
    from reports.render.vector import TracedFigures


@pytest.fixture(scope="session")
def results() -> Results:
    return sample_results()


@pytest.fixture(scope="session")
def one_mechanism(results: Results) -> Results:
    """The results of the first mechanism alone."""
    assert results.verdict is not None
    first = with_verdict(results, mechanisms=results.verdict.mechanisms[:1])
    return replace(first, mechanisms=results.mechanisms[:1], comparison=(), sweeps=(), sensitivity=())


@pytest.fixture(scope="session")
def judged_at() -> Callable[[Results, float], Results]:
    """The results as they are judged at a site of another PGA [g]."""
    return lambda results, pga_g: with_decision(results, question_at(pga_g))


@pytest.fixture(scope="session")
def document(results: Results) -> Document:
    from reports.assessment import assessment

    return assessment(results)


@pytest.fixture(scope="session")
def drawings(document: Document) -> TracedFigures:
    from reports.render.vector import document_processes, trace_figures

    with document_processes(1, document) as submit:
        return trace_figures(document, submit)


@pytest.fixture(scope="session")
def page(document: Document, drawings: TracedFigures, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report as HTML."""
    from reports.render.html import write_html
    from reports.render.vector import svg_picture

    pictures = {name: svg_picture(drawing.result()) for name, drawing in drawings.items()}
    return write_html(document, tmp_path_factory.mktemp("html") / "report.html", pictures=pictures)
