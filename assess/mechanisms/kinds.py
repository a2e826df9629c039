"""The kinds of mechanism that an engineer can state, each declared beside its constructor."""

from __future__ import annotations

from collections.abc import Mapping

from assess.mechanisms.arch_in_plan import HORIZONTAL_ARCH
from assess.mechanisms.assembly import MechanismKind
from assess.mechanisms.four_hinge import FOUR_HINGE
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.single_block import EQUIVALENT_BLOCK, SINGLE_BLOCK, EquivalentBlock
from assess.mechanisms.two_block import TWO_BLOCK
from assess.mechanisms.wedged_block import WEDGED_KINDS

MECHANISM_KINDS: Mapping[str, MechanismKind] = {
    kind.name: kind
    for kind in (SINGLE_BLOCK, TWO_BLOCK, FOUR_HINGE, *WEDGED_KINDS.values(), HORIZONTAL_ARCH, EQUIVALENT_BLOCK)
}

Definition = BlockMechanism | EquivalentBlock
"""What an engineer states of a mechanism, of any kind."""
