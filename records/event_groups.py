"""Event groups: recordings of one earthquake, or of one motion in two files."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from records.candidates import Candidate
from spectra.arrays import IntArray

Recording = tuple[Candidate, ...]  # the components of one recording that are chosen together

ALIKE = 0.01  # largest difference of the logarithms of two spectra of one motion; its digits differ from file to file
COARSE = 8  # of how many ordinates one is compared first


def event_groups(recordings: Sequence[Recording], *, one_per_event: bool) -> IntArray:
    """Number the groups of recordings [n] of which a suite may have only one.

    Recordings of one motion are one group, and with `one_per_event` also those of one earthquake. Where a motion is in
    two files of which only one names its earthquake, both are of that earthquake.
    """
    pairs = [same_motion(recordings)]
    if one_per_event:
        pairs.append(same_earthquake(recordings))
    first, second = np.concatenate(pairs).T
    graph = coo_array((np.ones(first.size), (first, second)), shape=(len(recordings), len(recordings)))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


def same_earthquake(recordings: Sequence[Recording]) -> IntArray:
    """Pair each recording with the first of its earthquake [m, 2]."""
    first: dict[str, int] = {}
    pairs = [(first.setdefault(parts[0].earthquake, place), place) for place, parts in enumerate(recordings)]
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def same_motion(recordings: Sequence[Recording]) -> IntArray:
    """Pair recordings [m, 2] with a component whose spectrum has the same shape, to one percent."""
    of = np.array([place for place, parts in enumerate(recordings) for _ in parts], dtype=np.int64)
    spectra = [one.spectrum for parts in recordings for one in parts]
    if not spectra:
        return np.empty((0, 2), dtype=np.int64)
    log = np.log(np.maximum(spectra, 1e-300))
    shape = log - log.max(axis=1, keepdims=True)
    near = KDTree(shape[:, ::COARSE]).query_pairs(ALIKE, p=np.inf, output_type="ndarray").reshape(-1, 2)
    alike = np.abs(shape[near[:, 0]] - shape[near[:, 1]]).max(axis=1) <= ALIKE
    return np.asarray(of[near[alike]], dtype=np.int64)
