"""One block rocking about the edges of its base (thesis 3.2.1), and what both kinds of single block share."""

from __future__ import annotations

from math import atan2, cos, hypot, isclose, sin
from typing import Literal

from assess.errors import MechanismError
from assess.geometry.planar import PlanarBody
from assess.loads import Load, PointMass
from assess.loads import mirrored as mirrored_load
from assess.mechanisms.chain import Block, Chain, Point, mirrored, mirrored_blocks
from assess.mechanisms.mechanism import Mechanism, Sides
from assess.oscillator import SingleBlock
from assess.restitution import Restitution, Rule, one_sided, two_sided

RestitutionChoice = float | Literal["thesis", "housner", "sorrentino", "momentum"]


def single_block(
    name: str,
    body: PlanarBody,
    *,
    label: str = "",
    sides: Sides = "two",
    hinge: Point | None = None,
    hinge_negative: Point | None = None,
    loads: tuple[Load, ...] = (),
    restitution: tuple[RestitutionChoice, RestitutionChoice] = ("thesis", "thesis"),
) -> Mechanism:
    """The mechanism of `body` turning about `hinge` (positive) and `hinge_negative`, default the edges of its base.

    Raises MechanismError without a base, for a base of no width and for a block that is already falling.
    """
    if sides == "one" and hinge_negative is not None:
        raise MechanismError(f'mechanism "{name}": hinges_negative with sides = "one"; remove one of them')
    block = Block(body.mass, body.centroid, body.inertia)
    positive = Chain((block,), (hinge or _edge(body, "positive", name=name),), loads)
    _require_stable(positive, name=name, towards="positive")
    negative = None
    if sides == "two":
        other = hinge_negative or _edge(body, "negative", name=name)
        negative = Chain(mirrored_blocks((block,)), (mirrored(other),), tuple(mirrored_load(load) for load in loads))
        _require_stable(negative, name=name, towards="negative")
    return assembled(
        name,
        "single-block",
        positive,
        negative,
        label=label,
        restitution=restitution,
        outlines=body.outline,
        notices=tuple(_off_base(body, hinge, "A") + _off_base(body, hinge_negative, "A'")),
    )


def _require_stable(chain: Chain, *, name: str, towards: str) -> None:
    """Raise MechanismError unless the block with what it carries stands: its centroid above its hinge and behind it."""
    block = plain_block(chain)
    behind, height = block.radius * sin(block.slenderness), block.radius * cos(block.slenderness)
    if height <= 0:
        raise MechanismError(
            f'mechanism "{name}": the centroid lies {-height:.4g} m below the hinge of {towards} rotation; '
            "a rocking block has its centroid above the hinge: check hinges and cut"
        )
    if behind <= 0:
        raise MechanismError(
            f'mechanism "{name}": already falling in {towards} rotation: the centroid lies {-behind:.4g} m beyond '
            "the hinge; check the geometry, the direction, the hinges and the loads"
        )


def _off_base(body: PlanarBody, hinge: Point | None, label: str) -> list[str]:
    """A sentence where a given hinge does not lie on the body's base."""
    if hinge is None or body.base is None:
        return []
    low, high = body.base
    width = high[0] - low[0]
    tolerance = 0.01 * width
    elevation = low[1] + (hinge[0] - low[0]) * (high[1] - low[1]) / (width or 1.0)
    if low[0] - tolerance <= hinge[0] <= high[0] + tolerance and abs(hinge[1] - elevation) <= tolerance:
        return []
    return [
        f"hinge {label} at ({hinge[0]:.4g}, {hinge[1]:.4g}) m is not on the base of the body, which reaches from "
        f"({low[0]:.4g}, {low[1]:.4g}) to ({high[0]:.4g}, {high[1]:.4g}) m; the whole body turns about it all the same"
    ]


