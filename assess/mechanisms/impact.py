"""The restitution of the impact that ends a branch, for every kind of mechanism.

At rest the blocks of both branches coincide, and each branch is a field of velocities: (x', z', theta') of every block
for a unit rate of phi. The rules differ in what is conserved from one field to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from math import isclose
from typing import Literal

from assess.errors import MechanismError
from assess.loads.load import PointMass
from assess.mechanisms.chain import Chain
from assess.mechanisms.rest import plain_block
from assess.mechanisms.restitution import Restitution, housner, sorrentino, source_text
from assess.mechanisms.velocity_field import angular_momentum, inertia_at_rest, kinetic_product, velocity_field
from assess.messages.message import Message, Quantity, Term, Value, message, warning

Named = Literal["thesis", "housner", "sorrentino", "momentum"]
RestitutionChoice = float | Named | None
"""A number, a rule by its name, or None: "momentum" if a load moves with the mechanism, else the rule of the thesis."""
Rule = Callable[[Chain, Chain], Restitution]
Rebound = Callable[[Chain], Restitution]

HOUSNER = (Term("Housner 1963, thesis eq. 3.44"),)
MOMENTUM = (Term("momentum kept over the mechanism"),)
ABOUT_BASE = (Term("angular momentum about the new base hinge, Sorrentino et al. 2008, thesis eq. 3.46"),)
NO_REBOUND = (Term("no rebound"),)
GIVEN = (Term("given"),)
WORST_OF_THREE = Term("histories take the worst of 0.5, 1 and 1.5 times it")
NOTABLE = 0.03  # a difference between two coefficients that is explained in a warning
REBOUNDS = (1.0, 0.5, 1.5)  # factors on the rebound of 3.45 in histories, 1 first
SAME = 5e-4  # coefficients this close are printed alike


def conserve_momentum(ending: Chain, starting: Chain) -> Restitution:
    """Conserve momentum: the impulses at the new hinges do no work on the new motion, so project the old field onto it.

    For one block this is the angular momentum about the new hinge. No impact by this rule adds energy.
    """
    new = velocity_field(starting)
    return Restitution(-kinetic_product(velocity_field(ending), new) / inertia_at_rest(new), MOMENTUM)


def conserve_about_base(ending: Chain, starting: Chain) -> Restitution:
    """Conserve the angular momentum of the whole about the new base hinge (3.46, there for two plain rectangles).

    This neglects the impulse of the support at the top.
    """
    old, new = velocity_field(ending), velocity_field(starting)
    x, z = starting.hinges[0]
    return Restitution(angular_momentum(old, -x, z) / angular_momentum(new, x, z), ABOUT_BASE)


def housner_rule(ending: Chain, starting: Chain) -> Restitution:
    """Apply 3.44, for a block with two like hinges."""
    return Restitution(housner(plain_block(ending)), HOUSNER)


def single_block_rule(ending: Chain, starting: Chain) -> Restitution:
    """Apply 3.44 for two like hinges; for others it could add energy (tested), so conserve momentum instead."""
    first, second = plain_block(ending), plain_block(starting)
    alike = isclose(first.slenderness, second.slenderness, rel_tol=1e-9) and isclose(
        first.radius, second.radius, rel_tol=1e-9
    )
    return housner_rule(ending, starting) if alike else conserve_momentum(ending, starting)


def sorrentino_rebound(chain: Chain) -> Restitution:
    """Apply 3.45 to one-sided rocking of a block against a wall; without a rebound return 0 with a warning."""
    signed = sorrentino(plain_block(chain))
    source = message("restitution-3-45", {"value": Quantity(signed, "ratio", 3)})
    if signed >= 0:
        return Restitution(0.0, (source,), warning("restitution-no-rebound", **source.values))
    return Restitution(-signed, (source, WORST_OF_THREE), range=REBOUNDS)


def no_rebound(chain: Chain) -> Restitution:
    """Return no rebound for one-sided rocking of a chain: no formula is published, so a number must be given."""
    return Restitution(0.0, NO_REBOUND, warning("restitution-chain"))


_BLOCK: Mapping[Named, Rule] = {"thesis": single_block_rule, "housner": housner_rule, "momentum": conserve_momentum}
TWO_SIDED: Mapping[str, Mapping[Named, Rule]] = {
    "single-block": _BLOCK,
    "equivalent-block": _BLOCK,
    "two-block": {"thesis": conserve_about_base, "sorrentino": conserve_about_base, "momentum": conserve_momentum},
    "four-hinge": {"thesis": conserve_momentum, "momentum": conserve_momentum},
}
ONE_SIDED: Mapping[str, Mapping[Named, Rebound]] = {
    "single-block": {"thesis": sorrentino_rebound, "sorrentino": sorrentino_rebound},
    "equivalent-block": {"thesis": sorrentino_rebound, "sorrentino": sorrentino_rebound},
    "two-block": {"thesis": no_rebound},
    "four-hinge": {"thesis": no_rebound},
}


def moving_masses(*chains: Chain) -> tuple[str, ...]:
    """Return the names of the loads that move with the mechanism, bearing or not."""
    return tuple(dict.fromkeys(load.name for chain in chains for load in chain.loads if isinstance(load, PointMass)))


def find_restitution(
    choice: RestitutionChoice, *, ending: Chain, starting: Chain | None, kind: str, name: str
) -> Restitution:
    """Find the coefficient of the impact that ends one branch.

    A negative value means that the mechanism stops at the impact: 0, with the value found as `stopped`.

    Parameters
    ----------
    choice : a number, a rule by its name, or None for the default
    ending, starting : the chains of the branches before and after the impact; starting None for one-sided rocking
    kind, name : of the mechanism

    Raises
    ------
    MechanismError : a rule that does not apply to this kind, or a named one that adds energy
    """
    if isinstance(choice, int | float):
        return Restitution(choice, GIVEN, _flattering(choice, ending=ending, starting=starting))
    rules = (ONE_SIDED if starting is None else TWO_SIDED)[kind]
    if choice is not None and choice not in rules:
        sides = "one" if starting is None else "two"
        known = ", ".join(f'"{rule}"' for rule in rules)
        raise MechanismError(
            f'mechanism "{name}": restitution "{choice}" is not for a {kind} with sides = "{sides}"; use {known} or a '
            "number"
        )
    if starting is None:
        return ONE_SIDED[kind][choice or "thesis"](ending)
    rule = choice or default_rule(ending, starting, kind=kind)
    kept = TWO_SIDED[kind][rule](ending, starting)
    _refuse_gain(kept, ending=ending, starting=starting, name=name)
    told = replace(kept, source=kept.source + compare_rules(rule, kept, ending=ending, starting=starting, kind=kind))
    return _stopped(told) if told.value < 0.0 else _noticed(told, ending=ending, starting=starting)


def _flattering(given: float, *, ending: Chain, starting: Chain | None) -> Message | None:
    """Return a warning if a given restitution takes more energy at each impact than momentum does."""
    by_momentum = 1.0 if starting is None else conserve_momentum(ending, starting).value
    if starting is None or given >= by_momentum - NOTABLE:
        return None
    values = {"given": Quantity(given, figures=3), "momentum": Quantity(by_momentum, figures=3)}
    return warning("restitution-takes-more", **values)


def default_rule(ending: Chain, starting: Chain, *, kind: str) -> Named:
    """Return momentum if a load moves with the mechanism, else the rule of the thesis unless it would add energy."""
    if moving_masses(ending, starting):
        return "momentum"
    kept = TWO_SIDED[kind]["thesis"](ending, starting)
    return "momentum" if _gains(kept, ending=ending, starting=starting) else "thesis"


def compare_rules(rule: Named, kept: Restitution, *, ending: Chain, starting: Chain, kind: str) -> tuple[Message, ...]:
    """Return what the other rule gives, and loads that slide on their seats; nothing if the value is the same."""
    other: Named = "thesis" if rule == "momentum" else "momentum"
    value = TWO_SIDED[kind][other](ending, starting).value
    said: tuple[Message, ...] = ()
    if abs(value - kept.value) > SAME:
        said = (message("restitution-other", {"rule": other, "value": Quantity(value, "ratio", 3)}),)
    if rule != "momentum" or not moving_masses(ending, starting):
        return said
    new = velocity_field(starting, sliding=True)
    slid = -kinetic_product(velocity_field(ending, sliding=True), new) / inertia_at_rest(new)
    if abs(slid - kept.value) <= NOTABLE:
        return said
    return (*said, message("restitution-sliding", {"value": Quantity(slid, "ratio", 3)}))


def _stopped(kept: Restitution) -> Restitution:
    """Return the coefficient of a mechanism that an impact brings to rest: by the rule it would move backwards."""
    notice = warning("restitution-stops", value=Quantity(kept.value, figures=3), source=kept.source[0])
    return replace(kept, value=0.0, notice=notice, stopped=kept.value)


def _noticed(kept: Restitution, *, ending: Chain, starting: Chain) -> Restitution:
    """Add a warning to a coefficient above 1, or well above that of the blocks without their loads."""
    if kept.value > 1.0:
        return replace(kept, notice=_faster(kept, ending=ending, starting=starting))
    loads = moving_masses(ending, starting)
    if not loads:
        return kept
    plain = conserve_momentum(*(without_masses(chain) for chain in (ending, starting))).value
    if kept.value <= plain + NOTABLE:
        return kept
    values: dict[str, Value] = {"value": Quantity(kept.value, figures=3), "plain": Quantity(plain, figures=3)}
    return replace(kept, notice=warning("restitution-of-high-mass", loads=", ".join(loads), **values))


def without_masses(chain: Chain) -> Chain:
    """Return the chain without the loads that move with it."""
    return replace(chain, loads=tuple(load for load in chain.loads if not isinstance(load, PointMass)))


def _faster(kept: Restitution, *, ending: Chain, starting: Chain) -> Message:
    """Return a warning that explains a coefficient above 1 without a gain of energy."""
    share = inertia_at_rest(velocity_field(starting)) / inertia_at_rest(velocity_field(ending))
    return warning(
        "restitution-above-one",
        value=Quantity(kept.value),
        share=Quantity(share, figures=3),
        kept=Quantity(100.0 * kept.value**2 * share, "percent", 3),
    )


def _gains(kept: Restitution, *, ending: Chain, starting: Chain) -> bool:
    """Return whether an impact would add energy."""
    return kept.value > 0.0 and kept.value**2 * inertia_at_rest(velocity_field(starting)) > inertia_at_rest(
        velocity_field(ending)
    ) * (1 + 1e-9)


def _refuse_gain(kept: Restitution, *, ending: Chain, starting: Chain, name: str) -> None:
    """Raise MechanismError for a coefficient that would add energy."""
    if _gains(kept, ending=ending, starting=starting):
        raise MechanismError(
            f'mechanism "{name}": restitution {kept.value:.3g} ({source_text(kept.source)}) would add energy at the '
            'impact, for the two hinges differ; use "momentum" or a number'
        )
