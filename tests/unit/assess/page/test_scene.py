"""What the drawing of the page is made of: labels, colours and hatches."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from assess.page.scene import HATCHES, OUTCOMES, UNKNOWN, UNKNOWN_HATCH, hinge_labels
from assess.results import NamedPoint


def test_hinges_at_one_place_have_one_label():
    hinges = [NamedPoint("A", (0.3, 0.0)), NamedPoint("B", (0.3, 2.0)), NamedPoint("A'", (0.301, 0.0))]
    assert hinge_labels(hinges, apart=0.01) == [("A, A'", (0.3, 0.0)), ("B", (0.3, 2.0))]
    assert len(hinge_labels(hinges, apart=0.0)) == 3


SEEN = {
    "as most do": np.eye(3),
    "without red cones": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "without green cones": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "without blue cones": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
"""Linear RGB as it is seen (Machado, Oliveira and Fernandes 2009, severity 1)."""


@pytest.mark.parametrize("sight", SEEN)
def test_colours_of_outcomes_are_told_apart_without_colour_vision(sight):
    """CIE 1976 differences of 15 and more, where 2.3 is just seen; and no two have the same hatching."""
    colours = [*OUTCOMES.values(), UNKNOWN]
    assert len({HATCHES[name] for name in OUTCOMES} | {UNKNOWN_HATCH}) == len(colours)
    labs = [lab(SEEN[sight] @ linear(np.array(each))) for each in colours]
    for one, other in combinations(labs, 2):
        assert np.linalg.norm(one - other) > 15.0


def linear(colour: np.ndarray) -> np.ndarray:
    """Return linear RGB of an sRGB colour of 8 bits (IEC 61966-2-1)."""
    share = colour / 255.0
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def lab(rgb: np.ndarray) -> np.ndarray:
    """Return CIE L*a*b* of linear RGB, under D65."""
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    share = np.clip(to_xyz @ np.clip(rgb, 0.0, 1.0) / [0.9505, 1.0, 1.089], 0.0, None)
    f = np.where(share > (6 / 29) ** 3, np.cbrt(share), share / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])
