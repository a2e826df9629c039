"""Axes of figures in US customary units: curves stay in place, ticks are at round numbers of the unit."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axis import Axis
from matplotlib.figure import Figure as Drawn
from matplotlib.text import Text
from matplotlib.ticker import Formatter, Locator

from reports.document import Document, Figure, Section
from reports.figures.style import report_style
from reports.language.customary import Customary, customary

_LABELLED = re.compile(r"\[([^\[\]]+)\](?=\s*$)")


def in_us_axes(document: Document) -> Document:
    """Return the document with figures whose axes are in US units once they are drawn."""
    return replace(document, sections=tuple(map(_section, document.sections)))


def _section(section: Section) -> Section:
    blocks = (
        replace(block, draw=partial(_drawn, block.draw)) if isinstance(block, Figure) else block
        for block in section.blocks
    )
    return replace(section, blocks=tuple(blocks))


def _drawn(draw: Callable[[], Drawn]) -> Drawn:
    figure = draw()
    with report_style():
        convert(figure)
    return figure


def convert(figure: Drawn) -> None:
    """Give every axis whose label ends in a unit, like "elevation z [m]", ticks and label in the US one.

    An axis without a label has the unit of the others of its direction, where they have but one.
    """
    across, up = ([getattr(axes, name) for axes in figure.axes] for name in ("xaxis", "yaxis"))
    _axes(across, besides=(figure.get_supxlabel(),))
    _axes(up, besides=(figure.get_supylabel(),))
    for letters in figure.findobj(Text):
        assert isinstance(letters, Text)
        letters.set_text(_LABELLED.sub(_renamed, letters.get_text()))


def _axes(axes: Sequence[Axis], *, besides: Iterable[str]) -> None:
    labels = [axis.get_label_text() for axis in axes]
    units = {_unit(label) for label in (*labels, *besides) if label}
    common = next(iter(units)) if len(units) == 1 else None
    for axis, label in zip(axes, labels, strict=True):
        found = _unit(label) if label else common
        if found is not None and not isinstance(axis.get_major_locator(), UsLocator):
            _scale(axis, found.factor)


def _scale(axis: Axis, factor: float) -> None:
    """Convert the ticks of one axis; axes that share its scale share them."""
    axis.set_major_locator(UsLocator(axis.get_major_locator(), factor))
    axis.set_minor_locator(UsLocator(axis.get_minor_locator(), factor))
    axis.set_major_formatter(UsFormatter(axis.get_major_formatter(), factor))
    axis.set_minor_formatter(UsFormatter(axis.get_minor_formatter(), factor))


def _unit(label: str) -> Customary | None:
    found = _LABELLED.search(label)
    return None if found is None else customary(found[1])


def _renamed(found: re.Match[str]) -> str:
    unit = customary(found[1])
    return found[0] if unit is None else f"[{unit.unit}]"


class _Scaled:
    """An axis as its locator and formatter see it: in units of which one of its own is `factor`."""

    def __init__(self, axis: Any, factor: float) -> None:
        self._axis, self._factor = axis, factor

    def __getattr__(self, name: str) -> Any:
        return getattr(self._axis, name)

    def get_view_interval(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Return the visible range of the axis."""
        return self._factor * np.asarray(self._axis.get_view_interval(), dtype=np.float64)

    def get_data_interval(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Return the range of the data along the axis."""
        return self._factor * np.asarray(self._axis.get_data_interval(), dtype=np.float64)


class UsLocator(Locator):
    """Ticks where another locator puts them on the axis in US units, in the units of the axis."""

    def __init__(self, inner: Locator, factor: float) -> None:
        self.inner, self.factor = inner, factor

    def set_axis(self, axis: Any) -> None:
        """Give both locators one axis, the inner one in US units."""
        super().set_axis(axis)
        self.inner.set_axis(_Scaled(axis, self.factor))  # type: ignore[arg-type]  # it answers as an axis does

    def __call__(self) -> Any:
        return np.asarray(self.inner(), dtype=np.float64) / self.factor

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Return the ticks between two values."""
        return np.asarray(self.inner.tick_values(vmin * self.factor, vmax * self.factor)) / self.factor

    def nonsingular(self, v0: float, v1: float) -> tuple[float, float]:
        """Return limits that differ."""
        return self.inner.nonsingular(v0, v1)


class UsFormatter(Formatter):
    """Numbers at the ticks as another formatter writes them, of the values in US units."""

    def __init__(self, inner: Formatter, factor: float) -> None:
        self.inner, self.factor = inner, factor

    def set_axis(self, axis: Any) -> None:
        """Give both formatters one axis, the inner one in US units."""
        super().set_axis(axis)
        self.inner.set_axis(_Scaled(axis, self.factor))  # type: ignore[arg-type]  # it answers as an axis does

    def __call__(self, x: float, pos: int | None = None) -> str:
        return self.inner(x * self.factor, pos)

    def set_locs(self, locs: list[float]) -> None:
        """Set the ticks that are written together."""
        super().set_locs(locs)
        self.inner.set_locs([at * self.factor for at in locs])

    def get_offset(self) -> str:
        """Return the power of ten that all numbers are to be multiplied by."""
        return self.inner.get_offset()
