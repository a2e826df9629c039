"""The automatic controls of a run: what each one compares, and whether the difference is within its tolerance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.messages.message import Message
from assess.short_repr import ShortRepr

ControlKind = Literal["equilibrium", "energy", "hand-multiplier", "convergence"]


@dataclass(frozen=True, repr=False)
class Control(ShortRepr):
    """One control of one mechanism: a value of the run beside a reference found another way.

    Values are in SI. `value`, `reference`, `difference` and `met` are None where the control was not made; `note` says
    why. `met` is also None where the two need not agree, which the note explains.

    Parameters
    ----------
    kind : str
        "equilibrium", "energy", "hand-multiplier" or "convergence".
    mechanism : str
        Name of the mechanism.
    quantity : str
        What is compared, in English.
    value : float, optional
        The program's own value.
    reference : float, optional
        The value it is compared with.
    dimension : str
        Dimension of both, a key of `assess.messages.message.UNITS`.
    difference : float, optional
        Relative difference; docs/controls.md says relative to what.
    tolerance : float
        The largest difference that is accepted; 0 where there is none.
    met : bool, optional
        Whether the difference is within the tolerance.
    note : Message
        How the control was made, or why it was not.
    """

    kind: ControlKind
    mechanism: str
    quantity: str
    value: float | None
    reference: float | None
    dimension: str
    difference: float | None
    tolerance: float
    met: bool | None
    note: Message
