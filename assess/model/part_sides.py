"""Where outside is: the sides of walls that face away from the building.

At the level of a wall, what its walls enclose is inside, but for courtyards, over which there is no floor, roof or
vault. A wall with both sides inside is an inner wall.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import shapely

from assess.mechanisms.mechanism import Vector
from assess.model.structure import COVERINGS, IN_LINE, Part, PartContact

STATIONS = (0.2, 0.35, 0.5, 0.65, 0.8)  # of the length of a wall, where its sides are looked at
AWAY = 0.2  # m: from the face of a wall
GAPS = 0.1  # m: walls nearer one another leave no way out
MOST = 0.6  # of the stations
COVERED = 0.5  # of a court: one that a roof covers by more is inside
BEHIND = 0.3  # m: what lies no farther beyond a wall's middle is not beyond it, as the eaves of its roof


def face_outwards(parts: Sequence[Part], contacts: Sequence[PartContact]) -> list[Part]:
    """Return the parts with the normals of façades outwards.

    A wall that encloses nothing by itself, as a gable or a parapet, faces as the wall that it stands on.

    Parameters
    ----------
    parts : of the building
    contacts : of them
    """
    plans = {part.name: shapely.MultiPoint(part.solid.vertices[:, :2]).convex_hull for part in parts}
    insides: dict[tuple[str, ...], shapely.Geometry] = {}
    found: dict[str, Part] = {}
    for part in parts:
        found[part.name] = (
            _turned(part, _outward_sign(part, parts, plans, insides)) if part.is_plate and part.kind != "pier" else part
        )
    for part in sorted(parts, key=lambda each: each.base):
        below = [each.second for each in contacts if each.first == part.name and each.relation == "stands-on"]
        carriers = [found[name] for name in below if found[name].outward]
        for carrier in carriers if part.is_plate and not found[part.name].outward else ():
            cosine = float(np.dot(carrier.normal, part.normal))
            if abs(cosine) > IN_LINE:
                found[part.name] = _turned(part, 1 if cosine > 0.0 else -1)
    return list(found.values())


def _turned(part: Part, sign: int) -> Part:
    """Return a part with its normal turned to the outside; sign 0 where neither side is known to be outside."""
    if sign == 0:
        return part
    if sign > 0:
        return replace(part, outward=True)
    length = part.length
    openings = tuple(
        replace(each, left=length - each.right, right=length - each.left) for each in reversed(part.openings)
    )
    return replace(part, normal=_minus(part.normal), along=_minus(part.along), outward=True, openings=openings)


def _minus(axis: Vector) -> Vector:
    return (-axis[0] + 0.0, -axis[1] + 0.0, -axis[2] + 0.0)


def _outward_sign(
    part: Part,
    parts: Sequence[Part],
    plans: Mapping[str, shapely.Geometry],
    insides: dict[tuple[str, ...], shapely.Geometry],
) -> int:
    """Return 1 where the normal of a wall points out of the building, -1 where it points in, 0 where neither is so."""
    level = (part.base + part.top) / 2.0
    around = [each for each in parts if each.kind not in (*COVERINGS, "tie") and each.base < level < each.top]
    over = [each for each in parts if each.kind in COVERINGS and each.top > level]
    key = (*(each.name for each in around), "", *(each.name for each in over))
    if key not in insides:
        insides[key] = _inside([plans[each.name] for each in around], [plans[each.name] for each in over])
    normal, along = np.array(part.normal[:2]), np.array(part.along[:2])
    places = part.start + np.array(STATIONS) * part.length
    middle = places[:, None] * along + part.middle * normal
    reach = (float(np.ptp(part.solid.vertices[:, :2] @ normal)) / 2.0 + AWAY) * normal
    front, back = (float(np.mean(shapely.contains_xy(insides[key], middle + side * reach))) for side in (1.0, -1.0))
    if (front >= MOST) != (back >= MOST):
        return -1 if front >= MOST else 1
    if front >= MOST:
        return 0
    others = np.array([float(each.solid.centroid[:2] @ normal) for each in parts if each.name != part.name])
    beyond = others - part.middle
    reach_out = max(BEHIND, part.thickness / 2.0)
    if (beyond > reach_out).any() == (beyond < -reach_out).any():
        return 0
    return -1 if (beyond > reach_out).any() else 1


def _inside(walls: Sequence[shapely.Geometry], coverings: Sequence[shapely.Geometry]) -> shapely.Geometry:
    """Return what walls enclose in plan, less the courts that nothing covers; all of it where there is no covering."""
    whole = shapely.union_all([shapely.buffer(wall, GAPS, join_style="mitre") for wall in walls])
    covered = shapely.union_all(list(coverings))
    filled, courts = [], []
    for polygon in shapely.get_parts(whole):
        filled.append(shapely.Polygon(polygon.exterior))
        holes = [shapely.Polygon(ring) for ring in polygon.interiors]
        courts += [hole for hole in holes if hole.intersection(covered).area < COVERED * hole.area and coverings]
    return shapely.difference(shapely.union_all(filled), shapely.union_all(courts))
