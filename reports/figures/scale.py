"""One unit for a whole axis, and its label."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from reports.language.locale import Locale
from reports.language.texts import Text
from reports.language.units import UNITS, Unit
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class Scale:
    """The unit in which an axis shows values in SI."""

    unit: Unit
    locale: Locale

    def of(self, values: ArrayLike) -> FloatArray:
        """Return values in SI as numbers of the unit."""
        return np.asarray(values, dtype=np.float64) / self.unit.size

    def heading(self, label: Text) -> str:
        """Return the label of the axis with its unit: "rotation φ [rad]"."""
        return f"{self.locale.text(label)} [{self.locale.unit_name(self.unit) or '-'}]"


def table_scale(dimension: str, locale: Locale) -> Scale:
    """Return the scale in the unit that tables have."""
    return Scale(locale.table_unit(dimension), locale)


def fitting_scale(dimension: str, values: Sequence[float], locale: Locale) -> Scale:
    """Return the scale in the unit in which the largest of the values is written."""
    largest = max((abs(value) for value in values if np.isfinite(value)), default=0.0)
    return Scale(UNITS[locale.system][dimension].of(largest), locale)
