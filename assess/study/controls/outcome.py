"""The outcome of a control: made, made without a tolerance, or not made; and the warning of one that failed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from assess.messages.message import Message, Quantity, note, warning
from assess.results import Control, ControlKind

TOLERANCE: Mapping[ControlKind, float] = {
    "equilibrium": 1e-6,
    "energy": 1e-3,
    "hand-multiplier": 1e-6,
    "convergence": 1e-2,
}
"""The largest relative difference that each kind of control accepts: of rounding, of quadrature, of chaos."""
FAILED: Mapping[ControlKind, str] = {
    "equilibrium": "control-not-in-equilibrium",
    "energy": "control-energy-lost",
    "hand-multiplier": "control-other-multiplier",
    "convergence": "control-not-converged",
}
"""The warning of each kind of control that fails."""


def made(
    kind: ControlKind,
    mechanism: str,
    quantity: str,
    *,
    value: float,
    reference: float,
    scale: float,
    dimension: str,
    note: Message,
) -> Control:
    """Return a control that was made.

    Parameters
    ----------
    kind : str
        Its kind, which decides its tolerance.
    mechanism, quantity : str
        What is compared.
    value, reference : float
        The program's own value, and that found another way [dimension].
    scale : float
        What the difference is relative to, positive [dimension].
    dimension : str
        Dimension of the values.
    note : Message
        How it was made.

    Returns
    -------
    Control
        Met if the difference is at most the tolerance.
    """
    difference, tolerance = abs(value - reference) / scale, TOLERANCE[kind]
    return Control(
        kind, mechanism, quantity, value, reference, dimension, difference, tolerance, difference <= tolerance, note
    )


def not_made(kind: ControlKind, mechanism: str, quantity: str, *, dimension: str, why: str) -> Control:
    """Return a control that was not made; why: the key of the note that says so."""
    return Control(kind, mechanism, quantity, None, None, dimension, None, TOLERANCE[kind], None, note(why, mechanism))


def warnings_of(controls: Sequence[Control]) -> tuple[Message, ...]:
    """Return a warning for each control that failed."""
    return tuple(
        warning(
            FAILED[each.kind],
            each.mechanism,
            difference=Quantity(100.0 * each.difference, "percent", 2),
            tolerance=Quantity(100.0 * each.tolerance, "percent", 2),
        )
        for each in controls
        if each.met is False and each.difference is not None
    )
