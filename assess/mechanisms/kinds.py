"""The kinds of mechanism that an engineer can state."""

from __future__ import annotations

from assess.mechanisms.four_hinge import FourHinge
from assess.mechanisms.single_block import EquivalentBlock, SingleBlock
from assess.mechanisms.two_block import TwoBlock

DirectionSought = SingleBlock | TwoBlock
"""The kinds whose weakest direction is sought if none is given; a four-hinge mechanism is drawn in its plane."""

Definition = SingleBlock | TwoBlock | FourHinge | EquivalentBlock
"""What an engineer states of a mechanism, of any kind."""
