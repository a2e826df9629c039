"""Numbers that a project file may hold and no wall or site has: densities, friction, levels, periods."""

from __future__ import annotations

from collections.abc import Iterator

from scipy.constants import g

from assess.messages.message import Message, Quantity, warning
from assess.project import sections
from spectra.spectrum import LARGEST_PLAUSIBLE

LIGHTEST, DENSEST = 100.0, 3500.0  # kg/m3: straw and cork, basalt; metals are denser, and no wall is made of them
ROUGHEST = 2.0  # coefficient of friction of masonry on masonry: tests give 0.3 to 1.2
LONGEST_CORNER = 1.0  # s: T_C* of NTC 2018 is below it everywhere in Italy


def implausible_numbers(content: sections.Content) -> Iterator[Message]:
    """Yield a warning for each number that is beyond what masonry and sites have.

    Parameters
    ----------
    content : of the project file
    """
    for name, material in content.materials.items():
        if not LIGHTEST <= material.density <= DENSEST:
            least, most = Quantity(LIGHTEST, "density"), Quantity(DENSEST, "density")
            given = Quantity(material.density, "density")
            yield warning("density-odd", f"materials.{name}.density", given=given, least=least, most=most)
        if material.friction is not None and material.friction > ROUGHEST:
            where, given = f"materials.{name}.friction", Quantity(material.friction, "ratio")
            yield warning("friction-large", where, given=given, most=Quantity(ROUGHEST, "ratio"))
    for level in content.analysis.levels or ():
        if level > LARGEST_PLAUSIBLE * g:
            given, most = Quantity(level / g, "ground acceleration"), Quantity(LARGEST_PLAUSIBLE, "ground acceleration")
            yield warning("level-large", "analysis.levels", given=given, most=most)
    corner = None if content.site is None else getattr(content.site.spectrum, "t_c_star", None)
    if corner is not None and corner > LONGEST_CORNER:
        given, most = Quantity(corner, "time"), Quantity(LONGEST_CORNER, "time")
        yield warning("corner-long", "site.spectrum.t_c_star", given=given, most=most)
