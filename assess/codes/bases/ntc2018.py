"""NTC 2018 with Circolare 7/2019: local mechanisms of existing masonry buildings (8.3, 8.5.4, C8.7.1.2)."""

from __future__ import annotations

from assess.codes.basis import Acceptance, Basis, IndexKind, LimitState, Method, Premise, Role

HISTORY = Method("ntc2018-history", Acceptance.IF_NAMED)
NONLINEAR = Method("ntc2018-nonlinear")
LINEAR = Method("ntc2018-linear", Acceptance.IF_NAMED, yields_to=("ntc2018-nonlinear",))

NTC2018 = Basis(
    name="ntc2018",
    edition="NTC 2018 (DM 17.1.2018) with Circolare 7/2019",
    index=IndexKind.ZETA_E,
    states=(
        LimitState("SLV", "SLV", ("SLV",), ((HISTORY,), (NONLINEAR,), (LINEAR,))),
        LimitState("SLC", "SLC", ("SLC",), ((HISTORY,), (NONLINEAR,))),
        LimitState("SLD", "SLD", ("SLD",), ((Method("ntc2018-linear"),),), Role.BESIDES, classes=("IV",)),
    ),
    default="SLV",
    premises=(Premise.SOUND_MASONRY,),
    clauses=(
        ("SLV, or alternatively SLC, chosen once for the building", "NTC 8.3, C8.7.1.2.1.6"),
        ("for use class IV also SLD", "NTC 8.3, 7.3.6"),
        ("non-linear kinematic analysis decides", "C8.7.1.2.1.6, C8.7.1.2.1.8"),
        ("linear with q = 2 where no capacity curve is worked out, for SLV only", "C8.7.1.2.1.7"),
        ("time histories where the project declares them", "C8.7.1.2.1.9, 7.3.5, 3.2.3.6"),
        ("FC of LC1 where crushing is not modelled", "C8.5.4, C8.7.1.2.1.3"),
        ("rigid chain credible only for masonry that does not disintegrate", "C8.7.1.2"),
    ),
    uncompared=("clauses by a public transcription of the decree and the circular, not by the printed texts",),
)
