"""Side walls behind a block that overturns, toothed into it: as an engineer states them, and what may turn before them.

    z ^                     the units of both walls overlap by l, one course in h_b, over the thickness t_s
      |   side wall  +----+
      |  - - - - - - |    |     the bed under i courses carries their weight w i h_b l t_s, and rubs
      |- - - - - - - |wall|     as the wall opens
      |  - - - - - - |    | -->
      +--------------+----A

How much rubs is for the clauses (`assess.codes.toothing`). A wall that is bonded over its whole height may turn above
any level alone, so that the weights and loads above each of them, about its front edge, go with what is stated.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np

from assess.declaration import UNCERTAIN, Evidence, Fault, Number, PositiveDensity, PositiveLength, Share
from assess.errors import MechanismError
from assess.geometry.cut import Piece, section_edges, section_moments
from assess.geometry.solid import Solid
from assess.geometry.surface import volume
from assess.mechanisms.chain import Chain, RigidBlock, virtual_work
from assess.oscillator import Toothing
from spectra.arrays import FloatArray

NONE_COUNTED = "no friction of side walls"
AS_SURVEYED = Evidence("measured", "up", NONE_COUNTED)  # where no source vouches for it, the table is left out
LOWEST = 0.1  # of the height of the crack: the least height of what turns
LAYERS = 400  # in which the masonry above the lowest level is summed up
LEVELS = 41  # above which what turns is weighed; its multiplier varies slowly with the height
JUST_BELOW = 1e-6  # of the height of the crack: a level this far below a load carries it
END = 0.05  # of the length of a wall: what its ends are, where side walls stand


@dataclass(frozen=True, kw_only=True)
class SideWalls:
    """Cross walls behind the wall, whose units are bonded into it."""

    bond: Annotated[Literal["toothed", "detached"], Evidence("measured", ("detached", "toothed"), NONE_COUNTED)]
    """"toothed": units of both walls overlap at the joint, course by course; "detached": a crack parts them already"""
    course: Annotated[PositiveLength | None, UNCERTAIN, Evidence("measured", "down", NONE_COUNTED)] = None
    """mean height of the units, h_b, like "0.25 m\""""
    overlap: Annotated[PositiveLength | None, UNCERTAIN, AS_SURVEYED] = None
    """length over which a unit of one course lies on that of the next, l"""
    thickness: Annotated[PositiveLength | None, UNCERTAIN, AS_SURVEYED] = None
    """of each side wall, t_s; of its outer leaf where its leaves are not bonded"""
    friction: Annotated[Share, UNCERTAIN, AS_SURVEYED] = 0.577
    """coefficient of friction between the units"""
    density: Annotated[PositiveDensity | None, UNCERTAIN, AS_SURVEYED] = None
    """of the side walls; that of the wall if absent"""
    count: Annotated[int, Number(least=1, most=2), AS_SURVEYED] = 1
    """how many side walls are toothed so: 1 or 2"""

    def faults(self) -> Iterator[Fault]:
        """Yield what a toothed joint lacks."""
        for key in ("course", "overlap", "thickness") if self.bond == "toothed" else ():
            if getattr(self, key) is None:
                yield key, 'missing; a toothed joint needs it; or write bond = "detached"'


@dataclass(frozen=True, eq=False)
class ToothedBlock:
    """A block with side walls toothed into it.

    stated : as an engineer states them
    solids : that turn; along : unit vector of the direction of positive rotation [3]
    inner : place of the back edge of its base along the direction [m]
    top : elevation of the lower of its two ends, up to which side walls are taken to rise [m]
    where : the mechanism, for errors
    """

    stated: SideWalls
    solids: tuple[Solid, ...]
    along: FloatArray
    inner: float
    top: float
    where: str


def toothed_block(where: str, stated: SideWalls, piece: Piece, along: FloatArray, *, foot: float) -> ToothedBlock:
    """Return a block with the side walls that are toothed into it.

    Parameters
    ----------
    where : the mechanism, for errors
    stated : the side walls
    piece : the block
    along : unit vector of the direction [3]
    foot : elevation of its hinge [m]

    Raises
    ------
    MechanismError : the block has no geometry, or is lower than one course
    """
    if not piece.solids or piece.body.base is None:
        raise MechanismError(
            f"{where}: side_walls: its bodies have no geometry, by which parts of it could turn alone; give them a "
            "mesh, box or profile, or remove side_walls"
        )
    top, course = _lower_end(piece.solids, along), stated.course or 0.0
    if top - foot < course:
        raise MechanismError(
            f"{where}: side_walls.course = {course:.4g} m: more than the {top - foot:.4g} m from the hinge to the top "
            "of the wall at its lower end; give the height of one course"
        )
    return ToothedBlock(stated, piece.solids, along, piece.body.base[0][0], top, where)


