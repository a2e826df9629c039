"""The two figures of the annex of verification."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from assess.results.verification import VerificationResults
from reports.document import Figure, Prose
from reports.figures import verification as drawing
from reports.language.texts import say


def figures(results: VerificationResults) -> Iterator[Prose | Figure]:
    """Yield how to read them, differences over tolerance by source, and values of the program over those expected."""
    yield Prose(
        (
            say(
                "Each point is one value. Left of the line at 1 the difference is within the tolerance, whose reason "
                "stands with the case; values that agree to more digits than are drawn stand at the left edge."
            ),
        )
    )
    shares = tuple(
        (case.key.partition("/")[0], case.source.standing, share) for case in results.cases for share in case.shares
    )
    if shares:
        caption = say("Difference of every value over its tolerance, by source.")
        yield Figure("differences", caption, partial(drawing.draw_differences, shares))
    pairs = tuple(
        (value.reference, value.found)
        for each in results.quantities
        for value in each.values
        if value.found is not None
    )
    caption = say("Value of the program against the expected one, without signs; zeros are left out.")
    yield Figure("agreement", caption, partial(drawing.draw_agreement, pairs))
