"""The restitution of the impact that ends a branch, for every kind of mechanism.

At rest the blocks of both branches coincide, and each branch is a field of velocities: (x', z', theta') of every block
for a unit rate of phi. The rules differ in what is conserved from one field to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import atan2, cos, hypot, isclose, sin
from typing import Annotated, Literal, get_args

import numpy as np

from assess.declaration import UNCERTAIN_RESTITUTION, Evidence, Number, Range, Safe, Tried, one_of
from assess.errors import MechanismError
from assess.loads.load import PointMass, source_phrase
from assess.mechanisms.chain import Chain, move, trace_point
from assess.messages.message import Message, Quantity, Term, Value, message, warning
from assess.oscillator import RockingBlock
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

RestitutionRule = Literal["thesis", "housner", "sorrentino", "momentum"]
RESTITUTIONS: tuple[str, ...] = get_args(RestitutionRule)

RestitutionChoice = float | RestitutionRule | None
"""A number, a rule by its name, or None for the default of the kind."""


RESTITUTION_NUMBER = Number(
    "ratio",
    least=0,
    most=1,
    beyond="outside [0, 1]; restitution is velocity after over velocity before the impact",
    form=f"not a known restitution; write a number in [0, 1], {one_of(RESTITUTIONS)}",
)
BY_FORMULA = Evidence(
    "measured",
    "either",
    "the formula's, on one side over its range in histories",
    judged="less of it takes more energy; of one-sided rocking it also shortens the way back",
    safe=Range((Tried(Safe.ABSENT, str(Term("that of the formula"))),), up_to="restitution", between=1),
)


@dataclass(frozen=True)
class Restitution:
    """Velocity after over velocity before the impact that ends a rotation [-], or a rule; None for the default."""

    positive: Annotated[RestitutionChoice, RESTITUTION_NUMBER, UNCERTAIN_RESTITUTION, BY_FORMULA] = None
    """if absent, momentum where a load moves with the mechanism, else the thesis' rule for the kind; of two blocks its
    rule times what the loads change by momentum"""
    negative: Annotated[RestitutionChoice, RESTITUTION_NUMBER, UNCERTAIN_RESTITUTION, BY_FORMULA] = None
    """the same for the impact that ends negative rotation"""

    @property
    def choices(self) -> tuple[RestitutionChoice, RestitutionChoice]:
        """For the impacts that end the positive and the negative branch."""
        return self.positive, self.negative


@dataclass(frozen=True)
class RestitutionCoefficient:
    """A coefficient [-], at least 0, its source, and a warning if the rule does not apply (else None).

    source : the parts of a phrase: the rule, and what other rules would give
    stopped : the negative value by the rule, if the impact brings the mechanism to rest; else None
    range : factors on an uncertain value in histories, of which the worst counts
    """

    value: float
    source: tuple[Term | Message, ...]
    warning: Message | None = None
    stopped: float | None = None
    range: tuple[float, ...] = (1.0,)


ImpactRule = Callable[[Chain, Chain], RestitutionCoefficient]
ReboundRule = Callable[[Chain], RestitutionCoefficient]


@dataclass(frozen=True)
class ImpactRules:
    """The rules of restitution that a kind of mechanism offers, by name; "thesis" is the default.

    two_sided : from the chains before and after the impact; one_sided : from the chain that rebounds
    unnamed : of two-sided rocking, where the project names no rule; None for `default_rule`
    """

    two_sided: Mapping[RestitutionRule, ImpactRule]
    one_sided: Mapping[RestitutionRule, ReboundRule]
    unnamed: ImpactRule | None = None


HOUSNER = (Term("Housner 1963, Mehrotra eq. 3.44"),)
MOMENTUM = (Term("momentum kept over the mechanism"),)
ABOUT_BASE = (Term("angular momentum about the new base hinge, Sorrentino et al. 2008, Mehrotra eq. 3.46"),)
WITH_LOADS = Term("times momentum with the loads over momentum without")
OF_SLENDER_BLOCK = Term("3.45 of a slender block, as none is published for a chain")
GIVEN = (Term("given"),)
NOT_KNOWN = (Term("what its impacts leave is not known; no history of it is answered"),)
WORST_OF_THREE = Term("histories take the worst of 0.5, 1 and 1.5 times it")
WORST_OF_FOUR = Term("histories take the worst of no rebound and 0.5, 1 and 1.5 times it")
NOTABLE = 0.03  # a difference between two coefficients that is explained in a warning
REBOUNDS = (1.0, 0.5, 1.5)  # factors on the rebound of 3.45 in histories, 1 first
REBOUNDS_OF_CHAIN = (1.0, 0.0, 0.5, 1.5)
SLENDER_REBOUND = 0.5  # minus 3.45 where alpha goes to 0 with I_O = 4/3 M R^2: 1 - 2 * 3/4
SAME = 5e-4  # coefficients this close are printed alike


def find_restitution(
    choice: RestitutionChoice, *, ending: Chain, starting: Chain | None, rules: ImpactRules, kind: str, name: str
) -> RestitutionCoefficient:
    """Find the coefficient of the impact that ends one branch.

    A negative value means that the mechanism stops at the impact: 0, with the value found as `stopped`.

    Parameters
    ----------
    choice : a number, a rule by its name, or None for the default
    ending, starting : the chains of the branches before and after the impact; starting None for one-sided rocking
    rules : that its kind offers
    kind, name : of the mechanism

    Raises
    ------
    MechanismError : a rule that does not apply to this kind, or a named one that adds energy
    """
    if isinstance(choice, int | float):
        return RestitutionCoefficient(
            choice, GIVEN, _high_dissipation_warning(choice, ending=ending, starting=starting)
        )
    offered = tuple(rules.one_sided if starting is None else rules.two_sided)
    if choice is not None and choice not in offered:
        sides = "one" if starting is None else "two"
        known = ", ".join(f'"{rule}"' for rule in offered)
        raise MechanismError(
            f'mechanism "{name}": restitution = "{choice}": not for a {kind} with sides = "{sides}"; use {known} or a '
            "number"
        )
    if starting is None:
        return rules.one_sided[choice or "thesis"](ending)
    if choice is None and rules.unnamed is not None:
        impact = rules.unnamed
    else:
        impact = rules.two_sided[choice or default_rule(ending, starting, rules=rules)]
    kept = impact(ending, starting)
    _require_no_gain(kept, ending=ending, starting=starting, name=name)
    kept = replace(kept, source=kept.source + _compare_rules(kept, ending=ending, starting=starting, rules=rules))
    if kept.value < 0.0:
        return _stopped_at_impact(kept)
    return _with_warning(kept, impact, ending=ending, starting=starting)


def unknown_rebound(ending: Chain) -> RestitutionCoefficient:
    """Return no velocity after the impact of a mechanism of which no history is answered."""
    return RestitutionCoefficient(0.0, NOT_KNOWN)


FALLS_OUTWARDS = ImpactRules(two_sided={}, one_sided={"thesis": unknown_rebound})
"""The rules of a mechanism that falls outwards, of which no history is answered."""


def default_rule(ending: Chain, starting: Chain, *, rules: ImpactRules) -> RestitutionRule:
    """Return momentum if a load moves with the mechanism, else the rule of the thesis unless it would add energy."""
    if _moving_masses(ending, starting):
        return "momentum"
    kept = rules.two_sided["thesis"](ending, starting)
    return "momentum" if _adds_energy(kept, ending=ending, starting=starting) else "thesis"


def conserve_momentum(ending: Chain, starting: Chain) -> RestitutionCoefficient:
    """Conserve momentum: the impulses at the new hinges do no work on the new motion, so project the old field onto it.

    For one block this is the angular momentum about the new hinge. No impact by this rule adds energy.
    """
    new = velocity_field(starting)
    return RestitutionCoefficient(-_kinetic_product(velocity_field(ending), new) / _inertia_at_rest(new), MOMENTUM)


def conserve_about_base(ending: Chain, starting: Chain) -> RestitutionCoefficient:
    """Conserve the angular momentum of the whole about the new base hinge (3.46, there for two plain rectangles).

    This neglects the impulse of the support at the top.
    """
    old, new = velocity_field(ending), velocity_field(starting)
    x, z = starting.hinges[0]
    return RestitutionCoefficient(_angular_momentum(old, -x, z) / _angular_momentum(new, x, z), ABOUT_BASE)


def conserve_with_loads(ending: Chain, starting: Chain) -> RestitutionCoefficient:
    """Return 3.46 of the bare blocks times momentum with the loads over momentum without, or momentum if it is larger.

    A load that vanishes changes nothing then, where momentum takes several times the energy that 3.46 does. Momentum
    is kept alone where 3.46 would add energy, and where a loaded mechanism stops by it.
    """
    bare = _without_masses(ending), _without_masses(starting)
    by_momentum, plain = conserve_momentum(ending, starting), conserve_momentum(*bare)
    found = conserve_about_base(*bare)
    if _moving_masses(ending, starting):
        if by_momentum.value <= 0.0 or plain.value <= 0.0:
            return by_momentum
        share = by_momentum.value / plain.value
        found = RestitutionCoefficient(found.value * share, (*ABOUT_BASE, WITH_LOADS))
    if found.value < by_momentum.value or _adds_energy(found, ending=ending, starting=starting):
        return by_momentum
    return found


def housner_rule(ending: Chain, starting: Chain) -> RestitutionCoefficient:
    """Apply 3.44, for a block with two like hinges."""
    return RestitutionCoefficient(housner(plain_block(ending)), HOUSNER)


def single_block_rule(ending: Chain, starting: Chain) -> RestitutionCoefficient:
    """Apply 3.44 for two like hinges; for others it could add energy (tested), so conserve momentum instead."""
    first, second = plain_block(ending), plain_block(starting)
    alike = isclose(first.slenderness, second.slenderness, rel_tol=1e-9) and isclose(
        first.radius, second.radius, rel_tol=1e-9
    )
    return housner_rule(ending, starting) if alike else conserve_momentum(ending, starting)


def sorrentino_rebound(chain: Chain) -> RestitutionCoefficient:
    """Apply 3.45 to one-sided rocking of a block against a wall; without a rebound return 0 with a warning."""
    signed = sorrentino(plain_block(chain))
    source = message("restitution-3-45", {"value": Quantity(signed, "ratio", 3)})
    if signed >= 0:
        return RestitutionCoefficient(0.0, (source,), warning("restitution-no-rebound", **source.values))
    return RestitutionCoefficient(-signed, (source, WORST_OF_THREE), range=REBOUNDS)


def chain_rebound(chain: Chain) -> RestitutionCoefficient:
    """Return the rebound of a slender block for one-sided rocking of a chain, with none in its range too.

    No formula is published for chains. A body that bounces off what stands behind it can be worse placed for the next
    pulse than one that stops there, so that without a rebound histories would flatter it.
    """
    sources = (OF_SLENDER_BLOCK, WORST_OF_FOUR)
    return RestitutionCoefficient(SLENDER_REBOUND, sources, warning("restitution-chain"), range=REBOUNDS_OF_CHAIN)


def housner(block: RockingBlock) -> float:
    """Return the coefficient of two-sided rocking: angular momentum about the new hinge is conserved.

    Housner 1963; thesis eq. 3.44.
    """
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return 1 - 2 * M * R**2 / I_O * sin(alpha) ** 2


def sorrentino(block: RockingBlock) -> float:
    """Return the signed coefficient of one-sided rocking: below zero the block rebounds.

    Sorrentino et al. 2011; thesis eq. 3.45.
    """
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return housner(block) ** 2 * (1 - 2 * M * R**2 / I_O * cos(alpha) ** 2)


def plain_block(chain: Chain) -> RockingBlock:
    """Return mass, radius, slenderness and hinge inertia of a chain of one block with its bearing masses.

    These enter 3.44 and 3.45; non-bearing masses and applied forces are ignored.
    """
    (block,), (hinge,) = chain.blocks, chain.hinges
    carried = [load for load in chain.loads if isinstance(load, PointMass) and load.bearing]
    points = [(block.mass, block.centroid), *((load.mass, load.at) for load in carried)]
    arms = [(mass, hinge[0] - at[0], at[1] - hinge[1]) for mass, at in points]
    total = sum(mass for mass, _, _ in arms)
    behind, height = (sum(arm[0] * arm[i] for arm in arms) / total for i in (1, 2))
    about_hinge = block.inertia + sum(mass * (b**2 + h**2) for mass, b, h in arms)
    return RockingBlock(total, hypot(behind, height), atan2(behind, height), about_hinge)


@dataclass(frozen=True, repr=False)
class VelocityField(ShortRepr):
    """Velocities at rest for a unit rate of phi in the sign of the branch; one row for each block, then each mass.

    horizontal_mass, vertical_mass : what moves horizontally and vertically [rows] [kg]; dx, dz : x' and z' [rows] [m]
    rate : theta' [rows] [-]; inertia : about each centroid [rows] [kg m2]; x, z : places [rows] [m]
    """

    horizontal_mass: FloatArray
    vertical_mass: FloatArray
    inertia: FloatArray
    dx: FloatArray
    dz: FloatArray
    rate: FloatArray
    x: FloatArray
    z: FloatArray


def velocity_field(chain: Chain, *, sliding: bool = False) -> VelocityField:
    """Return the velocities with which a chain leaves or reaches its rest.

    sliding : bearing masses slide on their seats and transfer no horizontal momentum
    """
    motion = move(chain, np.zeros(1))
    parts = chain.parts or tuple((block, number) for number, block in enumerate(chain.blocks))
    moving = [(part.mass, part.mass, part.inertia, part.centroid, number) for part, number in parts]
    masses = [load for load in chain.loads if isinstance(load, PointMass)]
    for load in masses:
        horizontal_mass = 0.0 if sliding and load.bearing else load.mass
        moving.append((horizontal_mass, load.mass * load.bearing, 0.0, load.at, load.block))
    rows = []
    for horizontal_mass, vertical_mass, turned, at, number in moving:
        if number is None:
            rows.append((horizontal_mass, vertical_mass, turned, 0.0, 0.0, 0.0, *at))
            continue
        path = trace_point(motion, block=number, at=at)
        rows.append((horizontal_mass, vertical_mass, turned, path.dx[0], path.dz[0], motion.rate[number, 0], *at))
    return VelocityField(*np.array(rows, dtype=np.float64).T)


def _compare_rules(
    kept: RestitutionCoefficient, *, ending: Chain, starting: Chain, rules: ImpactRules
) -> tuple[Message, ...]:
    """Return what the other rule gives, and loads that slide on their seats; nothing if the value is the same."""
    other: RestitutionRule = "thesis" if kept.source == MOMENTUM else "momentum"
    value = rules.two_sided[other](ending, starting).value
    messages: tuple[Message, ...] = ()
    if abs(value - kept.value) > SAME:
        messages = (message("restitution-other", {"rule": other, "value": Quantity(value, "ratio", 3)}),)
    if not _moving_masses(ending, starting) or not (kept.source == MOMENTUM or WITH_LOADS in kept.source):
        return messages
    new = velocity_field(starting, sliding=True)
    slid = -_kinetic_product(velocity_field(ending, sliding=True), new) / _inertia_at_rest(new)
    slid *= kept.value / conserve_momentum(ending, starting).value
    if abs(slid - kept.value) <= NOTABLE:
        return messages
    return (*messages, message("restitution-sliding", {"value": Quantity(slid, "ratio", 3)}))


def _moving_masses(*chains: Chain) -> tuple[str, ...]:
    """Return the names of the loads that move with the mechanism, bearing or not."""
    return tuple(dict.fromkeys(load.name for chain in chains for load in chain.loads if isinstance(load, PointMass)))


def _high_dissipation_warning(given: float, *, ending: Chain, starting: Chain | None) -> Message | None:
    """Return a warning if a given restitution takes more energy at each impact than momentum does."""
    by_momentum = 1.0 if starting is None else conserve_momentum(ending, starting).value
    if starting is None or given >= by_momentum - NOTABLE:
        return None
    values = {"given": Quantity(given, figures=3), "momentum": Quantity(by_momentum, figures=3)}
    return warning("restitution-takes-more", **values)


def _stopped_at_impact(kept: RestitutionCoefficient) -> RestitutionCoefficient:
    """Return the coefficient of a mechanism that an impact brings to rest: by the rule it would move backwards."""
    stops = warning("restitution-stops", value=Quantity(kept.value, figures=3), source=kept.source[0])
    return replace(kept, value=0.0, warning=stops, stopped=kept.value)


def _with_warning(
    kept: RestitutionCoefficient, impact: ImpactRule, *, ending: Chain, starting: Chain
) -> RestitutionCoefficient:
    """Add a warning to a coefficient above 1, or well above that of the blocks without their loads by the same rule."""
    if kept.value > 1.0:
        return replace(kept, warning=_above_one_warning(kept, ending=ending, starting=starting))
    loads = _moving_masses(ending, starting)
    if not loads:
        return kept
    plain = impact(_without_masses(ending), _without_masses(starting)).value
    if kept.value <= plain + NOTABLE:
        return kept
    values: dict[str, Value] = {"value": Quantity(kept.value, figures=3), "plain": Quantity(plain, figures=3)}
    return replace(kept, warning=warning("restitution-of-high-mass", loads=", ".join(loads), **values))


def _without_masses(chain: Chain) -> Chain:
    """Return the chain without the loads that move with it."""
    return replace(chain, loads=tuple(load for load in chain.loads if not isinstance(load, PointMass)))


def _above_one_warning(kept: RestitutionCoefficient, *, ending: Chain, starting: Chain) -> Message:
    """Return a warning that explains a coefficient above 1 without a gain of energy."""
    share = _inertia_at_rest(velocity_field(starting)) / _inertia_at_rest(velocity_field(ending))
    return warning(
        "restitution-above-one",
        value=Quantity(kept.value),
        share=Quantity(share, figures=3),
        kept=Quantity(100.0 * kept.value**2 * share, "percent", 3),
    )


def _adds_energy(kept: RestitutionCoefficient, *, ending: Chain, starting: Chain) -> bool:
    """Return whether an impact would add energy."""
    return kept.value > 0.0 and kept.value**2 * _inertia_at_rest(velocity_field(starting)) > _inertia_at_rest(
        velocity_field(ending)
    ) * (1 + 1e-9)


def _require_no_gain(kept: RestitutionCoefficient, *, ending: Chain, starting: Chain, name: str) -> None:
    """Raise MechanismError for a coefficient that would add energy."""
    if _adds_energy(kept, ending=ending, starting=starting):
        raise MechanismError(
            f'mechanism "{name}": restitution {kept.value:.3g} ({source_phrase(kept.source)}) would add energy at the '
            'impact, for the two hinges differ; use "momentum" or a number'
        )


def _kinetic_product(ending: VelocityField, starting: VelocityField) -> float:
    """Return the kinetic product of two fields [kg m2], the second mirrored back to the sign of the first.

    The product of a field with itself, not mirrored, is the inertia I of the branch.
    """
    along = np.sum(ending.horizontal_mass * ending.dx * -starting.dx)
    up = np.sum(ending.vertical_mass * ending.dz * starting.dz)
    return float(along + up + np.sum(ending.inertia * ending.rate * -starting.rate))


def _inertia_at_rest(moving: VelocityField) -> float:
    """Return I of the branch at rest [kg m2]."""
    squares = (
        moving.horizontal_mass * moving.dx**2 + moving.vertical_mass * moving.dz**2 + moving.inertia * moving.rate**2
    )
    return float(np.sum(squares))


def _angular_momentum(moving: VelocityField, x: float, z: float) -> float:
    """Return the angular momentum about a point (x, z) in the frame of the field, clockwise [kg m2]."""
    horizontal = (moving.z - z) * moving.horizontal_mass * moving.dx
    vertical = (moving.x - x) * moving.vertical_mass * moving.dz
    return float(np.sum(horizontal - vertical + moving.inertia * moving.rate))
