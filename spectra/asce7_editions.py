"""The editions of ASCE 7: clauses, site coefficients, and when each asks for a study of the site.

The site coefficients agree with those that the USGS tools compute with; the rules on site studies are from memory.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from spectra.errors import SpectrumError

Rows = Mapping[str, tuple[float, ...]]


@dataclass(frozen=True)
class SiteTable:
    """A site coefficient over a mapped acceleration: columns [g], a row of coefficients [-] for each site class."""

    clause: str
    columns: tuple[float, ...]
    rows: Rows


@dataclass(frozen=True)
class StudyRule:
    """When the standard asks for a study of the site: its classes, the least mapped value [g], the key of a message."""

    classes: tuple[str, ...]
    parameter: Literal["s_s", "s_1"]
    least: float
    key: str


@dataclass(frozen=True)
class Edition:
    """Where an edition keeps the design spectrum and the MCE spectrum, its rule for damping, coefficients, studies."""

    design: str
    mce: str
    damping: str
    f_a: SiteTable
    f_v: SiteTable
    study: str
    rules: tuple[StudyRule, ...] = ()


F_A_2005: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.2, 1.2, 1.1, 1.0, 1.0),
    "D": (1.6, 1.4, 1.2, 1.1, 1.0),
    "E": (2.5, 1.7, 1.2, 0.9, 0.9),
}
F_V_2005: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.7, 1.6, 1.5, 1.4, 1.3),
    "D": (2.4, 2.0, 1.8, 1.6, 1.5),
    "E": (3.5, 3.2, 2.8, 2.4, 2.4),
}
F_A_2016: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (0.9, 0.9, 0.9, 0.9, 0.9, 0.9),
    "B-unmeasured": (1.0, 1.0, 1.0, 1.0, 1.0, 1.0),  # 11.4.3: no shear wave velocity measured
    "C": (1.3, 1.3, 1.2, 1.2, 1.2, 1.2),
    "D": (1.6, 1.4, 1.2, 1.1, 1.0, 1.0),
    "D-default": (1.6, 1.4, 1.2, 1.2, 1.2, 1.2),  # 11.4.4: site class D taken by default
    "E": (2.4, 1.7, 1.3, 1.2, 1.2, 1.2),  # from S_S = 1.0 the value of class C, exception 1 of 11.4.8
}
F_V_2016: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B-unmeasured": (1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.5, 1.5, 1.5, 1.5, 1.5, 1.4),
    "D": (2.4, 2.2, 2.0, 1.9, 1.8, 1.7),
    "D-default": (2.4, 2.2, 2.0, 1.9, 1.8, 1.7),
    "E": (4.2, 3.3, 2.8, 2.4, 2.2, 2.0),
}
STUDIES_2016 = (
    StudyRule(
        ("E",),
        "s_s",
        1.0,
        "study-of-class-e",
    ),
    StudyRule(
        ("D", "D-default", "E"),
        "s_1",
        0.2,
        "study-of-classes-d-and-e",
    ),
)
_COLUMNS_2005 = ((0.25, 0.5, 0.75, 1.0, 1.25), (0.1, 0.2, 0.3, 0.4, 0.5))  # S_S, S_1 [g]
_COLUMNS_2016 = ((0.25, 0.5, 0.75, 1.0, 1.25, 1.5), (0.1, 0.2, 0.3, 0.4, 0.5, 0.6))

EDITIONS: Mapping[str, Edition] = {
    "asce7-05": Edition(
        "ASCE 7-05 §11.4.5",
        "ASCE 7-05 §11.4.6",
        "ASCE 7-05 Table 18.6-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("ASCE 7-05 Table 11.4-1", _COLUMNS_2005[0], F_A_2005),
        SiteTable("ASCE 7-05 Table 11.4-2", _COLUMNS_2005[1], F_V_2005),
        "ASCE 7-05 §11.4.7",
    ),
    "ibc2009": Edition(
        "IBC 2009 §1613.5 with ASCE 7-05 §11.4.5",
        "IBC 2009 §1613.5 with ASCE 7-05 §11.4.6",
        "ASCE 7-05 Table 18.6-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("IBC 2009 Table 1613.5.3(1)", _COLUMNS_2005[0], F_A_2005),
        SiteTable("IBC 2009 Table 1613.5.3(2)", _COLUMNS_2005[1], F_V_2005),
        "ASCE 7-05 §11.4.7",
    ),
    "asce7-10": Edition(
        "ASCE 7-10 §11.4.5",
        "ASCE 7-10 §11.4.6",
        "ASCE 7-10 Table 18.6-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("ASCE 7-10 Table 11.4-1", _COLUMNS_2005[0], F_A_2005),
        SiteTable("ASCE 7-10 Table 11.4-2", _COLUMNS_2005[1], F_V_2005),
        "ASCE 7-10 §11.4.7",
    ),
    "asce7-16": Edition(
        "ASCE 7-16 §11.4.6",
        "ASCE 7-16 §11.4.7",
        "ASCE 7-16 Table 18.7-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("ASCE 7-16 Table 11.4-1", _COLUMNS_2016[0], F_A_2016),
        SiteTable("ASCE 7-16 Table 11.4-2", _COLUMNS_2016[1], F_V_2016),
        "ASCE 7-16 §11.4.8",
        STUDIES_2016,
    ),
}


def edition_of(code: str) -> Edition:
    """Return the edition of that name; SpectrumError lists those known."""
    if code not in EDITIONS:
        raise SpectrumError(f'"{code}" is no edition of ASCE 7 known here; choose one of {", ".join(EDITIONS)}')
    return EDITIONS[code]
