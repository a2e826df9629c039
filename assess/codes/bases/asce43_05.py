"""ASCE/SEI 43-05: rocking of unanchored bodies by response histories, or by the approximate method of A.2."""

from __future__ import annotations

from assess.codes.basis import Acceptance, Basis, IndexKind, LimitState, Method

ASCE43_05 = Basis(
    name="asce43-05",
    edition="ASCE/SEI 43-05",
    index=IndexKind.DEMAND_CAPACITY,
    states=(
        LimitState(
            "DBE",
            "no overturning",
            ("DBE",),
            ((Method("asce43-05-history"),), (Method("asce43-05-spectrum", Acceptance.IF_NAMED),)),
        ),
    ),
    default="DBE",
    premises=(),
    clauses=(
        (
            "mean of the maxima of at least five records within half of the rotation that overturns",
            "response histories",
        ),
        ("the approximate method only where it is named, against one third", "Appendix A.2"),
    ),
    uncompared=(
        "the methods were read in the thesis and in an excerpt of Appendix A, not in the printed standard",
        "the limit of clause 7.1 for A.2 could not be read: one third of the rotation that overturns is taken",
    ),
)
