"""A spectral check whose demand lies beyond the end of its spectrum, against the same on a longer spectrum."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import asce43_05
from assess.codes.asce43_05 import Asce4305Options
from assess.codes.check import Reason
from assess.codes.context import Context
from assess.mechanisms.single_block import equivalent_block
from spectra import table

LEVELS = (0.1 * g, 0.3 * g, 0.4 * g, 0.6 * g)


def answers(last: float):
    """The check at four levels on a spectrum 1 / T that ends at the period `last` [s]."""
    periods = np.concatenate([[0.0], np.linspace(0.4, last, 60)])
    site = table.table_spectrum(periods, np.where(periods > 0.0, 0.4 / np.maximum(periods, 0.4), 0.4) * g)
    wall = equivalent_block("w", p=1.8, uplift=0.15, radius=2.4).oscillator
    return asce43_05.assess_spectrum(wall, Context(site, LEVELS, 0.0, 0.0, None), options=Asce4305Options())


@pytest.mark.parametrize("last", [2.2, 3.0])
def test_it_fails_without_being_said_to_overturn(last):
    short, long = answers(last), answers(30.0)
    assert [check.unbounded for check in long] == ["", "", "", "overturned"]
    assert [check.verdict for check in short] == [check.verdict for check in long]
    cut = short[-1]
    assert (cut.demand, cut.reason.key, cut.unbounded) == (None, Reason.BEYOND_SPECTRUM, "beyond the spectrum")
