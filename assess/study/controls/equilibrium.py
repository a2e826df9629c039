"""Reactions at the hinges against everything that acts on the masonry as rocking starts.

The reactions come from the equilibrium of every block about its hinges. Here the whole mechanism is taken at once: the
sum of its reactions must balance the sum of weights, loads and inertia forces, which are added up from the list of
masses and loads with the uplift multiplier of the oscillator, found by virtual work, or on joints that deform or crush
with that by moments about the hinges moved inwards.
"""

from __future__ import annotations

from collections.abc import Sequence

from assess.hinge_forces import HingeForces
from assess.mechanisms.chain import Chain
from assess.mechanisms.hinge_forces import chain_at_start, hinge_forces
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Quantity, note
from assess.oscillator import Oscillator, threshold
from assess.results import Control
from assess.study.controls.acting import acting_on
from assess.study.controls.hand_multiplier import moment_multiplier
from assess.study.controls.outcome import made, not_made

VERTICAL, HORIZONTAL = "vertical reactions", "horizontal reactions"


def equilibrium_controls(mechanism: Mechanism, oscillator: Oscillator) -> tuple[Control, ...]:
    """Compare the reactions of each branch with weights, loads and inertia; keep the worse branch of each direction.

    Parameters
    ----------
    mechanism : Mechanism
        With its hinges.
    oscillator : Oscillator
        The mechanism with every action that is there at rest, whose multiplier gives the inertia forces.

    Returns
    -------
    tuple of Control
        Vertical and horizontal; differences are relative to the weight that shakes.
    """
    forces = hinge_forces(mechanism)
    if not forces:
        return tuple(
            not_made("equilibrium", mechanism.name, each, dimension="force", why="control-without-hinges")
            for each in (VERTICAL, HORIZONTAL)
        )
    found = [
        of_branch(mechanism, chain, [each for each in forces if each.branch == branch], multiplier)
        for chain, branch, multiplier in zip(
            (mechanism.positive, mechanism.negative),
            ("positive", "negative"),
            multipliers(mechanism, oscillator),
            strict=False,
        )
        if chain is not None
    ]
    return tuple(max(each, key=lambda one: one.difference or 0.0) for each in zip(*found, strict=True))


def multipliers(mechanism: Mechanism, oscillator: Oscillator) -> tuple[float, float | None]:
    """Return the multiplier of each branch: of the oscillator, or on joints by moments about the moved hinges [-]."""
    if not mechanism.flexible:
        other = oscillator.negative
        return threshold(oscillator.positive) or 0.0, None if other is None else threshold(other)
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    positive, *others = (moment_multiplier(chain_at_start(chain, name=mechanism.name)) for chain in chains)
    return positive, others[0] if others else None


def of_branch(
    mechanism: Mechanism, chain: Chain, forces: Sequence[HingeForces], multiplier: float | None
) -> tuple[Control, Control]:
    """Return the controls of one branch, in its own sign: vertical and horizontal."""
    acting = acting_on(chain_at_start(chain, name=mechanism.name))
    weight = sum(each.shaken for each in acting)
    inertia = (multiplier or 0.0) * weight
    horizontal, vertical = reactions(forces, blocks=len(chain.blocks))
    said = note(
        "control-reactions",
        mechanism.name,
        hinge=forces[0].hinge,
        multiplier=Quantity(multiplier or 0.0, "ground acceleration", 4),
    )
    downward, onward = -sum(each.force[1] for each in acting), -sum(each.force[0] for each in acting) - inertia
    pairs = ((VERTICAL, vertical, downward), (HORIZONTAL, horizontal, onward))
    one, other = (
        made(
            "equilibrium",
            mechanism.name,
            quantity,
            value=value,
            reference=reference,
            scale=weight,
            dimension="force",
            note=said,
        )
        for quantity, value, reference in pairs
    )
    return one, other


def reactions(forces: Sequence[HingeForces], *, blocks: int) -> tuple[float, float]:
    """Return the sum of the reactions of supports (x, z) on the mechanism [N].

    Parameters
    ----------
    forces : sequence of HingeForces
        Of one branch, from the base on.
    blocks : int
        One block stands on A; two are also held at C, along the direction only; three also stand on D.
    """
    base, far = forces[0], forces[-1]
    horizontal, vertical = base.horizontal, base.vertical
    if blocks > 1:
        horizontal += far.horizontal
    if blocks > 2:
        vertical += far.vertical
    return horizontal, vertical
