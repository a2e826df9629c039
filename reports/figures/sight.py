"""What of points, lines and parts an eye sees behind the faces of bodies; all as a camera projects them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from reports.figures.faces import EDGE_ON, normals, plane_heights
from reports.figures.projection import Camera
from reports.figures.solids import Surface
from spectra.arrays import BoolArray, FloatArray, IntArray

STEPS = 60  # pieces of a line
FEW, GRID = 200, 5  # triangles of a part up to which points are taken on a grid over each, and points along its sides
BEHIND = 0.02  # of the bodies' depth: what is nearer to a face is on it


@dataclass(frozen=True)
class Curtain:
    """Faces [m, 3, 3] that hide what is behind them, and the tree by which they are found."""

    faces: FloatArray
    tree: shapely.STRtree

    def hides(self, points: FloatArray) -> BoolArray:
        """Return whether each of points [k, 3] lies behind one of the faces."""
        slack = BEHIND * float(np.ptp(self.faces[:, :, 2]))
        point, face = self.tree.query(np.asarray(shapely.points(points[:, :2])), predicate="intersects")
        nearer = plane_heights(self.faces[face], points[point, :2]) > points[point, 2] + slack
        return np.isin(np.arange(len(points)), point[nearer])


def curtain(faces: FloatArray) -> Curtain:
    """Return faces [m, 3, 3] as the camera sees them as what hides points behind them."""
    return Curtain(faces, shapely.STRtree(np.asarray(shapely.polygons(faces[:, :, :2]))))


def project_faces(surface: Surface, owner: IntArray, camera: Camera) -> tuple[Curtain, IntArray]:
    """Return the faces that look at the eye as the camera sees them, and the owner of each [m]."""
    corners = surface.corners
    front = normals(corners) @ camera.frame[2] > EDGE_ON
    return curtain(camera.project(corners[front])), owner[front]


def split_line(line: FloatArray, before: Curtain) -> Iterator[tuple[FloatArray, bool]]:
    """Yield the pieces [j, 3] of a line of points [k, 3], each with whether it is hidden."""
    along = np.linspace(0.0, len(line) - 1.0, STEPS * (len(line) - 1) if len(line) < 4 else 4 * len(line))
    points = np.column_stack([np.interp(along, np.arange(len(line)), line[:, axis]) for axis in range(3)])
    hidden = before.hides(points)
    turns = np.flatnonzero(np.diff(hidden)) + 1
    for start, end in zip([0, *turns], [*turns, len(points)], strict=True):
        yield points[start : end + 1], bool(hidden[start])


def visible_middle(own: FloatArray, before: Curtain) -> FloatArray | None:
    """Return the point [3] of a part's faces [j, 3, 3] nearest to the middle of what is seen; None if nothing is."""
    if not len(own):
        return None
    shares = _grid() if len(own) <= FEW else np.full((1, 3), 1.0 / 3.0)
    points = np.einsum("sc,jci->jsi", shares, own).reshape(-1, 3)
    weight = np.repeat(shapely.area(shapely.polygons(own[..., :2])), len(shares))
    seen = ~before.hides(points) & (weight > 0.0)
    if not seen.any():
        return None
    middle = np.average(points[seen, :2], axis=0, weights=weight[seen])
    return np.asarray(points[seen][np.linalg.norm(points[seen, :2] - middle, axis=1).argmin()])


def _grid() -> FloatArray:
    """Return shares of the corners [s, 3] of points over a triangle, none on its sides."""
    at = np.arange(GRID) + 1.0 / 3.0
    first, second = (each.ravel() / GRID for each in np.meshgrid(at, at))
    shares = np.column_stack([first, second, 1.0 - first - second])
    return np.asarray(shares[shares[:, 2] > 0.0])
