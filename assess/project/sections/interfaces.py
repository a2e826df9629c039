"""The tables `interface` and `interfaces` of a mechanism."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Discriminator, Tag, model_validator

from assess.project.quantities import JointStiffness, PositiveLength, Strength
from assess.project.section import Section, wrong
from assess.project.sections.corners import Corners
from assess.project.sections.uncertain_number import UNCERTAIN

Letter = Literal["A", "B", "C", "D"]
Size = Annotated[PositiveLength, UNCERTAIN]


SIZES = {
    "rectangle": "[t, l]",
    "hollow_rectangle": "[t, l, t_in, l_in]",
    "circle": "d",
    "annulus": "[d, d_in]",
    "polygon": "[[x, y], …]",
}


def _hollow(sizes: tuple[float, ...]) -> tuple[float, ...]:
    """Check that the hole of an outline is smaller than the outline."""
    half = len(sizes) // 2
    for outside, inside in zip(sizes[:half], sizes[half:], strict=True):
        if inside >= outside:
            raise wrong((), f"the hole, {inside:g} m, must be smaller than the outside, {outside:g} m")
    return sizes


def _shape(value: Any) -> Any:
    """Check that the value is "outline" or a table."""
    if value == "outline" or isinstance(value, dict | Shape):
        return value
    meant = [value] if value in list(SIZES) else list(SIZES)
    forms = ", ".join(f"{{ {name} = {SIZES[name]} }}" for name in meant)
    raise wrong((), f'not allowed; write "outline", or {forms}')


class Shape(Section):
    """The contact by one of its sizes, the first along the direction of motion, the second across."""

    rectangle: tuple[Size, Size] | None = None
    """[thickness, length]"""
    hollow_rectangle: Annotated[tuple[Size, Size, Size, Size], AfterValidator(_hollow)] | None = None
    """[thickness, length, inner thickness, inner length]"""
    circle: Size | None = None
    """diameter"""
    annulus: Annotated[tuple[Size, Size], AfterValidator(_hollow)] | None = None
    """[diameter, inner diameter]"""
    polygon: Corners | None = None
    """corners [[x, y], …] in plan"""

    @model_validator(mode="after")
    def _one(self) -> Self:
        given = [key for key, value in self.entries().items() if value is not None]
        if len(given) != 1:
            raise wrong(given[-1] if given else "rectangle", f"one shape is needed, not {len(given)}")
        return self


class Interface(Section):
    """What a hinge presses on: without tension, linear up to the strength, then plastic without memory."""

    model: Literal["rigid", "flexible", "semi-flexible", "flexible-thesis"] = "rigid"
    """"rigid" (with strength: crushing only), "flexible"; with its moment, but inertia about a fixed hinge:
    "semi-flexible", about the resultant: "flexible-thesis\""""
    stiffness: Annotated[JointStiffness, UNCERTAIN] | None = None
    """normal stiffness per area, like "10 GPa/m"; or give course_thickness"""
    course_thickness: Annotated[PositiveLength, UNCERTAIN] | None = None
    """thickness of the layer that yields: stiffness = young_modulus of the material / course_thickness"""
    strength: Annotated[Strength, UNCERTAIN] | None = None
    """in compression, like "1 MPa", or "inf"; the material's if absent (not for a rigid one)"""
    shape: Annotated[
        Annotated[Literal["outline"], Tag("<outline>")] | Annotated[Shape, Tag("<shape>")],
        Discriminator(lambda value: "<shape>" if isinstance(value, dict | Shape) else "<outline>"),
        BeforeValidator(_shape),
    ] = "outline"
    """"outline" of the mesh at the hinge, or { rectangle | hollow_rectangle | circle | annulus | polygon = … }"""

    @model_validator(mode="after")
    def _stiffness_is_given_once(self) -> Self:
        given = [key for key in ("stiffness", "course_thickness") if getattr(self, key) is not None]
        if self.model == "rigid" and given:
            raise wrong(given[0], 'is for flexible interfaces; write model = "flexible", or remove it')
        if self.model != "rigid" and len(given) != 1:
            raise wrong("stiffness", "give either stiffness or course_thickness")
        return self
