"""Cost of a contact: 500 rotations of each shape, from rest through opening and crushing.

Run as a script. What is asked for is less than 0.2 ms for a polygon of 50 sides.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np
import shapely

from assess.interfaces.contact import JointLaw, contact, thresholds
from assess.interfaces.section import annulus, circle, hollow_rectangle, polygon, rectangle

ROTATIONS = 500
LAW = JointLaw(3.4e8, 1.28e6)
ANGLES = np.linspace(0.0, 2.0 * math.pi, 50, endpoint=False)
FIFTY = shapely.Polygon(0.75 * np.column_stack([np.cos(ANGLES), np.sin(ANGLES)]))
SHAPES = {
    "polygon of 50 sides": lambda: polygon(FIFTY, direction=(1.0, 0.3)),
    "rectangle": lambda: rectangle(1.2, 3.0),
    "hollow rectangle, askew": lambda: hollow_rectangle(6.0, 8.0, inner=(3.6, 5.6), direction=(1.0, 0.4)),
    "circle": lambda: circle(1.5),
    "annulus": lambda: annulus(1.5, inner=1.1),
}
SHARES = (0.05, 0.3, 0.7)  # of the force over what can be carried


def milliseconds(work: Callable[[], object]) -> float:
    """The best of fifty."""
    best = math.inf
    for _ in range(50):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return 1e3 * best


def main() -> None:
    """The table."""
    columns = "".join(f"{f'N = {share} A f':>14}" for share in SHARES)
    print(f"{f'{ROTATIONS} rotations, ms':<28}{columns}{'the section':>14}")  # noqa: T201
    for name, make in SHAPES.items():
        section, costs = make(), []
        for share in SHARES:
            N = share * LAW.strength * section.area
            phi = np.linspace(0.0, 5.0 * max(thresholds(section, LAW, normal_force=N)), ROTATIONS)
            costs.append(
                milliseconds(lambda section=section, N=N, phi=phi: contact(section, LAW, normal_force=N, rotation=phi))
            )
        costs.append(milliseconds(make))
        print(f"{name:<28}" + "".join(f"{cost:>14.3f}" for cost in costs))  # noqa: T201


if __name__ == "__main__":
    main()