def toothing_of(block: ToothedBlock, chain: Chain) -> Toothing:
    """Weigh what may turn above each level of a block with side walls.

    Parameters
    ----------
    block : with side walls
    chain : of the positive branch, with all its loads
    """
    stated, height = block.stated, block.top - chain.hinges[0][1]
    parts = list(_parts_above(block, chain, block.top - _heights(block, chain, height)))
    parts.append((height, replace(chain, joints=()), max(chain.hinges[0][0] - block.inner, 0.0)))
    works = [virtual_work(part, np.zeros(1)) for _, part, _ in parts]
    volumes = [volume(solid.vertices, solid.triangles) for solid in block.solids]
    return Toothing(
        walls=stated.count,
        course=stated.course or 0.0,
        overlap=stated.overlap or 0.0,
        thickness=stated.thickness or 0.0,
        density=stated.density or sum(solid.mass for solid in block.solids) / sum(volumes),
        friction=stated.friction,
        height=np.array([each for each, _, _ in parts]),
        restoring=np.array([float(work.restoring[0]) for work in works]),
        excitation=np.array([float(work.excitation[0]) for work in works]),
        depth=np.array([depth for _, _, depth in parts]),
    )


def _heights(block: ToothedBlock, chain: Chain, height: float) -> FloatArray:
    """Return the heights of the parts that are weighed, rising, but the whole [n] [m]; some just carry a load."""
    least = max(block.stated.course or 0.0, LOWEST * height)
    above = np.array([block.top - load.at[1] for load in chain.loads])
    levels = np.unique(np.concatenate([np.linspace(least, height, LEVELS), above, above + JUST_BELOW * height]))
    return np.asarray(levels[(levels >= least) & (levels < height * (1.0 - JUST_BELOW))])


def _parts_above(block: ToothedBlock, chain: Chain, level: FloatArray) -> Iterator[tuple[float, Chain, float]]:
    """Yield what turns above each level about its front edge: its height, itself, and its depth there [m].

    Its masonry is summed up in thin layers; at a ledge what is both above and below bears.
    """
    along, top = block.along.tolist(), max(float(solid.vertices[:, 2].max()) for solid in block.solids)
    edges = np.unique(np.concatenate([level, np.linspace(float(level.min(initial=top)), top, LAYERS + 1)]))
    middle, thick = (edges[1:] + edges[:-1]) / 2.0, np.diff(edges)
    layers = np.zeros((len(middle), 2))
    near = JUST_BELOW * (block.top - chain.hinges[0][1])
    sides = np.array([[np.inf, -np.inf]] * len(level)), np.array([[np.inf, -np.inf]] * len(level))
    for solid in block.solids:
        density = solid.mass / volume(solid.vertices, solid.triangles)
        layers += density * section_moments(solid, middle, direction=along)[:, :2] * thick[:, None]
        for side, z in zip(sides, (level + near, level - near), strict=True):
            ends = section_edges(solid, z, direction=along)
            side[:, 0], side[:, 1] = np.minimum(side[:, 0], ends[:, 0]), np.maximum(side[:, 1], ends[:, 1])
    back, front = np.maximum(*(side[:, 0] for side in sides)), np.minimum(*(side[:, 1] for side in sides))
    for z, behind, ahead in zip(level.tolist(), back.tolist(), front.tolist(), strict=True):
        mass, moment = layers[middle > z].sum(axis=0).tolist()
        if mass > 0.0 and behind < ahead:
            rise = float(layers[middle > z, 0] @ middle[middle > z]) / mass
            masonry = RigidBlock(mass, (moment / mass, rise), 0.0)  # at rest its inertia has no part
            carried = tuple(load for load in chain.loads if load.at[1] > z)
            yield block.top - z, Chain((masonry,), ((ahead, z),), carried), ahead - behind


def _lower_end(solids: Sequence[Solid], along: FloatArray) -> float:
    """Return the top of the lower of the two ends of a wall across its direction [m]."""
    vertices = np.concatenate([solid.vertices for solid in solids])
    across = vertices @ np.array([-along[1], along[0], 0.0])
    low, high = float(across.min()), float(across.max())
    reach = END * (high - low)
    return min(float(vertices[at, 2].max()) for at in (across <= low + reach, across >= high - reach))
