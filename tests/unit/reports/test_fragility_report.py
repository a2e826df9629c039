"""The report of `assess fragility`: its sentences, its numbers, and texts of users that stay texts."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

from assess.messages.message import note
from assess.results.fragility import FragilityResults, LognormalResult, MechanismFragility
from reports.assessment import fragility_report, write_document
from reports.chapters import fragility, fragility_tables
from reports.document import Document, Figure, Table
from reports.intensity_measures import main_curve, main_risk, measure_text
from reports.language.locale import Locale
from tests.languages.test_reports import Listener, texts_in
from tests.support.document_numbers import is_known, misread, numbers_of, shown_numbers
from tests.support.fragility_results import (
    AVERAGE,
    MEASURES,
    SA,
    SCALED_PGA,
    SCALED_PGV,
    fragility_results,
    without_risk,
)
from tests.support.letters import letters
from tests.support.sample_document import HOSTILE

LOCALES = [Locale("en", "SI"), Locale("en", "US"), Locale("it", "SI"), Locale("it", "US")]


@pytest.fixture(scope="module")
def results() -> FragilityResults:
    return fragility_results()


@pytest.fixture(scope="module")
def document(results: FragilityResults) -> Document:
    return fragility_report(results)


def summary(mechanism: MechanismFragility, locale: Locale | None = None) -> str:
    return " ".join(letters(each, locale or Locale()) for each in fragility.mechanism_summary(mechanism))


def first_page(results: FragilityResults) -> str:
    made = fragility_report(results)
    return " ".join(letters(each, made.writer) for each in texts_in(made.sections[0]) if not isinstance(each, str))


@pytest.mark.parametrize("locale", LOCALES, ids=lambda each: f"{each.language}-{each.system}")
def test_numbers_are_within_half_a_unit_of_their_last_digit(document: Document, locale: Locale) -> None:
    made = replace(document, locale=locale)
    shown = list(shown_numbers(made, made.writer))
    assert len(shown) > 3000
    assert [each for each in shown if misread(each, point=locale.point)] == []


def test_numbers_are_those_of_the_results(results: FragilityResults, document: Document) -> None:
    """Besides: 5 % of a lognormal, intensities of islands, places in lists, distances in metres."""
    runs = [(run, unit) for each in results.mechanisms for run in each.runs for unit in run.intensity]
    islands = [end * unit for run, unit in runs for ends in run.islands for end in ends]
    fitted = [fit for each in results.mechanisms for curve in each.curves for fit in (curve.lognormal, curve.first)]
    fives = [fit.five_percent for fit in fitted if fit]
    far = [1000.0 * run.distance_km for run, _ in runs if run.distance_km is not None]
    known = sorted([*numbers_of(results), *islands, *fives, *far])  # type: ignore[arg-type]
    strange = {
        (each.where, each.text)
        for each in shown_numbers(document, document.writer)
        if not is_known(each.value, known) and not (each.value == int(each.value) and 0 <= each.value < 1000)
    }
    assert strange == set()


def test_five_percent_is_a_quantile_of_the_lognormal() -> None:
    fitted = LognormalResult(0.4, 0.5)
    assert norm.cdf(np.log(fitted.five_percent / fitted.median) / fitted.dispersion) == pytest.approx(0.05, rel=1e-12)


def test_measures_are_in_the_usual_notation() -> None:
    names = [letters(measure_text(each)) for each in MEASURES]
    assert names == ["PGA", "PGV", "Sa(0.5 s) at the base", "averaged Sa", "PGA/(g tan α)", "p·PGV/(g tan α)"]
    italian = [letters(measure_text(each), Locale("it")) for each in (SA, AVERAGE, SCALED_PGA, SCALED_PGV)]
    assert italian == ["Sa(0,5 s) alla base", "Sa media", "PGA/(g tan α)", "p·PGV/(g tan α)"]


def test_the_first_sentences_name_intensities_with_intervals_and_the_rate_beside_its_target(
    results: FragilityResults,
) -> None:
    front = results.mechanisms[0]
    curve, risk = main_curve(front), main_risk(front)
    assert curve is not None
    assert risk is not None
    assert curve.lognormal is not None
    low, high = curve.lognormal.median_interval or (0.0, 0.0)
    said = summary(front)
    assert f"{curve.lognormal.median:.3g} g ({low:.3g} g to {high:.3g} g) in 50 of 100" in said
    assert f"the annual rate of overturning is {risk.annual_rate:.2g} 1/year" in said
    assert f"a probability of {100 * risk.probability_50_years:.2g} % in 50 years" in said
    assert said.endswith("This is more than the target of 0.0001 1/year.")
    within = replace(front, risks=tuple(replace(each, target_rate=0.9) for each in front.risks))
    wide = f"With the epistemic dispersion it is {risk.with_epistemic:.2g} 1/year,"
    assert summary(within).endswith(f"{wide} within the target of 0.9 1/year.")


def test_without_a_hazard_the_rate_is_not_answered(results: FragilityResults) -> None:
    bare = without_risk(results)
    assert "annual rate" not in summary(bare.mechanisms[0])
    made = fragility_report(bare)
    assert "give the hazard of the site in [analysis.risk]" in first_page(bare)
    assert not [figure for figure in made.figures if figure.name.endswith("contributions")]


def test_a_curve_that_is_not_bounded_says_what_was_counted(results: FragilityResults) -> None:
    front = results.mechanisms[0]
    standing = tuple(
        replace(curve, lognormal=None, first=None, empirical=tuple(
            replace(point, reached=0, share=0.0) for point in curve.empirical))
        for curve in front.curves
    )  # fmt: skip
    assert summary(replace(front, curves=standing, risks=())).startswith("No record brings it to overturning up to PGA")
    some = tuple(replace(curve, lognormal=None) for curve in front.curves)
    assert "these runs do not bound a lognormal" in summary(replace(front, curves=some, risks=()))


def test_the_bound_is_called_a_bound(document: Document) -> None:
    said = {letters(text, document.writer) for text in texts_in(document.sections) if not isinstance(text, str)}
    assert any("The dashed line is a bound and no fragility" in text for text in said)


def test_trends_are_called_significant_in_words(results: FragilityResults) -> None:
    table = fragility_tables.measures_table(results.mechanisms[0], "measures")
    texts = [[letters(cell) for cell in row if hasattr(cell, "english")] for row in table.rows]
    for row, each in zip(texts, results.mechanisms[0].comparison, strict=True):
        for trend, said in zip(each.trends, row[-3:], strict=True):
            assert said.endswith(": significant") == (trend.p_value < 0.05)


def test_a_page_has_the_first_islands_and_the_tables_have_all(results: FragilityResults) -> None:
    front = results.mechanisms[0]
    many = replace(front, runs=tuple(replace(run, islands=((2.0, 2.5), (3.0, 3.5))) for run in front.runs))
    printed = fragility_tables.islands_table(many, "islands", most=10)
    assert (len(printed.rows), "the first 10 of 48" in letters(printed.caption)) == (10, True)
    made = fragility_report(replace(results, mechanisms=(many,)))
    assert len(next(table for table in made.data if table.name == "fragility-islands").rows) == 48


def test_nothing_is_left_in_english(document: Document) -> None:
    listener = Listener("it", titles=document.numbers)
    for text in texts_in((document.sections, document.data, document.subject)):
        listener.text(text)  # type: ignore[arg-type]
    assert listener.unknown == set()


def test_language_units_and_paper_are_those_of_the_project() -> None:
    made = fragility_report(fragility_results(language="it", units="US", paper="letter"))
    assert (made.locale.language, made.locale.system, made.paper) == ("it", "US", "letter")


def test_hostile_names_are_inert(results: FragilityResults, tmp_path: Path) -> None:
    front = results.mechanisms[0]
    runs = tuple(replace(run, record=f"{HOSTILE} {place}", event=HOSTILE) for place, run in enumerate(front.runs))
    remark = note("missing-key", key=HOSTILE, text=HOSTILE)
    curves = tuple(replace(curve, notes=(remark,)) for curve in front.curves)
    sources = {HOSTILE: 0.2}
    mechanism = replace(front, name=HOSTILE, label=HOSTILE, runs=runs, curves=curves, epistemic_sources=sources)
    hazard = tuple(replace(each, source=HOSTILE) for each in results.hazard)
    made = fragility_report(replace(results, title=HOSTILE, mechanisms=(mechanism,), hazard=hazard))
    drawn = {figure.name: figure for figure in made.figures}
    assert all(set(name) <= set("abcdefghijklmnopqrstuvwxyz0123456789-") for name in drawn)
    assert write_document(made, tmp_path, name="fragility.pdf", jobs=1).read_bytes().startswith(b"%PDF")
    assert "<script>alert(1)" not in (tmp_path / "fragility.html").read_text(encoding="utf-8")
    assert {path.name for path in (tmp_path / "figures").iterdir()} == {f"{name}.svg" for name in drawn}
    for path in (tmp_path / "tables").glob("*.csv"):
        with path.open(encoding="utf-8", newline="") as stream:
            cells = [cell for row in csv.reader(stream) for cell in row]
        assert not [cell for cell in cells if cell.startswith("=")]


def test_every_table_and_figure_has_its_own_name(document: Document) -> None:
    names = [block.name for block in (*document.blocks, *document.data) if isinstance(block, Table | Figure)]
    assert len(names) == len(set(names))


def test_a_run_of_one_record_and_one_state_has_its_figure_on_the_width_of_the_page(results: FragilityResults) -> None:
    front = results.mechanisms[0]
    kept = tuple(curve for curve in front.curves if curve.state.name == "overturning")
    made = fragility_report(replace(results, mechanisms=(replace(front, curves=kept),)))
    assert [figure.name for figure in made.figures] == [
        f"01-front-{each}" for each in ("fragility", "runs", "contributions")
    ]


@pytest.mark.parametrize(
    ("change", "said", "cell"),
    [
        ({"motion_known": False}, "not shaken by the motion there", "ground motion at a height"),
        ({"above_runs": 1.0}, "stronger motions than those that were run", "the runs end too soon"),
        ({"beyond": 1.0}, "stronger or more frequent motions than the hazard lists", "the hazard ends too soon"),
        ({"with_epistemic": None}, "give its dispersion in [analysis.fragility] epistemic", "no epistemic dispersion"),
        ({"with_epistemic": 0.5}, "it is 0.5 1/year, more than the target of", "target with the epistemic dispersion"),
    ],
)
def test_a_target_that_is_open_says_why(results: FragilityResults, change: dict, said: str, cell: str) -> None:
    mechanism = results.mechanisms[0]
    target = 2.0 * max(risk.with_epistemic for risk in mechanism.risks)
    met = {"target_rate": target, "motion_known": True, "above_runs": 0.0, "beyond": 0.0, "below": 0.0}
    for changes, expected, shown in (
        (met, "within the target of", "within the target"),
        (met | change, said, cell),
    ):
        one = replace(mechanism, risks=tuple(replace(each, **changes) for each in mechanism.risks))
        assert expected in summary(one)
        (row,) = fragility_tables.overview_table(replace(results, mechanisms=(one,))).rows
        assert shown in letters(row[-1].text)


def test_a_median_beyond_the_runs_is_called_extrapolated(results: FragilityResults) -> None:
    mechanism = results.mechanisms[0]
    curve = main_curve(mechanism)
    few = replace(curve, empirical=curve.empirical[:2])
    cut = replace(mechanism, curves=tuple(few if each is curve else each for each in mechanism.curves))
    assert curve.lognormal.median > few.empirical[-1].intensity
    assert "extrapolated" in summary(cut)
    assert "extrapolated" not in summary(mechanism)


def test_a_cloud_without_a_lognormal_says_why_there_is_no_rate(results: FragilityResults) -> None:
    why = note("fragility-cloud-separated")
    bare = tuple(
        replace(
            each,
            risks=(),
            curves=tuple(replace(one, method="cloud", lognormal=None, notes=(why,)) for one in each.curves),
        )
        for each in results.mechanisms
    )
    said = first_page(replace(results, mechanisms=bare))
    assert "give the hazard of the site" not in said
    assert "The intervals (95 %)" not in said
    assert "the rate of a cloud is that of its lognormal, and there is none by PGA: every record" in said
    others = tuple(replace(each, curves=tuple(one for one in each.curves if one.measure == SA)) for each in bare)
    said = first_page(replace(results, mechanisms=others))
    assert "there is no curve by PGA, the measure of the hazard" in said


def test_rates_and_their_probabilities_have_two_figures(results: FragilityResults) -> None:
    figures = {
        column.figures for column, _ in fragility_tables.RATE_FIELDS if column.dimension in ("annual rate", "percent")
    }
    assert figures == {2, 3}
    risk = main_risk(results.mechanisms[0])
    said = Locale().text(fragility.rate_sentence(replace(risk, annual_rate=1.26e-4, probability_50_years=0.00628)))
    assert "0.00013" in said
    assert "0.63" in said
