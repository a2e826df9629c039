"""Controls of a mechanism as rocking starts: its reactions, and its uplift multiplier as one would find it by hand.

Reactions at the hinges come from the equilibrium of every block about its hinges. Here the whole mechanism is taken at
once: the sum of its reactions must balance the sum of weights, loads and inertia forces, which are added up from the
list of masses and loads with the uplift multiplier of the oscillator, found by virtual work, or on joints that deform
or crush with that by moments about the hinges moved inwards.

By moments, what lies beyond a hinge is in equilibrium about it. With S the moment of the inertia of all masses at one
g, P the overturning moment of weights and forces, and (H, V) the reaction of the far support at (x_E, z_E):

    lambda S_k + P_k + H (z_E - z_k) - V (x_E - x_k) = 0        for each hinge k but the far support

    one block       lambda = sum(W b) / sum(W h)                                       b, h : lever arms about A
    two blocks      lambda and H : the whole about A, the upper block about B          V = 0, the top slides
    three blocks    lambda, H and V : the whole about A, two blocks about B, the last about C

The outcome of a control of any kind is compared with its tolerance here: made, made without a tolerance, or not made.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from assess.loads.load import Force, Point, PointMass, Tie, pull_at_rest, stretches
from assess.mechanisms.chain import Chain, move, trace_point
from assess.mechanisms.hinge_forces import chain_at_start, hinge_forces
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, note, warning
from assess.oscillator import Branch, HingeForces, Oscillator, linear_multiplier, threshold
from assess.results import Control, ControlKind
from spectra.gravity import g

VERTICAL, HORIZONTAL = "vertical reactions", "horizontal reactions"


def equilibrium_controls(mechanism: Mechanism, oscillator: Oscillator) -> tuple[Control, ...]:
    """Compare the reactions of each branch with weights, loads and inertia; keep those of the governing branch.

    Parameters
    ----------
    mechanism : with its hinges
    oscillator : the mechanism with every action that is there at rest, whose multiplier gives the inertia forces

    Returns
    -------
    Vertical and horizontal, of the branch with the least multiplier, or of one where they differ by more than their
    tolerance; differences are relative to the weight of all masses.
    """
    forces = hinge_forces(mechanism)
    if not forces:
        return tuple(
            control_not_made("equilibrium", mechanism.name, pair, dimension="force", why="control-without-hinges")
            for pair in (VERTICAL, HORIZONTAL)
        )
    of_branches = [
        _branch_controls(mechanism, chain, [pair for pair in forces if pair.branch == branch], multiplier)
        for chain, branch, multiplier in zip(
            (mechanism.positive, mechanism.negative),
            ("positive", "negative"),
            _branch_multipliers(mechanism, oscillator),
            strict=False,
        )
        if chain is not None
    ]
    return tuple(_governing(pair, oscillator) for pair in zip(*of_branches, strict=True))


UPLIFT_MULTIPLIER = "uplift multiplier"


def moment_multiplier(chain: Chain) -> float:
    """Return the multiplier that starts a chain on rigid hinges, by moments [-]; below 0 if it falls by itself."""
    acting, count = _forces_at_rest(chain), len(chain.blocks)
    far_x, far_z = chain.hinges[-1]
    rows, right = np.zeros((count, count)), np.zeros(count)
    for number, (x, z) in enumerate(chain.hinges[:count]):
        beyond = [force for force in acting if force.block >= number]
        rows[number] = [sum(force.inertia_per_g * (force.at[1] - z) for force in beyond), far_z - z, x - far_x][:count]
        right[number] = -sum(
            force.force[0] * (force.at[1] - z) - force.force[1] * (force.at[0] - x) for force in beyond
        )
    return float(np.linalg.solve(rows, right)[0])


def multiplier_control(mechanism: Mechanism, oscillator: Oscillator) -> Control:
    """Compare the oscillator's multiplier with that by moments, on the branch where it is least.

    Parameters
    ----------
    mechanism : with its chains
    oscillator : the mechanism with every action that is there at rest

    Returns
    -------
    Relative to the multiplier by moments; without tolerance where joints deform or crush.
    """
    if mechanism.flexible:
        alone = (
            replace(chain, loads=tuple(each for each in chain.loads if not stretches(each)))
            for chain in mechanism.chains
        )
        sides = list(zip(alone, oscillator.bare.branches, strict=False))
        return _multiplier_on_joints(mechanism, *min(sides, key=lambda each: linear_multiplier(each[1])))
    of_branches = [
        make_control(
            "hand-multiplier",
            mechanism.name,
            UPLIFT_MULTIPLIER,
            value=threshold(side) or 0.0,
            reference=by_hand,
            scale=abs(by_hand),
            dimension="ratio",
            note=note("control-moments", mechanism.name, hinge=hinge),
        )
        for chain, side, hinge in zip(mechanism.chains, oscillator.branches, ("A", "A'"), strict=False)
        if (by_hand := moment_multiplier(chain))
    ]
    return _governing(of_branches, oscillator)


def _governing(of_branches: Sequence[Control], oscillator: Oscillator) -> Control:
    """Return the control of the branch with the least multiplier, or the worst of those that fail."""
    failed = [each for each in of_branches if each.met is False]
    if failed:
        return max(failed, key=lambda control: control.difference or 0.0)
    multipliers = [linear_multiplier(branch) for branch in oscillator.branches]
    return min(zip(of_branches, multipliers, strict=False), key=lambda each: each[1])[0]


@dataclass(frozen=True)
class ForceAtRest:
    """One mass or load at rest.

    block : number of the block it acts on, from 0 at the base; at : its place (x, z) [m]
    force : (x, z) at rest [N]; inertia_per_g : its mass times g, the horizontal force of a multiplier of one [N]
    """

    block: int
    at: Point
    force: Point
    inertia_per_g: float


CONTROL_TOLERANCE: Mapping[ControlKind, float] = {
    "equilibrium": 1e-6,
    "energy": 1e-3,
    "hand-multiplier": 1e-6,
    "convergence": 1e-2,
}
"""The largest relative difference that each kind of control accepts: of rounding, of quadrature, of chaos."""

WARNING_KEYS: Mapping[ControlKind, str] = {
    "equilibrium": "control-not-in-equilibrium",
    "energy": "control-energy-lost",
    "hand-multiplier": "control-other-multiplier",
    "convergence": "control-not-converged",
}
"""The warning of each kind of control that fails."""


def make_control(
    kind: ControlKind,
    mechanism: str,
    quantity: str,
    *,
    value: float,
    reference: float,
    scale: float,
    dimension: str,
    note: Message,
) -> Control:
    """Return a control that was made.

    Parameters
    ----------
    kind : its kind, which decides its tolerance
    mechanism, quantity : what is compared
    value, reference : the program's own value, and that found another way [dimension]
    scale : what the difference is relative to, positive [dimension]
    dimension : dimension of the values
    note : how it was made

    Returns
    -------
    Met if the difference is at most the tolerance.
    """
    difference, tolerance = abs(value - reference) / scale, CONTROL_TOLERANCE[kind]
    return Control(
        kind, mechanism, quantity, value, reference, dimension, difference, tolerance, difference <= tolerance, note
    )


def control_not_made(kind: ControlKind, mechanism: str, quantity: str, *, dimension: str, why: str) -> Control:
    """Return a control that was not made; why: the key of the note that says so."""
    return Control(
        kind, mechanism, quantity, None, None, dimension, None, CONTROL_TOLERANCE[kind], None, note(why, mechanism)
    )


def control_warnings(controls: Sequence[Control]) -> tuple[Message, ...]:
    """Return a warning for each control that failed."""
    return tuple(
        warning(
            WARNING_KEYS[each.kind],
            each.mechanism,
            difference=Quantity(100.0 * each.difference, "percent", 2),
            tolerance=Quantity(100.0 * each.tolerance, "percent", 2),
        )
        for each in controls
        if each.met is False and each.difference is not None
    )


def _branch_multipliers(mechanism: Mechanism, oscillator: Oscillator) -> tuple[float, float | None]:
    """Return the multiplier of each branch: of the oscillator, or on joints by moments about the moved hinges [-]."""
    if not mechanism.flexible:
        other = oscillator.negative
        return threshold(oscillator.positive) or 0.0, None if other is None else threshold(other)
    positive, *others = (moment_multiplier(chain_at_start(chain, name=mechanism.name)) for chain in mechanism.chains)
    return positive, others[0] if others else None


def _branch_controls(
    mechanism: Mechanism, chain: Chain, forces: Sequence[HingeForces], multiplier: float | None
) -> tuple[Control, Control]:
    """Return the controls of one branch, in its own sign: vertical and horizontal."""
    acting = _forces_at_rest(chain_at_start(chain, name=mechanism.name))
    weight = sum(each.inertia_per_g for each in acting)
    inertia = (multiplier or 0.0) * weight
    horizontal, vertical = _sum_of_reactions(forces, blocks=len(chain.blocks))
    how = note(
        "control-reactions",
        mechanism.name,
        hinge=forces[0].hinge,
        multiplier=Quantity(multiplier or 0.0, "ground acceleration", 4),
    )
    downward, onward = -sum(each.force[1] for each in acting), -sum(each.force[0] for each in acting) - inertia
    pairs = ((VERTICAL, vertical, downward), (HORIZONTAL, horizontal, onward))
    one, other = (
        make_control(
            "equilibrium",
            mechanism.name,
            quantity,
            value=value,
            reference=reference,
            scale=weight,
            dimension="force",
            note=how,
        )
        for quantity, value, reference in pairs
    )
    return one, other


def _sum_of_reactions(forces: Sequence[HingeForces], *, blocks: int) -> tuple[float, float]:
    """Return the sum of the reactions of supports (x, z) on the mechanism [N].

    Parameters
    ----------
    forces : of one branch, from the base on
    blocks : one block stands on A; two are also held at C, along the direction only; three also stand on D
    """
    base, far = forces[0], forces[-1]
    horizontal, vertical = base.horizontal, base.vertical
    if blocks > 1:
        horizontal += far.horizontal
    if blocks > 2:
        vertical += far.vertical
    return horizontal, vertical


def _multiplier_on_joints(mechanism: Mechanism, chain: Chain, side: Branch) -> Control:
    """Return the largest multiplier on joints beside that of rigid hinges, which need not be equal."""
    value, rigid = linear_multiplier(side), moment_multiplier(chain)
    how = note("control-rigid-moments", mechanism.name, lower=Quantity(100.0 * (1.0 - value / rigid), "percent", 2))
    difference = abs(value - rigid) / abs(rigid)
    return Control(
        "hand-multiplier", mechanism.name, UPLIFT_MULTIPLIER, value, rigid, "ratio", difference, 0.0, None, how
    )


def _forces_at_rest(chain: Chain) -> list[ForceAtRest]:
    """Return every mass and load of a chain.

    A mass that is not bearing has horizontal inertia and no weight here, as all have that are seen from above; a tie
    that shortens as rocking starts is slack, unless it acts both ways or stretches, with a pretension to lose.
    """
    down = 0.0 if chain.level else -1.0
    forces = [
        ForceAtRest(number, block.centroid, (0.0, down * block.mass * g), block.mass * g)
        for number, block in enumerate(chain.blocks)
    ]
    for load in chain.loads:
        if isinstance(load, PointMass):
            weight = load.mass * g
            forces.append(ForceAtRest(load.block, load.at, (0.0, down * weight if load.bearing else 0.0), weight))
        elif isinstance(load, Force):
            forces.append(ForceAtRest(load.block, load.at, load.force, 0.0))
        elif load.both or stretches(load) or not _shortens(load, chain):
            forces.append(ForceAtRest(load.block, load.at, pull_at_rest(load), 0.0))
    return forces


def _shortens(tie: Tie, chain: Chain) -> bool:
    """Return whether the point of a tie starts to move along its pull."""
    along, up = pull_at_rest(tie)
    leaving = trace_point(move(chain, np.zeros(1)), block=tie.block, at=tie.at)
    return bool(along * leaving.dx[0] + up * leaving.dz[0] > 0.0)
