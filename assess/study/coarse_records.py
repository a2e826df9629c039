"""Records whose time step is too coarse for a mechanism.

Between samples the ground acceleration is taken as linear. That lowers a harmonic of n samples a period by
sinc^2(pi / n), 9 % for 6; what lies beyond half the sampling rate is not in the record at all. The integration takes
steps of its own, whatever the record's.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assess.messages.message import Message, Quantity, message, warning
from assess.messages.plural import first_names
from assess.oscillator import Oscillator, elastic_frequency
from assess.study.envelopes import EnvelopeCase
from assess.study.motions import ScaledRecord
from assess.study.study import Equation

FEWEST = 6.0
"""Samples in a period of the elastic vibration about rest."""
FEWEST_ROCKING = 10.0
"""Samples within 1 / p, in which a rocking rotation grows e-fold."""
MOST_NAMES = 3
"""Records that a message names."""


def coarse_record_messages(cases: Sequence[EnvelopeCase], motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    """Yield a warning for each mechanism for which some record is too coarse."""
    for case in cases:
        longest, why = longest_step(case.oscillator, equation=case.equation)
        coarse = [motion.record for motion in motions if motion.record.dt > longest]
        if coarse:
            names = first_names([f"{record.id} ({record.dt:.4g} s)" for record in coarse], MOST_NAMES)
            yield warning(
                "coarse-record",
                f"mechanisms.{case.name}",
                records=names,
                motion=why,
                longest=Quantity(longest, "time", 3),
            )


def longest_step(oscillator: Oscillator, *, equation: Equation) -> tuple[float, Message]:
    """Return the longest step of a record for an oscillator [s], and the motion that requires it.

    The linearised equation has no vibration about rest.
    """
    p = max(branch.linearised.p for branch in oscillator.branches)
    elastic = max((elastic_frequency(branch) or 0.0) for branch in oscillator.branches)
    if equation == "exact" and FEWEST * elastic > FEWEST_ROCKING * p:
        return 1.0 / (FEWEST * elastic), message("motion-elastic", {"frequency": Quantity(elastic, "frequency", 3)})
    return 1.0 / (FEWEST_ROCKING * p), message("motion-rocking", {"p": Quantity(p, "angular frequency", 3)})
