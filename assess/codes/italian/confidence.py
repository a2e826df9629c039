"""The confidence factor FC of the Italian codes: which one decides, and which is shown beside it.

FC divides the acceleration of the mechanism once, and no displacement. Where the compressive strength of the masonry
is not in the multiplier, FC is that of LC1 whatever the level of knowledge (C8.7.1.2.1.3; 617/2009: C8A.4.1).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from assess.codes.check import Check, Step, step
from assess.codes.italian.edition import Edition, Options
from assess.messages.message import Quantity, message

LEVELS: Mapping[str, float] = {"LC1": 1.35, "LC2": 1.20, "LC3": 1.00}  # C8.5.4 (617/2009: C8A.1.1)
LEAST_KNOWN = LEVELS["LC1"]
OF_LEVEL: Mapping[str, str] = {"LC1": "LC1's, as given", "LC2": "LC2's, as given", "LC3": "LC3's, as given"}


@dataclass(frozen=True)
class Confidence:
    """FC [-], where it comes from, and the larger one that decides where this one only informs."""

    factor: float
    why: str
    instead_of: float | None = None


def confidence_factors(options: Options, *, crushing: bool, level: str | None) -> tuple[Confidence, ...]:
    """Return the factor that decides, then the one given where it is lower, which is for comparison.

    Parameters
    ----------
    options : the factor given, if any
    crushing : whether the mechanism models crushing of the masonry
    level : of knowledge, None where it is not given

    Returns
    -------
    tuple of Confidence
    """
    deciding, given = _by_code(crushing, level), options.confidence_factor
    if given is None or given == deciding.factor:
        return (deciding,)
    if given > deciding.factor:
        return (Confidence(given, "given, larger than the code's"),)
    return deciding, Confidence(given, "given, below the code's: for comparison", deciding.factor)


def _by_code(crushing: bool, level: str | None) -> Confidence:
    if not crushing:
        return Confidence(LEAST_KNOWN, "LC1's, as crushing of the masonry is not modelled")
    if level is None:
        return Confidence(LEAST_KNOWN, "LC1's, as no level of knowledge is given")
    return Confidence(LEVELS[level], OF_LEVEL[level])


def confidence_step(confidence: Confidence, edition: Edition) -> Step:
    """Write FC."""
    words = "confidence factor, divides the acceleration once"
    return step("FC", words, edition.confidence, "of the level of knowledge", confidence.factor, remark=confidence.why)


def mark_informative(check: Check, confidence: Confidence) -> Check:
    """Return the check as it is, or marked as one for comparison where its factor is below the code's."""
    if confidence.instead_of is None:
        return check
    values = {"given": Quantity(confidence.factor), "deciding": Quantity(confidence.instead_of)}
    return replace(check, informs=True, remarks=(*check.remarks, message("lower-confidence-factor", values)))
