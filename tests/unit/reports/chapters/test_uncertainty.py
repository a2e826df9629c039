"""The chapter on uncertainty: half a page of the main part, numbers of the results, and what changes nothing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assess.results import Results
from assess.results.json import dumps, loads
from reports.assessment import assessment
from reports.chapters import uncertainty
from reports.document import FigureRow
from reports.figures import sensitivity as figure
from reports.language.locale import Locale
from tests.languages.test_reports import unknown_words
from tests.support.document_numbers import misread, shown_numbers, strange_numbers
from tests.support.drawn_figures import Bracketed, fixed_words
from tests.support.sample_document import HOSTILE
from tests.support.uncertainty_results import SAMPLES, with_uncertainty

LOCALES = [Locale("en", "SI"), Locale("en", "US"), Locale("it", "SI"), Locale("it", "US")]


@pytest.fixture(scope="module")
def sampled(results: Results) -> Results:
    return with_uncertainty(results)


def densities_text(results: Results) -> str:
    assert results.uncertainty is not None
    texts = uncertainty.densities_without_effect(results, results.uncertainty)
    return " ".join(map(Locale().text, texts))


def test_there_is_no_chapter_without_samples(results: Results) -> None:
    assert uncertainty.sections(results) == uncertainty.annex_sections(results) == []
    assert not list(uncertainty.data_tables(results))


def test_the_main_part_has_the_answer_that_fails_most_often(sampled: Results) -> None:
    (section,) = uncertainty.sections(sampled)
    assert [type(block).__name__ for block in section.blocks] == ["Prose", "Table", "FigureRow"]
    assert sampled.uncertainty is not None
    worst = max(sampled.uncertainty.answers, key=lambda each: each.probability or 0.0)
    assert uncertainty.shown_answers(sampled.uncertainty)[0] == worst


def test_an_answer_that_nothing_changes_has_no_figure(sampled: Results) -> None:
    assert sampled.uncertainty is not None
    still = tuple(replace(each, influences=()) for each in sampled.uncertainty.answers)
    one = replace(sampled, uncertainty=replace(sampled.uncertainty, answers=(still[0], sampled.uncertainty.answers[1])))
    (row,) = [block for block in uncertainty.sections(one)[0].blocks if isinstance(block, FigureRow)]
    assert "-uncertainty-02-" in row.figures[0].name
    none = replace(sampled, uncertainty=replace(sampled.uncertainty, answers=still))
    assert not [block for block in uncertainty.sections(none)[0].blocks if isinstance(block, FigureRow)]


def test_a_density_that_changes_nothing_is_told_of_the_mechanisms_where_that_is_so(sampled: Results) -> None:
    both = "For M1 Wall 6, eroded base; M2 parapet"
    assert densities_text(sampled).startswith(f"{both}, stone: density changes nothing") or densities_text(
        sampled
    ).startswith("For M1 Wall 6, eroded base and M2 parapet, stone: density changes nothing")
    found = sampled.uncertainty
    assert found is not None
    moving = tuple(replace(each, rank_correlation=0.3) for each in found.answers[0].influences)
    one = replace(found, answers=(replace(found.answers[0], influences=moving), found.answers[1]))
    assert densities_text(replace(sampled, uncertainty=one)).startswith(
        "For M2 parapet, stone: density changes nothing"
    )
    none = replace(found, answers=one.answers[:1])
    assert densities_text(replace(sampled, uncertainty=none)) == ""


def test_means_have_the_unit_of_their_key(sampled: Results) -> None:
    assert sampled.uncertainty is not None
    for locale, means in (
        (Locale(), ["0.6 m", "2100 kg/m³", "12 kN"]),
        (Locale("en", "US"), ["1.969 ft", "131.1 lb/ft³"]),
    ):
        rows = uncertainty.inputs_table(sampled.uncertainty).rows
        assert [locale.text(row[1]).replace("\u00a0", " ") for row in rows][: len(means)] == means  # type: ignore[arg-type]


@pytest.mark.parametrize("locale", LOCALES, ids=lambda each: f"{each.language}-{each.system}")
def test_numbers_are_within_half_a_unit_of_their_last_digit(sampled: Results, locale: Locale) -> None:
    document = replace(assessment(sampled, detail="full"), locale=locale)
    assert [each for each in shown_numbers(document, document.writer) if misread(each, point=locale.point)] == []


def test_numbers_are_those_of_the_results(sampled: Results) -> None:
    assert strange_numbers(sampled) == set()


def test_nothing_is_left_in_english(sampled: Results, results: Results) -> None:
    assert unknown_words(sampled, "it") == unknown_words(results, "it")


def test_results_are_read_as_they_were_written(sampled: Results) -> None:
    assert loads(dumps(sampled)) == sampled


def test_the_distribution_ends_at_the_share_that_does_not_overturn(sampled: Results) -> None:
    assert sampled.uncertainty is not None
    answer = sampled.uncertainty.answers[1]
    finite = sorted(ratio for ratio in answer.ratios if ratio is not None)
    assert 0 < len(finite) < SAMPLES
    (axes,) = figure.draw_distribution(answer, Locale()).axes
    x, y = map(np.asarray, axes.get_lines()[0].get_data())
    assert x.tolist() == finite
    assert y[-1] == pytest.approx(100.0 * len(finite) / SAMPLES)
    at_one = np.searchsorted(x, 1.0, side="right")
    assert 100.0 - y[at_one - 1] == pytest.approx(100.0 * (answer.probability or 0.0))


def test_bars_are_ranked_and_signed(sampled: Results) -> None:
    assert sampled.uncertainty is not None
    answer = sampled.uncertainty.answers[0]
    (axes,) = figure.draw_influences(answer, Locale()).axes
    widths = [patch.get_width() for patch in axes.patches]  # type: ignore[attr-defined]
    assert widths == [answer.influences[0].rank_correlation, answer.influences[2].rank_correlation]
    assert widths[0] < 0.0 < widths[1] < abs(widths[0])


def test_answers_without_a_finite_ratio_are_drawn(sampled: Results) -> None:
    assert sampled.uncertainty is not None
    empty = replace(sampled.uncertainty.answers[0], ratios=(None,) * SAMPLES, influences=(), at_mean=None)
    assert figure.draw_distribution(empty, Locale()).axes
    assert figure.draw_influences(empty, Locale()).axes


def test_keys_are_inert_and_words_go_through_the_locale(sampled: Results) -> None:
    assert sampled.uncertainty is not None
    answer = sampled.uncertainty.answers[0]
    hostile = replace(answer, influences=(replace(answer.influences[0], keys=(HOSTILE,), group=HOSTILE),))
    for draw in (figure.draw_distribution, figure.draw_influences):
        drawn = draw(hostile, Bracketed())
        drawn.draw_without_rendering()
        labels = {each.get_text() for axes in drawn.axes for each in axes.get_yticklabels()}
        assert not fixed_words(drawn, but=labels)
