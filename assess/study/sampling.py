"""Records whose time step is too coarse for a mechanism.

Between samples the ground acceleration is taken as a straight line. That lowers a harmonic of n samples a period by
sinc^2(pi / n), 9 % for 6, and what is beyond half the sampling rate is not in the record at all. The integration itself
takes steps of its own, whatever the record's.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assess.messages.message import Message, Quantity, warning
from assess.oscillator import Oscillator, elastic_frequency
from assess.study.envelopes import EnvelopeCase
from assess.study.motions import ScaledRecord
from assess.study.study import Equation

FEWEST = 6.0
"""Samples in a period of the elastic vibration about rest."""
FEWEST_ROCKING = 10.0
"""Samples within 1 / p, in which a rocking rotation grows e-fold."""
NAMED = 3
"""Records that a notice names."""


def coarse_record_messages(rockers: Sequence[EnvelopeCase], motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    """One for each mechanism, by name, that some record is too coarse for."""
    for rocker in rockers:
        longest, why = longest_step(rocker.oscillator, equation=rocker.equation)
        coarse = [motion.record for motion in motions if motion.record.dt > longest]
        if coarse:
            named = ", ".join(f"{record.id} ({record.dt:.4g} s)" for record in coarse[:NAMED])
            more = f" and {len(coarse) - NAMED} more" if len(coarse) > NAMED else ""
            yield warning(
                "coarse-record",
                f"mechanisms.{rocker.name}",
                records=f"{named}{more}",
                motion=why,
                longest=Quantity(longest, "time", 3),
            )


def longest_step(oscillator: Oscillator, *, equation: Equation) -> tuple[float, str]:
    """The longest step [s] of a record for this oscillator, and what asks for it, in words.

    The linearised equation knows no vibration about rest.
    """
    p = max(branch.linearised.p for branch in oscillator.branches)
    elastic = max((elastic_frequency(branch) or 0.0) for branch in oscillator.branches)
    if equation == "exact" and FEWEST * elastic > FEWEST_ROCKING * p:
        return 1.0 / (FEWEST * elastic), f"its elastic vibration on the joints, {elastic:.3g} Hz"
    return 1.0 / (FEWEST_ROCKING * p), f"its rocking, p = {p:.3g} 1/s"
