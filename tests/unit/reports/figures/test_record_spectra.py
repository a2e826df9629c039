"""Response spectra of records: the legend stands below the axes, and a figure that cannot be written is named."""

import re
from pathlib import Path

import numpy as np
import pytest

from assess.errors import OutputError
from reports.figures.spectrum import draw_record_spectra
from reports.language.locale import Locale
from reports.render.vector import write_figure

PERIOD = np.geomspace(0.02, 10.0, 50)


def test_the_legend_covers_no_curve() -> None:
    figure = draw_record_spectra([f"record {i}" for i in range(7)], PERIOD, np.ones((7, 50)), Locale())
    figure.draw_without_rendering()
    (axes,) = figure.axes
    (legend,) = figure.legends
    box = legend.get_window_extent()
    assert box.y1 <= axes.xaxis.label.get_window_extent().y0
    assert box.y0 >= figure.bbox.y0


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    path = tmp_path / "none" / "f.svg"
    with pytest.raises(OutputError, match=f"{re.escape(str(path))}: there is no folder .*; make it first"):
        write_figure(draw_record_spectra(["a"], PERIOD, np.ones((1, 50)), Locale()), path, creator="test")


def test_components_of_one_recording_keep_apart_in_the_legend() -> None:
    """As many entries as records, though their names differ at the end alone."""
    names = [f"20161113_110259_WTMC_20 {component}" for component in ("N28W", "S62W", "Up")]
    (axes,) = draw_record_spectra(names, PERIOD, np.ones((3, 50)), Locale()).axes
    shown = [line.get_label() for line in axes.get_lines()]
    assert len(set(shown)) == 3
    assert [str(text).split()[-1] for text in shown] == ["N28W", "S62W", "Up"]
    assert max(len(str(text)) for text in shown) <= 24
