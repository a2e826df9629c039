"""What the impact that ends a branch leaves of the velocity, for every kind of mechanism.

At rest the blocks of both branches stand in one place, and each branch is a field of velocities: (x', z', theta') of
every block for a unit rate of phi. The rules differ in what they take to be kept from one field to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import isclose
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from assess.errors import MechanismError
from assess.loads import PointMass
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import move, place
from assess.mechanisms.rest import plain_block
from assess.restitution import Restitution, housner, sorrentino

Named = Literal["thesis", "housner", "sorrentino", "momentum"]
RestitutionChoice = float | Named
Rule = Callable[[Chain, Chain], Restitution]
Rebound = Callable[[Chain], Restitution]
FloatArray = NDArray[np.float64]

HOUSNER = "Housner 1963, thesis eq. 3.44"
MOMENTUM = "momentum kept over the mechanism"
ABOUT_BASE = "angular momentum about the new base hinge, Sorrentino et al. 2008, thesis eq. 3.46"


@dataclass(frozen=True)
class Field:
    """Velocities at rest for a unit rate of phi, as the branch sees them; one row for each block, then each mass.

    mass, along, up : what moves horizontally and vertically, x' and z' [rows] [kg, kg, m, m]; turning : theta' [rows];
    inertia : about each centroid [rows] [kg m2]; x, z : places [rows] [m]
    """

    shaken: FloatArray
    borne: FloatArray
    inertia: FloatArray
    along: FloatArray
    up: FloatArray
    turning: FloatArray
    x: FloatArray
    z: FloatArray


def field(chain: Chain) -> Field:
    """The field of velocities with which `chain` leaves or reaches its rest."""
    motion = move(chain, np.zeros(1))
    parts = chain.parts or tuple((block, number) for number, block in enumerate(chain.blocks))
    moving = [(part.mass, part.mass, part.inertia, part.centroid, number) for part, number in parts]
    masses = [load for load in chain.loads if isinstance(load, PointMass)]
    moving += [(load.mass, load.mass * load.bearing, 0.0, load.at, load.block) for load in masses]
    rows = []
    for shaken, borne, turned, at, number in moving:
        if number is None:
            rows.append((shaken, borne, turned, 0.0, 0.0, 0.0, *at))
            continue
        path = place(motion, block=number, at=at)
        rows.append((shaken, borne, turned, path.dx[0], path.dz[0], motion.rate[number, 0], *at))
    return Field(*np.array(rows, dtype=np.float64).T)


def product(ending: Field, starting: Field) -> float:
    """The kinetic product of two fields [kg m2], the second mirrored back to the sign of the first.

    Of a field with itself, un-mirrored, it is the inertia I of the branch.
    """
    along = np.sum(ending.shaken * ending.along * -starting.along)
    up = np.sum(ending.borne * ending.up * starting.up)
    return float(along + up + np.sum(ending.inertia * ending.turning * -starting.turning))


def inertia(moving: Field) -> float:
    """I of the branch at rest [kg m2]."""
    squares = moving.shaken * moving.along**2 + moving.borne * moving.up**2 + moving.inertia * moving.turning**2
    return float(np.sum(squares))


def about(moving: Field, x: float, z: float) -> float:
    """Angular momentum about the point (x, z) of the field's own frame, clockwise [kg m2]."""
    arms = (moving.z - z) * moving.shaken * moving.along - (moving.x - x) * moving.borne * moving.up
    return float(np.sum(arms + moving.inertia * moving.turning))


def kept_momentum(ending: Chain, starting: Chain) -> Restitution:
    """The impulses at the new hinges do no work on the new motion: projection of the old field onto the new one.

    For one block that is the angular momentum about the new hinge. No impact by this rule adds energy.
    """
    new = field(starting)
    return Restitution(-product(field(ending), new) / inertia(new), MOMENTUM)


def kept_about_base(ending: Chain, starting: Chain) -> Restitution:
    """The angular momentum of the whole about the new base hinge is kept (3.46, there for two plain rectangles).

    That leaves out the impulse of the support at the top; beside it stands what `kept_momentum` gives.
    """
    old, new = field(ending), field(starting)
    x, z = starting.hinges[0]
    value = about(old, -x, z) / about(new, x, z)
    beside = kept_momentum(ending, starting).value
    return Restitution(value, f'{ABOUT_BASE}; "momentum" would give {beside:.3f}')


