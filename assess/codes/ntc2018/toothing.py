"""Friction of a toothed crack between a wall that overturns and the cross walls it is partly bonded to (C8.7.1.2).

It may enter the multiplier alpha0 of a simple overturning, where the height of the crack is the one of least alpha0. It
is not shown to last up to collapse, so it is in no d0*; in a(d) only up to a displacement at which the overlap is lost.
Loads on top of the cross walls are not in it.
"""

from __future__ import annotations

from assess.errors import ProcedureError

FRICTION = 0.577  # mu of reference [-]
LEVER = 1.0 / 3.0  # height of the resultant over the foot of the turning part, of the height of the crack


def toothing_friction(
    *,
    height: float,
    unit_height: float,
    overlap: float,
    thickness: float,
    unit_weight: float,
    friction: float = FRICTION,
) -> float:
    """Return F = 0.4 n (n + 1) Phi mu l^2 t_s w of one cross wall, with n = h / h_b and Phi = h_b / l (C8.7.1.2).

    It acts at a third of the height of the crack above the foot of the part that turns: the joint below i courses
    carries their weight, so that the friction grows downwards as a triangle.

    Parameters
    ----------
    height : of the crack, h [m]
    unit_height : mean height of the units, h_b [m]
    overlap : length of one friction joint, l [m]
    thickness : of the cross wall, t_s [m]
    unit_weight : of the cross wall, w [N/m3]
    friction : mu [-]

    Returns
    -------
    float [N]

    Raises
    ------
    ProcedureError
        For a crack lower than one course.
    """
    n, Phi = height / unit_height, unit_height / overlap
    if n < 1.0:
        raise ProcedureError(f"toothed crack of {height:.4g} m: C8.7.1.2 needs at least one course, {unit_height:.4g}")
    return 0.4 * n * (n + 1.0) * Phi * friction * overlap**2 * thickness * unit_weight