def _edge(body: PlanarBody, towards: Literal["positive", "negative"], *, name: str) -> Point:
    if body.base is None:
        raise MechanismError(
            f'mechanism "{name}": its body has no geometry, so its base is not known; '
            "give hinges = { A = [x, z] } and, for two-sided rocking, hinges_negative = { A = [x, z] }"
        )
    low, high = body.base
    width = high[0] - low[0]
    if width <= 1e-6 * hypot(body.centroid[0] - low[0], body.centroid[1] - low[1]):
        raise MechanismError(
            f'mechanism "{name}": the body touches the ground on an edge or a point (width {width:.3g} m), '
            "so it has no base to rock on; give hinges, or mend the geometry"
        )
    return high if towards == "positive" else low


def assembled(
    name: str,
    kind: str,
    positive: Chain,
    negative: Chain | None,
    *,
    label: str,
    restitution: tuple[RestitutionChoice, RestitutionChoice],
    outlines: tuple[tuple[Point, ...], ...],
    notices: tuple[str, ...] = (),
) -> Mechanism:
    """The mechanism of one block's chains with its coefficients of restitution resolved."""
    first, second = plain_block(positive), None if negative is None else plain_block(negative)
    kept = impact(restitution[0], ending=first, starting=second, name=name)
    kept_negative = kept if second is None else impact(restitution[1], ending=second, starting=first, name=name)
    return Mechanism(
        name=name,
        label=label or name,
        kind=kind,
        sides="one" if negative is None else "two",
        positive=positive,
        negative=negative,
        restitution=(kept.value, kept_negative.value),
        restitution_source=_sources(kept, kept_negative),
        elevation=positive.hinges[0][1],
        outlines=outlines,
        notices=(*notices, *sorted({kept.notice, kept_negative.notice} - {""})),
    )


def _sources(positive: Restitution, negative: Restitution) -> str:
    if positive.source == negative.source:
        return positive.source
    return f"positive: {positive.source}; negative: {negative.source}"


def plain_block(chain: Chain) -> SingleBlock:
    """Mass, radius, slenderness and inertia about the hinge of a chain of one block with its bearing masses.

    This is what an impact knows of it: masses that are not bearing, and given forces, have no part in its momentum.
    """
    (block,), (hinge,) = chain.blocks, chain.hinges
    carried = [load for load in chain.loads if isinstance(load, PointMass) and load.bearing]
    points = [(block.mass, block.centroid), *((load.mass, load.at) for load in carried)]
    arms = [(mass, hinge[0] - at[0], at[1] - hinge[1]) for mass, at in points]
    total = sum(mass for mass, _, _ in arms)
    behind, height = (sum(arm[0] * arm[i] for arm in arms) / total for i in (1, 2))
    about_hinge = block.inertia + sum(mass * (b**2 + h**2) for mass, b, h in arms)
    return SingleBlock(total, hypot(behind, height), atan2(behind, height), about_hinge)


def impact(choice: RestitutionChoice, *, ending: SingleBlock, starting: SingleBlock | None, name: str) -> Restitution:
    """The coefficient chosen for the impact that ends one branch; `starting` is None for one-sided rocking.

    "thesis" is Sorrentino's for one-sided and Housner's (3.44) for two-sided rocking. 3.44 keeps the angular momentum
    about the new hinge of a symmetric block; where the two hinges differ it would even add energy (tested), so there
    the same principle is applied to the block as it is: "momentum".
    """
    if not isinstance(choice, str):
        return Restitution(choice, "given")
    if starting is None:
        return one_sided("sorrentino" if choice == "thesis" else choice, block=ending, name=name)
    symmetric = isclose(ending.slenderness, starting.slenderness, rel_tol=1e-9) and isclose(
        ending.radius, starting.radius, rel_tol=1e-9
    )
    rule: Rule = choice if choice != "thesis" else "housner" if symmetric else "momentum"
    return two_sided(rule, ending=ending, starting=starting, name=name)
