"""The largest rotation of the governing history, found again from a table half as fine with steps less exact.

If halving the number of rotations in the table and allowing a hundred times the error in a step leaves the rotation as
it is, both are fine enough: the error of a spline falls with the fourth power of its spacing.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from assess.dynamics.history import TOLERANCE, peaks, product
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Quantity, note
from assess.oscillator import Branch, Oscillator
from assess.results import Control
from assess.study.controls.governing import GoverningHistory
from assess.study.controls.outcome import made, not_made
from spectra.arrays import FloatArray

LOOSER = 100.0  # times the error allowed in a step
RATIO, TIME, OVERTURNING = "largest rotation over that of overturning", "time of overturning", "overturning rotation"
COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")


def convergence_control(mechanism: Mechanism, governing: GoverningHistory | None) -> Control:
    """Compare the governing history with itself on a coarser table, or the overturning rotation where none rocks.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism.
    governing : GoverningHistory, optional
        Its history; None where none rocks.

    Returns
    -------
    Control
        Relative to the value of the run.
    """
    if governing is None:
        return _overturning(mechanism)
    if governing.equation == "linearised":
        return not_made("convergence", mechanism.name, RATIO, dimension="ratio", why="control-without-table")
    coarse = peaks(
        [coarser_oscillator(governing.oscillator)],
        [governing.motion],
        product(1, 1, governing.scale),
        equation="exact",
        threads=1,
        tolerance=LOOSER * TOLERANCE,
    )
    found = governing.found
    quantity, dimension = RATIO, "ratio"
    value, reference = found.max_rotation_ratio, float(coarse.max_ratio[0])
    if found.overturned and coarse.overturned[0]:
        quantity, dimension = TIME, "time"
        value, reference = found.overturning_time_s, float(coarse.overturning_time[0])
    if value is None:  # it overturns here, and not with less exact steps
        value = 1.0
    return made(
        "convergence",
        mechanism.name,
        quantity,
        value=value,
        reference=reference,
        scale=value,
        dimension=dimension,
        note=note(
            "control-coarser",
            mechanism.name,
            record=found.record,
            level=Quantity(found.level_pga_g, "ground acceleration", 3),
            factor=Quantity(LOOSER, "ratio", 3),
        ),
    )


def coarser_oscillator(oscillator: Oscillator) -> Oscillator:
    """Return the oscillator with every second rotation of its tables."""
    positive, negative = oscillator.positive, oscillator.negative
    first = coarser_branch(positive)
    other = first if negative is positive else None if negative is None else coarser_branch(negative)
    return replace(oscillator, positive=first, negative=other)


def coarser_branch(branch: Branch) -> Branch:
    """Return the branch with every second rotation of its table, and both ends of each smooth piece of it."""
    kept = every_second(branch.rotation)
    return replace(branch, **{key: getattr(branch, key)[kept] for key in COLUMNS})


def every_second(rotation: FloatArray) -> FloatArray:
    """Return the numbers of the nodes to keep [m]; jumps, of two nodes at one rotation, stay."""
    ends = np.concatenate([[0], np.flatnonzero(np.diff(rotation) == 0.0) + 1, [rotation.size]])
    pieces = [np.arange(first, last) for first, last in pairwise(ends.tolist())]
    return np.concatenate([np.union1d(piece[::2], piece[-1:]) for piece in pieces])


def _overturning(mechanism: Mechanism) -> Control:
    """Compare the overturning rotation with that at which a table half as fine falls to zero."""
    branch = mechanism.variants.deciding.positive
    roots = coarser_branch(branch).restoring_spline.roots(extrapolate=False)
    known = roots[np.isfinite(roots)]  # an interval of no width has none
    near = known[np.argmin(np.abs(known - branch.unstable))] if known.size else 0.0
    return made(
        "convergence",
        mechanism.name,
        OVERTURNING,
        value=branch.unstable,
        reference=float(near),
        scale=branch.unstable,
        dimension="rotation",
        note=note("control-coarser-table", mechanism.name),
    )
