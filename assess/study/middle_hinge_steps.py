"""The force of the hinge C of three blocks at rest, as lines of a calculation sheet: moments of two of the blocks."""

from __future__ import annotations

from dataclasses import dataclass
from math import isclose

import numpy as np
from scipy.constants import g

from assess.codes.calculation_step import Given, Step, step
from assess.mechanisms.flexible import FlexibleChain
from assess.mechanisms.joint_equilibrium import JointEquilibrium, each_contact
from assess.mechanisms.joint_forces import load_force
from assess.mechanisms.jointed_chain import JointedChain
from assess.study.section_steps import BALANCE
from spectra.arrays import ComplexArray

SAME = 1e-6  # relative: of two forces that are one
LEAST_ARM = 1e-9  # m: a shorter one is rounding

Acting = tuple[complex, complex]
"""Place, x + iz [m], and force to the right and up [N]."""


def points_at_rest(jointed: JointedChain, rest: JointEquilibrium) -> ComplexArray:
    """Return the resultants of the joints at rest, x + iz [hinges] [m]."""
    inside = each_contact(rest.contacts, "resultant", rest.closure.shape)
    return np.asarray((rest.configuration.corner + inside * jointed.faces(rest.configuration))[:, 0])


@dataclass(frozen=True)
class MiddleHinge:
    """The force of the hinge C on the third block at rest.

    moments : lines of the two moments; given : what its formulas hold; force : to the right and up [N]
    """

    moments: tuple[Step, Step]
    given: Given
    force: complex


BELOW = "((x_B − x_C) (z_C − z_D) − (z_B − z_C) (x_C − x_D))"


def middle_hinge(flexible: FlexibleChain, rest: JointEquilibrium) -> MiddleHinge:
    """Solve the force of C, from the moments of the second block about B and of the third about D.

    Parameters
    ----------
    flexible : the chain of three blocks
    rest : its joints at rest
    """
    B, C, D = (complex(each) for each in points_at_rest(flexible.jointed, rest)[1:])
    second, M_2 = _moment_step(flexible, 1, "M_2", ("x_B", "z_B"), B)
    third, M_3 = _moment_step(flexible, 2, "M_3", ("x_D", "z_D"), D)
    arm, other = B - C, C - D
    given: Given = {
        "M_2": (M_2, "N m"), "M_3": (M_3, "N m"),
        "x_B": (B.real, "m"), "z_B": (B.imag, "m"), "x_C": (C.real, "m"), "z_C": (C.imag, "m"),
        "x_D": (D.real, "m"), "z_D": (D.imag, "m"),
    }  # fmt: skip
    force = (M_2 * other - M_3 * arm) / (arm.real * other.imag - arm.imag * other.real)
    return MiddleHinge((second, third), given, force)


def vertical_step(hinge: MiddleHinge, *, above: bool) -> Step:
    """Write the vertical force of C, down: what presses on the third block (above), or else on the second."""
    moments = "(M_3 (z_B − z_C) − M_2 (z_C − z_D))" if above else "(M_2 (z_C − z_D) − M_3 (z_B − z_C))"
    down = -hinge.force.imag if above else hinge.force.imag
    words = "vertical force of C, by both moments"
    return step("V_C", words, BALANCE, f"{moments} / {BELOW}", down, "N", given=hinge.given)


def horizontal_step(hinge: MiddleHinge, H: float) -> Step | None:
    """Write the horizontal force of a joint where it is that of C; None where loads change it between them."""
    along = hinge.force.real
    if not isclose(abs(H), abs(along), rel_tol=SAME):
        return None
    forward = "(M_2 (x_C − x_D) − M_3 (x_B − x_C))"
    moments = forward if H * along > 0.0 else "(M_3 (x_B − x_C) − M_2 (x_C − x_D))"
    words = "horizontal force, that of C"
    return step("H", words, BALANCE, f"{moments} / {BELOW}", H, "N", given=hinge.given)


def _moment_step(
    flexible: FlexibleChain, block: int, symbol: str, axis: tuple[str, str], about: complex
) -> tuple[Step, float]:
    """Write the clockwise moment of weights and loads of a block about the resultant of one of its joints."""
    x_0, z_0 = axis
    given: dict[str, tuple[float, str]] = {}
    terms, total = list[str](), 0.0
    for number, (at, force) in enumerate(_acting(flexible, block), start=1):
        for name, value, place, pole, origin in (
            (f"V_{number}", -force.imag, ("x", at.real), x_0, about.real),
            (f"H_{number}", force.real, ("z", at.imag), z_0, about.imag),
        ):
            if value == 0.0:
                continue
            here, there = f"{place[0]}_{number}", place[1] if abs(place[1] - origin) > LEAST_ARM else origin
            given |= {name: (value, "N"), here: (there, "m"), pole: (origin, "m")}
            terms.append(f"{name} ({here} − {pole})")
            total += value * (there - origin)
    words = "clockwise moment of weight and loads"
    return step(symbol, words, BALANCE, " + ".join(terms), total, "N m", given=given), total


def _acting(flexible: FlexibleChain, number: int) -> list[Acting]:
    """Return weight and loads of a block at rest."""
    block = flexible.jointed.chain.blocks[number]
    acting = [(complex(*block.centroid), -1j * g * block.mass)]
    for load in flexible.jointed.chain.loads:
        if load.block == number:
            at = complex(*load.at)
            acting.append((at, complex(load_force(flexible.jointed, load, np.array([at]))[0])))
    return acting
