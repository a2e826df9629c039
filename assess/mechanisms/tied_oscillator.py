"""Mechanisms with ties that stretch: their curve on the first way out, and what their histories remember.

On rigid hinges the table of a mechanism is that without its ties, to which each adds N de/dphi. On joints that deform
it counts from a rest to which the pretension leans it. So the table is made with each tie pulling by its pretension
alone, and what its force has more of is added over the rotation of the block, as on rigid hinges: a joint sinks square
to the pull of a level tie, which neither lengthens it nor presses on the joint.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from math import radians, sin

import numpy as np

from assess.errors import MechanismError
from assess.loads.load import Tie, length_to_anchor, stretches
from assess.mechanisms.branch_table import Stages, staged_branch
from assess.mechanisms.chain import Chain, ChainPair, move, trace_point
from assess.mechanisms.flexible_oscillator import flexible_oscillator
from assess.oscillator import Branch, Memory, Oscillator, TieLaw
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

LEVEL = sin(radians(10.0))  # of the pull of a tie on joints that deform: up, over its length
AT_ONE = 1e-9  # rad, m: rotations and elongations this near are one
NEVER = -1.0  # m: elongation of a tie that one side does not have


def stretching_ties(stages: Stages) -> dict[str, Tie]:
    """Return the ties that stretch and are there at rest, by their names."""
    actions = stages[0].chain.actions
    return {each.name: each for each in actions if stretches(each)}


def tie_laws(ties: Sequence[Tie], elongation: Sequence[Sequence[tuple[FloatArray, FloatArray]]]) -> tuple[TieLaw, ...]:
    """Return the laws of ties.

    Parameters
    ----------
    ties : that stretch
    elongation : of each from rest and its derivative over rotation, on each side [ties][sides], [n] [m], [n] [m/rad]
    """
    found = []
    for tie, sides in zip(ties, elongation, strict=True):
        k = tie.stiffness or 1.0
        at_rest = tie.tension / k - tie.slack
        found.append(
            TieLaw(
                k,
                tie.most,
                at_rest + (tie.elongation or 0.0),
                tuple(e if (e <= NEVER).all() else at_rest + e for e, _ in sides),
                tuple(rate for _, rate in sides),
            )
        )
    return tuple(found)


def stretch(name: str, chain: Chain, other: Chain | None, rotation: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the elongation of a tie from rest [n] [m] and its derivative over rotation [n] [m/rad].

    Parameters
    ----------
    name : of the tie
    chain, other : of this side and of the other one, each in its own sign
    rotation : from the geometry, in the sign of `chain`; below 0 the other chain turns [n] [rad]
    """
    e, rate = np.full_like(rotation, NEVER), np.zeros_like(rotation)
    for here, of, sign in ((rotation >= 0.0, chain, 1.0), (rotation < 0.0, other, -1.0)):
        tie = None if of is None else next((each for each in of.actions if each.name == name), None)
        if of is None or not here.any() or not isinstance(tie, Tie) or tie.anchor is None:
            continue
        path = trace_point(move(of, np.r_[0.0, sign * rotation[here]]), block=tie.block, at=tie.at)
        to_x, to_z = tie.anchor[0] - path.x, tie.anchor[1] - path.z
        far = length_to_anchor(tie, to_x, to_z)
        e[here] = (far - far[0])[1:]
        rate[here] = -sign * ((to_x * path.dx + to_z * path.dz) / far)[1:]
    return e, rate


def memory_of_ties(ties: Mapping[str, Tie], bare: Oscillator, chains: Sequence[Chain]) -> Memory:
    """Return what histories remember of ties on rigid hinges.

    Parameters
    ----------
    ties : that stretch, by their names
    bare : the oscillator without them
    chains : of each of its branches, with them
    """
    sides = list(zip(chains, bare.branches, strict=True))
    found = [[stretch(name, chain, None, branch.rotation) for chain, branch in sides] for name in ties]
    return Memory(bare, tie_laws(list(ties.values()), found))


