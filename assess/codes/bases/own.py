"""A basis that the engineer states: the procedures listed, all or any of which must pass."""

from __future__ import annotations

from collections.abc import Sequence

from assess.codes.basis import Basis, IndexKind, LimitState, Method


def own(procedures: Sequence[str], *, rule: str, statement: str) -> Basis:
    """Return the basis of these procedures.

    Parameters
    ----------
    procedures : names, the most refined first
    rule : "all" makes them equals; with "any" the first that is answered decides
    statement : the engineer's, for the report

    Returns
    -------
    Basis
    """
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
