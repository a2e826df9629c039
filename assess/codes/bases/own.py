"""A basis that the engineer states: the procedures listed, all or any of which must hold."""

from __future__ import annotations

from collections.abc import Sequence

from assess.codes.basis import Basis, IndexKind, LimitState, Method


def own(procedures: Sequence[str], *, rule: str, statement: str) -> Basis:
    """The basis of these procedures: with "all" they are equals, with "any" the first that is answered decides."""
    methods = tuple(Method(name) for name in procedures)
    ranks = (methods,) if rule == "all" else tuple((method,) for method in methods)
    return Basis(
        name="own",
        edition="basis stated by the engineer",
        index=IndexKind.DEMAND_CAPACITY,
        states=(LimitState("own", "*", (), ranks),),
        default="own",
        premises=(),
        clauses=((statement, ""),),
        uncompared=(),
    )
