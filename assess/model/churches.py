"""What the parts of a church are, as far as geometry tells: which entry of the list of churches a mechanism answers.

An entry is answered only by the element that it speaks of. Where the drawing leaves open which wall that is, every wall
that it may be has to have the mechanism.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from assess.messages.message import note
from assess.model.least_multipliers import Drawing
from assess.model.moving_parts import Unexamined, bends, stands_on_tower
from assess.model.part_kinds import ABOVE_GROUND
from assess.model.structure import IN_LINE, Part, PartKind, Structure
from assess.model.turning import NEAR_LEVEL
from spectra.arrays import FloatArray

CHURCH_KINDS: tuple[PartKind, ...] = ("tower", "vault", "arch", "pinnacle")
"""Kinds of parts that a house seldom has, which tell whose list of mechanisms the report goes through."""
ACROSS = 0.34  # cosine: directions more than 70 degrees apart are across one another
WIDE = 0.5  # of the length of the apse: a triumphal arch that opens towards it spans at least this


def is_church(structure: Structure) -> bool:
    """Return whether a building has parts that a house seldom has."""
    return bool(structure.of_kind(*CHURCH_KINDS))


@dataclass(frozen=True)
class Church:
    """A building as the list of churches sees it."""

    drawing: Drawing

    @cached_property
    def apses(self) -> tuple[Part, ...]:
        """The walls that bend in plan."""
        return tuple(part for part in self.drawing.structure.of_kind("wall") if bends(part))

    @cached_property
    def axis(self) -> FloatArray | None:
        """The direction [3] of the nave, towards its apse if it has one; None where the drawing leaves it open."""
        ways = [_bulge(apse) for apse in self.apses] or [np.array(part.normal) for part in self._gabled]
        in_line = [abs(float(ways[0] @ way)) > IN_LINE for way in ways]
        return ways[0] if ways and all(in_line) else None

    @cached_property
    def facades(self) -> frozenset[str]:
        """The walls that may be the façade: opposite an apse and on its axis; without one, all along a gabled axis."""
        outer = [part for part in self._outer if part not in self.apses]
        if not self.apses:
            ends = [np.array(part.normal) for part in self._gabled]
            facing = [part for part in outer if any(abs(float(way @ part.normal)) > IN_LINE for way in ends)]
            return frozenset(part.name for part in facing)
        found: set[str] = set()
        for apse in self.apses:
            way, middle = _bulge(apse), apse.solid.centroid
            facing = [part for part in outer if float(way @ part.normal) < -IN_LINE]
            crossing = [part for part in facing if _spans(part, middle)]
            found |= {part.name for part in crossing or facing}
        return frozenset(found)

    def entry(self, kind: str, parts: Sequence[Part], low: float) -> str | None:
        """Return the entry of the list that a mechanism answers: empty for none, None as its class has it.

        Parameters
        ----------
        kind : the class of the mechanism
        parts : that it moves, the leading one first
        low : elevation of its hinge [m]
        """
        lead = parts[0]
        if kind in ("overturning", "overturning-of-storeys", "wedges"):
            return self._entry_of_wall(lead, low)
        if kind == "corner":
            on_tower = all(stands_on_tower((part,), self.drawing) for part in parts)
            return "bell-tower" if lead.kind == "tower" else "bell-cell" if on_tower else ""
        if kind in ("gable", "upper-part"):
            return "facade-top" if self._is_facade(lead) else ""
        if kind == "parapet":
            return "facade-top" if lead.kind == "wall" and self._is_facade(lead) else None
        if kind == "arch":
            return "triumphal-arch" if lead.name == self._triumphal_arch else ""
        if kind == "portal":
            return "porch" if self._is_outside(parts[:2]) else ""
        if kind == "tower":
            return "bell-tower" if lead.base <= self.drawing.structure.lowest + ABOVE_GROUND else ""
        return None

    def open_elements(self, tops: Collection[str]) -> Iterator[tuple[str, str, Unexamined]]:
        """Yield what may be an element of the list and is not known to be, with its class and the entry it may answer.

        tops : parts of which something turns above the foot of a façade
        """
        structure = self.drawing.structure
        if not is_church(structure):
            return
        named = [structure.part(name) for name in sorted(self.facades)]
        stacks = [structure.stack_of(part.name) for part in named if part.kind == "wall"]
        bare = [stack[0] for stack in stacks if not any(part.name in tops for part in stack)]
        for name in dict.fromkeys(part.name for part in bare if len(bare) < len(stacks)):
            yield "gable", "facade-top", Unexamined(structure.part(name), note("gap-facade-top"))
        if self._triumphal_arch is None:
            for arch in structure.of_kind("arch"):
                yield "arch", "triumphal-arch", Unexamined(arch, note("gap-which-arch"))

    @cached_property
    def _outer(self) -> tuple[Part, ...]:
        structure = self.drawing.structure
        outer = [part for part in structure.of_kind("wall", "gable") if part.outward]
        return tuple(part for part in outer if not stands_on_tower((part,), self.drawing))

    @cached_property
    def _gabled(self) -> tuple[Part, ...]:
        return tuple(part for part in self._outer if part.eaves is not None or part.kind == "gable")

    @cached_property
    def _triumphal_arch(self) -> str | None:
        """The arch across the nave that is nearest to its one apse; None where none is known to be."""
        if len(self.apses) != 1 or self.axis is None:
            return None
        (apse,), axis = self.apses, self.axis
        across = np.array([-axis[1], axis[0], 0.0])
        found = []
        for arch in self.drawing.structure.of_kind("arch"):
            aside = abs(float((arch.solid.centroid - apse.solid.centroid) @ across))
            before = float((apse.solid.centroid - arch.solid.centroid) @ axis)
            turned = abs(float(axis @ np.array(arch.along))) < ACROSS
            if turned and aside < arch.length / 4.0 and before > 0.0 and arch.length >= WIDE * apse.length:
                found.append((before, arch.name))
        return min(found)[1] if found else None

    def _entry_of_wall(self, lead: Part, low: float) -> str:
        stack = self.drawing.structure.stack_of(lead.name)
        if stands_on_tower(stack, self.drawing):
            return "bell-cell"
        if any(part in self.apses for part in stack):
            return "apse"
        if self._is_facade(lead):
            return "facade" if low <= min(part.base for part in stack) + NEAR_LEVEL else "facade-top"
        outer = next((part for part in stack if part.outward), None)
        if outer is None or self.axis is None or abs(float(self.axis @ np.array(outer.normal))) > ACROSS:
            return ""
        return "transept-end" if any(part in self._gabled for part in stack) else "nave-transverse"

    def _is_facade(self, part: Part) -> bool:
        return any(each.name in self.facades for each in self.drawing.structure.stack_of(part.name))

    def _is_outside(self, piers: Sequence[Part]) -> bool:
        """Return whether piers stand in front of the façade, which an apse tells."""
        if not self.apses or self.axis is None or not self.facades:
            return False
        structure, ahead = self.drawing.structure, -self.axis
        front = max(float((structure.part(name).solid.vertices @ ahead).max()) for name in self.facades)
        return all(float((pier.solid.vertices @ ahead).min()) > front for pier in piers)


def _bulge(part: Part) -> FloatArray:
    """Return the horizontal unit vector [3] towards the convex side of a wall that bends in plan."""
    middle = shapely.get_coordinates(shapely.MultiPoint(part.solid.vertices[:, :2]).convex_hull.centroid)[0]
    x, y = part.solid.centroid[:2] - middle
    away = np.array([x, y, 0.0]) if np.hypot(x, y) > NEAR_LEVEL else np.array(part.normal)
    return np.asarray(away / np.linalg.norm(away), dtype=np.float64)


def _spans(part: Part, point: FloatArray) -> bool:
    """Return whether a point [3] lies before or behind a wall, between its ends."""
    return part.start <= float(point @ np.array(part.along)) <= part.start + part.length
