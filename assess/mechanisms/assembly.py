"""The steps that all kinds of mechanism share: checks and warnings, restitution, and joints under the hinges."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any, Literal

import numpy as np
import shapely

from assess.geometry.cut import Piece
from assess.geometry.planar import Outline, base_of_section, lowest_corners, slope_across, turns_about_a_corner
from assess.geometry.solid import Solid
from assess.loads.load import Place, Point, point_in_plane
from assess.mechanisms.chain import (
    Chain,
    Joint,
    hinge_names,
    point_values,
    require_movable,
    require_stable,
    top_loads,
    virtual_work,
)
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.mechanisms.hinge_forces import hinge_compressions
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.mechanisms.restitution import (
    GIVEN,
    ImpactRules,
    RestitutionChoice,
    RestitutionCoefficient,
    find_restitution,
)
from assess.messages.message import Message, Quantity, Term, distinct, lengths, message, warning, whole_number


@dataclass(frozen=True, kw_only=True)
class MechanismKind:
    """What is particular to one kind of mechanism: declared once, beside its constructor; see `MECHANISM_KINDS`.

    definition : what an engineer states of it; it bears the name of the kind
    build : from the name of a mechanism, its definition, its pieces of masonry and its loads, on rigid hinges
    impacts : its rules of restitution
    support : how the masonry is held: free above its base, spanning between supports, or hinged to other blocks
    direction_sought : whether its weakest direction is found where none is given
    turns_on_base : whether it turns at the edges of its base or cut, by which alone directions are compared
    rocks : whether it comes back and what its impacts leave is known; else no history of it is answered
    """

    definition: type[Any]
    build: Callable[..., MechanismPieces]
    impacts: ImpactRules
    support: Literal["free", "spanning", "hinged"]
    direction_sought: bool = False
    turns_on_base: bool = False
    rocks: bool = True

    @property
    def name(self) -> str:
        """The kind, as project files write it."""
        name: str = self.definition.kind
        return name


MechanismPieces = tuple[Mechanism, Sequence[Piece]]
"""A mechanism, and the piece of masonry of each of its outlines."""


def assemble(
    name: str,
    kind: MechanismKind,
    positive: Chain,
    negative: Chain | None,
    *,
    label: str,
    restitution: tuple[RestitutionChoice, RestitutionChoice],
    outlines: tuple[Outline, ...],
    warnings: Iterable[Message] = (),
) -> Mechanism:
    """Assemble a mechanism from its chains, with its coefficients of restitution.

    Parameters
    ----------
    name : as in the project file
    kind : of mechanism
    positive, negative : the chain of each branch in its own sign; negative None for one-sided rocking
    label : for reports; empty: the name
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind
    outlines : of each block in the plane of motion
    warnings : on what was given

    Raises
    ------
    MechanismError : a chain that cannot move or already falls, or a rule of restitution that does not apply
    """
    chains, given = {"": positive} if negative is None else {"": positive, "'": negative}, tuple(warnings)
    for chain in chains.values():
        require_movable(chain, name=name)
        require_stable(chain, name=name, beside=hinge_beside(given))
    pulling = [text for mark, chain in chains.items() for text in _supports_in_tension(chain, mark=mark)]
    kept, back = _find_restitutions(restitution, positive, negative, rules=kind.impacts, kind=kind.name, name=name)
    return Mechanism(
        name=name,
        label=label or name,
        kind=kind.name,
        rules=kind.impacts,
        sides="one" if negative is None else "two",
        positive=positive,
        negative=negative,
        restitution=(kept.value, back.value),
        restitution_source_parts=_sources(kept, back),
        elevation=positive.hinges[0][1],
        outlines=outlines,
        warnings=(*given, *pulling, *_impact_warnings(kept, back)),
        stopped=_least_stopped(kept, back),
        rebounds=kept.range,
        rocks=kind.rocks,
    )


def add_joints(
    mechanism: Mechanism,
    positive: tuple[Joint | None, ...],
    negative: tuple[Joint | None, ...],
    *,
    restitution: tuple[RestitutionChoice, RestitutionChoice],
) -> Mechanism:
    """Put a rigid mechanism on joints.

    Its impacts are those of blocks rotating about fixed hinges, a_SF inside the edges (thesis 6.60, 6.67, 6.72): they
    keep the same share of the energy.

    Parameters
    ----------
    mechanism : on rigid hinges
    positive, negative : the joint under each hinge of each branch, in its own sign; None where the hinge stays rigid
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind

    Raises
    ------
    MechanismError, InterfaceError : a joint that cannot carry the force on it
    """
    name, kind, rules = mechanism.name, mechanism.kind, mechanism.rules
    front = replace(mechanism.positive, joints=_bearing_joints(mechanism.positive, positive))
    back = mechanism.negative and replace(mechanism.negative, joints=_bearing_joints(mechanism.negative, negative))
    ahead, behind = FlexibleChain(front, name), FlexibleChain(back, name) if back else None
    fixed = _find_restitutions(
        restitution,
        ahead.fixed_hinge_chain,
        behind.fixed_hinge_chain if behind else None,
        rules=rules,
        kind=kind,
        name=name,
    )
    kept, returned = _adjust_to_moving_hinges(fixed, ahead, behind)
    rigid = _find_restitutions(restitution, mechanism.positive, mechanism.negative, rules=rules, kind=kind, name=name)
    before = _impact_warnings(*rigid)
    others = [each for each in mechanism.warnings if each not in before]
    stiff = all(joint is None or joint.model == "rigid" for joint in (*positive, *negative))
    about = CRUSHED if stiff else INSIDE
    return replace(
        mechanism,
        positive=front,
        negative=back,
        restitution=(kept.value, returned.value),
        restitution_source_parts=_sources(kept, returned, *_hinge_points(kept, about)),
        warnings=(*others, *_impact_warnings(kept, returned)),
        stopped=_least_stopped(kept, returned),
        rebounds=kept.range,
    )


def common_arguments(definition: BlockMechanism) -> dict[str, Any]:
    """Return what every kind of chain takes unchanged."""
    return {
        "label": definition.label,
        "sides": "two" if definition.two_sided else "one",
        "restitution": definition.restitution.choices,
    }


def hinges_in_plane(hinges: Sequence[Place] | None, definition: BlockMechanism) -> Any:
    """Return hinges A, B, … as (distance along the direction from the origin, elevation) [m]; None if not given.

    Parameters
    ----------
    hinges : as an engineer states them: x, y, z or distance and elevation [m]
    definition : whose direction spans the plane
    """
    if hinges is None:
        return None
    points: tuple[Point, ...] = tuple(point_in_plane(at, definition.towards) for at in hinges)
    return points


NEAR = 0.01  # of the size of a block: a hinge this far outside it still touches it
TOUCH = 0.01  # m: blocks this near each other touch, as joints are no thicker
OUTSIDE = 0.05  # of the width of a base or block: a hinge farther beside it is none


class HingeBeside(StrEnum):
    """The keys of warnings on hinges beside their contacts.

    A project that states such a hinge is refused; one that a variation of its numbers moves there is not
    (`assess.model.directions`).
    """

    BASE = "hinge-beside-base"
    BLOCK = "hinge-beside-block"
    CONTACT = "hinge-beside-contact"


def hinge_beside(warnings: Iterable[Message]) -> str:
    """Return the text of the first warning on a hinge beside its contact; empty if there is none."""
    return next((each.text for each in warnings if each.key in frozenset(HingeBeside)), "")


def loose_hinges(hinges: Sequence[Point], outlines: Sequence[Outline], *, mark: str = "") -> Iterator[Message]:
    """Yield a warning for each hinge, counted from the base, that does not touch a block it joins.

    Blocks touch in their contact, so that a hinge outside either is outside their contact. Blocks that do not touch
    have none: that the drawing contradicts itself is told elsewhere (`assess.model.bodies.contradictions_of_blocks`).
    """
    areas = [shapely.union_all([shapely.Polygon(ring) for ring in rings]) for rings in outlines]
    for number, (hinge_name, hinge) in enumerate(zip("ABCD", hinges, strict=False)):
        joined = [block for block in (number - 1, number) if 0 <= block < len(areas) and not areas[block].is_empty]
        apart = len(joined) > 1 and areas[joined[0]].distance(areas[joined[1]]) > TOUCH
        for block in joined:
            gap = float(areas[block].distance(shapely.Point(hinge)))
            if gap > NEAR * float(areas[block].length) / 4.0:
                away, number_of_block = Quantity(gap, "length", 3), whole_number(block)
                named = f"{hinge_name}{mark}"
                values = {"hinge": named, "gap": away, "block": number_of_block, **point_values(hinge)}
                if apart or gap <= OUTSIDE * _thickness(areas[block]):
                    yield warning("loose-hinge", **values)
                    continue
                nearest = shapely.get_coordinates(shapely.shortest_line(areas[block], shapely.Point(hinge)))[0]
                yield warning(HingeBeside.BLOCK, **values, **lengths(near_x=nearest[0], near_z=nearest[1]))


def _thickness(area: shapely.Geometry) -> float:
    """Return the shorter side of the rectangle about a block [m]."""
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(area))
    return float(np.linalg.norm(np.diff(corners[:3], axis=0), axis=1).min())


ASKEW = "askew"
LEVEL_RISE = 0.01  # m: an extreme line that rises by less is level
UNEVEN = 0.05  # of its width: by how much a base may be narrower than the body just above it


def hinge_warnings(piece: Piece, direction: Sequence[float]) -> Iterator[Message]:
    """Warn if a hinge taken from the geometry is a corner, so that a wall may stand askew, or is not level."""
    if piece.foot is None:
        return
    if turns_about_a_corner(piece.foot, direction=direction):
        yield warning(ASKEW)
    rise = slope_across(piece.foot, direction=direction) if piece.cut else 0.0
    if rise > LEVEL_RISE:
        yield warning("cut-slopes", rise=Quantity(rise, "length", 3))
    if not piece.cut:
        yield from _uneven_base_warnings(piece.solids, direction)


Impacts = tuple[RestitutionCoefficient, RestitutionCoefficient]
INSIDE = Term("about hinges a_SF inside the edges")
CRUSHED = Term("about the resultants of the crushed joints")


def _adjust_to_moving_hinges(found: Impacts, front: FlexibleChain, back: FlexibleChain | None) -> Impacts:
    """Convert coefficients about fixed hinges to the inertia with which the branches begin, at equal shares of energy.

    On joints in full contact both branches begin about the same point, so that none can exceed 1.
    """
    if back is None:
        return found
    works = [chain.solve_equilibrium(np.zeros(1)).work for chain in (front, back)]
    leaning = [work for work in works if work.restoring[0] < 0.0]  # both branches begin at its equilibrium
    own = [(leaning if len(leaning) == 1 else [work])[0].inertia[0] for work in works]
    fixed = [virtual_work(chain.fixed_hinge_chain, np.zeros(1)).inertia[0] for chain in (front, back)]
    faster = float(np.sqrt(own[0] / own[1] * fixed[1] / fixed[0]))
    return _scale(found[0], faster), _scale(found[1], 1.0 / faster)


def _scale(kept: RestitutionCoefficient, factor: float) -> RestitutionCoefficient:
    """Return a coefficient times a factor, without the warning for values above 1 if it is no longer above."""
    if kept.source == GIVEN:
        return kept
    value = kept.value * factor
    return replace(kept, value=value, warning=kept.warning if value > 1.0 or kept.value <= 1.0 else None)


def _bearing_joints(chain: Chain, joints: tuple[Joint | None, ...]) -> tuple[Joint | None, ...]:
    """Return the joints, without the one at the top of a wall if no load comes through it."""
    return (*joints[:2], None) if len(chain.blocks) == 2 and not top_loads(chain) else joints


def _find_restitutions(
    choices: tuple[RestitutionChoice, RestitutionChoice],
    positive: Chain,
    negative: Chain | None,
    *,
    rules: ImpactRules,
    kind: str,
    name: str,
) -> Impacts:
    """Return the coefficients of the impacts that end the positive and the negative branch."""
    kept = find_restitution(choices[0], ending=positive, starting=negative, rules=rules, kind=kind, name=name)
    if negative is None:
        return kept, kept
    return kept, find_restitution(choices[1], ending=negative, starting=positive, rules=rules, kind=kind, name=name)


def _least_stopped(positive: RestitutionCoefficient, negative: RestitutionCoefficient) -> float | None:
    """Return the least of the negative coefficients, None if both impacts leave a velocity."""
    return min((each.stopped for each in (positive, negative) if each.stopped is not None), default=None)


def _sources(
    positive: RestitutionCoefficient, negative: RestitutionCoefficient, *about: Term
) -> tuple[Term | Message, ...]:
    """Return the source of both coefficients, in parts."""
    if positive.source == negative.source:
        return (*positive.source, *about)
    ahead = (message("restitution-positive", {"source": each}) for each in positive.source)
    behind = (message("restitution-negative", {"source": each}) for each in negative.source)
    return (*ahead, *behind, *about)


def _impact_warnings(*found: RestitutionCoefficient) -> tuple[Message, ...]:
    """Return the warnings on the coefficients, each once."""
    return distinct(each.warning for each in found if each.warning is not None)


def _hinge_points(kept: RestitutionCoefficient, about: Term) -> tuple[Term, ...]:
    """Return about which points a mechanism on joints turns, nothing where the coefficient is given."""
    return () if kept.source == GIVEN else (about,)


def _supports_in_tension(chain: Chain, *, mark: str = "") -> Iterator[Message]:
    """Yield a warning for each hinge on the ground that would be in tension at incipient motion."""
    for hinge_name, force in zip(hinge_names(chain), hinge_compressions(chain), strict=True):
        if hinge_name in "AD" and force < 0.0:
            yield warning("hinge-in-tension", hinge=f"{hinge_name}{mark}", pull=Quantity(-force, "force"))


def _uneven_base_warnings(solids: Sequence[Solid], direction: Sequence[float]) -> Iterator[Message]:
    """Warn of an uneven base: its lowest face is much narrower than the body just above."""
    faces = (lowest_corners(solids), lowest_corners(solids, within=LEVEL_RISE))
    ends = [base_of_section(face, direction=direction) for face in faces]
    width, wide = (high[0] - low[0] for low, high in ends)
    if width < (1.0 - UNEVEN) * wide:
        narrow, whole_width = (Quantity(each, "length", 3) for each in (width, wide))
        yield warning("uneven-base", width=narrow, wide=whole_width, above=Quantity(LEVEL_RISE, "short length", 3))
