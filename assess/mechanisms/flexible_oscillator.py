"""From a mechanism on flexible joints to its oscillator: equilibrium, and a table for each branch counted from there.

A joint in full contact deforms under any rotation, so the restoring moment of a symmetric mechanism begins at zero and
passes through rest smoothly. Under an eccentric load the mechanism rests at a rotation phi_e of one of its branches;
the branch on the other side then begins with the way back from phi_e to zero, seen in its own sign:

    other branch:  rotation 0 ... phi_e   the first chain from phi_e back to 0, moments and lifts with the other sign
                   from phi_e on          the second chain from 0
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from functools import cached_property
from itertools import pairwise
from typing import Literal

import numpy as np

from assess.errors import MechanismError
from assess.interfaces.contact import thresholds
from assess.mechanisms.branch_table import (
    FEWEST,
    NODES,
    REACH,
    ActionMoments,
    Stages,
    negligible_moments,
    single_stage,
    stage_signature,
    staged_branch,
)
from assess.mechanisms.chain import FLAT, Chain, ChainPair, Joint, Work, geometric_limit, mirror_point
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.oscillator import Branch, Oscillator
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray


def flexible_oscillator(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of chains on their joints, with the stages of each.

    Raises MechanismError if the mechanism finds no stable rest, or never overturns.
    """
    name, (first, second) = pair.name, pair.restitution
    positive = make_flexible_side(front, name=name, restitution=first)
    if pair.negative is None:
        return Oscillator(branch_from_rest(positive, None), None, pair.positive.mass, equilibrium=positive.lean)
    alike = same_stages(front, back) and first == second
    negative = positive if alike else make_flexible_side(back, name=name, restitution=second)
    if not _share_rest(pair.positive, pair.negative) or front[0].absent != back[0].absent:
        return Oscillator(
            positive=branch_from_rest(positive, None),
            negative=branch_from_rest(negative, None),
            mass=pair.positive.mass,
            equilibrium=positive.lean,
            equilibrium_negative=negative.lean,
        )
    if positive.leans and negative.leans:
        raise MechanismError(
            f'mechanism "{name}": it is pushed off its rest both ways, by {-positive.work.restoring[0]:.4g} and '
            f"{-negative.work.restoring[0]:.4g} N m: a hinge inside the edge of its contact does that, as pressure is "
            "counted from the hinge on; put hinges on the edges, give the shape between them, or check loads"
        )
    return Oscillator(
        positive=branch_from_rest(positive, negative),
        negative=branch_from_rest(negative, positive),
        mass=pair.positive.mass,
        equilibrium=positive.lean - negative.lean,
        equilibrium_negative=negative.lean - positive.lean,
    )


def flexible_moments(chain: Chain, *, name: str) -> ActionMoments:
    """Return the moments of the actions on a chain, each as its joints move."""
    flexible = FlexibleChain(chain, name)
    scan = np.unique(make_flexible_side(single_stage(chain), name=name, restitution=1.0).rotation)
    return ActionMoments(scan, lambda rotation: flexible.moments(rotation) + negligible_moments(chain))


def branch_from_rest(side: FlexibleSide, other: FlexibleSide | None) -> Branch:
    """Return the branch of one side, counted from the equilibrium of the mechanism.

    Raises MechanismError if the moment never falls to zero.
    """
    shift = side.lean
    overturning = side.fall(lambda work: work.restoring)
    critical = side.fall(lambda work: work.weight) if side.work.moment.any() else overturning
    if overturning is None or critical is None:
        raise MechanismError(
            f'mechanism "{side.flexible.name}": on its joints the restoring moment does not fall to zero before '
            f"{side.end:.3g} rad; check hinges, ties and joints"
        )
    columns = side.columns()
    if shift:
        columns = columns[:, columns[0] > (1.0 + 0.5 * FINE) * shift]
        stand = np.array([shift])
        work = side.work_at(stand, np.array([side.chain_at(shift, then="right")]))
        columns = np.concatenate([_branch_columns(stand, work), columns], axis=1)
    elif other is not None and other.lean:
        shift = -other.lean
        back = other.columns(back_from=other.lean)
        back[0] += shift
        columns = np.concatenate([back, columns], axis=1)
    columns[0] -= shift
    if abs(columns[2, 0]) <= NEGLIGIBLE * side.rigid.restoring[0]:
        columns[2, 0] = 0.0
    columns.flags.writeable = False
    phi, inertia, restoring, excitation, participation, lift = columns
    return Branch(
        phi,
        inertia,
        restoring,
        excitation,
        participation,
        lift,
        restitution=side.rigid.restitution,
        overturning=side.rigid.overturning,
        critical=critical - shift,
        overturning_flexible=overturning - shift,
    )


