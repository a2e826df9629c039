"""The names of the procedures, as project files write them."""

from __future__ import annotations

from typing import Literal, get_args

Procedure = Literal[
    "asce43-05-spectrum",
    "asce43-05-spectrum-thesis",
    "asce43-05-history",
    "dmi2008-linear",
    "dmi2008-nonlinear",
    "dmi2008-nonlinear-thesis",
    "nzsee2017-face-loaded",
    "asce41-13-ht",
    "ec8-element",
    "dmi2008-history",
    "ntc2018-linear",
    "ntc2018-nonlinear",
    "ntc2018-history",
    "asce43-05-sliding",
    "sliding",
]
PROCEDURES: tuple[Procedure, ...] = get_args(Procedure)
READINGS: tuple[Procedure, ...] = ("asce43-05-spectrum-thesis", "dmi2008-nonlinear-thesis")
