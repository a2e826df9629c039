"""A colour for each mechanism, one for all that differ by their joints alone."""

from __future__ import annotations

from assess.results import Results
from reports.figures.style import MECHANISMS, Pen
from reports.variants import group_variants

DASHES = ("-", "--", ":", "-.")
WIDTHS = (1.2, 2.2, 0.6)  # of lines [pt], of mechanisms that share a colour by chance


def mechanism_pens(results: Results) -> dict[str, Pen]:
    """Return how each mechanism is drawn: those that differ by their joints alone in one colour, each with a dash."""
    made = {}
    for place, group in enumerate(group_variants(results)):
        colour, width = MECHANISMS[place % len(MECHANISMS)], WIDTHS[place // len(MECHANISMS) % len(WIDTHS)]
        for number, mechanism in enumerate(group):
            made[mechanism.name] = Pen(colour, DASHES[number % len(DASHES)], "", width)
    return made