def oscillator_on_joints(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of one block on joints that deform, with ties that stretch.

    Parameters
    ----------
    pair : the chains of both directions
    front, back : the stages of the positive and of the negative chain; back is ignored for one-sided rocking

    Raises
    ------
    MechanismError : more than one block, or a tie that is not level
    """
    ties = stretching_ties(front) | stretching_ties(back)
    steep = [name for name, tie in ties.items() if not _is_level(tie)]
    if len(pair.positive.blocks) > 1 or steep:
        which = f"{', '.join(steep)} is no such tie" if steep else "this mechanism has more blocks"
        raise MechanismError(
            f'mechanism "{pair.name}": on joints that deform a tie that stretches is followed where it holds a single '
            f'block and is level within 10 degrees, and {which}; give it a constant force, or write model = "rigid"'
        )
    leaning = flexible_oscillator(pair, _pulling(front, ties), _pulling(back, ties))
    chains = [front[0].chain, None if pair.negative is None else back[0].chain]
    sides = [
        _Side(branch, chain, other, stages, shift, pair.name)
        for branch, chain, other, stages, shift in zip(
            leaning.branches,
            chains,
            chains[::-1],
            (front, back),
            leaning.equilibria,
            strict=False,
        )
        if chain is not None
    ]
    laws = tie_laws(list(ties.values()), [[side.stretch(name) for side in sides] for name in ties])
    bare = [side.without(ties) for side in sides]
    held = [side.held(ties, under) for side, under in zip(sides, bare, strict=True)]
    without = replace(leaning, positive=bare[0], negative=bare[1] if len(bare) > 1 else None)
    return replace(without, positive=held[0], negative=held[1] if len(held) > 1 else None, memory=Memory(without, laws))


@dataclass(frozen=True, repr=False)
class _Side(ShortRepr):
    """A branch on joints whose ties pull by their pretension; shift : of its rest, from the geometry [rad]."""

    branch: Branch
    chain: Chain
    other: Chain | None
    stages: Stages
    shift: float
    name: str

    def stretch(self, name: str) -> tuple[FloatArray, FloatArray]:
        """Return the elongation of a tie from rest, where it pulls with its pretension, and its derivative."""
        e, rate = stretch(name, self.chain, self.other, self.branch.rotation + self.shift)
        return (e, rate) if e[0] <= NEVER else (e - e[0], rate)

    def without(self, ties: dict[str, Tie]) -> Branch:
        """Return the branch without its ties, over the same rotations."""
        restoring = self.branch.restoring.copy()
        for name, tie in ties.items():
            restoring -= tie.tension * self.stretch(name)[1]
        rigid = staged_branch(_rigid(without_ties(self.stages, ties)), restitution=0.0, name=self.name)
        return self._with_moment(restoring, rigid.overturning, np.inf)

    def held(self, ties: dict[str, Tie], bare: Branch) -> Branch:
        """Return the branch with its ties as they first stretch, until it would overturn without them."""
        restoring, ends = bare.restoring.copy(), np.diff(bare.rotation) == 0.0
        beside = AT_ONE * (np.r_[False, ends].astype(float) - np.r_[ends, False])  # before a jump, and behind it
        for name, tie in ties.items():
            e, rate = self.stretch(name)
            there = e + beside < (np.inf if tie.elongation is None else tie.elongation)
            restoring += np.where(there, tie.pull_at(e), 0.0) * rate
        rigid = staged_branch(_rigid(self.stages), restitution=0.0, name=self.name)
        return self._with_moment(restoring, min(rigid.overturning, bare.overturning), bare.unstable)

    def _with_moment(self, restoring: FloatArray, overturning: float, most: float) -> Branch:
        restoring.flags.writeable = False
        made = replace(self.branch, restoring=restoring, overturning=overturning)
        falls = min(_falls(made), most)
        if falls == np.inf:
            raise MechanismError(
                f'mechanism "{self.name}": on its joints the restoring moment does not fall to zero before '
                f"{made.rotation[-1]:.3g} rad; check its joints"
            )
        return replace(made, overturning_flexible=falls)


def _falls(branch: Branch) -> float:
    """Return the first rotation at which the moment of a table falls to zero [rad]; inf where its ties hold it."""
    from scipy.optimize import brentq

    falling = np.flatnonzero((branch.restoring[:-1] > 0.0) & (branch.restoring[1:] <= 0.0))
    if not falling.size:
        return float(np.inf)
    low, high = branch.rotation[falling[0]], branch.rotation[falling[0] + 1]
    if high - low <= AT_ONE:
        return float(low)
    last = np.nextafter(high, low)  # a jump at the end of a segment belongs to the next
    return float(brentq(lambda phi: float(branch.restoring_spline(phi)), low, last, xtol=1e-15, rtol=1e-14))


def _is_level(tie: Tie) -> bool:
    if tie.anchor is None:
        return False
    across, up = tie.anchor[0] - tie.at[0], tie.anchor[1] - tie.at[1]
    return abs(up) <= LEVEL * float(np.hypot(across, up))


def _pulling(stages: Stages, ties: dict[str, Tie]) -> Stages:
    """Return stages in which ties that stretch pull by their pretension, on both sides and for good."""
    here = stretching_ties(stages)
    pulling = [
        Tie(tie.name, tie.tension, tie.at, anchor=tie.anchor, both=True, block=tie.block, aside=tie.aside)
        for tie in here.values()
    ]
    return tuple(
        replace(stage, absent=(), chain=replace(one.chain, loads=(*one.chain.loads, *pulling)))
        for stage, one in zip(stages, without_ties(stages, ties), strict=True)
    )


def without_ties(stages: Stages, ties: Collection[str]) -> Stages:
    """Return stages without some ties, by their names."""
    return tuple(
        replace(
            stage,
            chain=replace(stage.chain, loads=tuple(each for each in stage.chain.loads if each.name not in ties)),
        )
        for stage in stages
    )


def _rigid(stages: Stages) -> Stages:
    return tuple(replace(stage, chain=replace(stage.chain, joints=())) for stage in stages)