def kept_by_housner(ending: Chain, starting: Chain) -> Restitution:
    """3.44, for a block whose two hinges are alike."""
    return Restitution(housner(plain_block(ending)), HOUSNER)


def kept_by_block(ending: Chain, starting: Chain) -> Restitution:
    """3.44 where the two hinges are alike; elsewhere it would even add energy (tested), so there the law behind it."""
    first, second = plain_block(ending), plain_block(starting)
    alike = isclose(first.slenderness, second.slenderness, rel_tol=1e-9) and isclose(
        first.radius, second.radius, rel_tol=1e-9
    )
    return kept_by_housner(ending, starting) if alike else kept_momentum(ending, starting)


def rebound(chain: Chain) -> Restitution:
    """One-sided rocking of a block before a wall (3.45); a formula that gives no rebound counts as 0, with a notice."""
    signed = sorrentino(plain_block(chain))
    source = f"Sorrentino et al. 2011, thesis eq. 3.45: {signed:+.3f}"
    if signed >= 0:
        return Restitution(0.0, source, f"{source} is not negative: there is no rebound, restitution 0 is used")
    return Restitution(-signed, source)


def no_rebound(chain: Chain) -> Restitution:
    """One-sided rocking of a chain: no formula is published, so it does not rebound unless a number is given."""
    notice = "no rebound is taken for one-sided rocking of a chain, as no formula is published; give one as a number"
    return Restitution(0.0, "no rebound", notice)


_BLOCK: Mapping[Named, Rule] = {"thesis": kept_by_block, "housner": kept_by_housner, "momentum": kept_momentum}
TWO_SIDED: Mapping[str, Mapping[Named, Rule]] = {
    "single-block": _BLOCK,
    "equivalent-block": _BLOCK,
    "two-block": {"thesis": kept_about_base, "sorrentino": kept_about_base, "momentum": kept_momentum},
    "four-hinge": {"thesis": kept_momentum, "momentum": kept_momentum},
}
ONE_SIDED: Mapping[str, Mapping[Named, Rebound]] = {
    "single-block": {"thesis": rebound, "sorrentino": rebound},
    "equivalent-block": {"thesis": rebound, "sorrentino": rebound},
    "two-block": {"thesis": no_rebound},
    "four-hinge": {"thesis": no_rebound},
}


def impact(choice: RestitutionChoice, *, ending: Chain, starting: Chain | None, kind: str, name: str) -> Restitution:
    """The coefficient of the impact that ends one branch; `starting` is None for one-sided rocking.

    Raises MechanismError for a rule that is not for this kind, that adds energy or that leaves no rocking.
    """
    if not isinstance(choice, str):
        return Restitution(choice, "given")
    rules = (ONE_SIDED if starting is None else TWO_SIDED)[kind]
    if choice not in rules:
        sides = "one" if starting is None else "two"
        known = ", ".join(f'"{rule}"' for rule in rules)
        raise MechanismError(
            f'mechanism "{name}": restitution "{choice}" is not for a {kind} with sides = "{sides}"; use {known} or a '
            "number"
        )
    if starting is None:
        return ONE_SIDED[kind][choice](ending)
    kept = TWO_SIDED[kind][choice](ending, starting)
    _refuse_gain(kept, ending=ending, starting=starting, name=name)
    return replace(kept, notice=_faster(kept, ending=ending, starting=starting)) if kept.value > 1.0 else kept


def _faster(kept: Restitution, *, ending: Chain, starting: Chain) -> str:
    """Why a coefficient is above 1 without a gain of energy."""
    share = inertia(field(starting)) / inertia(field(ending))
    return (
        f"restitution {kept.value:.4g} is above 1 though energy is lost: the hinges of the two directions differ, and "
        f"the branch that begins is the faster one, its inertia being {share:.3g} of that of the one that ends; the "
        f"impact keeps {100.0 * kept.value**2 * share:.3g} % of the energy"
    )


def _refuse_gain(kept: Restitution, *, ending: Chain, starting: Chain, name: str) -> None:
    if kept.value < 0:
        raise MechanismError(
            f'mechanism "{name}": restitution by {kept.source} is {kept.value:.3g}: so stocky a mechanism does not '
            "rock on; give restitution as a number in [0, 1]"
        )
    if kept.value**2 * inertia(field(starting)) > inertia(field(ending)) * (1 + 1e-9):
        raise MechanismError(
            f'mechanism "{name}": restitution by {kept.source} is {kept.value:.3g}, which would add energy at the '
            'impact, for the two hinges differ; use "momentum" or a number'
        )
