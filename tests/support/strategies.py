"""Cases that properties draw by hypothesis: regions of contact, blocks, motions, walls."""

from __future__ import annotations

import numpy as np
import shapely
from hypothesis import strategies as st
from shapely.affinity import scale, translate

from assess.oscillator import Oscillator
from records.record import Record
from tests.support.blocks import branch
from tests.support.motions import noise


@st.composite
def stars(draw: st.DrawFn) -> shapely.Polygon:
    """Concave, of 5 to 14 corners."""
    radii = np.array(draw(st.lists(st.floats(0.4, 1.5), min_size=5, max_size=14)))
    angles = np.linspace(0, 2 * np.pi, radii.size, endpoint=False) + draw(st.floats(0.0, 1.0))
    return shapely.Polygon(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]))


@st.composite
def regions(draw: st.DrawFn) -> shapely.Polygon | shapely.MultiPolygon:
    """A star, which may have a hole, and another part beside it."""
    found = draw(stars())
    if draw(st.booleans()):
        found = found.difference(scale(found, 0.3, 0.3, origin=(0, 0)))
    if draw(st.booleans()):
        beside = translate(draw(stars()), draw(st.floats(3.1, 5.0)), draw(st.floats(3.1, 5.0)))
        found = shapely.union_all([found, beside])
    return found


@st.composite
def branches(draw: st.DrawFn):
    """A block of M R = 1 kg m, whose inertia may grow or shrink as it turns."""
    swell = draw(st.sampled_from([0.0, 0.0, 3.0, -1.5]))
    return branch(draw(st.floats(1.0, 3.0)), draw(st.floats(0.1, 0.35)), draw(st.floats(0.0, 1.0)), swell=swell)


@st.composite
def oscillators(draw: st.DrawFn, *, two_sided: bool = False) -> Oscillator:
    """Sides that need not be alike; one side may be missing."""
    negative = draw(branches()) if two_sided else draw(st.none() | branches())
    return Oscillator(draw(branches()), negative, 1.0)


@st.composite
def motions(draw: st.DrawFn, *, npts: int = 300) -> Record:
    """Smoothed noise, from what hardly lifts a block to what overturns most."""
    return noise(draw(st.integers(0, 10_000)), peak=draw(st.floats(1.0, 6.0)), npts=npts)
