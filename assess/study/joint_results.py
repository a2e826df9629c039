"""The joints of a mechanism as results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite
from typing import Any

import numpy as np

from assess.interfaces.contact import thresholds
from assess.mechanisms.chain import Chain
from assess.mechanisms.flexible import FlexibleChain
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.motion import FLAT, limit
from assess.mechanisms.statics import compressions
from assess.mechanisms.table import NODES
from assess.mechanisms.virtual_work import virtual_work
from assess.oscillator import Branch, Oscillator
from assess.results import BranchMoment, ContactSheet, InterfaceCurves
from assess.study.joint_steps import contact_sheets
from spectra.arrays import FloatArray

POINTS = 200  # of a curve, at most


def interface_results(mechanism: Mechanism, oscillator: Oscillator, names: Sequence[str]) -> tuple[dict[str, Any], ...]:
    """Return the force at every hinge of both branches, and how its contact opens and crushes."""
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    found: list[dict[str, Any]] = []
    for chain, side in zip(chains, oscillator.branches, strict=True):
        if chain.joints:
            found += _flexible(chain, side, names[len(found) :], mechanism.name)
        else:
            forces = compressions(chain)
            found += [_rigid(name, force) for name, force in zip(names[len(found) :], forces, strict=False)]
    return tuple(found)


def sheets_of_joints(mechanism: Mechanism, oscillator: Oscillator, names: Sequence[str]) -> Iterator[ContactSheet]:
    """Yield the calculation sheets of the joints of both branches that yield or crush."""
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    for chain, side, rest in zip(chains, oscillator.branches, oscillator.equilibria, strict=False):
        if chain.joints:
            yield from contact_sheets(FlexibleChain(chain, mechanism.name), side, names, equilibrium=rest)
        names = names[len(chain.hinges) :]


def _rigid(hinge: str, normal_force: float) -> dict[str, Any]:
    """Return a rigid contact, without curve; its force is that at incipient motion, negative in tension."""
    return {
        "hinge": hinge,
        "model": "rigid",
        "normal_force_n": normal_force,
        "area_m2": None,
        "stiffness_pa_m": None,
        "strength_pa": None,
        "opening_rad": 0.0,
        "crushing_rad": None,
        "curve": None,
    }


def _flexible(chain: Chain, side: Branch, names: Sequence[str], name: str) -> list[dict[str, Any]]:
    """Return the joints of one chain: forces at rest, rotations of the joints themselves.

    mechanism_rotation_rad is that of the chain from its geometry; the branch counts from phi_e.
    """
    step = -(-side.rotation.size // POINTS)
    rotation = np.unique(side.rotation)[::step]
    flexible = FlexibleChain(chain, name)
    held, rest = flexible.solve_equilibrium(rotation), flexible.solve_joints(np.zeros(1)).normal_force[:, 0]
    found = []
    for number, joint in enumerate(chain.joints):
        force = float(rest[number])
        contact = held.contacts[number]
        if joint is None or contact is None:
            found.append(_rigid(names[number], compressions(chain)[number]))
            continue
        opening, crushing = thresholds(joint.section, joint.law, normal_force=force)
        found.append({
            "hinge": names[number],
            "model": joint.model,
            "normal_force_n": force,
            "area_m2": joint.section.area,
            "depth_m": joint.section.depth,
            "stiffness_pa_m": _finite(joint.law.stiffness),
            "strength_pa": _finite(joint.law.strength),
            "opening_rad": _finite(opening),
            "crushing_rad": _finite(crushing),
            "curve": {
                "rotation_rad": tuple((held.relative[number] + 0.0).tolist()),
                "mechanism_rotation_rad": tuple(rotation.tolist()),
                "resultant_m": tuple(contact.resultant.tolist()),
                "peak_stress_pa": tuple(contact.peak_stress.tolist()),
                "open_share": tuple((contact.open_area / joint.section.area).tolist()),
                "crushed_share": tuple((contact.crushed_area / joint.section.area).tolist()),
            },
        })  # fmt: skip
    return found


def _finite(value: float) -> float | None:
    """Return the value, None in place of inf."""
    return float(value) if isfinite(value) else None


def interface_curves(mechanism: Mechanism, rigid: Sequence[Branch]) -> InterfaceCurves:
    """Return the moment of the positive branch with rigid joints, and about its fixed hinges a_SF."""
    chain = FlexibleChain(mechanism.positive, mechanism.name).fixed_hinge_chain
    rotation = np.linspace(0.0, min(rigid[0].rotation[-1], limit(chain) * (1.0 - FLAT)), NODES)
    fixed = virtual_work(chain, rotation).restoring  # may be zero from the start, where the joint still resists
    return InterfaceCurves(_moment(rigid[0].rotation, rigid[0].restoring), _moment(rotation, fixed))


def _moment(rotation: FloatArray, restoring: FloatArray) -> BranchMoment:
    return BranchMoment(tuple(rotation.tolist()), tuple(restoring.tolist()))
