"""The uplift multiplier by moments about the hinges, as one would find it by hand.

What lies beyond a hinge is in equilibrium about it. With S the moment of all masses shaken at one g, P the overturning
moment of weights and forces, and (H, V) the reaction of the far support at (x_E, z_E):

    lambda S_k + P_k + H (z_E - z_k) - V (x_E - x_k) = 0        for each hinge k but the far support

    one block       lambda = sum(W b) / sum(W h)                                       b, h : lever arms about A
    two blocks      lambda and H : the whole about A, the upper block about B          V = 0, the top slides
    three blocks    lambda, H and V : the whole about A, two blocks about B, the last about C
"""

from __future__ import annotations

import numpy as np

from assess.mechanisms.chain import Chain
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Quantity, note
from assess.oscillator import Branch, Oscillator, linear_multiplier, threshold
from assess.results import Control
from assess.study.controls.acting import acting_on
from assess.study.controls.outcome import made

QUANTITY = "uplift multiplier"


def moment_multiplier(chain: Chain) -> float:
    """Return the multiplier that starts a chain on rigid hinges, by moments [-]; below 0 if it falls by itself."""
    acting, count = acting_on(chain), len(chain.blocks)
    far_x, far_z = chain.hinges[-1]
    rows, right = np.zeros((count, count)), np.zeros(count)
    for number, (x, z) in enumerate(chain.hinges[:count]):
        beyond = [each for each in acting if each.block >= number]
        rows[number] = [sum(each.shaken * (each.at[1] - z) for each in beyond), far_z - z, x - far_x][:count]
        right[number] = -sum(each.force[0] * (each.at[1] - z) - each.force[1] * (each.at[0] - x) for each in beyond)
    return float(np.linalg.solve(rows, right)[0])


def multiplier_control(mechanism: Mechanism, oscillator: Oscillator) -> Control:
    """Compare the oscillator's multiplier with that by moments, on the branch where they differ most.

    Parameters
    ----------
    mechanism : Mechanism
        With its chains.
    oscillator : Oscillator
        The mechanism with every action that is there at rest.

    Returns
    -------
    Control
        Relative to the multiplier by moments; without tolerance where joints deform or crush.
    """
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    if mechanism.flexible:
        return _on_joints(mechanism, chains[0], oscillator.positive)
    found = [
        made(
            "hand-multiplier",
            mechanism.name,
            QUANTITY,
            value=threshold(side) or 0.0,
            reference=by_hand,
            scale=abs(by_hand),
            dimension="ratio",
            note=note("control-moments", mechanism.name, hinge=hinge),
        )
        for chain, side, hinge in zip(chains, oscillator.branches, ("A", "A'"), strict=False)
        if (by_hand := moment_multiplier(chain))
    ]
    return max(found, key=lambda one: one.difference or 0.0)


def _on_joints(mechanism: Mechanism, chain: Chain, side: Branch) -> Control:
    """Return the largest multiplier on joints beside that of rigid hinges, which need not be equal."""
    value, rigid = linear_multiplier(side), moment_multiplier(chain)
    said = note("control-rigid-moments", mechanism.name, lower=Quantity(100.0 * (1.0 - value / rigid), "percent", 2))
    difference = abs(value - rigid) / abs(rigid)
    return Control("hand-multiplier", mechanism.name, QUANTITY, value, rigid, "ratio", difference, 0.0, None, said)
