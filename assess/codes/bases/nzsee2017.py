"""NZSEE/MBIE 2017, Part C8: face-loaded walls, as a share of the new building standard."""

from __future__ import annotations

from assess.codes.basis import Basis, IndexKind, LimitState, Method, Premise

NZSEE2017 = Basis(
    name="nzsee2017",
    edition="NZSEE/MBIE Guidelines 2017, C8",
    index=IndexKind.NBS,
    states=(LimitState("ULS", "ULS", ("ULS",), ((Method("nzsee2017-face-loaded"),),)),),
    default="ULS",
    premises=(Premise.ANCHORAGE,),
    clauses=(("usable rotation of a face-loaded wall against the demand on a part", "C8.8.5, NZS 1170.5 section 8"),),
    uncompared=("the chapter was not compared with its print; its formulas were derived anew",),
)
