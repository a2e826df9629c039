"""What a hinge presses on, as an engineer states it: without tension, linear up to the strength, then plastic."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Model = Literal["rigid", "flexible", "semi-flexible", "flexible-thesis"]


@dataclass(frozen=True, kw_only=True)
class Shape:
    """The contact by one of its sizes [m], the first along the direction of motion, the second across.

    rectangle : (thickness, length); hollow_rectangle : with the sizes of the hole behind them; circle : diameter
    annulus : (diameter, inner diameter); polygon : corners (x, y) in plan
    """

    rectangle: tuple[float, float] | None = None
    hollow_rectangle: tuple[float, float, float, float] | None = None
    circle: float | None = None
    annulus: tuple[float, float] | None = None
    polygon: tuple[tuple[float, float], ...] | None = None


@dataclass(frozen=True, kw_only=True)
class Interface:
    """The joint under a hinge.

    model : "rigid" (with a strength: crushing only), or "flexible"; with its moment, but inertia about a fixed hinge:
    "semi-flexible", about the resultant: "flexible-thesis"
    stiffness : normal, per area [Pa/m], or course_thickness : of the layer that yields [m]
    strength : in compression [Pa], infinite for none; the material's where None (not for a rigid one)
    shape : "outline" of the body at the hinge, or sizes
    """

    model: Model = "rigid"
    stiffness: float | None = None
    course_thickness: float | None = None
    strength: float | None = None
    shape: Literal["outline"] | Shape = "outline"
