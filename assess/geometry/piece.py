"""Blocks of a mechanism as they are cut from the bodies of a building."""

from __future__ import annotations

from dataclasses import dataclass

from assess.geometry.planar import PlanarBody
from assess.geometry.solid import Solid
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class Piece:
    """One block of a mechanism, as cut.

    body : in the plane of motion; solids : what it is made of, none for direct values; foot : corners of the face it
    stands on [k, 3] [m], None without geometry; cut : whether that face is a cut; section : its rings [k, 3] [m];
    fixed : what lies beyond the cut and stays
    """

    body: PlanarBody
    solids: tuple[Solid, ...]
    foot: FloatArray | None
    cut: bool = False
    section: tuple[FloatArray, ...] = ()
    fixed: tuple[Solid, ...] = ()
