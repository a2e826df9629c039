"""The bases of a verdict: which limit states of each code decide, by which methods.

They are data; the rules of a verdict are in `assess.codes.verdict`. What a pass depends on goes with the procedure that
gives it (`assess.codes.check.Premise`), whatever the basis.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum


class LimitStateRole(StrEnum):
    """When a limit state decides: as the one chosen for the building, or besides it in some classes of use."""

    CHOSEN = "chosen"
    BESIDES = "besides"


class IndexKind(StrEnum):
    """The measure in which a code gives its answer."""

    ZETA_E = "zeta_E"
    NBS = "%NBS"
    DEMAND_CAPACITY = "D/C"


class Acceptance(StrEnum):
    """Whether a method decides of itself, or only where the project names it in `[verdict] procedures`."""

    ACCEPTED = "accepted"
    IF_NAMED = "if-named"


@dataclass(frozen=True)
class Method:
    """One procedure that may decide a limit state.

    procedure : its name
    acceptance : whether it must be named
    yields_to : procedures that are never stood in for: where one of them is requested, this one is not
    """

    procedure: str
    acceptance: Acceptance = Acceptance.ACCEPTED
    yields_to: tuple[str, ...] = ()


@dataclass(frozen=True)
class LimitState:
    """One limit state of a basis.

    name : as `[verdict] limit_state` writes it
    checked_as : the limit state of the checks of its methods
    actions : what `[site] limit_state` may call the action that belongs to it
    ranks : methods in order of refinement, the most refined first; those of one rank must all pass
    role : whether it is one that may be chosen
    classes : classes of use in which it decides besides the chosen one
    years : return period of its action, where the code fixes it for all buildings [years]; else None
    """

    name: str
    checked_as: str
    actions: tuple[str, ...]
    ranks: tuple[tuple[Method, ...], ...]
    role: LimitStateRole = LimitStateRole.CHOSEN
    classes: tuple[str, ...] = ()
    years: float | None = None


@dataclass(frozen=True)
class Basis:
    """The rules of one code for a verdict.

    edition : how it is cited; index : the measure of the answer; states : its limit states, the default one first
    default : the limit state where none is chosen; empty where the site's own action decides it
    clauses : (rule, clause) pairs for the report
    uncompared : what could not be compared with any text of the standard
    suite_code : the code whose rules a suite of records is held to, as `records.compliance` calls it; empty for none
    circular : that goes with an Italian code, which gives its confidence factors; empty for other codes
    """

    name: str
    edition: str
    index: IndexKind
    states: tuple[LimitState, ...]
    default: str
    clauses: tuple[tuple[str, str], ...]
    uncompared: tuple[str, ...] = ()
    suite_code: str = ""
    circular: str = ""

    @property
    def chosen(self) -> tuple[LimitState, ...]:
        """The limit states of which one is chosen."""
        return tuple(state for state in self.states if state.role == LimitStateRole.CHOSEN)

    @property
    def methods(self) -> tuple[str, ...]:
        """Every procedure that the basis accepts, in order of refinement."""
        return tuple(
            dict.fromkeys(method.procedure for state in self.states for rank in state.ranks for method in rank)
        )


BY_HISTORIES = Method("ntc2018-history", Acceptance.IF_NAMED)
BY_CAPACITY_CURVE = Method("ntc2018-nonlinear")
BY_MULTIPLIER = Method("ntc2018-linear", Acceptance.IF_NAMED, yields_to=("ntc2018-nonlinear",))

NTC2018 = Basis(
    name="ntc2018",
    edition="NTC 2018 (DM 17.1.2018) with Circolare 7/2019",
    index=IndexKind.ZETA_E,
    states=(
        LimitState("SLV", "SLV", ("SLV",), ((BY_HISTORIES,), (BY_CAPACITY_CURVE,), (BY_MULTIPLIER,))),
        LimitState("SLC", "SLC", ("SLC",), ((BY_HISTORIES,), (BY_CAPACITY_CURVE,))),
        LimitState("SLD", "SLD", ("SLD",), ((Method("ntc2018-linear"),),), LimitStateRole.BESIDES, classes=("IV",)),
    ),
    default="SLV",
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
    suite_code="NTC 2018",
    circular="Circolare 7/2019",
)
"""NTC 2018 with Circolare 7/2019: local mechanisms of existing masonry buildings (8.3, 8.5.4, C8.7.1.2)."""
BY_EITHER = (Method("dmi2008-linear"), Method("dmi2008-nonlinear"))

DMI2008 = Basis(
    name="dmi2008",
    edition="NTC 2008 (DM 14.1.2008) with Circolare 617/2009, superseded in 2018",
    index=IndexKind.ZETA_E,
    states=(
        LimitState("SLV", "SLV", ("SLV",), (BY_EITHER,)),
        LimitState("SLD", "SLD", ("SLD",), ((Method("dmi2008-linear"),),), LimitStateRole.BESIDES, classes=("IV",)),
    ),
    default="SLV",
    clauses=(
        ("linear with q = 2, or the capacity spectrum: the one named, both where none is", "C8A.4.2.3"),
        ("above the ground both the ground's and the floor's demand", "C8A.4.2.3"),
        ("FC of LC1 where crushing is not modelled", "C8A.4.1"),
    ),
    uncompared=("all clauses are from memory of the circular",),
    suite_code="NTC 2018",
    circular="Circolare 617/2009",
)
"""NTC 2008 with Circolare 617/2009, superseded in 2018: local mechanisms (C8A.4)."""

NZSEE2017 = Basis(
    name="nzsee2017",
    edition="NZSEE/MBIE Guidelines 2017, C8",
    index=IndexKind.NBS,
    states=(LimitState("ULS", "ULS", ("ULS",), ((Method("nzsee2017-face-loaded"),),)),),
    default="ULS",
    clauses=(("usable rotation of a face-loaded wall against the demand on a part", "C8.8.5, NZS 1170.5 section 8"),),
    uncompared=("the chapter was not compared with its print; its formulas were derived anew",),
    suite_code="NZS 1170.5:2004",
)
"""NZSEE/MBIE 2017, Part C8: face-loaded walls, as a share of the new building standard."""
SLENDERNESS_TABLE = ((Method("asce41-13-ht"),),)

ASCE41_13 = Basis(
    name="asce41-13",
    edition="ASCE/SEI 41-13",
    index=IndexKind.DEMAND_CAPACITY,
    states=(
        LimitState("LS", "life safety, collapse prevention", ("BSE-1E", "LS"), SLENDERNESS_TABLE, years=225.0),
        LimitState("CP", "life safety, collapse prevention", ("BSE-2E", "CP"), SLENDERNESS_TABLE, years=975.0),
    ),
    default="",
    clauses=(("permissible h/t at S_X1 of the declared hazard level", "Table 11-5"),),
    uncompared=("the table is from memory of the standard",),
    suite_code="ASCE 7-16",
)
"""ASCE/SEI 41-13: permissible h/t of unreinforced masonry walls out of plane (11.3.3, Table 11-5)."""

DESIGN_BASIS = "DBE"
ASCE43_05 = Basis(
    name="asce43-05",
    edition="ASCE/SEI 43-05",
    index=IndexKind.DEMAND_CAPACITY,
    states=(
        LimitState(
            DESIGN_BASIS,
            "no overturning",
            (DESIGN_BASIS,),
            ((Method("asce43-05-history"),), (Method("asce43-05-spectrum", Acceptance.IF_NAMED),)),
        ),
    ),
    default=DESIGN_BASIS,
    clauses=(
        (
            "mean of the maxima of at least five records within half of the rotation that overturns",
            "response histories",
        ),
        ("the approximate method only where it is named, against one third", "Appendix A.2"),
    ),
    uncompared=(
        "the methods were read in Mehrotra and in an excerpt of Appendix A, not in the printed standard",
        "the limit of clause 7.1 for A.2 could not be read: one third of the rotation that overturns is taken",
    ),
    suite_code="ASCE 43-05",
)
"""ASCE/SEI 43-05: rocking of unanchored bodies by response histories, or by the approximate method of A.2."""

EC8 = Basis(
    name="ec8",
    edition="EN 1998-1:2004, 4.3.5",
    index=IndexKind.DEMAND_CAPACITY,
    states=(LimitState("ULS", "element", ("ULS", "NCR"), ((Method("ec8-element"),),), years=475.0),),
    default="ULS",
    clauses=(("static force on a non-structural element", "4.3.5.2 (4.24), (4.25)"),),
    uncompared=("q_a and gamma_a of the element are from memory; national annexes may change them",),
    suite_code="EN 1998-1:2004",
)
"""EN 1998-1: elements that carry no floor, by the static force of 4.3.5."""
BASES: Mapping[str, Basis] = {each.name: each for each in (NTC2018, DMI2008, NZSEE2017, ASCE41_13, ASCE43_05, EC8)}

BY_SITE: Mapping[str, str] = {"ntc2018": "ntc2018", "ntc2008": "dmi2008", "nzs1170.5": "nzsee2017", "ec8": "ec8"}
"""The basis of a site by the code of its spectrum; on others it must be named."""


def stated_basis(procedures: Sequence[str], *, rule: str, statement: str) -> Basis:
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
        clauses=((statement, ""),),
        uncompared=(),
    )
