"""ASCE/SEI 41-13: permissible h/t of unreinforced masonry walls out of plane (11.3.3, Table 11-5)."""

from __future__ import annotations

from assess.codes.basis import Basis, IndexKind, LimitState, Method, Premise

TABLE = ((Method("asce41-13-ht"),),)

ASCE41_13 = Basis(
    name="asce41-13",
    edition="ASCE/SEI 41-13",
    index=IndexKind.DEMAND_CAPACITY,
    states=(
        LimitState("LS", "life safety, collapse prevention", ("BSE-1E", "LS"), TABLE),
        LimitState("CP", "life safety, collapse prevention", ("BSE-2E", "CP"), TABLE),
    ),
    default="",
    premises=(Premise.ANCHORAGE, Premise.COLLAR_JOINTS),
    clauses=(("permissible h/t at S_X1 of the declared hazard level", "Table 11-5"),),
    uncompared=("the table is from memory of the standard",),
)
