"""The forces of a chain on joints in one configuration: on its blocks, at its hinges, and on its leading block."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from scipy.constants import g

from assess.loads.load import Force, Load, PointMass, pull_at_rest, upward
from assess.mechanisms.jointed_chain import Configuration, JointedChain
from spectra.arrays import ComplexArray, FloatArray


def block_forces(
    jointed: JointedChain,
    configuration: Configuration,
    points: ComplexArray,
    loads: Iterable[Load],
    *,
    blocks: bool = True,
) -> tuple[ComplexArray, FloatArray]:
    """Return the force on each block and its moment about the origin, anticlockwise [blocks, n] [N, N m].

    Parameters
    ----------
    jointed, configuration : the chain and its configuration
    points : of the resultants at the hinges [hinges, n] [m]
    loads : to include
    blocks : whether to include the weights of the blocks
    """
    shape = (len(jointed.chain.blocks), points.shape[1])
    force, moment = np.zeros(shape, dtype=np.complex128), np.zeros(shape)
    for number, block in enumerate(jointed.chain.blocks if blocks else ()):
        force[number] = -1j * g * block.mass
        moment[number] = -g * block.mass * jointed.place(configuration, number, complex(*block.centroid)).real
    for load in loads:
        here = points[2] if load in jointed.at_top else jointed.place(configuration, load.block, complex(*load.at))
        pull = load_force(jointed, load, here)
        force[load.block] += pull
        moment[load.block] += cross(here, pull)
    return force, moment


def hinge_reactions(points: ComplexArray, force: ComplexArray, moment: FloatArray) -> ComplexArray:
    """Return the force of each hinge on the chain beyond it [hinges, n] [N]; a moment holds the leading block.

    Every block k is in equilibrium: P_k - P_(k+1) + F_k = 0, and likewise its moments, but for the leading block.

    Parameters
    ----------
    points : of the resultants at the hinges [hinges, n] [m]
    force, moment : on each block, about the origin [blocks, n] [N, N m]
    """
    if len(force) == 1:
        return -force
    arm, turn = points[1] - points[2], cross(points[1], force[1]) - moment[1]
    if len(force) == 2:
        last = -turn / arm.imag + 0j  # the support at the top has no vertical reaction
        return np.array([last - force[0] - force[1], last - force[1], last])
    other, back = points[2] - points[3], cross(points[3], force[2]) - moment[2]
    third = (turn * other - back * arm) / cross(arm, other)
    return np.array([third - force[0] - force[1], third - force[1], third, third + force[2]])


def normal_forces(jointed: JointedChain, configuration: Configuration, reactions: ComplexArray) -> FloatArray:
    """Return the normal force of each joint [hinges, n] [N], 0 for a rigid one."""
    forces = np.zeros(reactions.shape)
    for i, ((face, _), joint) in enumerate(zip(jointed.pairs, jointed.joints, strict=True)):
        if joint is None:
            continue
        if len(jointed.chain.blocks) == i == 2:
            forces[i] = -sum(upward(load) for load in jointed.at_top)
            continue
        normal = jointed.normal[i] * (1.0 if face is None else configuration.turn[face])
        away = -1.0 if i > 1 else 1.0  # beyond the middle of the chain the pressing block comes before its face
        forces[i] = away * (np.conj(normal) * reactions[i]).real
    return forces


def holding_moment(
    jointed: JointedChain,
    configuration: Configuration,
    points: ComplexArray,
    loads: Iterable[Load],
    *,
    blocks: bool = False,
) -> FloatArray:
    """Return the clockwise moment that holds the leading block against loads [n] [N m].

    Parameters
    ----------
    jointed, configuration : the chain and its configuration
    points : of the resultants at the hinges [hinges, n] [m]
    loads : to include
    blocks : whether to include the weights of the blocks
    """
    force, moment = block_forces(jointed, configuration, points, loads, blocks=blocks)
    reactions = hinge_reactions(points, force, moment)
    passed_on = cross(points[1], reactions[1]) if len(force) > 1 else 0.0
    return np.asarray(cross(points[0], reactions[0]) + moment[0] - passed_on, dtype=np.float64)


def load_force(jointed: JointedChain, load: Load, here: ComplexArray) -> ComplexArray:
    """Return the force of a load.

    Parameters
    ----------
    jointed : the chain that carries it
    load : a mass, force or tie
    here : its point now [n] [m]

    Returns
    -------
    ComplexArray
        [n] [N]
    """
    if isinstance(load, PointMass):
        return np.full_like(here, -1j * g * load.mass * load.bearing)
    if isinstance(load, Force):
        return np.full_like(here, complex(*load.force))
    if load in jointed.slack:
        return np.zeros_like(here)
    if load.anchor is None:
        return np.full_like(here, complex(*pull_at_rest(load)))
    towards = complex(*load.anchor) - here
    return load.tension * towards / np.abs(towards)


def cross(a: ComplexArray, b: ComplexArray) -> FloatArray:
    """Return the moment about the origin of forces b at places a, anticlockwise [n]."""
    return np.asarray((np.conj(a) * b).imag)
