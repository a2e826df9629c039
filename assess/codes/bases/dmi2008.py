"""NTC 2008 with Circolare 617/2009, superseded in 2018: local mechanisms (C8A.4)."""

from __future__ import annotations

from assess.codes.basis import Basis, IndexKind, LimitState, Method, Premise, Role

EQUALS = (Method("dmi2008-linear"), Method("dmi2008-nonlinear"))

DMI2008 = Basis(
    name="dmi2008",
    edition="NTC 2008 (DM 14.1.2008) with Circolare 617/2009, superseded in 2018",
    index=IndexKind.ZETA_E,
    states=(
        LimitState("SLV", "SLV", ("SLV",), (EQUALS,)),
        LimitState("SLD", "SLD", ("SLD",), ((Method("dmi2008-linear"),),), Role.BESIDES, classes=("IV",)),
    ),
    default="SLV",
    premises=(Premise.SOUND_MASONRY,),
    clauses=(
        ("linear with q = 2, or the capacity spectrum: the one named, both where none is", "C8A.4.2.3"),
        ("above the ground both the ground's and the floor's demand", "C8A.4.2.3"),
        ("FC of LC1 where crushing is not modelled", "C8A.4.1"),
    ),
    uncompared=("all clauses are from memory of the circular",),
)
