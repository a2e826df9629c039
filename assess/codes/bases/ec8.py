"""EN 1998-1: elements that carry no floor, by the static force of 4.3.5."""

from __future__ import annotations

from assess.codes.basis import Basis, IndexKind, LimitState, Method, Premise

EC8 = Basis(
    name="ec8",
    edition="EN 1998-1:2004, 4.3.5",
    index=IndexKind.DEMAND_CAPACITY,
    states=(LimitState("ULS", "element", ("ULS", "NCR"), ((Method("ec8-element"),),)),),
    default="ULS",
    premises=(Premise.NO_FLOORS,),
    clauses=(("static force on a non-structural element", "4.3.5.2 (4.24), (4.25)"),),
    uncompared=("q_a and gamma_a of the element are from memory; national annexes may change them",),
)
