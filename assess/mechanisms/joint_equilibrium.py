"""The equilibrium of the joints of a chain at given rotations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.errors import MechanismError
from assess.interfaces.contact import Contact, contact
from assess.mechanisms.joint_forces import block_forces, hinge_reactions, normal_forces
from assess.mechanisms.jointed_chain import Configuration, JointedChain
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

Contacts = tuple[Contact | None, ...]

ROUNDS = 60
CONVERGED = 1e-13  # of the size of the chain: a smaller change from round to round is convergence
FOUND = 1e-9  # of the size: so is a change below this that no longer decreases
ROUGH = 1e-7  # of the size: and a change below this after all rounds, by rounding, as in very stiff joints at rest
BACK = 1e-9  # rad: a joint that rotates back by more would open at its hinge
LEVEL = 1e-15  # rad: a smaller rotation of a joint is rounding


@dataclass(frozen=True, repr=False)
class JointEquilibrium(ShortRepr):
    """The joints in equilibrium at n rotations.

    configuration; normal_force : on each joint [hinges, n] [N]; contacts : None for a rigid joint
    closure : of the edge of each joint [hinges, n] [m]
    """

    configuration: Configuration
    normal_force: FloatArray
    contacts: Contacts
    closure: FloatArray


def solve_joint_equilibrium(
    jointed: JointedChain, rotation: FloatArray, rest: FloatArray, near: FloatArray
) -> JointEquilibrium:
    """Solve the equilibrium of all joints by fixed-point iteration.

    It converges because the closure of one joint moves the others by little. From the second round on the step is
    corrected by the last two changes (Anderson 1965, with one step of memory).

    Parameters
    ----------
    jointed : the chain
    rotation : of its leading block [n] [rad]
    rest : closures at rest, from which sinking counts; nothing has sunk at rotation 0 [hinges] [m]
    near : first guess of the resultants [hinges, n] [m]

    Raises
    ------
    MechanismError : no equilibrium, or a joint that would open at its hinge
    """
    shape = (len(jointed.joints), rotation.size)
    now, before, change, last = np.array([np.zeros(shape), near]), None, np.inf, np.inf
    for _ in range(ROUNDS):
        configuration = jointed.configuration(rotation, now[0])
        points = configuration.corner + now[1] * jointed.faces(configuration)
        loads = block_forces(jointed, configuration, points, jointed.chain.loads)
        normal = normal_forces(jointed, configuration, hinge_reactions(points, *loads))
        contacts = contacts_of(jointed, configuration, normal)
        closure = each_contact(contacts, "closure", shape)
        found = np.array([(closure - rest[:, None]) * (rotation > 0.0), each_contact(contacts, "resultant", shape)])
        residual = found - now
        change = float(np.abs(residual).max())
        if change <= CONVERGED * jointed.size or (change <= FOUND * jointed.size and change >= last):
            _require_open(jointed, configuration)
            return JointEquilibrium(configuration, normal, contacts, closure)
        last, after = change, (found, residual)
        now = found if before is None else found - _memory(residual, before[1]) * (found - before[0])
        before = after
    if change <= ROUGH * jointed.size:
        _require_open(jointed, configuration)
        return JointEquilibrium(configuration, normal, contacts, closure)
    raise MechanismError(
        f'mechanism "{jointed.name}": its joints find no equilibrium (they still move by {last:.2g} m); check their '
        "stiffness and strength"
    )


def contacts_of(jointed: JointedChain, configuration: Configuration, normal: FloatArray) -> Contacts:
    """Return the contact of each joint under its normal force [hinges, n] [N]."""
    psi = jointed.relative(configuration)
    found: list[Contact | None] = []
    for joint, force, turned, where in zip(jointed.joints, normal, psi, jointed.places, strict=True):
        if joint is None:
            found.append(None)
            continue
        slope = np.sin(np.clip(turned, 0.0, np.pi / 2)) * (turned > LEVEL)
        found.append(contact(joint.section, joint.law, normal_force=force, rotation=slope, where=where))
    return tuple(found)


def each_contact(contacts: Contacts, name: str, shape: tuple[int, ...]) -> FloatArray:
    """Return one array of every contact.

    Parameters
    ----------
    contacts : of the joints; None for a rigid one
    name : of the array
    shape : of the result, [hinges, n]

    Returns
    -------
    FloatArray
        Zeros for a rigid joint.
    """
    return np.array([np.zeros(shape[1]) if found is None else getattr(found, name) for found in contacts])


def _require_open(jointed: JointedChain, configuration: Configuration) -> None:
    """Raise MechanismError if a joint would open at its hinge."""
    for joint, turned, where in zip(jointed.joints, jointed.relative(configuration), jointed.places, strict=True):
        if joint and turned.min() < -BACK:
            raise MechanismError(
                f"{where}: its faces turn by {-turned.min():.3g} rad away from the hinge, which would open there; "
                "put the hinge at the other face"
            )


def _memory(residual: FloatArray, before: FloatArray) -> FloatArray:
    """Return the share of the last step to take back at each rotation [n], for the least residual [2, hinges, n]."""
    step = residual - before
    square = np.sum(step * step, axis=(0, 1))
    share = np.sum(residual * step, axis=(0, 1)) / np.where(square > 0.0, square, 1.0)
    return np.asarray(share, dtype=np.float64)
