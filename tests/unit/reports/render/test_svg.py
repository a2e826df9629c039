"""A figure's marks as an SVG file."""

from __future__ import annotations

from pathlib import Path as File
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import TextPath

from reports.figures.style import report_style, sheet
from reports.language.locale import Locale
from reports.render.vector import _glyph, path_data, svg_picture, trace_figure, write_svg

SVG = "{http://www.w3.org/2000/svg}"


def written(folder: File, text: str) -> ElementTree.Element:
    with report_style():
        figure = sheet(2.0, Locale(), width=4.0)
        figure.set_layout_engine("none")
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0, 4), ylim=(0, 2))
        axes.set_axis_off()
        axes.plot([1, 3], [0.5, 1.5], color="#ff0000", linestyle="--")
        figure.text(0.5, 0.5, text)
    return ElementTree.parse(
        write_svg(svg_picture(trace_figure(figure)), folder / "figure.svg", creator="program <1>")
    ).getroot()


def test_a_line_lands_where_the_axes_put_it(tmp_path: File) -> None:
    root = written(tmp_path, "λ")
    lines = [each for each in root.iter(f"{SVG}path") if each.get("stroke") == "#ff0000"]
    assert [each.get("d") for each in lines] == ["M72 36L216 108"]
    assert lines[0].get("stroke-dasharray")
    assert (root.get("width"), root.get("viewBox")) == ("288pt", "0 0 288 144")
    assert root.findall(f"{SVG}g")[0].get("transform") == "matrix(1 0 0 -1 0 144)"  # y grows downwards in SVG


def test_text_is_kept_letter_for_letter(tmp_path: File) -> None:
    text = "$x_1$ <b>\"&' \\alpha"
    words = [each for each in written(tmp_path, text).iter(f"{SVG}g") if each.get("aria-label")]
    assert [each.get("aria-label") for each in words] == [text]
    assert len(words[0]) == len(text)


def test_every_reference_has_its_definition(tmp_path: File) -> None:
    root = written(tmp_path, "φ/φₒᵥ [-]")
    defined = {each.get("id") for each in root.iter() if each.get("id")}
    used = {each.get("{http://www.w3.org/1999/xlink}href", "#")[1:] for each in root.iter(f"{SVG}use")}
    clips = {each.get("clip-path", "")[5:-1] for each in root.iter() if each.get("clip-path")}
    assert used | clips == defined


@pytest.mark.parametrize("bold", [False, True])
def test_letters_are_those_of_the_font(bold: bool) -> None:
    data, advance = _glyph(bold, "R")
    font = FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal")
    path = TextPath((0, 0), "R", size=100, prop=font)
    numbers = np.array([float(x) for x in data.replace("Z", "").translate(str.maketrans("MLQC", "    ")).split()])
    expected = path.get_extents()
    assert numbers[::2].min() == pytest.approx(expected.x0, abs=1.0)
    assert numbers[::2].max() == pytest.approx(expected.x1, abs=1.0)
    assert TextPath((0, 0), "RR", size=100, prop=font).get_extents().x1 - expected.x1 == pytest.approx(advance, abs=1.0)


def test_outline_in_the_commands_of_svg() -> None:
    codes = bytes((Path.MOVETO, Path.LINETO, Path.CURVE3, Path.LINETO, Path.LINETO, Path.CLOSEPOLY))
    assert path_data(codes, (0, 0, 1, 0, 2, 1, 3, 1, 4, 2, 5, 2.5)) == "M0 0L1 0Q2 1 3 1L4 2L5 2.5Z"
