"""One figure of the report by its name."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from matplotlib.figure import Figure

from assess.errors import AssessError
from assess.results import ResolvedValue, Results
from reports.assessment import assessment, figure_names, report_figure
from reports.render.vector import Letters, trace_figure


def letters(figure: Figure) -> list[str]:
    return [mark.text for mark in trace_figure(figure).marks if isinstance(mark, Letters)]


def test_every_figure_of_the_report_has_a_name(results: Results) -> None:
    document = assessment(results, detail="full")
    own = [figure_names(document, results, mechanism.name) for mechanism in results.mechanisms]
    found = [name for names in (figure_names(document, results, None), *own) for name in names.values()]
    assert sorted(found) == sorted(figure.name for figure in document.figures)


@pytest.mark.parametrize("name", ["sketch", "capacity", "pga-rotation", "history"])
def test_a_figure_is_that_of_the_report(results: Results, name: str) -> None:
    mechanism, document = results.mechanisms[0], assessment(results, detail="full")
    whole = figure_names(document, results, mechanism.name)[name]
    drawn = next(figure for figure in document.figures if figure.name == whole).draw(document.writer)
    assert trace_figure(report_figure(name, results, mechanism=mechanism.name)) == trace_figure(drawn)


def test_a_figure_of_the_run_needs_no_mechanism(results: Results) -> None:
    assert "target" in letters(report_figure("spectrum", results))


def test_the_only_mechanism_need_not_be_named(one_mechanism: Results) -> None:
    assert "rotation φ [rad]" in letters(report_figure("capacity", one_mechanism))
    assert "target" in letters(report_figure("spectrum", one_mechanism))


def test_a_figure_has_the_units_and_language_of_the_report(results: Results) -> None:
    project = {
        **results.project,
        "report.language": ResolvedValue("it", True),
        "report.units": ResolvedValue("US", True),
    }
    found = letters(report_figure("capacity", replace(results, project=project), mechanism=results.mechanisms[0].name))
    assert any(text.endswith("[kip ft]") for text in found), found
    assert "0,0" in {text[:3] for text in found}


def test_an_unknown_name_is_told_with_the_known_ones(results: Results) -> None:
    name = results.mechanisms[0].name
    with pytest.raises(AssessError, match=r'no figure "capcity" of mechanism .*; known are .*sketch, .*capacity'):
        report_figure("capcity", results, mechanism=name)
    with pytest.raises(AssessError, match=r'no figure "capacity" of the run; known are .*spectrum.*need its name'):
        report_figure("capacity", results)
    with pytest.raises(AssessError, match=rf'no mechanism "W"; known are {name}'):
        report_figure("capacity", results, mechanism="W")


def test_a_figure_is_saved_by_matplotlib_too(results: Results, tmp_path: Path) -> None:
    figure = report_figure("capacity", results, mechanism=results.mechanisms[0].name)
    figure.savefig(tmp_path / "capacity.png")
    figure.savefig(tmp_path / "capacity.svg")
    assert figure._repr_png_().startswith(b"\x89PNG")  # type: ignore[attr-defined]