def same_stages(one: Stages, other: Stages) -> bool:
    """Return whether two sides, each in its own sign, are equal to the last digit."""
    return _same_chain(one[0].chain, other[0].chain) and stage_signature(one) == stage_signature(other)


FINE = 0.05  # step of the table over rotation, as moments go with the power -1/2 of it
COARSE = 1.0 / 128.0  # largest step, of the table's length
FIRST = 6  # steps up to the first change of regime
NEGLIGIBLE = 1e-9  # of the rigid restoring moment at rest: less is zero
NEAR = 1e-4  # of a root found on the table: distance at which the moment is evaluated again
ONSET = 1e-6  # of the table's length: a rotation that has just begun
SAME = 1e-9  # of the largest of them: places that move by less have converged
CORRECTIONS = 4  # of the places where joints open and crush, or moments are zero
CONVERGED = 1e-7  # of a root: after so short a step the error goes with its square


@dataclass(frozen=True, repr=False)
class FlexibleSide(ShortRepr):
    """A chain on its joints, and its branch on rigid ones.

    starts : rotations [rad] from which each of the chains applies, the first from rest; more than one if actions end
    """

    chains: tuple[FlexibleChain, ...]
    starts: tuple[float, ...]
    rigid: Branch

    @property
    def flexible(self) -> FlexibleChain:
        """The chain at rest."""
        return self.chains[0]

    @cached_property
    def end(self) -> float:
        """End of the table, beyond phi_ov and phi_cr of the rigid chain [rad]."""
        reach, farthest = (
            geometric_limit(self.flexible.chain) * (1.0 - FLAT),
            max(self.rigid.overturning, self.rigid.critical),
        )
        return min(max(REACH * self.rigid.overturning, 1.05 * farthest), 0.5 * (farthest + reach))

    @cached_property
    def stops(self) -> tuple[float, ...]:
        """Where each of the chains that the table reaches ends [rad]."""
        return (*(start for start in self.starts[1:] if start < self.end), self.end)

    def changes(self, number: int) -> list[float]:
        """Return the rotations [rad] at which joints of a chain, by its number, open or begin to crush, in order.

        First from their forces and rates at rest, then corrected by those at the rotations found.
        """
        chain, start, stop = self.chains[number], self.starts[number], self.stops[number]
        joints = [(number, joint) for number, joint in enumerate(chain.jointed.joints) if joint is not None]
        places = np.full((len(joints), 2), ONSET * self.end)
        for _ in range(CORRECTIONS):
            joints_there, before = chain.solve_joints(places.ravel()), places.copy()
            turned = chain.jointed.relative(joints_there.configuration)
            for row, (number, joint) in enumerate(joints):
                for column, at in enumerate((2 * row, 2 * row + 1)):
                    force, psi = float(joints_there.normal_force[number, at]), float(turned[number, at])
                    slope = thresholds(joint.section, joint.law, normal_force=force)[column]
                    places[row, column] *= np.arcsin(min(slope, 1.0)) / psi if psi > 0.0 else 1.0
            was, places = before, np.minimum(places, self.end)
            if np.abs(places - was).max() <= SAME * places.max():
                break
        return sorted({float(each) for each in places.ravel() if start < each < stop})

    @cached_property
    def pieces(self) -> tuple[FloatArray, ...]:
        """Nodes of each chain [n] [rad]: fine where joints open and crush, two at each kink."""
        return tuple(self._nodes(number) for number in range(len(self.stops)))

    @cached_property
    def rotation(self) -> FloatArray:
        """All nodes [n] [rad]."""
        return np.concatenate(self.pieces)

    @cached_property
    def number(self) -> IntArray:
        """The chain of each node [n]."""
        return np.repeat(np.arange(len(self.pieces)), [piece.size for piece in self.pieces])

    def _nodes(self, number: int) -> FloatArray:
        """Return the nodes of a chain, by its number."""
        start, stop, changes = self.starts[number], self.stops[number], self.changes(number)
        ends = [start, *changes, stop]
        if number:
            return np.concatenate([self._piece(*between, least=start) for between in pairwise(ends)])
        if not changes:
            return np.linspace(0.0, stop, NODES)
        return np.concatenate([self._piece(*between, least=ends[1]) for between in pairwise(ends)])

    def _piece(self, start: float, end: float, *, least: float) -> FloatArray:
        """Return the nodes from one change of regime to the next; least: the first change of all."""
        nodes = [start]
        while nodes[-1] < end:
            step = FINE * nodes[-1] if nodes[-1] >= least else least / FIRST
            nodes.append(nodes[-1] + min(step, COARSE * self.end))
        if len(nodes) < FEWEST:
            return np.linspace(start, end, FEWEST)
        stretched = start + (np.array(nodes) - start) * ((end - start) / (nodes[-1] - start))
        stretched[-1] = end
        return stretched

    @cached_property
    def work(self) -> Work:
        """The sums of virtual work at the nodes."""
        return self.work_at(self.rotation, self.number)

    def work_at(self, rotation: FloatArray, number: IntArray) -> Work:
        """Return the sums of virtual work at rotations [n] [rad].

        Equal rotations of one chain have equal sums, to the last digit, so that there is no jump between them.
        number : of the chain at each [n]
        """
        rows = np.empty((len(fields(Work)), rotation.size))
        for each in np.unique(number):
            here = number == each
            once, where = np.unique(rotation[here], return_inverse=True)
            work = self.chains[each].solve_equilibrium(once).work
            rows[:, here] = np.array([getattr(work, column.name)[where] for column in fields(work)])
        return Work(*rows)

    def chain_at(self, rotation: float, *, then: Literal["left", "right"]) -> int:
        """Return the number of the chain at a rotation [rad]; at a change of chains, the first or the second."""
        return max(int(np.searchsorted(self.starts[: len(self.stops)], rotation, side=then)) - 1, 0)

    @cached_property
    def leans(self) -> bool:
        """Whether its loads rotate it this way at rest."""
        return bool(self.work.restoring[0] < -NEGLIGIBLE * self.rigid.restoring[0])

    @cached_property
    def lean(self) -> float:
        """Equilibrium rotation under loads that rotate it this way [rad]; 0 if they do not.

        Raises MechanismError if there is no equilibrium.
        """
        start, then = self.work.restoring[:2]
        if start <= NEGLIGIBLE * self.rigid.restoring[0] and not self.leans and then < 0.0:
            raise MechanismError(
                f'mechanism "{self.flexible.name}": it falls by itself: its joints are too soft to hold it upright; '
                "give them more stiffness or area, or check loads"
            )
        if not self.leans:
            return 0.0
        found = self.fall(lambda work: -work.restoring)
        if found is None:
            raise MechanismError(
                f'mechanism "{self.flexible.name}": it falls by itself: the load on its joints lies '
                f"too far out, by {-self.work.restoring[0]:.4g} N m at rest; check loads, hinges and joints"
            )
        return found

    def fall(self, value: Callable[[Work], FloatArray]) -> float | None:
        """Return the first rotation at which a sum goes from + to - [rad]; None if it never does."""
        values = value(self.work)
        falling = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
        if not falling.size:
            return None
        first = int(falling[0])
        if self.number[first] != self.number[first + 1]:  # it falls at the end of a stage
            return float(self.rotation[first])
        here = self.number == self.number[first]
        near = _crossing(self.rotation[here], values[here], first - int(np.flatnonzero(here)[0]))
        for _ in range(CORRECTIONS):
            places = near * np.array([1.0 - NEAR, 1.0, 1.0 + NEAR])
            before, at, after = value(self.chains[self.number[first]].solve_equilibrium(places).work)
            step = float(at * 2.0 * NEAR * near / (after - before))
            near -= step
            if abs(step) <= CONVERGED * near:
                break
        return near

    def columns(self, *, back_from: float | None = None) -> FloatArray:
        """Return the table [6, n] over rotation, or that from a rotation back to zero in the other sign."""
        rotation, work = self.rotation, self.work
        if back_from is not None:
            kept = rotation < (1.0 - 0.5 * FINE) * back_from
            rotation = np.append(rotation[kept], back_from)[::-1]
            work = self.work_at(rotation, np.append(self.number[kept], self.chain_at(back_from, then="left"))[::-1])
        columns = _branch_columns(rotation, work)
        if back_from is not None:
            columns[0] = back_from - columns[0]
            columns[[2, 5]] *= -1.0
        return columns


def make_flexible_side(stages: Stages, *, name: str, restitution: float) -> FlexibleSide:
    """Make one side of a mechanism from its stages."""
    rigid = tuple(replace(stage, chain=replace(stage.chain, joints=())) for stage in stages)
    return FlexibleSide(
        chains=tuple(FlexibleChain(stage.chain, name) for stage in stages),
        starts=tuple(stage.start for stage in stages),
        rigid=staged_branch(rigid, restitution=restitution, name=name),
    )


def _share_rest(positive: Chain, negative: Chain) -> bool:
    """Return whether both directions use the same joints, and so share one equilibrium.

    An arch opens other joints each way: each direction then counts from the equilibrium of its own joints.
    """
    if positive.parts:
        return positive.parts == tuple(
            (replace(block, centroid=mirror_point(block.centroid)), number) for block, number in negative.parts
        )
    return True


def _same_chain(one: Chain, other: Chain) -> bool:
    """Return whether two chains, each in its own sign, are equal to the last digit."""
    return (one.blocks, one.hinges, one.loads) == (other.blocks, other.hinges, other.loads) and (
        [_joint_values(joint) for joint in one.joints] == [_joint_values(joint) for joint in other.joints]
    )


def _joint_values(joint: Joint | None) -> tuple[object, ...] | None:
    """Return the parts of a joint as values that compare."""
    if joint is None:
        return None
    section = joint.section
    return (joint.inward, joint.law, joint.model, section.depth, section.pieces.tolist(), section.discs.tolist())


def _branch_columns(rotation: FloatArray, work: Work) -> FloatArray:
    """Return the columns of a branch [6, n] from the sums at rotations [n]."""
    return np.array([rotation, work.inertia, work.restoring, work.excitation, work.participation, work.lift])


def _crossing(rotation: FloatArray, values: FloatArray, k: int) -> float:
    """Return where falling values pass zero after node k, by the cubic of rotation over values through four nodes."""
    first = min(max(k - 1, 0), rotation.size - 4)
    x, y = rotation[first : first + 4], values[first : first + 4]
    if np.all(np.diff(y) < 0.0):
        near = sum(
            x[i] * np.prod([y[j] / (y[j] - y[i]) for j in range(4) if j != i]) for i in range(4)
        )  # Lagrange's polynomial at zero
        if rotation[k] <= near <= rotation[k + 1]:
            return float(near)
    a, b = values[k], values[k + 1]
    return float(rotation[k] + (rotation[k + 1] - rotation[k]) * a / (a - b))
